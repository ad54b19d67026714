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
        if (reversed - expected).abs() < (off - expected).abs() { reversed } else { off }
    }

    /// A difference, of angles the shorter way round.
    pub fn turned(&self, difference: f64) -> f64 {
        if self.is_angle { difference - 360.0 * libm::round(difference / 360.0) } else { difference }
    }
}

/// A sum of costs, −2 ln of likelihoods, each the square of a normal deviate and the logarithm of its variance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cost {
    sum: f64,
    /// The variances multiplied, their logarithm not yet in the sum: logarithms take longest of all.
    product: f64,
}

impl Cost {
    pub const ZERO: Cost = Cost { sum: 0.0, product: 1.0 };

    pub fn add(&mut self, cost: f64) {
        self.sum += cost;
    }

    /// Adds that of a deviate, if nothing is cheaper: `variance` counts in that of its rounding. Whether it is added.
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

/// What a value costs that nothing explains.
#[derive(Clone, Copy, Debug)]
pub(super) struct Without {
    pub cost: f64,
    /// The square of the range in which the value could lie, in variances of its rounding.
    widest: f64,
}

/// Cost of a value that nothing explains, beyond the range in which it could lie: one of some hundred.
const UNEXPLAINED: f64 = 11.0;

impl Datum {
    /// What it costs if nothing explains it.
    pub fn without(&self) -> Without {
        let cost = self.range - libm::log(self.variance());
        Without { cost: cost + UNEXPLAINED, widest: libm::exp(cost) }
    }
}
use crate::construction::Sheet;
