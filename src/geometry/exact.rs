//! Numbers as a person writes them, and directions of angles, with twice the digits of f64 and bounds of their errors.

use super::{Ball, Number, Pair, UNIT_ROUNDOFF};

/// π/180 as a sum of two f64, and the bound of the rest.
const RADIANS_PER_DEGREE: Ball =
    Ball { high: 0.017_453_292_519_943_295, low: 2.948_652_270_870_168_7e-19, radius: 2e-35 };

/// π/30 in the same way: radians per second in a turn per minute.
pub const RADIANS_PER_SECOND: Ball =
    Ball { high: 0.104_719_755_119_659_78, low: -5.169_702_541_385_127_5e-18, radius: 3e-34 };

/// 2π in the same way.
pub const RADIANS_PER_TURN: Ball =
    Ball { high: std::f64::consts::TAU, low: 2.449_293_598_294_706_4e-16, radius: 6e-33 };

/// Below this the rests of numbers lose digits.
const SMALLEST: f64 = 1e-270;

impl Ball {
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

/// Powers of ten up to this one are exact in f64.
const EXACT: usize = 22;

impl Pair<Ball> {
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
        match quarters.rem_euclid(4.0) as u8 {
            0 => Pair { x: cosine, y: sine },
            1 => Pair { x: -sine, y: cosine },
            2 => Pair { x: -cosine, y: -sine },
            _ => Pair { x: sine, y: -cosine },
        }
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
    pub fn errors_from(self, v: super::Vector) -> [f64; 2] {
        [self.x.error_from(v.x), self.y.error_from(v.y)]
    }
}
