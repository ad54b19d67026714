//! `kinegon check` of drawings made on the drawing board: one, a class with marks, those of exercises; and Kinegon's own.

use serde_json::{Value, json};
use std::path::Path;
use std::process::Output;
use support::program::{kinegon, scratch, stderr};

const FOUR_BAR: &str = "templates/four-bar.json";

fn run(arguments: &[&str], file: &Path) -> Output {
    let (first, more) = arguments.split_at(2);
    kinegon().args(first).arg(file).args(more).output().expect("the program starts")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

/// Kinegon's own construction of the four-bar linkage.
fn own() -> Value {
    let output = kinegon().args(["steps", FOUR_BAR, "--drawing"]).output().expect("the program starts");
    assert!(output.status.success(), "{}", stderr(&output));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// The index of the first entry that makes this.
fn entry(drawing: &Value, key: &str, name: &str) -> usize {
    let did = drawing["did"].as_array().expect("a list");
    did.iter().position(|entry| entry[key] == name).expect("it is there")
}

/// A folder with a right drawing, two in which the same ray is turned, and one in which a normal part points outward.
fn class(folder: &Path) {
    let right = own();
    let mut turned = right.clone();
    let ray = entry(&right, "line", "r1");
    turned["did"][ray]["along"] = json!({ "parallel": "B,C" });
    let mut outward = right.clone();
    let normal = entry(&right, "lay_off", "n_bC");
    outward["did"][normal]["along"] = json!({ "parallel": "C,B" });
    for (name, mut drawing) in [("ana", right), ("bo", turned.clone()), ("cy", turned), ("di", outward)] {
        drawing["name"] = json!(name);
        std::fs::write(folder.join(format!("{name}.json")), drawing.to_string()).expect("it can be written");
    }
}

#[test]
fn one_drawing_is_judged_operation_by_operation() {
    let folder = scratch("boards-one");
    class(&folder);
    let output = run(&["check", FOUR_BAR], &folder.join("ana.json"));
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).ends_with("Every operation is right.\n"));
    let output = run(&["check", FOUR_BAR], &folder.join("bo.json"));
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let text = stdout(&output);
    for words in ["c does not lie on this line", "turned by 90°", "The first wrong operation is number 3."] {
        assert!(text.contains(words), "no {words} in\n{text}");
    }
    let output = run(&["check", FOUR_BAR, "--json", "--language", "de"], &folder.join("di.json"));
    let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let first = result["drawing"]["first_wrong"].as_u64().expect("one is wrong") as usize;
    let found = &result["drawing"]["entries"][first];
    assert_eq!((&found["verdict"], &found["mistake"]), (&json!("wrong"), &json!("normal-outward")));
    assert_eq!(found["says"], "n_bC liegt nicht dort");
}

#[test]
fn a_class_of_drawings_has_its_first_wrong_operations_counted() {
    let folder = scratch("boards-class");
    class(&folder);
    let output = run(&["check", FOUR_BAR], &folder);
    assert_eq!(output.status.code(), Some(1));
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let rows = reader.deserialize::<std::collections::BTreeMap<String, String>>();
    let rows: Vec<_> = rows.map(|row| row.expect("a row as wide as its head")).collect();
    let column = |name: &str| -> Vec<&str> { rows.iter().map(|row| row[name].as_str()).collect() };
    assert_eq!(column("name"), ["ana", "bo", "cy", "di"]);
    assert_eq!(column("passed"), ["true", "false", "false", "false"]);
    assert_eq!(column("mistake"), ["", "turned-ray", "turned-ray", "normal-outward"]);
    // The step in which c is found, and the one that lays the normal part off.
    assert_eq!(column("step"), ["", "5", "5", "11"]);
    assert!(stderr(&output).contains("2 of 4"), "{}", stderr(&output));
}

#[test]
fn drawings_of_exercises_find_theirs_and_have_keys() {
    let folder = scratch("boards-exercises");
    let exercises = folder.join("exercises");
    let mut command = kinegon();
    command.args(["exercise", "slider-crank", "--seed", "4", "--count", "2", "-o"]).arg(&exercises);
    assert!(command.output().expect("the program starts").status.success());
    for name in ["slider-crank-4-1", "slider-crank-4-2"] {
        let key = std::fs::read_to_string(exercises.join(name).join("key-drawing.json")).expect("a key");
        let mut drawing: Value = serde_json::from_str(&key).expect("JSON");
        drawing["exercise"] = json!(name);
        let file = folder.join("drawing.json");
        std::fs::write(&file, drawing.to_string()).expect("it can be written");
        let output = kinegon().arg("check").arg(&exercises).arg(&file).output().expect("the program starts");
        assert_eq!(output.status.code(), Some(0), "{}{}", stdout(&output), stderr(&output));
    }
}

#[test]
fn what_is_no_drawing_is_refused_with_its_place() {
    let folder = scratch("boards-refused");
    let file = folder.join("drawing.json");
    let refused = [
        (json!({ "kinegon_drawing": 1, "did": [{ "crosss": "c" }] }), "an entry has one of the keys"),
        (
            json!({ "kinegon_drawing": 1, "did": [{ "line": "r1", "through": "p" }] }),
            "a line has `through` and `along`, or `drawn`",
        ),
        (json!({ "kinegon_drawing": 1, "did": [{ "cross": "c", "of": ["r1", "r2"] }] }), "did.0: there is no line r1"),
        (json!({ "kinegon_drawing": 2, "did": [] }), "kinegon_drawing"),
    ];
    for (drawing, words) in refused {
        std::fs::write(&file, drawing.to_string()).expect("it can be written");
        let output = run(&["check", FOUR_BAR], &file);
        assert_eq!(output.status.code(), Some(2), "{drawing}");
        assert!(stderr(&output).contains(words), "{drawing}: {}", stderr(&output));
    }
}

#[test]
fn a_scale_at_which_no_paper_is_large_enough_is_refused() {
    let folder = scratch("boards-scale");
    let file = folder.join("far.json");
    std::fs::write(&file, "{\n  \"kinegon_drawing\": 1,\n  \"mu_v\": 2.5e-6,\n  \"did\": []\n}\n")
        .expect("it can be written");
    let output = run(&["check", FOUR_BAR], &file);
    assert_eq!(output.status.code(), Some(2), "{}", stdout(&output));
    let said = stderr(&output);
    for words in ["far.json:3:", "the velocity plan would be", "sheets of up to 100 m", "or leave mu_v out"] {
        assert!(said.contains(words), "no {words} in\n{said}");
    }
}
