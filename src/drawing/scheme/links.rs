//! Links as lines and areas, pieces of the neighbouring mechanism, the links in other positions, and paths of points over
//! the cycle of the drive.

use super::on_paper::{LinkShape, SchemeOnPaper};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{simplified, simplified_to};
use crate::drawing::labels::LabelRequest;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::RichText;
use crate::drawing::view::on_sheet;
use crate::geometry;
use crate::mechanism::BodyId;
use crate::position::Pose;
use kurbo::{Point, Rect, Vec2};

/// Half the length of the stroke across a path at a tick, in mm.
const TICK: f64 = 0.9;
/// Distance of a path from the lines that labels keep off in its place, in mm.
const ROUGH: f64 = 0.3;

impl<'a> SchemeOnPaper<'a> {
    pub(super) fn link_areas(&self, canvas: &mut Canvas<'_>) {
        for (id, _) in self.mechanism.links() {
            if let LinkShape::Plate(corners) = self.shape(id) {
                canvas.draw(Pen::LinkFill, Shape::Polygon(corners)).number = self.context.number(id);
            }
        }
    }

    pub(super) fn link_lines(&self, canvas: &mut Canvas<'_>) {
        for (id, body) in self.mechanism.links() {
            let name = format!("link-{}", body.name);
            let pen = if self.mechanism.is_equivalent(id) { Pen::Equivalent } else { Pen::Link };
            for (index, line) in self.shape(id).outlines().into_iter().enumerate() {
                let mark = match index {
                    0 => canvas.draw_named(&name, pen, line),
                    _ => canvas.draw(pen, line),
                };
                mark.number = self.context.number(id);
            }
        }
    }

    /// Draws a link of the neighbouring mechanism as a piece with a break line.
    pub(super) fn neighbour(&self, canvas: &mut Canvas<'_>, link: BodyId) {
        const LENGTH: f64 = 11.0;
        const HALF_WAVE: f64 = 2.6;
        /// Cosine of the smallest angle, 40°, between a piece and another line from its point.
        const CLEAR: f64 = 0.766;
        let body = self.mechanism.body(link);
        let (point, name) = (body.points[0], body.name.as_str());
        let from = self.at(point);
        let outward = self.outward(from).unwrap_or(Vec2::new(-1.0, 0.0));
        // Outwards, or in the nearest direction that keeps the piece on the panel, off its heading, and clear of the
        // links and guides at its point.
        let turned = |degrees: f64| {
            let turn = geometry::direction_of_degrees(degrees);
            Vec2::new(turn.x, turn.y).rotate_scale(outward)
        };
        let turns = [0.0, 30.0, -30.0, 60.0, -60.0, 90.0, -90.0, 120.0, -120.0];
        let bounds = canvas.obstacles.bounds;
        let fits = |away: &Vec2| {
            let tip = from + *away * (LENGTH + 1.2);
            let across = Vec2::new(-away.y, away.x) * HALF_WAVE;
            let outer = Rect::from_points(tip - across, tip + across).union_pt(from.lerp(tip, 0.5));
            bounds.contains(tip - across) && bounds.contains(tip + across) && !canvas.obstacles.overlaps(outer)
        };
        let taken = self.directions(point);
        let clear = |away: &Vec2| taken.iter().all(|other| away.dot(*other) < CLEAR);
        let tries = turns.map(turned);
        let on_panel = || tries.iter().filter(|away| fits(away));
        let best = on_panel().find(|away| clear(away));
        let away = *best.or(on_panel().next()).unwrap_or(&outward);
        let across = Vec2::new(-away.y, away.x);
        let end = from + away * LENGTH;
        canvas.draw_named(&format!("link-{name}"), Pen::Link, Shape::Line(from, end)).number =
            self.context.number(link);
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
        canvas.label(name, name, anchor, 1.2, Some(across), 1).number = self.context.number(link);
    }

    /// Draws the links in other positions; nothing keeps off them.
    pub(super) fn ghosts(&self, canvas: &mut Canvas<'_>) {
        for (index, pose) in self.context.traces.ghosts.iter().enumerate() {
            self.ghost(canvas, &format!("ghost-{}", index + 1), pose);
        }
    }

    /// Draws the other assembly modes, each with its number beside the point that is farthest from all others.
    pub(super) fn other_modes(&self, canvas: &mut Canvas<'_>) {
        let apart = self.context.modes.apart(self.pose);
        for ((number, pose), point) in self.context.modes.shown.iter().zip(apart) {
            let name = format!("mode-{number}");
            self.ghost(canvas, &name, pose);
            let words = self.context.words.language.mode(&number.to_string());
            let anchor = self.view.at(pose.points[point]);
            canvas.obstacles.add_boxes([Rect::from_center_size(anchor, (1.0, 1.0))]);
            canvas.ask(&name, LabelRequest::new(RichText::plain(&words), anchor, 1.0, None, 3));
        }
    }

    /// Draws the links in another position.
    fn ghost(&self, canvas: &mut Canvas<'_>, name: &str, pose: &'a Pose) {
        let ghost = self.in_pose(pose);
        let links = self.mechanism.links().filter(|(link, _)| !self.mechanism.is_equivalent(*link));
        for (link, body) in links {
            for (part, line) in ghost.shape(link).outlines().into_iter().enumerate() {
                let part = if part > 0 { format!("-{}", part + 1) } else { String::new() };
                let name = format!("{name}-link-{}{part}", body.name);
                canvas.draw_below(&name, Pen::Ghost, line).number = self.context.number(link);
            }
        }
    }

    /// Draws the paths of points, with a stroke across at every tick. Labels keep off the paths if possible.
    pub(super) fn paths(&self, canvas: &mut Canvas<'_>) {
        for path in &self.context.traces.paths {
            let number = self.context.number(path.link);
            for (what, pen, pieces) in [("beyond", Pen::Beyond, &path.beyond), ("path", Pen::Trace, &path.pieces)] {
                for (index, piece) in pieces.iter().enumerate() {
                    let chain: Vec<Point> = piece.iter().map(|(_, place)| self.view.at(*place)).collect();
                    let part = if index > 0 { format!("-{}", index + 1) } else { String::new() };
                    canvas.reserve(&Shape::Polyline(simplified_to(ROUGH, &chain)));
                    let line = Shape::Polyline(simplified(&chain));
                    canvas.draw_below(&format!("{what}-{}{part}", path.name), pen, line).number = number;
                }
            }
            for (index, tick) in path.ticks.iter().enumerate() {
                let Some(along) = tick.along.map(on_sheet) else {
                    continue;
                };
                let (at, across) = (self.view.at(tick.place), Vec2::new(-along.y, along.x) * TICK);
                let name = format!("tick-{}-{}", path.name, index + 1);
                let stroke = Shape::Line(at - across, at + across);
                canvas.reserve(&stroke);
                canvas.draw_below(&name, Pen::Trace, stroke).number = number;
            }
        }
    }
}
