//! The sheets of a student's drawing: the overlay on the right figure, and where the words about it and the table of values find room.

use super::figure::{Sheet, Shown, compose, draw_title, extents};
use super::layout::{Aside, Layout, MARGIN, TITLE};
use super::legend;
use super::overlay::Overlay;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::table::{Cells, Table};
use super::view::Extent;
use crate::plan::Solution;
use crate::scene::{Panel, Scene};
use kurbo::Rect;

/// The parts of a page that words beside the panels may take.
const BESIDE: [f64; 5] = [0.23, 0.235, 0.24, 0.25, 0.28];
/// White above the words of a column.
const TOP: f64 = 2.0;
/// Between words and the table below them.
const GAP: f64 = 4.0;

/// Where the words stand.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// Below the panels.
    Below,
    /// In a column to the right of the panels.
    Beside,
    /// On the sheet of the table, where the figure needs all of its own.
    Apart,
}

/// A way to divide the sheet.
struct Way {
    place: Place,
    extents: Vec<(Panel, Extent)>,
    layout: Layout,
}

/// A student's drawing over the right figure, with the words about it; last a table of the values.
///
/// Words stand below or beside the panels, where these come out larger, unless something would not fit any more that fits on a sheet
/// without words: then they stand above the table. The table is on the figure's sheet where that takes nothing from the panels, else on
/// sheets of its own. What lies outside a panel is cut off there and named at its edge.
#[must_use]
pub fn overlay(solution: &Solution, overlay: &Overlay) -> Vec<Drawing> {
    let (scene, scheme) = (&solution.scene, Scheme::new(solution));
    let words = &scheme.words;
    let page = scene.figure.page.size_mm();
    let way = best_way(scene, &scheme, overlay);
    let (table, rows) = overlay.table();
    let mut sheet = Sheet { layout: way.layout, worksheet: None };
    let mut shared = None;
    if way.place == Place::Below {
        let lines = lines_below(overlay, page);
        let both = Sheet::divided(scene, &scheme, &way.extents, lines, &|room| table.asides(room));
        shared = both.table.filter(|area| table.fits(*area));
        shared = shared.filter(|_| both.worth >= sheet.layout.worth);
        if shared.is_some() {
            sheet.layout = both;
        }
    }
    let shown = Shown::Overlay(overlay);
    let mut drawing = compose(scene, &scheme, &sheet, &way.extents, shown);
    drawing.steps = Vec::new();
    let mut below = sheet.layout.legend;
    below.y0 += sheet.layout.scales;
    match (way.place, sheet.layout.table) {
        (Place::Beside, Some(area)) => {
            drawing.draw(Pen::Frame, Shape::Polygon(legend::corners(area)));
            let area = Rect { y0: area.y0 + TOP, ..area };
            let from = overlay.draw_key(&mut drawing, area, words);
            let lines = overlay.lines(area.width() - 2.0 * legend::PAD, true);
            legend::draw_lines_in(&mut drawing, area, from, lines);
        }
        (Place::Apart, _) => drop(overlay.draw_key(&mut drawing, below, words)),
        _ => {
            let from = overlay.draw_key(&mut drawing, below, words);
            let lines = overlay.lines(legend::words_width(page), false);
            legend::draw_lines_in(&mut drawing, below, from, lines);
        }
    }
    let mut sheets = Vec::new();
    match shared {
        Some(area) => drop(table.draw(&mut drawing, area, &rows)),
        None => {
            let said = (way.place == Place::Apart).then_some(overlay);
            sheets = tables(&drawing, said, &table, &rows);
        }
    }
    sheets.insert(0, drawing);
    sheets
}

/// Room for the key and the words below the panels, in mm.
fn lines_below(overlay: &Overlay, page: [f64; 2]) -> f64 {
    let words = overlay.lines(legend::words_width(page), false);
    legend::height_of_lines(overlay.key_lines(false) + words.len())
}

/// The way in which most panels show all that they should, of these the one in which the student's points lie on the sheet, the words beside the figure,
/// its contents large.
fn best_way(scene: &Scene, scheme: &Scheme<'_>, overlay: &Overlay) -> Way {
    let page = scene.figure.page.size_mm();
    let own = extents(scheme);
    let height_beside = |column: f64| {
        let narrow = overlay.lines(column - 2.0 * legend::PAD, true).len();
        TOP + legend::height_of_lines(overlay.key_lines(true) + narrow)
    };
    let ways_for = |extents: Vec<(Panel, Extent)>| {
        let way = |place: Place, column: f64| {
            let (below, aside) = match place {
                Place::Below => (lines_below(overlay, page), Aside::Nothing),
                Place::Beside => (0.0, Aside::Right(column)),
                Place::Apart => {
                    let key = legend::height_of_lines(overlay.key_lines(false));
                    (key, Aside::Nothing)
                }
            };
            let layout = Sheet::divided(scene, scheme, &extents, below, &|_| vec![aside]);
            Way { place, extents: extents.clone(), layout }
        };
        let mut words = way(Place::Below, 0.0);
        let beside = BESIDE.iter().filter_map(|part| {
            let column = part * page[0];
            let beside = way(Place::Beside, column);
            let area = beside.layout.table?;
            (area.height() >= height_beside(column)).then_some(beside)
        });
        for beside in beside {
            if beside.layout.worth > words.layout.worth {
                words = beside;
            }
        }
        [words, way(Place::Apart, 0.0)]
    };
    // Whether all panels have room, and how many show all of their contents.
    let shows = |way: &Way| [way.layout.worth[0], way.layout.worth[1]];
    let mut best: Option<Way> = None;
    // All panels with the student's points first, then without those of one, of two, of all.
    let mut kept: Vec<u32> = (0..1 << own.len()).collect();
    kept.sort_by_key(|panels| std::cmp::Reverse(panels.count_ones()));
    for panels in kept {
        let extents = own.iter().enumerate().map(|(index, &(panel, extent))| {
            let is_given = scene.figure.mu(panel).is_some();
            let with_points = || overlay.extended(panel, extent, is_given);
            let is_kept = panels & (1 << index) != 0;
            (panel, if is_kept { with_points() } else { extent })
        });
        for way in ways_for(extents.collect()) {
            if best.as_ref().is_none_or(|best| shows(&way) > shows(best)) {
                best = Some(way);
            }
        }
    }
    best.expect("there is a way to keep no panel's points")
}

/// Sheets with the title, the words that the figure has no room for, and the table, as many as its rows need; upright, as lists are, where its rows
/// are not too wide.
fn tables<const N: usize>(
    figure: &Drawing,
    said: Option<&Overlay>,
    table: &Table<N>,
    rows: &[Cells<N>],
) -> Vec<Drawing> {
    let narrow = figure.width.min(figure.height);
    let [width, height] = match table.column() <= narrow - 2.0 * MARGIN {
        true => [narrow, figure.width.max(figure.height)],
        false => [figure.width, figure.height],
    };
    let whole = Rect::new(MARGIN, MARGIN, width - MARGIN, height - MARGIN);
    let mut area = whole;
    area.y0 += TITLE;
    let lines = said.map(|said| said.lines(legend::words_width([width, height]), false));
    let mut lines = lines.unwrap_or_default();
    let mut rows = rows;
    let mut sheets = Vec::new();
    while !rows.is_empty() {
        let mut drawing = Drawing { width, height, marks: Vec::new(), panels: Vec::new(), ..figure.clone() };
        draw_title(&mut drawing, whole);
        let mut own = area;
        if !lines.is_empty() {
            let room = Rect { y1: own.y0 + legend::height_of_lines(lines.len()), ..own };
            drawing.draw(Pen::Frame, Shape::Polygon(legend::corners(room)));
            legend::draw_lines_in(&mut drawing, room, 0, std::mem::take(&mut lines));
            own.y0 = room.y1 + GAP;
        }
        let (first, later) = rows.split_at(table.most(own).clamp(1, rows.len()));
        let table = Table { rows: first.len(), ..table.clone() };
        table.draw(&mut drawing, table.needed(own), first);
        rows = later;
        sheets.push(drawing);
    }
    sheets
}
