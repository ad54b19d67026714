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
fn wheels_have_the_circles_that_their_teeth_make() {
    let radii = |text: &str| -> Vec<f64> {
        let circles = Draft::of(text).expect("JSON").circles;
        circles.iter().map(|circle| libm::round(circle.radius * 1e9) / 1e9).collect()
    };
    // Arm of 60 mm: 20 teeth in a ring of 80, 40 on 20.
    let planetary = files::read("templates/planetary.json");
    assert_eq!(radii(&planetary), [20.0, 80.0, 40.0, 20.0]);
    // Also where it has no position yet.
    let loose = planetary.replace("\"AB\": 60", "\"AB\": 60, \"XY\": 1").replace("\"drive\"", "\"note\"");
    let told = loose.replace("\"ground\": {", "\"near\": { \"B\": [0, 30] },\n  \"ground\": {");
    assert!(!Draft::of(&told).expect("JSON").is_complete);
    assert_eq!(radii(&told), [10.0, 40.0, 20.0, 10.0]);
    // A disc and its roller.
    let cam = files::read("templates/eccentric-cam.json");
    assert_eq!(radii(&cam), [40.0, 12.0]);
    let arcs = drawn(&cam, [8.0, 40.0], 4.0).marks.into_iter().filter(|mark| matches!(mark.shape, Shape::Arc { .. }));
    assert!(arcs.count() >= 4, "each circle is drawn, as two halves");
    // A wheel on a rack; belts have the radii that they say.
    let rolling = files::read("tests/page/rolling.json").replace(
        "\"along\": 0 }]",
        r#""along": 0 }], "gears": [{ "mesh": ["2", "ground"], "teeth": [20, "rack"], "radius": 17, "on": "1" }]"#,
    );
    assert_eq!(radii(&rolling), [17.0]);
}

#[test]
fn loads_stand_where_they_act() {
    let loads = r#""forces": [
    { "on": "2", "at": 75, "force": { "size": 20, "angle": -90 } },
    { "on": "1", "couple": -300 },
    { "name": "P", "on": "1", "at": "B", "force": [3, 0], "turns": true }
  ],
  "near""#;
    let text = files::read("templates/slider-crank.json").replacen("\"near\"", loads, 1);
    let text = text.replacen("\"time\": \"s\"", "\"time\": \"s\", \"force\": \"N\"", 1);
    let draft_of = Draft::of(&text).expect("JSON");
    let names: Vec<&str> = draft_of.loads.iter().map(|load| load.name.as_str()).collect();
    assert_eq!(names, ["F1", "M1", "P"]);
    let [a, b, c] = ["A", "B", "C"].map(|point| draft_of.points[point].at);
    // The coupler is 150 mm long.
    assert!((draft_of.loads[0].at - (b + (c - b) / 2.0)).norm() < 1e-6);
    assert!((draft_of.loads[0].force.x).abs() < 1e-9 && (draft_of.loads[0].force.y + 20.0).abs() < 1e-9);
    assert!((draft_of.loads[1].at - (a + (b - a) / 2.0)).norm() < 1e-9, "a couple stands in the middle of its link");
    // Along the crank.
    assert!((draft_of.loads[2].force - (b - a).normalize() * 3.0).norm() < 1e-9);
    let drawing = drawn(&text, [80.0, 20.0], 3.0);
    for id in ["build-load-1", "build-load-2", "build-load-3"] {
        assert!(middle(&drawing, id).is_some(), "{id}");
    }
}

/// On the ground a place is where it is, on a link it counts along its axis from its first point.
#[test]
fn springs_reach_from_end_to_end() {
    let springs = r#""springs": [
    { "between": [["1", [10, 5]], ["ground", [-50, 60]]], "rate": 1, "length": 20 },
    { "between": [["3", "C"], ["ground", "A"]], "rate": 1, "length": 20 }
  ],
  "near""#;
    let text = files::read("templates/slider-crank.json").replacen("\"near\"", springs, 1);
    let text = text.replacen("\"time\": \"s\"", "\"time\": \"s\", \"force\": \"N\"", 1);
    let draft_of = Draft::of(&text).expect("JSON");
    let [a, b, c] = ["A", "B", "C"].map(|point| draft_of.points[point].at);
    let [ends, at_points] = draft_of.springs.as_slice() else { panic!("{:?}", draft_of.springs) };
    let along = (b - a).normalize();
    let place = a + along * 10.0 + kinegon::geometry::quarter_turn(along) * 5.0;
    assert!((ends.ends[0].1 - place).norm() < 1e-9 && ends.ends[1].1 == [-50.0, 60.0].into(), "{ends:?}");
    assert_eq!(at_points.ends.each_ref().map(|(_, at)| *at), [c, a]);
    let drawing = drawn(&text, [80.0, 20.0], 3.0);
    let zigzags =
        drawing.marks.iter().filter(|mark| mark.id.as_deref().is_some_and(|id| id.starts_with("build-spring-")));
    assert_eq!(zigzags.count(), 2);
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
        r#"{ "ground": { "A": [0, 0] }, "springs": [{}, 3, { "between": [["9", [1, 2]], ["ground", "A"]] }, { "between": ["A"] }] }"#,
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
