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

/// Below this the rests of numbers lose digits.
const SMALLEST: f64 = 1e-270;

/// Powers of ten up to this one are exact in f64.
const EXACT: usize = 22;

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

    /// The number that a person wrote and that was read as `x`: `x` with the distance of the shortest decimal that
    /// reads as `x`.
    ///
    /// So it holds `x` itself and the decimal, as 0.1 and the f64 next to it. Whole numbers, halves, quarters and so on
    /// are exact. A number of 16 digits or more was computed: it may be off by a rounding.
    #[must_use]
    pub fn written(x: f64) -> Ball {
        let is_whole = x.trunc() == x && x.abs() < 1e15;
        if is_whole || !x.is_finite() {
            return x.into();
        }
        if x.abs() < SMALLEST {
            return Ball::from(x).widened(SMALLEST * UNIT_ROUNDOFF);
        }
        let text = format!("{:e}", x.abs());
        let off = (decimal(&text) - Ball::from(x.abs())).error_from(0.0);
        let is_computed = text.bytes().filter(u8::is_ascii_digit).count() > 16;
        Ball::from(x).widened(if is_computed { off.max(UNIT_ROUNDOFF * x.abs()) } else { off })
    }

    /// The shortest decimal that reads as `x`.
    #[must_use]
    pub fn decimal(x: f64) -> Ball {
        let size = decimal(&format!("{:e}", x.abs()));
        if x < 0.0 { -size } else { size }
    }

    /// Bound of the distance of the number from `value`.
    #[inline]
    #[must_use]
    pub fn error_from(self, value: f64) -> f64 {
        (self.high - value).abs() * (1.0 + f64::EPSILON) + self.error()
    }

    /// Whether the middle and the bound of the error are finite.
    #[must_use]
    pub fn is_known(self) -> bool {
        self.high.is_finite() && self.error().is_finite()
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

    /// Cosine and sine of an angle in degrees.
    ///
    /// Whole quarter turns are taken off in degrees, where that is exact; then Taylor's series, whose rest is below
    /// 1e-33.
    #[must_use]
    pub fn direction_of_degrees(degrees: Ball) -> Self {
        const TERMS: u32 = 14;
        let quarters = (degrees.high / 90.0).round();
        let x = (degrees - Ball::from(quarters) * Ball::from(90.0)) * RADIANS_PER_DEGREE;
        let off = x.radius;
        let x = Ball { radius: 0.0, ..x };
        let square = x * x;
        let one = Ball::from(1.0);
        // 1 − x²/(k (k+1)) (1 − x²/((k+2) (k+3)) (…)), from the last term on.
        let series = |first: u32| {
            (0..TERMS).rev().fold(one, |rest, term| {
                let k = f64::from(first + 2 * term);
                one - square * rest / Ball::from(k * (k + 1.0))
            })
        };
        // The first term that is left out, and the angle's own error.
        let (cosine, sine) = (series(1).widened(off + 1e-33), (x * series(2)).widened(off + 1e-33));
        Pair { x: cosine, y: sine }.turned_by_quarters(quarters.rem_euclid(4.0) as i64)
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

    /// Adds `error` to the radius of both components.
    #[must_use]
    pub fn widened(self, error: f64) -> Self {
        Pair { x: self.x.widened(error), y: self.y.widened(error) }
    }

    /// Bounds of the distances of the components from those of `v`.
    #[must_use]
    pub fn errors_from(self, v: Vector) -> [f64; 2] {
        [self.x.error_from(v.x), self.y.error_from(v.y)]
    }
}

/// A decimal as in `3.125e-2`, of at most 17 digits, from its text.
fn decimal(text: &str) -> Ball {
    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{decimals}").parse::<i64>().unwrap_or_default();
    let high = digits as f64;
    // At most 17 digits: the rest is far below 2^53.
    let number = Ball { high, low: (digits - high as i64) as f64, radius: 0.0 };
    let power = power.parse::<i32>().unwrap_or_default() - decimals.len() as i32;
    (0..power.unsigned_abs()).step_by(EXACT).fold(number, |number, done| {
        let step = (power.unsigned_abs() - done).min(EXACT as u32);
        let scale = Ball::from((0..step).fold(1.0, |scale, _| 10.0 * scale));
        if power < 0 { number / scale } else { number * scale }
    })
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
