use super::{BodyMotion, Motion, MotionErrors, SlideMotion};
use crate::geometry::{Ball, Pair, Point};
use crate::mechanism::{BodyId, SliderId};
use crate::sheet::Order;

/// A [`BodyMotion`] before rounding, with bounds of its errors.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BoundedMotion {
    pub at: Pair<Ball>,
    pub velocity: Pair<Ball>,
    pub acceleration: Pair<Ball>,
    pub omega: Ball,
    pub alpha: Ball,
}

impl BoundedMotion {
    /// Velocity of the point at `p` relative to the reference point.
    pub fn swing(&self, p: Pair<Ball>) -> Pair<Ball> {
        if p == self.at {
            return Pair::default();
        }
        (p - self.at).quarter_turn() * self.omega
    }

    /// Acceleration of the point at `p` relative to the reference point.
    pub fn turning(&self, p: Pair<Ball>) -> Pair<Ball> {
        if p == self.at {
            return Pair::default();
        }
        let arm = p - self.at;
        arm.quarter_turn() * self.alpha - arm * (self.omega * self.omega)
    }

    /// The motion with reference point `p`.
    pub fn referred_to(&self, p: Pair<Ball>) -> BoundedMotion {
        BoundedMotion {
            at: p,
            velocity: self.velocity + self.swing(p),
            acceleration: self.acceleration + self.turning(p),
            ..*self
        }
    }

    fn rounded(&self) -> (BodyMotion, MotionErrors) {
        let motion = BodyMotion {
            at: Point::from(self.at.rounded()),
            velocity: self.velocity.rounded(),
            acceleration: self.acceleration.rounded(),
            omega: self.omega.high,
            alpha: self.alpha.high,
        };
        let errors = MotionErrors {
            velocity: self.velocity.errors(),
            acceleration: self.acceleration.errors(),
            omega: self.omega.error(),
            alpha: self.alpha.error(),
        };
        (motion, errors)
    }
}

/// A [`SlideMotion`] before rounding, with bounds of its errors.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BoundedSlide {
    pub velocity: Ball,
    pub acceleration: Ball,
}

impl BoundedSlide {
    fn rounded(&self) -> SlideMotion {
        SlideMotion {
            velocity: self.velocity.high,
            acceleration: self.acceleration.high,
            velocity_error: self.velocity.error(),
            acceleration_error: self.acceleration.error(),
        }
    }
}

/// The motions known so far. Later groups use these unrounded numbers, so that nothing is rounded twice.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// By body.
    pub bodies: Vec<BoundedMotion>,
    /// By slider.
    pub slides: Vec<BoundedSlide>,
}

impl State {
    pub fn body(&self, id: BodyId) -> &BoundedMotion {
        &self.bodies[id.0]
    }

    pub fn slide(&self, id: SliderId) -> &BoundedSlide {
        &self.slides[id.0]
    }

    /// All motions rounded to f64; with [`Order::Velocity`] accelerations are zero.
    pub fn rounded(mut self, order: Order, conditions: Vec<f64>, warnings: Vec<String>) -> Motion {
        if order == Order::Velocity {
            for body in &mut self.bodies {
                (body.acceleration, body.alpha) = Default::default();
            }
            for slide in &mut self.slides {
                slide.acceleration = Ball::default();
            }
        }
        let (bodies, errors) = self.bodies.iter().map(BoundedMotion::rounded).unzip();
        Motion {
            order,
            bodies,
            errors,
            slides: self.slides.iter().map(BoundedSlide::rounded).collect(),
            conditions,
            warnings,
        }
    }
}
