//! In: a mechanism. Out: a [`Pose`]: the places of all points and the directions of all guides. A drawn configuration
//! is taken from the scene's coordinates; from lengths every real assembly mode is found and the one nearest to the
//! rough places chosen. Velocities play no part here.
//!
//! # Positions use the velocity matrix
//!
//! The modes of a class III or IV group come from one trigonometric polynomial of degree 3, those of a dyad from a
//! circle and a line or circle; each is then closed by Newton steps whose matrix is that of the velocity equations.
//! For a group of higher class there is no polynomial: `search` lets Newton's method start near the rough places and
//! from many random positions, always the same ones, until a rule says that hardly a mode is missing. The groups'
//! modes make a tree; the nearest assembly is found by branch and bound, because the part that is already placed has
//! a distance from `near` that the whole can only exceed. Parts that share nothing but groups already placed are
//! solved, and counted, one by one. Modes are numbered by the angle of the group's first link that turns,
//! counter-clockwise from +x.
//!
//! Wheels and arms whose angles follow from meshes alone have one assembly: whole turns of drives count (`wheels`).
//!
//! Where a link's angle is given in place of a drive's, positions are found on a second mechanism
//! (`mechanism/build.rs`): the drive lets go, and a carriage on two sliders holds that link at its angle; motions
//! are those of the scene's own mechanism.

mod assemble;
mod closing;
mod frames;
#[doc(hidden)] // for tests
pub mod legs;
mod modes;
mod nearest;
#[doc(hidden)] // for tests
pub mod number;
mod paths;
mod platform;
#[doc(hidden)] // for tests
mod reach;
pub mod says;
mod search;
mod tree;
mod wheels;

pub(crate) use assemble::first_poses;
pub use assemble::{Listed, counted_poses, numbered_pose, pose, poses, with_nearest_sides};
pub(crate) use frames::principal_degrees;
pub(crate) use search::rough_places;
pub use tree::Count;
pub(crate) use tree::search_warnings;

use crate::Problem;
use crate::geometry::{Point, Vector, span};
use crate::mechanism::{PointId, SliderId};
use crate::message::Message;

/// Distance of points that counts as none, in sizes of the mechanism.
const SAME: f64 = 1e-6;

/// The position of a mechanism, in the fixed frame and in the scene's unit of length.
#[derive(Clone, Debug)]
pub struct Pose {
    /// By point: its place.
    pub points: Vec<Point>,
    /// By slider: the unit direction of its guide.
    pub guides: Vec<Vector>,
    /// By slider: the position along its guide, from the guide's `through`; none in a drawn configuration.
    pub slides: Vec<Option<f64>>,
    /// By body: the direction of its x axis, of any length; in a drawn configuration that of the line through its first
    /// two points, or of its guide. None for bodies without a name.
    pub axes: Vec<Option<Vector>>,
    /// By group: its assembly mode; none in a drawn configuration.
    pub assemblies: Vec<Option<Assembly>>,
    /// Warnings on the choice of the mode.
    pub warnings: Vec<Message>,
}

/// An assembly mode of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Assembly {
    /// Its number, from 1.
    pub mode: usize,
    /// Number of modes of the group.
    pub modes: usize,
    /// How many modes the group can have at most, as far as that is known.
    pub at_most: Option<u64>,
    /// Whether the group has assemblies besides in which it may move at fixed drives; these are no modes.
    pub may_move: bool,
}

impl Assembly {
    /// A mode of a whole mechanism.
    fn of_whole(mode: usize, modes: usize) -> Assembly {
        Assembly { mode, modes, at_most: None, may_move: false }
    }
}

impl Pose {
    /// The place of a point.
    #[inline]
    #[must_use]
    pub fn point(&self, id: PointId) -> Point {
        self.points[id.0]
    }

    /// Whether the points are in the same places and the guides in the same directions, apart from rounding: two modes of a slotted wheel may have the same points.
    #[must_use]
    pub fn is_same_as(&self, other: &Pose) -> bool {
        let size = span(self.points.iter().copied());
        let are_there = self.points.iter().zip(&other.points).all(|(a, b)| (a - b).norm() <= SAME * size);
        are_there && self.guides.iter().zip(&other.guides).all(|(a, b)| (a - b).norm() <= SAME)
    }

    /// The vector from one point to another.
    #[inline]
    #[must_use]
    pub fn arm(&self, from: PointId, to: PointId) -> Vector {
        self.points[to.0] - self.points[from.0]
    }

    /// The unit direction of a slider's guide.
    #[inline]
    #[must_use]
    pub fn guide(&self, id: SliderId) -> Vector {
        self.guides[id.0]
    }
}

/// Reasons why a mechanism cannot be assembled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum AssemblyError {
    /// No real assembly mode exists.
    NoMode {
        /// The group's links.
        links: String,
        /// The drive angles, as ` at angle(1) = 150°`.
        at: Message,
        /// The distance by which its links fail to meet.
        miss: Message,
        /// The ranges of the one drive's angle, in degrees, in which the mechanism can be assembled, as far as they are known.
        ranges: Vec<[f64; 2]>,
    },
    /// The guides of a link's two sliders are parallel: nothing holds it along them.
    ParallelGuides {
        /// The group's links.
        links: String,
        /// The link with the two sliders.
        link: String,
    },
    /// Lengths too large or too small: closing a loop takes fourth powers, which leave the range of f64.
    Size {
        /// The largest length, in the scene's unit.
        size: f64,
        /// Whether it is too large, not too small.
        is_large: bool,
    },
    /// There is no assembly mode of this number.
    NoSuchMode {
        /// The number asked for.
        mode: usize,
        /// Number of modes.
        count: usize,
    },
    /// The assembly modes are too many to go through them up to this number.
    TooManyModes {
        /// The number asked for.
        mode: usize,
        /// Number of modes counted.
        count: usize,
    },
    /// No assembly was found among many ways to put the first groups together.
    TooMuchWork,
    /// The search has found no assembly mode of a group of higher class.
    NotFound {
        /// The group's links.
        links: String,
        /// The drive angles, as ` at angle(1) = 150°`.
        at: Message,
        /// The number of starts and the smallest gap.
        tried: Message,
    },
    /// All assemblies found of a group of higher class are such that it may move at fixed drives.
    Moves {
        /// The group's links.
        links: String,
    },
}

/// A range as it is told: to hundredths of a degree within it.
fn told([from, to]: &[f64; 2]) -> Message {
    let [from, to] =
        [(100.0 * from).ceil(), (100.0 * to).floor()].map(|hundredths| format!("{:.2}", hundredths / 100.0));
    says::angle_from_to(from, to)
}

impl AssemblyError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        let (message, hint) = match self {
            AssemblyError::NoMode { links, at, miss, ranges } => {
                let hint = match ranges.is_empty() {
                    true => says::other_angle_or_lengths(),
                    false => says::angle_within_or_lengths(Message::list(ranges.iter().map(told), ", ")),
                };
                (says::no_mode(links, at.clone(), miss.clone()), hint)
            }
            AssemblyError::ParallelGuides { links, link } => (says::parallel_guides(links, link), says::turn_one()),
            AssemblyError::Size { size, is_large } => {
                let size = format!("{size:e}");
                (if *is_large { says::too_large(size) } else { says::too_small(size) }, says::other_unit())
            }
            AssemblyError::NoSuchMode { mode, count } => (says::no_such_mode(*mode, *count), says::modes_listed()),
            AssemblyError::TooManyModes { mode, count } => {
                (says::too_many_modes(*mode, *count), says::rough_places_choose())
            }
            AssemblyError::TooMuchWork => (says::too_much_work(), says::rough_places()),
            AssemblyError::Moves { links } => (says::moves(links), says::other_angle_or_lengths()),
            AssemblyError::NotFound { links, at, tried } => {
                (says::not_found(links, at.clone(), tried.clone()), says::rough_places_or_other())
            }
        };
        Problem::new(message).hint(hint)
    }
}
