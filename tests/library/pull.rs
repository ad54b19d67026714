//! A mechanism pulled by its points: it comes as near as it can, on its branch, with one drive.

use kinegon::Solution;
use kinegon::cycle::{Drive, Happening, Pull, Pulled};
use kinegon::geometry::{Point, Vector, degrees_of, span};
use kinegon::mechanism::PointId;
use kinegon::scene::GivenBy;
use support::files;
use support::random::Random;
use support::stages::solved;
use support::survey::PULLS;

/// Every scene that can be moved, with its name.
fn movable() -> Vec<(String, Solution)> {
    let folders = ["templates", "examples", "tests/lecture", "tests/driven_sliders"];
    let scenes = folders.into_iter().flat_map(files::scenes);
    let solutions = scenes.filter_map(|(name, text)| Some((name, solved(&text).ok()?)));
    let can_move = |(_, solution): &(String, Solution)| {
        solution.mechanism.given_by != GivenBy::Drawing && !solution.mechanism.drive_names().is_empty()
    };
    solutions.filter(can_move).collect()
}

fn scene(path: &str) -> Solution {
    solved(&files::read(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn point(solution: &Solution, name: &str) -> PointId {
    solution.mechanism.point(name).unwrap_or_else(|| panic!("there is no point {name}"))
}

fn size(solution: &Solution) -> f64 {
    span(solution.pose.points.iter().copied())
}

/// Farthest that a point is in one pose from where it is in the other.
fn apart(a: &Pulled, b: &Pulled) -> f64 {
    a.pose.points.iter().zip(&b.pose.points).map(|(p, q)| (p - q).norm()).fold(0.0, f64::max)
}

#[test]
fn a_crank_goes_to_the_angle_of_the_pointer_round_and_round() {
    let solution = scene("templates/four-bar.json");
    let (pivot, pin) = (solution.pose.point(point(&solution, "A")), point(&solution, "B"));
    let mut pull = Pull::new(&solution, None).expect("it can be moved");
    let start = pull.value();
    for step in 1..=400 {
        let degrees = start + 13.7 * f64::from(step);
        let (sine, cosine) = libm::sincos(degrees.to_radians());
        // Nearer than the pin or farther makes no difference.
        let arm = if step % 2 == 0 { 3.0 } else { 900.0 };
        let pulled = pull.to_place(pin, pivot + Vector::new(cosine, sine) * arm);
        assert!((pulled.value - degrees).abs() < 1e-9, "{} at {degrees}", pulled.value);
        assert!(pulled.limit.is_none());
    }
}

/// A little to either side the point is no nearer, or a limit stops the drive.
#[test]
fn a_pulled_point_comes_nearest() {
    let mut random = Random(17);
    let (mut met, mut stopped) = (0, 0);
    for (name, solution) in movable() {
        let size = size(&solution);
        for (index, start) in solution.pose.points.iter().enumerate() {
            let id = PointId(index);
            let Ok(mut pull) = Pull::of_point(&solution, id) else { continue };
            let unit = if pull.drive().is_angle { 360.0 } else { size };
            if !pull.moves(id) {
                let stays = pull.to_place(id, start + Vector::new(size, 0.0));
                assert_eq!(stays.pose.points, pull.to_value(pull.value()).pose.points, "{name}");
                continue;
            }
            for _ in 0..PULLS.now() {
                let off = Vector::new(random.between(-0.4, 0.4), random.between(-0.4, 0.4)) * size;
                let place = start + off;
                let before = pull.value();
                let pulled = pull.to_place(id, place);
                assert!((pulled.value - before).abs() <= 10.1 * unit, "{name}: {before} to {}", pulled.value);
                if let Some(limit) = pulled.limit {
                    assert!((limit.at - pulled.value).abs() < 3e-4 * unit, "{name}: {limit:?} at {}", pulled.value);
                    stopped += 1;
                    continue;
                }
                let distance = |pulled: &Pulled| (pulled.pose.point(id) - place).norm();
                let here = distance(&pulled);
                for by in [-1e-5, 1e-5] {
                    let beside = pull.clone().to_value(pulled.value + by * unit);
                    // Next to a change point there are no positions.
                    if (beside.value - pulled.value).abs() > 1.1e-5 * unit {
                        continue;
                    }
                    let further = distance(&beside);
                    assert!(
                        further >= here - 1e-8 * size,
                        "{name}, point {index}: {further} < {here} at {}",
                        pulled.value
                    );
                }
                met += 1;
            }
        }
    }
    assert!(met > 80 * PULLS.now() && stopped > 2 * PULLS.now(), "{met} met, {stopped} stopped");
}

#[test]
fn a_limit_stops_the_crank_and_lets_it_back() {
    let solution = scene("examples/figure-2.json");
    let (pivot, pin) = (solution.pose.point(point(&solution, "A")), point(&solution, "B"));
    let at =
        |degrees: f64| pivot + Vector::new(libm::cos(degrees.to_radians()), libm::sin(degrees.to_radians())) * 100.0;
    let mut pull = Pull::new(&solution, None).expect("it can be moved");
    assert!(pull.to_place(pin, at(120.0)).limit.is_none());
    let pulled = pull.to_place(pin, at(160.0));
    let limit = pulled.limit.expect("it is stopped");
    assert!(matches!(limit.what, Happening::Limit(_)));
    assert!((limit.at - 137.58).abs() < 0.01 && limit.at - pulled.value < 0.04, "{limit:?} at {}", pulled.value);
    assert!(solution.moved(pulled.pose).is_ok());
    let again = pull.to_place(pin, at(170.0));
    assert_eq!((again.value, again.limit.map(|limit| limit.at)), (pulled.value, Some(limit.at)));
    let back = pull.to_place(pin, at(70.0));
    assert!((back.value - 70.0).abs() < 1e-9 && back.limit.is_none());
    let set = pull.to_value(500.0);
    assert_eq!((set.value, set.limit.map(|limit| limit.at)), (pulled.value, Some(limit.at)));
    assert!(pull.to_value(f64::NAN).value == pulled.value);
    let [below, above] = pull.ends();
    assert_eq!(above.map(|end| end.at), Some(limit.at));
    assert!(below.is_some_and(|end| end.at < 70.0));
}

#[test]
fn after_a_turn_all_is_as_it_was() {
    for name in ["templates/four-bar", "tests/lecture/jansen", "templates/slider-crank", "tests/lecture/geneva"] {
        let solution = scene(&format!("{name}.json"));
        let mut pull = Pull::new(&solution, None).expect("it can be moved");
        let start = pull.to_value(pull.value());
        let mut there = start.clone();
        // Ten turns, forwards and back: what has been left behind is followed anew.
        for step in (1..=200).chain((0..200).rev()) {
            there = pull.to_value(start.value + 18.0 * f64::from(step));
            if step % 20 == 0 {
                assert!(
                    apart(&start, &there) < 1e-9 * size(&solution),
                    "{name}: {} at step {step}",
                    apart(&start, &there)
                );
            }
        }
        assert_eq!(there.value, start.value);
    }
}

#[test]
fn a_piston_turns_its_crank() {
    let solution = scene("templates/slider-crank.json");
    let pin = point(&solution, "C");
    let mut pull = Pull::of_point(&solution, pin).expect("it can be moved");
    let mut last = pull.value();
    let start = last;
    // To and fro past both dead centres, as a hand does.
    for step in 1..=4000 {
        let at = solution.pose.point(pin);
        let sway = libm::sin(0.01 * f64::from(step));
        let pulled = pull.to_place(pin, Point::new(1.5 * size(&solution) * sway, at.y));
        assert!(
            pulled.value * pull.value().signum() >= last * pull.value().signum() - 1e-6,
            "{} after {last}",
            pulled.value
        );
        last = pulled.value;
    }
    assert!((last - start).abs() > 360.0 * 5.0, "from {start} to {last}");
}

#[test]
fn one_drive_moves_and_the_others_stand_still() {
    let solution = scene("templates/five-bar.json");
    let names = solution.mechanism.drive_names();
    let angle = |pulled: &Pulled, name: &str| {
        let link = solution.mechanism.link(name).expect("it is a link");
        degrees_of(pulled.pose.axes[link.0].expect("it has an axis"))
    };
    for (index, name) in names.iter().enumerate() {
        let mut pull = Pull::new(&solution, Some(name)).expect("it can be moved");
        let start = pull.to_value(pull.value());
        let pulled = pull.to_value(start.value + 5.0);
        for (other, own) in names.iter().enumerate() {
            let moved = angle(&pulled, own) - angle(&start, own);
            let wanted = if other == index { 5.0 } else { 0.0 };
            assert!((moved - wanted).abs() < 1e-9, "{own} by {moved} while {name} moves");
        }
        // The pin of each crank is moved by its own drive.
        let link = solution.mechanism.link(name).expect("it is a link");
        for &pin in &solution.mechanism.body(link).points {
            let pull = Pull::of_point(&solution, pin).expect("it can be moved");
            let is_fixed = solution.mechanism.body(kinegon::mechanism::GROUND).has(pin);
            assert_eq!(&pull.drive().name, if is_fixed { &names[0] } else { name });
        }
    }
}

/// As time moves them: the angles of both cranks go on in proportion to their speeds, 4 and −3 rad/s, and the loop stays closed.
#[test]
fn drives_run_together_as_their_speeds_say() {
    let solution = scene("templates/five-bar.json");
    let mut pull = Pull::together(&solution, None).expect("it can be moved");
    let other = Drive::new(&solution.mechanism, Some("4")).expect("a second drive");
    let [b, c, d, e] = ["B", "C", "D", "E"].map(|name| point(&solution, name));
    for degrees in [120.0, 121.0, 160.0, 400.0, 30.0] {
        let pulled = pull.to_value(degrees);
        let second = 50.0 - 0.75 * (degrees - 120.0);
        assert!((pull.value_of(&other) - second).abs() < 1e-9, "{} at {degrees}", pull.value_of(&other));
        let place = |id| pulled.pose.point(id);
        let arm = place(d) - place(e);
        let off = libm::remainder(degrees_of(arm / arm.norm()) - second, 360.0);
        assert!(off.abs() < 1e-9, "{off} at {degrees}");
        for (from, to, length) in [(b, c, 130.0), (d, c, 120.0), (e, d, 40.0)] {
            assert!(((place(from) - place(to)).norm() - length).abs() < 1e-9, "at {degrees}");
        }
    }
    // The other drive stands where one is pulled alone.
    let mut alone = Pull::new(&solution, None).expect("it can be moved");
    alone.to_value(160.0);
    assert_eq!(alone.value_of(&other), 50.0);
}

#[test]
fn the_first_drive_with_a_speed_leads() {
    let leading = |text: &str| {
        let solution = solved(text).expect("it can be solved");
        Drive::leading(&solution.mechanism).expect("it has lengths").map(|drive| drive.name)
    };
    let text = files::read("templates/five-bar.json");
    let first_rests = text.replace("\"omega\": 4", "\"omega\": 0");
    let both_rest = first_rests.replace("\"omega\": -3", "\"omega\": 0");
    assert_eq!(
        [leading(&text), leading(&first_rests), leading(&both_rest)],
        [Some("1".into()), Some("4".into()), None]
    );
}
