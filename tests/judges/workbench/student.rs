//! A student: a link, a sheet to print, values typed one by one, what went wrong, the drawing over the right one, undo.

use super::bench::Bench;
use serde_json::{Value, json};
use support::files;

/// The address part of a student's link to an exercise, and the key's values.
fn exercise(bench: &mut Bench) -> (String, Value) {
    let options = json!({ "page": null, "language": null, "notation": null, "decimal": null });
    let scene = files::read("templates/four-bar.json");
    let made = bench.ask("exercise", &[json!(scene), json!("four-bar"), json!(7), json!(1), options]);
    let (text, form) = (made["text"].clone(), made["form"].clone());
    assert!(text.is_string(), "{made}");
    let shared = json!({ "text": text, "form": form, "panel": "check", "student": true });
    let link = bench.text(&format!("kinegon.app.link({shared}).then((link) => link.slice(link.indexOf('#')))"));
    let key: Value = serde_json::from_str(made["key_values"].as_str().expect("a form")).expect("JSON");
    (link, key)
}

/// Types a value into the box of that name, with its sign.
fn write(bench: &mut Bench, name: &str, value: f64) {
    let form = bench.scene();
    let rows = bench.ask("form", &[json!(form), json!("")]);
    let rows = rows["rows"].as_array().expect("rows");
    let asked: Vec<&Value> = rows.iter().filter(|row| row["is_asked"] == true).collect();
    let index = asked.iter().position(|row| row["name"] == name).unwrap_or_else(|| panic!("no box for {name}"));
    bench.value(&format!(
        "(() => {{ document.querySelectorAll('[data-box]').forEach((e) => delete e.dataset.box); \
         document.querySelectorAll('#panel-check .row input[inputmode=decimal]')[{index}].dataset.box = ''; }})()"
    ));
    let sign = if asked[index]["has_sense"] == true && value > 0.0 { "+" } else { "" };
    bench.fill("[data-box]", &format!("{sign}{}", (value * 100.0).round() / 100.0));
    bench.until(
        "document.querySelector('[data-box]').closest('.row').querySelector('.verdict').dataset.kind !== 'writing'",
    );
}

/// The verdict beside the box that was written last.
fn verdict(bench: &mut Bench) -> String {
    bench.settle();
    bench.text("document.querySelector('[data-box]').closest('.row').querySelector('.verdict').dataset.kind ?? ''")
}

#[test]
#[ignore = "needs Chromium"]
fn values_are_checked_one_by_one() {
    let mut bench = Bench::open("student");
    let (link, key) = exercise(&mut bench);
    bench.load(&link);
    assert_eq!(bench.text("kinegon.app.shown.value"), "check");
    assert!(!bench.marks().contains("velocity-vector"), "a student's link shows no plan");
    // Nor does a second link in the same tab.
    bench.value(&format!("location.hash = {}", json!(link)));
    bench.until("location.hash === ''");
    bench.settle();
    assert!(!bench.marks().contains("velocity-vector"), "a second student's link shows no plan");
    bench.picture("student-link");
    let values = key["values"].as_object().expect("values").clone();
    let mut written = 0;
    for (name, value) in &values {
        let Some(value) = value["value"].as_f64() else { continue };
        write(&mut bench, name, value);
        assert_eq!(verdict(&mut bench), "right", "{name} = {value}");
        written += 1;
        if written == 3 {
            break;
        }
    }
    assert_eq!(written, 3, "{key}");
    let good = bench.text("kinegon.history.now.value.form");
    // A value twice as large is off, and something is said about it.
    let (name, value) =
        values.iter().filter_map(|(name, v)| Some((name, v["value"].as_f64()?))).nth(1).expect("values");
    write(&mut bench, name, 2.0 * value);
    assert_eq!(verdict(&mut bench), "off", "{name}");
    bench.picture("student-off");
    bench.press_named("#panel-check", "What happened");
    bench.picture("student-happened");
    bench.value("document.activeElement.blur()");
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.text("kinegon.history.now.value.form"), good);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn the_papers_values_are_checked_at_once() {
    let mut bench = Bench::open("paper-values");
    let form = files::read("examples/paper-as-student.json");
    bench.value(&format!("kinegon.history.change({{ form: {} }})", json!(form)));
    bench.panel("check");
    let begin = bench.number("performance.now()");
    bench.until("/✓ 2.*≈ 17/.test(document.querySelector('#panel-check').textContent)");
    println!("29 values judged {:.0} ms after the panel was opened", bench.number("performance.now()") - begin);
    bench.picture("check");
    let before = bench.marks();
    bench.press_named("#panel-check", "What happened");
    bench.press_named("#panel-check", "Show my drawing");
    bench.until(&format!("document.querySelector('#sheet').innerHTML !== {}", json!(before)));
    bench.picture("overlay");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn an_exercise_is_made_and_given() {
    let mut bench = Bench::open("exercise");
    bench.panel("exercise");
    bench.choose("#panel-exercise select", "Four-bar");
    bench.fill("#panel-exercise input[type=number]", "7");
    // The sheet of another seed may have been there before.
    bench.until("document.querySelector('#panel-exercise').textContent.includes('four-bar-7-1')");
    bench.until("document.querySelector('#panel-exercise .sheet svg') !== null");
    bench.settle();
    bench.picture("exercise");
    bench.press_named("#panel-exercise", "Link for students");
    let link = bench
        .text("[...document.querySelectorAll('#panel-exercise input')].find((e) => e.value.includes('#1=')).value");
    let (_, hash) = link.split_once('#').expect("a link");
    bench.load(&format!("#{hash}"));
    assert_eq!(bench.value("kinegon.app.student.value"), true);
    // The link has what is given, the sheet, and the next exercise; undo brings the one before back, with its sheet.
    let task = "document.querySelector('#panel-check .task')?.textContent ?? ''";
    let stands = |number: u32| {
        format!("({task}).includes('four-bar-7-{number}') && document.querySelector('#panel-check .task svg') !== null")
    };
    bench.until(&stands(1));
    let told = bench.text(task);
    assert!(told.contains("Given:") && told.contains("Draw the plans"), "{told}");
    assert!(!told.contains("Choose the pole"), "the teacher did not allow the steps: {told}");
    let first = bench.scene();
    bench.press_named("#panel-check .task", "Next exercise");
    bench.until(&stands(2));
    assert_ne!(bench.scene(), first);
    bench.picture("student-next");
    bench.click("#undo");
    bench.until(&stands(1));
    assert_eq!(bench.scene(), first);
    // The same exercise as the program's.
    let made = bench.scene();
    let folder = bench.folder().join("made");
    let program = support::program::kinegon().args(["exercise", "four-bar", "--seed", "7", "-o"]).arg(&folder).output();
    assert!(program.expect("it runs").status.success());
    let scene = std::fs::read_to_string(folder.join("four-bar-7-1/scene.json")).expect("a scene");
    assert_eq!(made, scene);
    bench.assert_quiet();
}
