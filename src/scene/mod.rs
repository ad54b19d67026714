//! In: the text of a scene file (version 1), or a scene put together in Rust. Out: a checked [`Scene`], or a [`SceneError`]
//! with its place. A `Scene` says what the person wrote, in the person's units, degrees and order; every name in it refers
//! to something. It does not solve positions, count degrees of freedom, look for groups or read files: later stages do.
//!
//! In reading order: from text to types (`text` makes JSON of it, `typed` the types of any strict file), with the place of
//! what is wrong (`wrong`, `place`, `words`); then the parts of a scene, a file each, with the types that stand in the scene
//! file, what a `Scene` makes of them and what must be true; `read` lists them key by key, and goes the whole way.
//! `build` fills the same types in Rust, and `write` lays their text out.
//!
//! To add a kind of joint: a file like `slider`; its key, its field and its line in `read`. CONTRIBUTING.md has the whole list.

mod error;
mod kind;
mod words;
mod wrong;

mod place;
mod schema;
mod text;
mod typed;
mod write;

mod choice;
mod figure;
mod given_by;
mod units;
mod value;

mod drive;
mod motion;
mod name;
mod shape;

mod link;
mod names;
mod points;

mod slider;

mod known;

mod read;

mod build_parts;

mod build;

pub use build::Builder;
pub use build_parts::{Guide, NewLink, Push, Turn};
pub use drive::{Drive, SliderDrive};
pub use error::{Place, SceneError};
pub use figure::{DecimalMark, Figure, LanguageName, NotationName, Page, PageSize, PanelName, StyleName};
pub use given_by::GivenBy;
pub use link::Link;
pub use motion::{LinkMotion, PointMotion};
pub use points::Near;
pub use read::Scene;
pub use shape::{Length, Shape};
pub use slider::{Along, On, Slider};
pub use text::MAX_BYTES;
pub use units::{LengthUnit, TimeUnit, Units};
pub use value::{At, Direction, polar};

pub(crate) use kind::FileKind;
pub(crate) use schema::schema_of;
pub(crate) use typed::read_as;
pub(crate) use words::{nearest, nearest_within};
