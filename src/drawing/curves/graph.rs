use super::context::{Axis, CurveContext};
use crate::cycle::{CertainExtreme, Curve};
use crate::drawing::canvas::{Canvas, Wanted};
use crate::drawing::clip::{clipped_chain, clipped_segment, distance, simplified};
use crate::drawing::labels::LabelRequest;
use crate::drawing::lines::Line;
use crate::drawing::panel::{Frame, numbered};
use crate::drawing::shape::{Shape, corners, distance_to_box};
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{CAPTION, LABEL, PlacedText, RichText};
use crate::quantity::QuantityKind;
use crate::words::{Language, Wording, power_of_ten};
use kurbo::{Point, Rect, Size, Vec2};

/// Radius of the dot at an extreme value, in mm.
pub(super) const DOT: f64 = 0.75;
/// Radius of the circle at a dead centre, in mm.
pub(super) const DEAD: f64 = 0.8;
/// Most names of one curve that are shown.
const MOST_NAMES: usize = 4;
/// White above the highest and below the lowest value, for the values beside the dots: in mm, and at most this part of
/// the panel.
const BORDER: f64 = 6.2;
const MOST_BORDER: f64 = 0.17;
/// Smallest distance of round values: in mm, and at least this part of the panel.
const APART: f64 = 7.5;
const LEAST_APART: f64 = 0.1;

/// White between numbers and their axis, in mm.
pub(super) const BESIDE: f64 = 1.6;

/// The curves of one kind of quantity over the drive.
pub(super) struct Graph<'a> {
    pub kind: QuantityKind,
    /// Its curves, each with the number of its colour and dash.
    pub curves: Vec<(&'a Curve, usize)>,
    /// By curve: its least and greatest value.
    pub extremes: Vec<[Option<CertainExtreme>; 2]>,
    /// On the sheet, in mm: top of its heading, top and bottom of its area.
    pub rows: [f64; 3],
    axis: Axis,
}

impl<'a> Graph<'a> {
    pub(super) fn new(
        words: Wording,
        kind: QuantityKind,
        curves: Vec<(&'a Curve, usize)>,
        extremes: Vec<[Option<CertainExtreme>; 2]>,
        rows: [f64; 3],
    ) -> Graph<'a> {
        let zero = kind.is_rate().then_some(0.0);
        let shown = curves.iter().flat_map(|(curve, _)| curve.window).chain(zero);
        let [mut low, mut high] = shown.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], y| [a.min(y), b.max(y)]);
        if low == high {
            // A single constant needs a range around it.
            let room = if low == 0.0 { 1.0 } else { 0.5 * low.abs() };
            (low, high) = (low - room, high + room);
        }
        let height = rows[2] - rows[1];
        let border = BORDER.min(MOST_BORDER * height);
        let more = (high - low) * border / (height - 2.0 * border);
        let ends = [low - more, high + more];
        let apart = APART.max(LEAST_APART * height);
        let axis = Axis::new(words, ends, [rows[2], rows[1]], apart, kind == QuantityKind::Angle);
        Graph { kind, curves, extremes, rows, axis }
    }

    /// Width of the widest number beside its axis, in mm.
    pub(super) fn widest_number(&self) -> f64 {
        self.axis.numbers().map(|(_, number)| number.width(CAPTION)).fold(0.0, f64::max)
    }

    /// Draws the graph with its grid, frame and curves.
    pub(super) fn draw(&self, drawing: &mut Drawing, index: usize, context: &CurveContext<'_>, drive: &Axis) {
        let unit = self.kind.unit(context.scene.units);
        let unit = match self.axis.power {
            0 => unit,
            power => format!("{} {unit}", power_of_ten(power)),
        };
        let (name, prefix) = names(context.words.language, self.kind);
        let heading = numbered(index, &context.words.language.in_unit(name, &unit));
        let heading = Line::new(vec![RichText::plain(&heading)]);
        let at = Vec2::new(0.0, self.rows[0] + 5.2 - self.rows[1]);
        let frame = Frame { at, ..Frame::new(heading, Pen::Heading) };
        let area = Rect::new(drive.places[0], self.rows[1], drive.places[1], self.rows[2]);
        let mut canvas = Canvas::new(drawing, [name, prefix], area, &context.scene.figure.labels, context.dims);
        self.grid(canvas.drawing, area, drive);
        frame.draw(&mut canvas, None);
        self.content(&mut canvas, context, drive);
        canvas.finish(None);
    }

    /// Lines at round values, and their numbers.
    fn grid(&self, drawing: &mut Drawing, frame: Rect, drive: &Axis) {
        let inside = |at: f64, [a, b]: [f64; 2]| (at - a).abs() > 0.1 && (at - b).abs() > 0.1;
        for (y, number) in self.axis.numbers() {
            if inside(y, self.axis.places) {
                drawing.draw(Pen::Grid, Shape::Line(Point::new(frame.x0, y), Point::new(frame.x1, y)));
            }
            let end = Point::new(frame.x0 - BESIDE, y + 0.33 * CAPTION);
            drawing.draw(Pen::Caption, Shape::Text(PlacedText::ending_at(number, CAPTION, end)));
        }
        for x in drive.ticks.iter().map(|tick| drive.at(*tick)).filter(|x| inside(*x, drive.places)) {
            drawing.draw(Pen::Grid, Shape::Line(Point::new(x, frame.y0), Point::new(x, frame.y1)));
        }
    }

    /// Draws lines at zero and at marked values of the drive, the curves, their extreme values and names.
    fn content(&self, canvas: &mut Canvas<'_>, context: &CurveContext<'_>, drive: &Axis) {
        let frame = canvas.frame;
        let place = |at: f64, value: f64| Point::new(drive.at(at), self.axis.at(value));
        let mut straight = Vec::new();
        if self.axis.ends[0] < 0.0 && self.axis.ends[1] > 0.0 {
            let y = self.axis.at(0.0);
            straight.push((Pen::Zero, Point::new(frame.x0, y), Point::new(frame.x1, y)));
        }
        for (pen, value) in context.verticals() {
            let x = drive.at(value);
            straight.push((pen, Point::new(x, frame.y0), Point::new(x, frame.y1)));
        }
        for (pen, a, b) in &straight {
            canvas.draw(*pen, Shape::Line(*a, *b));
        }
        let lines: Vec<Vec<Vec<Point>>> = self.curves.iter().map(|curve| line(canvas, curve, place)).collect();
        for curve in &self.curves {
            dots(canvas, curve, place);
        }
        // Names keep off the extreme values, which are at their preferred places.
        let mut taken = Vec::new();
        for (curve, extremes) in self.curves.iter().zip(&self.extremes) {
            self.values(canvas, curve, extremes, &mut taken, place);
        }
        let straight: Vec<(Point, Point)> = straight.iter().map(|(_, a, b)| (*a, *b)).collect();
        let around = Surroundings { frame, curves: &lines, lines: &straight };
        for (index, ((curve, look), extremes)) in self.curves.iter().zip(&self.extremes).enumerate() {
            let text = RichText::math(&self.name(context, canvas, curve, extremes));
            let size = text.ink_box(LABEL).size();
            let Some((anchor, toward, area)) = name_place(index, size, &around, &taken) else {
                continue;
            };
            taken.push(area);
            let request = LabelRequest::new(text, anchor, CLEARANCE, Some(toward), 3);
            let wanted = canvas.ask(curve.asked[0].name(), request);
            (wanted.pen, wanted.number) = (Pen::Curve, Some(*look));
        }
    }

    /// Requests labels of the extremes: one for the greatest and one for the least value.
    fn values(
        &self,
        canvas: &mut Canvas<'_>,
        (curve, look): &(&Curve, usize),
        extremes: &[Option<CertainExtreme>; 2],
        taken: &mut Vec<Rect>,
        place: impl Fn(f64, f64) -> Point,
    ) {
        let dots = curve.extremes.iter().map(|e| place(e.at, e.value));
        taken.extend(dots.map(|dot| Rect::from_center_size(dot, (2.0 * DOT, 2.0 * DOT))));
        for (greatest, found) in [false, true].into_iter().zip(extremes) {
            let Some((first, found)) = curve.extremes.iter().find(|e| e.greatest == greatest).zip(found.as_ref())
            else {
                continue;
            };
            let up = if greatest { -1.0 } else { 1.0 };
            let text = RichText::plain(&self.axis.value(found));
            let (anchor, prefer) = (place(first.at, first.value), Some(Vec2::new(0.0, up)));
            let request = LabelRequest { size: CAPTION, ..LabelRequest::new(text, anchor, DOT + 0.5, prefer, 2) };
            let size = request.text.ink_box(request.size).size();
            let middle = Vec2::new(0.0, up * (request.clearance + 0.5 * size.height));
            taken.push(Rect::from_center_size(request.anchor + middle, size));
            let word = if greatest { "greatest" } else { "least" };
            let name = format!("{word}-{}", curve.asked[0].name());
            let wanted = Wanted::new(name, request);
            canvas.request_label(Wanted { pen: Pen::Curve, number: Some(*look), optional: true, ..wanted });
        }
    }

    /// The symbol of a curve, as in `ω_2 = ω_3`; with its value if it is constant.
    fn name(
        &self,
        context: &CurveContext<'_>,
        canvas: &Canvas<'_>,
        curve: &Curve,
        [constant, _]: &[Option<CertainExtreme>; 2],
    ) -> String {
        let mut parts: Vec<String> = Vec::new();
        for asked in &curve.asked {
            let symbol = canvas.shown(asked.name(), &context.symbol(asked));
            if !parts.contains(&symbol) {
                parts.push(symbol);
            }
        }
        if parts.len() > MOST_NAMES {
            parts.truncate(MOST_NAMES);
            parts.push("…".to_owned());
        }
        parts.extend(constant.as_ref().filter(|_| curve.constant.is_some()).map(|found| self.axis.value(found)));
        parts.join(" = ")
    }
}

/// Draws a curve; returns its lines on the sheet.
fn line(
    canvas: &mut Canvas<'_>,
    (curve, look): &(&Curve, usize),
    place: impl Fn(f64, f64) -> Point,
) -> Vec<Vec<Point>> {
    let frame = canvas.frame;
    let chains = curve.pieces.iter().flat_map(|piece| {
        let points: Vec<Point> = piece.iter().map(|[x, y]| place(*x, *y)).collect();
        clipped_chain(frame, &points)
    });
    let chains: Vec<Vec<Point>> = chains.map(|chain| simplified(&chain)).collect();
    for (part, chain) in chains.iter().enumerate() {
        let name = format!("curve-{}-{part}", curve.asked[0].name());
        canvas.draw_named(&name, Pen::Curve, Shape::Polyline(chain.clone())).number = Some(*look);
    }
    chains
}

/// Draws the dots of a curve's dead centres and extremes.
fn dots(canvas: &mut Canvas<'_>, (curve, look): &(&Curve, usize), place: impl Fn(f64, f64) -> Point) {
    for (index, at) in curve.dead.iter().enumerate() {
        let name = format!("dead-{}-{index}", curve.asked[0].name());
        let circle = Shape::Circle { center: place(*at, 0.0), radius: DEAD };
        canvas.draw_named(&name, Pen::Dead, circle).number = Some(*look);
    }
    for extreme in &curve.extremes {
        let dot = Shape::Circle { center: place(extreme.at, extreme.value), radius: DOT };
        canvas.draw(Pen::Curve, dot).number = Some(*look);
    }
}

/// The name of a kind of quantity, and the prefix of the ids in its graph.
fn names(language: &Language, kind: QuantityKind) -> (&str, &'static str) {
    match kind {
        QuantityKind::Angle => (language.angle(), "angle"),
        QuantityKind::AngularVelocity => (language.angular_velocity(), "omega"),
        QuantityKind::AngularAcceleration => (language.angular_acceleration(), "alpha"),
        QuantityKind::RotationalSpeed => (language.rotational_speed(), "rpm"),
        QuantityKind::SpeedRatio => (language.speed_ratio(), "ratio"),
        QuantityKind::Position => (language.position(), "position"),
        QuantityKind::Length => (language.length(), "length"),
        QuantityKind::Velocity => (language.velocity(), "velocity"),
        QuantityKind::Acceleration => (language.acceleration(), "acceleration"),
        QuantityKind::Force => (language.force(), "force"),
        QuantityKind::Moment => (language.moment(), "moment"),
        QuantityKind::Power => (language.power(), "power"),
    }
}

/// White between a curve and its name, in mm.
const CLEARANCE: f64 = 0.9;

/// Distance along a curve between the places for its name that are tried, in mm.
const STEP: f64 = 3.0;

/// Distance to other things, in mm, above which a place is not better.
const ROOM: f64 = 7.0;

/// The obstacles for a name, on the sheet.
struct Surroundings<'a> {
    frame: Rect,
    /// The lines of all curves, also of the named one.
    curves: &'a [Vec<Vec<Point>>],
    /// Straight lines, which names should keep off.
    lines: &'a [(Point, Point)],
}

/// The best place for the name of a curve: a point of the curve, the direction from it to the name, and the name's box;
/// none if no place is in the frame.
///
/// Places all along the curve, above and below it, are compared by their distance from other curves and from `taken`
/// boxes; of equals the rightmost one wins.
fn name_place(named: usize, size: Size, around: &Surroundings<'_>, taken: &[Rect]) -> Option<(Point, Vec2, Rect)> {
    let mut best: Option<(f64, (Point, Vec2, Rect))> = None;
    for anchor in around.curves[named].iter().flat_map(|part| along(part)) {
        for up in [-1.0, 1.0] {
            let toward = Vec2::new(0.0, up);
            let centre = anchor + toward * (CLEARANCE + 0.5 * size.height);
            let area = Rect::from_center_size(centre, size);
            if around.frame.inset(-1.5).union(area) != around.frame.inset(-1.5) {
                continue;
            }
            let least = best.as_ref().map_or(f64::NEG_INFINITY, |best| best.0);
            let room = room(named, area, around, taken, least);
            if room >= least {
                best = Some((room, (anchor, toward, area)));
            }
        }
    }
    best.map(|(_, place)| place)
}

/// Points of a line at equal steps.
fn along(line: &[Point]) -> Vec<Point> {
    let mut places = Vec::new();
    let mut left = 0.5 * STEP;
    for ends in line.windows(2) {
        let run = ends[1] - ends[0];
        let length = run.hypot2().sqrt();
        while left < length {
            places.push(ends[0] + run * (left / length));
            left += STEP;
        }
        left -= length;
    }
    places
}

/// The distance of a box from other things, in mm, negative where they overlap; or any value less than `least` if the
/// distance is less.
fn room(named: usize, area: Rect, around: &Surroundings<'_>, taken: &[Rect], least: f64) -> f64 {
    let mut room = ROOM;
    for other in taken {
        room = room.min(apart(area, *other).clamp(-1.0, ROOM));
    }
    for (a, b) in around.lines {
        room = room.min(gap_to_line(area, *a, *b) + 1.0);
    }
    for (index, curve) in around.curves.iter().enumerate() {
        for ends in curve.iter().flat_map(|part| part.windows(2)) {
            if room < least {
                return room;
            }
            // The named curve may be as near as its clearance.
            let near = if index == named { 0.8 * CLEARANCE } else { room };
            if apart(area, Rect::from_points(ends[0], ends[1])) >= near {
                continue;
            }
            let gap = gap_to_line(area, ends[0], ends[1]);
            let left = if index == named {
                ROOM + 12.0 * (gap - near).min(0.0)
            } else if gap > 0.0 {
                gap
            } else {
                -ROOM
            };
            room = room.min(left);
        }
    }
    room
}

/// The distance of two boxes in x or in y, the larger one; negative where they overlap.
fn apart(a: Rect, b: Rect) -> f64 {
    let across = (a.x0 - b.x1).max(b.x0 - a.x1);
    let down = (a.y0 - b.y1).max(b.y0 - a.y1);
    across.max(down)
}

/// The distance between a box and a straight line; 0 where they touch.
fn gap_to_line(area: Rect, a: Point, b: Point) -> f64 {
    let ends = distance_to_box(area, a).min(distance_to_box(area, b));
    if ends == 0.0 || clipped_segment(area, a, b).is_some() {
        return 0.0;
    }
    corners(area).map(|corner| distance(corner, a, b)).into_iter().fold(ends, f64::min)
}
