//! Form, text and picture are one scene; nothing is lost.

use super::bench::Bench;
use kinegon::format::OpenScene;
use support::files;

const AB: &str = "#panel-mechanism [data-path=\"links.1.lengths.AB\"] input";

#[test]
#[ignore = "needs Chromium"]
fn form_text_and_picture_are_one_scene() {
    let text = files::read("templates/four-bar.json");
    let mut bench = Bench::of("one-scene", &text);
    let before = bench.marks();
    bench.panel("mechanism");
    bench.fill(AB, "50");
    assert_eq!(bench.at("/links/1/lengths/AB"), 50);
    assert_eq!(bench.scene(), text.replace("\"AB\": 60", "\"AB\": 50"), "the rest stays to the letter");
    assert_ne!(bench.marks(), before, "the picture follows the form");
    let with_50 = bench.marks();
    // The same in the text.
    bench.panel("text");
    assert!(bench.text("document.querySelector('#panel-text .cm-content').textContent").contains("\"AB\": 50"));
    bench.picture("text");
    bench.value("(() => { const { view } = document.querySelector('#panel-text .cm-content').cmTile ?? {}; })()");
    bench.focus("#panel-text .cm-content");
    bench.press("Control+Home");
    let at = bench.scene().find("50 }").expect("the length");
    for _ in 0..at {
        bench.press("ArrowRight");
    }
    bench.press("Delete");
    bench.type_text("7");
    bench.until("kinegon.history.now.value.text.includes('\"AB\": 70')");
    bench.settle();
    assert_ne!(bench.marks(), with_50, "the picture follows the text");
    bench.panel("mechanism");
    assert_eq!(bench.text(&format!("document.querySelector('{AB}').value")), "70");
    // The same by the hand: the drive in picture, form and text.
    bench.pull_joint("B", [-60.0, 30.0]);
    let angle = bench.at("/links/1/drive/angle").as_f64().expect("an angle");
    assert!((angle - 60.0).abs() > 3.0, "{angle}");
    let shown =
        bench.text("document.querySelector('#panel-mechanism [data-path=\"links.1.drive.angle\"] input').value");
    assert_eq!(shown.parse::<f64>().ok(), Some(angle));
    bench.picture("mechanism");
    // One gesture, one entry.
    for expected in [70, 50, 60] {
        bench.click("#undo");
        bench.settle();
        assert_eq!(bench.at("/links/1/lengths/AB"), expected);
    }
    assert_eq!(bench.scene(), text);
    assert_eq!(bench.marks(), before);
    assert_eq!(bench.value("document.querySelector('#undo').disabled"), true);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn nothing_is_lost_by_closing_the_tab() {
    // Without a scene in the file, which would come first in a new tab.
    let mut bench = Bench::with("kept", None);
    let first = bench.scene();
    bench.put(&files::read("templates/slotted-lever.json").replace("Crank", "My own crank"));
    let mine = bench.scene();
    // At once, before any pause.
    bench.load("");
    assert_eq!(bench.scene(), mine);
    // Nor is what undo goes back through.
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.scene(), first);
    bench.assert_quiet();
}

/// A lesson comes with its scene in the file; what somebody makes of it is there again, and never takes the place of another lesson.
#[test]
#[ignore = "needs Chromium"]
fn work_on_a_lesson_is_never_lost() {
    let text = files::read("templates/four-bar.json");
    let mut bench = Bench::of("lesson-kept", &text);
    let mine = text.replace("Four-bar", "My four-bar");
    bench.put(&mine);
    // Loaded again, at once.
    bench.load("");
    assert_eq!(bench.scene(), mine);
    // The file has another lesson now: that is shown, and the work is offered.
    let other = files::read("templates/slider-crank.json");
    bench.put_into_file(OpenScene { text: &other, step: None });
    bench.load("");
    assert_eq!(bench.scene(), other);
    let offer = bench.text("document.querySelector('#notice').textContent");
    assert!(offer.contains("My four-bar linkage"), "{offer}");
    bench.picture("lesson-offer");
    bench.click("#notice-act");
    bench.settle();
    assert_eq!(bench.scene(), mine);
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.scene(), other, "undo leads back to the file's");
    // Another tab has the lesson of the file, and the offer.
    bench.value("sessionStorage.clear()");
    bench.put_into_file(OpenScene { text: &text, step: None });
    bench.load("");
    assert_eq!(bench.scene(), text);
    assert!(bench.text("document.querySelector('#notice').textContent").contains("My four-bar linkage"));
    bench.assert_quiet();
}
