use super::layout::{Aside, Layout};
use super::sheet::Drawing;
use kurbo::Rect;

/// Something on a sheet beside or below its panels.
pub(super) trait Item {
    /// Height that it needs below the scales, in mm.
    fn height(&self) -> f64 {
        0.0
    }

    /// The parts of the panels' room that it may take, if it stands beside them.
    fn asides(&self, _room: Rect) -> Vec<Aside> {
        Vec::new()
    }

    /// Draws it.
    fn draw(&self, drawing: &mut Drawing, layout: &Layout);
}
