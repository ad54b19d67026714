//! The mistakes that explain a drawing's values.

use super::mistakes::{Blank, Candidate, tell};
use super::verdict::{Judged, Verdict};

/// The best explanation of the values, and the others.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Diagnosis {
    /// The mistakes that explain the values and are probable; none where no value is off, or where no cause is probable.
    pub best: Explanation,
    /// Other explanations, less probable.
    pub others: Vec<Explanation>,
    /// Indices of the values that remain without an explanation.
    pub unexplained: Vec<usize>,
}

/// Mistakes that together explain the values.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Explanation {
    /// The mistakes, in the order of the construction.
    pub findings: Vec<Finding>,
    /// The probability that they were made, or others that the values alone cannot tell from them, from 0 to 1. An honest
    /// share is left for mistakes that the catalogue does not have. Without mistakes: the probability that none was made
    /// that the catalogue has.
    pub probability: f64,
    /// Whether the given values alone cannot tell it from the best one.
    pub is_alike: bool,
}

/// A mistake that was probably made.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Finding {
    /// The mistake, and where it was made.
    pub candidate: Candidate,
    /// Indices of the values that differ from the right ones because of the mistake and are consistent with it.
    pub follows: Vec<usize>,
    /// Indices of the values that the mistake would change and that are not as it would make them.
    pub(super) contradicts: Vec<usize>,
    /// Indices of the values in which the mistake itself was made: written otherwise than meant, or read from the wrong
    /// operation.
    pub written: Vec<usize>,
}

impl Diagnosis {
    /// No mistake is told; values that are off remain without an explanation.
    pub(super) fn none(values: &[Judged]) -> Diagnosis {
        Diagnosis {
            best: Explanation { findings: Vec::new(), probability: 1.0, is_alike: false },
            others: Vec::new(),
            unexplained: (0..values.len()).filter(|&i| values[i].verdict == Verdict::Off).collect(),
        }
    }
}

impl Finding {
    /// The values that the mistake changes, in the order of the construction.
    pub(super) fn changed(&self) -> Vec<usize> {
        let mut all: Vec<usize> =
            [&self.written, &self.follows, &self.contradicts].into_iter().flatten().copied().collect();
        all.sort_unstable();
        all
    }

    /// The first value that the mistake changes.
    pub(super) fn first(&self) -> Option<usize> {
        self.changed().first().copied()
    }

    /// The same place and the same consequences, but for an unknown cause; `name`: the first value that is wrong.
    pub(super) fn of_unknown_cause(&self, name: &str) -> Finding {
        let mut finding = self.clone();
        finding.candidate.told = tell::unknown(Blank::Quantity(name.to_owned()));
        finding
    }
}
