//! f32 as a number of Kinegon's kernel.

use std::ops::{Add, Div, Mul, Neg, Sub};

use kinegon::geometry::{Number, Pair, direction_of_degrees};

/// A number of 24 bits.
#[derive(Clone, Copy, Debug)]
pub struct Single(pub f32);

macro_rules! operators {
    ($($operator:ident $method:ident $sign:tt),*) => {$(
        impl $operator for Single {
            type Output = Single;

            fn $method(self, other: Single) -> Single {
                Single(self.0 $sign other.0)
            }
        }
    )*};
}

operators!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Mul<f64> for Single {
    type Output = Single;

    fn mul(self, other: f64) -> Single {
        Single(self.0 * other as f32)
    }
}

impl Neg for Single {
    type Output = Single;

    fn neg(self) -> Single {
        Single(-self.0)
    }
}

impl Number for Single {
    const LANES: usize = 1;

    fn splat(number: f64) -> Self {
        Single(number as f32)
    }

    fn from_lanes(number: impl Fn(usize) -> f64) -> Self {
        Single(number(0) as f32)
    }

    fn lane(&self, _: usize) -> f64 {
        f64::from(self.0)
    }

    fn sqrt(self) -> Self {
        Single(self.0.sqrt())
    }

    fn largest(self) -> f64 {
        f64::from(self.0.abs())
    }

    fn smallest(self) -> f64 {
        f64::from(self.0)
    }

    fn direction_of_degrees(self) -> Pair<Self> {
        Pair::<Single> {
            x: Single::splat(direction_of_degrees(f64::from(self.0)).x),
            y: Single::splat(direction_of_degrees(f64::from(self.0)).y),
        }
    }
}
