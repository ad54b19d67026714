//! Drives of every kind, several together and one alone; mechanisms of any size and anywhere.

use super::ends::apart;
use super::{TURN, followed, path, posed, scenes};
use kinegon::Solution;
use kinegon::cycle::{Drive, Path, Position, alone};
use kinegon::mechanism::{Mechanism, Role, SliderId};
use kinegon::quantity::State;
use serde_json::Value;

/// The scene with all lengths times a factor, moved by a vector.
fn transformed(text: &str, factor: f64, by: [f64; 2]) -> String {
    let mut scene: Value = serde_json::from_str(text).expect("a scene is JSON");
    let scale = |value: &mut Value| {
        if let Some(x) = value.as_f64() {
            *value = (x * factor).into();
        }
    };
    let place = |value: &mut Value, moved: bool| {
        for (x, by) in value.as_array_mut().into_iter().flatten().zip(by) {
            let by = if moved { by } else { 0.0 };
            *x = (x.as_f64().expect("a coordinate") * factor + by).into();
        }
    };
    for key in ["ground", "near"] {
        for (_, value) in scene[key].as_object_mut().into_iter().flatten() {
            place(value, true);
        }
    }
    for (_, link) in scene["links"].as_object_mut().into_iter().flatten() {
        for key in ["lengths", "shape"] {
            let Some(values) = link.get_mut(key) else {
                continue;
            };
            for (_, value) in values.as_object_mut().into_iter().flatten() {
                scale(value);
                place(value, false);
            }
        }
    }
    for contact in scene["contacts"].as_array_mut().into_iter().flatten() {
        contact["radii"].as_array_mut().into_iter().flatten().for_each(scale);
    }
    if scene["contacts"].is_null() {
        scene.as_object_mut().expect("an object").remove("contacts");
    }
    for key in ["gears", "friction"] {
        let wheels = scene.get_mut(key).and_then(Value::as_array_mut);
        wheels.into_iter().flatten().filter_map(|own| own.get_mut("radius")).for_each(scale);
    }
    let sliders = scene.get_mut("sliders").and_then(Value::as_array_mut);
    for slider in sliders.into_iter().flatten() {
        let on_ground = slider["on"] == "ground";
        let ends = slider.get_mut("travel").and_then(Value::as_array_mut);
        ends.into_iter().flatten().for_each(scale);
        if let Some(through) = slider.get_mut("through") {
            place(through, on_ground);
        }
        for (_, value) in slider.get_mut("drive").and_then(Value::as_object_mut).into_iter().flatten() {
            scale(value);
        }
    }
    scene.to_string()
}

/// All rates of links, then of sliders, then all positions of sliders.
fn numbers(position: &Position, mechanism: &Mechanism) -> [Vec<f64>; 3] {
    let sliders = || (0..mechanism.sliders.len()).map(SliderId);
    let spins = mechanism.links().flat_map(|(id, _)| position.angular_rates(id));
    let rates = sliders().flat_map(|id| position.slide_rates(id));
    let places = sliders().map(|id| position.slide_position(id).expect("it has one"));
    [spins.collect(), rates.collect(), places.collect()]
}

/// Values of the drive on a path, well inside of it.
fn inside(path: &Path) -> Vec<f64> {
    let width = path.high() - path.low();
    (1..100).map(|k| path.low() + width * f64::from(k) / 100.0).collect()
}

/// A power of two changes no digit, and so no decision: all tolerances are relative.
#[test]
fn size_does_not_matter() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let path = followed(&mechanism, &pose);
        for factor in [libm::exp2(-20.0), libm::exp2(20.0)] {
            let (other, pose) = posed(&transformed(&text, factor, [0.0; 2]));
            let unit = if path.drive.is_angle { 1.0 } else { factor };
            let scaled = followed(&other, &pose);
            assert_eq!(scaled.node_count(), path.node_count(), "{name} {factor}");
            let (mut own, mut others) = (path.walker(), scaled.walker());
            for value in inside(&path) {
                let [spins, rates, places] = numbers(&own.position(value).expect("inside"), &mechanism);
                let position = others.position(value * unit).expect("inside");
                let scale = |numbers: Vec<f64>| numbers.into_iter().map(|x| x * factor).collect::<Vec<_>>();
                let expected = [spins, scale(rates), scale(places)];
                assert_eq!(numbers(&position, &other), expected, "{name} {factor} at {value}");
            }
        }
    }
}

/// Angular velocities of links, places of points and sliders, and velocities of sliders; each kind with the power of the length in it.
fn all_numbers(own: &Solution) -> [(i32, Vec<f64>); 3] {
    let places = own.pose.points.iter().flat_map(|place| [place.x, place.y]);
    let slides = own.pose.slides.iter().flatten().copied();
    let spins = own.mechanism.links().map(|(id, _)| own.motion.body(id));
    let rates = own.motion.slides.iter().map(|slide| slide.velocity);
    [(0, spins.map(|body| body.omega).collect()), (1, places.chain(slides).collect()), (1, rates.collect())]
}

/// Within the lengths that are allowed a scene with sliders can be assembled at every size, and its numbers are the same times a power of two.
#[test]
fn sliders_of_every_size() {
    let folders = ["templates", "tests/lecture", "tests/driven_sliders"];
    let all = folders.into_iter().flat_map(support::files::scenes);
    // Radii of wheels have limits of their own.
    let is_meant =
        |text: &str| text.contains("\"sliders\"") && !text.contains("\"points\": {") && !text.contains("\"gears\"");
    let with_sliders = all.filter(|(_, text)| is_meant(text));
    let mut count = 0;
    for (name, text) in with_sliders {
        let Ok(own) = support::stages::solved(&transformed(&text, 1.0, [0.0; 2])) else { continue };
        count += 1;
        for power in [52, 60, 70, 200, -52, -60, -70, -200] {
            let factor = libm::exp2(f64::from(power));
            let scaled = support::stages::solved(&transformed(&text, factor, [0.0; 2]));
            let scaled = scaled.unwrap_or_else(|error| panic!("{name} times 2^{power}: {error}"));
            for ((of_length, expected), (_, got)) in all_numbers(&own).into_iter().zip(all_numbers(&scaled)) {
                let expected: Vec<f64> = expected.into_iter().map(|x| x * factor.powi(of_length)).collect();
                let largest = expected.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
                assert_eq!(got.len(), expected.len());
                for (a, b) in got.iter().zip(&expected) {
                    assert!((a - b).abs() <= 1e-14 * largest, "{name} times 2^{power}: {got:?} {expected:?}");
                }
            }
        }
    }
    assert!(count > 30, "{count}");
}

/// The numbers agree to this part of the largest of their kind.
fn agree(name: &str, got: &[Vec<f64>; 3], expected: &[Vec<f64>; 3], within: f64) {
    for (got, expected) in got.iter().zip(expected) {
        let largest = expected.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        for (a, b) in got.iter().zip(expected) {
            assert!((a - b).abs() <= within * largest, "{name}: {got:?} {expected:?}");
        }
    }
}

/// Only differences of coordinates count, and those of a scene 10⁸ units away are exact.
#[test]
fn place_does_not_matter() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let path = followed(&mechanism, &pose);
        let (moved, pose) = posed(&transformed(&text, 1.0, [1e8, -3e8]));
        let far = followed(&moved, &pose);
        let (mut own, mut others) = (path.walker(), far.walker());
        for value in inside(&path) {
            let expected = numbers(&own.position(value).expect("inside"), &mechanism);
            let got = numbers(&others.position(value).expect("inside"), &moved);
            agree(&name, &got, &expected, 1e-12);
        }
        for above in [false, true] {
            let [near, far] = [&path, &far].map(|path| path.end(above).map(|end| end.at));
            let apart = near.zip(far).map_or(0.0, |(a, b)| (a - b).abs());
            let size = if path.drive.is_angle { TURN } else { 100.0 };
            assert!(near.is_some() == far.is_some() && apart < 1e-12 * size, "{name}: {near:?} {far:?}");
        }
    }
}

/// After a whole turn of the only crank everything is where it was.
#[test]
fn cycles_close() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let drives = mechanism.bodies.iter().filter(|b| matches!(b.role, Role::Driver { .. } | Role::Pushed { .. }));
        let mut path = path(&mechanism, &pose);
        path.follow_to(path.low() + 5.0 * TURN);
        if drives.count() > 1 || path.end(true).is_some() || !path.drive.is_angle {
            continue;
        }
        let mut walker = path.walker();
        for start in (0..36).map(|k| path.low() + 7.0 + 10.0 * f64::from(k)) {
            let first = numbers(&walker.position(start).expect("inside"), &mechanism);
            for turn in 1..4 {
                let again = walker.position(start + TURN * f64::from(turn)).expect("inside");
                agree(&name, &numbers(&again, &mechanism), &first, 1e-12);
            }
        }
    }
}

fn scene(name: &str) -> String {
    let mut scenes = scenes().into_iter();
    scenes.find(|(found, _)| found == name).expect("it is there").1
}

/// Another drive runs in proportion to its speed, and rates are those of both; alone it stands.
#[test]
fn two_cranks_together_and_one_alone() {
    let (mechanism, pose) = posed(&scene("five-bar"));
    let [first, second] = ["1", "4"].map(|name| mechanism.link(name).expect("a link"));
    let standing = alone(&mechanism, "1");
    for (mechanism, ratio, rates) in [(&mechanism, -0.75, [-3.0, 5.0]), (&standing, 0.0, [0.0, 0.0])] {
        let path = followed(mechanism, &pose);
        let mut walker = path.walker();
        for value in inside(&path) {
            let position = walker.position(value).expect("inside");
            let angle = |link| {
                let axis = position.axis(link).expect("a link has one");
                libm::atan2(axis.y, axis.x).to_degrees()
            };
            assert!(apart(angle(first), value) < 1e-12 * TURN);
            assert!(apart(angle(second), 50.0 + ratio * (value - 120.0)) < 1e-12 * TURN);
            assert_eq!(position.angular_rates(first), [4.0, 10.0]);
            assert_eq!(position.angular_rates(second), rates);
        }
    }
    // The other crank can lead as well: the same positions, seen from it.
    let drive = Drive::new(&mechanism, Some("4")).expect("it is a drive");
    let mut led = Path::new(&mechanism, &pose, drive).expect("the position is regular");
    led.follow_to(0.0);
    let path = followed(&mechanism, &pose);
    let (mut own, mut other) = (path.walker(), led.walker());
    for value in (0..50).map(f64::from) {
        let leading = 120.0 + (value - 50.0) * 4.0 / -3.0;
        let [a, b] = [own.position(leading), other.position(value)].map(|p| p.expect("inside").pose());
        let off = a.points.iter().zip(&b.points).map(|(a, b)| (a - b).norm());
        assert!(off.fold(0.0, f64::max) < 1e-11);
    }
}

/// A drive that stands in the scene still has a path; only its rates are zero.
#[test]
fn a_standing_drive_has_a_path() {
    let scene = scene("figure-2");
    let (mechanism, pose) = posed(&scene);
    let standing = alone(&mechanism, "nobody");
    let (moving, still) = (followed(&mechanism, &pose), followed(&standing, &pose));
    assert_eq!(moving.end(true), still.end(true));
    let (mut a, mut b) = (moving.walker(), still.walker());
    for value in inside(&moving) {
        let (a, b) = (a.position(value).expect("inside"), b.position(value).expect("inside"));
        assert_eq!(a.pose().points, b.pose().points);
        let [spins, rates, _] = numbers(&b, &standing);
        assert!(spins.iter().chain(&rates).all(|rate| *rate == 0.0), "{spins:?} {rates:?}");
    }
}
