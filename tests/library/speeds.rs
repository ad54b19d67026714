//! Relative angular rates, ratios of speeds and revolutions a minute: against Willis' formula in whole numbers, against distances of
//! instant centres, in tables, and as a hand finds them.

use crate::gears::{number, solution};
use kinegon::construction::Tolerance;
use kinegon::cycle::{Drive, Path, Steps, Sweep};
use kinegon::geometry::Point;
use kinegon::quantity::{Quantity, QuantityRequest, pencil, turning_names};
use serde_json::{Value, json};
use support::files;
use support::random::Random;
use support::stages::solved;

/// Random trains.
const COUNT: u64 = 300;

/// An arm that carries a planet between a sun and a fixed ring, driven at so many revolutions a minute.
fn planetary(teeth: [i64; 2], rpm: i64, time: &str) -> Value {
    let [sun, planet] = teeth;
    json!({ "kinegon": 1, "units": { "length": "mm", "time": time }, "ground": { "A": [0, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 40, "rpm": rpm } },
                   "2": { "points": ["B", "Q"], "lengths": { "BQ": 20 } },
                   "3": { "points": ["A", "E"], "lengths": { "AE": 40 } } },
        "gears": [ { "mesh": ["2", "ground"], "teeth": [planet, -(sun + 2 * planet)], "on": "1" },
                   { "mesh": ["3", "2"], "teeth": [sun, planet], "on": "1" } ] })
}

/// A crank that drives a rocker.
fn four_bar(drive: &Value) -> Value {
    json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [100, 0] },
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 40 }, "drive": drive },
                   "2": { "points": ["B", "C"], "lengths": { "BC": 90 } },
                   "3": { "points": ["C", "D"], "lengths": { "CD": 70 } } },
        "near": { "C": [110, 65] } })
}

/// Value and stated bound of a wanted quantity, from the result.
fn wanted(result: &Value, name: &str) -> (f64, f64) {
    let read = |key: &str| result[key][name].as_f64().unwrap_or_else(|| panic!("{name} is not among {key}"));
    (read("quantities"), read("quantity_errors"))
}

fn result_of(mut scene: Value, want: &[&str]) -> Value {
    scene["want"] = json!(want);
    serde_json::to_value(solution(&scene).whole_result().expect("it has values")).expect("a result is JSON")
}

/// With a fixed ring: ω₃/ω₁ = 1 + z_r/z_s, ω₂/ω₁ = 1 − z_r/z_p, as quotients of whole numbers; and revolutions a minute of the drive are as given,
/// in both units of time.
#[test]
fn speeds_of_trains_are_those_of_willis() {
    for seed in 0..COUNT {
        let dice = &mut Random(seed);
        let teeth = [17 + dice.below(84) as i64, 17 + dice.below(84) as i64];
        let rpm = 1 + dice.below(3000) as i64;
        let rpm = if dice.below(2) == 0 { rpm } else { -rpm };
        let [sun, planet] = teeth;
        let ring = sun + 2 * planet;
        let time = ["s", "min"][dice.below(2)];
        let names = ["i(3,1)", "i(1,3)", "i(2,3)", "i(2,1)", "rpm(1)", "rpm(2)", "rpm(3)"];
        let result = result_of(planetary(teeth, rpm, time), &names);
        for (name, above, below) in [
            ("i(3,1)", sun + ring, sun),
            ("i(1,3)", sun, sun + ring),
            ("i(2,3)", (planet - ring) * sun, planet * (sun + ring)),
            ("i(2,1)", planet - ring, planet),
            ("rpm(1)", rpm, 1),
            ("rpm(2)", rpm * (planet - ring), planet),
            ("rpm(3)", rpm * (sun + ring), sun),
        ] {
            let (value, error) = wanted(&result, name);
            let truth = above as f64 / below as f64;
            // The quotient itself is rounded.
            let allowed = error + 0.5 * f64::EPSILON * truth.abs();
            assert!(
                (value - truth).abs() <= allowed,
                "{name} = {value} ± {error}, truth {truth}: {teeth:?}, {rpm} in {time}"
            );
            assert!(error <= 1e-14 * truth.abs(), "{name} = {value} ± {error} is not sharp");
        }
    }
}

/// Seen from the arm the wheels turn as in a train at rest: (ω₃ − ω₁)/(ω₂ − ω₁) = −z₂/z₃, and so do their accelerations.
#[test]
fn relative_rates_are_those_seen_from_the_arm() {
    let mut scene = planetary([40, 20], 30, "min");
    scene["links"]["1"]["drive"] = json!({ "angle": 40, "omega": 4, "alpha": 6 });
    for (head, of_arm) in [("omega", 4.0), ("alpha", 6.0)] {
        let names =
            [format!("{head}(2/1)"), format!("{head}(3/1)"), format!("{head}(1/2)"), format!("{head}(2/ground)")];
        let result = result_of(scene.clone(), &names.each_ref().map(String::as_str));
        // z_p (ω_p − ω_a) = z_r (0 − ω_a): −4 of the arm's.
        for (name, truth) in names.iter().zip([-4.0 * of_arm, 2.0 * of_arm, 4.0 * of_arm, -3.0 * of_arm]) {
            let (value, error) = wanted(&result, name);
            assert!((value - truth).abs() <= error && error <= 1e-13, "{name} = {value} ± {error}, truth {truth}");
        }
    }
}

/// Kennedy and Aronhold: ω₃/ω₁ is the quotient of the distances of P₁₃ from P₁₀ and P₃₀, in the sense of these on their line.
#[test]
fn a_ratio_is_that_of_distances_of_centres() {
    let mut compared = 0;
    for degrees in (5..360).step_by(7) {
        let solved = solution(&four_bar(&json!({ "angle": degrees, "omega": -3, "alpha": 2 })));
        // From lengths alone: the joints' places.
        let place =
            |name: &str| Point::new(number(&solved, &format!("x({name})")), number(&solved, &format!("y({name})")));
        let [b, c] = [place("B"), place("C")];
        // The coupler's line crosses that of the frame, on which A and D are.
        let along = c - b;
        let at = b.x - along.x * b.y / along.y;
        let truth = at / (at - 100.0);
        if along.y.abs() < 5.0 || truth.abs() > 100.0 {
            continue;
        }
        let ratio = number(&solved, "i(3,1)");
        assert!((ratio - truth).abs() <= 1e-11 * truth.abs().max(1.0), "at {degrees}°: {ratio}, by centres {truth}");
        compared += 1;
    }
    assert!(compared > 40, "{compared}");
}

/// A ratio to a link at rest has no value, and the message says which link rests; where the link rests within its bound alone, no bound is stated.
#[test]
fn there_is_no_ratio_to_a_link_at_rest() {
    let solved = solution(&planetary([40, 20], 30, "s"));
    let error = solved.quantity("i(3,ground)").expect_err("the frame rests").problem().message.to_string();
    assert!(error.contains("`ground` does not turn"), "{error}");
    assert!(matches!(solved.quantity("i(ground,3)"), Ok(Quantity::Number(0.0))));
    for name in ["i(3)", "i(3/1)", "rpm(3/1)", "omega(3,1)", "rpm(2).size"] {
        assert!(solved.quantity(name).is_err(), "{name}");
    }
    // 30 · 0.3 − 90 · 0.1 = 120 ω₁: the arm is at rest, though in f64 neither 0.3 nor 0.1 is what the scene says.
    let scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0] }, "want": ["i(3,1)"],
        "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 } },
                   "2": { "points": ["B", "Q"], "lengths": { "BQ": 30 } },
                   "3": { "points": ["A", "E"], "lengths": { "AE": 30 }, "drive": { "angle": 10, "omega": 0.3 } },
                   "4": { "points": ["A", "F"], "lengths": { "AF": 90 }, "drive": { "angle": 50, "omega": -0.1 } } },
        "gears": [ { "mesh": ["3", "2"], "teeth": [30, 30], "on": "1" }, { "mesh": ["2", "4"], "teeth": [30, -90], "on": "1" } ] });
    match solution(&scene).whole_result() {
        Ok(result) => {
            let result = serde_json::to_value(result).expect("a result is JSON");
            assert!(result["quantity_errors"]["i(3,1)"].is_null(), "{}", result["quantity_errors"]);
        }
        Err(error) => assert!(error.to_string().contains("`1` does not turn"), "{error}"),
    }
}

/// Tables have them as they follow from the columns of single rates, and blanks where a ratio has no value.
#[test]
fn tables_have_relative_rates_and_ratios() {
    let scene = four_bar(&json!({ "angle": 40, "omega": -3, "alpha": 2 }));
    let solved = solution(&scene);
    let mut path = Path::new(&solved.mechanism, &solved.pose, Drive::new(&solved.mechanism, None).expect("a crank"))
        .expect("it moves");
    path.cover(Some(0.0), Some(360.0)).expect("it goes round");
    let names = [
        "omega(1)",
        "omega(2)",
        "omega(3)",
        "alpha(2)",
        "alpha(3)",
        "omega(2/3)",
        "alpha(2/3)",
        "i(3,1)",
        "rpm(2)",
        "i(1,ground)",
    ];
    let names = names.map(str::to_owned);
    let steps = Steps::new(0.0, 360.0, 15.0).expect("a range");
    let table = Sweep::new(&path, steps, Some(&names)).expect("known quantities");
    let mut rows = 0;
    let columns = table.header().len();
    let all = table.rows(0..table.steps.count());
    for row in all.chunks(columns) {
        let numbers: Vec<f64> = row[1..10].iter().map(|number| number.expect("it has a value")).collect();
        let [one, two, three, second, third, relative, of_second, ratio, rpm] = numbers[..] else {
            panic!("{numbers:?}")
        };
        assert_eq!([relative, of_second, ratio], [two - three, second - third, three / one]);
        assert!((rpm - two * 30.0 / core::f64::consts::PI).abs() <= 1e-14 * rpm.abs());
        assert!(row[10].is_none(), "the frame is at rest");
        rows += 1;
    }
    assert_eq!(rows, 25);
}

/// A hand computes them from the rates that it has found, and its band is as wide as that of these.
#[test]
fn a_hand_computes_them_from_its_rates() {
    let scene = four_bar(&json!({ "angle": 65, "omega": -3, "alpha": 2 }));
    let solved = solved(&scene.to_string()).expect("it is solved");
    let names = ["omega(2)", "omega(3)", "omega(2/1)", "omega(2/3)", "alpha(3/1)", "i(3,1)", "rpm(3)", "rpm(1)"];
    let asked = names.map(|name| QuantityRequest::new(name, &solved.mechanism).expect(name)).to_vec();
    let pencil = pencil(&solved, &solved.scales(), Tolerance::default(), asked);
    let band = |name: &str| pencil.band(name).unwrap_or_else(|| panic!("{name} is not read"));
    for name in &names[..7] {
        let (own, truth) = (band(name), number(&solved, name));
        assert!((own.value - truth).abs() <= 1e-9 * truth.abs(), "{name}: {own:?}, {truth}");
        assert!(own.band > 0.0, "{name}: {own:?}");
    }
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
    // The drive's rate is given, so that only that of the other link scatters.
    assert!(close(band("omega(2/1)").band, band("omega(2)").band));
    assert!(close(band("i(3,1)").band, band("omega(3)").band / 3.0));
    assert!(close(band("rpm(3)").band, band("omega(3)").band * 30.0 / core::f64::consts::PI));
    assert!(pencil.band("rpm(1)").is_none(), "the scene gives it");
}

/// Where several links turn, these quantities are offered, each of which has a value; where one alone does, none are.
#[test]
fn what_turns_is_offered() {
    let offered = |text: &str| {
        let solution = solution(&serde_json::from_str(text).expect("JSON"));
        let names = turning_names(&solution.mechanism);
        for name in &names {
            QuantityRequest::new(name, &solution.mechanism).expect(name);
        }
        names
    };
    let train = offered(&files::read("templates/planetary.json"));
    let mut wanted =
        ["i(2,1)", "i(3,1)", "omega(2/1)", "alpha(2/1)", "omega(3/1)", "alpha(3/1)", "rpm(1)", "rpm(2)", "rpm(3)"];
    wanted.sort_unstable();
    let mut found = train.clone();
    found.sort_unstable();
    assert_eq!(found, wanted);
    assert_eq!(offered(&files::read("templates/four-bar.json")), ["i(3,1)"], "crank and rocker turn in the frame");
    assert_eq!(offered(&files::read("templates/slider-crank.json")), [""; 0]);
    // Wheels on the frame have no arm against which they turn.
    let plain = offered(&files::read("templates/gear-train.json"));
    assert!(plain.iter().all(|name| name.starts_with("i(") || name.starts_with("rpm(")), "{plain:?}");
}
