//! A photograph of a printed sheet into places on its paper: where the [markers](crate::drawing::markers) are to a part of a pixel, what camera explains them, which sheet it is,
//! and what straight lines a pencil has drawn on it.
//!
//! Places on paper are millimetres from the sheet's upper left corner, x to the right, y down; places in a picture are pixels likewise.

mod camera;
mod code;
mod edges;
mod markers;
mod paper;
mod picture;
mod sheet;
mod squares;
mod strokes;

pub use paper::Paper;
pub use picture::Picture;
pub use sheet::{PhotoSheet, Refusal, read};
pub use strokes::{Crossing, Stroke, crossing};
