use crate::geometry::{Floating, Lanes, MANY, Pair, Row, UNIT_ROUNDOFF, Vector, portions, quarter_turn};
use crate::kernel::{Block, Kernel, Single, Unknown, unit, vector};

/// A position on the path, with its rates for a unit rate of the drive.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// The drive's value: degrees, or a length.
    pub value: f64,
    pub block: Single,
    /// By group: the determinant, and the squared Hadamard ratio (1 far from singular positions, 0 in them).
    pub determinants: Vec<[f64; 2]>,
}

impl Node {
    pub fn new(kernel: &Kernel, value: f64, block: Single) -> Node {
        Node { value, determinants: kernel.determinants(&block), block }
    }
}

/// First and second derivative of an unknown, by time or, of a node, by the drive's value.
#[inline]
pub(super) fn rates(block: &Single, unknown: Unknown) -> [f64; 2] {
    match unknown {
        Unknown::Spin(class) => [block.omegas[class][0], block.alphas[class][0]],
        Unknown::Slide(slider) => [block.speeds[slider][0], block.accelerations[slider][0]],
    }
}

/// The path between two nodes: for each unknown the polynomial of degree 5 with the values, first and second
/// derivatives of both nodes.
#[derive(Clone, Debug)]
pub(super) struct Segment {
    pub from: f64,
    pub to: f64,
    /// Largest first Newton step from a prediction after which only rounding is left, in radians or parts of the
    /// group's size.
    pub sure: f64,
    /// Whether positions are closed once more with gaps of twice the digits.
    pub delicate: bool,
    turns: Vec<(usize, [Quintic; 2])>,
    slides: Vec<(usize, Quintic)>,
}

/// Coefficients of a polynomial of degree 5, constant term first; its variable runs from 0 to 1 along the segment.
type Quintic = [f64; 6];

/// The polynomial with the given value, first and second derivative at 0 and at 1 (Hermite interpolation).
pub fn quintic([f0, d0, e0]: [f64; 3], [f1, d1, e1]: [f64; 3]) -> Quintic {
    let rise = f1 - f0;
    [
        f0,
        d0,
        0.5 * e0,
        10.0 * rise - 6.0 * d0 - 4.0 * d1 - 1.5 * e0 + 0.5 * e1,
        -15.0 * rise + 8.0 * d0 + 7.0 * d1 + 1.5 * e0 - e1,
        6.0 * rise - 3.0 * d0 - 3.0 * d1 - 0.5 * e0 + 0.5 * e1,
    ]
}

#[inline(always)]
fn value<T: Floating>(q: &Quintic, x: T) -> T {
    let [rest @ .., last] = q;
    let mut sum = x.same(*last);
    for coefficient in rest.iter().rev() {
        sum = x.same(*coefficient).plus_product(sum, x);
    }
    sum
}

pub fn slope(q: &Quintic, x: f64) -> f64 {
    q[1] + x * (2.0 * q[2] + x * (3.0 * q[3] + x * (4.0 * q[4] + x * 5.0 * q[5])))
}

impl Segment {
    pub fn new(kernel: &Kernel, start: &Node, end: &Node) -> Segment {
        let step = end.value - start.value;
        // A Newton step leaves an error of its square over the Hadamard ratio, which is hardly less between the nodes
        // than at them.
        let groups = start.determinants.iter().chain(&end.determinants);
        let ratio = groups.fold(1.0, |least: f64, [_, squared]| least.min(squared.sqrt())) / 4.0;
        let mut segment = Segment {
            from: start.value,
            to: end.value,
            sure: 0.6 * (UNIT_ROUNDOFF * ratio).sqrt(),
            delicate: false,
            turns: Vec::new(),
            slides: Vec::new(),
        };
        for unknown in kernel.unknowns.iter().flatten() {
            match *unknown {
                Unknown::Spin(class) => {
                    // The unknown is the direction d = (cosine, sine); its derivatives are ω J d and (α J − ω²) d.
                    let of = |node: &Node| {
                        let direction = vector(&node.block.turns[class], 0);
                        let [omega, alpha] = rates(&node.block, *unknown);
                        let (omega, alpha) = (omega * step, alpha * step * step);
                        let across: Vector = quarter_turn(direction);
                        [direction, across * omega, across * alpha - direction * (omega * omega)]
                    };
                    let (a, b) = (of(start), of(end));
                    let curve = [0, 1].map(|axis| quintic(a.map(|v| v[axis]), b.map(|v| v[axis])));
                    segment.turns.push((class, curve));
                }
                Unknown::Slide(slider) => {
                    let of = |node: &Node| {
                        let [speed, second] = rates(&node.block, *unknown);
                        [node.block.slides[slider][0], speed * step, second * step * step]
                    };
                    segment.slides.push((slider, quintic(of(start), of(end))));
                }
            }
        }
        segment
    }

    /// Whether a value of the drive lies on the segment.
    #[inline(always)]
    pub fn holds(&self, drive: f64) -> bool {
        self.from <= drive && drive <= self.to
    }

    /// Whether all these values of the drive lie on the segment.
    #[inline(always)]
    pub fn holds_all<L: Lanes, R: Row>(&self, lanes: L, drive: &R) -> bool {
        let mut within = true;
        for k in portions::<L, R>() {
            within &= lanes.all_within(lanes.load(drive, k), self.from, self.to);
        }
        within
    }

    /// Sets the unknowns of `block` to the values of the polynomials at these values of the drive.
    #[inline(always)]
    pub fn predict<L: Lanes, R: Row>(&self, lanes: L, drive: &R, block: &mut Block<R>) {
        let (from, scale) = (lanes.splat(self.from), lanes.splat(1.0 / (self.to - self.from)));
        let mut along = [from; MANY];
        for k in portions::<L, R>() {
            along[k] = (lanes.load(drive, k) - from) * scale;
        }
        for (class, [cosine, sine]) in &self.turns {
            let turns = &mut block.turns[*class];
            for k in portions::<L, R>() {
                let x = along[k];
                let direction = Pair { x: value(cosine, x), y: value(sine, x) };
                // The interpolated direction is nearly of length 1; this makes it so.
                lanes.store_pair(turns, k, unit(direction));
            }
        }
        for (slider, curve) in &self.slides {
            let slides = &mut block.slides[*slider];
            for k in portions::<L, R>() {
                lanes.store(slides, k, value(curve, along[k]));
            }
        }
    }

    /// The rate of an unknown per unit of the drive, from the polynomials.
    pub fn rate(&self, unknown: Unknown, drive: f64) -> f64 {
        let x = (drive - self.from) / (self.to - self.from);
        let rise = match unknown {
            Unknown::Spin(class) => {
                let curve = self.turns.iter().find(|(c, _)| *c == class);
                curve.map_or(0.0, |(_, [cosine, sine])| {
                    value(cosine, x) * slope(sine, x) - value(sine, x) * slope(cosine, x)
                })
            }
            Unknown::Slide(slider) => {
                let curve = self.slides.iter().find(|(s, _)| *s == slider);
                curve.map_or(0.0, |(_, curve)| slope(curve, x))
            }
        };
        rise / (self.to - self.from)
    }
}
