use crate::accuracy::bounds;
use crate::geometry::degrees_of;
use crate::mechanism::{Body, BodyId, Class, Group, Joint, LoopEquations, Mechanism, PointId, Role};
use crate::motion::motion;
use crate::position::{Assembly, Listed, Pose, search_warnings};
use crate::scene::{GivenBy, Scene};
use crate::sheet::Order;
use crate::words::{Language, Wording};

/// Most decimals of coordinates and angles of assembly modes.
const DECIMALS: f64 = 6.0;

/// Size times condition of a mode from which on six decimals may not be certain.
const DELICATE: f64 = 1e7;

/// What a place or an angle may be off where nothing is proved, as at a limit: in parts of the largest coordinate.
const UNPROVED: f64 = 1e-6;

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
        lines.push(match group.links.len() {
            // A wheel alone, turned by what it touches, is no group of a class.
            1 => language.structure_wheel(&links),
            _ => language.structure_group(&links, class, shape(group.class, language)),
        });
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
/// links, and the number of all where not all are listed; below it for each group but dyads how many of its modes were found, how many there can be,
/// and whether there may be more.
#[must_use]
pub fn listed_modes(scene: &Scene, mechanism: &Mechanism, Listed { poses, count }: &Listed) -> String {
    let words = Wording::of(&scene.figure);
    let language = words.language;
    let number = count.number.to_string();
    let counted = if count.is_exact { number } else { language.modes_at_least(&number) };
    let modes = language.modes(&counted);
    let modes = match poses.len() {
        all if all as u64 == count.number && count.is_exact => modes,
        listed => language.modes_listed(&modes, &listed.to_string()),
    };
    let mut lines = vec![language.modes_heading(&modes, scene.units.length.as_str())];
    let numbered = poses.iter().zip(1..);
    let told = |pose: &Pose| certain_mode(scene, mechanism, pose, &words).join("\n     ");
    lines.extend(numbered.map(|(pose, number)| format!("{number:3}. {}", told(pose))));
    if scene.given_by == GivenBy::Lengths {
        let sought = mechanism.for_positions();
        // Groups may have fewer modes in some assemblies of those before them.
        let of_group = |index: usize| {
            let all = || poses.iter().filter_map(|pose| *pose.assemblies.get(index)?);
            let most = all().max_by_key(|assembly| assembly.modes)?;
            Some(Assembly { may_move: all().any(|assembly| assembly.may_move), ..most })
        };
        let assemblies: Vec<Option<Assembly>> = (0..sought.groups.len()).map(of_group).collect();
        for (group, assembly) in sought.groups.iter().zip(&assemblies) {
            if let Some(Assembly { modes, at_most: Some(most), .. }) = *assembly
                && group.class != Class::Second
                && (group.class != Class::Higher || modes as u64 == most)
            {
                lines.push(language.modes_of_group(&group.link_names(sought), &modes.to_string(), &most.to_string()));
            }
        }
        lines.extend(search_warnings(sought, &assemblies).map(|warning| language.says(&warning)));
    }
    lines.join("\n") + "\n"
}

/// An assembly mode of a scene in words, with as many decimals as are certain: bounds are found where six may not be.
fn certain_mode(scene: &Scene, mechanism: &Mechanism, pose: &Pose, words: &Wording) -> Vec<String> {
    let size = pose.points.iter().map(|point| point.coords.amax()).fold(0.0, f64::max);
    let conditions = mechanism.groups.iter().map(|group| {
        let system = LoopEquations::new(mechanism, group).factored(&pose.points, &pose.guides);
        system.map_or(f64::INFINITY, |system| system.condition())
    });
    if size * conditions.fold(1.0, f64::max) < DELICATE {
        return mode(mechanism, pose, words);
    }
    let proved = |bound: f64| if bound.is_finite() { bound } else { UNPROVED * size };
    let Ok(motion) = motion(mechanism, pose, Order::Velocity) else {
        return mode_within(mechanism, pose, words, |_| UNPROVED * size, |_| UNPROVED * size);
    };
    let bounds = bounds(scene, mechanism, pose, &motion);
    let angle = |body| proved(bounds.angle(body).unwrap_or(f64::INFINITY));
    mode_within(mechanism, pose, words, |point| proved(bounds.place(point)), angle)
}

/// An assembly mode in words: a line with the places of its inner points and one with the angles of its groups' links.
#[must_use]
pub fn mode(mechanism: &Mechanism, pose: &Pose, words: &Wording) -> Vec<String> {
    mode_within(mechanism, pose, words, |_| 0.0, |_| 0.0)
}

/// The same of places and angles that may be off by so much.
fn mode_within(
    mechanism: &Mechanism,
    pose: &Pose,
    words: &Wording,
    off_place: impl Fn(PointId) -> f64,
    off_angle: impl Fn(BodyId) -> f64,
) -> Vec<String> {
    let number = |x: f64, within: f64| {
        let certain = if within > 0.0 { libm::floor(-libm::log10(2.0 * within)) } else { DECIMALS };
        let written = format!("{x:.*}", certain.clamp(0.0, DECIMALS) as usize);
        // What is rounded to zero has no sign.
        let is_zero = written.bytes().all(|byte| !byte.is_ascii_digit() || byte == b'0');
        words.number(if is_zero { written.trim_start_matches('-').to_owned() } else { written })
    };
    // A driving link without a given angle is one of the links whose positions are sought.
    let mechanism = mechanism.for_positions();
    let points = mechanism.inner_points().into_iter().map(|p| {
        let q = pose.point(p);
        let off = off_place(p);
        format!("{} {}", mechanism.point_name(p), words.place([q.x, q.y].map(|x| number(x, off))))
    });
    let members = mechanism.links().filter(|(id, _)| mechanism.is_sought(*id));
    let angles = members.filter_map(|(id, body)| {
        let axis = pose.axes[id.0]?;
        Some(format!("angle({}) {}", body.name, number(degrees_of(axis), off_angle(id))))
    });
    let mut lines = [points.collect::<Vec<_>>(), angles.collect()].map(|line| line.join("  ")).to_vec();
    // A slotted lever and its block have no point whose position is sought.
    lines.retain(|line| !line.is_empty());
    lines
}
