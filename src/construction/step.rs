use super::cut::SpecialId;
use super::operation::Sheet;
use crate::geometry::Vector;
use crate::mechanism::{BodyId, DrivenSlide, PointId, SliderId};
use crate::words::{Notation, with_prime};
use indexmap::IndexMap;

/// Which plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanKind {
    /// Of velocities, from the pole p.
    Velocity,
    /// Of accelerations, from the pole π.
    Acceleration,
}

impl PlanKind {
    /// The name of the pole.
    #[must_use]
    pub fn pole(self) -> &'static str {
        match self {
            PlanKind::Velocity => "p",
            PlanKind::Acceleration => "π",
        }
    }

    /// How the pole is written, in markup.
    #[must_use]
    pub fn pole_in(self, notation: &Notation) -> &'static str {
        match self {
            PlanKind::Velocity => notation.velocity_pole,
            PlanKind::Acceleration => notation.acceleration_pole,
        }
    }

    /// The quantity name of a segment of the plan, as in `vplan(b,s3)`.
    #[must_use]
    pub fn segment_name(self, from: &str, to: &str) -> String {
        let head = match self {
            PlanKind::Velocity => "vplan",
            PlanKind::Acceleration => "aplan",
        };
        format!("{head}({from},{to})")
    }

    /// The sheet on which it is drawn.
    #[must_use]
    pub fn sheet(self) -> Sheet {
        match self {
            PlanKind::Velocity => Sheet::Velocity,
            PlanKind::Acceleration => Sheet::Acceleration,
        }
    }

    /// Name of the scale factor, as written.
    #[must_use]
    pub fn scale_name(self) -> &'static str {
        match self {
            PlanKind::Velocity => "μ_v",
            PlanKind::Acceleration => "μ_a",
        }
    }
}

/// A velocity or acceleration plan: its points and the steps by which it is drawn.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Which plan.
    pub kind: PlanKind,
    /// Its points by name, in order of construction; vectors from the pole, in units of the plan.
    pub points: IndexMap<String, PlanPoint>,
    /// How it is drawn, in order.
    pub steps: Vec<Step>,
}

/// A point of a plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanPoint {
    /// From the pole, in units of velocity or acceleration.
    pub vector: Vector,
    /// What it is.
    pub role: PointRole,
}

/// What a plan point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointRole {
    /// The pole, or the image of a point at rest.
    Pole,
    /// The end of a known vector.
    Known,
    /// The end of a normal part.
    Normal,
    /// The end of what a driven slider adds.
    Slid,
    /// The image of a special point.
    Special,
    /// The image of another point.
    Image,
}

/// One thing that a teacher does at the board: facts, from which [`Teller`](super::Teller) makes sentences and equations.
#[derive(Clone, Debug)]
pub struct Step {
    /// What is done.
    pub action: Action,
}

/// What a step does.
#[derive(Clone, Debug)]
pub enum Action {
    /// Choose a pole; these points at rest have their images there.
    Pole {
        /// Images that coincide with the pole.
        images: Vec<String>,
    },
    /// Find a special point on the mechanism: cut lines cross there.
    SpecialPoint {
        /// Its name.
        point: String,
        /// Which it is.
        special: SpecialId,
        /// Sine of the angle of crossing.
        sine: f64,
    },
    /// Lay off a vector.
    LayOff(Arrow),
    /// Draw a line of known direction.
    Ray(Ray),
    /// Mark where two rays cross.
    Cross {
        /// The point found.
        point: String,
        /// The points from which the two rays were drawn.
        from: [String; 2],
        /// Sine of the angle of crossing.
        sine: f64,
    },
    /// Measure a segment.
    Measure {
        /// From this plan point …
        from: String,
        /// … to this one.
        to: String,
        /// Its length in units of the plan.
        value: f64,
    },
    /// Measure a length on the mechanism.
    MeasureLength {
        /// From this point …
        from: String,
        /// … to this one.
        to: String,
        /// Its length.
        value: f64,
    },
    /// Solve equations for unknowns.
    Solve {
        /// The equations.
        equations: Vec<LegEquation>,
        /// The unknowns' quantity names and values.
        unknowns: Vec<(String, f64)>,
    },
    /// There is no construction by two rays; these special points lie at infinity, where that is the reason.
    NoConstruction {
        /// Their names.
        far: Vec<String>,
    },
}

impl Action {
    /// Whether it reads a length off a sheet.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        matches!(self, Action::MeasureLength { .. } | Action::Measure { .. })
    }

    /// The plan point that it makes, if it makes one.
    #[must_use]
    pub fn image(&self) -> Option<&str> {
        match self {
            Action::LayOff(arrow) => Some(&arrow.to),
            Action::Cross { point, .. } => Some(point),
            _ => None,
        }
    }
}

/// The equation of a measured segment: what a leg adds to the motion of the point looked for makes it up.
#[derive(Clone, Debug, PartialEq)]
pub struct LegEquation {
    /// The point looked for …
    pub special: SpecialId,
    /// … over which of its legs.
    pub side: usize,
    /// The plan point from which the segment is measured.
    pub from: String,
    /// The segment, positive a quarter turn counter-clockwise from the cut line's direction.
    pub segment: f64,
}

/// A vector of a plan, from one of its points to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// From this plan point …
    pub from: String,
    /// … to this one.
    pub to: String,
    /// What it is.
    pub of: VectorOf,
}

/// What a vector of a plan is.
#[derive(Clone, Debug, PartialEq)]
pub enum VectorOf {
    /// The whole velocity or acceleration of a body's point.
    Point(BodyId, PointId),
    /// The normal part of a leg, Coriolis's included.
    Normal(SpecialId, usize),
    /// The velocity of one point of a link relative to another, by their names.
    Relative {
        /// The link.
        link: BodyId,
        /// Relative to this point …
        from: String,
        /// … that of this one.
        to: String,
    },
    /// The sliding velocity at a slider, from the point of the guide's body, by its name, to the slider's.
    Sliding(SliderId, String),
    /// What a driven slider adds.
    Driven(DrivenSlide, Added),
}

/// What a driven slider adds to the motion of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Added {
    /// v_r.
    SlidingVelocity,
    /// a_r.
    SlidingAcceleration,
    /// 2 ω ẑ × v_r.
    Coriolis,
}

impl Added {
    /// What a slider adds on a sheet, in the order in which it is laid off.
    #[must_use]
    pub fn on(sheet: Sheet) -> &'static [Added] {
        match sheet {
            Sheet::Acceleration => &[Added::SlidingAcceleration, Added::Coriolis],
            _ => &[Added::SlidingVelocity],
        }
    }
}

/// What kind of vector an arrow stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrowKind {
    /// A whole velocity or acceleration, from the pole.
    Whole,
    /// A normal part.
    Normal,
    /// A relative velocity of two points of one link.
    Relative,
    /// A sliding velocity or acceleration.
    Sliding,
    /// The Coriolis acceleration of a driven slider.
    Coriolis,
}

impl Arrow {
    /// What kind of vector it stands for.
    #[must_use]
    pub fn kind(&self) -> ArrowKind {
        match self.of {
            VectorOf::Point(..) => ArrowKind::Whole,
            VectorOf::Normal(..) => ArrowKind::Normal,
            VectorOf::Relative { .. } => ArrowKind::Relative,
            VectorOf::Driven(_, Added::Coriolis) => ArrowKind::Coriolis,
            VectorOf::Sliding(..) | VectorOf::Driven(..) => ArrowKind::Sliding,
        }
    }
}

/// A line of known direction through a plan point, on which a crossing will lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Ray {
    /// The plan point.
    pub through: String,
    /// The point that it will lead to.
    pub to: String,
    /// Unit direction.
    pub direction: Vector,
    /// How it lies to the line of the mechanism that gives the direction.
    pub relation: Relation,
    /// The point looked for …
    pub special: SpecialId,
    /// … and over which of its legs.
    pub side: usize,
}

/// How a ray lies to a line of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Normal to it.
    Perpendicular,
    /// Parallel to it.
    Parallel,
}

impl Plan {
    /// The vector from one plan point to another; `None` for a name that the plan does not have.
    #[must_use]
    pub fn segment(&self, from: &str, to: &str) -> Option<Vector> {
        Some(self.points.get(to)?.vector - self.points.get(from)?.vector)
    }

    /// How a name within the plan is shown where it would be `written` otherwise: poles and images follow the notation.
    #[must_use]
    pub fn shown(&self, name: &str, written: String, notation: &Notation) -> String {
        use PointRole::{Image, Known, Pole, Special};
        let pole = self.kind.pole_in(notation);
        let Some(point) = self.points.get(name) else {
            return written;
        };
        if name == self.kind.pole() {
            return pole.to_owned();
        }
        let primes = notation.primes && self.kind == PlanKind::Acceleration;
        let shown = match point.role {
            Pole | Known | Special | Image if primes => with_prime(&written),
            _ => written,
        };
        // The pole's letter is taken, but for a point at rest, whose image is the pole.
        match shown == pole && point.role != Pole {
            true => with_prime(&shown),
            false => shown,
        }
    }

    /// The vectors that the steps lay off, in order.
    pub fn arrows(&self) -> impl Iterator<Item = &Arrow> {
        self.steps.iter().filter_map(|s| match &s.action {
            Action::LayOff(arrow) => Some(arrow),
            _ => None,
        })
    }

    /// The rays that the steps draw, in order.
    pub fn rays(&self) -> impl Iterator<Item = &Ray> {
        self.steps.iter().filter_map(|s| match &s.action {
            Action::Ray(ray) => Some(ray),
            _ => None,
        })
    }
}
