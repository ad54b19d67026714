use super::Path;
use super::extreme::peak;
use super::reading::{End, Reading};
use super::samples::Sample;
use crate::kernel::InputKind;
use crate::quantity::{Asked, Kind};

/// Equal parts of the range at which a curve is looked at first.
pub(super) const PARTS: usize = 128;

/// What differs by less than this part of what is usual with these drives does not change.
const FLAT: f64 = 1e-6;

/// What differs by less than this part of itself is the same.
const SAME: f64 = 1e-9;

/// How much farther from its middle than it typically is a curve may be without counting as unbounded.
const WILD: f64 = 1e3;

/// How much farther than typical an unbounded curve is shown.
const SHOWN: f64 = 4.0;

/// A curve at first sight.
pub(super) struct Glance<'a> {
    pub asked: Vec<Asked>,
    pub reading: Reading<'a>,
    pub samples: Vec<Sample>,
    /// Lowest and highest value that are worth showing.
    pub window: [f64; 2],
    /// Whether it grows beyond all bounds, below and above.
    pub grows: [bool; 2],
    /// Its value where that is everywhere the same.
    pub constant: Option<f64>,
    /// What is nothing beside the usual size of such a quantity.
    nothing: f64,
}

impl<'a> Glance<'a> {
    /// A glance at a quantity by its samples over a range of the drive's value.
    pub fn new(path: &Path, range: [f64; 2], asked: Asked, reading: Reading<'a>, samples: Vec<Sample>) -> Self {
        let nothing = FLAT * natural(path, asked.kind());
        let mut glance = Glance {
            asked: vec![asked],
            reading,
            samples,
            window: [0.0; 2],
            grows: [false; 2],
            constant: None,
            nothing,
        };
        let [least, most] = hull(glance.samples.iter().filter_map(|s| s.1));
        if most - least <= nothing.max(SAME * most.abs().max(least.abs())) {
            let middle = 0.5 * (least + most);
            let value = if middle.abs() <= nothing { 0.0 } else { middle };
            glance.constant = Some(value);
            glance.window = [value; 2];
        } else {
            for (side, own) in range.into_iter().enumerate() {
                let end = path.end(side == 1).filter(|end| end.at == own);
                if let (Some(_), End::Grows(up)) = (end, glance.reading.ends[side]) {
                    glance.grows[usize::from(up)] = true;
                }
            }
            glance.frame(range);
        }
        glance
    }

    pub fn kind(&self) -> Kind {
        self.asked[0].kind()
    }

    /// Whether two quantities are of one kind and equal all along.
    pub fn equals(&self, other: &Glance) -> bool {
        let equal = |(a, b): (&Sample, &Sample)| match (a.1, b.1) {
            (Some(a), Some(b)) => (a - b).abs() <= self.nothing.max(SAME * a.abs()),
            (a, b) => a.is_none() && b.is_none(),
        };
        let mut pairs = self.samples.iter().zip(&other.samples);
        self.kind() == other.kind() && pairs.all(equal)
    }

    /// Finds the window, and poles within the range.
    fn frame(&mut self, [low, high]: [f64; 2]) {
        let (kind, samples, reading) = (self.kind(), &self.samples, &mut self.reading);
        let even = even(samples);
        // Rates are shown with their zero, angles and places without.
        let centre = if kind.is_rate() { 0.0 } else { median(even.iter().copied()) };
        let typical = median(even.iter().map(|y| (y - centre).abs())).max(self.nothing);
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let peaks = (0..samples.len()).filter_map(|i| peak(reading, samples, i, sign));
            let peaks: Vec<[f64; 2]> = peaks.collect();
            // An angle is bounded whatever happens.
            let wild = |p: &[f64; 2]| kind != Kind::Angle && (p[1] - centre) * sign > WILD * typical;
            self.grows[side] |= peaks.iter().any(wild);
            let grows = self.grows[side];
            let inner = |p: &&[f64; 2]| !grows || !wild(p) && p[0] > low && p[0] < high;
            let found = peaks.iter().filter(inner).map(|p| p[1]);
            let bound = hull(samples.iter().filter_map(|s| s.1))[side];
            // Where it grows without bound, as far as is typical or to its own end, whichever comes first.
            let shown = centre + sign * SHOWN * typical;
            let least = if grows && sign * shown < sign * bound { shown } else { bound };
            self.window[side] = found.fold(least, |a, b| if sign * b > sign * a { b } else { a });
        }
    }
}

/// How large a quantity of that kind is in a mechanism of this size with these drives.
fn natural(path: &Path, kind: Kind) -> f64 {
    let size = path.size();
    let inputs = path.kernel.inputs.iter().map(|input| match input.kind {
        InputKind::Turning { .. } => [input.rate.abs(), input.second.abs()],
        InputKind::Sliding { .. } => [input.rate.abs() / size, input.second.abs() / size],
    });
    let [first, second] = inputs.fold([0.0_f64; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
    let second = second.max(first * first);
    match kind {
        Kind::Angle => 360.0,
        Kind::AngularVelocity => first,
        Kind::AngularAcceleration => second,
        Kind::Position | Kind::Length => size,
        Kind::Velocity => first * size,
        Kind::Acceleration => second * size,
    }
}

/// Least and greatest of some numbers.
pub(super) fn hull(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    numbers.fold(none, |[low, high], y| [low.min(y), high.max(y)])
}

/// The middle one of some numbers.
fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

/// Values at equal steps of the drive, each that of the next sample.
fn even(samples: &[Sample]) -> Vec<f64> {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
        return Vec::new();
    };
    let step = (last.0 - first.0) / PARTS as f64;
    let at = |k: usize| {
        let x = first.0 + step * k as f64;
        let next = samples.partition_point(|s| s.0 < x);
        samples.get(next.min(samples.len() - 1))?.1
    };
    (0..=PARTS).filter_map(at).collect()
}
