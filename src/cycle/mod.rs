//! In: a mechanism and one pose. Out: a [`Path`]: the whole motion along that pose's branch while a drive runs, and any
//! position of it. The branch is followed in steps of adaptive size, and each step is checked: midway between two nodes
//! their interpolating quintic must meet the mechanism to half the digits of f64. So no step reaches another branch,
//! and one Newton step finds any position.
//! Limit positions, where two branches meet and the drive can go no further, are located and end the path.
//!
//! # A path proves itself
//!
//! A branch is followed in steps that adapt. Between two nodes stands, for each unknown, the polynomial of degree 5
//! that has both nodes' values and first and second derivatives; in the middle of every step it must meet the
//! mechanism to half the digits of f64 (`trace`). So no step can end on another branch, and any position of the path
//! is one Newton step away: tables, curves and searches begin there, in any order, on all cores. Next to change
//! points, where rounded gaps would move links much further than rounding of the drive does, one step more is made
//! with gaps of twice the digits (`kernel/refine.rs`). A step that takes more than four fifths of a determinant is
//! halved; so limits are approached, and found from the power with which rates grow there: d^(−1/2) of the distance d
//! at a limit, d^(−2) where a place runs off to infinity. Where a determinant passes through zero and rates do not
//! grow (a change point), the polynomial is followed to the other side.

mod curve;
mod drive;
mod error;
mod event;
mod locus;
mod mover;
mod path;
mod position;
mod pull;
mod range;
mod reading;
mod sampled;
#[doc(hidden)] // for tests
pub mod segment;
mod sweep;
mod trace;
mod traces;
mod variants;
mod walker;

pub use curve::{Curve, Curves, Extreme};
pub use drive::{Drive, alone};
pub use error::CycleError;
pub use locus::{Hodograph, Hodographs, PointPath, PointPaths, Tick};
pub use mover::Mover;
pub use path::{Event, Happening, Path};
pub use position::Position;
pub use pull::{Pull, Pulled};
pub use range::{Detour, Steps};
pub use sampled::Sampled;
pub use sweep::{Numbers, Sweep, every_name};
pub use traces::{Animation, OtherModes, Times, Traces};
pub use variants::{Kept, Variants};
pub use walker::Walker;
