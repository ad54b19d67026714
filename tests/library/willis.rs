//! Willis' table on sheets: its numbers against fractions of whole numbers, and its place, in which nothing else stands and where it is legible.

use crate::gears::solution;
use kinegon::drawing::{Drawing, FigureSheets, Shape};
use kinegon::scene::{Page, StyleName, ValuesShown};
use kinegon::{Scene, Sheet, Solution};
use serde_json::json;
use std::collections::BTreeMap;
use support::faults::faults;
use support::files;
use support::random::Random;
use support::survey::ALIKE;

/// Size of the rows of tables at their usual size, in mm of one em on A4.
const CAPTION: f64 = 4.0;
/// How much smaller the contents of panels may be for the table.
const COST: f64 = 2.0;

/// The cells of the table by their ids.
fn cells(drawing: &Drawing) -> BTreeMap<String, (String, f64)> {
    let cells = drawing.marks.iter().filter_map(|mark| match (&mark.shape, mark.id.as_deref()) {
        (Shape::Text(text), Some(id)) if id.starts_with("willis-") => {
            Some((id.to_owned(), (text.text.content(), text.size)))
        }
        _ => None,
    });
    cells.collect()
}

fn number(text: &str) -> f64 {
    text.replace('\u{2212}', "-").parse().unwrap_or_else(|_| panic!("`{text}` is no plain number"))
}

/// A planetary train with an arm of any rate whose ring is fixed, and one whose sun is driven as fast as its arm: what rests, or stands still against
/// the arm, has the number 0 and no rounding error of it.
#[test]
fn rows_are_sums_of_fractions() {
    for seed in 0..60 {
        let mut dice = Random(seed);
        let [sun, planet] = [0; 2].map(|_| 17 + dice.below(44) as i64);
        let ring = sun + 2 * planet;
        // In thousandths.
        let arm = 1 + dice.below(9999) as i64;
        let is_locked = seed % 3 == 0;
        let mut scene = json!({ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [3, 4] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 20, "omega": arm as f64 / 1000.0 } },
                       "2": ["B"], "3": ["A", "E"] },
            "gears": [ { "mesh": ["3", "2"], "teeth": [sun, planet], "on": "1" },
                       { "mesh": ["2", if is_locked { "4" } else { "ground" }], "teeth": [planet, -ring], "on": "1" } ],
            "figure": { "panels": ["scheme", "speeds"], "willis": true } });
        scene["links"]["3"] = json!({ "points": ["A", "E"], "lengths": { "AE": 10 } });
        if is_locked {
            scene["links"]["3"]["drive"] = json!({ "angle": 0, "omega": arm as f64 / 1000.0 });
            scene["links"]["4"] = json!(["A"]);
        }
        let sheets = solution(&scene);
        let sheets = FigureSheets::new(&sheets).sheets();
        let cells: BTreeMap<String, (String, f64)> = sheets.iter().flat_map(cells).collect();
        // ω_i − ω_arm over ω_sun − ω_arm, and the latter over ω_arm.
        let of_wheel = [("3", [1, 1]), ("2", [-sun, planet]), (if is_locked { "4" } else { "0" }, [-sun, ring])];
        let relative = if is_locked { 0.0 } else { ring as f64 / sun as f64 };
        for (wheel, [over, under]) in of_wheel {
            let cell = |column: &str| {
                let id = format!("willis-1-{wheel}-{column}");
                cells.get(&id).unwrap_or_else(|| panic!("{seed}: no {id}: {:?}", cells.keys())).0.clone()
            };
            let held = over as f64 / under as f64 * relative * arm as f64 / 1000.0;
            for (column, truth) in
                [("all", arm as f64 / 1000.0), ("held", held), ("together", arm as f64 / 1000.0 + held)]
            {
                let is_zero = (is_locked && column == "held") || (wheel == "0" && column == "together");
                match is_zero {
                    true => assert_eq!(cell(column), "0", "{seed}: {wheel}, {column}"),
                    false => {
                        let own = number(&cell(column));
                        assert!(
                            (own - truth).abs() <= 6e-5 * truth.abs(),
                            "{seed}: {wheel}, {column}: {own} for {truth}"
                        );
                    }
                }
            }
        }
    }
}

/// Scenes with wheels that mesh.
fn trains() -> Vec<(String, Scene)> {
    let all =
        ["templates", "examples", "tests/gears", "tests/trains", "tests/lecture"].into_iter().flat_map(files::scenes);
    let read = all.filter_map(|(name, text)| Some((name, Scene::read(&text).ok()?)));
    let trains: Vec<(String, Scene)> =
        read.filter(|(_, scene)| scene.gears.iter().any(|gear| gear.rack.is_none())).collect();
    assert!(trains.len() >= 10, "only {} trains", trains.len());
    trains
}

/// The table stands on the figure or on the next sheet, whole and in letters of their usual size; nothing lies on anything, with values and without, on
/// paper and in the hall; and for its sake no panel is much smaller.
#[test]
fn the_table_has_a_place_of_its_own() {
    let mut wrong = Vec::new();
    let (mut beside, mut apart) = (0, 0);
    for (name, scene) in trains().into_iter().step_by(ALIKE.now()) {
        for (style, page) in [(StyleName::Paper, "a4"), (StyleName::Lecture, "16x9"), (StyleName::Lecture, "a4")] {
            for values in [None, Some(ValuesShown::Shown(None))] {
                for panels in [vec![Sheet::Scheme, Sheet::Speeds], Sheet::USUAL.to_vec()] {
                    let case = format!("{name}, {style:?} on {page}, values {values:?}, panels {panels:?}");
                    let solved = |willis: bool| -> Solution {
                        let mut scene = scene.clone();
                        (scene.figure.style, scene.figure.values) = (style, values);
                        scene.figure.page = Page::from_name(page).expect("it is a page");
                        scene.figure.panels.clone_from(&panels);
                        scene.figure.willis = willis;
                        kinegon::solve(&scene).expect("it moves")
                    };
                    let (with, without) = (solved(true), solved(false));
                    let (sheets, plain) = (FigureSheets::new(&with).sheets(), FigureSheets::new(&without).figure());
                    for (index, sheet) in sheets.iter().take(2).enumerate() {
                        let found = faults(sheet).into_iter().filter(|fault| !fault.contains("-unlabelled"));
                        wrong.extend(found.map(|fault| format!("{case}, sheet {}: {fault}", index + 1)));
                    }
                    let own: Vec<usize> =
                        (0..sheets.len()).filter(|&sheet| !cells(&sheets[sheet]).is_empty()).collect();
                    let [sheet] = own[..] else {
                        wrong.push(format!("{case}: the table is on sheets {own:?}"));
                        continue;
                    };
                    *(if sheet == 0 { &mut beside } else { &mut apart }) += 1;
                    // On a slide all is as large as the sheet is.
                    let unit = plain.height.max(plain.width)
                        / if page == "a4" { plain.height.max(plain.width) } else { 297.0 };
                    let least =
                        cells(&sheets[sheet]).values().map(|(_, size)| size / unit).fold(f64::INFINITY, f64::min);
                    if least < 0.8 * CAPTION {
                        wrong.push(format!("{case}: letters of {least} mm"));
                    }
                    for (panel, frame) in &plain.panels {
                        let mine = sheets[0].panels.iter().find(|(name, _)| name == panel).map(|(_, frame)| *frame);
                        let size = |frame: kinegon::drawing::Rect| frame.width().min(frame.height());
                        if sheet == 0 && mine.is_none_or(|mine| size(mine) < size(*frame) / (2.0 * COST)) {
                            wrong.push(format!("{case}: panel {panel} is {mine:?} for {frame:?}"));
                        }
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
    let every = ALIKE.now();
    assert!(beside * every > 20 && (every > 1 || apart > 0), "{beside} beside, {apart} apart");
}
