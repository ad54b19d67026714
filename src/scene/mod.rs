//! In: the text of a scene file (version 1), or a scene put together in Rust. Out: a checked [`Scene`], or a [`SceneError`]
//! with its place. A `Scene` says what the person wrote, in the person's units, degrees and order; every name in it refers
//! to something. It does not solve positions, count degrees of freedom, look for groups or read files: later stages do.
//!
//! In reading order: from text to types (`text` makes JSON of it, `typed` the types of any strict file), with the place of
//! what is wrong (`wrong`, `place`, `words`); then the types that stand in a scene file, each with what must be true of it;
//! `file` names them key by key, and `read` goes the whole way. `build` fills the same types in Rust, `write` writes them.

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
mod form;
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

mod file;
mod read;

mod build;
mod build_parts;

pub use build::Builder;
pub use build_parts::{Guide, NewLink, Push, Turn};
pub use drive::{Drive, SliderDrive};
pub use error::{Place, SceneError};
pub use figure::{DecimalMark, Figure, LanguageName, NotationName, Page, PageSize, Panel, StyleName};
pub use form::Form;
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
