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
    /// 1 / |h|² by equation.
    inverse_squares: [T; EQUATIONS],
}

impl<const EQUATIONS: usize, T: Number> Reduced<EQUATIONS, T> {
    /// The system with columns h, s, t for each equation.
    #[inline(always)]
    #[must_use]
    pub fn new(columns: [[Pair<T>; 3]; EQUATIONS]) -> Self {
        let inverse = |[h, ..]: [Pair<T>; 3]| h.x.same(1.0) / h.dot(h);
        Self::with_inverse_squares(columns, columns.map(inverse))
    }

    /// The same where 1 / |h|² of each equation is known: of a turned link it is always the same.
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

    /// The determinant's two products; their size times a unit of rounding is how uncertain it is.
    #[inline(always)]
    #[must_use]
    pub fn products(&self) -> [T; 2] {
        let [[a, b], [c, d]] = self.rows;
        [a * d, b * c]
    }

    /// Square of the determinant over the product of its columns' lengths (Hadamard's ratio): 1 where all unknowns act at
    /// right angles, 0 in a singular position.
    #[must_use]
    pub fn squared_sharpness(&self) -> T {
        let determinant = self.determinant();
        let one = determinant.same(1.0);
        let square = |column: usize| {
            let squares = self.columns.iter().map(|c| c[column].dot(c[column]));
            squares.fold(one.same(0.0), |sum, square| sum + square)
        };
        let own = self.inverse_squares.iter().fold(one, |p, i| p * *i);
        let own = if EQUATIONS == 2 { own } else { one };
        determinant * determinant * own / (square(1) * square(2))
    }

    /// x, y and, of two equations, their own unknowns, for these right sides; `inverse` is that of the determinant.
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
        [x, y, self.own(0, x, y, sides), self.own(1, x, y, sides)]
    }

    /// The own unknown of an equation.
    #[inline(always)]
    fn own(&self, equation: usize, x: T, y: T, sides: [Pair<T>; EQUATIONS]) -> T {
        let [h, s, t] = self.columns[equation];
        let rest = sides[equation].minus_scaled(s, x).minus_scaled(t, y);
        h.dot(rest) * self.inverse_squares[equation]
    }
}
