use crate::geometry::{Ball, Pair, UNIT_ROUNDOFF, Vector};
use crate::mechanism::SliderId;
use crate::position::Pose;

/// Bounds on the errors of a body's motion, the positions taken as exact; zero where the motion is given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionErrors {
    /// Bounds on the errors of the components of the velocity at [`BodyMotion::at`](super::BodyMotion::at).
    pub velocity: Vector,
    /// The same of the acceleration.
    pub acceleration: Vector,
    /// Bound on the error of ω.
    pub omega: f64,
    /// Bound on the error of α.
    pub alpha: f64,
}

/// Bound of the relative error of a guide's unit vector: roundings since the scene's direction, and the deviation of
/// its length from 1.
pub(super) fn guide_error(u: Vector) -> f64 {
    const FROM_THE_SCENE: f64 = 4.0;
    let stretch = 0.5 * (u.norm_squared() - 1.0).abs();
    FROM_THE_SCENE * UNIT_ROUNDOFF + stretch
}

/// `sign` times a slider's unit vector, with the bound of its error.
pub(super) fn guide(pose: &Pose, slider: SliderId, sign: f64) -> Pair<Ball> {
    let u = pose.guide(slider) * sign;
    let error = guide_error(u);
    let Pair { x, y } = Pair::<Ball>::from(u);
    Pair { x: x.widened(u.x * error), y: y.widened(u.y * error) }
}
