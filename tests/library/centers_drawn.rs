//! The figure of instant centres as people see it: one symbol for a centre wherever it stands, and the special point that it is.

use kinegon::Solution;
use kinegon::drawing::{Drawing, Shape};
use kinegon::scene::{CenterName, FrameName, LanguageName};
use serde_json::{Value, json};
use support::faults::id;
use support::files;
use support::stages::solved;

fn template(name: &str, figure: Value) -> Solution {
    let mut scene: Value = serde_json::from_str(&files::read(&format!("templates/{name}.json"))).expect("a scene");
    scene["figure"] = figure;
    solved(&scene.to_string()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// What the label of that id says.
fn label(drawing: &Drawing, wanted: &str) -> String {
    let said = drawing.marks.iter().find(|mark| id(mark) == wanted).and_then(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.text.content()),
        _ => None,
    });
    said.unwrap_or_else(|| {
        let ids: Vec<&str> = drawing.marks.iter().map(id).filter(|id| id.contains("label")).collect();
        panic!("no label {wanted} in {ids:?}")
    })
}

#[test]
fn a_center_has_one_symbol() {
    for language in LanguageName::ALL {
        for letter in CenterName::ALL {
            for frame in [None, Some(FrameName::Zero)] {
                let number = frame.map(FrameName::as_str);
                let figure = json!({
                    "panels": ["scheme", "centers"], "inflection": ["2"], "mu_l": 5, "language": language.as_str(),
                    "center_letter": letter.as_str(), "frame": number,
                });
                let mut figure = figure;
                if number.is_none() {
                    figure.as_object_mut().expect("an object").remove("frame");
                }
                let solution = template("four-bar", figure);
                let drawing = solution.figure();
                let expected = format!("{}20", letter.as_str());
                let scheme = label(&drawing, "scheme-label-pole-2");
                let panel = label(&drawing, "centers-label-Pu282-groundu29");
                let case = format!("{} {expected} {number:?}", language.as_str());
                assert_eq!([scheme.as_str(), panel.as_str()], [expected.as_str(); 2], "{case}");
                let words = solution.wording();
                let steps = kinegon::construction::Teller::new(&solution, &words);
                let pair = kinegon::centers::LinkPair::named("P(2,ground)", &solution.mechanism).expect("a pair");
                let told = steps.center_symbol(pair, kinegon::construction::FigureOf::Mechanism);
                assert_eq!(told, format!("{}_{{20}}", letter.as_str()), "{case}");
            }
        }
    }
}

/// A name that the figure gives to a link stands in the symbols, too, and one of more than one sign with commas.
#[test]
fn links_are_named_as_on_the_scheme() {
    let figure = json!({ "panels": ["scheme", "centers"], "inflection": ["2"], "mu_l": 5, "labels": { "2": "II" } });
    let drawing = template("four-bar", figure).figure();
    assert_eq!(label(&drawing, "scheme-label-pole-2"), "PII,0");
    assert_eq!(label(&drawing, "centers-label-Pu282-groundu29"), "PII,0");
}

/// Links 2 and 4 hang the third-class group's link 3 on the frame: where they meet is the link's special point, and its centre with the frame.
#[test]
fn a_special_point_is_a_center() {
    let mut scene: Value = serde_json::from_str(&files::read("templates/third-class.json")).expect("a scene");
    let links = scene["links"].clone();
    for (now, before) in [("2", "4"), ("4", "5"), ("5", "2")] {
        scene["links"][now] = links[before].clone();
    }
    scene["figure"] = json!({ "panels": ["centers"] });
    let drawing = |scene: &Value| solved(&scene.to_string()).expect("a solution").figure();
    assert_eq!(label(&drawing(&scene), "centers-label-Pu283-groundu29"), "P30=S24");
    // Who shows no special points has no name for it.
    scene["figure"]["special_points"] = json!(false);
    assert_eq!(label(&drawing(&scene), "centers-label-Pu283-groundu29"), "P30");
    // In the template itself the special points are others: of a leg on the crank and one on the frame.
    let own = template("third-class", json!({ "panels": ["centers"] })).figure();
    assert_eq!(label(&own, "centers-label-Pu283-groundu29"), "P30");
}

/// A link that turns about a fixed point has no inflection circle: its pole does not move.
#[test]
fn no_inflection_circle_about_a_pin() {
    let solution = template("four-bar", json!({ "panels": ["scheme", "acceleration"], "inflection": ["2", "3"] }));
    assert!(solution.inflection_circle("2").is_some());
    assert!(solution.inflection_circle("3").is_none());
}
