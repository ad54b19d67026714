//! Texts of strangers from outside: whatever titles, labels, names of files, students and quantities say, a terminal obeys
//! none of it, a spreadsheet finds no formula, and every file can be read back.

use serde_json::{Value, json};
use std::path::Path;
use support::case::{Case, Outcome, found};
use support::files;
use support::outputs;
use support::program::{kinegon, scratch, stderr, with_scene};

/// What a terminal would obey.
const ESCAPES: &str = "\u{1b}]0;owned\u{7}\u{1b}[31m\u{9b}2J\u{202e}x\u{2066}\u{2028}\u{85}\u{7f}\nnext";

/// The four-bar linkage of the starting scenes, changed.
fn scene(change: impl FnOnce(&mut Value)) -> String {
    let mut scene = serde_json::from_str(&files::read("templates/four-bar.json")).expect("it is JSON");
    change(&mut scene);
    scene.to_string()
}

/// Runs a case in a folder of its own and judges it.
fn run(text: &str, folder: &Path) -> Outcome {
    let case = Case::read(text).expect("a case");
    case.lay_out(folder);
    let before = found(folder);
    let output = kinegon().args(&case.arguments).current_dir(folder).output().expect("the program starts");
    let outcome = Outcome { code: output.status.code(), stdout: output.stdout, stderr: output.stderr };
    case.judge(&outcome, folder, &before);
    outcome
}

#[test]
fn what_the_fuzzer_found_ends_well() {
    for name in files::list("tests/fuzzed/command_lines") {
        run(&files::read(&format!("tests/fuzzed/command_lines/{name}")), &scratch("strangers-fuzzed"));
    }
}

#[test]
fn no_text_of_a_scene_reaches_a_terminal_as_it_is() {
    let hostile = scene(|scene| {
        scene["title"] = ESCAPES.into();
        scene["figure"] = json!({ "labels": { "B": ESCAPES, "2": ESCAPES }, "trace": ["C"] });
    });
    for arguments in [&["steps"][..], &["solve"], &["structure"], &["modes"], &["sweep", "-o", "-", "--step", "90"]] {
        let output = with_scene(&[arguments, &["-"]].concat(), hostile.as_bytes());
        assert!(output.status.success(), "{arguments:?}: {}", stderr(&output));
        outputs::terminal(&output.stdout);
        outputs::message(&output.stderr);
    }
    // Errors with the text around their place.
    let broken = hostile.replacen("\"units\"", "\"unts\\u001b[31m\u{9b}31m\u{202e}\"", 1);
    let output = with_scene(&["solve", "-"], broken.as_bytes());
    assert_eq!(output.status.code(), Some(2));
    outputs::message(&output.stderr);
}

#[test]
fn no_argument_reaches_a_terminal_as_it_is() {
    let good = scene(|_| ());
    let long = "x".repeat(100_000);
    for odd in [ESCAPES, &long] {
        for arguments in [
            vec![odd],
            vec!["draw", "-", "--page", odd],
            vec!["draw", "-", "--style", odd],
            vec!["draw", "-", "--trace", odd, "-o", "-"],
            vec!["app", odd],
            vec!["draw", "-", "--steps", odd],
            vec!["draw", "-", "--mu-l", odd],
            vec!["sweep", "-", "--want", odd],
            vec!["sweep", "-", "--step", odd],
            vec!["curves", "-", "--want", odd],
            vec!["curves", "-", "--path", odd],
            vec!["solve", odd],
            vec!["steps", odd],
            vec!["check", odd, odd],
            vec!["exercise", odd, "-o", "nowhere"],
            vec!["new", odd],
            vec!["schema", odd],
        ] {
            let output = with_scene(&arguments, good.as_bytes());
            assert!(!output.status.success(), "{:?}", arguments[0]);
            let said = outputs::message(&output.stderr);
            assert!(!said.is_empty() && output.stdout.is_empty());
        }
    }
}

#[test]
fn a_blank_title_and_blank_labels_are_left_out_of_every_file() {
    for (number, blank) in ["", " ", "\n", "\u{200b}\u{202e}"].into_iter().enumerate() {
        let text = scene(|scene| {
            scene["title"] = blank.into();
            scene["figure"] = json!({ "labels": { "B": blank, "3": blank } });
        });
        let case = json!({
            "arguments": ["draw", "scene.json", "-o", "out/", "--format", "svg,pdf,tikz,html"],
            "files": { "scene.json": text },
        });
        let folder = scratch(&format!("strangers-blank-{number}"));
        let outcome = run(&case.to_string(), &folder);
        assert_eq!(outcome.code, Some(0), "{}", String::from_utf8_lossy(&outcome.stderr));
        assert_eq!(found(&folder).len(), 5);
        let svg = std::fs::read_to_string(folder.join("out/scene.svg")).expect("it was written");
        assert!(!svg.contains("<title>"), "{blank:?}");
    }
}

/// Names of students, and what stands in their cells.
const NAMES: [(&str, &str); 7] = [
    ("=HYPERLINK(\"x\")", "'=HYPERLINK(\"x\")"),
    ("\u{ff1d}1+1", "'\u{ff1d}1+1"),
    ("\u{200b}=1+1", "\u{200b}'=1+1"),
    ("Ana;=1+1", "Ana;'=1+1"),
    ("@SUM", "'@SUM"),
    ("-12.5", "-12.5"),
    ("O\u{2019}Neil-B.", "O\u{2019}Neil-B."),
];

#[test]
fn no_cell_of_a_report_is_a_formula() {
    let folder = scratch("strangers-cells");
    for (number, (name, _)) in NAMES.into_iter().enumerate() {
        let form = json!({ "kinegon_measured": 1, "name": name, "values": { "omega(3)": 1 } });
        std::fs::write(folder.join(format!("{number}.json")), form.to_string()).expect("it can be written");
    }
    let broken = "=cmd\u{1b}[31m\u{202e};=1.csv";
    std::fs::write(folder.join(broken), "\"=1+1\u{1b}[31m\",7\n").expect("it can be written");
    let output =
        kinegon().args(["check", "templates/four-bar.json", "--depth", "1"]).arg(&folder).output().expect("it starts");
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    let table = outputs::terminal(&output.stdout);
    outputs::csv(&table);
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let names: Vec<String> = reader.records().map(|row| row.expect("a row")[1].to_owned()).collect();
    for ((_, expected), name) in NAMES.iter().zip(&names) {
        assert_eq!(name, expected);
    }
}

#[test]
fn scales_of_no_paper_leave_no_infinity() {
    for mu in [5e-324, 1e-290, 1e100] {
        let text = scene(|scene| scene["figure"] = json!({ "mu_v": mu, "mu_a": mu, "mu_l": 2 }));
        let files = json!({ "scene.json": text });
        for (number, arguments) in [
            vec!["steps", "scene.json"],
            vec!["solve", "scene.json", "--pencil"],
            vec!["draw", "scene.json", "-o", "o/", "--worksheet", "--format", "svg"],
            vec!["draw", "scene.json", "-o", "o/", "--steps", "--format", "svg"],
        ]
        .into_iter()
        .enumerate()
        {
            let case = json!({ "arguments": arguments, "files": files });
            run(&case.to_string(), &scratch(&format!("strangers-scales-{number}")));
        }
    }
}
