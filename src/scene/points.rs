//! The frame and the points: their coordinates where they are needed, given motions, none of them twice, and rough places
//! that choose the assembly.

use indexmap::IndexMap;

use super::error::{Wrong, close};
use super::given::{GivenBy, PointMotion};
use super::joint::{On, Slider};
use super::link::{Link, check_apart};
use super::name::{Bearer, check_list, check_name};
use super::names::{Coordinates, Names};
use super::quantity_name::QuantityName;
use super::says;
use super::value::{At, NamesOr, NearValue, Vector, several_forms};
use super::write::write_forms;
use crate::message::Message;

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
        check_name(Bearer::Point, &name).map_err(|wrong| wrong.inside(&["points", &name]))?;
        coordinates.insert(name, place);
    }
    let names = match ground {
        None => Vec::new(),
        Some(Ground::Names(_)) if given_by == GivenBy::Lengths => {
            return Err(Wrong::value(&["ground"], says::no_coordinates()).hint(says::write_coordinates()));
        }
        Some(Ground::Names(names)) => {
            check_list(&names, None).map_err(|wrong| wrong.inside(&["ground"]))?;
            names
        }
        Some(Ground::Places(places)) => {
            let mut names = Vec::with_capacity(places.len());
            for (name, Vector(place)) in places {
                check_name(Bearer::Point, &name).map_err(|wrong| wrong.inside(&["ground", &name]))?;
                if coordinates.get(&name).is_some_and(|other| *other != place) {
                    let message = says::other_coordinates(&name);
                    return Err(Wrong::value(&["ground", &name], message).hint(says::name_only()));
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
            let hint = near.unwrap_or_else(|| says::add_to_points(point));
            Wrong::key(&[], says::not_in_points(point)).hint(hint)
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
        let hint = close(point, all).unwrap_or_else(says::name_in_link);
        return Err(Wrong::key(&["points", point], says::on_no_link(point)).hint(hint));
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
        return Err(Wrong::key(&["known"], says::known_is_drawn()).hint(says::points_or_drive()));
    }
    let known = file.unwrap_or_default();
    for name in known.keys() {
        names.point(&["known", name], name)?;
        if names.on_ground(name) {
            return Err(Wrong::key(&["known", name], says::ground_moves_not(name)).hint(says::remove_from_ground()));
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
    let mut given: IndexMap<&str, Message> = IndexMap::new();
    let mut give = |point, whose: &Message, path: &[&str]| match given.insert(point, whose.clone()) {
        None => Ok(()),
        Some(first) => {
            let message = says::motion_twice(point, first, whose.clone());
            Err(Wrong::value(path, message).hint(says::keep_one()))
        }
    };
    // A slider driven on a moving link gives a relative motion only, which is that of no point.
    let driven = |s: &Slider| s.drive.is_some() && s.on == On::Ground;
    for (name, link) in names.links {
        let pushes = |s: &Slider| driven(s) && s.link.as_ref() == Some(name);
        let whose = match link {
            Link { motion: Some(_), .. } => says::motion_of_link(name),
            Link { drive: Some(_), .. } => says::drive_of_link(name),
            _ if sliders.iter().any(pushes) => says::drive_of_slider(name),
            _ => continue,
        };
        for point in link.points.iter().filter(|point| !names.on_ground(point)) {
            give(point, &whose, &["links", name])?;
        }
    }
    for (index, slider) in sliders.iter().enumerate().filter(|(_, slider)| driven(slider)) {
        if let Some(pin) = &slider.pin {
            give(pin, &says::drive_of_its_slider(), &["sliders", &index.to_string()])?;
        }
    }
    for point in known.keys() {
        if let Some(whose) = given.get(point.as_str()) {
            let message = says::motion_already(point, whose.clone());
            return Err(Wrong::key(&["known", point], message).hint(says::keep_one()));
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
        return Err(Wrong::key(&["near"], says::drawn_needs_no_near()).hint(says::remove_it_drawn()));
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
                return Err(Wrong::value(&path, says::near_one_number(&key)));
            }
            (None, value) => {
                names.point(&path, &key)?;
                let NearValue::Vector(place) = value else {
                    return Err(Wrong::value(&path, says::near_two_numbers(&key)));
                };
                near.points.insert(key, place);
            }
        }
    }
    Ok(near)
}
