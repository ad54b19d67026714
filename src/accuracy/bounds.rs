use super::group::carry_group;
use crate::construction::Special;
use crate::geometry::{Point, UNIT_ROUNDOFF};
use crate::mechanism::{BodyId, JointId, JointKind, Mechanism, SliderId};
use crate::motion::{Motion, Order};
use crate::position::Pose;

/// Bounds of the errors of all rates, velocities and accelerations of a motion, in the scene's units.
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

/// Bounds of the errors of a body: of its rotation, and of the place to which its motion is referred.
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

/// Bounds of the errors of a place of a body; the same for every direction.
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
        carry_group(&mut bounds, group);
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

    /// Bounds of the errors of velocity and acceleration, in each component, of the body's point at `p`; rounding included.
    #[must_use]
    pub fn motion_at(&self, body: BodyId, p: Point) -> [f64; 2] {
        let errors = self.at(body, p);
        let motion = self.motion.body(body);
        let velocity = motion.velocity.norm() + motion.swing(p).norm();
        let turning = motion.tangential(p).norm() + motion.normal(p).norm();
        let acceleration = motion.acceleration.norm() + turning;
        // What the place's own motion took to compute, and what leads from there to `p`.
        let rounding = 8.0 * UNIT_ROUNDOFF;
        [errors.velocity + rounding * velocity, errors.acceleration + rounding * acceleration]
    }

    /// The same for a special point of a construction, whose place is where its cut lines cross; `None` at infinity.
    ///
    /// A cut line that is off by δ, or turned wrongly by t at the distance r, moves the crossing by (δ + r t) / |sine|.
    #[must_use]
    pub fn special(&self, special: &Special) -> Option<[f64; 2]> {
        let place = special.place.finite()?;
        let (size, sine) = (place.coords.norm(), special.crossing.sine().abs());
        let cuts = special.cuts.iter().map(|cut| {
            let start = cut.start().map_or(place, |p| self.pose.point(p));
            let reach = (place - start).norm();
            let [carrier, link] = [cut.carrier, special.link].map(|b| self.bodies[b.0].turn);
            let off = self.at(cut.leg.base, start).position;
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

    /// What is inherited at a place of a body, rounding at the place itself left out.
    pub(super) fn at(&self, body: BodyId, p: Point) -> PlaceErrors {
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

    /// What is inherited at `joint` by the body on its other side from `from`.
    pub(super) fn across(&self, joint: JointId, from: BodyId) -> PlaceErrors {
        let p = self.pose.point(self.mechanism.joint_point(joint));
        let mut errors = self.at(from, p);
        if let JointKind::Prismatic(id) = self.mechanism.joint(joint).kind {
            let (slide, own) = (self.motion.slide(id), &self.slides[id.0]);
            let turn = self.bodies[from.0].turn;
            let twice = 2.0 * self.motion.body(from).omega.abs();
            let rate = slide.velocity.abs();
            errors.position += own.position;
            errors.velocity += own.velocity + rate * turn;
            errors.acceleration += own.acceleration
                + slide.acceleration.abs() * turn
                + twice * (own.velocity + rate * turn)
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
