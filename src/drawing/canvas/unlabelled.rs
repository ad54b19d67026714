//! The names for which a panel has no room: their list below its heading, or else a word in a corner.

use super::Canvas;
use crate::drawing::clip::clipped_segment;
use crate::drawing::layout::ROW;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Pen, Unlabelled, UnlabelledName};
use crate::drawing::text::{ABOVE, BESIDE, CAPTION, PlacedText, RichText};
use crate::words::Language;
use kurbo::{Point, Rect};

/// White between a panel's edge and words in its corner, in mm.
const CORNER: f64 = 2.5;
/// White between the words of a list and its names, and between two names, in em.
const BETWEEN: f64 = 0.3;
/// The lower edge of a row below its baseline, in mm: scripts one above the other do not reach below it.
const BELOW: f64 = 1.6;

/// A piece of a list: its text, the row in which it stands, its left end, the step from which it is there.
struct Piece {
    text: RichText,
    row: usize,
    x: f64,
    since: u16,
}

impl Canvas<'_> {
    /// Keeps rows below the heading free, for the list of names without room.
    pub(in crate::drawing) fn keep_rows(&mut self, rows: usize) {
        self.rows = rows;
        if rows > 0 {
            let bottom = self.frame.y0 + self.header;
            let area = Rect::new(self.frame.x0, bottom - ROW * rows as f64, self.frame.x1, bottom);
            self.obstacles.add_texts([area]);
        }
    }

    /// Lists names without room, as far as there are rows for them, and tells the drawing of them. Without rows the panel
    /// says in a corner that there is no room; labels, which begin with the mark `first`, give way.
    pub(super) fn tell_unlabelled(
        &mut self,
        mut names: Vec<UnlabelledName>,
        first: usize,
        language: Option<&Language>,
    ) {
        if let Some(language) = language.filter(|_| !names.is_empty() && self.rows == 0) {
            names.append(&mut self.say_unlabelled(language.names_without_room(), first));
        }
        if names.is_empty() {
            return;
        }
        names.sort_by_key(|name| name.since);
        let pieces = language.map_or_else(Vec::new, |language| self.list(language.names_left_out(), &names));
        let rows = pieces.last().map_or(0, |last| last.row + 1);
        let are_listed = (1..=self.rows).contains(&rows);
        let (kept, top) = (self.rows, self.frame.y0 + self.header - ROW * self.rows as f64);
        for (index, Piece { text, row, x, since }) in pieces.into_iter().filter(|piece| piece.row < kept).enumerate() {
            self.step = since;
            let place = Point::new(x, top + ROW * (row + 1) as f64 - BELOW);
            let text = Shape::Text(PlacedText::new(text, CAPTION, place));
            self.draw_below(&format!("unlabelled-{index}"), Pen::Caption, text);
        }
        let panel = self.name.to_owned();
        self.drawing.unlabelled.push(Unlabelled { panel, names, rows, are_listed });
    }

    /// The list of names with words before it, in rows of the panel's width.
    fn list(&self, words: &str, names: &[UnlabelledName]) -> Vec<Piece> {
        let (left, right) = (self.frame.x0 + CORNER, self.frame.x1 - CORNER);
        let since = names.first().map_or(0, |name| name.since);
        let words = RichText::plain(words);
        let mut x = left + words.width(CAPTION);
        let mut pieces = vec![Piece { text: words, row: 0, x: left, since }];
        let comma = RichText::plain(",");
        let mut row = 0;
        for (index, name) in names.iter().enumerate() {
            if index > 0 {
                pieces.push(Piece { text: comma.clone(), row, x, since: name.since });
                x += comma.width(CAPTION);
            }
            let width = name.text.width(CAPTION);
            x += BETWEEN * CAPTION;
            if x + width + comma.width(CAPTION) > right {
                (row, x) = (row + 1, left);
            }
            pieces.push(Piece { text: name.text.clone(), row, x, since: name.since });
            x += width;
        }
        pieces
    }

    /// Says in a corner that there is no room for all names. Labels, which begin with the mark `first`, give way; these
    /// are returned.
    fn say_unlabelled(&mut self, words: &str, first: usize) -> Vec<UnlabelledName> {
        let boxes = self.drawing.marks[first..].iter().map(|mark| mark.shape.bounds());
        self.obstacles.add_boxes(boxes);
        let labels = self.drawing.marks.split_off(first);
        let area = self.say("unlabelled", words, 0);
        let mut left_out = Vec::new();
        for mark in labels {
            match &mark.shape {
                Shape::Text(text) if text.ink_box().overlaps(area) => {
                    let place = text.ink_box().center();
                    left_out.push(UnlabelledName { text: text.text.clone(), place, since: mark.since });
                    // Its leader comes before it.
                    let marks = &mut self.drawing.marks;
                    let has_leader = marks.last().is_some_and(|last| last.pen == Pen::Leader);
                    marks.truncate(marks.len() - usize::from(has_leader));
                }
                _ => self.drawing.marks.push(mark),
            }
        }
        left_out
    }

    /// Says something in a corner of the panel, where no label will stand.
    pub(in crate::drawing) fn remark(&mut self, name: &str, words: &str) {
        let area = self.say(name, words, 0);
        self.obstacles.add_boxes([area]);
    }

    /// Says something in a corner of the panel from a step on; `name` is the end of its mark's id. Returns its box.
    pub(super) fn say(&mut self, name: &str, words: &str, step: u16) -> Rect {
        let text = RichText::plain(words);
        // In a panel that is narrower than the words, as on a telephone, they are smaller.
        let room = self.frame.width() - 2.0 * CORNER;
        let height = CAPTION * (room / text.width(CAPTION)).min(1.0);
        let (left, right) = (self.frame.x0 + CORNER, self.frame.x1 - CORNER - text.width(height));
        let (top, bottom) = (self.frame.y0 + self.header, self.frame.y1 - CORNER);
        let corners = [(left, bottom), (right, bottom), (right, top + height), (left, top + height)];
        let corners = corners.map(|(x, y)| Point::new(x, y));
        let place = |from: Point| PlacedText::new(text.clone(), height, from);
        let covered = |from: &Point| {
            let ink = place(*from).ink_box().inflate(BESIDE, ABOVE);
            let lines = self.obstacles.lines.iter().filter(|(a, b)| clipped_segment(ink, *a, *b).is_some());
            lines.count() + 4 * self.obstacles.boxes.iter().filter(|area| area.overlaps(ink)).count()
        };
        let text = place(corners.into_iter().min_by_key(covered).expect("a panel has four corners"));
        let area = text.ink_box();
        self.step = step;
        self.draw_named(name, Pen::Caption, Shape::Text(text));
        area.inflate(BESIDE, ABOVE)
    }
}
