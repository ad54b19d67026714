//! In: a mechanism, its pose and its motion, whose rates have bounds of their rounding errors. Out: [`Bounds`] for
//! every velocity and acceleration. They add to the rates' own bounds that positions found from lengths are rounded and
//! that the motion of a group's outer bodies is inexact. No rate is computed here.

mod bounds;
mod group;
mod quantity;

pub use bounds::{Bounds, bounds};
pub use quantity::is_bounded;
