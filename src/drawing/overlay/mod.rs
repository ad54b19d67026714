//! A student's drawing over the right figure: what stands elsewhere on the own sheets, in a pen of its own, the steps at which something went
//! wrong in the accent colour, everything else pale.

mod panel;

use crate::drawing::canvas::CAPTION;
use crate::drawing::legend;
use crate::drawing::scheme::Scheme;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Emphasis, Mark, Pen};
use crate::drawing::table::{Cells, Table};
use crate::drawing::text::{PlacedText, RichText};
use crate::drawing::view::Extent;
use crate::geometry;
use crate::scene::Panel;
use crate::words::Wording;
use kurbo::{Point, Rect, Vec2};

/// Half the width of a cross that marks a point, in mm.
const CROSS: f64 = 1.1;
/// A panel grows for the student's points up to so many times the size of its own content: where its scale follows its size, and where the scale is
/// given.
const REACH: [f64; 2] = [1.6, 4.0];
/// Between a sample in the key and its words, and behind these, in mm.
const KEY: [f64; 2] = [1.6, 9.0];
/// Length of a sample in the key.
const SAMPLE: f64 = 11.0;

/// What a student's drawing has elsewhere than the right one, and what is to be said of it.
#[derive(Clone, Debug, Default)]
pub struct Overlay {
    /// Whose drawing it is.
    pub name: Option<String>,
    /// Points, marked with crosses.
    pub points: Vec<OwnPoint>,
    /// Lines and vectors.
    pub lines: Vec<OwnLine>,
    /// Steps at which something went wrong, the first one first.
    pub steps: Vec<WrongStep>,
    /// What is said below the panels, a paragraph each.
    pub words: Vec<String>,
    /// What the columns of the table of values show.
    pub head: [String; 6],
    /// The student's values.
    pub values: Vec<OwnValue>,
}

/// A point on a student's sheet.
#[derive(Clone, Debug)]
pub struct OwnPoint {
    /// Where it is drawn.
    pub panel: Panel,
    /// The name of the right point that it stands for.
    pub name: String,
    /// Its place, in units of the panel.
    pub at: geometry::Point,
    /// Whether its name is written beside it: not where it lies on the right point.
    pub is_named: bool,
}

/// A line on a student's sheet.
#[derive(Clone, Debug)]
pub struct OwnLine {
    /// Where it is drawn.
    pub panel: Panel,
    /// The point to which it leads.
    pub leads_to: String,
    /// Its ends, in units of the panel.
    pub ends: [geometry::Point; 2],
    /// What it is.
    pub kind: OwnKind,
    /// What is written beside it.
    pub label: Option<String>,
}

/// What a line on a student's sheet is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OwnKind {
    /// A straight line, without a head.
    Line,
    /// A vector.
    Vector,
    /// Not drawn by the student: it shows what another line has to do with the right drawing.
    Helper,
}

/// A step at which something went wrong.
#[derive(Clone, Debug)]
pub struct WrongStep {
    /// Its number, from 1.
    pub step: usize,
    /// The panel in which it is named.
    pub panel: Panel,
    /// What is written there.
    pub label: String,
    /// Of a step that solves for several rates the link whose rate is wrong; an empty name for a slide, which has no mark.
    pub link: Option<String>,
}

/// A row of the table of values.
#[derive(Clone, Debug)]
pub struct OwnValue {
    /// What stands in its cells.
    pub cells: [String; 6],
    /// Whether the value is off.
    pub is_off: bool,
}

impl Overlay {
    /// A panel's extent with the student's points where that does not make everything else small, at a scale that is given or not.
    pub(in crate::drawing) fn extended(&self, panel: Panel, own: Extent, is_given: bool) -> Extent {
        let reach = REACH[usize::from(is_given)];
        let points = self.points.iter().filter(|p| p.panel == panel);
        let ends = self.lines.iter().filter(|l| l.panel == panel);
        let ends = ends.flat_map(|l| l.ends);
        let mut extent = own;
        for place in points.map(|p| p.at).chain(ends) {
            let all = Extent::of([extent.low, extent.high, place]);
            if all.size().norm() <= reach * own.size().norm() {
                extent = all;
            }
        }
        extent
    }

    /// The words in lines of at most this width, in a column with an empty line before each paragraph.
    pub(in crate::drawing) fn lines(&self, width: f64, is_column: bool) -> Vec<RichText> {
        let words = self.words.iter();
        let lines = words.flat_map(|text| {
            let blank = is_column.then(|| RichText::plain(""));
            let lines = RichText::lines(&typeset(text), CAPTION, width);
            blank.into_iter().chain(lines)
        });
        lines.collect()
    }

    /// The samples that the key needs, by their places in it.
    fn key(&self) -> impl Iterator<Item = usize> {
        let own = !(self.points.is_empty() && self.lines.is_empty());
        let wrong = !self.steps.is_empty();
        let there = [own || wrong, own, wrong];
        (0..there.len()).filter(move |&sample| there[sample])
    }

    /// How many lines the key takes above the words, in a column or in a row.
    pub(in crate::drawing) fn key_lines(&self, is_column: bool) -> usize {
        let samples = self.key().count();
        if is_column { samples } else { samples.min(1) }
    }

    /// Draws the key at the upper edge of an area; how many lines it takes.
    pub(in crate::drawing) fn draw_key(&self, drawing: &mut Drawing, area: Rect, words: &Wording) -> usize {
        let is_column = area.width() < 0.5 * drawing.width;
        let mut at = legend::baseline(area, 0);
        for (line, sample) in (1..).zip(self.key()) {
            let language = words.language;
            let words = [language.check_key_right(), language.check_key_own(), language.check_key_wrong()][sample];
            let end = key(drawing, at, sample, words);
            at = match is_column {
                true => legend::baseline(area, line),
                false => Point::new(end + KEY[1], at.y),
            };
        }
        self.key_lines(is_column)
    }

    /// Makes the marks of a panel pale but for the student's and those of wrong steps, and lets none of them wait for its step.
    pub(in crate::drawing) fn emphasise(&self, marks: &mut Vec<Mark>, from: usize, scheme: &Scheme<'_>) {
        let drawn = marks.split_off(from);
        for mut mark in drawn {
            let is_wrong = self.steps.iter().any(|wrong| is_of(&mark, scheme, wrong));
            if mark.passing && !is_wrong {
                continue;
            }
            (mark.since, mark.passing) = (0, false);
            mark.emphasis = match mark.pen {
                Pen::Student | Pen::StudentPoint | Pen::Frame => Emphasis::Plain,
                _ if is_wrong => Emphasis::New,
                _ => Emphasis::Earlier,
            };
            marks.push(mark);
        }
    }

    /// The table of values.
    pub(in crate::drawing) fn table(&self) -> (Table<6>, Vec<Cells<6>>) {
        let set = |text: &String| RichText::plain(&typeset(text));
        let head = self.head.each_ref().map(set);
        let mut table = Table {
            widths: [0.0; 6],
            ending: [false, true, true, true, true, false],
            names: ["name", "own", "expected", "mm", "percent", "verdict"],
            rows: self.values.len(),
            foot: ([0.0; 2], 0),
            head,
        };
        let head = table.head.clone();
        table.widen(head.each_ref());
        let rows = self.values.iter().zip(1..).map(|(value, number)| Cells {
            texts: value.cells.each_ref().map(set),
            id: Some(format!("value-{number}")),
            since: 0,
            stands_out: value.is_off,
            boxes: [false; 6],
        });
        let rows: Vec<Cells<6>> = rows.collect();
        for row in &rows {
            table.widen(row.texts.each_ref());
        }
        (table, rows)
    }
}

/// A line of the key from the left end of its baseline: as it should be, the student's, where it went wrong. Where it ends.
fn key(drawing: &mut Drawing, from: Point, sample: usize, words: &str) -> f64 {
    let middle = from.y - 1.3;
    let ends = [from.x, from.x + SAMPLE].map(|x| Point::new(x, middle));
    let line = Shape::Line(ends[0], ends[1]);
    match sample {
        0 => drawing.draw(Pen::Velocity, line).emphasis = Emphasis::Earlier,
        1 => {
            drawing.draw(Pen::Student, line);
            for arm in cross(ends[0].midpoint(ends[1])) {
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
    let text = PlacedText::new(text, CAPTION, Point::new(start, from.y));
    drawing.draw(Pen::Caption, Shape::Text(text));
    end
}

/// Whether a mark comes with a step, and is of the link that the step went wrong with.
fn is_of(mark: &Mark, scheme: &Scheme<'_>, wrong: &WrongStep) -> bool {
    let link = |name: &String| {
        let id = scheme.mechanism.link(name);
        id.is_some() && mark.number == id.and_then(|id| scheme.number(id))
    };
    // The magnification of what is shown larger belongs to no step.
    let is_scale = mark.pen == Pen::Label && mark.id.is_none();
    usize::from(mark.since) == wrong.step && !is_scale && wrong.link.as_ref().is_none_or(link)
}

/// The two strokes of a cross.
fn cross(center: Point) -> [Shape; 2] {
    [1.0, -1.0].map(|sign| {
        let arm = Vec2::new(CROSS, sign * CROSS);
        Shape::Line(center - arm, center + arm)
    })
}

/// Names in sentences, `v_r(3/2)` and `n_b3`, as markup: all that follows an underscore stands low.
fn typeset(text: &str) -> String {
    let Some((before, after)) = text.split_once('_') else {
        return text.to_owned();
    };
    let is_low = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    // ² and ³ count as letters there, but stand high.
    let end = after.find(|c: char| !is_low(c) || matches!(c, '²' | '³'));
    let (low, rest) = after.split_at(end.unwrap_or(after.len()));
    format!("{before}_{{{}}}{}", typeset(low), typeset(rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn underscores_become_low_letters() {
        for (text, markup) in [
            ("v_r(3/2) and n_b3.", "v_{r}(3/2) and n_{b3}."),
            ("ω_2² L_BS3", "ω_{2}² L_{BS3}"),
            ("n_b_rodC", "n_{b_{rodC}}"),
            ("vplan(b,s3)", "vplan(b,s3)"),
        ] {
            assert_eq!(typeset(text), markup);
        }
    }
}
