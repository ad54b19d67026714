//! Boxes, lines and the distances between them.

use kurbo::{Point, Rect, Vec2};

/// A line prepared for clipping: its start, the reciprocals of its components, its length.
#[derive(Clone, Copy)]
pub(super) struct Clipped {
    start: Point,
    reciprocal: Vec2,
    pub(super) length: f64,
}

impl Clipped {
    pub(super) fn new((start, end): (Point, Point)) -> Self {
        // A zero component has a huge reciprocal of either sign: the line is then inside a band with all of its length
        // or with none.
        let reciprocal = |run: f64| if run.abs() < 1e-12 { 1e12 } else { 1.0 / run };
        let run = end - start;
        Self { start, reciprocal: Vec2::new(reciprocal(run.x), reciprocal(run.y)), length: run.hypot2().sqrt() }
    }

    /// The share of the line inside a box, between 0 and 1 (Liang and Barsky, "A New Concept and
    /// Method for Line Clipping", 1984).
    pub(super) fn share_inside(&self, area: Rect) -> f64 {
        let (x0, x1) = ((area.x0 - self.start.x) * self.reciprocal.x, (area.x1 - self.start.x) * self.reciprocal.x);
        let (y0, y1) = ((area.y0 - self.start.y) * self.reciprocal.y, (area.y1 - self.start.y) * self.reciprocal.y);
        let enters = greater(greater(lesser(x0, x1), lesser(y0, y1)), 0.0);
        let leaves = lesser(lesser(greater(x0, x1), greater(y0, y1)), 1.0);
        greater(leaves - enters, 0.0)
    }
}

/// `f64::min` for numbers that are not NaN: a single instruction, for the innermost loop.
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// `f64::max` for numbers that are not NaN.
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

pub(super) fn unit(vector: Vec2) -> Option<Vec2> {
    let size = vector.hypot2().sqrt();
    (size > 0.0 && size.is_finite()).then(|| vector / size)
}

/// Whether two boxes overlap or are closer than `gap`.
pub(super) fn touch(a: Rect, b: Rect, gap: f64) -> bool {
    a.x0 < b.x1 + gap && b.x0 < a.x1 + gap && a.y0 < b.y1 + gap && b.y0 < a.y1 + gap
}

pub(super) fn inside(area: Rect, point: Point) -> bool {
    area.x0 <= point.x && point.x <= area.x1 && area.y0 <= point.y && point.y <= area.y1
}

/// The distance of a point from a box; 0 inside.
pub(super) fn gap(area: Rect, point: Point) -> f64 {
    let x = (area.x0 - point.x).max(point.x - area.x1).max(0.0);
    let y = (area.y0 - point.y).max(point.y - area.y1).max(0.0);
    (x * x + y * y).sqrt()
}

/// Whether two lines cross; touching ends do not count.
pub(super) fn cross((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let turn = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}
