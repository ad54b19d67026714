use crate::geometry::{Ball, Pair, Point, Vector};
use crate::mechanism::{PointId, SliderId};

/// Where a mechanism is.
#[derive(Clone, Debug)]
pub struct Pose {
    /// By point.
    pub points: Vec<Point>,
    /// By slider: the unit direction of its guide.
    pub guides: Vec<Vector>,
    /// By slider: the position along its guide, counted from the guide's `through`; none in a drawn configuration.
    pub slides: Vec<Option<f64>>,
    /// By body: the direction of its axis (not of length 1); none where it has none.
    pub axes: Vec<Option<Vector>>,
    /// By group: which of its assembly modes this is; none in a drawn configuration.
    pub assemblies: Vec<Option<Assembly>>,
    /// What a reader should know of this choice.
    pub warnings: Vec<String>,
}

/// One of the ways in which a group can be put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Assembly {
    /// Its number, from 1.
    pub mode: usize,
    /// How many there are.
    pub modes: usize,
}

impl Pose {
    /// The place of a point.
    #[inline]
    #[must_use]
    pub fn point(&self, id: PointId) -> Point {
        self.points[id.0]
    }

    /// The vector from one point to another.
    #[inline]
    #[must_use]
    pub fn arm(&self, from: PointId, to: PointId) -> Vector {
        self.points[to.0] - self.points[from.0]
    }

    /// The same without any rounding.
    #[inline]
    #[must_use]
    pub fn exact_arm(&self, from: PointId, to: PointId) -> Pair<Ball> {
        Pair::between(self.points[from.0], self.points[to.0])
    }

    /// The unit direction of a slider's guide.
    #[inline]
    #[must_use]
    pub fn guide(&self, id: SliderId) -> Vector {
        self.guides[id.0]
    }
}
