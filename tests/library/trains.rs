//! Trains of wheels by hand: rates by pitch points against Willis' formula, images of pitch points, what steps and exercises say.

use crate::gears::{number, solution};
use kinegon::construction::{Action, RateEquation};
use kinegon::exercise::Exercises;
use kinegon::geometry::Vector;
use kinegon::scene::Kind;
use kinegon::{Order, Sheet};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use support::random::Random;
use support::stages::solved;

/// Trains of each kind.
const COUNT: u64 = 100;

fn teeth(dice: &mut Random) -> i32 {
    17 + dice.below(44) as i32
}

/// Sun, planet and ring on an arm, in all ways in which two of the three others are given, one of them perhaps at rest.
fn planetary(dice: &mut Random) -> (Value, [f64; 3], [f64; 4]) {
    let (sun, planet) = (teeth(dice), teeth(dice));
    let ring = sun + 2 * planet;
    let (free, resting) = (dice.below(3), dice.below(4));
    let names = ["arm", "sun", "ring"];
    let mut given = [0.0; 3];
    let mut links = json!({ "planet": { "points": ["B", "Q"], "lengths": { "BQ": 7 } } });
    let mut body: BTreeMap<&str, &str> = names.into_iter().map(|name| (name, name)).collect();
    for (index, (name, point)) in [("arm", "B"), ("sun", "S"), ("ring", "R")].into_iter().enumerate() {
        if index == resting && index != 0 && index != free {
            body.insert(name, "ground");
            continue;
        }
        links[name] = json!({ "points": ["A", point], "lengths": { format!("A{point}"): 60 } });
        if index != free {
            given[index] = dice.coarse();
            links[name]["drive"] = json!({ "angle": 15 * dice.below(24), "omega": given[index], "alpha": 0 });
        }
    }
    let [s, p, r] = [sun, planet, ring].map(f64::from);
    let solved = match free {
        0 => [(s * given[1] + r * given[2]) / (s + r), given[1], given[2]],
        1 => [given[0], ((s + r) * given[0] - r * given[2]) / s, given[2]],
        _ => [given[0], given[1], ((s + r) * given[0] - s * given[1]) / r],
    };
    let own = solved[0] - (solved[1] - solved[0]) * s / p;
    let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [3, 4] }, "links": links,
        "gears": [ { "mesh": [body["sun"], "planet"], "teeth": [sun, planet], "on": "arm" },
                   { "mesh": ["planet", body["ring"]], "teeth": [planet, -ring], "on": "arm" } ] });
    (scene, solved, [solved[0], solved[1], solved[2], own])
}

/// The plan's rates are those of Willis' formula, and both routes agree within what rounding allows.
#[test]
fn planetary_trains_are_constructed_by_pitch_points() {
    let mut by_pitch = 0;
    for seed in 0..COUNT {
        let (scene, _, truth) = planetary(&mut Random(seed));
        let s = solution(&scene);
        for (agreement, group) in s.construction.agreement.iter().zip(&s.mechanism.groups) {
            let names = group.link_names(&s.mechanism);
            let agreement = agreement.unwrap_or_else(|| panic!("{names} has no construction\n{scene}"));
            assert!(agreement.difference <= agreement.allowed, "{names}: {agreement:?}\n{scene}");
        }
        for (link, truth) in ["arm", "sun", "ring", "planet"].into_iter().zip(truth) {
            if s.mechanism.link(link).is_some() {
                let found = number(&s, &format!("omega({link})"));
                assert!((found - truth).abs() <= 1e-12 * truth.abs().max(10.0), "{link}: {found}, {truth}\n{scene}");
            }
        }
        for action in &s.construction.steps[Sheet::Velocity] {
            if let Action::Solve { equations, unknowns } = action
                && matches!(equations[0], RateEquation::Wheel(_))
            {
                by_pitch += unknowns.len();
            }
        }
    }
    assert!(by_pitch > COUNT as usize, "{by_pitch}");
}

/// The image of a pitch point is the velocity of both wheels there, worked out here from the motion of each.
#[test]
fn the_image_of_a_pitch_point_belongs_to_both_wheels() {
    for name in ["gear-train", "planetary", "differential", "reverted-train", "geared-five-bar"] {
        let s = solved(&Kind::named(name).expect("a kind").text).expect("it is solved");
        let plan = s.construction.plan(Order::Velocity).expect("a plan");
        let mut seen = 0;
        for joint in &s.mechanism.joints {
            let Some(pitch) = joint.pitch else { continue };
            let [a, b] = pitch.centers.map(|center| s.pose.point(center));
            let [z, w] = pitch.all_teeth.map(f64::from);
            let at = a + (b - a) * (z / (z + w));
            let both = joint.bodies.map(|body| s.motion.body(body).velocity_at(at));
            assert!((both[0] - both[1]).norm() < 1e-9 * both[0].norm().max(1.0), "{name}");
            let is_it = |(point, vector): &(&String, Vector)| {
                point.starts_with('p') && point.len() > 1 && (vector - both[0]).norm() < 1e-9 * both[0].norm().max(1.0)
            };
            let mut points = plan.points.iter().map(|(point, shown)| (point, shown.vector));
            assert!(points.any(|point| is_it(&point)), "{name}: no image of a pitch point has {}", both[0]);
            seen += 1;
        }
        assert!(seen > 0, "{name}");
    }
}

/// Steps say the equations of the teeth with their numbers.
#[test]
fn steps_say_the_equations_of_the_teeth() {
    let s = solved(&Kind::named("planetary").expect("a kind").text).expect("it is solved");
    let words = s.wording();
    let teller = kinegon::construction::Teller::new(&s, &words);
    let equations = |sheet: Sheet| -> Vec<String> {
        let solves = s.construction.steps[sheet].iter().filter_map(|action| match action {
            Action::Solve { equations, .. } => Some(equations),
            _ => None,
        });
        solves.flatten().map(|equation| teller.equation(equation)).collect()
    };
    let velocity = equations(Sheet::Velocity);
    assert!(velocity.contains(&"20 ω_{2} = −60 ω_{1}".to_owned()), "{velocity:?}");
    assert!(velocity.contains(&"40 ω_{3} + 20 ω_{2} = 60 ω_{1}".to_owned()), "{velocity:?}");
    let acceleration = equations(Sheet::Acceleration);
    assert_eq!(acceleration, ["20 α_{2} = −60 α_{1}", "40 α_{3} + 20 α_{2} = 60 α_{1}"]);
}

/// Exercises have whole teeth that fit, with distances that belong to them.
#[test]
fn exercises_with_wheels_have_teeth_that_fit() {
    let mut ratios = std::collections::BTreeSet::new();
    for name in ["gear-train", "planetary", "differential", "reverted-train", "geared-five-bar"] {
        let s = solved(&Kind::named(name).expect("a kind").text).expect("it is solved");
        let mut exercises = Exercises::new(&s, None, 5).expect("it has a construction");
        for _ in 0..3 {
            let exercise = exercises.next().unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(
                exercise.solution.mechanism.warnings.is_empty(),
                "{name}: {:?}",
                exercise.solution.mechanism.warnings
            );
            let scene: Value = serde_json::from_str(&exercise.text).expect("a scene is JSON");
            let teeth: Vec<[i64; 2]> = scene["gears"]
                .as_array()
                .expect("gears")
                .iter()
                .map(|gear| [0, 1].map(|side| gear["teeth"][side].as_i64().expect("whole teeth")))
                .collect();
            assert!(teeth.iter().flatten().all(|z| (17..=100).contains(&z.abs())), "{name}: {teeth:?}");
            if matches!(name, "planetary" | "differential") {
                let all: Vec<i64> = teeth.iter().flatten().copied().collect();
                let ring = all.iter().copied().find(|z| *z < 0).expect("a ring").abs();
                let sun = if name == "planetary" { teeth[1][0] } else { teeth[0][0] };
                let planet = if name == "planetary" { teeth[1][1] } else { teeth[0][1] };
                assert_eq!(ring, sun + 2 * planet, "{name}: {teeth:?}");
                assert_eq!((sun + ring) % 3, 0, "{name}: {teeth:?}");
            }
            ratios.insert(format!("{teeth:?}"));
        }
    }
    assert!(ratios.len() >= 12, "{ratios:?}");
}
