//! What marks and labels of a panel keep off.

use super::grid::Grid;
use super::shape::{crosses_line, distance_to_box, overlap};
use kurbo::{Line, ParamCurveNearest, Point, Rect};

/// What labels keep off, in the order in which it came, and grids that find what is near.
#[derive(Clone, Debug)]
pub struct Obstacles {
    /// Joints, arrowheads, boxes: never touched.
    pub boxes: Vec<Rect>,
    /// Lines: crossing one costs by the length inside the label's box.
    pub lines: Vec<(Point, Point)>,
    /// The panel: no label leaves it.
    pub bounds: Rect,
    grid_of_boxes: Grid,
    grid_of_lines: Grid,
}

impl Obstacles {
    /// A panel without obstacles.
    pub fn new(bounds: Rect) -> Self {
        let (grid_of_boxes, grid_of_lines) = (Grid::new(bounds), Grid::new(bounds));
        Self { boxes: Vec::new(), lines: Vec::new(), bounds, grid_of_boxes, grid_of_lines }
    }

    /// Adds boxes that nothing may touch.
    pub fn add_boxes(&mut self, areas: impl IntoIterator<Item = Rect>) {
        for area in areas {
            self.grid_of_boxes.add(self.boxes.len(), area);
            self.boxes.push(area);
        }
    }

    /// Adds lines that labels cross only where there is no better place.
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

    /// The lines near `area` by their numbers, in rising order.
    pub(super) fn lines_near(&self, area: Rect) -> Vec<usize> {
        self.grid_of_lines.near(area)
    }

    /// Whether the number of a line near `area` satisfies `is`.
    pub(super) fn any_line(&self, area: Rect, is: impl FnMut(usize) -> bool) -> bool {
        self.grid_of_lines.any(area, is)
    }

    /// Number of obstacles, lines and boxes, that a short segment crosses.
    pub(super) fn crossings_with(&self, from: Point, to: Point) -> usize {
        let area = Rect::from_points(from, to);
        let lines = self.lines_near(area).into_iter().filter(|index| crosses_line(self.lines[*index], (from, to)));
        lines.count() + self.boxes_near(area).filter(|other| other.overlaps(area)).count()
    }

    /// Whether a box overlaps one of the boxes.
    pub(super) fn overlaps(&self, area: Rect) -> bool {
        self.any_box(area, |other| overlap(other, area))
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
