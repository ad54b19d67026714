//! What follows from instant centres by ruler and pencil: velocities, also where a slider drives, and centres of curvature of paths by Bobillier's construction; held
//! to the computed motion, whose rates enter none of them, and to closed forms.

use kinegon::Solution;
use kinegon::construction::Centers;
use kinegon::geometry::{Place, span};
use kinegon::mechanism::BodyId;
use kinegon::quantity::Quantity;
use serde_json::{Value, json};
use support::files;
use support::random::Random;
use support::stages::solved;

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("a scene")
}

fn template(name: &str) -> Value {
    parsed(&files::read(&format!("templates/{name}.json")))
}

/// The scene with velocities and curvatures of all points of its links that move.
fn asked(scene: &Value) -> Solution {
    let mut scene = scene.clone();
    scene["figure"] = json!({ "panels": ["centers"] });
    let plain = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{scene}: {error}"));
    let on_ground = |name: &String| plain.mechanism.body(BodyId(0)).has(plain.mechanism.point(name).expect("a point"));
    let points: Vec<&String> = plain.mechanism.points.iter().filter(|name| !on_ground(name)).collect();
    scene["figure"]["velocities"] = json!(points);
    scene["figure"]["curvature"] = json!(points);
    solved(&scene.to_string()).unwrap_or_else(|error| panic!("{scene}: {error}"))
}

fn centers(solution: &Solution) -> &Centers {
    solution.construction.centers.as_deref().expect("the figure asks for them")
}

fn number(solution: &Solution, name: &str) -> Option<f64> {
    match solution.quantity(name) {
        Ok(Quantity::Number(value)) => Some(value),
        _ => None,
    }
}

/// Holds all that was found to the motion; how many velocities and curvatures these were.
fn compared(solution: &Solution) -> [usize; 2] {
    let centers = centers(solution);
    let size = span(solution.pose.points.iter().copied());
    let fastest = centers.velocities.iter().map(|found| found.velocity.norm()).fold(0.0, f64::max);
    for found in &centers.velocities {
        let at = solution.pose.point(found.point);
        let moved = solution.motion.body(found.link).velocity_at(at);
        let name = solution.mechanism.point_name(found.point);
        let off = (found.velocity - moved).norm();
        assert!(off <= 1e-8 * fastest.max(moved.norm()), "velocity of {name}: {} and not {moved}", found.velocity);
    }
    for found in &centers.curvatures {
        let name = solution.mechanism.point_name(found.point);
        let computed = number(solution, &format!("rho({name})"));
        match (found.radius, computed) {
            (Some(radius), Some(rho)) => {
                let agreement = found.agreement.expect("accelerations are asked for");
                assert!(agreement.difference <= agreement.allowed, "{name}: {agreement:?}");
                let allowed = agreement.allowed * size.max(radius) + 1e-12 * radius;
                assert!((radius - rho).abs() <= allowed, "rho({name}) = {rho}, constructed {radius}, {agreement:?}");
            }
            // Straight, as far as roundings tell.
            (None, rho) if rho.is_none_or(|rho| rho > 1e9 * size) => {}
            (radius, rho) => panic!("rho({name}) = {rho:?}, constructed {radius:?}"),
        }
    }
    [centers.velocities.len(), centers.curvatures.len()]
}

#[test]
fn of_templates() {
    let mut found = [0; 2];
    for name in [
        "four-bar",
        "slider-crank",
        "slotted-lever",
        "whitworth",
        "toggle-press",
        "hydraulic-boom",
        "watt-1",
        "stephenson-3",
        "third-class",
        "fourth-class",
    ] {
        let [velocities, curvatures] = compared(&asked(&template(name)));
        println!("{name}: {velocities} velocities, {curvatures} curvatures");
        assert!(velocities > 0, "{name}");
        found = [found[0] + velocities, found[1] + curvatures];
    }
    assert!(found[0] > 25 && found[1] > 6, "{found:?}");
}

/// Cranks, couplers and rockers, and couplers with a block in the frame, with a point beside the coupler.
#[test]
fn of_random_couplers() {
    let mut random = Random(23);
    let mut found = [0; 2];
    for round in 0..60 {
        let mut length = |from: f64, to: f64| random.between(from, to);
        let (crank, coupler, rocker) = (length(20.0, 50.0), length(80.0, 140.0), length(70.0, 120.0));
        let (angle, side, along) = (length(0.0, 360.0), length(20.0, 90.0), length(20.0, 100.0));
        let drive = json!({ "angle": angle, "omega": 7.0, "alpha": length(-30.0, 30.0) });
        let near = json!({ "C": [140.0, 90.0], "M": [90.0, 140.0] });
        let links = json!({
            "1": { "points": ["A", "B"], "lengths": { "AB": crank }, "drive": drive },
            "2": { "points": ["B", "C", "M"], "shape": { "B": [0, 0], "C": [coupler, 0], "M": [along, side] } },
        });
        let mut scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [130, 0] }, "links": links, "near": near });
        if round % 2 == 0 {
            scene["links"]["3"] = json!({ "points": ["D", "C"], "lengths": { "CD": rocker } });
        } else {
            scene["links"]["3"] = json!({ "points": ["C"] });
            scene["sliders"] = json!([{ "link": "3", "at": "C", "on": "ground", "through": [0.0, length(-15.0, 15.0)], "along": [1, 0] }]);
        }
        if solved(&scene.to_string()).is_err() {
            continue;
        }
        let [velocities, curvatures] = compared(&asked(&scene));
        found = [found[0] + velocities, found[1] + curvatures];
    }
    println!("{found:?}");
    assert!(found[0] > 60 && found[1] > 60, "{found:?}");
}

/// A trammel's points run on ellipses: both known centres of curvature are at infinity.
#[test]
fn of_a_trammel() {
    let (length, third, angle) = (100.0_f64, 30.0_f64, 35.0_f64);
    let (sine, cosine) = libm::sincos(angle.to_radians());
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "ground": { "O": [0, 0] },
        "links": {
            "1": { "points": ["X"] },
            "2": { "points": ["X", "Y", "M"], "shape": { "X": [0, 0], "Y": [length, 0], "M": [third, 0] } },
            "3": { "points": ["Y"] },
        },
        "sliders": [
            { "link": "1", "at": "X", "on": "ground", "through": "O", "along": [1, 0],
              "drive": { "position": length * cosine, "speed": 50, "acceleration": 0 } },
            { "link": "3", "at": "Y", "on": "ground", "through": "O", "along": [0, 1] },
        ],
        "near": { "Y": [0, length * sine] },
    });
    let solution = asked(&scene);
    let [velocities, curvatures] = compared(&solution);
    let points: Vec<&str> =
        centers(&solution).curvatures.iter().map(|found| solution.mechanism.point_name(found.point)).collect();
    assert_eq!(points, ["X", "Y", "M"]);
    assert_eq!([velocities, curvatures], [3, 3]);
    // M = (a cos φ, b sin φ) with a = |MY|, b = |MX|.
    let (a, b) = (length - third, third);
    let expected = libm::pow(a * a * sine * sine + b * b * cosine * cosine, 1.5) / (a * b);
    let radius = centers(&solution).curvatures[2].radius.expect("no inflection");
    assert!((radius - expected).abs() <= 1e-11 * expected, "{radius}, not {expected}");
    // X and Y run straight.
    assert!(centers(&solution).curvatures[..2].iter().all(|found| found.radius.is_none()));
}

/// The path of a crank's end has its pivot as centre of curvature, by the construction, too.
#[test]
fn of_pins_on_cranks() {
    let solution = asked(&template("four-bar"));
    let pivots = [("B", "A"), ("C", "D")];
    for (pin, pivot) in pivots {
        let [pin, pivot] = [pin, pivot].map(|name| solution.mechanism.point(name).expect("a point"));
        let found = centers(&solution).curvatures.iter().find(|found| found.point == pin).expect("found");
        let Place::At(center) = found.center else { panic!("{found:?}") };
        assert!((center - solution.pose.point(pivot)).norm() <= 1e-11 * span(solution.pose.points.iter().copied()));
    }
}

/// A piston that drives a crank: all of it has the speed of the drive.
#[test]
fn of_a_piston() {
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 40 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 120 } },
            "3": { "points": ["C", "K"], "shape": { "C": [0, 0], "K": [30, 20] } },
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": "A", "along": [1, 0],
                      "drive": { "position": 130, "speed": -60, "acceleration": 0 } }],
        "near": { "B": [20, 35], "K": [160, 20] },
    });
    let solution = asked(&scene);
    let [velocities, _] = compared(&solution);
    assert_eq!(velocities, 3);
    let of_piston = |name: &str| {
        let point = solution.mechanism.point(name);
        let found = centers(&solution).velocities.iter().find(|found| Some(found.point) == point).expect("found");
        found.velocity
    };
    assert!((of_piston("K") - nalgebra::Vector2::new(-60.0, 0.0)).norm() <= 1e-12);
}

/// Neither with two drives, nor with one at rest, does a velocity follow.
#[test]
fn what_does_not_follow_is_left_out() {
    let five_bar = asked(&template("five-bar"));
    assert!(centers(&five_bar).velocities.is_empty());
    assert_eq!(centers(&five_bar).without_velocity.len(), 3);
    let mut boom = template("hydraulic-boom");
    boom["sliders"][0]["drive"]["speed"] = json!(0);
    assert!(centers(&asked(&boom)).velocities.is_empty());
}

/// Of many links no lines are sought, which would take minutes; their centres come from the rates, and it is said.
#[test]
fn of_many_links_no_lines_are_sought() {
    let mut links = serde_json::Map::new();
    let (mut ground, mut near) = (json!({ "A": [0, 0] }), json!({}));
    links.insert(
        "1".into(),
        json!({ "points": ["A", "B0"], "lengths": { "AB0": 70 }, "drive": { "angle": 70, "omega": 1 } }),
    );
    for dyad in 0..25 {
        let (from, to, pivot) = (format!("B{dyad}"), format!("B{}", dyad + 1), format!("D{dyad}"));
        let x = 120 * (dyad + 1);
        ground[&pivot] = json!([x, 0]);
        near[&to] = json!([x + 24, 66]);
        let [coupler, rocker] = [format!("{from}{to}"), format!("{pivot}{to}")];
        links.insert(format!("c{dyad}"), json!({ "points": [from, to], "lengths": { coupler: 120 } }));
        links.insert(format!("r{dyad}"), json!({ "points": [pivot, to], "lengths": { rocker: 70 } }));
    }
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": ground, "links": links, "near": near,
        "figure": { "panels": ["centers"], "centers": "all" },
    });
    let solution = solved(&scene.to_string()).expect("a solution");
    assert!(centers(&solution).is_too_large);
    assert!(centers(&solution).all.iter().all(|center| center.is_permanent()));
    assert!(solution.warnings().any(|warning| warning.contains("at most 41 links")));
}
