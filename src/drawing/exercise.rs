//! The sheets of an exercise: the student's with the scheme true to scale, what is given, and boxes for what is to be found; the teacher's key.

use super::figure::{Sheet, Shown, compose, extents};
use super::legend;
use super::scheme::Scheme;
use super::sheet::Drawing;
use super::text::RichText;
use super::view::Extent;
use super::worksheet::Worksheet;
use crate::plan::{Asked, Solution};
use crate::scene::{Panel, Scene};

/// The sheet of an exercise: the scheme without special points, but with room for them; below it `sentences`, in markup; beside it a table with
/// a row for each of `asked` and boxes for its millimetres and its value, and a ruler. `None` where the scheme does not fit beside them at the
/// scale that the scene gives.
#[must_use]
pub fn exercise_sheet(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<Drawing> {
    let alone = alone(solution);
    let scheme = Scheme::new(&alone);
    let laid = Laid::out(&alone.scene, &scheme, sentences, |_| Worksheet::blank(&scheme, alone.scene.units, asked));
    let placed = laid.sheet.layout.panels.first()?;
    let size = laid.extents.first()?.1.size() / placed.mu;
    let fits = size.x <= placed.area.width() && size.y <= placed.area.height();
    fits.then(|| compose(&alone.scene, &scheme, &laid.sheet, &laid.extents, Shown::Words(&laid.lines)).after_step(0))
}

/// The figure that a scene asks for with other `sentences` below its scales, in markup.
#[must_use]
pub fn key_sheet(solution: &Solution, sentences: &[String]) -> Drawing {
    let (scene, scheme) = (&solution.scene, Scheme::new(solution));
    let table = |extents: &[(Panel, Extent)]| {
        let page = scene.figure.page.size_mm();
        Worksheet::new(&scheme, scene.units, extents, page)
    };
    let laid = Laid::out(scene, &scheme, sentences, table);
    compose(scene, &scheme, &laid.sheet, &laid.extents, Shown::Words(&laid.lines))
}

/// The scale at which the scheme fits on the sheet of an exercise, from the same as [`exercise_sheet`]; that of the scene where it gives one.
#[must_use]
pub fn exercise_scale(solution: &Solution, asked: &[Asked], sentences: &[String]) -> Option<f64> {
    let alone = alone(solution);
    let scheme = Scheme::new(&alone);
    let laid = Laid::out(&alone.scene, &scheme, sentences, |_| Worksheet::blank(&scheme, alone.scene.units, asked));
    laid.sheet.layout.panels.first().map(|placed| placed.mu)
}

/// The solution with nothing but the scheme in its figure.
fn alone(solution: &Solution) -> Solution {
    let mut alone = solution.clone();
    alone.scene.figure.panels = vec![Panel::Scheme];
    alone
}

/// A sheet of an exercise, divided up.
struct Laid {
    sheet: Sheet,
    extents: Vec<(Panel, Extent)>,
    lines: Vec<RichText>,
}

impl Laid {
    fn out(
        scene: &Scene,
        scheme: &Scheme<'_>,
        sentences: &[String],
        table: impl FnOnce(&[(Panel, Extent)]) -> Worksheet,
    ) -> Laid {
        let extents = extents(scheme);
        let [width, _] = scene.figure.page.size_mm();
        let lines = sentences.iter().flat_map(|s| legend::lines(s, width));
        let lines: Vec<RichText> = lines.collect();
        let table = table(&extents);
        let below = legend::height_of_lines(lines.len());
        let layout = Sheet::divided(scene, scheme, &extents, below, &|room| table.asides(room));
        let sheet = Sheet { layout, worksheet: Some(table) };
        Laid { sheet, extents, lines }
    }
}

/// Whether the scheme has its special points at their places, none beyond reach.
#[must_use]
pub fn shows_special_points(solution: &Solution) -> bool {
    let scheme = Scheme::new(solution);
    scheme.special().all(|special| scheme.is_near(special))
}
