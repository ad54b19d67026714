use crate::geometry::degrees_of;
use crate::mechanism::{Body, BodyId, Class, Group, Joint, Mechanism, Role};
use crate::position::{Count, Listed, Pose};
use crate::scene::Scene;
use std::fmt::Write;

/// The structure of a mechanism as text: its formula with each group's links and joints, degrees of freedom, and each
/// group's class and special points.
#[must_use]
pub fn structure(mechanism: &Mechanism) -> String {
    let mut text = String::new();
    let drives = mechanism.drive_names();
    let is_given = |b: &&Body| matches!(b.role, Role::Carrier { .. } | Role::Moving { .. });
    let known: Vec<&str> = mechanism.bodies.iter().filter(is_given).map(|b| b.name.as_str()).collect();
    let mut formula: Vec<String> = Vec::new();
    if !drives.is_empty() {
        formula.push(format!("I({})", drives.join(", ")));
    }
    for group in &mechanism.groups {
        formula.push(format!(
            "{}({}; {})",
            group.class.numeral(),
            group.link_names(mechanism),
            joints(mechanism, group)
        ));
    }
    let _ = writeln!(text, "{}", formula.join(" → "));
    // A group has as many constraints as freedoms, so the degrees of freedom are the drives.
    let _ = match (drives.len(), known.len()) {
        (n, 0) => writeln!(text, "degrees of freedom: {n}, as many as drives"),
        (0, _) => writeln!(text, "known motions: {}", known.join(", ")),
        (n, _) => writeln!(text, "drives: {n}; known motions: {}", known.join(", ")),
    };
    if let Some(placing) = &mechanism.placing {
        let groups = placing.mechanism.groups.iter().map(|group| {
            let links = group.link_names(&placing.mechanism);
            format!("{}({links})", group.class.numeral())
        });
        let _ = writeln!(
            text,
            "positions from angle({}) = {}°: {}",
            mechanism.body(placing.link).name,
            placing.angle,
            groups.collect::<Vec<_>>().join(" → ")
        );
    }
    for group in &mechanism.groups {
        let _ = writeln!(
            text,
            "links {}: class {}, {}",
            group.link_names(mechanism),
            group.class.numeral(),
            shape(group.class)
        );
        let special = group.special.iter().filter(|s| s.target.is_none());
        let special: Vec<&str> = special.map(|s| s.name.as_str()).collect();
        if !special.is_empty() {
            let _ = writeln!(text, "  special points {}", special.join(", "));
        }
    }
    text
}

/// The definition of a group's class, by this program's convention.
fn shape(class: Class) -> &'static str {
    match class {
        Class::Second => "two links",
        Class::Third => "a central link on three legs",
        Class::Fourth => "two drag links joined by two closure links, a closed contour of four",
        Class::Higher => "more links than the classes II to IV have, or joined in another way",
    }
}

/// The joints of a group as R and P; of a fourth-class group the joints of each drag link, prismatic ones last, as in
/// `RRP-RRR`.
fn joints(mechanism: &Mechanism, group: &Group) -> String {
    if group.class != Class::Fourth {
        return group.pattern(mechanism);
    }
    let of_link = |link: BodyId| {
        let own = |joint: &&Joint| joint.bodies.iter().any(|&b| mechanism.lead(b) == link);
        let mut joints: Vec<&Joint> = group.joints.iter().map(|&j| mechanism.joint(j)).filter(own).collect();
        joints.sort_by_key(|joint| joint.slider.is_some());
        joints.into_iter().map(|joint| joint.letter).collect::<String>()
    };
    format!("{}-{}", of_link(group.links[0]), of_link(group.links[2]))
}

/// The assembly modes of a mechanism as a numbered list, with the places of its inner points and the angles of its
/// groups' links; below it the warning, if any, that there may be more modes.
#[must_use]
pub fn modes(scene: &Scene, mechanism: &Mechanism, poses: &[Pose]) -> String {
    let count = Count { number: poses.len() as u64, is_exact: true };
    written(scene, mechanism, poses, count)
}

/// The same, with the number of all modes where not all are listed.
#[must_use]
pub fn listed_modes(scene: &Scene, mechanism: &Mechanism, listed: &Listed) -> String {
    written(scene, mechanism, &listed.poses, listed.count)
}

fn written(scene: &Scene, mechanism: &Mechanism, poses: &[Pose], count: Count) -> String {
    let mut text = String::new();
    let unit = scene.units.length.as_str();
    let plural = if count.number == 1 { "" } else { "s" };
    let first = match poses.len() {
        all if all as u64 == count.number && count.is_exact => String::new(),
        listed => format!(", listed are the first {listed}"),
    };
    let _ = writeln!(text, "{count} assembly mode{plural}{first}; coordinates in {unit}, angles in degrees");
    for (index, pose) in poses.iter().enumerate() {
        let _ = writeln!(text, "{:3}. {}", index + 1, mode(mechanism, pose).join("\n     "));
    }
    for remark in poses.iter().take(1).flat_map(|pose| &pose.warnings) {
        let _ = writeln!(text, "{remark}");
    }
    text
}

/// An assembly mode in words: a line with the places of its inner points and one with the angles of its groups' links.
#[must_use]
pub fn mode(mechanism: &Mechanism, pose: &Pose) -> Vec<String> {
    // A driving link without a given angle is one of the links whose positions are sought.
    let mechanism = mechanism.for_positions();
    let points = mechanism.inner_points().into_iter().map(|p| {
        let q = pose.point(p);
        format!("{} ({:.6}, {:.6})", mechanism.point_name(p), q.x, q.y)
    });
    let members = mechanism.links().filter(|(id, _)| mechanism.is_sought(*id));
    let angles = members.filter_map(|(id, body)| {
        let axis = pose.axes[id.0]?;
        Some(format!("angle({}) {:.6}", body.name, degrees_of(axis)))
    });
    let mut lines = [points.collect::<Vec<_>>(), angles.collect()].map(|line| line.join("  ")).to_vec();
    // A slotted lever and its block have no point whose position is sought.
    lines.retain(|line| !line.is_empty());
    lines
}
