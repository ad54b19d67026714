//! Slotted levers with one point: which way round they are taken, and how many assembly modes they have. A crank AB turns about A,
//! its pin B slides on a lever that turns about O: what is expected follows from the places of O and B alone.

use kinegon::geometry::{Point, degrees_of};
use kinegon::mechanism::mechanism;
use kinegon::position::{pose, poses};
use kinegon::scene::Scene;
use serde_json::{Value, json};

const CRANK: f64 = 60.0;

/// Error of a length in the mechanism's size, and of an angle in degrees.
const BOUND: f64 = 1e-11;

fn scene(pivot: [f64; 2], angle: f64) -> Value {
    json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "O": pivot },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": CRANK }, "drive": { "angle": angle, "omega": 10 } },
            "2": { "points": ["B"] },
            "3": { "points": ["O"] }
        },
        "sliders": [{ "link": "2", "at": "B", "on": "3" }]
    })
}

/// Angle of link 3 and position of the first slider, in the pose that `near` picks and in every listed one.
fn found(scene: &Value) -> ((f64, f64), Vec<(f64, f64)>) {
    let scene = Scene::read(&scene.to_string()).expect("a scene");
    let mechanism = mechanism(&scene).expect("a mechanism");
    let lever = mechanism.link("3").expect("a link");
    let read = |pose: &kinegon::position::Pose| {
        let axis = pose.axes[lever.0].expect("an axis");
        (degrees_of(axis), pose.slides[0].expect("a position"))
    };
    let picked = pose(&mechanism, &scene.near).expect("it can be assembled");
    let all = poses(&mechanism, &scene.near).expect("it can be assembled");
    let modes = picked.assemblies[0].expect("from lengths").modes;
    assert_eq!(modes, all.len());
    (read(&picked), all.iter().map(read).collect())
}

/// Where the pin is, seen from the pivot: angle in degrees, and distance.
fn truth(pivot: [f64; 2], angle: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(angle.to_radians());
    let arm = Point::new(CRANK * cos, CRANK * sin) - Point::from(pivot);
    (degrees_of(arm), libm::hypot(arm.x, arm.y))
}

fn assert_near(got: (f64, f64), want: (f64, f64), what: &str) {
    let turned = libm::remainder(got.0 - want.0, 360.0);
    let off = (got.1 - want.1) / CRANK;
    assert!(turned.abs() < BOUND && off.abs() < BOUND, "{what}: {got:?} in place of {want:?}");
}

const PIVOTS: [[f64; 2]; 4] = [[0.0, -120.0], [0.0, 120.0], [-35.0, 20.0], [7.0, -9.0]];

#[test]
fn the_pin_is_on_the_positive_side() {
    for pivot in PIVOTS {
        for angle in (0..360).step_by(15).map(f64::from) {
            let what = format!("pivot {pivot:?}, crank at {angle}°");
            let want = truth(pivot, angle);
            let block = scene(pivot, angle);
            let mut pin = block.clone();
            pin["links"].as_object_mut().expect("links").remove("2");
            pin["sliders"][0] = json!({ "pin": "B", "on": "3" });
            for scene in [block, pin] {
                let (picked, all) = found(&scene);
                assert_near(picked, want, &what);
                assert_eq!(all.len(), 1, "{what}");
            }
        }
    }
}

#[test]
fn near_may_turn_the_lever_round() {
    for pivot in PIVOTS {
        for angle in [20.0, 200.0] {
            let (lever, distance) = truth(pivot, angle);
            for (turn, slide) in [(5.0, distance), (170.0, -distance)] {
                let mut scene = scene(pivot, angle);
                scene["near"] = json!({ "angle(3)": lever + turn });
                let (picked, all) = found(&scene);
                let what = format!("pivot {pivot:?}, crank at {angle}°, near {turn}° from the pin");
                let turned = if slide > 0.0 { 0.0 } else { 180.0 };
                assert_near(picked, (lever + turned, slide), &what);
                assert_eq!(all.len(), 2, "{what}");
            }
        }
    }
}

/// A slot that passes the pivot by is another lever when turned by 180°: both ways are modes, without being asked for.
#[test]
fn a_slot_beside_the_pivot_has_two_modes() {
    let (pivot, angle, beside) = ([0.0, 120.0], 35.0, 25.0);
    let mut scene = scene(pivot, angle);
    scene["links"]["3"] = json!({ "shape": { "O": [0, 0] } });
    scene["sliders"][0]["through"] = json!([0, beside]);
    let (lever, distance) = truth(pivot, angle);
    // B is (s, beside) in the lever's own frame.
    let mut want: Vec<(f64, f64)> = [1.0, -1.0]
        .map(|sign| {
            let slide = sign * (distance * distance - beside * beside).sqrt();
            (lever - libm::atan2(beside, slide).to_degrees(), slide)
        })
        .to_vec();
    want.sort_by(|a, b| a.0.rem_euclid(360.0).total_cmp(&b.0.rem_euclid(360.0)));
    let (_, all) = found(&scene);
    assert_eq!(all.len(), 2);
    for (got, want) in all.into_iter().zip(want) {
        assert_near(got, want, "beside");
    }
}

/// A rod with a second point is not the same when it is turned: what slides through the swivel from either side stays two modes.
#[test]
fn a_rod_through_a_swivel_keeps_both_modes() {
    let mut scene = scene([0.0, 120.0], 35.0);
    scene["links"]["2"] = json!({ "points": ["B", "C"], "lengths": { "BC": 50 } });
    let (_, all) = found(&scene);
    assert_eq!(all.len(), 2);
    assert!((all[0].1 + all[1].1).abs() < BOUND * CRANK);
}
