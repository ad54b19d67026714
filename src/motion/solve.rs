use super::moving::{BoundedMotion, BoundedSlide, Places, State};
use super::refine::{Solver, acceleration_sides, velocity_sides};
use super::singular::{Standing, singular, standing};
use super::{Motion, MotionError, says};
use crate::geometry::{Ball, Pair, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{
    AngularRate, BodyId, Group, JointId, Loop, LoopEquations, Mechanism, PointId, Role, Slider, SliderId,
};
use crate::position::Pose;
use crate::scene::GivenBy;
use crate::sheet::Order;
use smallvec::smallvec;

/// Condition number from which a group counts as singular: with coordinates rounded to f64 no digit of its rates is
/// certain.
const SINGULAR_CONDITION: f64 = 0.05 / UNIT_ROUNDOFF;

/// Condition number above which there is a warning: coordinates rounded to f64 determine fewer than 8 digits of the
/// rates.
const NEARLY_SINGULAR_CONDITION: f64 = 1e-8 / UNIT_ROUNDOFF;

/// The part of itself by which rates found from lengths may be off, from which on there is a warning: rounding enters the
/// position times the condition, and from there the rates times the condition once more.
const NEARLY_AT_LIMIT: f64 = 1e-4;

/// The largest velocity, acceleration or rate of a result: squares and their sums must not overflow.
const LARGEST: f64 = 1e150;

/// Velocities and, for [`Order::Acceleration`], accelerations of every body of `mechanism` at `pose`.
///
/// # Errors
/// [`MotionError::Singular`] names the links and the critical lines of a group in a singular position;
/// [`MotionError::Overflow`] the links whose rates leave the range of f64.
pub fn motion(mechanism: &Mechanism, pose: &Pose, order: Order) -> Result<Motion, MotionError> {
    let mut state = known_state(mechanism, pose);
    let (mut conditions, mut warnings) = (Vec::new(), Vec::new());
    for group in &mechanism.groups {
        let condition = move_group(mechanism, group, pose, order, &mut state).map_err(|unsolved| match unsolved {
            Unsolved::Singular(condition) => {
                let standing = standing(mechanism, group, pose, &state);
                singular(mechanism, group, pose, condition, standing)
            }
            Unsolved::Overflow => MotionError::Overflow(group.link_names(mechanism)),
        })?;
        if condition > NEARLY_SINGULAR_CONDITION {
            let digits = -libm::log10(condition * UNIT_ROUNDOFF);
            let (links, condition) = (group.link_names(mechanism), format!("{condition:.1e}"));
            warnings.push(says::near_singular(links, condition, format!("{digits:.0}")));
        } else if mechanism.given_by == GivenBy::Lengths && condition * condition * UNIT_ROUNDOFF > NEARLY_AT_LIMIT {
            let digits = -libm::log10(condition * condition * UNIT_ROUNDOFF);
            let (links, condition) = (group.link_names(mechanism), format!("{condition:.1e}"));
            warnings.push(says::near_limit(links, condition, format!("{:.0}", digits.max(0.0))));
        }
        conditions.push(condition);
    }
    let motion = state.rounded(order, conditions, warnings);
    match overflowing_body(mechanism, pose, &motion) {
        Some(link) => Err(MotionError::Overflow(mechanism.body(link).name.clone())),
        None => Ok(motion),
    }
}

/// All motions with bounds of their errors, before rounding; with infinite bounds for a group that is singular within
/// the bounds of the places, or whose numbers leave the range of f64.
pub(crate) fn bounded_motion(mechanism: &Mechanism, places: &impl Places, order: Order) -> State {
    let mut state = known_state(mechanism, places);
    for group in &mechanism.groups {
        if move_group(mechanism, group, places, order, &mut state).is_err() {
            let equations = LoopEquations::new(mechanism, group);
            let unknown = Ball::default().widened(f64::INFINITY);
            for body in &group.bodies {
                (state.bodies[body.0].omega, state.bodies[body.0].alpha) = (unknown, unknown);
            }
            for &(id, _) in &equations.slides {
                state.slides[id.0] = BoundedSlide { velocity: unknown, acceleration: unknown };
            }
            set_reference_motions(mechanism, group, places, &mut state);
        }
    }
    state
}

/// Where a group stands that has no motion of which something is proved: by the motions of those before it.
pub(crate) fn standing_of(mechanism: &Mechanism, pose: &Pose, group: usize) -> Standing {
    let mut state = known_state(mechanism, pose);
    for before in &mechanism.groups[..group] {
        // Without a motion it stays at rest, and nothing follows for those after it.
        if move_group(mechanism, before, pose, Order::Velocity, &mut state).is_err() {
            return Standing::Unknown;
        }
    }
    standing(mechanism, &mechanism.groups[group], pose, &state)
}

/// The motions that the scene gives; rest for all others.
fn known_state(mechanism: &Mechanism, places: &impl Places) -> State {
    State {
        bodies: mechanism.body_ids().map(|id| known_motion(mechanism, places, id)).collect(),
        slides: mechanism.sliders.iter().map(|slider| driven_motion(places, slider)).collect(),
    }
}

/// Why a group has no motion.
enum Unsolved {
    /// With this condition number of its equations.
    Singular(f64),
    Overflow,
}

/// A body with a velocity or an acceleration above [`LARGEST`] or not finite.
fn overflowing_body(mechanism: &Mechanism, pose: &Pose, motion: &Motion) -> Option<BodyId> {
    let is_small = |v: Vector| v.amax() <= LARGEST;
    mechanism.body_ids().find(|&id| {
        let (body, moves) = (mechanism.body(id), motion.body(id));
        let places = body.points.iter().map(|&point| pose.point(point));
        let rates = Vector::new(moves.omega, moves.alpha);
        !(is_small(rates)
            && std::iter::once(moves.at)
                .chain(places)
                .all(|p| is_small(moves.velocity_at(p)) && is_small(moves.acceleration_at(p))))
    })
}

/// Adds the motion of `group`; its outer bodies' motions must be known. Returns the condition number.
fn move_group(
    mechanism: &Mechanism,
    group: &Group,
    places: &impl Places,
    order: Order,
    state: &mut State,
) -> Result<f64, Unsolved> {
    let equations = LoopEquations::new(mechanism, group);
    let vector = |from, to| places.rounded_arm(from, to);
    let guide = |slider| places.rounded_guide(slider);
    let system = equations.factored_of(vector, guide).ok_or_else(|| {
        // An infinite matrix comes from places too far apart, not from a singular position.
        let matrix = equations.matrix_of(vector, guide);
        let is_finite = matrix.iter().all(|x| x.is_finite());
        if is_finite { Unsolved::Singular(f64::INFINITY) } else { Unsolved::Overflow }
    })?;
    let condition = system.condition();
    if condition.is_nan() || condition >= SINGULAR_CONDITION {
        return Err(Unsolved::Singular(condition));
    }
    let solver = Solver::new(&equations, &system, places);
    let rates = solver.solve(velocity_sides(&equations, places, state));
    let accelerations = match order {
        Order::Acceleration => solver.solve(acceleration_sides(&equations, places, state, &rates)),
        Order::Velocity => smallvec![Ball::default(); equations.unknowns],
    };
    let mut all = rates.iter().chain(&accelerations);
    if !all.all(|x| x.is_known()) {
        return Err(Unsolved::Overflow);
    }

    for &link in &group.bodies {
        let (omega, alpha) = match equations.angular_rate_of(link) {
            AngularRate::Unknown(unknown) => (rates[unknown], accelerations[unknown]),
            AngularRate::Known(body) => (state.body(body).omega, state.body(body).alpha),
        };
        let body = &mut state.bodies[link.0];
        (body.omega, body.alpha) = (omega, alpha);
    }
    for &(slider, unknown) in &equations.slides {
        state.slides[slider.0] = BoundedSlide { velocity: rates[unknown], acceleration: accelerations[unknown] };
    }
    set_reference_motions(mechanism, group, places, state);
    Ok(condition)
}

/// Sets each link's reference point and its motion, along the loops: from the start, but for the last link from the
/// end. Links of a compound link follow from the one that the loop enters; a link in no loop follows over the joint
/// that connects it with known motion.
fn set_reference_motions(mechanism: &Mechanism, group: &Group, places: &impl Places, state: &mut State) {
    let mut placed: Vec<BodyId> = Vec::new();
    let across = |state: &State, slider: SliderId, from: BodyId| {
        motion_across(mechanism, places, slider, from, state.body(from), state.slide(slider))
    };
    let mut place = |joint: JointId, from: BodyId, to: BodyId, placed: &mut Vec<BodyId>| {
        if placed.contains(&to) {
            return;
        }
        placed.push(to);
        let [from, entered] = [from, to].map(|link| mechanism.side(joint, link));
        state.bodies[entered.0] = match mechanism.joint(joint).slider {
            Some(slider) => across(state, slider, from),
            None => {
                let &BoundedMotion { omega, alpha, .. } = state.body(entered);
                let pin = places.place(mechanism.joint_point(joint));
                BoundedMotion { omega, alpha, ..state.body(from).referred_to(pin) }
            }
        };
        for link in mechanism.compound(to) {
            for slide in mechanism.slides_between(entered, link) {
                state.bodies[slide.to.0] = across(state, slide.slider, slide.from);
            }
        }
    };
    let mut waiting: Vec<&Loop> = group.loops.iter().collect();
    // A loop that closes on a link of the group needs that link's motion first.
    let starts = |chain: &&Loop, placed: &[BodyId]| !chain.closed || placed.contains(&chain.bodies[0]);
    while let Some(next) = waiting.iter().position(|chain| starts(chain, &placed)) {
        let chain = waiting.remove(next);
        let last = chain.bodies.len() - 2;
        let end = (chain.joints[last], chain.bodies[last + 1], chain.bodies[last]);
        let forward = (0..last).map(|i| (chain.joints[i], chain.bodies[i], chain.bodies[i + 1]));
        for (joint, from, to) in std::iter::once(end).chain(forward) {
            place(joint, from, to, &mut placed);
        }
    }
    for (joint, from, to) in group.hanging(mechanism) {
        place(joint, from, to, &mut placed);
    }
}

/// The motion of a body that the scene gives; rest for a body of a group, whose motion is unknown.
fn known_motion(mechanism: &Mechanism, places: &impl Places, id: BodyId) -> BoundedMotion {
    let body = mechanism.body(id);
    match &body.role {
        Role::Ground | Role::Member => BoundedMotion::default(),
        Role::Driver { pivot, omega, alpha, .. } => {
            let turning = BoundedMotion {
                at: places.place(*pivot),
                omega: places.omega(id, *omega),
                alpha: places.rate(*alpha),
                ..BoundedMotion::default()
            };
            // The reference point is the point farthest from the pivot, where a group is usually joined.
            let arm = |p: PointId| places.rounded_arm(*pivot, p);
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
            at: Pair { x: places.given(at.x), y: places.given(at.y) },
            velocity: places.rate_pair(*velocity),
            acceleration: places.rate_pair(*acceleration),
            omega: places.rate(*omega),
            alpha: places.rate(*alpha),
        },
        Role::Carrier { velocity, acceleration } => BoundedMotion {
            at: places.place(body.points[0]),
            velocity: places.rate_pair(*velocity),
            acceleration: places.rate_pair(*acceleration),
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
fn driven_motion(places: &impl Places, slider: &Slider) -> BoundedSlide {
    let drive = slider.drive.as_ref();
    drive.map_or(BoundedSlide::default(), |drive| BoundedSlide {
        velocity: places.rate(drive.speed),
        acceleration: places.rate(drive.acceleration),
    })
}

/// The motion of the body on the other side of a slider from body `from`, whose motion is `source`.
///
/// a = a_from + u s̈ + 2 ω ṡ J u, where the last term is the Coriolis acceleration.
fn motion_across(
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
