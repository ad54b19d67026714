//! The sheets of an exercise: the student's with the scheme true to scale, the given numbers, and boxes for the
//! results; the teacher's key.

use super::compose::{Composition, further_sheets};
use super::context::{Purpose, SheetContext, Surface};
use super::key_table::{KeyRow, KeyTable};
use super::layout::{Item, Layout};
use super::lines::Lines;
use super::panels::{content, extents, panels};
use super::plan::sight::extent;
use super::plan_sheets::plan_sheets;
use super::scheme;
use super::sheet::Drawing;
use super::sheet_notes::Fields;
use super::text::RichText;
use super::worksheet::{Ruler, TablePlace, Worksheet};
use crate::construction::Solution;
use crate::quantity::QuantityRequest;
use crate::scene::{ConstructionShown, Page, PageSize, ValuesShown};
use crate::sheet::{PerSheet, Scales, Sheet};
use kurbo::Rect;

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

/// The key's sheet.
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
