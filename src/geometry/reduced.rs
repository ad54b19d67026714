use super::{Number, Pair};

/// Vector equations that split into two shared unknowns and one unknown of their own each.
///
/// One equation, s x + t y = b: then x = (b × t) / (s × t), y = (s × b) / (s × t).
/// Two equations h_i z_i + s_i x + t_i y = b_i: crossing with h_i removes z_i, (h × s) x + (h × t) y = h × b; the own unknown
/// is then z = h · (b − s x − t y) / |h|². Crossing with h is a rotation but for the length of h, so nothing of the full system's
/// stability is lost. The determinant is that of the full system.
#[derive(Clone, Copy, Debug)]
pub struct Reduced<const EQUATIONS: usize, T> {
    /// h, s, t; h is not read where there is only one equation.
    columns: [[Pair<T>; 3]; EQUATIONS],
    /// h × s, h × t by equation; components of s, t for one equation.
    rows: [[T; 2]; 2],
    inverse_determinant: T,
    inverse_squares: [T; EQUATIONS],
    /// The determinant.
    pub determinant: T,
}

impl<const EQUATIONS: usize, T: Number> Reduced<EQUATIONS, T> {
    /// The system with columns h, s, t for each equation.
    #[inline(always)]
    #[must_use]
    pub fn new(columns: [[Pair<T>; 3]; EQUATIONS]) -> Self {
        const { assert!(EQUATIONS == 1 || EQUATIONS == 2) };
        let one = T::splat(1.0);
        let [_, s, t] = columns[0];
        let mut rows = [[s.x, t.x], [s.y, t.y]];
        let mut inverse_squares = [one; EQUATIONS];
        if EQUATIONS == 2 {
            let squares = [0, EQUATIONS - 1].map(|k| columns[k][0].dot(columns[k][0]));
            // One division for both.
            let both = one / (squares[0] * squares[1]);
            inverse_squares = [squares[1] * both; EQUATIONS];
            inverse_squares[EQUATIONS - 1] = squares[0] * both;
            rows = [0, EQUATIONS - 1].map(|k| {
                let [h, s, t] = columns[k];
                [h.cross(s), h.cross(t)]
            });
        }
        let determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
        Self {
            columns,
            rows,
            inverse_determinant: one / determinant,
            inverse_squares,
            determinant,
        }
    }

    /// Square of the determinant over the product of its columns' lengths (Hadamard's ratio): 1 where all unknowns act at
    /// right angles, 0 in a singular position.
    #[must_use]
    pub fn squared_sharpness(&self) -> T {
        let square = |column: usize| {
            let squares = self.columns.iter().map(|c| c[column].dot(c[column]));
            squares.fold(T::splat(0.0), |sum, square| sum + square)
        };
        let own = self
            .inverse_squares
            .iter()
            .fold(T::splat(1.0), |p, i| p * *i);
        let own = if EQUATIONS == 2 { own } else { T::splat(1.0) };
        self.determinant * self.determinant * own / (square(1) * square(2))
    }

    /// Sum of the magnitudes of the determinant's two products: in units of rounding, how uncertain it is.
    #[must_use]
    pub fn products(&self) -> f64 {
        let [[a, b], [c, d]] = self.rows;
        (a * d).largest() + (b * c).largest()
    }

    /// x, y and, of two equations, their own unknowns, for these right sides.
    #[inline(always)]
    #[must_use]
    pub fn solve(&self, sides: [Pair<T>; EQUATIONS]) -> [T; 4] {
        let [[a, b], [c, d]] = self.rows;
        let [p, q] = if EQUATIONS == 1 {
            [sides[0].x, sides[0].y]
        } else {
            [0, EQUATIONS - 1].map(|k| self.columns[k][0].cross(sides[k]))
        };
        let x = (p * d - q * b) * self.inverse_determinant;
        let y = (a * q - c * p) * self.inverse_determinant;
        if EQUATIONS == 1 {
            return [x, y, x, y];
        }
        let [first, second] = [0, EQUATIONS - 1].map(|k| {
            let [h, s, t] = self.columns[k];
            h.dot(sides[k] - s * x - t * y) * self.inverse_squares[k]
        });
        [x, y, first, second]
    }
}
