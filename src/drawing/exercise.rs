//! The sheets of an exercise: the student's with the scheme true to scale, the given numbers, and boxes for the results;
//! those on which plans are drawn by hand, an empty panel for each with its pole and its scale; the teacher's key.

use super::canvas::Canvas;
use super::centers;
use super::compose::{Composition, further_sheets};
use super::context::{Purpose, SheetContext};
use super::labels::LabelRequest;
use super::layout::{Needs, Placed};
use super::lines::{Line, Lines};
use super::panel::{Frame, Panel, content, extents, panels, plan_extent};
use super::plan::on_paper::extent;
use super::scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::sheet_notes::Fields;
use super::text::RichText;
use super::view::{Extent, View};
use super::worksheet::{KeyRow, Ruler, TablePlace, Worksheet};
use crate::construction::{Plan, Solution};
use crate::geometry;
use crate::quantity::QuantityRequest;
use crate::scene::{ConstructionShown, Page, PageSize, ValuesShown};
use crate::sheet::{Order, PerSheet, Scales, Sheet};
use kurbo::{Point, Rect};

/// Smallest size of a table beside the scheme with markers, in parts of its usual size.
const SMALLEST_TABLE: f64 = 0.8;

/// The sheet of an exercise: the scheme without special points, but with room for them; below it `sentences`, in
/// markup; beside it a ruler and a table with a row for each of `asked`, with boxes for its millimetres and its value.
/// `None` where the scheme does not fit at the scale that the scene gives.
#[must_use]
pub fn exercise_sheet(solution: &Solution, asked: &[QuantityRequest], sentences: &[String]) -> Option<Drawing> {
    let context = SheetContext::new(solution, Purpose::Exercise);
    let sheet = student_sheet(&context, asked, sentences, TablePlace::Anywhere, false);
    let layout = sheet.layout();
    layout.holds_all().then(|| sheet.draw(&layout).after_step(0))
}

/// The scale of the scheme on the sheet of an exercise, with the arguments of [`exercise_sheet`]: the scene's scale or,
/// without one, the smallest that fits.
#[must_use]
pub fn exercise_scale(solution: &Solution, asked: &[QuantityRequest], sentences: &[String]) -> Option<f64> {
    let context = SheetContext::new(solution, Purpose::Exercise);
    student_sheet(&context, asked, sentences, TablePlace::Anywhere, false).layout().mu_of(Sheet::Scheme)
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
    // On each size first with the table beside the scheme, then with the table apart.
    let tries = pages(own).into_iter().flat_map(|[page, turned]| {
        let beside = [page, turned].map(|page| [(page, TablePlace::Beside), (page, TablePlace::Anywhere)]);
        [beside.concat(), [page, turned].map(|page| (page, TablePlace::Apart)).to_vec()].concat()
    });
    let alone = SheetContext::new(solution, Purpose::Exercise);
    let mu = PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet == Sheet::Scheme));
    for (page, place) in tries {
        let context = alone.on_page(page, mu).with_markers();
        let sheet = student_sheet(&context, asked, sentences, place, !plans.is_empty()).with_code(1, name);
        let layout = sheet.layout();
        let table = Worksheet::blank(&context, asked, place);
        let is_legible = |area: Rect| table.table.size_in(area) >= SMALLEST_TABLE;
        let is_apart = place == TablePlace::Apart;
        if layout.holds_all() && (is_apart || layout.aside().is_some_and(is_legible)) {
            let mut sheets = vec![sheet.draw(&layout).after_step(0)];
            sheets.extend(plans);
            if is_apart {
                let fields = |_| vec![RichText::plain(context.words.language.exercise_name())];
                sheets.extend(further_sheets(&sheets[0], context.surface.dims.unit, fields, table.filled(&layout)));
            }
            return sheets;
        }
    }
    let context = alone.on_page(own, mu);
    let sheet = student_sheet(&context, asked, sentences, TablePlace::Anywhere, !plans.is_empty());
    std::iter::once(sheet.draw(&sheet.layout()).after_step(0)).chain(plans).collect()
}

/// The pages that are tried: a page as it lies and turned, then A3 likewise.
fn pages(own: Page) -> [[Page; 2]; 2] {
    [own, Page { size: PageSize::A3, ..own }].map(|page| [page, Page { landscape: !page.landscape, ..page }])
}

/// The student's sheet, with the scheme as its only panel.
fn student_sheet<'a>(
    context: &'a SheetContext<'a>,
    asked: &[QuantityRequest],
    sentences: &[String],
    place: TablePlace,
    plans_follow: bool,
) -> Composition<'a> {
    let alone = [(Sheet::Scheme, scheme::on_paper::extent(context))];
    let sheet = Composition::new(context, panels(context, &alone, |sheet| vec![content(context, sheet)]));
    let has_plans = context.construction().draws_plans();
    let paper = match plans_follow {
        true if !has_plans && context.construction().centers.is_some() => {
            Some(context.words.language.exercise_center_sheet().to_owned())
        }
        true => Some(context.words.language.exercise_sheets().to_owned()),
        false => context.note_on_paper(),
    };
    let notes = [sentences.iter().cloned().chain(paper).chain(context.notes(asked)).collect(), Vec::new()];
    match place {
        TablePlace::Apart => with_notes(sheet, notes, true),
        _ => with_notes(sheet.with(Worksheet::blank(context, asked, place)), notes, false),
    }
}

/// A sheet with its scales, notes below them, a ruler beside these where no table has one, and lines for name and date:
/// beside the title, or between the notes before and after them.
fn with_notes<'a>(sheet: Composition<'a>, [before, after]: [Vec<String>; 2], has_ruler: bool) -> Composition<'a> {
    let context = sheet.context;
    let (fields, own_line) = Fields::new(context);
    let notes = before.iter().chain(&own_line).chain(&after);
    let lines = Lines::of(notes, context.surface.dims.width_below());
    let ruler = has_ruler.then(|| Ruler::with_lines(context, &lines));
    sheet.with(lines).with_optional(ruler).with_optional(fields)
}

/// The teacher's key: the scene's figure with all values, a table of the form's quantities, and notes below the scales.
#[must_use]
pub fn key_sheet(solution: &Solution, rows: &[KeyRow<'_>]) -> Drawing {
    let context = key_context(solution);
    let sheet = key(&context, rows);
    sheet.draw(&sheet.layout())
}

/// The scales of the key, with the arguments of [`key_sheet`]: those that the scene gives, else the finest that fit.
/// `None` where scheme or plans do not fit.
#[must_use]
pub fn key_scales(solution: &Solution, rows: &[KeyRow<'_>]) -> Option<Scales> {
    let layout = key(&key_context(solution), rows).layout();
    layout.holds_all().then(|| layout.mu())
}

fn key_context(solution: &Solution) -> SheetContext<'_> {
    let shown = solution.scene.figure.values.unwrap_or(ValuesShown::Shown(None));
    SheetContext::new(solution, Purpose::Exercise).with_values_as(shown)
}

fn key<'a>(context: &'a SheetContext<'a>, rows: &[KeyRow<'_>]) -> Composition<'a> {
    let panels = panels(context, &extents(context), |sheet| vec![content(context, sheet)]);
    let table = Worksheet::key(context, &panels, rows);
    let asked: Vec<QuantityRequest> = rows.iter().map(|row| row.asked.clone()).collect();
    let allowed = context.words.language.exercise_allowed().to_owned();
    let notes = Lines::of([allowed].iter().chain(&context.notes(&asked)), context.surface.dims.width_below());
    Composition::new(context, panels).with(table).with(notes)
}

/// Whether scheme and plans show all their points at their places, none by an arrow.
#[must_use]
pub fn shows_special_points(solution: &Solution) -> bool {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let [shown, all] = [context.figure().construction, ConstructionShown::Paper];
    let mut plans = context.construction().plans();
    context.special().all(|special| scheme::on_paper::is_near(&context, special))
        && plans.all(|plan| extent(plan, shown) == extent(plan, all))
}

/// Whether the figure of instant centres shows all of them at their places, none by an arrow.
#[must_use]
pub fn shows_centers(solution: &Solution) -> bool {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let extent = centers::extent(&context);
    let all = context.construction().centers.iter().flat_map(|centers| &centers.all);
    all.filter_map(|center| center.place.finite()).all(|place| extent.with(place) == extent)
}

/// White in a panel around the right plan, in mm: a wrong one is larger.
const AROUND_PLAN: f64 = 10.0;

/// The sheets for the plans that the figure shows, at these scales, with numbers from `first` on: all on one sheet where
/// they have room, else one each; on the figure's page, as it lies or turned, else on A3.
fn plan_sheets(solution: &Solution, scales: &Scales, name: &str, first: u16) -> Vec<Drawing> {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let own = context.figure().page;
    let shown = context.figure().shown_panels();
    let mu = PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet != Sheet::Scheme));
    let is_wanted = |sheet: &Sheet| shown.contains(sheet) && mu[*sheet].is_some();
    let plans = context.construction().plans().map(Plan::sheet);
    let centers = context.construction().centers.iter().map(|_| Sheet::Centers);
    let forces =
        [Sheet::Forces, Sheet::Lever].into_iter().filter(|sheet| context.construction().by_hand.contains(sheet));
    let plans: Vec<Sheet> = plans.chain(centers).chain(forces).filter(is_wanted).collect();
    let sheet = |page: Page, plans: &[Sheet], number: u16| {
        sheet_of_plans(&context.on_page(page, mu).with_markers(), plans, number, name, None)
    };
    if plans.len() > 1
        && let (all, true) = sheet(own, &plans, first)
    {
        return vec![all];
    }
    let alone = |(plan, number): (&Sheet, u16)| {
        let pages = pages(own);
        let mut tried = pages.into_iter().flatten().map(|page| sheet(page, &[*plan], number));
        let fitting = tried.find_map(|(drawn, fits)| fits.then_some(drawn));
        fitting.unwrap_or_else(|| sheet(pages[1][0], &[*plan], number).0)
    };
    plans.iter().zip(first..).map(alone).collect()
}

/// What is drawn on an empty panel.
pub(super) type Drawn<'a> = &'a dyn Fn(&mut Canvas<'_>, &View, &SheetContext<'_>);

/// The sheet for a plan as a student gets it, with something drawn on it and a note below: of the same size and with the same code as the empty one.
pub(super) fn plan_sheet_with(
    solution: &Solution,
    scales: &Scales,
    name: &str,
    (plan, number): (Sheet, u16),
    drawn: Drawn<'_>,
    note: Option<&str>,
) -> Drawing {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let mu = PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet == plan));
    let pages = pages(context.figure().page);
    let on_page = |page: Page| {
        sheet_of_plans(&context.on_page(page, mu).with_markers(), &[plan], number, name, Some((drawn, note)))
    };
    let mut tried = pages.into_iter().flatten().map(on_page);
    let fitting = tried.find_map(|(drawing, fits)| fits.then_some(drawing));
    fitting.unwrap_or_else(|| on_page(pages[1][0]).0)
}

/// A sheet for some plans, and whether it has room for them.
fn sheet_of_plans<'a>(
    context: &'a SheetContext<'a>,
    plans: &[Sheet],
    number: u16,
    name: &str,
    drawn: Option<(Drawn<'a>, Option<&str>)>,
) -> (Drawing, bool) {
    let panels = plans.iter().filter_map(|plan| {
        let mut panel = panel(context, *plan)?;
        if let Some((drawn, _)) = drawn {
            panel.layers.push(Box::new(move |canvas: &mut Canvas<'_>, view: &View| drawn(canvas, view, context)));
        }
        Some(panel)
    });
    let sheet = Composition::new(context, panels.collect());
    let has_markers = context.surface.dims.free.has_markers();
    let sentence = has_markers.then(|| context.words.language.sheet_markers().to_owned());
    let note = drawn.and_then(|(_, note)| note).map(str::to_owned);
    let notes = note.into_iter().chain(sentence).collect();
    let sheet = with_notes(sheet.with_code(number, name), [Vec::new(), notes], true);
    let mut layout = sheet.layout();
    for placed in layout.panels.iter_mut().filter(|placed| placed.needs.sheet.order().is_some()) {
        // The view shows the middle of the extent at the middle of the area.
        let off = (placed.area.center() - pole(placed)) * (placed.mu * placed.unit);
        placed.needs.extent = Extent::of([geometry::Point::new(off.x, -off.y)]);
    }
    (sheet.draw(&layout), layout.shows_all())
}

/// The panel of instant centres as a student gets it: the mechanism, with room for the lines.
fn panel_of_centers<'a>(context: &'a SheetContext<'a>) -> Panel<'a> {
    let name = context.words.language.sheet(Sheet::Centers);
    let frame = Frame::new(Line::new(vec![RichText::plain(name)]), Pen::Heading).with_scale(context);
    let needs = Needs {
        mu: context.surface.mu[Sheet::Centers],
        white: AROUND_PLAN,
        ..frame.needs(context, Sheet::Centers, centers::extent(context))
    };
    let layer = move |canvas: &mut Canvas<'_>, view: &View| scheme::draw_bare(canvas, view, context, |_| true);
    let language = Some(context.words.language);
    Panel { language, ..Panel::plain(name, Sheet::Centers.as_str(), needs, frame, vec![Box::new(layer)]) }
}

/// The panel of force polygons or of a lever as a student gets it: empty, but for the poles of levers.
fn panel_of_forces<'a>(context: &'a SheetContext<'a>, sheet: Sheet) -> Option<Panel<'a>> {
    let own = plan_extent(sheet, context.construction(), context.figure().construction);
    let name = context.words.language.sheet(sheet);
    let frame = Frame::new(Line::new(vec![RichText::plain(name)]), Pen::Heading).with_scale(context);
    let needs = Needs { mu: context.surface.mu[sheet], white: AROUND_PLAN, ..frame.needs(context, sheet, own?) };
    let layer = move |canvas: &mut Canvas<'_>, view: &View| {
        for own in context.construction().levers.iter().filter(|_| sheet == Sheet::Lever) {
            let (center, radius) = (view.at(geometry::Point::from(own.pole)), 2.0 * context.surface.dims.dot);
            canvas.draw_named("point-p", Pen::Pole, Shape::Circle { center, radius });
            let name = RichText::math(context.words.notation.pole(Order::Velocity));
            canvas.ask("p-", LabelRequest::new(name, center, radius + 0.7, None, 2));
        }
    };
    let language = Some(context.words.language);
    Some(Panel { language, ..Panel::plain(name, sheet.as_str(), needs, frame, vec![Box::new(layer)]) })
}

/// The empty panel of a plan.
fn panel<'a>(context: &'a SheetContext<'a>, sheet: Sheet) -> Option<Panel<'a>> {
    match sheet {
        Sheet::Centers => return Some(panel_of_centers(context)),
        Sheet::Forces | Sheet::Lever | Sheet::Speeds => return panel_of_forces(context, sheet),
        _ => {}
    }
    let plan = context.plan(sheet)?;
    let name = context.words.language.sheet(sheet);
    let frame = Frame::new(Line::new(vec![RichText::plain(name)]), Pen::Heading).with_scale(context);
    let needs = Needs {
        mu: context.surface.mu[sheet],
        white: AROUND_PLAN,
        ..frame.needs(context, sheet, extent(plan, ConstructionShown::Whole))
    };
    let pole = plan.order.pole();
    let layer = move |canvas: &mut Canvas<'_>, view: &View| {
        let (center, radius) = (view.at(geometry::Point::origin()), 2.0 * context.surface.dims.dot);
        canvas.draw_named(&format!("point-{pole}"), Pen::Pole, Shape::Circle { center, radius });
        let name = RichText::math(&context.shown(pole, Some(plan)));
        canvas.ask(&format!("{pole}-"), LabelRequest::new(name, center, radius + 0.7, None, 2));
    };
    let language = Some(context.words.language);
    Some(Panel { language, ..Panel::plain(name, sheet.as_str(), needs, frame, vec![Box::new(layer)]) })
}

/// The place of a plan's pole in its panel, at whole millimetres of paper: as near to the middle as the plan allows, so
/// that it tells little about the plan and that others have room, too.
fn pole(placed: &Placed) -> Point {
    let (plan, area) = (placed.needs.extent, placed.area);
    let mu = placed.mu * placed.unit;
    let within = |middle: f64, [from, to]: [f64; 2], [first, last]: [f64; 2]| {
        let place = if from <= to { middle.clamp(from, to) } else { 0.5 * (from + to) };
        let [first, last] = [libm::ceil(first * placed.unit), libm::floor(last * placed.unit)];
        libm::round(place * placed.unit).min(last).max(first) / placed.unit
    };
    let middle = area.center();
    Point::new(
        within(middle.x, [area.x0 - plan.low.x / mu, area.x1 - plan.high.x / mu], [area.x0, area.x1]),
        within(middle.y, [area.y0 + plan.high.y / mu, area.y1 + plan.low.y / mu], [area.y0, area.y1]),
    )
}
