//! The torque of each drive by the virtual power of all loads: a route that needs velocities, and no joint's force.

use super::Posed;
use super::acting::Acting;
use super::carried::{Drive, Forces};
use crate::geometry::{Ball, Pair, Vector};
use crate::mechanism::{BodyId, Mechanism, PointId, Role, SliderId};
use crate::motion::{Places, State, bounded_motion};
use crate::sheet::Order;

/// What a drive moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driven {
    /// A link, which turns.
    Body(BodyId),
    /// A slider, along its guide.
    Slider(SliderId),
}

impl Driven {
    /// The rate that the scene gives it.
    pub(crate) fn rate(self, mechanism: &Mechanism) -> Option<f64> {
        match self {
            Driven::Body(body) => match mechanism.body(body).role {
                Role::Driver { omega, .. } => Some(omega),
                _ => None,
            },
            Driven::Slider(slider) => mechanism.slider(slider).drive.map(|drive| drive.speed),
        }
    }
}

/// Places while one drive runs at rate 1 and the others stand: such rates are no numbers of the scene.
struct AtUnitRate<'a, P>(&'a P);

impl<P: Places> Places for AtUnitRate<'_, P> {
    fn place(&self, point: PointId) -> Pair<Ball> {
        self.0.place(point)
    }

    fn arm(&self, from: PointId, to: PointId) -> Pair<Ball> {
        self.0.arm(from, to)
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        self.0.guide(slider)
    }

    fn given(&self, number: f64) -> Ball {
        self.0.given(number)
    }

    fn rate(&self, rate: f64) -> Ball {
        Ball::from(i32::from(rate != 0.0))
    }

    fn omega(&self, _: BodyId, omega: f64) -> Ball {
        self.rate(omega)
    }

    fn rounded_arm(&self, from: PointId, to: PointId) -> Vector {
        self.0.rounded_arm(from, to)
    }

    fn rounded_guide(&self, slider: SliderId) -> Vector {
        self.0.rounded_guide(slider)
    }
}

/// The motion with a drive at rate 1.
fn at_unit_rate(mechanism: &Mechanism, places: &impl Places, driven: Driven) -> State {
    bounded_motion(&with_unit_rate(mechanism, driven), &AtUnitRate(places), Order::Velocity)
}

/// All drives: links first, then sliders.
fn driven(mechanism: &Mechanism) -> impl Iterator<Item = Driven> {
    let turned = mechanism.body_ids().filter(|&body| matches!(mechanism.body(body).role, Role::Driver { .. }));
    let pushed = mechanism.slider_ids().filter(|&slider| mechanism.slider(slider).drive.is_some());
    turned.map(Driven::Body).chain(pushed.map(Driven::Slider))
}

/// The velocities of all bodies by drive, while it runs at rate 1 and the others stand.
pub(crate) fn lever_states(mechanism: &Mechanism, places: &impl Places) -> Vec<(Driven, State)> {
    let state = |drive| (drive, at_unit_rate(mechanism, places, drive));
    driven(mechanism).map(state).collect()
}

/// What each drive needs, by both routes; `None` where a velocity has no bound.
pub(super) fn drives(
    mechanism: &Mechanism,
    posed: &(impl Posed<Ball> + Places),
    forces: &Forces,
) -> Option<Vec<Drive>> {
    let drive = |driven: Driven| {
        let state = at_unit_rate(mechanism, posed, driven);
        let power = |load: &Acting| {
            let motion = state.body(load.body).referred_to(load.at);
            load.force.dot(motion.velocity) + load.couple * motion.omega
        };
        let powers: Vec<Ball> = forces.acting.iter().map(power).collect();
        let by_power = -powers.iter().fold(Ball::default(), |sum, &power| sum + power);
        let by_bodies = match driven {
            Driven::Body(body) => forces.torque(body),
            Driven::Slider(slider) => forces.push(mechanism, slider, Places::guide(posed, slider)),
        };
        let (body, slider) = match driven {
            Driven::Body(body) => (Some(body), None),
            Driven::Slider(slider) => (None, Some(slider)),
        };
        by_power.is_known().then_some(Drive { body, slider, effort: by_bodies, by_power, powers })
    };
    driven(mechanism).map(drive).collect()
}

/// The mechanism with one drive at rate 1, and all other given motions at rest.
fn with_unit_rate(mechanism: &Mechanism, driven: Driven) -> Mechanism {
    let mut mechanism = mechanism.clone();
    for (index, body) in mechanism.bodies.iter_mut().enumerate() {
        let is_own = driven == Driven::Body(BodyId(index));
        match &mut body.role {
            Role::Driver { omega, alpha, .. } => (*omega, *alpha) = (f64::from(u8::from(is_own)), 0.0),
            Role::Moving { velocity, acceleration, omega, alpha, .. } => {
                (*velocity, *acceleration) = (Vector::zeros(), Vector::zeros());
                (*omega, *alpha) = (0.0, 0.0);
            }
            Role::Carrier { velocity, acceleration } => {
                (*velocity, *acceleration) = (Vector::zeros(), Vector::zeros());
            }
            Role::Ground | Role::Pushed { .. } | Role::Unsolved | Role::Member => {}
        }
    }
    for (index, slider) in mechanism.sliders.iter_mut().enumerate() {
        let is_own = driven == Driven::Slider(SliderId(index));
        if let Some(drive) = &mut slider.drive {
            (drive.speed, drive.acceleration) = (f64::from(u8::from(is_own)), 0.0);
        }
    }
    mechanism
}
