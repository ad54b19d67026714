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
/// Columns, then rows, are scaled to a largest element in [1, 2) by powers of two (no rounding); both components of a vector
/// alike, so that what is singular is so in every frame. nalgebra's LU factors use partial pivoting. Units of length or time therefore change nothing but exponents.
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
    pub fn new(matrix: DMatrix<f64>) -> Option<Self> {
        LinearSystem::of_vectors(matrix, 0)
    }

    /// As [`Self::new`], where the first rows are the components x and y of so many vectors.
    #[must_use]
    pub fn of_vectors(mut matrix: DMatrix<f64>, vectors: usize) -> Option<Self> {
        let [column_scale, row_scale] = scale(&mut matrix, vectors)?;
        let scaled = rows_of(&matrix);
        let factors = factored(matrix)?;
        Some(Self { scaled, factors, column_scale, row_scale, inverse: OnceLock::new() })
    }

    /// The solution for one right side, of a system that is needed for no other and no bound.
    #[must_use]
    pub fn solved_once(mut matrix: DMatrix<f64>, vectors: usize, b: &[f64]) -> Option<Vec<f64>> {
        let [column_scale, row_scale] = scale(&mut matrix, vectors)?;
        let mut x = DVector::from_iterator(b.len(), b.iter().zip(&row_scale).map(|(b, scale)| b * scale));
        factored(matrix)?.solve_mut(&mut x);
        Some(x.iter().zip(&column_scale).map(|(x, scale)| x * scale).collect())
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

    pub(super) fn size_of(&self) -> usize {
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
        let inverse = &self.inverse().elements;
        let mut reached = Numbers::from_elem(0.0, scaled.len());
        for (index, reached) in reached.iter_mut().enumerate() {
            let row = &inverse[index * scaled.len()..];
            for (k, size) in scaled.iter().enumerate() {
                *reached += row[k].abs() * size;
            }
            *reached = upward(*reached);
        }
        reached
    }

    /// Proves that equations have one and only one solution in a box about a point where they leave `gaps`, and this matrix
    /// as their derivatives (Krawczyk 1969; Rump 2010, §13); `None` where that is not proved.
    ///
    /// The box goes twice as far as the first step of Newton's method, so that there is room for what the change of the
    /// derivatives leaves of it; and no less far than `least`. `off_within` bounds how far the derivatives anywhere in the
    /// box that it is given are from this matrix. The proof holds for all these.
    pub fn verified_near(
        &self,
        gaps: &[f64],
        least: &[f64],
        off_within: impl FnOnce(&[f64]) -> Elements,
    ) -> Option<Verified<'_>> {
        let first = self.reach(gaps);
        let reach: Numbers = first.iter().zip(least).map(|(first, least)| (2.0 * first).max(*least)).collect();
        let verified = self.verified(&off_within(&reach));
        verified.maps_into_itself(&first, &reach).then_some(verified)
    }

    /// What the computed inverse proves of all matrices whose elements are at most `off` from those of this one.
    #[must_use]
    pub fn verified(&self, off: &[f64]) -> Verified<'_> {
        let size = self.size_of();
        let inverse = &self.inverse().elements;
        let mut off = Elements::from_slice(off);
        for (index, off) in off.iter_mut().enumerate() {
            *off *= self.row_scale[index / size] * self.column_scale[index % size];
        }
        let rounding = (size + 2) as f64 * UNIT_ROUNDOFF;
        let mut defects = Elements::from_elem(0.0, size * size);
        let mut left = Numbers::from_elem(0.0, size);
        let mut norm: f64 = 0.0;
        for index in 0..size {
            let defects = &mut defects[index * size..][..size];
            left.fill(0.0);
            left[index] = 1.0;
            defects[index] = rounding;
            for k in 0..size {
                let element = inverse[index * size + k];
                let (scaled, off) = (&self.scaled[k * size..][..size], &off[k * size..][..size]);
                for (column, left) in left.iter_mut().enumerate() {
                    let product = element * scaled[column];
                    *left -= product;
                    defects[column] += product.abs() * rounding + element.abs() * off[column];
                }
            }
            let mut sum = 0.0;
            for (column, defect) in defects.iter_mut().enumerate() {
                *defect = upward(*defect + left[column].abs());
                sum += *defect;
            }
            // `max` ignores NaN.
            norm = if sum.is_nan() { f64::INFINITY } else { norm.max(upward(sum)) };
        }
        Verified { system: self, off, defects, norm }
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
    /// The system of which it holds.
    #[must_use]
    pub fn system(&self) -> &LinearSystem {
        self.system
    }

    /// Whether Newton's method with R takes every point of the box `[−reach, reach]` to one inside of it, where the first
    /// step from its middle goes no farther than `first`.
    fn maps_into_itself(&self, first: &[f64], reach: &[f64]) -> bool {
        let scale = &self.system.column_scale;
        reach.iter().enumerate().all(|(index, &reach_here)| {
            let row = &self.defects[index * reach.len()..];
            let more: f64 = reach.iter().enumerate().map(|(k, reach)| row[k] * (reach / scale[k])).sum();
            upward(first[index] / scale[index] + more) < reach_here / scale[index]
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
        let mut residuals = Numbers::from_elem(0.0, size);
        for (row, left) in residuals.iter_mut().enumerate() {
            let (scaled, off) = (&scaled[row * size..][..size], &self.off[row * size..][..size]);
            let (mut residual, mut rounding) = (b[row] * row_scale[row], 0.0);
            *left = uncertain[row] * row_scale[row];
            for (column, x) in x.iter().enumerate() {
                let product = scaled[column] * x;
                residual -= product;
                *left += off[column] * x.abs();
                if product != 0.0 {
                    rounding += product.abs() + residual.abs();
                }
            }
            *left = upward(*left + residual.abs() + rounding * UNIT_ROUNDOFF);
        }
        let mut bounds = self.system.reached(&residuals);
        // No element is larger than the largest one over all, which the norm bounds.
        let most = upward(bounds.iter().copied().fold(0.0, f64::max) / ((1.0 - self.norm) * (1.0 - f64::EPSILON)));
        for (index, bound) in bounds.iter_mut().enumerate() {
            let defects: f64 = self.defects[index * size..][..size].iter().sum();
            *bound = upward(*bound + defects * most) * column_scale[index];
        }
        bounds
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

/// Scales columns, then rows, as [`LinearSystem`] says; their scales. `None` where a column or a row is zero, or not finite.
fn scale(matrix: &mut DMatrix<f64>, vectors: usize) -> Option<[DVector<f64>; 2]> {
    let size = matrix.nrows();
    let mut column_scale = DVector::repeat(size, 1.0);
    for (mut column, scale) in matrix.column_iter_mut().zip(column_scale.iter_mut()) {
        *scale = power_of_two_below_inverse(column.amax())?;
        column *= *scale;
    }
    let mut row_scale = DVector::repeat(size, 1.0);
    let most: Numbers = matrix.row_iter().map(|row| row.amax()).collect();
    for (index, (mut row, scale)) in matrix.row_iter_mut().zip(row_scale.iter_mut()).enumerate() {
        let other = if index < 2 * vectors { index ^ 1 } else { index };
        *scale = power_of_two_below_inverse(most[index].max(most[other]))?;
        row *= *scale;
    }
    Some([column_scale, row_scale])
}

/// The factors of a matrix; `None` where it is exactly singular or an element is not finite.
fn factored(matrix: DMatrix<f64>) -> Option<LU<f64, Dyn, Dyn>> {
    let factors = matrix.lu();
    let pivots = factors.lu_internal().diagonal();
    pivots.iter().all(|p| p.is_finite() && *p != 0.0).then_some(factors)
}

/// The power of two 2^−e for `largest` in [2^e, 2^(e+1)); `None` for zero, subnormal or not finite.
fn power_of_two_below_inverse(largest: f64) -> Option<f64> {
    let biased = largest.to_bits() >> 52;
    // Exponents 1 … 2045 have an inverse that is a normal number too.
    (1..=2045).contains(&biased).then(|| f64::from_bits((2046 - biased) << 52))
}
