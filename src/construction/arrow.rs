//! What is drawn in a plan: vectors that are laid off, rays of known direction.

use super::cut::SpecialId;
use crate::geometry::Vector;
use crate::mechanism::{BodyId, DrivenSlide, PointId, SliderId};
use crate::sheet::Order;

/// A vector that is laid off in a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// Whether it shows a velocity or an acceleration.
    pub order: Order,
    /// The plan point at which it is laid off …
    pub from: String,
    /// … and the one that it makes. [`Arrow::ends`] says where its head is.
    pub to: String,
    /// Its meaning.
    pub of: VectorOf,
}

/// Meaning of a vector of a plan.
#[derive(Clone, Debug, PartialEq)]
pub enum VectorOf {
    /// The whole velocity or acceleration of a body's point.
    Point(BodyId, PointId),
    /// The normal part of a leg: special point and leg.
    Normal(SpecialId, usize),
    /// The velocity or acceleration of one point of a link relative to another, by their names, or a part of it.
    Relative {
        /// The link.
        link: BodyId,
        /// From this point …
        from: String,
        /// … to this one.
        to: String,
        /// Which part of it: all of a relative velocity, of an acceleration the normal or the tangential part.
        part: VectorPart,
    },
    /// The sliding velocity at a slider, from the coincident point of the guide's body, given by name, to the slider's
    /// point.
    Sliding(SliderId, String),
    /// A part of the relative motion at a slider that a chain of vectors passes, in either direction: along its guide,
    /// or its Coriolis acceleration.
    Passed(DrivenSlide, VectorPart),
}

/// What a vector of a plan shows of a velocity or an acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorPart {
    /// All of it, from the pole.
    Whole,
    /// The velocity of one point of a link relative to another, ω × r.
    Relative,
    /// Normal (centripetal) acceleration, −ω² r.
    Normal,
    /// Tangential acceleration, α × r.
    Tangential,
    /// Relative velocity or acceleration along a guide.
    Sliding,
    /// Coriolis acceleration 2 ω ẑ × v_r.
    Coriolis,
}

impl VectorPart {
    /// The parts of the relative motion at a slider that are laid off in a plan, in order.
    pub(super) fn of_slide(order: Order) -> &'static [VectorPart] {
        match order {
            Order::Velocity => &[VectorPart::Sliding],
            Order::Acceleration => &[VectorPart::Sliding, VectorPart::Coriolis],
        }
    }
}

impl Arrow {
    /// Whether the vector points from the new plan point back to the one that was there: a chain that passes a slider
    /// from the sliding link to the guide subtracts its relative motion.
    pub(super) fn is_backwards(&self) -> bool {
        matches!(self.of, VectorOf::Passed(slide, _) if slide.sign < 0.0)
    }

    /// The plan points where the vector begins and where its head is. It has the direction of the quantity that it
    /// shows, whichever end is laid off first.
    #[must_use]
    pub fn ends(&self) -> [&str; 2] {
        match self.is_backwards() {
            true => [&self.to, &self.from],
            false => [&self.from, &self.to],
        }
    }

    /// What the vector shows.
    #[must_use]
    pub fn part(&self) -> VectorPart {
        match self.of {
            VectorOf::Point(..) => VectorPart::Whole,
            VectorOf::Normal(..) => VectorPart::Normal,
            VectorOf::Relative { part, .. } | VectorOf::Passed(_, part) => part,
            VectorOf::Sliding(..) => VectorPart::Sliding,
        }
    }
}

/// A line of known direction through a plan point, for a crossing.
#[derive(Clone, Debug, PartialEq)]
pub struct Ray {
    /// Whether it is a ray of the plan of velocities or of accelerations.
    pub order: Order,
    /// The plan point.
    pub through: String,
    /// The sought plan point on it.
    pub to: String,
    /// Unit direction.
    pub direction: Vector,
    /// Its relation to the line of the mechanism that gives the direction.
    pub relation: Relation,
    /// What gives its direction.
    pub of: RayOf,
}

/// What gives a ray its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayOf {
    /// The leg, 0 or 1, of a sought point.
    Leg(SpecialId, usize),
    /// A link, for the image of a further point of it.
    Arm {
        /// The link.
        link: BodyId,
        /// The point from whose image the ray starts.
        from: PointId,
        /// The point looked for.
        to: PointId,
        /// A third point, whose image is there too.
        other: PointId,
    },
}

/// Relation of a ray to a line of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Normal to it.
    Perpendicular,
    /// Parallel to it.
    Parallel,
    /// At the same angle to the line of two images as it makes with the line of their points.
    Angle,
}
