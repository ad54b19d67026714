use crate::geometry::{Point, UNIT_ROUNDOFF, Vector, cross, quarter_turn};

/// The 2 × 2 closed form for a fourth-class group with revolute joints only.
///
/// Projecting each loop on its closure link removes that link's rate: with BC, CD, ED, BG, GF, EF as arms
/// and h_3, h_5 the right sides of the two loops,
/// ω2 (BC × CD) − ω4 (ED × CD) = h_3 · CD, ω2 (BG × GF) − ω4 (EF × GF) = h_5 · GF,
/// ω3 = CD × (h_3 + ω4 J ED − ω2 J BC) / |CD|², ω5 likewise.
#[derive(Clone, Copy, Debug)]
pub struct ClosedForm {
    bc: Vector,
    cd: Vector,
    ed: Vector,
    bg: Vector,
    gf: Vector,
    ef: Vector,
    rows: [[f64; 2]; 2],
    inverse_determinant: f64,
    inverse_squares: [f64; 2],
}

impl ClosedForm {
    /// The reduced system for the joints B C D E F G; `None` where its determinant is lost in rounding.
    #[inline]
    #[must_use]
    pub fn new([b, c, d, e, f, g]: [Point; 6]) -> Option<Self> {
        let (bc, cd, ed) = (c - b, d - c, d - e);
        let (bg, gf, ef) = (g - b, f - g, f - e);
        let rows = [
            [cross(bc, cd), -cross(ed, cd)],
            [cross(bg, gf), -cross(ef, gf)],
        ];
        let (down, up) = (rows[0][0] * rows[1][1], rows[0][1] * rows[1][0]);
        let determinant = down - up;
        // Written so that a NaN is refused too.
        if !(determinant.abs() > 16.0 * UNIT_ROUNDOFF * (down.abs() + up.abs())) {
            return None;
        }
        Some(Self {
            bc,
            cd,
            ed,
            bg,
            gf,
            ef,
            rows,
            inverse_determinant: 1.0 / determinant,
            inverse_squares: [1.0 / cd.norm_squared(), 1.0 / gf.norm_squared()],
        })
    }

    /// The rates of the links 2, 3, 4, 5 for the loops' right sides `h3` and `h5`.
    #[inline]
    #[must_use]
    pub fn solve(&self, h3: Vector, h5: Vector) -> [f64; 4] {
        let (p, q) = (h3.dot(&self.cd), h5.dot(&self.gf));
        let [[a, b], [c, d]] = self.rows;
        let two = (p * d - q * b) * self.inverse_determinant;
        let four = (a * q - c * p) * self.inverse_determinant;
        let rest3 = h3 + quarter_turn(self.ed) * four - quarter_turn(self.bc) * two;
        let rest5 = h5 + quarter_turn(self.ef) * four - quarter_turn(self.bg) * two;
        let three = cross(self.cd, rest3) * self.inverse_squares[0];
        let five = cross(self.gf, rest5) * self.inverse_squares[1];
        [two, three, four, five]
    }

    /// Σ ω² r of the two loops, the normal parts of the acceleration equations.
    #[inline]
    #[must_use]
    pub fn normal_sums(&self, [two, three, four, five]: [f64; 4]) -> [Vector; 2] {
        let four = four * four;
        [
            self.bc * (two * two) + self.cd * (three * three) - self.ed * four,
            self.bg * (two * two) + self.gf * (five * five) - self.ef * four,
        ]
    }
}
