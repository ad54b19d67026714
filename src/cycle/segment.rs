use super::Path;
use crate::geometry::{Number, Pair, UNIT_ROUNDOFF, Vector, quarter_turn};
use crate::kernel::{Block, Kernel, Single, Unknown, unit, vector};

/// A position on the path, with its rates for a unit rate of the drive.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// The drive's value: degrees, or a length.
    pub value: f64,
    pub block: Single,
    /// By group: determinant, and squared sharpness.
    pub determinants: Vec<[f64; 2]>,
}

impl Node {
    pub fn new(path: &Path, value: f64, block: Single) -> Node {
        Node {
            value,
            determinants: path.kernel.determinants(&block),
            block,
        }
    }
}

/// The path between two nodes: for each unknown the polynomial of degree 5 that has both nodes' values, first and second derivatives.
#[derive(Clone, Debug)]
pub(super) struct Segment {
    pub from: f64,
    pub to: f64,
    /// The largest first Newton step from a prediction, in radians or parts of a group's size, that leaves only rounding.
    pub sure: f64,
    turns: Vec<(usize, [Quintic; 2])>,
    slides: Vec<(usize, Quintic)>,
}

/// Coefficients of a polynomial, constant term first; its variable runs from 0 to 1 along the segment.
type Quintic = [f64; 6];

/// The polynomial with value, first and second derivative of these at 0 and at 1 (Hermite).
fn quintic([f0, d0, e0]: [f64; 3], [f1, d1, e1]: [f64; 3]) -> Quintic {
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
fn value<T: Number>(q: &Quintic, x: T) -> T {
    let [constant, rest @ .., last] = q;
    let sum = rest
        .iter()
        .rev()
        .fold(T::splat(*last), |sum, c| sum * x + T::splat(*c));
    sum * x + T::splat(*constant)
}

fn slope(q: &Quintic, x: f64) -> f64 {
    q[1] + x * (2.0 * q[2] + x * (3.0 * q[3] + x * (4.0 * q[4] + x * 5.0 * q[5])))
}

impl Segment {
    pub fn new(kernel: &Kernel, start: &Node, end: &Node) -> Segment {
        let step = end.value - start.value;
        // A step leaves its square over the sharpness, which between the nodes is not much less than at them.
        let groups = start.determinants.iter().chain(&end.determinants);
        let sharpness = groups.fold(1.0, |least: f64, [_, s]| least.min(s.sqrt())) / 4.0;
        let mut segment = Segment {
            from: start.value,
            to: end.value,
            sure: 0.5 * (UNIT_ROUNDOFF * sharpness).sqrt(),
            turns: Vec::new(),
            slides: Vec::new(),
        };
        for unknown in kernel.unknowns.iter().flatten() {
            match *unknown {
                Unknown::Spin(class) => {
                    // Cosine and sine, whose derivatives are ω J d and (α J − ω²) d of the direction d.
                    let of = |node: &Node| {
                        let direction = vector(&node.block.turns[class], 0);
                        let omega = node.block.omegas[class][0] * step;
                        let alpha = node.block.alphas[class][0] * step * step;
                        let across: Vector = quarter_turn(direction);
                        [
                            direction,
                            across * omega,
                            across * alpha - direction * (omega * omega),
                        ]
                    };
                    let (a, b) = (of(start), of(end));
                    let curve = [0, 1].map(|axis| quintic(a.map(|v| v[axis]), b.map(|v| v[axis])));
                    segment.turns.push((class, curve));
                }
                Unknown::Slide(slider) => {
                    let of = |node: &Node| {
                        let block = &node.block;
                        let (speed, second) =
                            (block.speeds[slider][0], block.accelerations[slider][0]);
                        [block.slides[slider][0], speed * step, second * step * step]
                    };
                    segment.slides.push((slider, quintic(of(start), of(end))));
                }
            }
        }
        segment
    }

    /// Whether all these values of the drive lie on it.
    #[inline(always)]
    pub fn holds<T: Number, const M: usize>(&self, drive: &[T; M]) -> bool {
        let inside = |value: f64| self.from <= value && value <= self.to;
        drive
            .iter()
            .all(|v| (0..T::LANES).all(|lane| inside(v.lane(lane))))
    }

    /// Sets the unknowns of `block` to those of the polynomials.
    #[inline(always)]
    pub fn predict<T: Number, const M: usize>(&self, drive: &[T; M], block: &mut Block<T, M>) {
        let scale = 1.0 / (self.to - self.from);
        let along = drive.map(|value| (value - T::splat(self.from)) * scale);
        for (class, [cosine, sine]) in &self.turns {
            block.turns[*class] = along.map(|x| {
                // The polynomials leave the unit circle by little.
                unit(Pair {
                    x: value(cosine, x),
                    y: value(sine, x),
                })
            });
        }
        for (slider, curve) in &self.slides {
            block.slides[*slider] = along.map(|x| value(curve, x));
        }
    }

    /// The rate of an unknown per unit of the drive, by the polynomials.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quintic_meets_both_ends() {
        // f(x) = x⁵ − 2 x³ + x has f = 0, f' = 1, f'' = 0 at 0 and f = 0, f' = 0, f'' = 8 at 1.
        let q = quintic([0.0, 1.0, 0.0], [0.0, 0.0, 8.0]);
        assert_eq!(q, [0.0, 1.0, 0.0, -2.0, 0.0, 1.0]);
        assert_eq!(slope(&q, 0.5), 1.0 - 6.0 * 0.25 + 5.0 * 0.0625);
    }
}
