//! `kinegon check` from outside: forms, verdicts, exit codes, and values that nobody can understand.

use crate::support::program::{kinegon, scratch, stderr};
use std::process::Output;

const SCENE: &str = "examples/figure-2.json";

/// Checks a form with that text against Figure 2.
fn check(name: &str, text: &str, more: &[&str]) -> Output {
    // A folder for each: tests run side by side.
    let file = scratch(&format!("check-{name}")).join(name);
    std::fs::write(&file, text).expect("it can be written");
    let mut command = kinegon();
    command.args(["check", SCENE]).arg(&file).args(more);
    command.output().expect("the program starts")
}

fn form(inside: &str) -> String {
    format!(r#"{{ "kinegon_measured": 1, {inside} }}"#)
}

/// The message of what is refused, on one line.
fn refused(name: &str, text: &str) -> String {
    let output = check(name, text, &[]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(output.stdout.is_empty(), "{name}");
    said.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn right_values_pass_in_any_unit_scale_and_sense() {
    for (name, text) in [
        ("units.json", form(r#""values": { "L(B,S3)": 370.96, "vplan(s3,b)": 59.41, "omega(4)": -0.4747 }"#)),
        (
            "metres.json",
            form(
                r#""values": { "L(B,S3)": { "value": 0.37096, "unit": "m" }, "omega(4)": { "value": -4.533, "unit": "rpm" } }"#,
            ),
        ),
        ("paper.json", form(r#""mu_l": 2, "mu_v": 0.5, "values": { "L(B,S3)/mu": 185.5, "vplan(b,s3)/mu": 118.8 }"#)),
        (
            "all-mm.json",
            form(r#""in": "mm", "mu_l": 2, "mu_v": 0.5, "values": { "L(B,S3)": 185.5, "vplan(b,s3)": "118.8" }"#),
        ),
        ("clockwise.json", form(r#""positive": "clockwise", "values": { "omega(4)": 0.475, "alpha(4)": -0.448 }"#)),
        ("magnitudes.json", form(r#""values": { "omega(4)": 0.475, "a_r(3/2)": 58.4 }"#)),
        (
            "table.csv",
            "quantity,value,unit\nmu_v,0.5,\nL(B,S3),370.96,mm\n\"vplan(b,s3)/mu\",118.8,\nomega(4),-0.475,rad/s\n"
                .to_owned(),
        ),
        ("comma.csv", "quantity;value\nL(B,S3);370,96\nomega(4);-0,475\n".to_owned()),
        ("points.csv", "mu_v,1\nvelocity:p,10,20\nvelocity:b,44.2,114.0\nvelocity:s3,4.5,158.1\n".to_owned()),
        ("points-comma.csv", "mu_v;1\nvelocity:p;10;20\nvelocity:b;44,2;114,0\nvelocity:s3;4,5;158,1\n".to_owned()),
        // Turned by 90° and shifted: b 100 mm from p at −20°.
        (
            "points.json",
            form(r#""mu_v": 1, "points": { "velocity": { "p": [10, 20], "b": [44.2, 114.0], "s3": [4.5, 158.1] } }"#),
        ),
    ] {
        let output = check(name, &text, &[]);
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(output.status.code(), Some(0), "{name}: {said}{}", stderr(&output));
    }
}

#[test]
fn a_wrong_value_fails_and_json_says_the_same() {
    let text = form(r#""values": { "L(B,S3)": 370.96, "vplan(b,s3)": 79.41 }"#);
    assert_eq!(check("wrong.json", &text, &[]).status.code(), Some(1));
    let output = check("wrong-json.json", &text, &["--json", "--depth", "1"]);
    assert_eq!(output.status.code(), Some(1));
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(result["passed"], false);
    let verdicts: Vec<&str> =
        result["values"].as_array().expect("a list").iter().filter_map(|v| v["verdict"].as_str()).collect();
    assert_eq!(verdicts, ["right", "off"]);
}

#[test]
fn scales_of_a_drawing_that_is_not_asked_for_are_refused() {
    let text = form(r#""values": { "L(B,S3)": 370.96 }"#);
    for more in [["--mu-v", "2"], ["--page", "a3"], ["--style", "print"]] {
        let output = check("no-drawing.json", &text, &more);
        assert_eq!(output.status.code(), Some(2), "{more:?}");
        assert!(stderr(&output).contains("--draw out/"), "{more:?}");
    }
}

#[test]
fn a_mirrored_plan_is_told() {
    // The points of the right plan, x the other way.
    let places = r#""p": [90, 20], "b": [55.8, 114.0], "s3": [95.5, 158.1]"#;
    let text = form(&format!(r#""mu_v": 1, "points": {{ "velocity": {{ {places} }} }}"#));
    let output = check("mirrored.json", &text, &[]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("velocity plan are the mirror image"), "{said}");
    let output = check("mirrored-json.json", &text, &["--json"]);
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(result["mirrored"], serde_json::json!(["velocity"]));
    assert_eq!(result["passed"], false);
}

#[test]
fn clockwise_values_taken_for_counter_clockwise_are_off() {
    let text = form(r#""positive": "counter-clockwise", "values": { "omega(4)": 0.475 }"#);
    let output = check("sense.json", &text, &["--depth", "1"]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(1));
    assert!(said.contains("wrong sense"), "{said}");
}

#[test]
fn what_is_not_understood_is_said_clearly() {
    for (name, text, parts) in [
        ("name.json", form(r#""values": { "omga(4)": 1 }"#), vec!["`omga(4)` is no quantity", "omega(4)"]),
        ("point.json", form(r#""values": { "vplan(b,s4)": 1 }"#), vec!["no plan point `s4`", "did you mean `s3`"]),
        (
            "far-point.json",
            form(r#""mu_v": 1, "points": { "velocity": { "p": [0, 0], "zz": [1, 2] } }"#),
            vec!["no plan point `zz`", "--template` lists the names"],
        ),
        (
            "far-name.json",
            form(r#""values": { "speed": 1 }"#),
            vec!["`speed` is no quantity", "help: `kinegon check SCENE --template`"],
        ),
        (
            "unit.json",
            form(r#""values": { "omega(4)": { "value": 1, "unit": "mm" } }"#),
            vec!["`mm` is no unit of an angular velocity", "rad/s"],
        ),
        ("scale.json", form(r#""values": { "vplan(b,s3)/mu": 59 }"#), vec!["mu_v is missing", "add mu_v"]),
        ("zero.json", form(r#""mu_v": 0, "values": { "vplan(b,s3)/mu": 59 }"#), vec!["mu_v is no scale"]),
        (
            "twice.json",
            form(r#""mu_v": 1, "values": { "vplan(b,s3)/mu": 59, "vplan(b,s3)": 69 }"#),
            vec!["two values", "59", "69"],
        ),
        ("empty.json", form(r#""values": { "vplan(b,s3)": "" }"#), vec!["the form is empty", "--template"]),
        ("digits.json", form(r#""values": { "vplan(b,s3)": "59,4 mm" }"#), vec!["`59,4 mm` is no number"]),
        ("pole.json", form(r#""mu_v": 1, "points": { "velocity": { "b": [0, 0] } }"#), vec!["do not have its pole p"]),
        ("text.csv", "quantity,value\nL(B,S3),long\n".to_owned(), vec!["line 2", "`long` is no number"]),
        ("nan.csv", "quantity,value\nL(B,S3),NaN\n".to_owned(), vec!["line 2", "`NaN` is no number"]),
        ("twice.csv", "L(B,S3),370\nL(S3,B),248\n".to_owned(), vec!["line 2", "two values"]),
        (
            "coordinate.csv",
            "mu_v,1\nvelocity:p,0,0\nvelocity:b,1,\n".to_owned(),
            vec!["line 3", "no coordinate", "velocity:b,114,-2.7"],
        ),
        ("key.json", form(r#""valus": {}"#), vec!["unknown key `valus`", "values"]),
    ] {
        let said = refused(name, &text);
        let is_far = name.starts_with("far-");
        assert!(!is_far || !said.contains("nearest") && !said.contains("did you mean"), "{said}");
        for part in parts {
            assert!(said.contains(part), "{name}: {said}");
        }
    }
    let large = "L(B,S3),370.96\n".repeat(7_000_000);
    let said = refused("large.csv", &large);
    assert!(said.contains("larger than 4 MB"), "{said}");
}

#[test]
fn the_empty_form_names_every_quantity_of_the_steps_and_is_seen_to_be_empty() {
    let print = |more: &[&str]| {
        let output = kinegon().args(["check", SCENE]).args(more).output();
        let output = output.expect("the program starts");
        assert!(output.status.success(), "{}", stderr(&output));
        String::from_utf8(output.stdout).expect("text")
    };
    let json = print(&["--template"]);
    let csv = print(&["--template", "csv"]);
    let names = ["L(B,S3)", "vplan(p,b)", "vplan(b,s3)", "omega(4)", "aplan(b,k_b3)", "aplan(k_b3,n_b3)", "alpha(5)"];
    let mut last = [0, 0];
    for name in names {
        for (place, text) in last.iter_mut().zip([&json, &csv]) {
            let at = text.find(&format!("\"{name}\"")).unwrap_or_else(|| panic!("{name}"));
            assert!(at > *place, "{name} stands in the order of the steps");
            *place = at;
        }
    }
    assert!(refused("form.json", &json).contains("empty"));
    assert!(refused("form.csv", &csv).contains("empty"));
}

/// The numbers of Quintero et al. (2011) as they are printed, taken for a student's: word for word.
#[test]
fn the_paper_as_a_student() {
    let output = kinegon().args(["check", SCENE, "examples/paper-as-student.json"]).output();
    let output = output.expect("the program starts");
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stdout).expect("text");
    let start = said.find("No single mistake").expect("more than one mistake");
    let diagnosis = &said[start..];
    let expected = include_str!("../files/paper-as-student.txt");
    assert_eq!(diagnosis.trim(), expected.trim(), "\n{diagnosis}");
    let off: Vec<&str> =
        said.lines().filter(|l| l.ends_with("OFF")).filter_map(|l| l.split_whitespace().next()).collect();
    assert_eq!(off, ["L(B,S3)", "v(B/A).size", "a_r(3/2)"]);
}
