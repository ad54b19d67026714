//! In: a mechanism. Out: a [`Pose`]: the places of all points and the directions of all guides. A drawn configuration
//! is taken from the scene's coordinates; from lengths every real assembly mode is found and the one nearest to the
//! rough places chosen. Velocities play no part here.

mod assemble;
mod closing;
mod count;
mod error;
mod frames;
#[doc(hidden)] // for tests
pub mod legs;
mod levers;
mod listing;
mod modes;
mod nearest;
mod platform;
mod pose;
#[doc(hidden)] // for tests
pub mod roots;
mod rough;
mod search;
mod sides;
mod tree;

pub(crate) use assemble::first_poses;
pub use assemble::{Listed, counted_poses, numbered_pose, pose, poses};
pub use count::Count;
pub use error::AssemblyError;
pub use pose::{Assembly, Pose};
pub use sides::with_nearest_sides;
pub(crate) use tree::search_warnings;
