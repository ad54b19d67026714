//! The paper's mechanism (examples/figure-2.json) as one programs it for this mechanism alone, number by number.
//!
//! ```text
//! A→B→D = A→G→D        B + s u(θ2) = G + GD u(θ4)
//! A→B→E = A→G→F→E      B + BE u(θ2) = G + GF u(θ4 + γ) + FE u(θ5)
//! ```

pub const AB: f64 = 100.0;
pub const BE: f64 = 500.0;
pub const GD: f64 = 300.0;
pub const GF: f64 = 150.0;
const DF: f64 = 180.0;
pub const FE: f64 = 300.0;
pub const G: [f64; 2] = [275.0, 0.0];

/// Angular velocity of the crank, rad/s.
pub const OMEGA: f64 = -1.0;

/// The largest correction, in radians or parts of BE, after which a Newton step leaves rounding alone.
pub const SURE: f64 = 3e-9;

type Pair = [f64; 2];

/// The mechanism at its present position, with its rates.
#[derive(Clone, Copy, Debug)]
pub struct ByHand {
    /// The crank's angle in degrees.
    pub degrees: f64,
    /// Cosine and sine of the angles of links 2, 4, 5.
    pub turns: [Pair; 3],
    /// Distance of the block from B along link 2.
    pub slide: f64,
    /// ω of links 2, 4, 5 and the block's velocity along its guide.
    pub rates: [f64; 4],
    /// α of links 2, 4, 5 and the block's acceleration along its guide.
    pub seconds: [f64; 4],
    /// Cosine and sine of the angle from GD to GF.
    pub gamma: [f64; 2],
}

/// The equations of a position: unit vectors, and the inverse of the matrix of ω2 and ω4.
struct Equations {
    gaps: [Pair; 2],
    u2: Pair,
    u4: Pair,
    u6: Pair,
    u5: Pair,
    s: f64,
    rows: [Pair; 2],
    inverse: f64,
}

fn dot([a, b]: Pair, [c, d]: Pair) -> f64 {
    a * c + b * d
}

fn cross([a, b]: Pair, [c, d]: Pair) -> f64 {
    a * d - b * c
}

/// `v` turned by the angle of cosine c and sine s.
fn turn([c, s]: Pair, [x, y]: Pair) -> Pair {
    [c * x - s * y, s * x + c * y]
}

/// A direction turned by a small angle.
fn turned([c, s]: Pair, angle: f64) -> Pair {
    let [c, s] = [c - s * angle, s + c * angle];
    let excess = c * c + s * s - 1.0;
    let scale = 1.0 - excess * (0.5 - 0.375 * excess);
    [c * scale, s * scale]
}

impl ByHand {
    /// Near the position with the crank at 70°.
    pub fn new() -> ByHand {
        let unit = |degrees: f64| {
            let (sine, cosine) = libm::sincos(degrees.to_radians());
            [cosine, sine]
        };
        let cosine = (GD * GD + GF * GF - DF * DF) / (2.0 * GD * GF);
        let gamma = [cosine, -(1.0 - cosine * cosine).sqrt()];
        let turns = [42.0, 92.0, 76.0].map(unit);
        let mut start = ByHand { degrees: 70.0, turns, slide: 307.0, rates: [0.0; 4], seconds: [0.0; 4], gamma };
        start.go_to(70.0);
        start
    }

    /// Panics unless the rates at 70° are those that the tests of Kinegon have.
    pub fn check(&self) {
        assert!((self.rates[1] - -0.474_663_754_894).abs() < 1e-12);
        assert!((self.seconds[0] - 0.266_304_687_857_7).abs() < 1e-12);
    }

    /// Moves to another angle of the crank, from the position before carried on by its rates.
    #[inline(never)]
    pub fn go_to(&mut self, degrees: f64) {
        let time = (degrees - self.degrees).to_radians() / OMEGA;
        let ahead = |i: usize| time * (self.rates[i] + 0.5 * time * self.seconds[i]);
        let steps = [ahead(0), ahead(1), ahead(2), ahead(3)];
        self.carry(steps);
        let (sine, cosine) = libm::sincos(degrees.to_radians());
        let b = [AB * cosine, AB * sine];
        loop {
            let equations = self.equations(b);
            let steps = equations.solve(equations.gaps);
            self.carry(steps);
            let [x, y, z, s] = steps;
            let s = s / BE;
            if x * x + y * y + z * z + s * s < SURE * SURE {
                break;
            }
        }
        self.degrees = degrees;
        self.set_rates(b, &self.equations(b));
    }

    fn carry(&mut self, [x, y, z, s]: [f64; 4]) {
        let [a, b, c] = self.turns;
        self.turns = [turned(a, x), turned(b, y), turned(c, z)];
        self.slide += s;
    }

    fn equations(&self, b: Pair) -> Equations {
        let [u2, u4, u5] = self.turns;
        let u6 = turn(self.gamma, u4);
        let s = self.slide;
        let first = |i: usize| G[i] + GD * u4[i] - b[i] - s * u2[i];
        let second = |i: usize| G[i] + GF * u6[i] + FE * u5[i] - b[i] - BE * u2[i];
        let gaps = [[first(0), first(1)], [second(0), second(1)]];
        let rows = [[s, -GD * dot(u2, u4)], [-BE * cross(u5, u2), GF * cross(u5, u6)]];
        let inverse = 1.0 / (rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]);
        Equations { gaps, u2, u4, u6, u5, s, rows, inverse }
    }

    fn set_rates(&mut self, b: Pair, equations: &Equations) {
        let side = [OMEGA * b[1], -OMEGA * b[0]];
        let rates = equations.solve([side, side]);
        let [w2, w4, w5, v] = rates;
        let Equations { u2, u4, u6, u5, s, .. } = equations;
        let (x2, x4) = (w2 * w2, w4 * w4);
        let crank = |axis: usize| OMEGA * OMEGA * b[axis];
        let coriolis = [2.0 * w2 * v * u2[1], -2.0 * w2 * v * u2[0]];
        let first = |i: usize| crank(i) + x2 * s * u2[i] + coriolis[i] - x4 * GD * u4[i];
        let second = |i: usize| crank(i) + x2 * BE * u2[i] - x4 * GF * u6[i] - w5 * w5 * FE * u5[i];
        self.rates = rates;
        self.seconds = equations.solve([[first(0), first(1)], [second(0), second(1)]]);
    }
}

impl Equations {
    /// ω2, ω4, ω5 and the block's rate for these right sides.
    fn solve(&self, [first, second]: [Pair; 2]) -> [f64; 4] {
        let [[a, b], [c, d]] = self.rows;
        let (p, q) = (cross(self.u2, first), dot(self.u5, second));
        let x2 = (p * d - q * b) * self.inverse;
        let x4 = (a * q - c * p) * self.inverse;
        let slide = dot(self.u2, first) - x4 * GD * cross(self.u2, self.u4);
        let turn = cross(self.u5, second) - x2 * BE * dot(self.u5, self.u2) + x4 * GF * dot(self.u5, self.u6);
        [x2, x4, turn / -FE, slide]
    }
}
