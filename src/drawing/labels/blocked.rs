//! Where obstacles leave no place for a label: sums over small cells, which rule out most places of a search at once.

use kurbo::{Point, Rect};

use super::super::clip::clipped_segment;
use super::super::grid::Obstacles;

/// Width and height of a cell, in mm.
const CELL: f64 = 1.0;
/// Most columns and rows; what lies beyond is not ruled out here.
const MOST: f64 = 500.0;

/// The cells of a panel in which obstacles lie.
pub(super) struct Blocked {
    origin: Point,
    columns: usize,
    rows: usize,
    /// By corner of the cells: how many blocked ones are above it and to the left.
    sums: Vec<u32>,
}

impl Blocked {
    pub(super) fn new(obstacles: &Obstacles) -> Blocked {
        let bounds = obstacles.bounds;
        let count = |length: f64| (length / CELL).floor().clamp(0.0, MOST) as usize;
        let (columns, rows) = (count(bounds.width()), count(bounds.height()));
        let mut blocked = vec![false; columns * rows];
        let area = Rect::from_origin_size(bounds.origin(), (CELL * columns as f64, CELL * rows as f64));
        // The cells from one place to another, those at the ends only if more than their edge is touched.
        let cells = |from: f64, to: f64, most: usize| {
            let first = (from / CELL).floor().max(0.0) as usize;
            first..((to / CELL).ceil().max(0.0) as usize).min(most)
        };
        for other in obstacles.boxes.iter().map(|other| other.intersect(area)).filter(|other| other.area() > 0.0) {
            let other = other - area.origin().to_vec2();
            for row in cells(other.y0, other.y1, rows) {
                for column in cells(other.x0, other.x1, columns) {
                    blocked[row * columns + column] = true;
                }
            }
        }
        for (from, to) in obstacles.lines.iter().filter_map(|(from, to)| clipped_segment(area, *from, *to)) {
            let [from, to] = [from, to].map(|end| end - area.origin());
            // By their middles parts shorter than a cell are in a cell for certain.
            let parts = (2.0 * (to - from).hypot() / CELL).ceil();
            for part in 0..parts as usize {
                let middle = from + (to - from) * ((part as f64 + 0.5) / parts);
                let (column, row) = ((middle.x / CELL) as usize, (middle.y / CELL) as usize);
                let off_edge = |place: f64| (place / CELL - (place / CELL).round()).abs() > 1e-6;
                if column < columns && row < rows && off_edge(middle.x) && off_edge(middle.y) {
                    blocked[row * columns + column] = true;
                }
            }
        }
        let mut sums = vec![0; (columns + 1) * (rows + 1)];
        for row in 0..rows {
            let mut in_row = 0;
            for column in 0..columns {
                in_row += u32::from(blocked[row * columns + column]);
                sums[(row + 1) * (columns + 1) + column + 1] = sums[row * (columns + 1) + column + 1] + in_row;
            }
        }
        Blocked { origin: area.origin(), columns, rows, sums }
    }

    /// Whether an obstacle lies in a box for certain; else one may.
    pub(super) fn is_certain(&self, area: Rect) -> bool {
        let whole = |from: f64, to: f64, most: usize| {
            // Rounded up and down without the library's functions: this is asked for every place of a panel.
            let (from, to) = ((from / CELL).max(0.0), (to / CELL).max(0.0));
            let first = from as usize;
            (first + usize::from(from > first as f64), (to as usize).min(most))
        };
        let (left, right) = whole(area.x0 - self.origin.x, area.x1 - self.origin.x, self.columns);
        let (top, bottom) = whole(area.y0 - self.origin.y, area.y1 - self.origin.y, self.rows);
        if left >= right || top >= bottom {
            return false;
        }
        let sum = |row: usize, column: usize| self.sums[row * (self.columns + 1) + column];
        sum(bottom, right) + sum(top, left) > sum(bottom, left) + sum(top, right)
    }
}
