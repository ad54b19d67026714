//! A scene's text with another figure or other rough places; all else stands as it stood, to the letter.

use super::error::SceneError;
use super::figure::Figure;
use super::read::Scene;
use super::words::number;
use super::write::text as written;
use jsonc_parser::ParseOptions;
use jsonc_parser::cst::{CstInputValue, CstObject, CstRootNode};
use serde_json::{Map, Value};

/// The scene's text with this figure in place of its own.
///
/// # Errors
/// The text is no scene.
pub fn with_figure(text: &str, figure: &Figure) -> Result<String, SceneError> {
    let own = keys(&Scene::read(text)?.figure);
    let wanted = keys(figure);
    let names = wanted.keys().chain(own.keys().filter(|key| !wanted.contains_key(*key)));
    let changed: Vec<&String> = names.filter(|key| wanted.get(*key) != own.get(*key)).collect();
    Ok(changed_in(text, !changed.is_empty(), |scene| {
        let there = scene.object_value_or_set("figure");
        changed.iter().for_each(|key| put(&there, key, wanted.get(*key)));
    }))
}

/// The scene's text with rough places in place of its own: names as in `near`, with coordinates, or angles in degrees.
///
/// # Errors
/// The text is no scene.
pub fn with_near(text: &str, near: &[(String, Vec<f64>)]) -> Result<String, SceneError> {
    Scene::read(text)?;
    let value = |values: &[f64]| match values {
        [angle] => CstInputValue::Number(number(*angle)),
        place => CstInputValue::Array(place.iter().map(|x| CstInputValue::Number(number(*x))).collect()),
    };
    let entries = near.iter().map(|(name, values)| (name.clone(), value(values)));
    let near = CstInputValue::Object(entries.collect());
    Ok(changed_in(text, true, |scene| match scene.get("near") {
        Some(own) => own.set_value(near),
        None => _ = scene.append("near", near),
    }))
}

/// The keys of a figure that a file has to say.
fn keys(figure: &Figure) -> Map<String, Value> {
    let value = serde_json::from_str(&written(figure));
    if let Ok(Value::Object(keys)) = value { keys } else { Map::new() }
}

/// A scene's text after a change of its tree.
fn changed_in(text: &str, is_changed: bool, change: impl FnOnce(&CstObject)) -> String {
    match CstRootNode::parse(text, &ParseOptions::default()) {
        Ok(root) if is_changed => {
            change(&root.object_value_or_set());
            root.to_string()
        }
        // The reader has taken the same text.
        _ => text.to_owned(),
    }
}

fn put(there: &CstObject, key: &str, value: Option<&Value>) {
    match (there.get(key), value) {
        (Some(own), Some(value)) => own.set_value(input(value)),
        (None, Some(value)) => _ = there.append(key, input(value)),
        (Some(own), None) => own.remove(),
        (None, None) => {}
    }
}

fn input(value: &Value) -> CstInputValue {
    match value {
        Value::Null => CstInputValue::Null,
        Value::Bool(truth) => CstInputValue::Bool(*truth),
        Value::Number(number) => CstInputValue::Number(number.to_string()),
        Value::String(text) => CstInputValue::String(text.clone()),
        Value::Array(values) => CstInputValue::Array(values.iter().map(input).collect()),
        Value::Object(entries) => {
            CstInputValue::Object(entries.iter().map(|(key, value)| (key.clone(), input(value))).collect())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{with_figure, with_near};
    use crate::scene::{Scene, StyleName};

    const SCENE: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
  "note": "a < b",   "ground": { "A": [0, 0], "D": [160.000000000000000001, 0] },
  "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10 } },
    "2": { "points": ["B", "C"], "lengths": { "BC": 140 } }, "3": { "points": ["D", "C"], "lengths": { "CD": 110 } } } }"#;

    #[test]
    fn a_figure_is_put_in_and_taken_out() {
        let mut figure = Scene::read(SCENE).expect("it is good").figure;
        assert_eq!(with_figure(SCENE, &figure).as_deref(), Ok(SCENE));
        (figure.style, figure.mu_v) = (StyleName::Lecture, Some(2.5));
        figure.labels.insert("B".into(), "\"B₁\" </script>".into());
        let put = with_figure(SCENE, &figure).expect("it is good");
        assert_eq!(Scene::read(&put).expect("it is good").figure, figure);
        assert!(
            put.contains("160.000000000000000001, 0] },\n") && put.contains(r#""note": "a < b",   "ground""#),
            "{put}"
        );
        (figure.style, figure.mu_v) = (StyleName::Paper, Some(5.0));
        let back = with_figure(&put, &figure).expect("it is good");
        assert_eq!(Scene::read(&back).expect("it is good").figure, figure);
        assert!(!back.contains("style"), "{back}");
    }

    #[test]
    fn rough_places_are_put_in_and_changed() {
        let put = with_near(SCENE, &[("C".into(), vec![155.0, -110.5]), ("angle(3)".into(), vec![-90.0])]);
        let again = with_near(&put.expect("it is good"), &[("C".into(), vec![1.0, 2.0])]).expect("it is good");
        let near = Scene::read(&again).expect("it is good").near;
        assert_eq!((near.points.len(), near.angles_deg.len()), (1, 0), "{again}");
    }
}
