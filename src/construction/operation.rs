use super::cut::SpecialId;
use crate::geometry::Vector;
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId};
use smallvec::SmallVec;

/// Index of a place marked on a sheet: a joint of the scheme, a point of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PlaceId(pub usize);

/// Index of a line drawn on a sheet: a guide, a cut line, a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LineId(pub usize);

/// Index of a number that the person has: given, measured or computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NumberId(pub usize);

/// Where something is drawn; each has its own scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Sheet {
    /// The mechanism to scale.
    Scheme,
    /// The velocity plan.
    Velocity,
    /// The acceleration plan.
    Acceleration,
}

/// A step of the construction: its place among those of its sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct StepId {
    /// The sheet on which it is done.
    pub sheet: Sheet,
    /// How many steps of the sheet come before it.
    pub index: usize,
}

/// One operation of ruler, pencil and calculator.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// The sheet on which it happens; of a computation the sheet for which it is done.
    pub sheet: Sheet,
    /// The step that it belongs to; none for what comes before all steps or is only read off.
    pub step: Option<StepId>,
    /// What it is in the construction.
    pub part: Part,
    /// What is done.
    pub does: Does,
    /// Whether a person can do it with ruler and pencil: not where it builds on rates that no construction gives.
    pub by_hand: bool,
}

/// What an operation is in the construction: what mistakes, steps and sentences ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Where the values of a sheet count from.
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
    /// A ray towards a plan point.
    Ray,
    /// A plan point where two rays cross.
    Image,
    /// A vector of a plan.
    Vector,
    /// A number: what [`NumberKind`] says.
    Number,
    /// The rates that equations are solved for.
    Rates,
}

/// What an operation does: what it reads and what it makes.
#[derive(Clone, Debug, PartialEq)]
pub enum Does {
    /// Chooses where the sheet's values count from: exact.
    Pole {
        /// The place made.
        place: PlaceId,
        /// Where it is, in units of the sheet.
        at: Vector,
    },
    /// Sets a joint of the mechanism at its place.
    Plot {
        /// The place made.
        place: PlaceId,
        /// Where it belongs, in units of the sheet.
        at: Vector,
    },
    /// Lays the ruler on two places: what is off with this line is off with them.
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
    /// Lays off a vector of known size and direction.
    LayOff {
        /// Its end, which is made.
        place: PlaceId,
        /// Where it begins.
        from: PlaceId,
        /// Its size; a negative one runs against the direction.
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
        /// What is measured.
        how: How,
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
        /// What is summed.
        sum: Vec<Product>,
    },
    /// Solves equations for rates.
    Solve {
        /// The numbers made, in the order of the unknowns.
        unknowns: Vec<NumberId>,
        /// As many equations, at most four.
        equations: Vec<Equation>,
    },
}

/// A direction, by what is on the sheets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// To what it is set …
    pub reference: Reference,
    /// … turned by so many quarter turns counter-clockwise.
    pub quarter_turns: u8,
}

/// To what a direction is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reference {
    /// A line that is drawn already.
    Line(LineId),
    /// A direction that the scene gives, of length 1.
    Given(Vector),
}

/// What is measured from one place to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    /// The distance.
    Size,
    /// The distance, positive in the direction of a line.
    Along(LineId),
    /// The distance along x.
    X,
    /// The distance along y.
    Y,
    /// The direction, in degrees from +x, in (−180, 180].
    Direction,
}

/// A product of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Product {
    /// What it stands for.
    pub kind: ProductKind,
    /// A constant, often a sign.
    pub factor: f64,
    /// The numbers multiplied.
    pub of: SmallVec<[NumberId; 3]>,
}

/// What a product stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProductKind {
    /// A number as it is.
    Plain,
    /// A rate of rotation times a length: a relative velocity, a tangential acceleration.
    Turning,
    /// ω² times a length: a normal acceleration.
    Normal,
    /// 2 ω v_r.
    Coriolis,
    /// A rate along a guide.
    Sliding,
}

/// An equation for rates: Σ coefficient · unknown = Σ right.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The index of an unknown and its coefficient.
    pub left: Vec<(usize, Product)>,
    /// The right side.
    pub right: Vec<Product>,
}

/// What a number is.
#[derive(Clone, Debug, PartialEq)]
pub enum NumberKind {
    /// The distance of two places of the scheme.
    Length([End; 2]),
    /// A segment of the plan on this sheet, by the names of its ends.
    Segment(Sheet, [String; 2]),
    /// A rate: given, or solved for.
    Rate(Rate),
    /// The size of a vector that is laid off.
    Size,
    /// What is measured for a reader alone, by the name of the quantity.
    Reading(String),
}

/// An end of a length on the scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A joint.
    Joint(PointId),
    /// A special point.
    Special(SpecialId),
}

/// A rate of a link or a slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// Angular velocity.
    Omega(BodyId),
    /// Angular acceleration.
    Alpha(BodyId),
    /// Velocity along the guide.
    SlideVelocity(SliderId),
    /// Acceleration along the guide.
    SlideAcceleration(SliderId),
}

/// In what an elementary error is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorUnit {
    /// Millimetres of paper.
    Length,
    /// Degrees.
    Direction,
}

impl Sheet {
    /// All sheets, in the order in which they are drawn.
    pub const ALL: [Sheet; 3] = [Sheet::Scheme, Sheet::Velocity, Sheet::Acceleration];

    /// What it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Sheet::Scheme => "scheme",
            Sheet::Velocity => "velocity plan",
            Sheet::Acceleration => "acceleration plan",
        }
    }

    /// 0 for rates, 1 for their derivatives.
    #[must_use]
    pub fn order(self) -> usize {
        usize::from(self == Sheet::Acceleration)
    }
}

impl Rate {
    /// The name of its quantity, as in `omega(2)`.
    #[must_use]
    pub fn name(self, mechanism: &Mechanism) -> String {
        match self {
            Rate::Omega(link) => format!("omega({})", mechanism.body(link).name),
            Rate::Alpha(link) => format!("alpha({})", mechanism.body(link).name),
            Rate::SlideVelocity(slider) => format!("v_r({})", mechanism.slider_name(slider)),
            Rate::SlideAcceleration(slider) => format!("a_r({})", mechanism.slider_name(slider)),
        }
    }
}

impl Along {
    /// In the direction of a line.
    #[must_use]
    pub fn line(line: LineId) -> Along {
        Along { reference: Reference::Line(line), quarter_turns: 0 }
    }

    /// In a given direction.
    #[must_use]
    pub fn given(direction: Vector) -> Along {
        Along { reference: Reference::Given(direction), quarter_turns: 0 }
    }

    /// The same turned by so many quarter turns counter-clockwise.
    #[must_use]
    pub fn turned(self, quarter_turns: u8) -> Along {
        Along { quarter_turns: self.quarter_turns + quarter_turns, ..self }
    }
}

impl Product {
    /// A constant times numbers.
    #[must_use]
    pub fn new(kind: ProductKind, factor: f64, of: &[NumberId]) -> Product {
        Product { kind, factor, of: SmallVec::from_slice(of) }
    }

    /// A number as it is.
    #[must_use]
    pub fn plain(number: NumberId) -> Product {
        Product::new(ProductKind::Plain, 1.0, &[number])
    }

    /// The same, so many times as large.
    #[must_use]
    pub fn times(&self, factor: f64) -> Product {
        Product { factor: self.factor * factor, ..self.clone() }
    }
}

impl Does {
    /// The elementary errors that a hand brings into it, independent of each other and of those of other operations.
    #[must_use]
    pub fn errors(&self) -> &'static [ErrorUnit] {
        match self {
            // Along x and y.
            Does::Plot { .. } | Does::Cross { .. } => &[ErrorUnit::Length, ErrorUnit::Length],
            Does::Draw { .. } => &[ErrorUnit::Direction],
            Does::LayOff { .. } => &[ErrorUnit::Direction, ErrorUnit::Length],
            Does::Measure { how: How::Direction, .. } => &[ErrorUnit::Direction],
            Does::Measure { .. } => &[ErrorUnit::Length],
            Does::Pole { .. } | Does::Join { .. } | Does::Take { .. } | Does::Compute { .. } | Does::Solve { .. } => {
                &[]
            }
        }
    }

    /// The place that it makes.
    #[must_use]
    pub fn place(&self) -> Option<PlaceId> {
        match self {
            Does::Pole { place, .. }
            | Does::Plot { place, .. }
            | Does::Cross { place, .. }
            | Does::LayOff { place, .. } => Some(*place),
            _ => None,
        }
    }

    /// The line that it draws.
    #[must_use]
    pub fn line(&self) -> Option<LineId> {
        match self {
            Does::Join { line, .. } | Does::Draw { line, .. } => Some(*line),
            _ => None,
        }
    }

    /// The numbers that it makes.
    #[must_use]
    pub fn numbers(&self) -> &[NumberId] {
        match self {
            Does::Measure { number, .. } | Does::Take { number, .. } | Does::Compute { number, .. } => {
                core::slice::from_ref(number)
            }
            Does::Solve { unknowns, .. } => unknowns,
            _ => &[],
        }
    }

    /// The places and lines that it builds on.
    pub(super) fn places_and_lines_read(&self) -> (SmallVec<[PlaceId; 2]>, SmallVec<[LineId; 2]>) {
        let line = |along: &Along| match along.reference {
            Reference::Line(line) => SmallVec::from_slice(&[line]),
            Reference::Given(_) => SmallVec::new(),
        };
        match self {
            Does::Join { from, towards, .. } => (SmallVec::from_slice(&[*from, *towards]), SmallVec::new()),
            Does::Draw { through, along, .. } => (SmallVec::from_slice(&[*through]), line(along)),
            Does::Cross { lines, .. } => (SmallVec::new(), SmallVec::from_slice(lines)),
            Does::LayOff { from, along, .. } => (SmallVec::from_slice(&[*from]), line(along)),
            Does::Measure { from, to, how, .. } => {
                let lines = match how {
                    How::Along(line) => SmallVec::from_slice(&[*line]),
                    _ => SmallVec::new(),
                };
                (SmallVec::from_slice(&[*from, *to]), lines)
            }
            _ => Default::default(),
        }
    }

    /// Calls `see` with each number that it builds on.
    pub fn each_number_read(&self, mut see: impl FnMut(NumberId)) {
        let mut products = |all: &[Product]| all.iter().for_each(|product| product.of.iter().for_each(|&n| see(n)));
        match self {
            Does::Compute { sum, .. } => products(sum),
            Does::Solve { equations, .. } => {
                for equation in equations {
                    equation.left.iter().for_each(|(_, coefficient)| products(core::slice::from_ref(coefficient)));
                    products(&equation.right);
                }
            }
            Does::LayOff { size, .. } => see(*size),
            _ => {}
        }
    }
}
