use super::reading::Reading;
use super::samples::{Sample, hull};

/// The part of a curve's height by which a local extreme may miss the extreme of all samples and still be looked at.
const NEARLY: f64 = 0.05;

/// The part of a curve's height by which extremes that count as equal may differ.
const EQUAL: f64 = 1e-9;

/// The part of the range below which two extremes are one.
const APART: f64 = 1e-6;

/// A greatest or least value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The drive's value.
    pub at: f64,
    /// The quantity's value; of a smooth curve to rounding.
    pub value: f64,
    /// Whether it is a greatest value.
    pub greatest: bool,
}

/// The places where a curve of that height is greatest, or least, each by itself in its surroundings and equal to the others.
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
    let rated = found.iter().map(|p| sign * p[1]);
    let best = rated.fold(f64::NEG_INFINITY, f64::max);
    found.retain(|p| best - sign * p[1] <= EQUAL * height);
    let [low, high] = hull(all().map(|p| p[0]));
    found.dedup_by(|b, a| b[0] - a[0] <= APART * (high - low));
    let extreme = |p: &[f64; 2]| Extreme {
        at: p[0],
        // What rounding leaves of a zero is none.
        value: if p[1].abs() <= EQUAL * height { 0.0 } else { p[1] },
        greatest,
    };
    found.iter().map(extreme).collect()
}

/// The local extreme that the sample of that index is nearest to; none if a neighbour is further out.
pub(super) fn peak(reading: &mut Reading, samples: &[Sample], index: usize, sign: f64) -> Option<[f64; 2]> {
    let (x, y) = samples[index];
    let y = y?;
    let last = samples.len() - 1;
    let (left, right) = (index.saturating_sub(1), (index + 1).min(last));
    let further = |i: usize, or_equal: bool| {
        let other = samples[i].1.map(|other| sign * (other - y));
        i != index && other.is_some_and(|d| d > 0.0 || or_equal && d == 0.0)
    };
    // Of equal neighbours the first is it.
    if further(left, true) || further(right, false) {
        return None;
    }
    let between = reading.peak([samples[left].0, samples[right].0], sign, y);
    let better = between.filter(|p| sign * (p[1] - y) > 0.0);
    Some(better.unwrap_or([x, y]))
}
