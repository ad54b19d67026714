//! Where labels and enlarged details stood in the picture before: there they stay while a mechanism moves, as long as
//! nothing is much better.

use indexmap::IndexMap;
use kurbo::{Point, Vec2};

/// Places in the picture before and in the one that is being drawn.
#[derive(Clone, Debug, Default)]
pub(super) struct Held {
    before: Places,
    now: Places,
}

#[derive(Clone, Debug, Default)]
struct Places {
    /// By label: the middle of its ink from its anchor, in mm.
    labels: IndexMap<String, Vec2>,
    /// By panel.
    insets: IndexMap<String, Inset>,
}

impl Held {
    pub(super) fn next(&mut self) {
        self.before = std::mem::take(&mut self.now);
    }

    /// Whether there is a picture before.
    pub(super) fn has_picture(&self) -> bool {
        !self.before.labels.is_empty()
    }
    pub(super) fn label(&self, id: &str) -> Option<Vec2> {
        self.before.labels.get(id).copied()
    }
    pub(super) fn keep_label(&mut self, id: String, offset: Vec2) {
        self.now.labels.insert(id, offset);
    }

    /// The enlarged detail that a panel had.
    pub(super) fn inset(&self, panel: &str) -> Option<Inset> {
        self.before.insets.get(panel).copied()
    }

    /// Keeps the enlarged detail of a panel.
    pub(super) fn keep_inset(&mut self, panel: &str, inset: Inset) {
        self.now.insets.insert(panel.to_owned(), inset);
    }
}

/// A circle with an enlarged crowd of points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inset {
    /// Centre of the crowd, on the sheet.
    pub crowd: Point,
    /// Centre and radius of the circle, on the sheet.
    pub centre: Point,
    pub radius: f64,
    /// Factor of enlargement.
    pub factor: f64,
}
