use super::UNIT_ROUNDOFF;
use nalgebra::{DMatrix, DVector, Dyn, LU};
use smallvec::SmallVec;
use std::sync::OnceLock;

/// One number for each unknown of a group; up to four are stored without allocation.
pub type Numbers = SmallVec<[f64; 4]>;

/// Relative error of the computed inverse, in unit roundoffs times the condition number.
const INVERSE_ROUNDINGS: f64 = 8.0;

/// A square linear system, scaled and factored once, to be solved for several right sides.
///
/// Columns, then rows, are scaled to a largest element in [1, 2) by powers of two (no rounding); nalgebra's LU factors
/// use partial pivoting. Units of length or time therefore change nothing but exponents.
/// Accuracy: backward stable in practice for these sizes; [`Self::error_bound`] bounds the error of each unknown
/// (Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §7.1, §9.3).
#[derive(Clone, Debug)]
pub struct LinearSystem {
    scaled: DMatrix<f64>,
    factors: LU<f64, Dyn, Dyn>,
    column_scale: DVector<f64>,
    row_scale: DVector<f64>,
    /// Computed on first use.
    inverse: OnceLock<Inverse>,
}

/// The inverse of the scaled matrix.
#[derive(Clone, Debug)]
struct Inverse {
    /// Magnitudes of its elements.
    magnitudes: DMatrix<f64>,
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
        let factors = matrix.clone().lu();
        let pivots = factors.lu_internal().diagonal();
        let regular = pivots.iter().all(|p| p.is_finite() && *p != 0.0);
        regular.then_some(Self { scaled: matrix, factors, column_scale, row_scale, inverse: OnceLock::new() })
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

    fn inverse(&self) -> &Inverse {
        self.inverse.get_or_init(|| {
            let size = self.scaled.nrows();
            let mut magnitudes = DMatrix::identity(size, size);
            self.factors.solve_mut(&mut magnitudes);
            magnitudes.apply(|x| *x = x.abs());
            let norm = |matrix: &DMatrix<f64>| {
                matrix.row_iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
            };
            Inverse { condition: (norm(&self.scaled) * norm(&magnitudes)).max(1.0), magnitudes }
        })
    }

    /// The condition number of the scaled matrix in the largest-row-sum norm, at least 1.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.inverse().condition
    }

    /// A bound on the error of each element of the solution `x` of the right side `b`, taking the matrix as exact.
    ///
    /// `uncertain` bounds, for each equation, the error already in `b` and the error of the matrix times `x`.
    /// The bound is |A⁻¹| (|b − A x| + `uncertain` + the rounding error of that residual, summed along with it).
    #[must_use]
    pub fn error_bound(&self, x: &[f64], b: &[f64], uncertain: &[f64]) -> Numbers {
        let x: Numbers = x.iter().zip(&self.column_scale).map(|(x, scale)| x / scale).collect();
        let residuals: Numbers = (0..b.len())
            .map(|row| {
                let (mut residual, mut rounding) = (b[row] * self.row_scale[row], 0.0);
                for (column, x) in x.iter().enumerate() {
                    let product = self.scaled[(row, column)] * x;
                    residual -= product;
                    if product != 0.0 {
                        rounding += product.abs() + residual.abs();
                    }
                }
                let inherited = uncertain[row] * self.row_scale[row];
                inherited + residual.abs() + rounding * UNIT_ROUNDOFF
            })
            .collect();
        let Inverse { magnitudes, condition } = self.inverse();
        // The inverse is known to about u·condition only.
        let inverse_error = 1.0 + INVERSE_ROUNDINGS * UNIT_ROUNDOFF * condition;
        let bound = |(row, scale): (usize, &f64)| {
            let products = residuals.iter().enumerate().map(|(column, residual)| magnitudes[(row, column)] * residual);
            products.sum::<f64>() * inverse_error * scale
        };
        self.column_scale.iter().enumerate().map(bound).collect()
    }
}

/// The power of two 2^−e for `largest` in [2^e, 2^(e+1)); `None` for zero, subnormal or not finite.
fn power_of_two_below_inverse(largest: f64) -> Option<f64> {
    let biased = largest.to_bits() >> 52;
    // Exponents 1 … 2045 have an inverse that is a normal number too.
    (1..=2045).contains(&biased).then(|| f64::from_bits((2046 - biased) << 52))
}
