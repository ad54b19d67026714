//! Forms as a page shows and writes them.

use kinegon::Sheet;
use kinegon::check::{Measured, check, faults, form_boxes, further_boxes, report_parts, sheet_points};
use serde_json::Value;
use support::files;
use support::stages::{answer_key, solved};

#[test]
fn boxes_are_those_of_the_empty_form() {
    for (name, text) in files::templates() {
        let solution = solved(&text).expect("a starting scene is sound");
        let form = Measured::empty(solution.scales(), None);
        let file: Value = serde_json::from_str(&form.json(&solution)).expect("JSON");
        let asked: Vec<&str> = file["values"].as_object().expect("values").keys().map(String::as_str).collect();
        let boxes: Vec<String> = form_boxes(&solution).into_iter().map(|found| found.name).collect();
        assert_eq!(boxes, asked, "{name}");
        let points = sheet_points(&solution);
        let [velocity, acceleration] = [Sheet::Velocity, Sheet::Acceleration].map(|plan| points[plan][0].0.as_str());
        assert_eq!((velocity, acceleration), ("p", "π"), "{name}");
    }
}

/// The paper's values, with a place on paper.
fn papers() -> Measured {
    let form = files::read("examples/paper-as-student.json");
    Measured::read_json(&form).expect("a form")
}

#[test]
fn a_form_that_is_written_and_read_again_has_the_same_verdicts() {
    let solution = solved(&files::read("examples/figure-2.json")).expect("a sound scene");
    let key = answer_key(&solution, 1);
    let own = papers();
    // What is missing differs: the written form asks for all boxes.
    let told = |measured: &Measured| {
        let checked = check(measured, &key).expect("values that are understood");
        let parts = report_parts(&checked, &key);
        let rows = parts.rows.into_iter().flat_map(|row| row.cells);
        let causes = parts.causes.into_iter().map(|cause| cause.done);
        rows.chain(causes).chain([parts.heading]).collect::<Vec<String>>()
    };
    let again = Measured::read_json(&own.json(&solution)).expect("a form");
    assert_eq!(told(&again), told(&own));
    assert_eq!(told(&Measured::read_csv(&own.csv(&solution)).expect("a table")), told(&own));
    // A second time nothing changes any more.
    assert_eq!(again.json(&solution), own.json(&solution));
}

#[test]
fn every_verdict_has_its_box() {
    let solution = solved(&files::read("examples/figure-2.json")).expect("a sound scene");
    let key = answer_key(&solution, 2);
    let own = papers();
    let written = own.json(&solution);
    let own = Measured::read_json(&written).expect("a form");
    let mut boxes: Vec<String> = form_boxes(&solution).into_iter().map(|found| found.name).collect();
    let further: Vec<String> = further_boxes(&own, &key).into_iter().map(|found| found.name).collect();
    assert!(further.contains(&"v(B/A).size".to_owned()), "{further:?}");
    boxes.extend(further);
    let checked = check(&own, &key).expect("values that are understood");
    let parts = report_parts(&checked, &key);
    assert_eq!(parts.rows.len(), checked.values.len());
    for row in &parts.rows {
        assert!(boxes.contains(&row.name), "{} of {boxes:?}", row.name);
    }
}

/// A double quote that never closes takes the lines below with it: that is told, and nothing is an empty form.
#[test]
fn an_open_quotation_mark_is_told() {
    let measured = Measured::read_csv("omega(3),4\n\"omega(2),5\nalpha(2),6\n").expect("a table");
    assert_eq!(measured.values.len(), 1);
    let faults: Vec<String> = measured.faults.iter().map(ToString::to_string).collect();
    assert!(faults.len() == 1 && faults[0].contains("line 2") && faults[0].contains("double quote"), "{faults:?}");
    assert!(Measured::read_csv("\"omega(3)\",4\n\"L(B,S3)\",\"5,5\"\n").expect("a table").faults.is_empty());
}

#[test]
fn values_that_are_not_understood_are_told_apart() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a starting scene is sound");
    let key = answer_key(&solution, 2);
    let form = r#"{ "kinegon_measured": 1, "values": { "vplan(p,b)": "600", "omega(2)": "abc", "foo(1)": "3" } }"#;
    let measured = Measured::read_json(form).expect("a form");
    let found: Vec<(usize, String)> =
        faults(&measured, &key).into_iter().map(|(at, why)| (at, why.message.to_string())).collect();
    let said = ["`abc` is no number", "`foo(1)` is no quantity of this scene"];
    assert_eq!(found, [(1, said[0].to_owned()), (2, said[1].to_owned())]);
}

#[test]
fn a_unit_may_stand_behind_its_digits() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a starting scene is sound");
    let key = answer_key(&solution, 2);
    let of = |measured: &Measured| {
        let entries = kinegon::check::entries(measured, &key).expect("values that are understood");
        entries.into_iter().map(|entry| (entry.value, entry.rounding, entry.unit)).collect::<Vec<_>>()
    };
    // 1 rad/s is 60/2π = 9.549 revolutions per minute; the scene is in millimetres.
    let cells = ["6.6 m/s", "6,6 m/s", "6.6m/s", "0.66e1 m/s", "+6.6 m/s"];
    for cell in cells {
        let form =
            format!(r#"{{ "kinegon_measured": 1, "values": {{ "vplan(p,b)": "{cell}", "omega(2)": "-19,10 rpm" }} }}"#);
        let table = format!("vplan(p,b);{cell}\nomega(2);-19,10 rpm\n");
        let [json, csv] = [Measured::read_json(&form).expect("a form"), Measured::read_csv(&table).expect("a table")];
        let found = of(&json);
        assert_eq!(of(&csv), found, "{cell}");
        let [(speed, rounding, unit), (rate, ..)] = found.as_slice() else { panic!("two values") };
        assert_eq!((*speed, unit.as_deref()), (6600.0, Some("m/s")), "{cell}");
        assert!((rounding - 50.0).abs() < 1e-9, "{cell}: {rounding}");
        assert!((rate + 19.1 * core::f64::consts::TAU / 60.0).abs() < 1e-12, "{rate}");
    }
    // What is behind the digits must be a unit.
    for cell in ["6.6 e", "6.6 to 7 m/s", "about 6.6", "6.6e", "1/0", "6.6 kg"] {
        let form = format!(r#"{{ "kinegon_measured": 1, "values": {{ "vplan(p,b)": "{cell}" }} }}"#);
        assert_eq!(faults(&Measured::read_json(&form).expect("a form"), &key).len(), 1, "{cell}");
    }
    // A megabyte of letters is told as fast as it is read, by whatever machine.
    let long = format!(r#"{{ "kinegon_measured": 1, "values": {{ "vplan(p,b)": "{}" }} }}"#, "6m".repeat(500_000));
    let began = std::time::Instant::now();
    assert_eq!(faults(&Measured::read_json(&long).expect("a form"), &key).len(), 1);
    assert!(began.elapsed().as_secs_f64() < 2.0, "{:?}", began.elapsed());
}
