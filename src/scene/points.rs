//! The frame and the points: their coordinates where they are needed, given motions, none of them twice, and rough places
//! that choose the assembly.

use indexmap::IndexMap;

use super::error::{Wrong, close};
use super::given::{DRAWN, GivenBy, PointMotion};
use super::joint::{On, Slider};
use super::link::{Link, check_apart};
use super::name::{check_list, check_name};
use super::names::{Coordinates, Names};
use super::quantity_name::QuantityName;
use super::value::{At, NamesOr, NearValue, Vector, several_forms};
use super::write::write_forms;

/// The frame's points: names, or names with coordinates.
#[derive(Debug, Clone)]
pub(super) enum Ground {
    Names(Vec<String>),
    Places(IndexMap<String, Vector>),
}

write_forms! { Ground { Ground::Names(names) => names, Ground::Places(places) => places } }

several_forms!(Ground, "ground", NamesOr {
    expecting: r#"the frame's points as { "A": [x, y], … }, or their names as ["A", …]"#,
    names: Ground::Names,
    other: Ground::Places,
}, generator => {
    "anyOf": [
        generator.subschema_for::<IndexMap<String, Vector>>(),
        { "type": "array", "items": { "type": "string" }, "description": "Names only, in a drawn configuration" },
    ]
});

/// The names of the frame's points, and all coordinates that the scene gives.
pub(super) fn ground(
    given_by: GivenBy,
    ground: Option<Ground>,
    points: Option<IndexMap<String, Vector>>,
) -> Result<(Vec<String>, Coordinates), Wrong> {
    let mut coordinates = Coordinates::new();
    for (name, Vector(place)) in points.unwrap_or_default() {
        check_name("a point", &name).map_err(|wrong| wrong.inside(&["points", &name]))?;
        coordinates.insert(name, place);
    }
    let names = match ground {
        None => Vec::new(),
        Some(Ground::Names(_)) if given_by == GivenBy::Lengths => {
            let hint = r#"write { "A": [x, y], … }; or give the coordinates of every point in "points": { … }"#;
            return Err(Wrong::value(&["ground"], "the frame's points have no coordinates").hint(hint));
        }
        Some(Ground::Names(names)) => {
            check_list(&names, "").map_err(|wrong| wrong.inside(&["ground"]))?;
            names
        }
        Some(Ground::Places(places)) => {
            let mut names = Vec::with_capacity(places.len());
            for (name, Vector(place)) in places {
                check_name("a point", &name).map_err(|wrong| wrong.inside(&["ground", &name]))?;
                if coordinates.get(&name).is_some_and(|other| *other != place) {
                    let message = format!("point {name} has other coordinates in `points`");
                    let hint = "name it only in a list: \"ground\": [\"A\", …]";
                    return Err(Wrong::value(&["ground", &name], message).hint(hint));
                }
                coordinates.insert(name.clone(), place);
                names.push(name);
            }
            names
        }
    };
    Ok((names, coordinates))
}

/// Refuses points without coordinates, points on no link and not on the ground, names that results need, and links of
/// zero length.
pub(super) fn check_points(given_by: GivenBy, names: &Names<'_>, coordinates: &Coordinates) -> Result<(), Wrong> {
    let place_of = |point: &str| {
        coordinates.get(point).copied().ok_or_else(|| {
            let near = close(point, coordinates.keys().map(String::as_str));
            let hint = near.unwrap_or_else(|| format!("add \"{point}\": [x, y] to `points`"));
            Wrong::key(&[], format!("point {point} has no coordinates in `points`")).hint(hint)
        })
    };
    for (index, point) in names.ground.iter().enumerate() {
        names
            .check_reserved(point)
            .and_then(|()| place_of(point))
            .map_err(|wrong| wrong.at_first(&[&["ground", &index.to_string()], &["ground", point]]))?;
    }
    for (name, link) in names.links {
        let mut places = Vec::with_capacity(link.points.len());
        for (index, point) in link.points.iter().enumerate() {
            // A scene given by lengths has no places of moving points yet.
            let place = || if given_by == GivenBy::Drawing { place_of(point).map(Some) } else { Ok(None) };
            let place = names.check_reserved(point).and_then(|()| place()).map_err(|wrong| {
                let index = index.to_string();
                wrong.at_first(&[&["points", &index], &["shape", point], &[&index]]).inside(&["links", name])
            })?;
            places.extend(place.map(|place| (point.as_str(), place)));
        }
        check_apart(name, places.into_iter()).map_err(|(_, wrong)| wrong.inside(&["links", name]))?;
    }
    if let Some(point) = coordinates.keys().find(|point| !names.is_point(point)) {
        let all = names.links.values().flat_map(|link| &link.points).map(String::as_str);
        let hint = close(point, all).unwrap_or_else(|| "name it in the `points` of a link, or remove it".into());
        let message = format!("point {point} is on no link and not on the ground");
        return Err(Wrong::key(&["points", point], message).hint(hint));
    }
    Ok(())
}

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
