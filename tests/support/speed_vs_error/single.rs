//! f32 as a number of Kinegon's kernel.

use kinegon::geometry::Number;
use std::ops::{Add, Div, Mul, Neg, Sub};

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

impl Neg for Single {
    type Output = Single;

    fn neg(self) -> Single {
        Single(-self.0)
    }
}

impl Number for Single {
    fn eighths(self, count: i32) -> Self {
        Single(0.125 * count as f32)
    }

    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }

    fn sqrt(self) -> Self {
        Single(self.0.sqrt())
    }

    fn larger(self, other: Self) -> Self {
        if self.0 > other.0 { self } else { other }
    }
}
