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

/// Minus signs, degree signs behind angles and the unit of length behind positions are read, in a first line as in others.
#[test]
fn numbers_of_the_first_line_count_as_they_are_written() {
    let lines = json!([[0, 1], [90, 2]]);
    let plain = with_files("load_tables_plain", &json!([[-10, 10], [90, -30.5], [180, 4]]), &lines, &[]);
    let plain = plain.expect("it is solved");
    for (index, text) in [
        "\u{2212}10;10\n90;\u{2212}30,5\n180;4\n",
        "-10\u{b0};10\n90 \u{b0};-30.5\n180 deg;4\n",
        "sep=;\n-10;10\n90;-30.5\n180;4\n",
        "\"-10\",\"10\"\n90,-30.5\n180,4\n",
        "angle;gas (N)\n-10;10\n90;-30.5\n180;4\n",
    ]
    .into_iter()
    .enumerate()
    {
        let files = [("gas.csv", text)];
        let found = with_files(&format!("load_tables_signs_{index}"), &json!("gas.csv"), &lines, &files);
        assert_eq!(found.expect("it is solved"), plain, "{text:?}");
    }
    let over_position = |table: Value| {
        let force = json!({ "name": "gas", "on": "3", "at": "C", "force": [-2, 0], "over": { "of": "position(3/ground)", "table": table } });
        let mut scene: Value = serde_json::from_str(&scene(&lines, &lines)).expect("JSON");
        scene["forces"][0] = force;
        let folder = scratch("load_tables_position");
        std::fs::write(folder.join("scene.json"), scene.to_string()).expect("it can be written");
        std::fs::write(folder.join("gas.csv"), "150 mm;1\n250 mm;9\n").expect("it can be written");
        solved(&folder).expect("it is solved")
    };
    assert_eq!(over_position(json!("gas.csv")), over_position(json!([[150, 1], [250, 9]])));
    // A load may be called by a number: its name in the first line is a heading, a number beside it is none.
    let called = |text: &str| {
        let mut scene: Value = serde_json::from_str(&scene(&json!("gas.csv"), &lines)).expect("JSON");
        scene["forces"][0]["name"] = json!("1");
        let folder = scratch("load_tables_called");
        std::fs::write(folder.join("scene.json"), scene.to_string()).expect("it can be written");
        std::fs::write(folder.join("gas.csv"), text).expect("it can be written");
        solved(&folder)
    };
    assert_eq!(called("angle;2;1\n0;7;10\n90;7;20\n"), called("angle;1\n0;10\n90;20\n"));
    assert!(called("angle;1\n0;10\n90;20\n").is_ok());
}

/// What a scene names is a file in its folder, whatever its name: no stdin, no pipe, no device, nothing that a link leads to elsewhere.
#[test]
#[cfg(unix)]
fn only_files_are_read_as_tables() {
    let lines = json!([[0, 1], [90, 2]]);
    for (index, (name, message)) in [
        ("-", "-, which the scene names as a table, cannot be read"),
        ("pipe", "pipe, which the scene names as a table, is a pipe or a device"),
        ("zero", "zero, which the scene names as a table, is outside of its folder"),
        ("folder", "folder, which the scene names as a table, is a folder"),
        ("large", "large, which the scene names as a table, is larger than 4 MB"),
    ]
    .into_iter()
    .enumerate()
    {
        let folder = scratch(&format!("load_tables_special_{index}"));
        std::fs::write(folder.join("scene.json"), scene(&json!(name), &lines)).expect("it can be written");
        let made = std::process::Command::new("mkfifo").arg(folder.join("pipe")).status().expect("mkfifo runs");
        assert!(made.success());
        std::os::unix::fs::symlink("/dev/zero", folder.join("zero")).expect("it can be linked");
        std::fs::create_dir(folder.join("folder")).expect("it can be made");
        let large = std::fs::File::create(folder.join("large")).expect("it can be written");
        large.set_len(1 << 40).expect("it takes no room");
        // Who reads stdin finds a table there.
        let mut command = program::kinegon();
        let output = program::in_a_minute(command.current_dir(&folder).args(["solve", "scene.json"]), b"0;1\n90;2\n");
        let output = output.unwrap_or_else(|| panic!("{name}: it waits"));
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert!(stderr(&output).contains(message), "{name}: {}", stderr(&output));
    }
}

/// A file is read once for all its loads, and what is wrong in the scene is told at its place in the scene's file.
#[test]
fn many_loads_of_one_file_cost_no_more_than_their_lines() {
    let folder = scratch("load_tables_shared");
    std::fs::write(folder.join("gas.csv"), "0;1\n90;2\n").expect("it can be written");
    let solved_with = |count: usize, at: &str, table: &Value| {
        let mut scene: Value = serde_json::from_str(&scene(table, table)).expect("JSON");
        let load = |index: usize| json!({ "name": format!("P{index}"), "on": "3", "at": at, "force": [-1, 0], "over": { "of": "angle(1)", "table": table } });
        scene["forces"] = (0..count).map(load).collect();
        std::fs::write(folder.join("scene.json"), scene.to_string()).expect("it can be written");
        let begun = std::time::Instant::now();
        let output =
            program::kinegon().current_dir(&folder).args(["structure", "scene.json"]).output().expect("it runs");
        (output.status.code(), stderr(&output), begun.elapsed())
    };
    let (file, inline) = (json!("gas.csv"), json!([[0, 1], [90, 2]]));
    let (code, error, time) = solved_with(4000, "C", &file);
    assert_eq!(code, Some(0), "{error}");
    let (_, _, usual) = solved_with(4000, "C", &inline);
    assert!(time < 4 * usual + std::time::Duration::from_secs(1), "{time:?} for {usual:?}");
    let (code, error, _) = solved_with(2, "Q", &file);
    assert_eq!(code, Some(2));
    assert!(error.contains(r#""table":"gas.csv""#) && error.contains("forces[0].at"), "{error}");
    let many: String = (0..9_000).map(|index| format!("{};1\n", f64::from(index) / 50.0)).collect();
    std::fs::write(folder.join("gas.csv"), many).expect("it can be written");
    let (code, error, _) = solved_with(100, "C", &file);
    assert_eq!(code, Some(2));
    assert!(error.contains("with the tables of all its loads is larger than 4 MB: gas.csv"), "{error}");
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
        ("90,1\n0,2\n", "gas.csv: line 2: 0 stands after 90"),
        ("0,inf\n1,2\n", "gas.csv: line 1, column 2: there is no number"),
        // A first line with anything like a number is no heading: nothing falls out without a word.
        ("150 mm;1\n180;2\n", "gas.csv: line 1, column 1: there is no number"),
        ("10;2600 N\n180;2\n", "gas.csv: line 1, column 2: there is no number"),
        ("1.234,5;1\n180;2\n", "gas.csv: line 1, column 1: there is no number"),
        ("x;(1)\n0;1\n180;2\n", "gas.csv: line 1, column 1: there is no number"),
        ("\u{2013}10;1\n180;2\n", "gas.csv: line 1, column 1: there is no number"),
        ("NaN;NaN\n0;1\n180;2\n", "gas.csv: line 1, column 1: there is no number"),
        // Nor does a cell: here a decimal comma has split a number.
        ("0,1\n7,5,2\n", "gas.csv: line 2 has 3 cells, and the first line 2"),
        ("angle;M;gas\n0;\"1;5\n90;2;7\n", "gas.csv: line 2, column 2: there is no number"),
        ("0;1\n200;2\n100;3\n", "gas.csv: line 3: 100 stands after 200"),
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
    assert!(
        missing.expect_err("it is refused").contains("nowhere.csv, which the scene names as a table, cannot be read")
    );
    // What stands outside of the scene's folder is not read.
    let outside = scratch("load_tables_outside");
    std::fs::write(outside.join("secret.csv"), "0,1\n90,secret\n").expect("it can be written");
    let path = json!(outside.join("secret.csv"));
    let error = with_files("load_tables_inside", &path, &lines, &[]).expect_err("it is refused");
    assert!(error.contains("is outside of its folder"), "{error}");
}
