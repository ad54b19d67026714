//! Springs on the scheme: they end where the scene fixes them, in any position, and are in sight.

use crate::gears::solution;
use kinegon::drawing::{Drawing, Point, Shape};
use serde_json::{Value, json};

/// A four-bar linkage whose crank carries a spring at a place of its own, fixed to the frame far outside of the mechanism.
fn sprung(angle: f64, panels: &Value) -> Value {
    json!({ "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": { "A": [0, 0], "D": [120, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 40 }, "drive": { "angle": angle, "omega": 2 } },
                   "2": { "points": ["B", "C"], "lengths": { "BC": 110 } },
                   "3": { "points": ["C", "D"], "lengths": { "CD": 80 } } },
        "near": { "C": [110, 80] },
        "springs": [{ "between": [["1", [30, 15]], ["ground", [-150, 200]]], "rate": 1.5, "length": 40 }],
        "figure": { "panels": panels } })
}

fn shape<'a>(drawing: &'a Drawing, id: &str) -> &'a Shape {
    let mark = drawing.marks.iter().find(|mark| mark.id.as_deref() == Some(id));
    &mark.unwrap_or_else(|| panic!("no {id}")).shape
}

fn center(drawing: &Drawing, point: &str) -> Point {
    match shape(drawing, &format!("scheme-point-{point}")) {
        Shape::Circle { center, .. } => *center,
        other => panic!("{other:?}"),
    }
}

#[test]
fn they_end_where_the_scene_fixes_them() {
    for panels in [json!(["scheme", "forces"]), json!(["scheme", "velocity"])] {
        for turn in 0..12 {
            let angle = 30.0 * f64::from(turn) + 7.0;
            let drawing = solution(&sprung(angle, &panels)).figure();
            let [a, d] = ["A", "D"].map(|point| center(&drawing, point));
            // Upwards is downwards on the sheet.
            let on_sheet = |x: f64, y: f64| Point::new(a.x + x * (d.x - a.x) / 120.0, a.y - y * (d.x - a.x) / 120.0);
            let (cos, sin) = (libm::cos(angle.to_radians()), libm::sin(angle.to_radians()));
            let expected = [on_sheet(30.0 * cos - 15.0 * sin, 30.0 * sin + 15.0 * cos), on_sheet(-150.0, 200.0)];
            let Shape::Polyline(corners) = shape(&drawing, "scheme-spring-K1") else { panic!("no zigzag") };
            for (end, expected) in [corners[0], corners[corners.len() - 1]].into_iter().zip(expected) {
                assert!((end - expected).hypot() < 1e-3, "{angle}: {end:?} is {expected:?}");
            }
            assert!(!drawing.marks.iter().any(|mark| mark.id.as_deref() == Some("scheme-cut")), "{angle}: it is cut");
            let is_named = drawing.marks.iter().any(|mark| mark.id.as_deref() == Some("scheme-label-K1"));
            assert_eq!(is_named, panels[1] == "velocity", "{angle}: its force has the name where there is one");
        }
    }
}

/// With a length of its own it pulls towards the other end; where that is the same place there is no such direction, and forces are left out with
/// the reason.
#[test]
fn a_spring_whose_ends_meet_is_named() {
    let met = |length: f64| {
        let mut scene = sprung(37.0, &json!(["scheme", "velocity"]));
        scene["springs"] = json!([{ "between": [["1", "B"], ["2", "B"]], "rate": 1.5, "length": length }]);
        solution(&scene).warnings().collect::<Vec<_>>()
    };
    let told = met(40.0);
    assert!(told.iter().any(|warning| warning.contains("spring K1 meet")), "{told:?}");
    assert_eq!(met(0.0), Vec::<String>::new(), "without a length of its own it pulls with nothing");
}
