//! A photograph of a printed sheet into places on its paper: where the [markers](crate::drawing::markers) are to a part of a pixel, what camera explains them, which sheet it is,
//! and what straight lines a pencil has drawn on it.
//!
//! Places on paper are millimetres from the sheet's upper left corner, x to the right, y down; places in a picture are pixels likewise.
//!
//! # A photograph is a measurement
//!
//! `camera` finds focal length, axis, distortion, pose and the bend of the paper from the corners of eight markers by
//! least squares, with wide suppositions about each; the covariance of all that becomes a radius for every place on
//! paper. Edges are the middle of their rise, which blur does not move. A marker that does not fit the others is left
//! out; corners that leave more than 0.15 mm are a refusal. A code that is too blurred goes through an equalizer that
//! learns from the modules all codes share; else it is compared with the codes that the scene's sheets have.
//! `check/proposed/` carries the construction out along the pencil lines in many ways, and proposes a place only where
//! nearly all that speaks for any of them speaks for it.

mod camera;
mod code;
mod edges;
mod markers;
mod picture;
pub mod says;
mod sheet;
mod squares;
mod strokes;

pub use picture::{Paper, Picture};
pub use sheet::{PhotoSheet, Refusal, read};
pub use strokes::{Crossing, Stroke, crossing};
