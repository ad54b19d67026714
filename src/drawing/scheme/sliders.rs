//! Guides and the blocks on them; the ground: pivots, ground lines and their hatching.

use super::contacts::has_guide;
use super::on_paper::{LinkShape, ON_LINE, SchemeOnPaper, extent, is_on};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::clipped_segment;
use crate::drawing::context::SheetContext;
use crate::drawing::shape::{Shape, corners};
use crate::drawing::sheet::Pen;
use crate::drawing::view::{View, on_sheet, towards};
use crate::mechanism::{Body, BodyId, GROUND, Mark, PointId, SliderId};
use kurbo::{Point, Rect, Vec2};
use std::f64::consts::PI;

/// Half length and half width of a slider block, in mm.
pub(in crate::drawing) const BLOCK: Vec2 = Vec2::new(3.9, 2.2);

/// Half the width of a slot in mm: narrower than a block.
const SLOT: f64 = 1.25;
/// Distance of the edge of a link's area from the line of a slot in it, in mm: that of the slot and white.
const AROUND_SLOT: f64 = SLOT + 1.5;
/// Height of a pivot's triangle, and half the length of the ground line under it, in mm.
const PIVOT: f64 = 4.4;
const PIVOT_HALF: f64 = 4.2;
/// Height of the hatching under a ground line, in mm.
const HATCH: f64 = 1.7;

/// A slot as it is drawn.
pub(in crate::drawing) struct Slot {
    /// The ends of its line.
    pub ends: [Point; 2],
    /// Arms from the points of its link that are off the line.
    pub arms: Vec<[Point; 2]>,
}

/// The slot about a block at `at` on a link with these points; its guide runs `along`, and `reach` is the part of it about the block that
/// is seen. None between points of the link, where the block is on its line.
pub(in crate::drawing) fn slot(
    at: Point,
    along: Vec2,
    reach: [Point; 2],
    points: impl Iterator<Item = Point>,
) -> Option<Slot> {
    let across = Vec2::new(-along.y, along.x);
    let [mut low, mut high] = reach.map(|end| (end - at).dot(along));
    let (on_line, off_line): (Vec<Vec2>, Vec<Vec2>) =
        points.map(|point| point - at).partition(|offset| offset.dot(across).abs() <= ON_LINE);
    let places: Vec<f64> = on_line.iter().map(|offset| offset.dot(along)).collect();
    if places.len() >= 2 && places.iter().any(|&x| x < 0.0) && places.iter().any(|&x| x > 0.0) {
        return None;
    }
    // It begins at the point of its body that is next to the block, where there is one on that side.
    let next = |sign: f64| places.iter().map(|x| sign * x).filter(|x| *x > 0.0).reduce(f64::min);
    let ends = [next(-1.0).map_or(low, |x| -x), next(1.0).unwrap_or(high)].map(|x| at + along * x);
    for place in places {
        (low, high) = (low.min(place), high.max(place));
    }
    let arm = |offset: Vec2| [at + offset, at + along * offset.dot(along).clamp(low, high)];
    Some(Slot { ends, arms: off_line.into_iter().map(arm).collect() })
}

/// A slot between these ends on a link with these points: an arm joins each point of the link to it.
fn slot_with_ends(ends @ [low, high]: [Point; 2], points: impl Iterator<Item = Point>) -> Slot {
    let run = high - low;
    let foot = |point: Point| low + run * ((point - low).dot(run) / run.hypot2()).clamp(0.0, 1.0);
    let arms = points.map(|point| [point, foot(point)]).filter(|[point, foot]| (*point - *foot).hypot() > ON_LINE);
    Slot { ends, arms: arms.collect() }
}

impl SchemeOnPaper<'_> {
    /// The sliders in drawing order: those on the ground are behind.
    pub(super) fn sliders(&self) -> Vec<SliderId> {
        let marks = self.mechanism.joints.iter().flat_map(|joint| joint.marks.iter().copied());
        let blocks = marks.filter_map(|mark| match mark {
            Mark::Block(slider) => Some(slider),
            Mark::Circle { .. } | Mark::Wheel { .. } => None,
        });
        let (back, front): (Vec<SliderId>, Vec<SliderId>) =
            blocks.partition(|&id| self.mechanism.slider(id).on == GROUND);
        [back, front].concat()
    }

    /// Half length and half width of a block in mm, or of the slot about a pin without a block. Of two on one pin the
    /// one behind is larger, so that both are visible.
    pub(super) fn half(&self, id: SliderId) -> Vec2 {
        const BEHIND: f64 = 1.5;
        if self.mechanism.body(self.mechanism.slider(id).link).block {
            return Vec2::new(2.2 * BLOCK.x, self.dims().joint + 0.2);
        }
        let at = |id: SliderId| self.mechanism.slider(id).at;
        let later = self.sliders().into_iter().skip_while(|other| *other != id);
        let is_behind = later.skip(1).any(|other| at(other) == at(id));
        BLOCK * if is_behind { BEHIND } else { 1.0 }
    }

    /// Unit vector from a block to the ground line of its guide: clockwise from the guide's direction (below a
    /// horizontal one), but away from the links at the block.
    pub(super) fn ground_side(&self, id: SliderId) -> Vec2 {
        // Sine of the angle, about 9°, above which a link counts as on one side.
        const CLEARLY: f64 = 0.15;
        let slider = self.mechanism.slider(id);
        let along = on_sheet(self.pose.guide(id));
        let side = Vec2::new(-along.y, along.x);
        let at = self.at(slider.at);
        let mut towards = 0.0;
        for (link, body) in self.mechanism.links() {
            if link != slider.link && body.points.contains(&slider.at) {
                let arms = body.points.iter().map(|&p| self.at(p) - at);
                let arms = arms.filter(|arm| arm.hypot() > 0.0);
                towards += arms.map(|arm| arm.dot(side) / arm.hypot()).sum::<f64>();
            }
        }
        if towards > CLEARLY { -side } else { side }
    }

    /// Draws a guide without its line between points of its body: a slot about the block, connected with these points;
    /// likewise a guide that extends beyond them. It stays on the panel: an arm whose foot would be far off goes to the
    /// guide's end. A link with an area has the slot in it.
    pub(super) fn guide(&self, canvas: &mut Canvas<'_>, id: SliderId) {
        let half = self.half(id);
        let slider = self.mechanism.slider(id);
        if slider.on == GROUND {
            let Some([a, b]) = self.reach_of_guide(id, canvas.room()) else { return };
            ground_line(canvas, [a, b], self.ground_side(id), half.y);
            return;
        }
        let Some(Slot { ends, arms }) = self.slot(id, canvas.room()) else { return };
        if !matches!(self.shape(slider.on), LinkShape::Plate(_)) {
            for [from, to] in arms {
                canvas.draw(Pen::Link, Shape::Line(from, to)).number = self.context.number(slider.on);
            }
        }
        canvas.draw(Pen::Guide, Shape::Polyline(slot_outline(ends))).number = self.context.number(slider.on);
    }

    /// The ends of the part of a guide about its block, within the panel.
    fn reach_of_guide(&self, id: SliderId, room: Rect) -> Option<[Point; 2]> {
        let reach = 3.0 * BLOCK.x;
        let (at, along) = (self.at(self.mechanism.slider(id).at), on_sheet(self.pose.guide(id)));
        // White for the ground line and its hatching beside the block.
        let bounds = room.inset(-(self.half(id).y + HATCH));
        let ends = self.ends_of_guide(id).map(|[low, high]| [low - along * BLOCK.x, high + along * BLOCK.x]);
        let [low, high] = ends.unwrap_or([at - along * reach, at + along * reach]);
        clipped_segment(bounds, low, high).map(|(a, b)| [a, b])
    }

    /// The slot about a block on a link, within the panel; none between points of the link, where the block is on its line.
    fn slot(&self, id: SliderId, room: Rect) -> Option<Slot> {
        let slider = self.mechanism.slider(id);
        let (at, along) = (self.at(slider.at), on_sheet(self.pose.guide(id)));
        let points = || self.mechanism.body(slider.on).points.iter().map(|&point| self.at(point));
        match self.ends_of_guide(id) {
            Some(ends) => Some(slot_with_ends(ends, points())),
            None => slot(at, along, self.reach_of_guide(id, room)?, points()),
        }
    }

    /// The ends of a guide that has some.
    fn ends_of_guide(&self, id: SliderId) -> Option<[Point; 2]> {
        let slider = self.mechanism.slider(id);
        let (travel, at) = (slider.travel?, self.pose.slides[id.0]?);
        Some(travel.map(|end| self.view.at(self.pose.point(slider.at) + self.pose.guide(id) * (end - at))))
    }

    /// The corners around the slots of a link, which its area has room for.
    pub(super) fn corners_of_slots(&self, link: BodyId, room: Rect) -> Vec<Point> {
        let sliders = self.mechanism.slider_ids().filter(|&id| self.mechanism.slider(id).on == link);
        let sliders = sliders.filter(|&id| has_guide(self.mechanism, id));
        let corners = sliders.filter_map(|id| {
            let [a, b] = self.slot(id, room)?.ends;
            let along = towards(a, b, on_sheet(self.pose.guide(id))) * AROUND_SLOT;
            let across = Vec2::new(-along.y, along.x);
            Some([a - along - across, a - along + across, b + along - across, b + along + across])
        });
        corners.flatten().collect()
    }

    /// Draws a block or a slot, and over it the links on its pin.
    pub(super) fn block(&self, canvas: &mut Canvas<'_>, id: SliderId) {
        let slider = self.mechanism.slider(id);
        if self.mechanism.body(slider.link).block && slider.travel.is_some() {
            // A pin in a slot of which the ends are drawn.
            return;
        }
        let half = self.half(id);
        let (at, along) = (self.at(slider.at), on_sheet(self.pose.guide(id)));
        let across = Vec2::new(-along.y, along.x);
        let on_sheet = |p: Point| at + along * p.x + across * p.y;
        let area = Rect::from_center_size(Point::ORIGIN, (2.0 * half.x, 2.0 * half.y));
        let name = format!("slider-{}", self.mechanism.body(slider.link).name);
        let corners = block_corners(at, along, half);
        canvas.draw_named(&name, Pen::Slider, Shape::Polygon(corners)).number = self.context.number(slider.link);
        let others = self.mechanism.links().map(|(link, _)| link);
        for link in others.filter(|&link| link != slider.link && link != slider.on) {
            let lines = self.shape(link).lines();
            for [a, b] in lines.into_iter().filter(|&ends| is_on(ends, at)) {
                let in_block = |p: Point| Point::new((p - at).dot(along), (p - at).dot(across));
                if let Some((a, b)) = clipped_segment(area, in_block(a), in_block(b)) {
                    let bar = Shape::Line(on_sheet(a), on_sheet(b));
                    canvas.draw(Pen::Link, bar).number = self.context.number(link);
                }
            }
        }
    }

    /// Draws a pivot on the ground: below the point, or above it where that is out of the links' way.
    pub(super) fn pivot(&self, canvas: &mut Canvas<'_>, point: PointId) {
        let apex = self.at(point);
        if !self.is_pin(point) {
            return ground_piece(canvas, apex);
        }
        pivot(canvas, apex, self.down(point));
    }

    /// The box around the ground line under a pivot and its hatching.
    pub(super) fn pivot_box(&self, point: PointId) -> Rect {
        pivot_box(self.at(point), self.down(point))
    }

    /// Unit vector from a pivot to its ground: downwards, but upwards where links hang down and none stands up.
    pub(super) fn down(&self, point: PointId) -> Vec2 {
        // Cosine of the largest angle from the vertical at which a link is in the way.
        let steep = libm::cos(50.0_f64.to_radians());
        let links = self.context.facts.holders[point.0].iter().filter(|link| self.context.number(**link).is_some());
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

/// The corners of a block.
pub(in crate::drawing) fn block_corners(at: Point, along: Vec2, half: Vec2) -> Vec<Point> {
    let across = Vec2::new(-along.y, along.x);
    let area = Rect::from_center_size(Point::ORIGIN, (2.0 * half.x, 2.0 * half.y));
    corners(area).map(|p| at + along * p.x + across * p.y).to_vec()
}

/// Draws the ground line of a guide with its hatching, beside a block of this half width.
pub(in crate::drawing) fn ground_line(canvas: &mut Canvas<'_>, [a, b]: [Point; 2], side: Vec2, half: f64) {
    let (a, b) = (a + side * half, b + side * half);
    canvas.draw(Pen::Ground, Shape::Line(a, b));
    hatch(canvas, a, b, side);
    canvas.obstacles.add_boxes(strokes(a, b, side).map(|(from, to)| Rect::from_points(from, to)));
}

/// Draws a fixed point without a link: a piece of the ground with the point on it.
pub(in crate::drawing) fn ground_piece(canvas: &mut Canvas<'_>, apex: Point) {
    let across = Vec2::new(PIVOT_HALF, 0.0);
    let (a, b) = (apex - across, apex + across);
    canvas.draw(Pen::Ground, Shape::Line(a, b));
    hatch(canvas, a, b, Vec2::new(0.0, 1.0));
    canvas.obstacles.add_boxes([Rect::from_points(a, b + Vec2::new(0.0, HATCH))]);
}

/// Draws a pivot's foot; `down` is the unit vector from the pivot to its ground.
pub(in crate::drawing) fn pivot(canvas: &mut Canvas<'_>, apex: Point, down: Vec2) {
    const HALF: f64 = 2.3;
    let base = apex + down * PIVOT;
    let across = Vec2::new(1.0, 0.0);
    let triangle = vec![apex, base - across * HALF, base + across * HALF];
    canvas.draw(Pen::Slider, Shape::Polygon(triangle));
    let (a, b) = (base - across * PIVOT_HALF, base + across * PIVOT_HALF);
    canvas.draw(Pen::Ground, Shape::Line(a, b));
    hatch(canvas, a, b, down);
    canvas.obstacles.add_boxes([pivot_box(apex, down)]);
}

/// The box around the ground line under a pivot and its hatching.
fn pivot_box(apex: Point, down: Vec2) -> Rect {
    let across = Vec2::new(PIVOT_HALF, 0.0);
    Rect::from_points(apex + down * PIVOT - across, apex + down * (PIVOT + HATCH) + across)
}

/// The closed outline of a slot with round ends about this line.
pub(in crate::drawing) fn slot_outline([a, b]: [Point; 2]) -> Vec<Point> {
    const PARTS: usize = 6;
    let along = (b - a).normalize();
    let across = Vec2::new(-along.y, along.x);
    let round = |end: Point, out: Vec2, side: Vec2| {
        (0..=PARTS).map(move |k| {
            let turn = PI * k as f64 / PARTS as f64;
            end + (side * libm::cos(turn) + out * libm::sin(turn)) * SLOT
        })
    };
    let first = b - across * SLOT;
    round(b, along, -across).chain(round(a, -along, across)).chain([first]).collect()
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
