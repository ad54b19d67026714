//! Ways of points and of vectors' tips over a motion: a panel for each, at one scale in both directions, with marks at
//! round values of the drive and at limits.

use super::axis::significant;
use super::course::Course;
use crate::cycle::{Event, Happening};
use crate::drawing::canvas::Canvas;
use crate::drawing::chain::{clipped_chain, simplified};
use crate::drawing::clip::holds;
use crate::drawing::labels::LabelRequest;
use crate::drawing::layout::{HEADING, MARGIN, Needs, Placed, TITLE, on_paper};
use crate::drawing::legend::Entry;
use crate::drawing::panel::{Layer, Panel};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{CAPTION, LABEL, RichText};
use crate::drawing::view::{View, fitting_scale};
use crate::quantity::Kind;
use crate::scene::DecimalMark;
use kurbo::{Point, Rect, Vec2};

/// White between panels, in mm.
const GAP: f64 = 4.0;
/// White around the path inside a panel, for names and numbers, in mm.
const PADDING: f64 = 10.0;
/// Height of the scale at the foot of a panel, in mm.
pub(super) const SCALE: f64 = 8.0;
/// White beside the scale, in mm.
const BESIDE_SCALE: f64 = 2.5;
/// Height below the panels for the key of the numbers, in mm.
const FOOT: f64 = 9.0;
/// Radius of the dot at a marked tip, in mm.
pub(super) const DOT: f64 = 0.65;
/// Marked tips closer than this, in mm, share a dot and a label.
const SHARED: f64 = 0.4;
/// Half the length of the stroke across the path at a limit, in mm.
const STROKE: f64 = 2.4;

/// White in a panel besides that around the way, for the numbers of axes, in mm.
#[derive(Clone, Copy, Default)]
pub(super) struct Sides {
    pub left: f64,
    pub below: f64,
}

/// The sheet with these panels; its `sentences` are for readers who cannot see it.
pub(super) fn sheet(course: &Course<'_>, panels: &[Panel<'_>], beside: Sides, sentences: Vec<String>) -> Drawing {
    let [width, height] = course.dims.page;
    let mut drawing = course.titled(width - MARGIN);
    let line = course.drive();
    let middle = Point::new(0.5 * width, height - MARGIN - 1.8);
    let center = middle + Vec2::new(-0.5 * line.width(CAPTION) - 2.2, -1.3);
    drawing.draw(Pen::Pole, Shape::Circle { center, radius: DOT });
    line.centred(&mut drawing, middle);
    let whole = Rect::new(MARGIN, MARGIN + TITLE, width - MARGIN, height - MARGIN - FOOT);
    for (panel, placed) in panels.iter().zip(places(course, whole, panels, beside)) {
        panel.draw(&mut drawing, &placed, &course.scene.figure.labels, &course.dims, None);
    }
    drawing.description = format!("{}.", sentences.join("; "));
    drawing.enlarged(course.dims.unit)
}

/// The panels' places, in the number of columns that makes the paths largest.
fn places(course: &Course<'_>, whole: Rect, panels: &[Panel<'_>], beside: Sides) -> Vec<Placed> {
    let in_columns = |columns: usize| -> Vec<Placed> {
        let rows = panels.len().div_ceil(columns);
        let width = (whole.width() + GAP) / columns as f64;
        let height = (whole.height() + GAP) / rows as f64;
        let place = |(index, panel): (usize, &Panel<'_>)| {
            let (row, column) = ((index / columns) as f64, (index % columns) as f64);
            let corner = Point::new(whole.x0 + width * column, whole.y0 + height * row);
            let frame = Rect::from_origin_size(corner, (width - GAP, height - GAP));
            let mut area = frame.inset(-PADDING);
            area.x0 += beside.left;
            area.y0 += HEADING - 4.0;
            area.y1 -= SCALE - 4.0 + beside.below;
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

/// The layer with the scale of a panel.
pub(super) fn scale_of<'a>(course: &'a Course<'a>, kind: Kind) -> Box<dyn Layer + 'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| {
        let entry = scale(course, kind, view.mu() / course.dims.unit);
        let frame = canvas.frame();
        let foot = Point::new(frame.x0 + BESIDE_SCALE, frame.y1 - 2.8);
        entry.draw(canvas.drawing, foot);
        canvas.keep_off(Rect::new(frame.x0, foot.y - 4.4, foot.x + entry.width(), frame.y1));
        canvas.exclude_drawn();
    })
}

pub(super) fn label(text: RichText, anchor: Point, clearance: f64, prefer: Option<Vec2>, priority: u8) -> LabelRequest {
    LabelRequest { text, size: LABEL, anchor, clearance, prefer, priority }
}

/// The way in a panel.
pub(super) struct Way<'a> {
    pub course: &'a Course<'a>,
    /// The panel's index, by which a style picks the way's colour.
    pub index: usize,
}

impl Way<'_> {
    /// Draws the pieces of the way as far as they are within `room`; returns these parts.
    pub fn lines(
        &self,
        canvas: &mut Canvas<'_>,
        room: Rect,
        pieces: impl Iterator<Item = Vec<Point>>,
    ) -> Vec<Vec<Point>> {
        let chains: Vec<Vec<Point>> = pieces.flat_map(|points| clipped_chain(room, &points)).collect();
        for (part, chain) in chains.iter().enumerate() {
            let line = Shape::Polyline(simplified(chain));
            canvas.draw_named(&format!("way-{part}"), Pen::Curve, line).number = Some(self.index);
        }
        chains
    }

    /// Draws dots at round values of the drive, with their numbers; coincident tips share a label.
    pub fn marks(&self, canvas: &mut Canvas<'_>, marks: impl Iterator<Item = (f64, Point)>, pole: Point) {
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
    pub fn limits(&self, canvas: &mut Canvas<'_>, chains: &[Vec<Point>]) {
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
