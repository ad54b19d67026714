use super::group::add_group_bounds;
use crate::construction::Special;
use crate::geometry::{Point, UNIT_ROUNDOFF};
use crate::mechanism::{BodyId, JointId, Mechanism, SliderId};
use crate::motion::{Motion, Order};
use crate::position::Pose;

/// Bounds of the errors of all rates, velocities and accelerations of a motion, in the scene's units, angles in rad.
///
/// Places and rates that the scene gives count as exact; so do the coordinates of a drawn configuration.
#[derive(Clone, Debug)]
pub struct Bounds<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) pose: &'a Pose,
    pub(super) motion: &'a Motion,
    pub(super) bodies: Vec<BodyErrors>,
    pub(super) slides: Vec<SlideErrors>,
}

/// Bounds of the errors of a body: of its rotation, and of its reference point,
/// [`BodyMotion::at`](crate::motion::BodyMotion::at).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BodyErrors {
    /// Of its angle, in radians.
    pub turn: f64,
    pub omega: f64,
    pub alpha: f64,
    pub place: PlaceErrors,
}

/// Bounds of the errors of a slider.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SlideErrors {
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

/// Bounds of the errors of a point's position, velocity and acceleration, in any direction.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PlaceErrors {
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

/// Bounds of the errors of every rate, velocity and acceleration of `motion`.
///
/// Where a link's angle is given in place of a drive's, that drive's angle counts as exact.
#[must_use]
pub fn bounds<'a>(mechanism: &'a Mechanism, pose: &'a Pose, motion: &'a Motion) -> Bounds<'a> {
    let mut bounds = Bounds {
        mechanism,
        pose,
        motion,
        bodies: vec![BodyErrors::default(); mechanism.bodies.len()],
        slides: vec![SlideErrors::default(); mechanism.sliders.len()],
    };
    for group in &mechanism.groups {
        add_group_bounds(&mut bounds, group);
    }
    bounds
}

impl Bounds<'_> {
    /// Bounds of the errors of a body's angular velocity and acceleration.
    #[must_use]
    pub fn spin(&self, body: BodyId) -> [f64; 2] {
        let errors = &self.bodies[body.0];
        [errors.omega, errors.alpha]
    }

    /// Bounds of the errors of a slider's velocity and acceleration along its guide.
    #[must_use]
    pub fn slide(&self, slider: SliderId) -> [f64; 2] {
        let errors = &self.slides[slider.0];
        [errors.velocity, errors.acceleration]
    }

    /// Bounds of the errors of velocity and acceleration, in each component, of the body's point at `p`; rounding
    /// included.
    #[must_use]
    pub fn motion_at(&self, body: BodyId, p: Point) -> [f64; 2] {
        let errors = self.inherited_at(body, p);
        let motion = self.motion.body(body);
        let velocity = motion.velocity.norm() + motion.swing(p).norm();
        let turning = motion.tangential(p).norm() + motion.normal(p).norm();
        let acceleration = motion.acceleration.norm() + turning;
        // Roundings in the motion of the reference point and in the relative motion of `p`.
        let rounding = 8.0 * UNIT_ROUNDOFF;
        [errors.velocity + rounding * velocity, errors.acceleration + rounding * acceleration]
    }

    /// The same for a special point of a construction; `None` at infinity.
    ///
    /// A cut line that is displaced by δ, or turned by an error t at the distance r, moves the crossing by (δ + r t) /
    /// |sine|.
    #[must_use]
    pub fn special(&self, special: &Special) -> Option<[f64; 2]> {
        let place = special.place.finite()?;
        let (size, sine) = (place.coords.norm(), special.crossing.sine().abs());
        let cuts = special.cuts.iter().map(|cut| {
            let start = cut.start().map_or(place, |p| self.pose.point(p));
            let reach = (place - start).norm();
            let [carrier, link] = [cut.carrier, special.link].map(|b| self.bodies[b.0].turn);
            let off = self.inherited_at(cut.leg.base, start).position;
            let rounding = 8.0 * UNIT_ROUNDOFF * (size + reach + start.coords.norm());
            off + reach * carrier.max(link) + rounding
        });
        let moved = cuts.sum::<f64>() / sine;
        let motion = self.motion.body(special.link);
        let omega = motion.omega.abs();
        let [velocity, acceleration] = self.motion_at(special.link, place);
        Some([velocity + omega * moved, acceleration + (motion.alpha.abs() + omega * omega) * moved])
    }

    /// Bound of the error, in each component, of a slider's Coriolis acceleration 2 ω ẑ × v_r.
    #[must_use]
    pub fn coriolis(&self, slider: SliderId) -> f64 {
        let on = self.mechanism.slider(slider).on;
        let size = self.motion.coriolis(self.pose, slider, on).norm();
        let (errors, slide) = (&self.bodies[on.0], &self.slides[slider.0]);
        let omega = self.motion.body(on).omega.abs();
        let velocity = self.motion.slide(slider).velocity.abs();
        let rates = 2.0 * (omega * slide.velocity + velocity * errors.omega);
        rates + size * (errors.turn + 4.0 * UNIT_ROUNDOFF)
    }

    /// Errors of a body's point at `p` inherited from body and reference point, without the rounding of `p` itself.
    pub(super) fn inherited_at(&self, body: BodyId, p: Point) -> PlaceErrors {
        let (motion, errors) = (self.motion.body(body), &self.bodies[body.0]);
        let reach = (p - motion.at).norm();
        let omega = motion.omega.abs();
        let turning = motion.alpha.abs() + omega * omega;
        PlaceErrors {
            position: errors.place.position + reach * errors.turn,
            velocity: errors.place.velocity + reach * (errors.omega + omega * errors.turn),
            acceleration: errors.place.acceleration
                + reach * (errors.alpha + 2.0 * omega * errors.omega + turning * errors.turn),
        }
    }

    /// Errors at `joint` inherited from body `from`, for the body on the joint's other side.
    pub(super) fn inherited_across(&self, joint: JointId, from: BodyId) -> PlaceErrors {
        let p = self.pose.point(self.mechanism.joint_point(joint));
        let mut errors = self.inherited_at(from, p);
        if let Some(id) = self.mechanism.joint(joint).slider {
            let (slide, sliding) = (self.motion.slide(id), &self.slides[id.0]);
            let turn = self.bodies[from.0].turn;
            let twice = 2.0 * self.motion.body(from).omega.abs();
            let rate = slide.velocity.abs();
            errors.position += sliding.position;
            errors.velocity += sliding.velocity + rate * turn;
            errors.acceleration += sliding.acceleration
                + slide.acceleration.abs() * turn
                + twice * (sliding.velocity + rate * turn)
                + 2.0 * rate * self.bodies[from.0].omega;
        }
        errors
    }

    /// Whether accelerations have been computed.
    #[must_use]
    pub fn has_accelerations(&self) -> bool {
        self.motion.order == Order::Acceleration
    }
}
