//! A photograph of a drawing: the right plan over it, points that are tapped, what is said of them; pictures that are of no use.

use super::bench::Bench;
use kinegon::Sheet;
use kinegon::drawing::markers::{PlacedPanel, SheetCode};
use resvg::usvg::Options;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::sync::OnceLock;
use support::camera::Photograph;
use support::camera::chance::Kind;
use support::camera::drawn::{Drawing, Panel, drawn};
use support::camera::page::Page;
use support::camera::wrong::Wrong;
use support::files;
use support::ink::outlined;
use support::random::Random;
use support::students::hand::RIGHT;
use support::students::task::Task;

/// Longer side of a picture, in pixels; telephones have 4000.
const EDGE: usize = 2800;

/// How far a crossing that is tapped may be from its true place, in mm; with an arrow head on it.
const SNAPPED: f64 = 0.3;
const ARROW: f64 = 0.8;

/// A photograph of a student's drawing sheet, and the truth about it.
struct Taken {
    jpeg: Vec<u8>,
    code: SheetCode,
    drawing: Drawing,
    photograph: Photograph,
}

/// The photograph of a four-bar linkage's plans, taken once for all tests.
fn four_bar() -> &'static Taken {
    static TAKEN: OnceLock<Taken> = OnceLock::new();
    TAKEN.get_or_init(|| taken("four-bar", "FOUR-BAR", EDGE))
}

/// Photographs the sheet on which somebody has drawn the plans of a starting scene without errors.
fn taken(kind: &'static str, name: &str, edge: usize) -> Taken {
    let text = files::read(&format!("templates/{kind}.json"));
    let task = Task::new(kind, &text).expect("a scene");
    let sheets = task.solution.drawing_sheets(name);
    let sheet = sheets.iter().find(|sheet| is_of_plans(sheet.code.as_ref())).expect("a sheet for plans");
    let code = sheet.code.clone().expect("it has a code");
    let plan = |panel: Sheet| if panel == Sheet::Velocity { 1 } else { 2 };
    let panel = |p: &PlacedPanel| Panel { plan: plan(p.panel), pole: p.origin, mu: Some(p.mu), has_pole: true };
    let panels: Vec<Panel> = code.panels.iter().map(panel).collect();
    let drawing = drawn(&task, None, RIGHT, 1, &panels);
    let size = code.page.size_mm();
    let page = Page::draw(&outlined(&sheet.svg()), size, 24, &Options::default()).printed(&drawing.strokes, 1);
    // The first picture in which the sheet lies as it is read.
    let pictures = (1..).map(|seed| Photograph::random(seed, Kind::Flat, size).with_edge(edge));
    let is_upright = |picture: &Photograph| {
        let truth = picture.truth();
        let [a, b] = [[0.0, 0.0], [size[0], 0.0]].map(|mm| truth.pixel(mm));
        b[0] - a[0] > 3.0 * (b[1] - a[1]).abs()
    };
    let photograph = pictures.into_iter().find(is_upright).expect("there is one");
    Taken { jpeg: photograph.take(Some(&page)).jpeg, code, drawing, photograph }
}

fn is_of_plans(code: Option<&SheetCode>) -> bool {
    code.is_some_and(|code| code.panels.iter().any(|panel| panel.panel == Sheet::Velocity))
}

impl Taken {
    /// Puts the photograph into the test's folder.
    fn file(&self, bench: &Bench) -> PathBuf {
        let file = bench.folder().join("photograph.jpg");
        std::fs::write(&file, &self.jpeg).expect("the test's folder can be written");
        file
    }

    /// Pixels of the picture per mm.
    fn per_mm(&self) -> f64 {
        let [a, b] = [[100.0, 100.0], [110.0, 100.0]].map(|mm| self.photograph.truth().pixel(mm));
        0.1 * libm::hypot(b[0] - a[0], b[1] - a[1])
    }

    /// Where a point of a plan is: on the screen, and in mm from the pole with y up.
    fn place(&self, bench: &mut Bench, plan: usize, name: &str) -> ([f64; 2], [f64; 2]) {
        let mm = self.drawing.place(plan, name).unwrap_or_else(|| panic!("no {name}"));
        let panel = if plan == 1 { Sheet::Velocity } else { Sheet::Acceleration };
        let pole = self.code.panels.iter().find(|p| p.panel == panel).expect("the plan").origin;
        let [x, y] = self.photograph.truth().pixel(mm);
        let on_screen = bench.value(&format!(
            "(() => {{ const m = document.querySelector('#photo .stage g').getScreenCTM(); \
             return [m.a * {x} + m.e, m.d * {y} + m.f]; }})()"
        ));
        (std::array::from_fn(|k| on_screen[k].as_f64().expect("a number")), [mm[0] - pole[0], pole[1] - mm[1]])
    }
}

/// Gives the page a picture and waits until it has looked at it.
fn show(bench: &mut Bench, file: &std::path::Path) {
    bench.give_files("#photo-file", &[file]);
    bench.until("!document.querySelector('#photo').hidden && document.querySelector('#photo').ariaBusy === 'false'");
    bench.frame();
}

/// What the photograph's foot says.
fn said(bench: &mut Bench) -> String {
    bench.text("document.querySelector('#photo .says').textContent")
}

/// Waits until that verdict stands at a point in the picture: `right`, `off`, `open`.
fn until_judged(bench: &mut Bench, key: &str, verdict: &str) {
    bench.until(&format!("document.querySelector('#photo .mark[data-key=\"{key}\"]')?.dataset.kind === '{verdict}'"));
}

/// The places of a plan's points in the form.
fn places(bench: &mut Bench, plan: &str) -> Value {
    bench.value(&format!("JSON.parse(kinegon.history.now.value.form || '{{}}').points?.{plan} ?? {{}}"))
}

fn distance(a: [f64; 2], b: &Value) -> f64 {
    let [x, y] = [0, 1].map(|k| b[k].as_f64().expect("a number"));
    libm::hypot(a[0] - x, a[1] - y)
}

#[test]
#[ignore = "needs Chromium"]
fn points_of_a_photograph_are_checked() {
    let mut bench = Bench::of("photo", &files::read("templates/four-bar.json"));
    bench.panel("check");
    let taken = four_bar();
    let file = taken.file(&bench);
    let begin = bench.number("performance.now()");
    show(&mut bench, &file);
    println!("the right plan lies over it after {:.0} ms", bench.number("performance.now()") - begin);
    assert!(said(&mut bench).contains("point b of the velocity plan"), "{}", said(&mut bench));
    // The right plan lies where the honest student has drawn.
    for (plan, key, name) in [(1, "velocity", "b"), (1, "velocity", "c"), (2, "acceleration", "c")] {
        let ([x, y], _) = taken.place(&mut bench, plan, name);
        let off = bench.number(&format!(
            "Math.min(...[...document.querySelectorAll('#photo .right')].map((e) => {{ const r = e.firstChild.getBoundingClientRect(); \
             return Math.hypot(r.x + r.width / 2 - {x}, r.y + r.height / 2 - {y}); }}))"
        ));
        assert!(off < 1.0, "the right {name} of the {key} plan is {off} pixels away");
    }
    bench.picture("photo");
    // Nothing is taken without being asked.
    bench.until("document.querySelector('#photo .guess') !== null");
    assert_eq!(places(&mut bench, "velocity"), json!({}));
    // The guess of the chosen point is accepted by a tap on it. An arrow head stands there.
    let ([x, y], b) = taken.place(&mut bench, 1, "b");
    bench.drag(&[[x + 2.0, y - 3.0]]);
    until_judged(&mut bench, "velocity/b", "right");
    let own = places(&mut bench, "velocity");
    assert!(distance(b, &own["b"]) < ARROW, "{b:?} {own}");
    assert!(own["b"][2].as_f64().is_some_and(|band| band > 0.0 && band < 1.0), "{own}");
    // Who aims beside a crossing gets the crossing.
    let ([x, y], c) = taken.place(&mut bench, 1, "c");
    bench.take_hold([x + 3.0, y + 3.0]);
    bench.until("!document.querySelector('#photo .loupe').hidden");
    bench.let_go([x + 3.0, y + 3.0]);
    until_judged(&mut bench, "velocity/c", "right");
    let own = places(&mut bench, "velocity");
    assert!(distance(c, &own["c"]) < SNAPPED, "{c:?} {own}");
    assert!(own["p"].is_array(), "the pole is where it is printed: {own}");
    bench.press_named("#photo .actions", "Accept all");
    for (plan, key, names) in [(1, "velocity", ["b", "c"]), (2, "acceleration", ["b", "c"])] {
        let own = places(&mut bench, key);
        for name in names {
            let (_, at) = taken.place(&mut bench, plan, name);
            assert!(distance(at, &own[name]) < ARROW, "{key} {name}: {at:?} {own}");
            until_judged(&mut bench, &format!("{key}/{name}"), "right");
        }
    }
    bench.until("/✓/.test(document.querySelector('#panel-check .counts').textContent)");
    assert!(!bench.text("document.querySelector('#panel-check .counts').textContent").contains('✗'));
    assert!(said(&mut bench).starts_with("All points are marked"), "{}", said(&mut bench));
    bench.picture("photo-marked");
    on_the_board(&mut bench, taken);
    // A point that is elsewhere is off, there and in the check; undo brings it back.
    let good = bench.text("kinegon.history.now.value.form");
    bench.click("#photo .chips [data-key='velocity/c']");
    for _ in 0..12 {
        bench.press("Shift+ArrowDown");
    }
    until_judged(&mut bench, "velocity/c", "off");
    assert!(said(&mut bench).starts_with("c is off by"), "{}", said(&mut bench));
    bench.until("/✗/.test(document.querySelector('#panel-check .counts').textContent)");
    bench.picture("photo-off");
    bench.click("#photo-undo");
    bench.settle();
    assert_eq!(bench.text("kinegon.history.now.value.form"), good);
    until_judged(&mut bench, "velocity/c", "right");
    bench.click("#photo-close");
    assert_eq!(bench.value("document.querySelector('#photo').hidden"), true);
    bench.assert_quiet();
}

/// The points go on as marks on the board, where they are on the paper, and are right there.
fn on_the_board(bench: &mut Bench, taken: &Taken) {
    bench.press_named("#photo .actions", "Go on with them on the board");
    bench.until("document.querySelector('#board')?.hidden === false");
    let text = bench.text("kinegon.history.now.value.drawing");
    let drawing: Value = serde_json::from_str(&text).expect("a drawing is JSON");
    let judged =
        bench.value("kinegon.engine.board_judge(kinegon.app.solved.value.good, kinegon.history.now.value.drawing)");
    assert_eq!(judged["first_wrong"], Value::Null, "{judged}");
    for (plan, sheet, scale) in [(1, "velocity", "mu_v"), (2, "acceleration", "mu_a")] {
        let panel = if plan == 1 { Sheet::Velocity } else { Sheet::Acceleration };
        let printed = taken.code.panels.iter().find(|p| p.panel == panel).expect("the plan").mu;
        for name in ["b", "c"] {
            let mut marks = drawing["did"].as_array().expect("entries").iter();
            let mark = marks.find(|entry| entry["mark"] == name && entry["on"] == sheet).expect("a mark");
            let (_, at) = taken.place(bench, plan, name);
            let ratio = printed / drawing[scale].as_f64().expect("a scale");
            assert!(distance(at.map(|mm| mm * ratio), &mark["drawn"]) < ARROW, "{sheet} {name}: {at:?} {mark}");
        }
    }
    bench.picture("photo-on-the-board");
    // A second time nothing comes twice.
    bench.press("Escape");
    bench.until("document.querySelector('#board').hidden");
    bench.press_named("#photo .actions", "Go on with them on the board");
    bench.until("!document.querySelector('#board').hidden");
    assert_eq!(bench.text("kinegon.history.now.value.drawing"), text);
    bench.press("Escape");
    bench.until("document.querySelector('#board').hidden");
}

#[test]
#[ignore = "needs Chromium"]
fn a_point_is_marked_beside_another() {
    let mut bench = Bench::of("photo-beside", &files::read("templates/four-bar.json"));
    bench.panel("check");
    let file = four_bar().file(&bench);
    show(&mut bench, &file);
    let ([x, y], _) = four_bar().place(&mut bench, 1, "b");
    bench.until("document.querySelector('#photo .guess') !== null");
    bench.drag(&[[x + 2.0, y - 3.0]]);
    until_judged(&mut bench, "velocity/b", "right");
    let b = places(&mut bench, "velocity")["b"].clone();
    // The next point lies nine pixels beside the first: the tap is for it, and the first stays.
    assert!(said(&mut bench).contains("point c"), "{}", said(&mut bench));
    bench.drag(&[[x, y + 9.0]]);
    bench.until("document.querySelector('#photo .mark[data-key=\"velocity/c\"]') !== null");
    let own = places(&mut bench, "velocity");
    assert_eq!(own["b"], b);
    let [c, first] = ["c", "b"].map(|name| [0, 1].map(|k| own[name][k].as_f64().expect("a number")));
    assert!(libm::hypot(c[0] - first[0], c[1] - first[1]) > 0.5, "{own}");
    // What a mouse does at this size is stated: four pixels.
    let pixels = 4.0 / bench.number("document.querySelector('#photo .stage g').getScreenCTM().a");
    let per_mm = four_bar().per_mm();
    let band = own["c"][2].as_f64().expect("a band");
    assert!(band >= 0.9 * pixels / per_mm && band < 1.5 * (pixels / per_mm).max(0.3), "{band} {pixels} {per_mm}");
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn a_photograph_fills_a_telephone() {
    let mut bench = Bench::closed("photo-telephone", None);
    bench.telephone([390, 844]);
    bench.load("");
    bench.put(&files::read("templates/four-bar.json"));
    bench.panel("check");
    let taken = four_bar();
    let file = taken.file(&bench);
    show(&mut bench, &file);
    let filled = "(() => { const r = document.querySelector('#photo').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()";
    assert_eq!(bench.value(filled), json!([0, 0, 390, 844]));
    // A finger that stays sees the place magnified, and the place goes to the crossing when it is lifted.
    bench.click("#photo .chips [data-key='velocity/c']");
    bench.frame();
    let ([x, y], c) = taken.place(&mut bench, 1, "c");
    let point = |[x, y]: [f64; 2]| json!([{ "x": x, "y": y, "id": 0 }]);
    bench.call("Input.dispatchTouchEvent", json!({ "type": "touchStart", "touchPoints": point([x + 4.0, y + 5.0]) }));
    bench.until("!document.querySelector('#photo .loupe').hidden");
    bench.picture("photo-loupe");
    bench.call("Input.dispatchTouchEvent", json!({ "type": "touchEnd", "touchPoints": [] }));
    bench.until("document.querySelector('#photo .mark') !== null");
    let own = places(&mut bench, "velocity");
    assert!(distance(c, &own["c"]) < SNAPPED, "{c:?} {own}");
    assert_eq!(bench.value("document.querySelector('#photo .loupe').hidden"), true);
    // Two fingers enlarge, and mark nothing.
    let before = bench.text("kinegon.history.now.value.form");
    let scale = "document.querySelector('#photo .stage g').getCTM().a";
    let was = bench.number(scale);
    bench.touch(&[&[[150.0, 300.0], [240.0, 300.0]], &[[100.0, 300.0], [290.0, 300.0]]]);
    bench.until(&format!("{scale} > 1.5 * {was}"));
    assert_eq!(bench.text("kinegon.history.now.value.form"), before);
    bench.value(&super::access::axe());
    for look in ["light", "dark"] {
        bench.media("", &[("prefers-color-scheme", look), ("prefers-reduced-motion", "reduce")]);
        bench.settle();
        bench.picture(&format!("photo-telephone-{look}"));
        let violations = "axe.run(document, { resultTypes: ['violations'] }).then(({ violations }) => \
             violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).join(', ')}`))";
        assert_eq!(bench.value(violations), json!([]), "{look}");
    }
    bench.assert_quiet();
}

#[test]
#[ignore = "needs Chromium"]
fn pictures_of_no_use_say_what_to_do() {
    let mut bench = Bench::of("photo-refused", &files::read("templates/slider-crank.json"));
    bench.panel("check");
    // A desk with a page of writing.
    let size = [297.0, 210.0];
    let photograph = Photograph::random(1, Kind::Flat, size).with_edge(1200);
    let page = Wrong::Text
        .svg(size, &mut Random(1))
        .map(|svg| Page::draw(&svg, size, 12, &Options::default()).printed(&[], 1));
    let file = bench.folder().join("writing.jpg");
    std::fs::write(&file, photograph.take(page.as_ref()).jpeg).expect("written");
    show(&mut bench, &file);
    let says = said(&mut bench);
    assert!(says.contains("markers") && says.contains("all eight black squares"), "{says}");
    bench.picture("photo-refused");
    // The sheet of another scene.
    let other = taken("four-bar", "FOUR-BAR-7-2", EDGE / 2);
    let file = other.file(&bench);
    show(&mut bench, &file);
    let says = said(&mut bench);
    assert!(says.contains("FOUR-BAR-7-2") && says.contains("not of this scene"), "{says}");
    assert_eq!(bench.value("document.querySelector('#photo .right')"), Value::Null);
    // No picture at all; in Spanish.
    bench.choose("#language", "Español");
    let file = bench.folder().join("dibujo.heic");
    std::fs::write(&file, "no picture").expect("written");
    show(&mut bench, &file);
    let says = said(&mut bench);
    assert!(says.contains("dibujo.heic") && says.contains("JPEG"), "{says}");
    // There is a way on, and a way back.
    assert_eq!(bench.value("document.activeElement.textContent"), "Otra fotografía…");
    bench.press("Escape");
    assert_eq!(bench.value("document.querySelector('#photo').hidden"), true);
    bench.assert_quiet();
}
