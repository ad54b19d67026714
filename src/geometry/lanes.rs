use super::{Number, Pair};
use pulp::Simd;
use std::fmt::Debug;
use std::ops::{Add, Div, Index, IndexMut, Mul, Neg, Sub};

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

    const COUNT: usize = S::F64_LANES;

    #[inline(always)]
    fn splat(self, number: f64) -> Register<S> {
        let numbers = self.0.splat_f64s(number);
        Register { simd: self.0, numbers }
    }

    #[inline(always)]
    fn load<R: Row>(self, row: &R, k: usize) -> Register<S> {
        let (portions, _) = S::as_simd_f64s(row.as_ref());
        Register { simd: self.0, numbers: portions[k] }
    }

    #[inline(always)]
    fn store<R: Row>(self, row: &mut R, k: usize, register: Register<S>) {
        let (portions, _) = S::as_mut_simd_f64s(row.as_mut());
        portions[k] = register.numbers;
    }

    #[inline(always)]
    fn sum(self, register: Register<S>) -> f64 {
        self.0.reduce_sum_f64s(register.numbers)
    }

    #[inline(always)]
    fn largest(self, register: Register<S>) -> f64 {
        self.0.reduce_max_f64s(register.numbers)
    }
}

macro_rules! by_register {
    ($($operator:ident $method:ident $instruction:ident),*) => {$(
        impl<S: Simd> $operator for Register<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let numbers = self.simd.$instruction(self.numbers, other.numbers);
                Register { numbers, ..self }
            }
        }
    )*};
}

by_register!(Add add add_f64s, Sub sub sub_f64s, Mul mul mul_f64s, Div div div_f64s);

impl<S: Simd> Neg for Register<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        let numbers = self.simd.neg_f64s(self.numbers);
        Register { numbers, ..self }
    }
}

impl<S: Simd> Number for Register<S> {
    #[inline(always)]
    fn same(self, number: f64) -> Self {
        Registers(self.simd).splat(number)
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        let numbers = self.simd.mul_add_e_f64s(a.numbers, b.numbers, self.numbers);
        Register { numbers, ..self }
    }

    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        let simd = self.simd;
        let numbers = simd.negate_mul_add_e_f64s(a.numbers, b.numbers, self.numbers);
        Register { numbers, ..self }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let numbers = self.simd.sqrt_f64s(self.numbers);
        Register { numbers, ..self }
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        let numbers = self.simd.max_f64s(self.numbers, other.numbers);
        Register { numbers, ..self }
    }
}
