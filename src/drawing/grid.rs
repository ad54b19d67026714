//! Where things lie on a panel: a grid that finds what is near without looking at everything; and what marks and labels of
//! a panel keep off.
//!
//! A tree of boxes (as in the crate `rstar`) would find less well here: rays cross a whole panel aslant, so that their
//! boxes all overlap, and labels move often. A grid takes lines cell by cell, and a move costs a few cells.

use super::shape::{crosses_line, distance_to_box};
use super::text::{ABOVE, BESIDE};
use kurbo::{Line, ParamCurveNearest, Point, Rect};
use smallvec::SmallVec;
use std::cell::RefCell;

/// Width and height of a cell in mm, about those of a name.
const CELL: f64 = 4.0;
/// Most columns and rows; on larger areas cells are larger.
const MOST: f64 = 256.0;
/// Lines that go farther out, in mm, are looked at wherever one looks: where exactly they cross a cell is lost in
/// rounding.
const FAR: f64 = 1e6;
/// White around a line's cells, in mm, against rounding.
const SLACK: f64 = 1e-3;
/// White around a label's ink that no line enters, at least and at most, in mm.
pub(super) const STRIKE: [f64; 2] = [0.4, 0.6];
/// Least white between a label's ink and a box, in mm.
pub(super) const BOX_GAP: f64 = 0.3;

/// The numbers of things by the cells that they touch.
///
/// Things outside the area belong to the cells at its edge, so they are found, too, but less quickly.
#[derive(Clone, Debug)]
pub struct Grid {
    origin: Point,
    /// Width and height of its cells.
    cell: [f64; 2],
    columns: usize,
    rows: usize,
    /// By cell: the things in it; few have more than four.
    cells: Vec<SmallVec<[u32; 4]>>,
    everywhere: Vec<u32>,
    seen: RefCell<Seen>,
}

/// What a search has found already.
#[derive(Clone, Debug, Default)]
struct Seen {
    search: u32,
    /// By thing: the last search that found it.
    last: Vec<u32>,
}

impl Grid {
    /// A grid without things over an area.
    pub fn new(area: Rect) -> Self {
        // One for a length that is no number.
        let count = |length: f64| if length.is_nan() { 1.0 } else { (length / CELL).ceil().clamp(1.0, MOST) };
        let (columns, rows) = (count(area.width()), count(area.height()));
        let cell = [(area.width() / columns).max(CELL), (area.height() / rows).max(CELL)];
        let (origin, columns, rows) = (area.origin(), columns as usize, rows as usize);
        let cells = std::iter::repeat_with(SmallVec::new).take(columns * rows).collect();
        Self { origin, cell, columns, rows, cells, everywhere: Vec::new(), seen: RefCell::default() }
    }

    /// The column of a place; that at the edge outside, the first for a NaN.
    fn column(&self, x: f64) -> usize {
        (((x - self.origin.x) / self.cell[0]) as usize).min(self.columns - 1)
    }

    fn row(&self, y: f64) -> usize {
        (((y - self.origin.y) / self.cell[1]) as usize).min(self.rows - 1)
    }

    /// The cells that a box touches.
    fn cells_of(&self, area: Rect) -> impl Iterator<Item = usize> + use<> {
        let (first, last) = (self.column(area.x0), self.column(area.x1));
        let columns = self.columns;
        (self.row(area.y0)..=self.row(area.y1)).flat_map(move |row| row * columns + first..=row * columns + last)
    }

    /// How many cells a box touches.
    pub(super) fn cell_count(&self, area: Rect) -> usize {
        let columns = self.column(area.x1).saturating_sub(self.column(area.x0)) + 1;
        columns * (self.row(area.y1).saturating_sub(self.row(area.y0)) + 1)
    }

    /// Adds a thing in a box.
    pub fn add(&mut self, thing: usize, area: Rect) {
        for cell in self.cells_of(area) {
            self.cells[cell].push(thing as u32);
        }
    }

    /// The things in a cell, the last one first.
    fn within(&self, cell: usize) -> impl Iterator<Item = usize> {
        self.cells[cell].iter().rev().map(|thing| *thing as usize)
    }

    /// Takes a thing out of a box.
    pub fn remove(&mut self, thing: usize, area: Rect) {
        for cell in self.cells_of(area) {
            let things = &mut self.cells[cell];
            if let Some(index) = things.iter().rposition(|other| *other == thing as u32) {
                things.swap_remove(index);
            }
        }
    }

    /// Adds a straight line.
    pub fn add_line(&mut self, thing: usize, line: (Point, Point)) {
        if !is_near(line) {
            self.everywhere.push(thing as u32);
            return;
        }
        for cell in self.cells_along(line) {
            self.cells[cell].push(thing as u32);
        }
    }

    /// The cells that a straight line touches, row by row.
    fn cells_along(&self, (from, to): (Point, Point)) -> impl Iterator<Item = usize> + use<> {
        let (high, low) = if from.y <= to.y { (from, to) } else { (to, from) };
        let run = low - high;
        let at =
            move |y: f64| if run.y > 0.0 { high.x + run.x * ((y - high.y) / run.y).clamp(0.0, 1.0) } else { high.x };
        let (first, last) = (self.row(high.y - SLACK), self.row(low.y + SLACK));
        let ranges: SmallVec<[(usize, usize); 16]> = (first..=last)
            .map(|row| {
                // The part of the line in this row; beyond the grid's edge all of it.
                let edge = |row: usize| self.origin.y + row as f64 * self.cell[1];
                let upper = if row == 0 { high.y } else { edge(row) - SLACK };
                let lower = if row + 1 == self.rows { low.y } else { edge(row + 1) + SLACK };
                let (a, b) = if run.y > 0.0 { (at(upper), at(lower)) } else { (from.x, to.x) };
                let columns = (self.column(a.min(b) - SLACK), self.column(a.max(b) + SLACK));
                (row * self.columns + columns.0, row * self.columns + columns.1)
            })
            .collect();
        ranges.into_iter().flat_map(|(first, last)| first..=last)
    }

    /// Whether something near a box satisfies `is`; a thing may be asked for twice.
    pub(super) fn any(&self, area: Rect, mut is: impl FnMut(usize) -> bool) -> bool {
        // Plain loops: most of the time of a search for places is spent here.
        for thing in &self.everywhere {
            if is(*thing as usize) {
                return true;
            }
        }
        let (first, last) = (self.column(area.x0), self.column(area.x1));
        for row in self.row(area.y0)..=self.row(area.y1) {
            let start = row * self.columns;
            for cell in self.cells.get(start + first..=start + last).unwrap_or_default() {
                for thing in cell.iter().rev() {
                    if is(*thing as usize) {
                        return true;
                    }
                }
            }
        }
        false
    }

    /// What is near a box, in rising order, each once; at least all that touches it.
    pub fn near(&self, area: Rect) -> Vec<usize> {
        self.some_near(area, usize::MAX, |_| true)
    }

    /// The things near a box that `is` holds for, in rising order, each once; of a crowd any `most`, without a look at the others.
    pub(super) fn some_near(&self, area: Rect, most: usize, is: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut found = Vec::new();
        self.each_in(self.cells_of(area), |thing| {
            if is(thing) {
                found.push(thing);
            }
            found.len() < most
        });
        found.sort_unstable();
        found
    }

    /// Looks at what is near a straight line, each once; at least at all that touches it.
    fn each_along(&self, line: (Point, Point), mut look: impl FnMut(usize)) {
        let look = |thing| {
            look(thing);
            true
        };
        if is_near(line) {
            self.each_in(self.cells_along(line), look);
        } else {
            self.each_in(self.cells_of(Rect::from_points(line.0, line.1)), look);
        }
    }

    /// Looks at the things in some cells and at those everywhere, each once, as long as `look` wants to go on.
    fn each_in(&self, cells: impl Iterator<Item = usize>, mut look: impl FnMut(usize) -> bool) {
        if !self.everywhere.iter().all(|thing| look(*thing as usize)) {
            return;
        }
        let mut seen = self.seen.borrow_mut();
        let Seen { search, last } = &mut *seen;
        *search += 1;
        for cell in cells {
            for thing in self.within(cell) {
                if last.len() <= thing {
                    last.resize(thing + 1, 0);
                }
                if std::mem::replace(&mut last[thing], *search) != *search && !look(thing) {
                    return;
                }
            }
        }
    }
}

/// Whether a line is so near that its cells can be told.
fn is_near((from, to): (Point, Point)) -> bool {
    let is_near = |point: Point| (point.x.abs() < FAR) & (point.y.abs() < FAR);
    is_near(from) && is_near(to)
}

/// What labels keep off, in the order in which it came, and grids that find what is near.
#[derive(Clone, Debug)]
pub struct Obstacles {
    /// Joints, arrowheads, boxes: never touched.
    pub boxes: Vec<Rect>,
    /// Lines: no label stands on one as long as another place is free.
    pub lines: Vec<(Point, Point)>,
    /// The panel: no label leaves it.
    pub bounds: Rect,
    /// White around a label's ink that no line enters, in mm: half the width of a line.
    pub strike: f64,
    /// By box: the ink of the text that it keeps white, if it does.
    inks: Vec<Option<Rect>>,
    grid_of_boxes: Grid,
    grid_of_lines: Grid,
}

impl Obstacles {
    /// A panel without obstacles.
    pub fn new(bounds: Rect) -> Self {
        let (grid_of_boxes, grid_of_lines) = (Grid::new(bounds), Grid::new(bounds));
        Self {
            boxes: Vec::new(),
            lines: Vec::new(),
            bounds,
            strike: STRIKE[0],
            inks: Vec::new(),
            grid_of_boxes,
            grid_of_lines,
        }
    }

    /// Adds boxes that nothing may touch.
    pub fn add_boxes(&mut self, areas: impl IntoIterator<Item = Rect>) {
        areas.into_iter().for_each(|area| self.add_box(area, None));
    }

    fn add_box(&mut self, area: Rect, ink: Option<Rect>) {
        self.grid_of_boxes.add(self.boxes.len(), area);
        self.boxes.push(area);
        self.inks.push(ink);
    }

    /// Adds texts, from which other texts keep as much white as two texts need.
    pub(super) fn add_texts(&mut self, inks: impl IntoIterator<Item = Rect>) {
        inks.into_iter().for_each(|ink| self.add_box(ink.inflate(BESIDE - BOX_GAP, ABOVE - BOX_GAP), Some(ink)));
    }

    /// Adds lines that labels cross only where there is no other place.
    pub fn add_lines(&mut self, lines: impl IntoIterator<Item = (Point, Point)>) {
        for line in lines {
            self.grid_of_lines.add_line(self.lines.len(), line);
            self.lines.push(line);
        }
    }

    /// Whether a box near `area` satisfies `is`.
    pub(super) fn any_box(&self, area: Rect, mut is: impl FnMut(Rect) -> bool) -> bool {
        self.grid_of_boxes.any(area, |index| is(self.boxes[index]))
    }

    /// The boxes near `area`, in the order in which they came.
    pub(super) fn boxes_near(&self, area: Rect) -> impl Iterator<Item = Rect> {
        self.grid_of_boxes.near(area).into_iter().map(|index| self.boxes[index])
    }

    /// Looks at the boxes along a line, each once, without the white around texts; and whether it is a text's.
    pub(super) fn each_box_along(&self, line: (Point, Point), mut look: impl FnMut(Rect, bool)) {
        self.grid_of_boxes.each_along(line, |index| {
            let ink = self.inks[index];
            look(ink.unwrap_or(self.boxes[index]), ink.is_some());
        });
    }

    /// Looks at the lines along a line, each once.
    pub(super) fn each_line_along(&self, line: (Point, Point), mut look: impl FnMut((Point, Point))) {
        self.grid_of_lines.each_along(line, |index| look(self.lines[index]));
    }

    /// The lines near `area` that `is` holds for by their numbers, in rising order; of a crowd any `most`.
    pub(super) fn lines_near(&self, area: Rect, most: usize, is: impl Fn(usize) -> bool) -> Vec<usize> {
        self.grid_of_lines.some_near(area, most, is)
    }

    /// Whether the number of a line near `area` satisfies `is`.
    pub(super) fn any_line(&self, area: Rect, is: impl FnMut(usize) -> bool) -> bool {
        self.grid_of_lines.any(area, is)
    }

    /// Number of obstacles, lines and boxes, that a short segment crosses.
    pub(super) fn crossings_with(&self, from: Point, to: Point) -> usize {
        let area = Rect::from_points(from, to);
        let lines = self.lines_near(area, usize::MAX, |index| crosses_line(self.lines[index], (from, to)));
        lines.len() + self.boxes_near(area).filter(|other| other.overlaps(area)).count()
    }

    /// Whether a box overlaps one of the boxes.
    pub(super) fn overlaps(&self, area: Rect) -> bool {
        self.any_box(area, |other| other.overlaps(area))
    }

    /// Whether a circle is off all of them.
    pub(super) fn is_free(&self, centre: Point, radius: f64) -> bool {
        let is_on_line = |index: usize| {
            let (a, b) = self.lines[index];
            Line::new(a, b).nearest(centre, 1e-3).distance_sq <= radius * radius
        };
        let around = Rect::from_center_size(centre, (2.0 * radius, 2.0 * radius)).inflate(1e-6, 1e-6);
        !self.any_line(around, is_on_line) && !self.any_box(around, |area| distance_to_box(area, centre) <= radius)
    }
}
