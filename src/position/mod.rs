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
//! Where a link's angle is given in place of a drive's, positions are found on a second mechanism
//! (`mechanism/placing.rs`): the drive lets go, and a carriage on two sliders holds that link at its angle; motions
//! are those of the scene's own mechanism.

mod assemble;
mod closing;
mod error;
mod frames;
#[doc(hidden)] // for tests
pub mod legs;
mod listing;
mod modes;
mod nearest;
mod platform;
mod pose;
#[doc(hidden)] // for tests
pub mod roots;
mod search;
mod tree;

pub(crate) use assemble::first_poses;
pub use assemble::{Listed, counted_poses, numbered_pose, pose, poses, with_nearest_sides};
pub use error::AssemblyError;
pub use listing::Count;
pub use pose::{Assembly, Pose};
pub(crate) use tree::search_warnings;
