//! Mechanisms of one kind side by side against each of them alone.

use super::{U, posed};
use kinegon::Order;
use kinegon::cycle::{CycleError, Variants};
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::motion::motion;
use kinegon::position::{Pose, pose};
use kinegon::quantity::State;
use kinegon::scene::Scene;
use serde_json::Value;
use support::random::Random;

const SCENES: [&str; 4] = [
    include_str!("../../../templates/four-bar.json"),
    include_str!("../../../templates/slider-crank.json"),
    include_str!("../../../templates/watt-1.json"),
    include_str!("../../../examples/figure-2.json"),
];

/// How many of each kind: two full blocks and a part of one.
const COUNT: usize = 75;

/// The scene with every length another by up to a fiftieth, and the drive at an angle.
fn varied(text: &str, dice: &mut Random, angle: f64) -> String {
    let mut scene: Value = serde_json::from_str(text).expect("JSON");
    let links = scene["links"].as_object_mut().expect("links");
    for link in links.values_mut() {
        if let Some(lengths) = link.get_mut("lengths").and_then(Value::as_object_mut) {
            for length in lengths.values_mut().filter(|v| v.is_number()) {
                let size = length.as_f64().expect("a length");
                *length = (size * (1.0 + dice.within(0.02))).into();
            }
        }
        if let Some(drive) = link.get_mut("drive").and_then(Value::as_object_mut) {
            drive.insert("angle".into(), angle.into());
        }
    }
    scene.to_string()
}

fn angle_of(text: &str) -> f64 {
    let scene: Value = serde_json::from_str(text).expect("JSON");
    let mut links = scene["links"].as_object().expect("links").values();
    links.find_map(|l| l["drive"]["angle"].as_f64()).expect("a drive")
}

fn alone(text: &str) -> Option<(Mechanism, Pose)> {
    let scene = Scene::read(text).ok()?;
    let mechanism = mechanism(&scene).ok()?;
    let pose = pose(&mechanism, &scene.near).ok()?;
    Some((mechanism, pose))
}

#[test]
fn each_moves_as_it_does_alone() {
    for (which, text) in SCENES.into_iter().enumerate() {
        let angle = angle_of(text);
        let texts = |angle: f64| -> Vec<String> {
            let mut dice = Random(7 + which as u64);
            (0..COUNT).map(|_| varied(text, &mut dice, angle)).collect()
        };
        let (mechanisms, poses): (Vec<_>, Vec<_>) = texts(angle).iter().map(|t| posed(t)).unzip();
        let mut variants = Variants::new(&mechanisms, &poses).expect("of one kind");
        for moved in [angle, angle + 4.0] {
            for index in 0..COUNT {
                variants.drives_mut(index)[0] = moved;
            }
            variants.compute();
            for (index, text) in texts(moved).iter().enumerate() {
                let (mechanism, pose) = alone(text).expect("it can be assembled");
                let expected = motion(&mechanism, &pose, Order::Acceleration).expect("regular");
                let position = variants.position(index).expect("it gets there");
                for (link, _) in mechanism.links() {
                    let body = expected.body(link);
                    let [omega, alpha] = position.angular_rates(link);
                    let condition = expected.conditions.iter().copied().fold(1.0, f64::max);
                    let sizes = |spin: fn(&kinegon::motion::BodyMotion) -> f64| {
                        let all = mechanism.links().map(|(l, _)| spin(expected.body(l)).abs());
                        all.fold(0.0, f64::max)
                    };
                    let allowed = 200.0 * U * condition * condition;
                    let off = (omega - body.omega).abs() / sizes(|b| b.omega);
                    assert!(off <= allowed, "{which} {index} omega {off:e} {allowed:e}");
                    let off = (alpha - body.alpha).abs() / sizes(|b| b.alpha);
                    assert!(off <= allowed, "{which} {index} alpha {off:e} {allowed:e}");
                }
            }
        }
    }
}

/// One that cannot get there says so and holds up no other.
#[test]
fn one_that_cannot_get_there_holds_up_no_other() {
    let text = SCENES[3];
    let (mechanisms, poses): (Vec<_>, Vec<_>) = (0..5).map(|_| posed(text)).unzip();
    let mut variants = Variants::new(&mechanisms, &poses).expect("of one kind");
    // The limit position is at 137.58°.
    variants.drives_mut(2)[0] = 138.0;
    variants.drives_mut(3)[0] = 71.0;
    variants.compute();
    let found: Vec<bool> = (0..5).map(|i| variants.position(i).is_some()).collect();
    assert_eq!(found, [true, true, false, true, true]);
    let spin = |index: usize| {
        let position = variants.position(index).expect("it gets there");
        mechanisms[0].links().map(|(l, _)| position.angular_rates(l)).collect::<Vec<_>>()
    };
    assert_eq!(spin(0), spin(4));
    assert_ne!(spin(0), spin(3));
}

#[test]
fn other_kinds_are_refused() {
    let (mechanisms, poses): (Vec<_>, Vec<_>) = SCENES[..2].iter().map(|t| posed(t)).unzip();
    let error = Variants::new(&mechanisms, &poses).expect_err("a four-bar is no slider-crank");
    assert_eq!(error, CycleError::NotOfOneKind(1));
}
