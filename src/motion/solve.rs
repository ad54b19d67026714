use super::known::{driven_motion, known_motion, slid};
use super::singular::singular;
use super::{
    BodyMotion, ClosedForm, GroupAccuracy, Motion, MotionError, MotionErrors, Order, Rates,
    RightSide, SlideMotion,
};
use crate::geometry::{Numbers, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{
    BodyId, Group, JointId, JointKind, Loop, LoopEquations, Mechanism, SliderId,
};
use crate::position::Pose;
use smallvec::smallvec;

/// Condition number from which a group counts as singular: no digit of a rate would be certain.
const SINGULAR_CONDITION: f64 = 0.05 / UNIT_ROUNDOFF;

/// Condition number from which a result carries a warning: fewer than 8 certain digits are left.
const NEARLY_SINGULAR_CONDITION: f64 = 1e-8 / UNIT_ROUNDOFF;

/// The largest velocity, acceleration or rate that is given out: its square is still a number, and so are sums of squares.
const LARGEST: f64 = 1e150;

/// Velocities (and accelerations) of every body of `mechanism` at `pose`.
///
/// # Errors
/// [`MotionError::Singular`] names the links and lines where a group has no definite motion.
pub fn motion(mechanism: &Mechanism, pose: &Pose, order: Order) -> Result<Motion, MotionError> {
    let bodies = mechanism.bodies.iter();
    let (bodies, errors) = bodies
        .map(|body| known_motion(mechanism, pose, body, order))
        .unzip();
    let sliders = mechanism.sliders.iter();
    let mut motion = Motion {
        order,
        bodies,
        errors,
        slides: sliders.map(|s| driven_motion(s, order)).collect(),
        groups: Vec::new(),
        warnings: Vec::new(),
    };
    for group in &mechanism.groups {
        move_group(mechanism, group, pose, &mut motion)?;
    }
    match too_large(mechanism, pose, &motion) {
        Some(link) => Err(MotionError::Overflow {
            links: mechanism.body(link).name.clone(),
        }),
        None => Ok(motion),
    }
}

/// A link that moves too fast for the square of a velocity or an acceleration to be a number.
fn too_large(mechanism: &Mechanism, pose: &Pose, motion: &Motion) -> Option<BodyId> {
    let is_small = |v: Vector| v.amax() <= LARGEST;
    (0..mechanism.bodies.len()).map(BodyId).find(|&id| {
        let (body, moves) = (mechanism.body(id), motion.body(id));
        let places = body.points.iter().map(|&point| pose.point(point));
        let rates = Vector::new(moves.omega, moves.alpha);
        !(is_small(rates)
            && std::iter::once(moves.at)
                .chain(places)
                .all(|p| is_small(moves.velocity_at(p)) && is_small(moves.acceleration_at(p))))
    })
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
        .ok_or_else(|| {
            // Places so far apart that their differences leave the range of f64 say nothing of the position.
            let matrix = equations.matrix(&pose.points, &pose.guides);
            if matrix.iter().all(|x| x.is_finite()) {
                singular(f64::INFINITY)
            } else {
                MotionError::Overflow {
                    links: group.link_names(mechanism),
                }
            }
        })?;
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
    let closed = ClosedForm::new(&equations, &pose.points, &pose.guides);
    let solved = |mut side: RightSide| {
        let rates = match &closed {
            Some(form) => form.solve_all(&side.value),
            None => system.solve(&side.value),
        };
        side.doubt_coefficients(&equations, pose, &rates);
        let errors = system.error_bound(&rates, &side.value, &side.uncertain);
        (rates, errors)
    };
    let (rates, rate_errors) = solved(RightSide::velocity(&equations, pose, motion));
    let (seconds, second_errors) = match motion.order {
        Order::Velocity => {
            let zeros: Numbers = smallvec![0.0; equations.unknowns];
            (zeros.clone(), zeros)
        }
        Order::Acceleration => {
            let rates = Rates {
                values: &rates,
                errors: &rate_errors,
            };
            solved(RightSide::acceleration(&equations, pose, motion, rates))
        }
    };
    let finite = |x: &Numbers| x.iter().all(|x| x.is_finite());
    if ![&rates, &rate_errors, &seconds, &second_errors]
        .into_iter()
        .all(finite)
    {
        return Err(MotionError::Overflow {
            links: group.link_names(mechanism),
        });
    }
    motion.groups.push(GroupAccuracy { condition });

    for &link in &group.bodies {
        let omega = equations.spin(link, &rates, |b| motion.body(b).omega);
        let alpha = equations.spin(link, &seconds, |b| motion.body(b).alpha);
        let errors = MotionErrors {
            omega: equations.spin(link, &rate_errors, |b| motion.error(b).omega),
            alpha: equations.spin(link, &second_errors, |b| motion.error(b).alpha),
            ..MotionErrors::default()
        };
        let body = &mut motion.bodies[link.0];
        (body.omega, body.alpha) = (omega, alpha);
        motion.errors[link.0] = errors;
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

/// Gives each link a place whose motion is known: from the start of its loop, the last link from the end; the links of a compound
/// link from that of them which the loop enters.
fn place_motions(mechanism: &Mechanism, group: &Group, pose: &Pose, motion: &mut Motion) {
    let mut placed: Vec<BodyId> = Vec::new();
    let mut waiting: Vec<&Loop> = group.loops.iter().collect();
    // A loop that closes on a link of the group waits for that link.
    let starts =
        |chain: &&Loop, placed: &[BodyId]| !chain.closed || placed.contains(&chain.bodies[0]);
    while let Some(next) = waiting.iter().position(|chain| starts(chain, &placed)) {
        let chain = waiting.remove(next);
        let last = chain.bodies.len() - 2;
        let end = (
            chain.joints[last],
            chain.bodies[last + 1],
            chain.bodies[last],
        );
        let forward = (0..last).map(|i| (chain.joints[i], chain.bodies[i], chain.bodies[i + 1]));
        for (joint, from, to) in std::iter::once(end).chain(forward) {
            if placed.contains(&to) {
                continue;
            }
            placed.push(to);
            let [from, entered] = [from, to].map(|link| mechanism.side(joint, link));
            carry_over(mechanism, pose, motion, joint, from, entered);
            for link in mechanism.compound(to) {
                for slide in mechanism.way(entered, link) {
                    slide_over(mechanism, pose, motion, slide.slider, slide.from, slide.to);
                }
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
    match mechanism.joint(joint).kind {
        JointKind::Prismatic(slider) => slide_over(mechanism, pose, motion, slider, from, to),
        JointKind::Revolute(point) => {
            let at = pose.point(point);
            let (source, errors) = (motion.body(from), motion.error(from));
            let (moved, errors) = (source.referred_to(at), errors.at(source, at));
            let (omega, alpha) = (motion.body(to).omega, motion.body(to).alpha);
            let moved = BodyMotion {
                omega,
                alpha,
                ..moved
            };
            let own = motion.error(to);
            let errors = MotionErrors {
                omega: own.omega,
                alpha: own.alpha,
                ..errors
            };
            put(motion, to, moved, errors);
        }
    }
}

/// The motion of body `to`, from that of body `from` on the other side of a slider; they turn alike.
fn slide_over(
    mechanism: &Mechanism,
    pose: &Pose,
    motion: &mut Motion,
    slider: SliderId,
    from: BodyId,
    to: BodyId,
) {
    let source = (*motion.body(from), *motion.error(from));
    let slide = motion.slide(slider);
    let (moved, errors) = slid(mechanism, pose, slider, from, source, slide);
    put(motion, to, moved, errors);
}

/// Notes the motion of body `to` as far as it was asked for.
fn put(motion: &mut Motion, to: BodyId, mut moved: BodyMotion, mut errors: MotionErrors) {
    if motion.order == Order::Velocity {
        moved.acceleration.fill(0.0);
        errors.acceleration.fill(0.0);
    }
    motion.bodies[to.0] = moved;
    motion.errors[to.0] = errors;
}
