use crate::geometry::{UNIT_ROUNDOFF, Vector, cross};
use crate::mechanism::{Reduction, UNKNOWNS};

/// The loop equations of a fourth-class group, reduced to two equations for the two rates that both loops share.
///
/// Each loop has one rate of its own: that of its closure link, or of the slider there. With h the column of that rate
/// and s, t those of the shared rates x, y, crossing the loop's equation with h removes it:
/// (h × s) x + (h × t) y = h × b; the own rate is then h · (b − s x − t y) / |h|².
/// For revolute joints this is ω2 (BC × CD) − ω4 (ED × CD) = Δv · CD and its like. Crossing with h is a rotation but for the
/// length of h, so nothing of the full system's stability is lost.
#[derive(Clone, Copy, Debug)]
pub struct ClosedForm {
    reduction: Reduction,
    /// For each loop: h, s, t.
    columns: [[Vector; 3]; 2],
    /// h × s, h × t.
    rows: [[f64; 2]; 2],
    inverse_determinant: f64,
    inverse_squares: [f64; 2],
}

impl ClosedForm {
    /// The reduced form of the equations with this matrix; `None` where its determinant is lost in rounding or near the ends of
    /// f64's range.
    #[inline]
    #[must_use]
    pub fn new(matrix: &[[f64; UNKNOWNS]; UNKNOWNS], reduction: Reduction) -> Option<Self> {
        let column = |side: usize, unknown: usize| {
            Vector::new(matrix[2 * side][unknown], matrix[2 * side + 1][unknown])
        };
        let [x, y] = reduction.shared;
        let of_loop = |side: usize| {
            [
                column(side, reduction.own[side]),
                column(side, x),
                column(side, y),
            ]
        };
        let columns = [of_loop(0), of_loop(1)];
        let rows = columns.map(|[h, s, t]| [cross(h, s), cross(h, t)]);
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

    /// The rates for a right side.
    #[inline]
    #[must_use]
    pub fn solve(&self, side: &[f64; UNKNOWNS]) -> [f64; UNKNOWNS] {
        let sides = [Vector::new(side[0], side[1]), Vector::new(side[2], side[3])];
        let [p, q] = [0, 1].map(|i| cross(self.columns[i][0], sides[i]));
        let [[a, b], [c, d]] = self.rows;
        let x = (p * d - q * b) * self.inverse_determinant;
        let y = (a * q - c * p) * self.inverse_determinant;
        let mut rates = [0.0; UNKNOWNS];
        rates[self.reduction.shared[0]] = x;
        rates[self.reduction.shared[1]] = y;
        for i in 0..2 {
            let [h, s, t] = self.columns[i];
            let rest = sides[i] - s * x - t * y;
            rates[self.reduction.own[i]] = h.dot(&rest) * self.inverse_squares[i];
        }
        rates
    }
}
