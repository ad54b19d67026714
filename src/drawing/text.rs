use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use kurbo::{BezPath, Point, Rect, Vec2};

use super::fonts;
use super::markup::{Run, Setter, Setting};
use crate::text::Untrusted;

/// Size of labels, in mm of one em. Lower-case letters of the bundled font are 0.429 em high: 2 mm; scripts are
/// smaller.
pub(super) const LABEL: f64 = 4.7;
/// Size of captions, in mm of one em; no words of a figure are smaller.
pub(super) const CAPTION: f64 = 4.7;

/// Least white between two texts side by side, in mm: half an em. With less they read as one.
pub(super) const BESIDE: f64 = 0.5 * LABEL;
/// Least white between two texts one above the other, in mm.
pub(super) const ABOVE: f64 = 0.2 * LABEL;

/// Most texts of a setting that are remembered.
const MOST_SET: usize = 4096;

thread_local! {
    /// Texts by their source, for each setting with and without markup.
    static SET: RefCell<[BTreeMap<String, RichText>; 4]> = RefCell::default();
}

/// White between two texts, in em: a space of the bundled font.
const SPACE: f64 = 0.25;

/// A line of text with subscripts and superscripts, measured.
///
/// Markup: `_x` or `_{...}` sets a subscript, `^x` or `^{...}` a superscript; one after the other
/// on the same base they stand one above the other. Without braces one letter is taken. All else is
/// literal, an unclosed brace too. Control characters are dropped, other white space becomes a
/// space.
#[derive(Clone, Debug, PartialEq)]
pub struct RichText {
    /// Shared: a sheet has most texts several times, and a drawing is copied.
    runs: Arc<[Run]>,
    advance: f64,
    ink: Rect,
}

impl RichText {
    /// A mathematical label: Latin and Greek letters slanted, digits, brackets and signs upright;
    /// `'` becomes a prime and `-` a minus.
    pub fn math(source: &str) -> Self {
        Self::set(source, Setting::Math, true)
    }

    /// Upright text with the same markup.
    pub fn plain(source: &str) -> Self {
        Self::set(source, Setting::Plain, true)
    }

    /// Upright text taken letter by letter, without markup: for titles and names from outside.
    pub fn verbatim(source: impl Into<Untrusted>) -> Self {
        Self::set(&source.into().for_setting(), Setting::Plain, false)
    }

    /// Lines of [`plain`](Self::plain) text, broken at spaces, each at most `width` mm wide at a size, unless a single
    /// word is wider.
    pub fn lines(source: &str, size: f64, width: f64) -> Vec<Self> {
        let whole = Self::plain(source);
        if whole.width(size) <= width {
            return vec![whole];
        }
        let measured = |text: &str| Self::plain(text).width(size);
        let space = measured("x x") - 2.0 * measured("x");
        let mut lines = vec![String::new()];
        let mut taken = 0.0;
        for word in source.split(' ') {
            let word_width = measured(word);
            let line = lines.last_mut().expect("there is one line at least");
            if line.is_empty() || taken + space + word_width <= width {
                taken += if line.is_empty() { word_width } else { space + word_width };
                line.extend((!line.is_empty()).then_some(' '));
                line.push_str(word);
            } else {
                taken = word_width;
                lines.push(word.to_owned());
            }
        }
        lines.iter().map(|line| Self::plain(line)).collect()
    }

    /// This text, a space, and another text.
    #[must_use]
    pub fn followed_by(mut self, other: &Self) -> Self {
        let shift = self.advance + SPACE;
        let moved =
            |(index, run): (usize, &Run)| Run { x: run.x + shift, spaced: index == 0 || run.spaced, ..run.clone() };
        self.runs = self.runs.iter().cloned().chain(other.runs.iter().enumerate().map(moved)).collect();
        self.ink = self.ink.union(other.ink + Vec2::new(shift, 0.0));
        self.advance = shift + other.advance;
        self
    }

    /// A text that has been set before is not set again: sheets of one scene, and frames of a page, share most texts.
    fn set(source: &str, setting: Setting, markup: bool) -> Self {
        SET.with_borrow_mut(|known| {
            let known = &mut known[usize::from(setting == Setting::Math) + 2 * usize::from(markup)];
            if let Some(text) = known.get(source) {
                return text.clone();
            }
            let setter = Setter::set(source, setting, markup);
            let text = Self { runs: setter.runs.into(), advance: setter.pen.x, ink: setter.ink.unwrap_or(Rect::ZERO) };
            if known.len() >= MOST_SET {
                known.clear();
            }
            known.insert(source.to_owned(), text.clone());
            text
        })
    }

    /// The runs in reading order.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// The advance of the pen in mm, at a size in mm of one em.
    pub fn width(&self, size: f64) -> f64 {
        self.advance * size
    }

    /// The tight box around the ink in mm at a size (mm of one em), from the left end of the baseline, y down; empty at
    /// the origin for a text without ink.
    pub fn ink_box(&self, size: f64) -> Rect {
        Rect::new(self.ink.x0 * size, self.ink.y0 * size, self.ink.x1 * size, self.ink.y1 * size)
    }

    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// The letters alone, without spaces around runs: for searches and logs.
    pub fn content(&self) -> String {
        self.runs.iter().map(|run| run.content.as_str()).collect()
    }
}

/// A text at its place on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedText {
    /// The text.
    pub text: RichText,
    /// Its size: mm of one em.
    pub size: f64,
    /// The left end of its baseline.
    pub origin: Point,
    /// The point that stays in place where another font sets the text wider or narrower than measured.
    pub anchor: Anchor,
}

/// A place on the baseline of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// A run at its place on the sheet, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedRun<'a> {
    /// The letters.
    pub content: &'a str,
    /// Whether the face is the slanted one.
    pub italic: bool,
    /// The size of the letters: mm of one em.
    pub size: f64,
    /// The left end of the run's baseline.
    pub origin: Point,
}

impl PlacedRun<'_> {
    /// Calls `show` with the outline of each glyph, in em, y down, and the left end of its baseline on the sheet;
    /// outlines are filled by the nonzero rule.
    pub fn outline(&self, mut show: impl FnMut(&'static BezPath, Point)) {
        fonts::face(self.italic).outline(self.content, |glyph, pen| {
            show(glyph, self.origin + Vec2::new(pen * self.size, 0.0));
        });
    }

    /// Calls `show` for each glyph with its number in the face ([`REGULAR`](super::REGULAR) or
    /// [`ITALIC`](super::ITALIC)), 0 for a letter that the face lacks, the bytes of `content` that it draws, and its
    /// left end from that of the run, in em. Returns the advance of the run, in em.
    pub fn glyphs(&self, show: impl FnMut(u16, Range<usize>, f64)) -> f64 {
        fonts::face(self.italic).glyphs(self.content, show)
    }
}

impl PlacedText {
    /// A text whose baseline starts at `origin`.
    pub fn new(text: RichText, size: f64, origin: Point) -> Self {
        Self { text, size, origin, anchor: Anchor::Start }
    }

    /// This text in its place, with another point that stays where a wider font is used.
    pub fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// A text that ends at `end` on its baseline.
    pub fn ending_at(text: RichText, size: f64, end: Point) -> Self {
        Self { origin: Point::new(end.x - text.width(size), end.y), text, size, anchor: Anchor::End }
    }

    /// The tight box around the ink on the sheet, in mm.
    pub fn ink_box(&self) -> Rect {
        self.text.ink_box(self.size) + self.origin.to_vec2()
    }

    /// The runs at their places on the sheet.
    pub fn runs(&self) -> impl Iterator<Item = PlacedRun<'_>> {
        self.text.runs().iter().map(|run| PlacedRun {
            content: &run.content,
            italic: run.italic,
            size: run.scale * self.size,
            origin: self.origin + Vec2::new(run.x, run.y) * self.size,
        })
    }
}
