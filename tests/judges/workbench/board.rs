//! The plans are drawn on the board: the velocity plan of a four-bar by mouse, by finger, by keys alone and by the list alone, in few
//! gestures each; what is wrong is named; what is drawn is there again.

use super::access;
use super::bench::Bench;
use serde_json::{Value, json};
use support::files;

/// Most gestures for the velocity plan of a four-bar: presses, pulls, keys, or words typed in one go.
const MOST_GESTURES: usize = 25;

/// The velocity of C of templates/four-bar.json in mm/s, from its geometry: v_C ⊥ CD, and v_C − v_B ⊥ BC.
fn velocity_of_c() -> [f64; 2] {
    let (sin, cos) = libm::sincos(60f64.to_radians());
    let (b, d) = ([60.0 * cos, 60.0 * sin], [160.0, 0.0]);
    // C is 140 from B and 110 from D, on the upper side.
    let (way, apart) = ([d[0] - b[0], d[1] - b[1]], libm::hypot(d[0] - b[0], d[1] - b[1]));
    let along = (140.0 * 140.0 - 110.0 * 110.0 + apart * apart) / (2.0 * apart);
    let up = libm::sqrt(140.0 * 140.0 - along * along);
    let unit = way.map(|part| part / apart);
    let c = [b[0] + along * unit[0] - up * unit[1], b[1] + along * unit[1] + up * unit[0]];
    let v_b = [-10.0 * b[1], 10.0 * b[0]];
    // v_C = ω₃ (C − D) turned by a quarter; its part along BC is that of v_B.
    let (bc, dc) = ([c[0] - b[0], c[1] - b[1]], [c[0] - d[0], c[1] - d[1]]);
    let omega = (v_b[0] * bc[0] + v_b[1] * bc[1]) / (-dc[1] * bc[0] + dc[0] * bc[1]);
    [-omega * dc[1], omega * dc[0]]
}

/// A bench with the board over the page.
pub fn opened(name: &str) -> Bench {
    let mut bench = Bench::of(name, &files::read("templates/four-bar.json"));
    begin(&mut bench);
    bench
}

pub fn begin(bench: &mut Bench) {
    begin_on(bench, "velocity");
}

/// Opens the board, on which this sheet is drawn on.
fn begin_on(bench: &mut Bench, sheet: &str) {
    bench.panel("check");
    // What stands above it comes from the engine, and moves it.
    bench.until("document.querySelector('#board-begin')?.getClientRects().length > 0");
    let words = bench.text("document.querySelector('#board-begin').textContent");
    bench.press_named("#panel-check", &words);
    bench.until(&format!("document.querySelector('#board .over[data-sheet={sheet}]')?.dataset.window !== undefined"));
    bench.until("document.activeElement.closest('#board') !== null");
    bench.settle();
}

pub fn drawing(bench: &mut Bench) -> Value {
    let text = bench.text("kinegon.history.now.value.drawing || '{\"did\":[]}'");
    serde_json::from_str(&text).expect("a drawing is JSON")
}

/// What the engine says of the drawing.
pub fn known(bench: &mut Bench) -> Value {
    bench.value("kinegon.engine.board(kinegon.app.solved.value.good, kinegon.history.now.value.drawing ?? '')")
}

/// Where a thing of a sheet is, in mm of the sheet.
pub fn at(bench: &mut Bench, sheet: &str, name: &str) -> [f64; 2] {
    let known = known(bench);
    let things = known["things"].as_array().expect("things");
    let found = things.iter().find(|thing| thing["sheet"] == sheet && thing["name"] == name);
    let place = &found.unwrap_or_else(|| panic!("no {name} on {sheet}: {known}"))["at"];
    [0, 1].map(|k| place[k].as_f64().expect("a number"))
}

/// Where a place of a sheet is on the screen.
pub fn on_screen(bench: &mut Bench, sheet: &str, [x, y]: [f64; 2]) -> [f64; 2] {
    let place = bench.value(&format!(
        "(() => {{ const e = document.querySelector('#board .over[data-sheet={sheet}]'); const [l, t, s] = JSON.parse(e.dataset.window); \
         const r = e.getBoundingClientRect(); return [r.left + ({x} - l) * s, r.top + ({y} - t) * s]; }})()"
    ));
    [0, 1].map(|k| place[k].as_f64().expect("a number"))
}

/// A hand that counts what it does.
pub struct Hand<'b> {
    pub bench: &'b mut Bench,
    pub is_finger: bool,
    pub gestures: usize,
}

impl Hand<'_> {
    fn press(&mut self, selector: &str) {
        self.gestures += 1;
        if self.is_finger {
            self.bench.tap(selector);
        } else {
            self.bench.click(selector);
        }
        self.bench.settle();
    }

    fn tool(&mut self, name: &str) {
        self.press(&format!("#board [data-tool={name}]"));
    }

    fn chip(&mut self, name: &str) {
        self.bench.until(&format!("document.querySelector({}) !== null", json!(chip(name))));
        self.press(&chip(name));
    }

    /// A press at a thing.
    fn at(&mut self, sheet: &str, name: &str) {
        let place = at(self.bench, sheet, name);
        self.place(sheet, place);
    }

    fn place(&mut self, sheet: &str, place: [f64; 2]) {
        self.gestures += 1;
        let [x, y] = on_screen(self.bench, sheet, place);
        if self.is_finger {
            self.bench.touch(&[&[[x, y]]]);
        } else {
            self.bench.take_hold([x, y]);
            self.bench.let_go([x, y]);
        }
        self.bench.settle();
    }

    /// The velocity plan; `coupler`: the link to which the first line is normal.
    pub fn velocity_plan(&mut self, coupler: &str) {
        self.tool("lay_off");
        self.chip("omega(1)");
        self.chip("L(A,B)");
        self.at("velocity", "p");
        self.at("scheme", "1");
        self.chip("b");
        self.tool("line");
        self.at("scheme", coupler);
        self.at("velocity", "b");
        self.at("scheme", "3");
        self.at("velocity", "p");
        self.tool("cross");
        let crossing = crossing(self.bench);
        self.place("velocity", crossing);
        self.chip("c");
        self.tool("measure");
        self.at("velocity", "b");
        self.at("velocity", "c");
    }
}

fn chip(name: &str) -> String {
    format!("#board .chips [data-name=\"{name}\"]")
}

/// Where lines cross.
fn crossing(bench: &mut Bench) -> [f64; 2] {
    crossing_on(bench, "velocity")
}

fn crossing_on(bench: &mut Bench, sheet: &str) -> [f64; 2] {
    let ask = json!({ "has": { "cross": "" }, "sheet": sheet, "at": [0, 0], "reach": 1e4 });
    let found = bench.value(&format!(
        "kinegon.engine.board_snap(kinegon.app.solved.value.good, kinegon.history.now.value.drawing, {ask})"
    ));
    [0, 1].map(|k| found[0]["at"][k].as_f64().unwrap_or_else(|| panic!("no lines cross: {found}")))
}

/// Whether the drawing is the right plan: c is where geometry has it, and every operation is right.
fn holds(bench: &mut Bench) {
    let known = known(bench);
    let sheets = known["sheets"].as_array().expect("sheets");
    let pole = &sheets.iter().find(|sheet| sheet["sheet"] == "velocity").expect("a plan")["pole"];
    let scale = drawing(bench)["mu_v"].as_f64().expect("the drawing says its scale");
    let c = at(bench, "velocity", "c");
    let [x, y] =
        [(c[0] - pole[0].as_f64().expect("a number")) * scale, (pole[1].as_f64().expect("a number") - c[1]) * scale];
    let [v_x, v_y] = velocity_of_c();
    assert!(libm::hypot(x - v_x, y - v_y) < 1e-6 * libm::hypot(v_x, v_y), "[{x}, {y}] for [{v_x}, {v_y}]");
    let judged = judged(bench);
    let verdicts = judged["entries"].as_array().expect("verdicts");
    let is_good = |entry: &Value| ["right", "unused", "undone"].iter().any(|good| entry["verdict"] == *good);
    assert!(verdicts.iter().all(is_good), "{judged}");
    assert_eq!(judged["first_wrong"], Value::Null);
}

fn judged(bench: &mut Bench) -> Value {
    bench.value("kinegon.engine.board_judge(kinegon.app.solved.value.good, kinegon.history.now.value.drawing)")
}

#[test]
#[ignore = "needs Chromium"]
fn a_velocity_plan_by_mouse() {
    let mut bench = opened("board-mouse");
    let mut hand = Hand { bench: &mut bench, is_finger: false, gestures: 0 };
    hand.velocity_plan("2");
    assert!(hand.gestures <= MOST_GESTURES, "{} gestures", hand.gestures);
    holds(&mut bench);
    bench.picture("board-mouse");
    // What is taken back stands no longer, and comes again; nothing is taken out of the file.
    let drawn = drawing(&mut bench)["did"].as_array().expect("entries").len();
    bench.click("#board-undo");
    bench.settle();
    assert_eq!(drawing(&mut bench)["did"][drawn], json!({ "undo": 1, "t": drawing(&mut bench)["did"][drawn]["t"] }));
    bench.click("#board-redo");
    bench.settle();
    holds(&mut bench);
    // The rubber takes a thing with what hangs on it: r1, c and the measure; r2 and b stay.
    let mut hand = Hand { bench: &mut bench, is_finger: false, gestures: 0 };
    hand.tool("rub");
    bench.choose("#board select[data-blank=name]", "Velocity: line r1");
    bench.click("#board .strip .main");
    bench.settle();
    let known = known(&mut bench);
    let left: Vec<&str> = known["things"]
        .as_array()
        .expect("things")
        .iter()
        .filter(|t| !t["entry"].is_null())
        .filter_map(|t| t["name"].as_str())
        .collect();
    assert_eq!(left, ["b", "r2"]);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_velocity_plan_by_finger() {
    let mut bench = Bench::of("board-finger", &files::read("templates/four-bar.json"));
    bench.telephone([390, 844]);
    bench.settle();
    begin(&mut bench);
    let mut hand = Hand { bench: &mut bench, is_finger: true, gestures: 0 };
    hand.velocity_plan("2");
    assert!(hand.gestures <= MOST_GESTURES, "{} gestures", hand.gestures);
    holds(&mut bench);
    bench.picture("board-finger");
    // Two fingers zoom and draw nothing.
    let before = drawing(&mut bench);
    let window = |bench: &mut Bench| {
        bench.number("JSON.parse(document.querySelector('#board .over[data-sheet=velocity]').dataset.window)[2]")
    };
    let scale = window(&mut bench);
    let [x, y, ..] = bench.place("#board .over[data-sheet=velocity]");
    let ways: Vec<[[f64; 2]; 2]> =
        (0..=8).map(|k| [[x - 30.0 - 4.0 * f64::from(k), y], [x + 30.0 + 4.0 * f64::from(k), y]]).collect();
    bench.touch(&ways.iter().map(<[_; 2]>::as_slice).collect::<Vec<_>>());
    bench.settle();
    assert!(window(&mut bench) > 1.5 * scale);
    assert_eq!(drawing(&mut bench), before);
    // On the narrowest screen nothing is beyond its edge.
    bench.telephone([320, 568]);
    bench.settle();
    let beyond = bench.value(
        "[document.documentElement.scrollWidth <= innerWidth, ...[...document.querySelectorAll('#board > .head button, #board .strip > *')] \
         .filter((e) => e.getClientRects().length > 0 && e.getBoundingClientRect().right > innerWidth).map((e) => e.id || e.className)]",
    );
    assert_eq!(beyond, json!([true]));
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_velocity_plan_by_keys_alone() {
    let mut bench = opened("board-keys");
    let mut gestures = 0;
    let mut press = |bench: &mut Bench, key: &str| {
        gestures += 1;
        bench.press(key);
        bench.settle();
    };
    // Goes on with N until it is heard what is possible there.
    let go_to = |bench: &mut Bench, press: &mut dyn FnMut(&mut Bench, &str), words: &str| {
        for _ in 0..8 {
            let spoken = bench.text("document.querySelector('#spoken').textContent");
            if spoken == words || spoken.ends_with(&format!(" {words}")) {
                return press(bench, "Enter");
            }
            press(bench, "n");
        }
        panic!("no {words}: {}", bench.text("document.querySelector('#spoken').textContent"));
    };
    press(&mut bench, "d");
    bench.type_text("omega(1)*L(A,B)");
    press(&mut bench, "Enter");
    go_to(&mut bench, &mut press, "p");
    go_to(&mut bench, &mut press, "1");
    press(&mut bench, "Enter");
    press(&mut bench, "s");
    go_to(&mut bench, &mut press, "2");
    go_to(&mut bench, &mut press, "b");
    go_to(&mut bench, &mut press, "3");
    go_to(&mut bench, &mut press, "p");
    press(&mut bench, "p");
    go_to(&mut bench, &mut press, "r2");
    bench.until("document.activeElement.dataset.name === 'c'");
    press(&mut bench, "Enter");
    // With the words that were typed.
    assert!(gestures < MOST_GESTURES, "{gestures} gestures");
    holds(&mut bench);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_velocity_plan_by_the_list_alone() {
    let mut bench = opened("board-list");
    let mut gestures = 0;
    let rows: [(&str, &[(&str, &str)]); 4] = [
        ("lay_off", &[("size", "omega(1)*L(A,B)"), ("from", "p"), ("reference", "1"), ("name", "b")]),
        ("line", &[("reference", "2"), ("through", "b")]),
        ("line", &[("reference", "3"), ("through", "p")]),
        ("cross", &[("first", "r1"), ("second", "r2"), ("name", "c")]),
    ];
    let mut tool = "";
    for (next, blanks) in rows {
        if tool != next {
            bench.click(&format!("#board [data-tool={next}]"));
            gestures += 1;
        }
        tool = next;
        for (blank, value) in blanks {
            let set = format!(
                "(() => {{ const e = document.querySelector('#board .entry-form [data-blank={blank}]'); e.focus(); e.value = {}; \
                 e.dispatchEvent(new Event(e.tagName === 'SELECT' ? 'change' : 'input')); return e.value; }})()",
                json!(value)
            );
            assert_eq!(bench.text(&set), *value, "{next}, {blank}");
            gestures += 1;
        }
        bench.click("#board .strip > .main");
        bench.settle();
        gestures += 1;
    }
    assert!(gestures <= MOST_GESTURES, "{gestures} gestures");
    holds(&mut bench);
    // Each is said with its numbers.
    let rows = bench.value("[...document.querySelectorAll('#board .list .what')].map((e) => e.textContent)");
    assert_eq!(rows.as_array().map(Vec::len), Some(4), "{rows}");
    // What cannot be is not written, and it is said why.
    bench.click("#board [data-tool=compute]");
    bench.fill("#board [data-blank=name]", "x1");
    bench.fill("#board [data-blank=as]", "2*unknown");
    bench.click("#board .strip > .main");
    bench.settle();
    assert_eq!(drawing(&mut bench)["did"].as_array().map(Vec::len), Some(4));
    assert!(bench.text("document.querySelector('#board .says.bad').textContent").contains("unknown"));
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn the_first_wrong_operation_is_named_and_hints_are_counted() {
    let mut bench = opened("board-wrong");
    bench.click("#board-hint");
    bench.settle();
    assert_ne!(bench.text("document.querySelector('#board .says').textContent"), "");
    assert_eq!(drawing(&mut bench)["hints"], 1);
    let mut hand = Hand { bench: &mut bench, is_finger: false, gestures: 0 };
    // The line through b is normal to the crank in place of the coupler.
    hand.velocity_plan("1");
    bench.click("#board-check");
    bench.settle();
    assert_eq!(judged(&mut bench)["first_wrong"], 1);
    assert_eq!(
        bench.value("[...document.querySelectorAll('#board .list li')].findIndex((e) => e.matches('.first'))"),
        1
    );
    bench.picture("board-wrong");
    // It is kept.
    bench.value("new Promise((done) => setTimeout(done, 500))");
    let before = drawing(&mut bench);
    bench.load("");
    begin(&mut bench);
    assert_eq!(drawing(&mut bench), before);
    // As a student's exam nothing is told of it, and the file is handed in.
    let use_ = json!({ "mode": "exam", "snap": "all", "at_once": false });
    bench.value(&format!("kinegon.app.board.set({use_})"));
    assert_eq!(
        bench.value("['#board-hint', '#board-check'].map((id) => document.querySelector(id).hidden)"),
        json!([true, true])
    );
    bench.click("#board-hand-in");
    let (name, bytes) = bench.saved(|browser| browser.click("#board-hand-in-now"));
    assert!(name.ends_with("-drawing.json"), "{name}");
    assert_eq!(serde_json::from_slice::<Value>(&bytes).expect("JSON"), drawing(&mut bench));
    // Replayed, it is shown as far as the slider says.
    bench.value("kinegon.app.board.set(null)");
    bench.click("#board-more");
    bench.press_named("#board-files", "Replay");
    bench.settle();
    assert_eq!(bench.text("document.querySelector('#board .replay output').textContent").split(' ').next(), Some("0"));
    bench.focus("#board .replay input");
    bench.press("ArrowRight");
    bench.settle();
    assert_eq!(bench.value("document.querySelectorAll('#board .list li').length"), 1);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn axe_finds_nothing_on_the_board() {
    let axe = access::axe();
    let mut bench = opened("board-axe");
    bench.value(&axe);
    let mut hand = Hand { bench: &mut bench, is_finger: false, gestures: 0 };
    hand.velocity_plan("1");
    bench.click("#board-check");
    let mut found = Vec::new();
    for (look, is_small) in [("light", false), ("dark", false), ("light", true)] {
        bench.media("", &[("prefers-color-scheme", look), ("prefers-reduced-motion", "reduce")]);
        if is_small {
            bench.telephone([360, 640]);
        }
        for tool in ["lay_off", "line", "join", "cross", "like", "measure", "compute", "solve", "rub"] {
            bench.value(&format!("document.querySelector('#board [data-tool={tool}]').click()"));
            bench.settle();
            bench.picture(&format!("board-{look}-{tool}{}", if is_small { "-small" } else { "" }));
            let violations = bench.value(&access::run("{}"));
            found.extend(violations.as_array().expect("a list").iter().map(|v| format!("{look}, {tool}: {v}")));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    bench.assert_quiet();
}

/// The centre of the coupler of templates/slider-crank.json: on the crank's line and above the block, by its geometry.
fn instant_centre_by(name: &str, size: [u32; 2], is_finger: bool) {
    let mut scene: Value = serde_json::from_str(&files::read("templates/slider-crank.json")).expect("a scene");
    scene["figure"] = json!({ "panels": ["scheme", "centers"], "centers": ["P(2,ground)"] });
    let mut bench = Bench::of(name, &scene.to_string());
    if is_finger {
        bench.telephone(size);
        bench.settle();
    }
    begin_on(&mut bench, "centers");
    let mut hand = Hand { bench: &mut bench, is_finger, gestures: 0 };
    hand.tool("join");
    hand.at("centers", "A");
    hand.at("centers", "B");
    hand.tool("line");
    hand.at("scheme", "3/ground");
    // The guide and the rod meet at the block's pin.
    hand.chip("guide 3/ground");
    hand.at("centers", "C");
    hand.tool("cross");
    let at_crossing = crossing_on(hand.bench, "centers");
    hand.place("centers", at_crossing);
    hand.chip("P(2,ground)");
    assert!(hand.gestures <= MOST_GESTURES, "{} gestures", hand.gestures);
    bench.picture(name);
    let [a, b, c, p] = ["A", "B", "C", "P(2,ground)"].map(|name| at(&mut bench, "centers", name));
    let right = [c[0], a[1] + (b[1] - a[1]) * (c[0] - a[0]) / (b[0] - a[0])];
    assert!(libm::hypot(p[0] - right[0], p[1] - right[1]) < 0.02, "{p:?} for {right:?}");
    assert_eq!(judged(&mut bench)["first_wrong"], Value::Null);
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn an_instant_centre_by_mouse_and_by_finger() {
    instant_centre_by("board-centers-mouse", [1280, 800], false);
    instant_centre_by("board-centers-finger", [390, 844], true);
}
