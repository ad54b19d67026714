//! A table on a sheet: rows of cells under a head, in as many columns side by side as fit.

use super::layout::{Aside, Item, Layout, cut_off};
use super::shape::Shape;
use super::sheet::{Drawing, Emphasis, Mark, Pen};
use super::text::{CAPTION, PlacedText, RichText};
use kurbo::{Point, Rect};

/// Height of a row, in mm.
const ROW: f64 = 6.2;
/// Height of the row of headings, in mm.
const HEAD: f64 = 7.6;
/// White inside the frame, in mm.
pub(super) const PAD: f64 = 3.0;
/// White between the cells of a row, in mm.
const GUTTER: f64 = 3.2;
/// Height of a box above and below the baseline, in mm.
const BOX: [f64; 2] = [4.1, 1.3];
/// Smallest size of rows, in parts of the usual size.
const SMALLEST: f64 = 0.1;
/// Largest part of a shared sheet's width or height for the table.
const MOST: f64 = 0.6;

/// A table of rows of cells, without a place.
#[derive(Clone)]
pub(super) struct Table {
    /// Headings of the cells.
    pub head: Vec<Heading>,
    pub rows: Vec<Cells>,
    /// Room below the last column: width and height in mm, and the height in rows.
    pub foot: ([f64; 2], usize),
}

/// What stands above the cells of all rows, and what these have in common.
#[derive(Clone)]
pub(super) struct Heading {
    text: RichText,
    /// End of the cells' ids.
    name: &'static str,
    /// Whether the cells are aligned on the right, as numbers are.
    is_right: bool,
    /// Width of the cells, in mm.
    pub width: f64,
}

impl Heading {
    pub(super) fn new(text: RichText, name: &'static str, is_right: bool) -> Self {
        Self { width: text.width(CAPTION), text, name, is_right }
    }
}

/// A row of a table.
#[derive(Clone)]
pub(super) struct Cells {
    pub texts: Vec<RichText>,
    /// Prefix of the ids of their marks.
    pub id: String,
    /// The step with which they appear.
    pub since: u16,
    /// Whether they are emphasized.
    pub stands_out: bool,
    /// Indices of those that are boxes to be filled in.
    pub boxes: &'static [usize],
}

impl Cells {
    /// Cells of texts, there from the start.
    pub(super) fn new(texts: Vec<RichText>, id: String) -> Self {
        Self { texts, id, since: 0, stands_out: false, boxes: &[] }
    }
}

/// Arrangement of rows: number of columns, rows in each and in the last, size in parts of the usual size.
struct Arrangement {
    columns: usize,
    depth: usize,
    last: usize,
    small: f64,
}

impl Item for Table {
    fn asides(&self, room: Rect) -> Vec<Aside> {
        let below = self.height(self.columns(room.width()));
        let mut asides = vec![Aside::Below(below.min(MOST * room.height()))];
        let width = |columns: &usize| *columns as f64 * self.column();
        let mut beside = (1..).take_while(|columns| width(columns) < MOST * room.width());
        let fitting = beside.find(|columns| self.height(*columns) <= room.height());
        asides.extend(fitting.map(|columns| Aside::Right(width(&columns))));
        asides
    }

    fn draw(&self, drawing: &mut Drawing, _: &Layout, aside: Option<Rect>) {
        if let Some(area) = aside {
            self.draw_in(drawing, area);
        }
    }
}

impl Table {
    /// A table with cells wide enough for all texts.
    pub(super) fn new(mut head: Vec<Heading>, rows: Vec<Cells>) -> Self {
        for row in &rows {
            for (heading, text) in head.iter_mut().zip(&row.texts) {
                heading.width = heading.width.max(text.width(CAPTION));
            }
        }
        Self { head, rows, foot: ([0.0; 2], 0) }
    }

    /// Width of a column with white on both sides, in mm.
    pub(super) fn column(&self) -> f64 {
        let cells: f64 = self.head.iter().map(|heading| heading.width).sum();
        let row = cells + GUTTER * (self.head.len() - 1) as f64;
        row.max(self.foot.0[0]) + 2.0 * PAD
    }

    /// Number of columns in a width, at least one.
    fn columns(&self, width: f64) -> usize {
        let fitting = ((width + 1e-6) / self.column()) as usize;
        fitting.clamp(1, self.rows.len().max(1))
    }

    /// Number of rows in each column, with the foot below the last.
    fn depth(&self, columns: usize) -> usize {
        let foot = self.foot.1;
        (self.rows.len() + foot).div_ceil(columns).max(foot)
    }

    fn height(&self, columns: usize) -> f64 {
        HEAD + ROW * self.depth(columns) as f64 + 2.0 * PAD
    }

    /// Arrangement of the rows in an area, at the usual size if they fit; for far more rows than fit it is smaller.
    fn arrangement(&self, area: Rect) -> Arrangement {
        let mut small = 1.0;
        loop {
            let columns = self.columns(area.width() / small);
            let rows_in = |height: f64| {
                let rows = (height - 2.0 * PAD - HEAD * small) / (ROW * small) + 1e-6;
                rows.max(0.0) as usize
            };
            let depth = rows_in(area.height());
            let last = rows_in(area.height() - self.foot.0[1]).min(depth);
            let fits = depth * (columns - 1) + last >= self.rows.len();
            if fits || small < SMALLEST {
                // Rows are distributed evenly; the last column has the rest.
                let even = (self.rows.len() + depth - last).div_ceil(columns);
                let depth = even.min(depth);
                return Arrangement {
                    columns,
                    depth,
                    last: self.rows.len().saturating_sub(depth * (columns - 1)),
                    small,
                };
            }
            small *= 0.97;
        }
    }

    /// Whether its rows fit into an area at their usual size.
    pub(super) fn fits(&self, area: Rect) -> bool {
        self.column() <= area.width() && self.arrangement(area).small == 1.0
    }

    /// The size of its rows in an area, in parts of their usual size.
    pub(super) fn size_in(&self, area: Rect) -> f64 {
        self.arrangement(area).small
    }

    /// The areas beside or below panels in which all its rows fit at their usual size.
    pub(super) fn asides_at_full_size(&self, room: Rect) -> Vec<Aside> {
        let fits = |aside: &Aside| cut_off(room, *aside).1.is_some_and(|area| self.fits(area));
        self.asides(room).into_iter().filter(fits).collect()
    }

    /// Number of rows that an area holds at their usual size.
    pub(super) fn capacity(&self, area: Rect) -> usize {
        let rows = (area.height() - 2.0 * PAD - HEAD) / ROW + 1e-6;
        let columns = ((area.width() + 1e-6) / self.column()) as usize;
        rows.max(0.0) as usize * columns.max(1)
    }

    /// The upper part of an area that its rows need.
    pub(super) fn needed(&self, area: Rect) -> Rect {
        let height = self.height(self.columns(area.width()));
        Rect::new(area.x0, area.y0, area.x1, (area.y0 + height).min(area.y1))
    }

    /// Draws the table in an area; returns the lower left corner of the foot.
    pub(super) fn draw_in(&self, drawing: &mut Drawing, area: Rect) -> Point {
        drawing.draw(Pen::Frame, Shape::rectangle(area));
        let Arrangement { columns, depth, last, small } = self.arrangement(area);
        let pitch = area.width() / columns as f64;
        let mut left = self.rows.as_slice();
        for column in 0..columns {
            let x = area.x0 + pitch * column as f64;
            if column > 0 {
                let ends = [area.y0, area.y1].map(|y| Point::new(x, y));
                drawing.draw(Pen::Frame, Shape::Line(ends[0], ends[1]));
            }
            let room = if column + 1 < columns { depth } else { last };
            let (rows, later) = left.split_at(room.min(left.len()));
            left = later;
            if rows.is_empty() {
                continue;
            }
            let head = Point::new(x + PAD * small, area.y0 + (PAD + 4.2) * small);
            self.row(drawing, head, small, None);
            let y = area.y0 + (PAD + HEAD - 1.6) * small;
            let ends = [x + PAD * small, x + pitch - PAD * small].map(|x| Point::new(x, y));
            drawing.draw(Pen::Grid, Shape::Line(ends[0], ends[1]));
            for (line, row) in rows.iter().enumerate() {
                let below = PAD + HEAD + ROW * line as f64 + 4.0;
                let at = Point::new(head.x, area.y0 + below * small);
                self.row(drawing, at, small, Some(row));
            }
        }
        Point::new(area.x1 - pitch + PAD, area.y1 - PAD)
    }

    /// Writes a row, or else the headings, from the left end `from` of its baseline.
    fn row(&self, drawing: &mut Drawing, from: Point, small: f64, row: Option<&Cells>) {
        let size = CAPTION * small;
        let (pen, emphasis) = match row {
            Some(row) if row.stands_out => (Pen::Label, Emphasis::New),
            _ => (Pen::Caption, Emphasis::Plain),
        };
        let mut x = from.x;
        for (cell, heading) in self.head.iter().enumerate() {
            let text = row.map_or(&heading.text, |row| &row.texts[cell]);
            let width = heading.width * small;
            let start = if heading.is_right { x + width - text.width(size) } else { x };
            let id = row.map(|row| format!("{}-{}", row.id, heading.name));
            if row.is_some_and(|row| row.boxes.contains(&cell)) {
                let [above, below] = BOX.map(|y| y * small);
                let area = Rect::new(x, from.y - above, x + width, from.y + below);
                drawing.add(Mark { id: id.clone(), ..Mark::new(Pen::Frame, Shape::rectangle(area)) });
            }
            x += width + GUTTER * small;
            if !text.is_empty() {
                let text = PlacedText::new(text.clone(), size, Point::new(start, from.y));
                let since = row.map_or(0, |row| row.since);
                drawing.add(Mark { id, since, emphasis, ..Mark::new(pen, Shape::Text(text)) });
            }
        }
    }
}
