//! The words about a student's drawing: a key of its lines, sentences, a table of the values.

use super::layer::{CROSS, cross};
use super::{Overlay, OwnValue};
use crate::drawing::context::SheetContext;
use crate::drawing::layout::{Aside, Item, Layout};
use crate::drawing::lines::{self, PAD};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Emphasis, Pen};
use crate::drawing::table::{Cells, Heading, Table};
use crate::drawing::text::{CAPTION, RichText};
use kurbo::{Point, Rect};

/// White between a sample in the key and its words, and after these, in mm.
const KEY: [f64; 2] = [1.6, 9.0];
/// Length of a sample in the key, in mm.
const SAMPLE: f64 = 11.0;
/// White above the words of a column, in mm.
const TOP: f64 = 2.0;

/// Place of the words about a drawing.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::drawing) enum WordsPlace {
    /// Below the panels.
    Below,
    /// In a column of this width, in mm, to the right of the panels.
    Beside(f64),
    /// On the sheet of the table, where only the key fits on the figure's sheet.
    Apart,
}

/// The key and the words on the figure's sheet.
pub(in crate::drawing) struct Notes<'a> {
    pub context: &'a SheetContext<'a>,
    pub overlay: &'a Overlay,
    pub place: WordsPlace,
}

impl Notes<'_> {
    /// Whether an area is high enough.
    pub(in crate::drawing) fn fits(&self, area: Rect) -> bool {
        area.height() >= TOP + self.needed()
    }

    /// Height of key and words, in mm.
    fn needed(&self) -> f64 {
        lines::height(self.key_lines() + self.lines().len())
    }

    fn lines(&self) -> Vec<RichText> {
        match self.place {
            WordsPlace::Below => self.overlay.lines(lines::width(self.context.surface.dims.page), false),
            WordsPlace::Beside(width) => self.overlay.lines(width - 2.0 * PAD, true),
            WordsPlace::Apart => Vec::new(),
        }
    }

    fn is_column(&self) -> bool {
        matches!(self.place, WordsPlace::Beside(_))
    }

    /// The samples in the key: 0 right, 1 the student's, 2 wrong.
    fn key(&self) -> impl Iterator<Item = usize> {
        let Overlay { points, lines, steps, .. } = self.overlay;
        let has_own = !(points.is_empty() && lines.is_empty());
        let wrong = !steps.is_empty();
        let needed = [has_own || wrong, has_own, wrong];
        (0..needed.len()).filter(move |&sample| needed[sample])
    }

    /// Number of lines of the key above the words, in a column or in a row.
    fn key_lines(&self) -> usize {
        let samples = self.key().count();
        if self.is_column() { samples } else { samples.min(1) }
    }

    /// Draws the key at the upper edge of an area.
    fn draw_key(&self, drawing: &mut Drawing, area: Rect) {
        let mut at = lines::baseline(area, 0);
        for (line, sample) in (1..).zip(self.key()) {
            let language = self.context.words.language;
            let words = [language.check_key_right(), language.check_key_own(), language.check_key_wrong()][sample];
            let end = key(drawing, at, sample, words);
            at = match self.is_column() {
                true => lines::baseline(area, line),
                false => Point::new(end + KEY[1], at.y),
            };
        }
    }
}

impl Item for Notes<'_> {
    fn height(&self) -> f64 {
        if self.is_column() { 0.0 } else { self.needed() }
    }

    fn asides(&self, _: Rect) -> Vec<Aside> {
        match self.place {
            WordsPlace::Beside(width) => vec![Aside::Right(width)],
            _ => Vec::new(),
        }
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout, aside: Option<Rect>) {
        let area = match aside {
            Some(column) if self.is_column() => {
                drawing.draw(Pen::Frame, Shape::rectangle(column));
                Rect { y0: column.y0 + TOP, ..column }
            }
            _ => layout.below,
        };
        self.draw_key(drawing, area);
        lines::draw(drawing, area, self.key_lines(), &self.lines());
    }
}

impl Overlay {
    /// A sentence or a cell with its names as they are set, the part after an underscore low.
    #[must_use]
    pub fn set(text: &str) -> RichText {
        RichText::plain(&typeset(text))
    }

    /// The table of the values.
    pub(in crate::drawing) fn table(&self) -> Table {
        let row = |(value, number): (&OwnValue, usize)| {
            let texts = value.cells.iter().map(|text| Overlay::set(text)).collect();
            Cells { stands_out: value.is_off, ..Cells::new(texts, format!("value-{number}")) }
        };
        let names = ["name", "own", "expected", "mm", "percent", "verdict"];
        let heading = |(text, name): (&String, &'static str)| {
            Heading::new(Overlay::set(text), name, !matches!(name, "name" | "verdict"))
        };
        Table::new(self.head.iter().zip(names).map(heading).collect(), self.values.iter().zip(1..).map(row).collect())
    }

    /// The words in lines of at most this width in mm; in a column with an empty line before each paragraph.
    pub(in crate::drawing) fn lines(&self, width: f64, is_column: bool) -> Vec<RichText> {
        let lines = self.words.iter().flat_map(|text| {
            let blank = is_column.then(|| RichText::plain(""));
            blank.into_iter().chain(RichText::lines(&typeset(text), CAPTION, width))
        });
        lines.collect()
    }
}

/// Draws an entry of the key from the left end of its baseline; returns its right end.
fn key(drawing: &mut Drawing, from: Point, sample: usize, words: &str) -> f64 {
    let middle = from.y - 1.3;
    let ends = [from.x, from.x + SAMPLE].map(|x| Point::new(x, middle));
    let line = Shape::Line(ends[0], ends[1]);
    match sample {
        0 => drawing.draw(Pen::Velocity, line).emphasis = Emphasis::Earlier,
        1 => {
            drawing.draw(Pen::Student, line);
            for arm in cross(ends[0].midpoint(ends[1]), CROSS) {
                drawing.draw(Pen::StudentPoint, arm);
            }
        }
        _ => {
            drawing.draw(Pen::Hint, line.clone());
            drawing.draw(Pen::Velocity, line).emphasis = Emphasis::New;
        }
    }
    let text = RichText::plain(words);
    let start = from.x + SAMPLE + KEY[0];
    let end = start + text.width(CAPTION);
    drawing.caption(text, Point::new(start, from.y));
    end
}

/// Names in sentences, as `v_r(3/2)` and `n_b3`, in markup: the part after an underscore is a subscript.
pub fn typeset(text: &str) -> String {
    let Some((before, after)) = text.split_once('_') else {
        return text.to_owned();
    };
    let is_low = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    // ² and ³ are alphanumeric, but no part of the subscript.
    let end = after.find(|c: char| !is_low(c) || matches!(c, '²' | '³'));
    let (low, rest) = after.split_at(end.unwrap_or(after.len()));
    format!("{before}_{{{}}}{}", typeset(low), typeset(rest))
}
