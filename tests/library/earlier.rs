//! What was written in an earlier format is still read: `tests/earlier` has a folder for each day on which a format grew. A result keeps every key
//! that it had, with values of the same kind, and numbers that agree within both bounds.

use kinegon::board::HandDrawing;
use kinegon::check::{Marks, Measured, check};
use kinegon::drawing::Style;
use kinegon::study::StudyFile;
use serde_json::Value;
use support::files;
use support::stages::{answer_key, solved};

/// Names, in order of days, and texts of all files of a kind: `2026-11-21/scenes/four-bar.json`.
fn each(kind: &str) -> Vec<(String, String)> {
    let days = files::list("tests/earlier").into_iter().filter(|day| day.starts_with(|c: char| c.is_ascii_digit()));
    let folders = days.map(|day| format!("tests/earlier/{day}/{kind}")).filter(|folder| files::path(folder).is_dir());
    let names = folders.flat_map(|folder| files::list(&folder).into_iter().map(move |name| format!("{folder}/{name}")));
    let all: Vec<(String, String)> = names.map(|name| (name.clone(), files::read(&name))).collect();
    assert!(!all.is_empty(), "no {kind}");
    all
}

/// The newest scene whose name a file's begins with: a form `four-bar-right.json` is of `four-bar.json`.
fn scene_of(file: &str) -> Option<String> {
    let stem = |path: &str| path.rsplit('/').next().and_then(|name| name.split('.').next()).unwrap_or("").to_owned();
    let own = stem(file).replace("paper-as-student", "figure-2");
    let fitting = each("scenes").into_iter().filter(|(name, _)| own.starts_with(&stem(name)));
    // The longest name fits best; of several days the last one is the newest.
    fitting.max_by_key(|(name, _)| stem(name).len()).map(|(_, text)| text)
}

#[test]
fn scenes_are_solved() {
    for (name, text) in each("scenes") {
        solved(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

#[test]
fn forms_are_judged() {
    let mut judged = 0;
    for (name, text) in each("forms") {
        let measured = match name.ends_with(".csv") {
            true => Measured::read_csv(&text).unwrap_or_else(|error| panic!("{name}: {error}")),
            false => Measured::read_json(&text).unwrap_or_else(|error| panic!("{name}: {error}")),
        };
        let Some(scene) = scene_of(&name) else { continue };
        let solution = solved(&scene).unwrap_or_else(|error| panic!("{name}: {error}"));
        check(&measured, &answer_key(&solution, 2)).unwrap_or_else(|error| panic!("{name}: {error}"));
        judged += 1;
    }
    assert!(judged > 10, "{judged}");
}

#[test]
fn drawings_marks_styles_and_studies_are_read() {
    for (name, text) in each("drawings") {
        let drawing = HandDrawing::read(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(!drawing.did.is_empty(), "{name}");
    }
    for (name, text) in each("marks") {
        Marks::read(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    for (name, text) in each("styles") {
        Style::read(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    for (name, text) in each("studies") {
        StudyFile::read(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// Holds a part of today's result against the earlier one, at a place in the file.
fn assert_kept(at: &str, before: &Value, now: &Value, allowed: f64) {
    match (before, now) {
        (Value::Object(before), Value::Object(now)) => {
            for (key, value) in before {
                let error = |object: &serde_json::Map<String, Value>| {
                    object.get(&format!("{key}_error")).and_then(Value::as_f64)
                };
                let allowed = error(before).unwrap_or(0.0) + error(now).unwrap_or(0.0);
                let own = now.get(key).unwrap_or_else(|| panic!("{at}: {key} is gone"));
                assert_kept(&format!("{at}/{key}"), value, own, allowed);
            }
        }
        (Value::Array(before), Value::Array(now)) => {
            assert_eq!(before.len(), now.len(), "{at}");
            before.iter().zip(now).for_each(|(before, now)| assert_kept(at, before, now, allowed));
        }
        // A bound may get tighter.
        (Value::Number(_), Value::Number(_)) if at.contains("_error") => (),
        (Value::Number(before), Value::Number(now)) => {
            let [before, now] = [before, now].map(|number| number.as_f64().expect("a number"));
            // Lengths of paper, conditions and limits of disagreement have no bound of their own.
            let allowed = allowed.max(1e-12 * before.abs());
            assert!((before - now).abs() <= allowed, "{at}: {before} before, {now} now, {allowed} allowed");
        }
        // Texts for people may be put into better words.
        (Value::String(_), Value::String(_)) => (),
        _ => assert_eq!(before, now, "{at}"),
    }
}

#[test]
fn results_keep_their_keys_and_numbers() {
    for (name, text) in each("results") {
        let scene = scene_of(&name).unwrap_or_else(|| panic!("{name} has no scene"));
        let solution = solved(&scene).unwrap_or_else(|error| panic!("{name}: {error}"));
        let result = solution.whole_result().unwrap_or_else(|error| panic!("{name}: {error}"));
        let now = serde_json::to_value(&result).expect("it is JSON");
        assert_kept(&name, &serde_json::from_str(&text).expect("it is JSON"), &now, 0.0);
    }
}
