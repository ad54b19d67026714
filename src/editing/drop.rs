//! Removes links and points with all that names them.

use serde_json::{Value as Json, json};

use super::document::Document;
use super::measure;
use super::names::{Named, Names, Renamer, no_such};
use crate::scene::{JOINTS, JointKind, Meaning, SceneError, pair};

/// Removes a link, its sliders, and the points that nothing else has.
pub(super) fn link(document: &mut Document<'_>, name: &str) -> Result<(), SceneError> {
    let names = Names::of(&document.json());
    if let Some(contact) = equivalent(&document.json(), &names, name) {
        document.remove(&["contacts", &contact.to_string()])?;
        return remove_named(document, &names, Named::Link, name);
    }
    let Some(points) = names.links.get(name) else {
        return Err(no_such(document, Named::Link, name, &names.links.keys().cloned().collect::<Vec<_>>()));
    };
    document.remove(&["links", name])?;
    remove_joints(document, Meaning::Link, name)?;
    remove_entries(document, &["forces"], &|load| load["on"] == *name)?;
    remove_entries(document, &["springs"], &|spring| ends(spring).any(|end| end[0] == *name))?;
    remove_friction(document, &names, Named::Link, name)?;
    loosen_pins(document, &names, name)?;
    document.remove(&["near", &format!("angle({name})")])?;
    for list in ["centrodes", "inflection"] {
        remove_entries(document, &["figure", list], &|link| *link == *name)?;
    }
    remove_named(document, &names, Named::Link, name)?;
    let is_elsewhere = |point: &String| {
        names.ground.contains(point) || names.links.iter().any(|(link, points)| link != name && points.contains(point))
    };
    for orphan in points.iter().filter(|point| !is_elsewhere(point)) {
        forget(document, &names, orphan)?;
    }
    Ok(())
}

/// The contact for which a link of this name stands, by its index.
fn equivalent(scene: &Json, names: &Names, link: &str) -> Option<usize> {
    let contacts = scene["contacts"].as_array()?.iter().enumerate();
    let mut of_links = contacts.filter(|(_, contact)| contact["along"].is_null()).map(|(index, _)| index);
    let place = names.equivalents.iter().position(|name| name == link)?;
    of_links.nth(place)
}

/// Removes a point from all links; those that are left without a second point go, unless a joint that the scene lists names them.
pub(super) fn point(document: &mut Document<'_>, name: &str) -> Result<(), SceneError> {
    let names = Names::of(&document.json());
    if !names.has_point(name) {
        return Err(no_such(document, Named::Point, name, &names.points()));
    }
    remove_joints(document, Meaning::Point, name)?;
    remove_wheels(document, &names, name)?;
    remove_faces(document, &names, name)?;
    remove_guides(document, &names, name)?;
    for (link, points) in names.links.iter().filter(|(_, points)| points.iter().any(|point| point == name)) {
        take_from_link(document, link, points, name)?;
    }
    document.remove(&["ground", name])?;
    remove_entries(document, &["ground"], &|point| *point == *name)?;
    forget(document, &names, name)?;
    let left = Names::of(&document.json());
    let scene = document.json();
    let names_link = |kind: &JointKind, link: &str| {
        let mut joints = scene[kind.list].as_array().into_iter().flatten();
        joints.any(|joint| kind.words(joint, Meaning::Link).any(|word| word == link))
    };
    let is_joined = |link: &str| JOINTS.iter().any(|kind| names_link(kind, link));
    let had = |link: &String| names.links.get(link).is_some_and(|points| points.iter().any(|point| point == name));
    let short = |(link, points): &(&String, &Vec<String>)| {
        had(link) && (points.is_empty() || (points.len() == 1 && !is_joined(link)))
    };
    left.links.iter().filter(short).try_for_each(|(name, _)| link(document, name))
}

/// Removes a point from a link.
fn take_from_link(document: &mut Document<'_>, link: &str, points: &[String], name: &str) -> Result<(), SceneError> {
    let scene = document.json();
    let entry = &scene["links"][link];
    let lengths = entry["lengths"].as_object().into_iter().flatten().map(|(key, _)| key);
    for key in lengths.filter(|key| pair(key, points).is_some_and(|(from, to)| from == name || to == name)) {
        document.remove(&["links", link, "lengths", key])?;
    }
    if entry["lengths"].as_object().is_some_and(|lengths| lengths.keys().all(|key| key != "note") && points.len() <= 2)
    {
        document.remove(&["links", link, "lengths"])?;
    }
    document.remove(&["links", link, "shape", name])?;
    if entry["motion"]["at"] == *name {
        let at = match scene["points"].get(name) {
            Some(place) => document.set(&["links", link, "motion", "at"], place),
            None => document.remove(&["links", link, "motion"]),
        };
        at?;
    }
    let list: &[&str] = if entry.is_array() { &["links", link] } else { &["links", link, "points"] };
    remove_entries(document, list, &|point| *point == *name)
}

/// Removes what only says something of a point: its place, its known motion, its label, its path.
fn forget(document: &mut Document<'_>, names: &Names, name: &str) -> Result<(), SceneError> {
    remove_joints(document, Meaning::Point, name)?;
    remove_loads(document, names, name)?;
    for table in ["near", "points", "known"] {
        document.remove(&[table, name])?;
    }
    for list in ["trace", "velocities", "curvature"] {
        remove_entries(document, &["figure", list], &|point| *point == *name)?;
    }
    remove_named(document, names, Named::Point, name)
}

/// The two ends of a spring: a body and a place each.
fn ends(spring: &Json) -> impl Iterator<Item = &Json> {
    spring["between"].as_array().into_iter().flatten()
}

/// Removes the friction of pins and guides that are named by a point or a link.
fn remove_friction(document: &mut Document<'_>, names: &Names, what: Named, name: &str) -> Result<(), SceneError> {
    let renamer = Renamer::new(names, what, name, "\u{1}");
    let is_gone = |friction: &Json| {
        let guide = friction["guide"].as_str();
        (what == Named::Point && friction["pin"] == *name)
            || guide.is_some_and(|name| renamer.plan_name(name).is_some())
    };
    remove_entries(document, &["friction"], &is_gone)
}

/// Removes the friction of pins that were fixed in a link and still join several others, and no longer says in which of two links one is fixed.
fn loosen_pins(document: &mut Document<'_>, names: &Names, link: &str) -> Result<(), SceneError> {
    let has = |points: &[String], pin: &Json| points.iter().any(|point| pin == point);
    let joined = |friction: &Json| {
        let others = names.links.iter().filter(|(name, points)| *name != link && has(points, &friction["pin"])).count();
        others + usize::from(has(&names.ground, &friction["pin"]))
    };
    remove_entries(document, &["friction"], &|friction| friction["fixed_in"] == *link && joined(friction) > 2)?;
    let scene = document.json();
    for (index, friction) in scene["friction"].as_array().into_iter().flatten().enumerate() {
        if !friction["fixed_in"].is_null() && joined(friction) <= 2 {
            document.remove(&["friction", &index.to_string(), "fixed_in"])?;
        }
    }
    Ok(())
}

/// Removes what loads links at a point: forces, springs and friction there, and masses with their centre there.
fn remove_loads(document: &mut Document<'_>, names: &Names, point: &str) -> Result<(), SceneError> {
    remove_entries(document, &["forces"], &|load| load["at"] == *point)?;
    remove_entries(document, &["springs"], &|spring| ends(spring).any(|end| end[1] == *point))?;
    remove_friction(document, names, Named::Point, point)?;
    let scene = document.json();
    for (link, _) in scene["links"].as_object().into_iter().flatten().filter(|(_, link)| link["center"] == *point) {
        for key in ["mass", "weight", "inertia", "center"] {
            document.remove(&["links", link, key])?;
        }
    }
    Ok(())
}

/// Removes the joints that name a point or a link.
fn remove_joints(document: &mut Document<'_>, what: Meaning, name: &str) -> Result<(), SceneError> {
    JOINTS.into_iter().try_for_each(|kind| {
        remove_entries(document, &[kind.list], &|joint| kind.words(joint, what).any(|word| word == name))
    })
}

/// Removes the gear pairs of which a wheel turns on its carrier about a point.
fn remove_wheels(document: &mut Document<'_>, names: &Names, point: &str) -> Result<(), SceneError> {
    let has = |body: &Json| match body.as_str() {
        Some("ground") => names.ground.iter().any(|own| own == point),
        body => body.and_then(|link| names.links.get(link)).is_some_and(|points| points.iter().any(|own| own == point)),
    };
    let is_center = |gear: &Json| has(&gear["on"]) && gear["mesh"].as_array().into_iter().flatten().any(has);
    remove_entries(document, &["gears"], &is_center)
}

/// Removes the contacts with a flat profile that goes through a point.
fn remove_faces(document: &mut Document<'_>, names: &Names, point: &str) -> Result<(), SceneError> {
    let is_end = |contact: &Json| {
        let points = names.of_carrier(contact["links"][1].as_str().unwrap_or_default());
        let ends = contact["along"].as_str().and_then(|key| pair(key, points));
        ends.is_some_and(|(from, to)| from == point || to == point)
    };
    remove_entries(document, &["contacts"], &|contact| contact["through"] == *point || is_end(contact))
}

/// Removes entries of the list at a path, if there is a list.
fn remove_entries(
    document: &mut Document<'_>,
    path: &[&str],
    is_gone: &dyn Fn(&Json) -> bool,
) -> Result<(), SceneError> {
    let scene = document.json();
    let list = path.iter().fold(&scene, |around, key| &around[*key]);
    let entries = || list.as_array().into_iter().flatten().enumerate();
    let gone: Vec<String> = entries().filter(|(_, entry)| is_gone(entry)).map(|(index, _)| index.to_string()).collect();
    // An empty list in the figure would ask for nothing, where the key left out asks for what is usual.
    if path.len() > 1 && !gone.is_empty() && gone.len() == entries().count() {
        return document.remove(path);
    }
    gone.iter().rev().try_for_each(|index| document.remove(&[path, &[index]].concat()))
}

/// Lets guides that a point defines go on without it: in the direction that coordinates give, else along the axis.
fn remove_guides(document: &mut Document<'_>, names: &Names, name: &str) -> Result<(), SceneError> {
    let scene = document.json();
    let place = |point: &str| {
        let place = [&scene["points"], &scene["ground"]].into_iter().find_map(|table| table.get(point))?;
        Some([place[0].as_f64()?, place[1].as_f64()?])
    };
    for (index, slider) in scene["sliders"].as_array().into_iter().flatten().enumerate() {
        let index = index.to_string();
        let is_first = names.ground.first().is_some_and(|first| first == name);
        let is_usual =
            slider["on"] == *"ground" && slider["through"].is_null() && !slider["along"].is_string() && is_first;
        if slider["through"] == *name || (is_usual && names.drawn.is_none()) {
            let place = place(name).filter(|_| slider["on"] == *"ground");
            document.set(&["sliders", &index, "through"], &json!(place.map(|place| place.map(measure::json))))?;
        }
        let ends = slider["along"].as_str().and_then(|key| pair(key, names.of_carrier(names.carrier(&index))));
        let Some((from, to)) = ends.filter(|(from, to)| from == name || to == name) else {
            continue;
        };
        let is_fixed = names.drawn.is_some() || slider["on"] == *"ground";
        let direction = place(&from).zip(place(&to)).filter(|_| is_fixed);
        let direction = direction.map(|(a, b)| [b[0] - a[0], b[1] - a[1]]).filter(|along| *along != [0.0, 0.0]);
        document.set(&["sliders", &index, "along"], &json!(direction.map(|along| along.map(measure::json))))?;
    }
    Ok(())
}

/// Removes labels and quantities that mean a point or a link.
fn remove_named(document: &mut Document<'_>, names: &Names, what: Named, name: &str) -> Result<(), SceneError> {
    let scene = document.json();
    // What another name would change means this one.
    let renamer = Renamer::new(names, what, name, "\u{1}");
    let labels = scene["figure"]["labels"].as_object().into_iter().flatten();
    for (label, _) in labels.filter(|(label, _)| renamer.plan_name(label).is_some()) {
        document.remove(&["figure", "labels", label])?;
    }
    let asked = scene["form"].as_object().into_iter().flatten();
    for (quantity, _) in asked.filter(|(quantity, _)| renamer.quantity(quantity).is_some()) {
        document.remove(&["form", quantity])?;
    }
    let is_gone = |quantity: &Json| quantity.as_str().is_some_and(|name| renamer.quantity(name).is_some());
    remove_entries(document, &["figure", "centers"], &is_gone)?;
    remove_entries(document, &["want"], &is_gone)
}
