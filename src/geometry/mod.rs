//! Plane geometry that every later stage shares: points, vectors, angles, lines, their crossings, small linear systems.
//! In: coordinates in the scene's own length unit, x right, y up. Out: the same; only `angle.rs` deals in degrees.
//! Nothing here knows what a mechanism is.

mod angle;
mod ball;
mod exact;
mod lanes;
mod line;
mod numbers;
mod random;
mod reduced;
mod system;

pub use angle::{degrees_of, direction_of_degrees, turn_of_degrees};
pub use ball::Ball;
pub use exact::{RADIANS_PER_SECOND, RADIANS_PER_TURN};
pub use lanes::{Lanes, MANY, Many, OneByOne, Register, Registers, Row, portions};
pub use line::{Crossing, Line, PARALLEL, Place};
pub use numbers::{NEAR, Number, Pair, direction_near, quarters_of};
pub use random::Random;
pub use reduced::Reduced;
pub use system::{LinearSystem, Numbers};

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

/// The size of a set of points: the diagonal of their bounding box, zero for fewer than two.
///
/// It is at most √2 times the largest distance between two of the points: good enough to call a distance large or
/// small.
#[must_use]
pub fn span(points: impl IntoIterator<Item = Point>) -> f64 {
    let mut corners: Option<(Point, Point)> = None;
    for p in points {
        let (low, high) = corners.get_or_insert((p, p));
        *low = low.inf(&p);
        *high = high.sup(&p);
    }
    corners.map_or(0.0, |(low, high)| (high - low).norm())
}
