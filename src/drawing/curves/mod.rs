//! In: quantities over a cycle, sampled. Out: a sheet with a panel for each kind of quantity, one above the other on a
//! common axis of the drive (`chart.rs`), or with a panel for the hodograph of each vector (`hodograph.rs`). Extreme
//! values, dead centres, limits and the scene's own position are marked; every curve has its name. Nothing of the
//! motion is computed here.

mod axis;
mod chart;
mod course;
mod error;
mod graph;
mod hodograph;
mod looks;
mod names;
mod path;
mod way;

pub use chart::{curves, drive_ends};
pub use error::CurvesError;
pub use hodograph::hodographs;
pub use path::paths;
