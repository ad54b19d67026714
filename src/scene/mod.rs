//! In: the text of a scene file (version 1), or a scene built in Rust. Out: a checked [`Scene`], or a [`SceneError`]
//! with its place in the text. A `Scene` has the values of the file, in its units, degrees and order; every name in it
//! refers to something. Positions, degrees of freedom and groups are found in later stages, which also read the files.
//!
//! In reading order: `text` makes JSON of the text and `typed` makes typed values of it, for any file that is read
//! strictly; `wrong`, `place` and `words` are errors, their places and their words. Then come the parts of a scene, a
//! file each, with the types of the scene file, the types of a `Scene`, and the checks. `read` lists the parts key by
//! key, and joins all stages. `build` fills the same types in Rust, and `write` makes their text; `rewritten` changes a text.
//! `fingerprint` is the short sign by which a sheet of paper knows its scene.
//!
//! To add a kind of joint: a file like `slider`; its key, its field and its line in `read`. CONTRIBUTING.md has the
//! whole list.

mod error;
mod hint;
mod kind;
mod words;
mod wrong;

mod place;
mod reader;
mod schema;
mod text;
mod typed;
mod write;

mod choice;
mod figure;
mod given_by;
mod sizes;
mod units;
mod value;
mod values;

mod drive;
mod motion;
mod name;
mod shape;

mod link;
mod names;
mod points;

mod slider;

mod known;

mod kinds;
mod size;

mod traced;

mod read;

mod fingerprint;

mod tree;

mod build_parts;

mod build;

pub use build::Builder;
pub use build_parts::{Guide, NewLink, Push, Turn};
pub use drive::{Drive, SliderDrive};
pub use error::{Place, SceneError};
pub use figure::{
    ConstructionShown, DecimalMark, Figure, LanguageName, NotationName, Page, PageSize, ScalesFor, StyleName,
};
pub use given_by::GivenBy;
pub use kinds::Kind;
pub use link::Link;
pub use motion::{LinkMotion, PointMotion};
pub use points::Near;
pub use read::Scene;
pub use shape::{Length, Shape};
pub use size::SizeLimit;
pub use sizes::{Measure, Sizes};
pub use slider::{Along, On, Slider};
pub use text::MAX_BYTES;
pub use units::{LengthUnit, TimeUnit, Units};
pub use value::{At, Direction, polar};
pub use values::ValuesShown;

pub(crate) use kind::FileKind;
pub(crate) use schema::schema_of;
pub(crate) use tree::{SceneTree, pair, why_not};
pub(crate) use typed::read_as;
pub(crate) use words::{nearest, nearest_within};
pub(crate) use write::figure_keys;
