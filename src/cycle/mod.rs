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
//! grow (a change point), the polynomial is followed to the other side. Whether branches of a four-bar linkage cross, or
//! only come near each other, and where a limit is, is told by sums of its lengths (`motion/reach.rs`).
//! Mechanisms that differ in their numbers alone are moved side by side (`variants`), from where the last positions let expect them (`kept`); `alike` finds all their assemblies from those of one of them.
//! `still` says of one position what of it turns back there, in the same words.

mod alike;
mod centrode;
mod certain;
mod curve;
mod drive;
mod dwell;
mod event;
mod kept;
mod known;
mod leap;
mod locus;
mod mover;
mod path;
mod position;
mod pull;
mod range;
mod reading;
mod running;
mod sampled;
#[doc(hidden)] // for tests
pub mod says;
#[doc(hidden)] // for tests
pub mod segment;
mod still;
mod sweep;
mod together;
mod trace;
mod traces;
mod variants;
mod walker;

pub(crate) use alike::Assemblies;
pub use centrode::Centrode;
pub use certain::CertainExtreme;
pub use curve::{Curve, Curves, Extreme};
pub(crate) use drive::differing_drives;
pub use drive::{Drive, alone};
pub use dwell::told_engagement;
pub use kept::Kept;
pub use locus::{Hodograph, Hodographs, PointPath, PointPaths, Tick};
pub use mover::Mover;
pub use path::{Event, Happening, Path};
pub use position::Position;
pub use pull::{Pull, Pulled};
pub use range::{Detour, Steps};
pub use running::Running;
pub use sampled::Sampled;
pub use still::{told_turning_back, turning_back};
pub use sweep::{Numbers, Sweep, every_name};
pub use traces::{Animation, OtherModes, Times, Traces};
pub use variants::Variants;
pub use walker::Walker;

use crate::Problem;
use crate::motion::Standing;
use crate::quantity::QuantityError;

/// Why a motion cannot be followed, or a quantity along it not be shown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum CycleError {
    /// A drawn configuration has one position.
    Drawn,
    /// Profiles that touch are known at their contact alone.
    AtContact,
    /// In the scene's own position a slider of this name is beyond an end of its guide.
    OffGuide(String),
    /// Mechanisms to be computed side by side are not of one kind: the number of the one that differs, from 0.
    NotOfOneKind(usize),
    /// The mechanism has no drive.
    NoDrive,
    /// The drive that was asked for does not exist.
    NoSuchDrive {
        /// The name asked for.
        name: String,
        /// The names of the drives that exist.
        known: String,
    },
    /// The scene's own position is singular, so it does not decide on which branch the motion goes on.
    Singular {
        /// The group's links.
        links: String,
        /// The drive's value, in words.
        at: String,
        /// Whether it is a limit or a change point.
        standing: Standing,
    },
    /// The range cannot be reached from the scene's position.
    OutOfReach {
        /// Where the range begins.
        from: String,
        /// Where it ends.
        to: String,
        /// The event that ends the path before the range, in words.
        stop: String,
        /// The lowest reachable value found.
        low: String,
        /// The highest reachable value found.
        high: String,
    },
    /// A range, step or count without meaning.
    Range(Problem),
    /// A hodograph was asked for of a quantity that is no vector.
    NoVector(String),
    /// A path was asked for of what is no point of a moving link.
    NoPath(String),
    /// A quantity that was asked for has no curve.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
}

impl CycleError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            CycleError::Drawn => Problem::new(says::drawn()).hint(says::lengths_and_drive()),
            CycleError::AtContact => Problem::new(says::at_contact()).hint(says::say_circular()),
            CycleError::OffGuide(slider) => Problem::new(says::off_guide(slider)).hint(says::on_guide()),
            CycleError::NotOfOneKind(number) => Problem::new(says::other_kind(*number)).hint(says::same_kind()),
            CycleError::NoDrive => Problem::new(says::no_drive()).hint(says::give_drive()),
            CycleError::NoSuchDrive { name, known } => says::no_such_drive(name, known).into(),
            CycleError::Singular { links, at, standing } => {
                let message = match standing {
                    Standing::Limit => says::at_limit(at, links),
                    Standing::Change => says::at_change(at, links),
                    _ => says::singular(links, at),
                };
                Problem::new(message).hint(says::other_position())
            }
            CycleError::OutOfReach { from, to, stop, low, high } => {
                Problem::new(says::out_of_reach(from, to, stop)).hint(says::within_reach(low, high))
            }
            CycleError::Range(problem) => problem.clone(),
            CycleError::NoVector(name) => Problem::new(says::no_vector(name)).hint(says::vectors()),
            CycleError::NoPath(name) => says::no_path(name).into(),
            CycleError::Quantity(error) => error.problem(),
        }
    }
}
