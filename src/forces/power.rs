//! The torque of each drive by the virtual power of all loads: a route that needs velocities, and no joint's force.

use super::Posed;
use super::acting::Acting;
use super::carried::{Drive, Forces};
use crate::geometry::{Ball, Vector};
use crate::mechanism::{BodyId, Mechanism, Role, SliderId};
use crate::motion::bounded_motion;
use crate::sheet::Order;

/// What moves a drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Driven {
    Body(BodyId),
    Slider(SliderId),
}

/// What each drive needs, by both routes; `None` where a velocity has no bound.
pub(super) fn drives(mechanism: &Mechanism, posed: &impl Posed, forces: &Forces) -> Option<Vec<Drive>> {
    let turned = mechanism.body_ids().filter(|&body| matches!(mechanism.body(body).role, Role::Driver { .. }));
    let pushed = mechanism.slider_ids().filter(|&slider| mechanism.slider(slider).drive.is_some());
    let all = turned.map(Driven::Body).chain(pushed.map(Driven::Slider));
    let drive = |driven: Driven| {
        let state = bounded_motion(&with_unit_rate(mechanism, driven), posed, Order::Velocity);
        let power = |load: &Acting| {
            let motion = state.body(load.body).referred_to(load.at);
            load.force.dot(motion.velocity) + load.couple * motion.omega
        };
        let powers: Vec<Ball> = forces.acting.iter().map(power).collect();
        let by_power = -powers.iter().fold(Ball::default(), |sum, &power| sum + power);
        let by_bodies = match driven {
            Driven::Body(body) => forces.torque(body),
            Driven::Slider(slider) => forces.push(mechanism, slider, posed.guide(slider)),
        };
        let (body, slider) = match driven {
            Driven::Body(body) => (Some(body), None),
            Driven::Slider(slider) => (None, Some(slider)),
        };
        by_power.is_known().then_some(Drive { body, slider, effort: by_bodies, by_power, powers })
    };
    all.map(drive).collect()
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
