//! Force plans drawn on the board: Kinegon's own construction of every case of independent digits is right, so is any order of the forces, the first
//! wrong operation is named, and what the board shows has all that a hand needs.

use kinegon::board::{Given, HandDrawing, Judge, JudgedDrawing, Screen, Verdict, own_drawing};
use kinegon::check::AnswerKey;
use kinegon::construction::Tolerance;
use kinegon::{Sheet, Solution};
use serde_json::{Value, json};
use support::stages::solved;
use support::survey::ALIKE;

fn with_forces(mut scene: Value) -> Solution {
    scene["figure"]["panels"] = json!(["scheme", "forces"]);
    solved(&scene.to_string()).expect("it can be solved")
}

fn judge(solution: &Solution) -> Judge {
    Judge::new(&AnswerKey::new(solution, Some(Tolerance::default())))
}

fn drawing(did: &[Value]) -> HandDrawing {
    let text = json!({ "kinegon_drawing": 1, "did": did }).to_string();
    HandDrawing::read(&text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn judged(judge: &Judge, did: &[Value]) -> JudgedDrawing {
    judge.judge(&drawing(did)).unwrap_or_else(|error| panic!("{did:?}: {error}"))
}

#[test]
fn own_constructions_of_forces_are_right() {
    let mut count = 0;
    for case in crate::forces::cases().into_iter().step_by(ALIKE.now()) {
        let solution = with_forces(case["scene"].clone());
        let own = own_drawing(&Given::new(&solution), &solution.scales());
        let id = &case["id"];
        let whole = HandDrawing::read(&own).unwrap_or_else(|error| panic!("{id}: {error}"));
        let found = judge(&solution).judge(&whole).unwrap_or_else(|error| panic!("{id}: {error}"));
        let wrong = found.first_wrong().map(|index| (&whole.did[index], &found.verdicts[index]));
        assert!(wrong.is_none(), "{id}: {wrong:?}");
        assert!(found.verdicts.contains(&Verdict::Right), "{id}");
        count += 1;
    }
    assert!(count * ALIKE.now() >= 35, "{count}");
}

/// A four-bar linkage with weight and inertia of the coupler and a force on the rocker.
fn four_bar() -> Solution {
    with_forces(json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" }, "gravity": [0, -9810],
        "ground": { "A": [0, 0], "D": [160, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 60, "omega": 10, "alpha": 0 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 140 }, "mass": 4, "inertia": 9000, "center": [70, 5] },
            "3": { "points": ["D", "C"], "lengths": { "CD": 110 } }
        },
        "near": { "C": [155, 110] },
        "forces": [{ "name": "P", "on": "3", "at": "C", "force": [-150, -60] }]
    }))
}

/// The moments of the coupler about C, and the polygon of the dyad: P first, which Kinegon's own construction has last.
fn plan() -> Vec<Value> {
    let load = |name: &str| json!({ "parallel": format!("load({name})") });
    vec![
        json!({ "line": "w", "on": "scheme", "through": "G2", "along": load("weight(2)") }),
        json!({ "line": "u", "on": "scheme", "through": "C", "along": { "normal": "w" } }),
        json!({ "cross": "f1", "of": ["w", "u"] }),
        json!({ "measure": "m1", "on": "scheme", "from": "C", "to": "f1" }),
        json!({ "line": "i", "on": "scheme", "through": "G2", "along": load("inertia(2)") }),
        json!({ "line": "v", "on": "scheme", "through": "C", "along": { "normal": "i" } }),
        json!({ "cross": "f2", "of": ["i", "v"] }),
        json!({ "measure": "m2", "on": "scheme", "from": "C", "to": "f2" }),
        json!({ "compute": "R_t(B,2)",
                "as": "(load(weight(2)) * m1 - load(inertia(2)) * m2 + M_i(2)) / L(B,C)" }),
        json!({ "lay_off": "k1", "on": "forces", "from": "o1", "size": "load(P)", "along": load("P") }),
        json!({ "lay_off": "k2", "on": "forces", "from": "k1", "size": "load(weight(2))", "along": load("weight(2)") }),
        json!({ "lay_off": "k3", "on": "forces", "from": "k2", "size": "R_t(B,2)", "along": { "normal": "B,C" } }),
        json!({ "lay_off": "k4", "on": "forces", "from": "k3", "size": "load(inertia(2))", "along": load("inertia(2)") }),
        json!({ "line": "r1", "on": "forces", "through": "k4", "along": { "parallel": "2" } }),
        json!({ "line": "r2", "on": "forces", "through": "o1", "along": { "parallel": "C,D" } }),
        json!({ "cross": "k5", "of": ["r1", "r2"] }),
        json!({ "measure": "R_n(B,2)", "on": "forces", "from": "k4", "to": "k5" }),
        json!({ "measure": "R_n(D,3)", "on": "forces", "from": "k5", "to": "o1" }),
        json!({ "compute": "R(B,2)", "as": "sqrt(R_n(B,2)^2 + R_t(B,2)^2)" }),
    ]
}

#[test]
fn any_order_of_the_forces_is_right() {
    let solution = four_bar();
    let judge = judge(&solution);
    let found = judged(&judge, &plan());
    assert_eq!(found.first_wrong(), None, "{:?}", found.verdicts);
    assert!(found.verdicts.iter().all(|verdict| *verdict == Verdict::Right), "{:?}", found.verdicts);
    // From the start against the forces, and half of them on each side.
    let mut backwards = plan();
    backwards[11] =
        json!({ "lay_off": "k3", "on": "forces", "from": "o1", "size": "-R_t(B,2)", "along": { "normal": "B,C" } });
    backwards[12] = json!({ "lay_off": "k4", "on": "forces", "from": "k2", "size": "load(inertia(2))", "along": { "parallel": "load(inertia(2))" } });
    backwards[14] = json!({ "line": "r2", "on": "forces", "through": "k3", "along": { "parallel": "3" } });
    backwards[17] = json!({ "measure": "R_n(D,3)", "on": "forces", "from": "k5", "to": "k3" });
    let found = judged(&judge, &backwards);
    assert_eq!(found.first_wrong(), None, "{:?}", found.verdicts);
    // Every beginning of it is right, too.
    for length in 0..plan().len() {
        assert_eq!(judged(&judge, &plan()[..length]).first_wrong(), None, "{length}");
    }
}

#[test]
fn the_first_wrong_operation_with_forces_is_named() {
    let solution = four_bar();
    let judge = judge(&solution);
    let load = |name: &str| json!({ "parallel": format!("load({name})") });
    let laid = |to: &str, from: &str, size: &str, along: Value| json!({ "lay_off": to, "on": "forces", "from": from, "size": size, "along": along });
    let cases: [(usize, Value, usize, &str); 9] = [
        (12, laid("k4", "k3", "-load(inertia(2))", load("inertia(2)")), 12, "inertia-along-a"),
        (11, laid("k3", "k2", "-R_t(B,2)", json!({ "normal": "B,C" })), 11, "negative-tangential-kept"),
        (12, laid("k4", "k3", "load(P)", load("P")), 12, "twice"),
        (12, laid("k4", "k3", "1000 * load(inertia(2))", load("inertia(2)")), 12, "mass-for-weight"),
        (13, json!({ "line": "r1", "on": "forces", "through": "k4", "along": { "normal": "2" } }), 13, "normal-across"),
        (
            13,
            json!({ "line": "r1", "on": "forces", "through": "k3", "along": { "parallel": "2" } }),
            15,
            "force-missing-in-polygon",
        ),
        (
            8,
            json!({ "compute": "R_t(B,2)", "as": "(load(weight(2)) * m1 - load(inertia(2)) * m2) / L(B,C)" }),
            8,
            "couple-forgotten",
        ),
        (
            8,
            json!({ "compute": "R_t(B,2)", "as": "(load(weight(2)) * m1 / mu_l - load(inertia(2)) * m2 / mu_l + M_i(2)) / L(B,C)" }),
            8,
            "arm-in-paper-mm",
        ),
        (3, json!({ "measure": "m1", "on": "scheme", "from": "C", "to": "G2" }), 8, "arm-to-point"),
    ];
    for (index, entry, expected, name) in cases {
        let mut did = plan();
        let mut head = json!({ "kinegon_drawing": 1, "mu_l": 2 });
        did[index] = entry.clone();
        head["did"] = json!(did);
        let drawing = HandDrawing::read(&head.to_string()).expect("a good drawing");
        let found = judge.judge(&drawing).expect("it can be carried out");
        assert_eq!(found.first_wrong(), Some(expected), "{entry}: {:?}", found.verdicts);
        let Verdict::Wrong(wrong) = &found.verdicts[expected] else { unreachable!() };
        assert_eq!(wrong.mistake.as_ref().map(|told| told.mistake.id()), Some(name), "{entry}");
        // What hangs on it and is right by itself follows; in place of what was laid off twice another force is missing.
        let later = &found.verdicts[expected + 1..];
        let follows = |verdict: &Verdict| matches!(verdict, Verdict::Right | Verdict::Follows);
        assert!(name == "twice" || later.iter().all(follows), "{entry}: {later:?}");
    }
}

#[test]
fn the_board_shows_what_a_hand_needs_for_forces() {
    let solution = four_bar();
    let screen = Screen::new(judge(&solution), solution.wording());
    let shown = screen.board(String::new(), &drawing(&plan()));
    assert!(shown.refused.is_none(), "{:?}", shown.refused);
    let sheets: Vec<Sheet> = shown.sheets.iter().map(|sheet| sheet.sheet).collect();
    assert_eq!(sheets, [Sheet::Scheme, Sheet::Forces]);
    let given: Vec<&str> = shown.given.iter().map(|number| number.name.as_str()).collect();
    for name in ["load(weight(2))", "load(inertia(2))", "M_i(2)", "load(P)", "L(B,C)"] {
        assert!(given.contains(&name), "{name}: {given:?}");
    }
    let is_there =
        |sheet: Sheet, name: &str| shown.things.iter().any(|thing| thing.sheet == sheet && thing.name == name);
    assert!(is_there(Sheet::Forces, "o1") && is_there(Sheet::Forces, "o2") && is_there(Sheet::Scheme, "G2"));
    assert!(is_there(Sheet::Scheme, "load(P)"));
    let asked: Vec<&str> = shown.names.iter().filter(|name| !name.is_made).map(|name| name.name.as_str()).collect();
    assert!(asked.contains(&"T(1)") && !asked.contains(&"R_n(B,2)"), "{asked:?}");
    // All corners are on the paper.
    for thing in shown.things.iter().filter(|thing| thing.sheet == Sheet::Forces) {
        let sheet = &shown.sheets[1];
        let [x, y] = thing.at;
        assert!((0.0..=sheet.width).contains(&x) && (0.0..=sheet.height).contains(&y), "{}: {x} {y}", thing.name);
    }
    // Whoever has drawn the whole polygon in another order is told what comes then, not to draw it again.
    let hint = screen.hint(&drawing(&plan()), None, 2);
    assert!(!hint.words.contains("laid off"), "{}", hint.words);
}
