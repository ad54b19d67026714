//! Sheets with markers: nothing stands where the markers and the code are, these are where they are said to be, and the code says what is on
//! the sheet.

use kinegon::drawing::markers::{CODE_WHITE, CODES, SheetCode, WHITE, cells, code_place, places};
use kinegon::drawing::{Drawing, Pen, Point, Rect, Shape, Style};
use kinegon::exercise::Exercises;
use kinegon::scene::{Figure, Page, StyleName};
use kinegon::{PerSheet, Sheet};
use kinegon::{Scene, Solution};
use support::files;
use support::stages::solved;
use support::survey::{KINDS, PAGES_EACH};

const PAGES: [&str; 6] = ["a4", "a4-portrait", "a3", "a3-portrait", "letter", "letter-portrait"];

fn scenes() -> Vec<(String, String)> {
    let mut all = files::scenes("templates");
    all.extend(["figure-1", "figure-2"].map(|name| (name.to_owned(), files::read(&format!("examples/{name}.json")))));
    all
}

fn with_page(solution: &Solution, page: &str, change: impl Fn(&mut Figure)) -> Solution {
    let mut solution = solution.clone();
    solution.scene.figure.page = Page::from_name(page).expect("a page");
    change(&mut solution.scene.figure);
    solution
}

/// What a mark covers, with half of the width of its lines.
fn ink(drawing: &Drawing, mark: &kinegon::drawing::Mark) -> Rect {
    let look = drawing.look(mark);
    let width = if look.stroke.is_some() { 0.5 * look.width } else { 0.0 };
    mark.shape.drawn_box().inflate(width, width)
}

fn overlap(a: Rect, b: Rect) -> bool {
    a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1
}

/// What must hold for every sheet with markers.
fn assert_good(what: &str, drawing: &Drawing) {
    let code = drawing.code.as_ref().unwrap_or_else(|| panic!("{what}: no code"));
    let page = [drawing.width, drawing.height];
    assert_eq!(code.page.size_mm(), page, "{what}");
    let free = places(page).map(|place| place.inflate(WHITE, WHITE));
    let free = free.into_iter().chain([code_place(page).inflate(CODE_WHITE, CODE_WHITE)]);
    let free: Vec<Rect> = free.collect();
    for mark in drawing.marks.iter().filter(|mark| !matches!(mark.pen, Pen::Marker | Pen::MarkerWhite)) {
        let ink = ink(drawing, mark);
        let is_on_paper = ink.x0 >= 0.0 && ink.y0 >= 0.0 && ink.x1 <= page[0] && ink.y1 <= page[1];
        assert!(is_on_paper, "{what}: {mark:?}");
        for (number, free) in free.iter().enumerate() {
            assert!(!overlap(ink, *free), "{what}: in the white of {number}: {:?} {:?}", mark.pen, mark.shape);
        }
    }
    assert_eq!(SheetCode::read(&code.text()).as_ref().map(SheetCode::text), Some(code.text()), "{what}");
    assert!(!drawing.panels.is_empty() && code.panels.len() == drawing.panels.len(), "{what}");
}

#[test]
fn nothing_stands_where_markers_are() {
    let (mut marked, mut plain) = (0, Vec::new());
    for (turn, (name, text)) in scenes().into_iter().enumerate() {
        let solution = solved(&text).expect("a good scene");
        // Quick runs take pages by turns.
        for (index, page) in PAGES.into_iter().enumerate().skip(turn % PAGES_EACH.now()).step_by(PAGES_EACH.now()) {
            let style = StyleName::ALL[index % StyleName::ALL.len()];
            let what = format!("{name} {page} {}", style.as_str());
            let filled = with_page(&solution, page, |figure| (figure.worksheet, figure.style) = (true, style));
            match &filled.sheets()[0] {
                sheet if sheet.code.is_some() => {
                    marked += 1;
                    assert_good(&what, sheet);
                }
                _ => plain.push(what.clone()),
            }
            let blank = with_page(&solution, page, |figure| figure.style = style).drawing_sheets(&name);
            let codes: Vec<&Drawing> = blank.iter().filter(|sheet| sheet.code.is_some()).collect();
            // The scheme and one or two sheets for the plans; a table may come last, without markers.
            assert!(codes.len() >= 2 && blank.len() - codes.len() <= 1, "{what}");
            for (sheet, number) in codes.into_iter().zip(1..) {
                assert_good(&what, sheet);
                assert_eq!(sheet.code.as_ref().map(|code| code.number), Some(number), "{what}");
            }
        }
    }
    // The filled sheets have the scales of the scene's other sheets, and a third of them no room for markers as well.
    assert!(marked > plain.len(), "{marked} with markers; without: {plain:?}");
}

#[test]
fn exercises_have_sheets_for_their_plans() {
    // Polygons of forces have sheets of their own: force_boards.rs, polygons.rs.
    let of_plans = scenes().into_iter().filter(|(_, text)| !text.contains("\"forces\""));
    for (name, text) in of_plans.step_by(KINDS.now()) {
        let base = solved(&text).expect("a good scene");
        let exercise = Exercises::new(&base, None, 5);
        let exercise = exercise.expect("it can vary").next().expect("one is found");
        let sheets = exercise.sheets(&format!("{name}-5-1"));
        let scene = Scene::read(&exercise.text).expect("a scene").fingerprint();
        let mut shown = Vec::new();
        for (sheet, number) in sheets.iter().filter(|sheet| sheet.code.is_some()).zip(1..) {
            assert_good(&name, sheet);
            let code = sheet.code.as_ref().expect("it has one");
            assert_eq!((code.number, &code.scene), (number, &scene), "{name}");
            assert!(code.name.starts_with(&name.to_uppercase()[..name.len().min(20)]), "{name}: {}", code.name);
            for panel in &code.panels {
                shown.push(panel.panel);
                let figure = &exercise.solution.scene.figure;
                assert_eq!(Some(panel.mu), figure.mu[panel.panel], "{name}");
                assert_holds(&name, &exercise.solution, sheet, panel);
            }
        }
        assert_eq!(shown, Sheet::USUAL, "{name}");
    }
}

/// The right scheme or plan lies in its panel.
fn assert_holds(name: &str, solution: &Solution, sheet: &Drawing, panel: &kinegon::drawing::markers::PlacedPanel) {
    let index =
        sheet.code.iter().flat_map(|code| &code.panels).position(|p| p.panel == panel.panel).expect("it is one");
    let (_, frame) = sheet.panels[index];
    if panel.panel == Sheet::Scheme {
        // The joints are where the code says.
        let joints: Vec<Point> =
            sheet.marks.iter().filter(|m| m.pen == Pen::Joint).map(|m| m.shape.bounds().center()).collect();
        for (place, point) in solution.pose.points.iter().zip(&solution.mechanism.points) {
            let [x, y] = panel.at([place.x, place.y]);
            let nearest = joints.iter().map(|joint| (*joint - Point::new(x, y)).hypot()).fold(f64::INFINITY, f64::min);
            let is_joint = solution.scene.links.values().filter(|link| link.points.contains(point)).count() > 1;
            assert!(nearest < 0.01 || !is_joint, "{name}: {point} is {nearest} mm off");
        }
        return;
    }
    assert!(panel.origin.iter().all(|mm| (mm - mm.round()).abs() < 1e-9), "{name}: {:?}", panel.origin);
    let dot = sheet.marks.iter().filter(|mark| mark.pen == Pen::Pole).map(|mark| mark.shape.bounds().center());
    let off =
        dot.map(|dot| (dot - Point::from((panel.origin[0], panel.origin[1]))).hypot()).fold(f64::INFINITY, f64::min);
    assert!(off < 1e-9, "{name}: the pole is {off} mm off");
    for (point, at) in &solution.construction.plan_on(panel.panel).expect("a plan").points {
        let [x, y] = panel.at([at.vector.x, at.vector.y]);
        assert!(frame.inset(-2.0).contains(Point::new(x, y)), "{name}: {point} at {x}, {y} in {frame:?}");
    }
}

/// A work sheet of figure 2, at scales that leave room for markers.
fn sheet(page: &str, style: StyleName) -> Drawing {
    let solution = solved(&files::read("examples/figure-2.json")).expect("a good scene");
    let solution = with_page(&solution, page, |figure| {
        (figure.worksheet, figure.style) = (true, style);
        figure.mu = PerSheet::from_fn(|sheet| Some(if sheet == Sheet::Scheme { 10.0 } else { 2.0 }));
    });
    solution.sheets().swap_remove(0)
}

/// The numbers of an SVG path, by pairs.
fn points_of(svg: &str, id: &str) -> Vec<[f64; 2]> {
    let (_, rest) = svg.split_once(&format!("id=\"{id}\"")).unwrap_or_else(|| panic!("no {id}"));
    let (_, rest) = rest.split_once("d=\"").expect("a path");
    let (data, _) = rest.split_once('"').expect("its end");
    let numbers = data.split(|c: char| c.is_ascii_alphabetic() || c == ' ' || c == ',').filter(|part| !part.is_empty());
    let numbers: Vec<f64> = numbers.map(|number| number.parse().expect("a number")).collect();
    numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect()
}

#[test]
fn svg_has_markers_at_their_places() {
    for page in PAGES {
        let drawing = sheet(page, StyleName::Paper);
        let svg = drawing.svg();
        for (place, number) in places([drawing.width, drawing.height]).into_iter().zip(1..) {
            let points = points_of(&svg, &format!("marker-{number}"));
            for (axis, ends) in [[place.x0, place.x1], [place.y0, place.y1]].into_iter().enumerate() {
                let [low, high] = ends;
                let least = points.iter().map(|point| point[axis]).fold(f64::INFINITY, f64::min);
                let most = points.iter().map(|point| point[axis]).fold(f64::NEG_INFINITY, f64::max);
                assert!((least - low).abs() < 0.01 && (most - high).abs() < 0.01, "{page} {number}: {least} {most}");
            }
        }
    }
    // Black without an outline in every style.
    let sheets = StyleName::ALL.map(|style| sheet("a3", style));
    let marked: Vec<&Drawing> = sheets.iter().filter(|sheet| sheet.code.is_some()).collect();
    // Letters for the hall leave no room on a small sheet.
    assert!(marked.len() >= 3, "{}", marked.len());
    for sheet in marked {
        let svg = sheet.svg();
        let (before, _) = svg.split_once("id=\"marker-1\"").expect("a marker");
        let group = &before[before.rfind("<g").expect("a group")..];
        assert!(group.contains("#000000") && !group.contains("stroke-width"), "{group}");
    }
}

#[test]
fn rasters_have_cells_and_a_legible_code() {
    for (page, style) in [("a4", StyleName::Paper), ("letter-portrait", StyleName::Board), ("a3", StyleName::Print)] {
        let drawing = sheet(page, style);
        let dpi = 200.0;
        let picture = resvg::tiny_skia::Pixmap::decode_png(&drawing.png(dpi).expect("it is drawn")).expect("a PNG");
        let pixels_per_mm = f64::from(picture.width()) / drawing.width;
        let dark = |x: f64, y: f64| {
            let pixel = picture.pixel((x * pixels_per_mm) as u32, (y * pixels_per_mm) as u32).expect("on the sheet");
            u16::from(pixel.red()) + u16::from(pixel.green()) + u16::from(pixel.blue()) < 384
        };
        for (place, code) in places([drawing.width, drawing.height]).into_iter().zip(CODES) {
            for (row, line) in cells(code).iter().enumerate() {
                for (column, black) in line.iter().enumerate() {
                    let [x, y] = [column, row].map(|cell| (cell as f64 + 0.5) * 8.0 / 6.0);
                    assert_eq!(dark(place.x0 + x, place.y0 + y), *black, "{page} {code:#06x} {row} {column}");
                }
            }
            // White round it, also on dark paper.
            let around = [(-1.0, 4.0), (9.0, 4.0), (4.0, -1.0), (4.0, 9.0), (-1.0, -1.0), (9.0, 9.0)];
            assert!(around.iter().all(|(x, y)| !dark(place.x0 + x, place.y0 + y)), "{page} {code:#06x}");
        }
        let [width, height] = [picture.width(), picture.height()].map(|side| side as usize);
        let grey = |x: usize, y: usize| picture.pixel(x as u32, y as u32).map_or(255, |pixel| pixel.green());
        let mut picture = rqrr::PreparedImage::prepare_from_greyscale(width, height, grey);
        let read: Vec<String> =
            picture.detect_grids().iter().filter_map(|grid| grid.decode().ok()).map(|(_, text)| text).collect();
        let code = drawing.code.as_ref().expect("it has one");
        assert_eq!(read, [code.text()], "{page}");
        assert_eq!(Style::named(style).is_dark(), style == StyleName::Board);
    }
}

#[test]
fn pdf_has_markers_at_their_places() {
    let drawing = sheet("a4-portrait", StyleName::Paper);
    let pdf = lopdf::Document::load_mem(&drawing.pdf().expect("it is written")).expect("a PDF");
    let page = pdf.page_iter().next().expect("a page");
    let content = pdf.get_and_decode_page_content(page).expect("its content");
    let number = |object: &lopdf::Object| f64::from(object.as_float().expect("a number"));
    // Points of paths, in mm from the upper left corner.
    let mut matrices = vec![[1.0, 0.0, 0.0, 1.0, 0.0, 0.0]];
    let mut points: Vec<[f64; 2]> = Vec::new();
    for operation in &content.operations {
        let of: Vec<f64> = match operation.operator.as_str() {
            "cm" | "m" | "l" => operation.operands.iter().map(number).collect(),
            _ => Vec::new(),
        };
        let now = *matrices.last().expect("there is one");
        match operation.operator.as_str() {
            "q" => matrices.push(now),
            "Q" => drop(matrices.pop()),
            "cm" => {
                let [a, b, c, d, e, f] = now;
                let [p, q, r, s, t, u] = of[..] else { panic!("six numbers") };
                let next =
                    [p * a + q * c, p * b + q * d, r * a + s * c, r * b + s * d, t * a + u * c + e, t * b + u * d + f];
                *matrices.last_mut().expect("there is one") = next;
            }
            "m" | "l" => {
                let [a, b, c, d, e, f] = now;
                let [x, y] = [of[0] * a + of[1] * c + e, of[0] * b + of[1] * d + f].map(|points| points * 25.4 / 72.0);
                points.push([x, drawing.height - y]);
            }
            _ => {}
        }
    }
    for place in places([drawing.width, drawing.height]) {
        for corner in [[place.x0, place.y0], [place.x1, place.y0], [place.x1, place.y1], [place.x0, place.y1]] {
            let off = |point: &[f64; 2]| libm::hypot(point[0] - corner[0], point[1] - corner[1]);
            let nearest = points.iter().map(off).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.01, "{corner:?}: {nearest} mm");
        }
    }
}

/// Without markers a sheet is as it was before there were any: as a figure's that is no work sheet but for the table.
#[test]
fn markers_can_be_left_out() {
    let solution = solved(&files::read("templates/four-bar.json")).expect("a good scene");
    let plain = with_page(&solution, "a4", |figure| (figure.worksheet, figure.markers) = (true, false)).sheets();
    assert!(plain.iter().all(|sheet| sheet.code.is_none() && sheet.marks.iter().all(|mark| mark.pen != Pen::Marker)));
    let frame = |sheet: &Drawing| sheet.marks.iter().find(|m| m.pen == Pen::Frame).map(|m| m.shape.bounds());
    // Panels begin 8 mm from the left edge, 17 mm from the upper edge.
    assert_eq!(frame(&plain[0]).map(|frame| [frame.x0, frame.y0]), Some([8.0, 17.0]));
    let wide = with_page(&solution, "16x9", |figure| figure.worksheet = true).sheets();
    assert!(wide[0].code.is_none());
    let mut plain = solution.clone();
    plain.scene.figure.markers = false;
    let [with, without] = [&solution, &plain].map(|solution| {
        let exercises = Exercises::new(solution, None, 3);
        exercises.expect("it can vary").next().expect("one is found")
    });
    assert_eq!(with.text, without.text);
    assert_eq!(without.sheets("x"), std::slice::from_ref(&without.sheet));
    assert_eq!(with.sheet, without.sheet);
    assert!(with.sheets("x").len() >= 2);
    let is_marker = |shape: &Shape| matches!(shape, Shape::Area(_));
    assert!(with.sheets("x").iter().all(|sheet| sheet.marks.iter().filter(|m| is_marker(&m.shape)).count() == 9));
}
