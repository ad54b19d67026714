use super::moving::{BoundedMotion, BoundedSlide};
use super::places::Places;
use crate::mechanism::{BodyId, Mechanism, PointId, Role, Slider, SliderId};

/// The motion of a body that the scene gives; rest for a body of a group, whose motion is unknown.
pub(super) fn known_motion(mechanism: &Mechanism, places: &impl Places, id: BodyId) -> BoundedMotion {
    let body = mechanism.body(id);
    match &body.role {
        Role::Ground | Role::Member => BoundedMotion::default(),
        Role::Driver { pivot, omega, alpha, .. } => {
            let turning = BoundedMotion {
                at: places.place(*pivot),
                omega: places.omega(id, *omega),
                alpha: places.given(*alpha),
                ..BoundedMotion::default()
            };
            // The reference point is the point farthest from the pivot, where a group is usually joined.
            let arm = |p: PointId| places.points()[p.0] - places.points()[pivot.0];
            let farther = |best: PointId, &p: &PointId| {
                if arm(p).norm_squared() > arm(best).norm_squared() { p } else { best }
            };
            turning.referred_to(places.place(body.points.iter().fold(*pivot, farther)))
        }
        Role::Pushed { slider, from } => {
            let source = known_motion(mechanism, places, *from);
            let slide = driven_motion(places, mechanism.slider(*slider));
            motion_across(mechanism, places, *slider, *from, &source, &slide)
        }
        Role::Moving { at, velocity, acceleration, omega, alpha } => BoundedMotion {
            at: places.given_pair(at.coords),
            velocity: places.given_pair(*velocity),
            acceleration: places.given_pair(*acceleration),
            omega: places.given(*omega),
            alpha: places.given(*alpha),
        },
        Role::Carrier { velocity, acceleration } => BoundedMotion {
            at: places.place(body.points[0]),
            velocity: places.given_pair(*velocity),
            acceleration: places.given_pair(*acceleration),
            ..BoundedMotion::default()
        },
        Role::Unsolved => {
            let carries = |b: &BodyId| {
                let other = mechanism.body(*b);
                matches!(other.role, Role::Carrier { .. }) && other.points[0] == body.points[0]
            };
            let carrier = mechanism.body_ids().find(carries);
            carrier.map_or(BoundedMotion::default(), |carrier| known_motion(mechanism, places, carrier))
        }
    }
}

/// The given motion of a driven slider; zero for a free one.
pub(super) fn driven_motion(places: &impl Places, slider: &Slider) -> BoundedSlide {
    let drive = slider.drive.as_ref();
    drive.map_or(BoundedSlide::default(), |drive| BoundedSlide {
        velocity: places.given(drive.speed),
        acceleration: places.given(drive.acceleration),
    })
}

/// The motion of the body on the other side of a slider from body `from`, whose motion is `source`.
///
/// a = a_from + u s̈ + 2 ω ṡ J u, where the last term is the Coriolis acceleration.
pub(super) fn motion_across(
    mechanism: &Mechanism,
    places: &impl Places,
    slider: SliderId,
    from: BodyId,
    source: &BoundedMotion,
    slide: &BoundedSlide,
) -> BoundedMotion {
    let Slider { at, on, .. } = *mechanism.slider(slider);
    let guide = places.guide(slider);
    let u = if on == from { guide } else { -guide };
    let moved = source.referred_to(places.place(at));
    let coriolis = u.quarter_turn() * (source.omega * slide.velocity).twice();
    BoundedMotion {
        velocity: moved.velocity + u * slide.velocity,
        acceleration: moved.acceleration + u * slide.acceleration + coriolis,
        ..moved
    }
}
