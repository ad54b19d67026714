use super::known::known_motion;
use super::{
    BodyMotion, ClosedForm, GroupAccuracy, Motion, MotionError, Order, RateErrors, RightSide,
    SlideMotion,
};
use crate::geometry::{Line, LinearSystem, UNIT_ROUNDOFF, Vector, cross, quarter_turn};
use crate::mechanism::{
    BodyId, Group, JointId, JointKind, LoopEquations, Mechanism, SliderId, UNKNOWNS,
};
use crate::position::Pose;

/// Condition number from which a group counts as singular: no digit of a rate would be certain.
const SINGULAR_CONDITION: f64 = 0.05 / UNIT_ROUNDOFF;

/// Condition number from which a result carries a warning: fewer than 8 certain digits are left.
const NEARLY_SINGULAR_CONDITION: f64 = 1e-8 / UNIT_ROUNDOFF;

/// Velocities (and accelerations) of every body of `mechanism` at `pose`.
///
/// # Errors
/// [`MotionError::Singular`] names the links and lines where a group has no definite motion.
pub fn motion(mechanism: &Mechanism, pose: &Pose, order: Order) -> Result<Motion, MotionError> {
    let bodies = mechanism.bodies.iter();
    let mut motion = Motion {
        order,
        bodies: bodies
            .map(|body| known_motion(mechanism, pose, body, order))
            .collect(),
        errors: vec![RateErrors::default(); mechanism.bodies.len()],
        slides: vec![SlideMotion::default(); mechanism.sliders.len()],
        groups: Vec::new(),
        warnings: Vec::new(),
    };
    for group in &mechanism.groups {
        move_group(mechanism, group, pose, &mut motion)?;
    }
    Ok(motion)
}

/// The unknown rates of a group and their derivatives, without error bounds: the quick way for many positions.
///
/// By the closed form where there is one and its determinant is safe, else by the full system; `None` in a singular position.
/// The same numbers as [`motion()`] gives.
#[inline]
#[must_use]
pub fn rates(
    equations: &LoopEquations,
    pose: &Pose,
    known: &[BodyMotion],
) -> Option<[[f64; UNKNOWNS]; 2]> {
    let matrix = equations.matrix(&pose.points, &pose.guides);
    match equations
        .reduction
        .and_then(|r| ClosedForm::new(&matrix, r))
    {
        Some(form) => Some(both_orders(equations, pose, known, |side| form.solve(side))),
        None => LinearSystem::new(matrix)
            .map(|system| both_orders(equations, pose, known, |side| system.solve(side))),
    }
}

#[inline]
fn both_orders(
    equations: &LoopEquations,
    pose: &Pose,
    known: &[BodyMotion],
    solve: impl Fn(&[f64; UNKNOWNS]) -> [f64; UNKNOWNS],
) -> [[f64; UNKNOWNS]; 2] {
    let none = [0.0; UNKNOWNS];
    let side = RightSide::<false>::velocity(equations, pose, known);
    let first = solve(&side.value);
    let side = RightSide::<false>::acceleration(equations, pose, known, &first, &none);
    [first, solve(&side.value)]
}

/// Adds the motion of `group`, whose outer bodies' motions are known.
fn move_group(
    mechanism: &Mechanism,
    group: &Group,
    pose: &Pose,
    motion: &mut Motion,
) -> Result<(), MotionError> {
    let equations = LoopEquations::new(mechanism, group);
    let singular = |condition| singular(mechanism, group, pose, condition);
    let system = equations
        .factored(&pose.points, &pose.guides)
        .ok_or_else(|| singular(f64::INFINITY))?;
    let condition = system.condition();
    if condition.is_nan() || condition >= SINGULAR_CONDITION {
        return Err(singular(condition));
    }
    if condition > NEARLY_SINGULAR_CONDITION {
        let digits = -libm::log10(condition * UNIT_ROUNDOFF);
        motion.warnings.push(format!(
            "links {} are near a singular position (condition {condition:.1e}): about {digits:.0} digits of their rates are certain",
            group.link_names(mechanism),
        ));
    }
    let matrix = equations.matrix(&pose.points, &pose.guides);
    let closed = equations
        .reduction
        .and_then(|r| ClosedForm::new(&matrix, r));
    let solved = |side: &RightSide<true>| {
        let rates = match &closed {
            Some(form) => form.solve(&side.value),
            None => system.solve(&side.value),
        };
        let errors = system.error_bound(&rates, &side.value, &side.uncertain);
        (rates, errors)
    };
    let (rates, rate_errors) = solved(&RightSide::velocity(&equations, pose, &motion.bodies));
    let (seconds, second_errors) = match motion.order {
        Order::Velocity => ([0.0; UNKNOWNS], [0.0; UNKNOWNS]),
        Order::Acceleration => {
            let side =
                RightSide::acceleration(&equations, pose, &motion.bodies, &rates, &rate_errors);
            solved(&side)
        }
    };
    let finite = |x: &[f64; UNKNOWNS]| x.iter().all(|x| x.is_finite());
    if ![rates, rate_errors, seconds, second_errors]
        .iter()
        .all(finite)
    {
        return Err(MotionError::Overflow {
            links: group.link_names(mechanism),
        });
    }
    motion.groups.push(GroupAccuracy { condition });

    for &link in &group.links {
        let omega = equations.spin(link, &rates, |b| motion.body(b).omega);
        let alpha = equations.spin(link, &seconds, |b| motion.body(b).alpha);
        let body = &mut motion.bodies[link.0];
        (body.omega, body.alpha) = (omega, alpha);
        if let Some(unknown) = equations.spin_unknown(link) {
            motion.errors[link.0] = RateErrors {
                omega: rate_errors[unknown],
                alpha: second_errors[unknown],
            };
        }
    }
    for slider in (0..mechanism.sliders.len()).map(SliderId) {
        if let Some(unknown) = equations.slide_unknown(slider) {
            motion.slides[slider.0] = SlideMotion {
                velocity: rates[unknown],
                acceleration: seconds[unknown],
                velocity_error: rate_errors[unknown],
                acceleration_error: second_errors[unknown],
            };
        }
    }
    place_motions(mechanism, group, pose, motion);
    Ok(())
}

/// Gives each link a place whose motion is known: from the start of its loop, the last link from the end.
fn place_motions(mechanism: &Mechanism, group: &Group, pose: &Pose, motion: &mut Motion) {
    let mut placed: Vec<BodyId> = Vec::new();
    for chain in &group.loops {
        let last = chain.bodies.len() - 2;
        let end = (
            chain.joints[last],
            chain.bodies[last + 1],
            chain.bodies[last],
        );
        let forward = (0..last).map(|i| (chain.joints[i], chain.bodies[i], chain.bodies[i + 1]));
        for (joint, from, to) in std::iter::once(end).chain(forward) {
            if !placed.contains(&to) {
                carry_over(mechanism, pose, motion, joint, from, to);
                placed.push(to);
            }
        }
    }
}

/// The motion of body `to` at `joint`, from that of body `from`.
fn carry_over(
    mechanism: &Mechanism,
    pose: &Pose,
    motion: &mut Motion,
    joint: JointId,
    from: BodyId,
    to: BodyId,
) {
    let at = pose.point(mechanism.joint_point(joint));
    let source = *motion.body(from);
    let (mut velocity, mut acceleration) = (source.velocity_at(at), source.acceleration_at(at));
    if let JointKind::Prismatic(id) = mechanism.joint(joint).kind {
        let slide = *motion.slide(id);
        let forward = mechanism.slider(id).on == from;
        let u = pose.guide(id) * if forward { 1.0 } else { -1.0 };
        velocity += u * slide.velocity;
        acceleration +=
            u * slide.acceleration + quarter_turn(u) * (2.0 * source.omega * slide.velocity);
    }
    if motion.order == Order::Velocity {
        acceleration = Vector::zeros();
    }
    let body = &mut motion.bodies[to.0];
    *body = BodyMotion {
        at,
        velocity,
        acceleration,
        ..*body
    };
}

/// The finding that a fourth-class group is singular: lines CD, GF and BE concur.
fn singular(mechanism: &Mechanism, group: &Group, pose: &Pose, condition: f64) -> MotionError {
    let [third, fifth] = [&group.loops[0].joints, &group.loops[1].joints];
    let pairs = [
        [third[1], third[2]],
        [fifth[1], fifth[2]],
        [third[0], third[3]],
    ];
    let directions: Vec<Vector> = pairs
        .iter()
        .filter_map(|&[a, b]| joint_line(mechanism, pose, a, b)?.direction())
        .collect();
    let parallel = directions
        .windows(2)
        .all(|d| cross(d[0], d[1]).abs() < 1e-6);
    let meeting = if parallel && directions.len() == 3 {
        "are parallel"
    } else {
        "meet in one point"
    };
    MotionError::Singular {
        links: group.link_names(mechanism),
        lines: Box::new(pairs.map(|[a, b]| line_name(mechanism, a, b))),
        meeting: meeting.into(),
        condition,
        hint: "another crank angle, or move one of these joints off the common point".into(),
    }
}

/// The line through two joints; a prismatic joint is a pin at infinity, normal to its guide.
fn joint_line(mechanism: &Mechanism, pose: &Pose, a: JointId, b: JointId) -> Option<Line> {
    let normal = |j: JointId| match mechanism.joint(j).kind {
        JointKind::Prismatic(slider) => Some(quarter_turn(pose.guide(slider))),
        JointKind::Revolute(_) => None,
    };
    let place = |j: JointId| pose.point(mechanism.joint_point(j));
    match (normal(a), normal(b)) {
        (None, None) => Line::new(place(a), place(b) - place(a)),
        (None, Some(n)) => Line::new(place(a), n),
        (Some(n), None) => Line::new(place(b), n),
        (Some(_), Some(_)) => Some(Line::AtInfinity),
    }
}

/// That line in words.
fn line_name(mechanism: &Mechanism, a: JointId, b: JointId) -> String {
    let name = |j: JointId| mechanism.point_name(mechanism.joint_point(j)).to_owned();
    match (mechanism.is_prismatic(a), mechanism.is_prismatic(b)) {
        (false, false) => format!("{}{}", name(a), name(b)),
        (true, false) => format!("through {} normal to the guide at {}", name(b), name(a)),
        (false, true) => format!("through {} normal to the guide at {}", name(a), name(b)),
        (true, true) => format!("at infinity (guides at {} and {})", name(a), name(b)),
    }
}
