//! New links, points and sliders, with lengths and places measured in the present position.

use serde::{Deserialize, Serialize};
use serde_json::{Value as Json, json};

use super::document::Document;
use super::measure::{self, Decimals, Placed, measured, shape_place};
use super::names::{Named, Names, check_name, no_such};
use super::present::Present;
use super::says;
use crate::geometry::Point;
use crate::message::Message;
use crate::scene::{LengthUnit, SceneError, Units, pair};

/// A new link.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct NewLink {
    /// Its points. One that the scene has already becomes a joint.
    pub points: Vec<PlacedPoint>,
}

/// A point where it is, or is to be, in the present position.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct PlacedPoint {
    /// Its name.
    pub name: String,
    /// Its place in the fixed frame, in units of length.
    pub at: [f64; 2],
}

/// A further point of a link.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct NewPoint {
    /// The link, or `ground`.
    pub link: String,
    /// The point's name.
    pub name: String,
    /// Its place in the present position, in the fixed frame.
    pub at: [f64; 2],
}

/// A new slider.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct NewSlider {
    /// The sliding link; empty for a pin in a slot.
    pub link: String,
    /// The point of it that is on the guide, or the pin.
    pub at: String,
    /// What carries the guide: a link, or `ground`.
    pub on: String,
    /// The guide's direction: degrees, or two points of its carrier as `BE`.
    pub along: Along,
}

/// The direction of a new guide.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Along {
    /// From +x on the ground, from the carrier's axis otherwise.
    Degrees(f64),
    /// Two points of the carrier.
    Points(String),
}

/// The text of a scene without links, to begin with: two fixed points A and D.
#[must_use]
pub fn blank(units: Units) -> String {
    // About 200 mm apart.
    let apart = match units.length {
        LengthUnit::Mm => "200",
        LengthUnit::Cm => "20",
        LengthUnit::M => "0.2",
        LengthUnit::In => "8",
        LengthUnit::Ft => "1",
    };
    format!(
        r#"{{
  "kinegon": 1,
  "units": {{ "length": "{}", "time": "{}" }},
  "ground": {{ "A": [0, 0], "D": [{apart}, 0] }},
  "links": {{}}
}}
"#,
        units.length.as_str(),
        units.time.as_str(),
    )
}

/// Adds a link between points.
pub(super) fn link(document: &mut Document<'_>, new: &NewLink) -> Result<(), SceneError> {
    let names = Names::of(&document.json());
    let present = Present::of(document);
    let points: Vec<Placed<'_>> = new.points.iter().map(|point| (point.name.as_str(), Point::from(point.at))).collect();
    for (index, (name, _)) in points.iter().enumerate() {
        check_name(document, Named::Point, name)?;
        if points[..index].iter().any(|(other, _)| other == name) {
            return Err(document.error(&[], says::point_twice(*name), None));
        }
    }
    if points.is_empty() {
        return Err(document.error(&[], says::no_points(), Some(says::name_one())));
    }
    let decimals = Decimals::of_size(present.size(points.iter().map(|(_, place)| *place)));
    let link = free_name(&names);
    let list = Json::from(points.iter().map(|(name, _)| *name).collect::<Vec<_>>());
    let entry = if names.drawn.is_some() {
        list
    } else {
        match measured(document, &link, &points, decimals)? {
            Some(("shape", shape)) => json!({ "shape": shape }),
            Some((key, lengths)) => json!({ "points": list, key: lengths }),
            None => json!({ "points": list }),
        }
    };
    document.set(&["links", &link], &entry)?;
    let is_triangle = has_three_lengths(&entry);
    for (name, place) in points {
        if !names.has_point(name) || is_triangle {
            place_point(document, &names, name, place, decimals)?;
        }
    }
    Ok(())
}

/// Adds a point to a link or to the ground.
pub(super) fn point(document: &mut Document<'_>, new: &NewPoint) -> Result<(), SceneError> {
    let NewPoint { link, name, at } = new;
    let place = Point::from(*at);
    let names = Names::of(&document.json());
    check_name(document, Named::Point, name)?;
    if names.of_carrier(link).contains(name) {
        return Err(document.error(&["links", link], says::point_on_link(link, name), None));
    }
    let present = Present::of(document);
    let decimals = Decimals::of_size(present.size([place]));
    if link == "ground" {
        let is_list = document.json()["ground"].is_array();
        if is_list {
            document.set(&["ground", &names.ground.len().to_string()], &Json::from(name.as_str()))?;
        }
        let table = if is_list { "points" } else { "ground" };
        return document.set(&[table, name], &decimals.place_json(place));
    }
    let Some(points) = names.links.get(link) else {
        return Err(no_such(document, Named::Link, link, &names.links.keys().cloned().collect::<Vec<_>>()));
    };
    if names.drawn.is_none() {
        let entry = with_point(document, &present, link, points, (name, place), decimals)?;
        let is_triangle = has_three_lengths(&entry);
        document.set(&["links", link], &entry)?;
        let others = points.iter().filter_map(|point| Some((point, *present.places.get(point)?)));
        for (point, place) in others.filter(|_| is_triangle) {
            place_point(document, &names, point, place, decimals)?;
        }
    } else {
        let index = points.len().to_string();
        let is_list = document.json()["links"][link].is_array();
        let path: &[&str] = if is_list { &["links", link, &index] } else { &["links", link, "points", &index] };
        document.set(path, &Json::from(name.as_str()))?;
    }
    if names.has_point(name) { Ok(()) } else { place_point(document, &names, name, place, decimals) }
}

/// The entry of a link given by lengths or a shape, with one more point.
fn with_point(
    document: &Document<'_>,
    present: &Present,
    link: &str,
    points: &[String],
    (name, place): Placed<'_>,
    decimals: Decimals,
) -> Result<Json, SceneError> {
    let mut entry = document.json()["links"][link].clone();
    if !entry.is_object() {
        entry = json!({ "points": points });
    }
    let unknown = |message: Message| document.error(&["links", link], message, Some(says::rough_places()));
    if let Some(list) = entry.get_mut("points").and_then(Json::as_array_mut) {
        list.push(name.into());
    }
    if let Some(shape) = entry.get_mut("shape").and_then(Json::as_object_mut) {
        let placement = present.placement(link, shape).ok_or_else(|| unknown(says::link_unknown(link)))?;
        shape.insert(name.to_owned(), shape_place(decimals.place(placement.inverse() * place)));
        return Ok(entry);
    }
    let mut placed: Vec<Placed<'_>> = Vec::with_capacity(points.len() + 1);
    for point in points {
        let place = present.places.get(point).ok_or_else(|| unknown(says::point_unknown(point)))?;
        placed.push((point, *place));
    }
    placed.push((name, place));
    let Some((key, mut measures)) = measured(document, link, &placed, decimals)? else {
        return Ok(entry);
    };
    let before = entry.as_object_mut().and_then(|entry| entry.shift_remove("lengths"));
    if key == "shape" {
        if let Some(entry) = entry.as_object_mut() {
            entry.shift_remove("points");
        }
    } else if let Some(before) = before.as_ref().and_then(Json::as_object) {
        // The lengths that are there stay, in their order and with the digits that they have.
        let added = measures.as_object().cloned().unwrap_or_default().into_iter();
        let is_new = |key: &String| pair(key, points).is_none();
        let kept = before.clone().into_iter().chain(added.filter(|(key, _)| is_new(key)));
        measures = Json::Object(kept.collect());
    }
    entry[key] = measures;
    Ok(entry)
}

fn has_three_lengths(link: &Json) -> bool {
    link["lengths"].as_object().is_some_and(|lengths| lengths.len() == 3)
}

/// Says where a point is: in the drawing, or roughly in `near` unless it is fixed or said there already.
fn place_point(
    document: &mut Document<'_>,
    names: &Names,
    name: &str,
    place: Point,
    decimals: Decimals,
) -> Result<(), SceneError> {
    let table = if names.drawn.is_some() { "points" } else { "near" };
    let is_said = document.json()[table].get(name).is_some() || names.ground.iter().any(|point| point == name);
    if is_said { Ok(()) } else { document.set(&[table, name], &decimals.place_json(place)) }
}

/// Adds a slider.
pub(super) fn slider(document: &mut Document<'_>, new: &NewSlider) -> Result<(), SceneError> {
    let NewSlider { link, at, on, along } = new;
    let names = Names::of(&document.json());
    let is_known = |name: &str| ["", "ground"].contains(&name) || names.links.contains_key(name);
    if let Some(unknown) = [link, on].into_iter().find(|name| !is_known(name)) {
        return Err(no_such(document, Named::Link, unknown, &names.links.keys().cloned().collect::<Vec<_>>()));
    }
    let sliding = if link.is_empty() { names.points() } else { names.of_carrier(link).to_vec() };
    if !sliding.contains(at) {
        return Err(no_such(document, Named::Point, at, &sliding));
    }
    if names.of_carrier(on).contains(at) {
        return Err(document.error(&[], says::slides_on_own(at, on), Some(says::other_point())));
    }
    let mut entry = match link.is_empty() {
        true => json!({ "pin": at, "on": on }),
        false => json!({ "link": link, "at": at, "on": on }),
    };
    if let (Along::Degrees(_), None) = (along, &names.drawn)
        && let Some(through) = through(document, on, at)
    {
        entry["through"] = through;
    }
    entry["along"] = match along {
        Along::Degrees(degrees) => measure::json(*degrees),
        Along::Points(points) => Json::from(points.as_str()),
    };
    match document.json()["sliders"].as_array().map(Vec::len) {
        None => document.set(&["sliders"], &json!([entry])),
        Some(count) => document.set(&["sliders", &count.to_string()], &entry),
    }
}

/// The place of a guide that goes through a point where this is now; `None` where it cannot be said.
fn through(document: &Document<'_>, on: &str, at: &str) -> Option<Json> {
    let present = Present::of(document);
    let place = *present.places.get(at)?;
    let decimals = Decimals::of_size(present.size([]));
    if on == "ground" {
        return Some(decimals.place_json(place));
    }
    let scene = document.json();
    let shape = scene["links"][on]["shape"].as_object()?;
    let placement = present.placement(on, shape)?;
    Some(decimals.place_json(placement.inverse() * place))
}

/// The smallest number that no link has.
fn free_name(names: &Names) -> String {
    let points = names.points();
    let is_kept = |number: &str| {
        let is_beside = |point: &String| {
            point.strip_prefix('S') == Some(number) || point.split_once('_').is_some_and(|(_, link)| link == number)
        };
        names.links.contains_key(number)
            || names.equivalents.iter().any(|link| link == number)
            || points.iter().any(is_beside)
    };
    let mut numbers = (1..).map(|number: usize| number.to_string());
    numbers.find(|number| !is_kept(number)).unwrap_or_default()
}
