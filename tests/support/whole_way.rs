//! Hostile scenes on the whole way: an error that can be shown, or figure and result with nothing but finite numbers.

use super::stages::solved;
use kinegon::construction::Tolerance;
use kinegon::drawing::{Drawing, Film, Shape, Timing};
use kinegon::format::{self, ResultFile};
use kinegon::quantity::{Quantity, QuantityRequest, measured_names, pencil, step_names};
use kinegon::scene::Scene;
use kinegon::{Error, Solution};
use resvg::usvg::roxmltree::Document;
use serde_json::Value;

/// Reads the text; an error must be one that can be shown.
pub fn reading(text: &str) {
    if let Err(error) = Scene::read(text) {
        can_be_shown(text, &error.into());
    }
}

/// Takes the text through all stages and looks at everything that comes out.
pub fn whole_way(text: &str) -> Result<(), Error> {
    let solution = solved(text).inspect_err(|error| can_be_shown(text, error))?;
    let mut result = solution.result();
    add_quantities(&solution, &mut result);
    result_is_finite(&result);
    drawing_is_finite(&solution.figure());
    let all = solution.stepwise_figure();
    for step in [1, all.steps.len() / 2 + 1, all.steps.len() + 1] {
        drawing_is_finite(&all.after_step(step));
    }
    drawn_otherwise(&solution);
    let layered = format::layered_svg(&all, format::Text::Letters);
    assert!(Document::parse(&layered).is_ok(), "{layered}");
    assert!(!solution.figure().tikz().is_empty());
    assert!(!format::structure(&solution.mechanism, &solution.wording()).is_empty());
    let names = step_names(&solution.construction);
    let asked = names.iter().map(|name| QuantityRequest::new(name, &solution.mechanism));
    let asked = asked.map(|a| a.expect("steps measure quantities")).collect();
    let pencil = pencil(&solution, &solution.scales(), Tolerance::default(), asked);
    assert!(!solution.steps(&pencil).is_empty());
    Ok(())
}

/// Sheets for a hand, and pictures of a film, in pixels too: what reckons with fewer digits must not fail on them.
fn drawn_otherwise(solution: &Solution) {
    solution.drawing_sheets("1").iter().for_each(drawing_is_finite);
    let film = Film::new(solution, None, Timing { seconds: 1.0, per_second: 3 });
    let pictures: Vec<Drawing> = film.map(|film| film.drawings().collect()).unwrap_or_default();
    for picture in pictures.iter().chain([&solution.figure()]) {
        drawing_is_finite(picture);
        assert!(picture.png(25.0).is_ok_and(|file| !file.is_empty()));
    }
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
    assert!(!kinegon::cli::shown("scene.json", text, error).is_empty());
}

/// All that the construction measures.
fn add_quantities(solution: &Solution, result: &mut ResultFile) {
    for name in measured_names(&solution.construction) {
        let value = match solution.quantity(&name).unwrap_or_else(|error| panic!("{name} was measured, but: {error}")) {
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

/// Whether a number is null; a bound that cannot be given may be.
fn has_null(json: &Value) -> bool {
    match json {
        Value::Null => true,
        Value::Array(elements) => elements.iter().any(has_null),
        Value::Object(entries) => {
            entries.iter().any(|(key, value)| !(key.ends_with("_error") && value.is_null()) && has_null(value))
        }
        _ => false,
    }
}

/// Looks at all numbers of a drawing, and reads its SVG.
pub fn drawing_is_finite(drawing: &Drawing) {
    for mark in &drawing.marks {
        // A blank label is a text without letters, which no format writes.
        let is_blank = matches!(&mark.shape, Shape::Text(text) if text.text.content().trim().is_empty());
        assert!(is_blank || mark.shape.is_drawable(), "{mark:?}");
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
