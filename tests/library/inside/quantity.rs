//! Symbols of quantities as they stand on the blackboard.

use kinegon::construction::display;
use kinegon::quantity::{QuantityKind, QuantityRequest};

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
        assert_eq!(asked.symbol(&mechanism, notation, &display), symbol);
        assert_eq!((asked.kind(), asked.written.subject().as_str()), (kind, subject), "{name}");
    }
    let paper = QuantityRequest::new("vplan(b,s3)/mu", &mechanism).expect("a known form");
    assert!(paper.written.on_paper);
}
