use super::{Floating, Number, Pair};
use fearless_simd::{Simd, SimdBase, SimdFloat, SimdMask};
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
    type Number: Floating;

    /// These lanes with one register at a time.
    type Narrow: Lanes;

    /// Positions in one [`Self::Number`].
    const COUNT: usize;

    /// Whether `a b + c` is an operation or two, and not some eighty.
    const HAS_PLUS_PRODUCT: bool;

    /// One register at a time: for steps with more numbers in use than two together leave room for.
    fn narrow(self) -> Self::Narrow;

    /// `number` in all lanes.
    fn splat(self, number: f64) -> Self::Number;

    /// The `k`th portion of a row, [`Self::COUNT`] numbers.
    fn load<R: Row>(self, row: &R, k: usize) -> Self::Number;

    /// Sets the `k`th portion of a row.
    fn store<R: Row>(self, row: &mut R, k: usize, numbers: Self::Number);

    /// Whether all lanes are from `from` to `to`; none is NaN then.
    fn all_within(self, numbers: Self::Number, from: f64, to: f64) -> bool;

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

    type Narrow = Self;

    const COUNT: usize = 1;

    const HAS_PLUS_PRODUCT: bool = true;

    #[inline(always)]
    fn narrow(self) -> Self {
        self
    }

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
    fn all_within(self, number: f64, from: f64, to: f64) -> bool {
        from <= number && number <= to
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

/// Registers that batches compute together.
pub const TOGETHER: usize = 2;

/// In SIMD registers of the instruction set `S`, `N` of them as one; a row fills a whole number of these portions.
///
/// Two together are quicker where few numbers are in use: while one waits for a result, the processor computes the
/// other, and finding the rows costs half as much per position.
#[derive(Clone, Copy, Debug)]
pub struct Registers<S, const N: usize>(pub S);

/// The numbers in `N` SIMD registers.
#[derive(Clone, Copy, Debug)]
pub struct Register<S: Simd, const N: usize> {
    simd: S,
    numbers: [S::f64s; N],
}

impl<S: Simd, const N: usize> Lanes for Registers<S, N> {
    type Number = Register<S, N>;

    type Narrow = Registers<S, 1>;

    const COUNT: usize = N * S::f64s::LEN;

    /// Registers of two numbers have such an operation only on some processors; wider ones always do.
    const HAS_PLUS_PRODUCT: bool = S::f64s::LEN > 2 || cfg!(target_arch = "aarch64");

    #[inline(always)]
    fn narrow(self) -> Registers<S, 1> {
        Registers(self.0)
    }

    #[inline(always)]
    fn splat(self, number: f64) -> Register<S, N> {
        Register { simd: self.0, numbers: [S::f64s::splat(self.0, number); N] }
    }

    #[inline(always)]
    fn load<R: Row>(self, row: &R, k: usize) -> Register<S, N> {
        let portion = &row.as_ref()[k * Self::COUNT..(k + 1) * Self::COUNT];
        let mut register = self.splat(0.0);
        for i in 0..N {
            register.numbers[i] = S::f64s::from_slice(self.0, &portion[i * S::f64s::LEN..(i + 1) * S::f64s::LEN]);
        }
        register
    }

    #[inline(always)]
    fn store<R: Row>(self, row: &mut R, k: usize, register: Register<S, N>) {
        let portion = &mut row.as_mut()[k * Self::COUNT..(k + 1) * Self::COUNT];
        for i in 0..N {
            register.numbers[i].store_slice(&mut portion[i * S::f64s::LEN..(i + 1) * S::f64s::LEN]);
        }
    }

    #[inline(always)]
    fn all_within(self, register: Register<S, N>, from: f64, to: f64) -> bool {
        let (from, to) = (S::f64s::splat(self.0, from), S::f64s::splat(self.0, to));
        let mut within = true;
        for i in 0..N {
            let numbers = register.numbers[i];
            within &= (numbers.simd_ge(from) & numbers.simd_le(to)).all_true();
        }
        within
    }

    #[inline(always)]
    fn sum(self, register: Register<S, N>) -> f64 {
        let mut sum = register.numbers[0];
        for i in 1..N {
            sum += register.numbers[i];
        }
        sum.reduce_sum()
    }

    #[inline(always)]
    fn largest(self, register: Register<S, N>) -> f64 {
        let mut largest = register.numbers[0];
        for i in 1..N {
            largest = largest.max_precise(register.numbers[i]);
        }
        largest.reduce_max_precise()
    }
}

macro_rules! by_register {
    ($($operator:ident $method:ident),*) => {$(
        impl<S: Simd, const N: usize> $operator for Register<S, N> {
            type Output = Self;

            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for i in 0..N {
                    self.numbers[i] = self.numbers[i].$method(other.numbers[i]);
                }
                self
            }
        }
    )*};
}

by_register!(Add add, Sub sub, Mul mul, Div div);

impl<S: Simd, const N: usize> Neg for Register<S, N> {
    type Output = Self;

    #[inline(always)]
    fn neg(mut self) -> Self {
        for i in 0..N {
            self.numbers[i] = -self.numbers[i];
        }
        self
    }
}

/// `a b + c` without an operation for it: some eighty instructions. Not inlined, for a group's equations have hundreds of
/// these: functions of 300 kB took the compiler longer than a quarter of the library.
#[inline(never)]
fn step_by_step<S: Simd>(simd: S, a: S::f64s, b: S::f64s, c: S::f64s) -> S::f64s {
    simd.vectorize(
        #[inline(always)]
        || a.mul_add_precise(b, c),
    )
}

impl<S: Simd, const N: usize> Floating for Register<S, N> {
    #[inline(always)]
    fn same(self, number: f64) -> Self {
        Registers::<S, N>(self.simd).splat(number)
    }
}

impl<S: Simd, const N: usize> Number for Register<S, N> {
    #[inline(always)]
    fn eighths(self, count: i32) -> Self {
        self.same(0.125 * f64::from(count))
    }

    /// Rounded once, also where the processor has no such operation: the same bits on every machine.
    #[inline(always)]
    fn plus_product(mut self, a: Self, b: Self) -> Self {
        for i in 0..N {
            let (a, b, sum) = (a.numbers[i], b.numbers[i], self.numbers[i]);
            self.numbers[i] = if Registers::<S, N>::HAS_PLUS_PRODUCT {
                a.mul_add_precise(b, sum)
            } else {
                step_by_step(self.simd, a, b, sum)
            };
        }
        self
    }

    #[inline(always)]
    fn sqrt(mut self) -> Self {
        for i in 0..N {
            self.numbers[i] = self.numbers[i].sqrt();
        }
        self
    }

    #[inline(always)]
    fn larger(mut self, other: Self) -> Self {
        for i in 0..N {
            self.numbers[i] = self.numbers[i].max(other.numbers[i]);
        }
        self
    }
}
