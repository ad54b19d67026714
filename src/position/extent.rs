use crate::geometry::{Point, span};

/// The bounding box of points.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Extent {
    /// Its lower left and upper right corner; none without points.
    corners: Option<[Point; 2]>,
}

impl Extent {
    pub(super) fn of(points: impl IntoIterator<Item = Point>) -> Extent {
        Extent::default().with(points)
    }

    /// The box of these points, too.
    pub(super) fn with(mut self, points: impl IntoIterator<Item = Point>) -> Extent {
        for p in points {
            let [low, high] = self.corners.unwrap_or([p, p]);
            self.corners = Some([low.inf(&p), high.sup(&p)]);
        }
        self
    }

    /// The box of both.
    pub(super) fn joined(self, other: Extent) -> Extent {
        self.with(other.corners.into_iter().flatten())
    }

    /// Its diagonal: the size of the set of points, as [`span`] gives it.
    pub(super) fn size(self) -> f64 {
        span(self.corners.into_iter().flatten())
    }
}
