use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::{CAPTION, PlacedText, RichText};
use kurbo::{Point, Rect};

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

    /// Draws it as a caption, centred at a point of its baseline.
    pub(super) fn centred(&self, drawing: &mut Drawing, middle: Point) {
        let from = Point::new(middle.x - 0.5 * self.width(CAPTION), middle.y);
        self.starting(drawing, Pen::Caption, from, CAPTION);
    }

    /// Draws it as a caption that ends at a point of its baseline.
    pub(super) fn ending(&self, drawing: &mut Drawing, end: Point) {
        let from = Point::new(end.x - self.width(CAPTION), end.y);
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
