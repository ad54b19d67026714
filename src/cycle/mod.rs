//! In: a mechanism and one pose. Out: a [`Path`]: the whole motion along that pose's branch while a drive runs, and any
//! position of it. The branch is followed in steps of adaptive size, and each step is checked: midway between two nodes
//! their interpolating quintic must meet the mechanism to half the digits of f64. So no step reaches another branch,
//! and one Newton step finds any position.
//! Limit positions, where two branches meet and the drive can go no further, are located and end the path.

mod animation;
mod circuit;
mod columns;
mod curve;
mod detour;
mod drive;
mod error;
mod event;
mod extreme;
mod hodograph;
mod mover;
mod other_modes;
mod path;
mod point_path;
mod position;
mod pull;
mod reading;
mod samples;
#[doc(hidden)] // for tests
pub mod segment;
mod start;
mod steps;
mod survey;
mod sweep;
mod tip;
mod trace;
mod traces;
mod usual;
mod variants;
mod walker;

pub use animation::Animation;
pub use columns::Column;
pub use curve::{Curve, Curves};
pub use detour::Detour;
pub use drive::{Drive, alone};
pub use error::CycleError;
pub use event::{Event, Happening};
pub use extreme::Extreme;
pub use hodograph::{Hodograph, Hodographs};
pub use mover::Mover;
pub use other_modes::OtherModes;
pub use path::Path;
pub use point_path::{PointPath, PointPaths, Tick};
pub use position::Position;
pub use pull::{Pull, Pulled};
pub use steps::Steps;
pub use sweep::{Numbers, Sweep, every_name};
pub use traces::{Times, Traces};
pub use variants::{Kept, Variants};
pub use walker::Walker;
