//! Guides and the blocks on them.

use super::super::canvas::{Canvas, clipped_segment};
use super::super::sheet::{Pen, Shape};
use super::super::view::{View, on_sheet};
use super::Scheme;
use super::ground::{HATCH, hatch, strokes};
use crate::geometry::{self, span};
use crate::mechanism::{GROUND, SliderId};
use kurbo::{Rect, Vec2};

/// Half length and half width of a slider block in mm.
pub(super) const BLOCK: Vec2 = Vec2::new(3.9, 2.2);

impl Scheme<'_> {
    /// Places that keep room for guides on the ground.
    pub(super) fn guide_ends(&self) -> impl Iterator<Item = geometry::Point> {
        const SHARE: f64 = 0.06;
        let reach = SHARE * span(self.pose.points.iter().copied());
        let sliders = (0..self.mechanism.sliders.len()).map(SliderId);
        sliders
            .filter(|&id| self.mechanism.slider(id).on == GROUND)
            .flat_map(move |id| {
                let at = self.pose.point(self.mechanism.slider(id).at);
                let arm = self.pose.guide(id) * reach;
                [at - arm, at + arm]
            })
    }

    /// A guide that is no line between its body's points: a line about the block, joined to those
    /// points; so is one that runs on beyond them. It stays on the panel: an arm whose foot would lie far off goes to the guide's end.
    pub(super) fn guide(&self, canvas: &mut Canvas<'_>, view: &View, id: SliderId) {
        const HALF: f64 = 3.0 * BLOCK.x;
        let slider = self.mechanism.slider(id);
        let (at, along) = (self.at(view, slider.at), on_sheet(self.pose.guide(id)));
        let across = Vec2::new(-along.y, along.x);
        // Room for the ground line and its hatching beside the block.
        let bounds = canvas.bounds().inset(-(BLOCK.y + HATCH));
        let Some((a, b)) = clipped_segment(bounds, at - along * HALF, at + along * HALF) else {
            return;
        };
        if slider.on == GROUND {
            let (a, b) = (a + across * BLOCK.y, b + across * BLOCK.y);
            canvas.draw(Pen::Ground, Shape::Line(a, b));
            hatch(canvas, a, b, across);
            for (from, to) in strokes(a, b, across) {
                canvas.keep_off(Rect::from_points(from, to));
            }
            return;
        }
        let (mut low, mut high) = ((a - at).dot(along), (b - at).dot(along));
        let points = &self.mechanism.body(slider.on).points;
        let offsets = points.iter().map(|&point| self.at(view, point) - at);
        let (on_line, off_line): (Vec<Vec2>, Vec<Vec2>) =
            offsets.partition(|offset| offset.dot(across).abs() <= 0.3);
        let places: Vec<f64> = on_line.iter().map(|offset| offset.dot(along)).collect();
        // Between points of its body the block is on the drawn link already.
        if places.len() >= 2 && places.iter().any(|&x| x < 0.0) && places.iter().any(|&x| x > 0.0) {
            return;
        }
        for place in places {
            (low, high) = (low.min(place), high.max(place));
        }
        for offset in off_line {
            let foot = at + along * offset.dot(along).clamp(low, high);
            canvas.draw(Pen::Link, Shape::Line(at + offset, foot));
        }
        let (a, b) = (at + along * low, at + along * high);
        canvas.draw(Pen::Guide, Shape::Line(a, b));
    }

    pub(super) fn block(&self, canvas: &mut Canvas<'_>, view: &View, id: SliderId) {
        let slider = self.mechanism.slider(id);
        let (at, along) = (self.at(view, slider.at), on_sheet(self.pose.guide(id)));
        let across = Vec2::new(-along.y, along.x);
        let corner = |x: f64, y: f64| at + along * (x * BLOCK.x) + across * (y * BLOCK.y);
        let corners = vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        let name = format!("slider-{}", self.mechanism.body(slider.link).name);
        canvas.draw_named(&name, Pen::Slider, Shape::Polygon(corners));
    }
}
