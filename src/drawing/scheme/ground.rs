//! The ground: pivots, ground lines and their hatching.

use super::super::canvas::Canvas;
use super::super::sheet::{Pen, Shape};
use super::Scheme;
use kurbo::{Point, Rect, Vec2};

/// Height of a pivot's triangle, and half the length of the ground line under it, in mm.
const PIVOT: f64 = 4.4;
const PIVOT_HALF: f64 = 4.2;
/// How far the strokes under a ground line reach, in mm.
pub(super) const HATCH: f64 = 1.7;

impl Scheme<'_> {
    /// A pivot on the ground.
    pub(super) fn pivot(&self, canvas: &mut Canvas<'_>, apex: Point) {
        const HALF: f64 = 2.3;
        let base = apex.y + PIVOT;
        let triangle = vec![
            apex,
            Point::new(apex.x - HALF, base),
            Point::new(apex.x + HALF, base),
        ];
        canvas.draw(Pen::Slider, Shape::Polygon(triangle));
        let (a, b) = (
            Point::new(apex.x - PIVOT_HALF, base),
            Point::new(apex.x + PIVOT_HALF, base),
        );
        canvas.draw(Pen::Ground, Shape::Line(a, b));
        hatch(canvas, a, b, Vec2::new(0.0, 1.0));
        canvas.keep_off(pivot_box(apex));
    }
}

/// The ground line under a pivot and its hatching.
pub(super) fn pivot_box(apex: Point) -> Rect {
    let base = apex.y + PIVOT;
    Rect::new(apex.x - PIVOT_HALF, base, apex.x + PIVOT_HALF, base + HATCH)
}

/// Hatches a ground line on the side of `away`.
pub(super) fn hatch(canvas: &mut Canvas<'_>, a: Point, b: Point, away: Vec2) {
    for (from, to) in strokes(a, b, away) {
        canvas.drawing.draw(Pen::Hatch, Shape::Line(from, to));
    }
}

/// Short strokes along a ground line, on the side of `away`.
pub(super) fn strokes(a: Point, b: Point, away: Vec2) -> impl Iterator<Item = (Point, Point)> {
    const SPACING: f64 = 1.4;
    let run = b - a;
    let count = (run.hypot() / SPACING).round().max(1.0);
    let along = run / run.hypot();
    (0..count as usize).map(move |k| {
        let from = a + run * ((k as f64 + 0.75) / count);
        (from, from + away * HATCH - along * HATCH)
    })
}
