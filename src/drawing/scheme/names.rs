//! Joints, and the labels of points and links.

use super::link_shape::LinkShape;
use super::on_paper::SchemeOnPaper;
use super::sliders::BLOCK;
use crate::construction::display;
use crate::drawing::canvas::Canvas;
use crate::drawing::grid::Grid;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::view::{on_sheet, towards};
use crate::mechanism::{BodyId, GROUND, PointId, Role, Slider, SliderId};
use kurbo::{Point, Rect, Vec2};

impl SchemeOnPaper<'_> {
    /// Draws circles at pins, dots at other points, and their labels.
    pub(super) fn joints(&self, canvas: &mut Canvas<'_>) {
        let mut named = Near::new(canvas.bounds());
        for point in (0..self.mechanism.points.len()).map(PointId) {
            let center = self.at(point);
            let pin = self.is_pin(point);
            let slides = self.context.facts.slides[point.0];
            let name = self.mechanism.point_name(point);
            let id = format!("point-{name}");
            if pin {
                let radius = self.dims().joint;
                canvas.draw_named(&id, Pen::Joint, Shape::Circle { center, radius });
            } else {
                let radius = self.dims().dot * (0.5 / 0.45);
                canvas.draw_named(&id, Pen::ImagePoint, Shape::Circle { center, radius });
            }
            let clearance = if slides { BLOCK.y + 0.8 } else { self.dims().joint + 0.9 };
            // Of two coincident points the second has the lower priority.
            let twin = named.distance(center, 0.3).is_some_and(|distance| distance < 0.3);
            let priority = if twin { 1 } else { 2 };
            named.add(center);
            canvas.label(name, &display(name), center, clearance, self.outward(center), priority);
        }
    }

    /// Draws the links' labels: inside areas, beside lines where there is most room.
    pub(super) fn link_names(&self, canvas: &mut Canvas<'_>) {
        /// Room beside a link's name, in mm.
        const ROOM: f64 = 8.0;
        let mut joints = Near::new(canvas.bounds());
        self.pose.points.iter().for_each(|&p| joints.add(self.view.at(p)));
        for (id, body) in self.mechanism.links() {
            if body.role == Role::Unsolved {
                continue;
            }
            let (anchor, clearance, prefer) = match self.shape(id) {
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
                    let outer = self.outward(anchor).is_some_and(|o| o.dot(beside) < 0.0);
                    (anchor, 1.3, Some(if outer { -beside } else { beside }))
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
            let label = canvas.label(&body.name, &body.name, anchor, clearance, prefer, 1);
            label.number = self.number(id);
        }
        if let Some(&first) = self.mechanism.body(GROUND).points.first() {
            let name = self.mechanism.body(GROUND).name.as_str();
            let shown = canvas.shown(name, "");
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
}

/// Points on the sheet, and which of them are near a place.
pub(super) struct Near {
    points: Vec<Point>,
    grid: Grid,
}

impl Near {
    /// No points yet, on the sheet around an area.
    pub(super) fn new(area: Rect) -> Self {
        Self { points: Vec::new(), grid: Grid::new(area) }
    }
    pub(super) fn add(&mut self, point: Point) {
        self.grid.add(self.points.len(), Rect::from_points(point, point));
        self.points.push(point);
    }

    /// The distance of the nearest point, if it is at most `most`.
    pub(super) fn distance(&self, place: Point, most: f64) -> Option<f64> {
        let area = Rect::from_center_size(place, (2.0 * most, 2.0 * most)).inflate(1e-6, 1e-6);
        let near = self.grid.near(area).into_iter().map(|index| (self.points[index] - place).hypot());
        near.filter(|distance| *distance <= most).reduce(f64::min)
    }
}
