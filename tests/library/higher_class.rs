//! Groups of higher class: random ones of six links, written down by lengths from an assembly that is known, and a platform of bars.

use kinegon::Order;
use kinegon::Solution;
use kinegon::geometry::Vector;
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::motion::motion;
use kinegon::position::{AssemblyError, Count, Listed, Pose, pose, poses};
use kinegon::scene::Scene;
use serde_json::{Value, json};
use support::files;
use support::planted::{KNOWN, Planted};
use support::random::Random;
use support::stages::solved;
use support::survey::HIGHER_CLASS;

/// Random groups tried.
fn groups() -> usize {
    HIGHER_CLASS.now()
}

/// The largest condition number of a planted position.
const CONDITION: f64 = 1e3;

/// What may be left of a link's lengths, in sizes of the mechanism.
const RESIDUAL: f64 = 1e-10;

/// Joints of six links, to known bodies and between each other, as the lot will have it.
fn joints(random: &mut Random) -> Vec<(usize, usize)> {
    let outer = 2 + random.below(3);
    let mut joints: Vec<(usize, usize)> = Vec::new();
    while joints.len() < 9 {
        let a = random.below(6);
        let b = if joints.len() < outer { KNOWN } else { random.below(6) };
        let again = b != KNOWN && (joints.contains(&(a, b)) || joints.contains(&(b, a)));
        if a != b && !again {
            joints.push((a, b));
        }
    }
    joints
}

/// The next random mechanism whose only group is one of six links, well conditioned.
fn next(random: &mut Random) -> (Planted, Scene, Mechanism) {
    loop {
        let joints = joints(random);
        let kind = |_| if random.below(4) == 0 { 'P' } else { 'R' };
        let kinds: String = joints.iter().map(kind).collect();
        let planted = Planted::new(random, &kinds, &joints);
        let condition = planted.condition();
        if condition.is_nan() || condition > CONDITION {
            continue;
        }
        let scene = Scene::read(&planted.scene()).expect("a scene");
        // Most lots make no group, or several small ones.
        if let Ok(mechanism) = mechanism(&scene)
            && let [group] = mechanism.groups.as_slice()
        {
            assert_eq!(group.class.numeral(), "higher");
            return (planted, scene, mechanism);
        }
    }
}

/// By how much points of a link are not as far apart as they should be, in sizes of the mechanism (about 2 of the planted units).
fn residual(planted: &Planted, mechanism: &Mechanism, pose: &Pose) -> f64 {
    let bodies = mechanism.bodies.iter();
    let misses = bodies.flat_map(|body| {
        let own = body.points.iter().zip(&body.local);
        own.clone()
            .flat_map(move |(&p, a)| own.clone().map(move |(&q, b)| (pose.arm(p, q).norm() - (b - a).norm()).abs()))
    });
    misses.fold(0.0, f64::max) / (2.0 * planted.scale)
}

/// The largest distance of a point from where it was planted, in sizes of the mechanism.
fn distance(planted: &Planted, mechanism: &Mechanism, pose: &Pose) -> f64 {
    let distances = planted.inner().map(|(name, [x, y])| {
        let place = pose.point(mechanism.point(name).expect("a point"));
        libm::hypot(place.x / planted.scale - x, place.y / planted.scale - y)
    });
    distances.fold(0.0, f64::max) / 2.0
}

/// Places up to 5 % of the mechanism's size off lead to the planted assembly; without any it is among those listed.
#[test]
fn the_planted_assembly_is_found() {
    let mut random = Random(0x6111);
    let (mut listed, mut modes) = (0, 0);
    let groups = groups();
    for _ in 0..groups {
        let (planted, scene, mechanism) = next(&mut random);
        let mut near = scene.near.clone();
        for place in near.points.values_mut() {
            for x in place {
                *x += 0.05 * 2.0 * planted.scale * random.within(1.0);
            }
        }
        let found = pose(&mechanism, &near).unwrap_or_else(|e| panic!("{e}\n{}", planted.scene()));
        let off = distance(&planted, &mechanism, &found);
        assert!(off < 1e-9, "{off:.1e} off\n{}", planted.scene());
        let [warning] = found.warnings.as_slice() else {
            panic!("{:?}", found.warnings);
        };
        assert!(warning.to_string().contains("there may be more"), "{warning}");

        let all = poses(&mechanism, &Default::default()).expect("at least one");
        for mode in &all {
            let left = residual(&planted, &mechanism, mode);
            assert!(left <= RESIDUAL, "{left:.1e} is left\n{}", planted.scene());
        }
        let is_planted = |mode: &Pose| distance(&planted, &mechanism, mode) < 1e-9;
        listed += usize::from(all.iter().any(is_planted));
        modes += all.len();
        let count = Count { number: all.len() as u64, is_exact: true };
        let text = kinegon::format::listed_modes(&scene, &mechanism, &Listed { poses: all, count });
        assert!(text.contains("there may be more"), "{text}");
    }
    println!("{groups} groups, {modes} modes, the planted one listed in {listed}");
    assert!(100 * listed >= 98 * groups, "{listed} of {groups}");
}

/// Velocities against differences of positions that are found anew with the crank turned a little.
#[test]
fn velocities_are_derivatives_of_positions() {
    let mut random = Random(0x6222);
    for _ in 0..groups().div_ceil(4) {
        let (planted, scene, mechanism) = next(&mut random);
        let start = pose(&mechanism, &scene.near).expect("it can be assembled");
        let moves = motion(&mechanism, &start, Order::Velocity).expect("it moves");
        let text: Value = serde_json::from_str(&planted.scene()).expect("JSON");
        // In radians; the crank makes 1 rad in a unit of time.
        let at = |turn: f64| -> Vec<Vector> {
            let mut text = text.clone();
            let angle = text["links"]["b1"]["drive"]["angle"].as_f64();
            let angle = angle.expect("a number") + turn.to_degrees();
            text["links"]["b1"]["drive"]["angle"] = json!(angle);
            moved(&text).pose.points.iter().map(|p| p.coords).collect()
        };
        let step = 1e-4;
        let difference = |step: f64| -> Vec<Vector> {
            let (before, after) = (at(-step), at(step));
            let pairs = after.into_iter().zip(before);
            pairs.map(|(a, b)| (a - b) / (2.0 * step)).collect()
        };
        // Richardson's extrapolation takes the error of second order away.
        let (fine, coarse) = (difference(step), difference(2.0 * step));
        let velocities: Vec<Vector> = fine.iter().zip(&coarse).map(|(f, c)| (f * 4.0 - c) / 3.0).collect();
        let largest = velocities.iter().fold(0.0, |m: f64, v| m.max(v.norm()));
        for body in 0..mechanism.bodies.len() {
            for &point in &mechanism.bodies[body].points {
                let got = moves.bodies[body].velocity_at(start.point(point));
                let off = (got - velocities[point.0]).norm() / largest;
                assert!(off < 1e-7, "{off:.1e} off\n{}", planted.scene());
            }
        }
    }
}

#[test]
fn what_is_not_found_is_said_so() {
    let mut random = Random(0x6333);
    let (planted, _, _) = next(&mut random);
    let mut text: Value = serde_json::from_str(&planted.scene()).expect("JSON");
    // A link cannot reach anything a thousand sizes away.
    let ground = text["ground"].as_object_mut().expect("points");
    let (_, far) = ground.iter_mut().next_back().expect("a joint on the ground");
    *far = json!([2000.0 * planted.scale, 0]);
    let scene = Scene::read(&text.to_string()).expect("a scene");
    let error = pose(&mechanism(&scene).expect("a mechanism"), &scene.near).unwrap_err();
    assert!(matches!(error, AssemblyError::NotFound { .. }), "{error}");
    let message = error.to_string();
    assert!(message.contains("starts closes") && message.contains("`near`"), "{message}");
}

/// A crank with a fourth-class group and one of its links doubled in place of a drive: the count of freedoms is right, but the doubled link
/// holds twice what is held already, and all others can move. So there is nothing to search.
#[test]
fn a_doubled_link_is_no_drive() {
    let scene = files::read("tests/fuzzed/doubled_link.json");
    let scene = Scene::read(&scene).expect("a scene");
    let refused = mechanism(&scene).unwrap_err().to_string();
    assert!(refused.contains("can still move"), "{refused}");
}

fn moved(scene: &Value) -> Solution {
    solved(&scene.to_string()).expect("it moves")
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
    let one = moved(&drawn(&[("2", json!(["B", "J", "K", "L", "C"])), rocker.clone()]));
    let [a, b, c] = [("a", json!(["B", "J", "K"])), ("b", json!(["K", "L"])), ("c", json!(["L", "J", "C"]))];
    for links in [[&a, &b, &c, &rocker], [&rocker, &c, &a, &b], [&b, &rocker, &c, &a], [&c, &b, &a, &rocker]] {
        let Solution { mechanism, pose, motion, .. } = moved(&drawn(&links.map(Clone::clone)));
        assert_eq!(mechanism.groups.len(), 1);
        let whole = one.motion.body(one.mechanism.link("2").expect("the coupler"));
        for name in ["a", "b", "c"] {
            let bar = motion.body(mechanism.link(name).expect("a bar"));
            assert!((bar.omega - whole.omega).abs() < 1e-12, "{name}");
            assert!((bar.alpha - whole.alpha).abs() < 1e-12, "{name}");
            for point in ["B", "C", "J", "K", "L"] {
                let place = pose.point(mechanism.point(point).expect("a point"));
                let (got, want) = (bar.acceleration_at(place), whole.acceleration_at(place));
                assert!((got - want).norm() < 1e-9, "{point} of {name}: {got} {want}");
            }
        }
    }
}
