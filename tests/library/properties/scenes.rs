//! Random scenes: the templates with other lengths, places and drives, and random groups.

use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::{Value, json};
use std::fmt;
use std::sync::LazyLock;
use support::files::templates;
use support::groups::{Group, regular_patterns};
use support::planted::{Planted, pattern};
use support::random::Random;

/// A scene, shown as its text.
#[derive(Clone)]
pub struct Scene(pub Value);

impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

/// By how much lengths and places of a template vary, in parts of themselves.
const VARIES: f64 = 0.08;

/// How far a drive is turned from where it stands in the template, in degrees.
const TURNED: f64 = 20.0;

/// Templates, random groups from lengths, random groups as drawn.
pub fn scenes() -> impl Strategy<Value = Scene> {
    prop_oneof![
        6 => varied(),
        2 => planted(),
        1 => drawn(),
    ]
}

/// A template whose numbers are varied. Simpler is nearer to the template.
pub fn varied() -> impl Strategy<Value = Scene> {
    static TEMPLATES: LazyLock<Vec<Value>> = LazyLock::new(|| {
        // Where a rack stands when its wheel stands at 0 is held to its own truth: racks.rs.
        let texts = templates().into_iter().filter(|(_, text)| !text.contains("\"rack\""));
        let read = |(_, text): (_, String)| bare(&serde_json::from_str(&text).expect("JSON"));
        texts.map(read).collect()
    });
    let drive = (-1.0..1.0_f64, 0.1..10.0_f64, any::<bool>(), -2.0..2.0_f64);
    (0..TEMPLATES.len(), vec(-1.0..1.0_f64, 8..32), drive).prop_map(|(which, lots, drive)| {
        let mut scene = TEMPLATES[which].clone();
        let mut lots = lots.into_iter().cycle();
        vary(&mut scene, &mut || 1.0 + VARIES * lots.next().expect("they begin again"));
        let (turn, omega, reversed, alpha) = drive;
        let omega = if reversed { -omega } else { omega };
        for link in scene["links"].as_object_mut().expect("links by name").values_mut() {
            if let Some(drive) = link.get_mut("drive") {
                let angle = drive["angle"].as_f64().expect("from lengths");
                *drive = json!({ "angle": angle + TURNED * turn, "omega": omega, "alpha": alpha * omega * omega });
            }
        }
        Scene(scene)
    })
}

/// A random group of the second, third or fourth class with a crank, from lengths.
fn planted() -> impl Strategy<Value = Scene> {
    any::<u64>().no_shrink().prop_map(|seed| {
        let mut random = Random(seed);
        let class = ["II", "III", "IV"][random.below(3)];
        let (kinds, joints) = pattern(&mut random, class);
        let planted = Planted::new(&mut random, &kinds, &joints);
        Scene(serde_json::from_str(&planted.scene()).expect("JSON"))
    })
}

/// A random fourth-class group as drawn, none of the hard ones: changes of these round.
fn drawn() -> impl Strategy<Value = Scene> {
    any::<u64>().no_shrink().prop_map(|seed| {
        let mut random = Random(seed);
        let patterns = regular_patterns();
        let which = random.below(patterns.len());
        Scene(Group::plain(&mut random, &patterns[which]).scene())
    })
}

/// A scene without what does not count: notes, title, figure.
fn bare(scene: &Value) -> Value {
    const IDLE: [&str; 4] = ["note", "title", "figure", "$schema"];
    match scene {
        Value::Object(entries) => {
            let kept = entries.iter().filter(|(key, _)| !IDLE.contains(&key.as_str()));
            kept.map(|(key, value)| (key.clone(), bare(value))).collect()
        }
        Value::Array(elements) => elements.iter().map(bare).collect(),
        other => other.clone(),
    }
}

/// Varies lengths, places and given motions.
fn vary(scene: &mut Value, factor: &mut impl FnMut() -> f64) {
    for key in ["ground", "points", "known"] {
        each_number(&mut scene[key], factor);
    }
    for link in scene["links"].as_object_mut().expect("links by name").values_mut() {
        for key in ["lengths", "shape", "motion"] {
            if let Some(part) = link.get_mut(key) {
                each_number(part, factor);
            }
        }
    }
    for slider in scene["sliders"].as_array_mut().into_iter().flatten() {
        for key in ["through", "drive"] {
            if let Some(part) = slider.get_mut(key) {
                each_number(part, factor);
            }
        }
    }
    for contact in scene["contacts"].as_array_mut().into_iter().flatten() {
        each_number(&mut contact["radii"], factor);
    }
    scene.as_object_mut().expect("an object").retain(|_, value| !value.is_null());
}

fn each_number(node: &mut Value, factor: &mut impl FnMut() -> f64) {
    match node {
        Value::Number(number) => *node = json!(factor() * number.as_f64().expect("finite")),
        Value::Array(elements) => elements.iter_mut().for_each(|e| each_number(e, factor)),
        Value::Object(entries) => entries.values_mut().for_each(|e| each_number(e, factor)),
        _ => {}
    }
}
