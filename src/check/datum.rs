//! Values as they are compared with predictions, and what an unlikely one costs.

use crate::sheet::Sheet;
/// A value of the form as it is compared with a prediction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Datum {
    /// The index of its entry.
    pub entry: usize,
    pub value: f64,
    /// Half a unit of its last digit.
    pub rounding: f64,
    /// Whether its sign is unknown.
    pub is_magnitude: bool,
    pub is_angle: bool,
    /// The plan in whose unit it is; `None` for lengths, angles and angular rates.
    pub sheet: Option<Sheet>,
    /// The range in which a value of this kind could lie.
    pub span: f64,
}

impl Datum {
    /// The variance of its rounding: errors are uniform up to half a unit of the last digit.
    pub fn variance(&self) -> f64 {
        self.rounding * self.rounding / 3.0
    }

    /// The value less the predicted one; where the sign is unknown, with the sign that brings this difference nearest
    /// to `expected`.
    pub fn off(&self, predicted: f64, expected: f64) -> f64 {
        let off = self.turned(self.value - predicted);
        if !self.is_magnitude {
            return off;
        }
        let reversed = -self.value - predicted;
        if (reversed - expected).abs() < (off - expected).abs() { reversed } else { off }
    }

    /// By how much two predictions differ as far as such a value shows it.
    pub fn seen_apart(&self, predicted: f64, other: f64) -> f64 {
        if self.is_magnitude { predicted.abs() - other.abs() } else { self.turned(predicted - other) }
    }

    /// A difference of two such values; of angles the shorter way round.
    pub fn turned(&self, difference: f64) -> f64 {
        if self.is_angle { difference - 360.0 * libm::round(difference / 360.0) } else { difference }
    }
}

/// A sum of costs, −2 ln of likelihoods: of a normal deviate its square over its variance, plus the logarithm of the
/// variance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cost {
    sum: f64,
    /// The product of variances whose logarithm is not in the sum yet: one logarithm of many is the quickest.
    product: f64,
}

impl Cost {
    pub const ZERO: Cost = Cost { sum: 0.0, product: 1.0 };

    pub fn add(&mut self, cost: f64) {
        self.sum += cost;
    }

    /// Adds the cost of a deviate, or that of an unexplained value where it is less; whether it is the deviate's.
    /// `square` is in variances of the deviate, `variance` in variances of the value's rounding.
    pub fn add_deviate(&mut self, square: f64, variance: f64, without: &Without) -> bool {
        let is_near = square <= UNEXPLAINED && variance <= without.widest;
        if !is_near && square + libm::log(variance) > without.cost {
            self.sum += without.cost;
            return false;
        }
        self.sum += square;
        self.product *= variance;
        if !(1e-200..1e200).contains(&self.product) {
            self.sum += libm::log(self.product);
            self.product = 1.0;
        }
        true
    }

    pub fn total(self) -> f64 {
        self.sum + libm::log(self.product)
    }
}

/// The cost of an unexplained value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Without {
    pub cost: f64,
    /// The square of the range in which the value could lie, over the variance of its rounding.
    widest: f64,
}

/// Cost of an unexplained value beyond that of the range in which it could lie: one value of some hundred is so.
const UNEXPLAINED: f64 = 11.0;

impl Datum {
    /// The cost of the value if nothing explains it.
    pub fn without(&self) -> Without {
        let cost = 2.0 * libm::log(self.span) - libm::log(self.variance());
        Without { cost: cost + UNEXPLAINED, widest: libm::exp(cost) }
    }
}
