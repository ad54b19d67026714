//! The same scene with links, points and joints listed in another order.

use super::random::Random;
use serde_json::{Map, Value};

/// A scene's text in another order of its links, of their points behind the two of the axis, of its ground points, its joints, rough places and
/// friction. What the format says by an order stays: a guide without `through` counts from its carrier's first point, moments on the frame count about
/// its first one, and what has no name of its own is called by its number.
pub fn reordered(text: &str, dice: &mut Random) -> String {
    let mut scene: Value = serde_json::from_str(text).expect("a scene is JSON");
    let counts_from_first = |slider: &Value| slider["on"] == "ground" && slider.get("through").is_none();
    let keeps_first = ["forces", "springs", "gravity"].iter().any(|key| scene.get(key).is_some())
        || scene["sliders"].as_array().into_iter().flatten().any(counts_from_first)
        || scene["contacts"].as_array().is_some();
    let entries = scene.as_object_mut().expect("a scene is an object");
    if let Some(ground) = entries.get_mut("ground") {
        shuffle_from(ground, usize::from(keeps_first), dice);
    }
    for key in ["points", "known", "near", "friction", "gears"] {
        entries.get_mut(key).into_iter().for_each(|list| shuffle_from(list, 0, dice));
    }
    for key in ["forces", "springs", "contacts"] {
        let is_named =
            |list: &&mut Value| list.as_array().is_some_and(|all| all.iter().all(|own| own.get("name").is_some()));
        entries.get_mut(key).filter(is_named).into_iter().for_each(|list| shuffle_from(list, 0, dice));
    }
    if let Some(sliders) = entries.get_mut("sliders").filter(|sliders| !has_alike(sliders)) {
        shuffle_from(sliders, 0, dice);
    }
    if let Some(links) = entries.get_mut("links") {
        links.as_object_mut().into_iter().flat_map(Map::values_mut).for_each(|link| shuffle_points(link, dice));
        shuffle_from(links, 0, dice);
    }
    scene.to_string()
}

/// Whether several sliders are called by their number among those of the same two.
fn has_alike(sliders: &Value) -> bool {
    let name = |slider: &Value| [slider["link"].to_string(), slider["pin"].to_string(), slider["on"].to_string()];
    let names: Vec<_> = sliders.as_array().into_iter().flatten().map(name).collect();
    names.iter().enumerate().any(|(index, name)| names[..index].contains(name))
}

fn shuffle_points(link: &mut Value, dice: &mut Random) {
    match link {
        Value::Object(keys) => {
            let has_points = keys.contains_key("points");
            keys.get_mut("points").into_iter().for_each(|points| shuffle_from(points, 2, dice));
            keys.get_mut("lengths").into_iter().for_each(|lengths| shuffle_from(lengths, 0, dice));
            keys.get_mut("shape")
                .into_iter()
                .for_each(|shape| shuffle_from(shape, if has_points { 0 } else { 2 }, dice));
        }
        list => shuffle_from(list, 2, dice),
    }
}

/// Shuffles a list or an object, but for its first entries.
fn shuffle_from(list: &mut Value, first: usize, dice: &mut Random) {
    match list {
        Value::Array(elements) => shuffle(elements, first, dice),
        Value::Object(keys) => {
            let (notes, mut entries): (Vec<_>, Vec<_>) =
                std::mem::take(keys).into_iter().partition(|(key, _)| key == "note");
            shuffle(&mut entries, first, dice);
            keys.extend(entries.into_iter().chain(notes));
        }
        _ => {}
    }
}

fn shuffle<T>(all: &mut [T], first: usize, dice: &mut Random) {
    for last in (first + 1..all.len()).rev() {
        all.swap(last, first + dice.below(last + 1 - first));
    }
}
