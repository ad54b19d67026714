//! Hodographs: a panel for each vector with the path of its tip, at one scale in both directions, and the vector at the
//! scene's own position.

use super::axis::significant;
use super::course::Course;
use super::error::CurvesError;
use super::lines::{clipped_chain, simplified};
use crate::cycle::{Event, Happening, Hodograph, Hodographs};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::holds;
use crate::drawing::dims::Dims;
use crate::drawing::labels::LabelRequest;
use crate::drawing::layout::{HEADING, MARGIN, Needs, Placed, TITLE, on_paper};
use crate::drawing::legend::Entry;
use crate::drawing::line::Line;
use crate::drawing::panel::{Frame, Layer, Panel, numbered};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{CAPTION, LABEL, RichText};
use crate::drawing::view::{Extent, View, fitting_scale};
use crate::geometry;
use crate::quantity::Kind;
use crate::scene::{DecimalMark, Scene};
use crate::words::Wording;
use kurbo::{Point, Rect, Vec2};

/// Prefixes of the ids in each panel; a sheet holds as many panels.
const PREFIXES: [&str; 6] = ["hodograph-a", "hodograph-b", "hodograph-c", "hodograph-d", "hodograph-e", "hodograph-f"];
/// White between panels, in mm.
const GAP: f64 = 4.0;
/// White around the path inside a panel, for names and numbers, in mm.
const PADDING: f64 = 10.0;
/// Height of the scale at the foot of a panel, in mm.
const SCALE: f64 = 8.0;
/// White beside the scale, in mm.
const BESIDE_SCALE: f64 = 2.5;
/// Height below the panels for the key of the numbers, in mm.
const FOOT: f64 = 9.0;
/// Radius of the dot at a marked tip, in mm.
const DOT: f64 = 0.65;
/// Marked tips closer than this, in mm, share a dot and a label.
const SHARED: f64 = 0.4;
/// Half the length of the stroke across the path at a limit, in mm.
const STROKE: f64 = 2.4;

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
    let [width, height] = course.dims.page;
    let mut drawing = course.titled(width - MARGIN);
    let line = course.drive();
    let middle = Point::new(0.5 * width, height - MARGIN - 1.8);
    let center = middle + Vec2::new(-0.5 * line.width(CAPTION) - 2.2, -1.3);
    drawing.draw(Pen::Pole, Shape::Circle { center, radius: DOT });
    line.centred(&mut drawing, middle);
    let whole = Rect::new(MARGIN, MARGIN + TITLE, width - MARGIN, height - MARGIN - FOOT);
    for (panel, placed) in panels.iter().zip(places(&course, whole, &panels)) {
        panel.draw(&mut drawing, &placed, &scene.figure.labels, &course.dims);
    }
    let sentences: Vec<String> = all.hodographs.iter().map(|one| words.language.hodograph(one.asked.name())).collect();
    drawing.description = format!("{}.", sentences.join("; "));
    Ok(drawing.enlarged(course.dims.unit))
}

/// The panels' places, in the number of columns that makes the paths largest.
fn places(course: &Course<'_>, whole: Rect, panels: &[Panel<'_>]) -> Vec<Placed> {
    let in_columns = |columns: usize| -> Vec<Placed> {
        let rows = panels.len().div_ceil(columns);
        let width = (whole.width() + GAP) / columns as f64;
        let height = (whole.height() + GAP) / rows as f64;
        let place = |(index, panel): (usize, &Panel<'_>)| {
            let (row, column) = ((index / columns) as f64, (index % columns) as f64);
            let corner = Point::new(whole.x0 + width * column, whole.y0 + height * row);
            let frame = Rect::from_origin_size(corner, (width - GAP, height - GAP));
            let mut area = frame.inset(-PADDING);
            area.y0 += HEADING - 4.0;
            area.y1 -= SCALE - 4.0;
            let Needs { kind, extent, .. } = panel.needs;
            let unit = course.dims.unit;
            Placed { kind, frame, area, mu: fitting_scale(&extent, on_paper(area, unit)), unit }
        };
        panels.iter().enumerate().map(place).collect()
    };
    // First whether every panel is wide enough for its scale, then the size of the paths; of equals the one with more
    // columns.
    let worth = |places: &Vec<Placed>| {
        let width = |placed: &Placed| scale(course, placed.kind, placed.mu).width() + 2.0 * BESIDE_SCALE;
        let fits = places.iter().all(|placed| width(placed) <= placed.frame.width());
        let sizes = places.iter().zip(panels).map(|(placed, panel)| placed.shown(&panel.needs.extent).norm());
        (fits, sizes.product::<f64>())
    };
    let ways = (1..=panels.len().max(1)).map(in_columns);
    let best = ways.max_by(|a, b| {
        let (a, b) = (worth(a), worth(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    best.unwrap_or_default()
}

/// The scale of a panel, with its bar.
fn scale(course: &Course<'_>, kind: Kind, mu: f64) -> Entry {
    Entry::new(kind, mu, &course.words, course.scene.units, &course.dims)
}

/// The panel of a vector with the layers frame, scale and path of its tip.
fn panel<'a>(course: &'a Course<'a>, index: usize, one: &'a Hodograph) -> Panel<'a> {
    let symbol = course.symbol(&one.asked).trim_matches('|').to_owned();
    let sentence = |symbol: &str| numbered(index, &course.words.language.hodograph(symbol));
    let frame = Frame::new(Line::around(sentence, RichText::math(&symbol)), Pen::Caption);
    let kind = one.asked.kind();
    let scale = move |canvas: &mut Canvas<'_>, view: &View| {
        let entry = scale(course, kind, view.mu() / course.dims.unit);
        let frame = canvas.frame();
        let foot = Point::new(frame.x0 + BESIDE_SCALE, frame.y1 - 2.8);
        entry.draw(canvas.drawing, foot);
        canvas.keep_off(Rect::new(frame.x0, foot.y - 4.4, foot.x + entry.width(), frame.y1));
        canvas.exclude_drawn();
    };
    Panel {
        name: one.asked.name().to_owned(),
        prefix: PREFIXES[index],
        needs: Needs {
            kind,
            extent: Extent::of(one.window.map(geometry::Point::from)),
            heading: frame.width(),
            mu: None,
            weight: 1.0,
        },
        cut: String::new(),
        layers: vec![Box::new(frame), Box::new(scale), Box::new(TipPath { course, index, one, symbol })],
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
        let mut chains: Vec<Vec<Point>> = Vec::new();
        for piece in &one.pieces {
            let points: Vec<Point> = piece.iter().map(|(_, tip)| at(*tip)).collect();
            chains.extend(clipped_chain(room, &points));
        }
        for (part, chain) in chains.iter().enumerate() {
            let line = Shape::Polyline(simplified(chain));
            canvas.draw_named(&format!("way-{part}"), Pen::Curve, line).number = Some(self.index);
        }
        self.limits(canvas, &chains);
        if let Some(tip) = one.own.map(at)
            && (tip - pole).hypot() > 1e-3
        {
            let vector = canvas.arrow(pole, tip);
            canvas.draw_named("own", own_pen, vector);
            let along = (tip - pole).normalize();
            let prefer = Vec2::new(along.y, -along.x);
            canvas.ask("own", label(RichText::math(&self.symbol), pole.lerp(tip, 0.6), 0.9, Some(prefer), 2));
        }
        self.marks(canvas, one.marks.iter().map(|(value, tip)| (*value, at(*tip))), pole);
        canvas.draw_named("pole", Pen::Pole, Shape::Circle { center: pole, radius: 0.9 });
        canvas.ask("pole", label(RichText::math(pole_name), pole, 1.5, None, 3));
    }
}

fn label(text: RichText, anchor: Point, clearance: f64, prefer: Option<Vec2>, priority: u8) -> LabelRequest {
    LabelRequest { text, size: LABEL, anchor, clearance, prefer, priority }
}

impl TipPath<'_> {
    /// Draws dots at round values of the drive, with their numbers; coincident tips share a label.
    fn marks(&self, canvas: &mut Canvas<'_>, marks: impl Iterator<Item = (f64, Point)>, pole: Point) {
        let mut places: Vec<(Point, Vec<f64>)> = Vec::new();
        for (value, tip) in marks {
            let shared = places.iter_mut().find(|(place, _)| (*place - tip).hypot() < SHARED);
            match shared {
                Some((_, values)) => values.push(value),
                None => places.push((tip, vec![value])),
            }
        }
        for (center, values) in places {
            if !holds(canvas.bounds(), center) {
                continue;
            }
            let name = significant(6).write(values[0], DecimalMark::Point);
            let dot = Shape::Circle { center, radius: DOT };
            let mark = canvas.draw_named(&format!("tip-{name}"), Pen::Curve, dot);
            mark.number = Some(self.index);
            let numbers: Vec<String> = values.iter().map(|v| self.course.number(*v, 6)).collect();
            let away = center - pole;
            let prefer = (away.hypot() > 1.0).then(|| away.normalize());
            let text = RichText::plain(&numbers.join("; "));
            canvas.ask(&format!("tip-{name}"), label(text, center, DOT + 0.6, prefer, 1));
        }
    }

    /// Draws strokes across the path at its ends in limit positions.
    fn limits(&self, canvas: &mut Canvas<'_>, chains: &[Vec<Point>]) {
        let [low, high] = self.course.range;
        let is_end = |event: &&Event| matches!(event.what, Happening::Limit { .. } | Happening::Singular { .. });
        for event in self.course.events.iter().filter(is_end) {
            let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * (high - low);
            let end = if near(event.at, low) {
                chains.first().map(|chain| (chain[0], chain[1]))
            } else if near(event.at, high) {
                let last = chains.last();
                last.map(|chain| (chain[chain.len() - 1], chain[chain.len() - 2]))
            } else {
                None
            };
            let Some((end, before)) = end else { continue };
            let way = end - before;
            if way.hypot() == 0.0 {
                continue;
            }
            let across = Vec2::new(-way.y, way.x).normalize() * STROKE;
            canvas.draw(Pen::Zero, Shape::Line(end - across, end + across));
            let words = format!("{} {}", self.course.words.language.limit(), self.course.drive_value(event.at));
            let name = format!("limit-{}", if near(event.at, low) { "low" } else { "high" });
            canvas.ask(&name, label(RichText::plain(&words), end, STROKE, None, 2));
        }
    }
}
