//! Frames of links from their lengths, and angles that look like radians.

use kinegon::geometry::Point;
use kinegon::mechanism::mechanism;
use kinegon::scene::Scene;

/// A driven link, and a dyad between its point B and the ground.
fn scene(lengths: &str, angle: &str) -> Scene {
    let text = format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "E": [9, 0] }},
        "links": {{
            "1": {{ "points": ["A", "B", "C"], "lengths": {{ {lengths} }}, "drive": {{ "angle": {angle}, "omega": 1 }} }},
            "2": {{ "points": ["B", "F"], "lengths": {{ "BF": 7 }} }},
            "3": {{ "points": ["E", "F"], "lengths": {{ "EF": 8 }} }} }} }}"#
    );
    Scene::read(&text).expect("a good scene")
}

/// The third corner of a triangle with its base on the x axis.
fn corner(ab: f64, ac: f64, bc: f64) -> Point {
    let scene = scene(&format!(r#""AB": {ab}, "AC": {ac}, "BC": {bc}"#), "60");
    let mechanism = mechanism(&scene).expect("a mechanism");
    mechanism.body(mechanism.link("1").expect("the link")).local[2]
}

#[test]
fn right_triangle() {
    assert!((corner(4.0, 3.0, 5.0) - Point::new(0.0, 3.0)).norm() < 1e-15);
}

#[test]
fn straight_link() {
    assert_eq!(corner(3.0, 1.0, 2.0).y, 0.0);
    // 0.5 + 0.2 differs from 0.7 by rounding, of which the height would be the square root.
    assert_eq!(corner(0.5, 0.2, 0.7).y, 0.0);
}

#[test]
fn radians_are_told_from_degrees() {
    let warnings = |angle: &str| {
        let scene = scene(r#""AB": 4, "AC": 3, "BC": 5"#, angle);
        let warnings = mechanism(&scene).expect("a mechanism").warnings;
        warnings.iter().map(ToString::to_string).filter(|warning| warning.contains("radians")).collect::<Vec<_>>()
    };
    // π/3, π/2, −π/6, π and 3π/2 as people round them.
    for (angle, meant) in [("1.0472", 60), ("1.5708", 90), ("-0.5236", -30), ("3.14159", 180), ("4.712", 270)] {
        let warnings = warnings(angle);
        assert!(warnings.len() == 1 && warnings[0].contains(&format!("so {meant} if")), "{angle}: {warnings:?}");
    }
    for angle in ["0", "1", "1.5", "2.25", "5", "30", "60", "0.001", "6.7", "104.72"] {
        assert!(warnings(angle).is_empty(), "{angle}");
    }
}
