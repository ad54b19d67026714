//! Joints, and the labels of points and links.

use super::super::canvas::Canvas;
use super::super::shape::Shape;
use super::super::sheet::Pen;
use super::super::view::{View, on_sheet, towards};
use super::Scheme;
use super::links::LinkShape;
use super::looked_up::Near;
use super::sliders::BLOCK;
use crate::construction::display;
use crate::mechanism::{BodyId, GROUND, PointId, Role, Slider, SliderId};
use kurbo::{Point, Vec2};

impl Scheme<'_> {
    /// Draws circles at pins, dots at other points, and their labels.
    pub(super) fn joints(&self, canvas: &mut Canvas<'_>, view: &View) {
        let mut named = Near::new(canvas.bounds());
        for point in (0..self.mechanism.points.len()).map(PointId) {
            let center = self.at(view, point);
            let pin = self.is_pin(point);
            let slides = self.looked_up.slides[point.0];
            let name = self.mechanism.point_name(point);
            let id = format!("point-{name}");
            if pin {
                let radius = self.dims.joint;
                canvas.draw_named(&id, Pen::Joint, Shape::Circle { center, radius });
            } else {
                let radius = self.dims.dot * (0.5 / 0.45);
                canvas.draw_named(&id, Pen::ImagePoint, Shape::Circle { center, radius });
            }
            let clearance = if slides { BLOCK.y + 0.8 } else { self.dims.joint + 0.9 };
            // Of two coincident points the second has the lower priority.
            let twin = named.distance(center, 0.3).is_some_and(|distance| distance < 0.3);
            let priority = if twin { 1 } else { 2 };
            named.add(center);
            canvas.label(name, &display(name), center, clearance, self.outward(view, center), priority);
        }
    }

    /// Whether a point is a pin.
    pub(super) fn is_pin(&self, point: PointId) -> bool {
        self.looked_up.pins[point.0]
    }

    /// Unit vector from the centre of the mechanism; none within 5 mm of it.
    pub(super) fn outward(&self, view: &View, from: Point) -> Option<Vec2> {
        let away = from - view.at(self.looked_up.middle);
        (away.hypot() > 5.0).then(|| away.normalize())
    }

    /// Draws the links' labels: inside areas, beside lines where there is most room.
    pub(super) fn link_names(&self, canvas: &mut Canvas<'_>, view: &View) {
        /// Room beside a link's name, in mm.
        const ROOM: f64 = 8.0;
        let mut joints = Near::new(canvas.bounds());
        self.pose.points.iter().for_each(|&p| joints.add(view.at(p)));
        for (id, body) in self.mechanism.links() {
            if body.role == Role::Unsolved {
                continue;
            }
            let (anchor, clearance, prefer) = match self.shape(view, id) {
                LinkShape::Bars(bars) => {
                    let [a, b] = bars[bars.len() - 1];
                    let free = |share: f64| joints.distance(a.lerp(b, share), ROOM).unwrap_or(f64::INFINITY);
                    let shares = [0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78];
                    // The middle, unless a joint is nearby.
                    let good = shares.into_iter().find(|&s| free(s) > ROOM);
                    let best = |x: &f64, y: &f64| free(*x).total_cmp(&free(*y));
                    let share = good.or_else(|| shares.into_iter().max_by(best));
                    let anchor = a.lerp(b, share.unwrap_or(0.5));
                    // Normal to the line, on its outer side.
                    let along = towards(a, b, Vec2::new(1.0, 0.0));
                    let beside = Vec2::new(-along.y, along.x);
                    let outer = self.outward(view, anchor).is_some_and(|o| o.dot(beside) < 0.0);
                    (anchor, 1.3, Some(if outer { -beside } else { beside }))
                }
                LinkShape::Nothing => match self.place_of_small(view, id) {
                    Some(place) => place,
                    None => continue,
                },
                LinkShape::Plate(corners) => {
                    let sum = corners.iter().fold(Vec2::ZERO, |s, p| s + p.to_vec2());
                    ((sum / corners.len() as f64).to_point(), 0.0, None)
                }
            };
            let label = canvas.label(&body.name, &body.name, anchor, clearance, prefer, 1);
            label.number = self.number(id);
        }
        if let Some(&first) = self.mechanism.body(GROUND).points.first() {
            let name = self.mechanism.body(GROUND).name.as_str();
            let shown = canvas.shown(name, "");
            if !shown.is_empty() {
                let anchor = self.at(view, first) + Vec2::new(0.0, 6.0);
                canvas.label(name, &shown, anchor, 1.5, Some(Vec2::new(0.0, 1.0)), 1);
            }
        }
    }

    /// Place, clearance and preferred side of the label of a link with fewer than two points: beside its block or its
    /// guide.
    fn place_of_small(&self, view: &View, link: BodyId) -> Option<(Point, f64, Option<Vec2>)> {
        let belongs = |s: &Slider| s.link == link || s.on == link;
        let index = self.mechanism.sliders.iter().position(belongs)?;
        let slider = &self.mechanism.sliders[index];
        let at = self.at(view, slider.at);
        let along = on_sheet(self.pose.guide(SliderId(index)));
        if slider.link != link {
            // Between its only point and the block, if there is room.
            let only_point = self.mechanism.body(link).points.first();
            let only_point = only_point.map(|&point| self.at(view, point));
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
        let mut lines = self.directions(view, slider.at);
        if self.mechanism.body(GROUND).points.contains(&slider.at) {
            lines.push(self.down(view, slider.at));
        }
        let taken: f64 = lines.iter().map(|line| line.dot(side)).sum();
        let side = if taken > 0.0 { -side } else { side };
        Some((at, half + 0.8, Some(side)))
    }
}
