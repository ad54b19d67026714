//! Change points, where two branches cross: the motion that goes on smoothly is followed, and where rates are undetermined there are none.

use super::ends::{TURNS, apart, slider_crank};
use super::four_bars::FourBar;
use super::{TURN, U, path, posed};
use kinegon::cycle::{Happening, Path, Steps, Sweep};
use kinegon::mechanism::SliderId;
use kinegon::quantity::State;

/// How exactly a change point is located, in turns.
const LOCATED: f64 = 1e-12;

/// Around a change point there is nothing to read, in turns.
const BLANK: f64 = 1e-4;

/// The change points on a path are just these, whole turns aside.
fn changes(path: &Path, expected: &[f64]) -> Vec<f64> {
    let events = path.events().into_iter();
    let found = events.filter(|e| matches!(e.what, Happening::Change(_)));
    let found: Vec<f64> = found.map(|e| e.at).collect();
    let off = |at: f64| expected.iter().map(|e| apart(*e, at)).fold(f64::MAX, f64::min);
    for at in &found {
        assert!(off(*at) < LOCATED * TURN, "{at} {expected:?}");
    }
    let within = |at: &f64| (path.low()..=path.high()).contains(at);
    let turns = (-2..4).map(|turn| f64::from(turn) * TURN);
    let count = turns.flat_map(|t| expected.iter().map(move |e| e + t)).filter(within).count();
    assert_eq!(found.len(), count, "{found:?}");
    found
}

/// Four-bars whose shortest and longest link together are as long as the others, with their change points.
#[test]
fn four_bars() {
    let bars: [([f64; 4], &[f64]); 8] = [
        // Parallelograms, and antiparallelograms on their other branch.
        ([1.0, 2.0, 1.0, 2.0], &[0.0, 180.0]),
        ([70.0, 20.0, 70.0, 20.0], &[0.0, 180.0]),
        ([50.0, 50.5, 50.0, 50.5], &[0.0, 180.0]),
        // Kites: the crank as long as the ground, or as the coupler, which stays on it then.
        ([1.0, 2.0, 2.0, 1.0], &[0.0]),
        ([1.0, 1.0, 2.0, 2.0], &[0.0, 180.0]),
        // No two links alike, exact in f64 and not.
        ([1.0, 2.0, 4.0, 3.0], &[0.0]),
        ([1.0, 2.5, 3.25, 1.75], &[0.0]),
        ([0.7, 1.1, 1.3, 0.9], &[0.0]),
    ];
    for ([crank, coupler, rocker, ground], expected) in bars {
        let bar = FourBar { crank, coupler, rocker, ground };
        for hand in [1.0, -1.0] {
            for start in [50.0, 230.0, 359.0] {
                let (place, _) = bar.joint(start, hand).expect("it can be assembled");
                let (mechanism, pose) = posed(&bar.scene(start, place));
                let mut path = path(&mechanism, &pose);
                path.cover(Some(-300.0), Some(700.0)).expect("it can be followed");
                let found = changes(&path, expected);
                let joint = mechanism.point("C").expect("a point");
                let size = crank + coupler + rocker + ground;
                let mut walker = path.walker();
                for value in (-3000..7000).map(|k| 0.1 * f64::from(k)) {
                    let passed = found.iter().filter(|at| (start < **at) != (value < **at));
                    let hand = if passed.count() % 2 == 0 { hand } else { -hand };
                    let away = found.iter().map(|at| (at - value).abs()).fold(f64::MAX, f64::min);
                    let position = walker.position(value);
                    assert_eq!(position.is_none(), away < BLANK * TURN, "{bar:?} {value}");
                    let (Some(position), Some((place, sine))) = (position, bar.joint(value, hand)) else {
                        continue;
                    };
                    let got = position.place(joint);
                    let off = libm::hypot(got.x - place[0], got.y - place[1]) / size;
                    assert!(off < 20.0 * U / sine, "{bar:?} {hand} from {start} at {value}: {off:e}");
                }
            }
        }
    }
}

/// A coupler that is longer than the ground by 10⁻⁹: at 1 − cos φ = 10⁻¹¹ from where it would be a parallelogram that lies in
/// one line the dyad is folded, and nothing reaches the angles between. If it is shorter, the branches pass each other.
#[test]
fn branches_that_only_come_near_do_not_cross() {
    let limit = libm::sqrt(2e-11).to_degrees();
    for (from, to) in [(0.0, 60.0), (-1.0, 60.0), (-300.0, 700.0), (-10.0, 30.0), (-30.0, 30.5)] {
        for sense in [1.0, -1.0] {
            let bar = FourBar { crank: 60.0, coupler: 150.000_000_001, rocker: 60.0, ground: 150.0 };
            let (place, _) = bar.joint(30.0, 1.0).expect("it can be assembled");
            let (mechanism, pose) = posed(&bar.scene(30.0, place));
            let mut path = path(&mechanism, &pose);
            let both = if sense > 0.0 { [from, to] } else { [to, from] };
            both.iter().for_each(|value| path.follow_to(*value));
            let events = path.events();
            assert!(!events.iter().any(|e| matches!(e.what, Happening::Change(_))), "{from} to {to}: {events:?}");
            let ends: Vec<f64> =
                events.iter().filter(|e| matches!(e.what, Happening::Limit(_))).map(|e| e.at).collect();
            assert!(ends.iter().any(|at| (at - limit).abs() < 1e-3 * limit), "{from} to {to}: {events:?}");
        }
    }
}

/// A parallelogram at a crank angle of 50°.
pub fn parallelogram() -> String {
    let bar = FourBar { crank: 30.0, coupler: 80.0, rocker: 30.0, ground: 80.0 };
    let (place, _) = bar.joint(50.0, 1.0).expect("it can be assembled");
    bar.scene(50.0, place)
}

/// The rocker of a parallelogram turns with the crank, whatever it passes; rounding grows with the second and third power of the distance.
#[test]
fn a_parallelogram() {
    let (mechanism, pose) = posed(&parallelogram());
    let mut path = path(&mechanism, &pose);
    path.cover(Some(50.0), Some(770.0)).expect("it can be followed");
    let [coupler, rocker] = ["2", "3"].map(|name| mechanism.link(name).expect("a link"));
    let mut walker = path.walker();
    for value in (500..7700).map(|k| 0.1 * f64::from(k) + 0.04) {
        let position = walker.position(value).expect("it is on the path");
        let sine = libm::sin(value.to_radians()).abs();
        let [omega, alpha] = position.angular_rates(rocker);
        let off = [omega - 1.0, alpha, position.angular_rates(coupler)[0], position.angular_rates(coupler)[1]];
        let allowed = [2, 3, 2, 3].map(|power| 40.0 * U / sine.powi(power));
        for k in 0..4 {
            assert!(off[k].abs() < allowed[k], "{value}: {off:?} {allowed:?}");
        }
    }
}

/// Near a change point positions are known to rounding, one by one and many together, so rates lose one power of the
/// distance less.
#[test]
fn accuracy_is_even() {
    let bar = FourBar { crank: 60.0, coupler: 150.0, rocker: 60.0, ground: 150.0 };
    let (place, _) = bar.joint(60.0, 1.0).expect("it can be assembled");
    let scene = bar.scene(60.0, place).replace("\"omega\": 1", "\"omega\": 1, \"alpha\": 1");
    let (mechanism, pose) = posed(&scene);
    let rocker = mechanism.link("3").expect("a link");
    let mut path = path(&mechanism, &pose);
    path.cover(Some(-2.0), Some(20.0)).expect("it can be followed");
    let values: Vec<f64> = (5..500).map(|k| 0.01 * f64::from(k)).collect();
    let check = |value: f64, position: &dyn State| {
        let angle = value.to_radians();
        let axis = position.axis(rocker).expect("an axis");
        let [omega, alpha] = position.angular_rates(rocker);
        let off = [libm::atan2(axis.y, axis.x) - angle, omega - 1.0, alpha - 1.0];
        let allowed = [4.0 * U, 4.0 * U / angle, 4.0 * U / (angle * angle)];
        for k in 0..3 {
            assert!(off[k].abs() <= allowed[k], "{value}: {off:?} {allowed:?}");
        }
    };
    let mut walker = path.walker();
    for value in &values {
        check(*value, &walker.position(*value).expect("it is on the path"));
    }
    let names = ["angle(3)", "omega(3)", "alpha(3)"].map(String::from);
    let steps = Steps::new(0.05, 5.0, 0.01).expect("steps");
    let table = Sweep::new(&path, steps, Some(&names)).expect("quantities");
    for row in table.rows(0..table.steps.count()).chunks(4) {
        let [value, angle, omega, alpha] = [0, 1, 2, 3].map(|k| row[k].expect("a number"));
        let turned = value.to_radians();
        let off = [angle.to_radians() - turned, omega - 1.0, alpha - 1.0];
        let allowed = [4.0 * U, 4.0 * U / turned, 4.0 * U / (turned * turned)];
        for k in 0..3 {
            assert!(off[k].abs() <= allowed[k], "{value}: {off:?} {allowed:?}");
        }
    }
}

/// Lengths that miss a change point by little: only what is there is told.
#[test]
fn next_to_a_parallelogram() {
    let path_of = |coupler: f64, check: &dyn Fn(&Path)| {
        let scene = FourBar { crank: 60.0, coupler, rocker: 60.0, ground: 150.0 };
        let (place, _) = scene.joint(30.0, 1.0).expect("it can be assembled");
        let (mechanism, pose) = posed(&scene.scene(30.0, place));
        let mut path = path(&mechanism, &pose);
        path.cover(Some(0.0), Some(60.0)).expect("it can be followed");
        check(&path);
    };
    // Links 2 and 3 turn the same way all along: nothing stops.
    path_of(150.000000001, &|path| {
        let stops = path.events().into_iter().filter(|e| matches!(e.what, Happening::TurnsBack { .. }));
        assert_eq!(stops.collect::<Vec<_>>(), []);
        // Nor do branches cross: the dyad is folded before they come together.
        assert!(!path.events().iter().any(|e| matches!(e.what, Happening::Change(_))));
        let limit = path.events().into_iter().find(|e| matches!(e.what, Happening::Limit(_))).expect("a limit");
        assert!(path.touches(&limit, [0.0, 60.0]) && !path.touches(&limit, [1.0, 60.0]), "{limit:?}");
    });
    // The rocker stops where crank and coupler lie in line, 210 mm less the gap long.
    path_of(149.999999999, &|path| {
        let stops = path.events().into_iter().filter(|e| matches!(e.what, Happening::TurnsBack { .. }));
        let stops: Vec<f64> = stops.map(|e| e.at).collect();
        let expected = libm::sqrt(2.0 * 1e-9 * 120.0 / (2.0 * 150.0 * 210.0)).to_degrees();
        assert!(stops.len() == 1 && (stops[0] - expected).abs() < 1e-4 * expected, "{stops:?} {expected}");
    });
}

/// With a rod as long as the crank the piston passes the crank's pivot, x = 2 a cos θ; or it stays there and the rod turns with the crank.
#[test]
fn a_rod_as_long_as_the_crank() {
    for stays in [false, true] {
        let scene = slider_crank(50.0, 50.0, 0.0, [TURNS, ""]);
        let place = if stays { [0.0, 0.0] } else { [100.0, 0.0] };
        let near = format!("\"near\": {{ \"C\": {place:?} }} }}");
        let scene = format!("{}{near}", &scene[..scene.find("\"near\"").expect("it has one")]);
        let (mechanism, pose) = posed(&scene);
        let mut path = path(&mechanism, &pose);
        path.cover(Some(2.0), Some(722.0)).expect("it can be followed");
        changes(&path, &[90.0, 270.0]);
        let piston = SliderId(0);
        let mut walker = path.walker();
        for value in (20..7220).map(|k| 0.1 * f64::from(k) + 0.04) {
            let position = walker.position(value).expect("it is on the path");
            let (sine, cosine) = libm::sincos(value.to_radians());
            let factor = if stays { 0.0 } else { 100.0 };
            let expected = [cosine, -sine, -cosine].map(|x| factor * x);
            let [speed, second] = position.slide_rates(piston);
            let got = [position.slide_position(piston).expect("it has one"), speed, second];
            for k in 0..3 {
                let allowed = 4000.0 * U / cosine.abs().powi(k as i32 + 1);
                assert!((got[k] - expected[k]).abs() < allowed, "{value}: {got:?} {expected:?}");
            }
        }
    }
}
/// A path that begins next to a change point takes a run-up from the other side.
#[test]
fn a_start_next_to_a_change_point() {
    let bar = FourBar { crank: 30.0, coupler: 80.0, rocker: 30.0, ground: 80.0 };
    for away in [1.0, 0.1, 1e-2, 1e-3, 1e-4, -1e-4, -1e-3, -1e-2, -0.1, -1.0] {
        for hand in [1.0, -1.0] {
            let start = 180.0 + away;
            let (place, _) = bar.joint(start, hand).expect("it can be assembled");
            let (mechanism, pose) = posed(&bar.scene(start, place));
            let mut path = path(&mechanism, &pose);
            path.cover(Some(0.5), Some(700.0)).expect("it can be followed");
            changes(&path, &[0.0, 180.0]);
        }
    }
}

/// Two parallelograms in a row are singular at once; each goes on smoothly.
#[test]
fn two_parallelograms_in_a_row() {
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [80, 0], "G": [150, 0] },
      "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 30 }, "drive": { "angle": 50, "omega": 1 } },
                 "2": { "points": ["B", "C"], "lengths": { "BC": 80 } }, "3": { "points": ["D", "C"], "lengths": { "DC": 30 } },
                 "4": { "points": ["C", "F"], "lengths": { "CF": 70 } }, "5": { "points": ["G", "F"], "lengths": { "GF": 30 } } },
      "near": { "C": [100, 23], "F": [170, 23] } }"#;
    let (mechanism, pose) = posed(scene);
    let mut path = path(&mechanism, &pose);
    path.cover(Some(50.0), Some(770.0)).expect("it can be followed");
    changes(&path, &[0.0, 180.0]);
    let [three, five] = ["3", "5"].map(|name| mechanism.link(name).expect("a link"));
    let mut walker = path.walker();
    for value in (50..770).map(|k| f64::from(k) + 0.5) {
        let position = walker.position(value).expect("it is on the path");
        for link in [three, five] {
            let [omega, alpha] = position.angular_rates(link);
            assert!((omega - 1.0).abs() < 1e-9 && alpha.abs() < 1e-6, "{value}: {omega} {alpha}");
        }
    }
}
