//! In: a mechanism given by lengths. Out: a [`Kernel`]: the mechanism compiled into a short list of actions. A
//! [`Block`] holds many positions side by side; each action runs over all of them, so the generality costs time only
//! once per block. Newton's method on the loop equations and the rates from the same matrix are here, to full f64
//! accuracy.
//!
//! Bodies connected by prismatic joints rotate together: they form one class with one angle. A loop is then a sum of
//! few vectors, one for each class in it, and the loop equations of `mechanism` follow from these.
//!
//! # How many positions cost less than one after another
//!
//! Loops are turned into sums of few vectors, one for each class of links that turn together, and everything else
//! into placings, one after another. Numbers stand in rows, one for each quantity, of one position or of many side by
//! side (`geometry/lanes.rs`); each action runs along the rows in the widest registers that the processor turns out
//! to have, by the same code as one position does number by number. So the cost of being general is paid once a
//! block. What a kernel does hangs on links and joints alone; lengths stand in rows, too, and `lengths.rs` has a recipe by which they
//! follow from the numbers of any mechanism of the kind, so that of many mechanisms one is compiled. Registers multiply and add with one rounding, on processors without that step by step, so a table has the
//! same bytes on every machine and in the browser; last digits differ from those of one position. Where positions and
//! rates are asked for together, the groups of a four-bar and of the paper's mechanism have code of their own
//! (`shapes.rs`), in which a Newton step and the rates after it stay in registers; all others go through rows, to the
//! same bits. The many are positions of one path (`cycle/walker.rs`), or mechanisms of one kind with other lengths
//! (`cycle/variants.rs`). A quantity of links alone needs no places of points, and then none are computed.

mod action;
mod block;
mod classes;
mod close;
mod columns;
mod compile;
mod lengths;
mod loops;
mod motions;
mod rates;
mod refine;
mod shapes;
mod solve;

pub use action::{Input, InputKind, Kernel, Seat, Unknown};
pub use block::{Block, Single, vector};
pub use close::{Correction, unit};
pub use motions::Begun;
