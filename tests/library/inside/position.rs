//! Roots of trigonometric polynomials, placements on three legs, and how the search for the nearest assembly grows.

use kinegon::geometry::{Placement, Point, Vector, turn_of_degrees};
use kinegon::mechanism::mechanism;
use kinegon::position::legs::{LegCondition, placements, real_roots, real_roots_of_first_degree};
use kinegon::position::pose;
use kinegon::scene::Scene;
use serde_json::json;
use std::f64::consts::PI;

/// Roots planted as Π sin((φ − φ_k)/2) over six angles, a trigonometric polynomial of degree 3.
fn planted(angles: &[f64; 6]) -> Vec<f64> {
    let roots = real_roots(|d| {
        let angle = libm::atan2(d.y, d.x);
        angles.iter().map(|a| libm::sin(0.5 * (angle - a))).product()
    });
    let angles = roots.iter().map(|d| libm::atan2(d.y, d.x));
    angles.map(|a| a.rem_euclid(2.0 * PI)).collect()
}

#[test]
fn finds_all_planted_roots() {
    let angles = [0.3, 0.9, 1.0, 3.1, 3.2, 6.0];
    let found = planted(&angles);
    assert_eq!(found.len(), 6);
    for (a, b) in found.iter().zip(&angles) {
        assert!((a - b).abs() < 1e-12, "{found:?}");
    }
}

#[test]
fn first_degree_has_two_roots_one_or_none() {
    for (planted, exact) in [([0.3, 6.0], 1e-12), ([2.0, 2.0], 1e-7), ([3.0, 3.0 + 1e-7], 1e-7)] {
        let found = real_roots_of_first_degree(|d| {
            let angle = libm::atan2(d.y, d.x);
            planted.iter().map(|a| libm::sin(0.5 * (angle - a))).product()
        });
        let angles: Vec<f64> = found.iter().map(|d| libm::atan2(d.y, d.x).rem_euclid(2.0 * PI)).collect();
        for planted in planted {
            assert!(angles.iter().any(|angle| (angle - planted).abs() < exact), "{planted}: {angles:?}");
        }
        assert_eq!(angles.len(), if exact < 1e-7 { 2 } else { 3 });
    }
    assert!(real_roots_of_first_degree(|d| d.x + 1.001).is_empty());
    assert!(real_roots_of_first_degree(|_| 0.0).is_empty());
}

#[test]
fn keeps_a_double_root() {
    let found = planted(&[0.3, 0.3, 2.0, 3.5, 4.0, 5.0]);
    assert!(found.iter().any(|a| (a - 0.3).abs() < 1e-5), "{found:?}");
    assert!(found.len() == 5 || found.len() == 6);
}

#[test]
fn planted_placement_is_found() {
    let turn = turn_of_degrees(40.0);
    let planted = Placement::from_parts(Vector::new(3.0, 1.0).into(), turn);
    let leg = |a: Point, b: Point| LegCondition::Distance { a, b, length: (planted * b - a).norm() };
    let legs = [
        leg(Point::new(0.0, 0.0), Point::new(0.5, 0.2)),
        leg(Point::new(2.0, -1.0), Point::new(1.5, 0.0)),
        leg(Point::new(1.0, 2.5), Point::new(-0.5, 1.0)),
    ];
    let found = placements(legs);
    assert!(found.iter().any(|p| {
        (p.translation.vector - planted.translation.vector).norm() < 1e-9
            && p.rotation.angle_to(&planted.rotation).abs() < 1e-9
    }));
    assert!(found.len().is_multiple_of(2) && found.len() <= 6);
}

/// A crank with dyads one behind the other, all alike, whose joints are near at `noise` from where they are.
fn chain(dyads: usize, noise: f64) -> (Scene, Vec<Point>) {
    let mut scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] }, "near": {},
        "links": { "1": { "points": ["A", "P0"], "lengths": { "A-P0": 10 }, "drive": { "angle": 90, "omega": 1 } } }
    });
    let mut joints = vec![Point::new(0.0, 10.0)];
    for index in 1..=dyads {
        let (pivot, joint) = (Point::new(40.0 * index as f64, 0.0), Point::new(40.0 * index as f64 + 3.0, 28.0));
        let link = |from: &str, at: Point| {
            let to = format!("P{index}");
            json!({ "points": [from, to], "lengths": { format!("{from}-{to}"): (joint - at).norm() } })
        };
        scene["ground"][format!("G{index}")] = json!([pivot.x, pivot.y]);
        scene["links"][format!("a{index}")] = link(&format!("P{}", index - 1), joints[index - 1]);
        scene["links"][format!("b{index}")] = link(&format!("G{index}"), pivot);
        let side = if index % 2 == 0 { noise } else { -noise };
        scene["near"][format!("P{index}")] = json!([joint.x + side, joint.y - side]);
        joints.push(joint);
    }
    (Scene::read(&scene.to_string()).expect("a scene"), joints)
}

/// Two hundred dyads have 2²⁰⁰ assemblies: what looks at more than a few of each does not come to an end.
#[test]
fn the_nearest_of_very_many_assemblies_is_found() {
    for (dyads, noise) in [(20, 0.0), (200, 0.0), (200, 4.0)] {
        let (scene, joints) = chain(dyads, noise);
        let mechanism = mechanism(&scene).expect("a mechanism");
        let found = pose(&mechanism, &scene.near).expect("it can be assembled");
        for (index, joint) in joints.iter().enumerate() {
            let place = found.point(mechanism.point(&format!("P{index}")).expect("the joint"));
            assert!((place - joint).norm() < 1e-6, "P{index} is at {place} with a noise of {noise}");
        }
    }
}
