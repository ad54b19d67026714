//! Work sheets: what is printed is the result, millimetres times scale are the value, the ruler is one, and nothing overlaps on any page.

use kinegon::Sheet;
use kinegon::Solution;
use kinegon::drawing::{Drawing, Mark, Shape};
use kinegon::quantity::{Quantity, QuantityRequest, measured_names};
use support::faults::{faults, panels};
use support::files;
use support::stages::solved;
use support::survey::PAGES_EACH;

/// Every way to lay a sheet.
const PAGES: [&str; 6] = ["a4", "a4-portrait", "a3", "a3-portrait", "letter", "letter-portrait"];

/// A scene's text with these keys in its figure.
fn with_figure(text: &str, keys: serde_json::Value) -> String {
    let mut scene: serde_json::Value = serde_json::from_str(text).expect("a scene is JSON");
    for (key, value) in keys.as_object().expect("keys") {
        scene["figure"][key] = value.clone();
    }
    scene.to_string()
}

fn scenes() -> Vec<(String, String)> {
    let mut all = files::scenes("templates");
    for name in ["figure-1", "figure-2"] {
        all.push((name.to_owned(), files::read(&format!("examples/{name}.json"))));
    }
    all
}

/// The sheet with the panels, and the one with the table where it has no room there.
fn worksheet(text: &str, keys: serde_json::Value) -> (Solution, Vec<Drawing>) {
    let mut keys = keys;
    keys["worksheet"] = true.into();
    let solution = solved(&with_figure(text, keys)).expect("a good scene");
    let sheets = solution.sheets();
    (solution, sheets)
}

/// What the marks of an id say.
fn said(sheets: &[Drawing], id: &str) -> String {
    let found = |mark: &&Mark| mark.id.as_deref() == Some(id);
    match sheets.iter().flat_map(|sheet| &sheet.marks).find(found).map(|mark| &mark.shape) {
        Some(Shape::Text(text)) => text.text.content(),
        _ => panic!("no text {id}"),
    }
}

/// A number as it stands on paper, and the half of its last digit.
fn read(written: &str) -> (f64, f64) {
    // Large numbers have their digits in groups.
    let written = &written.replace(char::is_whitespace, "");
    let text = written.replace(',', ".").replace('−', "-").replace('\u{a0}', "");
    let (mantissa, power) = text.split_once("·10").unwrap_or((&text, "0"));
    let ten = libm::pow(10.0, power.parse().expect("a power"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len()) as f64;
    let value: f64 = mantissa.parse().unwrap_or_else(|_| panic!("{written}"));
    (value * ten, 0.5 * libm::pow(10.0, -decimals) * ten)
}

/// Rows of all sheets are the construction's measured lengths, in its order, to the printed digit.
#[test]
fn printed_lengths_are_the_results() {
    let mut rows = 0;
    for (name, text) in scenes() {
        for decimal in ["point", "comma"] {
            let (solution, sheets) = worksheet(&text, serde_json::json!({ "decimal": decimal }));
            let used = solution.scales();
            let names = measured_names(&solution.construction);
            for (index, asked) in names.iter().enumerate() {
                let cell = |which: &str| said(&sheets, &format!("measured-{}-{which}", index + 1));
                let Ok(Quantity::Number(value)) = solution.quantity(asked) else {
                    panic!("{name}: {asked} has no value")
                };
                let mu = match asked.as_bytes()[0] {
                    b'L' => used[Sheet::Scheme],
                    b'v' => used[Sheet::Velocity],
                    _ => used[Sheet::Acceleration],
                };
                let mu = mu.expect("the panel is there");
                let (mm, printed) = (cell("mm"), cell("value"));
                for written in [&mm, &printed] {
                    let other = if decimal == "comma" { '.' } else { ',' };
                    assert!(!written.contains(other), "{name}: {written}");
                }
                let ((mm, half_mm), (printed, half)) = (read(&mm), read(&printed));
                let value = value.abs();
                // A digit more for rounding to even where the result is exactly half way.
                assert!((printed - value).abs() <= half * (1.0 + 1e-9), "{name}: {asked} {printed} {value}");
                assert!((mm - value / mu).abs() <= half_mm * (1.0 + 1e-9), "{name}: {asked} {mm}");
                assert_eq!(half_mm, 0.005);
                assert!((mm * mu - printed).abs() <= half_mm * mu + half, "{name}: {asked}");
                let unit = QuantityRequest::new(asked, &solution.mechanism)
                    .expect("it is known")
                    .kind()
                    .unit(solution.scene.units);
                assert_eq!(cell("unit"), unit);
                rows += 1;
            }
            let beyond = format!("measured-{}-mm", names.len() + 1);
            assert!(sheets.iter().flat_map(|sheet| &sheet.marks).all(|mark| mark.id.as_deref() != Some(&beyond)));
        }
    }
    assert!(rows > 200, "{rows}");
}

#[test]
fn names_follow_the_notation_and_hidden_points_have_no_rows() {
    let text = files::read("examples/figure-2.json");
    let (_, sheets) = worksheet(&text, serde_json::json!({ "notation": "english" }));
    let name = |index: usize| said(&sheets, &format!("measured-{index}-name"));
    assert_eq!(name(1), "B S3");
    assert_eq!(name(5), "b s3");
    assert_eq!(name(9), "ns3bs′3");
    let (_, sheets) = worksheet(&text, serde_json::json!({ "labels": { "S3": "Q" }, "panels": ["scheme"] }));
    assert_eq!(said(&sheets, "measured-1-name"), "B Q");
    assert!(sheets.iter().all(|sheet| !sheet.svg().contains("measured-5-")));
    let (_, sheets) = worksheet(&text, serde_json::json!({ "special_points": false }));
    assert!(sheets.iter().all(|sheet| !sheet.svg().contains("measured-1-")));
}

#[test]
fn the_ruler_has_fifty_millimetres() {
    for page in PAGES {
        let text = files::read("templates/four-bar.json");
        let (_, sheets) = worksheet(&text, serde_json::json!({ "page": page }));
        let file = sheets[0].svg();
        let [width, height] = [sheets[0].width, sheets[0].height];
        let root = &file[..file.find('>').expect("the root ends")];
        for size in [
            format!(" width=\"{width}mm\""),
            format!(" height=\"{height}mm\""),
            format!(" viewBox=\"0 0 {width} {height}\""),
        ] {
            assert!(root.contains(&size), "{root}");
        }
        let ends = |id: &str| -> Vec<f64> {
            let start = file.find(&format!("<path id=\"{id}\" d=\"M")).expect("it is drawn");
            let data = file[start..].split('"').nth(3).expect("path data");
            let numbers = data.split(|c: char| !c.is_ascii_digit() && c != '.');
            numbers.filter(|n| !n.is_empty()).map(|n| n.parse().expect("a number")).collect()
        };
        let line = ends("ruler");
        assert_eq!(format!("{:.2}", line[2] - line[0]), "50.00", "{page}");
        assert_eq!(line[1], line[3]);
        for mm in 0..=50 {
            let stroke = ends(&format!("ruler-{mm}"));
            assert!((stroke[0] - line[0] - f64::from(mm)).abs() < 1e-3, "{page}");
            // Longer strokes at every fifth and tenth.
            let long = stroke[3] - stroke[1];
            let least = if mm % 10 == 0 {
                3.5
            } else if mm % 5 == 0 {
                2.5
            } else {
                1.5
            };
            assert!(long > least && long < least + 0.9, "{page}: {long}");
        }
    }
}

#[test]
fn nothing_overlaps_on_any_page() {
    let mut wrong = Vec::new();
    for (turn, (name, text)) in scenes().into_iter().enumerate() {
        for page in PAGES.into_iter().skip(turn % PAGES_EACH.now()).step_by(PAGES_EACH.now()) {
            for language in ["en", "es"] {
                // Words are as long in one as in the other on most sheets.
                if language == "es" && page != "a4-portrait" {
                    continue;
                }
                let keys = serde_json::json!({ "page": page, "language": language, "decimal": "comma" });
                let (_, sheets) = worksheet(&text, keys);
                for (number, sheet) in sheets.iter().enumerate() {
                    let found = faults(sheet);
                    wrong.extend(found.iter().map(|fault| format!("{name} on {page}, sheet {number}: {fault}")));
                    let has_table = number + 1 == sheets.len();
                    let legend = usize::from(number == 0);
                    assert_eq!(panels(sheet).len(), sheet.panels.len() + legend + usize::from(has_table), "{name}");
                    assert_eq!(!sheet.panels.is_empty(), number == 0, "{name} on {page}");
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

/// Four groups on one crank, with 48 measured lengths: the table stands in more columns, on as many sheets as it needs, in letters of the usual size, and keeps to itself.
#[test]
fn long_tables_stand_in_columns() {
    let mut scene: serde_json::Value = serde_json::from_str(&files::read("templates/third-class.json")).expect("JSON");
    // More groups of the same kind on the same crank pin, with names of their own.
    let (links, ground, near) = (scene["links"].clone(), scene["ground"].clone(), scene["near"].clone());
    for copy in 1..4 {
        let renamed = |value: &serde_json::Value| {
            let mut text = value.to_string();
            for point in ["C", "D", "E", "F", "G"] {
                text = text.replace(point, &format!("{point}{}", "'".repeat(copy)));
            }
            serde_json::from_str::<serde_json::Value>(&text).expect("still JSON")
        };
        for (key, place) in renamed(&ground).as_object().expect("points") {
            if key != "A" && key != "note" {
                scene["ground"][key] = place.clone();
            }
        }
        for (key, place) in renamed(&near).as_object().expect("points") {
            if key != "note" {
                scene["near"][key] = place.clone();
            }
        }
        for (key, link) in renamed(&links).as_object().expect("links") {
            if key != "1" {
                scene["links"][format!("{key}{}", copy * 10)] = link.clone();
            }
        }
    }
    for page in PAGES {
        let (solution, sheets) = worksheet(&scene.to_string(), serde_json::json!({ "page": page }));
        let rows = measured_names(&solution.construction).len();
        assert!(rows >= 40, "{rows}");
        // The mechanisms lie on each other, so only the table is looked at.
        let wrong = sheets.iter().flat_map(faults).filter(|fault| fault.contains("measured"));
        let wrong: Vec<String> = wrong.collect();
        assert!(wrong.is_empty(), "{page}: {}", wrong.join("\n"));
        said(&sheets, &format!("measured-{rows}-mm"));
        let letters = |sheet: &Drawing| {
            let cells =
                sheet.marks.iter().filter(|mark| mark.id.as_deref().is_some_and(|id| id.starts_with("measured")));
            cells
                .filter_map(|mark| if let Shape::Text(text) = &mark.shape { Some(text.size) } else { None })
                .collect::<Vec<_>>()
        };
        let sizes: Vec<f64> = sheets.iter().flat_map(letters).collect();
        assert!(sizes.iter().all(|size| *size == sizes[0]), "{page}");
    }
}

/// A table never makes panels smaller: the sheet with the panels has the scales of the figure, also where the scene gives them.
#[test]
fn a_table_leaves_the_scales_as_they_are() {
    let mut apart = 0;
    // Figure 2 asks for scales of each sheet.
    let scenes = scenes().into_iter().filter(|(_, text)| !text.contains("\"scales\""));
    for (turn, (name, text)) in scenes.enumerate() {
        for page in PAGES.into_iter().skip(turn % PAGES_EACH.now()).step_by(PAGES_EACH.now()) {
            let keys = serde_json::json!({ "page": page });
            let alone = solved(&with_figure(&text, keys.clone())).expect("a good scene").scales();
            let (solution, sheets) = worksheet(&text, keys);
            let used = solution.scales();
            assert_eq!(used, alone, "{name} on {page}");
            assert!(sheets[0].svg().contains("id=\"ruler\""), "{name} on {page}");
            assert!(sheets.len() == 1 || !sheets[1].svg().contains("id=\"ruler\""), "{name} on {page}");
            apart += usize::from(sheets.len() > 1);
        }
    }
    assert!(apart > 10 / PAGES_EACH.now(), "{apart} tables have a sheet of their own");
}
