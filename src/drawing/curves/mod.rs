//! In: quantities over a cycle, sampled. Out: a sheet with a panel for each kind of quantity, one above the other on a
//! common axis of the drive (`chart.rs`, `graph.rs`), or with a panel for each path of a point or hodograph (`locus.rs`).
//! Extreme values, dead centres, limits and the scene's own position are marked; every curve has its name. Nothing of the
//! motion is computed here.

mod chart;
#[doc(hidden)] // for tests
pub mod context;
mod graph;
mod locus;

pub use chart::{curves, drive_ends};
pub use context::CurvesError;
pub use locus::{hodograph_ways, hodographs, path_ways, paths};
