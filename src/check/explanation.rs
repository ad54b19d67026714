//! The mistakes that explain a drawing's values.

use super::mistakes::Candidate;

/// The best explanation of the values, and the others.
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// The mistakes that explain the values best; none where nothing is to be explained or no mistake of the catalogue
    /// explains it.
    pub best: Explanation,
    /// Other explanations, less probable.
    pub others: Vec<Explanation>,
    /// Indices of the values that remain without an explanation.
    pub unexplained: Vec<usize>,
}

/// Mistakes that together explain the values.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// The mistakes, in the order of the construction.
    pub findings: Vec<Finding>,
    /// Its probability among all explanations that were tried, from 0 to 1.
    pub probability: f64,
    /// Whether the given values alone cannot tell it from the best one.
    pub is_alike: bool,
}

/// A mistake that was probably made.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The mistake, and where it was made.
    pub candidate: Candidate,
    /// Indices of the values that differ from the right ones because of the mistake and are consistent with it.
    pub follows: Vec<usize>,
    /// Indices of the values in which the mistake itself was made: written otherwise than meant, or read from the wrong
    /// operation.
    pub written: Vec<usize>,
}
