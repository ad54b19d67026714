//! The sheets of a corrected drawing: the student's drawing over the right figure, sentences about it, and the table of
//! values; or the right plans over a photographed sheet, straightened out.

use super::centers;
use super::compose::{Composition, blank, further_sheets};
use super::context::{Purpose, SheetContext};
use super::dims::Dims;
use super::layout::{Layout, Placed};
use super::lines;
use super::markers::SheetCode;
use super::overlay::{Notes, Overlay, OwnLayer, WordsPlace, cross};
use super::panel::{Extents, Panel, content, extents, hints, panels};
use super::plan;
use super::shape::Shape;
use super::sheet::{Drawing, Emphasis, Pen};
use super::text::{CAPTION, PlacedText, RichText};
use super::view::{Extent, Series};
use crate::construction::Solution;
use crate::scene::{Figure, StyleName};
use crate::sheet::{Scales, Sheet};
use crate::text::Untrusted;
use kurbo::{Affine, Point, Rect, Vec2};

/// Widths of a column of words beside the panels, in parts of the page's width.
const BESIDE: [f64; 5] = [0.23, 0.235, 0.24, 0.25, 0.28];

/// A sheet with the words about a drawing in some place.
struct Division<'a> {
    place: WordsPlace,
    sheet: Composition<'a>,
    layout: Layout,
    /// How many of the student's points and ends of lines are outside of their panels.
    outside: usize,
}

/// A student's drawing over the right figure, with sentences about it; last a table of the values.
///
/// The sentences are below or beside the panels, where the panels are larger, unless something would no longer fit that
/// fits on a sheet without sentences: then they are above the table. The table is on the figure's sheet if the panels
/// are not smaller for it, else on further sheets; without values there is none. Content outside a panel is cut off and named at its edge.
#[must_use]
pub fn overlay(solution: &Solution, overlay: &Overlay) -> Vec<Drawing> {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let at_scale = best_division(&context, overlay);
    // Where a page is too small for the student's points at the scale that the scene gives, a finer one is better: a vector turned round is seen by where it ends.
    let free = context.on_page(context.surface.page, Scales::default());
    let smaller = (at_scale.outside > 0).then(|| best_division(&free, overlay));
    let smaller = smaller.filter(|other| other.layout.shows_all() && other.outside < at_scale.outside);
    let Division { place, mut sheet, layout, .. } = smaller.unwrap_or(at_scale);
    if overlay.values.is_empty() {
        return vec![sheet.draw(&layout)];
    }
    let table = overlay.table();
    if place == WordsPlace::Below {
        sheet.items.push(Box::new(table.clone()));
        let both = sheet.layout();
        let fits = both.aside().is_some_and(|area| table.fits(area));
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
    let sheet = Composition::new(context, panels).with(notes);
    Composition { title: overlay.titled(&sheet.title), ..sheet }
}

/// The division with which most panels show their whole contents; of equals the one that shows more of the student's
/// points, then the one with the sentences beside the figure, then the one with larger contents.
fn best_division<'a>(context: &'a SheetContext<'a>, overlay: &'a Overlay) -> Division<'a> {
    let page = context.surface.dims.page;
    let notes = |place| Notes { context, overlay, place };
    let division = |extents: &Extents, place: WordsPlace| {
        let sheet = sheet(context, overlay, extents, notes(place));
        let outside = extents.iter().map(|(panel, extent)| overlay.outside(*panel, *extent)).sum();
        Division { place, layout: sheet.layout(), sheet, outside }
    };
    let divisions_for = |extents: &Extents| {
        let mut words = division(extents, WordsPlace::Below);
        for part in BESIDE {
            let beside = division(extents, WordsPlace::Beside(part * page[0]));
            let fits = beside.layout.aside().is_some_and(|column| notes(beside.place).fits(column));
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
            let is_given = context.surface.mu[panel].is_some();
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

/// White round a plan, in which names have room, in mm.
const AROUND: f64 = 12.0;
/// Half the width of the cross of a point that was found, in mm.
const CROSS: f64 = 1.2;

/// A point of a plan or of a figure of instant centres that is seen on a photographed sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct SeenPoint {
    /// On which sheet of the construction.
    pub panel: Sheet,
    /// Its name, as in `b` or `P(1,3)`.
    pub name: String,
    /// Its place on the sheet, in mm, y down.
    pub at: [f64; 2],
    /// Radius that holds it with 95 %, in mm.
    pub band: f64,
    /// Whether it is elsewhere than it should be: then it has its name.
    pub is_off: bool,
}

/// The right plans and lines of centres of a sheet at their places on it, in the accent colour of the style `paper`, and the points that were found, with circles that hold them.
///
/// In millimetres of the sheet, without ground: it is laid over the picture of the sheet.
#[must_use]
pub fn over_photo(solution: &Solution, code: &SheetCode, seen: &[SeenPoint]) -> Drawing {
    let mut solution = solution.clone();
    let figure = &mut solution.scene.figure;
    figure.style = StyleName::Paper;
    figure.page = code.page;
    figure.focus = None;
    figure.panels = code.panels.iter().map(|panel| panel.panel).collect();
    let mut context = SheetContext::new(&solution, Purpose::Drawing);
    for panel in &code.panels {
        context.surface.mu[panel.panel] = Some(panel.mu);
    }
    let unit = context.surface.dims.unit;
    let title = solution.scene.title.clone().unwrap_or_default();
    let mut drawing = blank(context.figure(), context.surface.dims.page, title);
    for placed in &code.panels {
        let Some(extent) = extent_over_photo(&context, placed.panel) else { continue };
        let layer =
            |panel| if panel == Sheet::Centers { centers::lines_alone(&context) } else { content(&context, panel) };
        let all = panels(&context, &[(placed.panel, extent)], |panel| vec![layer(panel)]);
        for panel in all {
            // The photographed sheet has the frame.
            let panel = Panel { frame: None, content: None, ..panel };
            let area = Affine::scale(1.0 / unit).transform_rect_bbox(area(&extent, placed.origin, placed.mu));
            let place = Placed::with_area(&panel.needs, [area.inflate(AROUND, AROUND), area], unit, Series::Hand);
            panel.draw(&mut drawing, &place, &solution.scene.figure.labels, &context.surface.dims, None);
        }
    }
    drawing.marks.retain(|mark| mark.until.is_none());
    drawing.panels.clear();
    let mut drawing = drawing.enlarged(unit);
    for mark in &mut drawing.marks {
        mark.emphasis = Emphasis::New;
    }
    for point in seen {
        draw_seen(&mut drawing, &context, point);
    }
    drawing
}

/// The extent of what is drawn over a photographed panel; none of a scheme, on which nothing is sought.
fn extent_over_photo(context: &SheetContext<'_>, sheet: Sheet) -> Option<Extent> {
    match sheet {
        Sheet::Centers => context.construction().centers.as_ref().map(|_| centers::extent(context)),
        _ => Some(plan::on_paper::extent(context.plan(sheet)?, context.figure().construction)),
    }
}

/// The area of a panel's extent on the sheet, in mm.
fn area(extent: &Extent, origin: [f64; 2], mu: f64) -> Rect {
    let at = |x: f64, y: f64| Point::new(origin[0] + x / mu, origin[1] - y / mu);
    Rect::from_points(at(extent.low.x, extent.low.y), at(extent.high.x, extent.high.y))
}

/// Draws a point that was found: a cross, the circle that holds it, and where it is off its name with an asterisk.
fn draw_seen(drawing: &mut Drawing, context: &SheetContext<'_>, point: &SeenPoint) {
    let center = Point::new(point.at[0], point.at[1]);
    for arm in cross(center, CROSS) {
        drawing.draw(Pen::StudentPoint, arm);
    }
    drawing.draw(Pen::StudentPoint, Shape::Circle { center, radius: point.band.max(CROSS) });
    if point.is_off {
        let name = context.place_name(point.panel, &point.name);
        let name = RichText::math(&format!("{name}^*"));
        let from = center + Vec2::new(1.5 * CROSS, -1.2 * CROSS);
        drawing.draw(Pen::StudentPoint, Shape::Text(PlacedText::new(name, CAPTION * context.surface.dims.unit, from)));
    }
}
