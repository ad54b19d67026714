//! What the page saves is what the program writes, to the byte, for every starting scene.

use super::bench::Bench;
use serde_json::{Value, json};
use support::files;
use support::program::{stderr, with_scene};

/// What the program prints for a scene.
fn printed(arguments: &[&str], scene: &str) -> Vec<u8> {
    let output = with_scene(arguments, scene.as_bytes());
    assert!(!output.stdout.is_empty(), "{arguments:?}: {}", stderr(&output));
    output.stdout
}

/// The bytes that are written as digits.
fn bytes(digits: &Value) -> Vec<u8> {
    let digits = digits.as_str().unwrap_or_else(|| panic!("no bytes: {digits}")).as_bytes();
    let value = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).expect("digits"), 16).expect("digits");
    digits.chunks(2).map(value).collect()
}

#[test]
#[ignore = "needs Chromium"]
fn files_are_those_of_the_program() {
    let mut bench = Bench::open("bytes");
    let scenes = files::scenes("templates").into_iter().chain(files::scenes("examples"));
    for (name, text) in scenes {
        let is_drawn = serde_json::from_str::<Value>(&text).expect("JSON").get("points").is_some();
        for (format, of, command) in [
            ("svg", "figure", &["draw", "-", "-o", "-"][..]),
            ("tikz", "figure", &["draw", "-", "-o", "-", "--format", "tikz"]),
            ("json", "figure", &["solve", "-"]),
            ("steps", "figure", &["steps", "-"]),
            ("csv", "figure", &["sweep", "-"]),
            ("pdf", "figure", &["draw", "-", "-o", "-", "--format", "pdf"]),
        ] {
            if format == "csv" && is_drawn {
                continue;
            }
            let made = bench.ask("file", &[json!(text), json!({ "format": format, "of": of })]);
            assert!(bytes(&made) == printed(command, &text), "{name}: {format}");
        }
    }
    bench.assert_quiet();
}

/// JSON in which 10 and 10.0 are the same.
fn as_numbers(value: &Value) -> Value {
    match value {
        Value::Number(number) => json!(number.as_f64()),
        Value::Array(values) => values.iter().map(as_numbers).collect(),
        Value::Object(entries) => entries.iter().map(|(key, value)| (key.clone(), as_numbers(value))).collect(),
        other => other.clone(),
    }
}

#[test]
#[ignore = "needs Chromium"]
fn a_check_is_that_of_the_program() {
    let mut bench = Bench::open("check-bytes");
    let folder = bench.folder();
    let pairs = [
        (files::read("examples/figure-2.json"), files::read("examples/paper-as-student.json")),
        (files::read("templates/four-bar.json"), files::read("fuzz/seeds/forms/four-bar-one-off.json")),
        (files::read("templates/slotted-lever.json"), files::read("fuzz/seeds/forms/slotted-lever-mm.json")),
    ];
    for (scene, form) in pairs {
        let path = folder.join("form.json");
        std::fs::write(&path, &form).expect("written");
        let path = path.to_str().expect("UTF-8");
        let options = json!({ "marks": null, "pencil_mm": null, "pencil_degrees": null, "drawn": true });
        let begin = bench.number("performance.now()");
        let checked = bench.ask("check", &[json!(scene), json!(form), options]);
        println!("checked after {:.0} ms", bench.number("performance.now()") - begin);
        let program: Value = serde_json::from_slice(&printed(&["check", "-", path, "--json"], &scene)).expect("JSON");
        assert!(as_numbers(&checked["result"]) == as_numbers(&program), "{}", checked["refused"]);
        let report = String::from_utf8(printed(&["check", "-", path], &scene)).expect("UTF-8");
        assert_eq!(checked["report"].as_str(), Some(report.as_str()));
    }
}
