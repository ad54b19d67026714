use super::errors::guide;
use super::moving::{BoundedMotion, BoundedSlide};
use crate::mechanism::{Body, BodyId, Mechanism, Role, Slider, SliderId};
use crate::position::Pose;

/// The motion of a body that the scene gives; rest for a body of a group, whose motion is unknown.
pub(super) fn known_motion(mechanism: &Mechanism, pose: &Pose, body: &Body) -> BoundedMotion {
    match &body.role {
        Role::Ground | Role::Member => BoundedMotion::default(),
        Role::Driver { pivot, omega, alpha, .. } => {
            let pivot = pose.point(*pivot);
            let turning =
                BoundedMotion { at: pivot, omega: (*omega).into(), alpha: (*alpha).into(), ..BoundedMotion::default() };
            // The reference point is the point farthest from the pivot, where a group is usually joined.
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
            motion_across(mechanism, pose, *slider, *from, &source, &slide)
        }
        Role::Moving { at, velocity, acceleration, omega, alpha } => BoundedMotion {
            at: *at,
            velocity: (*velocity).into(),
            acceleration: (*acceleration).into(),
            omega: (*omega).into(),
            alpha: (*alpha).into(),
        },
        Role::Carrier { velocity, acceleration } => BoundedMotion {
            at: pose.point(body.points[0]),
            velocity: (*velocity).into(),
            acceleration: (*acceleration).into(),
            ..BoundedMotion::default()
        },
        Role::Stub => {
            let carrier = mechanism
                .bodies
                .iter()
                .find(|b| matches!(b.role, Role::Carrier { .. }) && b.points[0] == body.points[0]);
            carrier.map_or(BoundedMotion::default(), |carrier| known_motion(mechanism, pose, carrier))
        }
    }
}

/// The given motion of a driven slider; zero for a free one.
pub(super) fn driven_motion(slider: &Slider) -> BoundedSlide {
    let drive = slider.drive.as_ref();
    drive.map_or(BoundedSlide::default(), |drive| BoundedSlide {
        velocity: drive.speed.into(),
        acceleration: drive.acceleration.into(),
    })
}

/// The motion of the body on the other side of a slider from body `from`, whose motion is `source`.
///
/// a = a_from + u s̈ + 2 ω ṡ J u, where the last term is the Coriolis acceleration.
pub(super) fn motion_across(
    mechanism: &Mechanism,
    pose: &Pose,
    slider: SliderId,
    from: BodyId,
    source: &BoundedMotion,
    slide: &BoundedSlide,
) -> BoundedMotion {
    let Slider { at, on, .. } = *mechanism.slider(slider);
    let u = guide(pose, slider, if on == from { 1.0 } else { -1.0 });
    let moved = source.referred_to(pose.point(at));
    let coriolis = u.quarter_turn() * (source.omega * slide.velocity).twice();
    BoundedMotion {
        velocity: moved.velocity + u * slide.velocity,
        acceleration: moved.acceleration + u * slide.acceleration + coriolis,
        ..moved
    }
}
