use super::errors::{MotionErrors, Sum, error_of_product, guide_roundings};
use super::{BodyMotion, Order, SlideMotion};
use crate::geometry::{UNIT_ROUNDOFF, quarter_turn};
use crate::mechanism::{Body, BodyId, Mechanism, Role, Slider, SliderId};
use crate::position::Pose;

/// The motion of a body that moves as the scene says, with bounds of its errors; rest for one that is still to be found.
pub(super) fn known_motion(
    mechanism: &Mechanism,
    pose: &Pose,
    body: &Body,
    order: Order,
) -> (BodyMotion, MotionErrors) {
    let given = |motion| (motion, MotionErrors::default());
    let (mut motion, mut errors) = match &body.role {
        Role::Ground | Role::Member => given(BodyMotion::REST),
        Role::Driver {
            pivot,
            omega,
            alpha,
            ..
        } => {
            let pivot = pose.point(*pivot);
            let turning = BodyMotion {
                at: pivot,
                omega: *omega,
                alpha: *alpha,
                ..BodyMotion::REST
            };
            // Referred to its other end, where a group usually hangs on: the pivot's rest is exact there.
            let at = body.points.iter().map(|&p| pose.point(p));
            let at = at.fold(pivot, |best, p| {
                if (p - pivot).norm_squared() > (best - pivot).norm_squared() {
                    p
                } else {
                    best
                }
            });
            (
                turning.referred_to(at),
                MotionErrors::default().at(&turning, at),
            )
        }
        Role::Pushed { slider, from } => {
            let source = known_motion(mechanism, pose, mechanism.body(*from), order);
            let slide = driven_motion(mechanism.slider(*slider), order);
            slid(mechanism, pose, *slider, *from, source, &slide)
        }
        Role::Moving {
            at,
            velocity,
            acceleration,
            omega,
            alpha,
        } => given(BodyMotion {
            at: *at,
            velocity: *velocity,
            acceleration: *acceleration,
            omega: *omega,
            alpha: *alpha,
        }),
        Role::Carrier {
            velocity,
            acceleration,
        } => given(BodyMotion {
            at: pose.point(body.points[0]),
            velocity: *velocity,
            acceleration: *acceleration,
            omega: 0.0,
            alpha: 0.0,
        }),
        Role::Stub => {
            let carrier = mechanism
                .bodies
                .iter()
                .find(|b| matches!(b.role, Role::Carrier { .. }) && b.points[0] == body.points[0]);
            carrier.map_or(given(BodyMotion::REST), |carrier| {
                known_motion(mechanism, pose, carrier, order)
            })
        }
    };
    if order == Order::Velocity {
        motion.acceleration.fill(0.0);
        motion.alpha = 0.0;
        errors.acceleration.fill(0.0);
    }
    (motion, errors)
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

/// The motion of the body on the other side of a slider from `from`, which moves as `source` says, with bounds of its errors.
///
/// a = a_from + u s̈ + 2 ω ṡ J u, the last part Coriolis's.
pub(super) fn slid(
    mechanism: &Mechanism,
    pose: &Pose,
    slider: SliderId,
    from: BodyId,
    (source, errors): (BodyMotion, MotionErrors),
    slide: &SlideMotion,
) -> (BodyMotion, MotionErrors) {
    let Slider { at, on, .. } = *mechanism.slider(slider);
    let at = pose.point(at);
    let u = pose.guide(slider) * if on == from { 1.0 } else { -1.0 };
    let of_guide = guide_roundings(u);
    let (motion, errors) = (source.referred_to(at), errors.at(&source, at));
    let mut velocity = Sum {
        value: motion.velocity,
        error: errors.velocity,
    };
    velocity.add(u * slide.velocity, 1.0 + of_guide);
    velocity.doubt(u * slide.velocity_error);
    let mut acceleration = Sum {
        value: motion.acceleration,
        error: errors.acceleration,
    };
    let sliding = u * slide.acceleration;
    let coriolis = quarter_turn(u) * (2.0 * source.omega * slide.velocity);
    acceleration.add(sliding + coriolis, 1.0);
    acceleration.doubt(sliding * ((1.0 + of_guide) * UNIT_ROUNDOFF));
    acceleration.doubt(coriolis * ((2.0 + of_guide) * UNIT_ROUNDOFF));
    acceleration.doubt(u * slide.acceleration_error);
    let error = error_of_product(
        [source.omega, slide.velocity],
        [errors.omega, slide.velocity_error],
    );
    acceleration.doubt(quarter_turn(u) * (2.0 * error));
    (
        BodyMotion {
            velocity: velocity.value,
            acceleration: acceleration.value,
            ..motion
        },
        MotionErrors {
            velocity: velocity.error,
            acceleration: acceleration.error,
            ..errors
        },
    )
}
