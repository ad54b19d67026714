//! In: a scene and its solution, in numbers of f64. Out: [`Bounds`] of the whole error of every number: what reading the
//! scene, finding the position and computing the motion have lost. They are distances from an enclosure of the true
//! position and motion, computed with twice the digits.
//!
//! # Only balls enter
//!
//! A mechanism has rounded numbers: the direction of a guide, a wheel's constant angle. None of them may become a ball, and f64 has no
//! conversion to one: the same numbers are found again from those of the scene (`given`), which are looked up in its text with all their
//! digits. What is exact by choice, as the place from which Newton's method starts, says so by [`Ball::within`](crate::geometry::Ball::within).
//!
//! # A stated error is a distance
//!
//! `placed` takes the scene's numbers as balls with all their digits, and goes on from the f64 position with Newton steps
//! in twice the digits until only rounding of these is left; `certificate` proves that one and only one assembly lies there. `motion/`
//! then computes the rates by the same code as for a pose: it asks for places through a trait, which are exact for a
//! `Pose` and balls for an enclosure. What a result states is how far its f64 number can be from that ball, so
//! nothing that was lost on the way has to be estimated. `quantities` reads every quantity from the enclosure as its value is read from
//! the pose, segments of plans from the construction carried out within it. The bound at the position as printed (`Motion::errors`)
//! stays beside it: the two routes are compared there.

mod bounds;
mod certificate;
mod contacts;
mod enclosure;
mod given;
mod locals;
mod placed;
mod places;
mod poles;
mod quantities;
#[doc(hidden)] // for tests
pub mod says;
mod true_number;

pub(crate) use bounds::bounds_within;
pub use bounds::{Bounds, bounds};
pub use contacts::Contacting;
pub(crate) use given::Room;
pub(crate) use true_number::TrueNumber;
