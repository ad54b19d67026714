//! In: a mechanism and one pose. Out: a [`Path`]: the whole motion along that pose's branch while a drive runs, and any position of it.
//! The branch is followed by steps that adapt to it and proves itself: between two nodes a quintic through both must meet
//! the mechanism in the middle to half the digits of f64, so the next branch is out of reach and one Newton step finds any position.
//! Limit positions, where two branches meet and the drive can go no further, are located and end the path.

mod animation;
mod columns;
mod curve;
mod drive;
mod error;
mod event;
mod extreme;
mod hodograph;
mod path;
mod position;
mod reading;
mod samples;
mod segment;
mod start;
mod steps;
mod survey;
mod sweep;
mod trace;
mod variants;
mod walker;

pub use animation::Animation;
pub use columns::Column;
pub use curve::{Curve, Curves};
pub use drive::{Drive, alone};
pub use error::CycleError;
pub use event::{Event, Happening};
pub use extreme::Extreme;
pub use hodograph::{Hodograph, Hodographs};
pub use path::Path;
pub use position::Position;
pub use steps::Steps;
pub use sweep::{Numbers, Sweep};
pub use variants::Variants;
pub use walker::Walker;
