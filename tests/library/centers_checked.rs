//! Forms with instant centres: what they ask for, that independent digits are right there, and that other forms are as they were.

use kinegon::centers::LinkPair;
use kinegon::check::{AnswerKey, Measured, Verdict, check, form_names};
use kinegon::construction::{CenterOrigin, Spot, Tolerance};
use kinegon::drawing::markers::SheetCode;
use kinegon::drawing::{Pen, Point};
use kinegon::exercise::Exercises;
use kinegon::geometry::Place;
use kinegon::quantity::step_pencil;
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
fn exercised() -> [(&'static str, Value); 7] {
    let panels = json!(["scheme", "centers"]);
    [
        ("four-bar", json!({ "panels": panels, "velocities": ["C"] })),
        ("slider-crank", json!({ "panels": panels, "velocities": ["C"] })),
        ("slotted-lever", json!({ "panels": panels })),
        ("stephenson-3", json!({ "panels": panels, "centers": ["P(1,5)"] })),
        ("fourth-class", json!({ "panels": panels, "centers": ["P(1,4)"], "velocities": ["F"] })),
        ("four-bar", json!({ "panels": panels, "centers": ["P(2,ground)"], "inflection": ["2"] })),
        ("slider-crank", json!({ "panels": panels, "centers": ["P(2,ground)"], "inflection": ["2"] })),
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
            assert!(!name.starts_with("d_i(") || allowed <= 0.5 * value.value, "{kind}: {name} ± {allowed}");
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

/// A parallelogram: its coupler only translates, and so does each of two opposite links against the other.
const PARALLELOGRAM: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": ["A", "D"],
    "points": { "A": [0, 0], "B": [30, 40], "C": [130, 40], "D": [100, 0] },
    "links": { "1": { "points": ["A", "B"], "drive": { "omega": 2, "alpha": 0 } }, "2": ["B", "C"], "3": ["D", "C"] },
    "figure": { "panels": ["scheme", "centers"], "centers": "all" } }"#;

#[test]
fn the_direction_of_a_centre_at_infinity_is_read_as_that_of_a_line() {
    let solution = solved(PARALLELOGRAM).expect("it can be solved");
    assert_eq!(names(&solution), ["P(2,ground).angle", "P(1,3).angle"]);
    // The cranks have the slope 4 : 3, frame and coupler none.
    let crank = 53.130_102_354_155_98;
    let verdicts = |first: f64, second: f64| -> Vec<Verdict> {
        let values = json!({ "P(2,ground).angle": format!("{first:.1}"), "P(1,3).angle": format!("{second:.1}") });
        let checked = check(&form(&values), &AnswerKey::new(&solution, None)).expect("a form");
        assert!(checked.values.iter().all(|value| (0.5..5.0).contains(&value.tolerance)));
        checked.values.iter().map(|value| value.verdict).collect()
    };
    assert_eq!(verdicts(crank, 0.0), [Verdict::Right, Verdict::Right]);
    assert_eq!(verdicts(crank - 180.0, 180.0), [Verdict::Right, Verdict::Right]);
    assert_eq!(verdicts(crank + 0.4, -179.7), [Verdict::WithinTolerance, Verdict::WithinTolerance]);
    assert_eq!(verdicts(crank + 90.0, 90.0), [Verdict::Off, Verdict::Off]);
}

#[test]
fn a_form_that_names_centres_is_judged_where_the_figure_shows_none() {
    let shown = with_figure("four-bar", json!({ "panels": ["scheme", "centers"], "velocities": ["C"] }));
    let plans = with_figure("four-bar", json!({ "panels": ["scheme", "velocity"], "mu_v": 5, "mu_l": 2 }));
    let digits = |name: &str| format!("{:.2}", shown.quantity(name).expect("a value").as_number());
    let values = json!({ "P(1,3).x": digits("P(1,3).x"), "P(0,2).y": "0.0", "omega(3)": digits("omega(3)") });
    let written = form(&values);
    assert!(form(&json!({ "omega(3)": "1.0" })).with_centers(&plans).is_none(), "it names none");
    assert!(written.with_centers(&shown).is_none(), "the figure has them");
    let solution = written.with_centers(&plans).expect("a construction of the centres");
    let checked = check(&written, &AnswerKey::new(&solution, None)).expect("a form");
    let verdicts: Vec<Verdict> = checked.values.iter().map(|value| value.verdict).collect();
    assert_eq!(verdicts, [Verdict::Right, Verdict::Off, Verdict::Right]);
}

#[test]
fn a_figure_of_permanent_centres_alone_says_that_nothing_is_to_be_found() {
    let base =
        with_figure("four-bar", json!({ "panels": ["scheme", "centers"], "centers": ["P(1,ground)", "P(1,2)"] }));
    let error = Exercises::new(&base, None, 1).expect_err("there is nothing to find").to_string();
    assert!(error.contains("nothing to find"), "{error}");
}

#[test]
fn steps_tell_places_distances_and_directions_with_their_bands() {
    let figure = json!({ "panels": ["scheme", "centers"], "mu_c": 2, "velocities": ["C"] });
    let solution = with_figure("four-bar", figure);
    let pencil = step_pencil(&solution, Tolerance::default()).expect("bands");
    let steps = solution.steps(&pencil);
    for name in ["P(1,3).x", "P(2,ground).y", "L(P(3,ground),C)", "omega(3)", "v(C).angle"] {
        let band = pencil.band(name).unwrap_or_else(|| panic!("{name} has a band"));
        let (value, band) = (solution.quantity(name).expect("a value").as_number(), band.band);
        let line = steps.lines().find(|line| {
            let number = |text: &str| text.trim().split([' ', '°']).next().and_then(|text| text.parse::<f64>().ok());
            let near = |text: Option<&str>, of: f64, part: f64| {
                text.and_then(number).is_some_and(|x| (x - of).abs() <= part * of.abs())
            };
            let last = line.rsplit(" = ").next();
            near(last, value, 1e-3) && near(line.split("; ± ").nth(1), band, 0.06)
        });
        assert!(line.is_some(), "{name} = {value} ± {band} in\n{steps}");
    }
}

#[test]
fn a_centre_is_called_by_the_label_of_the_frame() {
    let symbol = |figure: Value| {
        let solution = with_figure("four-bar", figure);
        let pair = LinkPair::named("P(1,ground)", &solution.mechanism).expect("a pair");
        pair.symbol(0, &solution.mechanism, &solution.wording().notation, &str::to_owned)
    };
    assert_eq!(symbol(json!({})), "P_{10}");
    assert_eq!(symbol(json!({ "frame": "0" })), "P_{10}");
    assert_eq!(symbol(json!({ "frame": "0", "labels": { "ground": "6" } })), "P_{16}");
    assert_eq!(symbol(json!({ "labels": { "ground": "bed plate" } })), "P_{10}");
}

/// The digits are those of absolute coordinates and free bodies; the lines use no rate.
#[test]
fn inflection_poles_by_lines_are_those_of_independent_digits() {
    let mut count = 0;
    for line in files::read("tests/centers/cases.jsonl").lines() {
        let case: Value = serde_json::from_str(line).expect("JSON");
        let expected = case["expected"]["inflection"].as_object().expect("links");
        let mut scene = case["scene"].clone();
        let links: Vec<&String> = expected.keys().collect();
        scene["figure"] = json!({ "panels": ["centers"], "inflection": links });
        let solution = solved(&scene.to_string()).expect("it can be solved");
        let size = kinegon::geometry::span(solution.pose.points.iter().copied());
        for found in &solution.construction.centers.as_deref().expect("centres").inflections {
            let link = solution.construction.centers.as_deref().expect("centres").tangents[found.tangent].link;
            let truth = &expected[&solution.mechanism.body(link).name];
            let number = |value: &Value| value.as_str().and_then(|digits| digits.parse::<f64>().ok()).expect("digits");
            let pole = found.pole.finite().expect("a place");
            let off = [pole.x - number(&truth["inflection_pole"][0]), pole.y - number(&truth["inflection_pole"][1])];
            let diameter = number(&truth["diameter"]);
            assert!(off.iter().all(|off| off.abs() <= 1e-9 * size.max(diameter)), "{} {off:?}", case["id"]);
            assert!((found.diameter - diameter).abs() <= 1e-9 * size.max(diameter), "{}", case["id"]);
            let agreement = found.agreement.expect("accelerations");
            assert!(agreement.difference <= agreement.allowed, "{}: {agreement:?}", case["id"]);
            count += 1;
        }
    }
    assert!(count >= 6, "{count} inflection poles");
}

#[test]
fn an_exercise_asks_for_the_inflection_pole_and_does_not_show_it() {
    let figure = json!({ "panels": ["scheme", "centers"], "centers": ["P(2,ground)"], "inflection": ["2"] });
    let exercise = Exercises::new(&with_figure("four-bar", figure), None, 3).expect("it can vary").next().expect("one");
    let names: Vec<String> = exercise.key().values.keys().cloned().collect();
    assert!(["W(2).x", "W(2).y", "d_i(2)"].iter().all(|name| names.iter().any(|own| own == name)), "{names:?}");
    let shown = exercise.sheets("x").into_iter().flat_map(|sheet| sheet.marks);
    assert!(
        shown.into_iter().all(|mark| mark.id.is_none_or(|id| !id.contains("inflection"))),
        "the circle is the answer"
    );
}

/// A single flier: two of its centres need a link left out.
#[test]
fn a_single_flier_is_an_exercise() {
    let text = files::read("tests/centers/cases.jsonl");
    let line = text.lines().find(|line| line.contains("I02-single-flier")).expect("it is there");
    let mut scene = serde_json::from_str::<Value>(line).expect("a case")["scene"].clone();
    scene["figure"] = json!({ "panels": ["scheme", "centers"], "centers": ["P(5,ground)"] });
    let exercise = Exercises::new(&solved(&scene.to_string()).expect("solved"), None, 1).expect("it can vary").next();
    let exercise = exercise.unwrap_or_else(|error| panic!("{error}"));
    let centers = exercise.solution.construction.centers.as_deref().expect("centres");
    assert!(centers.by_rates.is_empty());
}
