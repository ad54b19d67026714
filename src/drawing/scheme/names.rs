//! Joints and the names of points and links.

use super::super::canvas::Canvas;
use super::super::sheet::{Pen, Shape};
use super::super::view::{Extent, View, on_sheet};
use super::sliders::BLOCK;
use super::{JOINT, Scheme};
use crate::geometry::Vector;
use crate::mechanism::{BodyId, GROUND, JointKind, PointId, Role, SliderId};
use crate::plan::display;
use kurbo::{Point, Vec2};

impl Scheme<'_> {
    /// Circles at pins, dots at other points, and their names.
    pub(super) fn joints(&self, canvas: &mut Canvas<'_>, view: &View) {
        let mut named: Vec<Point> = Vec::new();
        for point in (0..self.mechanism.points.len()).map(PointId) {
            let center = self.at(view, point);
            let is_pin = |j: &crate::mechanism::Joint| j.kind == JointKind::Revolute(point);
            let pin = self.mechanism.joints.iter().any(is_pin);
            let slides = self.mechanism.sliders.iter().any(|s| s.at == point);
            let name = self.mechanism.point_name(point);
            let id = format!("point-{name}");
            if pin {
                let radius = JOINT;
                canvas.draw_named(&id, Pen::Joint, Shape::Circle { center, radius });
            } else {
                let radius = 0.5;
                canvas.draw_named(&id, Pen::ImagePoint, Shape::Circle { center, radius });
            }
            let clearance = if slides { BLOCK.y + 0.8 } else { JOINT + 0.6 };
            // Two points in one place are told apart by their labels alone.
            let twin = named.iter().any(|p| (*p - center).hypot() < 0.3);
            let priority = if twin { 1 } else { 2 };
            named.push(center);
            canvas.label(
                name,
                &display(name),
                center,
                clearance,
                self.outward(view, center),
                priority,
            );
        }
    }

    /// The direction away from the middle of the mechanism.
    pub(super) fn outward(&self, view: &View, from: Point) -> Option<Vec2> {
        let extent = Extent::of(self.pose.points.iter().copied());
        let away = from - view.at(nalgebra::center(&extent.low, &extent.high));
        (away.hypot() > 5.0).then(|| away.normalize())
    }

    /// The links' names: inside areas, beside lines where there is most room.
    pub(super) fn link_names(&self, canvas: &mut Canvas<'_>, view: &View) {
        let joints: Vec<Point> = self.pose.points.iter().map(|&p| view.at(p)).collect();
        for (id, body) in self.mechanism.links() {
            if body.role == Role::Stub {
                continue;
            }
            let corners: Vec<Point> = self
                .outline(&body.points)
                .iter()
                .map(|&p| view.at(p))
                .collect();
            let (anchor, clearance, prefer) = match corners.as_slice() {
                [a, b] => {
                    let free = |share: f64| {
                        let p = a.lerp(*b, share);
                        let nearest = joints.iter().map(|j| (*j - p).hypot());
                        nearest.fold(f64::INFINITY, f64::min)
                    };
                    let shares = [0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78];
                    // The middle, unless a joint is close there.
                    let good = shares.into_iter().find(|&s| free(s) > 8.0);
                    let best = |x: &f64, y: &f64| free(*x).total_cmp(&free(*y));
                    let share = good.or_else(|| shares.into_iter().max_by(best));
                    (a.lerp(*b, share.unwrap_or(0.5)), 1.0, None)
                }
                [] | [_] => match self.own_place(view, id) {
                    Some((place, clearance)) => (place, clearance, None),
                    None => continue,
                },
                corners => {
                    let sum = corners.iter().fold(Vec2::ZERO, |s, p| s + p.to_vec2());
                    ((sum / corners.len() as f64).to_point(), 0.0, None)
                }
            };
            canvas.label(&body.name, &body.name, anchor, clearance, prefer, 1);
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

    /// Where a link with fewer than two points is: its block or its guide.
    fn own_place(&self, view: &View, link: BodyId) -> Option<(Point, f64)> {
        let own = |s: &crate::mechanism::Slider| s.link == link || s.on == link;
        let index = self.mechanism.sliders.iter().position(own)?;
        let slider = &self.mechanism.sliders[index];
        let at = self.at(view, slider.at);
        if slider.link == link {
            return Some((at, 1.2 * BLOCK.x));
        }
        let along: Vector = self.pose.guide(SliderId(index));
        Some((at + on_sheet(along) * (2.4 * BLOCK.x), 1.0))
    }
}
