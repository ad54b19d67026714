//! Plane geometry that every later stage shares: points, vectors, angles, lines, their crossings, small linear systems.
//! In: coordinates in the scene's own length unit, x right, y up. Out: the same; functions whose names say so deal in
//! degrees.
//! Nothing here knows what a mechanism is.

mod ball;
mod decimal;
mod equations;
mod lanes;
mod line;
mod numbers;
mod random;
mod reduced;
mod refined;
mod several;
mod system;

pub use ball::{Ball, DEGREES_PER_RADIAN, RADIANS_PER_SECOND, RADIANS_PER_TURN};
pub use equations::{Equations, Solvable};
pub use lanes::{Lanes, MANY, Many, OneByOne, Register, Registers, Row, TOGETHER, portions};
pub use line::{Crossing, Line, PARALLEL, Place};
pub use numbers::{Floating, NEAR, Number, Pair, direction_near, quarters_of};
pub use random::Random;
pub use reduced::Reduced;
pub use refined::{Balls, Sides, refined};
pub use several::{SEVERAL, Several};
pub use system::{Elements, LinearSystem, Numbers, Verified};

/// A place in the plane, in the scene's length unit. Points cannot be added to each other.
pub type Point = nalgebra::Point2<f64>;

/// A difference of places, a velocity or an acceleration.
pub type Vector = nalgebra::Vector2<f64>;

/// A rigid placement: rotation, then translation.
pub type Placement = nalgebra::Isometry2<f64>;

/// A rotation, held as cosine and sine.
pub type Turn = nalgebra::UnitComplex<f64>;

/// Half the distance from 1 to the next larger f64: the relative error of one rounding.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// `v` turned by +90° (counter-clockwise): J(x, y) = (−y, x).
#[inline]
#[must_use]
pub fn quarter_turn(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

/// The product of two vectors as complex numbers: `a` turned by the angle of `b` and longer as many times as `b` is.
#[inline]
#[must_use]
pub fn complex_product(a: Vector, b: Vector) -> Vector {
    Vector::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// The scalar cross product a × b, positive when b lies counter-clockwise of a.
#[inline]
#[must_use]
pub fn cross(a: Vector, b: Vector) -> f64 {
    a.x * b.y - a.y * b.x
}

/// The unit vector along `v`, `None` for the zero vector or one that is not finite; also for lengths whose squares
/// leave the range of f64.
#[must_use]
pub fn unit(v: Vector) -> Option<Vector> {
    let largest = v.amax();
    (largest > 0.0 && largest.is_finite()).then(|| (v / largest).normalize())
}

/// The bounding box of points.
#[derive(Clone, Copy, Debug, Default)]
pub struct BoundingBox {
    /// Its lower left and upper right corner; none without points.
    pub corners: Option<[Point; 2]>,
}

impl BoundingBox {
    /// The box of these points.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = Point>) -> BoundingBox {
        BoundingBox::default().with(points)
    }

    /// The box of its points and these.
    #[must_use]
    pub fn with(mut self, points: impl IntoIterator<Item = Point>) -> BoundingBox {
        for p in points {
            let [low, high] = self.corners.get_or_insert([p, p]);
            *low = low.inf(&p);
            *high = high.sup(&p);
        }
        self
    }

    /// The box of its points and those of another.
    #[must_use]
    pub fn joined(self, other: BoundingBox) -> BoundingBox {
        self.with(other.corners.into_iter().flatten())
    }

    /// Its diagonal: the size of the set of points, zero for fewer than two.
    ///
    /// It is at most √2 times the largest distance between two of the points: good enough to call a distance large or
    /// small.
    #[must_use]
    pub fn size(self) -> f64 {
        self.corners.map_or(0.0, |[low, high]| (high - low).norm())
    }
}

/// The size of a set of points, as [`BoundingBox::size`] has it.
#[must_use]
pub fn span(points: impl IntoIterator<Item = Point>) -> f64 {
    BoundingBox::of(points).size()
}

/// The corners of the convex hull of points, counter-clockwise, by Andrew's monotone chain (1979).
///
/// `is_corner` says of three points in order round it whether the second is a corner: there the outline turns to the left, by
/// as much as the caller asks.
pub fn hull(mut points: Vec<Point>, is_corner: impl Fn([Point; 3]) -> bool) -> Vec<Point> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut hull: Vec<Point> = Vec::new();
    for _ in 0..2 {
        let first = hull.len();
        for &point in &points {
            while let [.., a, b] = hull[first..]
                && !is_corner([a, b, point])
            {
                hull.pop();
            }
            hull.push(point);
        }
        // The last point is the first one of the way back.
        hull.pop();
        points.reverse();
    }
    hull
}

/// The unit vector at `degrees` from +x, counter-clockwise; exact at whole quarter turns.
///
/// The whole quarter turns are taken off in degrees, where that is exact, so 90° gives (0, 1) and a
/// large angle loses nothing. Trigonometry is libm's: the same bits on every platform.
#[must_use]
pub fn direction_of_degrees(degrees: f64) -> Vector {
    // Products with 90 are exact up to some 1e17; the remainder always is.
    let degrees = if degrees.abs() > 1e15 { degrees % 360.0 } else { degrees };
    let quarters = (degrees / 90.0).round();
    let rest = (degrees - 90.0 * quarters).to_radians();
    let (sine, cosine) = (libm::sin(rest), libm::cos(rest));
    let Pair { x, y } = Pair { x: cosine, y: sine }.turned_by_quarters(quarters.rem_euclid(4.0) as i64);
    Vector::new(x, y)
}

/// The rotation by `degrees`, counter-clockwise.
#[must_use]
pub fn turn_of_degrees(degrees: f64) -> Turn {
    let d = direction_of_degrees(degrees);
    Turn::from_cos_sin_unchecked(d.x, d.y)
}

/// The angle of `v` from +x in degrees, in (−180, 180]; zero for the zero vector.
#[must_use]
pub fn degrees_of(v: Vector) -> f64 {
    let degrees = libm::atan2(v.y, v.x).to_degrees();
    if degrees <= -180.0 { 180.0 } else { degrees }
}

/// An angle in degrees plus the whole turns that bring it nearest to `other`; nearest to zero it is the shorter way round.
#[must_use]
pub fn with_turns(degrees: f64, other: f64) -> f64 {
    degrees + 360.0 * libm::round((other - degrees) / 360.0)
}

/// The same of a line, which has no sense: with half turns added.
#[must_use]
pub fn without_sense(degrees: f64, other: f64) -> f64 {
    degrees + 180.0 * libm::round((other - degrees) / 180.0)
}
