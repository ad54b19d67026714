//! Lines of words: one of several parts, and many below the scales or in another area.

use super::dims::MARGIN;
use super::layout::{Item, Layout};
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::{CAPTION, PlacedText, RichText};
use kurbo::{Point, Rect};

/// White on the left and on the right of words and of scales, in mm.
pub(super) const PAD: f64 = 4.0;
/// White below the words, in mm.
pub(super) const EDGE: f64 = 2.2;
/// Height of a line of words, in mm.
const LINE: f64 = 6.0;

/// A line of text of several parts, with slanted symbols and upright words.
pub(super) struct Line(Vec<RichText>);

impl Line {
    /// White between its parts, in em.
    const SPACE: f64 = 0.28;

    pub(super) fn new(parts: Vec<RichText>) -> Line {
        Line(parts)
    }

    /// A sentence with a symbol inserted.
    pub(super) fn around(sentence: impl Fn(&str) -> String, symbol: RichText) -> Line {
        const BLANK: &str = "\u{fffc}";
        let sentence = sentence(BLANK);
        let (before, behind) = sentence.split_once(BLANK).unwrap_or((&sentence, ""));
        let words = |text: &str| (!text.trim().is_empty()).then(|| RichText::plain(text.trim()));
        Line(words(before).into_iter().chain([symbol]).chain(words(behind)).collect())
    }

    pub(super) fn width(&self, size: f64) -> f64 {
        let spaces = self.0.len().saturating_sub(1) as f64 * Self::SPACE * size;
        spaces + self.0.iter().map(|part| part.width(size)).sum::<f64>()
    }

    /// Draws it as a caption with this share of its width before a point of its baseline: 0.5 centres it, 1 ends it there.
    pub(super) fn caption(&self, drawing: &mut Drawing, at: Point, share: f64) {
        let from = Point::new(at.x - share * self.width(CAPTION), at.y);
        self.starting(drawing, Pen::Caption, from, CAPTION);
    }

    /// Draws it from a point of its baseline; returns the box around its ink.
    pub(super) fn starting(&self, drawing: &mut Drawing, pen: Pen, from: Point, size: f64) -> Rect {
        let mut at = from;
        let mut ink: Option<Rect> = None;
        for part in &self.0 {
            let text = PlacedText::new(part.clone(), size, at);
            at.x += part.width(size) + Self::SPACE * size;
            ink = Some(ink.map_or(text.ink_box(), |ink| ink.union(text.ink_box())));
            drawing.draw(pen, Shape::Text(text));
        }
        ink.unwrap_or(Rect::from_points(from, from))
    }
}

/// Lines of words below the scales.
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

    fn draw(&self, drawing: &mut Drawing, layout: &Layout, _: Option<Rect>) {
        let from = drawing.marks.len();
        draw(drawing, layout.below, 0, &self.lines);
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
