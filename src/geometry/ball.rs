use super::{Number, Pair, Point, Vector};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Relative rounding error allowed for the middle of a sum or product: 16 u², at least twice the proven bounds 3 u² and
/// 7 u².
const ROUNDING: f64 = f64::EPSILON * f64::EPSILON * 4.0;

/// A number with twice the digits of f64 and a bound of its error: the true number lies within `radius` of `high +
/// low`.
///
/// Sums and products are those of double-double arithmetic, which err by at most 3 u² and 7 u² of the result (Joldes,
/// Muller, Popescu, *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*, ACM TOMS 44
/// (2017), algorithms 6 and 10, made of Knuth's two-sum and Dekker's product); radii are propagated as in ball
/// arithmetic (Johansson, *Arb*, IEEE Trans. Computers 66 (2017)). Each operation rounds the same on every platform. A
/// factor of 2^996 or more makes a product NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ball {
    /// The middle, rounded to f64.
    pub high: f64,
    /// The rest of the middle, at most half a unit in the last place of `high`.
    pub low: f64,
    /// Bound of the absolute error of `high + low`.
    pub radius: f64,
}

impl Ball {
    /// The difference x − y of two exact numbers, without rounding error.
    #[inline]
    #[must_use]
    pub fn difference(x: f64, y: f64) -> Ball {
        let (high, low) = two_sum(x, -y);
        Ball { high, low, radius: 0.0 }
    }

    /// Twice the number, exactly.
    #[inline]
    #[must_use]
    pub fn twice(self) -> Ball {
        Ball { high: 2.0 * self.high, low: 2.0 * self.low, radius: 2.0 * self.radius }
    }

    /// Adds `error` to the radius.
    #[inline]
    #[must_use]
    pub fn widened(self, error: f64) -> Ball {
        Ball { radius: self.radius + error.abs(), ..self }
    }

    /// Bound of the absolute error of `high` taken without `low`.
    #[inline]
    #[must_use]
    pub fn error(self) -> f64 {
        self.low.abs() + self.radius
    }
}

/// An exact number: a ball of radius 0.
impl From<f64> for Ball {
    #[inline]
    fn from(x: f64) -> Ball {
        Ball { high: x, ..Ball::default() }
    }
}

impl Add for Ball {
    type Output = Ball;

    #[inline]
    fn add(self, other: Ball) -> Ball {
        let (sum, rest) = two_sum(self.high, other.high);
        let (low, lowest) = two_sum(self.low, other.low);
        let (sum, rest) = ordered_sum(sum, rest + low);
        let (high, low) = ordered_sum(sum, rest + lowest);
        Ball { high, low, radius: self.radius + other.radius + ROUNDING * high.abs() }
    }
}

impl Neg for Ball {
    type Output = Ball;

    #[inline]
    fn neg(self) -> Ball {
        Ball { high: -self.high, low: -self.low, ..self }
    }
}

impl Sub for Ball {
    type Output = Ball;

    #[inline]
    fn sub(self, other: Ball) -> Ball {
        self + -other
    }
}

impl Mul for Ball {
    type Output = Ball;

    #[inline]
    fn mul(self, other: Ball) -> Ball {
        let (product, rest) = two_product(self.high, other.high);
        let crossed = self.high * other.low + self.low * other.high;
        let (high, low) = ordered_sum(product, rest + crossed);
        let carried = self.high.abs() * other.radius + self.radius * other.high.abs();
        Ball { high, low, radius: carried + self.radius * other.radius + ROUNDING * high.abs() }
    }
}

impl Div for Ball {
    type Output = Ball;

    /// The quotient as a sum of two f64 numbers; the remainder of the dividend bounds its error. The radius is infinite
    /// where the divisor may be zero.
    #[inline]
    fn div(self, other: Ball) -> Ball {
        let first = self.high / other.high;
        let left = self - other * Ball::from(first);
        let second = left.high / other.high;
        let rest = left - other * Ball::from(second);
        let (high, low) = two_sum(first, second);
        let least = (other.high.abs() - other.error()).max(0.0);
        Ball { high, low, radius: (rest.high.abs() + rest.error()) / least }
    }
}

impl Number for Ball {
    fn same(self, number: f64) -> Ball {
        number.into()
    }

    fn plus_product(self, a: Ball, b: Ball) -> Ball {
        self + a * b
    }

    fn minus_product(self, a: Ball, b: Ball) -> Ball {
        self - a * b
    }

    /// The root s as a sum of two f64 numbers; the residual x − s² bounds its error: |√x − s| ≤ |x − s²| / s.
    fn sqrt(self) -> Ball {
        let first = self.high.sqrt();
        if first == 0.0 {
            return Ball { radius: self.error().sqrt(), ..Ball::default() };
        }
        let left = self - Ball::from(first) * Ball::from(first);
        let (high, low) = two_sum(first, left.high / (2.0 * first));
        let root = Ball { high, low, radius: 0.0 };
        let rest = self - root * root;
        Ball { radius: (rest.high.abs() + rest.error()) / first, ..root }
    }

    fn larger(self, other: Ball) -> Ball {
        if self.high > other.high { self } else { other }
    }
}

/// A vector of exact components.
impl From<Vector> for Pair<Ball> {
    #[inline]
    fn from(v: Vector) -> Self {
        Pair { x: v.x.into(), y: v.y.into() }
    }
}

impl Pair<Ball> {
    /// The vector from one exact place to another, without rounding error.
    #[inline]
    #[must_use]
    pub fn between(from: Point, to: Point) -> Self {
        Pair { x: Ball::difference(to.x, from.x), y: Ball::difference(to.y, from.y) }
    }

    /// Rounded to f64.
    #[must_use]
    pub fn rounded(self) -> Vector {
        Vector::new(self.x.high, self.y.high)
    }

    /// Bounds of the errors of the components of [`Self::rounded`].
    #[must_use]
    pub fn errors(self) -> Vector {
        Vector::new(self.x.error(), self.y.error())
    }
}

/// x + y as the rounded sum and its rounding error (Knuth's two-sum).
#[inline]
fn two_sum(x: f64, y: f64) -> (f64, f64) {
    let sum = x + y;
    let from_x = sum - y;
    let from_y = sum - from_x;
    (sum, (x - from_x) + (y - from_y))
}

/// As [`two_sum`], for |x| ≥ |y| (Dekker's fast two-sum).
#[inline]
fn ordered_sum(x: f64, y: f64) -> (f64, f64) {
    let sum = x + y;
    (sum, y - (sum - x))
}

/// x y as the rounded product and its rounding error (Dekker's product, with Veltkamp's split into halves of 26 bits).
/// `mul_add` would call a library function where the processor is not known to have the instruction.
#[inline]
fn two_product(x: f64, y: f64) -> (f64, f64) {
    let halves = |x: f64| {
        const SPLIT: f64 = 134_217_729.0; // 2^27 + 1
        let scaled = SPLIT * x;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let product = x * y;
    let ((a, b), (c, d)) = (halves(x), halves(y));
    (product, ((a * c - product) + a * d + b * c) + b * d)
}
