//! Paths of points: a panel for each, y over x to one scale, with the numbers of both axes.

use super::axis::Axis;
use super::course::Course;
use super::error::CurvesError;
use super::way::{DOT, SCALE, Sides, Way, label, scale_of, sheet};
use crate::cycle::{PointPath, PointPaths};
use crate::drawing::canvas::Canvas;
use crate::drawing::chain::{clipped_chain, simplified};
use crate::drawing::dims::Dims;
use crate::drawing::layout::{Needs, WHITE};
use crate::drawing::line::Line;
use crate::drawing::panel::{Frame, Layer, Panel, numbered};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{Anchor, CAPTION, PlacedText, RichText};
use crate::drawing::view::{Extent, View};
use crate::geometry;
use crate::quantity::Kind;
use crate::scene::Scene;
use crate::words::Wording;
use kurbo::{Point, Rect};

/// Prefixes of the ids in each panel; a sheet holds as many panels.
const PREFIXES: [&str; 6] = ["path-a", "path-b", "path-c", "path-d", "path-e", "path-f"];
/// Room for the numbers of the axes, in mm.
const NUMBERS: Sides = Sides { left: 7.0, below: 5.0 };
/// Distance of the axes from the panel's left edge and from the scale at its foot, in mm.
const AXES: [f64; 2] = [13.0, 5.5];
/// Smallest distance of round values on the axes, in mm.
const APART: f64 = 14.0;
/// White between numbers and their axis, in mm.
const BESIDE: f64 = 1.2;

/// The figure of the paths of some points, on the scene's page.
///
/// # Errors
/// There are too many for a sheet.
pub fn paths(scene: &Scene, all: &PointPaths) -> Result<Drawing, CurvesError> {
    let (wanted, room) = (all.paths.len(), PREFIXES.len());
    if wanted > room {
        return Err(CurvesError::Panels { wanted, room });
    }
    let words = Wording::of(&scene.figure);
    let dims = Dims::of(&scene.figure);
    let course = Course { scene, dims, words, path: all.path, range: all.range, events: &all.events };
    let panels: Vec<Panel<'_>> = all.paths.iter().enumerate().map(|(index, one)| panel(&course, index, one)).collect();
    let unit = scene.units.length.as_str();
    let sentences = all.paths.iter().map(|one| words.language.path_of(&one.name, unit));
    Ok(sheet(&course, &panels, NUMBERS, sentences.collect()))
}

/// The panel of a point with the layers frame, scale, axes and path.
fn panel<'a>(course: &'a Course<'a>, index: usize, one: &'a PointPath) -> Panel<'a> {
    let unit = course.scene.units.length.as_str();
    let symbol = RichText::math(&course.shown(&one.name));
    let sentence = |symbol: &str| numbered(index, &course.words.language.path_of(symbol, unit));
    let frame = Frame::new(Line::around(sentence, symbol), Pen::Caption);
    let places = one.pieces.iter().chain(&one.beyond).flatten().map(|(_, place)| *place);
    Panel {
        name: one.name.clone(),
        prefix: PREFIXES[index],
        needs: Needs {
            kind: Kind::Length,
            extent: Extent::of(places),
            heading: frame.width(),
            above: 0.0,
            mu: None,
            white: WHITE,
            weight: 1.0,
        },
        cut: String::new(),
        unlabelled: String::new(),
        content: None,
        layers: vec![
            Box::new(frame),
            scale_of(course, Kind::Length),
            Box::new(|canvas: &mut Canvas<'_>, view: &View| axes(course, canvas, view)),
            Box::new(Walk { course, index, one }),
        ],
    }
}

/// The area of the path in its panel.
fn room(canvas: &Canvas<'_>) -> Rect {
    let frame = canvas.frame();
    Rect { x0: frame.x0 + AXES[0], y1: frame.y1 - SCALE - AXES[1], ..canvas.room() }
}

/// Draws the axes: lines at round values, and numbers below and on the left.
fn axes(course: &Course<'_>, canvas: &mut Canvas<'_>, view: &View) {
    let room = room(canvas);
    let origin = view.at(geometry::Point::origin());
    let [left, right] = [room.x0, room.x1].map(|x| (x - origin.x) * view.mu());
    let [low, high] = [room.y1, room.y0].map(|y| (origin.y - y) * view.mu());
    let across = Axis::new(course.words, [left, right], [room.x0, room.x1], APART, false);
    let up = Axis::new(course.words, [low, high], [room.y1, room.y0], APART, false);
    for value in &across.ticks {
        let x = across.at(*value);
        canvas.draw(Pen::Grid, Shape::Line(Point::new(x, room.y0), Point::new(x, room.y1)));
        let text = RichText::plain(&across.tick(*value));
        let half = 0.5 * text.width(CAPTION);
        if x - half > room.x0 - 2.0 && x + half < room.x1 {
            number(canvas, text, Point::new(x - half, room.y1 + BESIDE + 3.2), Anchor::Middle);
        }
    }
    for value in &up.ticks {
        let y = up.at(*value);
        canvas.draw(Pen::Grid, Shape::Line(Point::new(room.x0, y), Point::new(room.x1, y)));
        let text = RichText::plain(&up.tick(*value));
        let from = Point::new(room.x0 - BESIDE - text.width(CAPTION), y + 1.5);
        if y - 2.0 > room.y0 && y + 2.0 < room.y1 + 2.0 {
            number(canvas, text, from, Anchor::End);
        }
    }
    canvas.draw(Pen::Frame, Shape::Line(Point::new(room.x0, room.y0), Point::new(room.x0, room.y1)));
    canvas.draw(Pen::Frame, Shape::Line(Point::new(room.x0, room.y1), Point::new(room.x1, room.y1)));
}

/// Writes a number of an axis, which labels keep off.
fn number(canvas: &mut Canvas<'_>, text: RichText, from: Point, anchor: Anchor) {
    canvas.draw(Pen::Caption, Shape::Text(PlacedText::new(text, CAPTION, from).anchored(anchor)));
}

/// The path of a point.
struct Walk<'a> {
    course: &'a Course<'a>,
    index: usize,
    one: &'a PointPath,
}

impl Layer for Walk<'_> {
    fn draw(&self, canvas: &mut Canvas<'_>, view: &View) {
        let (one, room) = (self.one, room(canvas));
        let way = Way { course: self.course, index: self.index };
        let on_sheet = |piece: &Vec<(f64, geometry::Point)>| piece.iter().map(|(_, place)| view.at(*place)).collect();
        let beyond = one.beyond.iter().map(on_sheet).flat_map(|points: Vec<Point>| clipped_chain(room, &points));
        for (part, chain) in beyond.enumerate() {
            canvas.draw_named(&format!("beyond-{part}"), Pen::Beyond, Shape::Polyline(simplified(&chain)));
        }
        let chains = way.lines(canvas, room, one.pieces.iter().map(on_sheet));
        way.limits(canvas, &chains);
        let extent = Extent::of(one.pieces.iter().flatten().map(|(_, place)| *place));
        let centre = view.at(nalgebra::center(&extent.low, &extent.high));
        way.marks(canvas, one.ticks.iter().map(|tick| (tick.value, view.at(tick.place))), centre);
        if let Some(center) = one.own.map(|place| view.at(place)) {
            canvas.draw_named("own", Pen::Joint, Shape::Circle { center, radius: 2.0 * DOT });
            let name = RichText::math(&self.course.shown(&one.name));
            canvas.ask("own", label(name, center, 2.0 * DOT + 0.6, None, 3));
        }
    }
}
