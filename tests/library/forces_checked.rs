//! Forms with forces: what they ask for, that independent digits are right there, that the twenty mistakes are named and honest hands are not
//! accused; and exercises with forces.

use kinegon::check::{AnswerKey, Measured, Mistake, Student, Verdict, check, form_names};
use kinegon::construction::{Action, Found, Tolerance};
use kinegon::exercise::Exercises;
use kinegon::geometry::Random;
use kinegon::quantity::step_pencil;
use kinegon::{Scales, Sheet, Solution};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use support::files;
use support::stages::solved;
use support::survey::ALIKE;

const UNITS: &str = r#"{ "length": "mm", "time": "s", "mass": "kg", "force": "N" }"#;

/// The starting scene of a kind with loads.
fn with_loads(kind: &str, change: impl FnOnce(&mut Value), panels: &[&str]) -> Value {
    let mut scene: Value = serde_json::from_str(&files::read(&format!("templates/{kind}.json"))).expect("a scene");
    scene["units"] = serde_json::from_str(UNITS).expect("JSON");
    change(&mut scene);
    scene["figure"] = json!({ "panels": panels });
    scene
}

fn solution(scene: &Value) -> Solution {
    solved(&scene.to_string()).expect("it can be solved")
}

fn with_mass(scene: &mut Value, link: &str, mass: f64, inertia: f64, center: Value) {
    let own = &mut scene["links"][link];
    own["mass"] = json!(mass);
    own["inertia"] = json!(inertia);
    own["center"] = center;
}

/// The kinds of exercises with forces, each as a scene: one load on a dyad, inertia, a piston, two groups, a shaper, a lever, groups of class III and IV.
fn kinds() -> Vec<(&'static str, Value)> {
    let plan = &["scheme", "forces"][..];
    vec![
        ("one load", one_load(plan)),
        ("inertia", inertia(plan)),
        ("piston", piston(plan)),
        ("two groups", two_groups(plan)),
        ("shaper", shaper(plan)),
        ("lever", lever()),
        ("class III", third(plan)),
        ("class IV", fourth(plan)),
    ]
}

fn one_load(panels: &[&str]) -> Value {
    with_loads(
        "four-bar",
        |scene| {
            scene["analysis"] = json!("static");
            scene["forces"] = json!([{ "name": "P", "on": "2", "at": 60, "force": { "size": 150, "angle": -80 } }]);
        },
        panels,
    )
}

fn inertia(panels: &[&str]) -> Value {
    with_loads(
        "four-bar",
        |scene| {
            with_mass(scene, "2", 20.0, 60000.0, json!(60));
            with_mass(scene, "3", 10.0, 20000.0, json!(60));
        },
        panels,
    )
}

fn piston(panels: &[&str]) -> Value {
    with_loads(
        "slider-crank",
        |scene| {
            with_mass(scene, "2", 20.0, 80000.0, json!(60));
            scene["forces"] =
                json!([{ "name": "P", "on": "3", "at": "C", "force": [-200, 0] }, { "on": "3", "couple": -3000 }]);
        },
        panels,
    )
}

/// A rocker that pushes a slider by a rod, as in a press: a dyad hangs on another one.
fn two_groups(panels: &[&str]) -> Value {
    let mut scene = with_loads("four-bar", |_| {}, panels);
    scene["analysis"] = json!("static");
    scene["links"]["3"] = json!({ "points": ["D", "C", "K"], "lengths": { "CD": 110, "DK": 80, "CK": 50 } });
    scene["links"]["4"] = json!({ "points": ["K", "E"], "lengths": { "KE": 130 } });
    scene["links"]["5"] = json!({ "points": ["E"] });
    scene["sliders"] = json!([{ "link": "5", "at": "E", "on": "ground", "through": [0, 60], "along": 0 }]);
    scene["near"] = json!({ "C": [155, 110], "K": [175, 80], "E": [300, 60] });
    scene["forces"] = json!([{ "name": "P", "on": "5", "at": "E", "force": [-150, 0] }]);
    scene
}

fn shaper(panels: &[&str]) -> Value {
    with_loads(
        "whitworth",
        |scene| {
            scene["analysis"] = json!("static");
            scene["forces"] = json!([{ "name": "P", "on": "5", "at": "F", "force": [-150, 0] }]);
        },
        panels,
    )
}

fn lever() -> Value {
    with_loads(
        "four-bar",
        |scene| {
            with_mass(scene, "2", 20.0, 60000.0, json!(60));
            scene["forces"] = json!([{ "name": "P", "on": "3", "at": "C", "force": [-100, -60] }]);
        },
        &["scheme", "lever"],
    )
}

fn third(panels: &[&str]) -> Value {
    with_loads(
        "third-class",
        |scene| {
            scene["analysis"] = json!("static");
            let central = scene["links"].as_object().expect("links").keys().nth(2).cloned().expect("a link");
            let point = scene["links"][&central]["points"][1].clone();
            scene["forces"] =
                json!([{ "name": "P", "on": central, "at": point, "force": { "size": 150, "angle": -70 } }]);
        },
        panels,
    )
}

fn fourth(panels: &[&str]) -> Value {
    let mut scene: Value = serde_json::from_str(&files::read("examples/figure-2.json")).expect("a scene");
    scene["units"] = serde_json::from_str(UNITS).expect("JSON");
    scene["analysis"] = json!("static");
    scene["forces"] = json!([{ "name": "P", "on": "4", "at": "D", "force": { "size": 150, "angle": -150 } }]);
    scene["figure"] = json!({ "panels": panels });
    scene.as_object_mut().expect("an object").shift_remove("want");
    scene
}

fn form(solution: &Solution, values: &Value) -> Measured {
    let mut form = json!({ "kinegon_measured": 1, "positive": "counter-clockwise" });
    for (sheet, mu) in solution.scales().given() {
        form[sheet.facts().scale_key] = json!(mu);
    }
    form["values"] = values.clone();
    Measured::read_json(&form.to_string()).expect("a form")
}

#[test]
fn a_figure_of_forces_asks_for_them_and_no_velocity() {
    let solution = solution(&piston(&["scheme", "forces"]));
    let names = form_names(&solution.construction);
    for name in
        ["R_t(B,2)", "R_n(B,2)", "N(3/ground)", "M(3/ground)", "h(3/ground)", "R(C,2).size", "R(C,2).angle", "T(1)"]
    {
        assert!(names.iter().any(|own| own == name), "{name} in {names:?}");
    }
    assert!(!names.iter().any(|name| name.contains("plan") || name.starts_with("omega")), "{names:?}");
    let scales: Scales = solution.scales();
    assert_eq!(scales.given().map(|(sheet, _)| sheet).collect::<Vec<_>>(), [Sheet::Scheme, Sheet::Forces]);
}

#[test]
fn a_lever_asks_for_the_powers_of_the_loads() {
    let names = form_names(&solution(&lever()).construction);
    assert_eq!(names, ["power(inertia(2))", "power(P)", "T(1)"]);
}

#[test]
fn every_force_that_steps_find_has_a_band() {
    for (kind, scene) in kinds() {
        let solution = solution(&scene);
        let pencil = step_pencil(&solution, Tolerance::default()).expect("names");
        assert!(!pencil.quantities.is_empty(), "{kind}");
        for (asked, band) in &pencil.quantities {
            let band = band.as_ref().unwrap_or_else(|why| panic!("{kind}: {} has no band: {why}", asked.name()));
            let value =
                asked.value(&solution.snapshot(), Some(&solution.construction), None).expect("a value").as_number();
            let read =
                if band.value * value < 0.0 && asked.name().starts_with("R_") { -band.value } else { band.value };
            let apart = kinegon::geometry::with_turns(read - value, 0.0).abs().min((read - value).abs());
            assert!(apart <= 1e-9 * value.abs().max(1.0), "{kind}: {} is read as {read}, not {value}", asked.name());
        }
    }
}

/// The digits are those of absolute coordinates and free bodies, none of Kinegon's.
#[test]
fn independent_digits_are_right_values_of_a_form() {
    let (mut forms, mut values) = (0, 0);
    for line in files::read("tests/forces/forces.jsonl").lines() {
        let case: Value = serde_json::from_str(line).expect("JSON");
        let mut scene = case["scene"].clone();
        scene["figure"] = json!({ "panels": ["scheme", "forces"] });
        let Ok(solution) = solved(&scene.to_string()) else { continue };
        let number = |value: &Value| value.as_str().and_then(|digits| digits.parse::<f64>().ok());
        let mut written = json!({});
        for name in form_names(&solution.construction) {
            let (head, rest) = name.split_once('(').expect("a name");
            let (inside, tail) = rest.rsplit_once(')').expect("a name");
            let digits = match head {
                "R" => inside.split_once(',').and_then(|(pin, link)| {
                    let force = &case["expected"]["reactions"][pin][link];
                    let (x, y) = (number(&force[0])?, number(&force[1])?);
                    Some(if tail == ".size" { libm::hypot(x, y) } else { libm::atan2(y, x).to_degrees() })
                }),
                "N" | "M" | "h" => number(&case["expected"]["sliders"][inside][head]),
                "T" => number(&case["expected"]["drives"][inside]["torque"]),
                _ => None,
            };
            if let Some(digits) = digits {
                written[&name] = json!(format!("{digits:.6}"));
            }
        }
        let count = written.as_object().map_or(0, serde_json::Map::len);
        if count == 0 {
            continue;
        }
        let checked = check(&form(&solution, &written), &AnswerKey::new(&solution, None));
        let checked = checked.unwrap_or_else(|error| panic!("{}: {error}", case["id"]));
        for value in &checked.values {
            let is_right = matches!(value.verdict, Verdict::Right | Verdict::WithinTolerance | Verdict::TooSmall);
            assert!(is_right, "{} {}: {:?} {}", case["id"], value.entry.asked.name(), value.verdict, value.difference);
        }
        (forms, values) = (forms + 1, values + count);
    }
    assert!(forms >= 20 && values >= 200, "{forms} forms with {values} values");
}

/// The mistakes of forces, by their names.
const MISTAKES: [&str; 20] = [
    "inertia-along-a",
    "inertia-couple-along-alpha",
    "couple-forgotten",
    "percussion-on-wrong-side",
    "a-of-joint-for-centre",
    "centripetal-part-left-out",
    "arm-to-point",
    "arm-in-paper-mm",
    "reaction-not-reversed",
    "negative-tangential-kept",
    "normal-across",
    "force-missing-in-polygon",
    "twice",
    "guide-reaction-along-rod",
    "guide-reaction-through-pin",
    "mass-for-weight",
    "moment-about-wrong-point",
    "lever-not-turned",
    "couple-on-lever-unscaled",
    "torque-sense",
];

#[test]
fn each_mistake_with_forces_is_planted_and_mostly_named() {
    let mut random = Random(5);
    let (mut planted, mut named): (BTreeMap<&str, usize>, usize) = (BTreeMap::new(), 0);
    let tried: Vec<&str> = MISTAKES.into_iter().step_by(ALIKE.now()).collect();
    for (kind, mut scene) in kinds() {
        if kind == "inertia" || kind == "lever" {
            scene["gravity"] = json!([0, -9810]);
        }
        let solution = solution(&scene);
        let key = AnswerKey::new(&solution, None);
        let student = Student::new(&key).expect("a form");
        let right = student.exact(None);
        for mistake in Mistake::all().filter(|mistake| tried.contains(&mistake.id())) {
            let ways = student.ways(mistake);
            let shows = |way: &&kinegon::check::Candidate| {
                let found = student.exact(Some(way));
                let off = found.iter().zip(&right).filter_map(|(found, right)| {
                    let (found, right) = ((*found)?, (*right)?);
                    Some((found - right).abs() / right.abs().max(1.0))
                });
                // What throws a value far away nobody would draw.
                off.fold(0.0, f64::max) > 0.08 && found.iter().flatten().all(|value| value.abs() < 1e6)
            };
            let Some(way) = ways.iter().find(shows) else { continue };
            let drawn = student.draw(&[way], [0.1; 2], &mut || random.within(), &[]);
            let checked = check(&drawn, &key).expect("a form");
            let told: Vec<&str> =
                checked.diagnosis.best.findings.iter().map(|found| found.candidate.mistake().id()).collect();
            // Without the value of the couple nobody can tell these apart.
            let same =
                |id: &str| if id == "percussion-on-wrong-side" { "inertia-couple-along-alpha" } else { id }.to_owned();
            named += usize::from(told.iter().any(|id| same(id) == same(mistake.id())));
            *planted.entry(mistake.id()).or_default() += 1;
        }
    }
    for mistake in tried {
        assert!(planted.contains_key(mistake), "{mistake} is never planted");
    }
    let all: usize = planted.values().sum();
    assert!(all * ALIKE.now() >= 50 && named * 100 >= all * 75, "{named} of {all}: {planted:?}");
}

#[test]
fn honest_hands_are_told_of_no_mistake_with_forces() {
    let mut random = Random(6);
    // Of mechanisms that a hand draws well.
    for (kind, scene) in
        [("inertia", inertia(&["scheme", "forces"])), ("piston", piston(&["scheme", "forces"])), ("lever", lever())]
    {
        let mut exercises = Exercises::new(&solution(&scene), None, 5).expect("it can vary");
        let solution = exercises.next().expect("an exercise").solution;
        let key = AnswerKey::new(&solution, None);
        let student = Student::new(&key).expect("a form");
        for _ in 0..3 {
            let drawn = student.draw(&[], [0.3; 2], &mut || random.within(), &[]);
            let checked = check(&drawn, &key).expect("a form");
            assert_eq!(checked.diagnosis.best.findings.len(), 0, "{kind}");
        }
    }
}

#[test]
fn exercises_have_forces_that_a_hand_draws_well() {
    for (kind, scene) in kinds() {
        let mut exercises = Exercises::new(&solution(&scene), None, 5).expect("it can vary");
        let exercise = exercises.next().unwrap_or_else(|error| panic!("{kind}: {error}"));
        let again = solved(&exercise.text).expect("an exercise can be solved");
        assert_eq!(again.scene.figure.mu, exercise.scales, "{kind}: the file says its scales");
        let plan = again.construction.forces.as_deref().expect("forces");
        if let Some(mu) = exercise.scales[Sheet::Forces] {
            let sizes: Vec<f64> =
                plan.polygons.iter().flat_map(|own| &own.sides).map(|side| side.vector.norm()).collect();
            let largest = sizes.iter().copied().fold(0.0, f64::max);
            for size in sizes.iter().filter(|size| **size > 1e-9 * largest) {
                assert!(*size >= 8.0 * mu && largest <= 40.0 * size, "{kind}: a force of {size}");
            }
            // The arm of what a sum of moments tells is its last.
            let mu_l = exercise.scales[Sheet::Scheme].expect("a scale");
            for moment in
                plan.moments.iter().filter(|moment| matches!(moment.finds, Found::Force(_)) && moment.value != 0.0)
            {
                let arm = moment.arms.last().expect("an arm").length;
                assert!(arm >= 10.0 * mu_l, "{kind}: an arm of {arm}");
            }
        }
        for (name, value) in exercise.key().values.iter().filter(|(name, _)| name.starts_with(['R', 'N', 'T', 'p'])) {
            let allowed = value.allowed.unwrap_or_else(|| panic!("{kind}: {name} has no band"));
            assert!(allowed > 0.0, "{kind}: {name}");
        }
        let steps = &again.construction.steps[Sheet::Forces];
        assert!(!steps.iter().any(|action| matches!(action, Action::NoConstruction(_))));
        let sheets = exercise.sheets("forces-5-1");
        assert!(sheets.len() >= 2, "{kind}: a sheet for the forces follows");
    }
}

/// An engine's gas force beside the weight of its light rod: who asks for an exercise is told which forces are so unequal.
#[test]
#[ignore = "takes long"]
fn unequal_forces_are_named() {
    let scene = json!({
        "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" }, "ground": { "A": [0, 0] },
        "links": {
            "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 50, "omega": 10 } },
            "2": { "points": ["B", "C"], "lengths": { "BC": 180 }, "mass": 0.3, "center": 70 },
            "3": { "points": ["C"] },
        },
        "sliders": [{ "link": "3", "at": "C", "on": "ground", "through": [0, 0], "along": 0 }],
        "near": { "C": [200, 0] }, "gravity": [0, -9810], "analysis": "static",
        "forces": [{ "name": "P", "on": "3", "at": "C", "force": [-4000, 0] }],
        "figure": { "panels": ["scheme", "forces"] },
    });
    // Springs do not change.
    let mut scene = scene;
    scene.as_object_mut().expect("a scene").shift_remove("forces");
    scene["links"]["2"] = json!({ "points": ["B", "C"], "lengths": { "BC": 180 } });
    let spring = |end: Value, rate: f64| json!({ "between": [end, ["ground", [90, 300]]], "rate": rate, "length": 0 });
    scene["springs"] = json!([spring(json!(["3", "C"]), 20.0), spring(json!(["2", 70]), 0.02)]);
    let base = solved(&scene.to_string()).expect("a good scene");
    let error = Exercises::new(&base, None, 1).expect("it varies").next().expect_err("5 N beside 6000");
    let told = error.to_string();
    assert!(told.contains("K_2"), "{told}");
    assert!(told.contains("leave out what is so small"), "{told}");
}

/// An engine with a gas force of thousands of newtons whose links weigh some, and a shaper whose ram is moved slowly: their loads change until polygons can
/// be drawn, and what changes is told; those of a scene that can be drawn do not.
#[test]
#[ignore = "takes long"]
fn loads_that_are_too_unequal_are_made_alike() {
    let engine = with_loads(
        "slider-crank",
        |scene| {
            scene["links"]["1"]["drive"] = json!({ "angle": 60, "omega": 300 });
            with_mass(scene, "2", 0.8, 2100.0, json!(45));
            with_mass(scene, "3", 0.6, 0.0, json!("C"));
            scene["gravity"] = json!([0, -9810]);
            let table = json!([[0, 5200], [30, 4200], [60, 2000], [120, 700], [180, 200], [360, 5200]]);
            let over = json!({ "of": "angle(1)", "table": table });
            scene["forces"] = json!([{ "name": "P", "on": "3", "at": "C", "force": [-1, 0], "over": over }]);
        },
        &["scheme", "forces"],
    );
    let mut ram = shaper(&["scheme", "forces"]);
    ram["analysis"] = json!("dynamic");
    ram["gravity"] = json!([0, -9810]);
    with_mass(&mut ram, "3", 3.0, 20000.0, json!("E"));
    with_mass(&mut ram, "4", 2.0, 0.0, json!("E"));
    with_mass(&mut ram, "5", 8.0, 0.0, json!("F"));
    ram["forces"][0]["force"] = json!([-600, 0]);
    for (scene, told) in [(engine, "g = 0"), (ram, "ω")] {
        let mut exercises = Exercises::new(&solution(&scene), None, 1).expect("it can vary");
        let exercise = exercises.next().unwrap_or_else(|error| panic!("{told}: {error}"));
        let said = exercises.evened().expect("it says what has changed").to_string();
        assert!(said.contains(told), "{said}");
        let plan = exercise.solution.construction.forces.as_deref().expect("forces");
        let sizes: Vec<f64> = plan.polygons.iter().flat_map(|own| &own.sides).map(|side| side.vector.norm()).collect();
        let most = sizes.iter().copied().fold(0.0, f64::max);
        let least = sizes.iter().copied().filter(|size| *size > 1e-9 * most).fold(most, f64::min);
        assert!(most <= 40.0 * least, "{told}: {most} beside {least}");
        // A force of a table is given as it is in the position.
        let force = exercise.solution.quantity("load(P).x").expect("a value").as_number();
        let given: String =
            exercise.given().iter().flat_map(|line| line.runs().iter()).map(|run| run.content.as_str()).collect();
        let written = given.split("P = (").nth(1).and_then(|rest| rest.split(',').next()).expect("P is given");
        let written: f64 =
            written.replace(['\u{202f}', '\u{a0}', ' '], "").replace('\u{2212}', "-").parse().expect("a number");
        assert!((written - force).abs() <= 5e-4 * force.abs(), "{written}, not {force}");
    }
    let mut exercises = Exercises::new(&solution(&one_load(&["scheme", "forces"])), None, 5).expect("it can vary");
    exercises.next().expect("an exercise");
    assert!(exercises.evened().is_none());
}
