//! How accurate the hand is that has drawn, measured and computed.

use super::model::{COMPUTING, GROUPS, TOGETHER};

/// Sizes of a hand's errors that are tried, in parts of the tolerance: from a blunt pencil to a drawing program.
pub(super) const SIZES: [f64; 13] = [4.0, 2.8, 2.0, 1.4, 1.0, 0.7, 0.5, 0.2, 0.05, 0.01, 2e-3, 2e-4, 1e-5];

/// Index in [`SIZES`] of the hand for which the tolerance is made.
pub(super) const CAREFUL: usize = 4;

/// Sizes of slips in computed numbers that are tried, in parts of [`SLIP`].
pub(super) const SLIPS: [f64; 3] = [0.0, 0.3, 1.0];

/// Limit of the relative errors of numbers computed carelessly, in per cent.
pub(super) const SLIP: f64 = 1.0;

/// Least size of a hand's errors, in parts of the tolerance; a drawing with smaller errors was not made by hand.
const BY_HAND: f64 = 0.04;

/// Cost of a hand whose errors of one kind are ten times smaller than the tolerance.
const BETTER: f64 = 1.2;

/// Cost of a hand whose errors are twice as large as the tolerance.
const WORSE: f64 = 9.0;

/// Cost of slips in computed numbers.
const SLIPPING: f64 = 6.0;

/// How accurate a hand is, and how it computes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hand {
    /// The size of its errors of each kind, in parts of the tolerance; of computed numbers, of [`SLIP`].
    pub errors: [f64; GROUPS],
    /// Which digits of a number it uses later.
    pub habit: Habit,
}

/// Which digits of a written number somebody uses in later operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Habit {
    /// Sometimes those that are written, sometimes all.
    Mixed,
    /// Those that are written.
    AsWritten,
    /// All digits of a calculator.
    AllDigits,
}

impl Hand {
    /// A hand whose errors of drawing and measuring are all of one size, and that computes without slips.
    pub fn alike(size: f64) -> Hand {
        let mut errors = [size; GROUPS];
        errors[TOGETHER] = 0.0;
        errors[COMPUTING] = 0.0;
        Hand { errors, habit: Habit::Mixed }
    }

    /// A hand whose errors are all so many times as large.
    pub fn times(mut self, factor: f64) -> Hand {
        self.errors.iter_mut().for_each(|size| *size *= factor);
        self
    }

    /// The size of its largest errors of drawing and measuring, in parts of the tolerance.
    pub fn worst(&self) -> f64 {
        self.errors[..COMPUTING].iter().copied().fold(0.0, f64::max)
    }

    /// Whether its errors are as large as those of drawings by hand.
    pub fn is_by_hand(&self) -> bool {
        self.errors[..COMPUTING].iter().all(|&s| s == 0.0 || s >= BY_HAND)
    }

    /// Its cost, −2 ln of its prior probability. A kind of errors of size zero is left out: it is not a better hand.
    pub fn cost(&self) -> f64 {
        let sizes = self.errors[..COMPUTING].iter().filter(|s| **s > 0.0);
        let better: f64 = sizes.map(|s| -BETTER * libm::log10(s.min(1.0))).sum();
        let worse = WORSE * libm::log2(self.worst().max(1.0));
        let slipping = if self.errors[COMPUTING] > 0.0 { SLIPPING } else { 0.0 };
        better + worse + slipping
    }
}
