use super::UNIT_ROUNDOFF;

/// A square linear system, scaled and factored once, to be solved for several right sides.
///
/// Columns, then rows, are scaled to a largest element in [1, 2) by powers of two (no rounding), and
/// rows are pivoted. Units of length or time therefore change nothing but exponents.
/// Accuracy: backward stable in practice for these sizes; see [`Self::error_bound`] for the proof of
/// each single number (Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §7.1, §9.3).
#[derive(Clone, Debug)]
pub struct LinearSystem<const N: usize> {
    scaled: [[f64; N]; N],
    factors: [[f64; N]; N],
    order: [usize; N],
    column_scale: [f64; N],
    row_scale: [f64; N],
}

impl<const N: usize> LinearSystem<N> {
    /// The factored system, or `None` where a pivot is exactly zero or an element not finite.
    ///
    /// A matrix that is only nearly singular is factored; ask [`Self::condition`].
    #[must_use]
    pub fn new(mut matrix: [[f64; N]; N]) -> Option<Self> {
        let mut column_scale = [1.0; N];
        for (c, scale) in column_scale.iter_mut().enumerate() {
            let largest = (0..N).fold(0.0, |m: f64, r| m.max(matrix[r][c].abs()));
            *scale = power_of_two_below_inverse(largest)?;
            (0..N).for_each(|r| matrix[r][c] *= *scale);
        }
        let mut row_scale = [1.0; N];
        for (row, scale) in matrix.iter_mut().zip(&mut row_scale) {
            let largest = row.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            *scale = power_of_two_below_inverse(largest)?;
            row.iter_mut().for_each(|x| *x *= *scale);
        }
        let scaled = matrix;
        let mut order = [0; N];
        order.iter_mut().enumerate().for_each(|(i, o)| *o = i);
        for k in 0..N {
            let pivot = (k..N).fold(k, |best, r| {
                if matrix[r][k].abs() > matrix[best][k].abs() {
                    r
                } else {
                    best
                }
            });
            matrix.swap(k, pivot);
            order.swap(k, pivot);
            let pivot_row = matrix[k];
            if pivot_row[k] == 0.0 {
                return None;
            }
            for row in &mut matrix[k + 1..] {
                row[k] /= pivot_row[k];
                for c in k + 1..N {
                    row[c] -= row[k] * pivot_row[c];
                }
            }
        }
        Some(Self {
            scaled,
            factors: matrix,
            order,
            column_scale,
            row_scale,
        })
    }

    /// The solution for the right side `b`.
    #[must_use]
    pub fn solve(&self, b: &[f64; N]) -> [f64; N] {
        let mut x = [0.0; N];
        for (xi, &o) in x.iter_mut().zip(&self.order) {
            *xi = b[o] * self.row_scale[o];
        }
        self.substitute(&mut x);
        for (xi, scale) in x.iter_mut().zip(&self.column_scale) {
            *xi *= scale;
        }
        x
    }

    /// Forward and back substitution with the factors alone.
    fn substitute(&self, x: &mut [f64; N]) {
        for i in 1..N {
            for k in 0..i {
                x[i] -= self.factors[i][k] * x[k];
            }
        }
        for i in (0..N).rev() {
            for k in i + 1..N {
                x[i] -= self.factors[i][k] * x[k];
            }
            x[i] /= self.factors[i][i];
        }
    }

    /// The magnitudes of the scaled matrix's inverse.
    #[must_use]
    fn inverse_magnitudes(&self) -> [[f64; N]; N] {
        let mut inverse = [[0.0; N]; N];
        for (k, &source) in self.order.iter().enumerate() {
            let mut column = [0.0; N];
            column[k] = 1.0;
            self.substitute(&mut column);
            for r in 0..N {
                inverse[r][source] = column[r].abs();
            }
        }
        inverse
    }

    /// The condition number of the scaled matrix in the largest-row-sum norm, at least 1.
    #[must_use]
    pub fn condition(&self) -> f64 {
        let row_sum = |m: &[[f64; N]; N]| {
            m.iter()
                .map(|row| row.iter().map(|x| x.abs()).sum::<f64>())
                .fold(0.0, f64::max)
        };
        (row_sum(&self.scaled) * row_sum(&self.inverse_magnitudes())).max(1.0)
    }

    /// A bound on the error of each element of the solution `x` of the right side `b`.
    ///
    /// `uncertain` bounds the error that each element of `b` carries already. The bound is
    /// |A⁻¹| (|b − A x| + `uncertain` + (N + 4) u (|A| |x| + |b|)): the residual that is there, what the inputs
    /// bring, and the rounding of forming both.
    #[must_use]
    pub fn error_bound(&self, x: &[f64; N], b: &[f64; N], uncertain: &[f64; N]) -> [f64; N] {
        let rounding = (N + 4) as f64 * UNIT_ROUNDOFF;
        let mut doubt = [0.0; N];
        for r in 0..N {
            let right = b[r] * self.row_scale[r];
            let (mut residual, mut size) = (right, right.abs());
            for c in 0..N {
                let term = self.scaled[r][c] * (x[c] / self.column_scale[c]);
                residual -= term;
                size += term.abs();
            }
            doubt[r] = residual.abs() + uncertain[r] * self.row_scale[r] + rounding * size;
        }
        let inverse = self.inverse_magnitudes();
        let mut bound = [0.0; N];
        for r in 0..N {
            let sum: f64 = (0..N).map(|c| inverse[r][c] * doubt[c]).sum();
            bound[r] = sum * self.column_scale[r];
        }
        bound
    }
}

/// The power of two 2^−e for `largest` in [2^e, 2^(e+1)); `None` for zero, subnormal or not finite.
fn power_of_two_below_inverse(largest: f64) -> Option<f64> {
    let biased = largest.to_bits() >> 52;
    // Exponents 1 … 2045 have an inverse that is a normal number too.
    (1..=2045)
        .contains(&biased)
        .then(|| f64::from_bits((2046 - biased) << 52))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_badly_scaled_system_to_the_last_digits() {
        // Rows and columns of very different size, solution (1, 2, −3).
        let a = [[1e-200, 2e3, 0.0], [3e-200, -4e3, 1e90], [0.0, 1e3, 2e90]];
        let x = [1e200, 2e-3, -3e-90];
        let b = [1.0 + 4.0, 3.0 - 8.0 - 3.0, 2.0 - 6.0];
        let system = LinearSystem::new(a).expect("regular");
        let solved = system.solve(&b);
        for (got, want) in solved.iter().zip(&x) {
            assert!((got / want - 1.0).abs() < 1e-14, "{got} {want}");
        }
        assert!(system.condition() < 20.0);
        let bound = system.error_bound(&solved, &b, &[0.0; 3]);
        for ((got, want), bound) in solved.iter().zip(&x).zip(&bound) {
            assert!((got - want).abs() <= *bound && *bound < 1e-13 * want.abs());
        }
    }

    #[test]
    fn refuses_what_has_no_solution() {
        assert!(LinearSystem::new([[1.0, 2.0], [2.0, 4.0]]).is_none());
        assert!(LinearSystem::new([[1.0, f64::NAN], [2.0, 4.0]]).is_none());
        assert!(LinearSystem::new([[0.0, 0.0], [2.0, 4.0]]).is_none());
    }
}
