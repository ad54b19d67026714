//! Hodographs: a panel for each vector with the path of its tip, at one scale in both directions, and the vector at the
//! scene's own position.

use super::course::Course;
use super::error::CurvesError;
use super::way::{SCALE, Sides, Way, label, scale_of, sheet};
use crate::cycle::{Hodograph, Hodographs};
use crate::drawing::canvas::Canvas;
use crate::drawing::dims::Dims;
use crate::drawing::layout::{Needs, WHITE};
use crate::drawing::line::Line;
use crate::drawing::panel::{Frame, Layer, Panel, numbered};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::RichText;
use crate::drawing::view::{Extent, View};
use crate::geometry;
use crate::quantity::Kind;
use crate::scene::Scene;
use crate::words::Wording;
use kurbo::{Point, Rect, Vec2};

/// Prefixes of the ids in each panel; a sheet holds as many panels.
const PREFIXES: [&str; 6] = ["hodograph-a", "hodograph-b", "hodograph-c", "hodograph-d", "hodograph-e", "hodograph-f"];
/// The figure of the hodographs of some vectors, on the scene's page.
///
/// # Errors
/// There are too many for a sheet.
pub fn hodographs(scene: &Scene, all: &Hodographs) -> Result<Drawing, CurvesError> {
    let (wanted, room) = (all.hodographs.len(), PREFIXES.len());
    if wanted > room {
        return Err(CurvesError::Panels { wanted, room });
    }
    let words = Wording::of(&scene.figure);
    let course =
        Course { scene, dims: Dims::of(&scene.figure), words, path: all.path, range: all.range, events: &all.events };
    let panels: Vec<Panel<'_>> =
        all.hodographs.iter().enumerate().map(|(index, one)| panel(&course, index, one)).collect();
    let sentences = all.hodographs.iter().map(|one| words.language.hodograph(one.asked.name()));
    Ok(sheet(&course, &panels, Sides::default(), sentences.collect()))
}

/// The panel of a vector with the layers frame, scale and path of its tip.
fn panel<'a>(course: &'a Course<'a>, index: usize, one: &'a Hodograph) -> Panel<'a> {
    let symbol = course.symbol(&one.asked).trim_matches('|').to_owned();
    let sentence = |symbol: &str| numbered(index, &course.words.language.hodograph(symbol));
    let frame = Frame::new(Line::around(sentence, RichText::math(&symbol)), Pen::Caption);
    Panel {
        name: one.asked.name().to_owned(),
        prefix: PREFIXES[index],
        needs: Needs {
            above: 0.0,
            kind: one.asked.kind(),
            extent: Extent::of(one.window.map(geometry::Point::from)),
            heading: frame.width(),
            mu: None,
            white: WHITE,
            weight: 1.0,
        },
        cut: String::new(),
        unlabelled: String::new(),
        content: None,
        layers: vec![
            Box::new(frame),
            scale_of(course, one.asked.kind()),
            Box::new(TipPath { course, index, one, symbol }),
        ],
    }
}

/// The path of a vector's tip.
struct TipPath<'a> {
    course: &'a Course<'a>,
    index: usize,
    one: &'a Hodograph,
    /// Markup of the vector.
    symbol: String,
}

impl Layer for TipPath<'_> {
    fn draw(&self, canvas: &mut Canvas<'_>, view: &View) {
        let one = self.one;
        let at = |v: geometry::Vector| view.at(geometry::Point::from(v));
        let pole = at(nalgebra::zero());
        let notation = self.course.words.notation;
        let (own_pen, pole_name) = match one.asked.kind() {
            Kind::Acceleration => (Pen::Acceleration, notation.acceleration_pole),
            _ => (Pen::Velocity, notation.velocity_pole),
        };
        // Lines end above the scale.
        let room = Rect { y1: canvas.frame().y1 - SCALE, ..canvas.room() };
        for (a, b) in [
            (Point::new(room.x0, pole.y), Point::new(room.x1, pole.y)),
            (Point::new(pole.x, room.y0), Point::new(pole.x, room.y1)),
        ] {
            canvas.draw(Pen::Grid, Shape::Line(a, b));
        }
        let way = Way { course: self.course, index: self.index };
        let pieces = one.pieces.iter().map(|piece| piece.iter().map(|(_, tip)| at(*tip)).collect());
        let chains = way.lines(canvas, room, pieces);
        way.limits(canvas, &chains);
        if let Some(tip) = one.own.map(at)
            && (tip - pole).hypot() > 1e-3
        {
            let vector = canvas.arrow(pole, tip);
            canvas.draw_named("own", own_pen, vector);
            let along = (tip - pole).normalize();
            let prefer = Vec2::new(along.y, -along.x);
            canvas.ask("own", label(RichText::math(&self.symbol), pole.lerp(tip, 0.6), 0.9, Some(prefer), 2));
        }
        way.marks(canvas, one.marks.iter().map(|(value, tip)| (*value, at(*tip))), pole);
        canvas.draw_named("pole", Pen::Pole, Shape::Circle { center: pole, radius: 0.9 });
        canvas.ask("pole", label(RichText::math(pole_name), pole, 1.5, None, 3));
    }
}
