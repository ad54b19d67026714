//! What explains values.

use super::mistakes::Candidate;

/// What explains the values.
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// The mistakes that explain them best, in the order of the construction; none where nothing is to be explained or nothing in the
    /// catalogue does.
    pub best: Explanation,
    /// What explains them, too, less surely.
    pub others: Vec<Explanation>,
    /// The values, by their places in the list, that remain without an explanation.
    pub unexplained: Vec<usize>,
}

/// Mistakes that explain values together.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// The mistakes, in the order of the construction.
    pub findings: Vec<Finding>,
    /// How sure it is among all explanations that were tried, from 0 to 1.
    pub probability: f64,
    /// Whether it is here because the given values alone cannot tell it from the best one.
    pub is_alike: bool,
}

/// A mistake that was probably made.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The mistake, and where it was made.
    pub candidate: Candidate,
    /// Values, by their places in the list, that differ from the right ones because of it and are consistent with it.
    pub follows: Vec<usize>,
    /// Values that it touches itself: written otherwise than meant, or read where it was made.
    pub written: Vec<usize>,
}
