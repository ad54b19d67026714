//! Without a mouse: everything is reached by Tab and arrows, and is seen to be reached.

use super::bench::Bench;
use serde_json::json;
use support::files;

/// Goes on with Tab until an element has the keys; it must be seen that it has them.
fn tab_to(bench: &mut Bench, selector: &str) {
    for _ in 0..250 {
        if bench.value(&format!("document.activeElement?.matches({}) ?? false", json!(selector))) == true {
            let seen = bench.value(
                "(() => { const s = getComputedStyle(document.activeElement); \
                 return s.outlineStyle !== 'none' || s.boxShadow !== 'none' || document.activeElement.matches('.cm-content'); })()",
            );
            assert_eq!(seen, true, "{selector}: it is not seen that it has the keys");
            return;
        }
        bench.press("Tab");
    }
    panic!("Tab does not reach {selector}");
}

#[test]
#[ignore = "needs Chromium"]
fn a_teacher_works_by_keys() {
    let mut bench = Bench::open("teacher-keys");
    // A kind.
    tab_to(&mut bench, "[role=tab]");
    bench.press("Home");
    bench.until("document.activeElement.id === 'tab-mechanism'");
    if bench.text("kinegon.app.shown.value") != "mechanism" {
        bench.press("Enter");
    }
    tab_to(&mut bench, "#panel-mechanism details.gallery > summary");
    bench.press("Enter");
    bench.until("document.querySelectorAll('#panel-mechanism button.kind').length > 10");
    tab_to(&mut bench, "#panel-mechanism button.kind");
    bench.press("Enter");
    bench.settle();
    assert!(bench.scene().contains("Four-bar"));
    // A length.
    tab_to(&mut bench, "[data-path=\"links.1.lengths.AB\"] input");
    bench.value("document.activeElement.select?.()");
    bench.type_text("55");
    bench.press("Enter");
    bench.settle();
    assert_eq!(bench.at("/links/1/lengths/AB"), 55);
    // A joint by arrows, and back.
    let angle = bench.at("/links/1/drive/angle");
    tab_to(&mut bench, "#handle-B");
    for _ in 0..4 {
        bench.press("ArrowLeft");
    }
    bench.until("document.querySelector('#bubble').hidden");
    bench.settle();
    assert_ne!(bench.at("/links/1/drive/angle"), angle);
    bench.picture("keys");
    bench.press("Control+z");
    bench.settle();
    assert_eq!(bench.at("/links/1/drive/angle"), angle);
    // The steps.
    tab_to(&mut bench, "#steps-toggle");
    bench.press("Enter");
    bench.value("document.activeElement.blur()");
    bench.press("Home");
    bench.press("ArrowRight");
    bench.settle();
    assert_eq!(bench.value("kinegon.app.view.value.step"), 2);
    // A file.
    tab_to(&mut bench, "[role=tab]");
    bench.press("End");
    if bench.text("kinegon.app.shown.value") != "save" {
        bench.press("Enter");
    }
    bench.settle();
    tab_to(&mut bench, "#panel-save button");
    let (name, _) = bench.saved(|browser| browser.press("Enter"));
    assert!(name.ends_with(".svg"), "{name}");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_student_works_by_keys() {
    let mut bench = Bench::open("student-keys");
    let text = files::read("templates/four-bar.json");
    let form = bench.ask("form", &[json!(text), json!("")])["json"].clone();
    let shared = json!({ "text": text, "form": form, "panel": "check", "student": true });
    let link = bench.text(&format!("kinegon.app.link({shared}).then((link) => link.slice(link.indexOf('#')))"));
    bench.load(&link);
    tab_to(&mut bench, "#panel-check .row input");
    bench.type_text("12.5");
    bench.press("Tab");
    bench.until("document.querySelector('#panel-check .row .verdict').textContent !== ''");
    assert!(bench.text("kinegon.history.now.value.form").contains("12.5"));
    bench.value("document.activeElement.blur()");
    bench.press("Control+z");
    bench.settle();
    assert!(!bench.text("kinegon.history.now.value.form").contains("12.5"));
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn no_letter_of_the_first_value_is_lost() {
    let text = files::read("templates/four-bar.json");
    let mut bench = Bench::of("first-value", &text);
    bench.panel("check");
    tab_to(&mut bench, "#panel-check .row input");
    bench.type_text("12.5");
    bench.press("Tab");
    bench.settle();
    let form = bench.text("kinegon.history.now.value.form");
    assert!(form.contains("12.5"), "what was typed before there was a form: {form}");
    bench.assert_quiet();
}
