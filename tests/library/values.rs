//! The layer of values: each number beside a vector or a link is that of the result, in the unit asked for.

use kinegon::drawing::{Drawing, FigureSheets, Shape};
use kinegon::scene::{LengthUnit, Page, StyleName, ValuesShown};
use kinegon::{Scene, Solution, solve};
use support::faults::{faults, id};
use support::files::{read, scenes};
use support::survey::LISTED_UNITS;

/// The scene, drawn with values in this unit.
fn with_values(text: &str, unit: Option<LengthUnit>) -> Option<(Solution, Drawing)> {
    let mut scene = Scene::read(text).ok()?;
    scene.figure.values = Some(ValuesShown::Shown(unit));
    let solution = solve(&scene).ok()?;
    let drawing = solution.figure();
    Some((solution, drawing))
}

/// The texts of a drawing whose ids begin with this.
fn texts<'a>(drawing: &'a Drawing, begin: &'a str) -> impl Iterator<Item = String> + 'a {
    let marks = drawing.marks.iter().filter(move |mark| id(mark).contains(begin));
    marks.filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.text.content()),
        _ => None,
    })
}

/// The number and the unit behind the sign of equality.
fn number_and_unit(text: &str) -> (f64, &str) {
    let behind = text.rsplit('=').next().expect("a value");
    let letters = behind.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(behind.len());
    let (number, unit) = behind.split_at(letters);
    let number = number.replace(char::is_whitespace, "").replace('−', "-");
    let (digits, power) = number.split_once("·10").unwrap_or((&number, "0"));
    let number: f64 = digits.parse().unwrap_or_else(|_| panic!("{text}"));
    (number * libm::pow(10.0, power.parse().unwrap_or_else(|_| panic!("{text}"))), unit)
}

/// By the id of a listed value: its result, if it is that of one point or link.
fn truth(result: &serde_json::Value, id: &str) -> Option<f64> {
    let size = |name: &str, key: &str| {
        let [x, y] = [0, 1].map(|k| result["points"][name][key][k].as_f64());
        Some(libm::hypot(x?, y?))
    };
    if let Some(name) = id.strip_prefix("listed-velocity-value-v_") {
        return size(name, "velocity");
    }
    if let Some(name) = id.strip_prefix("listed-acceleration-value-a_") {
        return size(name, "acceleration");
    }
    let rate = |name: &str, key: &str| result["links"][name][key].as_f64();
    if let Some(name) = id.strip_prefix("listed-scheme-value-u3c9_") {
        return rate(name, "omega");
    }
    id.strip_prefix("listed-scheme-value-u3b1_").and_then(|name| rate(name, "alpha"))
}

#[test]
fn listed_values_are_those_of_the_result() {
    let mut seen = 0;
    let units = [(None, None), (Some(LengthUnit::M), Some(1.0)), (Some(LengthUnit::In), Some(0.0254))];
    let every = LISTED_UNITS.now();
    for (turn, (name, text)) in scenes("templates").into_iter().chain(scenes("tests/lecture")).enumerate() {
        for (unit, per_metre) in units.into_iter().skip(turn % every).step_by(every) {
            let Some((solution, drawing)) = with_values(&text, unit) else { continue };
            let own = match solution.scene.units.length {
                LengthUnit::M => 1.0,
                LengthUnit::Mm => 1e-3,
                LengthUnit::Cm => 1e-2,
                LengthUnit::In => 0.0254,
                LengthUnit::Ft => 0.3048,
                other => panic!("how long is {other:?}?"),
            };
            let result = serde_json::to_value(solution.result()).expect("JSON");
            for mark in drawing.marks.iter().filter(|mark| id(mark).starts_with("listed-")) {
                let Shape::Text(placed) = &mark.shape else { panic!("{mark:?}") };
                let Some(truth) = truth(&result, id(mark)) else { continue };
                let text = placed.text.content();
                let (shown, written) = number_and_unit(&text);
                let of_vector = !id(mark).contains("scheme");
                let factor = if of_vector { per_metre.map_or(1.0, |metre| own / metre) } else { 1.0 };
                let off = (shown - truth * factor).abs();
                assert!(off <= 0.0051 * (truth * factor).abs() + 1e-9, "{name}: {} is {shown}, not {truth}", id(mark));
                if let (Some(unit), true) = (unit, of_vector) {
                    assert!(written.starts_with(unit.as_str()), "{name}: {written}");
                }
                seen += 1;
            }
        }
    }
    assert!(seen > 500 / every, "{seen}");
}

#[test]
fn nothing_covers_a_value() {
    let mut wrong = Vec::new();
    let mut labels = 0;
    for (name, text) in scenes("templates").into_iter().chain(scenes("tests/lecture")) {
        let Some((_, drawing)) = with_values(&text, None) else { continue };
        labels += drawing.marks.iter().filter(|mark| id(mark).contains("-value-")).count();
        wrong.extend(faults(&drawing).into_iter().map(|fault| format!("{name}: {fault}")));
    }
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
    assert!(labels > 300, "{labels}");
}

/// Without being asked for, values stand on sheets for a lecture alone.
#[test]
fn values_are_usual_in_a_lecture_alone() {
    let text = read("templates/four-bar.json");
    let drawn = |style: &str| {
        let mut scene = Scene::read(&text).expect("a template");
        scene.figure.style = kinegon::scene::StyleName::ALL.into_iter().find(|s| s.as_str() == style).expect("a style");
        solve(&scene).expect("it moves").figure()
    };
    assert_eq!(texts(&drawn("paper"), "value-").count(), 0);
    assert!(texts(&drawn("lecture"), "value-").count() > 5);
}

/// A list of results makes no scale much coarser, unless names without room want a list, too, and the scales that the sheet then states are scales at which it can be drawn.
#[test]
fn a_list_costs_no_scale_much() {
    let mut with_list = 0;
    for name in ["dyad-rpp", "fourth-class"]
        .map(|name| format!("templates/{name}.json"))
        .into_iter()
        .chain(["atkinson", "geneva", "peau", "shaper", "stephenson"].map(|name| format!("tests/lecture/{name}.json")))
    {
        let text = read(&name);
        let mut scales = |shown: ValuesShown, given| {
            let mut scene = Scene::read(&text).expect("a good scene");
            (scene.figure.values, scene.figure.mu) = (Some(shown), given);
            let solution = solve(&scene).expect("it moves");
            let sheets = FigureSheets::new(&solution);
            assert!(sheets.overflow_warnings().is_empty(), "{name}: {:?}", sheets.overflow_warnings());
            with_list += usize::from(texts(&sheets.figure(), "listed-").next().is_some());
            sheets.scales()
        };
        let without = scales(ValuesShown::Hidden, Default::default());
        let with = scales(ValuesShown::Shown(None), Default::default());
        for (sheet, mu) in with.given() {
            let before = without[sheet].expect("it has that panel");
            assert!(mu <= 1.2 * before * (1.0 + 1e-9), "{name}: {mu} in place of {before}");
        }
        assert_eq!(scales(ValuesShown::Shown(None), with), with, "{name}");
    }
    assert!(with_list >= 7, "only {with_list} lists");
}

/// The list of results takes the place of the remark, so that a figure has the same room with values and without; and it gives
/// way to names, which then stand on the figure at its scales.
#[test]
fn a_list_stands_in_place_of_the_remark_and_gives_way_to_names() {
    let drawn = |name: &str, shown: ValuesShown| {
        let mut scene = Scene::read(&read(name)).expect("a good scene");
        scene.figure.values = Some(shown);
        let solution = solve(&scene).expect("it moves");
        let sheets = FigureSheets::new(&solution);
        (sheets.figure(), sheets.scales())
    };
    let has_remark = |drawing: &Drawing| {
        drawing.marks.iter().any(|mark| match &mark.shape {
            Shape::Text(text) => text.text.content().contains("loop equations"),
            _ => false,
        })
    };
    let mut counts = [0; 2];
    for name in ["four-bar", "fourth-class", "watt-1", "slider-crank"].map(|name| format!("templates/{name}.json")) {
        let (with, without) = (drawn(&name, ValuesShown::Shown(None)).0, drawn(&name, ValuesShown::Hidden).0);
        let has_list = texts(&with, "listed-").next().is_some();
        assert_eq!([has_remark(&with), has_remark(&without)], [!has_list, true], "{name}");
        counts[usize::from(has_list)] += 1;
    }
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    let valve = "tests/lecture/valve.json";
    let ((with, scales), (_, own)) = (drawn(valve, ValuesShown::Shown(None)), drawn(valve, ValuesShown::Hidden));
    assert_eq!(scales, own);
    assert!(with.unlabelled.is_empty() && texts(&with, "listed-").next().is_none() == has_remark(&with));
}

/// Of a crowd in the hall there are few sheets: the main results that have no room on the figure, and parts of the plans that
/// are much smaller than these. All values follow only where they are asked for.
#[test]
fn a_crowd_in_the_hall_has_few_sheets() {
    let sheets_of = |asked: Option<ValuesShown>| {
        let mut scene = Scene::read(&read("tests/lecture/excavator.json")).expect("a good scene");
        let figure = &mut scene.figure;
        (figure.style, figure.page, figure.values) =
            (StyleName::Lecture, Page::from_name("16x9").expect("a page"), asked);
        let solution = solve(&scene).expect("it moves");
        let sheets = FigureSheets::new(&solution);
        let all = sheets.sheets();
        let tables = all.iter().skip(1).filter(|sheet| sheet.panels.is_empty()).count();
        (tables, all.len(), sheets.values_left_out(&all[0]))
    };
    let (tables, all, left_out) = sheets_of(None);
    assert!(tables <= 1 && all <= 5 && left_out > 20, "{tables} tables of {all} sheets, {left_out} values left out");
    let (tables, _, left_out) = sheets_of(Some(ValuesShown::Shown(None)));
    assert!(tables > 1 && left_out == 0, "{tables} tables, {left_out} values left out");
}

/// Points that are one but for rounding have no sheet of their own: of the scissor five names stand at one place.
#[test]
fn one_place_has_no_sheet_of_its_own() {
    let mut scene = Scene::read(&read("tests/lecture/scissor.json")).expect("a good scene");
    (scene.figure.style, scene.figure.page) = (StyleName::Lecture, Page::from_name("16x9").expect("a page"));
    let sheets = FigureSheets::new(&solve(&scene).expect("it moves")).sheets();
    assert_eq!(sheets.iter().filter(|sheet| !sheet.panels.is_empty()).count(), 1);
}

/// A relative vector has its head where its symbol says: that of v_CB is at c.
#[test]
fn relative_vectors_have_heads() {
    let (_, drawing) = with_values(&read("templates/four-bar.json"), None).expect("it moves");
    let place =
        |name: &str| drawing.marks.iter().find(|mark| id(mark) == name).expect("a point").shape.bounds().center();
    for (vector, head) in
        [("velocity-vector-b-c", "velocity-point-c"), ("acceleration-vector-n_bC-c", "acceleration-point-c")]
    {
        let mark = drawing.marks.iter().find(|mark| id(mark) == vector).unwrap_or_else(|| panic!("no {vector}"));
        let Shape::Arrow { to, .. } = mark.shape else { panic!("{mark:?}") };
        assert!((to - place(head)).hypot() < 1e-6, "{vector}");
    }
}
