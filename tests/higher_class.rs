//! Groups of higher class.

use kinegon::mechanism::mechanism;
use kinegon::motion::{Motion, Order, motion};
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;
use serde_json::{Value, json};

fn moved(scene: &Value) -> (kinegon::mechanism::Mechanism, Pose, Motion) {
    let scene = Scene::read(&scene.to_string()).expect("a scene");
    let mechanism = mechanism(&scene).expect("a mechanism");
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    let motion = motion(&mechanism, &pose, Order::Acceleration).expect("it moves");
    (mechanism, pose, motion)
}

/// Three bars pinned to a triangle are one rigid link: they move as the coupler of a four-bar linkage in whose place they stand.
#[test]
fn three_bars_move_as_one_link() {
    let drawn = |coupler: &[(&str, Value)]| {
        let mut scene = json!({
            "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": ["A", "D"],
            "points": { "A": [0, 0], "B": [30, 25], "C": [110, 50], "D": [100, -10], "J": [40, 60], "K": [75, 90], "L": [95, 70] },
            "links": { "1": { "points": ["A", "B"], "drive": { "omega": 3, "alpha": -2 } } }
        });
        for (name, points) in coupler {
            scene["links"][*name] = points.clone();
        }
        scene
    };
    let rocker = ("r", json!(["C", "D"]));
    let (link, _, one) = moved(&drawn(&[
        ("2", json!(["B", "J", "K", "L", "C"])),
        rocker.clone(),
    ]));
    let [a, b, c] = [
        ("a", json!(["B", "J", "K"])),
        ("b", json!(["K", "L"])),
        ("c", json!(["L", "J", "C"])),
    ];
    for links in [
        [&a, &b, &c, &rocker],
        [&rocker, &c, &a, &b],
        [&b, &rocker, &c, &a],
        [&c, &b, &a, &rocker],
    ] {
        let (mechanism, pose, three) = moved(&drawn(&links.map(Clone::clone)));
        assert_eq!(mechanism.groups.len(), 1);
        let whole = one.body(link.link("2").expect("the coupler"));
        for name in ["a", "b", "c"] {
            let bar = three.body(mechanism.link(name).expect("a bar"));
            assert!((bar.omega - whole.omega).abs() < 1e-12, "{name}");
            assert!((bar.alpha - whole.alpha).abs() < 1e-12, "{name}");
            for point in ["B", "C", "J", "K", "L"] {
                let place = pose.point(mechanism.point(point).expect("a point"));
                let (got, want) = (bar.acceleration_at(place), whole.acceleration_at(place));
                assert!(
                    (got - want).norm() < 1e-9,
                    "{point} of {name}: {got} {want}"
                );
            }
        }
    }
}
