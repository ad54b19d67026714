use crate::drafting::Sheet;

/// A value as it enters the comparison.
#[derive(Clone, Copy, Debug)]
pub(super) struct Datum {
    /// The entry.
    pub entry: usize,
    pub value: f64,
    pub rounding: f64,
    /// Whether its sense is unknown.
    pub is_magnitude: bool,
    pub is_angle: bool,
    /// The plan in whose unit it is; none of rates of rotation and angles.
    pub sheet: Option<Sheet>,
    /// ln of the square of the range in which a value of this kind could lie.
    pub range: f64,
}

impl Datum {
    /// The variance of its rounding: every error up to half a unit of the last digit is equally likely.
    pub fn variance(&self) -> f64 {
        self.rounding * self.rounding / 3.0
    }

    /// How far it is from what is predicted; where no sense is known, in the sense in which it comes nearest to what is `expected` of that.
    pub fn off(&self, predicted: f64, expected: f64) -> f64 {
        let off = self.turned(self.value - predicted);
        if !self.is_magnitude {
            return off;
        }
        let reversed = -self.value - predicted;
        if (reversed - expected).abs() < (off - expected).abs() {
            reversed
        } else {
            off
        }
    }

    /// A difference, of angles the shorter way round.
    pub fn turned(&self, difference: f64) -> f64 {
        if self.is_angle {
            difference - 360.0 * libm::round(difference / 360.0)
        } else {
            difference
        }
    }
}
