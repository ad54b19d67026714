//! How work grows with a scene: what takes a time that doubles with it takes four times as long for four times as much, and
//! not sixteen times. Time is that of this thread on its core, where the system tells it.

use kinegon::accuracy::bounds;
use kinegon::board::{Given, HandDrawing, Judge, own_drawing};
use kinegon::check::{AnswerKey, DEPTH, Measured, check, form_names};
use kinegon::construction::Tolerance;
use kinegon::drawing::{Film, HeldLayout, Timing};
use kinegon::editing::{tables_in_files, with_tables};
use kinegon::exercise::{ExerciseError, Exercises};
use kinegon::kernel::Kernel;
use kinegon::mechanism::mechanism;
use kinegon::position::counted_poses;
use kinegon::quantity::step_pencil;
use kinegon::scene::{GivenBy, Scene};
use kinegon::study::{Study, StudyFile};
use kinegon::{Order, Solution, posed};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::{Duration, Instant};
use support::stages::{answer_key, solved};
use support::survey::Size;

/// The time that this thread has been at work.
fn busy(began: Instant) -> Duration {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let told = told.and_then(|told| told.split(' ').next()?.parse().ok());
    told.map_or_else(|| began.elapsed(), Duration::from_nanos)
}

/// Work is repeated until it takes so long: some systems count a thread's time in ticks of 4 ms.
const LEAST: Duration = Duration::from_millis(60);
/// What takes longer than this is measured once: a thread's time of so long says enough.
const LONG: Duration = Duration::from_millis(300);

/// How many times as long work takes for 4 n as for n, the best of three.
fn growth<T>(n: usize, prepare: impl Fn(usize) -> T, work: impl Fn(&T)) -> f64 {
    let [small, large] = [n, 4 * n].map(|size| seconds(&prepare(size), &work));
    println!("{n}: {:.1} ms, {}: {:.1} ms", 1e3 * small, 4 * n, 1e3 * large);
    large / small
}

/// How long work takes, the best of three.
fn seconds<T>(prepared: &T, work: impl Fn(&T)) -> f64 {
    let began = Instant::now();
    let mut shortest = Duration::MAX;
    for _ in 0..3 {
        let before = busy(began);
        let mut rounds = 0;
        let each = loop {
            work(prepared);
            rounds += 1;
            let took = busy(began) - before;
            if took >= LEAST {
                break took / rounds;
            }
        };
        shortest = shortest.min(each);
        if each >= LONG {
            break;
        }
    }
    shortest.as_secs_f64()
}

/// Four times as long, or a little more on a machine that others use.
fn is_in_proportion(what: &str, growth: f64) {
    grows_at_most(9.0, what, growth);
}

fn grows_at_most(most: f64, what: &str, growth: f64) {
    assert!(growth < most, "{what}: four times as much takes {growth:.1} times as long");
}

/// A four-bar with so many further points on its coupler.
fn many_points(count: usize) -> String {
    let mut shape = String::new();
    for k in 0..count {
        let (x, y) = (0.14 * k as f64, 5.0 + (k * 37 % 140) as f64);
        write!(shape, r#", "P{k}": [{x:.3}, {y}]"#).expect("a string takes all");
    }
    four_bar("points", &shape)
}

fn four_bar(title: &str, shape: &str) -> String {
    format!(
        r#"{{ "kinegon": 1, "title": "{title}", "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [160, 0] }},
            "links": {{
                "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 60 }}, "drive": {{ "angle": 60, "omega": 10 }} }},
                "2": {{ "shape": {{ "B": [0, 0], "C": [140, 0]{shape} }} }},
                "3": {{ "points": ["D", "C"], "lengths": {{ "CD": 110 }} }} }},
            "near": {{ "C": [155, 110] }} }}"#
    )
}

/// So many four-bars side by side, with a place for each moving joint in `near`.
fn four_bars(count: usize) -> String {
    let (mut ground, mut links, mut near) = (String::new(), String::new(), String::new());
    for k in 0..count {
        let comma = if k == 0 { "" } else { "," };
        let (x, y) = (400 * (k % 40), 400 * (k / 40));
        let written = [
            write!(ground, r#"{comma} "A{k}": [{x}, {y}], "D{k}": [{}, {y}]"#, x + 160),
            write!(
                links,
                r#"{comma} "a{k}": {{ "points": ["A{k}", "B{k}"], "lengths": {{ "A{k}-B{k}": 60 }}, "drive": {{ "angle": 60, "omega": 10 }} }},
                "b{k}": {{ "points": ["B{k}", "C{k}"], "lengths": {{ "B{k}-C{k}": 140 }} }},
                "c{k}": {{ "points": ["D{k}", "C{k}"], "lengths": {{ "C{k}-D{k}": 110 }} }}"#
            ),
            write!(near, r#"{comma} "C{k}": [{}, {}]"#, x + 155, y + 110),
        ];
        assert!(written.iter().all(Result::is_ok), "a string takes all");
    }
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ {ground} }}, "links": {{ {links} }}, "near": {{ {near} }} }}"#
    )
}

fn solution(text: &str) -> Solution {
    solved(text).expect("a good scene")
}

#[test]
fn points_of_a_link() {
    let with = |count: usize| solution(&many_points(count));
    is_in_proportion(
        "bands",
        growth(200, with, |own| {
            step_pencil(own, Tolerance::default()).expect("it can be drawn");
        }),
    );
    // The search for names' places is bounded, and is most of it.
    is_in_proportion("a figure", growth(400, with, |own| drop(own.figure())));
    is_in_proportion("a figure in steps", growth(300, with, |own| drop(own.coarse_figure())));
}

#[test]
fn linkages_side_by_side() {
    let read = |count: usize| Scene::read(&four_bars(count)).expect("a good scene");
    let limit = kinegon::scene::SizeLimit::NUMBERS;
    // Proofs touch much memory, which a large mechanism has less near at hand.
    grows_at_most(
        12.0,
        "solving",
        growth(80, read, |scene| {
            let (mechanism, pose) = posed(scene, limit, None).expect("it can be put together");
            Solution::new(scene.clone(), mechanism, pose, Order::Acceleration).expect("it moves");
        }),
    );
    is_in_proportion(
        "modes",
        growth(80, read, |scene| {
            let mechanism = mechanism(scene).expect("it is one");
            let listed = counted_poses(&mechanism, &scene.near).expect("it can be put together");
            assert!(listed.poses.len() * mechanism.points.len() <= 400_000);
        }),
    );
}

/// In a construction that nobody draws by hand each value is judged, and no cause is looked for: places for mistakes grow with the square
/// of the links, and explanations with them.
#[test]
fn forms_of_nonsense_for_many_links() {
    let nonsense = |own: &Solution| {
        let values = form_names(&own.construction).into_iter().zip(0..);
        let values = values.map(|(name, k)| (name, format!("{}.{k}", k * 7919 % 300)));
        let file = json!({
            "kinegon_measured": 1, "positive": "counter-clockwise", "values": values.collect::<BTreeMap<String, String>>(),
        });
        let mut measured = Measured::read_json(&file.to_string()).expect("a form");
        measured.mu = own.scales();
        measured
    };
    let with = |count: usize| solution(&four_bars(count));
    let grown = growth(30, with, |own| {
        let checked = check(&nonsense(own), &answer_key(own, DEPTH)).expect("values that are understood");
        assert!(!checked.is_passed() && checked.diagnosis.best.findings.is_empty());
        assert_eq!(checked.diagnosis.looked_at, 0);
    });
    // The bands of all values, each with the errors of all operations before it.
    grows_at_most(25.0, "a form of nonsense", grown);
}

/// A four-bar with these loads, drawn on these panels.
fn with_loads(loads: impl Iterator<Item = Value>, panels: &[&str]) -> String {
    let mut scene: Value = serde_json::from_str(&four_bar("loads", "")).expect("it is JSON");
    scene["units"]["force"] = "N".into();
    scene["forces"] = loads.collect();
    scene["figure"] = json!({ "panels": panels });
    scene.to_string()
}

/// A drawing with all sizes wrong: each operation is judged by all that was made before, but in a construction that nobody draws by hand no
/// mistakes of the catalogue are gone through for it.
#[test]
fn drawings_that_are_wrong() {
    let with = |count: usize| {
        let own = solution(&four_bars(count));
        let mut drawing: Value = serde_json::from_str(&own_drawing(&Given::new(&own), &own.scales())).expect("JSON");
        let entries = drawing["did"].as_array_mut().expect("a list");
        for size in entries.iter_mut().filter_map(|entry| entry.get_mut("size")) {
            *size = format!("2 * ({})", size.as_str().expect("a formula")).into();
        }
        let judge = Judge::new(&AnswerKey::new(&own, None));
        (judge, HandDrawing::read(&drawing.to_string()).expect("a drawing"))
    };
    let judged = |(judge, drawing): &(Judge, HandDrawing)| {
        let judged = judge.judge(drawing).expect("it can be carried out");
        assert!(judged.first_wrong().is_some());
    };
    // Some twenty operations for each.
    grows_at_most(25.0, "a wrong drawing", growth(6, with, judged));
}

/// Each load is looked up among the others once, and couples without a name are counted on.
#[test]
fn reading_loads() {
    let with = |count: usize| {
        let loads = (0..count).map(|k| json!({ "name": format!("F{k}"), "on": "2", "couple": k }));
        with_loads(loads, &["scheme"])
    };
    let read = |text: &String| drop(Scene::read(text).expect("a good scene"));
    is_in_proportion("loads with names", growth(2500, with, read));
    let with = |count: usize| with_loads((0..count).map(|k| json!({ "on": "2", "couple": k })), &["scheme"]);
    is_in_proportion("couples without names", growth(1000, with, read));
}

/// What is seen of the forces on a lever is found once for all, and where a link's couples act.
#[test]
fn loads_on_a_lever() {
    let forces = |count: usize| {
        // All but one are too small to be seen and to have a name, which would take most of the time.
        let force =
            |k| json!({ "on": "2", "at": [k % 100, 1 + k / 100], "force": [if k == 0 { 1e12 } else { 1.0 }, -2] });
        solution(&with_loads((0..count).map(force), &["lever"]))
    };
    is_in_proportion("a lever", growth(100, forces, |own| drop(own.figure())));
    let couples = |count: usize| {
        let text = with_loads((0..count).map(|k| json!({ "on": "2", "couple": 1 + k })), &["scheme", "lever"]);
        Scene::read(&text).expect("a good scene")
    };
    is_in_proportion("couples", growth(500, couples, |scene| drop(kinegon::solve(scene).expect("it moves"))));
}

/// Tables are put into the text of a scene at once.
#[test]
fn tables_of_loads() {
    let with = |count: usize| {
        let over = json!({ "of": "angle(1)", "table": "t.csv" });
        let loads = (0..count).map(|k| json!({ "name": format!("F{k}"), "on": "2", "couple": 1, "over": over }));
        with_loads(loads, &["scheme"])
    };
    let put = |text: &String| {
        let tables = tables_in_files(text).into_iter().map(|table| (table.load, vec![[0.0, 1.0], [360.0, 2.0]]));
        let (text, put) = with_tables(text, &tables.collect::<Vec<_>>()).expect("it is JSON");
        assert!(text.len() > 1000 && put.len() > 10);
    };
    is_in_proportion("tables", growth(250, with, put));
}

/// Centres that are named one by one take about as long as all of them.
#[test]
fn centers_named_one_by_one() {
    let dyads = 8;
    let chain = |centers: Value| {
        let (mut ground, mut links) = (json!({ "A": [0, 0] }), serde_json::Map::new());
        links.insert(
            "1".into(),
            json!({ "points": ["A", "P0"], "lengths": { "A-P0": 20 }, "drive": { "angle": 60, "omega": 10 } }),
        );
        let mut near = serde_json::Map::new();
        for k in 1..=dyads {
            let (before, joint, pivot) = (format!("P{}", k - 1), format!("P{k}"), format!("G{k}"));
            ground[&pivot] = json!([60 * k, k * k % 7]);
            near.insert(joint.clone(), json!([60 * k + 5, 40]));
            let link = |from: &str, length: usize| json!({ "points": [from, joint], "lengths": { format!("{from}-{joint}"): length } });
            links.insert((2 * k).to_string(), link(&before, 58 + k * 5 % 4));
            links.insert((2 * k + 1).to_string(), link(&pivot, 38 + k * 3 % 5));
        }
        let figure = json!({ "panels": ["scheme", "centers"], "centers": centers });
        let units = json!({ "length": "mm", "time": "s" });
        Scene::read(
            &json!({ "kinegon": 1, "units": units, "ground": ground, "links": links, "near": near, "figure": figure })
                .to_string(),
        )
        .expect("a good scene")
    };
    let named: Vec<String> =
        (0..30).map(|k| (2 + k * 5 % 7, 9 + k * 3 % 8)).map(|(a, b)| format!("P({a},{b})")).collect();
    let named: std::collections::BTreeSet<String> = named.into_iter().collect();
    let [all, some] = [json!("all"), json!(named)].map(|centers| {
        seconds(&chain(centers), |scene| {
            let own = kinegon::solve(scene).expect("it moves");
            assert!(own.construction.centers.is_some_and(|centers| centers.all.len() > 40));
        })
    });
    println!("all: {:.1} ms, {} of them: {:.1} ms", 1e3 * all, named.len(), 1e3 * some);
    assert!(some < 6.0 * all, "{} centres: {some} s, all: {all} s", named.len());
}

/// Drives that turn equally fast take a mechanism through the same positions: these are looked at once.
#[test]
fn drives_of_a_film() {
    let read = |count: usize| solution(&four_bars(count));
    let timing = Timing { seconds: 1.0, per_second: 2 };
    let film = |own: &Solution| drop(Film::new(own, None, timing).expect("it moves"));
    is_in_proportion("a film", growth(6, read, film));
    let cycle = |own: &Solution| drop(HeldLayout::of_cycle(own, None, None, None));
    // Each drive alone takes it through others, of which there are fewer the more points there are.
    is_in_proportion("the layout of a cycle", growth(6, read, cycle));
}

/// So many slider-cranks side by side.
fn slider_cranks(count: usize) -> String {
    let (mut ground, mut links, mut near, mut sliders) = (String::new(), String::new(), String::new(), String::new());
    for k in 0..count {
        let comma = if k == 0 { "" } else { "," };
        let (x, y) = (400 * (k % 40), 400 * (k / 40));
        let written = [
            write!(ground, r#"{comma} "A{k}": [{x}, {y}]"#),
            write!(
                links,
                r#"{comma} "a{k}": {{ "points": ["A{k}", "B{k}"], "lengths": {{ "A{k}-B{k}": 50 }}, "drive": {{ "angle": 60, "omega": 10 }} }},
                "b{k}": {{ "points": ["B{k}", "C{k}"], "lengths": {{ "B{k}-C{k}": 150 }} }}, "c{k}": {{ "points": ["C{k}"] }}"#
            ),
            write!(near, r#"{comma} "C{k}": [{}, {}]"#, x + 160, y + 20),
            write!(
                sliders,
                r#"{comma} {{ "link": "c{k}", "at": "C{k}", "on": "ground", "through": [{x}, {}], "along": 0 }}"#,
                y + 20
            ),
        ];
        assert!(written.iter().all(Result::is_ok), "a string takes all");
    }
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ {ground} }}, "links": {{ {links} }}, "sliders": [{sliders}],
            "near": {{ {near} }} }}"#
    )
}

/// A group's bounds look at its own sliders, not at all.
#[test]
fn bounds_of_sliders_side_by_side() {
    let with = |count: usize| solution(&slider_cranks(count));
    let bounded = |own: &Solution| drop(bounds(&own.scene, &own.mechanism, &own.pose, &own.motion));
    // What is left beyond four times is the search for driven sliders, a nanosecond each.
    grows_at_most(12.0, "bounds", growth(400, with, bounded));
}

#[test]
fn words_of_a_title() {
    let with = |count: usize| {
        let own = solution(&four_bar(&"a ".repeat(count), ""));
        assert_eq!(own.scene.given_by, GivenBy::Lengths);
        own
    };
    is_in_proportion("sheets to be drawn on", growth(1000, with, |own| drop(own.drawing_sheets("1"))));
}

/// Each variant of a large mechanism takes long: fewer are tried before that is given up.
#[test]
fn variants_of_many_links() {
    if !Size::is_usual("exercises of sixty linkages") {
        return;
    }
    let mut exercises = Exercises::new(&solution(&four_bars(60)), None, 1).expect("it has a construction");
    let error = exercises.next().expect_err("of sixty linkages one does not reach");
    assert!(matches!(error, ExerciseError::GaveUp { tries: ..100, .. }), "{error}");
}

/// As many links as a scene may have, with a place for every joint: there is nothing to search.
#[test]
fn places_of_all_joints_leave_nothing_to_search() {
    let scene = Scene::read(&four_bars(2000)).expect("a good scene");
    let (_, pose) = posed(&scene, kinegon::scene::SizeLimit::NUMBERS, None).expect("it can be put together");
    assert!(pose.warnings.is_empty(), "{:?}", pose.warnings);
}

/// A study of so many four-bars, which go round from one angle to another by steps.
fn study(rows: usize, [from, to, step]: [f64; 3]) -> Study {
    let text = format!(
        r#"{{ "kinegon_study": 1, "scene": {}, "count": {rows}, "at_steps": true,
            "vary": {{ "3.CD": {{ "plus_minus": 5 }}, "1.AB": {{ "plus_minus": 2 }} }},
            "cycle": {{ "from": {from}, "to": {to}, "step": {step} }}, "want": {{ "omega(3)": ["max"], "alpha(3)": ["max"] }} }}"#,
        four_bar("", "")
    );
    let study = StudyFile::read(&text).expect("a study");
    study.of(Scene::read(&four_bar("", "")).expect("a scene")).expect("it moves")
}

#[test]
fn rows_of_a_study() {
    let all = |study: &Study| drop(study.rows(0..study.count()));
    is_in_proportion("rows", growth(256, |rows| study(rows, [0.0, 360.0, 5.0]), all));
    is_in_proportion("steps", growth(90, |steps| study(128, [0.0, 360.0, 360.0 / steps as f64]), all));
}

/// A row, its assembly and three positions, takes less than twice what it takes to compile its mechanism; were it compiled for each row it
/// would be nearly three times.
#[test]
fn a_row_of_a_study_is_not_compiled() {
    const ROWS: usize = 512;
    // The clock of a thread may tick in hundredths of a second.
    const TIMES: usize = 20;
    let mechanism = solution(&four_bar("", "")).mechanism;
    let study = study(ROWS, [58.0, 62.0, 2.0]);
    let began = Instant::now();
    let shortest = |work: &dyn Fn()| {
        let times = (0..3).map(|_| {
            let before = busy(began);
            (0..TIMES).for_each(|_| work());
            busy(began) - before
        });
        times.min().unwrap_or_default().as_secs_f64()
    };
    let compiled = shortest(&|| (0..ROWS).for_each(|_| drop(std::hint::black_box(Kernel::new(&mechanism)))));
    let rows = shortest(&|| drop(study.rows(0..study.count())));
    let each = |all: f64| 1e6 * all / (ROWS * TIMES) as f64;
    println!("a row {:.2} µs, to compile one {:.2} µs", each(rows), each(compiled));
    assert!(rows < 2.5 * compiled, "a row takes {:.1} times as long as to compile a mechanism", rows / compiled);
}
