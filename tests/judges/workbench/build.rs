//! A mechanism is put together in Build, from nothing, and changed.

use super::bench::Bench;
use nalgebra::Complex;
use serde_json::{Value, json};

/// Where a place of the scene is on the screen.
pub fn on_screen(bench: &mut Bench, [x, y]: [f64; 2]) -> [f64; 2] {
    let window = bench.value("JSON.parse(document.querySelector('#build-stage').dataset.window)");
    let [centre_x, centre_y, scale] = [0, 1, 2].map(|k| window[k].as_f64().expect("a number"));
    let [middle_x, middle_y, ..] = bench.place("#build-stage");
    [middle_x + (x - centre_x) * scale, middle_y - (y - centre_y) * scale]
}

pub fn drag(bench: &mut Bench, from: [f64; 2], to: [f64; 2]) {
    let [from, to] = [from, to].map(|place| on_screen(bench, place));
    let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
    bench.drag(&[from, middle, to]);
    bench.settle();
}

pub fn click(bench: &mut Bench, at: [f64; 2]) {
    let at = on_screen(bench, at);
    bench.take_hold(at);
    bench.let_go(at);
    bench.settle();
}

pub fn tool(bench: &mut Bench, name: &str) {
    bench.click(&format!("#build .tools [data-value={name}]"));
    bench.settle();
}

/// A bench with an empty stage.
pub fn empty(name: &str) -> Bench {
    let mut bench = Bench::open(name);
    bench.panel("mechanism");
    begin(&mut bench);
    bench
}

/// Begins with an empty stage; the panel of the mechanism is open.
pub fn begin(bench: &mut Bench) {
    bench.press_named("#panel-mechanism", "New, empty");
    bench.until(
        "document.querySelector('#build-stage').dataset.window !== undefined && document.activeElement.id === 'build-stage'",
    );
    bench.settle();
}

/// Where the points are, by name.
pub fn places(bench: &mut Bench) -> Vec<(String, Complex<f64>)> {
    let text = json!(bench.scene());
    let all = bench.ask("places", &[text]);
    let place = |point: &Value| {
        let [x, y] = [0, 1].map(|axis| point["at"][axis].as_f64().expect("a number"));
        (point["name"].as_str().expect("a name").to_owned(), Complex::new(x, y))
    };
    all.as_array().expect("places").iter().map(place).collect()
}

fn place_of(bench: &mut Bench, point: &str) -> [f64; 2] {
    let at = places(bench).into_iter().find(|(name, _)| name == point).expect("a point").1;
    [at.re, at.im]
}

pub fn state(bench: &mut Bench) -> String {
    bench.text("document.querySelector('#build-state').textContent")
}

/// A four-bar linkage: three links, two fixed points, a drive.
pub fn four_bar(bench: &mut Bench) {
    drag(bench, [0.0, 0.0], [20.0, 60.0]);
    drag(bench, [20.0, 60.0], [140.0, 90.0]);
    drag(bench, [140.0, 90.0], [160.0, 0.0]);
    tool(bench, "fixed");
    click(bench, [0.0, 0.0]);
    click(bench, [160.0, 0.0]);
    tool(bench, "drive");
    click(bench, [12.0, 36.0]);
}

#[test]
#[ignore = "needs Chromium"]
fn a_four_bar_is_built_moved_and_taken_apart() {
    let mut bench = empty("build");
    assert_eq!(bench.message(), "", "nothing is wrong with what is only begun");
    assert!(bench.text("document.title").starts_with("Scene"), "the scene before it has gone");
    four_bar(&mut bench);
    assert_eq!(bench.value("kinegon.app.solved.value.refused"), Value::Null, "{}", bench.scene());
    assert!(state(&mut bench).starts_with("Complete"), "{}", state(&mut bench));
    let length = bench.at("/links/2/lengths/BC").as_f64().expect("a length");
    assert!((length - 15_300_f64.sqrt()).abs() < 0.05, "√(120² + 30²), {length}");
    bench.picture("build-four-bar");
    // A joint is dragged: the mechanism is another one, in one entry of undo.
    let before = bench.scene();
    tool(&mut bench, "select");
    drag(&mut bench, [140.0, 90.0], [150.0, 110.0]);
    let [x, y] = place_of(&mut bench, "C");
    assert!(libm::hypot(x - 150.0, y - 110.0) < 0.5, "{x} {y}");
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.scene(), before);
    // A click shows the link's card, and Delete takes the link away; what is left keeps its places.
    click(&mut bench, [80.0, 75.0]);
    assert_eq!(bench.value("document.querySelector('[data-path=\"links.2\"]').classList.contains('revealed')"), true);
    bench.press("Delete");
    bench.settle();
    assert_eq!(bench.at("/links/2"), Value::Null);
    assert!(state(&mut bench).starts_with("Not complete yet"), "{}", state(&mut bench));
    let [x, y] = place_of(&mut bench, "C");
    assert!(libm::hypot(x - 140.0, y - 90.0) < 0.5, "{x} {y}");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn guides_have_any_angle_and_cylinders_drive() {
    let mut bench = empty("build-sliders");
    drag(&mut bench, [0.0, 0.0], [40.0, 30.0]);
    drag(&mut bench, [40.0, 30.0], [120.0, 60.0]);
    tool(&mut bench, "slider");
    drag(&mut bench, [120.0, 60.0], [160.0, 100.0]);
    assert_eq!(bench.at("/sliders/0/along"), 45, "{}", bench.scene());
    assert_eq!(bench.at("/sliders/0/on"), "ground");
    tool(&mut bench, "fixed");
    click(&mut bench, [0.0, 0.0]);
    // A cylinder from the ground to the crank's pin drives it.
    tool(&mut bench, "cylinder");
    drag(&mut bench, [100.0, -40.0], [40.0, 30.0]);
    tool(&mut bench, "fixed");
    click(&mut bench, [100.0, -40.0]);
    assert!(state(&mut bench).starts_with("Complete"), "{} {}", state(&mut bench), bench.scene());
    let position = bench.at("/sliders/1/drive/position").as_f64().expect("a position");
    let rod = bench
        .at("/links/5/lengths")
        .as_object()
        .expect("a rod")
        .values()
        .next()
        .and_then(Value::as_f64)
        .expect("a length");
    assert!((position + rod - 8_500_f64.sqrt()).abs() < 0.05, "√(60² + 70²): {position} {rod}");
    bench.picture("build-cylinder");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn what_is_chosen_is_copied_and_by_keys_all_is_done() {
    let mut bench = empty("build-keys");
    // The cross goes by steps of the grid; Enter begins a link and ends it.
    let step = |bench: &mut Bench, key: &str, times: usize| {
        for _ in 0..times {
            bench.press(key);
        }
        bench.settle();
    };
    let link = |bench: &mut Bench, key: &str, times: usize| {
        step(bench, "Enter", 1);
        step(bench, key, times);
        step(bench, "Enter", 1);
    };
    link(&mut bench, "ArrowUp", 6);
    link(&mut bench, "ArrowRight", 9);
    link(&mut bench, "ArrowDown", 7);
    assert_eq!(bench.at("/links").as_object().map(serde_json::Map::len), Some(3), "{}", bench.scene());
    step(&mut bench, "4", 1);
    step(&mut bench, "Enter", 1);
    step(&mut bench, "PageDown", 1);
    let spoken = bench.text("document.querySelector('#spoken').textContent");
    assert!(!spoken.is_empty(), "where the cross is, is said");
    let fixed = bench.at("/ground").as_object().map(serde_json::Map::len);
    assert_eq!(fixed, Some(1), "{}", bench.scene());
    // All of it once more.
    bench.press("Control+a");
    bench.press("Control+c");
    bench.press("Control+v");
    bench.settle();
    assert_eq!(bench.at("/links").as_object().map(serde_json::Map::len), Some(6), "{}", bench.scene());
    bench.click("#undo");
    bench.settle();
    assert_eq!(bench.at("/links").as_object().map(serde_json::Map::len), Some(3));
    bench.assert_quiet();
}
