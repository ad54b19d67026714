//! Every textbook case of `tests/worked`, from its lengths and as drawn, against the exact motion; and what the example
//! `textbook_cases` says about the printed answers.

use crate::examples::textbook_cases::{Case, cases, markdown, plain};
use serde_json::Value;
use support::comparison::Comparison;
use support::exact::exceeds;
use support::files;
use support::stages::solved;

/// Errors allowed, relative to the largest quantity of a kind.
const BOUND: f64 = 1e-10;

#[test]
fn every_case_moves_as_it_must() {
    let (mut worst, mut seen, mut failures) = ((0.0, String::new()), 0, Vec::new());
    for case in folders() {
        let expect: Value =
            serde_json::from_str(&files::read(&format!("tests/worked/{case}/expect.json"))).expect("JSON");
        for file in ["scene.json", "drawn.json"] {
            seen += 1;
            let text = files::read(&format!("tests/worked/{case}/{file}"));
            let scene: Value = serde_json::from_str(&text).expect("JSON");
            let expect = decimals(&merged(&expect, &expect["per_file"][file]));
            let solution = solved(&text).unwrap_or_else(|e| panic!("{case}/{file}: {e}"));
            let result = solution.result();
            let mut comparison = Comparison::new(&expect, &scene, &result);
            comparison.all();
            let what = |what: &str| format!("{case}/{file}: {what}");
            failures.extend(comparison.problems.iter().map(|problem| what(problem)));
            assert!(comparison.errors.len() > 10, "{}", what("too little"));
            for (error, quantity) in comparison.errors {
                if exceeds(error, BOUND) {
                    failures.push(what(&format!("{quantity} is wrong by {error:.3e}")));
                }
                if exceeds(error, worst.0) {
                    worst = (error, what(&quantity));
                }
            }
        }
    }
    println!("{seen} files, largest error {:.3e} ({})", worst.0, worst.1);
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert_eq!(seen, 40);
}

#[test]
fn printed_answers_deserve_their_verdicts() {
    let cases = cases().expect("the cases are solved");
    let mut rows = 0;
    let mut failures = Vec::new();
    for (case, row) in cases.iter().flat_map(|c| c.rows.iter().map(move |r| (c, r))) {
        rows += 1;
        let what = format!("{}: {} printed {}", case.id, row.quantity, row.printed);
        let size = row.exact.abs().max(1e-3);
        if exceeds((row.computed - row.exact).abs() / size, BOUND) {
            failures.push(format!("{what}: {} is not {}", row.computed, row.exact));
        }
        let value: f64 = row.printed.parse().expect("a number");
        let difference = (value - row.computed).abs();
        let part = difference / size;
        let fair = match row.verdict.as_str() {
            // A small component carries the rounding of its vector.
            "agrees to machine precision" => part < 1e-13 || difference < 1e-14,
            // A last digit may be a slip of rounding; five digits of one hand value are.
            "agrees to the printed digits" => difference <= 1.01 * last_digit(&row.printed) || part < 1e-4,
            v if v.starts_with("agrees") => part < 1e-3,
            v if v.starts_with("graphical") => part <= 0.03,
            v if v.starts_with("coarse graphical") => part > 0.03 && part < 0.065,
            _ => false,
        };
        if !fair {
            failures.push(format!("{what}, computed {}: not \"{}\"", row.computed, row.verdict));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert_eq!((cases.len(), rows), (20, 269));
}

#[test]
fn every_folder_is_in_the_table_once() {
    let cases = cases().expect("the cases are solved");
    let mut ids: Vec<&str> = cases.iter().map(|c: &Case| c.id).collect();
    ids.sort_unstable();
    assert_eq!(ids, folders());
}

#[test]
fn the_table_fits_100_columns_and_the_page_is_current() {
    let cases = cases().expect("the cases are solved");
    for line in plain(&cases).lines() {
        assert!(line.chars().count() <= 100 && line.trim_end() == line, "{line:?}");
    }
    let there = files::read("docs/textbook-cases.md");
    assert!(
        there.replace("\r\n", "\n") == markdown(&cases),
        "make it anew: cargo run --example textbook_cases -- --markdown > docs/textbook-cases.md"
    );
}

/// One unit of the last digit printed.
fn last_digit(printed: &str) -> f64 {
    let decimals = printed.split_once('.').map_or(0, |(_, d)| d.len());
    libm::pow(10.0, -(decimals as f64))
}

fn folders() -> Vec<String> {
    let mut names = files::list("tests/worked");
    names.retain(|name| files::path("tests/worked").join(name).is_dir());
    names
}

/// The common expectation with what holds for one file only.
fn merged(common: &Value, own: &Value) -> Value {
    let (Value::Object(common), Value::Object(own)) = (common, own) else {
        return own.clone();
    };
    let mut all = common.clone();
    for (key, value) in own {
        let value = match all.get(key) {
            Some(there) => merged(there, value),
            None => value.clone(),
        };
        all.insert(key.clone(), value);
    }
    Value::Object(all)
}

/// The numbers as decimal strings, as the comparison takes them.
fn decimals(json: &Value) -> Value {
    match json {
        Value::Number(number) => Value::String(number.to_string()),
        Value::Array(items) => items.iter().map(decimals).collect(),
        Value::Object(items) => {
            let items = items.iter().map(|(k, v)| (k.clone(), decimals(v)));
            Value::Object(items.collect())
        }
        other => other.clone(),
    }
}
