//! The frame and the points: every point has a place where the form needs one, and every name is a point of something.

use std::collections::HashSet;

use indexmap::IndexMap;

use super::check_lengths::coincident;
use super::check_links::DRAWN;
use super::error::SceneError;
use super::file::PointMotionFile;
use super::forms::{Ground, NearValue, Vector};
use super::link::Link;
use super::names::{Names, check_name};
use super::place::{Source, Spot};
use super::slider::Slider;
use super::words::close;
use super::{Form, Near, On, PointMotion};

/// Coordinates by the name of a point.
type Coordinates = IndexMap<String, [f64; 2]>;

/// The names of the frame's points and the coordinates that the scene gives.
pub(super) fn ground(
    source: Source<'_>,
    form: Form,
    ground: Option<Ground>,
    points: Option<IndexMap<String, Vector>>,
) -> Result<(Vec<String>, Coordinates), SceneError> {
    let invalid = |path: &[&str], (message, hint)| source.error_with(path, Spot::Key, message, hint);
    let mut coordinates = Coordinates::new();
    for (name, Vector(place)) in points.into_iter().flatten() {
        check_name("a point", &name).map_err(|wrong| invalid(&["points", &name], wrong))?;
        coordinates.insert(name, place);
    }
    let mut names = Vec::new();
    match ground {
        None => {}
        Some(Ground::Names(_)) if form == Form::Lengths => {
            let hint = r#"write { "A": [x, y], … }; or give the coordinates of every point in "points": { … }"#;
            return Err(source.error(&["ground"], "the frame's points have no coordinates").hint(hint));
        }
        Some(Ground::Names(list)) => {
            let mut seen = HashSet::new();
            for (index, name) in list.into_iter().enumerate() {
                let index = index.to_string();
                check_name("a point", &name).map_err(|wrong| invalid(&["ground", &index], wrong))?;
                if !seen.insert(name.clone()) {
                    return Err(source.error(&["ground", &index], format!("point {name} stands twice")));
                }
                names.push(name);
            }
        }
        Some(Ground::Places(places)) => {
            for (name, Vector(place)) in places {
                let path = ["ground", &name];
                check_name("a point", &name).map_err(|wrong| invalid(&path, wrong))?;
                if coordinates.get(&name).is_some_and(|other| *other != place) {
                    let message = format!("point {name} has other coordinates in `points`");
                    return Err(source.error(&path, message).hint("name it only in a list: \"ground\": [\"A\", …]"));
                }
                coordinates.insert(name.clone(), place);
                names.push(name);
            }
        }
    }
    Ok((names, coordinates))
}

/// Errors at points without coordinates, points that are on nothing, names kept for results, and zero-length links.
pub(super) fn check_points(
    source: Source<'_>,
    form: Form,
    names: &Names<'_>,
    ground: &[String],
    links: &IndexMap<String, Link>,
    coordinates: &Coordinates,
) -> Result<(), SceneError> {
    let place_of = |point: &str| {
        coordinates.get(point).copied().ok_or_else(|| {
            let known = close(point, coordinates.keys().map(String::as_str));
            let hint = known.unwrap_or_else(|| format!("add \"{point}\": [x, y] to `points`"));
            (format!("point {point} has no coordinates in `points`"), Some(hint))
        })
    };
    for (index, point) in ground.iter().enumerate() {
        names.check_reserved(point).and_then(|()| place_of(point)).map_err(|(message, hint)| {
            let index = index.to_string();
            source.error_at_first(&[&["ground", &index], &["ground", point]], message, hint)
        })?;
    }
    for (name, link) in links {
        let mut places = Vec::with_capacity(link.points.len());
        for (index, point) in link.points.iter().enumerate() {
            let mut check = || {
                names.check_reserved(point)?;
                if form == Form::Drawn {
                    places.push((point.as_str(), place_of(point)?));
                }
                Ok(())
            };
            check().map_err(|(message, hint)| {
                let index = index.to_string();
                let link = ["links", name];
                let listed = [link[0], link[1], "points", &index];
                let bare = [link[0], link[1], &index];
                let shape = [link[0], link[1], "shape", point];
                source.error_at_first(&[&listed, &shape, &bare], message, hint)
            })?;
        }
        if let Some((first, second)) = coincident(places.into_iter()) {
            let message = format!("link {name} has {first} and {second} in one place: a zero-length link");
            return Err(source.error(&["links", name], message).hint("use one name for both, or move one"));
        }
    }
    if let Some(point) = coordinates.keys().find(|point| !names.is_point(point)) {
        let message = format!("point {point} is on no link and not on the ground");
        let all = links.values().flat_map(|link| &link.points).map(String::as_str);
        let hint = close(point, all).unwrap_or_else(|| "name it in the `points` of a link, or remove it".into());
        return Err(source.key_error(&["points", point], message).hint(hint));
    }
    Ok(())
}

/// The points whose motion is known.
pub(super) fn known(
    source: Source<'_>,
    form: Form,
    names: &Names<'_>,
    file: Option<IndexMap<String, PointMotionFile>>,
) -> Result<IndexMap<String, PointMotion>, SceneError> {
    if file.is_some() && form == Form::Lengths {
        let hint = r#"give the coordinates of every point in "points": { … }, or drive a link"#;
        return Err(source.key_error(&["known"], "known motions belong to a drawn configuration").hint(hint));
    }
    let mut known = IndexMap::new();
    for (name, motion) in file.into_iter().flatten() {
        let path = ["known", &name];
        names.point(&path, &name)?;
        if names.on_ground(&name) {
            let message = format!("point {name} is on the ground, which does not move");
            return Err(source.key_error(&path, message).hint("remove it here or from `ground`"));
        }
        let acceleration = motion.acceleration.map_or([0.0; 2], |vector| vector.0);
        known.insert(name, PointMotion { velocity: motion.velocity.0, acceleration });
    }
    Ok(known)
}

/// Errors at points whose motion is given twice: by `known`, by the motion or the drive of a link, by the drive of a
/// slider on the ground.
pub(super) fn check_given_once(
    source: Source<'_>,
    names: &Names<'_>,
    known: &IndexMap<String, PointMotion>,
    sliders: &[Slider],
) -> Result<(), SceneError> {
    // What gives the motion of a point, in words, by the point.
    let mut given: IndexMap<&str, String> = IndexMap::new();
    let mut give = |point, whose: &str, path: &[&str]| match given.insert(point, whose.to_owned()) {
        None => Ok(()),
        Some(first) => {
            let message = format!("the motion of point {point} is given twice: by {first} and by {whose}");
            Err(source.error(path, message).hint("keep one of them"))
        }
    };
    // A slider driven along a moving link says how two links move against each other, of no point how it moves.
    let driven = |s: &Slider| s.drive.is_some() && s.on == On::Ground;
    for (name, link) in names.links() {
        let pushes = |s: &Slider| driven(s) && s.link.as_ref() == Some(name);
        let whose = match (&link.motion, &link.drive) {
            (Some(_), _) => format!("the `motion` of link {name}"),
            (None, Some(_)) => format!("the drive of link {name}"),
            (None, None) if sliders.iter().any(pushes) => format!("the drive of slider {name}"),
            (None, None) => continue,
        };
        for point in link.points.iter().filter(|point| !names.on_ground(point)) {
            give(point, &whose, &["links", name])?;
        }
    }
    for (index, slider) in sliders.iter().enumerate() {
        if let Some(pin) = slider.pin.as_ref().filter(|_| driven(slider)) {
            let path = ["sliders", &index.to_string()];
            give(pin, "the drive of its slider", &path)?;
        }
    }
    for point in known.keys() {
        if let Some(whose) = given.get(point.as_str()) {
            let message = format!("the motion of point {point} is given already, by {whose}");
            return Err(source.key_error(&["known", point], message).hint("keep one of them"));
        }
    }
    Ok(())
}

/// The approximate positions.
pub(super) fn near(
    source: Source<'_>,
    form: Form,
    names: &Names<'_>,
    file: Option<IndexMap<String, NearValue>>,
) -> Result<Near, SceneError> {
    if file.is_some() && form == Form::Drawn {
        let message = "a drawn configuration needs no `near`";
        return Err(source.key_error(&["near"], message).hint(format!("remove it: {DRAWN}")));
    }
    let mut near = Near::default();
    for (key, value) in file.into_iter().flatten() {
        let path = ["near", &key];
        let link = key.strip_prefix("angle(").and_then(|rest| rest.strip_suffix(')'));
        match (link, value) {
            (Some(link), NearValue::Degrees(degrees)) => {
                names.link(&path, link)?;
                near.angles_deg.insert(link.to_owned(), degrees);
            }
            (Some(_), NearValue::Vector(_)) => {
                return Err(source.error(&path, format!("{key} is one number, in degrees, not two")));
            }
            (None, NearValue::Vector(place)) => {
                names.point(&path, &key)?;
                near.points.insert(key, place);
            }
            (None, NearValue::Degrees(_)) => {
                names.point(&path, &key)?;
                return Err(source.error(&path, format!("point {key} needs two numbers [x, y], found one")));
            }
        }
    }
    Ok(near)
}
