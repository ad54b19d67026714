use super::BodyMotion;
use crate::geometry::{Numbers, UNIT_ROUNDOFF, Vector, quarter_turn};
use crate::mechanism::{LoopEquations, LoopTerms, SlideRate, Spin};
use crate::position::Pose;

/// The right side of one loop's equations: a vector, and how uncertain rounding has left it.
#[derive(Clone, Copy, Debug)]
pub struct LoopSide {
    /// The sum of the known terms.
    pub value: Vector,
    /// Bounds of the errors of its components.
    pub uncertain: Vector,
}

/// The right sides of all loops, two numbers each, with bounds of their errors.
#[derive(Clone, Debug)]
pub struct RightSide {
    /// The two components for each loop.
    pub value: Numbers,
    /// Bounds of their errors.
    pub uncertain: Numbers,
}

impl RightSide {
    /// The right side of the velocity equations.
    #[must_use]
    pub fn velocity(equations: &LoopEquations, pose: &Pose, known: &[BodyMotion]) -> Self {
        let loops = equations.loops.iter();
        Self::of(loops.map(|terms| LoopSide::velocity(terms, pose, known)))
    }

    /// The right side of the acceleration equations, with the solution `rates` of the velocity equations.
    ///
    /// `rate_errors` bounds the errors of `rates`, which make this side uncertain.
    #[must_use]
    pub fn acceleration(
        equations: &LoopEquations,
        pose: &Pose,
        known: &[BodyMotion],
        rates: &[f64],
        rate_errors: &[f64],
    ) -> Self {
        let loops = equations.loops.iter();
        Self::of(loops.map(|t| LoopSide::acceleration(t, pose, known, rates, rate_errors)))
    }

    fn of(loops: impl Iterator<Item = LoopSide>) -> Self {
        let (mut value, mut uncertain) = (Numbers::new(), Numbers::new());
        for side in loops {
            value.extend([side.value.x, side.value.y]);
            uncertain.extend([side.uncertain.x, side.uncertain.y]);
        }
        Self { value, uncertain }
    }
}

impl LoopSide {
    /// The right side of a loop's velocity equations.
    #[inline]
    #[must_use]
    pub fn velocity(terms: &LoopTerms, pose: &Pose, known: &[BodyMotion]) -> Self {
        let mut side = Self::zero();
        if let Some([start, end]) = terms.ends.map(|ends| ends.map(|b| &known[b.0])) {
            let (first, last) = (pose.point(terms.first), pose.point(terms.last));
            side.add(end.velocity - start.velocity, 1.0);
            side.add(end.swing(last), 3.0);
            side.add(-start.swing(first), 3.0);
        }
        for arm in &terms.arms {
            if let Spin::Known(body) = arm.spin {
                let turned = quarter_turn(pose.arm(arm.from, arm.to));
                side.add(-turned * known[body.0].omega, 2.0);
            }
        }
        for slide in &terms.slides {
            if let SlideRate::Driven([speed, _]) = slide.rate {
                let u = pose.guide(slide.slider) * slide.sign;
                side.add(-u * speed, 1.0);
            }
        }
        side
    }

    /// The right side of a loop's acceleration equations, with the solution `rates` of the velocity equations.
    ///
    /// `rate_errors` bounds the errors of `rates`.
    #[inline]
    #[must_use]
    pub fn acceleration(
        terms: &LoopTerms,
        pose: &Pose,
        known: &[BodyMotion],
        rates: &[f64],
        rate_errors: &[f64],
    ) -> Self {
        let mut side = Self::zero();
        if let Some([start, end]) = terms.ends.map(|ends| ends.map(|b| &known[b.0])) {
            let (first, last) = (pose.point(terms.first), pose.point(terms.last));
            side.add(end.acceleration - start.acceleration, 1.0);
            side.add(end.tangential(last), 3.0);
            side.add(end.normal(last), 4.0);
            side.add(-start.tangential(first), 3.0);
            side.add(-start.normal(first), 4.0);
        }
        for arm in &terms.arms {
            let r = pose.arm(arm.from, arm.to);
            match arm.spin {
                Spin::Unknown(unknown) => {
                    let omega = rates[unknown];
                    side.add(r * (omega * omega), 3.0);
                    side.doubt(r * (2.0 * omega.abs() * rate_errors[unknown]));
                }
                Spin::Known(body) => {
                    let body = &known[body.0];
                    side.add(-quarter_turn(r) * body.alpha, 2.0);
                    side.add(r * (body.omega * body.omega), 3.0);
                }
            }
        }
        for slide in &terms.slides {
            let u = pose.guide(slide.slider) * slide.sign;
            let omega = match slide.spin {
                Spin::Unknown(unknown) => rates[unknown],
                Spin::Known(body) => known[body.0].omega,
            };
            let rate = match slide.rate {
                SlideRate::Unknown(unknown) => rates[unknown],
                SlideRate::Driven([speed, acceleration]) => {
                    side.add(-u * acceleration, 1.0);
                    speed
                }
            };
            let across = quarter_turn(u);
            side.add(-across * (2.0 * omega * rate), 4.0);
            let omega_error = match slide.spin {
                Spin::Unknown(unknown) => rate_errors[unknown],
                Spin::Known(_) => 0.0,
            };
            let rate_error = match slide.rate {
                SlideRate::Unknown(unknown) => rate_errors[unknown],
                SlideRate::Driven(_) => 0.0,
            };
            side.doubt(across * (2.0 * (omega.abs() * rate_error + rate.abs() * omega_error)));
        }
        side
    }

    #[inline]
    fn zero() -> Self {
        Self {
            value: Vector::zeros(),
            uncertain: Vector::zeros(),
        }
    }

    /// Adds a term that carries `roundings` roundings of its own.
    #[inline]
    fn add(&mut self, term: Vector, roundings: f64) {
        self.value += term;
        // Four more for the additions that it goes through.
        self.doubt(term * ((roundings + 4.0) * UNIT_ROUNDOFF));
    }

    #[inline]
    fn doubt(&mut self, error: Vector) {
        self.uncertain += error.abs();
    }
}
