//! What else is said of a position: given motions, none of them twice, and rough places that choose the assembly.

use indexmap::IndexMap;

use super::error::Wrong;
use super::given::{DRAWN, GivenBy, PointMotion};
use super::joint::{On, Slider};
use super::link::Link;
use super::names::Names;
use super::quantity_name::QuantityName;
use super::value::{At, NearValue};

/// Approximate positions, which choose the assembly mode.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Near {
    /// Approximate coordinates of points, in the fixed frame.
    pub points: IndexMap<String, [f64; 2]>,
    /// Approximate angles of links from +x by link name, in degrees (`"angle(3)"` in the file).
    pub angles_deg: IndexMap<String, f64>,
}

/// The points of given motion.
pub(super) fn known(
    given_by: GivenBy,
    names: &Names<'_>,
    file: Option<IndexMap<String, PointMotion>>,
) -> Result<IndexMap<String, PointMotion>, Wrong> {
    if file.is_some() && given_by == GivenBy::Lengths {
        let hint = r#"give the coordinates of every point in "points": { … }, or drive a link"#;
        return Err(Wrong::key(&["known"], "known motions belong to a drawn configuration").hint(hint));
    }
    let known = file.unwrap_or_default();
    for name in known.keys() {
        names.point(&["known", name], name)?;
        if names.on_ground(name) {
            let message = format!("point {name} is on the ground, which does not move");
            return Err(Wrong::key(&["known", name], message).hint("remove it here or from `ground`"));
        }
    }
    Ok(known)
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

/// The approximate places and angles.
pub(super) fn near(
    given_by: GivenBy,
    names: &Names<'_>,
    file: Option<IndexMap<String, NearValue>>,
) -> Result<Near, Wrong> {
    if file.is_some() && given_by == GivenBy::Drawing {
        let message = "a drawn configuration needs no `near`";
        return Err(Wrong::key(&["near"], message).hint(format!("remove it: {DRAWN}")));
    }
    let mut near = Near::default();
    for (key, value) in file.unwrap_or_default() {
        let path = ["near", &key];
        let link = QuantityName::link_of_angle(&key);
        match (link, value) {
            (Some(link), NearValue::Degrees(degrees)) => {
                names.link(&path, link)?;
                near.angles_deg.insert(link.to_owned(), degrees);
            }
            (Some(_), NearValue::Vector(_)) => {
                return Err(Wrong::value(&path, format!("{key} is one number, in degrees, not two")));
            }
            (None, value) => {
                names.point(&path, &key)?;
                let NearValue::Vector(place) = value else {
                    return Err(Wrong::value(&path, format!("point {key} needs two numbers [x, y], found one")));
                };
                near.points.insert(key, place);
            }
        }
    }
    Ok(near)
}
