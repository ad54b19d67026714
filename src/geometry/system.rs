use super::UNIT_ROUNDOFF;
use nalgebra::{DMatrix, DVector, Dyn, LU};
use smallvec::SmallVec;
use std::sync::OnceLock;

/// One number for each unknown of a group; up to four are stored without allocation.
pub type Numbers = SmallVec<[f64; 4]>;

/// A bound for each element of a matrix, row by row.
pub type Elements = SmallVec<[f64; 16]>;

/// By this sums of numbers that are not negative are made larger than all their roundings to nearest make them smaller:
/// of thousands of terms.
const UPWARD: f64 = 1.0 + f64::EPSILON * 4096.0;

/// A square linear system, scaled and factored once, to be solved for several right sides.
///
/// Columns, then rows, are scaled to a largest element in [1, 2) by powers of two (no rounding); nalgebra's LU factors
/// use partial pivoting. Units of length or time therefore change nothing but exponents.
/// Accuracy: backward stable in practice for these sizes; [`Self::verified`] bounds the error of each unknown.
#[derive(Clone, Debug)]
pub struct LinearSystem {
    /// The scaled matrix, row by row.
    scaled: Elements,
    factors: LU<f64, Dyn, Dyn>,
    column_scale: DVector<f64>,
    row_scale: DVector<f64>,
    /// Computed on first use.
    inverse: OnceLock<Inverse>,
}

/// The inverse of the scaled matrix, as it was computed.
#[derive(Clone, Debug)]
struct Inverse {
    /// Row by row.
    elements: Elements,
    /// The condition number of the scaled matrix.
    condition: f64,
}

impl LinearSystem {
    /// The factored system, or `None` where it is exactly singular or an element is not finite.
    ///
    /// A matrix that is only nearly singular is factored; ask [`Self::condition`].
    #[must_use]
    pub fn new(mut matrix: DMatrix<f64>) -> Option<Self> {
        let size = matrix.nrows();
        let mut column_scale = DVector::repeat(size, 1.0);
        for (mut column, scale) in matrix.column_iter_mut().zip(column_scale.iter_mut()) {
            *scale = power_of_two_below_inverse(column.amax())?;
            column *= *scale;
        }
        let mut row_scale = DVector::repeat(size, 1.0);
        for (mut row, scale) in matrix.row_iter_mut().zip(row_scale.iter_mut()) {
            *scale = power_of_two_below_inverse(row.amax())?;
            row *= *scale;
        }
        let scaled = rows_of(&matrix);
        let factors = matrix.lu();
        let pivots = factors.lu_internal().diagonal();
        let regular = pivots.iter().all(|p| p.is_finite() && *p != 0.0);
        regular.then_some(Self { scaled, factors, column_scale, row_scale, inverse: OnceLock::new() })
    }

    /// The solution for the right side `b`.
    #[must_use]
    pub fn solve(&self, b: &[f64]) -> Numbers {
        let mut x = DVector::from_column_slice(b).component_mul(&self.row_scale);
        // No pivot is zero, so there is a solution; one that leaves the range of f64 shows in its elements.
        self.factors.solve_mut(&mut x);
        x.component_mul(&self.column_scale).iter().copied().collect()
    }

    /// The largest magnitude among the unknowns `x`, each in the unit of its column of the scaled matrix.
    #[must_use]
    pub fn size(&self, x: impl IntoIterator<Item = f64>) -> f64 {
        let scaled = x.into_iter().zip(&self.column_scale);
        scaled.fold(0.0, |largest, (x, scale)| largest.max((x / scale).abs()))
    }

    /// The determinant of the matrix.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        let scales = self.column_scale.iter().chain(self.row_scale.iter());
        scales.fold(self.factors.determinant(), |d, scale| d / scale)
    }

    fn size_of(&self) -> usize {
        self.column_scale.len()
    }

    fn inverse(&self) -> &Inverse {
        self.inverse.get_or_init(|| {
            let size = self.size_of();
            let mut matrix = DMatrix::identity(size, size);
            self.factors.solve_mut(&mut matrix);
            let elements = rows_of(&matrix);
            let norm = |elements: &[f64]| {
                let rows = elements.chunks(size.max(1));
                rows.map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
            };
            Inverse { condition: (norm(&self.scaled) * norm(&elements)).max(1.0), elements }
        })
    }

    /// The condition number of the scaled matrix in the largest-row-sum norm, at least 1.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.inverse().condition
    }

    /// |R| `sizes`, R the computed inverse: how far a correction for right sides of these sizes goes, rounded up.
    #[must_use]
    pub fn reach(&self, sizes: &[f64]) -> Numbers {
        let scaled: Numbers = sizes.iter().zip(&self.row_scale).map(|(size, scale)| size * scale).collect();
        self.reached(&scaled).iter().zip(&self.column_scale).map(|(x, scale)| x * scale).collect()
    }

    fn reached(&self, scaled: &[f64]) -> Numbers {
        let rows = self.inverse().elements.chunks(scaled.len().max(1));
        rows.map(|row| upward(row.iter().zip(scaled).map(|(element, size)| element.abs() * size).sum())).collect()
    }

    /// What the computed inverse proves of all matrices whose elements are at most `off` from those of this one.
    #[must_use]
    pub fn verified(&self, off: &[f64]) -> Verified<'_> {
        let size = self.size_of();
        let inverse = &self.inverse().elements;
        let mut scaled_off = Elements::from_slice(off);
        for (row, scale) in scaled_off.chunks_mut(size.max(1)).zip(&self.row_scale) {
            row.iter_mut().zip(&self.column_scale).for_each(|(off, by)| *off *= scale * by);
        }
        let rounding = (size + 2) as f64 * UNIT_ROUNDOFF;
        let mut defects = Elements::from_elem(0.0, size * size);
        let mut left = Numbers::from_elem(0.0, size);
        let mut norm: f64 = 0.0;
        for (index, (row, defects)) in inverse.chunks(size.max(1)).zip(defects.chunks_mut(size.max(1))).enumerate() {
            left.fill(0.0);
            left[index] = 1.0;
            defects[index] = rounding;
            let others = self.scaled.chunks(size).zip(scaled_off.chunks(size));
            for (&element, (scaled, off)) in row.iter().zip(others) {
                for (((left, defect), &a), &off) in left.iter_mut().zip(defects.iter_mut()).zip(scaled).zip(off) {
                    let product = element * a;
                    *left -= product;
                    *defect += product.abs() * rounding + element.abs() * off;
                }
            }
            defects.iter_mut().zip(&left).for_each(|(defect, left)| *defect = upward(*defect + left.abs()));
            let sum = upward(defects.iter().sum());
            // `max` ignores NaN.
            norm = if sum.is_nan() { f64::INFINITY } else { norm.max(sum) };
        }
        Verified { system: self, off: scaled_off, defects, norm }
    }
}

/// The computed inverse R of a matrix A, with bounds of |I − R A| for all matrices A that are meant (Rump, *Verification
/// methods: rigorous results using floating-point arithmetic*, Acta Numerica 19 (2010), §10). All is scaled as in the
/// system.
///
/// If a norm of I − R A is below 1, none of them is singular, and A e = r gives e = R r + (I − R A) e, so that
/// |e| ≤ |R| |r| + |I − R A| |e|, element by element.
#[derive(Clone, Debug)]
pub struct Verified<'a> {
    system: &'a LinearSystem,
    /// How far elements of A may be from those of the system.
    off: Elements,
    /// Bounds of |I − R A|.
    defects: Elements,
    /// The largest sum of a row of these.
    norm: f64,
}

impl Verified<'_> {
    /// Whether Newton's method with R takes every point of the box `[−reach, reach]` to one inside of it, where the
    /// equations are off by at most `sizes` in its middle and have derivatives A: then they have one and only one
    /// solution in the box (Krawczyk 1969; Rump 2010, §13).
    #[must_use]
    pub fn maps_into_itself(&self, sizes: &[f64], reach: &[f64]) -> bool {
        let scaled = |x: &[f64], scale: &DVector<f64>| -> Numbers { x.iter().zip(scale).map(|(x, s)| x * s).collect() };
        let first = self.system.reached(&scaled(sizes, &self.system.row_scale));
        let reach: Numbers = reach.iter().zip(&self.system.column_scale).map(|(x, s)| x / s).collect();
        let rows = self.defects.chunks(reach.len().max(1));
        rows.zip(first).zip(&reach).all(|((row, first), &reach_here)| {
            let more: f64 = row.iter().zip(&reach).map(|(defect, reach)| defect * reach).sum();
            upward(first + more) < reach_here
        })
    }

    /// A bound on the error of each element of the solution `x` of the right side `b`, which may be off by `uncertain`,
    /// for all matrices that are meant; infinite where one of these may be singular.
    #[must_use]
    pub fn error_bound(&self, x: &[f64], b: &[f64], uncertain: &[f64]) -> Numbers {
        let LinearSystem { scaled, row_scale, column_scale, .. } = self.system;
        let size = self.system.size_of();
        if self.norm >= 1.0 {
            return Numbers::from_elem(f64::INFINITY, size);
        }
        let x: Numbers = x.iter().zip(column_scale).map(|(x, scale)| x / scale).collect();
        let rows = scaled.chunks(size.max(1)).zip(self.off.chunks(size.max(1)));
        let right = b.iter().zip(uncertain).zip(row_scale);
        let residuals: Numbers = (rows.zip(right))
            .map(|((row, off), ((b, uncertain), scale))| {
                let (mut residual, mut rounding, mut more) = (b * scale, 0.0, uncertain * scale);
                for ((a, off), x) in row.iter().zip(off).zip(&x) {
                    let product = a * x;
                    residual -= product;
                    more += off * x.abs();
                    if product != 0.0 {
                        rounding += product.abs() + residual.abs();
                    }
                }
                upward(more + residual.abs() + rounding * UNIT_ROUNDOFF)
            })
            .collect();
        let first = self.system.reached(&residuals);
        // No element is larger than the largest one over all, which the norm bounds.
        let most = upward(first.iter().copied().fold(0.0, f64::max) / ((1.0 - self.norm) * (1.0 - f64::EPSILON)));
        let rows = self.defects.chunks(size.max(1)).zip(&first).zip(column_scale);
        rows.map(|((row, first), scale)| upward(first + row.iter().sum::<f64>() * most) * scale).collect()
    }
}

/// The elements of a matrix, row by row.
fn rows_of(matrix: &DMatrix<f64>) -> Elements {
    let mut elements = Elements::with_capacity(matrix.len());
    for row in 0..matrix.nrows() {
        elements.extend((0..matrix.ncols()).map(|column| matrix[(row, column)]));
    }
    elements
}

/// A sum of numbers that are not negative, rounded to nearest, made so much larger that it bounds what it stands for,
/// also where that is below the range of f64.
fn upward(sum: f64) -> f64 {
    if sum == 0.0 { 0.0 } else { sum * UPWARD + f64::MIN_POSITIVE }
}

/// The power of two 2^−e for `largest` in [2^e, 2^(e+1)); `None` for zero, subnormal or not finite.
fn power_of_two_below_inverse(largest: f64) -> Option<f64> {
    let biased = largest.to_bits() >> 52;
    // Exponents 1 … 2045 have an inverse that is a normal number too.
    (1..=2045).contains(&biased).then(|| f64::from_bits((2046 - biased) << 52))
}
