use crate::geometry::Vector;
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

/// One act of the construction.
#[derive(Clone, Debug, PartialEq)]
pub struct Act {
    /// The sheet on which it happens; of a computation the sheet for which it is done.
    pub sheet: Sheet,
    /// What it makes, by name or in a few words: `S3`, `n_b3`, `L(B,S3)`, `ray from b to s3`.
    pub makes: String,
    /// What is done.
    pub deed: Deed,
}

/// What an act does: what it reads and what it makes.
#[derive(Clone, Debug, PartialEq)]
pub enum Deed {
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
        /// To what its direction is set …
        reference: Reference,
        /// … turned by so many quarter turns counter-clockwise.
        quarter_turns: u8,
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
        /// To what its direction is set …
        reference: Reference,
        /// … turned by so many quarter turns counter-clockwise.
        quarter_turns: u8,
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
    /// A constant, often a sign.
    pub factor: f64,
    /// The numbers multiplied.
    pub of: SmallVec<[NumberId; 3]>,
}

/// An equation for rates: Σ coefficient · unknown = Σ right.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The index of an unknown and its coefficient.
    pub left: Vec<(usize, Product)>,
    /// The right side.
    pub right: Vec<Product>,
}

/// In what an elementary error is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// Millimetres of paper.
    Length,
    /// Degrees.
    Direction,
}

impl Product {
    /// A constant times numbers.
    #[must_use]
    pub fn new(factor: f64, of: &[NumberId]) -> Product {
        Product { factor, of: SmallVec::from_slice(of) }
    }
}

impl Deed {
    /// The elementary errors that a hand brings into it, independent of each other and of those of other acts.
    #[must_use]
    pub fn errors(&self) -> &'static [Error] {
        match self {
            // Along x and y.
            Deed::Plot { .. } | Deed::Cross { .. } => &[Error::Length, Error::Length],
            Deed::Draw { .. } => &[Error::Direction],
            Deed::LayOff { .. } => &[Error::Direction, Error::Length],
            Deed::Measure { how: How::Direction, .. } => &[Error::Direction],
            Deed::Measure { .. } => &[Error::Length],
            Deed::Pole { .. } | Deed::Join { .. } | Deed::Take { .. } | Deed::Compute { .. } | Deed::Solve { .. } => {
                &[]
            }
        }
    }
}
