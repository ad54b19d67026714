use super::{BodyMotion, GroupAccuracy, Motion, MotionErrors, Order, SlideMotion};
use crate::geometry::{Ball, Pair, Point};
use crate::mechanism::{BodyId, SliderId};

/// The motion of a rigid body before rounding: that of one of its places, and its rotation.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moving {
    pub at: Point,
    pub velocity: Pair<Ball>,
    pub acceleration: Pair<Ball>,
    pub omega: Ball,
    pub alpha: Ball,
}

impl Moving {
    /// Velocity of the point at `p` relative to that at `at`.
    pub fn swing(&self, p: Point) -> Pair<Ball> {
        if p == self.at {
            return Pair::default();
        }
        Pair::between(self.at, p).quarter_turn() * self.omega
    }

    /// Acceleration of the point at `p` relative to that at `at`.
    pub fn turning(&self, p: Point) -> Pair<Ball> {
        if p == self.at {
            return Pair::default();
        }
        let arm = Pair::between(self.at, p);
        arm.quarter_turn() * self.alpha - arm * (self.omega * self.omega)
    }

    /// The same motion, described by that of the body's point at `p`.
    pub fn referred_to(&self, p: Point) -> Moving {
        Moving {
            at: p,
            velocity: self.velocity + self.swing(p),
            acceleration: self.acceleration + self.turning(p),
            ..*self
        }
    }

    fn rounded(&self) -> (BodyMotion, MotionErrors) {
        let motion = BodyMotion {
            at: self.at,
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

/// The motion of a slider along its guide before rounding.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sliding {
    pub velocity: Ball,
    pub acceleration: Ball,
}

impl Sliding {
    fn rounded(&self) -> SlideMotion {
        SlideMotion {
            velocity: self.velocity.high,
            acceleration: self.acceleration.high,
            velocity_error: self.velocity.error(),
            acceleration_error: self.acceleration.error(),
        }
    }
}

/// What moves, as far as it is known. Whoever continues from here reads these numbers, so that nothing is rounded twice.
#[derive(Clone, Debug)]
pub(super) struct State {
    /// By body.
    pub bodies: Vec<Moving>,
    /// By slider.
    pub slides: Vec<Sliding>,
}

impl State {
    pub fn body(&self, id: BodyId) -> &Moving {
        &self.bodies[id.0]
    }

    pub fn slide(&self, id: SliderId) -> &Sliding {
        &self.slides[id.0]
    }

    /// Everything rounded to f64; no accelerations where they were not asked for.
    pub fn rounded(mut self, order: Order, groups: Vec<GroupAccuracy>, warnings: Vec<String>) -> Motion {
        if order == Order::Velocity {
            for body in &mut self.bodies {
                (body.acceleration, body.alpha) = Default::default();
            }
            for slide in &mut self.slides {
                slide.acceleration = Ball::default();
            }
        }
        let (bodies, errors) = self.bodies.iter().map(Moving::rounded).unzip();
        Motion { order, bodies, errors, slides: self.slides.iter().map(Sliding::rounded).collect(), groups, warnings }
    }
}
