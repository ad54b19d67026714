//! The sheets of an exercise: the student's with the scheme true to scale, the given numbers, and boxes for the
//! results; the teacher's key.

use super::compose::{Composition, further_sheets};
use super::figure::{composition, content, extents, panels};
use super::key_table::{KeyRow, KeyTable};
use super::layout::{Item, Layout};
use super::lines::Lines;
use super::plan_panel;
use super::plan_sheets::plan_sheets;
use super::scheme::Scheme;
use super::sheet::Drawing;
use super::sheet_notes::Fields;
use super::text::RichText;
use super::worksheet::{Ruler, TablePlace, Worksheet};
use crate::construction::Solution;
use crate::quantity::{Asked, Kind};
use crate::scene::{ConstructionShown, Page, PageSize, ValuesShown};
use crate::sheet::{PerSheet, Scales, Sheet};
use kurbo::Rect;

/// Smallest size of a table beside the scheme with markers, in parts of its usual size.
const SMALLEST_TABLE: f64 = 0.8;

/// The sheet of an exercise: the scheme without special points, but with room for them; below it `sentences`, in
/// markup; beside it a ruler and a table with a row for each of `asked`, with boxes for its millimetres and its value.
/// `None` where the scheme does not fit at the scale that the scene gives.
#[must_use]
pub fn exercise_sheet(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<Drawing> {
    let scheme = Scheme::new(solution).for_pencil().with_senses().without_values();
    let sheet = student_sheet(&scheme, sentences, &Table::on_sheet(asked));
    let layout = sheet.layout();
    is_whole(&scheme, &layout).then(|| sheet.draw(&layout).after_step(0))
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
    asked: &[Asked],
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
    let mut solution = solution.clone();
    for (page, place) in ways {
        solution.scene.figure.page = page;
        let scheme = Scheme::new(&solution).for_pencil().with_senses().without_values();
        let has_markers = scheme.figure.has_markers();
        let dims = if has_markers { scheme.dims.with_markers() } else { scheme.dims };
        let scheme = Scheme { dims, mu: scheme_alone(scales), ..scheme };
        let table = Table { asked, place, plans_follow: !plans.is_empty() };
        let signs = has_markers.then(|| scheme.signs(1, name));
        let sheet = Composition { signs, ..student_sheet(&scheme, sentences, &table) };
        let layout = sheet.layout();
        let blank = Worksheet::blank(&scheme, asked);
        let is_legible = |area: Rect| blank.table.size_in(area) >= SMALLEST_TABLE;
        let has_table = place == TablePlace::Apart || layout.aside.is_some_and(is_legible);
        if has_table && is_whole(&scheme, &layout) {
            let first = sheet.draw(&layout).after_step(0);
            let apart = (place == TablePlace::Apart).then(|| blank.filled(&layout));
            let fields = |_| vec![RichText::plain(scheme.words.language.exercise_name())];
            let last = apart.map(|table| further_sheets(&first, scheme.dims.unit, fields, table));
            return std::iter::once(first).chain(plans).chain(last.into_iter().flatten()).collect();
        }
    }
    solution.scene.figure.page = own;
    let scheme = Scheme::new(&solution).for_pencil().with_senses().without_values();
    let scheme = Scheme { mu: scheme_alone(scales), ..scheme };
    let table = Table { asked, place: TablePlace::Anywhere, plans_follow: !plans.is_empty() };
    let sheet = student_sheet(&scheme, sentences, &table);
    std::iter::once(sheet.draw(&sheet.layout()).after_step(0)).chain(plans).collect()
}

/// The scale of the scheme alone, on sheets that show no plan.
fn scheme_alone(scales: &Scales) -> Scales {
    PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet == Sheet::Scheme))
}

/// Whether a sheet has room for the whole scheme.
fn is_whole(scheme: &Scheme<'_>, layout: &Layout) -> bool {
    let size = layout.panels.first().map(|placed| (placed.shown(&scheme.extent()), placed.area));
    size.is_some_and(|(size, area)| size.x <= area.width() && size.y <= area.height())
}

/// The scale of the scheme on the sheet of an exercise, with the arguments of [`exercise_sheet`]: the scene's scale or,
/// without one, the smallest that fits.
#[must_use]
pub fn exercise_scale(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<f64> {
    let scheme = Scheme::new(solution).for_pencil().with_senses().without_values();
    let layout = student_sheet(&scheme, sentences, &Table::on_sheet(asked)).layout();
    layout.panels.first().map(|placed| placed.mu)
}

/// The teacher's key: the scene's figure with all values, a table of the form's quantities, and `sentences` below the
/// scales, in markup.
#[must_use]
pub fn key_sheet(solution: &Solution, rows: &[KeyRow<'_>], sentences: &[String]) -> Drawing {
    let solution = with_values(solution);
    let scheme = Scheme::new(&solution).for_pencil().with_senses();
    let sheet = key(&scheme, rows, sentences);
    sheet.draw(&sheet.layout())
}

/// The scales of the key, with the arguments of [`key_sheet`]: those that the scene gives, else the finest that fit.
/// `None` where scheme or plans do not fit.
#[must_use]
pub fn key_scales(solution: &Solution, rows: &[KeyRow<'_>], sentences: &[String]) -> Option<Scales> {
    let solution = with_values(solution);
    let scheme = Scheme::new(&solution).for_pencil().with_senses();
    let sheet = key(&scheme, rows, sentences);
    let layout = sheet.layout();
    let fit = sheet.panels.iter().zip(&layout.panels).all(|(panel, placed)| placed.holds(&panel.needs.extent));
    fit.then(|| PerSheet::from_fn(|sheet| layout.mu(Kind::drawn_on(sheet))))
}

/// The scene with the layer of values in its figure.
fn with_values(solution: &Solution) -> Solution {
    let mut solution = solution.clone();
    solution.scene.figure.values.get_or_insert(ValuesShown::Shown(None));
    solution
}

/// The key's sheet.
fn key<'a>(scheme: &'a Scheme<'a>, rows: &[KeyRow<'_>], sentences: &[String]) -> Composition<'a> {
    let panels = panels(scheme, &extents(scheme), |panel| vec![content(scheme, panel)]);
    let table: Box<dyn Item> = Box::new(KeyTable::new(scheme, &panels, rows));
    let asked: Vec<Asked> = rows.iter().map(|row| row.asked.clone()).collect();
    let notes = scheme.notes(&asked);
    let sentences = Lines::of(sentences.iter().chain(&notes), scheme.dims.width_below());
    composition(scheme, panels, Some(table), vec![Box::new(sentences)])
}

/// The table of a student's sheet.
struct Table<'a> {
    asked: &'a [Asked],
    place: TablePlace,
    /// Whether sheets for the plans follow.
    plans_follow: bool,
}

impl<'a> Table<'a> {
    /// The table on a sheet that stands alone.
    fn on_sheet(asked: &'a [Asked]) -> Table<'a> {
        Table { asked, place: TablePlace::Anywhere, plans_follow: false }
    }
}

/// The student's sheet, with the scheme as its only panel.
fn student_sheet<'a>(scheme: &'a Scheme<'a>, sentences: &[String], table: &Table<'_>) -> Composition<'a> {
    let alone = [(Sheet::Scheme, scheme.extent())];
    let panels = panels(scheme, &alone, |panel| vec![content(scheme, panel)]);
    let (fields, own_line) = match Fields::new(scheme, &scheme.title()) {
        Ok(fields) => (Some(Box::new(fields) as Box<dyn Item>), None),
        Err(line) => (None, Some(line)),
    };
    let paper = match table.plans_follow {
        true => Some(scheme.words.language.exercise_sheets().to_owned()),
        false => scheme.note_on_paper(),
    };
    let notes: Vec<String> = paper.into_iter().chain(scheme.notes(table.asked)).chain(own_line).collect();
    let sentences = Lines::of(sentences.iter().chain(&notes), scheme.dims.width_below());
    let mut items: Vec<Box<dyn Item>> = Vec::new();
    let beside: Option<Box<dyn Item>> = match table.place {
        TablePlace::Apart => {
            items.push(Ruler::below(scheme, &sentences));
            None
        }
        place => Some(Box::new(Worksheet { place, ..Worksheet::blank(scheme, table.asked) })),
    };
    items.insert(0, Box::new(sentences));
    composition(scheme, panels, beside, items.into_iter().chain(fields).collect())
}

/// Whether scheme and plans show all their points at their places, none by an arrow.
#[must_use]
pub fn shows_special_points(solution: &Solution) -> bool {
    let scheme = Scheme::new(solution).for_pencil().without_values();
    let [shown, all] = [scheme.figure.construction, ConstructionShown::Paper];
    let mut plans = scheme.construction.plans();
    scheme.special().all(|special| scheme.is_near(special))
        && plans.all(|plan| plan_panel::extent(plan, shown) == plan_panel::extent(plan, all))
}
