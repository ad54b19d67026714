//! Tables of loads in files beside a scene: the same as if their lines stood in it, and one clear message where something is wrong.

use serde_json::{Value, json};
use std::path::Path;
use support::program::{self, scratch, stderr};

/// A slider-crank with a force on its slider and a couple on its crank, whose tables stand in these files.
fn scene(force: &Value, couple: &Value) -> String {
    json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "force": "N" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": 40, "omega": 10 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 150 } }, "3": { "points": ["C"] },
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0 }],
        "near": { "C": [150, 0] },
        "forces": [
            { "name": "gas", "on": "3", "at": "C", "force": [-2, 0], "over": { "of": "angle(1)", "table": force } },
            { "name": "M", "on": "1", "couple": 3, "over": { "of": "angle(1)", "table": couple } }],
    })
    .to_string()
}

/// The forces of a scene file, or the error.
fn solved(folder: &Path) -> Result<Value, String> {
    let output =
        program::kinegon().current_dir(folder).args(["solve", "scene.json"]).output().expect("the program runs");
    match output.status.success() {
        true => {
            let result: Value = serde_json::from_slice(&output.stdout).expect("a result is JSON");
            Ok(result["forces"].clone())
        }
        false => Err(stderr(&output)),
    }
}

fn with_files(name: &str, force: &Value, couple: &Value, files: &[(&str, &str)]) -> Result<Value, String> {
    let folder = scratch(name);
    std::fs::write(folder.join("scene.json"), scene(force, couple)).expect("it can be written");
    for (file, text) in files {
        std::fs::write(folder.join(file), text).expect("it can be written");
    }
    solved(&folder)
}

#[test]
fn a_table_in_a_file_is_the_same_as_its_lines() {
    let (gas, torque) = (json!([[0, 10], [90, 30.5], [180, -4]]), json!([[0, 1], [90, 2], [180, 0.5]]));
    let inline = with_files("load_tables_inline", &gas, &torque, &[]).expect("it is solved");
    for (index, (gas_file, torque_file)) in [
        ("0,10\n90,30.5\n180,-4\n", "0;1\r\n90;2\r\n180;0,5\r\n"),
        ("angle,gas\n0,10\n90,30.5\n180,-4", "\u{feff}angle\tM\n\n0\t1\n90\t2\n180\t0.5\n"),
        ("angle,M,gas\n0,1,10\n90,2,30.5\n180,0.5,-4\n", "angle,gas,M\n0,10,1\n90,30.5,2\n180,-4,0.5\n"),
    ]
    .into_iter()
    .enumerate()
    {
        let files = [("gas.csv", gas_file), ("m.csv", torque_file)];
        let found = with_files(&format!("load_tables_{index}"), &json!("gas.csv"), &json!("m.csv"), &files);
        assert_eq!(found.expect("it is solved"), inline);
    }
}

#[test]
fn what_is_wrong_in_a_table_is_told_with_its_place() {
    let lines = json!([[0, 1], [90, 2]]);
    for (index, (text, message)) in [
        ("0,1\n90,two\n", "gas.csv: line 2, column 2: there is no number"),
        ("0,1\n90\n", "gas.csv: line 2, column 2: there is no number"),
        ("0\n1\n", "gas.csv: there is no second column"),
        ("0,1,2\n", "gas.csv: there are more than two columns, and the first line does not name them"),
        ("angle,p,q\n0,1,2\n", "gas.csv: there is no column for `gas`"),
        ("90,1\n0,2\n", "over.table"),
        ("0,inf\n1,2\n", "gas.csv: line 1, column 2: there is no number"),
    ]
    .into_iter()
    .enumerate()
    {
        let found = with_files(&format!("load_tables_bad_{index}"), &json!("gas.csv"), &lines, &[("gas.csv", text)]);
        let error = found.expect_err("it is refused");
        assert!(error.contains(message), "{text:?}: {error}");
    }
    let many: String = (0..10_001).map(|index| format!("{index},1\n")).collect();
    let found = with_files("load_tables_many", &json!("gas.csv"), &lines, &[("gas.csv", &many)]);
    assert!(found.expect_err("it is refused").contains("more than 10000 lines"));
    let missing = with_files("load_tables_missing", &json!("nowhere.csv"), &lines, &[]);
    assert!(missing.expect_err("it is refused").contains("nowhere.csv cannot be read"));
    // What stands outside of the scene's folder is not read.
    let outside = scratch("load_tables_outside");
    std::fs::write(outside.join("secret.csv"), "0,1\n90,secret\n").expect("it can be written");
    let path = json!(outside.join("secret.csv"));
    let error = with_files("load_tables_inside", &path, &lines, &[]).expect_err("it is refused");
    assert!(error.contains("is outside of its folder"), "{error}");
}
