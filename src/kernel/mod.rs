//! In: a mechanism given by lengths. Out: a [`Kernel`]: the mechanism compiled into a short list of actions. A
//! [`Block`] holds many positions side by side; each action runs over all of them, so the generality costs time only
//! once per block. Newton's method on the loop equations and the rates from the same matrix are here, to full f64
//! accuracy.
//!
//! Bodies connected by prismatic joints rotate together: they form one class with one angle. A loop is then a sum of
//! few vectors, one for each class in it, and the loop equations of `mechanism` follow from these.

mod action;
mod at_once;
mod block;
mod classes;
mod close;
mod columns;
mod compile;
mod pattern;
mod rates;
mod refine;
mod solve;

pub use action::{Input, InputKind, Kernel, Seat, Unknown};
pub use block::{Block, Coordinates, Single, portions, vector};
pub use close::{Correction, unit};
