use crate::geometry::{Numbers, Point, UNIT_ROUNDOFF, Vector, cross};
use crate::mechanism::{LoopEquations, Reduction};

/// The loop equations of a group reduced to two equations for two rates: second, third and fourth class.
///
/// A dyad's one loop has just two unknown rates x, y with columns s, t: x = (b × t) / (s × t), y = (s × b) / (s × t).
/// In a third- or fourth-class group each of the two loops has one rate of its own besides the two that they share.
/// With h the column of that rate, crossing the loop's equation with h removes it:
/// (h × s) x + (h × t) y = h × b; the own rate is then h · (b − s x − t y) / |h|².
/// For a fourth-class group with pins only this is ω2 (BC × CD) − ω4 (ED × CD) = Δv · CD and its like. Crossing with h is a
/// rotation but for the length of h, so nothing of the full system's stability is lost.
#[derive(Clone, Copy, Debug)]
pub struct ClosedForm {
    reduction: Reduction,
    /// For each loop: h, s, t. A dyad uses s and t of the first.
    columns: [[Vector; 3]; 2],
    /// h × s, h × t.
    rows: [[f64; 2]; 2],
    inverse_determinant: f64,
    inverse_squares: [f64; 2],
}

impl ClosedForm {
    /// The reduced form of the equations where the points and guides are these; `None` where there is none, or its determinant is
    /// lost in rounding or near the ends of f64's range.
    #[inline]
    #[must_use]
    pub fn new(equations: &LoopEquations, points: &[Point], guides: &[Vector]) -> Option<Self> {
        let reduction = equations.reduction?;
        // A reduction has at most four unknowns in two loops.
        let mut all = [[Vector::zeros(); 4]; 2];
        for (terms, columns) in equations.loops.iter().zip(&mut all) {
            terms.add_columns(points, guides, columns);
        }
        let (columns, rows) = match reduction {
            Reduction::OneLoop => {
                let [s, t, ..] = all[0];
                let none = [Vector::zeros(); 3];
                ([[Vector::zeros(), s, t], none], [[s.x, t.x], [s.y, t.y]])
            }
            Reduction::TwoLoops {
                shared: [x, y],
                own,
            } => {
                let columns = [0, 1].map(|i| [all[i][own[i]], all[i][x], all[i][y]]);
                (columns, columns.map(|[h, s, t]| [cross(h, s), cross(h, t)]))
            }
        };
        let (down, up) = (rows[0][0] * rows[1][1], rows[0][1] * rows[1][0]);
        let determinant = down - up;
        // False for a NaN too. Fourth powers of lengths must not come near the ends of f64's range.
        let safe = determinant.abs() > 16.0 * UNIT_ROUNDOFF * (down.abs() + up.abs())
            && (1e-250..1e250).contains(&determinant.abs());
        safe.then(|| Self {
            reduction,
            columns,
            rows,
            inverse_determinant: 1.0 / determinant,
            inverse_squares: columns.map(|[h, ..]| 1.0 / h.norm_squared()),
        })
    }

    /// The rates for the right sides of the loops; a dyad has one loop and the first two rates.
    #[inline]
    #[must_use]
    pub fn solve(&self, sides: [Vector; 2]) -> [f64; 4] {
        let [[a, b], [c, d]] = self.rows;
        let cramer = |p: f64, q: f64| {
            let x = (p * d - q * b) * self.inverse_determinant;
            (x, (a * q - c * p) * self.inverse_determinant)
        };
        let mut rates = [0.0; 4];
        match self.reduction {
            Reduction::OneLoop => (rates[0], rates[1]) = cramer(sides[0].x, sides[0].y),
            Reduction::TwoLoops { shared, own } => {
                let [p, q] = [0, 1].map(|i| cross(self.columns[i][0], sides[i]));
                let (x, y) = cramer(p, q);
                rates[shared[0]] = x;
                rates[shared[1]] = y;
                for i in 0..2 {
                    let [h, s, t] = self.columns[i];
                    let rest = sides[i] - s * x - t * y;
                    rates[own[i]] = h.dot(&rest) * self.inverse_squares[i];
                }
            }
        }
        rates
    }

    /// The same for the right sides in a row, as many rates as there are numbers.
    #[must_use]
    pub fn solve_all(&self, side: &[f64]) -> Numbers {
        let mut sides = [Vector::zeros(); 2];
        for (vector, pair) in sides.iter_mut().zip(side.chunks_exact(2)) {
            *vector = Vector::new(pair[0], pair[1]);
        }
        Numbers::from_slice(&self.solve(sides)[..side.len()])
    }
}
