use crate::Problem;
use crate::geometry::{Line, Vector, cross, quarter_turn};
use crate::mechanism::{Class, Group, JointId, Mechanism};
use crate::position::Pose;

/// Reasons why the motion at a pose is not defined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum MotionError {
    /// The group is in a singular position.
    Singular {
        /// The group's links.
        links: String,
        /// The concurrent or parallel lines, in words.
        reason: String,
        /// Condition number of the loop equations; infinite where a pivot vanishes.
        condition: f64,
    },
    /// A number exceeds the range of f64.
    Overflow {
        /// The group's links.
        links: String,
    },
}

impl MotionError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            MotionError::Singular { links, reason, condition } => {
                let how =
                    if condition.is_finite() { format!("condition {condition:.1e}") } else { "exactly".to_owned() };
                Problem::new(format!("links {links} are in a singular position: {reason} ({how})"))
                    .hint("another crank angle, or move one of these joints off the common line or point")
            }
            MotionError::Overflow { links } => Problem::new(format!(
                "links {links}: a distance, a velocity or an acceleration is too large to be represented"
            ))
            .hint("larger units of length, or slower drives"),
        }
    }
}

/// The error for a singular group, with the lines that are concurrent or parallel.
pub(super) fn singular(mechanism: &Mechanism, group: &Group, pose: &Pose, condition: f64) -> MotionError {
    let pairs = critical_lines(group);
    let directions: Vec<Vector> =
        pairs.iter().filter_map(|&[a, b]| joint_line(mechanism, pose, a, b)?.direction()).collect();
    let parallel = directions.len() == pairs.len() && directions.windows(2).all(|d| cross(d[0], d[1]).abs() < 1e-6);
    let names: Vec<String> = pairs.iter().map(|&[a, b]| line_name(mechanism, a, b)).collect();
    let reason = match (group.class, parallel) {
        (Class::Higher, _) => "its loops have no definite motion".to_owned(),
        (Class::Second, _) => format!("{} lie in one line", names.join(" and ")),
        (_, true) => format!("the lines {} are parallel", names.join(", ")),
        (_, false) => format!("the lines {} meet in one point", names.join(", ")),
    };
    MotionError::Singular { links: group.link_names(mechanism), reason, condition }
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

/// The line through two joints, in words.
fn line_name(mechanism: &Mechanism, a: JointId, b: JointId) -> String {
    let name = |j: JointId| mechanism.point_name(mechanism.joint_point(j)).to_owned();
    let slides = |j: JointId| mechanism.joint(j).slider.is_some();
    match (slides(a), slides(b)) {
        (false, false) => format!("{}{}", name(a), name(b)),
        (true, false) => format!("through {} normal to the guide at {}", name(b), name(a)),
        (false, true) => format!("through {} normal to the guide at {}", name(a), name(b)),
        (true, true) => format!("at infinity (guides at {} and {})", name(a), name(b)),
    }
}
