//! Paths of points over the cycle of the drive, and ghosts: the links in other positions.

use super::super::canvas::Canvas;
use super::super::clip::{simplified, simplified_to};
use super::super::shape::Shape;
use super::super::sheet::Pen;
use super::super::view::{View, on_sheet};
use super::Scheme;
use super::links::LinkShape;
use crate::cycle::Times;
use crate::geometry;
use crate::position::Pose;
use crate::text::Untrusted;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Rect, Vec2};

/// Half the length of the stroke across a path at a tick, in mm.
const TICK: f64 = 0.9;
/// Distance of a path from the lines that labels keep off in its place, in mm.
const ROUGH: f64 = 0.3;
/// Number style of the steps between ticks.
const STEP: NumberStyle = NumberStyle::significant(3).trimmed().in_full(-3, 6).on(Medium::Figure);

impl Scheme<'_> {
    /// The places of all paths and ghosts.
    pub(super) fn places_of_traces(&self) -> impl Iterator<Item = geometry::Point> {
        let pieces = self.traces.paths.iter().flat_map(|path| path.pieces.iter().chain(&path.beyond).flatten());
        let ghosts = self.traces.ghosts.iter().flat_map(|ghost| ghost.points.iter().copied());
        pieces.map(|(_, place)| *place).chain(ghosts)
    }

    /// Draws the links in other positions; nothing keeps off them.
    pub(super) fn ghosts(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (index, pose) in self.traces.ghosts.iter().enumerate() {
            self.ghost(canvas, view, &format!("ghost-{}", index + 1), pose);
        }
    }

    /// The places of all other modes.
    pub(super) fn places_of_modes(&self) -> impl Iterator<Item = geometry::Point> {
        self.modes.shown.iter().flat_map(|(_, pose)| pose.points.iter().copied())
    }

    /// Draws the other assembly modes, each with its number beside the point that is farthest from all others.
    pub(super) fn other_modes(&self, canvas: &mut Canvas<'_>, view: &View) {
        let apart = self.modes.apart(self.pose);
        for ((number, pose), point) in self.modes.shown.iter().zip(apart) {
            let name = format!("mode-{number}");
            self.ghost(canvas, view, &name, pose);
            let words = self.words.language.mode(&number.to_string());
            let anchor = view.at(pose.points[point]);
            canvas.keep_off(Rect::from_center_size(anchor, (1.0, 1.0)));
            canvas.words(&name, &words, anchor);
        }
    }

    /// Draws the links in another position.
    fn ghost(&self, canvas: &mut Canvas<'_>, view: &View, name: &str, pose: &Pose) {
        let ghost = self.posed(pose);
        for (link, body) in self.mechanism.links() {
            let lines = match ghost.shape(view, link) {
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
    pub(super) fn paths(&self, canvas: &mut Canvas<'_>, view: &View) {
        for path in &self.traces.paths {
            let number = self.number(path.link);
            for (what, pen, pieces) in [("beyond", Pen::Beyond, &path.beyond), ("path", Pen::Trace, &path.pieces)] {
                for (index, piece) in pieces.iter().enumerate() {
                    let chain: Vec<Point> = piece.iter().map(|(_, place)| view.at(*place)).collect();
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
                let (at, across) = (view.at(tick.place), Vec2::new(-along.y, along.x) * TICK);
                let name = format!("tick-{}-{}", path.name, index + 1);
                let stroke = Shape::Line(at - across, at + across);
                canvas.draw_below(&name, Pen::Trace, stroke).number = number;
            }
        }
    }

    /// The sentence on the paths and their ticks, in markup.
    pub(in crate::drawing) fn sentence_on_paths(&self) -> Option<String> {
        let Times { drive, step, time, .. } = self.traces.times.as_ref()?;
        let shown = |name: &str| self.shown(name, None);
        let points: Vec<String> = self.traces.paths.iter().map(|path| shown(&path.name)).collect();
        let (language, units) = (self.words.language, self.scene.units);
        let number = |value: f64| self.words.write(value, STEP);
        let step = match drive.is_angle() {
            true => format!("{}°", number(*step)),
            false => format!("{} {}", number(*step), units.length.as_str()),
        };
        let drive = self.figure.labels.get(&drive.name).map_or_else(|| drive.name.clone(), Untrusted::for_setting);
        let points = points.join(", ");
        let mut sentence = match time {
            Some(time) => {
                let time = format!("{} {}", number(*time), units.time.as_str());
                language.paths_in_time(&points, &step, &drive, &time)
            }
            None => language.paths(&points, &step, &drive),
        };
        if self.traces.paths.iter().any(|path| !path.beyond.is_empty()) {
            sentence = format!("{sentence} {}", language.paths_beyond());
        }
        Some(sentence)
    }
}
