use super::{Equations, Number, Solvable};
use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// So many numbers side by side.
pub const SEVERAL: usize = 8;

/// One quantity at several positions, to the same bits as at each by itself: what is looked up for a mechanism is so looked up once for all of
/// them, and the compiler computes two numbers or more at a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Several(pub [f64; SEVERAL]);

impl Several {
    /// What a function gives for each.
    #[inline]
    #[must_use]
    pub fn map(self, each: impl Fn(f64) -> f64) -> Several {
        Several(self.0.map(each))
    }
}

impl From<f64> for Several {
    #[inline]
    fn from(number: f64) -> Several {
        Several([number; SEVERAL])
    }
}

impl From<i32> for Several {
    #[inline]
    fn from(number: i32) -> Several {
        f64::from(number).into()
    }
}

macro_rules! by_lane {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Several {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                Several(from_fn(|lane| self.0[lane].$method(other.0[lane])))
            }
        }
    )*};
}

by_lane!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Several {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl Number for Several {
    #[inline]
    fn eighths(self, count: i32) -> Self {
        (0.125 * f64::from(count)).into()
    }

    #[inline]
    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline]
    fn larger(self, other: Self) -> Self {
        Several(from_fn(|lane| self.0[lane].larger(other.0[lane])))
    }
}

impl Solvable for Several {
    fn solved(equations: &Equations<Several>) -> Option<Vec<Several>> {
        let by_lane: Option<Vec<Vec<f64>>> =
            (0..SEVERAL).map(|lane| equations.each(|number| number.0[lane]).solved()).collect();
        let by_lane = by_lane?;
        Some((0..by_lane[0].len()).map(|unknown| Several(from_fn(|lane| by_lane[lane][unknown]))).collect())
    }
}
