//! Positions, velocities and accelerations eight at a time, in loops written for one mechanism each: the paper's
//! (examples/figure-2.json) by Newton's method, as in `by_hand.rs`, and the four-bar (templates/four-bar.json) in
//! closed form. In the widest registers of the processor, as Kinegon's.

use crate::by_hand::{AB, BE, ByHand, FE, G, GD, GF, OMEGA, SURE};
use fearless_simd::{Level, Simd, SimdBase, SimdFloat, dispatch, f64x8};

/// Positions that a hand-written loop computes at a time.
pub const EIGHT: usize = 8;

/// One quantity at eight positions.
type Row = [f64; EIGHT];

/// Eight positions: cosines and sines of the angles of the links that are no crank, a slide, and rates of all these.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Eight<const LINKS: usize, const UNKNOWNS: usize> {
    pub crank: [Row; 2],
    pub turns: [[Row; 2]; LINKS],
    pub slide: Row,
    pub rates: [Row; UNKNOWNS],
    pub seconds: [Row; UNKNOWNS],
}

impl<const LINKS: usize, const UNKNOWNS: usize> Eight<LINKS, UNKNOWNS> {
    pub const ZERO: Self = Eight {
        crank: [[0.0; EIGHT]; 2],
        turns: [[[0.0; EIGHT]; 2]; LINKS],
        slide: [0.0; EIGHT],
        rates: [[0.0; EIGHT]; UNKNOWNS],
        seconds: [[0.0; EIGHT]; UNKNOWNS],
    };
}

/// Links 2, 4, 5; the unknowns are their angles and the block's distance from B along link 2.
pub type Paper = Eight<3, 4>;

/// Links 2, 3.
pub type FourBar = Eight<2, 2>;

/// Computes the paper's mechanism at these angles of the crank, which follow one another closely from that of `start`,
/// into as many places as there are, over and over.
#[inline(never)]
pub fn paper(registers: Level, start: &ByHand, degrees: &[f64], places: &mut [Paper]) {
    dispatch!(registers, simd => paper_in(simd, start, degrees, places));
}

/// The rates alone, of positions that have been computed.
#[inline(never)]
pub fn paper_rates(registers: Level, start: &ByHand, places: &mut [Paper]) {
    dispatch!(registers, simd => paper_rates_in(simd, start.gamma, places));
}

/// As [`paper`], from any angle on.
#[inline(never)]
pub fn four_bar(registers: Level, degrees: &[f64], places: &mut [FourBar]) {
    dispatch!(registers, simd => four_bar_in(simd, degrees, places));
}

type Pair<S> = [f64x8<S>; 2];

#[inline(always)]
fn load<S: Simd>(simd: S, rows: &[Row; 2]) -> Pair<S> {
    [f64x8::load_array_ref(simd, &rows[0]), f64x8::load_array_ref(simd, &rows[1])]
}

#[inline(always)]
fn store<S: Simd>(rows: &mut [Row; 2], v: Pair<S>) {
    v[0].store_array(&mut rows[0]);
    v[1].store_array(&mut rows[1]);
}

#[inline(always)]
fn scaled<S: Simd>(v: Pair<S>, by: f64) -> Pair<S> {
    [v[0] * by, v[1] * by]
}

#[inline(always)]
fn less<S: Simd>(v: Pair<S>, w: Pair<S>) -> Pair<S> {
    [v[0] - w[0], v[1] - w[1]]
}

/// v + w s
#[inline(always)]
fn plus<S: Simd>(v: Pair<S>, w: Pair<S>, s: f64x8<S>) -> Pair<S> {
    [w[0].mul_add(s, v[0]), w[1].mul_add(s, v[1])]
}

#[inline(always)]
fn dot<S: Simd>([a, b]: Pair<S>, [c, d]: Pair<S>) -> f64x8<S> {
    a.mul_add(c, b * d)
}

#[inline(always)]
fn cross<S: Simd>([a, b]: Pair<S>, [c, d]: Pair<S>) -> f64x8<S> {
    a.mul_sub(d, b * c)
}

/// `v` turned by the angle of cosine c and sine s.
#[inline(always)]
fn turn<S: Simd>([c, s]: Pair<S>, [x, y]: Pair<S>) -> Pair<S> {
    [c.mul_sub(x, s * y), s.mul_add(x, c * y)]
}

/// A direction turned by a small angle.
#[inline(always)]
fn turned<S: Simd>([c, s]: Pair<S>, angle: f64x8<S>) -> Pair<S> {
    let v = [c - s * angle, s + c * angle];
    let excess = dot(v, v) - 1.0;
    let scale = excess.mul_add(excess.mul_add(0.375, -0.5), 1.0);
    [v[0] * scale, v[1] * scale]
}

/// The highest coefficient stands first.
#[inline(always)]
fn polynomial<S: Simd>(simd: S, x: f64x8<S>, coefficients: [f64; 6]) -> f64x8<S> {
    let mut sum = f64x8::splat(simd, coefficients[0]);
    for coefficient in &coefficients[1..] {
        sum = sum.mul_add(x, *coefficient);
    }
    sum
}

/// Cosine and sine of angles in degrees.
#[inline(always)]
fn direction<S: Simd>(simd: S, degrees: f64x8<S>) -> Pair<S> {
    let quarters = (degrees * (1.0 / 90.0)).round_ties_even();
    let x = (degrees - quarters * 90.0) * (std::f64::consts::PI / 180.0);
    let z = x * x;
    // The polynomials of fdlibm (Sun Microsystems, 1993).
    let sine = [
        1.589_690_995_211_55e-10,
        -2.505_076_025_340_686_3e-8,
        2.755_731_370_707_006_8e-6,
        -1.984_126_982_985_795e-4,
        8.333_333_333_322_49e-3,
        -1.666_666_666_666_663_2e-1,
    ];
    let sine = polynomial(simd, z, sine).mul_add(z * x, x);
    let cosine = [
        -1.135_964_755_778_819_5e-11,
        2.087_572_321_298_175e-9,
        -2.755_731_435_139_066_3e-7,
        2.480_158_728_947_673e-5,
        -1.388_888_888_887_411e-3,
        4.166_666_666_666_666e-2,
    ];
    let cosine = polynomial(simd, z, cosine).mul_add(z * z, z * -0.5 + 1.0);
    // Quarter turns from −2 to 2 without whole turns; their cosine is 1 − |q| and their sine q (2 − |q|).
    let quarters = quarters - (quarters * 0.25).round_ties_even() * 4.0;
    let size = quarters.abs();
    turn([size * -1.0 + 1.0, quarters * (size * -1.0 + 2.0)], [cosine, sine])
}

/// The unit vectors of a position of the paper's mechanism, and the inverse of the matrix of ω2 and ω4.
struct Equations<S: Simd> {
    u2: Pair<S>,
    u4: Pair<S>,
    u6: Pair<S>,
    u5: Pair<S>,
    s: f64x8<S>,
    rows: [Pair<S>; 2],
    inverse: f64x8<S>,
}

impl<S: Simd> Equations<S> {
    #[inline(always)]
    fn new(simd: S, [u2, u4, u5]: [Pair<S>; 3], s: f64x8<S>, gamma: [f64; 2]) -> Self {
        let u6 = turn([f64x8::splat(simd, gamma[0]), f64x8::splat(simd, gamma[1])], u4);
        let rows = [[s, dot(u2, u4) * -GD], [cross(u5, u2) * -BE, cross(u5, u6) * GF]];
        let inverse = f64x8::splat(simd, 1.0) / cross(rows[0], rows[1]);
        Equations { u2, u4, u6, u5, s, rows, inverse }
    }

    /// ω2, ω4, ω5 and the block's rate for these right sides.
    #[inline(always)]
    fn solve(&self, first: Pair<S>, second: Pair<S>) -> [f64x8<S>; 4] {
        let [[a, b], [c, d]] = self.rows;
        let (p, q) = (cross(self.u2, first), dot(self.u5, second));
        let x2 = cross([p, q], [b, d]) * self.inverse;
        let x4 = cross([a, c], [p, q]) * self.inverse;
        let slide = dot(self.u2, first) - x4 * GD * cross(self.u2, self.u4);
        let turn = cross(self.u5, second) - x2 * BE * dot(self.u5, self.u2) + x4 * GF * dot(self.u5, self.u6);
        [x2, x4, turn * (-1.0 / FE), slide]
    }

    /// The unknowns' velocities and accelerations; `b` is the vector of the crank.
    #[inline(always)]
    fn rates(&self, b: Pair<S>) -> [[f64x8<S>; 4]; 2] {
        let Equations { u2, u4, u6, u5, s, .. } = *self;
        let side = [b[1] * OMEGA, b[0] * -OMEGA];
        let rates = self.solve(side, side);
        let [w2, w4, w5, v] = rates;
        let (x2, x4, x5) = (w2 * w2, w4 * w4, w5 * w5);
        let crank = scaled(b, OMEGA * OMEGA);
        let coriolis = w2 * v * 2.0;
        let first = plus(plus(crank, u2, x2 * s), u4, x4 * -GD);
        let first = plus(first, [u2[1], -u2[0]], coriolis);
        let second = plus(plus(plus(crank, u2, x2 * BE), u6, x4 * -GF), u5, x5 * -FE);
        [rates, self.solve(first, second)]
    }
}

#[inline(always)]
fn paper_in<S: Simd>(simd: S, start: &ByHand, degrees: &[f64], places: &mut [Paper]) {
    let all = |x: f64| f64x8::splat(simd, x);
    let mut turns = start.turns.map(|turn| [all(turn[0]), all(turn[1])]);
    let mut slide = all(start.slide);
    let [mut rates, mut seconds] = [[all(0.0); 4]; 2];
    for i in 0..4 {
        (rates[i], seconds[i]) = (all(start.rates[i]), all(start.seconds[i]));
    }
    let mut before = all(start.degrees);
    let count = places.len();
    for (group, values) in degrees.chunks_exact(EIGHT).enumerate() {
        let degrees = f64x8::from_slice(simd, values);
        let time = (degrees - before) * (std::f64::consts::PI / 180.0 / OMEGA);
        before = degrees;
        let mut steps = rates;
        for i in 0..4 {
            steps[i] = time * (time * 0.5).mul_add(seconds[i], rates[i]);
        }
        let crank = direction(simd, degrees);
        let b = scaled(crank, AB);
        loop {
            for (turn, step) in turns.iter_mut().zip(steps) {
                *turn = turned(*turn, step);
            }
            slide += steps[3];
            let equations = Equations::new(simd, turns, slide, start.gamma);
            let Equations { u2, u4, u6, u5, s, .. } = equations;
            let from = [all(G[0]) - b[0], all(G[1]) - b[1]];
            let first = less(plus(from, u4, all(GD)), [s * u2[0], s * u2[1]]);
            let second = less(plus(plus(from, u6, all(GF)), u5, all(FE)), scaled(u2, BE));
            steps = equations.solve(first, second);
            let [x, y, z, s] = steps;
            let s = s * (1.0 / BE);
            let largest = dot([x, y], [x, y]) + dot([z, s], [z, s]);
            if largest.reduce_max() < SURE * SURE {
                break;
            }
        }
        for (turn, step) in turns.iter_mut().zip(steps) {
            *turn = turned(*turn, step);
        }
        slide += steps[3];
        [rates, seconds] = Equations::new(simd, turns, slide, start.gamma).rates(b);
        let place = &mut places[group % count];
        store(&mut place.crank, crank);
        for (place, turn) in place.turns.iter_mut().zip(turns) {
            store(place, turn);
        }
        slide.store_array(&mut place.slide);
        for i in 0..4 {
            rates[i].store_array(&mut place.rates[i]);
            seconds[i].store_array(&mut place.seconds[i]);
        }
    }
}

#[inline(always)]
fn paper_rates_in<S: Simd>(simd: S, gamma: [f64; 2], places: &mut [Paper]) {
    for place in places {
        let turns = [load(simd, &place.turns[0]), load(simd, &place.turns[1]), load(simd, &place.turns[2])];
        let slide = f64x8::load_array_ref(simd, &place.slide);
        let b = scaled(load(simd, &place.crank), AB);
        let [rates, seconds] = Equations::new(simd, turns, slide, gamma).rates(b);
        for i in 0..4 {
            rates[i].store_array(&mut place.rates[i]);
            seconds[i].store_array(&mut place.seconds[i]);
        }
    }
}

/// Lengths of the four-bar, and the crank's angular velocity.
const CRANK: f64 = 60.0;
const COUPLER: f64 = 140.0;
const ROCKER: f64 = 110.0;
const GROUND: f64 = 160.0;
const SPEED: f64 = 10.0;

#[inline(always)]
fn four_bar_in<S: Simd>(simd: S, degrees: &[f64], places: &mut [FourBar]) {
    let all = |x: f64| f64x8::splat(simd, x);
    let count = places.len();
    for (group, values) in degrees.chunks_exact(EIGHT).enumerate() {
        let crank = direction(simd, f64x8::from_slice(simd, values));
        let b = scaled(crank, CRANK);
        // B→C = (a d + h J d) / |d|² of the vector d = B→D.
        let d = [all(GROUND) - b[0], -b[1]];
        let square = dot(d, d);
        let inverse = all(1.0) / square;
        let a = square * 0.5 + (0.5 * (COUPLER * COUPLER - ROCKER * ROCKER));
        let h = (square * (COUPLER * COUPLER) - a * a).sqrt();
        let bc = turn([a * inverse, h * inverse], d);
        let [u2, u3] = [scaled(bc, 1.0 / COUPLER), scaled(less(bc, d), 1.0 / ROCKER)];
        // ω1 J b + BC ω2 J u2 = CD ω3 J u3, and its derivative, in the directions of u3 and u2.
        let inverse = all(1.0) / cross(u2, u3);
        let w2 = cross(b, u3) * inverse * (-SPEED / COUPLER);
        let w3 = cross(b, u2) * inverse * (-SPEED / ROCKER);
        let normal = plus(scaled(b, SPEED * SPEED), u2, w2 * w2 * COUPLER);
        let normal = plus(normal, u3, w3 * w3 * -ROCKER);
        let a2 = dot(normal, u3) * inverse * (1.0 / COUPLER);
        let a3 = dot(normal, u2) * inverse * (1.0 / ROCKER);
        let place = &mut places[group % count];
        store(&mut place.crank, crank);
        store(&mut place.turns[0], u2);
        store(&mut place.turns[1], u3);
        w2.store_array(&mut place.rates[0]);
        w3.store_array(&mut place.rates[1]);
        a2.store_array(&mut place.seconds[0]);
        a3.store_array(&mut place.seconds[1]);
    }
}
