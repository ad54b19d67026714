use crate::geometry::{UNIT_ROUNDOFF, Vector};

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
