//! In: quantities over a cycle, sampled. Out: a sheet with a panel for each kind of quantity, one above the other over
//! the drive's axis (`chart.rs`), or with a panel for the way of each vector's tip (`hodograph.rs`).
//! Greatest and least values, dead centres, limits and the scene's own position are marked; every curve bears its name.
//! Nothing of the motion is computed here.

mod axis;
mod chart;
mod course;
mod error;
mod graph;
mod hodograph;
mod lines;
mod looks;
mod names;

pub use chart::curves;
pub use error::CurvesError;
pub use hodograph::hodographs;
