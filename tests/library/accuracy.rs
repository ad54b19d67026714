//! What the library claims of its accuracy, on families of hard fourth-class groups (`tests/support/speed_vs_error/families.rs`).

use kinegon::Solution;
use kinegon::mechanism::mechanism;
use kinegon::position::pose;
use kinegon::scene::{Along, Scene};
use serde_json::Value;
use support::exact::minus;
use support::files::{self, scene_text};
use support::random::Random;
use support::speed_vs_error::families::Family;
use support::speed_vs_error::lengths::Lengths;
use support::speed_vs_error::methods::{Method, Prepared};
use support::speed_vs_error::survey::{Survey, median};
use support::speed_vs_error::truth::{Precise, Truth, rounded};
use support::speed_vs_error::{assembled, document, joints};
use support::stages::solved;
use support::survey::HARD_GROUPS;

/// Half the distance from 1 to the next f64.
const U: f64 = f64::EPSILON / 2.0;

/// Largest error of velocities and of accelerations, in units u·condition.
const CLAIM: f64 = 1.0;

/// Largest error of a link's angular velocity or acceleration, in units u·|its true value|, whatever the condition; 1 is the nearest f64.
const ROUNDINGS: f64 = 4.0;

/// Groups for each family and parameter.
fn groups() -> usize {
    HARD_GROUPS.now()
}

/// Which error of the paper's procedure, in units u·condition, is more than six digits lost.
const SIX_DIGITS: f64 = 1e6;

/// By how much the library must be better there.
const FOUR_DIGITS: f64 = 1e4;

/// Errors of a group in units u·condition.
struct Errors {
    naive: f64,
    /// Of velocities and accelerations.
    library: [f64; 2],
    /// The largest of its angular rates, by [`Case::roundings`](measure::Case::roundings).
    roundings: f64,
}

/// A family's errors by its parameter; without the groups that the library refuses.
fn errors(family: Family) -> Vec<(f64, Vec<Errors>)> {
    let parameters = family.parameters().into_iter();
    let errors = parameters.map(|parameter| {
        // Not the seeds of the survey.
        let mut dice = Random(1000 + family as u64);
        let groups = (0..groups()).map(|_| family.group(parameter, &mut dice));
        let prepared = groups.filter_map(|group| Prepared::new(&group));
        let errors = prepared.filter_map(|one| {
            let rates = one.rates(Method::Library);
            Some(Errors {
                naive: one.case.worst_units(&one.rates(Method::Naive))?,
                library: one.case.units(&rates)?,
                roundings: one.case.roundings(&rates),
            })
        });
        (parameter, errors.collect())
    });
    errors.collect()
}

#[test]
fn errors_stay_below_the_claims_and_far_below_those_of_the_naive_procedure() {
    let (mut hopeless, mut saved) = (0, 0);
    let mut failures = Vec::new();
    for family in Family::ALL {
        let mut sorted = [Vec::new(), Vec::new()];
        let mut last_digit: f64 = 0.0;
        for Errors { naive, library, roundings } in errors(family).into_iter().flat_map(|(_, errors)| errors) {
            last_digit = last_digit.max(roundings);
            let worst = library[0].max(library[1]);
            sorted[0].push(library[0]);
            sorted[1].push(library[1]);
            if naive.is_nan() || naive > SIX_DIGITS {
                hopeless += 1;
                saved += usize::from(worst * FOUR_DIGITS < naive);
            }
        }
        let count = sorted[0].len();
        let [velocity, acceleration] = sorted.map(|mut errors| {
            errors.sort_by(f64::total_cmp);
            [0.5, 0.99, 0.999, 1.0].map(|share| errors[(share * (count - 1) as f64) as usize])
        });
        println!(
            "{}: {count} groups; median, 99 %, 99.9 %, largest error of velocities {velocity:.2?} u·condition, of accelerations {acceleration:.2?}; of ω and α {last_digit:.4} u",
            family.name(),
        );
        // Written so that no NaN passes.
        let kept = velocity[3] <= CLAIM && acceleration[3] <= CLAIM && last_digit <= ROUNDINGS;
        if !kept {
            failures.push(family.name());
        }
    }
    println!(
        "the naive procedure loses more than six digits in {hopeless} groups, the library is four digits better in {saved}"
    );
    assert!(failures.is_empty(), "above the claims: {failures:?}");
    assert_eq!(hopeless, saved);
    assert!(hopeless > 30 * groups(), "the families have become too easy");
}

#[test]
fn parallel_cut_lines_are_as_good_as_crossing_ones() {
    for family in [Family::Parallel, Family::BothParallel] {
        // The same groups, but for the angle of their cut lines.
        let [crossing, parallel] = [1e-3..1.0, 0.0..1e-12].map(|parameters| {
            let rows = errors(family).into_iter();
            let rows = rows.filter(|(parameter, _)| parameters.contains(parameter));
            let errors = rows.flat_map(|(_, errors)| errors);
            median(errors.map(|e| e.library[1])).expect("some groups")
        });
        println!(
            "{}: median error of accelerations {parallel:.2} u·condition; while the lines cross {crossing:.2}",
            family.name()
        );
        assert!(parallel < 1.25 * crossing, "{family:?}");
    }
}

/// By how much a number of 256 bits differs from a decimal one.
fn differs(number: &Precise, decimal: &str) -> f64 {
    let high = rounded(number);
    let low = rounded(&(number.clone() - <Precise as joints::Real>::exactly(high)));
    minus(high, decimal) + low
}

/// The reference itself against the 90-digit truth of tests/reference, of which 20 digits stand there.
#[test]
fn the_reference_has_all_published_digits() {
    let mut compared = 0;
    for set in ["class4", "class4_prismatic", "dyads", "triads", "hard", "hard_dyads_triads"] {
        for line in files::read(&format!("tests/reference/{set}.jsonl")).lines() {
            let case: Value = serde_json::from_str(line).expect("a line is JSON");
            let (name, expect) = (&case["name"], &case["expect"]);
            let scene = Scene::read(scene_text(line)).expect("a good scene");
            let mechanism = mechanism(&scene).expect("a mechanism");
            let pose = pose(&mechanism, &scene.near).expect("it is drawn");
            let points: Vec<[f64; 2]> = pose.points.iter().map(|p| [p.x, p.y]).collect();
            let guides = scene.sliders.iter().map(|slider| match slider.along {
                Along::Direction(direction) => direction,
                ref other => panic!("{name}: {other:?}"),
            });
            let given: Vec<[f64; 2]> = guides.collect();
            let guides = mechanism.sliders.iter().map(|slider| given[slider.given.expect("a slider of the scene")]);
            let guides: Vec<[f64; 2]> = guides.collect();
            let truth = Truth::new(&mechanism, &points, &guides);
            if expect["singular"] == true {
                continue;
            }
            let truth = truth.expect("it is not singular");
            for (link, numbers) in expect["links"].as_object().into_iter().flatten() {
                let body = &truth.bodies[mechanism.link(link).expect("a link").0];
                for (key, number) in [("omega", &body.omega), ("alpha", &body.alpha)] {
                    let decimal = numbers[key].as_str().expect("a decimal string");
                    let difference = differs(number, decimal).abs();
                    // 20 digits are written, and zeros of the truth are its rounding.
                    let allowed = 1e-19 * rounded(number).abs() + 1e-60;
                    assert!(difference <= allowed, "{name}: {key}({link}) {difference:e}");
                    compared += 1;
                }
            }
        }
    }
    println!("{compared} numbers of the reference have all published digits");
    assert!(compared > 2500);
}

/// The reference of positions from lengths, where the motion is known: in a parallelogram the rocker turns as the crank does; a rod as
/// long as the crank, on a guide through the crank's pivot, turns the other way.
#[test]
fn the_reference_from_lengths_is_right() {
    let parallelogram = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [120, 90] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 77.7, "omega": 3, "alpha": -2 } },
                   "2": { "points": ["B", "C"], "lengths": { "BC": 150 } },
                   "3": { "points": ["D", "C"], "lengths": { "CD": 60 } } },
        "near": { "C": [133, 149] } }"#;
    let rod = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": 77.7, "omega": 3, "alpha": -2 } },
                   "3": { "points": ["B", "C"], "lengths": { "BC": 50 } }, "4": { "points": ["C"] } },
        "sliders": [{ "link": "4", "at": "C", "on": "ground", "through": "A", "along": 0 }],
        "near": { "C": [21, 0] } }"#;
    for (text, sign) in [(parallelogram, 1.0), (rod, -1.0)] {
        let Solution { mechanism, pose, .. } = solved(text).expect("it can be solved");
        let truth = assembled::truth(&mechanism, &pose, |_| 77.7).expect("it closes");
        let body = &truth.bodies[mechanism.link("3").expect("a link").0];
        for (rate, expected) in [(&body.omega, 3.0 * sign), (&body.alpha, -2.0 * sign)] {
            let off = rounded(&(rate.clone() - <Precise as joints::Real>::exactly(expected)));
            assert!(off.abs() < 1e-45, "{text}: {off:e}");
        }
    }
}

/// What the page says of positions from lengths, on fewer of them.
#[test]
fn from_lengths_errors_stay_below_the_square_of_the_condition() {
    let lengths = Lengths::with([4, 1], 6);
    let mut count = 0;
    for reading in lengths.readings() {
        let allowed = 100.0 * U * reading.condition * reading.condition;
        assert!(reading.errors[..2].iter().all(|error| *error <= allowed), "{reading:?} {allowed:e}");
        count += 1;
    }
    assert_eq!(count, 13 + 9 * 6 + 7 + 7);
    // Next to a change point a table keeps digits that equations in f64 lose.
    let (_, nearest) = lengths.approaches[1].rows.last().expect("rows");
    assert!(nearest.errors[1] * 100.0 < nearest.errors[2], "{nearest:?}");
    for class in &lengths.classes {
        let kept = class.given.iter().all(|(condition, [ours, _])| *ours <= U * condition);
        assert!(kept, "{}: {:?}", class.name, class.given);
    }
}

#[test]
fn the_page_is_current() {
    let page = files::read("docs/accuracy.md").replace("\r\n", "\n");
    let now = document::accuracy(&Survey::new());
    assert!(page.starts_with(&now), "run cargo run --release --example speed_vs_error");
}
