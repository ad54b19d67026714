//! Given motions: of which points they are, and that none is given twice.

use indexmap::IndexMap;

use super::error::Wrong;
use super::given::GivenBy;
use super::given::PointMotion;
use super::link::Link;
use super::names::Names;
use super::slider::{On, Slider};
use super::value::{At, Entries};

/// The points of given motion.
pub(super) fn known(
    given_by: GivenBy,
    names: &Names<'_>,
    file: Option<Entries<PointMotion>>,
) -> Result<IndexMap<String, PointMotion>, Wrong> {
    if file.is_some() && given_by == GivenBy::Lengths {
        let hint = r#"give the coordinates of every point in "points": { … }, or drive a link"#;
        return Err(Wrong::key(&["known"], "known motions belong to a drawn configuration").hint(hint));
    }
    let known = file.unwrap_or_default().0;
    for (name, _) in &known {
        names.point(&["known", name], name)?;
        if names.on_ground(name) {
            let message = format!("point {name} is on the ground, which does not move");
            return Err(Wrong::key(&["known", name], message).hint("remove it here or from `ground`"));
        }
    }
    Ok(known.into_iter().collect())
}

/// Refuses a second motion of a point: given by `known`, by the motion or the drive of a link, or by the drive of a
/// slider on the ground.
pub(super) fn check_given_once(
    names: &Names<'_>,
    known: &IndexMap<String, PointMotion>,
    sliders: &[Slider],
) -> Result<(), Wrong> {
    // For each point the source of its motion, in words.
    let mut given: IndexMap<&str, String> = IndexMap::new();
    let mut give = |point, whose: &str, path: &[&str]| match given.insert(point, whose.to_owned()) {
        None => Ok(()),
        Some(first) => {
            let message = format!("the motion of point {point} is given twice: by {first} and by {whose}");
            Err(Wrong::value(path, message).hint("keep one of them"))
        }
    };
    // A slider driven on a moving link gives a relative motion only, which is that of no point.
    let driven = |s: &Slider| s.drive.is_some() && s.on == On::Ground;
    for (name, link) in names.links {
        let pushes = |s: &Slider| driven(s) && s.link.as_ref() == Some(name);
        let whose = match link {
            Link { motion: Some(_), .. } => format!("the `motion` of link {name}"),
            Link { drive: Some(_), .. } => format!("the drive of link {name}"),
            _ if sliders.iter().any(pushes) => format!("the drive of slider {name}"),
            _ => continue,
        };
        for point in link.points.iter().filter(|point| !names.on_ground(point)) {
            give(point, &whose, &["links", name])?;
        }
    }
    for (index, slider) in sliders.iter().enumerate().filter(|(_, slider)| driven(slider)) {
        if let Some(pin) = &slider.pin {
            give(pin, "the drive of its slider", &["sliders", &index.to_string()])?;
        }
    }
    for point in known.keys() {
        if let Some(whose) = given.get(point.as_str()) {
            let message = format!("the motion of point {point} is given already, by {whose}");
            return Err(Wrong::key(&["known", point], message).hint("keep one of them"));
        }
    }
    Ok(())
}

/// Refuses motions of links at points that do not exist.
pub(super) fn check_motions(names: &Names<'_>) -> Result<(), Wrong> {
    for (name, link) in names.links {
        if let Some(At::Point(point)) = link.motion.as_ref().map(|motion| &motion.at) {
            names.point(&["links", name, "motion", "at"], point)?;
        }
    }
    Ok(())
}
