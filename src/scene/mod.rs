//! In: the text of a scene file (version 1), or a scene built in Rust. Out: a checked [`Scene`], or a [`SceneError`]
//! with its place in the text. A `Scene` has the values of the file, in its units, degrees and order; every name in it
//! refers to something. Positions, degrees of freedom and groups are found in later stages, which also read the files.
//!
//! In reading order: `text` makes JSON of the text, `reader` typed values of the JSON, and `typed` says in plain words what is
//! wrong, for any file that is read strictly; `error` finds its place, and `says` has the sentences. Then come the parts of a scene, a file each, with the
//! types of the scene file, the types of a `Scene`, and the checks. `read` lists the parts key by key, and joins all stages.
//! `build` fills the same types in Rust, and `write` makes their text.
//!
//! To add a kind of joint: a file like `joint/slider` and its line in `joint/mod`; its key, its field and its line in `read`.
//! CONTRIBUTING.md has the whole list.

mod build;
mod build_contacts;
mod build_loads;
mod centers;
mod choices;
mod digits;
mod error;
mod figure;
mod friction;
mod given;
mod head;
mod joint;
mod kinds;
mod link;
mod load_names;
mod loads;
mod name;
mod names;
mod over;
mod page;
mod points;
mod quantity_name;
mod read;
mod reader;
#[doc(hidden)] // for tests
pub mod says;
mod schema;
#[cfg(feature = "schemas")]
pub(crate) mod schema_made;
mod text;
mod typed;
mod units;
mod value;
mod write;

pub use build::{Builder, Guide, Mesh, NewLink, Push, Turn};
pub use build_contacts::Profiles;
pub use build_loads::{NewLoad, NewSpring};
pub use centers::CentersShown;
pub use choices::{
    CenterName, ConstructionShown, CoriolisName, DecimalMark, FrameName, LanguageName, NotationName, ScalesFor,
    SlidingName, StyleName, TurnedName, ValuesShown,
};
pub use error::{Place, SceneError};
pub use figure::Figure;
pub use friction::{Friction, Grip, RubbingJoint};
pub use given::{Drive, GivenBy, LinkMotion, PointMotion, SliderDrive};
pub use head::{Argument, Component, Head};
pub use joint::*;
pub use kinds::Kind;
pub use link::{Length, Link, Shape};
pub use loads::{Amount, Analysis, LinkPlace, Load, Loads, Mass, Spring, SpringEnd};
pub use over::{Gauge, Over};
pub use page::{Measure, Page, PageSize, Sizes};
pub use points::Near;
pub use quantity_name::QuantityName;
pub(crate) use read::MOST_MARKS;
pub use read::{Scene, SizeLimit};
#[doc(hidden)] // for tests
pub use read::{folded, signs};
pub use text::MAX_BYTES;
pub use units::{ForceUnit, LengthUnit, MassUnit, TimeUnit, Units};
pub use value::{At, Direction, polar};

pub(crate) use error::{close, list, nearest, nearest_within, range_of};
pub(crate) use figure::figure_keys;
pub(crate) use link::STRAIGHT;
pub(crate) use load_names::{LoadNames, couple_name, couple_number};
pub(crate) use name::{Bearer, by_name, joined, pair, why_not};
pub(crate) use schema::schema;
pub(crate) use text::{FileKind, LARGEST, SceneTree};
pub(crate) use typed::read_as;
pub(crate) use value::several_forms;
pub(crate) use write::quoted;
