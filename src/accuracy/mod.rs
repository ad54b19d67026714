//! In: a mechanism, its pose and its motion, whose rates carry bounds of their errors. Out: [`Bounds`] for every velocity and acceleration.
//! Added to the stated bounds of ω, α and slide rates is what they leave out: that positions found from lengths are rounded, and that a
//! group hangs on links whose motion is not exact. No rate is computed here.

mod bounds;
mod group;

pub use bounds::{Bounds, bounds};
