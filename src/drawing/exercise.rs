//! The sheets of an exercise: the student's with the scheme true to scale, the given numbers, and boxes for the results;
//! those on which plans are drawn by hand, an empty panel for each with its pole and its scale; the teacher's key.

use super::canvas::Canvas;
use super::compose::{Composition, further_sheets};
use super::context::{Purpose, SheetContext, Surface};
use super::layout::{Item, Layout, Needs, Placed};
use super::lines::{Line, Lines};
use super::panel::{Frame, Layer, Panel};
use super::panels::{content, extents, panels};
use super::plan::sight::extent;
use super::scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::sheet_notes::Fields;
use super::text::RichText;
use super::view::{Extent, View};
use super::worksheet::{KeyRow, KeyTable, Ruler, TablePlace, Worksheet};
use crate::construction::Solution;
use crate::geometry;
use crate::quantity::QuantityRequest;
use crate::scene::{ConstructionShown, Page, PageSize, ValuesShown};
use crate::sheet::{PerSheet, Scales, Sheet};
use kurbo::{Point, Rect};

/// Smallest size of a table beside the scheme with markers, in parts of its usual size.
const SMALLEST_TABLE: f64 = 0.8;

/// The sheet of an exercise: the scheme without special points, but with room for them; below it `sentences`, in
/// markup; beside it a ruler and a table with a row for each of `asked`, with boxes for its millimetres and its value.
/// `None` where the scheme does not fit at the scale that the scene gives.
#[must_use]
pub fn exercise_sheet(solution: &Solution, asked: &[QuantityRequest], sentences: &[String]) -> Option<Drawing> {
    let context = SheetContext::new(solution, Purpose::Exercise);
    let sheet = student_sheet(&context, sentences, &StudentTable::on_sheet(asked));
    let layout = sheet.layout();
    is_whole(&context, &layout).then(|| sheet.draw(&layout).after_step(0))
}

/// The sheets on which a student draws, with markers unless the figure is to have none: as [`exercise_sheet`], then those
/// for the plans that the figure shows, all at these scales. `name` stands in the codes of the sheets.
///
/// Where the scheme has no room beside the table on the figure's page, the page is turned; else the table comes last, on
/// sheets of its own; else the page is A3. Where even that is too small for the scheme at its scale, its sheet is without
/// markers.
#[must_use]
pub fn drawing_sheets(
    solution: &Solution,
    scales: &Scales,
    name: &str,
    asked: &[QuantityRequest],
    sentences: &[String],
) -> Vec<Drawing> {
    let plans = plan_sheets(solution, scales, name, 2);
    let own = solution.scene.figure.page;
    let turned = |page: Page| Page { landscape: !page.landscape, ..page };
    let large = Page { size: PageSize::A3, ..own };
    let pages = [[own, turned(own)], [large, turned(large)]];
    // On each size first with the table beside the scheme, then with the table apart.
    let ways = pages.into_iter().flat_map(|pages| {
        let with = move |places: &'static [TablePlace]| {
            pages.into_iter().flat_map(move |page| places.iter().map(move |place| (page, *place)))
        };
        with(&[TablePlace::Beside, TablePlace::Anywhere]).chain(with(&[TablePlace::Apart]))
    });
    let alone = SheetContext::new(solution, Purpose::Exercise);
    let mu = PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet == Sheet::Scheme));
    for (page, place) in ways {
        let context = alone.on(Surface::on_page(page, alone.figure(), mu));
        let has_markers = context.wants_markers();
        let context = if has_markers { context.on(context.surface.with_markers()) } else { context };
        let table = StudentTable { asked, place, plans_follow: !plans.is_empty() };
        let signs = has_markers.then(|| context.signs(1, name));
        let sheet = Composition { signs, ..student_sheet(&context, sentences, &table) };
        let layout = sheet.layout();
        let blank = Worksheet::blank(&context, asked);
        let is_legible = |area: Rect| blank.table.size_in(area) >= SMALLEST_TABLE;
        let has_table = place == TablePlace::Apart || layout.aside.is_some_and(is_legible);
        if has_table && is_whole(&context, &layout) {
            let first = sheet.draw(&layout).after_step(0);
            let apart = (place == TablePlace::Apart).then(|| blank.filled(&layout));
            let fields = |_| vec![RichText::plain(context.words.language.exercise_name())];
            let last = apart.map(|table| further_sheets(&first, context.surface.dims.unit, fields, table));
            return std::iter::once(first).chain(plans).chain(last.into_iter().flatten()).collect();
        }
    }
    let context = alone.on(Surface::on_page(own, alone.figure(), mu));
    let table = StudentTable { asked, place: TablePlace::Anywhere, plans_follow: !plans.is_empty() };
    let sheet = student_sheet(&context, sentences, &table);
    std::iter::once(sheet.draw(&sheet.layout()).after_step(0)).chain(plans).collect()
}

/// Whether a sheet has room for the whole scheme.
fn is_whole(context: &SheetContext<'_>, layout: &Layout) -> bool {
    let size = layout.panels.first().map(|placed| (placed.shown(&scheme::sight::extent(context)), placed.area));
    size.is_some_and(|(size, area)| size.x <= area.width() && size.y <= area.height())
}

/// The scale of the scheme on the sheet of an exercise, with the arguments of [`exercise_sheet`]: the scene's scale or,
/// without one, the smallest that fits.
#[must_use]
pub fn exercise_scale(solution: &Solution, asked: &[QuantityRequest], sentences: &[String]) -> Option<f64> {
    let context = SheetContext::new(solution, Purpose::Exercise);
    let layout = student_sheet(&context, sentences, &StudentTable::on_sheet(asked)).layout();
    layout.panels.first().map(|placed| placed.mu)
}

/// The teacher's key: the scene's figure with all values, a table of the form's quantities, and `sentences` below the
/// scales, in markup.
#[must_use]
pub fn key_sheet(solution: &Solution, rows: &[KeyRow<'_>], sentences: &[String]) -> Drawing {
    let solution = with_values(solution);
    let context = SheetContext::new(&solution, Purpose::Exercise).with_values();
    let sheet = key(&context, rows, sentences);
    sheet.draw(&sheet.layout())
}

/// The scales of the key, with the arguments of [`key_sheet`]: those that the scene gives, else the finest that fit.
/// `None` where scheme or plans do not fit.
#[must_use]
pub fn key_scales(solution: &Solution, rows: &[KeyRow<'_>], sentences: &[String]) -> Option<Scales> {
    let solution = with_values(solution);
    let context = SheetContext::new(&solution, Purpose::Exercise).with_values();
    let sheet = key(&context, rows, sentences);
    let layout = sheet.layout();
    let fit = sheet.panels.iter().zip(&layout.panels).all(|(panel, placed)| placed.holds(&panel.needs.extent));
    fit.then(|| layout.mu())
}

/// The scene with the layer of values in its figure.
fn with_values(solution: &Solution) -> Solution {
    let mut solution = solution.clone();
    solution.scene.figure.values.get_or_insert(ValuesShown::Shown(None));
    solution
}
fn key<'a>(context: &'a SheetContext<'a>, rows: &[KeyRow<'_>], sentences: &[String]) -> Composition<'a> {
    let panels = panels(context, &extents(context), |panel| vec![content(context, panel)]);
    let table: Box<dyn Item> = Box::new(KeyTable::new(context, &panels, rows));
    let asked: Vec<QuantityRequest> = rows.iter().map(|row| row.asked.clone()).collect();
    let notes = context.notes(&asked);
    let sentences = Lines::of(sentences.iter().chain(&notes), context.surface.dims.width_below());
    Composition::new(context, panels, Some(table), vec![Box::new(sentences)])
}

/// The table of a student's sheet.
struct StudentTable<'a> {
    asked: &'a [QuantityRequest],
    place: TablePlace,
    /// Whether sheets for the plans follow.
    plans_follow: bool,
}

impl<'a> StudentTable<'a> {
    /// The table on a sheet that stands alone.
    fn on_sheet(asked: &'a [QuantityRequest]) -> StudentTable<'a> {
        StudentTable { asked, place: TablePlace::Anywhere, plans_follow: false }
    }
}

/// The student's sheet, with the scheme as its only panel.
fn student_sheet<'a>(context: &'a SheetContext<'a>, sentences: &[String], table: &StudentTable<'_>) -> Composition<'a> {
    let alone = vec![(Sheet::Scheme, scheme::sight::extent(context))];
    let panels = panels(context, &alone, |panel| vec![content(context, panel)]);
    let (fields, own_line) = match Fields::new(context, &context.title()) {
        Ok(fields) => (Some(Box::new(fields) as Box<dyn Item>), None),
        Err(line) => (None, Some(line)),
    };
    let paper = match table.plans_follow {
        true => Some(context.words.language.exercise_sheets().to_owned()),
        false => context.note_on_paper(),
    };
    let notes: Vec<String> = paper.into_iter().chain(context.notes(table.asked)).chain(own_line).collect();
    let sentences = Lines::of(sentences.iter().chain(&notes), context.surface.dims.width_below());
    let mut items: Vec<Box<dyn Item>> = Vec::new();
    let beside: Option<Box<dyn Item>> = match table.place {
        TablePlace::Apart => {
            items.push(Ruler::below(context, &sentences));
            None
        }
        place => Some(Box::new(Worksheet { place, ..Worksheet::blank(context, table.asked) })),
    };
    items.insert(0, Box::new(sentences));
    Composition::new(context, panels, beside, items.into_iter().chain(fields).collect())
}

/// Whether scheme and plans show all their points at their places, none by an arrow.
#[must_use]
pub fn shows_special_points(solution: &Solution) -> bool {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let [shown, all] = [context.figure().construction, ConstructionShown::Paper];
    let mut plans = context.construction().plans();
    context.special().all(|special| scheme::sight::is_near(&context, special))
        && plans.all(|plan| extent(plan, shown) == extent(plan, all))
}

/// White in a panel around the right plan, in mm: a wrong one is larger.
const AROUND_PLAN: f64 = 10.0;

/// The sheets for the plans that the figure shows, at these scales, with numbers from `first` on: both
/// on one sheet where both have room, else one each; on the figure's page, as it lies or turned, else on A3.
fn plan_sheets(solution: &Solution, scales: &Scales, name: &str, first: u16) -> Vec<Drawing> {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let own = context.figure().page;
    let shown = context.figure().shown_panels();
    let mu = PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet.is_plan()));
    let is_wanted = |sheet: &Sheet| shown.contains(sheet) && context.plan(*sheet).is_some() && mu[*sheet].is_some();
    let plans: Vec<Sheet> = Sheet::PLANS.into_iter().filter(is_wanted).collect();
    let sheet = |page: Page, plans: &[Sheet], number: u16| {
        let context = context.on(Surface::on_page(page, context.figure(), mu));
        match context.wants_markers() {
            true => drawn(&context.on(context.surface.with_markers()), plans, number, name),
            false => drawn(&context, plans, number, name),
        }
    };
    if plans.len() > 1
        && let (both, true) = sheet(own, &plans, first)
    {
        return vec![both];
    }
    let turned = |page: Page| Page { landscape: !page.landscape, ..page };
    let large = Page { size: PageSize::A3, ..own };
    let alone = |(plan, number): (&Sheet, u16)| {
        let pages = [own, turned(own), large, turned(large)].into_iter();
        let fitting = pages.map(|page| sheet(page, &[*plan], number)).find_map(|(drawn, fits)| fits.then_some(drawn));
        fitting.unwrap_or_else(|| sheet(large, &[*plan], number).0)
    };
    plans.iter().zip(first..).map(alone).collect()
}

/// A sheet for some plans, and whether it has room for them.
fn drawn(context: &SheetContext<'_>, plans: &[Sheet], number: u16, name: &str) -> (Drawing, bool) {
    let mut sheet = sheet_of_plans(context, plans);
    sheet.signs = context.wants_markers().then(|| context.signs(number, name));
    let layout = sheet.layout();
    for (panel, placed) in sheet.panels.iter_mut().zip(&layout.panels) {
        let pole = pole(&panel.needs.extent, placed);
        // The view shows the middle of the extent at the middle of the area.
        let off = (placed.area.center() - pole) * (placed.mu * placed.unit);
        panel.needs.extent = Extent::of([geometry::Point::new(off.x, -off.y)]);
    }
    (sheet.draw(&layout), layout.shows_all())
}
fn sheet_of_plans<'a>(context: &'a SheetContext<'a>, plans: &[Sheet]) -> Composition<'a> {
    let panels = plans.iter().filter_map(|plan| panel(context, *plan)).collect();
    let title = context.title();
    let (fields, own_line) = match Fields::new(context, &title) {
        Ok(fields) => (Some(Box::new(fields) as Box<dyn Item>), None),
        Err(line) => (None, Some(line)),
    };
    let sentence = context.wants_markers().then(|| context.words.language.sheet_markers().to_owned());
    let lines = Lines::of(own_line.iter().chain(&sentence), context.surface.dims.width_below());
    let ruler = Ruler::below(context, &lines);
    let below = [Box::new(lines) as Box<dyn Item>, ruler];
    Composition::new(context, panels, None, below.into_iter().chain(fields).collect())
}

/// The empty panel of a plan.
fn panel<'a>(context: &'a SheetContext<'a>, plan: Sheet) -> Option<Panel<'a>> {
    let drawn = context.plan(plan)?;
    let name = context.words.language.sheet(plan);
    let frame = Frame::new(Line::new(vec![RichText::plain(name)]), Pen::Heading);
    let needs = Needs {
        kind: plan.drawn(),
        extent: extent(drawn, ConstructionShown::Whole),
        heading: frame.width(),
        above: 0.0,
        mu: context.surface.mu[plan],
        white: AROUND_PLAN,
        weight: 1.0,
    };
    let pole = drawn.sheet.pole();
    let layer = move |canvas: &mut Canvas<'_>, view: &View| {
        let (center, radius) = (view.at(geometry::Point::origin()), 2.0 * context.surface.dims.dot);
        canvas.draw_named(&format!("point-{pole}"), Pen::Pole, Shape::Circle { center, radius });
        canvas.label_renamed(pole, &context.shown(pole, Some(drawn)), center, radius + 0.7, None);
    };
    Some(Panel {
        name: name.to_owned(),
        prefix: plan.as_str().to_owned(),
        needs,
        cut: context.words.language.cut_at_edge().to_owned(),
        unlabelled: context.words.language.names_without_room().to_owned(),
        content: None,
        layers: vec![Box::new(frame) as Box<dyn Layer>, Box::new(layer)],
    })
}

/// The place of a plan's pole in its panel, at whole millimetres of paper: as near to the middle as the plan allows, so
/// that it tells little about the plan and that others have room, too.
fn pole(plan: &Extent, placed: &Placed) -> Point {
    let (area, room, mu) = (placed.area, placed.room_of_pole(), placed.mu * placed.unit);
    let within = |middle: f64, [from, to]: [f64; 2], [first, last]: [f64; 2]| {
        let place = if from <= to { middle.clamp(from, to) } else { 0.5 * (from + to) };
        let [first, last] = [libm::ceil(first * placed.unit), libm::floor(last * placed.unit)];
        libm::round(place * placed.unit).min(last).max(first) / placed.unit
    };
    let middle = area.center();
    Point::new(
        within(middle.x, [area.x0 - plan.low.x / mu, area.x1 - plan.high.x / mu], [room.x0, room.x1]),
        within(middle.y, [area.y0 + plan.high.y / mu, area.y1 + plan.low.y / mu], [room.y0, room.y1]),
    )
}
