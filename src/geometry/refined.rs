//! Iterative refinement: the unknowns of a linear system almost to the last digit, with bounds of their errors.

use super::ball::exact;
use super::{Ball, LinearSystem, Numbers, Verified};
use smallvec::{SmallVec, smallvec};

/// Unknowns with bounds of their errors.
pub type Balls = SmallVec<[Ball; 4]>;

/// Right sides of a system, or what unknowns leave of them.
pub trait Sides {
    /// In the order of the equations.
    fn numbers(&self) -> impl Iterator<Item = Ball>;
}

impl Sides for Vec<Ball> {
    fn numbers(&self) -> impl Iterator<Item = Ball> {
        self.iter().copied()
    }
}

/// The unknowns of a system for these right sides.
///
/// The residual of the solution is computed with twice the digits, the same factors give a correction, and so on
/// (Wilkinson 1963; Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §12.1). Each pass multiplies the
/// error by about u·condition. Refinement ends after a correction smaller than the part `last_correction` of the solution, or when
/// corrections no longer decrease. `correct` gives the correction for a residual, `left` what unknowns leave of the right sides.
pub fn refined<S: Sides>(
    verified: &Verified<'_>,
    sides: S,
    last_correction: f64,
    correct: impl Fn(&LinearSystem, &[f64]) -> Numbers,
    left: impl Fn(&S, &[Ball]) -> S,
) -> Balls {
    let system = verified.system();
    let mut solution: Balls = smallvec![Ball::default(); system.size_of()];
    let (mut rest, mut before) = (None, f64::INFINITY);
    loop {
        let here = rest.as_ref().unwrap_or(&sides);
        let right: Numbers = here.numbers().map(|x| x.high).collect();
        let correction = correct(system, &right);
        for (x, &more) in solution.iter_mut().zip(&correction) {
            *x = *x + exact(more);
        }
        let change = system.size(correction.iter().copied());
        let size = system.size(solution.iter().map(|x| x.high));
        // Corrections that no longer decrease are rounding.
        if change <= last_correction * size || change > 0.5 * before || !change.is_finite() {
            let uncertain: Numbers = here.numbers().map(Ball::error).collect();
            let errors = verified.error_bound(&correction, &right, &uncertain);
            for (x, error) in solution.iter_mut().zip(errors) {
                *x = x.widened(error);
            }
            return solution;
        }
        before = change;
        rest = Some(left(&sides, &solution));
    }
}
