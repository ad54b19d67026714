use super::Motion;
use super::errors::{Sum, error_of_product, guide_roundings};
use crate::geometry::{Numbers, UNIT_ROUNDOFF, Vector, quarter_turn};
use crate::mechanism::{LoopEquations, LoopTerms, SlideRate, Spin};
use crate::position::Pose;

/// The right sides of all loops, two numbers each, with bounds of their errors.
#[derive(Clone, Debug)]
pub struct RightSide {
    /// The two components for each loop.
    pub value: Numbers,
    /// Bounds of their errors.
    pub uncertain: Numbers,
}

/// Rates of the unknowns, with bounds of their errors.
#[derive(Clone, Copy, Debug)]
pub struct Rates<'a> {
    /// Their values.
    pub values: &'a [f64],
    /// Bounds of their errors.
    pub errors: &'a [f64],
}

impl RightSide {
    /// The right side of the velocity equations, where known bodies move as `motion` says.
    #[must_use]
    pub fn velocity(equations: &LoopEquations, pose: &Pose, motion: &Motion) -> Self {
        let loops = equations.loops.iter();
        Self::of(loops.map(|terms| velocity(terms, pose, motion)))
    }

    /// The right side of the acceleration equations, with the solution `rates` of the velocity equations.
    #[must_use]
    pub fn acceleration(
        equations: &LoopEquations,
        pose: &Pose,
        motion: &Motion,
        rates: Rates<'_>,
    ) -> Self {
        let loops = equations.loops.iter();
        Self::of(loops.map(|terms| acceleration(terms, pose, motion, rates)))
    }

    /// Adds to the bounds what the rounding of the equations' coefficients makes of the solution `x`.
    pub fn doubt_coefficients(&mut self, equations: &LoopEquations, pose: &Pose, x: &[f64]) {
        for (terms, uncertain) in equations.loops.iter().zip(self.uncertain.chunks_mut(2)) {
            let mut doubt = |v: Vector| {
                uncertain[0] += v.x.abs();
                uncertain[1] += v.y.abs();
            };
            for arm in &terms.arms {
                if let Spin::Unknown(unknown) = arm.spin {
                    // One rounding as a difference of places, one for each further arm of the same rotation.
                    let alike = terms.arms.iter().filter(|other| other.spin == arm.spin);
                    let error = alike.count() as f64 * UNIT_ROUNDOFF * x[unknown];
                    doubt(quarter_turn(pose.arm(arm.from, arm.to)) * error);
                }
            }
            for slide in &terms.slides {
                if let SlideRate::Unknown(unknown) = slide.rate {
                    let u = pose.guide(slide.slider);
                    doubt(u * (guide_roundings(u) * UNIT_ROUNDOFF * x[unknown]));
                }
            }
        }
    }

    fn of(loops: impl Iterator<Item = Sum>) -> Self {
        let (mut value, mut uncertain) = (Numbers::new(), Numbers::new());
        for side in loops {
            value.extend([side.value.x, side.value.y]);
            uncertain.extend([side.error.x, side.error.y]);
        }
        Self { value, uncertain }
    }
}

/// The right side of a loop's velocity equations.
#[inline]
fn velocity(terms: &LoopTerms, pose: &Pose, motion: &Motion) -> Sum {
    let mut side = Sum::default();
    if let Some([start, end]) = terms.ends {
        let (first, last) = (pose.point(terms.first), pose.point(terms.last));
        let [start, end] = [start, end].map(|b| (motion.body(b), motion.error(b)));
        side.add(end.0.velocity - start.0.velocity, 1.0);
        side.doubt(end.1.velocity + start.1.velocity);
        side.add(end.0.swing(last), 2.0);
        side.doubt(end.1.swing(end.0, last));
        side.add(-start.0.swing(first), 2.0);
        side.doubt(start.1.swing(start.0, first));
    }
    for arm in &terms.arms {
        if let Spin::Known(body) = arm.spin {
            let turned = quarter_turn(pose.arm(arm.from, arm.to));
            side.add(-turned * motion.body(body).omega, 2.0);
            side.doubt(turned * motion.error(body).omega);
        }
    }
    for slide in &terms.slides {
        if let SlideRate::Driven([speed, _]) = slide.rate {
            let u = pose.guide(slide.slider) * slide.sign;
            side.add(-u * speed, 1.0 + guide_roundings(u));
        }
    }
    side
}

/// The right side of a loop's acceleration equations, with the solution of the velocity equations.
#[inline]
fn acceleration(terms: &LoopTerms, pose: &Pose, motion: &Motion, rates: Rates<'_>) -> Sum {
    let mut side = Sum::default();
    if let Some([start, end]) = terms.ends {
        let (first, last) = (pose.point(terms.first), pose.point(terms.last));
        let [start, end] = [start, end].map(|b| (motion.body(b), motion.error(b)));
        side.add(end.0.acceleration - start.0.acceleration, 1.0);
        side.doubt(end.1.acceleration + start.1.acceleration);
        side.add(end.0.tangential(last), 2.0);
        side.doubt(end.1.tangential(end.0, last));
        side.add(end.0.normal(last), 3.0);
        side.doubt(end.1.normal(end.0, last));
        side.add(-start.0.tangential(first), 2.0);
        side.doubt(start.1.tangential(start.0, first));
        side.add(-start.0.normal(first), 3.0);
        side.doubt(start.1.normal(start.0, first));
    }
    let spin = |spin: Spin| match spin {
        Spin::Unknown(unknown) => (rates.values[unknown], rates.errors[unknown]),
        Spin::Known(body) => (motion.body(body).omega, motion.error(body).omega),
    };
    for arm in &terms.arms {
        let r = pose.arm(arm.from, arm.to);
        let (omega, error) = spin(arm.spin);
        if let Spin::Known(body) = arm.spin {
            side.add(-quarter_turn(r) * motion.body(body).alpha, 2.0);
            side.doubt(quarter_turn(r) * motion.error(body).alpha);
        }
        side.add(r * (omega * omega), 3.0);
        side.doubt(r * error_of_product([omega; 2], [error; 2]));
    }
    for slide in &terms.slides {
        let u = pose.guide(slide.slider) * slide.sign;
        let (omega, omega_error) = spin(slide.spin);
        let (rate, rate_error) = match slide.rate {
            SlideRate::Unknown(unknown) => (rates.values[unknown], rates.errors[unknown]),
            SlideRate::Driven([speed, acceleration]) => {
                side.add(-u * acceleration, 1.0 + guide_roundings(u));
                (speed, 0.0)
            }
        };
        let across = quarter_turn(u);
        side.add(-across * (2.0 * omega * rate), 2.0 + guide_roundings(u));
        let error = error_of_product([omega, rate], [omega_error, rate_error]);
        side.doubt(across * (2.0 * error));
    }
    side
}
