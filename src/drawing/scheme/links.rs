//! Links as lines and areas, pieces of the neighbouring mechanism, the sense in which drives turn.

use super::super::canvas::Canvas;
use super::super::sheet::{Pen, Shape};
use super::super::view::View;
use super::Scheme;
use super::ground::pivot_box;
use crate::geometry::{self, cross, span};
use crate::mechanism::PointId;
use kurbo::{Point, Vec2};

impl Scheme<'_> {
    /// Corners of a link in order around it; two for a straight one.
    pub(super) fn outline(&self, points: &[PointId]) -> Vec<geometry::Point> {
        let mut places: Vec<geometry::Point> = points.iter().map(|&p| self.pose.point(p)).collect();
        if places.len() < 3 {
            return places;
        }
        // The convex hull, by Andrew's monotone chain.
        places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        let size = span(places.iter().copied());
        let mut hull: Vec<geometry::Point> = Vec::new();
        for pass in 0..2 {
            let base = hull.len();
            for &p in &places {
                while hull.len() >= base + 2 {
                    let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
                    // Flatter than a thousandth of the link is drawn as straight.
                    if cross(b - a, p - b) > 1e-3 * size * (p - a).norm() {
                        break;
                    }
                    hull.pop();
                }
                hull.push(p);
            }
            hull.pop();
            if pass == 0 {
                places.reverse();
            }
        }
        hull
    }

    pub(super) fn link_areas(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (index, (_, body)) in self.mechanism.links().enumerate() {
            let outline = self.outline(&body.points);
            if outline.len() > 2 {
                let corners = outline.iter().map(|&p| view.at(p)).collect();
                canvas.draw(Pen::LinkFill(index as u8), Shape::Polygon(corners));
            }
        }
    }

    pub(super) fn link_lines(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (_, body) in self.mechanism.links() {
            let corners: Vec<Point> = self
                .outline(&body.points)
                .iter()
                .map(|&p| view.at(p))
                .collect();
            let name = format!("link-{}", body.name);
            match corners.as_slice() {
                [] | [_] => {}
                [a, b] => canvas.draw_named(&name, Pen::Link, Shape::Line(*a, *b)),
                _ => canvas.draw_named(&name, Pen::Link, Shape::Polygon(corners)),
            }
        }
    }

    /// A link of the neighbouring mechanism: a piece of it, broken off.
    pub(super) fn stub(&self, canvas: &mut Canvas<'_>, view: &View, point: PointId, name: &str) {
        const LENGTH: f64 = 11.0;
        let from = self.at(view, point);
        const HALF_WAVE: f64 = 2.6;
        let outward = self.outward(view, from).unwrap_or(Vec2::new(-1.0, 0.0));
        // Outwards, or as little beside it as keeps the piece on the panel.
        let turned = |degrees: f64| {
            let turn = geometry::direction_of_degrees(degrees);
            Vec2::new(
                turn.x * outward.x - turn.y * outward.y,
                turn.y * outward.x + turn.x * outward.y,
            )
        };
        let turns = [0.0, 30.0, -30.0, 60.0, -60.0, 90.0, -90.0, 120.0, -120.0];
        let bounds = canvas.bounds();
        let fits = |away: &Vec2| {
            let tip = from + *away * (LENGTH + 1.2);
            let across = Vec2::new(-away.y, away.x) * HALF_WAVE;
            bounds.contains(tip - across) && bounds.contains(tip + across)
        };
        let mut tries = turns.into_iter().map(turned);
        let away = tries.find(fits).unwrap_or(outward);
        let across = Vec2::new(-away.y, away.x);
        let end = from + away * LENGTH;
        canvas.draw_named(&format!("link-{name}"), Pen::Link, Shape::Line(from, end));
        let wave = vec![
            end + across * HALF_WAVE,
            end + across * 0.7,
            end + across * 0.3 + away * 1.2,
            end - across * 0.3 - away * 1.2,
            end - across * 0.7,
            end - across * HALF_WAVE,
        ];
        canvas.draw(Pen::Guide, Shape::Polyline(wave));
        canvas.label(
            name,
            name,
            from + away * (0.6 * LENGTH),
            1.2,
            Some(across),
            1,
        );
    }

    /// The sense in which a driven link turns.
    pub(super) fn turning(
        &self,
        canvas: &mut Canvas<'_>,
        view: &View,
        pivot: PointId,
        points: &[PointId],
        name: &str,
        omega: f64,
    ) {
        const RADIUS: f64 = 7.5;
        const SWEEP: f64 = 1.5;
        let Some(&tip) = points.iter().find(|&&p| p != pivot) else {
            return;
        };
        let center = self.at(view, pivot);
        let arm = self.at(view, tip) - center;
        if omega == 0.0 || arm.hypot() < 1.0 {
            return;
        }
        // Counter-clockwise is against the sheet's own sense of angles.
        let sense = -omega.signum();
        let arc = |radius: f64, lead: f64| Shape::ArcArrow {
            center,
            radius,
            start: libm::atan2(arm.y, arm.x) + sense * lead,
            sweep: sense * SWEEP,
        };
        // Off the panel's edge and, where that can be, off the pivot's hatching: ahead of the link,
        // behind it, or smaller.
        let (bounds, foot) = (canvas.bounds(), pivot_box(center));
        let behind = -0.35 - SWEEP;
        let tries = [
            (RADIUS, 0.35),
            (RADIUS, behind),
            (0.8 * RADIUS, 0.35),
            (0.8 * RADIUS, behind),
        ];
        let fits =
            |&&(radius, lead): &&(f64, f64)| arc(radius, lead).drawn_box().union(bounds) == bounds;
        let clear = |&&(radius, lead): &&(f64, f64)| {
            let both = arc(radius, lead).drawn_box().intersect(foot);
            both.area() <= 0.0
        };
        let best = tries.iter().filter(fits).find(clear);
        let &(radius, lead) = best.or(tries.iter().find(fits)).unwrap_or(&tries[2]);
        let start = libm::atan2(arm.y, arm.x) + sense * lead;
        let sweep = sense * SWEEP;
        let shape = arc(radius, lead);
        canvas.draw_named(&format!("omega-{name}"), Pen::Turning, shape);
        let middle = start + 0.6 * sweep;
        let direction = Vec2::new(libm::cos(middle), libm::sin(middle));
        let label = format!("ω_{{{}}}", canvas.shown(name, name));
        let anchor = center + direction * radius;
        canvas.label(
            &format!("omega({name})"),
            &label,
            anchor,
            0.8,
            Some(direction),
            2,
        );
    }
}
