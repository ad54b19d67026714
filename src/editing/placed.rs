//! Points at other places, and changes that leave points where they were, also in a scene that is not complete.

use serde_json::{Value as Json, json};

use super::document::Document;
use super::draft::{Sketch, sliders};
use super::measure::{self, Decimals, Placed};
use super::names::Names;
use super::position::position_of;
use super::present::Present;
use super::{Edit, Pins, PlacedPoint, Reshape, apply};
use crate::geometry::{Point, Vector, degrees_of};
use crate::scene::{SceneError, pair};

/// The text after some changes, as of [`apply`]. Where the scene cannot be solved after them, what could be known before stays
/// known: the text says in `near` roughly where points are that it no longer tells in another way, so that what is drawn of it stays
/// where it was.
///
/// # Errors
/// As of [`apply`].
pub fn apply_in_place(text: &str, edits: &[Edit]) -> Result<String, SceneError> {
    let changed = apply(text, edits)?;
    let mut document = Document::new(&changed)?;
    if Present::of(&document).solved().is_some() {
        return Ok(changed);
    }
    let before = Present::of(&Document::new(text)?);
    keep_places(&mut document, &before, &|name| !edits.iter().any(|edit| places_anew(edit, name)))?;
    Ok(document.text())
}

/// Says roughly where points are that the text no longer places where they were.
fn keep_places(
    document: &mut Document<'_>,
    before: &Present,
    is_kept: &dyn Fn(&str) -> bool,
) -> Result<(), SceneError> {
    let names = Names::of(&document.json());
    let after = Present::of(document);
    let table = if names.drawn.is_some() { "points" } else { "near" };
    let decimals = Decimals::of_size(before.size([]));
    let moving = before.places.iter().filter(|(name, _)| names.has_point(name) && !names.ground.contains(name));
    for (name, place) in moving.filter(|(name, _)| is_kept(name)) {
        // What was solved is better known than a rough place that the text may have had all along.
        if after.places.get(name).is_none_or(|told| before.solved().is_some() && told != place) {
            document.set(&[table, name], &decimals.place_json(*place))?;
        }
    }
    Ok(())
}

/// Whether a change is about the rough place of a point itself.
fn places_anew(edit: &Edit, name: &str) -> bool {
    let path = match edit {
        Edit::Set { set, .. } => set,
        Edit::Remove { remove } => remove,
        _ => return false,
    };
    path.len() >= 2 && path[0] == "near".into() && path[1] == name.into()
}

/// The text with points at other places. In a scene that can be solved each is pulled there in turn, as by [`Reshape`]; in one
/// that cannot be, or that several points leave together, their places are put down and all that hangs on them is measured anew: lengths,
/// shapes, the angle of a drive, how far a slider is along its guide.
///
/// # Errors
/// The text is not JSON, or there is no such point.
pub fn with_places(text: &str, places: &[PlacedPoint]) -> Result<String, SceneError> {
    let pulled = places.iter().try_fold(text.to_owned(), |text, PlacedPoint { name, at }| {
        Reshape::new(&text, name, &Pins::default())?.to(*at).map(|reshaped| reshaped.text)
    });
    match (pulled, places) {
        (Ok(text), _) => Ok(text),
        // A single joint of a scene that can be solved goes where it is let go, or nowhere.
        (Err(error), [_]) if Present::of(&Document::new(text)?).solved().is_some() => Err(error),
        _ => put_down(text, places),
    }
}

fn put_down(text: &str, places: &[PlacedPoint]) -> Result<String, SceneError> {
    let mut document = Document::new(text)?;
    let names = Names::of(&document.json());
    let before = Present::of(&document);
    let decimals = Decimals::of_size(before.size(places.iter().map(|point| point.at.into())));
    let mut moved = before.clone().told_roughly();
    for PlacedPoint { name, at } in places {
        if !names.has_point(name) {
            return Err(super::names::no_such(&document, super::Named::Point, name, &names.points()));
        }
        let table = match &names.drawn {
            Some(_) => "points",
            None if names.ground.contains(name) => "ground",
            None => "near",
        };
        let place = decimals.place(Point::from(*at));
        document.set(&[table, name], &decimals.place_json(place))?;
        moved.places.insert(name.clone(), place);
    }
    if names.drawn.is_some() {
        return Ok(document.text());
    }
    let is_moved = |name: &String| places.iter().any(|point| point.name == *name);
    for (link, points) in names.links.iter().filter(|(_, points)| points.iter().any(is_moved)) {
        measure_link(&mut document, &moved, link, points, decimals.finer(1))?;
    }
    move_guides(&mut document, &before, &moved, &is_moved, decimals)?;
    if before.solved().is_some() && Present::of(&document).solved().is_none() {
        keep_places(&mut document, &before, &|name| !places.iter().any(|point| point.name == name))?;
    }
    Ok(document.text())
}

/// Measures a link anew: its lengths, its shape, its angle.
fn measure_link(
    document: &mut Document<'_>,
    now: &Present,
    link: &str,
    points: &[String],
    decimals: Decimals,
) -> Result<(), SceneError> {
    let entry = document.json()["links"][link].clone();
    let place = |name: &str| now.places.get(name).copied();
    for (key, _) in entry["lengths"].as_object().into_iter().flatten() {
        let ends = pair(key, points).and_then(|(a, b)| Some((place(&a)?, place(&b)?)));
        if let Some((a, b)) = ends {
            document.set(&["links", link, "lengths", key], &decimals.json((b - a).norm()))?;
        }
    }
    let placed: Option<Vec<Placed<'_>>> = points.iter().map(|name| Some((name.as_str(), place(name)?))).collect();
    let Some(placed) = placed else { return Ok(()) };
    if entry["shape"].is_object() {
        document.set(&["links", link, "shape"], &measure::shape(&placed, decimals))?;
    }
    if let [(_, from), (_, to), ..] = placed.as_slice()
        && let Some(path) = super::position::turning(&entry_in(link, &entry), link)
    {
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        document.set(&path, &Decimals::ANGLE.json(degrees_of(to - from)))?;
    }
    Ok(())
}

/// A scene with this link alone.
fn entry_in(link: &str, entry: &Json) -> Json {
    json!({ "links": { link: entry } })
}

/// Guides on the ground through places where points were go on through these points; driven sliders stand where they are now.
fn move_guides(
    document: &mut Document<'_>,
    before: &Present,
    now: &Present,
    is_moved: &dyn Fn(&String) -> bool,
    decimals: Decimals,
) -> Result<(), SceneError> {
    let scene = document.json();
    for (index, slider) in sliders(&scene).iter().enumerate() {
        let Some(at) = slider["at"].as_str().or(slider["pin"].as_str()).map(str::to_owned) else { continue };
        let number = index.to_string();
        let was = before.places.get(&at).zip(super::present::two_numbers(&slider["through"]));
        let is_through = was.is_some_and(|(place, through)| (place - through).norm() <= decimals.step());
        if let (true, true, Some(place)) = (slider["on"] == *"ground" && is_through, is_moved(&at), now.places.get(&at))
        {
            document.set(&["sliders", &number, "through"], &decimals.place_json(*place))?;
        }
    }
    let sketch = Sketch::of(document, now.clone());
    for index in 0..sliders(&scene).len() {
        let slider = &scene["sliders"][index];
        let place = slider["at"].as_str().and_then(|at| now.places.get(at));
        if let (Some(path), Some(guide), Some(place)) = (position_of(&scene, index), sketch.guide(index), place) {
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            let arm: Vector = place - guide.through;
            document.set(&path, &decimals.json(arm.dot(&guide.along)))?;
        }
    }
    Ok(())
}
