//! Numbers as a person writes them, and directions of angles, with twice the digits of f64 and bounds of their errors.

use super::{Ball, Number, Pair};

/// π/180 as a sum of two f64, and the bound of the rest.
const RADIANS_PER_DEGREE: Ball =
    Ball { high: 0.017_453_292_519_943_295, low: 2.948_652_270_870_168_7e-19, radius: 2e-35 };

/// π/30 in the same way: radians per second in a turn per minute.
pub const RADIANS_PER_SECOND: Ball =
    Ball { high: 0.104_719_755_119_659_78, low: -5.169_702_541_385_127_5e-18, radius: 3e-34 };

/// 2π in the same way.
pub const RADIANS_PER_TURN: Ball =
    Ball { high: 6.283_185_307_179_586, low: 2.449_293_598_294_706_4e-16, radius: 6e-33 };

impl Ball {
    /// The number that a person wrote and that was read as `x`: `x` with the distance of the shortest decimal that
    /// reads as `x`.
    ///
    /// So it holds `x` itself and the decimal, as 0.1 and the f64 next to it. Whole numbers, halves, quarters and so on
    /// are exact.
    #[must_use]
    pub fn written(x: f64) -> Ball {
        let is_whole = x.trunc() == x && x.abs() < 1e15;
        if is_whole || !x.is_finite() {
            return x.into();
        }
        let text = format!("{:e}", x.abs());
        let decimal = decimal(&text).unwrap_or(Ball { high: x.abs(), low: 0.0, radius: x.abs() * f64::EPSILON });
        Ball::from(x).widened((decimal - Ball::from(x.abs())).error_from(0.0))
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
fn decimal(text: &str) -> Option<Ball> {
    let (mantissa, power) = text.split_once('e')?;
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let digits: i64 = mantissa.replace('.', "").parse().ok()?;
    let high = digits as f64;
    // At most 17 digits: the rest is far below 2^53.
    let whole = Ball { high, low: (digits - high as i64) as f64, radius: 0.0 };
    let power = power.parse::<i32>().ok()? - i32::try_from(decimals).ok()?;
    let scale = power_of_ten(power.unsigned_abs());
    Some(if power < 0 { whole / scale } else { whole * scale })
}

/// 10^power; exact up to 10^22.
fn power_of_ten(power: u32) -> Ball {
    const EXACT: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22,
    ];
    let mut product = Ball::from(1.0);
    let mut left = power as usize;
    while left > 0 {
        let step = left.min(EXACT.len() - 1);
        product = product * Ball::from(EXACT[step]);
        left -= step;
    }
    product
}

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
