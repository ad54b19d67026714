//! Loci: paths of points, and of vectors' tips (hodographs). A panel for each, at one scale in both directions, with marks
//! at round values of the drive and at limits; paths have the numbers of both axes, hodographs the vector at the scene's
//! own position.

use super::context::{Axis, CurveContext, CurvesError, significant};
use crate::construction::VectorPart;
use crate::cycle::{Event, Happening, Hodograph, Hodographs, PointPath, PointPaths};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{clipped_chain, holds, simplified};
use crate::drawing::held_layout::Pane;
use crate::drawing::labels::LabelRequest;
use crate::drawing::layout::{HEADING, Needs, Placed};
use crate::drawing::lines::Line;
use crate::drawing::panel::{Frame, Layer, Panel, numbered};
use crate::drawing::scale_bar::{ScaleBar, ScaleBars};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{Anchor, CAPTION, PlacedText, RichText};
use crate::drawing::view::{Extent, Series, View, together};
use crate::geometry;
use crate::scene::{DecimalMark, Scene};
use crate::sheet::Sheet;
use kurbo::{Affine, Point, Rect, Vec2};

/// Panels that a sheet holds.
const MOST: usize = 6;
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

/// White in a panel besides that around the curve, for the numbers of axes: on the left and below, in mm.
const NUMBERS: [f64; 2] = [7.0, 5.0];
/// Distance of the axes from the panel's left edge and from the scale at its foot, in mm.
const AXES: [f64; 2] = [13.0, 5.5];
/// Smallest distance of round values on the axes, in mm.
const APART: f64 = 14.0;
/// White between numbers and their axis, in mm.
const BESIDE_AXIS: f64 = 1.2;

/// The figure of the paths of some points, on the scene's page or on a part of a screen.
///
/// # Errors
/// There are too many for a sheet.
pub fn paths(scene: &Scene, all: &PointPaths, pane: Option<Pane>) -> Result<Drawing, CurvesError> {
    let context = CurveContext::new(scene, all, pane);
    let unit = scene.units.length.as_str();
    let sentences = all.curves.iter().map(|one| context.words.language.path_of(&one.name, unit));
    sheet(&context, &path_panels(&context, &all.curves), NUMBERS, sentences.collect())
}

/// Where [`paths`] draws its points: values of the drive with places in mm of the sheet, in pieces without a gap. For
/// programs that mark the points while the drive moves.
#[must_use]
pub fn path_ways(scene: &Scene, all: &PointPaths, pane: Option<Pane>) -> Vec<Vec<(f64, Point)>> {
    let context = CurveContext::new(scene, all, pane);
    let pieces = all.curves.iter().map(|one| one.pieces.clone());
    ways(&context, &path_panels(&context, &all.curves), NUMBERS, pieces)
}

/// The figure of the hodographs of some vectors, on the scene's page or on a part of a screen.
///
/// # Errors
/// There are too many for a sheet.
pub fn hodographs(scene: &Scene, all: &Hodographs, pane: Option<Pane>) -> Result<Drawing, CurvesError> {
    let context = CurveContext::new(scene, all, pane);
    let sentences = all.curves.iter().map(|one| context.words.language.hodograph(one.asked.name()));
    sheet(&context, &hodograph_panels(&context, &all.curves), [0.0; 2], sentences.collect())
}

/// Where [`hodographs`] draws the tips of its vectors, as [`path_ways`].
#[must_use]
pub fn hodograph_ways(scene: &Scene, all: &Hodographs, pane: Option<Pane>) -> Vec<Vec<(f64, Point)>> {
    let context = CurveContext::new(scene, all, pane);
    let on_plane = |piece: &Vec<(f64, geometry::Vector)>| {
        piece.iter().map(|(value, tip)| (*value, geometry::Point::from(*tip))).collect()
    };
    let pieces = all.curves.iter().map(|one| one.pieces.iter().map(on_plane).collect());
    ways(&context, &hodograph_panels(&context, &all.curves), [0.0; 2], pieces)
}

/// The pieces of the curves, one for each panel, on the sheet with these panels.
fn ways(
    context: &CurveContext<'_>,
    panels: &[Panel<'_>],
    numbers: [f64; 2],
    pieces: impl Iterator<Item = Vec<Vec<(f64, geometry::Point)>>>,
) -> Vec<Vec<(f64, Point)>> {
    let enlarged = Affine::scale(context.dims.unit);
    let on_sheet = |(placed, pieces): (Placed, Vec<Vec<(f64, geometry::Point)>>)| {
        let view = placed.view(None);
        let way = move |piece: Vec<(f64, geometry::Point)>| {
            piece.into_iter().map(|(value, place)| (value, enlarged * view.at(place))).collect()
        };
        pieces.into_iter().map(way).collect::<Vec<_>>()
    };
    places(context, panels, numbers).into_iter().zip(pieces).flat_map(on_sheet).collect()
}

/// A panel for each path.
fn path_panels<'a>(context: &'a CurveContext<'a>, all: &'a [PointPath]) -> Vec<Panel<'a>> {
    all.iter().enumerate().map(|(index, one)| path_panel(context, index, one)).collect()
}

/// A panel for each hodograph.
fn hodograph_panels<'a>(context: &'a CurveContext<'a>, all: &'a [Hodograph]) -> Vec<Panel<'a>> {
    all.iter().enumerate().map(|(index, one)| hodograph_panel(context, index, one)).collect()
}

/// The panel of a point with the layers frame, scale, axes and path.
fn path_panel<'a>(context: &'a CurveContext<'a>, index: usize, one: &'a PointPath) -> Panel<'a> {
    let unit = context.scene.units.length.as_str();
    let symbol = RichText::math(&context.shown(&one.name));
    let sentence = |symbol: &str| numbered(index, &context.words.language.path_of(symbol, unit));
    let frame = Frame::new(Line::around(sentence, symbol), Pen::Caption);
    let places = one.pieces.iter().chain(&one.beyond).flatten().map(|(_, place)| *place);
    let needs = Needs::usual(Sheet::Scheme, Extent::of(places), frame.width());
    let axes = |canvas: &mut Canvas<'_>, view: &View| axes(context, canvas, view);
    let locus = Locus { context, index };
    let path = move |canvas: &mut Canvas<'_>, view: &View| locus.path(canvas, view, one);
    let layers: Vec<Layer<'_>> = vec![scale_of(context, Sheet::Scheme), Box::new(axes), Box::new(path)];
    Panel::plain(&one.name, &prefix("path", index), needs, frame, layers)
}

/// The panel of a vector with the layers frame, scale and path of its tip.
fn hodograph_panel<'a>(context: &'a CurveContext<'a>, index: usize, one: &'a Hodograph) -> Panel<'a> {
    let symbol = context.symbol(&one.asked).trim_matches('|').to_owned();
    let sentence = |symbol: &str| numbered(index, &context.words.language.hodograph(symbol));
    let frame = Frame::new(Line::around(sentence, RichText::math(&symbol)), Pen::Caption);
    let sheet = one.asked.sheet();
    let needs = Needs::usual(sheet, Extent::of(one.window.map(geometry::Point::from)), frame.width());
    let locus = Locus { context, index };
    let tip = move |canvas: &mut Canvas<'_>, view: &View| locus.hodograph(canvas, view, one, &symbol);
    let layers: Vec<Layer<'_>> = vec![scale_of(context, sheet), Box::new(tip)];
    Panel::plain(one.asked.name(), &prefix("hodograph", index), needs, frame, layers)
}

/// Prefix of the ids in a panel, as `path-a`.
fn prefix(what: &str, index: usize) -> String {
    format!("{what}-{}", char::from(b'a' + index as u8))
}

/// The sheet with these panels; its `sentences` are for readers who cannot see it.
fn sheet(
    context: &CurveContext<'_>,
    panels: &[Panel<'_>],
    numbers: [f64; 2],
    sentences: Vec<String>,
) -> Result<Drawing, CurvesError> {
    if panels.len() > MOST {
        return Err(CurvesError::Panels { wanted: panels.len(), room: MOST });
    }
    let ([width, height], free) = (context.dims.page, context.dims.free);
    let mut drawing = context.titled(width - free.edge);
    let line = context.drive();
    let middle = Point::new(0.5 * width, height - free.edge - 1.8);
    let center = middle + Vec2::new(-0.5 * line.width(CAPTION) - 2.2, -1.3);
    drawing.draw(Pen::Pole, Shape::Circle { center, radius: DOT });
    line.caption(&mut drawing, middle, 0.5);
    for (panel, placed) in panels.iter().zip(places(context, panels, numbers)) {
        panel.draw(&mut drawing, &placed, &context.scene.figure.labels, &context.dims, None);
    }
    drawing.description = format!("{}.", sentences.join("; "));
    Ok(drawing.enlarged(context.dims.unit))
}

/// The panels' places, in the number of columns that makes the paths largest.
fn places(context: &CurveContext<'_>, panels: &[Panel<'_>], [left, below]: [f64; 2]) -> Vec<Placed> {
    let ([width, height], free) = (context.dims.page, context.dims.free);
    let whole = Rect::new(free.edge, free.top, width - free.edge, height - free.edge - FOOT);
    let in_columns = |columns: usize| -> Vec<Placed> {
        let rows = panels.len().div_ceil(columns);
        let width = (whole.width() + GAP) / columns as f64;
        let height = (whole.height() + GAP) / rows as f64;
        let place = |(index, panel): (usize, &Panel<'_>)| {
            let (row, column) = ((index / columns) as f64, (index % columns) as f64);
            let corner = Point::new(whole.x0 + width * column, whole.y0 + height * row);
            let frame = Rect::from_origin_size(corner, (width - GAP, height - GAP));
            let mut area = frame.inset(-PADDING);
            area.x0 += left;
            area.y0 += HEADING - 4.0;
            area.y1 -= SCALE - 4.0 + below;
            Placed::with_area(&panel.needs, [frame, area], context.dims.unit, series(context))
        };
        panels.iter().enumerate().map(place).collect()
    };
    // First whether every panel is wide enough for its scale, then the size of the paths; of equals the one with more
    // columns.
    let worth = |places: &Vec<Placed>| {
        let width = |placed: &Placed| scale(context, placed.needs.sheet, placed.mu).width() + 2.0 * BESIDE_SCALE;
        let fits = places.iter().all(|placed| width(placed) <= placed.frame.width());
        (fits, places.iter().map(Placed::size).product::<f64>())
    };
    let divisions = (1..=panels.len().max(1)).map(in_columns);
    let best = divisions.max_by(|a, b| {
        let (a, b) = (worth(a), worth(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    best.unwrap_or_default()
}

/// The scale of a panel, with its bar.
fn scale(context: &CurveContext<'_>, sheet: Sheet, mu: f64) -> ScaleBar {
    let (units, unit, series) = (context.scene.units, context.dims.unit, series(context));
    ScaleBars { words: context.words, units, unit, series }.bar(sheet, mu)
}

/// From which the scales are: on a screen nobody lays a ruler.
fn series(context: &CurveContext<'_>) -> Series {
    if context.dims.has_title() { Series::Ruler } else { Series::Any }
}

/// The layer with the scale of a panel.
fn scale_of<'a>(context: &'a CurveContext<'a>, sheet: Sheet) -> Layer<'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| {
        let entry = scale(context, sheet, view.mu() / context.dims.unit);
        let frame = canvas.frame;
        let foot = Point::new(frame.x0 + BESIDE_SCALE, frame.y1 - 2.8);
        entry.draw(canvas.drawing, foot, None);
        canvas.obstacles.add_boxes([Rect::new(frame.x0, foot.y - 4.4, foot.x + entry.width(), frame.y1)]);
        canvas.exclude_drawn();
    })
}

/// The area of the path in its panel.
fn room_of_path(canvas: &Canvas<'_>) -> Rect {
    let frame = canvas.frame;
    Rect { x0: frame.x0 + AXES[0], y1: frame.y1 - SCALE - AXES[1], ..canvas.room() }
}

/// Draws the axes: lines at round values, and numbers below and on the left.
fn axes(context: &CurveContext<'_>, canvas: &mut Canvas<'_>, view: &View) {
    let room = room_of_path(canvas);
    let origin = view.at(geometry::Point::origin());
    let [left, right] = [room.x0, room.x1].map(|x| (x - origin.x) * view.mu());
    let [low, high] = [room.y1, room.y0].map(|y| (origin.y - y) * view.mu());
    let across = Axis::new(context.words, [left, right], [room.x0, room.x1], APART, false);
    let up = Axis::new(context.words, [low, high], [room.y1, room.y0], APART, false);
    for (x, text) in across.numbers() {
        canvas.draw(Pen::Grid, Shape::Line(Point::new(x, room.y0), Point::new(x, room.y1)));
        let half = 0.5 * text.width(CAPTION);
        if x - half > room.x0 - 2.0 && x + half < room.x1 {
            number(canvas, text, Point::new(x - half, room.y1 + BESIDE_AXIS + 3.2), Anchor::Middle);
        }
    }
    for (y, text) in up.numbers() {
        canvas.draw(Pen::Grid, Shape::Line(Point::new(room.x0, y), Point::new(room.x1, y)));
        let from = Point::new(room.x0 - BESIDE_AXIS - text.width(CAPTION), y + 1.5);
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

/// A curve in its panel.
struct Locus<'a> {
    context: &'a CurveContext<'a>,
    /// The panel's index, by which a style picks the curve's colour.
    index: usize,
}

impl Locus<'_> {
    /// Draws the path of a point.
    fn path(&self, canvas: &mut Canvas<'_>, view: &View, one: &PointPath) {
        let room = room_of_path(canvas);
        let on_sheet = |piece: &Vec<(f64, geometry::Point)>| piece.iter().map(|(_, place)| view.at(*place)).collect();
        let beyond = one.beyond.iter().map(on_sheet).flat_map(|points: Vec<Point>| clipped_chain(room, &points));
        for (part, chain) in beyond.enumerate() {
            canvas.draw_named(&format!("beyond-{part}"), Pen::Beyond, Shape::Polyline(simplified(&chain)));
        }
        let chains = self.lines(canvas, room, one.pieces.iter().map(on_sheet));
        self.limits(canvas, &chains);
        let extent = Extent::of(one.pieces.iter().flatten().map(|(_, place)| *place));
        let centre = view.at(nalgebra::center(&extent.low, &extent.high));
        self.marks(canvas, one.ticks.iter().map(|tick| (tick.value, view.at(tick.place))), centre);
        if let Some(center) = one.own.map(|place| view.at(place)) {
            canvas.draw_named("own", Pen::Joint, Shape::Circle { center, radius: 2.0 * DOT });
            let name = RichText::math(&self.context.shown(&one.name));
            canvas.ask("own", LabelRequest::new(name, center, 2.0 * DOT + 0.6, None, 3));
        }
    }

    /// Draws the path of a vector's tip from the pole, and the vector, whose markup is `symbol`, at the scene's own position.
    fn hodograph(&self, canvas: &mut Canvas<'_>, view: &View, one: &Hodograph, symbol: &str) {
        let at = |v: geometry::Vector| view.at(geometry::Point::from(v));
        let pole = at(nalgebra::zero());
        let notation = self.context.words.notation;
        let order = one.asked.order().expect("a vector is a velocity or an acceleration");
        let own_pen = Pen::of_vectors(order, VectorPart::Whole);
        let pole_name = notation.pole(order);
        // Lines end above the scale.
        let room = Rect { y1: canvas.frame.y1 - SCALE, ..canvas.room() };
        for (a, b) in [
            (Point::new(room.x0, pole.y), Point::new(room.x1, pole.y)),
            (Point::new(pole.x, room.y0), Point::new(pole.x, room.y1)),
        ] {
            canvas.draw(Pen::Grid, Shape::Line(a, b));
        }
        let pieces = one.pieces.iter().map(|piece| piece.iter().map(|(_, tip)| at(*tip)).collect());
        let chains = self.lines(canvas, room, pieces);
        self.limits(canvas, &chains);
        if let Some(tip) = one.own.map(at)
            && (tip - pole).hypot() > 1e-3
        {
            let vector = canvas.arrow(pole, tip);
            canvas.draw_named("own", own_pen, vector);
            let along = (tip - pole).normalize();
            let prefer = Vec2::new(along.y, -along.x);
            canvas.ask("own", LabelRequest::new(RichText::math(symbol), pole.lerp(tip, 0.6), 0.9, Some(prefer), 2));
        }
        self.marks(canvas, one.marks.iter().map(|(value, tip)| (*value, at(*tip))), pole);
        canvas.draw_named("pole", Pen::Pole, Shape::Circle { center: pole, radius: 0.9 });
        canvas.ask("pole", LabelRequest::new(RichText::math(pole_name), pole, 1.5, None, 3));
    }

    /// Draws the pieces of the curve as far as they are within `room`; returns these parts.
    fn lines(&self, canvas: &mut Canvas<'_>, room: Rect, pieces: impl Iterator<Item = Vec<Point>>) -> Vec<Vec<Point>> {
        let chains: Vec<Vec<Point>> = pieces.flat_map(|points| clipped_chain(room, &points)).collect();
        for (part, chain) in chains.iter().enumerate() {
            let line = Shape::Polyline(simplified(chain));
            canvas.draw_named(&format!("way-{part}"), Pen::Curve, line).number = Some(self.index);
        }
        chains
    }

    /// Draws dots at round values of the drive, with their numbers; coincident tips share a label.
    fn marks(&self, canvas: &mut Canvas<'_>, marks: impl Iterator<Item = (f64, Point)>, pole: Point) {
        for (center, values) in together(marks.map(|(value, tip)| (tip, value)), SHARED) {
            if !holds(canvas.obstacles.bounds, center) {
                continue;
            }
            let name = significant(6).write(values[0], DecimalMark::Point);
            let dot = Shape::Circle { center, radius: DOT };
            let mark = canvas.draw_named(&format!("tip-{name}"), Pen::Curve, dot);
            mark.number = Some(self.index);
            let numbers: Vec<String> = values.iter().map(|v| self.context.number(*v, 6)).collect();
            let away = center - pole;
            let prefer = (away.hypot() > 1.0).then(|| away.normalize());
            let text = RichText::plain(&numbers.join("; "));
            canvas.ask(&format!("tip-{name}"), LabelRequest::new(text, center, DOT + 0.6, prefer, 1));
        }
    }

    /// Draws strokes across the path at its ends in limit positions.
    fn limits(&self, canvas: &mut Canvas<'_>, chains: &[Vec<Point>]) {
        let [low, high] = self.context.range;
        let is_end = |event: &&Event| {
            matches!(event.what, Happening::Limit(_) | Happening::Singular(_) | Happening::Leaves { .. })
        };
        for event in self.context.events.iter().filter(is_end) {
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
            let along = end - before;
            if along.hypot() == 0.0 {
                continue;
            }
            let across = Vec2::new(-along.y, along.x).normalize() * STROKE;
            canvas.draw(Pen::Zero, Shape::Line(end - across, end + across));
            let words = format!("{} {}", self.context.words.language.limit(), self.context.drive_value(event.at));
            let name = format!("limit-{}", if near(event.at, low) { "low" } else { "high" });
            canvas.ask(&name, LabelRequest::new(RichText::plain(&words), end, STROKE, None, 2));
        }
    }
}
