//! The sheets of a corrected drawing: the student's drawing over the right figure, sentences about it, and the table of
//! values.

use super::compose::{Composition, blank, further_sheets};
use super::context::{Purpose, SheetContext};
use super::dims::Dims;
use super::layout::Layout;
use super::legend::Legend;
use super::lines;
use super::overlay::{Notes, Overlay, OwnLayer, WordsPlace};
use super::panel::{Extents, content, extents, hints, panels};
use super::sheet::Drawing;
use crate::construction::Solution;
use crate::scene::Figure;
use crate::text::Untrusted;

/// Widths of a column of words beside the panels, in parts of the page's width.
const BESIDE: [f64; 5] = [0.23, 0.235, 0.24, 0.25, 0.28];

/// A sheet with the words about a drawing in some place.
struct Division<'a> {
    place: WordsPlace,
    sheet: Composition<'a>,
    layout: Layout,
}

/// A student's drawing over the right figure, with sentences about it; last a table of the values.
///
/// The sentences are below or beside the panels, where the panels are larger, unless something would no longer fit that
/// fits on a sheet without sentences: then they are above the table. The table is on the figure's sheet if the panels
/// are not smaller for it, else on further sheets; without values there is none. Content outside a panel is cut off and named at its edge.
#[must_use]
pub fn overlay(solution: &Solution, overlay: &Overlay) -> Vec<Drawing> {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let Division { place, mut sheet, layout } = best_division(&context, overlay);
    if overlay.values.is_empty() {
        return vec![sheet.draw(&layout)];
    }
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
    let unplaced = |page| match place {
        WordsPlace::Apart => overlay.lines(lines::width(page), false),
        _ => Vec::new(),
    };
    let tables = further_sheets(&figure, context.surface.dims.unit, unplaced, table);
    std::iter::once(figure).chain(tables).collect()
}

/// The words about a student's drawing and the table of its values without a figure, on sheets in the size and the
/// style of `figure`.
#[must_use]
pub fn overlay_words(figure: &Figure, title: &Untrusted, overlay: &Overlay) -> Vec<Drawing> {
    let dims = Dims::of(figure);
    let blank = blank(figure, dims.page, overlay.titled(title)).enlarged(dims.unit);
    further_sheets(&blank, dims.unit, |page| overlay.lines(lines::width(page), false), overlay.table())
}

/// The right figure under the student's drawing, with the sentences in their place.
fn sheet<'a>(
    context: &'a SheetContext<'a>,
    overlay: &'a Overlay,
    extents: &Extents,
    notes: Notes<'a>,
) -> Composition<'a> {
    let mut panels = panels(context, extents, |sheet| vec![hints(context, sheet), content(context, sheet)]);
    for panel in &mut panels {
        panel.own = Some(OwnLayer { overlay, context, panel: panel.needs.sheet });
    }
    let sheet = Composition::new(context, panels).with(Legend::of(context)).with(notes);
    Composition { title: overlay.titled(&sheet.title), ..sheet }
}

/// The division with which most panels show their whole contents; of equals the one that shows more of the student's
/// points, then the one with the sentences beside the figure, then the one with larger contents.
fn best_division<'a>(context: &'a SheetContext<'a>, overlay: &'a Overlay) -> Division<'a> {
    let page = context.surface.dims.page;
    let notes = |place| Notes { context, overlay, place };
    let division = |extents: &Extents, place: WordsPlace| {
        let sheet = sheet(context, overlay, extents, notes(place));
        Division { place, layout: sheet.layout(), sheet }
    };
    let divisions_for = |extents: &Extents| {
        let mut words = division(extents, WordsPlace::Below);
        for part in BESIDE {
            let beside = division(extents, WordsPlace::Beside(part * page[0]));
            let fits = beside.layout.aside.is_some_and(|column| notes(beside.place).fits(column));
            if fits && beside.layout.worth > words.layout.worth {
                words = beside;
            }
        }
        [words, division(extents, WordsPlace::Apart)]
    };
    // First whether all panels are large enough, then how many show their whole contents.
    let shows = |division: &Division| [division.layout.worth[0], division.layout.worth[1]];
    let right_extents = extents(context);
    let mut best: Option<Division> = None;
    // Panels extended for the student's points: all, then all but one, all but two …, none.
    let mut kept: Vec<u32> = (0..1 << right_extents.len()).collect();
    kept.sort_by_key(|panels| std::cmp::Reverse(panels.count_ones()));
    let mut tried: Vec<Extents> = Vec::new();
    for panels in kept {
        let extents = right_extents.iter().enumerate().map(|(index, &(panel, extent))| {
            let is_given = context.figure().mu[panel].is_some();
            let is_kept = panels & (1 << index) != 0;
            (panel, if is_kept { overlay.extended(panel, extent, is_given) } else { extent })
        });
        let extents: Extents = extents.collect();
        // Where the student's points are within the right content it makes no difference which panels are extended.
        if tried.contains(&extents) {
            continue;
        }
        for division in divisions_for(&extents) {
            if best.as_ref().is_none_or(|best| shows(&division) > shows(best)) {
                best = Some(division);
            }
        }
        tried.push(extents);
    }
    best.expect("there is a way to keep no panel's points")
}
