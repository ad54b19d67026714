use super::axis::Axis;
use super::lines::{clipped_chain, simplified};
use super::names::{CLEARANCE, Surroundings, name_place};
use super::{BESIDE, Sheet, words};
use crate::cycle::Curve;
use crate::drawing::canvas::{CAPTION, Canvas, LABEL, Wanted};
use crate::drawing::labels::LabelRequest;
use crate::drawing::legend::corners;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::text::{PlacedText, RichText};
use crate::quantity::Kind;
use crate::words::power_of_ten;
use kurbo::{Point, Rect, Vec2};

/// Radius of the dot at a greatest or least value.
pub(super) const DOT: f64 = 0.75;
/// Radius of the circle at a dead centre.
pub(super) const DEAD: f64 = 0.8;
/// So many of a curve's names are shown.
const MOST_NAMES: usize = 4;
/// Size of the values beside dots.
const VALUE: f64 = CAPTION;
/// Room above the highest and below the lowest value, for the values beside the dots: in mm, and at most this part of the panel.
const BORDER: f64 = 6.2;
const MOST_BORDER: f64 = 0.17;
/// Least distance of round values: in mm, and at least this part of the panel.
const APART: f64 = 7.5;
const LEAST_APART: f64 = 0.1;

/// The panel of one kind of quantities.
pub(super) struct Panel {
    pub kind: Kind,
    /// Its curves, by index.
    pub members: Vec<usize>,
    /// Top of its heading, top and bottom of its area.
    pub rows: [f64; 3],
    letter: char,
    axis: Axis,
}

impl Panel {
    pub(super) fn new(sheet: &Sheet, index: usize, kind: Kind, members: Vec<usize>, rows: [f64; 3]) -> Panel {
        let curves = members.iter().map(|i| &sheet.curves.curves[*i]);
        let windows = curves.flat_map(|c| c.window);
        let zero = kind.is_rate().then_some(0.0);
        let shown = windows.chain(zero);
        let [mut low, mut high] = shown.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], y| [a.min(y), b.max(y)]);
        if low == high {
            // A lone constant.
            let room = if low == 0.0 { 1.0 } else { 0.5 * low.abs() };
            (low, high) = (low - room, high + room);
        }
        let height = rows[2] - rows[1];
        let border = BORDER.min(MOST_BORDER * height);
        let more = (high - low) * border / (height - 2.0 * border);
        let ends = [low - more, high + more];
        let apart = APART.max(LEAST_APART * height);
        Panel {
            axis: Axis::new(sheet.words, ends, [rows[2], rows[1]], apart, kind == Kind::Angle),
            letter: char::from(b'a' + index as u8),
            kind,
            members,
            rows,
        }
    }

    /// Width of the widest number beside its axis, in mm.
    pub(super) fn widest_number(&self) -> f64 {
        let width = |tick: &f64| RichText::plain(&self.axis.tick(*tick)).width(CAPTION);
        self.axis.ticks.iter().map(width).fold(0.0, f64::max)
    }

    /// Its marks' ids begin with this.
    fn prefix(&self) -> &'static str {
        match self.kind {
            Kind::Angle => "angle",
            Kind::AngularVelocity => "omega",
            Kind::AngularAcceleration => "alpha",
            Kind::Position => "position",
            Kind::Length => "length",
            Kind::Velocity => "velocity",
            Kind::Acceleration => "acceleration",
        }
    }

    pub(super) fn draw(&self, sheet: &Sheet, drawing: &mut Drawing, drive: &Axis) {
        let frame = Rect::new(drive.places[0], self.rows[1], drive.places[1], self.rows[2]);
        self.lines(drawing, drive, frame);
        drawing.draw(Pen::Frame, Shape::Polygon(corners(frame)));
        self.heading(sheet, drawing, frame);
        let renamed = &sheet.scene.figure.labels;
        let mut canvas = Canvas::new(drawing, self.prefix(), frame, renamed);
        let mut lines = Vec::new();
        if self.axis.ends[0] < 0.0 && self.axis.ends[1] > 0.0 {
            let y = self.axis.at(0.0);
            lines.push((Pen::Zero, Point::new(frame.x0, y), Point::new(frame.x1, y)));
        }
        for (pen, value) in sheet.verticals() {
            let x = drive.at(value);
            lines.push((pen, Point::new(x, frame.y0), Point::new(x, frame.y1)));
        }
        for (pen, a, b) in &lines {
            canvas.draw(*pen, Shape::Line(*a, *b));
        }
        let lines: Vec<(Point, Point)> = lines.iter().map(|(_, a, b)| (*a, *b)).collect();
        self.curves(sheet, &mut canvas, drive, frame, &lines);
        canvas.finish();
    }

    fn heading(&self, sheet: &Sheet, drawing: &mut Drawing, frame: Rect) {
        let unit = self.kind.unit(sheet.scene.units);
        let unit = match self.axis.power {
            0 => unit,
            power => format!("{} {unit}", power_of_ten(power)),
        };
        let language = sheet.words.language;
        let shows = language.in_unit(words::kind(language, self.kind), &unit);
        let heading = format!("({}) {shows}", self.letter);
        let baseline = Point::new(frame.x0, self.rows[0] + 5.2);
        let heading = PlacedText::new(RichText::plain(&heading), 1.05 * CAPTION, baseline);
        drawing.draw(Pen::Heading, Shape::Text(heading));
    }

    /// Lines at round values, and their numbers.
    fn lines(&self, drawing: &mut Drawing, drive: &Axis, frame: Rect) {
        let inside = |at: f64, [a, b]: [f64; 2]| (at - a).abs() > 0.1 && (at - b).abs() > 0.1;
        for tick in &self.axis.ticks {
            let y = self.axis.at(*tick);
            let (a, b) = (Point::new(frame.x0, y), Point::new(frame.x1, y));
            if inside(y, self.axis.places) {
                drawing.draw(Pen::Grid, Shape::Line(a, b));
            }
            let text = RichText::plain(&self.axis.tick(*tick));
            let end = Point::new(frame.x0 - BESIDE, y + 0.33 * CAPTION);
            let text = PlacedText::ending_at(text, CAPTION, end);
            drawing.draw(Pen::Caption, Shape::Text(text));
        }
        for tick in &drive.ticks {
            let x = drive.at(*tick);
            let (a, b) = (Point::new(x, frame.y0), Point::new(x, frame.y1));
            if inside(x, drive.places) {
                drawing.draw(Pen::Grid, Shape::Line(a, b));
            }
        }
    }

    fn curves(&self, sheet: &Sheet, canvas: &mut Canvas<'_>, drive: &Axis, frame: Rect, straight: &[(Point, Point)]) {
        let place = |at: f64, value: f64| Point::new(drive.at(at), self.axis.at(value));
        let own = || self.members.iter().map(|i| (&sheet.curves.curves[*i], Some(sheet.numbers[*i])));
        let mut lines: Vec<Vec<Vec<Point>>> = Vec::new();
        for (curve, number) in own() {
            let pieces = curve.pieces.iter();
            let chains = pieces.flat_map(|piece| {
                let points: Vec<Point> = piece.iter().map(|[x, y]| place(*x, *y)).collect();
                clipped_chain(frame, &points)
            });
            let chains: Vec<Vec<Point>> = chains.map(|chain| simplified(&chain)).collect();
            for (part, chain) in chains.iter().enumerate() {
                let name = format!("curve-{}-{part}", curve.asked[0].name());
                let line = Shape::Polyline(chain.clone());
                canvas.draw_named(&name, Pen::Curve, line).number = number;
            }
            lines.push(chains);
        }
        for (curve, number) in own() {
            for (index, at) in curve.dead.iter().enumerate() {
                let (center, radius) = (place(*at, 0.0), DEAD);
                let name = format!("dead-{}-{index}", curve.asked[0].name());
                let circle = Shape::Circle { center, radius };
                canvas.draw_named(&name, Pen::Dead, circle).number = number;
            }
            for extreme in &curve.extremes {
                let (center, radius) = (place(extreme.at, extreme.value), DOT);
                let dot = Shape::Circle { center, radius };
                canvas.draw(Pen::Curve, dot).number = number;
            }
        }
        let around = Surroundings { frame, curves: &lines, lines: straight };
        // Names keep off the values, which stand where they like best.
        let mut taken = Vec::new();
        for (curve, number) in own() {
            self.values(canvas, curve, number, &mut taken, place);
        }
        for (index, (curve, number)) in own().enumerate() {
            let text = RichText::math(&self.name(sheet, canvas, curve));
            let size = text.ink_box(LABEL).size();
            let Some((anchor, toward, area)) = name_place(index, size, &around, &taken) else {
                continue;
            };
            taken.push(area);
            let request =
                LabelRequest { text, size: LABEL, anchor, clearance: CLEARANCE, prefer: Some(toward), priority: 3 };
            canvas.want(Wanted {
                request,
                name: format!("label-{}", curve.asked[0].name()),
                pen: Pen::Curve,
                number,
                optional: false,
            });
        }
    }

    /// The values of the extremes, each once however often it is reached.
    fn values(
        &self,
        canvas: &mut Canvas<'_>,
        curve: &Curve,
        number: Option<usize>,
        taken: &mut Vec<Rect>,
        place: impl Fn(f64, f64) -> Point,
    ) {
        let dots = curve.extremes.iter().map(|e| place(e.at, e.value));
        taken.extend(dots.map(|dot| Rect::from_center_size(dot, (2.0 * DOT, 2.0 * DOT))));
        for greatest in [false, true] {
            let Some(first) = curve.extremes.iter().find(|e| e.greatest == greatest) else {
                continue;
            };
            let up = if greatest { -1.0 } else { 1.0 };
            let request = LabelRequest {
                text: RichText::plain(&self.axis.value(first.value)),
                size: VALUE,
                anchor: place(first.at, first.value),
                clearance: DOT + 0.5,
                prefer: Some(Vec2::new(0.0, up)),
                priority: 2,
            };
            let size = request.text.ink_box(VALUE).size();
            let middle = Vec2::new(0.0, up * (request.clearance + 0.5 * size.height));
            taken.push(Rect::from_center_size(request.anchor + middle, size));
            let word = if greatest { "greatest" } else { "least" };
            canvas.want(Wanted {
                request,
                name: format!("{word}-{}", curve.asked[0].name()),
                pen: Pen::Curve,
                number,
                optional: true,
            });
        }
    }

    /// What a curve is called, as in `ω_2 = ω_3`; with its value where that does not change.
    fn name(&self, sheet: &Sheet, canvas: &Canvas<'_>, curve: &Curve) -> String {
        let mechanism = sheet.curves.path.mechanism;
        let mut parts: Vec<String> = Vec::new();
        for asked in &curve.asked {
            let symbol = asked.symbol(mechanism, sheet.words.notation, &|name| sheet.shown(name));
            let symbol = canvas.shown(asked.name(), &symbol);
            if !parts.contains(&symbol) {
                parts.push(symbol);
            }
        }
        if parts.len() > MOST_NAMES {
            parts.truncate(MOST_NAMES);
            parts.push("…".to_owned());
        }
        parts.extend(curve.constant.map(|value| self.axis.value(value)));
        parts.join(" = ")
    }
}
