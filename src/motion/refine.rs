use super::ClosedForm;
use super::errors::guide_error;
use super::sides::{Balls, Sides, residuals};
use crate::geometry::{Ball, LinearSystem, Numbers, UNIT_ROUNDOFF, Vector, quarter_turn};
use crate::mechanism::{LoopEquations, SlideRate, Spin};
use crate::position::Pose;
use smallvec::smallvec;

/// Solves a group's loop equations almost to the last digit by iterative refinement.
///
/// The residual of the solution is computed with twice the digits, the same factors give a correction, and so on
/// (Wilkinson 1963; Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §12.1). Each pass multiplies the
/// error by about u·condition.
pub(super) struct Solver<'a> {
    equations: &'a LoopEquations,
    system: &'a LinearSystem,
    pose: &'a Pose,
    closed: Option<ClosedForm>,
    /// Refinement ends after a correction smaller than this part of the solution.
    last_correction: f64,
}

impl<'a> Solver<'a> {
    pub fn new(equations: &'a LoopEquations, system: &'a LinearSystem, pose: &'a Pose) -> Self {
        // A correction δ leaves an error of about u·condition·δ. The error of the velocities enters the accelerations
        // multiplied by the condition once more, and should stay some bits below the last digit.
        let condition = system.condition();
        Self {
            equations,
            system,
            pose,
            closed: ClosedForm::new(equations, &pose.points, &pose.guides),
            last_correction: 1.0 / (16.0 * condition * condition),
        }
    }

    /// The unknowns for these right sides, with bounds of their errors.
    pub fn solve(&self, sides: &Sides) -> Balls {
        let mut solution: Balls = smallvec![Ball::default(); self.equations.unknowns];
        let mut rest = sides.clone();
        let mut before = f64::INFINITY;
        loop {
            let right: Numbers = rest.numbers().map(|x| x.high).collect();
            let correction = match &self.closed {
                Some(form) => form.solve_all(&right),
                None => self.system.solve(&right),
            };
            for (x, &more) in solution.iter_mut().zip(&correction) {
                *x = *x + more.into();
            }
            let change = self.system.size(correction.iter().copied());
            let size = self.system.size(solution.iter().map(|x| x.high));
            // Corrections that no longer decrease are rounding.
            if change <= self.last_correction * size || change > 0.5 * before || !change.is_finite() {
                self.widen(&mut solution, &rest, &correction);
                return solution;
            }
            before = change;
            rest = residuals(self.equations, self.pose, sides, &solution);
        }
    }

    /// Widens the solution by the bounds of its errors after the last `correction`, found for the residual `rest`.
    fn widen(&self, solution: &mut Balls, rest: &Sides, correction: &[f64]) {
        let right: Numbers = rest.numbers().map(|x| x.high).collect();
        let mut uncertain: Numbers = rest.numbers().map(Ball::error).collect();
        self.add_coefficient_errors(&mut uncertain, correction);
        let errors = self.system.error_bound(correction, &right, &uncertain);
        for (x, error) in solution.iter_mut().zip(errors) {
            *x = x.widened(error);
        }
    }

    /// Adds the effect of rounded coefficients: their errors times the correction.
    fn add_coefficient_errors(&self, uncertain: &mut Numbers, correction: &[f64]) {
        for (terms, uncertain) in self.equations.loops.iter().zip(uncertain.chunks_mut(2)) {
            let mut add = |v: Vector| {
                uncertain[0] += v.x.abs();
                uncertain[1] += v.y.abs();
            };
            for arm in &terms.arms {
                if let Spin::Unknown(unknown) = arm.spin {
                    // One rounding for the difference of two places, one for each further arm of the same rotation.
                    let alike = terms.arms.iter().filter(|other| other.spin == arm.spin);
                    let error = alike.count() as f64 * UNIT_ROUNDOFF * correction[unknown];
                    add(quarter_turn(self.pose.arm(arm.from, arm.to)) * error);
                }
            }
            for slide in &terms.slides {
                if let SlideRate::Unknown(unknown) = slide.rate {
                    let u = self.pose.guide(slide.slider);
                    add(u * (guide_error(u) * correction[unknown]));
                }
            }
        }
    }
}
