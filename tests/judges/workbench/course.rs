//! A SCORM package in a frame of a course: its management system, which the test plays, hears the score.

use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;
use support::browser::Browser;
use support::program::{kinegon, scratch, stderr};
use support::tools::{find, run_in};

/// A management system that remembers what it hears.
const SYSTEM: &str = r#"<!DOCTYPE html><link rel="icon" href="data:,"><title>course</title><script>
window.values = { "cmi.core.student_id": "s-17" };
window.heard = [];
const said = (name, answer) => (...given) => { heard.push(name); return answer(...given); };
window.API = {
  LMSInitialize: said("initialize", () => "true"),
  LMSFinish: said("finish", () => "true"),
  LMSGetValue: said("get", (name) => values[name] ?? (name === "cmi.core.lesson_status" ? "not attempted" : "")),
  LMSSetValue: said("set", (name, value) => { values[name] = value; return "true"; }),
  LMSCommit: said("commit", () => "true"),
  LMSGetLastError: () => "0",
};
</script><iframe src="index.html" width="1200" height="760"></iframe>"#;

/// A management system that is out of order until the test mends it: one call throws, one is missing, what is set is refused.
const FAULTY: &str = r#"<!DOCTYPE html><link rel="icon" href="data:,"><title>course</title><script>
window.values = {};
window.mended = false;
window.API = {
  LMSInitialize: () => { throw new Error("out of order"); },
  LMSFinish: () => "true",
  LMSSetValue: (name, value) => { if (!mended) return "false"; values[name] = value; return "true"; },
  LMSCommit: () => "true",
};
</script><iframe src="index.html" width="1200" height="760"></iframe>"#;

/// Whether the workbench stands in the frame of the package's page, in the system's frame.
const READY: &str = "document.querySelector('iframe')?.contentDocument?.querySelector('iframe')?.contentWindow?.kinegon !== undefined \
    && document.querySelector('iframe').contentDocument.querySelector('iframe').contentDocument.documentElement.dataset.ready === 'yes'";

/// The files of a package of three exercises, with the system's page; the exercises are in the folder, too.
fn site(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let python = find("python3");
    let package = folder.join("page.zip");
    for more in [
        vec!["-o".as_ref(), folder.as_os_str()],
        vec!["--lms".as_ref(), "scorm".as_ref(), "-o".as_ref(), package.as_os_str()],
    ] {
        let made = kinegon().args(["exercise", "four-bar", "--seed", "7", "--count", "3"]).args(more).output();
        let made = made.expect("the program starts");
        assert!(made.status.success(), "{}", stderr(&made));
    }
    run_in(folder, &python, ["-m", "zipfile", "-e", "page.zip", "site"]);
    let systems = [("system.html", SYSTEM), ("faulty.html", FAULTY)];
    let mut files: BTreeMap<_, _> = systems.map(|(name, page)| (name.to_owned(), page.as_bytes().to_vec())).into();
    for name in ["index.html", "workbench.html"] {
        let own = std::env::var_os("KINEGON_PAGE").filter(|_| name == "workbench.html");
        let path = own.map_or_else(|| folder.join("site").join(name), Into::into);
        files.insert(name.to_owned(), std::fs::read(path).expect("it is in the package"));
    }
    files
}

/// Fills the form in the frame with these values.
fn fill(browser: &mut Browser, values: &serde_json::Map<String, Value>) {
    browser.value(&format!(
        "(() => {{ const {{ history }} = document.querySelector('iframe').contentDocument.querySelector('iframe').contentWindow.kinegon; \
         const {{ in: _, ...form }} = JSON.parse(history.now.value.form); \
         history.change({{ form: JSON.stringify({{ ...form, positive: 'counter-clockwise', values: {{ ...form.values, ...{} }} }}) }}); }})()",
        Value::from(values.clone())
    ));
}

#[test]
#[ignore = "needs Chromium and Python"]
fn a_course_hears_the_score() {
    let folder = scratch("workbench-course");
    let files = site(&folder);
    let mut browser = Browser::start(&folder, [1280, 800]);
    browser.visit(files, "system.html", READY);
    let exercise = browser
        .text("JSON.parse(document.querySelector('iframe').contentDocument.querySelector('iframe').contentWindow.kinegon.history.now.value.form).exercise");
    assert!(exercise.starts_with("four-bar-7-"), "{exercise}");
    let student = browser.value("document.querySelector('iframe').contentDocument.querySelector('iframe').contentWindow.kinegon.app.student.value");
    assert_eq!(student, true, "no plan is shown");
    assert_eq!(browser.value("values['cmi.core.score.raw'] ?? null"), Value::Null, "nothing is checked yet");
    let told = "document.querySelector('iframe').contentDocument.querySelector('#no-course').hidden";
    assert_eq!(browser.value(told), true);
    let key = std::fs::read_to_string(folder.join(&exercise).join("key.json")).expect("a key");
    let key: Value = serde_json::from_str(&key).expect("JSON");
    let values: serde_json::Map<String, Value> =
        key["values"].as_object().expect("values").iter().map(|(name, v)| (name.clone(), v["value"].clone())).collect();
    // Some right values, then all of them, then one that is off: the best counts.
    let some = values.iter().take(4).map(|(name, value)| (name.clone(), value.clone())).collect();
    fill(&mut browser, &some);
    let scene = std::fs::read_to_string(folder.join(&exercise).join("scene.json")).expect("a scene");
    let scene: Value = serde_json::from_str(&scene).expect("JSON");
    let worth = |name: &String| scene["form"][name].as_f64().expect("what it is worth");
    let (earned, of): (f64, f64) = (values.keys().take(4).map(worth).sum(), values.keys().map(worth).sum());
    let part = (1000.0 * earned / of).round() / 10.0;
    browser.until(&format!("values['cmi.core.score.raw'] === '{part}'"));
    assert_eq!(browser.text("values['cmi.core.lesson_status']"), "incomplete");
    // Another visit: what is written is there again.
    browser.value("document.querySelector('iframe').src = 'about:blank'");
    browser.until("heard.at(-1) === 'finish'");
    assert_eq!(browser.text("values['cmi.core.exit']"), "suspend");
    assert!(browser.text("values['cmi.core.session_time']").starts_with("00:0"), "some seconds or minutes");
    browser.value("document.querySelector('iframe').src = 'index.html'");
    browser.until(READY);
    let filled = "Object.values(JSON.parse(document.querySelector('iframe').contentDocument.querySelector('iframe').contentWindow        .kinegon.history.now.value.form).values).filter((value) => value !== '').length";
    assert_eq!(browser.number(filled), 4.0);
    // The page around the workbench begins and ends each visit, and nobody else.
    assert_eq!(browser.number("heard.filter((what) => what === 'initialize').length"), 2.0);
    assert_eq!(browser.number("heard.filter((what) => what === 'finish').length"), 1.0);
    fill(&mut browser, &values);
    browser.until("values['cmi.core.score.raw'] === '100'");
    assert_eq!(browser.text("values['cmi.core.lesson_status']"), "completed");
    assert_eq!(browser.text("values['cmi.core.score.min'] + ' to ' + values['cmi.core.score.max']"), "0 to 100");
    let commits = browser.number("heard.filter((what) => what === 'commit').length");
    let mut off = values.clone();
    off.insert("omega(2)".to_owned(), json!(99));
    fill(&mut browser, &off);
    browser.until(&format!("heard.filter((what) => what === 'commit').length > {commits}"));
    assert_eq!(browser.text("values['cmi.core.score.raw']"), "100");
    browser.picture("course");
    browser.value("document.querySelector('iframe').src = 'about:blank'");
    browser.until("heard.at(-1) === 'finish'");
    assert_eq!(browser.text("values['cmi.core.exit']"), "");
    browser.assert_quiet();
}

#[test]
#[ignore = "needs Chromium and Python"]
fn a_faulty_course_leaves_the_exercise_and_is_told() {
    let folder = scratch("workbench-faulty-course");
    let files = site(&folder);
    let mut browser = Browser::start(&folder, [1280, 800]);
    browser.visit(files, "faulty.html", READY);
    let page = "document.querySelector('iframe').contentDocument.querySelector('iframe').contentDocument";
    let notice = format!("{page}.querySelector('#notice:not([hidden])')?.textContent ?? ''");
    assert!(browser.text(&notice).contains("does not take the marks"), "{}", browser.text(&notice));
    let exercise = browser.text(&format!("JSON.parse({page}.defaultView.kinegon.history.now.value.form).exercise"));
    let key = std::fs::read_to_string(folder.join(&exercise).join("key.json")).expect("a key");
    let key: Value = serde_json::from_str(&key).expect("JSON");
    let values = key["values"].as_object().expect("values").iter();
    fill(&mut browser, &values.map(|(name, v)| (name.clone(), v["value"].clone())).collect());
    // The page checks as it always does.
    browser.until(&format!("{page}.querySelector('#panel-check .result .heading.good') !== null"));
    assert_eq!(browser.value("values"), json!({}));
    browser.picture("course-faulty");
    browser.value(&format!("mended = true; {page}.querySelector('#notice-act').click()"));
    assert_eq!(browser.text("values['cmi.core.score.raw']"), "100");
    assert!(browser.text(&notice).contains("has the marks"), "{}", browser.text(&notice));
    browser.assert_quiet();
}

/// Opened by itself the package's page shows an exercise, too.
#[test]
#[ignore = "needs Chromium and Python"]
fn without_a_course_there_is_an_exercise_all_the_same() {
    let folder = scratch("workbench-no-course");
    let files = site(&folder);
    let mut browser = Browser::start(&folder, [1280, 800]);
    let frame = "document.querySelector('iframe')";
    browser.visit(files, "index.html", &format!("{frame}?.contentDocument?.documentElement?.dataset.ready === 'yes'"));
    assert_eq!(browser.value(&format!("{frame}.contentWindow.kinegon.app.student.value")), true);
    assert_eq!(browser.value(&format!("{frame}.contentWindow.kinegon.app.course")), Value::Null);
    // What is given is told once, of the exercise that is open.
    assert_eq!(browser.number("document.querySelectorAll('details').length"), 1.0);
    assert!(browser.text("document.querySelector('details').textContent").contains("rad/s"));
    assert_eq!(
        browser.value("document.querySelector('#no-course').hidden"),
        false,
        "the student hears that no marks are sent"
    );
    browser.picture("course-alone");
    browser.assert_quiet();
}
