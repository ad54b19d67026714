use super::ClosedForm;
use super::errors::guide_error;
use super::sides::{Balls, Sides, residuals};
use crate::geometry::{Ball, LinearSystem, Numbers, UNIT_ROUNDOFF, Vector, quarter_turn};
use crate::mechanism::{LoopEquations, SlideRate, Spin};
use crate::position::Pose;
use smallvec::smallvec;

/// Solves a group's loop equations to about the last digit by iterative refinement.
///
/// What the solution leaves of the right side is computed with twice the digits, with the same factors that gives a correction, and so on
/// (Wilkinson 1963; Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §12.1). Each pass makes the error about u·condition
/// times smaller.
pub(super) struct Solver<'a> {
    equations: &'a LoopEquations,
    system: &'a LinearSystem,
    pose: &'a Pose,
    closed: Option<ClosedForm>,
    /// A correction that is smaller than this part of the solution is the last.
    last: f64,
}

impl<'a> Solver<'a> {
    pub fn new(equations: &'a LoopEquations, system: &'a LinearSystem, pose: &'a Pose) -> Self {
        // After a correction δ an error of about u·condition·δ is left. Accelerations enlarge that of velocities by the condition once
        // more, and it should still be some binary digits below the last.
        let condition = system.condition();
        Self {
            equations,
            system,
            pose,
            closed: ClosedForm::new(equations, &pose.points, &pose.guides),
            last: 1.0 / (16.0 * condition * condition),
        }
    }

    /// The unknowns for these right sides, with bounds of their errors.
    pub fn solve(&self, sides: &Sides) -> Balls {
        let mut solution: Balls = smallvec![Ball::default(); self.equations.unknowns];
        let mut rest = sides.clone();
        let mut before = f64::INFINITY;
        loop {
            let right: Numbers = components(&rest).map(|x| x.high).collect();
            let correction = match &self.closed {
                Some(form) => form.solve_all(&right),
                None => self.system.solve(&right),
            };
            for (x, &more) in solution.iter_mut().zip(&correction) {
                *x = *x + more.into();
            }
            let change = self.system.size(correction.iter().copied());
            let size = self.system.size(solution.iter().map(|x| x.high));
            // Where corrections do not shrink any more, this is all that can be had.
            if change <= self.last * size || change > 0.5 * before || !change.is_finite() {
                self.bound(&mut solution, &rest, &correction);
                return solution;
            }
            before = change;
            rest = residuals(self.equations, self.pose, sides, &solution);
        }
    }

    /// Adds the bounds of the errors after the last correction, which has been found for the right side `rest`.
    fn bound(&self, solution: &mut Balls, rest: &Sides, correction: &[f64]) {
        let right: Numbers = components(rest).map(|x| x.high).collect();
        let mut uncertain: Numbers = components(rest).map(Ball::error).collect();
        self.doubt_coefficients(&mut uncertain, correction);
        let errors = self.system.error_bound(correction, &right, &uncertain);
        for (x, error) in solution.iter_mut().zip(errors) {
            *x = x.widened(error);
        }
    }

    /// Adds what the rounding of the equations' coefficients makes of the correction.
    fn doubt_coefficients(&self, uncertain: &mut Numbers, correction: &[f64]) {
        for (terms, uncertain) in self.equations.loops.iter().zip(uncertain.chunks_mut(2)) {
            let mut doubt = |v: Vector| {
                uncertain[0] += v.x.abs();
                uncertain[1] += v.y.abs();
            };
            for arm in &terms.arms {
                if let Spin::Unknown(unknown) = arm.spin {
                    // One rounding as a difference of places, one for each further arm of the same rotation.
                    let alike = terms.arms.iter().filter(|other| other.spin == arm.spin);
                    let error = alike.count() as f64 * UNIT_ROUNDOFF * correction[unknown];
                    doubt(quarter_turn(self.pose.arm(arm.from, arm.to)) * error);
                }
            }
            for slide in &terms.slides {
                if let SlideRate::Unknown(unknown) = slide.rate {
                    let u = self.pose.guide(slide.slider);
                    doubt(u * (guide_error(u) * correction[unknown]));
                }
            }
        }
    }
}

fn components(sides: &Sides) -> impl Iterator<Item = Ball> {
    sides.iter().flat_map(|side| [side.x, side.y])
}
