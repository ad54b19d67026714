//! What is put together by hand: points stay where they were while a scene is not complete, and go where they are dragged.

use super::position;
use kinegon::editing::{Draft, Edit, Key, PlacedPoint, apply_in_place, places, with_places};
use kinegon::geometry::Point;
use serde_json::{Value, json};
use support::files;

fn to(name: &str, at: [f64; 2]) -> PlacedPoint {
    PlacedPoint { name: name.to_owned(), at }
}

fn without_drive(text: &str, link: &str) -> String {
    let remove = ["links", link, "drive"].map(Key::from).to_vec();
    apply_in_place(text, &[Edit::Remove { remove }]).expect("a change")
}

#[test]
fn points_stay_when_a_scene_is_no_longer_complete() {
    for name in ["four-bar", "whitworth", "stephenson-3", "slider-crank"] {
        let text = files::read(&format!("templates/{name}.json"));
        let before = places(&text).expect("places");
        let scene: Value = serde_json::from_str(&text).expect("JSON");
        let links = scene["links"].as_object().expect("links").iter();
        let driven =
            links.filter(|(_, link)| link["drive"].is_object()).map(|(name, _)| name.clone()).next().expect("a drive");
        let open = without_drive(&text, &driven);
        assert!(position(&open).is_err(), "{name} has no drive");
        let after = places(&open).expect("places");
        for (point, [x, y]) in &before {
            let [u, v] = after.get(point).unwrap_or_else(|| panic!("{name}: {point} is lost\n{open}"));
            assert!(libm::hypot(x - u, y - v) < 0.5, "{name}: {point} went from {x}, {y} to {u}, {v}");
        }
    }
}

#[test]
fn a_change_that_leaves_a_scene_complete_is_the_change_alone() {
    let text = files::read("templates/four-bar.json");
    let set = ["links", "3", "lengths", "CD"].map(Key::from).to_vec();
    let changed = apply_in_place(&text, &[Edit::Set { set, value: json!(115) }]).expect("a change");
    assert_eq!(changed, text.replace("\"CD\": 110", "\"CD\": 115"));
}

#[test]
fn dragged_points_of_an_incomplete_scene_take_lengths_guides_and_drives_with_them() {
    let text = r#"{
  "kinegon": 1, "units": { "length": "mm", "time": "s" },
  "ground": { "A": [0, 0] },
  "links": {
    "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": 0, "omega": 1 } },
    "2": { "points": ["B", "C"], "lengths": { "BC": 100 } },
    "3": ["C"]
  },
  "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [150, 0], "along": 90 }],
  "near": { "B": [50, 0], "C": [150, 0], "E": [0, 0] }
}"#;
    // E is in no link, so that the scene is not complete.
    let moved = with_places(text, &[to("B", [30.0, 40.0])]).expect("moved");
    let scene: Value = serde_json::from_str(&moved).expect("JSON");
    assert_eq!(scene["near"]["B"], json!([30, 40]));
    assert_eq!(scene["links"]["1"]["lengths"]["AB"], json!(50), "{moved}");
    // From (30, 40) to (150, 0): √(120² + 40²).
    let length = scene["links"]["2"]["lengths"]["BC"].as_f64().expect("a length");
    assert!((length - 16_000_f64.sqrt()).abs() < 0.01, "{moved}");
    let angle = scene["links"]["1"]["drive"]["angle"].as_f64().expect("an angle");
    assert!((angle - 53.13).abs() < 0.01, "{moved}");
    let moved = with_places(text, &[to("C", [160.0, 20.0]), to("A", [10.0, 0.0])]).expect("moved");
    let scene: Value = serde_json::from_str(&moved).expect("JSON");
    assert_eq!(scene["sliders"][0]["through"], json!([160, 20]), "{moved}");
    assert_eq!(scene["ground"]["A"], json!([10, 0]), "{moved}");
    assert_eq!(scene["links"]["1"]["lengths"]["AB"], json!(40), "{moved}");
    assert!(with_places(text, &[to("Q", [0.0, 0.0])]).is_err());
}

#[test]
fn a_whole_mechanism_moves_as_one() {
    let text = files::read("templates/four-bar.json");
    let (_, mechanism, pose) = position(&text).expect("a position");
    let by = Point::new(40.0, -30.0).coords;
    let moves: Vec<PlacedPoint> =
        mechanism.points.iter().zip(&pose.points).map(|(name, place)| to(name, (place + by).into())).collect();
    let moved = with_places(&text, &moves).expect("moved");
    let (_, _, after) = position(&moved).unwrap_or_else(|error| panic!("{error}\n{moved}"));
    for (before, after) in pose.points.iter().zip(&after.points) {
        assert!((after - before - by).norm() < 0.2, "{before} {after}\n{moved}");
    }
}

#[test]
fn guides_run_as_the_text_says_also_before_the_scene_is_complete() {
    let text = r#"{
  "ground": { "A": [0, 0] },
  "links": { "1": { "shape": { "B": 0, "C": [30, 40], "E": [60, 0] } }, "2": ["P"], "3": ["Q"], "4": ["R"] },
  "sliders": [
    { "link": "2", "at": "P", "on": "1", "along": "CE" },
    { "link": "3", "at": "Q", "on": "1", "through": "B", "along": 90 },
    { "link": "4", "at": "R", "on": "ground", "through": [5, 7], "along": [3, -4] }
  ],
  "near": { "B": [10, 0], "C": [-30, 30], "E": [10, 60], "P": [0, 40], "Q": [0, 0], "R": [8, 3] }
}"#;
    let draft = Draft::of(text).expect("JSON");
    assert!(!draft.is_complete);
    // The link is turned by 90°: C at (10 − 40, 30), E at (10, 60).
    let guides: Vec<_> = draft.sliders.iter().map(|slider| slider.guide.expect("a guide")).collect();
    let wanted = [([-30.0, 30.0], [0.8, 0.6]), ([10.0, 0.0], [-1.0, 0.0]), ([5.0, 7.0], [0.6, -0.8])];
    for (guide, (through, along)) in guides.iter().zip(wanted) {
        assert!((guide.through - Point::from(through)).norm() < 1e-9, "{guide:?}");
        assert!((guide.along - Point::from(along).coords).norm() < 1e-9, "{guide:?}");
    }
}
