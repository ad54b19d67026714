use super::{Number, Pair};
use fearless_simd::{Simd, SimdBase, SimdFloat};
use std::fmt::Debug;
use std::ops::{Add, Div, Index, IndexMut, Mul, Neg, Range, Sub};

/// Positions computed side by side: enough that the choice of each operation costs little per position, few enough that
/// all numbers stay in the first-level cache.
pub const MANY: usize = 32;

/// One quantity at several positions.
pub trait Row:
    Copy + Debug + Send + Sync + AsRef<[f64]> + AsMut<[f64]> + Index<usize, Output = f64> + IndexMut<usize>
{
    /// Number of positions.
    const LEN: usize;

    /// A row with `number` at all positions.
    fn splat(number: f64) -> Self;
}

/// One position.
impl Row for [f64; 1] {
    const LEN: usize = 1;

    #[inline(always)]
    fn splat(number: f64) -> Self {
        [number]
    }
}

/// [`MANY`] positions, aligned for the widest registers of today's processors.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Many(pub [f64; MANY]);

impl Row for Many {
    const LEN: usize = MANY;

    #[inline(always)]
    fn splat(number: f64) -> Self {
        Many([number; MANY])
    }
}

impl AsRef<[f64]> for Many {
    #[inline(always)]
    fn as_ref(&self) -> &[f64] {
        &self.0
    }
}

impl AsMut<[f64]> for Many {
    #[inline(always)]
    fn as_mut(&mut self) -> &mut [f64] {
        &mut self.0
    }
}

impl Index<usize> for Many {
    type Output = f64;

    #[inline(always)]
    fn index(&self, position: usize) -> &f64 {
        &self.0[position]
    }
}

impl IndexMut<usize> for Many {
    #[inline(always)]
    fn index_mut(&mut self, position: usize) -> &mut f64 {
        &mut self.0[position]
    }
}

/// How rows are processed: number by number, or in SIMD registers.
pub trait Lanes: Copy {
    /// What one operation works on: a number, or a register of several.
    type Number: Number;

    /// Positions in one [`Self::Number`].
    const COUNT: usize;

    /// `number` in all lanes.
    fn splat(self, number: f64) -> Self::Number;

    /// The `k`th portion of a row, [`Self::COUNT`] numbers.
    fn load<R: Row>(self, row: &R, k: usize) -> Self::Number;

    /// Sets the `k`th portion of a row.
    fn store<R: Row>(self, row: &mut R, k: usize, numbers: Self::Number);

    /// The sum over all lanes; NaN if one of them is NaN.
    fn sum(self, numbers: Self::Number) -> f64;

    /// The largest of all lanes that are not NaN.
    fn largest(self, numbers: Self::Number) -> f64;

    /// The `k`th portion of a row of vectors, given as rows of x and of y.
    #[inline(always)]
    fn pair<R: Row>(self, rows: &[R; 2], k: usize) -> Pair<Self::Number> {
        Pair { x: self.load(&rows[0], k), y: self.load(&rows[1], k) }
    }

    /// Sets the `k`th portion of a row of vectors.
    #[inline(always)]
    fn store_pair<R: Row>(self, rows: &mut [R; 2], k: usize, pair: Pair<Self::Number>) {
        self.store(&mut rows[0], k, pair.x);
        self.store(&mut rows[1], k, pair.y);
    }
}

/// Indices of the portions of a row that `lanes` computes together.
#[inline(always)]
#[must_use]
pub fn portions<L: Lanes, R: Row>() -> Range<usize> {
    0..R::LEN / L::COUNT
}

/// Number by number, without SIMD.
#[derive(Clone, Copy, Debug)]
pub struct OneByOne;

impl Lanes for OneByOne {
    type Number = f64;

    const COUNT: usize = 1;

    #[inline(always)]
    fn splat(self, number: f64) -> f64 {
        number
    }

    #[inline(always)]
    fn load<R: Row>(self, row: &R, k: usize) -> f64 {
        row.as_ref()[k]
    }

    #[inline(always)]
    fn store<R: Row>(self, row: &mut R, k: usize, number: f64) {
        row.as_mut()[k] = number;
    }

    #[inline(always)]
    fn sum(self, number: f64) -> f64 {
        number
    }

    #[inline(always)]
    fn largest(self, number: f64) -> f64 {
        number
    }
}

/// In SIMD registers of the instruction set `S`; a row fills a whole number of them.
#[derive(Clone, Copy, Debug)]
pub struct Registers<S>(pub S);

/// The numbers in one SIMD register.
#[derive(Clone, Copy, Debug)]
pub struct Register<S: Simd> {
    simd: S,
    numbers: S::f64s,
}

impl<S: Simd> Lanes for Registers<S> {
    type Number = Register<S>;

    const COUNT: usize = S::f64s::LEN;

    #[inline(always)]
    fn splat(self, number: f64) -> Register<S> {
        Register { simd: self.0, numbers: S::f64s::splat(self.0, number) }
    }

    #[inline(always)]
    fn load<R: Row>(self, row: &R, k: usize) -> Register<S> {
        let portion = &row.as_ref()[k * Self::COUNT..(k + 1) * Self::COUNT];
        Register { simd: self.0, numbers: S::f64s::from_slice(self.0, portion) }
    }

    #[inline(always)]
    fn store<R: Row>(self, row: &mut R, k: usize, register: Register<S>) {
        register.numbers.store_slice(&mut row.as_mut()[k * Self::COUNT..(k + 1) * Self::COUNT]);
    }

    #[inline(always)]
    fn sum(self, register: Register<S>) -> f64 {
        register.numbers.reduce_sum()
    }

    #[inline(always)]
    fn largest(self, register: Register<S>) -> f64 {
        register.numbers.reduce_max_precise()
    }
}

macro_rules! by_register {
    ($($operator:ident $method:ident),*) => {$(
        impl<S: Simd> $operator for Register<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Register { numbers: self.numbers.$method(other.numbers), ..self }
            }
        }
    )*};
}

by_register!(Add add, Sub sub, Mul mul, Div div);

impl<S: Simd> Neg for Register<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Register { numbers: -self.numbers, ..self }
    }
}

impl<S: Simd> Number for Register<S> {
    #[inline(always)]
    fn same(self, number: f64) -> Self {
        Registers(self.simd).splat(number)
    }

    /// Rounded once, also where the processor has no such operation: the same bits on every machine.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        Register { numbers: a.numbers.mul_add_precise(b.numbers, self.numbers), ..self }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Register { numbers: self.numbers.sqrt(), ..self }
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Register { numbers: self.numbers.max(other.numbers), ..self }
    }
}
