//! Steps at the board: what is done in each, and the quantities that it yields.

use super::arrow::{Arrow, Ray};
use super::cut::SpecialId;
use super::kennedy::{CenterId, CenterLine, Centers, CurvatureStep, FigureOf};
use super::lever::{Lever, LeverStep};
use super::plan::Plan;
use super::polygon::{ForcePlan, ForceStep};
use super::speeds::SpeedStep;
use crate::centers::LinkPair;
use crate::mechanism::{BodyId, GROUND, JointId, PointId, SliderId};
use crate::sheet::{Order, Sheet};

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
