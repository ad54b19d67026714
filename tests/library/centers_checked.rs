//! Forms with instant centres: what they ask for, that independent digits are right there, and that other forms are as they were.

use kinegon::check::{AnswerKey, Measured, Verdict, check, form_names};
use kinegon::construction::{CenterOrigin, Spot};
use kinegon::drawing::markers::SheetCode;
use kinegon::drawing::{Pen, Point};
use kinegon::exercise::Exercises;
use kinegon::geometry::Place;
use kinegon::{Scales, Sheet, Solution};
use serde_json::{Value, json};
use support::files;
use support::stages::solved;

/// The starting scene of a kind with this figure.
fn with_figure(kind: &str, figure: Value) -> Solution {
    let mut scene: Value = serde_json::from_str(&files::read(&format!("templates/{kind}.json"))).expect("a scene");
    scene["figure"] = figure;
    solved(&scene.to_string()).expect("it can be solved")
}

fn names(solution: &Solution) -> Vec<String> {
    form_names(&solution.construction)
}

fn form(values: &Value) -> Measured {
    let mut form = json!({ "kinegon_measured": 1, "mu_c": 1.0, "positive": "counter-clockwise" });
    form["values"] = values.clone();
    Measured::read_json(&form.to_string()).expect("a form")
}

#[test]
fn a_figure_of_centres_asks_for_them_and_no_plan() {
    let solution = with_figure("four-bar", json!({ "panels": ["scheme", "centers"], "velocities": ["C"] }));
    let [first, second] = [["P(2,ground).x", "P(2,ground).y"], ["P(1,3).x", "P(1,3).y"]];
    let velocity =
        ["L(P(1,ground),P(1,3))", "L(P(3,ground),P(1,3))", "omega(3)", "L(P(3,ground),C)", "v(C).size", "v(C).angle"];
    assert_eq!(names(&solution), [&first[..], &second[..], &velocity[..]].concat());
}

#[test]
fn a_plan_that_is_shown_is_asked_for_too_and_gives_the_rates() {
    let figure = |panels: Value| json!({ "panels": panels, "velocities": ["C"] });
    let plan = names(&with_figure("four-bar", figure(json!(["scheme", "velocity"]))));
    let both = names(&with_figure("four-bar", figure(json!(["scheme", "velocity", "centers"]))));
    let alone = names(&with_figure("four-bar", figure(json!(["scheme", "centers"]))));
    let of_accelerations = |name: &&String| name.starts_with("aplan") || name.starts_with("alpha");
    for name in plan.iter().filter(|name| !of_accelerations(name)).chain(&alone) {
        assert_eq!(both.iter().filter(|other| *other == name).count(), 1, "{name} in {both:?}");
    }
    assert!(!both.iter().any(|name| of_accelerations(&name)), "{both:?}");
}

/// The digits are those of absolute coordinates and free bodies, none of Kinegon's.
#[test]
fn independent_digits_are_right_values_of_a_form() {
    let (mut forms, mut values) = (0, 0);
    for line in files::read("tests/centers/cases.jsonl").lines() {
        let case: Value = serde_json::from_str(line).expect("JSON");
        let mut scene = case["scene"].clone();
        scene["figure"] = json!({ "panels": ["centers"], "centers": "all" });
        let solution = solved(&scene.to_string()).expect("it can be solved");
        let number = |value: &Value| value.as_str().and_then(|digits| digits.parse::<f64>().ok()).expect("a number");
        let mut written = json!({});
        for name in names(&solution).iter().filter(|name| name.starts_with("P(")) {
            let (center, axis) = name.rsplit_once('.').expect("a coordinate");
            let at = &case["expected"]["centers"][center]["at"];
            if at.is_array() {
                let digits = number(&at[usize::from(axis == "y")]);
                written[name] = json!(format!("{digits:.6}"));
            }
        }
        let count = written.as_object().map_or(0, serde_json::Map::len);
        if count == 0 {
            continue;
        }
        let key = AnswerKey::new(&solution, None);
        let checked = check(&form(&written), &key).unwrap_or_else(|error| panic!("{}: {error}", case["id"]));
        for value in &checked.values {
            assert_eq!(value.verdict, Verdict::Right, "{} {}", case["id"], value.entry.asked.name());
        }
        (forms, values) = (forms + 1, values + count);
    }
    assert!(forms >= 15 && values >= 100, "{forms} forms with {values} values");
}

#[test]
fn centres_are_understood_with_their_links_in_either_order_and_the_frame_as_0() {
    let solution = with_figure("four-bar", json!({ "panels": ["scheme", "centers"], "velocities": ["C"] }));
    let key = AnswerKey::new(&solution, None);
    let written = |one: &str, two: &str| json!({ one: "153.7", two: "50.0" });
    let usual = check(&form(&written("P(2,ground).x", "L(P(1,3),P(3,ground))")), &key).expect("a form");
    let other = check(&form(&written("P(0,2).x", "L(P(3,0),P(3,1))")), &key).expect("a form");
    let named = |checked: &kinegon::check::Checked| -> Vec<String> {
        checked.values.iter().map(|value| value.entry.asked.name().to_owned()).collect()
    };
    assert_eq!(named(&usual), ["P(2,ground).x", "L(P(3,ground),P(1,3))"]);
    assert_eq!(named(&other), named(&usual));
}

#[test]
fn a_form_of_centres_needs_the_scale_of_their_sheet_alone() {
    let solution = with_figure("four-bar", json!({ "panels": ["centers"], "mu_c": 2 }));
    let scales: Scales = solution.scales();
    assert_eq!(scales.given().map(|(sheet, _)| sheet).collect::<Vec<_>>(), [Sheet::Centers]);
    let checked = check(&form(&json!({ "P(1,3).y": "0.0" })), &AnswerKey::new(&solution, None)).expect("a form");
    assert_eq!(checked.values.len(), 1);
}

/// All centres of four-bars, slider-cranks and slotted levers, one of a six-bar, and by velocities that of a class IV group.
fn exercised() -> [(&'static str, Value); 5] {
    let panels = json!(["scheme", "centers"]);
    [
        ("four-bar", json!({ "panels": panels, "velocities": ["C"] })),
        ("slider-crank", json!({ "panels": panels, "velocities": ["C"] })),
        ("slotted-lever", json!({ "panels": panels })),
        ("stephenson-3", json!({ "panels": panels, "centers": ["P(1,5)"] })),
        ("fourth-class", json!({ "panels": panels, "centers": ["P(1,4)"], "velocities": ["F"] })),
    ]
}

#[test]
fn exercises_have_centres_that_a_hand_draws_well() {
    for (kind, figure) in exercised() {
        let base = with_figure(kind, figure);
        let mut exercises = Exercises::new(&base, None, 5).expect("it can vary");
        let exercise = exercises.next().unwrap_or_else(|error| panic!("{kind}: {error}"));
        let mu = exercise.scales[Sheet::Centers].expect("a scale");
        let solution = solved(&exercise.text).expect("an exercise can be solved");
        assert_eq!(solution.scene.figure.mu, exercise.scales, "{kind}: the file says its scales");
        let centers = solution.construction.centers.as_deref().expect("centres");
        let mut places = Vec::new();
        for center in &centers.all {
            if let CenterOrigin::Lines { sine, .. } = center.origin
                && matches!(center.place, Place::At(_))
            {
                // The sine of 20°.
                assert!(sine >= 0.342, "{kind}: {} crosses at {sine}", center.name);
            }
            if let (Spot::At(id), Place::At(place)) = (center.spot, center.place) {
                places.push((id, place));
            }
        }
        for (index, (id, place)) in places.iter().enumerate() {
            let others = places[index + 1..].iter().filter(|(other, _)| other != id);
            for (_, other) in others {
                assert!((place - other).norm() >= 6.0 * mu, "{kind}: two centres within 6 mm");
            }
        }
        let key = exercise.key();
        for (name, value) in &key.values {
            let allowed = value.allowed.unwrap_or_else(|| panic!("{kind}: {name} has no band"));
            assert!(!name.starts_with("P(") || allowed <= 4.0 * mu, "{kind}: {name} ± {allowed}");
            assert!(!name.starts_with("L(") || value.value >= 15.0 * mu, "{kind}: {name} is short");
        }
    }
}

/// A photograph of the sheet is read by what its code says.
#[test]
fn the_sheet_of_an_exercise_has_the_mechanism_at_the_scale_of_the_centres() {
    let base = with_figure("four-bar", json!({ "panels": ["scheme", "centers"], "velocities": ["C"] }));
    let exercise = Exercises::new(&base, None, 7).expect("it can vary").next().expect("an exercise");
    let sheets = exercise.sheets("centres-7-1");
    let sheet = &sheets[1];
    let code = sheet.code.as_ref().expect("markers and a code");
    let read = SheetCode::read(&code.text()).expect("a code");
    let [panel] = read.panels.as_slice() else { panic!("one panel") };
    assert_eq!((panel.panel, Some(panel.mu)), (Sheet::Centers, exercise.scales[Sheet::Centers]));
    let joints: Vec<_> =
        sheet.marks.iter().filter(|mark| mark.pen == Pen::Joint).map(|mark| mark.shape.bounds().center()).collect();
    for place in &exercise.solution.pose.points {
        let [x, y] = panel.at([place.x, place.y]);
        assert!(
            joints.iter().any(|joint| (*joint - Point::new(x, y)).hypot() < 0.01),
            "a joint stands where the code says"
        );
    }
}

#[test]
fn a_figure_with_a_plan_beside_its_centres_makes_exercises_of_both() {
    let base = with_figure("four-bar", json!({ "panels": ["scheme", "velocity", "centers"] }));
    let exercise = Exercises::new(&base, None, 3).expect("it can vary").next().expect("an exercise");
    let names: Vec<String> = exercise.key().values.keys().cloned().collect();
    for name in ["vplan(d,c)", "omega(3)", "P(1,3).x"] {
        assert!(names.iter().any(|own| own == name), "{name} in {names:?}");
    }
}

/// A form with places of the four-bar's centres on paper, in mm at 2 mm for each, moved by this.
fn places(moved: &[(&str, [f64; 2])], origin: [f64; 2], degrees: f64) -> Value {
    let text = files::read("templates/four-bar.json");
    let solution = solved(&text).expect("a sound scene");
    let point =
        |name: &str| solution.pose.points[solution.mechanism.points.iter().position(|p| p == name).expect("a joint")];
    let [a, b, c, d] = ["A", "B", "C", "D"].map(point);
    // Of two lines by two points each, by Cramer's rule.
    let crossing = |p: [f64; 2], q: [f64; 2], r: [f64; 2], s: [f64; 2]| {
        let [u, v] = [[q[0] - p[0], q[1] - p[1]], [s[0] - r[0], s[1] - r[1]]];
        let t = ((r[0] - p[0]) * v[1] - (r[1] - p[1]) * v[0]) / (u[0] * v[1] - u[1] * v[0]);
        [p[0] + t * u[0], p[1] + t * u[1]]
    };
    let [a, b, c, d] = [a, b, c, d].map(|p| [p.x, p.y]);
    let all = [("A", a), ("D", d), ("P(2,0)", crossing(a, b, c, d)), ("P(3,1)", crossing(b, c, a, d))];
    let (sine, cosine) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    let placed = all.into_iter().map(|(name, [x, y])| {
        let by = moved.iter().find(|(own, _)| *own == name).map_or([0.0; 2], |(_, by)| *by);
        let [x, y] = [(x - a[0]) / 2.0 + by[0], (y - a[1]) / 2.0 + by[1]];
        (name.to_owned(), json!([origin[0] + cosine * x - sine * y, origin[1] + sine * x + cosine * y, 0.3]))
    });
    let placed: serde_json::Map<String, Value> = placed.collect();
    json!({ "kinegon_measured": 1, "mu_c": 2.0, "points": { "centers": placed } })
}

#[test]
fn places_on_paper_are_coordinates_of_centres() {
    let solution = with_figure("four-bar", json!({ "panels": ["scheme", "centers"] }));
    let key = AnswerKey::new(&solution, None);
    let told = |form: Value| {
        let checked = check(&Measured::read_json(&form.to_string()).expect("a form"), &key).expect("it is understood");
        let values = checked.values.iter().map(|value| (value.entry.asked.name().to_owned(), value.verdict));
        let findings = checked.diagnosis.best.findings.iter().map(|finding| finding.candidate.mistake().id());
        (values.collect::<Vec<_>>(), findings.collect::<Vec<_>>())
    };
    let right = [("P(2,ground).x", 0), ("P(2,ground).y", 0), ("P(1,3).x", 0), ("P(1,3).y", 0)];
    let right: Vec<_> = right.map(|(name, _)| (name.to_owned(), Verdict::Right)).to_vec();
    // From whatever place they are measured, and however the sheet lies, where a second joint shows that.
    for (origin, degrees) in [([0.0, 0.0], 0.0), ([31.0, -17.0], 0.0), ([31.0, -17.0], 35.0), ([5.0, 80.0], -120.0)] {
        let (values, findings) = told(places(&[], origin, degrees));
        assert_eq!((values, findings.len()), (right.clone(), 0), "{origin:?} {degrees}");
    }
    let (values, _) = told(places(&[("P(3,1)", [6.0, 0.0])], [3.0, 4.0], 20.0));
    let off: Vec<&str> =
        values.iter().filter(|(_, verdict)| *verdict == Verdict::Off).map(|(name, _)| name.as_str()).collect();
    assert_eq!(off, ["P(1,3).x"]);
    // Both at each other's place.
    let [x, y] = ["P(2,ground)", "P(1,3)"].map(|name| {
        let centers = solution.construction.centers.as_deref().expect("centres");
        centers.all.iter().find(|center| center.name == name).and_then(|center| center.place.finite()).expect("near")
    });
    let by = (y - x) / 2.0;
    let (_, findings) = told(places(&[("P(2,0)", [by.x, by.y]), ("P(3,1)", [-by.x, -by.y])], [0.0; 2], 0.0));
    assert_eq!(findings, ["lines-without-common-link"]);
}

#[test]
fn places_of_centres_are_written_as_they_are_read() {
    let solution = with_figure("four-bar", json!({ "panels": ["scheme", "centers"] }));
    let form = places(&[], [3.5, -2.0], 0.0);
    let measured = Measured::read_json(&form.to_string()).expect("a form");
    let again: Value = serde_json::from_str(&measured.json(&solution)).expect("JSON");
    assert_eq!(again["points"], form["points"]);
    let table = Measured::read_csv(&measured.csv(&solution)).expect("a table");
    assert_eq!(table.points[0].sheet, Sheet::Centers);
    assert_eq!(table.points[0].places.len(), 4);
    // Without the joint from which they are measured they say nothing, and on a force plan nothing is placed.
    let mut without = form.clone();
    without["points"]["centers"].as_object_mut().expect("places").remove("A");
    let error = check(&Measured::read_json(&without.to_string()).expect("a form"), &AnswerKey::new(&solution, None));
    assert_eq!(
        error.expect_err("no origin").to_string(),
        "instant centres: the place of A is missing, from which the others are measured"
    );
    let forces = json!({ "kinegon_measured": 1, "points": { "forces": { "A": [0, 0] } } }).to_string();
    assert!(Measured::read_json(&forces).is_err());
}
