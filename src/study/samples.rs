//! Values of one quantity at equal steps of the drive; NaN where it has none.

/// The mean over the drive's values by the trapezoidal rule, which for a whole turn is exact but for the harmonics that the steps do not
/// resolve.
pub(super) fn mean(samples: &[f64]) -> Option<f64> {
    let [first, .., last] = samples else {
        return samples.first().copied().filter(|y| y.is_finite());
    };
    let sum: f64 = samples.iter().sum::<f64>() - 0.5 * (first + last);
    Some(sum / (samples.len() - 1) as f64).filter(|mean| mean.is_finite())
}

/// Adds whole turns to angles in degrees, so that they run on without jumps.
pub(super) fn unwrap(samples: &mut [f64]) {
    let mut last = f64::NAN;
    for sample in samples {
        if last.is_finite() {
            *sample = near(*sample, last);
        }
        if sample.is_finite() {
            last = *sample;
        }
    }
}

/// The angle in degrees plus the whole turns that bring it nearest to another.
pub(super) fn near(angle: f64, other: f64) -> f64 {
    angle + 360.0 * ((other - angle) / 360.0).round()
}
