//! A teacher in class: the crank in the hand, steps by keys, panels one by one, full screen, dark; limits and other modes.

use super::bench::Bench;
use kinegon::format::OpenScene;
use serde_json::json;
use support::files;

/// The window onto the sheet, in mm.
const SIGHT: &str = "document.querySelector('#sheet').viewBox.baseVal.width";

#[test]
#[ignore = "needs Chromium"]
fn plans_follow_the_crank() {
    let mut bench = Bench::open("crank");
    let before = bench.marks();
    let [x, y] = bench.joint("B");
    bench.take_hold([x, y]);
    bench.pull([x - 30.0, y + 20.0]);
    bench.frame();
    bench.pull([x - 60.0, y + 30.0]);
    bench.until("!document.querySelector('#bubble').hidden && /°/.test(document.querySelector('#bubble').textContent)");
    // The picture follows while the hand holds.
    bench.until(&format!("document.querySelector('#sheet').innerHTML !== {}", json!(before)));
    bench.picture("crank");
    // Escape puts it back.
    bench.press("Escape");
    bench.let_go([x - 60.0, y + 30.0]);
    bench.until(&format!("document.querySelector('#sheet').innerHTML === {}", json!(before)));
    // The slider of the drive, and keys.
    let angle = bench.at("/links/1/drive/angle").as_f64().expect("an angle");
    bench.focus("#drive-1");
    bench.press("ArrowRight");
    bench.press("ArrowRight");
    bench.value("document.activeElement.blur()");
    bench.settle();
    assert_eq!(bench.at("/links/1/drive/angle").as_f64(), Some(angle + 2.0));
    // Any moving joint moves it.
    let any = bench.marks();
    bench.pull_joint("D", [0.0, 12.0]);
    assert_ne!(bench.marks(), any);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn it_plays_by_itself() {
    let mut bench = Bench::open("play");
    bench.value("kinegon.frames.length = 0");
    bench.press(" ");
    bench.until("document.querySelector('#play').ariaPressed === 'true' && kinegon.frames.length > 20");
    let pictures = bench.number(
        "new Promise((done) => { const from = kinegon.frames.length; setTimeout(() => done(kinegon.frames.length - from), 1000); })",
    );
    println!("{pictures:.0} pictures a second");
    bench.press(" ");
    bench.until("document.querySelector('#play').ariaPressed === 'false'");
    bench.settle();
    // Going round is one gesture.
    bench.press("Control+z");
    bench.settle();
    assert_eq!(bench.value("kinegon.history.canUndo.value"), false);
    // Who wants little motion gets two pictures a second.
    bench.media("", &[("prefers-reduced-motion", "reduce")]);
    bench.value("kinegon.frames.length = 0");
    bench.click("#play");
    let calm = bench.number("new Promise((done) => setTimeout(() => done(kinegon.frames.length), 1500))");
    bench.click("#play");
    assert!(calm <= 6.0, "{calm} pictures in 1.5 s");
    bench.assert_quiet();
}

/// Lets it play for some pictures and stops it: how far each drive has gone, from the pictures that were shown.
fn played(bench: &mut Bench) -> Vec<f64> {
    bench.value("(window.stands = [], window.unwatch = kinegon.app.picture.on(({ drives }) => window.stands.push(drives.map(({ value }) => value))), 0)");
    bench.press(" ");
    bench.until("window.stands.length > 12");
    bench.press(" ");
    bench.until("document.querySelector('#play').ariaPressed === 'false'");
    bench.settle();
    let gone = bench.value("(window.unwatch(), window.stands[12].map((value, k) => value - window.stands[0][k]))");
    gone.as_array().expect("a list").iter().filter_map(|gone| gone.as_f64()).collect()
}

#[test]
#[ignore = "needs Chromium"]
fn drives_run_as_the_scene_says() {
    // Crank 1 of the paper's Figure 2 turns at −1 rad/s.
    let mut bench = Bench::open("runs");
    let gone = played(&mut bench);
    assert!(gone[0] < -1.0, "{gone:?}");
    // Of two, at 4 and −3 rad/s, both run; the page says so.
    bench.put(&files::read("templates/five-bar.json"));
    let gone = played(&mut bench);
    assert!(gone[0] > 1.0 && (gone[1] / gone[0] + 0.75).abs() < 1e-6, "{gone:?}");
    assert!(bench.text("document.querySelector('#said').textContent").contains("All drives run together"));
    assert!(bench.text("document.querySelector('#play').title").contains("all drives"));
    // A slider moves one alone.
    let other = bench.at("/links/4/drive/angle");
    bench.focus("#drive-1");
    bench.press("ArrowRight");
    bench.value("document.activeElement.blur()");
    bench.settle();
    assert_eq!(bench.at("/links/4/drive/angle"), other);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn what_is_changed_while_it_plays_stays() {
    let mut bench = Bench::open("plays-changed");
    let other = files::read("templates/four-bar.json");
    bench.press(" ");
    bench.until("document.querySelector('#play').ariaPressed === 'true' && kinegon.frames.length > 5");
    bench.value(&format!("kinegon.app.open({})", json!(other)));
    bench.until("document.querySelector('#play').ariaPressed === 'false'");
    bench.settle();
    assert_eq!(bench.scene(), other);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_lesson_goes_step_by_step() {
    let text = files::read("examples/figure-2.json");
    let scene = Some(OpenScene { text: &text, step: Some(1) });
    let mut bench = Bench::with("steps", scene);
    let caption = "document.querySelector('#step-caption').textContent";
    assert_eq!(bench.value("document.querySelector('#steps').hidden"), false, "a lesson begins with its steps");
    assert_eq!(bench.value("kinegon.app.view.value.step"), 1);
    bench.value("document.activeElement.blur()");
    for _ in 0..6 {
        bench.press("ArrowRight");
    }
    bench.click("#step-forward");
    bench.settle();
    assert_eq!(bench.value("kinegon.app.view.value.step"), 8);
    assert_eq!(bench.text(caption), "Lay off the velocity of B, normal to AB, in the sense of ω1.");
    assert!(bench.marks().contains("velocity-vector-p-b"));
    bench.picture("step");
    bench.press("p");
    bench.until("document.body.classList.contains('presenting')");
    bench.settle();
    bench.picture("lesson");
    bench.press("Escape");
    bench.until("!document.body.classList.contains('presenting')");
    bench.value("document.activeElement.blur()");
    bench.press("ArrowLeft");
    bench.settle();
    assert!(!bench.marks().contains("velocity-vector-p-b"));
    // The mechanism moves while a step is shown.
    let at_seven = bench.marks();
    bench.press("ArrowUp");
    bench.until("document.querySelector('#bubble').hidden");
    bench.settle();
    bench.until(&format!("document.querySelector('#sheet').innerHTML !== {}", serde_json::json!(at_seven)));
    bench.press("End");
    bench.settle();
    assert_eq!(bench.value("kinegon.app.view.value.step === null"), true);
    bench.press("Home");
    bench.settle();
    assert_eq!(bench.value("kinegon.app.view.value.step"), 1);
    bench.click("#step-coarse");
    bench.settle();
    assert_eq!(bench.value("kinegon.app.view.value.coarse"), true);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn it_is_seen_from_the_last_row() {
    let mut bench = Bench::open("seen");
    let all = bench.number(SIGHT);
    let whole = bench.marks();
    bench.press("2");
    bench.until_other(&whole);
    bench.picture("velocity-panel");
    bench.press("a");
    bench.until(&format!("document.querySelector('#sheet').innerHTML === {}", json!(whole)));
    bench.press("+");
    bench.until(&format!("{SIGHT} < {}", 0.95 * all));
    bench.press("0");
    bench.until(&format!("Math.abs({SIGHT} - {all}) < 1"));
    bench.press("d");
    let [dark, light] = ["backgroundColor", "color"].map(|look| {
        let colour = bench.text(&format!("getComputedStyle(document.body).{look}"));
        let parts = colour.trim_start_matches(|c: char| !c.is_ascii_digit()).split([',', ' ', ')', '/']);
        parts.filter_map(|part| part.parse::<f64>().ok()).take(3).sum::<f64>()
    });
    assert!(dark < light, "{dark} {light}");
    bench.picture("dark");
    bench.press("d");
    bench.press("p");
    bench.until("document.body.classList.contains('presenting')");
    bench.settle();
    let share = bench.number("document.querySelector('#pane').clientHeight / innerHeight");
    assert!(share > 0.7, "{share}");
    bench.picture("full-screen");
    bench.press("Escape");
    bench.until("!document.body.classList.contains('presenting')");
    bench.screen([1920, 1080], 1.0);
    bench.settle();
    bench.picture("projector");
    assert_eq!(bench.value("document.documentElement.scrollWidth <= 1920"), true);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_limit_stops_the_hand_and_says_so() {
    // Its crank cannot turn round.
    let text = files::read("tests/lecture/watt.json");
    let mut bench = Bench::of("limit", &text);
    let low = bench.value("kinegon.app.solved.value.opened.drives[0].low");
    assert!(low.is_number(), "this drive has limits");
    // Round with the crank's end, beyond where it can go.
    let [x, y] = bench.joint("A");
    let centre = bench.value(
        "(() => { const { at } = kinegon.app.picture.value.handles.find(({ name }) => name === 'O'); \
         const { x, y } = new DOMPoint(...at).matrixTransform(document.querySelector('#sheet').getScreenCTM()); return [x, y]; })()",
    );
    let [cx, cy] = [0, 1].map(|k| centre[k].as_f64().expect("a place"));
    let (radius, begin) = (libm::hypot(x - cx, y - cy), libm::atan2(y - cy, x - cx));
    bench.take_hold([x, y]);
    for k in 1..=24 {
        let angle = begin - 0.1 * f64::from(k);
        bench.pull([cx + radius * libm::cos(angle), cy + radius * libm::sin(angle)]);
        bench.frame();
    }
    bench.until("kinegon.app.picture.value.notes.some((note) => /limit/i.test(note))");
    bench.until("/limit/i.test(document.querySelector('#bubble').textContent)");
    bench.picture("limit");
    bench.let_go([x, y]);
    bench.settle();
    assert_eq!(bench.message(), "");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn other_modes_are_seen_and_chosen() {
    let text = files::read("templates/four-bar.json");
    let mut bench = Bench::of("modes", &text);
    let own = bench.marks();
    bench.panel("modes");
    bench.until("document.querySelectorAll('#panel-modes input[type=radio]').length === 2");
    bench.click("#panel-modes input[type=checkbox]");
    bench.settle();
    let ghosts = bench.marks();
    assert!(ghosts.contains("mode 2") && !own.contains("mode 2"), "the other mode is drawn pale");
    bench.picture("modes");
    bench.click("#panel-modes input[type=radio]:not(:checked)");
    bench.settle();
    let near = bench.at("/near/C/1").as_f64().expect("a rough place");
    assert!(near < 0.0, "{near}");
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.scene(), text);
    bench.assert_quiet();
}
