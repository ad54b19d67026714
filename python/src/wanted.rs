//! What of the motion a table shows.

use crate::scene::Scene;
use pyo3::prelude::*;

/// The range, the step and the columns of a table, as `kinegon sweep` takes them.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Wanted {
    pub start: Option<f64>,
    pub stop: Option<f64>,
    pub step: Option<f64>,
    /// Names of quantities; none for those of the scene, or all.
    pub want: Option<Vec<String>>,
    pub drive: Option<String>,
    /// Whether other drives stand still.
    pub alone: bool,
    /// Whether each quantity is followed by the bound of its error.
    pub errors: bool,
    /// Whether it may take more than a gigabyte.
    pub huge: bool,
}

impl Wanted {
    /// Whether a part of the motion is asked for.
    pub fn is_part(&self) -> bool {
        self.start.is_some() || self.stop.is_some()
    }

    /// The names of quantities, here or in the scene.
    pub fn names<'a>(&'a self, scene: &'a Scene) -> Option<&'a [String]> {
        self.want.as_deref().or(scene.scene.want.as_deref())
    }
}
