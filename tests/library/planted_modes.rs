//! Random groups of classes II to IV are written down by lengths from an assembly that is known: that assembly must be among
//! the modes, and `near` must choose it. In half of the groups a link is cut in two that a driven slider joins; of those the angular
//! velocities and the second route are demanded too.
//!
//! Release builds try 12 000 groups, debug builds 2 400. Groups whose planted position is nearly singular are left out: their modes
//! are not far enough apart. The Jacobian that says so, and gives the velocities, is made here from the joints of all links, apart from
//! the library.

use kinegon::Order;
use std::collections::BTreeMap;
use support::survey::PLANTED_GROUPS;

use kinegon::construction::{Extent, construct};
use kinegon::mechanism::{Mechanism, mechanism};
use kinegon::motion::motion;
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;
use support::planted::{Planted, pattern};
use support::random::Random;

/// Groups of each class.
fn groups() -> usize {
    PLANTED_GROUPS.now()
}

/// The largest condition number of a planted position.
const CONDITION: f64 = 1e4;

/// How far a point may be from where it was planted, in sizes of the mechanism; at the largest condition there are still
/// three digits between this and rounding.
const BOUND: f64 = 1e-9;

#[test]
fn dyads() {
    plant("II", 0x11);
}

#[test]
fn third_class() {
    plant("III", 0x111);
}

#[test]
fn fourth_class() {
    plant("IV", 0x1111);
}

fn plant(class: &str, seed: u64) {
    let mut random = Random(seed);
    let groups = groups();
    let (mut tried, mut left_out, mut modes) = (0, 0, 0);
    let mut worst: f64 = 0.0;
    let mut kinds_seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut failures = Vec::new();
    while tried < groups {
        let (kinds, joints) = pattern(&mut random, class);
        let mut planted = Planted::new(&mut random, &kinds, &joints);
        if tried % 2 == 1 {
            planted.cut(&mut random);
        }
        let condition = planted.condition();
        if condition.is_nan() || condition > CONDITION {
            left_out += 1;
            assert!(left_out < 20 * groups, "most groups can be planted");
            continue;
        }
        tried += 1;
        *kinds_seen.entry(kinds.clone()).or_default() += 1;
        match find(&planted, class) {
            Ok((error, count)) => {
                worst = worst.max(error);
                modes += count;
            }
            Err(problem) => {
                failures.push(format!("{kinds}: {problem}\n{}", planted.scene()));
            }
        }
    }
    println!(
        "{tried} groups of {} patterns, {left_out} left out; {modes} modes; largest error {worst:.1e}",
        kinds_seen.len(),
    );
    let count = failures.len();
    failures.truncate(4);
    assert!(count == 0, "{count} of {tried}:\n{}", failures.join("\n"));
}

/// Largest error of a point, in sizes of the mechanism, and the number of modes.
fn find(planted: &Planted, class: &str) -> Result<(f64, usize), String> {
    let scene = Scene::read(&planted.scene()).map_err(|e| e.to_string())?;
    let mechanism = mechanism(&scene).map_err(|e| e.to_string())?;
    let classes: Vec<&str> = mechanism.groups.iter().map(|g| g.class.numeral()).collect();
    if classes != [class] {
        return Err(format!("groups of classes {classes:?} in place of {class}"));
    }
    let pose = pose(&mechanism, &scene.near).map_err(|e| e.to_string())?;
    if !pose.warnings.is_empty() {
        return Err(pose.warnings.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "));
    }
    let count = pose.assemblies.iter().flatten().map(|a| a.modes).product();
    if count == 0 {
        return Err("no modes are counted".to_owned());
    }
    let mut largest: f64 = 0.0;
    for (name, [x, y]) in planted.inner() {
        let place = pose.point(mechanism.point(name).ok_or("a point is missing")?);
        let off = libm::hypot(place.x / planted.scale - x, place.y / planted.scale - y);
        // Places are within ±1, so the mechanism's size is about 2.
        if off.is_nan() || off > 2.0 * BOUND {
            let modes = format!("the closest of {count} modes");
            return Err(format!("{name} is {off:.2e} off in {modes}"));
        }
        largest = largest.max(off / 2.0);
    }
    if planted.piece.is_some() {
        moves(planted, &mechanism, &pose)?;
    }
    Ok((largest, count))
}

/// Whether the angular velocities are those of the Jacobian, and the second route finds the same rates.
fn moves(planted: &Planted, mechanism: &Mechanism, pose: &Pose) -> Result<(), String> {
    let motion = motion(mechanism, pose, Order::Acceleration).map_err(|e| e.to_string())?;
    let (matrix, right) = planted.jacobian();
    let rates = matrix.lu().solve(&right).ok_or("no velocities")?;
    let links = planted.bodies.len() - 3;
    let scale = (0..links).fold(1.0, |m: f64, link| m.max(rates[3 * link + 2].abs()));
    for link in 0..links {
        let body = mechanism.link(&format!("b{}", link + 2)).ok_or("a link is missing")?;
        let (omega, truth) = (motion.body(body).omega, rates[3 * link + 2]);
        let off = (omega - truth).abs() / scale;
        if off.is_nan() || off > BOUND {
            return Err(format!("b{} turns with {omega} in place of {truth}", link + 2));
        }
    }
    for agreement in construct(mechanism, pose, &motion, Extent::Points).agreement.iter().flatten() {
        if agreement.difference > agreement.allowed {
            return Err(format!("the routes differ: {agreement:?}"));
        }
    }
    Ok(())
}
