//! Hostile scenes on the whole way: an error that can be shown, or figure and result with nothing but finite numbers.
#![allow(dead_code)] // not every test uses all of it

use kinegon::Error;
use kinegon::drafting::{Tolerance, pencil};
use kinegon::drawing::{Drawing, scales, stepwise};
use kinegon::format::{self, ResultFile};
use kinegon::plan::{Asked, Quantity, measured_names, quantity, step_names};
use kinegon::scene::Scene;
use resvg::usvg::roxmltree::Document;
use serde_json::Value;

use kinegon::Solution;
use crate::stages::solved;

/// Reads the text; an error must be one that can be shown.
pub fn reading(text: &str) {
    if let Err(error) = Scene::read(text) {
        can_be_shown(text, &error.into());
    }
}

/// Takes the text through all stages and looks at everything that comes out.
pub fn whole_way(text: &str) -> Result<(), Error> {
    let stages = solved(text).inspect_err(|error| can_be_shown(text, error))?;
    let mut result = stages.result();
    add_quantities(&stages, &mut result);
    result_is_finite(&result);
    drawing_is_finite(&stages.figure());
    let Solution { scene, mechanism, pose, motion, construction } = &stages;
    let all = stepwise(scene, mechanism, pose, construction);
    for step in [1, all.steps.len() / 2 + 1, all.steps.len() + 1] {
        drawing_is_finite(&all.after_step(step));
    }
    let layered = format::layered_svg(&all, format::Text::Letters);
    assert!(Document::parse(&layered).is_ok(), "{layered}");
    assert!(!stages.figure().tikz().is_empty());
    assert!(!format::structure(mechanism).is_empty());
    let names = step_names(construction);
    let asked = names.iter().map(|name| Asked::new(name, mechanism));
    let pencil = pencil(
        mechanism,
        pose,
        motion,
        construction,
        &scales(scene, mechanism, pose, construction),
        Tolerance::default(),
        asked.map(|a| a.expect("steps measure quantities")).collect(),
    );
    assert!(!format::steps(scene, construction, &pencil).is_empty());
    Ok(())
}

fn can_be_shown(text: &str, error: &Error) {
    if let Error::Scene(finding) = error {
        let span = finding.place.as_ref().map(|place| place.span.clone());
        assert!(span.is_none_or(|span| text.get(span).is_some()), "the span of {error} is not in the text");
    }
    let message = error.to_string();
    assert!(!message.is_empty());
    let control = message.chars().find(|c| c.is_control() && *c != '\n');
    assert_eq!(control, None, "{message:?}");
    #[cfg(feature = "cli")]
    assert!(!kinegon::cli::shown("scene.json", text, error).is_empty());
}

/// All that the construction measures.
fn add_quantities(stages: &Solution, result: &mut ResultFile) {
    let Solution { scene, mechanism, pose, motion, construction } = stages;
    let scales = scales(scene, mechanism, pose, construction);
    for name in measured_names(construction) {
        let value = quantity(&name, mechanism, pose, motion, construction, Some(&scales));
        let value = match value.unwrap_or_else(|error| panic!("{name} was measured, but: {error}")) {
            Quantity::Number(x) => format::QuantityResult::Number(x),
            Quantity::Vector(v) => format::QuantityResult::Vector([v.x, v.y]),
        };
        result.quantities.insert(name, value);
    }
}

/// serde_json writes `null` for what is not finite.
fn result_is_finite(result: &ResultFile) {
    let text = format::json(result);
    let mut json: Value = serde_json::from_str(&text).expect("a result is JSON");
    for (group, shown) in result.groups.iter().zip(json["groups"].as_array_mut().expect("a list")) {
        assert!(group.condition >= 1.0, "condition {}", group.condition);
        let routes = [group.disagreement, group.disagreement_allowed];
        assert!(
            routes == [None; 2] || routes.iter().all(|x| x.is_some_and(f64::is_finite)),
            "the routes differ by {routes:?}\n{text}"
        );
        // Where there is but one route, null is meant.
        let shown = shown.as_object_mut().expect("a group");
        shown.retain(|key, _| !key.starts_with("disagreement"));
    }
    assert!(!has_null(&json), "not finite:\n{text}");
    for (name, link) in &result.links {
        let turned = link.angle.unwrap_or(0.0);
        assert!(turned > -180.0 && turned <= 180.0, "angle({name}) is {turned}");
        let errors = [link.omega_error, link.alpha_error.unwrap_or(0.0)];
        assert!(errors.iter().all(|error| *error >= 0.0), "{name}: {errors:?}");
    }
}

fn has_null(json: &Value) -> bool {
    match json {
        Value::Null => true,
        Value::Array(elements) => elements.iter().any(has_null),
        Value::Object(entries) => entries.values().any(has_null),
        _ => false,
    }
}

fn drawing_is_finite(drawing: &Drawing) {
    for mark in &drawing.marks {
        assert!(mark.shape.is_finite(), "{mark:?}");
    }
    let svg = drawing.svg();
    let document = Document::parse(&svg).unwrap_or_else(|error| panic!("{error}\n{svg}"));
    for attribute in document.descendants().flat_map(|node| node.attributes()) {
        let is_number = attribute.name() != "id";
        assert!(
            !(is_number && (attribute.value().contains("NaN") || attribute.value().contains("inf"))),
            "{attribute:?}"
        );
    }
}
