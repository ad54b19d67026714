//! What marks and labels of a panel keep off.

use super::grid::Grid;
use super::shape::overlap;
use kurbo::{Line, ParamCurveNearest, Point, Rect};

/// Obstacles for labels.
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacles {
    /// Joints, arrowheads, boxes: never touched.
    pub boxes: Vec<Rect>,
    /// Lines: crossing one costs by the length inside the label's box.
    pub lines: Vec<(Point, Point)>,
    /// The panel: no label leaves it.
    pub bounds: Rect,
}

/// The obstacles of a panel, and where they lie.
#[derive(Clone, Debug)]
pub(super) struct Taken {
    all: Obstacles,
    boxes: Grid,
    lines: Grid,
}

impl Taken {
    pub(super) fn new(bounds: Rect) -> Self {
        let all = Obstacles { boxes: Vec::new(), lines: Vec::new(), bounds };
        Self { all, boxes: Grid::new(bounds), lines: Grid::new(bounds) }
    }
    pub(super) fn of(obstacles: &Obstacles) -> Self {
        let mut taken = Self::new(obstacles.bounds);
        taken.add_boxes(obstacles.boxes.iter().copied());
        taken.add_lines(obstacles.lines.iter().copied());
        taken
    }

    /// All obstacles, in the order in which they came.
    pub(super) fn all(&self) -> &Obstacles {
        &self.all
    }
    pub(super) fn add_box(&mut self, area: Rect) {
        self.boxes.add(self.all.boxes.len(), area);
        self.all.boxes.push(area);
    }
    pub(super) fn add_boxes(&mut self, areas: impl IntoIterator<Item = Rect>) {
        areas.into_iter().for_each(|area| self.add_box(area));
    }
    pub(super) fn add_lines(&mut self, lines: impl IntoIterator<Item = (Point, Point)>) {
        for line in lines {
            self.lines.add_line(self.all.lines.len(), line);
            self.all.lines.push(line);
        }
    }

    /// Whether a box near `area` satisfies `is`.
    pub(super) fn any_box(&self, area: Rect, mut is: impl FnMut(Rect) -> bool) -> bool {
        self.boxes.any(area, |index| is(self.all.boxes[index]))
    }

    /// The boxes near `area`, in the order in which they came.
    pub(super) fn boxes_near(&self, area: Rect) -> impl Iterator<Item = Rect> {
        self.boxes.near(area).into_iter().map(|index| self.all.boxes[index])
    }

    /// The lines near `area` by their numbers, in rising order.
    pub(super) fn lines_near(&self, area: Rect) -> Vec<usize> {
        self.lines.near(area)
    }

    /// Whether the number of a line near `area` satisfies `is`.
    pub(super) fn any_line(&self, area: Rect, is: impl FnMut(usize) -> bool) -> bool {
        self.lines.any(area, is)
    }

    /// Number of obstacles, lines and boxes, that a short segment crosses.
    pub(super) fn crossings_with(&self, from: Point, to: Point) -> usize {
        let side = |a: Point, b: Point, p: Point| (b - a).cross(p - a);
        let crosses = |&index: &usize| {
            let (a, b) = self.all.lines[index];
            side(a, b, from) * side(a, b, to) < 0.0 && side(from, to, a) * side(from, to, b) < 0.0
        };
        let segment_box = Rect::from_points(from, to);
        let lines = self.lines_near(segment_box).iter().filter(|index| crosses(index)).count();
        lines + self.boxes_near(segment_box).filter(|area| area.overlaps(segment_box)).count()
    }

    /// Whether a box overlaps one of the boxes.
    pub(super) fn overlaps(&self, area: Rect) -> bool {
        self.any_box(area, |other| overlap(other, area))
    }

    /// Whether a circle is off all of them.
    pub(super) fn is_free(&self, centre: Point, radius: f64) -> bool {
        let far = radius * radius;
        let is_on_line = |index: usize| {
            let (a, b) = self.all.lines[index];
            Line::new(a, b).nearest(centre, 1e-3).distance_sq <= far
        };
        let is_on_box = |area: Rect| {
            let nearest = Point::new(centre.x.clamp(area.x0, area.x1), centre.y.clamp(area.y0, area.y1));
            (nearest - centre).hypot2() <= far
        };
        let around = Rect::from_center_size(centre, (2.0 * radius, 2.0 * radius)).inflate(1e-6, 1e-6);
        !self.lines.any(around, is_on_line) && !self.any_box(around, is_on_box)
    }
}
