//! Steps at the board, and the plans that they draw.

use super::cut::SpecialId;
use super::kennedy::{CenterId, CenterLine, Centers, CurvatureStep, FigureOf};
use super::lever::{Lever, LeverStep};
use super::polygon::{ForcePlan, ForceStep};
use super::speeds::SpeedStep;
use crate::centers::LinkPair;
use crate::geometry::Vector;
use crate::mechanism::{BodyId, DrivenSlide, GROUND, JointId, PointId, SliderId};
use crate::sheet::{Order, Sheet};
use crate::words::{Notation, with_prime};
use indexmap::IndexMap;

/// What is done in a step at the board: the facts from which [`Teller`](super::Teller) makes sentences and equations.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Action {
    /// Choose a pole; it is the image of all fixed points.
    Pole {
        /// Of the plan of velocities or of accelerations.
        order: Order,
        /// Names of the images that coincide with the pole.
        images: Vec<String>,
    },
    /// Find a special point on the scheme by crossing cut lines.
    SpecialPoint {
        /// Its name.
        point: String,
        /// Its index.
        special: SpecialId,
        /// Sine of the angle between the cut lines.
        sine: f64,
    },
    /// Lay off a vector.
    LayOff(Arrow),
    /// Draw a line of known direction.
    Ray(Ray),
    /// Mark where two rays cross.
    Cross {
        /// The plan point at the crossing.
        point: String,
        /// The plan points from which the two rays were drawn.
        from: [String; 2],
        /// Sine of the angle between the rays.
        sine: f64,
    },
    /// Measure a length on the scheme or a segment of a plan.
    Measure {
        /// From this point …
        from: String,
        /// … to this one.
        to: String,
        /// Its length, in units of length, velocity or acceleration.
        value: f64,
    },
    /// Solve equations for unknowns.
    Solve {
        /// The equations.
        equations: Vec<RateEquation>,
        /// The unknowns' quantity names and values.
        unknowns: Vec<(String, f64)>,
    },
    /// Divide the line between two images in the ratio of the link: the image of a point on the line of two others.
    Divide {
        /// The plan point made.
        point: String,
        /// The images that are divided.
        between: [String; 2],
        /// On the link: the points whose images they are, and the point looked for.
        points: [PointId; 3],
    },
    /// The link does not turn: a further point has the image of another.
    Coincide {
        /// The plan point made.
        point: String,
        /// The image that is there.
        with: String,
        /// The link.
        link: BodyId,
    },
    /// Plot the permanent instant centres: pins, and guides' normals at infinity.
    PermanentCenters,
    /// Draw a line on which a centre lies.
    CenterLine {
        /// The centre that it leads to …
        center: CenterId,
        /// … of these links …
        pair: LinkPair,
        /// … in this figure.
        figure: FigureOf,
        /// The line.
        line: CenterLine,
    },
    /// Mark the instant centre where its two lines cross.
    Center(CenterId),
    /// Leave a link out and glue two others together.
    LeaveOut {
        /// The centre that is looked for.
        center: LinkPair,
        /// The figure that is left.
        figure: FigureOf,
    },
    /// No lines lead to these centres: their places come from the computed motion.
    CentersByRates(Vec<LinkPair>),
    /// Compute the angular velocity of a link from distances of centres.
    RateByCenters {
        /// The link.
        link: BodyId,
        /// The driven link.
        driver: BodyId,
        /// Its angular velocity.
        value: f64,
        /// Names of the distances that are measured for it, and of the angular velocity.
        names: Vec<String>,
    },
    /// Compute the angular velocity of a link from that of a driven slider, which the link has in this centre.
    RateBySlide {
        /// The link.
        link: BodyId,
        /// The centre.
        at: LinkPair,
        /// The slider.
        slider: SliderId,
        /// The angular velocity.
        value: f64,
        /// Names of the distance that is measured for it, and of the angular velocity.
        names: Vec<String>,
    },
    /// Lay off the velocity of a point, normal to its ray from the centre of its link: index among the velocities by centres.
    VelocityByCenters(usize),
    /// Draw what leads to the centre of curvature of a path: index among the pole tangents, among the centres of curvature, or among the inflection poles.
    Curvature {
        /// The index.
        index: usize,
        /// What is drawn.
        step: CurvatureStep,
    },
    /// Something of the force plan.
    Force(ForceStep),
    /// Something of a lever.
    Lever(LeverStep),
    /// Something of the speed diagram.
    Speeds(SpeedStep),
    /// There is no construction by two rays: names of the special points at infinity, where these are the reason; else
    /// none.
    NoConstruction(Vec<String>),
}

impl Action {
    /// Whether it reads a length off a sheet.
    pub(crate) fn is_measured(&self) -> bool {
        matches!(self, Action::Measure { .. })
    }

    /// The plan point that it makes, if it makes one.
    #[must_use]
    pub fn image(&self) -> Option<&str> {
        match self {
            Action::LayOff(arrow) => Some(&arrow.to),
            Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => Some(point),
            _ => None,
        }
    }
}

/// A step of the construction with its number.
#[derive(Clone, Copy, Debug)]
pub struct NumberedStep<'a> {
    /// Number of the step, from 1 through all sheets.
    pub number: usize,
    /// The sheet on which it is drawn.
    pub sheet: Sheet,
    /// The plan to which it belongs; none on other sheets.
    pub plan: Option<&'a Plan>,
    /// The instant centres, where there are some.
    pub centers: Option<&'a Centers>,
    /// The force plan, where there is one.
    pub forces: Option<&'a ForcePlan>,
    /// The levers, where there are some.
    pub levers: &'a [Lever],
    /// What is done.
    pub action: &'a Action,
}

impl NumberedStep<'_> {
    /// Names of the quantities that the step yields.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let sheet = self.sheet;
        match self.action {
            Action::Measure { from, to, .. } => vec![sheet.segment_name(from, to)],
            Action::LayOff(arrow) => vec![sheet.segment_name(&arrow.from, &arrow.to)],
            Action::Solve { unknowns, .. } => unknowns.iter().map(|u| u.0.clone()).collect(),
            Action::Center(id) => self.centers.map_or_else(Vec::new, |centers| centers.get(*id).quantities()),
            Action::RateByCenters { names, .. } | Action::RateBySlide { names, .. } => names.clone(),
            Action::VelocityByCenters(index) => {
                let velocity = self.centers.and_then(|centers| centers.velocities.get(*index));
                velocity.map_or_else(Vec::new, |velocity| velocity.names.clone())
            }
            Action::Curvature { index, step } => {
                let inflection = self.centers.and_then(|centers| centers.inflections.get(*index));
                match (step, inflection) {
                    (CurvatureStep::InflectionPoint, Some(inflection)) => inflection.measured.clone(),
                    (CurvatureStep::InflectionPole, Some(inflection)) => inflection.found.clone(),
                    _ => Vec::new(),
                }
            }
            Action::PermanentCenters
            | Action::CenterLine { .. }
            | Action::LeaveOut { .. }
            | Action::CentersByRates(_) => Vec::new(),
            Action::Force(step) => self.forces.map_or_else(Vec::new, |plan| plan.names(step)),
            Action::Lever(step) => {
                let (LeverStep::Turn(index) | LeverStep::Arm(index, _) | LeverStep::Effort(index)) = *step;
                self.levers.get(index).map_or_else(Vec::new, |lever| lever.names(*step))
            }
            // At the pole there is nothing to be measured.
            Action::Coincide { link: GROUND, .. } => Vec::new(),
            action => {
                let image = self.plan.zip(action.image());
                image.map(|(plan, point)| sheet.segment_name(plan.order.pole(), point)).into_iter().collect()
            }
        }
    }
}

/// An equation from which rates are found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RateEquation {
    /// That of a segment measured for a leg.
    Leg(LegEquation),
    /// That of a segment between the images of two points of a wheel or an arm.
    Wheel(WheelEquation),
    /// That of a mesh, z₁ ω₁ + z₂ ω₂ = (z₁ + z₂) ω_carrier, or the same for angular accelerations.
    Mesh(Order, JointId),
    /// One speed where two wheels, or a wheel and its rack, touch, or at the rims of wheels with a belt.
    Rolling(Order, JointId),
}

/// The equation of a measured segment between the images of two points of a wheel or an arm: its angular velocity times their distance.
#[derive(Clone, Debug, PartialEq)]
pub struct WheelEquation {
    /// The wheel or the arm.
    pub link: BodyId,
    /// The names of its two points.
    pub ends: [String; 2],
    /// The image of the first …
    pub from: String,
    /// … and that of the second.
    pub to: String,
    /// The segment, with the sign of the angular velocity.
    pub segment: f64,
}

/// The equation of a measured segment, which is the sum of the terms of a leg.
#[derive(Clone, Debug, PartialEq)]
pub struct LegEquation {
    /// Whether the segment shows a velocity or an acceleration.
    pub order: Order,
    /// The sought point …
    pub special: SpecialId,
    /// … and the leg, 0 or 1.
    pub side: usize,
    /// The plan point from which the segment is measured.
    pub from: String,
    /// The segment, positive a quarter turn counter-clockwise from the cut line's direction.
    pub segment: f64,
}

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
