use super::errors::guide;
use super::moving::{Moving, Sliding};
use crate::mechanism::{Body, BodyId, Mechanism, Role, Slider, SliderId};
use crate::position::Pose;

/// The motion of a body that moves as the scene says; rest for one that is still to be found.
pub(super) fn known_motion(mechanism: &Mechanism, pose: &Pose, body: &Body) -> Moving {
    match &body.role {
        Role::Ground | Role::Member => Moving::default(),
        Role::Driver { pivot, omega, alpha, .. } => {
            let pivot = pose.point(*pivot);
            let turning = Moving { at: pivot, omega: (*omega).into(), alpha: (*alpha).into(), ..Moving::default() };
            // Referred to its other end, where a group usually hangs on.
            let at = body.points.iter().map(|&p| pose.point(p));
            let at = at.fold(
                pivot,
                |best, p| {
                    if (p - pivot).norm_squared() > (best - pivot).norm_squared() { p } else { best }
                },
            );
            turning.referred_to(at)
        }
        Role::Pushed { slider, from } => {
            let source = known_motion(mechanism, pose, mechanism.body(*from));
            let slide = driven_motion(mechanism.slider(*slider));
            slid(mechanism, pose, *slider, *from, &source, &slide)
        }
        Role::Moving { at, velocity, acceleration, omega, alpha } => Moving {
            at: *at,
            velocity: (*velocity).into(),
            acceleration: (*acceleration).into(),
            omega: (*omega).into(),
            alpha: (*alpha).into(),
        },
        Role::Carrier { velocity, acceleration } => Moving {
            at: pose.point(body.points[0]),
            velocity: (*velocity).into(),
            acceleration: (*acceleration).into(),
            ..Moving::default()
        },
        Role::Stub => {
            let carrier = mechanism
                .bodies
                .iter()
                .find(|b| matches!(b.role, Role::Carrier { .. }) && b.points[0] == body.points[0]);
            carrier.map_or(Moving::default(), |carrier| known_motion(mechanism, pose, carrier))
        }
    }
}

/// How a slider moves by its drive; at rest without one.
pub(super) fn driven_motion(slider: &Slider) -> Sliding {
    let drive = slider.drive.as_ref();
    drive.map_or(Sliding::default(), |drive| Sliding {
        velocity: drive.speed.into(),
        acceleration: drive.acceleration.into(),
    })
}

/// The motion of the body on the other side of a slider from `from`, which moves as `source` says.
///
/// a = a_from + u s̈ + 2 ω ṡ J u, the last part Coriolis's.
pub(super) fn slid(
    mechanism: &Mechanism,
    pose: &Pose,
    slider: SliderId,
    from: BodyId,
    source: &Moving,
    slide: &Sliding,
) -> Moving {
    let Slider { at, on, .. } = *mechanism.slider(slider);
    let u = guide(pose, slider, if on == from { 1.0 } else { -1.0 });
    let moved = source.referred_to(pose.point(at));
    let coriolis = u.quarter_turn() * (source.omega * slide.velocity).twice();
    Moving {
        velocity: moved.velocity + u * slide.velocity,
        acceleration: moved.acceleration + u * slide.acceleration + coriolis,
        ..moved
    }
}
