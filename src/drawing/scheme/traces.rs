//! Paths of points over the cycle of the drive, and ghosts: the links in other positions.

use super::link_shape::LinkShape;
use super::on_paper::SchemeOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{simplified, simplified_to};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::view::on_sheet;
use crate::position::Pose;
use kurbo::{Point, Rect, Vec2};

/// Half the length of the stroke across a path at a tick, in mm.
const TICK: f64 = 0.9;
/// Distance of a path from the lines that labels keep off in its place, in mm.
const ROUGH: f64 = 0.3;

impl SchemeOnPaper<'_> {
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
            canvas.keep_off(Rect::from_center_size(anchor, (1.0, 1.0)));
            canvas.words(&name, &words, anchor);
        }
    }

    /// Draws the links in another position.
    fn ghost(&self, canvas: &mut Canvas<'_>, name: &str, pose: &Pose) {
        let ghost = self.posed(pose);
        for (link, body) in self.mechanism.links() {
            let lines = match ghost.shape(self.view, link) {
                LinkShape::Nothing => Vec::new(),
                LinkShape::Bars(bars) => bars.into_iter().map(|[a, b]| Shape::Line(a, b)).collect(),
                LinkShape::Plate(corners) => vec![Shape::Polygon(corners)],
            };
            for (part, line) in lines.into_iter().enumerate() {
                let part = if part > 0 { format!("-{}", part + 1) } else { String::new() };
                let name = format!("{name}-link-{}{part}", body.name);
                canvas.draw_below(&name, Pen::Ghost, line).number = self.number(link);
            }
        }
    }

    /// Draws the paths of points, with a stroke across at every tick. Labels keep off the paths if possible.
    pub(super) fn paths(&self, canvas: &mut Canvas<'_>) {
        for path in &self.context.traces.paths {
            let number = self.number(path.link);
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
                canvas.draw_below(&name, Pen::Trace, stroke).number = number;
            }
        }
    }
}
