//! In: a scene and its solution, in numbers of f64. Out: [`Bounds`] of the whole error of every number: what reading the
//! scene, finding the position and computing the motion have lost. They are distances from an enclosure of the true
//! position and motion, computed with twice the digits.

mod bounds;
mod enclosure;
mod given;
mod placed;
mod quantity;

pub use bounds::{Bounds, bounds};
pub(crate) use quantity::is_bounded;
