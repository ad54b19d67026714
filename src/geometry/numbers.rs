// The same lane of several arrays is read and written: an index says it best.
#![allow(clippy::needless_range_loop)]

use super::Vector;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or several that go through the same calculation side by side.
pub trait Number:
    Copy
    + Debug
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Mul<f64, Output = Self>
    + Neg<Output = Self>
{
    /// How many numbers there are.
    const LANES: usize;

    /// The same number in all lanes.
    fn splat(number: f64) -> Self;

    /// A number for each lane.
    fn from_lanes(number: impl Fn(usize) -> f64) -> Self;

    /// The number of a lane.
    fn lane(&self, index: usize) -> f64;

    /// The square roots.
    fn sqrt(self) -> Self;

    /// The largest magnitude; not a number if one of them is not.
    fn largest(self) -> f64;

    /// The smallest of the numbers.
    fn smallest(self) -> f64;

    /// Cosine and sine of angles in degrees, exact at whole quarter turns.
    fn direction_of_degrees(self) -> Pair<Self>;
}

impl Number for f64 {
    const LANES: usize = 1;

    #[inline(always)]
    fn splat(number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn from_lanes(number: impl Fn(usize) -> f64) -> Self {
        number(0)
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn largest(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn smallest(self) -> f64 {
        self
    }

    #[inline(always)]
    fn direction_of_degrees(self) -> Pair<f64> {
        let [x, y] = direction_by_polynomials(self);
        Pair { x, y }
    }
}

/// Eight numbers, as wide as the widest registers of today's processors.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Eight(pub [f64; 8]);

macro_rules! lanewise {
    ($($operator:ident $method:ident $sign:tt),*) => {$(
        impl $operator for Eight {
            type Output = Eight;

            #[inline(always)]
            fn $method(self, other: Eight) -> Eight {
                let mut result = self;
                for i in 0..8 {
                    result.0[i] = self.0[i] $sign other.0[i];
                }
                result
            }
        }
    )*};
}

lanewise!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Mul<f64> for Eight {
    type Output = Eight;

    #[inline(always)]
    fn mul(self, other: f64) -> Eight {
        self * Eight([other; 8])
    }
}

impl Neg for Eight {
    type Output = Eight;

    #[inline(always)]
    fn neg(self) -> Eight {
        let mut result = self;
        for x in &mut result.0 {
            *x = -*x;
        }
        result
    }
}

impl Number for Eight {
    const LANES: usize = 8;

    #[inline(always)]
    fn splat(number: f64) -> Self {
        Eight([number; 8])
    }

    #[inline(always)]
    fn from_lanes(number: impl Fn(usize) -> f64) -> Self {
        Eight(std::array::from_fn(number))
    }

    #[inline(always)]
    fn lane(&self, index: usize) -> f64 {
        self.0[index]
    }

    #[inline(always)]
    fn sqrt(mut self) -> Eight {
        for x in &mut self.0 {
            *x = x.sqrt();
        }
        self
    }

    #[inline(always)]
    fn largest(self) -> f64 {
        // The sum is not a number if one of them is not.
        let mut largest = 0.0 * self.0.iter().sum::<f64>();
        for x in self.0 {
            let x = x.abs();
            largest = if x > largest { x } else { largest };
        }
        largest
    }

    #[inline(always)]
    fn smallest(self) -> f64 {
        let [first, rest @ ..] = self.0;
        rest.iter()
            .fold(first, |least, x| if *x < least { *x } else { least })
    }

    #[inline(always)]
    fn direction_of_degrees(self) -> Pair<Eight> {
        let (mut x, mut y) = (self, self);
        for i in 0..8 {
            [x.0[i], y.0[i]] = direction_by_polynomials(self.0[i]);
        }
        Pair { x, y }
    }
}

/// Cosine and sine of an angle in degrees without branches or tables.
///
/// Whole quarter turns are taken off in degrees, where that is exact; the rest is at most 45°, where the minimax polynomials of
/// fdlibm (Sun Microsystems, 1993) are right within one unit in the last place.
#[inline(always)]
// The coefficients stand as published.
#[allow(clippy::excessive_precision)]
fn direction_by_polynomials(degrees: f64) -> [f64; 2] {
    // Adding and subtracting this rounds to a whole number, up to 2^51.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let shifted = degrees * (1.0 / 90.0) + ROUND;
    let quarters = shifted - ROUND;
    let x = (degrees - 90.0 * quarters) * (std::f64::consts::PI / 180.0);
    let z = x * x;
    let sine_tail = 8.333_333_333_322_489_461_24e-3
        + z * (-1.984_126_982_985_794_931_34e-4
            + z * (2.755_731_370_707_006_767_89e-6
                + z * (-2.505_076_025_340_686_341_95e-8 + z * 1.589_690_995_211_550_102_21e-10)));
    let sine = x + z * x * (-1.666_666_666_666_663_243_48e-1 + z * sine_tail);
    let cosine_tail = z
        * (4.166_666_666_666_660_190_37e-2
            + z * (-1.388_888_888_887_410_957_49e-3
                + z * (2.480_158_728_947_672_941_78e-5
                    + z * (-2.755_731_435_139_066_330_35e-7
                        + z * (2.087_572_321_298_174_827_90e-9
                            - z * 1.135_964_755_778_819_482_65e-11)))));
    let half = 0.5 * z;
    let whole = 1.0 - half;
    let cosine = whole + ((1.0 - whole - half) + z * cosine_tail);
    // The quarter turns' last two bits stand in the last two bits of the shifted number.
    let bits = shifted.to_bits();
    let odd = bits & 1 == 1;
    let (c, s) = if odd { (sine, cosine) } else { (cosine, sine) };
    let flip_cosine = ((bits ^ (bits >> 1)) & 1) << 63;
    let flip_sine = ((bits >> 1) & 1) << 63;
    [
        f64::from_bits(c.to_bits() ^ flip_cosine),
        f64::from_bits(s.to_bits() ^ flip_sine),
    ]
}

/// A vector of such numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<T> {
    /// Along x.
    pub x: T,
    /// Along y.
    pub y: T,
}

impl<T: Number> Pair<T> {
    /// The same vector in all lanes.
    #[inline(always)]
    #[must_use]
    pub fn splat(vector: Vector) -> Self {
        Pair {
            x: T::splat(vector.x),
            y: T::splat(vector.y),
        }
    }

    /// The vector of a lane.
    #[inline(always)]
    #[must_use]
    pub fn lane(&self, index: usize) -> Vector {
        Vector::new(self.x.lane(index), self.y.lane(index))
    }

    /// Turned by +90°.
    #[inline(always)]
    #[must_use]
    pub fn quarter_turn(self) -> Self {
        Pair {
            x: -self.y,
            y: self.x,
        }
    }

    /// `local` turned by the angle of which this is cosine and sine.
    #[inline(always)]
    #[must_use]
    pub fn turn(self, local: Vector) -> Self {
        Pair {
            x: self.x * local.x - self.y * local.y,
            y: self.y * local.x + self.x * local.y,
        }
    }

    /// The scalar cross product.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> T {
        self.x * other.y - self.y * other.x
    }

    /// The scalar product.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y
    }
}

impl From<Vector> for Pair<f64> {
    fn from(v: Vector) -> Self {
        Pair { x: v.x, y: v.y }
    }
}

impl<T: Number> Add for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Pair {
            x: self.x + other.x,
            y: self.y + other.y,
        }
    }
}

impl<T: Number> Sub for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Pair {
            x: self.x - other.x,
            y: self.y - other.y,
        }
    }
}

impl<T: Number> Mul<T> for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, scale: T) -> Self {
        Pair {
            x: self.x * scale,
            y: self.y * scale,
        }
    }
}

impl<T: Number> Neg for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Pair {
            x: -self.x,
            y: -self.y,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::direction_of_degrees;

    #[test]
    fn eight_directions_are_those_of_one() {
        let mut worst: f64 = 0.0;
        for k in -40_000..40_000 {
            let degrees = f64::from(k) * 0.037;
            let [c, s] = direction_by_polynomials(degrees);
            let d = direction_of_degrees(degrees);
            worst = worst.max((c - d.x).abs()).max((s - d.y).abs());
        }
        assert!(worst <= f64::EPSILON, "{worst}");
        for quarter in -9..9 {
            let degrees = 90.0 * f64::from(quarter);
            let d = direction_of_degrees(degrees);
            assert_eq!(
                direction_by_polynomials(degrees).map(|x| x + 0.0),
                [d.x + 0.0, d.y + 0.0]
            );
        }
    }

    #[test]
    fn a_number_that_is_none_is_the_largest() {
        let mut eight = [1.0; 8];
        eight[3] = -7.0;
        assert_eq!(Eight(eight).largest(), 7.0);
        eight[5] = f64::NAN;
        assert!(Eight(eight).largest().is_nan());
    }
}
