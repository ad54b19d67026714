use super::Path;
use super::extreme::peak;
use super::reading::{End, Reading};
use super::samples::{Sample, hull};
use crate::kernel::InputKind;
use crate::quantity::{QuantityKind, QuantityRequest};

/// Equal parts of the range at which a curve is sampled first.
pub(super) const PARTS: usize = 128;

/// A curve whose values spread by less than this part of [`typical_size`] is constant.
const FLAT: f64 = 1e-6;

/// Relative difference of values that count as equal.
const SAME: f64 = 1e-9;

/// A peak this many times further from the centre than the median value counts as unbounded.
const UNBOUNDED: f64 = 1e3;

/// An unbounded curve is shown up to this many times the median distance from the centre.
const SHOWN: f64 = 4.0;

/// Results of a first coarse sampling of a curve: whether it is constant, where it is unbounded, and which values to
/// show.
pub(super) struct CurveSurvey<'a> {
    pub asked: Vec<QuantityRequest>,
    pub reading: Reading<'a>,
    pub samples: Vec<Sample>,
    /// Lowest and highest value to be shown.
    pub window: [f64; 2],
    /// Whether it grows without bound, downwards and upwards.
    pub grows: [bool; 2],
    /// The value of a constant curve.
    pub constant: Option<f64>,
    /// Absolute tolerance for zero.
    zero: f64,
}

impl<'a> CurveSurvey<'a> {
    /// The survey of a quantity, from its samples over a range of the drive's value.
    pub fn new(
        path: &Path,
        range: [f64; 2],
        asked: QuantityRequest,
        reading: Reading<'a>,
        samples: Vec<Sample>,
    ) -> Self {
        let zero = FLAT * typical_size(path, asked.kind());
        let mut survey = CurveSurvey {
            asked: vec![asked],
            reading,
            samples,
            window: [0.0; 2],
            grows: [false; 2],
            constant: None,
            zero,
        };
        let [least, most] = hull(survey.samples.iter().filter_map(|s| s.1));
        if most - least <= zero.max(SAME * most.abs().max(least.abs())) {
            let middle = 0.5 * (least + most);
            let value = if middle.abs() <= zero { 0.0 } else { middle };
            survey.constant = Some(value);
            survey.window = [value; 2];
        } else {
            for (side, own) in range.into_iter().enumerate() {
                let end = path.end(side == 1).filter(|end| end.at == own);
                if let (Some(_), End::Grows(up)) = (end, survey.reading.ends[side]) {
                    survey.grows[usize::from(up)] = true;
                }
            }
            survey.frame(range);
        }
        survey
    }

    pub fn kind(&self) -> QuantityKind {
        self.asked[0].kind()
    }

    /// Whether two quantities are of one kind and equal at all samples.
    pub fn equals(&self, other: &CurveSurvey) -> bool {
        let equal = |(a, b): (&Sample, &Sample)| match (a.1, b.1) {
            (Some(a), Some(b)) => (a - b).abs() <= self.zero.max(SAME * a.abs()),
            (a, b) => a.is_none() && b.is_none(),
        };
        let mut pairs = self.samples.iter().zip(&other.samples);
        self.kind() == other.kind() && pairs.all(equal)
    }

    /// Finds the window, and where the curve grows without bound within the range.
    fn frame(&mut self, [low, high]: [f64; 2]) {
        let (kind, samples, reading) = (self.kind(), &self.samples, &mut self.reading);
        let even = even(samples);
        // The window of a rate includes zero, that of an angle or a place need not.
        let centre = if kind.is_rate() { 0.0 } else { median(even.iter().copied()) };
        let typical = median(even.iter().map(|y| (y - centre).abs())).max(self.zero);
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let peaks: Vec<[f64; 2]> = (0..samples.len()).filter_map(|i| peak(reading, samples, i, sign)).collect();
            // An angle is always bounded.
            let unbounded = |p: &[f64; 2]| kind != QuantityKind::Angle && (p[1] - centre) * sign > UNBOUNDED * typical;
            self.grows[side] |= peaks.iter().any(unbounded);
            let grows = self.grows[side];
            let inner = |p: &&[f64; 2]| !grows || !unbounded(p) && p[0] > low && p[0] < high;
            let found = peaks.iter().filter(inner).map(|p| p[1]);
            let bound = hull(samples.iter().filter_map(|s| s.1))[side];
            // An unbounded curve is shown up to a typical distance or to its own last sample, whichever is nearer.
            let shown = centre + sign * SHOWN * typical;
            let least = if grows && sign * shown < sign * bound { shown } else { bound };
            self.window[side] = found.fold(least, |a, b| if sign * b > sign * a { b } else { a });
        }
    }
}

/// The order of magnitude of a quantity of that kind in a mechanism of this size with these drives.
fn typical_size(path: &Path, kind: QuantityKind) -> f64 {
    let size = path.size();
    let inputs = path.kernel.inputs.iter().map(|input| match input.kind {
        InputKind::Turning { .. } => [input.rate.abs(), input.second.abs()],
        InputKind::Sliding { .. } => [input.rate.abs() / size, input.second.abs() / size],
    });
    let [first, second] = inputs.fold([0.0_f64; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
    let second = second.max(first * first);
    match kind {
        QuantityKind::Angle => 360.0,
        QuantityKind::AngularVelocity => first,
        QuantityKind::AngularAcceleration => second,
        QuantityKind::Position | QuantityKind::Length => size,
        QuantityKind::Velocity => first * size,
        QuantityKind::Acceleration => second * size,
    }
}

/// The median of some numbers, of an even count the upper of the two in the middle; zero of none.
fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

/// Values at equal steps of the drive, each taken from the next sample.
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
