//! What hands do in Build besides its tools: fingers that rest and pinch, several parts at once, a photograph behind, and how it is left.

use super::bench::Bench;
use super::build::{click, drag, empty, four_bar, on_screen, places, state, tool};
use serde_json::Value;
use support::files;

fn count(bench: &mut Bench, pointer: &str) -> usize {
    bench.at(pointer).as_object().map_or(0, serde_json::Map::len)
}

/// What is chosen: how many points.
fn chosen(bench: &mut Bench) -> f64 {
    bench.number("document.querySelectorAll('#build-stage circle.chosen').length")
}

#[test]
#[ignore = "needs Chromium"]
fn a_finger_that_rests_opens_the_menu_and_two_zoom() {
    let mut bench = empty("build-fingers");
    four_bar(&mut bench);
    bench.telephone([390, 844]);
    bench.settle();
    bench.press_named("#build .seen", "Fit");
    tool(&mut bench, "select");
    // Resting on C: the menu, in which it is fixed.
    let [x, y] = on_screen(&mut bench, [140.0, 90.0]);
    let finger = serde_json::json!([{ "x": x, "y": y, "id": 0 }]);
    bench.call("Input.dispatchTouchEvent", serde_json::json!({ "type": "touchStart", "touchPoints": finger }));
    bench.until("document.querySelector('.build-menu').matches(':popover-open')");
    bench.call("Input.dispatchTouchEvent", serde_json::json!({ "type": "touchEnd", "touchPoints": [] }));
    bench.picture("build-menu");
    let low = bench.value("[...document.querySelectorAll('.build-menu button')].filter((e) => e.getBoundingClientRect().height < 44 || e.getBoundingClientRect().right > innerWidth).length");
    assert_eq!(low, 0, "entries for fingers, within the screen");
    bench.press_named(".build-menu", "Fix it");
    assert_ne!(bench.at("/ground/C"), Value::Null, "{}", bench.scene());
    bench.click("#undo");
    bench.settle();
    // Two fingers go from 80 to 160 px apart, and 30 px to the right: what was between them stays there, also where nothing is seen any more.
    let window = |bench: &mut Bench| {
        let window = bench.value("JSON.parse(document.querySelector('#build-stage').dataset.window)");
        [0, 1, 2].map(|k| window[k].as_f64().expect("a number"))
    };
    // y of the pane goes down.
    let under = |window: [f64; 3], right: f64| [window[0] + right / window[2], window[1] - 60.0 / window[2]];
    let [x, y, ..] = bench.place("#build-stage");
    let apart = |by: f64, half: f64| [[x + by - half, y + 60.0], [x + by + half, y + 60.0]];
    let ways: Vec<[[f64; 2]; 2]> =
        (0..=8).map(|k| apart(30.0 * f64::from(k) / 8.0, 40.0 + 5.0 * f64::from(k))).collect();
    for _ in 0..3 {
        let before = window(&mut bench);
        bench.touch(&ways.iter().map(<[_; 2]>::as_slice).collect::<Vec<_>>());
        bench.until(&format!(
            "JSON.parse(document.querySelector('#build-stage').dataset.window)[2] > {}",
            1.97 * before[2]
        ));
        bench.settle();
        let after = window(&mut bench);
        assert!((after[2] / before[2] - 2.0).abs() < 0.02, "{before:?} {after:?}");
        let [was, is] = [under(before, 0.0), under(after, 30.0)];
        assert!(libm::hypot(was[0] - is[0], was[1] - is[1]) * after[2] < 1.0, "{was:?} {is:?}");
    }
    assert_eq!(count(&mut bench, "/links"), 3, "two fingers build nothing");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn several_are_copied_with_their_drives_and_removed() {
    let mut bench = empty("build-several");
    four_bar(&mut bench);
    tool(&mut bench, "select");
    // A frame, drawn with Shift, around all; what is copied is complete as its original is.
    let [from, to] = [[-20.0, -20.0], [180.0, 110.0]].map(|place| on_screen(&mut bench, place));
    let shift = |bench: &mut Bench, kind: &str, [x, y]: [f64; 2]| {
        let event = serde_json::json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1, "modifiers": 8 });
        bench.call("Input.dispatchMouseEvent", event);
    };
    shift(&mut bench, "mousePressed", from);
    shift(&mut bench, "mouseMoved", [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])]);
    shift(&mut bench, "mouseMoved", to);
    shift(&mut bench, "mouseReleased", to);
    bench.settle();
    assert_eq!(chosen(&mut bench), 4.0);
    let original = bench.scene();
    bench.press("Control+c");
    bench.press("Control+v");
    bench.until("Object.keys(JSON.parse(kinegon.history.now.value.text).links).length === 6");
    bench.settle();
    assert!(state(&mut bench).starts_with("Complete"), "{} {}", state(&mut bench), bench.scene());
    for (own, copy) in [("1", "4"), ("2", "5"), ("3", "6")] {
        let lengths = |bench: &mut Bench, link: &str| {
            let table = bench.at(&format!("/links/{link}/lengths"));
            table.as_object().expect("lengths").values().map(|length| length.as_f64()).collect::<Vec<_>>()
        };
        assert_eq!(lengths(&mut bench, own), lengths(&mut bench, copy), "{}", bench.scene());
        let drives = [own, copy].map(|link| bench.at(&format!("/links/{link}/drive")));
        assert_eq!(drives[0], drives[1]);
    }
    // The copy is chosen: it is dragged as one, and only it. That, and the copy, are an entry of undo each.
    let all = places(&mut bench);
    let copy = all.iter().find(|(name, _)| name == "F").expect("the copy of D").1;
    drag(&mut bench, [copy.re, copy.im], [copy.re + 40.0, copy.im - 20.0]);
    let moved = places(&mut bench);
    for ((name, was), (_, is)) in all.iter().zip(&moved) {
        let way = if ["A", "B", "C", "D"].contains(&name.as_str()) { [0.0, 0.0] } else { [40.0, -20.0] };
        let off = libm::hypot(is.re - was.re - way[0], is.im - was.im - way[1]);
        assert!(off < 0.2, "{name} went from {was} to {is}");
    }
    bench.picture("build-copied");
    // Delete takes the whole copy, and the text is the original's.
    bench.press("Delete");
    bench.until("Object.keys(JSON.parse(kinegon.history.now.value.text).links).length === 3");
    bench.settle();
    let [left, was] = [bench.scene(), original.clone()].map(|text| serde_json::from_str::<Value>(&text).expect("JSON"));
    assert_eq!(left["links"], was["links"]);
    assert_eq!(left["ground"], was["ground"]);
    for _ in 0..3 {
        bench.click("#undo");
        bench.settle();
    }
    assert_eq!(bench.scene(), original, "three entries: copied, moved, removed");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_photograph_lies_behind_to_scale() {
    let mut bench = empty("build-photograph");
    // A box for files that is asked for stays where the test reaches it.
    bench.value("HTMLInputElement.prototype.click = function () { this.id = 'asked'; setTimeout(() => document.body.append(this)); }");
    bench.press_named("#build", "Photograph");
    bench.until("document.querySelector('#asked') !== null");
    bench.give_files("#asked", &[&files::path("docs/workbench.png")]);
    bench.until("document.querySelector('#build image') !== null");
    // Two places of it that are 200 of its pixels apart are said to be 120 mm apart.
    let shown = "(() => { const { left, top, width, height } = document.querySelector('#build image').getBoundingClientRect(); return [left, top, width, height]; })()";
    let image = bench.value(shown);
    let [left, top, width, height] = [0, 1, 2, 3].map(|k| image[k].as_f64().expect("a number"));
    let share = [0.3, 0.6];
    for part in share {
        let at = [left + part * width, top + 0.5 * height];
        bench.take_hold(at);
        bench.let_go(at);
        bench.settle();
    }
    bench.until("document.activeElement.matches('#build .length')");
    bench.insert("twelve");
    bench.press("Enter");
    assert!(bench.text("document.querySelector('#said').textContent").contains("a number of mm"));
    bench.press("Control+a");
    bench.insert("120");
    bench.press("Enter");
    bench.until("document.querySelector('#build .length').hidden");
    bench.settle();
    let image = bench.value(shown);
    let scale = bench.number("JSON.parse(document.querySelector('#build-stage').dataset.window)[2]");
    let apart = (share[1] - share[0]) * image[2].as_f64().expect("a width") / scale;
    assert!((apart - 120.0).abs() < 0.5, "{apart} mm");
    // What is built over it is a mechanism, and the photograph no part of it.
    drag(&mut bench, [0.0, 0.0], [60.0, 0.0]);
    assert_eq!(bench.at("/links/1/lengths/AB"), 60, "{}", bench.scene());
    assert!(!bench.scene().contains("blob"), "{}", bench.scene());
    bench.picture("build-photograph");
    bench.press_named("#build", "Without photograph");
    assert_eq!(bench.value("document.querySelector('#build image')"), Value::Null);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn what_is_only_begun_is_no_mistake() {
    let mut bench = empty("build-begun");
    drag(&mut bench, [0.0, 0.0], [20.0, 60.0]);
    drag(&mut bench, [20.0, 60.0], [140.0, 90.0]);
    // Where no point is near but the grid leads to one, that is meant.
    tool(&mut bench, "fixed");
    click(&mut bench, [4.9, 0.0]);
    assert_eq!(bench.at("/ground"), serde_json::json!({ "A": [0, 0] }), "{}", bench.scene());
    let missing = state(&mut bench);
    assert!(missing.starts_with("Not complete yet"), "{missing}");
    bench.click("#hand-move");
    bench.settle();
    assert_eq!(bench.message(), format!("{missing}Go on building"), "the same words, and a way back");
    let red = "[document.querySelector('#message').role, document.querySelectorAll('.refusal').length, document.querySelectorAll('#message strong').length]";
    assert_eq!(bench.value(red), serde_json::json!(["status", 0, 0]));
    bench.picture("build-left");
    bench.click("#message-build");
    bench.settle();
    assert_eq!(
        bench.value("[kinegon.app.building.value, document.activeElement.id]"),
        serde_json::json!([true, "build-stage"])
    );
    assert_eq!(bench.message(), "");
    // A mistake is one: there is no link of that name.
    let scene = bench.scene().replace("\"ground\"", "\"grount\"");
    bench.click("#hand-move");
    bench.put(&scene);
    assert_eq!(bench.value("document.querySelector('#message').role"), "alert");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn what_plays_stops_where_building_begins() {
    let mut bench = Bench::of("build-play", &files::read("templates/four-bar.json"));
    bench.click("#play");
    bench.until("document.querySelector('#play').ariaPressed === 'true'");
    bench.click("#hand-build");
    assert_eq!(bench.value("document.querySelector('#play').ariaPressed"), "false");
    bench.settle();
    let scene = bench.scene();
    bench.value("new Promise((done) => setTimeout(done, 300))");
    assert_eq!(bench.scene(), scene, "nothing moves behind what is built");
    // At once the keys are the stage's.
    bench.press(" ");
    bench.settle();
    assert_eq!(bench.value("document.querySelector('#play').ariaPressed"), "false");
    bench.assert_quiet();
}
