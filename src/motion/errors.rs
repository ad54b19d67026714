use super::BodyMotion;
use crate::geometry::{Point, UNIT_ROUNDOFF, Vector, quarter_turn};

/// Roundings that a guide's unit direction carries: those from the scene's own direction, and what turning with its body has
/// left of its length.
pub(super) fn guide_roundings(u: Vector) -> f64 {
    const FROM_THE_SCENE: f64 = 4.0;
    let stretch = 0.5 * (u.norm_squared() - 1.0).abs();
    FROM_THE_SCENE + stretch / UNIT_ROUNDOFF
}

/// Bounds on the errors of a body's motion at given positions; zero where the motion is given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionErrors {
    /// Bounds on the errors of the components of the velocity at [`BodyMotion::at`].
    pub velocity: Vector,
    /// The same of the acceleration.
    pub acceleration: Vector,
    /// Bound on the error of ω.
    pub omega: f64,
    /// Bound on the error of α.
    pub alpha: f64,
}

impl MotionErrors {
    /// The bounds for the same motion, described by that of the body's point at `p`.
    pub(super) fn at(&self, body: &BodyMotion, p: Point) -> MotionErrors {
        let mut velocity = Sum {
            value: body.velocity,
            error: self.velocity,
        };
        velocity.add(body.swing(p), 2.0);
        velocity.doubt(self.swing(body, p));
        let mut acceleration = Sum {
            value: body.acceleration,
            error: self.acceleration,
        };
        acceleration.add(body.tangential(p), 2.0);
        acceleration.doubt(self.tangential(body, p));
        acceleration.add(body.normal(p), 3.0);
        acceleration.doubt(self.normal(body, p));
        MotionErrors {
            velocity: velocity.error,
            acceleration: acceleration.error,
            ..*self
        }
    }

    /// What the error of ω makes of the velocity of the body's point at `p`.
    pub(super) fn swing(&self, body: &BodyMotion, p: Point) -> Vector {
        quarter_turn(p - body.at) * self.omega
    }

    /// What the error of α makes of its tangential acceleration.
    pub(super) fn tangential(&self, body: &BodyMotion, p: Point) -> Vector {
        quarter_turn(p - body.at) * self.alpha
    }

    /// What the error of ω makes of its normal acceleration.
    pub(super) fn normal(&self, body: &BodyMotion, p: Point) -> Vector {
        (p - body.at) * error_of_product([body.omega; 2], [self.omega; 2])
    }
}

/// Bound on the error of x y, where those of x and y are at most so large.
pub(super) fn error_of_product([x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    x.abs() * dy + y.abs() * dx + dx * dy
}

/// A sum of vectors with bounds on the errors of its components, by running error analysis: every addition errs by at most u times
/// what it gives (Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §3.3).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sum {
    /// The sum so far.
    pub value: Vector,
    /// The bounds.
    pub error: Vector,
}

impl Sum {
    /// Adds a term that carries `roundings` roundings of its own.
    #[inline]
    pub fn add(&mut self, term: Vector, roundings: f64) {
        self.value += term;
        self.doubt(term * (roundings * UNIT_ROUNDOFF));
        self.doubt(self.value * UNIT_ROUNDOFF);
    }

    /// Makes the sum uncertain by the magnitudes of these components.
    #[inline]
    pub fn doubt(&mut self, error: Vector) {
        self.error += error.abs();
    }
}
