//! What is said of a group in a singular position: whether it is a limit or a change point, and which lines meet there.

use super::MotionError;
use super::moving::State;
use super::reach::Reach;
use super::refine::velocity_sides;
use super::says;
use crate::geometry::{Line, Numbers, Sides, Vector, cross, degrees_of, quarter_turn};
use crate::mechanism::{Class, Group, JointId, LoopEquations, Mechanism, Role};
use crate::message::Message;
use crate::position::Pose;
use crate::words::certain_angle;

/// Condition number from which a group counts as nearly singular: a double root is found to half the digits.
const NEARLY: f64 = 1e6;

/// Part of the largest rates that a singular group could have, from which on its rates do grow without bound.
const GROWS: f64 = 1e-5;

/// … and below which they stay.
const STAYS: f64 = 1e-6;

/// Turn by which a position that is singular to the last digit is disturbed, in radians.
const DISTURBED: f64 = 1e-9;

/// What a singular position is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Standing {
    /// Two branches meet: the drive can go no further, rates grow without bound.
    Limit,
    /// Two branches cross: rates are not determined, as the motion could go on in either.
    Change,
    /// Not one of these for certain.
    Unknown,
}

/// What the position of a group is that is singular, or nearly so, where all before it move like `state`.
///
/// Of a dyad on a crank sums of lengths tell whether branches cross. Else the rates that the drives demand do: in the limit
/// they would be as large as any, at a change point they are not.
pub(super) fn standing(mechanism: &Mechanism, group: &Group, pose: &Pose, state: &State) -> Standing {
    let equations = LoopEquations::new(mechanism, group);
    let turned = |v: Vector, by: usize| v + quarter_turn(v) * (DISTURBED * (by % 7 + 1) as f64);
    let system = equations.factored_of(
        |from, to| turned(pose.arm(from, to), from.0 + 2 * to.0),
        |slider| turned(pose.guide(slider), slider.0),
    );
    let Some(system) = system.filter(|system| system.condition() > NEARLY) else { return Standing::Unknown };
    let sides: Numbers = velocity_sides(&equations, pose, state).numbers().map(|x| x.high).collect();
    // A vector in any direction, and a relation between angles.
    let size = |index: usize| {
        let of_vector = index < 2 * equations.loops.len();
        if of_vector { libm::hypot(sides[index], sides[index ^ 1]) } else { sides[index].abs() }
    };
    let most: Numbers = (0..sides.len()).map(size).collect();
    let part = system.size(system.solve(&sides)) / system.size(system.reach(&most));
    let crosses = Reach::new(mechanism, group, pose).map(|reach| reach.branches_cross());
    match crosses {
        Some(false) if part > STAYS => Standing::Limit,
        Some(true) if part < GROWS => Standing::Change,
        None if part > GROWS => Standing::Limit,
        None if part < STAYS => Standing::Change,
        _ => Standing::Unknown,
    }
}

/// The name of the drive's value and where it stands, as `angle(1)` and `30°`: of the first of several drives.
#[must_use]
pub fn drive_stands(mechanism: &Mechanism, pose: &Pose) -> [String; 2] {
    let turned = mechanism.links().find_map(|(id, body)| match body.role {
        Role::Driver { angle, .. } => {
            let angle = angle.or_else(|| pose.axes[id.0].map(degrees_of))?;
            Some([format!("angle({})", body.name), certain_angle(angle, 0.0)])
        }
        _ => None,
    });
    let pushed = || {
        let id = mechanism.slider_ids().find(|&id| mechanism.slider(id).drive.is_some())?;
        Some([format!("position({})", mechanism.slider_name(id)), pose.slides[id.0]?.to_string()])
    };
    turned.or_else(pushed).unwrap_or_default()
}

/// The error for a singular group, with the lines that are concurrent or parallel.
pub(super) fn singular(
    mechanism: &Mechanism,
    group: &Group,
    pose: &Pose,
    condition: f64,
    standing: Standing,
) -> MotionError {
    let pairs = critical_lines(group);
    let directions: Vec<Vector> =
        pairs.iter().filter_map(|&[a, b]| joint_line(mechanism, pose, a, b)?.direction()).collect();
    let parallel = directions.len() == pairs.len() && directions.windows(2).all(|d| cross(d[0], d[1]).abs() < 1e-6);
    let names: Vec<Message> = pairs.iter().map(|&[a, b]| line_name(mechanism, a, b)).collect();
    let reason = match (group.class, names.as_slice()) {
        (Class::Higher, _) => says::no_definite_motion(),
        (Class::Second, [first, second]) => says::in_one_line(first.clone(), second.clone()),
        _ if parallel => says::parallel(Message::list(names, ", ")),
        _ => says::in_one_point(Message::list(names, ", ")),
    };
    let place = drive_stands(mechanism, pose);
    // Without a drive there is nothing that could not go on.
    let standing = if place[0].is_empty() { Standing::Unknown } else { standing };
    let at = place.join(" = ");
    MotionError::Singular { links: group.link_names(mechanism), reason, condition, standing, at }
}

/// The joints on the critical lines. Class II: from either outer joint to the inner one. Class III: along each leg.
/// Class IV: CD, GF and BE.
fn critical_lines(group: &Group) -> Vec<[JointId; 2]> {
    let joints = |k: usize| &group.loops[k].joints;
    match group.class {
        Class::Second => vec![[joints(0)[0], joints(0)[1]], [joints(0)[1], joints(0)[2]]],
        Class::Third => vec![[joints(0)[0], joints(0)[1]], [joints(0)[2], joints(0)[3]], [joints(1)[2], joints(1)[3]]],
        Class::Fourth => vec![[joints(0)[1], joints(0)[2]], [joints(1)[1], joints(1)[2]], [joints(0)[0], joints(0)[3]]],
        Class::Higher => Vec::new(),
    }
}

/// The line through two joints; a prismatic joint is a pin at infinity, normal to its guide.
fn joint_line(mechanism: &Mechanism, pose: &Pose, a: JointId, b: JointId) -> Option<Line> {
    let normal = |j: JointId| mechanism.joint(j).slider.map(|slider| quarter_turn(pose.guide(slider)));
    let place = |j: JointId| pose.point(mechanism.joint_point(j));
    match (normal(a), normal(b)) {
        (None, None) => Line::new(place(a), place(b) - place(a)),
        (None, Some(n)) => Line::new(place(a), n),
        (Some(n), None) => Line::new(place(b), n),
        (Some(_), Some(_)) => Some(Line::AtInfinity),
    }
}

/// The line through two joints.
fn line_name(mechanism: &Mechanism, a: JointId, b: JointId) -> Message {
    let name = |j: JointId| mechanism.point_name(mechanism.joint_point(j)).to_owned();
    let slides = |j: JointId| mechanism.joint(j).slider.is_some();
    match (slides(a), slides(b)) {
        (false, false) => format!("{}{}", name(a), name(b)).into(),
        (true, false) => says::normal_to_guide(name(b), name(a)),
        (false, true) => says::normal_to_guide(name(a), name(b)),
        (true, true) => says::at_infinity(name(a), name(b)),
    }
}
