use super::BodyMotion;
use crate::geometry::{UNIT_ROUNDOFF, Vector, quarter_turn};
use crate::mechanism::{LoopEquations, Spin, UNKNOWNS};
use crate::position::Pose;

/// One right side of the loop equations, and (if `BOUNDED`) how uncertain rounding has left each element.
#[derive(Clone, Copy, Debug)]
pub struct RightSide<const BOUNDED: bool> {
    /// The two components for each loop.
    pub value: [f64; UNKNOWNS],
    /// Bounds of their errors; zero where they were not asked for.
    pub uncertain: [f64; UNKNOWNS],
}

impl<const BOUNDED: bool> RightSide<BOUNDED> {
    /// The right side of the velocity equations.
    #[inline]
    #[must_use]
    pub fn velocity(equations: &LoopEquations, pose: &Pose, known: &[BodyMotion]) -> Self {
        let mut side = Self::zero();
        for (index, terms) in equations.loops.iter().enumerate() {
            let (start, end) = (&known[terms.start.0], &known[terms.end.0]);
            let (first, last) = (pose.point(terms.first), pose.point(terms.last));
            side.add(index, end.velocity - start.velocity, 1.0);
            side.add(index, end.swing(last), 3.0);
            side.add(index, -start.swing(first), 3.0);
            for arm in &terms.arms {
                if let Spin::Known(body) = arm.spin {
                    let turned = quarter_turn(pose.arm(arm.from, arm.to));
                    side.add(index, -turned * known[body.0].omega, 2.0);
                }
            }
        }
        side
    }

    /// The right side of the acceleration equations, with the solution `rates` of the velocity equations.
    ///
    /// `rate_errors` bounds the errors of `rates`; they make this side uncertain.
    #[inline]
    #[must_use]
    pub fn acceleration(
        equations: &LoopEquations,
        pose: &Pose,
        known: &[BodyMotion],
        rates: &[f64; UNKNOWNS],
        rate_errors: &[f64; UNKNOWNS],
    ) -> Self {
        let mut side = Self::zero();
        for (index, terms) in equations.loops.iter().enumerate() {
            let (start, end) = (&known[terms.start.0], &known[terms.end.0]);
            let (first, last) = (pose.point(terms.first), pose.point(terms.last));
            side.add(index, end.acceleration - start.acceleration, 1.0);
            side.add(index, end.tangential(last), 3.0);
            side.add(index, end.normal(last), 4.0);
            side.add(index, -start.tangential(first), 3.0);
            side.add(index, -start.normal(first), 4.0);
            for arm in &terms.arms {
                let r = pose.arm(arm.from, arm.to);
                match arm.spin {
                    Spin::Unknown(unknown) => {
                        let omega = rates[unknown];
                        side.add(index, r * (omega * omega), 3.0);
                        if BOUNDED {
                            side.doubt(index, r * (2.0 * omega.abs() * rate_errors[unknown]));
                        }
                    }
                    Spin::Known(body) => {
                        let body = &known[body.0];
                        side.add(index, -quarter_turn(r) * body.alpha, 2.0);
                        side.add(index, r * (body.omega * body.omega), 3.0);
                    }
                }
            }
            for slide in &terms.slides {
                let u = quarter_turn(pose.guide(slide.slider)) * slide.sign;
                let (omega, omega_error) = match slide.spin {
                    Spin::Unknown(unknown) => (rates[unknown], rate_errors[unknown]),
                    Spin::Known(body) => (known[body.0].omega, 0.0),
                };
                let rate = rates[slide.unknown];
                side.add(index, -u * (2.0 * omega * rate), 4.0);
                if BOUNDED {
                    let rate_error = rate_errors[slide.unknown];
                    let doubt = 2.0 * (omega.abs() * rate_error + rate.abs() * omega_error);
                    side.doubt(index, u * doubt);
                }
            }
        }
        side
    }

    fn zero() -> Self {
        Self {
            value: [0.0; UNKNOWNS],
            uncertain: [0.0; UNKNOWNS],
        }
    }

    /// Adds a term that carries `roundings` roundings of its own.
    fn add(&mut self, index: usize, term: Vector, roundings: f64) {
        self.value[2 * index] += term.x;
        self.value[2 * index + 1] += term.y;
        if BOUNDED {
            // Four more for the additions that it goes through.
            self.doubt(index, term * ((roundings + 4.0) * UNIT_ROUNDOFF));
        }
    }

    fn doubt(&mut self, index: usize, error: Vector) {
        self.uncertain[2 * index] += error.x.abs();
        self.uncertain[2 * index + 1] += error.y.abs();
    }
}
