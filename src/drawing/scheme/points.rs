//! Joints and special points, the cut lines that cross there, and the names of points and links.

use super::on_paper::{LinkShape, SchemeOnPaper, is_near};
use super::sliders::BLOCK;
use crate::construction::{Special, display};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{clipped_segment, holds};
use crate::drawing::grid::Obstacles;
use crate::drawing::labels::LabelRequest;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::RichText;
use crate::drawing::view::{on_sheet, towards};
use crate::geometry::Place;
use crate::mechanism::{BodyId, GROUND, PointId, Role, Slider, SliderId};
use crate::scene::FrameName;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Rect, Vec2};

/// Number style of the distances of special points far away.
const DISTANCE: NumberStyle = NumberStyle::significant(4).in_full(-3, 6).on(Medium::Figure);
/// Side of the sign of a right angle, in mm.
const RIGHT_ANGLE: f64 = 2.4;

impl SchemeOnPaper<'_> {
    /// Draws circles at pins, dots at other points, and the labels of those that are named.
    pub(super) fn joints(&self, canvas: &mut Canvas<'_>, is_named: impl Fn(PointId) -> bool) {
        let mut named = Obstacles::new(canvas.obstacles.bounds);
        for point in self.mechanism.point_ids() {
            let center = self.at(point);
            let slides = self.context.facts.slides[point.0];
            let name = self.mechanism.point_name(point);
            let (pen, radius) = match self.is_pin(point) {
                true => (Pen::Joint, self.dims().joint),
                false => (Pen::ImagePoint, self.dims().dot * (0.5 / 0.45)),
            };
            canvas.draw_named(&format!("point-{name}"), pen, Shape::Circle { center, radius });
            let clearance = if slides { BLOCK.y + 0.8 } else { self.dims().joint + 0.9 };
            // Of two coincident points the second has the lower priority.
            let twin = distance(&named, center, 0.3).is_some_and(|distance| distance < 0.3);
            let priority = if twin { 1 } else { 2 };
            named.add_boxes([Rect::from_points(center, center)]);
            if !is_named(point) {
                continue;
            }
            canvas.label(name, &display(name), center, clearance, self.outward(center), priority);
        }
    }

    /// Draws the links' labels: inside areas, beside lines where there is most room.
    pub(super) fn link_names(&self, canvas: &mut Canvas<'_>) {
        /// Room beside a link's name, in mm.
        const ROOM: f64 = 8.0;
        let mut joints = Obstacles::new(canvas.obstacles.bounds);
        let places = self.pose.points.iter().map(|&point| self.view.at(point));
        joints.add_boxes(places.map(|place| Rect::from_points(place, place)));
        for (id, body) in self.mechanism.links() {
            if body.role == Role::Unsolved {
                continue;
            }
            let (anchor, clearance, prefer) = match self.shape(id) {
                LinkShape::Bars(bars) => {
                    let [a, b] = bars[bars.len() - 1];
                    let free = |share: f64| distance(&joints, a.lerp(b, share), ROOM).unwrap_or(f64::INFINITY);
                    let shares = [0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78];
                    // The middle, unless a joint is nearby.
                    let good = shares.into_iter().find(|&s| free(s) > ROOM);
                    let best = |x: &f64, y: &f64| free(*x).total_cmp(&free(*y));
                    let share = good.or_else(|| shares.into_iter().max_by(best));
                    let anchor = a.lerp(b, share.unwrap_or(0.5));
                    (anchor, 1.3, Some(self.outer_side([a, b], anchor)))
                }
                LinkShape::Nothing => match self.place_of_small(id) {
                    Some(place) => place,
                    None => continue,
                },
                LinkShape::Plate(corners) => {
                    let sum = corners.iter().fold(Vec2::ZERO, |s, p| s + p.to_vec2());
                    ((sum / corners.len() as f64).to_point(), 0.0, None)
                }
            };
            let number = self.context.number(id);
            let label = canvas.label(&body.name, &body.name, anchor, clearance, prefer, 1);
            label.number = number;
            if self.mechanism.is_equivalent(id) {
                let whole = self.context.words.language.equivalent(&self.context.shown(&body.name, None));
                label.short = Some(std::mem::replace(&mut label.request.text, RichText::math(&whole)));
            }
        }
        if let Some(&first) = self.mechanism.body(GROUND).points.first() {
            let name = self.mechanism.body(GROUND).name.as_str();
            let number = self.context.words.notation.frame.map_or("", FrameName::as_str);
            let shown = canvas.shown(name, number);
            if !shown.is_empty() {
                let anchor = self.at(first) + Vec2::new(0.0, 6.0);
                canvas.label(name, &shown, anchor, 1.5, Some(Vec2::new(0.0, 1.0)), 1);
            }
        }
    }

    /// Place, clearance and preferred side of the label of a link with fewer than two points: beside its block or its
    /// guide.
    fn place_of_small(&self, link: BodyId) -> Option<(Point, f64, Option<Vec2>)> {
        let belongs = |s: &Slider| s.link == link || s.on == link;
        let index = self.mechanism.sliders.iter().position(belongs)?;
        let slider = &self.mechanism.sliders[index];
        let at = self.at(slider.at);
        let along = on_sheet(self.pose.guide(SliderId(index)));
        if slider.link != link {
            // Between its only point and the block, if there is room.
            let only_point = self.mechanism.body(link).points.first();
            let only_point = only_point.map(|&point| self.at(point));
            if let Some(only_point) = only_point.filter(|only_point| (*only_point - at).hypot() > 5.0 * BLOCK.x) {
                return Some((only_point.midpoint(at), 1.0, None));
            }
            return Some((at + along * (2.4 * BLOCK.x), 1.0, None));
        }
        // At an end of the block on the ground, else beside the guide, on the side with fewer lines.
        let half = self.half(SliderId(index));
        let (side, half) = match slider.on {
            GROUND => (along, half.x),
            _ => (Vec2::new(-along.y, along.x), half.y),
        };
        let mut lines = self.directions(slider.at);
        if self.mechanism.body(GROUND).points.contains(&slider.at) {
            lines.push(self.down(slider.at));
        }
        let taken: f64 = lines.iter().map(|line| line.dot(side)).sum();
        let side = if taken > 0.0 { -side } else { side };
        Some((at, half + 0.8, Some(side)))
    }

    /// The cut lines of a special point, from their joints to it.
    pub(super) fn cuts(&self, canvas: &mut Canvas<'_>, special: &Special) {
        if !self.context.figure().construction.has_lines() {
            return;
        }
        let bounds = canvas.room();
        for cut in &special.cuts {
            let (Some(start), Some(direction)) = (cut.start(), cut.line.direction()) else {
                continue;
            };
            let from = self.at(start);
            // For a distant special point the cut line runs towards it to the panel's edge.
            let to = match special.place {
                Place::At(place) => self.view.at(place),
                Place::AtInfinity(_) => from + on_sheet(direction) * (bounds.width() + bounds.height()),
            };
            let name = format!("cut-{}-{}", special.name, self.mechanism.point_name(start));
            // A special point may coincide with the joint.
            let towards_special = towards(from, to, on_sheet(direction));
            let end = if self.shows(canvas, special) { to + towards_special * 3.0 } else { to };
            if let Some((a, b)) = clipped_segment(bounds, from, end) {
                canvas.draw_named(&name, Pen::Construction, Shape::Line(a, b));
            }
            if let Some(slider) = cut.guide() {
                // The sign of a right angle.
                let (along, across) = (on_sheet(self.pose.guide(slider)), towards_special);
                let chain = [along, along + across, across].map(|side| from + side * RIGHT_ANGLE);
                canvas.draw(Pen::Frame, Shape::Polyline(chain.to_vec()));
            }
        }
    }

    /// Whether a special point stands at its place: it is near enough, and there is room.
    fn shows(&self, canvas: &Canvas<'_>, special: &Special) -> bool {
        let place = special.place.finite().filter(|_| is_near(self.context, special));
        place.is_some_and(|place| holds(canvas.room().inset(-self.dims().joint), self.view.at(place)))
    }

    /// Draws a special point at its place, or a distant one as an arrow with its distance.
    pub(super) fn mark_special(&self, canvas: &mut Canvas<'_>, special: &Special) {
        let label = self.context.facts.markup(&special.name);
        if self.shows(canvas, special) {
            let Some(place) = special.place.finite() else {
                return;
            };
            let center = self.view.at(place);
            let name = format!("point-{}", special.name);
            let shape = Shape::Circle { center, radius: self.dims().joint };
            canvas.draw_named(&name, Pen::Special, shape);
            canvas.label(&special.name, &label, center, self.dims().joint + 0.7, None, 3);
            return;
        }
        // The arrow is on the first cut line with a direction.
        let bounds = canvas.room().inset(-2.0);
        let start = special.cuts.iter().find_map(|c| Some((c.start()?, c.line.direction()?)));
        let Some((start, direction)) = start else {
            return;
        };
        let from = self.at(start);
        let towards = match special.place {
            Place::At(place) => self.view.at(place) - from,
            Place::AtInfinity(_) => on_sheet(direction),
        };
        let far = from + towards.normalize() * (bounds.width() + bounds.height());
        let Some((_, edge)) = clipped_segment(bounds, from, far) else {
            return;
        };
        let tail = edge - towards.normalize() * 9.0;
        let distance = match special.place {
            Place::At(place) => {
                let distance = (place - self.pose.point(start)).norm();
                let name = self.mechanism.point_name(start);
                let unit = self.context.solution.scene.units.length.as_str();
                let distance = format!("{} {unit}", self.context.words.write(distance, DISTANCE));
                self.context.words.language.far_away(&label, &distance, name)
            }
            Place::AtInfinity(_) => self.context.words.language.at_infinity(&label),
        };
        let name = format!("point-{}", special.name);
        canvas.draw_named(&name, Pen::Special, canvas.arrow(tail, edge));
        let request = LabelRequest::new(RichText::plain(&distance), tail, 1.0, None, 3);
        canvas.ask(&special.name, request).short = Some(RichText::math(&label));
    }
}

/// The distance of the nearest of some points, kept as boxes without size, if it is at most `most`.
fn distance(points: &Obstacles, place: Point, most: f64) -> Option<f64> {
    let area = Rect::from_center_size(place, (2.0 * most, 2.0 * most)).inflate(1e-6, 1e-6);
    let near = points.boxes_near(area).map(|point| (point.origin() - place).hypot());
    near.filter(|distance| *distance <= most).reduce(f64::min)
}
