use super::{Number, Pair};

/// One plane vector equation in two unknowns x, y; or two that share x, y and have one further unknown z_i each.
///
/// One equation, s x + t y = b: then x = (b × t) / (s × t), y = (s × b) / (s × t).
/// Two equations h_i z_i + s_i x + t_i y = b_i: the cross product with h_i removes z_i, (h × s) x + (h × t) y = h × b;
/// then z = h · (b − s x − t y) / |h|². The cross product with h is a rotation but for the length of h, so the
/// elimination is as stable as the full system. The determinant is that of the full system.
#[derive(Clone, Copy, Debug)]
pub struct Reduced<const EQUATIONS: usize, T> {
    /// h, s, t of each equation; h is not read where there is only one equation.
    columns: [[Pair<T>; 3]; EQUATIONS],
    /// The matrix of x and y: h × s, h × t of each of two equations, or the components of s, t of a single one.
    rows: [[T; 2]; 2],
    /// 1 / |h|² by equation.
    inverse_squares: [T; EQUATIONS],
}

impl<const EQUATIONS: usize, T: Number> Reduced<EQUATIONS, T> {
    /// The system with columns h, s, t for each equation.
    #[inline(always)]
    #[must_use]
    pub fn new(columns: [[Pair<T>; 3]; EQUATIONS]) -> Self {
        let inverse = |[h, ..]: [Pair<T>; 3]| h.x.one() / h.dot(h);
        Self::with_inverse_squares(columns, columns.map(inverse))
    }

    /// As [`Self::new`], with 1 / |h|² of each equation known: h of a turning link keeps its length.
    #[inline(always)]
    #[must_use]
    pub fn with_inverse_squares(columns: [[Pair<T>; 3]; EQUATIONS], inverse_squares: [T; EQUATIONS]) -> Self {
        const { assert!(EQUATIONS == 1 || EQUATIONS == 2) };
        let rows = if EQUATIONS == 1 {
            let [_, s, t] = columns[0];
            [[s.x, t.x], [s.y, t.y]]
        } else {
            let ([h, s, t], [g, u, v]) = (columns[0], columns[EQUATIONS - 1]);
            [[h.cross(s), h.cross(t)], [g.cross(u), g.cross(v)]]
        };
        Self { columns, rows, inverse_squares }
    }

    /// The determinant.
    #[inline(always)]
    #[must_use]
    pub fn determinant(&self) -> T {
        let [[a, b], [c, d]] = self.rows;
        (a * d).minus_product(b, c)
    }

    /// The two products whose difference is the determinant; its rounding error is about their size times the unit
    /// roundoff.
    #[inline(always)]
    #[must_use]
    pub fn products(&self) -> [T; 2] {
        let [[a, b], [c, d]] = self.rows;
        [a * d, b * c]
    }

    /// Square of the Hadamard ratio (the determinant over the product of its columns' lengths): 1 where all unknowns act
    /// at right angles, 0 in a singular position.
    #[must_use]
    pub fn squared_hadamard_ratio(&self) -> T {
        let determinant = self.determinant();
        let one = determinant.one();
        let square = |column: usize| {
            self.columns.iter().map(|c| c[column].dot(c[column])).fold(one.eighths(0), |sum, square| sum + square)
        };
        let inverse_squares = if EQUATIONS == 2 { self.inverse_squares.iter().fold(one, |p, i| p * *i) } else { one };
        determinant * determinant * inverse_squares / (square(1) * square(2))
    }

    /// x, y, z_1, z_2 for these right sides, or x, y, x, y for a single equation; `inverse` is 1 / determinant.
    #[inline(always)]
    #[must_use]
    pub fn solve(&self, inverse: T, sides: [Pair<T>; EQUATIONS]) -> [T; 4] {
        let [[a, b], [c, d]] = self.rows;
        let [p, q] = if EQUATIONS == 1 {
            [sides[0].x, sides[0].y]
        } else {
            let ([h, ..], [g, ..]) = (self.columns[0], self.columns[EQUATIONS - 1]);
            [h.cross(sides[0]), g.cross(sides[EQUATIONS - 1])]
        };
        let x = (p * d).minus_product(q, b) * inverse;
        let y = (a * q).minus_product(c, p) * inverse;
        if EQUATIONS == 1 {
            return [x, y, x, y];
        }
        [x, y, self.further_unknown(0, x, y, sides), self.further_unknown(1, x, y, sides)]
    }

    /// The unknown z of an equation.
    #[inline(always)]
    fn further_unknown(&self, equation: usize, x: T, y: T, sides: [Pair<T>; EQUATIONS]) -> T {
        let [h, s, t] = self.columns[equation];
        let rest = sides[equation].minus_scaled(s, x).minus_scaled(t, y);
        h.dot(rest) * self.inverse_squares[equation]
    }
}
