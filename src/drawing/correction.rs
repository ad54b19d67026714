//! The sheets of a student's drawing: the overlay on the right figure, and where the words about it and the table of values find room.

use super::compose::{Composition, draw_title};
use super::figure::{composition, content, extents, hints, panels};
use super::layout::{Layout, MARGIN, TITLE};
use super::lines;
use super::overlay::{Notes, Overlay, OwnLayer, WordsPlace};
use super::scheme::Scheme;
use super::shape::{Shape, corners};
use super::sheet::{Drawing, Pen};
use super::table::Table;
use super::text::RichText;
use super::view::Extent;
use crate::construction::Solution;
use crate::scene::PanelName;
use kurbo::Rect;

/// The parts of a page that words beside the panels may take.
const BESIDE: [f64; 5] = [0.23, 0.235, 0.24, 0.25, 0.28];
/// Between words and the table below them.
const GAP: f64 = 4.0;

/// A way to divide the sheet.
struct Way<'a> {
    place: WordsPlace,
    sheet: Composition<'a>,
    layout: Layout,
}

/// A student's drawing over the right figure, with the words about it; last a table of the values.
///
/// Words stand below or beside the panels, where these come out larger, unless something would not fit any more that fits on a sheet
/// without words: then they stand above the table. The table is on the figure's sheet where that takes nothing from the panels, else on
/// sheets of its own. What lies outside a panel is cut off there and named at its edge.
#[must_use]
pub fn overlay(solution: &Solution, overlay: &Overlay) -> Vec<Drawing> {
    let scheme = Scheme::new(solution);
    let Way { place, mut sheet, layout } = best_way(&scheme, overlay);
    let table = overlay.table();
    if place == WordsPlace::Below {
        sheet.items.push(Box::new(table.clone()));
        let both = sheet.layout();
        let fits = both.aside.is_some_and(|area| table.fits(area));
        if fits && both.worth >= layout.worth {
            return vec![sheet.draw(&both)];
        }
        sheet.items.pop();
    }
    let figure = sheet.draw(&layout);
    let said = (place == WordsPlace::Apart).then_some(overlay);
    let tables = tables(&figure, said, table);
    std::iter::once(figure).chain(tables).collect()
}

/// The right figure under the student's drawing, and the words in their place.
fn sheet<'a>(
    scheme: &'a Scheme<'a>,
    overlay: &'a Overlay,
    extents: &[(PanelName, Extent)],
    notes: Notes<'a>,
) -> Composition<'a> {
    let own = |panel| Box::new(OwnLayer { overlay, scheme, panel });
    let panels = panels(scheme, extents, |panel| vec![hints(scheme, panel), content(scheme, panel), own(panel)]);
    let mut sheet = composition(scheme, panels, None, vec![Box::new(notes)]);
    if let Some(name) = &overlay.name {
        sheet.title = format!("{} – {name}", sheet.title);
    }
    sheet.steps = Vec::new();
    sheet
}

/// The way in which most panels show all that they should, of these the one in which the student's points lie on the sheet, the words beside the figure,
/// its contents large.
fn best_way<'a>(scheme: &'a Scheme<'a>, overlay: &'a Overlay) -> Way<'a> {
    let page = scheme.figure.page.size_mm();
    let notes = |place| Notes { overlay, words: scheme.words, page, place };
    let way = |extents: &[(PanelName, Extent)], place: WordsPlace| {
        let sheet = sheet(scheme, overlay, extents, notes(place));
        Way { place, layout: sheet.layout(), sheet }
    };
    let ways_for = |extents: &[(PanelName, Extent)]| {
        let mut words = way(extents, WordsPlace::Below);
        for part in BESIDE {
            let beside = way(extents, WordsPlace::Beside(part * page[0]));
            let fits = beside.layout.aside.is_some_and(|column| notes(beside.place).fit(column));
            if fits && beside.layout.worth > words.layout.worth {
                words = beside;
            }
        }
        [words, way(extents, WordsPlace::Apart)]
    };
    // Whether all panels have room, and how many show all of their contents.
    let shows = |way: &Way| [way.layout.worth[0], way.layout.worth[1]];
    let own = extents(scheme);
    let mut best: Option<Way> = None;
    // All panels with the student's points first, then without those of one, of two, of all.
    let mut kept: Vec<u32> = (0..1 << own.len()).collect();
    kept.sort_by_key(|panels| std::cmp::Reverse(panels.count_ones()));
    for panels in kept {
        let extents = own.iter().enumerate().map(|(index, &(panel, extent))| {
            let is_given = scheme.figure.mu(panel).is_some();
            let is_kept = panels & (1 << index) != 0;
            (panel, if is_kept { overlay.extended(panel, extent, is_given) } else { extent })
        });
        for way in ways_for(&extents.collect::<Vec<_>>()) {
            if best.as_ref().is_none_or(|best| shows(&way) > shows(best)) {
                best = Some(way);
            }
        }
    }
    best.expect("there is a way to keep no panel's points")
}

/// Sheets with the title, the words that the figure has no room for, and the table, as many as its rows need; upright, as lists are, where its rows
/// are not too wide.
fn tables<const N: usize>(figure: &Drawing, said: Option<&Overlay>, mut table: Table<N>) -> Vec<Drawing> {
    let narrow = figure.width.min(figure.height);
    let [width, height] = match table.column() <= narrow - 2.0 * MARGIN {
        true => [narrow, figure.width.max(figure.height)],
        false => [figure.width, figure.height],
    };
    let area = Rect::new(MARGIN, MARGIN + TITLE, width - MARGIN, height - MARGIN);
    let said = said.map(|said| said.lines(lines::width([width, height]), false));
    let mut said: Vec<RichText> = said.unwrap_or_default();
    let mut sheets = Vec::new();
    while !table.rows.is_empty() {
        let mut drawing = Drawing { width, height, marks: Vec::new(), panels: Vec::new(), ..figure.clone() };
        draw_title(&mut drawing);
        let mut own = area;
        if !said.is_empty() {
            let room = Rect { y1: own.y0 + lines::height(said.len()), ..own };
            drawing.draw(Pen::Frame, Shape::Polygon(corners(room)));
            lines::draw(&mut drawing, room, 0, &std::mem::take(&mut said));
            own.y0 = room.y1 + GAP;
        }
        let later = table.rows.split_off(table.most(own).clamp(1, table.rows.len()));
        table.draw_in(&mut drawing, table.needed(own));
        table.rows = later;
        sheets.push(drawing);
    }
    sheets
}
