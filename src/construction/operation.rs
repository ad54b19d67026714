use super::cut::SpecialId;
use super::kennedy::CenterId;
use super::number::{Equation, NumberId, Product};
use crate::geometry::Vector;
use crate::mechanism::{JointId, PointId, SliderId};
use crate::sheet::Sheet;
use smallvec::SmallVec;

/// Index of a place marked on a sheet: a joint of the scheme, a point of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PlaceId(pub usize);

/// Index of a line drawn on a sheet: a guide, a cut line, a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LineId(pub usize);

/// A step of the construction, by its sheet and its index there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct StepId {
    /// The sheet on which it is done.
    pub sheet: Sheet,
    /// Index among the steps of the sheet, from 0.
    pub index: usize,
}

/// One operation of ruler, pencil and calculator.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// The sheet on which it is drawn or measured; for a computation the sheet that uses the result.
    pub sheet: Sheet,
    /// The step that it belongs to; none for what precedes all steps or is only a reading.
    pub step: Option<StepId>,
    /// Its role in the construction.
    pub role: OperationRole,
    /// What is done.
    pub kind: OperationKind,
    /// Whether it can be done with ruler and pencil: false where it uses rates taken from the computed motion.
    pub by_hand: bool,
}

/// Role of an operation in the construction; mistakes, steps and sentences refer to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum OperationRole {
    /// The origin of a plan.
    Pole,
    /// A joint of the mechanism.
    Joint(PointId),
    /// A line through two points.
    Line,
    /// A slider's guide.
    Guide(SliderId),
    /// A cut line of a special point.
    CutLine(SpecialId),
    /// A special point, where two cut lines cross.
    SpecialPoint(SpecialId),
    /// A line on which an instant centre lies, the first or the second.
    CenterLine(CenterId, usize),
    /// An instant centre, where two such lines cross.
    Center(CenterId),
    /// The place where a load acts: its index among the loads of the force plan.
    Load(usize),
    /// The pitch point of wheels that mesh, or of a wheel and its rack.
    Pitch(JointId),
    /// A line of action of a force, or a normal to it.
    ForceLine,
    /// The foot of the normal from a point to a line of action.
    Foot,
    /// The point about which moments are taken, where two lines of action cross.
    MomentPoint,
    /// A ray towards a plan point.
    Ray,
    /// A plan point where two rays cross.
    Image,
    /// A vector of a plan.
    Vector,
    /// A number that is read, measured or computed.
    Number,
    /// The rates that equations are solved for.
    Rates,
}

/// The action of an operation, with its arguments and results.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OperationKind {
    /// Chooses the origin of a sheet: exact.
    Pole {
        /// The place made.
        place: PlaceId,
        /// Its coordinates, in units of the sheet.
        at: Vector,
    },
    /// Plots a joint of the mechanism.
    Plot {
        /// The place made.
        place: PlaceId,
        /// Its exact coordinates, in units of the sheet.
        at: Vector,
    },
    /// Joins two places by a line: its only errors are those of the two places.
    Join {
        /// The line made, from the first place towards the second.
        line: LineId,
        /// The first place.
        from: PlaceId,
        /// The second place.
        towards: PlaceId,
    },
    /// Draws a line of known direction through a place.
    Draw {
        /// The line made.
        line: LineId,
        /// A place of it.
        through: PlaceId,
        /// Its direction.
        along: Along,
    },
    /// Marks where two lines cross.
    Cross {
        /// The place made.
        place: PlaceId,
        /// The lines.
        lines: [LineId; 2],
    },
    /// Marks where two lines cross of which the construction need not have either: done only by mistake.
    Meet {
        /// The place made.
        place: PlaceId,
        /// The lines.
        lines: [Ruled; 2],
    },
    /// Marks a place of a line, the nearest to a given one: done only by mistake.
    OnLine {
        /// The place made.
        place: PlaceId,
        /// The line.
        line: Ruled,
        /// The given place, in units of the sheet.
        near: Vector,
    },
    /// Divides the line between two places as a point of a link divides the line between two others.
    Divide {
        /// The place made.
        place: PlaceId,
        /// The two places, images of the first two points.
        ends: [PlaceId; 2],
        /// On the scheme: the two points of the link, and the point on their line.
        like: [PlaceId; 3],
    },
    /// Lays off a vector of known size and direction.
    LayOff {
        /// Its end, which is made.
        place: PlaceId,
        /// Where it begins.
        from: PlaceId,
        /// Its signed size; a negative one runs against the direction.
        size: NumberId,
        /// Its direction.
        along: Along,
    },
    /// Measures from one place to another.
    Measure {
        /// The number made.
        number: NumberId,
        /// The first place.
        from: PlaceId,
        /// The second place.
        to: PlaceId,
        /// The measured quantity.
        how: MeasuredAs,
    },
    /// Reads the direction of a line: in degrees from +x, within ±90, as a line has no sense.
    ReadDirection {
        /// The number made.
        number: NumberId,
        /// The direction.
        along: Along,
    },
    /// Takes a number from the scene.
    Take {
        /// The number made.
        number: NumberId,
        /// Its value.
        value: f64,
    },
    /// Computes a sum of products.
    Compute {
        /// The number made.
        number: NumberId,
        /// The products.
        sum: Vec<Product>,
    },
    /// Solves equations for rates.
    Solve {
        /// The numbers made, in the order of the unknowns.
        unknowns: Vec<NumberId>,
        /// As many equations as unknowns, at most four.
        equations: Vec<Equation>,
    },
}

/// A line that somebody rules by mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ruled {
    /// One that is drawn.
    Line(LineId),
    /// One through two ends, of which one may be at infinity.
    Through([RuledEnd; 2]),
}

/// What a line runs through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RuledEnd {
    /// A place of the sheet.
    Place(PlaceId),
    /// A place that the construction does not mark, in units of the sheet.
    At(Vector),
    /// A point at infinity.
    Towards(Along),
}

/// A direction relative to a line on a sheet or to the scene's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// The reference direction …
    pub reference: Reference,
    /// … and the number of quarter turns from it, counter-clockwise.
    pub quarter_turns: u8,
}

/// A reference direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reference {
    /// The direction of a line that is drawn already.
    Line(LineId),
    /// The direction of a line of a plan, turned by the angle from one line of the scheme to another: so a triangle is
    /// drawn similar to that of the link.
    Angle {
        /// The line of the plan.
        base: LineId,
        /// The line of the scheme of which it is the image.
        from: LineId,
        /// The other line of the scheme.
        to: LineId,
    },
    /// A unit vector that the scene gives.
    Given(Vector),
}

/// What is measured between two places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredAs {
    /// The distance.
    Size,
    /// The component along a line, positive in its direction.
    Along(LineId),
    /// The component along x.
    X,
    /// The component along y.
    Y,
    /// The direction, in degrees from +x, in (−180, 180].
    Direction,
}

/// Unit of an elementary error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorUnit {
    /// Millimetres of paper.
    Length,
    /// Degrees.
    Direction,
}

impl Ruled {
    /// Whether it is drawn in a direction, not between two places.
    pub(super) fn is_drawn_along(self) -> bool {
        matches!(self, Ruled::Through(ends) if ends.iter().any(|end| matches!(end, RuledEnd::Towards(_))))
    }
}

impl Along {
    /// The direction of a line.
    #[must_use]
    pub fn line(line: LineId) -> Along {
        Along { reference: Reference::Line(line), quarter_turns: 0 }
    }

    /// The direction of a line of a plan, turned by the angle between two lines of the scheme.
    #[must_use]
    pub fn angle(base: LineId, [from, to]: [LineId; 2]) -> Along {
        Along { reference: Reference::Angle { base, from, to }, quarter_turns: 0 }
    }

    /// A given direction, of length 1.
    #[must_use]
    pub fn given(direction: Vector) -> Along {
        Along { reference: Reference::Given(direction), quarter_turns: 0 }
    }

    /// The direction, turned by so many further quarter turns counter-clockwise.
    #[must_use]
    pub fn turned(self, quarter_turns: u8) -> Along {
        Along { quarter_turns: self.quarter_turns + quarter_turns, ..self }
    }
}

impl OperationKind {
    /// Whether several steps may use its result: what is given, joining lines and sums belong to no step.
    pub(super) fn is_shared(&self) -> bool {
        use OperationKind::{Compute, Join, Plot, Pole, Take};
        matches!(self, Pole { .. } | Plot { .. } | Join { .. } | Take { .. } | Compute { .. })
    }

    /// The elementary errors of the hand in this operation, independent of each other and of other operations' errors.
    #[must_use]
    pub fn errors(&self) -> &'static [ErrorUnit] {
        match self {
            // Along x and y.
            OperationKind::Plot { .. } | OperationKind::Cross { .. } | OperationKind::Meet { .. } => {
                &[ErrorUnit::Length, ErrorUnit::Length]
            }
            // Along the line; then of the line.
            OperationKind::OnLine { line, .. } if line.is_drawn_along() => &[ErrorUnit::Length, ErrorUnit::Direction],
            OperationKind::OnLine { .. } => &[ErrorUnit::Length, ErrorUnit::Length],
            OperationKind::Draw { .. } | OperationKind::ReadDirection { .. } => &[ErrorUnit::Direction],
            OperationKind::LayOff { .. } => &[ErrorUnit::Direction, ErrorUnit::Length],
            OperationKind::Measure { how: MeasuredAs::Direction, .. } => &[ErrorUnit::Direction],
            OperationKind::Divide { .. } | OperationKind::Measure { .. } => &[ErrorUnit::Length],
            OperationKind::Pole { .. }
            | OperationKind::Join { .. }
            | OperationKind::Take { .. }
            | OperationKind::Compute { .. }
            | OperationKind::Solve { .. } => &[],
        }
    }

    /// The place that it makes; none for other results.
    #[must_use]
    pub fn place(&self) -> Option<PlaceId> {
        match self {
            OperationKind::Pole { place, .. }
            | OperationKind::Plot { place, .. }
            | OperationKind::Cross { place, .. }
            | OperationKind::Meet { place, .. }
            | OperationKind::OnLine { place, .. }
            | OperationKind::Divide { place, .. }
            | OperationKind::LayOff { place, .. } => Some(*place),
            _ => None,
        }
    }

    /// The line that it draws; none for other results.
    #[must_use]
    pub fn line(&self) -> Option<LineId> {
        match self {
            OperationKind::Join { line, .. } | OperationKind::Draw { line, .. } => Some(*line),
            _ => None,
        }
    }

    /// The numbers that it makes.
    #[must_use]
    pub fn numbers(&self) -> &[NumberId] {
        match self {
            OperationKind::Measure { number, .. }
            | OperationKind::ReadDirection { number, .. }
            | OperationKind::Take { number, .. }
            | OperationKind::Compute { number, .. } => core::slice::from_ref(number),
            OperationKind::Solve { unknowns, .. } => unknowns,
            _ => &[],
        }
    }

    /// The places and lines that it uses.
    pub(crate) fn places_and_lines_read(&self) -> (SmallVec<[PlaceId; 2]>, SmallVec<[LineId; 2]>) {
        let line = |along: &Along| match along.reference {
            Reference::Line(line) => SmallVec::from_slice(&[line]),
            Reference::Angle { base, from, to } => SmallVec::from_slice(&[base, from, to]),
            Reference::Given(_) => SmallVec::new(),
        };
        match self {
            OperationKind::Join { from, towards, .. } => (SmallVec::from_slice(&[*from, *towards]), SmallVec::new()),
            OperationKind::Draw { through, along, .. } => (SmallVec::from_slice(&[*through]), line(along)),
            OperationKind::Cross { lines, .. } => (SmallVec::new(), SmallVec::from_slice(lines)),
            OperationKind::ReadDirection { along, .. } => (SmallVec::new(), line(along)),
            OperationKind::Divide { ends, like, .. } => (ends.iter().chain(like).copied().collect(), SmallVec::new()),
            OperationKind::LayOff { from, along, .. } => (SmallVec::from_slice(&[*from]), line(along)),
            OperationKind::Measure { from, to, how, .. } => {
                let lines = match how {
                    MeasuredAs::Along(line) => SmallVec::from_slice(&[*line]),
                    _ => SmallVec::new(),
                };
                (SmallVec::from_slice(&[*from, *to]), lines)
            }
            _ => Default::default(),
        }
    }

    /// Calls `see` with each number that it uses.
    pub(crate) fn each_number_read(&self, mut see: impl FnMut(NumberId)) {
        let mut products = |all: &[Product]| all.iter().for_each(|product| product.of.iter().for_each(|&n| see(n)));
        match self {
            OperationKind::Compute { sum, .. } => products(sum),
            OperationKind::Solve { equations, .. } => {
                for equation in equations {
                    equation.left.iter().for_each(|(_, coefficient)| products(core::slice::from_ref(coefficient)));
                    products(&equation.right);
                }
            }
            OperationKind::LayOff { size, .. } => see(*size),
            _ => {}
        }
    }
}
