//! What follows from mistakes with wheels, cams and friction, against closed forms of the numbers that a student then writes; and that the check names each by them.

use kinegon::check::{AnswerKey, Mistake, Student, check, form_names};
use serde_json::{Value, json};
use support::files;
use support::stages::solved;

/// Errors allowed, in parts of a number.
const OFF: f64 = 1e-9;

/// Some way of the mistake gives these values, and the check of a form with all of its values names it.
fn is_named(scene: &Value, id: &str, expected: &[(&str, f64)]) {
    let solution = solved(&scene.to_string()).unwrap_or_else(|error| panic!("{error}\n{scene}"));
    let names = form_names(&solution.construction);
    let key = AnswerKey::new(&solution, None);
    let student = Student::new(&key).expect("a form");
    let mistake =
        Mistake::all().find(|mistake| mistake.id() == id).unwrap_or_else(|| panic!("{id} is in the catalogue"));
    let ways = student.ways(mistake);
    let values = |found: &[Option<f64>]| {
        let value = |name: &str| {
            found[names.iter().position(|own| own == name).unwrap_or_else(|| panic!("{name} in {names:?}"))]
        };
        expected.iter().map(|(name, _)| value(name)).collect::<Vec<_>>()
    };
    let is_it = |found: &[Option<f64>]| {
        let pairs = values(found).into_iter().zip(expected);
        pairs
            .into_iter()
            .all(|(found, (_, right))| found.is_some_and(|found| (found - right).abs() <= OFF * right.abs().max(1.0)))
    };
    assert!(!is_it(&student.exact(None)), "{id}: {expected:?} is right");
    let way = ways.iter().find(|way| is_it(&student.exact(Some(way))));
    let found: Vec<_> = ways.iter().map(|way| values(&student.exact(Some(way)))).collect();
    let way = way.unwrap_or_else(|| panic!("{id}: {expected:?} is none of {found:?}"));
    let drawn = student.draw(&[way], [0.0; 2], &mut || 0.0, &[]);
    let checked = check(&drawn, &key).expect("a form");
    let told: Vec<&str> = checked.diagnosis.best.findings.iter().map(|found| found.candidate.mistake().id()).collect();
    assert_eq!(told, [id], "{expected:?}");
}

/// Wheels of 20 and 40 mm radius; a couple of 4000 N mm on the second.
fn wheels() -> Value {
    json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": { "A": [0, 0], "D": [60, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 15 }, "drive": { "angle": 30, "omega": 5 } },
            "2": { "points": ["D", "Q"], "lengths": { "DQ": 25 } },
        },
        "gears": [{ "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground", "pressure": 20 }],
        "forces": [{ "on": "2", "couple": -4000 }], "figure": { "panels": ["scheme", "forces"] },
    })
}

#[test]
fn teeth_that_push_along_the_tangent_alone() {
    is_named(&wheels(), "radial-force-left-out", &[("R(D,2).size", 100.0), ("R(A,1).size", 100.0), ("T(1)", -2000.0)]);
}

#[test]
fn a_diameter_in_place_of_a_radius() {
    let along = libm::cos(20.0_f64.to_radians());
    is_named(&wheels(), "diameter-for-radius", &[("R(D,2).size", 50.0 / along), ("T(1)", -1000.0)]);
    is_named(&wheels(), "diameter-for-radius", &[("R(D,2).size", 100.0 / along), ("T(1)", -4000.0)]);
    is_named(&wheels(), "diameter-for-radius", &[("R(D,2).size", 50.0 / along), ("T(1)", -2000.0)]);
    // A rack that a wheel of 20 mm radius drives with 5 rad/s, and one that drives it with 100 mm/s.
    let mut rack = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 15 }, "drive": { "angle": 30, "omega": 5, "alpha": 20 } }, "2": { "points": ["R"] } },
        "gears": [{ "mesh": ["1", "2"], "teeth": [20, "rack"], "radius": 20, "on": "ground" }],
        "sliders": [{ "link": "2", "at": "R", "on": "ground", "through": [0, -25], "along": 0 }], "near": { "R": [10, -25] },
    });
    is_named(&rack, "diameter-for-radius", &[("vplan(p,r)", 200.0), ("aplan(π,r)", 800.0), ("vplan(p,b)", 75.0)]);
    rack["links"]["1"] = json!({ "points": ["A", "B"], "lengths": { "AB": 15 } });
    rack["sliders"][0]["drive"] = json!({ "position": 10, "speed": 100 });
    is_named(&rack, "diameter-for-radius", &[("vplan(p,r)", 100.0), ("vplan(p,b)", 37.5)]);
}

/// A crank of 60 mm at 75° that turns with 10 rad/s, a rod of 180 mm without mass, 1000 N against the slider's motion; with the angle of the rod and the
/// slider's speed.
fn press(friction: &Value) -> (Value, f64, f64) {
    let (sine, cosine) = libm::sincos(75.0_f64.to_radians());
    let rod = libm::asin(60.0 * sine / 180.0);
    let omega_2 = -60.0 * 10.0 * cosine / (180.0 * libm::cos(rod));
    let speed = -600.0 * sine + 180.0 * libm::sin(rod) * omega_2;
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 75, "omega": 10 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 180 } }, "3": { "points": ["C"] },
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0 }], "near": { "C": [200, 0] },
        "forces": [{ "name": "P", "on": "3", "at": "C", "force": [1000, 0] }], "friction": friction,
        "figure": { "panels": ["scheme", "forces"] },
    });
    (scene, rod, speed)
}

/// The rod pushes along itself at the angle β: X tan β presses in the guide, X ∓ μ X tan β = 1000 along it.
#[test]
fn friction_of_a_guide_taken_wrongly() {
    let (scene, rod, _) = press(&json!([{ "guide": "3/ground", "angle": 35 }]));
    let (slope, along) = (libm::tan(rod), libm::cos(rod));
    let grip = libm::tan(35.0_f64.to_radians());
    let values = |push: f64| {
        [("R(C,2).size", push / along), ("N(3/ground)", 0.0)]
            .map(|(name, value)| (name, if name.starts_with('N') { push * slope } else { value }))
    };
    let both = |id: &str, push: f64| {
        let [size, normal] = values(push);
        // The guide presses upwards or downwards as the rod does.
        let sign = if sign_of_normal(&scene) < 0.0 { -1.0 } else { 1.0 };
        is_named(&scene, id, &[size, (normal.0, sign * normal.1)]);
    };
    both("friction-sense", 1000.0 / (1.0 + grip * slope));
    both("friction-left-out", 1000.0);
    both("normal-without-lean", 1000.0 * (1.0 + grip * slope));
    both("angle-for-coefficient", 1000.0 / (1.0 - 35.0_f64.to_radians() * slope));
}

/// The sense in which the guide presses, which no mistake here changes.
fn sign_of_normal(scene: &Value) -> f64 {
    solved(&scene.to_string()).expect("a scene").quantity("N(3/ground)").expect("a force").as_number()
}

/// At the shaft alone friction changes no other force: the torque takes ρ R more, R along the rod.
#[test]
fn a_circle_of_friction_by_the_diameter() {
    let (scene, rod, speed) = press(&json!([{ "pin": "A", "coefficient": 0.3, "radius": 25 }]));
    let radius = 25.0 * libm::sin(libm::atan(0.3));
    let force = 1000.0 / libm::cos(rod);
    let torque = |radius: f64| -1000.0 * speed / 10.0 + radius * force;
    is_named(&scene, "friction-circle-diameter", &[("T(1)", torque(2.0 * radius)), ("R(A,1).size", force)]);
    is_named(&scene, "friction-sense", &[("T(1)", torque(-radius))]);
    is_named(&scene, "friction-left-out", &[("T(1)", torque(0.0))]);
}

fn template(kind: &str) -> Value {
    serde_json::from_str(&files::read(&format!("templates/{kind}.json"))).expect("a scene")
}

/// A disc of 40 mm radius whose centre K is 20 mm from the shaft, a roller of 12 mm that goes up and down 8 mm beside it.
#[test]
fn a_cam_with_a_roller_taken_wrongly() {
    let scene = template("eccentric-cam");
    let (sine, cosine) = libm::sincos(50.0_f64.to_radians());
    let (k, v) = ([20.0 * cosine, 20.0 * sine], [-300.0 * sine, 300.0 * cosine]);
    let height = |distance: f64| (distance * distance - (8.0 - k[0]) * (8.0 - k[0])).sqrt();
    // Whose velocity differs from that of K across the line from K.
    let up = |[x, y]: [f64; 2]| (v[0] * x + v[1] * y) / y;
    let right = height(52.0);
    let relative = libm::hypot(v[0], up([8.0 - k[0], right]) - v[1]);
    // The sense: the roller's centre moves to the right over K, so the link turns clockwise.
    is_named(&scene, "roller-radius-left-out", &[("vplan(k,c)", relative), ("omega(2)", -relative / 40.0)]);
    let low = [8.0 - k[0], height(40.0)];
    is_named(&scene, "roller-radius-left-out", &[("vplan(c_ground,c)", up(low).abs()), ("v_r(3/ground)", up(low))]);
    is_named(&scene, "wrong-centre-of-curvature", &[("vplan(c_ground,c)", up([8.0, k[1] + right]).abs())]);
    is_named(&scene, "sliding-left-out", &[("vplan(c_ground,c)", 300.0), ("vplan(k,c)", 0.0), ("omega(2)", 0.0)]);
}

/// A lever about B that a disc about K touches from below.
#[test]
fn a_flat_face_taken_wrongly() {
    let scene = template("flat-follower");
    let (sine, cosine) = libm::sincos(40.0_f64.to_radians());
    let (k, v) = ([18.0 * cosine, 18.0 * sine], [-216.0 * sine, 216.0 * cosine]);
    let arm = [k[0] + 110.0, k[1] - 30.0];
    let length = libm::hypot(arm[0], arm[1]);
    // Along the line from B the velocity across it is that of the lever.
    let across = (arm[0] * v[1] - arm[1] * v[0]) / length;
    is_named(&scene, "face-along-wrong-line", &[("vplan(b,k_2)", across.abs()), ("omega(2)", across / length)]);
    is_named(&scene, "sliding-left-out", &[("vplan(b,k_2)", 216.0), ("v_r(K/2)", 0.0)]);
}
