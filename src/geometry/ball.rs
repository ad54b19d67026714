use super::{Number, Pair, Point, UNIT_ROUNDOFF, Vector};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Relative rounding error allowed for the middle of a sum or product: 16 u², at least twice the proven bounds 3 u² and
/// 7 u².
const ROUNDING: f64 = f64::EPSILON * f64::EPSILON * 4.0;

/// π/180 as a sum of two f64, and the bound of the rest.
const RADIANS_PER_DEGREE: Ball =
    Ball { high: 0.017_453_292_519_943_295, low: 2.948_652_270_870_168_7e-19, radius: 2e-35 };

/// π/30 likewise: radians per second in a turn per minute.
pub const RADIANS_PER_SECOND: Ball =
    Ball { high: 0.104_719_755_119_659_78, low: -5.169_702_541_385_127_5e-18, radius: 3e-34 };

/// 2π likewise: radians in a turn.
pub const RADIANS_PER_TURN: Ball =
    Ball { high: std::f64::consts::TAU, low: 2.449_293_598_294_706_4e-16, radius: 6e-33 };

/// 180/π likewise: degrees in a radian.
pub const DEGREES_PER_RADIAN: Ball =
    Ball { high: 57.295_779_513_082_32, low: -1.987_849_567_057_628_3e-15, radius: 2e-31 };

/// By this a radius that was summed by rounding to nearest is made larger: see [`Ball`].
const UPWARD: f64 = 1.0 + 16.0 * UNIT_ROUNDOFF;

/// Products below this may have rests below the range of f64; above it the slack of [`ROUNDING`], 9 u² of them, is more
/// than all that their rests and radii can have lost there.
const SMALL: f64 = 1e-270;

/// More than what twenty operations lose below the range of f64.
const LEAST: f64 = f64::MIN_POSITIVE;

/// Angles up to this size are reduced by multiples of 90° without rounding.
const REDUCIBLE: f64 = 1e15;

/// A number with twice the digits of f64 and a bound of its error: the true number lies within `radius` of `high +
/// low`.
///
/// # Why the true number is always within
///
/// Sums and products are those of double-double arithmetic, which err by at most 3 u² and 7 u² of the result (Joldes,
/// Muller, Popescu, *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*, ACM TOMS 44
/// (2017), algorithms 6 and 10, made of Knuth's two-sum and Dekker's product); radii are propagated as in ball
/// arithmetic (Johansson, *Arb*, IEEE Trans. Computers 66 (2017)). A radius is a sum of at most eight products of
/// numbers that are not negative. Each rounding to nearest takes at most the part u of it, so at most (1 − u)¹² of it are
/// left, and |low| ≤ u |high| takes one more u: multiplied by 1 + 16 u it is again at least what it stands for. That
/// holds for normal numbers; smaller products get the least normal number on top. Each operation rounds the same on every platform. A
/// factor of 2^996 or more makes a product NaN, which counts as no bound.
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

    /// The product of two exact numbers, without rounding error while it is within the range of f64.
    #[inline]
    #[must_use]
    pub fn product(x: f64, y: f64) -> Ball {
        let (high, low) = two_product(x, y);
        let is_small = high.abs() < SMALL && x != 0.0 && y != 0.0;
        Ball { high, low, radius: if is_small { LEAST } else { 0.0 } }
    }

    /// A number of which `value` is known, and that it is off by no more than `error`. Only a number that is what its f64 is has no error: one
    /// that is chosen, as a place about which others are expanded, or one that counts as given for itself, as those of a pose.
    #[inline]
    #[must_use]
    pub fn within(value: f64, error: f64) -> Ball {
        Ball { high: value, low: 0.0, radius: error.abs() }
    }

    /// The number, or its negative where `sign` is negative.
    #[inline]
    #[must_use]
    pub fn signed(self, sign: f64) -> Ball {
        if sign < 0.0 { -self } else { self }
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
        Ball { radius: upward(self.radius + error.abs()), ..self }
    }

    /// Bound of the absolute error of `high` taken without `low`.
    #[inline]
    #[must_use]
    pub fn error(self) -> f64 {
        upward(self.low.abs() + self.radius)
    }

    /// The middle alone, taken as exact.
    #[inline]
    #[must_use]
    pub fn middle(self) -> Ball {
        Ball { radius: 0.0, ..self }
    }

    /// The largest size that the number may have.
    #[inline]
    #[must_use]
    pub fn largest(self) -> f64 {
        upward(self.high.abs() + self.error())
    }

    /// The smallest size that the number may have; zero where its sign is not certain.
    #[inline]
    #[must_use]
    pub fn smallest(self) -> f64 {
        ((self.high.abs() - self.error()) * (1.0 - 4.0 * UNIT_ROUNDOFF)).max(0.0)
    }

    /// A ball that holds this one and another.
    #[must_use]
    pub fn joined(self, other: Ball) -> Ball {
        let apart = (other - self).largest();
        Ball { radius: upward(self.radius.max(other.radius) + apart), ..self }
    }

    /// The quotient by an exact number: rests of the quotient are divided once more, with an error of at most 3 u²
    /// (Joldes and others, algorithm 15).
    #[inline]
    #[must_use]
    fn over(self, divisor: f64) -> Ball {
        let first = self.high / divisor;
        let (product, rest) = two_product(first, divisor);
        let left = ((self.high - product) - rest) + self.low;
        let (high, low) = ordered_sum(first, left / divisor);
        let radius = upward(self.radius / divisor.abs() + ROUNDING * high.abs());
        let is_small = high.abs() < SMALL && self != Ball::default();
        Ball { high, low, radius: if is_small { radius + LEAST } else { radius } }
    }

    /// Bound of the distance of the number from `value`.
    #[inline]
    #[must_use]
    pub fn error_from(self, value: f64) -> f64 {
        upward((self.high - value).abs() + self.error())
    }

    /// Whether the middle and the bound of the error are finite.
    #[must_use]
    pub fn is_known(self) -> bool {
        self.high.is_finite() && self.error().is_finite()
    }
}

/// A whole number, which f64 has exactly. There is no such conversion of other numbers of f64, whose error has to be stated:
/// [`Ball::within`].
impl From<i32> for Ball {
    #[inline]
    fn from(number: i32) -> Ball {
        exact(f64::from(number))
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
        Ball { high, low, radius: upward(self.radius + other.radius + ROUNDING * high.abs()) }
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
        let radius = upward(carried + self.radius * other.radius + ROUNDING * high.abs());
        if product.abs() < SMALL && self != Ball::default() && other != Ball::default() {
            return Ball { high, low, radius: radius + LEAST };
        }
        Ball { high, low, radius }
    }
}

impl Div for Ball {
    type Output = Ball;

    /// The quotient as a sum of two f64 numbers; the remainder of the dividend bounds its error. The radius is infinite
    /// where the divisor may be zero.
    #[inline]
    fn div(self, other: Ball) -> Ball {
        let first = self.high / other.high;
        let left = self - other * exact(first);
        let second = left.high / other.high;
        let rest = left - other * exact(second);
        let (high, low) = two_sum(first, second);
        let off = rest.largest();
        let radius = if off == 0.0 { 0.0 } else { upward(off / other.smallest()) + LEAST };
        Ball { high, low, radius }
    }
}

impl Number for Ball {
    fn eighths(self, count: i32) -> Ball {
        exact(0.125 * f64::from(count))
    }

    fn plus_product(self, a: Ball, b: Ball) -> Ball {
        self + a * b
    }

    /// The root s as a sum of two f64 numbers; the residual x − s² bounds its error: |√x − s| ≤ |x − s²| / s. Zero, with
    /// the root of all that the number may be, where that may be zero; no bound for a negative number.
    fn sqrt(self) -> Ball {
        if self.high.abs() <= self.error() {
            return Ball { radius: upward(self.largest().sqrt()), ..Ball::default() };
        }
        let first = self.high.sqrt();
        let left = self - exact(first) * exact(first);
        let (high, low) = two_sum(first, left.high / (2.0 * first));
        let root = Ball { high, low, radius: 0.0 };
        let rest = self - root * root;
        Ball { radius: upward(rest.largest() / first) + LEAST, ..root }
    }

    fn larger(self, other: Ball) -> Ball {
        if self.high > other.high { self } else { other }
    }
}

impl Pair<Ball> {
    /// A vector of which `v` is known, and that neither component is off by more than `error`: see [`Ball::within`].
    #[inline]
    #[must_use]
    pub fn within(v: Vector, error: f64) -> Self {
        Pair { x: Ball::within(v.x, error), y: Ball::within(v.y, error) }
    }

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

    /// Cosine and sine of an angle in degrees.
    ///
    /// Whole quarter turns are taken off in degrees, where that is exact; then Taylor's series, whose rest is below
    /// 1e-33.
    #[must_use]
    pub fn direction_of_degrees(degrees: Ball) -> Self {
        const TERMS: u32 = 14;
        let mut degrees = degrees;
        if degrees.high.abs() > REDUCIBLE {
            // Remainders are exact.
            let whole = Ball::difference(degrees.high % 360.0, -(degrees.low % 360.0));
            degrees = whole.widened(degrees.radius);
        }
        let quarters = (degrees.high / 90.0).round();
        let x = (degrees - exact(quarters * 90.0)) * RADIANS_PER_DEGREE;
        let turns = quarters.rem_euclid(4.0) as i64;
        if x == Ball::default() {
            return Pair { x: Ball::from(1), y: Ball::default() }.turned_by_quarters(turns);
        }
        let off = x.radius;
        let x = x.middle();
        let square = x * x;
        let one = Ball::from(1);
        // 1 − x²/(k (k+1)) (1 − x²/((k+2) (k+3)) (…)), from the last term on.
        let series = |first: u32| {
            (0..TERMS).rev().fold(one, |rest, term| {
                let k = f64::from(first + 2 * term);
                one - (square * rest).over(k * (k + 1.0))
            })
        };
        // The first term that is left out, and the angle's own error.
        let (cosine, sine) = (series(1).widened(off + 1e-33), (x * series(2)).widened(off + 1e-33));
        Pair { x: cosine, y: sine }.turned_by_quarters(turns)
    }

    /// The unit vector in the same direction; with infinite bounds for a vector that may be zero.
    #[must_use]
    pub fn unit(self) -> Self {
        let length = self.dot(self).sqrt();
        Pair { x: self.x / length, y: self.y / length }
    }

    /// The turn the other way round, for cosine and sine of an angle.
    #[must_use]
    pub fn reversed(self) -> Self {
        Pair { x: self.x, y: -self.y }
    }

    /// The turn by so many times the angle, for cosine and sine of an angle. It is doubled again and again: to turn by the angle itself
    /// each time would multiply the error by √2 each time.
    #[must_use]
    pub fn times(self, times: u32) -> Self {
        let (mut whole, mut doubled, mut left) = (Pair { x: Ball::from(1), y: Ball::default() }, self, times);
        while left > 0 {
            if left % 2 == 1 {
                whole = whole.turn(doubled);
            }
            doubled = doubled.turn(doubled);
            left /= 2;
        }
        whole
    }

    /// Adds `error` to the radius of both components.
    #[must_use]
    pub fn widened(self, error: f64) -> Self {
        Pair { x: self.x.widened(error), y: self.y.widened(error) }
    }

    /// The middles alone, taken as exact.
    #[must_use]
    pub fn middle(self) -> Self {
        Pair { x: self.x.middle(), y: self.y.middle() }
    }

    /// Turned by an exact angle of at most 10⁻⁴ radians, given by its middle, by the first terms of cosine and sine: the
    /// next ones are below φ⁴/24 and φ⁵/120.
    #[must_use]
    pub fn turned_slightly(self, angle: f64) -> Self {
        let x = exact(angle);
        let square = x * x;
        let cosine = Ball::from(1) - square.over(2.0);
        let sine = x - (square * x).over(6.0);
        let off = angle * angle * angle * angle;
        Pair { x: cosine.widened(off), y: sine.widened(off) }.turn(self)
    }

    /// Bound of the angle in degrees between this direction and that at `degrees`; infinite from a quarter turn on.
    ///
    /// `degrees` may come from any arctangent: cosine and sine of it are found anew and held against the direction.
    /// The angle φ is at most tan φ.
    #[must_use]
    pub fn degrees_from(self, degrees: f64) -> f64 {
        let printed = Pair::direction_of_degrees(exact(degrees));
        let (across, along) = (printed.cross(self), printed.dot(self));
        let least = if along.high > 0.0 { along.smallest() } else { 0.0 };
        if across.largest() == 0.0 && least > 0.0 {
            return 0.0;
        }
        let radians = upward(across.largest() / least);
        upward(radians * 57.295_779_513_082_33)
    }

    /// Bounds of the distances of the components from those of `v`.
    #[must_use]
    pub fn errors_from(self, v: Vector) -> [f64; 2] {
        [self.x.error_from(v.x), self.y.error_from(v.y)]
    }
}

/// A number that is what its f64 is.
#[inline]
pub(super) fn exact(x: f64) -> Ball {
    Ball::within(x, 0.0)
}

/// A radius that was summed by rounding to nearest, made so much larger that it bounds what it stands for.
#[inline(always)]
fn upward(radius: f64) -> f64 {
    radius * UPWARD
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
