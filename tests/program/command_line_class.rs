//! `kinegon check SCENE FOLDER` from outside: the forms of a class, some of them broken, with mistakes put in; marks.

use kinegon::check::{Measured, Mistake, Student};
use std::path::{Path, PathBuf};
use std::process::Output;
use support::files;
use support::program::{kinegon, scratch, stderr};
use support::random::Random;
use support::stages::{answer_key, solved};

const LEVER: &str = "templates/slotted-lever.json";
const FOUR_BAR: &str = "templates/four-bar.json";

/// What a careful hand is off by, in mm and degrees.
const HAND: [f64; 2] = [0.2, 0.2];

fn run(scene: &str, form: &Path, more: &[&str]) -> Output {
    let mut command = kinegon();
    command.args(["check", scene]).arg(form).args(more);
    command.output().expect("the program starts")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

/// The rows of a table by the names of its columns.
fn rows(text: &str) -> Vec<std::collections::BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let rows = reader.deserialize();
    rows.map(|row| row.expect("a row as wide as its head")).collect()
}

fn form(measured: &Measured, name: &str) -> String {
    let values = measured.values.iter();
    let values = values.map(|v| (v.name.clone(), v.text.clone().into()));
    let values: serde_json::Map<String, serde_json::Value> = values.collect();
    let mut form = serde_json::json!({ "kinegon_measured": 1, "name": name, "values": values });
    for (sheet, mu) in measured.mu.given() {
        form[sheet.facts().scale_key] = mu.into();
    }
    form.to_string()
}

/// A folder with the drawings of nine students of the slotted lever: of each five have drawn well, three have forgotten the same Coriolis
/// acceleration, one has laid a normal acceleration off outward. The steps of both mistakes.
fn class(name: &str) -> (PathBuf, [usize; 2]) {
    let folder = scratch(name);
    let solution = solved(&files::read(LEVER)).expect("a good scene");
    let drawn = answer_key(&solution, 1);
    let student = Student::new(&drawn).expect("it can be drawn");
    let planted = [Mistake::CoriolisForgotten, Mistake::NormalOutward];
    let planted = planted.map(|m| student.ways(m).swap_remove(0));
    let mut random = Random(17);
    for number in 0..9 {
        let mistakes = match number {
            1 | 4 | 6 => vec![&planted[0]],
            3 => vec![&planted[1]],
            _ => vec![],
        };
        let measured = student.draw(&mistakes, HAND, &mut || random.within(1.0), &[]);
        let text = form(&measured, &format!("Student {number}"));
        std::fs::write(folder.join(format!("{number}.json")), text).expect("written");
    }
    (folder, planted.map(|p| p.step))
}

#[test]
fn each_student_has_a_row_and_the_class_a_summary() {
    let (folder, steps) = class("class-good");
    let output = run(LEVER, &folder, &["--depth", "1"]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let text = stdout(&output);
    let rows = rows(&text);
    assert_eq!(rows.len(), 9);
    for (number, row) in rows.iter().enumerate() {
        assert_eq!(row["file"], format!("{number}.json"));
        assert_eq!(row["name"], format!("Student {number}"));
        let (mistake, step) = match number {
            1 | 4 | 6 => ("coriolis-forgotten", steps[0].to_string()),
            3 => ("normal-outward", steps[1].to_string()),
            _ => ("", String::new()),
        };
        assert_eq!(row["mistake"], mistake, "{text}");
        assert_eq!(row["step"], step, "{text}");
        assert_eq!(row["passed"], mistake.is_empty().to_string());
        assert_eq!(row["done"].is_empty(), mistake.is_empty());
        assert_eq!(row["off"] == "0", mistake.is_empty());
        let count = |name: &str| row[name].parse::<usize>().expect("a number");
        assert_eq!(count("right") + count("within") + count("off"), count("values"));
        assert_eq!(row["message"], "");
        assert!(!row.contains_key("marks"));
    }
    let said = stderr(&output);
    let common = format!("3 of 9: step {}, the Coriolis acceleration", steps[0]);
    assert!(said.contains("9 files: 5 passed, 4 off, 0 not understood"), "{said}");
    assert!(said.contains(&common), "{said}");
    assert!(!said.contains("1 of 9"), "{said}");
    let spanish = run(LEVER, &folder, &["--depth", "1", "--language", "es"]);
    let common = format!("3 de 9: paso {}, ", steps[0]);
    assert!(stderr(&spanish).contains(&common), "{}", stderr(&spanish));
}

#[test]
fn the_report_comes_in_three_forms_that_say_the_same() {
    let (folder, _) = class("class-forms");
    let out = scratch("class-forms-out");
    let read = |name: &str| {
        let output = run(LEVER, &folder, &["--depth", "1", "-o", out.join(name).to_str().expect("UTF-8")]);
        assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
        assert!(output.stdout.is_empty());
        std::fs::read_to_string(out.join(name)).expect("it is written")
    };
    let (csv, json, lines) = (read("r.csv"), read("r.json"), read("r.jsonl"));
    let whole: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let lines: Vec<serde_json::Value> = lines.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
    assert_eq!(whole["rows"].as_array(), Some(&lines));
    assert_eq!(whole["kinegon_class"], 1);
    assert_eq!(whole["summary"]["passed"], 5);
    assert_eq!(whole["summary"]["commonest"][0]["count"], 3);
    for (row, json) in rows(&csv).iter().zip(&lines) {
        for key in ["values", "right", "within", "off", "passed"] {
            assert_eq!(row[key], json[key].to_string(), "{key}");
        }
        assert_eq!(row["mistake"], json["first"]["mistake"].as_str().unwrap_or(""));
    }
    let shown = run(LEVER, &folder, &["--depth", "1", "--json"]);
    assert_eq!(stdout(&shown), json);
    assert_eq!(stdout(&run(LEVER, &folder, &["--depth", "1", "-o", "-"])), csv);
    // What a check by itself says.
    let single = run(LEVER, &folder.join("4.json"), &["--depth", "1", "--json"]);
    let single: serde_json::Value = serde_json::from_slice(&single.stdout).expect("JSON");
    let mistakes = &single["diagnosis"]["mistakes"][0];
    assert_eq!(lines[4]["first"]["mistake"], mistakes["mistake"]);
    assert_eq!(lines[4]["first"]["step"], mistakes["step"]);
    assert_eq!(lines[4]["done"], mistakes["done"]);
    assert_eq!(lines[4]["probability"], single["diagnosis"]["probability"]);
}

#[test]
fn broken_files_are_rows() {
    let folder = scratch("class-broken");
    let write = |name: &str, bytes: &[u8]| {
        std::fs::write(folder.join(name), bytes).expect("it can be written");
    };
    let good = br#"{ "kinegon_measured": 1, "positive": "counter-clockwise", "values": { "vplan(p,b)": 600 } }"#;
    write("a.JSON", good);
    write("b.csv", b"quantity,value\nvplan(p,b),600\nomega(9),2\n");
    write("c.csv", b"PK\x03\x04\x00\x01");
    std::fs::create_dir(folder.join("d.csv")).expect("made");
    write("e.json", b"{ \"kinegon_measured\": 1, \"valus\": {} }");
    write("f.json", b"");
    std::fs::File::create(folder.join("g.csv")).and_then(|file| file.set_len(100 << 20)).expect("a hole of 100 MB");
    write("h.json", br#"{ "kinegon_measured": 1, "name": "=HYPERLINK(\"x\")", "values": { "vplan(p,b)": 600 } }"#);
    let long = format!("quantity,value\n{}(3),1\n", "x".repeat(1 << 20));
    write("i.csv", long.as_bytes());
    // What is handed in with another ending is not read, and says so.
    write("j.txt", good);
    write("k.xlsx", b"PK\x03\x04\x00\x01");
    write("l.jpg", b"\xff\xd8\xff");
    write("m", good);
    // Ignored: hidden files, files that systems and this program put there, subfolders.
    write(".hidden.json", b"{}");
    for own in ["README", "readme.md", "Thumbs.db", "desktop.ini", "~$k.xlsx", "Ana-2-check.png"] {
        write(own, b"x");
    }
    write("report.jsonl", b"{\"file\":\"a.JSON\"}\n");
    write("a.html", format!("<!-- {} -->", kinegon::format::FEEDBACK_MARK).as_bytes());
    std::fs::create_dir(folder.join("sub")).expect("made");
    std::fs::write(folder.join("sub/z.json"), good).expect("written");
    let output = run(FOUR_BAR, &folder, &["--depth", "1"]);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    let text = stdout(&output);
    let rows = rows(&text);
    let names: Vec<&str> = rows.iter().map(|row| row["file"].as_str()).collect();
    let expected = [
        "a.JSON", "b.csv", "c.csv", "d.csv", "e.json", "f.json", "g.csv", "h.json", "i.csv", "j.txt", "k.xlsx",
        "l.jpg", "m",
    ];
    assert_eq!(names, expected);
    for (index, part) in [
        (0, ""),
        (1, "line 3: "),
        (2, "is no text"),
        (3, "a folder"),
        (4, "unknown key `valus`"),
        (5, ""),
        (6, "larger than 4 MB"),
        (7, ""),
        (8, "is no quantity"),
        (9, "`.json` or `.csv`"),
        (10, "`.json` or `.csv`"),
        (11, "photograph"),
        (12, "`.json` or `.csv`"),
    ] {
        let message = &rows[index]["message"];
        assert!(message.contains(part) || (index == 8 && message.ends_with('…')), "{index}: {message}");
        assert_eq!(message.is_empty(), [0, 7].contains(&index), "{message}");
        assert!(!message.contains("class-broken"), "{message}");
        assert!(message.chars().count() <= 301, "{message}");
        // One value is not all that is asked for.
        assert_eq!(rows[index]["right"], if [0, 7].contains(&index) { "1" } else { "" });
        assert_eq!(rows[index]["passed"], "false");
    }
    // What a spreadsheet would take for a formula.
    assert_eq!(rows[7]["name"], "'=HYPERLINK(\"x\")");
    assert!(stderr(&output).contains("13 files: 0 passed, 0 off, 11 not understood"));
}

#[cfg(unix)]
#[test]
fn a_pipe_is_not_waited_for() {
    let folder = scratch("class-pipe");
    let made = std::process::Command::new("mkfifo").arg(folder.join("x.json")).status();
    assert!(made.expect("mkfifo runs").success());
    let output = run(FOUR_BAR, &folder, &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(rows(&stdout(&output))[0]["message"].contains("special"));
}

/// A pipe in place of an exercise's file is refused: Kinegon neither waits for it nor skips it.
#[cfg(unix)]
#[test]
fn a_pipe_is_no_file_of_an_exercise() {
    let folder = scratch("class-exercise-pipe");
    let [exercises, forms] = ["exercises", "forms"].map(|name| folder.join(name));
    std::fs::create_dir_all(exercises.join("one")).expect("made");
    std::fs::create_dir_all(exercises.join("other")).expect("made");
    std::fs::create_dir_all(&forms).expect("made");
    std::fs::copy(FOUR_BAR, exercises.join("one/scene.json")).expect("copied");
    std::fs::copy(FOUR_BAR, exercises.join("other/scene.json")).expect("copied");
    std::fs::write(forms.join("one.csv"), "omega(2),-2.424\n").expect("written");
    for file in ["one/marks.json", "other/scene.json", "x.json"] {
        let path = exercises.join(file);
        drop(std::fs::remove_file(&path));
        assert!(std::process::Command::new("mkfifo").arg(&path).status().expect("mkfifo runs").success());
        for given in [exercises.as_path(), path.parent().expect("a folder")] {
            let output = run(given.to_str().expect("UTF-8"), &forms, &[]);
            assert_eq!(output.status.code(), Some(2), "{file}: {}", stdout(&output));
            assert!(
                stderr(&output).contains(file) && stderr(&output).contains("is a pipe or a device"),
                "{}",
                stderr(&output)
            );
        }
        std::fs::remove_file(&path).expect("removed");
        std::fs::copy(FOUR_BAR, exercises.join("other/scene.json")).expect("copied");
    }
}

/// What a student's link leads to outside of its folder is not read: neither a form, a drawing nor a photograph, nor a file of an exercise.
#[cfg(unix)]
#[test]
fn links_out_of_a_folder_are_not_followed() {
    use std::os::unix::fs::symlink;
    let folder = scratch("class-links");
    for inside in ["forms", "secret", "photos", "exercises/one"] {
        std::fs::create_dir_all(folder.join(inside)).expect("made");
    }
    std::fs::write(folder.join("secret/secret.csv"), "hunter2,toor\n").expect("written");
    std::fs::write(folder.join("secret/drawing.json"), r#"{ "kinegon_drawing": 1, "did": ["hunter2"] }"#)
        .expect("written");
    std::fs::write(folder.join("forms/own.csv"), "omega(2),-2.424\n").expect("written");
    symlink("../secret/secret.csv", folder.join("forms/a.csv")).expect("made");
    symlink("../secret/drawing.json", folder.join("forms/b.json")).expect("made");
    symlink("own.csv", folder.join("forms/c.csv")).expect("made");
    let pages = folder.join("pages/");
    let pages = ["--feedback", pages.to_str().expect("UTF-8"), "--feedback-format", "html"];
    let output = run(FOUR_BAR, &folder.join("forms"), &pages);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    let told = rows(&stdout(&output));
    for (row, is_read) in told.iter().zip([false, false, true, true]) {
        assert_eq!(row["message"].contains("link to a file outside of its folder"), !is_read, "{row:?}");
    }
    for page in ["a.html", "b.html"] {
        let page = std::fs::read_to_string(folder.join("pages").join(page)).expect("there is a page");
        assert!(!page.contains("hunter2") && !page.contains("toor"), "{page}");
    }
    assert!(!stdout(&output).contains("hunter2"));
    // A photograph, and the files of an exercise.
    std::fs::write(folder.join("secret/sheet.jpg"), "hunter2").expect("written");
    symlink("../secret/sheet.jpg", folder.join("photos/Ana-1.jpg")).expect("made");
    let forms = folder.join("out");
    let output = run(FOUR_BAR, &folder.join("photos"), &["-o", forms.to_str().expect("UTF-8")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stdout(&output).contains("link to a file outside"), "{}", stdout(&output));
    std::fs::copy(FOUR_BAR, folder.join("secret/scene.json")).expect("copied");
    for file in ["scene.json", "marks.json"] {
        let own = folder.join("exercises/one");
        std::fs::copy(FOUR_BAR, own.join("scene.json")).expect("copied");
        drop(std::fs::remove_file(own.join(file)));
        symlink("../../secret/scene.json", own.join(file)).expect("made");
        let output = run(folder.join("exercises").to_str().expect("UTF-8"), &folder.join("forms"), &[]);
        assert_eq!(output.status.code(), Some(2), "{file}");
        assert!(stderr(&output).contains("link to a file outside"), "{file}: {}", stderr(&output));
        std::fs::remove_file(own.join(file)).expect("removed");
    }
}

#[test]
fn a_class_of_good_drawings_passes_and_an_empty_folder_is_misuse() {
    let folder = scratch("class-empty");
    let output = run(FOUR_BAR, &folder, &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    assert!(stderr(&output).contains("has no forms to check"), "{}", stderr(&output));
    // With the scene itself in the folder.
    let asked = files::read(FOUR_BAR).replacen('{', r#"{ "form": { "omega(2)": 1 },"#, 1);
    std::fs::write(folder.join("scene.json"), asked).expect("written");
    std::fs::write(folder.join("x.csv"), "omega(2),-2.424\n").expect("written");
    let scene = folder.join("scene.json");
    let scene = scene.to_str().expect("UTF-8");
    let output = run(scene, &folder, &[]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(rows(&stdout(&output)).len(), 1);
    // A report beside the forms is none of them the next time, and no form is written over.
    let report = folder.join("report.csv");
    let report = report.to_str().expect("UTF-8");
    for _ in 0..2 {
        let output = run(scene, &folder, &["-o", report]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert!(stderr(&output).contains("1 file: 1 passed"));
    }
    for (name, part) in
        [("x.csv", "is not overwritten"), ("scene.json", "is not overwritten"), ("x.ods", "known endings")]
    {
        let place = folder.join(name);
        let output = run(scene, &folder, &["-o", place.to_str().expect("UTF-8")]);
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert!(stderr(&output).contains(part), "{name}: {}", stderr(&output));
    }
    let kept = std::fs::read_to_string(folder.join("x.csv")).expect("there");
    assert_eq!(kept, "omega(2),-2.424\n");
}

/// The four-bar linkage with ω in place of ω² in the normal part along BC: the values by closed form, the marks counted by hand.
#[test]
fn marks_follow_a_mistake_through() {
    let folder = scratch("class-marks");
    let scene = folder.join("scene.json");
    let figure = r#""figure": { "mu_l": 2.5, "mu_v": 5, "mu_a": 50,"#;
    std::fs::write(&scene, files::read(FOUR_BAR).replace(r#""figure": {"#, figure)).expect("written");
    let scene = scene.to_str().expect("UTF-8");
    let [b, c] = joints();
    let turned = |v: [f64; 2]| [-v[1], v[0]];
    let (cb, cd) = ([c[0] - b[0], c[1] - b[1]], [c[0] - 160.0, c[1]]);
    // ω_2 J CB − ω_3 J CD = −v_B, and the same for α with what the normal parts leave.
    let solved = |right: [f64; 2]| {
        let (p, q) = (turned(cb), turned(cd));
        let det = -p[0] * q[1] + q[0] * p[1];
        [(-right[0] * q[1] + q[0] * right[1]) / det, (p[0] * right[1] - p[1] * right[0]) / det]
    };
    let v_b = turned(b).map(|x| 10.0 * x);
    let omega = solved(v_b.map(|x| -x));
    assert!((omega[0] + 2.424343).abs() < 1e-6, "{omega:?}");
    let factor = omega[0].abs();
    let right = [0, 1].map(|k| -omega[1] * omega[1] * cd[k] + factor * cb[k] + 100.0 * b[k]);
    let alpha = solved(right);
    let a_c = [0, 1].map(|k| -omega[1] * omega[1] * cd[k] + alpha[1] * turned(cd)[k]);
    let a_c = libm::hypot(a_c[0], a_c[1]);
    let values = format!(
        "positive,counter-clockwise\nomega(2),{:.3}\n\"aplan(b,n_bC)\",{:.1}\n\"aplan(π,c)\",{a_c:.1}\nalpha(2),{:.2}\nalpha(3),{:.2}\n\
         vplan(p;b),600\nvplan(b;c),339.4\n",
        omega[0],
        factor * 140.0,
        alpha[0],
        alpha[1]
    )
    .replace("(p;b)", "(p,b)")
    .replace("(b;c)", "(b,c)");
    let forms = folder.join("forms");
    std::fs::create_dir(&forms).expect("a folder");
    std::fs::write(forms.join("x.csv"), values).expect("written");
    let scheme = forms.join("marks.json");
    let awarded = |text: &str| {
        std::fs::write(&scheme, text).expect("written");
        let marks = ["--marks", scheme.to_str().expect("UTF-8")];
        let output = run(scene, &forms, &marks);
        assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
        let rows = rows(&stdout(&output));
        assert_eq!(rows.len(), 1, "the marking scheme is no form");
        let single = run(scene, &forms.join("x.csv"), &[&marks[..], &["--json"]].concat());
        let single: serde_json::Value = serde_json::from_slice(&single.stdout).expect("JSON");
        let [earned, of] = ["earned", "of"].map(|key| single["marks"][key].as_f64());
        assert_eq!(rows[0]["marks"].parse().ok(), earned);
        assert_eq!(rows[0]["marks_of"].parse().ok(), of);
        let told = run(scene, &forms.join("x.csv"), &marks);
        let told = stdout(&told);
        let line = told.lines().last().unwrap_or_default().to_owned();
        assert!(line.starts_with("Marks: "), "{told}");
        [
            earned.expect("a number"),
            of.expect("a number"),
            single["marks"]["follow_through"].as_f64().expect("a number"),
        ]
    };
    // omega(2) is right, 1; omega(3) is not there, 0; the normal part is the mistake itself, 0 of 2; a_C is off by 5 mm of paper and follows,
    // half of 3; alpha(2) is 1.5 off and within its 1.8, 4; alpha(3) is 4.8 off and follows, half of 4.
    let values = r#""values": { "aplan(b,n_bC)": 2, "omega(2)": 1, "omega(3)": 1, "aplan(c,π)": 3, "alpha(2)": 4, "alpha(3)": 4 }"#;
    let marks = |more: &str| awarded(&format!(r#"{{ "kinegon_marks": 1, {values}{more} }}"#));
    assert_eq!(marks(r#", "follow_through": 0.5"#), [8.5, 15.0, 3.5]);
    assert_eq!(marks(""), [12.0, 15.0, 7.0]);
    assert_eq!(marks(r#", "follow_through": 0, "missing": 0.25"#), [5.25, 15.0, 0.0]);
    // 13 quantities in the form, p c and d c being the same; of the 7 given six are right, within, or follow.
    assert_eq!(awarded(r#"{ "kinegon_marks": 1 }"#), [6.0, 13.0, 2.0]);
    let both = r#"{ "kinegon_marks": 1, "each": 0.5, "values": { "omega(2)": 3 } }"#;
    assert_eq!(awarded(both), [5.5, 9.0, 1.0]);
}

/// B and C of the four-bar linkage: AB = 60 at 60°, BC = 140, CD = 110, D 160 to the right of A.
fn joints() -> [[f64; 2]; 2] {
    let b = [30.0, 30.0 * libm::sqrt(3.0)];
    let d = [160.0 - b[0], -b[1]];
    let apart = libm::hypot(d[0], d[1]);
    let along = (apart * apart + 140.0 * 140.0 - 110.0 * 110.0) / (2.0 * apart);
    let high = libm::sqrt(140.0 * 140.0 - along * along);
    let u = d.map(|x| x / apart);
    let c = [b[0] + along * u[0] - high * u[1], b[1] + along * u[1] + high * u[0]];
    [b, c]
}

#[test]
fn wrong_marking_schemes_are_refused() {
    let folder = scratch("class-schemes");
    std::fs::write(folder.join("x.csv"), "omega(2),-2.424\n").expect("written");
    for (text, parts) in [
        (r#"{ "kinegon_marks": 1, "values": { "omga(2)": 1 } }"#, ["values.omga(2)", "`omega(2)`"]),
        (r#"{ "kinegon_marks": 1, "values": { "omega(2)": -1 } }"#, ["values.omega(2)", "no number of marks"]),
        (
            r#"{ "kinegon_marks": 1, "values": { "vplan(b,c)": 1, "vplan(c,b)": 1 } }"#,
            ["values.vplan(c,b)", "same quantity"],
        ),
        (r#"{ "kinegon_marks": 1, "follow_through": 2 }"#, ["follow_through", "from 0"]),
        (r#"{ "kinegon_marks": 1, "each": 0 }"#, ["no marks for anything", "each"]),
        (r#"{ "kinegon_marks": 1, "eech": 2 }"#, ["unknown key `eech`", "each"]),
        (r#"{ "kinegon_mark": 1 }"#, ["kinegon_marks", "marking scheme"]),
    ] {
        let scheme = folder.join("scheme.txt");
        std::fs::write(&scheme, text).expect("written");
        let marks = ["--marks", scheme.to_str().expect("UTF-8")];
        for form in [folder.clone(), folder.join("x.csv")] {
            let output = run(FOUR_BAR, &form, &marks);
            let said = stderr(&output);
            assert_eq!(output.status.code(), Some(2), "{said}");
            assert!(output.stdout.is_empty());
            for part in parts {
                assert!(said.contains(part), "{text}: {said}");
            }
        }
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_no_report() {
    use std::time::{Duration, Instant};
    let (folder, _) = class("class-interrupted");
    let form = std::fs::read(folder.join("1.json")).expect("there");
    for number in 10..2000 {
        std::fs::write(folder.join(format!("{number}.json")), &form).expect("written");
    }
    let out = scratch("class-interrupted-out");
    let mut command = kinegon();
    command.args(["check", LEVER]).arg(&folder);
    command.arg("-o").arg(out.join("report.csv"));
    let mut child = command.stderr(std::process::Stdio::piped()).spawn().expect("it starts");
    let start = Instant::now();
    let names =
        || std::fs::read_dir(&out).expect("a folder").filter_map(|e| Some(e.ok()?.file_name())).collect::<Vec<_>>();
    while names().is_empty() {
        assert!(start.elapsed() < Duration::from_secs(60));
        std::thread::sleep(Duration::from_millis(20));
    }
    std::thread::sleep(Duration::from_millis(100));
    let id = child.id().to_string();
    let kill = std::process::Command::new("kill").args(["-INT", &id]).status();
    assert!(kill.expect("kill runs").success());
    let status = child.wait().expect("it ends");
    assert_eq!(status.code(), Some(130));
    assert!(start.elapsed() < Duration::from_secs(60), "it goes on");
    assert!(names().is_empty(), "{:?}", names());
}

#[test]
fn the_values_of_another_exercise_are_told() {
    let [exercises, forms] = ["class-others", "class-others-forms"].map(scratch);
    let mut command = kinegon();
    command.args(["exercise", "four-bar", "--seed", "5", "--count", "2", "-o"]).arg(&exercises);
    assert!(command.output().expect("the program starts").status.success());
    // The right values of the second exercise, handed in for the first, and those of the first.
    let [own, other] = ["four-bar-5-1", "four-bar-5-2"];
    let values = |name: &str| {
        let text = std::fs::read_to_string(exercises.join(name).join("key.json")).expect("a key");
        let key: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let values = key["values"].as_object().expect("values").iter();
        values.map(|(name, row)| (name.clone(), row["value"].clone())).collect::<serde_json::Map<_, _>>()
    };
    for (file, of) in [("copied.json", other), ("own.json", own)] {
        let form = serde_json::json!({
            "kinegon_measured": 1, "name": file, "exercise": own, "positive": "counter-clockwise", "values": values(of),
        });
        std::fs::write(forms.join(file), form.to_string()).expect("written");
    }
    let mut command = kinegon();
    let output = command.arg("check").arg(&exercises).arg(&forms).output().expect("the program starts");
    let rows = rows(&stdout(&output));
    let [copied, right] = rows.as_slice() else { panic!("{}", stderr(&output)) };
    assert_eq!((copied["values_of"].as_str(), copied["mistake"].as_str()), (other, ""), "{copied:?}");
    assert_eq!((right["values_of"].as_str(), right["passed"].as_str()), ("", "true"), "{right:?}");
}

/// A form that names another exercise than its file or its folder does is checked against the one that it names, and its row says so.
#[test]
fn a_file_named_after_another_exercise_is_told() {
    let folder = scratch("class-other-name");
    let [exercises, forms] = ["exercises", "forms"].map(|name| folder.join(name));
    for name in ["one", "two"] {
        std::fs::create_dir_all(exercises.join(name)).expect("made");
        std::fs::create_dir_all(forms.join(name)).expect("made");
        std::fs::copy(FOUR_BAR, exercises.join(name).join("scene.json")).expect("copied");
    }
    let form = r#"{ "kinegon_measured": 1, "exercise": "one", "positive": "counter-clockwise", "values": { "omega(2)": -2.424 } }"#;
    for name in ["one Ana.json", "two Bo.json", "Cid.json", "two/Dan.json", "two/one Eva.json"] {
        std::fs::write(forms.join(name), form).expect("written");
    }
    let output = run(exercises.to_str().expect("UTF-8"), &forms, &[]);
    for row in rows(&stdout(&output)) {
        let is_told = ["two Bo.json", "two/Dan.json"].contains(&row["file"].as_str());
        assert_eq!(row["message"].contains("`two`"), is_told, "{row:?}");
        assert_eq!((row["exercise"].as_str(), row["right"].as_str()), ("one", "1"), "{row:?}");
    }
    let alone = run(exercises.to_str().expect("UTF-8"), &forms.join("two Bo.json"), &[]);
    assert!(stderr(&alone).contains("warning") && stderr(&alone).contains("`two`"), "{}", stderr(&alone));
}
