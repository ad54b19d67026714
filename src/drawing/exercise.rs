//! The sheets of an exercise: the student's with the scheme true to scale, the given numbers, and boxes for the
//! results; the teacher's key.

use super::compose::Composition;
use super::figure::{composition, content, extents, kind, panels};
use super::key_table::{KeyRow, KeyTable};
use super::layout::Item;
use super::lines::Lines;
use super::plan_panel;
use super::scheme::Scheme;
use super::sheet::Drawing;
use super::sheet_notes::Fields;
use super::worksheet::Worksheet;
use crate::construction::Solution;
use crate::quantity::{Asked, Scales};
use crate::scene::{ConstructionShown, PanelName, ValuesShown};

/// The sheet of an exercise: the scheme without special points, but with room for them; below it `sentences`, in
/// markup; beside it a ruler and a table with a row for each of `asked`, with boxes for its millimetres and its value.
/// `None` where the scheme does not fit at the scale that the scene gives.
#[must_use]
pub fn exercise_sheet(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<Drawing> {
    let scheme = Scheme::new(solution).for_pencil().with_senses().without_values();
    let sheet = student_sheet(&scheme, asked, sentences);
    let layout = sheet.layout();
    let placed = layout.panels.first()?;
    let size = placed.shown(&scheme.extent());
    let fits = size.x <= placed.area.width() && size.y <= placed.area.height();
    fits.then(|| sheet.draw(&layout).after_step(0))
}

/// The scale of the scheme on the sheet of an exercise, with the arguments of [`exercise_sheet`]: the scene's scale or,
/// without one, the smallest that fits.
#[must_use]
pub fn exercise_scale(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<f64> {
    let scheme = Scheme::new(solution).for_pencil().with_senses().without_values();
    let layout = student_sheet(&scheme, asked, sentences).layout();
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
    let mu = |panel: PanelName| layout.mu(kind(panel));
    fit.then(|| Scales {
        length: mu(PanelName::Scheme),
        velocity: mu(PanelName::Velocity),
        acceleration: mu(PanelName::Acceleration),
    })
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
    let sentences = Lines::of(sentences.iter().chain(&notes), scheme.dims.page);
    composition(scheme, panels, Some(table), vec![Box::new(sentences)])
}

/// The student's sheet, with the scheme as its only panel.
fn student_sheet<'a>(scheme: &'a Scheme<'a>, asked: &[Asked], sentences: &[String]) -> Composition<'a> {
    let alone = [(PanelName::Scheme, scheme.extent())];
    let panels = panels(scheme, &alone, |panel| vec![content(scheme, panel)]);
    let table: Box<dyn Item> = Box::new(Worksheet::blank(scheme, asked));
    let title = scheme.scene.title.clone().unwrap_or_else(|| scheme.words.language.title().into());
    let (fields, own_line) = match Fields::new(scheme, &title) {
        Ok(fields) => (Some(Box::new(fields) as Box<dyn Item>), None),
        Err(line) => (None, Some(line)),
    };
    let notes: Vec<String> = scheme.note_on_paper().into_iter().chain(scheme.notes(asked)).chain(own_line).collect();
    let sentences: Box<dyn Item> = Box::new(Lines::of(sentences.iter().chain(&notes), scheme.dims.page));
    composition(scheme, panels, Some(table), std::iter::once(sentences).chain(fields).collect())
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
