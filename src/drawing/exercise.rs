//! The sheets of an exercise: the student's with the scheme true to scale, the given numbers, and boxes for the
//! results; the teacher's key.

use super::compose::Composition;
use super::figure::{composition, content, extents, panels};
use super::layout::Item;
use super::lines::Lines;
use super::plan_panel;
use super::scheme::Scheme;
use super::sheet::Drawing;
use super::worksheet::Worksheet;
use crate::construction::Solution;
use crate::quantity::Asked;
use crate::scene::{ConstructionShown, PanelName, ValuesShown};

/// The sheet of an exercise: the scheme without special points, but with room for them; below it `sentences`, in
/// markup; beside it a ruler and a table with a row for each of `asked`, with boxes for its millimetres and its value.
/// `None` where the scheme does not fit at the scale that the scene gives.
#[must_use]
pub fn exercise_sheet(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<Drawing> {
    let scheme = Scheme::new(solution).for_pencil().without_values();
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
    let layout = student_sheet(&Scheme::new(solution).for_pencil().without_values(), asked, sentences).layout();
    layout.panels.first().map(|placed| placed.mu)
}

/// The scene's figure with other `sentences` below its scales, in markup, and with the table of a work sheet.
#[must_use]
pub fn key_sheet(solution: &Solution, sentences: &[String]) -> Drawing {
    let mut solution = solution.clone();
    solution.scene.figure.values.get_or_insert(ValuesShown::Shown(None));
    let scheme = Scheme::new(&solution).for_pencil();
    let panels = panels(&scheme, &extents(&scheme), |panel| vec![content(&scheme, panel)]);
    let table: Box<dyn Item> = Box::new(Worksheet::new(&scheme, &panels));
    let sentences = Lines::of(sentences, scheme.dims.page);
    let sheet = composition(&scheme, panels, Some(table), vec![Box::new(sentences)]);
    sheet.draw(&sheet.layout())
}

/// The student's sheet, with the scheme as its only panel.
fn student_sheet<'a>(scheme: &'a Scheme<'a>, asked: &[Asked], sentences: &[String]) -> Composition<'a> {
    let alone = [(PanelName::Scheme, scheme.extent())];
    let panels = panels(scheme, &alone, |panel| vec![content(scheme, panel)]);
    let table: Box<dyn Item> = Box::new(Worksheet::blank(scheme, asked));
    let sentences = Lines::of(sentences, scheme.dims.page);
    composition(scheme, panels, Some(table), vec![Box::new(sentences)])
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
