//! Files for learning management systems, read back by the importers' own rules (`tests/courses/read.py`), and held to
//! the keys of the same exercises.

use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use support::files;
use support::program::{kinegon, scratch, stderr};
use support::tools::{find, run};

/// Runs `kinegon exercise`, which must do it.
fn exercise(kind: &Path, more: &[&str], output: &Path) {
    let done = kinegon().arg("exercise").arg(kind).args(["--seed", "7"]).args(more).arg("-o").arg(output).output();
    let done = done.expect("the program starts");
    assert!(done.status.success(), "{}", stderr(&done));
}

/// What the importer of a system would have of a file.
fn read(system: &str, file: &Path) -> Value {
    let reader = files::path("tests/courses/read.py");
    let said = run(&find("python3"), ["-B".as_ref(), reader.as_os_str(), system.as_ref(), file.as_os_str()]);
    serde_json::from_slice(&said).expect("JSON")
}

/// The exercises of a kind as folders, and as the file of a system, read back: the folder and what was read.
fn both(name: &str, kind: &str, system: &str, count: &str) -> (PathBuf, Value) {
    let folder = scratch(&format!("courses-{name}"));
    let file = folder.join(if system == "moodle" { "course.xml" } else { "course.zip" });
    exercise(Path::new(kind), &["--count", count], &folder);
    exercise(Path::new(kind), &["--count", count, "--lms", system], &file);
    (folder, read(system, &file))
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).expect("it was written")).expect("JSON")
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-7 * (a.abs() + b.abs())
}

fn number(of: &Value, key: &str) -> f64 {
    of[key].as_f64().unwrap_or_else(|| panic!("no number `{key}` in {of}"))
}

fn list(of: &Value) -> &[Value] {
    of.as_array().unwrap_or_else(|| panic!("no list: {of}"))
}

/// Half a unit of a number's third significant digit.
fn half(value: f64) -> f64 {
    let written = format!("{value:.2e}");
    let exponent: i32 = written.split_once('e').expect("an exponent").1.parse().expect("a number");
    // 9.996 is written 1.00e1, but its third digit is that of hundredths.
    let exponent = if value.abs() < 10f64.powi(exponent) { exponent - 1 } else { exponent };
    0.5 * 10f64.powi(exponent - 2)
}

/// Holds a field to the key's value: the right number, both signs of a size, no marks for the other sense of a rate.
fn hold_to_key(name: &str, value: &Value, answers: &[Value], names_sense: bool) {
    let (right, allowed) = (number(value, "value"), number(value, "allowed"));
    let (first, other) = (&answers[0], &answers[1]);
    assert!(close(number(first, "value"), right) && number(first, "percent") == 100.0, "{name}: {first}, not {right}");
    assert!(close(number(first, "tolerance"), allowed + half(right)), "{name}: {first}, allowed {allowed}");
    let is_size = name.contains("plan(") || name.starts_with("L(");
    if is_size || names_sense {
        assert!(close(number(other, "value"), -right), "{name}: {other}");
        assert_eq!(number(other, "percent"), if is_size { 100.0 } else { 0.0 }, "{name}");
    }
    for (place, wrong) in answers.iter().enumerate().skip(1) {
        for better in &answers[..place] {
            let apart = (number(wrong, "value") - number(better, "value")).abs();
            assert!(
                apart > number(wrong, "tolerance") + number(better, "tolerance"),
                "{name}: {wrong} overlaps {better}"
            );
        }
    }
}

#[test]
#[ignore = "needs Python"]
fn moodle_accepts_what_the_keys_allow() {
    for kind in ["four-bar", "slotted-lever"] {
        let (folder, quiz) = both(&format!("moodle-{kind}"), kind, "moodle", "3");
        assert_eq!(quiz["category"], format!("$course$/Kinegon/{kind}"));
        let questions = list(&quiz["questions"]);
        assert_eq!(questions.len(), 3);
        for (question, number) in questions.iter().zip(1..) {
            let own = folder.join(format!("{kind}-7-{number}"));
            let key = json(&own.join("key.json"));
            let own_name = format!("{kind}-7-{number}");
            assert_eq!(question["name"], format!("{own_name}: {}", key["title"].as_str().expect("a title")));
            assert_eq!(question["idnumber"], own_name);
            assert_eq!(question["tags"], json!(["Kinegon", kind]));
            let worth = json(&own.join("scene.json"))["form"].clone();
            let (values, fields) = (key["values"].as_object().expect("values"), list(&question["fields"]));
            assert_eq!(values.len(), fields.len(), "{kind}");
            let mut named = 0;
            for ((name, value), field) in values.iter().zip(fields) {
                assert_eq!(self::number(field, "weight"), self::number(&worth, name), "{name}");
                hold_to_key(name, value, list(&field["answers"]), true);
                named += list(&field["answers"]).iter().skip(2).filter(|answer| answer["said"].is_string()).count();
            }
            assert!(named > fields.len(), "{kind}: only {named} wrong numbers have a name");
            // Every file that is shown is there, and the sheet to print is that of the folder.
            let given = question["files"].as_object().expect("files");
            for used in list(&question["used"]) {
                assert!(given.contains_key(used.as_str().expect("a name")), "{used} of {:?}", given.keys());
            }
            #[cfg(feature = "pdf")]
            {
                let sheet = std::fs::read(own.join("sheet.pdf")).expect("a sheet");
                let sheet: String = sheet.iter().map(|byte| format!("{byte:02x}")).collect();
                assert_eq!(given[&format!("{kind}-7-{number}-sheet.pdf")], sheet);
            }
        }
    }
}

/// Sites often take no file over 8 MB. A picture in a page has no font but those of the machine, and no other file.
#[test]
#[ignore = "needs Python"]
fn a_class_fits_into_an_upload_and_pictures_bring_their_letters() {
    for kind in ["four-bar", "third-class", "platform-3rrr"] {
        let folder = scratch(&format!("courses-size-{kind}"));
        let file = folder.join("quiz.xml");
        exercise(Path::new(kind), &["--count", "2", "--lms", "moodle"], &file);
        let size = std::fs::metadata(&file).expect("it was written").len() / 2;
        assert!(30 * size < 7_000_000, "{kind}: {size} bytes a question");
        let quiz = read("moodle", &file);
        for (name, bytes) in quiz["questions"][0]["files"].as_object().expect("files") {
            let Some(_) = name.strip_suffix(".svg") else { continue };
            let svg = bytes.as_str().expect("digits").as_bytes().chunks(2);
            let svg: Vec<u8> = svg
                .map(|two| u8::from_str_radix(std::str::from_utf8(two).expect("digits"), 16).expect("a byte"))
                .collect();
            let svg = String::from_utf8(svg).expect("text");
            assert!(!svg.contains("<text") && !svg.contains("font"), "{kind}: {name}");
            let mut uses = 0;
            for used in svg.split(" href=\"#").skip(1).filter_map(|rest| rest.split('"').next()) {
                assert_eq!(svg.matches(&format!("id=\"{used}\"")).count(), 1, "{kind}: {name}: {used}");
                uses += 1;
            }
            assert!(uses > 10, "{kind}: {name} has {uses} letters");
        }
    }
}

/// A segment that was not divided by its length, computed from the scene alone.
#[test]
#[ignore = "needs Python"]
fn a_wrong_number_has_the_name_of_its_mistake() {
    let (folder, quiz) = both("named", "four-bar", "moodle", "1");
    let [scene, key] = ["scene", "key"].map(|name| json(&folder.join(format!("four-bar-7-1/{name}.json"))));
    let length = number(&scene["links"]["3"]["lengths"], "CD");
    let omega = number(&key["values"]["omega(3)"], "value").abs();
    let place = key["values"].as_object().expect("values").keys().position(|name| name == "omega(3)");
    let answers = list(&quiz["questions"][0]["fields"][place.expect("it is asked for")]["answers"]);
    let own = answers.iter().find(|answer| close(number(answer, "value"), omega * length));
    let own = own.unwrap_or_else(|| panic!("no {} among {answers:#?}", omega * length));
    let said = own["said"].as_str().expect("feedback");
    assert!(said.contains("ω_3") && said.contains("not divided by L_DC"), "{said}");
    assert_eq!(own["percent"], 0.0);
    // The crank's diameter in place of its radius doubles all velocities: charged in the first, and paid for in those that follow.
    for (name, percent) in [("vplan(p,b)", 0.0), ("vplan(b,c)", 100.0)] {
        let place = key["values"].as_object().expect("values").keys().position(|own| own == name);
        let answers = list(&quiz["questions"][0]["fields"][place.expect("it is asked for")]["answers"]);
        let double = 2.0 * number(&key["values"][name], "value");
        let own = answers.iter().find(|answer| close(number(answer, "value"), double));
        assert_eq!(own.unwrap_or_else(|| panic!("no {double} among {answers:#?}"))["percent"], percent, "{name}");
    }
}

#[test]
#[ignore = "needs Python"]
fn canvas_accepts_what_the_keys_allow() {
    let (folder, package) = both("canvas", "slider-crank", "canvas", "2");
    let names = list(&package["names"]);
    assert_eq!(names[0], "imsmanifest.xml");
    // The manifest lists every file, and no other.
    let listed = package["listed"].as_object().expect("a list");
    assert!(names[1..].iter().all(|name| listed.contains_key(name.as_str().expect("a name"))), "{listed:?}");
    assert_eq!(listed.len(), names.len() - 1);
    let quizzes = list(&package["quizzes"]);
    assert_eq!(quizzes.len(), 2);
    for (quiz, number_of) in quizzes.iter().zip(1..) {
        let key = json(&folder.join(format!("slider-crank-7-{number_of}/key.json")));
        let title = key["title"].as_str().expect("a title");
        assert_eq!(quiz["title"], format!("slider-crank-7-{number_of}: {title}"));
        let (values, items) = (key["values"].as_object().expect("values"), list(&quiz["items"]));
        assert_eq!(values.len() + 1, items.len());
        // Picture and sheet stand once, before the questions.
        assert_eq!(items[0]["metadata"], json!({ "question_type": "text_only_question", "points_possible": "0" }));
        let used = list(&items[0]["used"]);
        assert!(used.len() == 2 && used.iter().all(|file| names.contains(file)), "{used:?}");
        let scene = json(&folder.join(format!("slider-crank-7-{number_of}/scene.json")));
        for ((name, value), item) in values.iter().zip(&items[1..]) {
            let points = number(&scene["form"], name).to_string();
            assert_eq!(item["metadata"], json!({ "question_type": "numerical_question", "points_possible": points }));
            let answers = list(&item["answers"]);
            hold_to_key(
                name,
                value,
                &[answers, &[json!({ "value": 0, "tolerance": 0, "percent": 0 })]].concat(),
                false,
            );
            for answer in answers {
                let [value, tolerance] = ["value", "tolerance"].map(|key| number(answer, key));
                let ends = [value - tolerance, value + tolerance];
                assert!(
                    list(&answer["ends"])
                        .iter()
                        .zip(ends)
                        .all(|(end, own)| (end.as_f64().expect("a number") - own).abs() <= 1e-6 * value.abs())
                );
            }
            // All see what is said of any wrong number: it must not give the right one away.
            let said = item["said"].as_str().unwrap_or_default();
            assert!(!said.contains("sense is wrong"), "{name}: {said}");
            assert_eq!(item["used"], json!([]));
        }
    }
}

#[test]
#[ignore = "needs Python"]
fn a_scorm_package_has_the_exercise_and_no_key() {
    let (folder, package) = both("scorm", "four-bar", "scorm", "2");
    let print = if cfg!(feature = "pdf") { "pdf" } else { "svg" };
    let sheets = [1, 2].map(|number| format!("four-bar-7-{number}-sheet.{print}"));
    let files = ["index.html", "workbench.html", "THIRD-PARTY.txt", &sheets[0], &sheets[1]];
    assert_eq!(package["files"], json!(files));
    assert_eq!(package["names"], json!([&["imsmanifest.xml"], &files[..]].concat()));
    assert_eq!([&package["version"], &package["kind"]], ["1.2", "sco"]);
    assert_eq!([&package["default"], &package["starts"]], [true, true]);
    assert_eq!(package["pass"], Value::Null, "nothing that a student must reach, unless the teacher says so");
    let opened = list(&package["opened"]);
    assert_eq!(opened.len(), 2);
    for (opened, number) in opened.iter().zip(1..) {
        let own = folder.join(format!("four-bar-7-{number}"));
        assert_eq!(opened["text"], std::fs::read_to_string(own.join("scene.json")).expect("a scene"));
        // What the scheme does not show: without the crank's speed nothing can be drawn.
        let scene = json(&own.join("scene.json"));
        let told = format!(" = {} rad/s", self::number(&scene["links"]["1"]["drive"], "omega").abs());
        assert!(package["page"].as_str().expect("a page").contains(&told), "{told}");
        assert_eq!([&opened["student"], &opened["panel"]], [&json!(true), &json!("check")]);
        let form: Value = serde_json::from_str(opened["form"].as_str().expect("a form")).expect("JSON");
        let (asked, given) = (json(&own.join("form.json")), &form["values"]);
        assert_eq!(asked["values"], *given, "an empty form");
        assert!(form["positive"].is_null() && form["in"] == "mm");
    }
}

#[test]
#[ignore = "needs Python"]
fn what_must_be_reached_stands_in_the_manifest() {
    let file = scratch("courses-pass").join("page.zip");
    exercise(Path::new("dyad-rrr"), &["--lms", "scorm", "--pass", "60"], &file);
    let package = read("scorm", &file);
    assert_eq!(package["pass"], "60");
}

/// Whoever guesses within a factor of ten of the right value hits what is paid for as following in a quarter of all cases at most: in half a
/// decade of two.
#[test]
#[ignore = "needs Python"]
fn a_field_does_not_pay_for_every_number() {
    let mut paid = 0;
    for kind in ["four-bar", "third-class"] {
        let (_, quiz) = both(&format!("guessed-{kind}"), kind, "moodle", "1");
        for field in list(&quiz["questions"][0]["fields"]) {
            let answers = list(&field["answers"]);
            let right = number(&answers[0], "value");
            let follows = answers[1..]
                .iter()
                .filter(|answer| number(answer, "percent") > 0.0 && !close(number(answer, "value"), -right));
            let decades: Vec<f64> = follows
                .map(|answer| {
                    let [value, tolerance] = ["value", "tolerance"].map(|key| number(answer, key).abs());
                    let from = (value - tolerance).max(0.1 * right.abs());
                    let to = (value + tolerance).min(10.0 * right.abs());
                    libm::log10(to / from).max(0.0)
                })
                .collect();
            let all: f64 = decades.iter().sum();
            assert!(all < 0.51, "{kind}: {all} decades of {}", answers[0]);
            paid += decades.len();
        }
    }
    assert!(paid > 30, "only {paid} numbers that follow are paid for");
}

/// A list sorts names letter by letter.
#[test]
#[ignore = "needs Python"]
fn ten_questions_are_listed_in_their_order() {
    let file = scratch("courses-ten").join("quiz.xml");
    exercise(Path::new("dyad-rrp"), &["--count", "10", "--lms", "moodle"], &file);
    let quiz = read("moodle", &file);
    let names: Vec<&str> = list(&quiz["questions"]).iter().map(|one| one["name"].as_str().expect("a name")).collect();
    assert!(names.is_sorted() && names[0].starts_with("dyad-rrp-7-01: "), "{names:?}");
}

#[test]
fn one_seed_gives_the_same_bytes() {
    let folder = scratch("courses-twice");
    for (system, ending) in [("moodle", "xml"), ("canvas", "zip"), ("scorm", "zip")] {
        let [once, twice] = ["once", "twice"].map(|name| {
            let file = folder.join(format!("{system}-{name}.{ending}"));
            exercise(Path::new("four-bar"), &["--lms", system], &file);
            std::fs::read(file).expect("it was written")
        });
        assert!(once == twice, "{system}");
    }
}

/// Whatever a title or a label says, it stays a text: no field, no element, no other question.
#[test]
#[ignore = "needs Python"]
fn a_hostile_title_stays_a_title() {
    let folder = scratch("courses-hostile");
    let title = "]]></text><x a=\"'>}{1:NUMERICAL:=0:9}~#%50%\\} {{exercises}} </script> @@PLUGINFILE@@ \u{202e}\u{1b}[31m &lt;&#125;";
    let mut scene: Value = serde_json::from_str(&files::read("templates/four-bar.json")).expect("JSON");
    scene["title"] = json!(title);
    scene["figure"] = json!({ "labels": { "B": "}~#<b>{1:NM:=1}", "2": "=~}%100%" } });
    let file = folder.join("a}b~c.json");
    std::fs::write(&file, scene.to_string()).expect("the test's folder can be written");
    for (system, output) in [("moodle", "quiz.xml"), ("canvas", "quiz.zip"), ("scorm", "page.zip")] {
        let output = folder.join(output);
        exercise(&file, &["--lms", system], &output);
        let read = read(system, &output);
        match system {
            "moodle" => {
                let question = &read["questions"][0];
                assert_eq!(read["category"], "$course$/Kinegon/a}b~c");
                assert_eq!(list(&read["questions"]).len(), 1);
                assert_eq!(list(&question["fields"]).len(), 11, "no field more than boxes");
                let name = question["name"].as_str().expect("a name");
                assert!(name.starts_with("a_b_c-7-1: ]]></text><x a=\"'>}{1:NUMERICAL:=0:9}~#%50%\\}"), "{name}");
                assert!(!name.contains('\u{202e}') && !name.contains('\u{1b}'));
                let text = question["text"].as_str().expect("a text");
                assert!(!text.contains("<x a") && !text.contains("<b>"), "{text}");
            }
            "canvas" => {
                let items = list(&read["quizzes"][0]["items"]);
                assert_eq!(items.len(), 12, "what is told, and the boxes");
                assert!(items.iter().all(|item| !item["text"].as_str().expect("a text").contains("<x a")));
            }
            _ => assert!(list(&read["opened"])[0]["text"].as_str().expect("a scene").contains("NUMERICAL")),
        }
    }
}

#[test]
fn what_cannot_be_a_course_is_refused() {
    let folder = scratch("courses-refused");
    for (arguments, said) in [
        (&["four-bar", "--lms", "moodle", "-o", "class/"][..], "ends in `.xml`"),
        (&["four-bar", "--lms", "moodle", "-o", "."], ". is a folder"),
        (&["four-bar", "--lms", "moodle", "-o", "quiz.zip"], "end in `.xml`"),
        (&["four-bar", "--lms", "canvas", "-o", "quiz"], "end in `.zip`"),
        (&["four-bar", "--lms", "scorm", "-o", "quiz.xml"], "end in `.zip`"),
        (&["four-bar", "--lms", "blackboard", "-o", "quiz.xml"], "moodle, canvas, scorm"),
        (&["no-such-kind", "--lms", "moodle", "-o", "quiz.xml"], "no kind of mechanism"),
        (&["four-bar", "--lms", "scorm", "--pass", "101", "-o", "quiz.zip"], "0..=100"),
        (&["four-bar", "--lms", "moodle", "--pass", "60", "-o", "quiz.xml"], "add `--lms scorm`"),
        (&["four-bar", "--pass", "60", "-o", "class/"], "add `--lms scorm`"),
    ] {
        let refused = kinegon().args(["exercise", "--seed", "1"]).args(arguments).current_dir(&folder).output();
        let refused = refused.expect("the program starts");
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&refused).contains(said), "{arguments:?}: {}", stderr(&refused));
        assert_eq!(std::fs::read_dir(&folder).expect("it is there").count(), 0, "{arguments:?}");
    }
}
