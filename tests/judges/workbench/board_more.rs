//! On the drawing board: the calculator asks for the sense of a rate and is written by presses alone; points that lie close together and directions that meet are asked for; the
//! drawings of a class lie beside it.

use super::bench::Bench;
use super::board::{at, begin, drawing, on_screen, opened};
use serde_json::{Value, json};
use support::files;

fn chips(bench: &mut Bench) -> Value {
    bench.value("[...document.querySelectorAll('#board .chips button')].map((e) => e.dataset.name ?? e.dataset.sign)")
}

#[test]
#[ignore = "needs Chromium"]
fn a_rate_is_asked_for_its_sense() {
    let mut bench = opened("board-sense");
    bench.click("#board [data-tool=compute]");
    bench.settle();
    bench.click("#board .chips [data-name='omega(2)']");
    for press in [
        "[data-name='omega(1)']",
        "[data-sign='^2']",
        "[data-name='L(A,B)']",
        "[data-sign='/']",
        "[data-name='L(B,C)']",
    ] {
        bench.click(&format!("#board .chips {press}"));
        bench.settle();
    }
    let written = "document.querySelector('#board [data-blank=as]').value";
    assert_eq!(bench.text(written), "omega(1)^2*L(A,B)/L(B,C)");
    bench.click("#board .chips [data-sign=back]");
    bench.settle();
    assert_eq!(bench.text(written), "omega(1)^2*L(A,B)/");
    bench.type_text("2");
    bench.click("#board .strip > .main");
    bench.settle();
    assert_eq!(drawing(&mut bench)["did"].as_array().map_or(0, Vec::len), 0, "it has no sense yet");
    assert_eq!(chips(&mut bench), json!(["ccw", "cw", "as_it_comes"]));
    bench.click("#board .chips [data-name=cw]");
    bench.settle();
    let entry = drawing(&mut bench)["did"][0].clone();
    assert_eq!([&entry["as"], &entry["sense"]], [&json!("omega(1)^2*L(A,B)/2"), &json!("cw")]);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn points_that_lie_close_together_are_asked_for() {
    let mut bench = opened("board-close");
    // A tenth of a millimetre of the sheet from the pole.
    let text = json!({ "kinegon_drawing": 1, "mu_v": 5, "did": [
        { "lay_off": "h1", "on": "velocity", "from": "p", "size": 0.5, "along": { "angle": 0 } },
    ] });
    bench.value(&format!("(kinegon.history.draw({}), true)", json!(text.to_string())));
    bench.until("document.querySelectorAll('#board .list li').length === 1");
    bench.click("#board [data-tool=measure]");
    bench.settle();
    let pole = at(&mut bench, "velocity", "p");
    let [x, y] = on_screen(&mut bench, "velocity", pole);
    bench.take_hold([x, y]);
    bench.let_go([x, y]);
    bench.settle();
    assert_eq!(chips(&mut bench), json!(["p", "h1"]));
    bench.click("#board .chips [data-name=h1]");
    bench.settle();
    assert_eq!(bench.text("document.querySelector('#board [data-blank=from]').value"), "h1");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn directions_that_meet_are_asked_for() {
    let mut bench = opened("board-directions");
    bench.click("#board [data-tool=line]");
    bench.settle();
    let joint = at(&mut bench, "scheme", "B");
    let [x, y] = on_screen(&mut bench, "scheme", joint);
    bench.take_hold([x, y]);
    bench.let_go([x, y]);
    bench.settle();
    let offered = chips(&mut bench);
    let mut names: Vec<&str> = offered.as_array().expect("a list").iter().filter_map(Value::as_str).collect();
    names.sort_unstable();
    assert_eq!(names, ["link 1", "link 2"]);
    bench.click("#board .chips [data-name='link 2']");
    bench.settle();
    assert_eq!(bench.text("document.querySelector('#board [data-blank=reference]').value"), "2");
    // The square is turned by a press.
    let how = "document.querySelector('#board [data-blank=how]').value";
    assert_eq!(bench.text(how), "normal");
    bench.click("#board [data-turn=quarter]");
    bench.settle();
    assert_eq!(bench.text(how), "parallel");
    assert_eq!(bench.text("document.querySelector('#board [data-blank=reference]').value"), "2");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn the_drawings_of_a_class_are_told_by_what_was_wrong_first() {
    let mut bench = Bench::of("board-class", &files::read("templates/four-bar.json"));
    let entry = |along: &str, t: u32| json!({ "lay_off": "b", "on": "velocity", "from": "p", "size": "omega(1)*L(A,B)", "along": { along: "1" }, "t": t });
    let of = |name: &str, did: &[Value]| json!({ "name": format!("{name}.json"), "text": json!({ "kinegon_drawing": 1, "name": name, "did": did }).to_string() });
    let class = json!([
        of("Ana", &[entry("normal", 59_000)]),
        of("Ben", &[entry("parallel", 61_000)]),
        of("Cem", &[entry("parallel", 240_000)]),
        of("Dora", &[json!({ "join": "r1", "on": "scheme", "points": ["A", "Z"] })]),
    ]);
    bench.value(&format!("(kinegon.app.handed.set({class}), kinegon.app.drawing.set(true), true)"));
    bench.until("document.querySelectorAll('#board-class .group').length === 3");
    let groups = bench.value(
        "[...document.querySelectorAll('#board-class .group')].map((e) => [e.querySelector('b').textContent, ...[...e.querySelectorAll('button')].map((b) => b.textContent)])",
    );
    assert_eq!(groups, json!([["2 ×", "Ben2 min", "Cem4 min"], ["1 ×", "Ana1 min"], ["1 ×", "Dora"]]));
    bench.press_named("#board-class", "Ben2 min");
    bench.until("document.querySelector('#board .list li.first') !== null");
    bench.picture("board-class");
    // The own drawing is there as it was.
    bench.press_named("#board-class", "Ben2 min");
    bench.settle();
    begin_again(&mut bench);
    bench.assert_quiet();
}

fn begin_again(bench: &mut Bench) {
    assert_eq!(bench.value("document.querySelectorAll('#board .list li').length"), 0);
    bench.click("#board-close");
    begin(bench);
    assert_eq!(drawing(bench)["did"].as_array().map_or(0, Vec::len), 0);
}
