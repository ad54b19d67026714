//! What equally spaced values of one quantity tell: their mean, and where between them it is greatest. NaN stands where it has none.

use crate::geometry::with_turns;

/// Newton steps for the vertex of a quartic; the parabola's is near.
const STEPS: usize = 4;

/// Halvings of a step in the search for a zero: a small part of it is nothing in an integral that is greatest there.
const HALVINGS: usize = 30;

/// The mean over the drive's values by the trapezoidal rule, which for a whole turn is exact but for the harmonics that the steps do not
/// resolve.
pub(super) fn mean(samples: &[f64]) -> Option<f64> {
    let [first, .., last] = samples else {
        return samples.first().copied().filter(|y| y.is_finite());
    };
    let sum: f64 = samples.iter().sum::<f64>() - 0.5 * (first + last);
    Some(sum / (samples.len() - 1) as f64).filter(|mean| mean.is_finite())
}

/// How far the integral of the samples less their mean goes up and down over the drive, `step` from one sample to the next: of a torque
/// the work that a flywheel takes in and gives back (R. L. Norton, *Design of Machinery*, "flywheels"). Between two samples
/// by the cubic through these and their neighbours; of a periodic quantity the last sample is the first one. `None` with
/// fewer than four samples, or where one has no value.
pub(super) fn fluctuation(samples: &[f64], step: f64, periodic: bool) -> Option<f64> {
    let count = samples.len();
    if count < 4 || samples.iter().any(|y| !y.is_finite()) {
        return None;
    }
    let at = |sample: i64| samples[if periodic { sample.rem_euclid(count as i64 - 1) } else { sample } as usize];
    let piece = |sample: i64| {
        let last = count as i64 - 4;
        let first = if periodic { sample - 1 } else { (sample - 1).clamp(0, last) };
        Cubic { values: [0, 1, 2, 3].map(|k| at(first + k)), from: (first - sample) as f64 }
    };
    let pieces = || (0..count as i64 - 1).map(piece);
    let mean = pieces().map(|cubic| cubic.integral(1.0)).sum::<f64>() / (count - 1) as f64;
    let (mut sum, mut lowest, mut highest) = (0.0, 0.0_f64, 0.0_f64);
    for cubic in pieces().map(|cubic| cubic.above(mean)) {
        let [left, right] = [cubic.at(0.0), cubic.at(1.0)];
        // It is greatest and least where the quantity is at its mean.
        let turning = (left * right < 0.0).then(|| cubic.zero(left));
        for part in turning.into_iter().chain([1.0]) {
            let there = sum + cubic.integral(part);
            (lowest, highest) = (lowest.min(there), highest.max(there));
        }
        sum += cubic.integral(1.0);
    }
    Some((highest - lowest) * step)
}

/// The cubic through four samples, one step apart from `from` on.
struct Cubic {
    values: [f64; 4],
    from: f64,
}

impl Cubic {
    fn above(self, mean: f64) -> Cubic {
        Cubic { values: self.values.map(|y| y - mean), ..self }
    }

    /// By Newton's forward differences.
    fn at(&self, t: f64) -> f64 {
        let [a, b, c, d] = self.values;
        let s = t - self.from;
        let [first, second, third] = [b - a, c - 2.0 * b + a, d - 3.0 * c + 3.0 * b - a];
        a + s * (first + (s - 1.0) / 2.0 * (second + (s - 2.0) / 3.0 * third))
    }

    /// From 0 to `end`, by Gauss's rule of two points, which is exact for cubics.
    fn integral(&self, end: f64) -> f64 {
        let off = 0.5 / 3.0_f64.sqrt();
        0.5 * end * (self.at(end * (0.5 - off)) + self.at(end * (0.5 + off)))
    }

    /// A zero between 0, where it has the sign of `left`, and 1, where it has the other.
    fn zero(&self, left: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.at(middle) * left > 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

/// Adds whole turns to angles in degrees, so that they run on without jumps.
pub(super) fn unwrap(samples: &mut [f64]) {
    let mut last = f64::NAN;
    for sample in samples {
        if last.is_finite() {
            *sample = with_turns(*sample, last);
        }
        if sample.is_finite() {
            last = *sample;
        }
    }
}

/// Samples of a smooth quantity.
pub(super) struct Spaced<'a> {
    pub values: &'a [f64],
    /// 1 for greatest values, −1 for least ones.
    pub sign: f64,
    /// Whether the last sample is the first one, a turn later.
    pub periodic: bool,
}

/// A place between samples: the sample next to it with its value, and the distance from that in steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub sample: usize,
    pub value: f64,
    pub beyond: f64,
}

impl Spaced<'_> {
    /// The place of the greatest value, from the quartics through five samples each; at ends from parabolas. `None` where a sample has no
    /// value.
    pub fn peak(&self) -> Option<Spot> {
        // Counted to the end, so that the compiler uses registers of many.
        if !self.values.iter().fold(true, |all, y| all & y.is_finite()) {
            return None;
        }
        let mut best: Option<(usize, [f64; 2])> = None;
        let mut take = |sample: usize| {
            let vertex = self.vertex(sample);
            // Of equal ones the last counts.
            if best.is_none_or(|(_, other)| vertex[1].total_cmp(&other[1]).is_ge()) {
                best = Some((sample, vertex));
            }
        };
        if self.is_local(0) {
            take(0);
        }
        // Between the ends each has both neighbours.
        for (before, w) in self.values.windows(3).enumerate() {
            if self.sign * w[1] > self.sign * w[0] && self.sign * w[1] >= self.sign * w[2] {
                take(before + 1);
            }
        }
        let last = self.values.len() - 1;
        if last > 0 && !self.periodic && self.is_local(last) {
            take(last);
        }
        best.map(|(sample, [beyond, _])| Spot { sample, value: self.values[sample], beyond })
    }

    /// A sample by its place, which may lie beyond the ends of a period.
    fn at(&self, place: isize) -> Option<f64> {
        let count = self.values.len() as isize;
        let place = if self.periodic { place.rem_euclid(count - 1) } else { place };
        usize::try_from(place).ok().and_then(|place| self.values.get(place)).map(|y| self.sign * y)
    }

    /// Whether the value at an end is greater than those beside it.
    fn is_local(&self, k: usize) -> bool {
        let k = k as isize;
        let own = self.at(k);
        // Of equal neighbours the first counts.
        self.at(k - 1).is_none_or(|y| own > Some(y)) && self.at(k + 1).is_none_or(|y| own >= Some(y))
    }

    /// The vertex next to a sample: its distance in steps, and the value there.
    fn vertex(&self, k: usize) -> [f64; 2] {
        let k = k as isize;
        let Some(y) = self.at(k) else {
            return [0.0, f64::NEG_INFINITY];
        };
        let (Some(before), Some(after)) = (self.at(k - 1), self.at(k + 1)) else {
            return self.end(k, y);
        };
        let slope = 0.5 * (after - before);
        let bend = after - 2.0 * y + before;
        let (slope, bend, third, fourth) = match (self.at(k - 2), self.at(k + 2)) {
            (Some(first), Some(last)) => (
                (first - 8.0 * before + 8.0 * after - last) / 12.0,
                (16.0 * (before + after) - first - last - 30.0 * y) / 12.0,
                0.5 * (last - 2.0 * after + 2.0 * before - first),
                first - 4.0 * before + 6.0 * y - 4.0 * after + last,
            ),
            _ => (slope, bend, 0.0, 0.0),
        };
        let mut t = if bend < 0.0 { (-slope / bend).clamp(-1.0, 1.0) } else { 0.0 };
        for _ in 0..STEPS {
            let rate = slope + t * (bend + t * (third / 2.0 + t * fourth / 6.0));
            let by = bend + t * (third + t * fourth / 2.0);
            if by < 0.0 {
                t = (t - rate / by).clamp(-1.0, 1.0);
            }
        }
        [t, y + t * (slope + t * (bend / 2.0 + t * (third / 6.0 + t * fourth / 24.0)))]
    }

    /// The vertex next to an end: that of the parabola through the three samples there, if it lies between them.
    fn end(&self, k: isize, y: f64) -> [f64; 2] {
        let inward = if k == 0 { 1 } else { -1 };
        let (Some(next), Some(third)) = (self.at(k + inward), self.at(k + 2 * inward)) else {
            return [0.0, y];
        };
        let bend = third - 2.0 * next + y;
        let slope = next - y - bend / 2.0;
        if slope <= 0.0 || bend >= 0.0 {
            return [0.0, y];
        }
        let t = (-slope / bend).min(1.0);
        [t * inward as f64, y + t * (slope + t * bend / 2.0)]
    }
}
