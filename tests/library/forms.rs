//! Forms as a page shows and writes them.

use kinegon::Sheet;
use kinegon::check::{Measured, check, check_result, faults, form_boxes, further_boxes, report_parts, sheet_points};
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

/// A form of the four-bar linkage in millimetres of paper, 2 mm/s each, with a value of a plan's segment and one of a rate.
fn on_paper(segment: &str, rate: &str) -> Measured {
    let form = format!(
        r#"{{ "kinegon_measured": 1, "mu_v": 2, "mu_l": 1, "in": "mm", "values": {{ "vplan(p,b)": "{segment}", "omega(2)": "{rate}" }} }}"#
    );
    Measured::read_json(&form).expect("a form")
}

#[test]
fn a_unit_says_whether_a_segment_is_on_paper() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a starting scene is sound");
    let key = answer_key(&solution, 2);
    let cells = [
        ("162.5", true),
        ("162,5 mm", true),
        ("16.25 cm", true),
        ("6.3976378 in", true),
        ("325 mm/s", false),
        ("32.5cm/s", false),
        ("0,325 m/s", false),
    ];
    for (cell, is_on_paper) in cells {
        let entries = kinegon::check::entries(&on_paper(cell, "1"), &key).expect("values that are understood");
        let found = entries.iter().find(|entry| entry.asked.name() == "vplan(p,b)").expect("its value");
        assert_eq!(found.on_paper, is_on_paper, "{cell}");
        assert!((found.value - 325.0).abs() < 1e-5, "{cell}: {}", found.value);
    }
    // A revolution is 2π, a minute 60 s.
    let rate = -32.2_f64.to_radians();
    let cells = [
        "-32.2 °/s",
        "-32.2 º/s",
        "−32,2 deg/s",
        "-5.366667 rpm",
        "-5.366667 1/min",
        "-5.366667 min-1",
        "-5.366667 U/min",
        "-0.08944444 rev/s",
    ];
    for cell in cells {
        let entries = kinegon::check::entries(&on_paper("300", cell), &key).expect("values that are understood");
        let found = entries.iter().find(|entry| entry.asked.name() == "omega(2)").expect("its value");
        assert!((found.value - rate).abs() < 1e-6, "{cell}: {}", found.value);
    }
    for cell in ["0.1625 m", "3 kg", "3 rad/s"] {
        assert_eq!(faults(&on_paper(cell, "1"), &key).len(), 1, "{cell}");
    }
}

/// Values written where millimetres of paper are asked for, and rates in degrees, are told as that.
#[test]
fn values_for_millimetres_and_degrees_for_radians_are_told() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a starting scene is sound");
    let key = answer_key(&solution, 2);
    let written = |sheet: &str, text: &dyn Fn(f64) -> Option<String>| {
        let boxes = form_boxes(&solution).into_iter();
        let values = boxes.map(|found| {
            let value = found.asked.value(&solution.snapshot(), Some(&solution.construction), None);
            let value = value.expect("a value").as_number();
            let own = if found.asked.is_distance() {
                let scale = if found.asked.kind().unit(solution.scene.units) == "mm/s" { 2.0 } else { 20.0 };
                format!("{:.1}", value.abs() / scale)
            } else {
                format!("{value:+.4}")
            };
            let other = if found.name.starts_with(sheet) { text(value) } else { None };
            format!("{:?}: {:?}", found.name, other.unwrap_or(own))
        });
        let values = values.collect::<Vec<String>>().join(", ");
        let form =
            format!(r#"{{ "kinegon_measured": 1, "mu_v": 2, "mu_a": 20, "in": "mm", "values": {{ {values} }} }}"#);
        let measured = Measured::read_json(&form).expect("a form");
        let checked = check(&measured, &key).expect("values that are understood");
        serde_json::to_value(check_result(&checked, &key, None)).expect("JSON")["diagnosis"]["mistakes"].clone()
    };
    assert_eq!(written("", &|_| None), serde_json::json!([]));
    let told = written("vplan(p,b)", &|value| Some(format!("{value:.0}")));
    assert_eq!((&told[0]["mistake"], &told[1]), (&"other-unit".into(), &Value::Null), "{told}");
    assert_eq!(told[0]["done"], "vplan(p,b): 600 is the value in mm/s; the box asks for millimetres of paper");
    assert_eq!(told[0]["should_be"], "600 : 2 = 300 mm on paper");
    // Its millimetres may be those of the value; and 0 is 0 in every unit.
    let told = written("vplan(p,b)", &|value| Some(format!("{value:.0} mm")));
    assert_eq!(told[0]["done"], "vplan(p,b): 600 is the value in mm/s; the box asks for millimetres of paper");
    assert_eq!(told[0]["should_be"], "600 : 2 = 300 mm on paper");
    let told = written("omega(2)", &|_| Some("0".to_owned()));
    assert_ne!(told[0]["mistake"], "other-unit", "{told}");
    for (sheet, unit, scale) in [("vplan", "mm/s", "2"), ("aplan", "mm/s²", "20")] {
        let told = written(sheet, &|value| Some(format!("{:.0}", value.abs())));
        assert_eq!((&told[0]["mistake"], &told[1]), (&"other-unit".into(), &Value::Null), "{told}");
        let done = told[0]["done"].as_str().expect("a sentence");
        assert!(done.contains(&format!("values in {unit} are written")), "{done}");
        assert!(
            told[0]["should_be"].as_str().is_some_and(|should| should.contains(&format!("by {scale} is"))),
            "{told}"
        );
    }
    let told = written("omega(2)", &|value| Some(format!("{:+.1}", value.to_degrees())));
    assert_eq!((&told[0]["mistake"], &told[1]), (&"degrees-for-radians".into(), &Value::Null), "{told}");
}

/// What the segments of the plans are, as textbooks write it.
#[test]
fn a_segment_is_the_vector_between_its_points() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a starting scene is sound");
    let labels = kinegon::drawing::SheetLabels::of(&solution);
    let told = form_boxes(&solution).into_iter().filter_map(|found| {
        let vector = labels.vector(&found.asked)?;
        Some((found.name, kinegon::format::html_text(&vector)))
    });
    let told: Vec<(String, String)> = told.collect();
    let of = |name: &str| told.iter().find(|(own, _)| own == name).map(|(_, vector)| vector.as_str());
    assert_eq!(of("vplan(p,b)"), Some("<i>v</i><sub><i>B</i></sub>"), "{told:?}");
    assert_eq!(of("vplan(b,c)"), Some("<i>v</i><sub><i>CB</i></sub>"), "{told:?}");
    assert_eq!(of("aplan(n_bC,c)"), Some("<i>a</i><sub><i>CB</i></sub><sup><i>t</i></sup>"), "{told:?}");
    assert_eq!(of("aplan(d,n_dC)"), Some("<i>a</i><sub><i>CD</i></sub><sup><i>n</i></sup>"), "{told:?}");
}
