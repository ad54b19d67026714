//! The ground: pivots, ground lines and their hatching.

use super::on_paper::SchemeOnPaper;
use super::sight::extent;
use crate::drawing::canvas::Canvas;
use crate::drawing::context::SheetContext;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::view::View;
use crate::mechanism::{Body, BodyId, GROUND, PointId};
use kurbo::{Point, Rect, Vec2};

/// Height of a pivot's triangle, and half the length of the ground line under it, in mm.
const PIVOT: f64 = 4.4;
const PIVOT_HALF: f64 = 4.2;
/// Height of the hatching under a ground line, in mm.
pub(super) const HATCH: f64 = 1.7;

impl SchemeOnPaper<'_> {
    /// Draws a pivot on the ground: below the point, or above it where that is out of the links' way.
    pub(super) fn pivot(&self, canvas: &mut Canvas<'_>, point: PointId) {
        const HALF: f64 = 2.3;
        let apex = self.at(point);
        if !self.is_pin(point) {
            self.fixed_point(canvas, apex);
            return;
        }
        let down = self.down(point);
        let base = apex + down * PIVOT;
        let across = Vec2::new(1.0, 0.0);
        let triangle = vec![apex, base - across * HALF, base + across * HALF];
        canvas.draw(Pen::Slider, Shape::Polygon(triangle));
        let (a, b) = (base - across * PIVOT_HALF, base + across * PIVOT_HALF);
        canvas.draw(Pen::Ground, Shape::Line(a, b));
        hatch(canvas, a, b, down);
        canvas.keep_off(self.pivot_box(point));
    }

    /// Draws a fixed point without a link: a piece of the ground with the point on it.
    fn fixed_point(&self, canvas: &mut Canvas<'_>, at: Point) {
        let across = Vec2::new(PIVOT_HALF, 0.0);
        canvas.draw(Pen::Ground, Shape::Line(at - across, at + across));
        hatch(canvas, at - across, at + across, Vec2::new(0.0, 1.0));
        canvas.keep_off(Rect::from_points(at - across, at + across + Vec2::new(0.0, HATCH)));
    }

    /// The box around the ground line under a pivot and its hatching.
    pub(super) fn pivot_box(&self, point: PointId) -> Rect {
        let (apex, down) = (self.at(point), self.down(point));
        let across = Vec2::new(PIVOT_HALF, 0.0);
        Rect::from_points(apex + down * PIVOT - across, apex + down * (PIVOT + HATCH) + across)
    }

    /// Unit vector from a pivot to its ground: downwards, but upwards where links hang down and none stands up.
    pub(super) fn down(&self, point: PointId) -> Vec2 {
        // Cosine of the largest angle from the vertical at which a link is in the way.
        let steep = libm::cos(50.0_f64.to_radians());
        let links = self.context.facts.holders[point.0].iter().filter(|link| self.number(**link).is_some());
        let at_pivot: Vec<(BodyId, &Body)> = links.map(|&link| (link, self.mechanism.body(link))).collect();
        let is_at_pivot = |link: BodyId| at_pivot.iter().any(|(id, _)| *id == link);
        let blocks = self.mechanism.sliders.iter().filter(|s| is_at_pivot(s.on));
        let places = at_pivot.iter().flat_map(|(_, body)| &body.points).copied();
        let places = places.chain(blocks.map(|slider| slider.at));
        let arms = places.map(|other| self.at(other) - self.at(point));
        let arms = arms.filter(|arm| arm.hypot() > 0.0);
        let downwards: Vec<f64> = arms.map(|arm| arm.y / arm.hypot()).collect();
        let hang = downwards.iter().any(|&y| y > steep);
        let stand = downwards.iter().any(|&y| y < -steep);
        Vec2::new(0.0, if hang && !stand { -1.0 } else { 1.0 })
    }
}

/// Hatches a ground line on the side of `away`.
pub(super) fn hatch(canvas: &mut Canvas<'_>, a: Point, b: Point, away: Vec2) {
    for (from, to) in strokes(a, b, away) {
        canvas.draw(Pen::Hatch, Shape::Line(from, to));
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

/// White that supports above their pivots need between a panel's heading and the mechanism, in mm.
pub(in crate::drawing) fn above(context: &SheetContext<'_>) -> f64 {
    let view = View::new(1.0, &extent(context), Rect::ZERO);
    let scheme = SchemeOnPaper::new(context, &view);
    let mut fixed = scheme.mechanism.body(GROUND).points.iter();
    if fixed.any(|&point| scheme.is_pin(point) && scheme.down(point).y < 0.0) { 2.0 } else { 0.0 }
}
