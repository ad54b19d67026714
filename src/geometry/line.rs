use super::{Point, UNIT_ROUNDOFF, Vector, cross, unit};

/// Sine of the angle below which two directions that each carry one rounding cannot be told from
/// parallel ones.
pub const PARALLEL: f64 = 4.0 * UNIT_ROUNDOFF;

/// A straight line, the line at infinity included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// Through a point, along a unit direction.
    Through {
        /// A point of the line.
        point: Point,
        /// Its direction, of length 1.
        direction: Vector,
    },
    /// The line at infinity.
    AtInfinity,
}

impl Line {
    /// The line through `point` along `along`, which need not be of length 1; `None` if `along` is zero.
    #[must_use]
    pub fn new(point: Point, along: Vector) -> Option<Line> {
        let direction = unit(along)?;
        Some(Line::Through { point, direction })
    }

    /// The unit direction, `None` for the line at infinity.
    #[must_use]
    pub fn direction(&self) -> Option<Vector> {
        match self {
            Line::Through { direction, .. } => Some(*direction),
            Line::AtInfinity => None,
        }
    }

    /// Where this line crosses `other`: a homogeneous point and the sine of the angle of crossing.
    #[must_use]
    pub fn crossing(&self, other: &Line) -> Crossing {
        match (self, other) {
            (Line::Through { point, direction }, Line::Through { point: q, direction: e }) => {
                // p + t d on the other line: t = ((q − p) × e) / (d × e); kept undivided.
                let sine = cross(*direction, *e);
                Crossing { base: *point, offset: direction * cross(q - point, *e), direction: *direction, sine }
            }
            (Line::Through { point, direction }, Line::AtInfinity)
            | (Line::AtInfinity, Line::Through { point, direction }) => {
                Crossing { base: *point, offset: *direction, direction: *direction, sine: 0.0 }
            }
            (Line::AtInfinity, Line::AtInfinity) => {
                Crossing { base: Point::origin(), offset: Vector::zeros(), direction: Vector::zeros(), sine: 0.0 }
            }
        }
    }
}

/// The crossing of two lines as a homogeneous point: `base + offset / sine`.
///
/// Nothing is divided until a place is asked for, so a crossing at infinity is an ordinary value.
/// The relative error of its distance from `base` is about (unit roundoff) / |sine|.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    base: Point,
    offset: Vector,
    direction: Vector,
    sine: f64,
}

impl Crossing {
    /// A crossing with the same sine, at a place that is known already.
    #[must_use]
    pub fn at(self, place: Point) -> Crossing {
        Crossing { base: place, offset: Vector::zeros(), ..self }
    }

    /// The sine of the angle from the first line to the second; zero when they are parallel.
    #[must_use]
    pub fn sine(&self) -> f64 {
        self.sine
    }

    /// The vector from `p` to the crossing; `None` at infinity.
    ///
    /// Subtracts coordinates first: far from the origin it keeps the digits that [`Self::place`] rounds off.
    #[must_use]
    pub fn vector_from(&self, p: Point) -> Option<Vector> {
        self.place().finite()?;
        Some((self.base - p) + self.offset / self.sine)
    }

    /// Where the lines cross.
    #[must_use]
    pub fn place(&self) -> Place {
        let reach = self.offset / self.sine;
        if self.sine.abs() <= PARALLEL || !(reach.x.is_finite() && reach.y.is_finite()) {
            Place::AtInfinity(self.direction)
        } else {
            Place::At(self.base + reach)
        }
    }
}

/// A point of the plane, points at infinity included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// An ordinary point.
    At(Point),
    /// The point at infinity in this direction (of length 1; either sense means the same point).
    AtInfinity(Vector),
}

impl Place {
    /// The point, unless it is at infinity.
    #[must_use]
    pub fn finite(&self) -> Option<Point> {
        match self {
            Place::At(p) => Some(*p),
            Place::AtInfinity(_) => None,
        }
    }
}
