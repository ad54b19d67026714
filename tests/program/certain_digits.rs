//! `kinegon solve --digits`: what is printed is true to one unit of its last digit, and hardly a certain digit is missing.

use serde_json::Value;
use std::collections::BTreeMap;
use support::exact::{exactly_written, minus};
use support::files;
use support::program::{stderr, with_scene};

/// A unit of the last digit must not be this many times the error in the middle of all numbers: certain digits would be missing.
const WASTEFUL: f64 = 1000.0;

/// Name, value, unit and bound of each line of the table.
fn table(scene: &str) -> Option<BTreeMap<String, [String; 3]>> {
    let output = with_scene(&["solve", "--digits", "-"], scene.as_bytes());
    // Singular positions are refused.
    if output.status.code() == Some(1) {
        return None;
    }
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let lines = text.lines().map(|line| {
        let (row, bound) = line.split_once('±').expect("a bound");
        let mut words = row.split_whitespace();
        let mut next = || words.next().expect("a word").to_owned();
        let bound = bound.split(',').next().expect("a number").trim().to_owned();
        (next(), [next(), next(), bound])
    });
    Some(lines.collect())
}

/// One unit of the last digit of a printed number.
fn unit(text: &str) -> f64 {
    let (digits, power) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, low)| low.len());
    let power: i32 = power.parse().expect("a whole number");
    format!("1e{}", power - decimals as i32).parse().expect("a number")
}

/// What the reference says of a case, by the names of the table.
fn truths(expect: &Value) -> Vec<(String, String)> {
    let mut truths = Vec::new();
    let object = |key: &str| expect[key].as_object().into_iter().flatten();
    let text = |value: &Value| value.as_str().map(str::to_owned);
    let mut put = |name: String, value: &Value| {
        if let Some(value) = text(value) {
            truths.push((name, value));
        }
    };
    for (name, link) in object("links") {
        put(format!("omega({name})"), &link["omega"]);
        put(format!("alpha({name})"), &link["alpha"]);
    }
    for (name, slider) in object("sliders") {
        let link = name.split('/').next().expect("a name");
        let name = format!("{link}/{}", slider["on"].as_str().expect("a name"));
        put(format!("v_r({name})"), &slider["velocity"]);
        put(format!("a_r({name})"), &slider["acceleration"]);
    }
    for kind in ["points", "coincident", "special"] {
        for (name, point) in object(kind) {
            for (letter, key) in [("v", "velocity"), ("a", "acceleration")] {
                for (axis, index) in [("x", 0), ("y", 1)] {
                    put(format!("{letter}({name}).{axis}"), &point[key][index]);
                }
                let parts = [0, 1].map(|index| point[key][index].as_str().and_then(|text| text.parse::<f64>().ok()));
                if let [Some(x), Some(y)] = parts {
                    // Rounded twice, which is less than the least bound.
                    put(format!("{letter}({name}).size"), &format!("{:e}", libm::hypot(x, y)).into());
                    put(format!("{letter}({name}).angle"), &format!("{:e}", libm::atan2(y, x).to_degrees()).into());
                }
            }
        }
    }
    truths
}

/// Every printed digit of a set of reference scenes; of `every` cases one is taken.
fn check(set: &str, every: usize, least: usize) {
    let text = files::read(&format!("tests/reference/{set}.jsonl"));
    let mut seen = 0;
    let (mut wrong, mut kept) = (Vec::new(), Vec::new());
    for line in text.lines().step_by(every) {
        let case: Value = serde_json::from_str(line).expect("a line is JSON");
        let Some(table) = table(&exactly_written(files::scene_text(line))) else {
            continue;
        };
        for (name, truth) in truths(&case["expect"]) {
            let Some([value, _, bound]) = table.get(&name) else {
                continue;
            };
            seen += 1;
            let printed: f64 = value.parse().expect("a number");
            let error = minus(printed, &truth).abs();
            // Directions are alike after a turn.
            let error = if name.ends_with(".angle") { error.min((error - 360.0).abs()) } else { error };
            // Nothing is certain: the true value lies within the bound of zero. Else within a unit of the last digit.
            let allowed = match value.as_str() {
                "0" => bound.parse().expect("a number"),
                _ => unit(value),
            };
            // The printed decimal itself is read with one rounding.
            let slack = 1e-16 * printed.abs();
            if error > allowed + slack {
                wrong.push(format!("{}: {name} = {value} ± {bound}, truly {truth}", case["name"]));
            }
            // Exact decimals say nothing of how tight a bound is.
            if bound != "0" && error > 0.0 {
                kept.push(allowed / error);
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {seen}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(seen >= least, "{set}: only {seen} numbers compared");
    kept.sort_by(f64::total_cmp);
    let middle = kept[kept.len() / 2];
    assert!(middle < WASTEFUL, "{set}: units of the last digit are {middle:.0} errors");
}

#[test]
fn of_the_papers_mechanism_from_its_lengths_to_its_limit() {
    check("paper", 1, 2000);
}

#[test]
fn of_dyads_and_triads() {
    check("dyads", 1, 500);
    check("triads", 1, 200);
}

#[test]
fn of_hard_positions() {
    check("hard", 3, 3000);
    check("hard_dyads_triads", 1, 500);
}

/// A dyad next to its dead centre, and one that hangs on it, as drawn: neither has lost a digit. The true rates are those of exact
/// fractions.
#[test]
fn of_a_group_that_hangs_on_a_nearly_dead_one() {
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "points": { "A": [0, 0], "B": [60, 10], "C": [160, 17], "D": [260, 24.00048828125], "E": [230, 70], "F": [330, 95], "G": [350, 0] },
        "ground": ["A", "D", "G"],
        "links": { "1": { "points": ["A", "B"], "drive": { "omega": 2, "alpha": 1 } },
                   "2": ["B", "C"], "3": ["C", "D", "E"], "4": ["E", "F"], "5": ["F", "G"] } }"#;
    let table = table(scene).expect("it is not singular");
    for (name, truth) in [
        ("omega(2)", "23755.6"),
        ("omega(3)", "-23756.8"),
        ("omega(4)", "-4585.0856"),
        ("omega(5)", "-12709.772"),
        ("alpha(3)", "-232293370259754.1888"),
        ("alpha(4)", "-44832718273617.392529744"),
        ("alpha(5)", "-124275906976749.85031608"),
    ] {
        let [value, ..] = &table[name];
        let error = minus(value.parse().expect("a number"), truth).abs();
        assert!(error <= unit(value), "{name} = {value}, truly {truth}");
        // The condition of 4e6 would leave nine digits of plain f64.
        let digits = value.split('e').next().expect("digits");
        let count = digits.bytes().filter(u8::is_ascii_digit).count();
        assert!((15..=17).contains(&count), "{name} = {value}");
    }
}

/// A crank that pushes nothing: at a dead centre the rocker stands still, and only that can be said.
#[test]
fn says_where_no_digit_is_certain() {
    // Crank and coupler in one line: ω4 is nothing, ω2 is −ω1 · 30/70.
    let scene = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
        "points": { "A": [0, 0], "B": [18, 24], "C": [60, 80], "D": [90, 0] }, "ground": ["A", "D"],
        "links": { "1": { "points": ["A", "B"], "drive": { "omega": 0.7 } }, "2": ["B", "C"], "3": ["C", "D"] } }"#;
    let output = with_scene(&["solve", "--digits", "-"], scene.as_bytes());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let line = |name: &str| text.lines().find(|l| l.starts_with(name)).expect(name);
    let words: Vec<&str> = line("omega(3)").split_whitespace().collect();
    assert_eq!((words[1], words[3]), ("0", "±"), "{text}");
    assert!(line("omega(3)").ends_with("no digit is certain"), "{text}");
    let coupler: Vec<&str> = line("omega(2)").split_whitespace().collect();
    assert!(coupler[1].starts_with("-0.30000000000"), "{text}");
}

#[test]
fn goes_with_modes_and_has_what_is_wanted() {
    let figure_2 = files::read("examples/figure-2.json");
    let mode = ["solve", "--digits", "--mode", "2", "-"];
    let output = with_scene(&mode, figure_2.as_bytes());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let other = String::from_utf8(output.stdout).expect("UTF-8");
    let own = with_scene(&["solve", "--digits", "-"], figure_2.as_bytes());
    assert_ne!(other.as_bytes(), own.stdout);

    let want =
        r#""want": ["omega(2)", "v(D)", "L(B,S3)", "vplan(b,s3)", "x(S3)", "v(S3/B)", "vplan(b,s3)/mu"], "figure""#;
    let scene = figure_2.replace("\"figure\"", want);
    let output = with_scene(&["solve", "--digits", "-"], scene.as_bytes());
    assert_eq!(stderr(&output), "");
    // What is wanted stands beside all the rest.
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(text.contains("v(D).x") && text.contains("a(D).x"), "{text}");
    let row = |name: &str| {
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
        let found: Vec<&Vec<&str>> = rows.iter().filter(|row| row[0] == name).collect();
        assert_eq!(found.len(), 1, "{name}: {text}");
        found[0].iter().map(|word| (*word).to_owned()).collect::<Vec<String>>()
    };
    row("omega(2)");
    for name in ["L(B,S3)", "vplan(b,s3)", "x(S3)", "v(S3/B).size", "vplan(b,s3)/mu"] {
        let row = row(name);
        let digits = row[1].bytes().filter(u8::is_ascii_digit).count();
        let bound: f64 = row[4].parse().expect("a bound");
        assert!(row[3] == "±" && bound > 0.0 && bound < 1e-10 && digits >= 13, "{row:?}");
    }
    // A segment and the relative velocity that it shows are one number.
    assert_eq!(row("vplan(b,s3)")[1][..14], row("v(S3/B).size")[1][..14]);
    assert_eq!(row("vplan(b,s3)/mu")[2], "mm");
}

/// What a lecturer looks for first: sizes and directions, of relative vectors too.
#[test]
fn sizes_and_directions_stand_there() {
    let table = table(&files::read("tests/lecture/shaper.json")).expect("it is not singular");
    for name in ["v(D).size", "v(D).angle", "a(B).size", "a(B).angle", "a_c(2/3).size", "a_c(2/3).angle"] {
        assert!(table.contains_key(name), "{name}");
    }
    // A point at rest has no direction.
    assert_eq!(table["v(O).size"][0], "0");
    assert!(!table.contains_key("v(O).angle"));
    let [size, unit, _] = &table["v(A).size"];
    let (size, truth) = (size.parse::<f64>().expect("a number"), 200.0 * std::f64::consts::PI);
    assert!((size - truth).abs() < 1e-9 && unit == "mm/s", "{size}");
}

/// The same four-bar at the origin and 10¹¹ mm away from it, where f64 has five decimals left: what is printed there is what is printed
/// here, with the decimals that are certain.
#[test]
fn modes_have_certain_decimals_alone() {
    let places = |away: &str| -> Vec<[String; 2]> {
        let scene = format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [{away}000, 0], "D": [{away}120, 0] }},
            "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 40 }}, "drive": {{ "angle": 60, "omega": 10 }} }},
            "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 100 }} }}, "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 80 }} }} }} }}"#
        );
        let output = with_scene(&["modes", "-"], scene.replace("[000,", "[0,").as_bytes());
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        let told = text.lines().filter_map(|line| Some(line.split_once("C (")?.1.split_once(')')?.0.to_owned()));
        let pair = |told: String| {
            let (x, y) = told.split_once(", ").expect("two coordinates");
            [x.strip_prefix(away).unwrap_or(x).to_owned(), y.to_owned()]
        };
        told.map(pair).collect()
    };
    let (here, there) = (places(""), places("100000000"));
    assert_eq!([here.len(), there.len()], [2, 2]);
    for (here, there) in here.iter().flatten().zip(there.iter().flatten()) {
        let decimals = |text: &str| text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let [own, far] = [here, there].map(|text| text.parse::<f64>().expect("a number"));
        assert!(decimals(here) == 6 && (2..6).contains(&decimals(there)), "{here} {there}");
        assert!((own - far).abs() <= 0.5 * libm::pow(10.0, -(decimals(there) as f64)) + 1e-6, "{here} {there}");
    }
}
