use super::Vector;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or several on which the same operations are carried out side by side.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// So many eighths in every lane, as a value of the type of `self`; the value of `self` does not matter. Every kind of number has
    /// them exactly, with bounds or without.
    fn eighths(self, count: i32) -> Self;

    /// The number 1, as [`Self::eighths`].
    #[inline(always)]
    fn one(self) -> Self {
        self.eighths(8)
    }

    /// self + a b, rounded once where the processor has a fast instruction for that.
    fn plus_product(self, a: Self, b: Self) -> Self;

    /// self − a b, rounded as [`Self::plus_product`].
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self.plus_product(-a, b)
    }

    /// The square root.
    fn sqrt(self) -> Self;

    /// The larger of two; either of them where one is NaN.
    fn larger(self, other: Self) -> Self;
}

/// A number of f64, without bounds, or several of them.
pub trait Floating: Number {
    /// `number` in every lane, as a value of the type of `self`; the value of `self` does not matter.
    fn same(self, number: f64) -> Self;
}

impl Floating for f64 {
    #[inline(always)]
    fn same(self, number: f64) -> f64 {
        number
    }
}

impl Number for f64 {
    #[inline(always)]
    fn eighths(self, count: i32) -> f64 {
        0.125 * f64::from(count)
    }

    #[inline(always)]
    fn plus_product(self, a: f64, b: f64) -> f64 {
        self + a * b
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn larger(self, other: f64) -> f64 {
        if self > other { self } else { other }
    }
}

/// Largest distance from a whole quarter turn at which [`direction_near`] is accurate, in degrees.
pub const NEAR: f64 = 45.0;

/// The number of quarter turns nearest to an angle in degrees.
#[inline(always)]
#[must_use]
pub fn quarters_of(degrees: f64) -> f64 {
    // Adding and subtracting 1.5 · 2^52 rounds to a whole number, for arguments up to 2^51.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    degrees * (1.0 / 90.0) + ROUND - ROUND
}

/// Cosine and sine of `degrees`, which lie within [`NEAR`] of so many quarter turns; these are subtracted in degrees,
/// where that is exact.
///
/// The minimax polynomials of fdlibm (Sun Microsystems, 1993) are right within one unit in the last place up to
/// [`NEAR`] and quickly lose digits beyond. Exact at the quarter turns.
#[inline(always)]
#[expect(clippy::excessive_precision, reason = "the coefficients stand as published")]
#[must_use]
pub fn direction_near<T: Floating>(degrees: T, quarters: f64) -> Pair<T> {
    let number = |x: f64| degrees.same(x);
    let x = (degrees - number(90.0 * quarters)) * number(std::f64::consts::PI / 180.0);
    let z = x * x;
    let sine = number(1.589_690_995_211_550_102_21e-10);
    let sine = number(-2.505_076_025_340_686_341_95e-8).plus_product(z, sine);
    let sine = number(2.755_731_370_707_006_767_89e-6).plus_product(z, sine);
    let sine = number(-1.984_126_982_985_794_931_34e-4).plus_product(z, sine);
    let sine = number(8.333_333_333_322_489_461_24e-3).plus_product(z, sine);
    let sine = number(-1.666_666_666_666_663_243_48e-1).plus_product(z, sine);
    let sine = x.plus_product(z * x, sine);
    let tail = number(-1.135_964_755_778_819_482_65e-11);
    let tail = number(2.087_572_321_298_174_827_90e-9).plus_product(z, tail);
    let tail = number(-2.755_731_435_139_066_330_35e-7).plus_product(z, tail);
    let tail = number(2.480_158_728_947_672_941_78e-5).plus_product(z, tail);
    let tail = number(-1.388_888_888_887_410_957_49e-3).plus_product(z, tail);
    let tail = number(4.166_666_666_666_660_190_37e-2).plus_product(z, tail);
    let (one, half) = (number(1.0), z * number(0.5));
    let whole = one - half;
    let cosine = whole + ((one - whole) - half).plus_product(z * z, tail);
    Pair { x: cosine, y: sine }.turned_by_quarters(quarters as i64)
}

/// A vector with components of type `T`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair<T> {
    /// Along x.
    pub x: T,
    /// Along y.
    pub y: T,
}

impl<T: Neg<Output = T>> Pair<T> {
    /// Turned by +90°.
    #[inline(always)]
    #[must_use]
    pub fn quarter_turn(self) -> Self {
        Pair { x: -self.y, y: self.x }
    }

    /// Turned by so many quarter turns.
    #[inline(always)]
    pub(super) fn turned_by_quarters(self, quarters: i64) -> Self {
        // Whole turns are taken off as in two's complement.
        match quarters & 3 {
            0 => self,
            1 => self.quarter_turn(),
            2 => Pair { x: -self.x, y: -self.y },
            _ => Pair { x: self.y, y: -self.x },
        }
    }
}

impl<T: Number> Pair<T> {
    /// `local` turned by the angle whose cosine and sine are `self`.
    #[inline(always)]
    #[must_use]
    pub fn turn(self, local: Self) -> Self {
        Pair {
            x: (self.x * local.x).minus_product(self.y, local.y),
            y: (self.x * local.y).plus_product(self.y, local.x),
        }
    }

    /// The scalar cross product.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> T {
        (self.x * other.y).minus_product(self.y, other.x)
    }

    /// The scalar product.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        (self.x * other.x).plus_product(self.y, other.y)
    }

    /// self + v s.
    #[inline(always)]
    #[must_use]
    pub fn plus_scaled(self, v: Self, s: T) -> Self {
        Pair { x: self.x.plus_product(v.x, s), y: self.y.plus_product(v.y, s) }
    }

    /// self − v s.
    #[inline(always)]
    #[must_use]
    pub fn minus_scaled(self, v: Self, s: T) -> Self {
        Pair { x: self.x.minus_product(v.x, s), y: self.y.minus_product(v.y, s) }
    }

    /// self + J v s, J the turn by +90°.
    #[inline(always)]
    #[must_use]
    pub fn plus_turned(self, v: Self, s: T) -> Self {
        Pair { x: self.x.minus_product(v.y, s), y: self.y.plus_product(v.x, s) }
    }

    /// self − J v s, J the turn by +90°.
    #[inline(always)]
    #[must_use]
    pub fn minus_turned(self, v: Self, s: T) -> Self {
        Pair { x: self.x.plus_product(v.y, s), y: self.y.minus_product(v.x, s) }
    }
}

impl From<Vector> for Pair<f64> {
    fn from(v: Vector) -> Self {
        Pair { x: v.x, y: v.y }
    }
}

impl<T: Add<Output = T>> Add for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Pair { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<T: Sub<Output = T>> Sub for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Pair { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<T: Neg<Output = T>> Neg for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Pair { x: -self.x, y: -self.y }
    }
}

impl<T: Copy + Mul<Output = T>> Mul<T> for Pair<T> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, scale: T) -> Self {
        Pair { x: self.x * scale, y: self.y * scale }
    }
}
