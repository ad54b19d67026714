//! The sheets of an exercise: the student's with the scheme true to scale, what is given, and boxes for what is to be found; the teacher's key.

use super::compose::Composition;
use super::figure::{composition, content, extents, panels};
use super::lines::Lines;
use super::scheme::Scheme;
use super::sheet::Drawing;
use super::worksheet::Worksheet;
use crate::construction::Solution;
use crate::quantity::Asked;
use crate::scene::PanelName;

/// The sheet of an exercise: the scheme without special points, but with room for them; below it `sentences`, in markup; beside it a table with
/// a row for each of `asked` and boxes for its millimetres and its value, and a ruler. `None` where the scheme does not fit beside them at the
/// scale that the scene gives.
#[must_use]
pub fn exercise_sheet(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<Drawing> {
    let scheme = Scheme::new(solution);
    let sheet = students(&scheme, asked, sentences);
    let layout = sheet.layout();
    let placed = layout.panels.first()?;
    let size = scheme.extent().size() / placed.mu;
    let fits = size.x <= placed.area.width() && size.y <= placed.area.height();
    fits.then(|| sheet.draw(&layout).after_step(0))
}

/// The scale at which the scheme fits on the sheet of an exercise, from the same as [`exercise_sheet`]; that of the scene where it gives one.
#[must_use]
pub fn exercise_scale(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<f64> {
    let layout = students(&Scheme::new(solution), asked, sentences).layout();
    layout.panels.first().map(|placed| placed.mu)
}

/// The figure that a scene asks for with other `sentences` below its scales, in markup, and with the table of a work
/// sheet.
#[must_use]
pub fn key_sheet(solution: &Solution, sentences: &[String]) -> Drawing {
    let scheme = Scheme::new(solution);
    let panels = panels(&scheme, &extents(&scheme), |panel| vec![content(&scheme, panel)]);
    let table = Worksheet::new(&scheme, &panels);
    let sentences = Lines::of(sentences, scheme.figure.page.size_mm());
    let sheet = composition(&scheme, panels, Some(table), vec![Box::new(sentences)]);
    sheet.draw(&sheet.layout())
}

/// The student's sheet, which has nothing but the scheme.
fn students<'a>(scheme: &'a Scheme<'a>, asked: &[Asked], sentences: &[String]) -> Composition<'a> {
    let alone = [(PanelName::Scheme, scheme.extent())];
    let panels = panels(scheme, &alone, |panel| vec![content(scheme, panel)]);
    let table = Worksheet::blank(scheme, asked);
    let sentences = Lines::of(sentences, scheme.figure.page.size_mm());
    composition(scheme, panels, Some(table), vec![Box::new(sentences)])
}

/// Whether the scheme has its special points at their places, none beyond reach.
#[must_use]
pub fn shows_special_points(solution: &Solution) -> bool {
    let scheme = Scheme::new(solution);
    scheme.special().all(|special| scheme.is_near(special))
}
