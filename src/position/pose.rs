use crate::geometry::{Point, Vector, span};
use crate::mechanism::{PointId, SliderId};

/// Distance of points that counts as none, in sizes of the mechanism.
const SAME: f64 = 1e-6;

/// The position of a mechanism, in the fixed frame and in the scene's unit of length.
#[derive(Clone, Debug)]
pub struct Pose {
    /// By point: its place.
    pub points: Vec<Point>,
    /// By slider: the unit direction of its guide.
    pub guides: Vec<Vector>,
    /// By slider: the position along its guide, from the guide's `through`; none in a drawn configuration.
    pub slides: Vec<Option<f64>>,
    /// By body: the direction of its x axis, of any length; in a drawn configuration that of the line through its first
    /// two points, or of its guide. None for bodies without a name.
    pub axes: Vec<Option<Vector>>,
    /// By group: its assembly mode; none in a drawn configuration.
    pub assemblies: Vec<Option<Assembly>>,
    /// Warnings on the choice of the mode.
    pub warnings: Vec<String>,
}

/// An assembly mode of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Assembly {
    /// Its number, from 1.
    pub mode: usize,
    /// Number of modes of the group.
    pub modes: usize,
}

impl Pose {
    /// The place of a point.
    #[inline]
    #[must_use]
    pub fn point(&self, id: PointId) -> Point {
        self.points[id.0]
    }

    /// Whether the points are in the same places, apart from rounding.
    #[must_use]
    pub fn is_same_as(&self, other: &Pose) -> bool {
        let size = span(self.points.iter().copied());
        self.points.iter().zip(&other.points).all(|(a, b)| (a - b).norm() <= SAME * size)
    }

    /// The vector from one point to another.
    #[inline]
    #[must_use]
    pub fn arm(&self, from: PointId, to: PointId) -> Vector {
        self.points[to.0] - self.points[from.0]
    }

    /// The unit direction of a slider's guide.
    #[inline]
    #[must_use]
    pub fn guide(&self, id: SliderId) -> Vector {
        self.guides[id.0]
    }
}
