use super::{BodyMotion, Order};
use crate::geometry::quarter_turn;
use crate::mechanism::{Body, Mechanism, Role};
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
        Role::Pushed {
            slider,
            speed,
            acceleration,
            ..
        } => {
            let along = pose.guide(*slider);
            BodyMotion {
                at: pose.point(mechanism.slider(*slider).at),
                velocity: along * *speed,
                acceleration: along * *acceleration,
                omega: 0.0,
                alpha: 0.0,
            }
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
