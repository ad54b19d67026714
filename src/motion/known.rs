use super::{BodyMotion, Order, SlideMotion};
use crate::geometry::quarter_turn;
use crate::mechanism::{Body, BodyId, Mechanism, Role, Slider, SliderId};
use crate::position::Pose;

/// The motion of a body that moves as the scene says; rest for one that is still to be found.
pub(super) fn known_motion(
    mechanism: &Mechanism,
    pose: &Pose,
    body: &Body,
    order: Order,
) -> BodyMotion {
    let mut motion = match &body.role {
        Role::Ground | Role::Member => BodyMotion::REST,
        Role::Driver {
            pivot,
            omega,
            alpha,
            ..
        } => {
            // Referred to its other end, where a group usually hangs on: the pivot's rest is exact there.
            let pivot = pose.point(*pivot);
            let at = body.points.iter().map(|&p| pose.point(p));
            let at = at.fold(pivot, |best, p| {
                if (p - pivot).norm_squared() > (best - pivot).norm_squared() {
                    p
                } else {
                    best
                }
            });
            let arm = at - pivot;
            BodyMotion {
                at,
                velocity: quarter_turn(arm) * *omega,
                acceleration: quarter_turn(arm) * *alpha - arm * (omega * omega),
                omega: *omega,
                alpha: *alpha,
            }
        }
        Role::Pushed { slider, from } => {
            let source = known_motion(mechanism, pose, mechanism.body(*from), order);
            let slide = driven_motion(mechanism.slider(*slider), order);
            slid(mechanism, pose, *slider, *from, &source, &slide)
        }
        Role::Moving {
            at,
            velocity,
            acceleration,
            omega,
            alpha,
        } => BodyMotion {
            at: *at,
            velocity: *velocity,
            acceleration: *acceleration,
            omega: *omega,
            alpha: *alpha,
        },
        Role::Carrier {
            velocity,
            acceleration,
        } => BodyMotion {
            at: pose.point(body.points[0]),
            velocity: *velocity,
            acceleration: *acceleration,
            omega: 0.0,
            alpha: 0.0,
        },
        Role::Stub => {
            let carrier = mechanism
                .bodies
                .iter()
                .find(|b| matches!(b.role, Role::Carrier { .. }) && b.points[0] == body.points[0]);
            carrier.map_or(BodyMotion::REST, |carrier| {
                known_motion(mechanism, pose, carrier, order)
            })
        }
    };
    if order == Order::Velocity {
        motion.acceleration.fill(0.0);
        motion.alpha = 0.0;
    }
    motion
}

/// How a slider moves by its drive; at rest without one.
pub(super) fn driven_motion(slider: &Slider, order: Order) -> SlideMotion {
    let Some(drive) = slider.drive else {
        return SlideMotion::default();
    };
    let second = order == Order::Acceleration;
    SlideMotion {
        velocity: drive.speed,
        acceleration: if second { drive.acceleration } else { 0.0 },
        ..SlideMotion::default()
    }
}

/// The motion of the body on the other side of a slider from `from`, which moves as `source` says.
///
/// a = a_from + u s̈ + 2 ω ṡ J u, the last part Coriolis's.
pub(super) fn slid(
    mechanism: &Mechanism,
    pose: &Pose,
    slider: SliderId,
    from: BodyId,
    source: &BodyMotion,
    slide: &SlideMotion,
) -> BodyMotion {
    let Slider { at, on, .. } = *mechanism.slider(slider);
    let at = pose.point(at);
    let u = pose.guide(slider) * if on == from { 1.0 } else { -1.0 };
    let coriolis = quarter_turn(u) * (2.0 * source.omega * slide.velocity);
    BodyMotion {
        at,
        velocity: source.velocity_at(at) + u * slide.velocity,
        acceleration: source.acceleration_at(at) + (u * slide.acceleration + coriolis),
        ..*source
    }
}
