// The same lane of several arrays is read and written: an index says it best.
#![allow(clippy::needless_range_loop)]

use super::{Lanes, Pairs, Vector, cross, lane};

/// Vector equations that split into two numbers' worth of shared unknowns and one unknown of their own each, in N lanes.
///
/// One equation, s x + t y = b: then x = (b × t) / (s × t), y = (s × b) / (s × t).
/// Two equations h_i z_i + s_i x + t_i y = b_i: crossing with h_i removes z_i, (h × s) x + (h × t) y = h × b; the own unknown
/// is then z = h · (b − s x − t y) / |h|². Crossing with h is a rotation but for the length of h, so nothing of the full system's
/// stability is lost. The determinant is that of the full system.
#[derive(Clone, Copy, Debug)]
pub struct Reduced<const EQUATIONS: usize, const N: usize> {
    columns: [[Pairs<N>; 3]; EQUATIONS],
    /// h × s, h × t by equation; components of s, t for one equation.
    rows: [[Lanes<N>; 2]; 2],
    inverse_determinant: Lanes<N>,
    inverse_squares: [Lanes<N>; EQUATIONS],
    /// The determinant.
    pub determinant: Lanes<N>,
    /// Sum of the magnitudes of the determinant's two products: in units of rounding, how uncertain it is.
    pub products: Lanes<N>,
    /// Square of the determinant over the product of its columns' lengths (Hadamard's ratio): 1 where all unknowns act at
    /// right angles, 0 in a singular position.
    pub squared_sharpness: Lanes<N>,
}

impl<const EQUATIONS: usize, const N: usize> Reduced<EQUATIONS, N> {
    /// The system with columns h, s, t for each equation; h is not read where there is only one.
    #[inline(always)]
    #[must_use]
    pub fn new(columns: [[Pairs<N>; 3]; EQUATIONS]) -> Self {
        const { assert!(EQUATIONS == 1 || EQUATIONS == 2) };
        let zeros = [0.0; N];
        let mut system = Self {
            columns,
            rows: [[zeros; 2]; 2],
            inverse_determinant: zeros,
            inverse_squares: [zeros; EQUATIONS],
            determinant: zeros,
            products: zeros,
            squared_sharpness: zeros,
        };
        for i in 0..N {
            let (mut s_square, mut t_square, mut inverse_h_squares) = (0.0, 0.0, 1.0);
            let mut rows = [[0.0; 2]; 2];
            for k in 0..EQUATIONS {
                let [h, s, t] = system.column(k, i);
                s_square += s.norm_squared();
                t_square += t.norm_squared();
                if EQUATIONS == 1 {
                    rows = [[s.x, t.x], [s.y, t.y]];
                } else {
                    rows[k] = [cross(h, s), cross(h, t)];
                    system.inverse_squares[k][i] = 1.0 / h.norm_squared();
                    inverse_h_squares *= system.inverse_squares[k][i];
                }
            }
            for k in 0..2 {
                for l in 0..2 {
                    system.rows[k][l][i] = rows[k][l];
                }
            }
            let (down, up) = (rows[0][0] * rows[1][1], rows[0][1] * rows[1][0]);
            let determinant = down - up;
            system.determinant[i] = determinant;
            system.products[i] = down.abs() + up.abs();
            system.squared_sharpness[i] =
                determinant * determinant * inverse_h_squares / (s_square * t_square);
            system.inverse_determinant[i] = 1.0 / determinant;
        }
        system
    }

    #[inline(always)]
    fn column(&self, equation: usize, i: usize) -> [Vector; 3] {
        let [h, s, t] = &self.columns[equation];
        [lane(h, i), lane(s, i), lane(t, i)]
    }

    /// x, y and, of two equations, their own unknowns, for these right sides.
    #[inline(always)]
    #[must_use]
    pub fn solve(&self, sides: &[Pairs<N>; EQUATIONS]) -> [Lanes<N>; 4] {
        let mut solution = [[0.0; N]; 4];
        for i in 0..N {
            let [[a, b], [c, d]] = self.rows.map(|row| row.map(|x| x[i]));
            let [p, q] = if EQUATIONS == 1 {
                let b = lane(&sides[0], i);
                [b.x, b.y]
            } else {
                [0, EQUATIONS - 1].map(|k| cross(self.column(k, i)[0], lane(&sides[k], i)))
            };
            let x = (p * d - q * b) * self.inverse_determinant[i];
            let y = (a * q - c * p) * self.inverse_determinant[i];
            (solution[0][i], solution[1][i]) = (x, y);
            if EQUATIONS == 2 {
                for k in 0..EQUATIONS {
                    let [h, s, t] = self.column(k, i);
                    let rest = lane(&sides[k], i) - s * x - t * y;
                    solution[2 + k][i] = h.dot(&rest) * self.inverse_squares[k][i];
                }
            }
        }
        solution
    }
}
