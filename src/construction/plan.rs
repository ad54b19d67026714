//! The points of a plan.

use crate::geometry::Vector;
use crate::sheet::{Order, Sheet};
use crate::words::{Notation, with_prime};
use indexmap::IndexMap;

/// The points of a velocity or acceleration plan.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Whether it shows velocities or accelerations.
    pub order: Order,
    /// Its points by name, in order of construction; vectors from the pole, in units of the plan.
    pub points: IndexMap<String, PlanPoint>,
    /// The length of the longest vector from the pole to a point.
    pub(super) largest: f64,
    /// By the image that it makes first: the index of a step.
    pub(super) makers: IndexMap<String, usize>,
}

/// A point of a plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanPoint {
    /// Vector from the pole, in the scene's units of velocity or acceleration.
    pub vector: Vector,
    /// Its role.
    pub role: PointRole,
}

/// Role of a plan point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PointRole {
    /// The pole, or the image of a point at rest.
    Pole,
    /// The end of a known vector.
    Known,
    /// The end of a normal part.
    Normal,
    /// The end of a driven slider's relative velocity or acceleration.
    Slid,
    /// The image of a special point.
    Special,
    /// The image of another point.
    Image,
}

/// Vectors and rates below this part of the largest of their kind are rounding errors of zero.
pub const NOTHING: f64 = 1e-12;

impl Plan {
    pub(super) fn new(order: Order) -> Plan {
        Plan { order, points: IndexMap::new(), largest: 0.0, makers: IndexMap::new() }
    }

    /// The sheet on which it is drawn.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        self.order.sheet()
    }

    /// The vector from one plan point to another; `None` for an unknown name.
    #[must_use]
    pub fn segment(&self, from: &str, to: &str) -> Option<Vector> {
        Some(self.points.get(to)?.vector - self.points.get(from)?.vector)
    }

    /// The vector from one plan point to another as it is shown: zero where only rounding is left of it.
    pub(crate) fn shown_segment(&self, from: &str, to: &str) -> Option<Vector> {
        let segment = self.segment(from, to)?;
        Some(if self.is_nothing(segment.norm()) { Vector::zeros() } else { segment })
    }

    /// Whether a size is what rounding leaves of zero in this plan.
    pub(crate) fn is_nothing(&self, size: f64) -> bool {
        size.abs() <= NOTHING * self.largest
    }

    /// The symbol of a plan point in a notation; `written` is the symbol without its changes for poles and images.
    #[must_use]
    pub fn shown(&self, name: &str, written: String, notation: &Notation) -> String {
        use PointRole::{Image, Known, Pole, Special};
        let pole = notation.pole(self.order);
        let Some(point) = self.points.get(name) else {
            return written;
        };
        // A point of the ground under a slider has no name of its own in a plan.
        let is_under = point.role == PointRole::Pole && name.ends_with("_ground");
        if name == self.order.pole() || is_under {
            return pole.to_owned();
        }
        let primes = notation.primes && self.order == Order::Acceleration;
        let shown = match point.role {
            Pole | Known | Special | Image if primes => with_prime(&written),
            _ => written,
        };
        // The pole's symbol is taken, but the image of a fixed point is the pole.
        match shown == pole && point.role != Pole {
            true => with_prime(&shown),
            false => shown,
        }
    }
}
