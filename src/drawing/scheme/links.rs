//! Links as lines and areas, and pieces of the neighbouring mechanism.

use super::link_shape::LinkShape;
use super::on_paper::SchemeOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::geometry;
use crate::mechanism::BodyId;
use kurbo::{Rect, Vec2};

impl SchemeOnPaper<'_> {
    pub(super) fn link_areas(&self, canvas: &mut Canvas<'_>) {
        for (id, _) in self.mechanism.links() {
            if let LinkShape::Plate(corners) = self.shape(id) {
                let area = Shape::Polygon(corners);
                canvas.draw(Pen::LinkFill, area).number = self.number(id);
            }
        }
    }

    pub(super) fn link_lines(&self, canvas: &mut Canvas<'_>) {
        for (id, body) in self.mechanism.links() {
            let lines = match self.shape(id) {
                LinkShape::Nothing => Vec::new(),
                LinkShape::Bars(bars) => bars.iter().map(|[a, b]| Shape::Line(*a, *b)).collect(),
                LinkShape::Plate(corners) => vec![Shape::Polygon(corners)],
            };
            let name = format!("link-{}", body.name);
            for (index, line) in lines.into_iter().enumerate() {
                let mark = match index {
                    0 => canvas.draw_named(&name, Pen::Link, line),
                    _ => canvas.draw(Pen::Link, line),
                };
                mark.number = self.number(id);
            }
        }
    }

    /// Draws a link of the neighbouring mechanism as a piece with a break line.
    pub(super) fn stub(&self, canvas: &mut Canvas<'_>, link: BodyId) {
        let body = self.mechanism.body(link);
        let (point, name) = (body.points[0], body.name.as_str());
        const LENGTH: f64 = 11.0;
        let from = self.at(point);
        const HALF_WAVE: f64 = 2.6;
        /// Cosine of the smallest angle, 40°, between a piece and another line from its point.
        const CLEAR: f64 = 0.766;
        let outward = self.outward(from).unwrap_or(Vec2::new(-1.0, 0.0));
        // Outwards, or in the nearest direction that keeps the piece on the panel, off its heading, and clear of the
        // links and guides at its point.
        let turned = |degrees: f64| {
            let turn = geometry::direction_of_degrees(degrees);
            Vec2::new(turn.x * outward.x - turn.y * outward.y, turn.y * outward.x + turn.x * outward.y)
        };
        let turns = [0.0, 30.0, -30.0, 60.0, -60.0, 90.0, -90.0, 120.0, -120.0];
        let bounds = canvas.bounds();
        let fits = |away: &Vec2| {
            let tip = from + *away * (LENGTH + 1.2);
            let across = Vec2::new(-away.y, away.x) * HALF_WAVE;
            let outer = Rect::from_points(tip - across, tip + across).union_pt(from.lerp(tip, 0.5));
            bounds.contains(tip - across) && bounds.contains(tip + across) && !canvas.is_taken(outer)
        };
        let taken = self.directions(point);
        let clear = |away: &Vec2| taken.iter().all(|other| away.dot(*other) < CLEAR);
        let tries = turns.map(turned);
        let on_panel = || tries.iter().filter(|away| fits(away));
        let best = on_panel().find(|away| clear(away));
        let away = *best.or(on_panel().next()).unwrap_or(&outward);
        let across = Vec2::new(-away.y, away.x);
        let end = from + away * LENGTH;
        let piece = Shape::Line(from, end);
        let mark = canvas.draw_named(&format!("link-{name}"), Pen::Link, piece);
        mark.number = self.number(link);
        let wave = vec![
            end + across * HALF_WAVE,
            end + across * 0.7,
            end + across * 0.3 + away * 1.2,
            end - across * 0.3 - away * 1.2,
            end - across * 0.7,
            end - across * HALF_WAVE,
        ];
        canvas.draw(Pen::Guide, Shape::Polyline(wave));
        let anchor = from + away * (0.6 * LENGTH);
        let label = canvas.label(name, name, anchor, 1.2, Some(across), 1);
        label.number = self.number(link);
    }
}
