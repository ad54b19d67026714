use crate::geometry::degrees_of;
use crate::mechanism::{Body, BodyId, Class, Group, Joint, Mechanism, Role};
use crate::position::{Listed, Pose, search_warnings};
use crate::scene::{GivenBy, Scene};
use crate::words::{Language, Wording};

/// The structure of a mechanism as text: its formula with each group's links and joints, degrees of freedom, and each
/// group's class and special points.
#[must_use]
pub fn structure(mechanism: &Mechanism, words: &Wording) -> String {
    let language = words.language;
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
            group.class.in_words(language),
            group.link_names(mechanism),
            joints(mechanism, group)
        ));
    }
    let mut lines = vec![formula.join(" → ")];
    // A group has as many constraints as freedoms, so the degrees of freedom are the drives.
    let count = drives.len().to_string();
    lines.push(match (drives.len(), known.len()) {
        (_, 0) => language.structure_freedoms(&count),
        (0, _) => language.structure_known(&known.join(", ")),
        _ => language.structure_drives(&count, &known.join(", ")),
    });
    if let Some(placing) = &mechanism.placing {
        let groups = placing.mechanism.groups.iter().map(|group| {
            let links = group.link_names(&placing.mechanism);
            format!("{}({links})", group.class.in_words(language))
        });
        let degrees = words.number(placing.angle.to_string());
        let angle = format!("angle({}) = {degrees}°", mechanism.body(placing.link).name);
        lines.push(language.structure_positions(&angle, &groups.collect::<Vec<_>>().join(" → ")));
    }
    for group in &mechanism.groups {
        let (links, class) = (group.link_names(mechanism), group.class.in_words(language));
        lines.push(language.structure_group(&links, class, shape(group.class, language)));
        let special = group.special.iter().filter(|s| s.target.is_none());
        let special: Vec<&str> = special.map(|s| s.name.as_str()).collect();
        if !special.is_empty() {
            lines.push(format!("  {}", language.structure_special_points(&special.join(", "))));
        }
    }
    lines.join("\n") + "\n"
}

/// The definition of a group's class, by this program's convention.
fn shape(class: Class, language: &Language) -> &str {
    match class {
        Class::Second => language.shape_second(),
        Class::Third => language.shape_third(),
        Class::Fourth => language.shape_fourth(),
        Class::Higher => language.shape_higher(),
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

/// Assembly modes of a mechanism as a numbered list, with the places of its inner points and the angles of its groups'
/// links, and the number of all where not all are listed; below it the warning, if any, that there may be more modes.
#[must_use]
pub fn listed_modes(scene: &Scene, mechanism: &Mechanism, Listed { poses, count }: &Listed) -> String {
    let words = Wording::of(&scene.figure);
    let language = words.language;
    let number = count.number.to_string();
    let counted = if count.is_exact { number } else { language.modes_at_least(&number) };
    let modes = match count.number {
        1 => language.modes_one(&counted),
        _ => language.modes_many(&counted),
    };
    let modes = match poses.len() {
        all if all as u64 == count.number && count.is_exact => modes,
        listed => language.modes_listed(&modes, &listed.to_string()),
    };
    let mut lines = vec![language.modes_heading(&modes, scene.units.length.as_str())];
    let numbered = poses.iter().zip(1..);
    lines.extend(
        numbered.map(|(pose, number)| format!("{number:3}. {}", mode(mechanism, pose, &words).join("\n     "))),
    );
    if scene.given_by == GivenBy::Lengths {
        lines.extend(search_warnings(mechanism.for_positions()).map(|warning| language.says(&warning)));
    }
    lines.join("\n") + "\n"
}

/// An assembly mode in words: a line with the places of its inner points and one with the angles of its groups' links.
#[must_use]
pub fn mode(mechanism: &Mechanism, pose: &Pose, words: &Wording) -> Vec<String> {
    let number = |x: f64| words.number(format!("{x:.6}"));
    // A driving link without a given angle is one of the links whose positions are sought.
    let mechanism = mechanism.for_positions();
    let points = mechanism.inner_points().into_iter().map(|p| {
        let q = pose.point(p);
        format!("{} {}", mechanism.point_name(p), words.place([q.x, q.y].map(number)))
    });
    let members = mechanism.links().filter(|(id, _)| mechanism.is_sought(*id));
    let angles = members.filter_map(|(id, body)| {
        let axis = pose.axes[id.0]?;
        Some(format!("angle({}) {}", body.name, number(degrees_of(axis))))
    });
    let mut lines = [points.collect::<Vec<_>>(), angles.collect()].map(|line| line.join("  ")).to_vec();
    // A slotted lever and its block have no point whose position is sought.
    lines.retain(|line| !line.is_empty());
    lines
}
