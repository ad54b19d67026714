//! Symbols of quantities as they stand on the blackboard.

use kinegon::construction::display;
use kinegon::quantity::{QuantityKind, QuantityRequest};
use kinegon::scene::{FrameName, SlidingName};

#[test]
fn symbols_as_on_the_blackboard() {
    let text = include_str!("../../../examples/figure-2.json");
    let scene = kinegon::scene::Scene::read(text).expect("a good scene");
    let mechanism = kinegon::mechanism::mechanism(&scene).expect("a mechanism");
    let notation = kinegon::words::Wording::default().notation;
    for (name, symbol, kind, subject) in [
        ("omega(4)", "ω_{4}", QuantityKind::AngularVelocity, "4"),
        ("angle(4)", "φ_{4}", QuantityKind::Angle, "4"),
        ("position(3/2)", "s(3/2)", QuantityKind::Position, "3/2"),
        ("v_r(3/2)", "v_{r}(3/2)", QuantityKind::Velocity, "3/2"),
        ("a_c(3/2)", "|a_{c}(3/2)|", QuantityKind::Acceleration, "3/2"),
        ("a_c(3/2).x", "a_{c,x}(3/2)", QuantityKind::Acceleration, "3/2"),
        ("x(D)", "x_{D}", QuantityKind::Position, "D"),
        ("v(D).y", "v_{D,y}", QuantityKind::Velocity, "D"),
        ("v(D).angle", "∠v_{D}", QuantityKind::Angle, "D"),
        ("a(D/G).size", "|a_{DG}|", QuantityKind::Acceleration, "D/G"),
        ("a_n(S3/B)", "|a^{n}_{S_{3}B}|", QuantityKind::Acceleration, "S3/B"),
        ("L(B,S3)", "L_{BS_{3}}", QuantityKind::Length, "B,S3"),
        ("vplan(b,s3)", "μ_v (b s_{3})", QuantityKind::Velocity, "b,s3"),
    ] {
        let asked = QuantityRequest::new(name, &mechanism).expect(name);
        assert_eq!(asked.symbol(&mechanism, &notation, &display), symbol);
        assert_eq!((asked.kind(), asked.written.subject().as_str()), (kind, subject), "{name}");
    }
    let mut by_points = notation;
    by_points.sliding = SlidingName::Points;
    for (name, symbol) in [
        ("position(3/2)", "s(3/2)"),
        ("v_r(3/2)", "v_{D_{3}D_{2}}"),
        ("a_r(3/2)", "a^{r}_{D_{3}D_{2}}"),
        ("a_c(3/2).x", "a^{c}_{D_{3}D_{2},x}"),
    ] {
        let asked = QuantityRequest::new(name, &mechanism).expect(name);
        assert_eq!(asked.symbol(&mechanism, &by_points, &display), symbol);
    }
    let paper = QuantityRequest::new("vplan(b,s3)/mu", &mechanism).expect("a known form");
    assert!(paper.written.on_paper);
}

/// The block of a pin in a slot has no name: the pin is a point of the link, or of the frame, that has it.
#[test]
fn a_pin_in_a_slot_is_a_point_of_its_link() {
    let text = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "ground": { "A": [0, 0], "D": [0, -120] },
        "links": {
          "1": { "points": ["A", "B1"], "lengths": { "AB1": 60 }, "drive": { "angle": 30, "omega": 10 } },
          "3": { "points": ["D", "C"], "lengths": { "CD": 220 } } },
        "sliders": [ { "pin": "B1", "on": "3", "along": "DC" } ],
        "near": { "C": [70, 90] } }"#;
    let scene = kinegon::scene::Scene::read(text).expect("a good scene");
    let mechanism = kinegon::mechanism::mechanism(&scene).expect("a mechanism");
    let usual = kinegon::words::Wording::default().notation;
    let mut notation = usual;
    (notation.sliding, notation.frame) = (SlidingName::Points, Some(FrameName::Zero));
    let asked = QuantityRequest::new("v_r(B1/3)", &mechanism).expect("a slider");
    assert_eq!(asked.symbol(&mechanism, &usual, &display), "v_{r}(B_{1}/3)");
    assert_eq!(asked.symbol(&mechanism, &notation, &display), "v_{B_{1,1}B_{1,3}}");

    // A slide that moves on a pin of the frame.
    let fixed = text.replace(r#""pin": "B1", "on": "3", "along": "DC""#, r#""pin": "D", "on": "2", "along": "B1C""#);
    let fixed = fixed.replace(
        r#""3": { "points": ["D", "C"], "lengths": { "CD": 220 } }"#,
        r#""2": { "points": ["B1", "C"], "lengths": { "B1C": 220 } }"#,
    );
    let scene = kinegon::scene::Scene::read(&fixed).expect("a good scene");
    let mechanism = kinegon::mechanism::mechanism(&scene).expect("a mechanism");
    let asked = QuantityRequest::new("v_r(D/2)", &mechanism).expect("a slider");
    assert_eq!(asked.symbol(&mechanism, &notation, &display), "v_{D_{0}D_{2}}");
}
