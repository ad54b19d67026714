//! Lines of words, below the scales or in another area.

use super::layout::{Item, Layout, MARGIN};
use super::sheet::Drawing;
use super::text::{CAPTION, RichText};
use kurbo::{Point, Rect};

/// White on the left and on the right of words and of scales, in mm.
pub(super) const PAD: f64 = 4.0;
/// White below the words, in mm.
pub(super) const EDGE: f64 = 2.2;
/// Height of a line of words, in mm.
const LINE: f64 = 6.0;

/// Lines below the scales.
pub(super) struct Lines {
    pub lines: Vec<RichText>,
    /// The only step with these lines; none for all.
    pub step: Option<u16>,
}

impl Lines {
    /// Sentences, each on new lines, in an area of that width.
    pub(super) fn of<'a>(sentences: impl IntoIterator<Item = &'a String>, width: f64) -> Lines {
        let lines = |sentence: &'a String| RichText::lines(sentence, CAPTION, width - 2.0 * PAD);
        Lines { lines: sentences.into_iter().flat_map(lines).collect(), step: None }
    }
}

impl Item for Lines {
    fn height(&self) -> f64 {
        if self.lines.is_empty() { 0.0 } else { height(self.lines.len()) }
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let from = drawing.marks.len();
        draw(drawing, layout.below(), 0, &self.lines);
        if let Some(step) = self.step {
            for mark in &mut drawing.marks[from..] {
                (mark.since, mark.passing) = (step, true);
            }
        }
    }
}

/// Width of lines below the scales on a sheet of that size, in mm.
pub(super) fn width([width, _]: [f64; 2]) -> f64 {
    width - 2.0 * (MARGIN + PAD)
}

/// Height of so many lines, in mm.
pub(super) fn height(lines: usize) -> f64 {
    LINE * lines as f64 + EDGE
}

/// Writes lines from the upper edge of an area, after `before` other lines.
pub(super) fn draw(drawing: &mut Drawing, area: Rect, before: usize, lines: &[RichText]) {
    for (line, number) in lines.iter().zip(before..) {
        drawing.caption(line.clone(), baseline(area, number));
    }
}

/// Left end of a line's baseline in an area.
pub(super) fn baseline(area: Rect, line: usize) -> Point {
    Point::new(area.x0 + PAD, area.y0 + 4.6 + LINE * line as f64)
}
