//! A scene a moment later or earlier, and what differences of positions say of its rates.

use super::comparison::entries;
use super::stages::solved;
use kinegon::Error;
use kinegon::format::ResultFile;
use serde_json::Value;

/// The scene a moment later or earlier: every drive turned or pushed as its rates say, on the branch of `now`.
fn moved(scene: &Value, now: &ResultFile, time: f64) -> String {
    let mut scene = scene.clone();
    let is_ground = |scene: &Value, name: &str| scene["ground"].get(name).is_some();
    let places = now.points.iter().filter(|(_, point)| point.on.is_none());
    let near: serde_json::Map<String, Value> = places
        .filter(|(name, _)| !is_ground(&scene, name))
        .map(|(name, point)| (name.clone(), serde_json::json!(point.position)))
        .collect();
    scene["near"] = Value::Object(near);
    let move_on = |drive: &mut Value, [place, first, second]: [&str; 3], unit: f64| {
        let rate = |key: &str| drive.get(key).and_then(Value::as_f64).unwrap_or(0.0);
        let moved = time * (rate(first) + 0.5 * time * rate(second)) * unit;
        drive[place] = (rate(place) + moved).into();
    };
    let links = scene["links"].as_object_mut().expect("links by name");
    for drive in links.values_mut().filter_map(|link| link.get_mut("drive")) {
        move_on(drive, ["angle", "omega", "alpha"], 1_f64.to_degrees());
    }
    let sliders = scene.get_mut("sliders").and_then(Value::as_array_mut);
    for slider in sliders.into_iter().flatten() {
        if let Some(drive) = slider.get_mut("drive") {
            move_on(drive, ["position", "speed", "acceleration"], 1.0);
        }
    }
    scene.to_string()
}

/// The largest rate of a drive in rad per unit of time; a pushed slider's is its speed over its position. None in a drawn configuration,
/// where nothing moves on.
pub fn fastest(scene: &Value) -> Option<f64> {
    if scene.get("points").is_some() {
        return None;
    }
    let turned = entries(&scene["links"]).filter_map(|(_, link)| link["drive"]["omega"].as_f64());
    let sliders = scene["sliders"].as_array().into_iter().flatten();
    let pushed = sliders.filter_map(|slider| {
        let drive = &slider["drive"];
        Some(drive["speed"].as_f64()? / drive["position"].as_f64()?)
    });
    turned.chain(pushed).map(f64::abs).reduce(f64::max)
}

/// Largest errors of central differences of positions: of the first against velocities, of the second against accelerations.
pub fn differences(scene: &Value, now: &ResultFile, time: f64) -> Result<[f64; 2], Error> {
    let before = solved(&moved(scene, now, -time))?.result();
    let after = solved(&moved(scene, now, time))?.result();
    let mut errors = [0.0_f64; 2];
    for (point, here) in now.points.iter().filter(|(_, point)| point.on.is_none()) {
        let place = |result: &ResultFile| result.points[point].position.expect("a place");
        let (a, b, c) = (place(&before), place(now), place(&after));
        let (v, w) = (here.velocity, here.acceleration);
        let (v, w) = (v.expect("asked for"), w.expect("asked for"));
        for i in 0..2 {
            let first = (c[i] - a[i]) / (2.0 * time);
            let second = ((c[i] - b[i]) - (b[i] - a[i])) / (time * time);
            errors[0] = errors[0].max((first - v[i]).abs());
            errors[1] = errors[1].max((second - w[i]).abs());
        }
    }
    Ok(errors)
}
