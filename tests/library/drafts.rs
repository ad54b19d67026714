//! Mechanisms that are not complete yet, as they are drawn in the hand Build.

use kinegon::drawing::{DraftView, Drawing, Pane, Shape, draft};
use kinegon::editing::Draft;
use support::files;

const PANE: Pane = Pane { width: 940.0, height: 564.0, letters: 14.1, words: false };

fn drawn(text: &str, centre: [f64; 2], scale: f64) -> Drawing {
    draft(&Draft::of(text).expect("JSON"), &DraftView { pane: PANE, centre, scale })
}

/// Where a mark is on the screen, in pixels from its middle, y up.
fn middle(drawing: &Drawing, id: &str) -> Option<[f64; 2]> {
    let mark = drawing.marks.iter().find(|mark| mark.id.as_deref() == Some(id))?;
    let centre = match &mark.shape {
        Shape::Circle { center, .. } => *center,
        shape => shape.bounds().center(),
    };
    let pixel = PANE.width / drawing.width;
    Some([centre.x * pixel - 0.5 * PANE.width, 0.5 * PANE.height - centre.y * pixel])
}

#[test]
fn what_is_known_stands_to_scale_and_what_is_not_is_left_out() {
    let text = r#"{
  "ground": { "A": [0, 0], "D": [100, 0] },
  "links": { "1": ["A", "B"], "2": ["B", "C"], "3": ["E", "F"] },
  "near": { "B": [20, 60] }
}"#;
    let drawing = drawn(text, [50.0, 30.0], 3.0);
    for (id, at) in
        [("build-point-A", [-150.0, -90.0]), ("build-point-B", [-90.0, 90.0]), ("build-link-1", [-120.0, 0.0])]
    {
        let place = middle(&drawing, id).expect(id);
        assert!(libm::hypot(place[0] - at[0], place[1] - at[1]) < 1e-6, "{id}: {place:?}");
    }
    assert!(middle(&drawing, "build-link-2").is_some(), "a link of which one end is known is a stub");
    assert_eq!(middle(&drawing, "build-link-3"), None);
    assert_eq!(middle(&drawing, "build-point-C"), None);
    let names =
        |name: &str| drawing.marks.iter().any(|mark| mark.id.as_deref() == Some(&format!("build-label-{name}")));
    assert!(names("A") && names("D") && names("B"));
}

#[test]
fn guides_blocks_and_drives_stand_as_in_the_scheme() {
    let text = files::read("templates/hydraulic-boom.json");
    let draft_of = Draft::of(&text).expect("JSON");
    assert!(draft_of.is_complete);
    let drawing = drawn(&text, [1000.0, 800.0], 0.25);
    for id in ["build-slider-0", "build-drive-0", "build-link-4"] {
        assert!(middle(&drawing, id).is_some(), "{id}");
    }
    let [x, y] = middle(&drawing, "build-slider-0").expect("a block");
    let at = draft_of.points["D"].at;
    assert!(libm::hypot(x - 0.25 * (at.x - 1000.0), y - 0.25 * (at.y - 800.0)) < 1e-6);
}

#[test]
fn any_text_is_drawn_without_a_fault() {
    for text in [
        "{}",
        r#"{ "links": {} }"#,
        r#"{ "links": { "1": [] }, "sliders": [{}, 3, { "at": "A", "on": "1" }], "near": { "A": ["x", 1] } }"#,
        r#"{ "ground": { "A": [0, 0], "B": [0, 0] }, "links": { "1": ["A", "B"] }, "sliders": [{ "pin": "A", "on": "1", "along": "AB" }] }"#,
        r#"{ "links": { "1": ["A"], "2": ["A"] }, "sliders": [{ "link": "1", "at": "A", "on": "2" }, { "link": "2", "at": "A", "on": "1" }], "near": { "A": [1, 1] } }"#,
        r#"{ "ground": { "A": [1e308, -1e308] }, "links": { "1": ["A", "B"] }, "near": { "B": [0, 0] } }"#,
        // A fuzzer's: a guide from where nothing is.
        r#"{ "ground": { "A": [0, 1.7976931348623157e+308], "G": [275, 0] }, "links": { "3": ["D"], "2": ["B", "E"] },
             "sliders": [{ "link": "3", "at": "D", "on": "ground", "through": "A" }], "near": { "D": [263, 300], "E": [406, 428] } }"#,
    ] {
        assert!(drawn(text, [0.0, 0.0], 3.0).svg().starts_with("<"), "{text}");
        for (centre, scale) in [([0.0, 0.0], 3.0), ([-1e9, 1e-9], 1e-6), ([0.0, 0.0], 1e6)] {
            let marks = drawn(text, centre, scale).marks;
            assert!(marks.iter().all(|mark| mark.shape.is_drawable()), "{text}: {marks:?}");
        }
    }
    assert!(Draft::of("[").is_err());
}
