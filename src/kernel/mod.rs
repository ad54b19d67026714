//! In: a mechanism given by lengths. Out: a [`Kernel`]: the same, compiled for many positions into a short list of actions.
//! A [`Block`] holds many positions side by side; each action runs over all of them, so being general costs once a block.
//! Everything that must be exact about a position is here: Newton's method on the loop equations, and the rates from the same matrix.
//!
//! Bodies that prismatic joints tie together turn together: they are one class with one angle. So a loop is a sum of few vectors,
//! one for each class that it passes, and the loop equations of `mechanism` are read off these.

mod action;
mod block;
mod classes;
mod close;
mod columns;
mod compile;
mod rates;
mod solve;

pub use action::Unknown;
pub use block::{Block, Single, vector};
pub use close::{Correction, portions, unit};
pub use compile::{Input, InputKind, Kernel, Seat};
