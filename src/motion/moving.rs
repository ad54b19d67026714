use super::{BodyMotion, Motion, MotionErrors, SlideMotion};
use crate::geometry::{Ball, Pair, Point, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::message::Message;
use crate::position::Pose;
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
    pub fn rounded(mut self, order: Order, conditions: Vec<f64>, warnings: Vec<Message>) -> Motion {
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

/// Where a mechanism's points and guides are when its motion is computed, and the numbers that the scene gives for it.
///
/// A [`Pose`] stands for itself: its f64 numbers count as exact. Enclosures of the true places are the other kind
/// ([`accuracy`](crate::accuracy)).
pub trait Places {
    /// The place of a point.
    fn place(&self, point: PointId) -> Pair<Ball>;
    /// The vector from one point to another.
    fn arm(&self, from: PointId, to: PointId) -> Pair<Ball>;
    /// The unit direction of a slider's guide.
    fn guide(&self, slider: SliderId) -> Pair<Ball>;
    /// A number of the scene: a length, a coordinate or an angle.
    fn given(&self, number: f64) -> Ball;
    /// A velocity or an acceleration that is given, by the scene or since.
    fn rate(&self, rate: f64) -> Ball;
    /// The given angular velocity of a driven body.
    fn omega(&self, body: BodyId, omega: f64) -> Ball;

    /// The vector from one point to another, rounded.
    fn rounded_arm(&self, from: PointId, to: PointId) -> Vector {
        self.arm(from, to).rounded()
    }

    /// The direction of a slider's guide, rounded.
    fn rounded_guide(&self, slider: SliderId) -> Vector {
        self.guide(slider).rounded()
    }

    /// A velocity or an acceleration that is given.
    fn rate_pair(&self, v: Vector) -> Pair<Ball> {
        Pair { x: self.rate(v.x), y: self.rate(v.y) }
    }
}

impl Places for Pose {
    fn place(&self, point: PointId) -> Pair<Ball> {
        Pair::within(self.point(point).coords, 0.0)
    }

    fn arm(&self, from: PointId, to: PointId) -> Pair<Ball> {
        Pair::between(self.points[from.0], self.points[to.0])
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        let u = self.guides[slider.0];
        let error = guide_error(u);
        Pair { x: Ball::within(u.x, u.x * error), y: Ball::within(u.y, u.y * error) }
    }

    fn rounded_arm(&self, from: PointId, to: PointId) -> Vector {
        self.points[to.0] - self.points[from.0]
    }

    fn rounded_guide(&self, slider: SliderId) -> Vector {
        self.guides[slider.0]
    }

    fn given(&self, number: f64) -> Ball {
        Ball::within(number, 0.0)
    }

    fn rate(&self, rate: f64) -> Ball {
        Ball::within(rate, 0.0)
    }

    fn omega(&self, _: BodyId, omega: f64) -> Ball {
        Ball::within(omega, 0.0)
    }
}

/// Bound of the relative error of a guide's unit vector: roundings since the scene's direction, and the deviation of
/// its length from 1.
pub(crate) fn guide_error(u: Vector) -> f64 {
    const FROM_THE_SCENE: f64 = 4.0;
    let stretch = 0.5 * (u.norm_squared() - 1.0).abs();
    FROM_THE_SCENE * UNIT_ROUNDOFF + stretch
}
