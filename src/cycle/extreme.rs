use super::reading::Reading;
use super::samples::{Sample, hull};

/// Distance from the extreme of all samples within which a sample's neighbourhood is searched, in parts of the curve's
/// height.
const NEARLY: f64 = 0.05;

/// Difference of two extremes that count as equal, in parts of the curve's height.
const EQUAL: f64 = 1e-9;

/// Distance of two extremes that count as one, in parts of the range.
const APART: f64 = 1e-6;

/// A greatest or least value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The drive's value.
    pub at: f64,
    /// The quantity's value; exact to rounding where the curve is smooth.
    pub value: f64,
    /// Whether it is a greatest value; else a least one.
    pub greatest: bool,
}

/// The places where a curve of that height is greatest, or least; several where the values there are equal.
pub(super) fn extremes(reading: &mut Reading, pieces: &[Vec<[f64; 2]>], height: f64, greatest: bool) -> Vec<Extreme> {
    let sign = if greatest { 1.0 } else { -1.0 };
    let all = || pieces.iter().flatten();
    let best = hull(all().map(|p| p[1]))[usize::from(greatest)];
    let mut found: Vec<[f64; 2]> = Vec::new();
    for piece in pieces {
        let samples: Vec<Sample> = piece.iter().map(|p| (p[0], Some(p[1]))).collect();
        for (index, [_, value]) in piece.iter().enumerate() {
            if sign * (best - value) <= NEARLY * height {
                found.extend(peak(reading, &samples, index, sign));
            }
        }
    }
    let best = found.iter().map(|p| sign * p[1]).fold(f64::NEG_INFINITY, f64::max);
    found.retain(|p| best - sign * p[1] <= EQUAL * height);
    let [low, high] = hull(all().map(|p| p[0]));
    found.dedup_by(|b, a| b[0] - a[0] <= APART * (high - low));
    let extreme = |p: &[f64; 2]| Extreme {
        at: p[0],
        // A zero with rounding errors is written as zero.
        value: if p[1].abs() <= EQUAL * height { 0.0 } else { p[1] },
        greatest,
    };
    found.iter().map(extreme).collect()
}

/// The local extreme next to the sample of that index; `None` if a neighbour of the sample lies further out.
pub(super) fn peak(reading: &mut Reading, samples: &[Sample], index: usize, sign: f64) -> Option<[f64; 2]> {
    let (x, y) = samples[index];
    let y = y?;
    let last = samples.len() - 1;
    let (left, right) = (index.saturating_sub(1), (index + 1).min(last));
    let further = |i: usize, or_equal: bool| {
        let other = samples[i].1.map(|other| sign * (other - y));
        i != index && other.is_some_and(|d| d > 0.0 || or_equal && d == 0.0)
    };
    // Of equal neighbours the first counts.
    if further(left, true) || further(right, false) {
        return None;
    }
    let between = reading.peak([samples[left].0, samples[right].0], sign, y);
    Some(between.filter(|p| sign * (p[1] - y) > 0.0).unwrap_or([x, y]))
}
