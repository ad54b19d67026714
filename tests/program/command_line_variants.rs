//! `kinegon check EXERCISES FORMS` from outside: each form against its own exercise; the pages that students get back.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Output;
use support::files;
use support::program::{kinegon, scratch, stderr};

/// The lengths of the couplers of the exercises `four-bar-7-1`, `four-bar-7-2` and `four-bar-7-12`: all else is the
/// four-bar linkage of the templates.
const EXERCISES: [(&str, f64); 3] = [("four-bar-7-1", 140.0), ("four-bar-7-2", 190.0), ("four-bar-7-12", 105.0)];

fn check(arguments: &[&Path], more: &[&str]) -> Output {
    let mut command = kinegon();
    command.arg("check").args(arguments).args(more);
    command.output().expect("the program starts")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

/// The rows of a table by the names of their files.
fn rows(output: &Output) -> BTreeMap<String, BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let rows = reader.deserialize().map(|row| row.expect("a row as wide as its head"));
    rows.map(|row: BTreeMap<String, String>| (row["file"].clone(), row)).collect()
}

/// ω_2 and ω_3 of the four-bar linkage with AB = 60 at 60°, CD = 110, D 160 to the right of A, ω_1 = 10: by closed form.
fn rates(bc: f64) -> [f64; 2] {
    let b = [30.0, 30.0 * libm::sqrt(3.0)];
    let d = [160.0 - b[0], -b[1]];
    let apart = libm::hypot(d[0], d[1]);
    let along = (apart * apart + bc * bc - 110.0 * 110.0) / (2.0 * apart);
    let high = libm::sqrt(bc * bc - along * along);
    let u = d.map(|x| x / apart);
    let c = [b[0] + along * u[0] - high * u[1], b[1] + along * u[1] + high * u[0]];
    // v_B + ω_2 J BC = ω_3 J DC, crossed with one arm each.
    let (p, q) = ([c[0] - b[0], c[1] - b[1]], [c[0] - 160.0, c[1]]);
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    [10.0 * cross(b, q) / -cross(p, q), 10.0 * cross(b, p) / cross(q, p)]
}

fn scene(bc: f64) -> String {
    files::read("templates/four-bar.json").replace("\"BC\": 140", &format!("\"BC\": {bc}"))
}

/// A folder of exercises as `kinegon exercise` writes them.
fn exercises(place: &Path) -> PathBuf {
    let folder = place.join("exercises");
    for (name, bc) in EXERCISES {
        write(&folder.join(name).join("scene.json"), &scene(bc));
        write(&folder.join(name).join("key.json"), "{ \"kinegon_key\": 1 }");
    }
    folder
}

fn write(path: &Path, text: &str) {
    std::fs::create_dir_all(path.parent().expect("it is in a folder")).expect("made");
    std::fs::write(path, text).expect("written");
}

/// A form of the exercise with that coupler, both rates `times` the right ones.
fn form(bc: f64, times: f64, more: &str) -> String {
    let [two, three] = rates(bc).map(|rate| rate * times);
    format!("quantity,value,unit\n{more}positive,counter-clockwise,\nomega(2),{two:.3},\nomega(3),{three:.3},\n")
}

#[test]
fn rates_by_closed_form_are_those_of_the_template() {
    let [two, three] = rates(140.0);
    assert!((two + 2.424_343).abs() < 1e-6 && three > 0.0, "{two} {three}");
}

#[test]
fn each_form_is_held_against_its_own_exercise() {
    let place = scratch("variants");
    let (exercises, forms) = (exercises(&place), place.join("forms"));
    write(&forms.join("Ana.csv"), &form(190.0, 1.0, "name,Ana,\nexercise,four-bar-7-2,\n"));
    write(&forms.join("four-bar-7-12 Ben.csv"), &form(105.0, 1.0, ""));
    write(&forms.join("four-bar-7-1/Cem.csv"), &form(140.0, 1.0, ""));
    write(&forms.join("late/four-bar-7-2/x/Dora.csv"), &form(190.0, 1.0, ""));
    // That of another exercise, and one with wrong values.
    write(&forms.join("four-bar-7-1 Eva.csv"), &form(190.0, 1.0, ""));
    write(&forms.join("four-bar-7-2_Finn.csv"), &form(190.0, 1.5, ""));
    let output = check(&[&exercises, &forms], &[]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(stdout(&output).starts_with("file,exercise,name,passed,values,"), "{}", stdout(&output));
    let rows = rows(&output);
    for (file, exercise, is_off) in [
        ("Ana.csv", "four-bar-7-2", false),
        ("four-bar-7-12 Ben.csv", "four-bar-7-12", false),
        ("four-bar-7-1/Cem.csv", "four-bar-7-1", false),
        ("late/four-bar-7-2/x/Dora.csv", "four-bar-7-2", false),
        ("four-bar-7-1 Eva.csv", "four-bar-7-1", true),
        ("four-bar-7-2_Finn.csv", "four-bar-7-2", true),
    ] {
        let row = &rows[file];
        assert_eq!([&row["exercise"], &row["message"]], [exercise, ""], "{file}");
        assert_eq!(row["off"] != "0", is_off, "{file}");
        // An exercise asks for more than two values: what is not there is not right.
        assert_eq!([row["values"].as_str(), row["passed"].as_str(), row["missing"].as_str()], ["2", "false", "11"]);
    }
    assert_eq!(rows.len(), 6);
    assert_eq!(rows["Ana.csv"]["name"], "Ana");
    assert!(stderr(&output).contains("6 files: 0 passed, 2 off, 0 not understood"), "{}", stderr(&output));
    // One form alone finds its exercise, too, and what is said of it is what its row says.
    let alone = check(&[&exercises, &forms.join("Ana.csv")], &["--json"]);
    assert_eq!(alone.status.code(), Some(1), "{}", stderr(&alone));
    let alone: serde_json::Value = serde_json::from_slice(&alone.stdout).expect("JSON");
    let expected = alone["values"][0]["expected"].as_f64().expect("a number");
    assert!((expected - rates(190.0)[0]).abs() < 1e-9);
}

#[test]
fn a_joint_report_in_json_names_the_exercises_and_that_of_one_scene_does_not() {
    let place = scratch("variants-json");
    let (exercises, forms) = (exercises(&place), place.join("forms"));
    write(&forms.join("four-bar-7-1.csv"), &form(140.0, 1.0, ""));
    let out = place.join("out");
    for name in ["r.json", "r.jsonl", "r.csv"] {
        for _ in 0..2 {
            let output = check(&[&exercises, &forms], &["-o", out.join(name).to_str().expect("UTF-8")]);
            assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
        }
    }
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect("written");
    let json: serde_json::Value = serde_json::from_str(&read("r.json")).expect("JSON");
    assert_eq!(json["rows"][0]["exercise"], "four-bar-7-1");
    assert_eq!(json["summary"]["incomplete"], 1);
    assert_eq!(json["summary"]["unknown"], 0);
    let line: serde_json::Value = serde_json::from_str(read("r.jsonl").trim()).expect("JSON");
    assert_eq!(line, json["rows"][0]);
    let of_one = check(&[&exercises.join("four-bar-7-1/scene.json"), &forms], &["--json"]);
    assert!(!stdout(&of_one).contains("\"exercise\""), "{}", stdout(&of_one));
    // A folder with one scene is one exercise.
    write(&forms.join("Gil.csv"), &form(140.0, 1.0, ""));
    let of_folder = check(&[&exercises.join("four-bar-7-1"), &forms], &[]);
    assert_eq!(of_folder.status.code(), Some(1), "{}", stderr(&of_folder));
    assert_eq!(rows(&of_folder)["Gil.csv"]["exercise"], "four-bar-7-1");
    // A report beside the forms is no form the next time; a form is not written over.
    let report = forms.join("r.csv");
    for _ in 0..2 {
        let output = check(&[&exercises, &forms], &["-o", report.to_str().expect("UTF-8")]);
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        assert!(stderr(&output).contains("2 files: 0 passed, 0 off, 1 not understood"), "{}", stderr(&output));
    }
    let output = check(&[&exercises, &forms], &["-o", forms.join("Gil.csv").to_str().expect("UTF-8")]);
    assert!(stderr(&output).contains("is not overwritten"), "{}", stderr(&output));
}

#[test]
fn what_has_no_exercise_says_which_there_are() {
    let place = scratch("variants-unclear");
    let (exercises, forms) = (exercises(&place), place.join("forms"));
    write(&exercises.join("broken/scene.json"), "{ \"kinegon\": 1, \"title\": 3 }");
    for (file, text) in [
        ("Ana.csv", form(140.0, 1.0, "")),
        ("Ben.csv", form(140.0, 1.0, "exercise,four-bar-7-3,\n")),
        ("four-bar-7-1 four-bar-7-2.csv", form(140.0, 1.0, "")),
        ("four-bar-7-13.csv", form(140.0, 1.0, "")),
        ("four-bar-7-1.csv", "quantity,value\nomega(9),1\n".to_owned()),
        ("four-bar-7-2.json", "{ \"kinegon_measured\": 1, \"valus\": {} }".to_owned()),
        ("broken Cem.csv", form(140.0, 1.0, "")),
        ("good.four-bar-7-1.csv", form(140.0, 1.0, "")),
    ] {
        write(&forms.join(file), &text);
    }
    let output = check(&[&exercises, &forms], &[]);
    assert_eq!(output.status.code(), Some(2));
    let rows = rows(&output);
    for (file, part) in [
        ("Ana.csv", "does not say to which exercise it belongs"),
        ("Ana.csv", "there are broken, four-bar-7-1, four-bar-7-12, four-bar-7-2"),
        ("Ben.csv", "its exercise `four-bar-7-3` is not in"),
        ("four-bar-7-1 four-bar-7-2.csv", "several exercises: four-bar-7-1, four-bar-7-2"),
        ("four-bar-7-13.csv", "does not say to which exercise it belongs"),
        ("four-bar-7-1.csv", "line 2: "),
        ("four-bar-7-2.json", "unknown key `valus`"),
        ("broken Cem.csv", "its exercise broken cannot be solved: "),
    ] {
        assert!(rows[file]["message"].contains(part), "{file}: {}", rows[file]["message"]);
        assert_eq!(rows[file]["passed"], "false");
    }
    assert_eq!(rows["good.four-bar-7-1.csv"]["off"], "0");
    assert!(stderr(&output).contains("8 files: 0 passed, 0 off, 7 not understood"), "{}", stderr(&output));
    let alone = check(&[&exercises, &forms.join("Ana.csv")], &[]);
    assert_eq!(alone.status.code(), Some(2));
    assert!(stderr(&alone).contains("does not say to which exercise"), "{}", stderr(&alone));
}

#[test]
fn a_folder_without_exercises_and_options_of_one_scene_are_refused() {
    let place = scratch("variants-refused");
    let (exercises, forms) = (exercises(&place), place.join("forms"));
    write(&forms.join("four-bar-7-1.csv"), &form(140.0, 1.0, ""));
    write(&place.join("twice/a/scene.json"), &scene(140.0));
    write(&place.join("twice/a.json"), &scene(140.0));
    for (folder, more, part) in [
        (&forms, &[][..], "has no exercises"),
        (&place.join("twice"), &[], "have one name"),
        (&exercises, &["--mode", "1"], "--mode is of one scene"),
        (&exercises, &["--draw", "out"], "--draw draws one form"),
        (&exercises, &["--feedback-format", "html"], "--feedback-format"),
        (&exercises, &["--feedback", "-"], "is no folder"),
    ] {
        let output = check(&[folder, &forms], more);
        assert_eq!(output.status.code(), Some(2), "{part}");
        assert!(output.stdout.is_empty());
        assert!(stderr(&output).contains(part), "{part}: {}", stderr(&output));
    }
    let output = check(&[&exercises], &["--template"]);
    assert!(stderr(&output).contains("--template writes the form of one scene"), "{}", stderr(&output));
    // Scene files side by side are exercises, too; other files are none.
    let flat = place.join("flat");
    write(&flat.join("four-bar-7-1.json"), &scene(140.0));
    write(&flat.join("marks.json"), "{ \"kinegon_marks\": 1 }");
    let output = check(&[&flat, &forms], &[]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
}

#[test]
fn marks_are_those_of_the_exercise_or_of_all() {
    let place = scratch("variants-marks");
    let (exercises, forms) = (exercises(&place), place.join("forms"));
    write(&forms.join("four-bar-7-1.csv"), &form(140.0, 1.0, ""));
    write(&forms.join("four-bar-7-2.csv"), &form(190.0, 1.0, ""));
    let all = place.join("all.json");
    let marks = ["--marks", all.to_str().expect("UTF-8")];
    write(&all, r#"{ "kinegon_marks": 1, "values": { "omega(2)": 1, "alpha(2)": 1 } }"#);
    let earned = |output: &Output| {
        assert_eq!(output.status.code(), Some(1), "{}", stderr(output));
        let rows = rows(output);
        ["four-bar-7-1.csv", "four-bar-7-2.csv"]
            .map(|file| [&rows[file]["marks"], &rows[file]["marks_of"]].map(String::clone))
    };
    // omega(2) is right, alpha(2) is not there.
    assert_eq!(earned(&check(&[&exercises, &forms], &marks)), [["1", "2"], ["1", "2"]]);
    // An own scheme comes before the one for all, and is enough by itself.
    write(
        &exercises.join("four-bar-7-2/marks.json"),
        r#"{ "kinegon_marks": 1, "values": { "omega(2)": 3, "omega(3)": 4 } }"#,
    );
    assert_eq!(earned(&check(&[&exercises, &forms], &marks)), [["1", "2"], ["7", "7"]]);
    assert_eq!(earned(&check(&[&exercises, &forms], &[])), [["", ""], ["7", "7"]]);
    let alone = check(&[&exercises, &forms.join("four-bar-7-2.csv")], &[]);
    assert!(stdout(&alone).ends_with("Marks: 7 of 7\n"), "{}", stdout(&alone));
    // A scheme must fit all to which it is applied.
    write(&all, r#"{ "kinegon_marks": 1, "values": { "omega(7)": 1 } }"#);
    let output = check(&[&exercises, &forms], &marks);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    assert!(stderr(&output).contains("does not fit exercise four-bar-7-1: values.omega(7)"), "{}", stderr(&output));
}

#[test]
fn every_student_gets_a_page() {
    let place = scratch("feedback");
    let (exercises, forms, pages) = (exercises(&place), place.join("forms"), place.join("pages"));
    write(&forms.join("four-bar-7-1/Ana.csv"), &form(140.0, 1.0, "name,Ana <b>,\n"));
    write(&forms.join("four-bar-7-2 Ben.csv"), &form(190.0, 1.5, ""));
    write(&forms.join("Cem.csv"), &form(140.0, 1.0, ""));
    let both = ["--feedback", pages.to_str().expect("UTF-8"), "--feedback-format", "pdf,html"];
    let output = check(&[&exercises, &forms], &[&both[..], &["-o", "-", "--language", "es"]].concat());
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    let all = rows(&output);
    assert_eq!(all.len(), 3);
    let names = |folder: &Path| {
        let entries = std::fs::read_dir(folder).expect("there");
        let mut names: Vec<String> =
            entries.map(|e| e.expect("read").file_name().into_string().expect("UTF-8")).collect();
        names.sort();
        names
    };
    let stems = ["Cem", "four-bar-7-1-Ana", "four-bar-7-2 Ben"];
    let expected = stems.iter().flat_map(|stem| ["html", "pdf"].map(|ending| format!("{stem}.{ending}")));
    assert_eq!(names(&pages), expected.collect::<Vec<_>>());
    let read = |name: &str| std::fs::read_to_string(pages.join(name)).expect("written");
    let ana = read("four-bar-7-1-Ana.html");
    assert!(ana.contains("<html lang=\"es\">") && ana.contains("Ana &lt;b&gt;"));
    assert!(ana.contains("<td>ω<sub>2</sub></td>") && ana.contains("<td>correcto</td>"));
    assert!(!ana.contains("<svg") && !ana.contains("<script"), "nothing is off, so there is no drawing");
    let ben = read("four-bar-7-2 Ben.html");
    assert!(ben.contains("<svg") && ben.contains("FUERA"));
    let off = ben.matches("<tr class=\"off\">").count();
    assert!(off > 0 && all["four-bar-7-2 Ben.csv"]["off"] == off.to_string());
    let cem = read("Cem.html");
    assert!(cem.contains("does not say to which exercise") && cem.contains("Entréguelo"));
    for stem in stems {
        let pdf = std::fs::read(pages.join(format!("{stem}.pdf"))).expect("written");
        assert!(pdf.starts_with(b"%PDF-"), "{stem}");
    }
    // The same again is written over; what somebody else has put there is not, and then nothing is done.
    let again = check(&[&exercises, &forms], &both);
    assert_eq!(again.status.code(), Some(2), "{}", stderr(&again));
    assert_eq!(rows(&again).len(), 3);
    write(&pages.join("Cem.html"), "<p>mine</p>");
    std::fs::remove_file(pages.join("four-bar-7-2 Ben.pdf")).expect("there");
    let refused = check(&[&exercises, &forms], &both);
    assert_eq!(refused.status.code(), Some(2));
    assert!(refused.stdout.is_empty());
    assert!(stderr(&refused).contains("Cem.html is there already"), "{}", stderr(&refused));
    assert_eq!(read("Cem.html"), "<p>mine</p>");
    assert!(!pages.join("four-bar-7-2 Ben.pdf").exists());
}

#[test]
fn pages_are_of_one_exercise_and_of_one_form_too() {
    let place = scratch("feedback-one");
    let (exercises, forms) = (exercises(&place), place.join("forms"));
    let scene = exercises.join("four-bar-7-1/scene.json");
    write(&forms.join("Ana.csv"), &form(140.0, 1.5, ""));
    write(&forms.join("ana.json"), "{ \"kinegon_measured\": 1, \"values\": { \"omega(2)\": \"-2.42\" } }");
    let marks = place.join("marks.json");
    write(&marks, r#"{ "kinegon_marks": 1, "values": { "omega(2)": 3 } }"#);
    let folder = |name: &str| place.join(name);
    let page = |form: &Path, name: &str, more: &[&str]| {
        let pages = folder(name);
        let options = ["--feedback", pages.to_str().expect("UTF-8"), "--feedback-format", "html"];
        let output = check(&[&scene, form], &[&options[..], more].concat());
        (pages, output)
    };
    let (pages, output) = page(&forms, "class", &["--marks", marks.to_str().expect("UTF-8")]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let marks = rows(&output);
    assert_eq!(marks["ana.json"]["marks"], "3");
    for (file, page) in [("Ana.csv", "Ana-csv.html"), ("ana.json", "ana-json.html")] {
        let text = std::fs::read_to_string(pages.join(page)).expect("written");
        let said = format!("Marks: {} of 3", marks[file]["marks"]);
        assert!(text.contains(&said), "{file}: {said}");
    }
    let (pages, output) = page(&forms.join("ana.json"), "one", &[]);
    // One value of many is there.
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(pages.join("ana.html").is_file());
}
