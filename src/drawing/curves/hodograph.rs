//! Ways of vectors' tips: a panel for each vector, true to scale in both directions, with the vector at the scene's own position.

use super::lines::{clipped_chain, simplified};
use super::words::{self, Line};
use super::{CurvesError, Sheet};
use crate::cycle::{Curves, Happening, Hodograph, Hodographs};
use crate::drawing::canvas::{CAPTION, Canvas, LABEL, Wanted};
use crate::drawing::labels::LabelRequest;
use crate::drawing::layout::{HEADING, MARGIN, TITLE};
use crate::drawing::legend::{Entry, corners};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use crate::drawing::style::Style;
use crate::drawing::text::RichText;
use crate::drawing::view::{Extent, View, fitting_scale};
use crate::geometry;
use crate::quantity::Kind;
use crate::scene::{DecimalMark, Scene};
use crate::words::Wording;
use kurbo::{Point, Rect, Vec2};

/// Ids of what is in each panel; so many find room on a sheet.
const PREFIXES: [&str; 6] = ["hodograph-a", "hodograph-b", "hodograph-c", "hodograph-d", "hodograph-e", "hodograph-f"];
/// Between panels.
const GAP: f64 = 4.0;
/// White around the way inside a panel, for names and numbers.
const PADDING: f64 = 10.0;
/// Room for the scale at the foot of a panel.
const SCALE: f64 = 8.0;
/// White beside it.
const BESIDE_SCALE: f64 = 2.5;
/// Room for what the numbers mean below the panels.
const FOOT: f64 = 9.0;
/// Radius of the dot at a marked tip.
const DOT: f64 = 0.65;
/// Marked tips nearer to each other than this share their numbers' place.
const SHARED: f64 = 0.4;
/// Half the length of the stroke across the way at a limit.
const STROKE: f64 = 2.4;

/// The figure of the ways of vectors' tips, on the scene's page.
///
/// # Errors
/// They are too many for a sheet.
pub fn hodographs(scene: &Scene, all: &Hodographs) -> Result<Drawing, CurvesError> {
    let wanted = all.hodographs.len();
    let room = PREFIXES.len();
    if wanted > room {
        return Err(CurvesError::Panels { wanted, room });
    }
    let bare = Curves { path: all.path, range: all.range, curves: Vec::new(), events: all.events.clone() };
    let sheet = Sheet { scene, words: Wording::of(&scene.figure), curves: &bare, numbers: Vec::new() };
    let [width, height] = scene.figure.page.size_mm();
    let mut drawing = Drawing::new(width, height);
    drawing.style = Style::named(scene.figure.style);
    sheet.title(&mut drawing, [MARGIN, width - MARGIN]);
    let line = words::drive(&sheet);
    let half = 0.5 * line.width(CAPTION);
    let middle = Point::new(0.5 * width, height - MARGIN - 1.8);
    let center = middle + Vec2::new(-half - 2.2, -1.3);
    drawing.draw(Pen::Pole, Shape::Circle { center, radius: DOT });
    line.centred(&mut drawing, middle, CAPTION);
    let whole = Rect::new(MARGIN, MARGIN + TITLE, width - MARGIN, height - MARGIN - FOOT);
    let mut said = Vec::new();
    for (index, (frame, one)) in frames(&sheet, whole, &all.hodographs).into_iter().zip(&all.hodographs).enumerate() {
        let panel = Panel { sheet: &sheet, index, frame, one };
        panel.draw(&mut drawing);
        said.push(sheet.words.language.hodograph(one.asked.name()));
    }
    drawing.description = format!("{}.", said.join("; "));
    Ok(drawing)
}

/// The panels, in as many columns as let the ways come out largest.
fn frames(sheet: &Sheet, whole: Rect, all: &[Hodograph]) -> Vec<Rect> {
    let in_columns = |columns: usize| -> Vec<Rect> {
        let rows = all.len().div_ceil(columns);
        let width = (whole.width() + GAP) / columns as f64;
        let height = (whole.height() + GAP) / rows as f64;
        let frame = |index: usize| {
            let (row, column) = ((index / columns) as f64, (index % columns) as f64);
            let corner = Point::new(whole.x0 + width * column, whole.y0 + height * row);
            Rect::from_origin_size(corner, (width - GAP, height - GAP))
        };
        (0..all.len()).map(frame).collect()
    };
    // First that every panel is wide enough for its scale, then how large the ways come out; of equals more columns.
    let worth = |frames: &Vec<Rect>| {
        let drawn = frames.iter().zip(all).map(|(frame, one)| {
            let extent = extent(one);
            let mu = fitting_scale(&extent, area(*frame));
            let scale = scale(sheet, one, mu).width() + 2.0 * BESIDE_SCALE;
            (scale <= frame.width(), extent.size().norm() / mu)
        });
        let drawn: Vec<(bool, f64)> = drawn.collect();
        let fits = drawn.iter().all(|(fits, _)| *fits);
        let size: f64 = drawn.iter().map(|(_, size)| size).product();
        (fits, size)
    };
    let ways = (1..=all.len().max(1)).map(in_columns);
    let best = ways.max_by(|a, b| {
        let (a, b) = (worth(a), worth(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    best.unwrap_or_default()
}

/// The scale of a panel, with its bar.
fn scale(sheet: &Sheet, one: &Hodograph, mu: f64) -> Entry {
    let symbol = match one.asked.kind() {
        Kind::Acceleration => "μ_a",
        _ => "μ_v",
    };
    let unit = one.asked.kind().unit(sheet.scene.units);
    Entry::new(symbol, &unit, mu, &sheet.words)
}

/// Where the way goes in a panel.
fn area(frame: Rect) -> Rect {
    let mut area = frame.inset(-PADDING);
    area.y0 += HEADING - 4.0;
    area.y1 -= SCALE - 4.0;
    area
}

fn extent(one: &Hodograph) -> Extent {
    Extent::of(one.window.map(geometry::Point::from))
}

struct Panel<'a> {
    sheet: &'a Sheet<'a>,
    index: usize,
    frame: Rect,
    one: &'a Hodograph,
}

impl Panel<'_> {
    fn draw(&self, drawing: &mut Drawing) {
        let (frame, one) = (self.frame, self.one);
        let area = area(frame);
        let extent = extent(one);
        let mu = fitting_scale(&extent, area);
        let view = View::new(mu, &extent, area);
        let at = |v: geometry::Vector| view.at(geometry::Point::from(v));
        let pole = at(nalgebra::zero());
        drawing.draw(Pen::Frame, Shape::Polygon(corners(frame)));
        let symbol = self.symbol();
        drawing.panels.push((one.asked.name().to_owned(), frame));
        let head = self.heading(&symbol).starting(drawing, Point::new(frame.x0 + 2.5, frame.y0 + 6.0), 1.05 * CAPTION);
        let own_pen = match one.asked.kind() {
            Kind::Acceleration => Pen::Acceleration,
            _ => Pen::Velocity,
        };
        let entry = scale(self.sheet, one, mu);
        let foot = Point::new(frame.x0 + BESIDE_SCALE, frame.y1 - 2.8);
        entry.draw(drawing, foot);
        let renamed = &self.sheet.scene.figure.labels;
        let mut canvas = Canvas::new(drawing, PREFIXES[self.index], frame, renamed);
        canvas.keep_off(head);
        // Lines keep off the scale.
        let mut room = canvas.room();
        room.y1 = frame.y1 - SCALE;
        canvas.keep_off(Rect::new(frame.x0, foot.y - 4.4, foot.x + entry.width(), frame.y1));
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
            let mark = canvas.draw_named(&format!("way-{part}"), Pen::Curve, line);
            mark.number = Some(self.index);
        }
        self.limits(&mut canvas, &chains);
        if let Some(tip) = one.own.map(at)
            && (tip - pole).hypot() > 1e-3
        {
            canvas.draw_named("own", own_pen, Shape::Arrow { from: pole, to: tip });
            let beside = pole.lerp(tip, 0.6);
            let along = (tip - pole).normalize();
            let prefer = Vec2::new(along.y, -along.x);
            self.label(&mut canvas, "own", RichText::math(&symbol), beside, 0.9, Some(prefer), 2);
        }
        self.marks(&mut canvas, one.marks.iter().map(|(value, tip)| (*value, at(*tip))), pole);
        let notation = self.sheet.words.notation;
        let name = match one.asked.kind() {
            Kind::Acceleration => notation.acceleration_pole,
            _ => notation.velocity_pole,
        };
        canvas.draw_named("pole", Pen::Pole, Shape::Circle { center: pole, radius: 0.9 });
        self.label(&mut canvas, "pole", RichText::math(name), pole, 1.5, None, 3);
        canvas.finish();
    }

    /// How the vector is written.
    fn symbol(&self) -> String {
        let sheet = self.sheet;
        let mechanism = sheet.curves.path.mechanism;
        let symbol = self.one.asked.symbol(mechanism, sheet.words.notation, &|name| sheet.shown(name));
        symbol.trim_matches('|').to_owned()
    }

    fn heading(&self, symbol: &str) -> Line {
        let letter = char::from(b'a' + self.index as u8);
        let sentence = self.sheet.words.language.hodograph(words::SYMBOL);
        Line::around(&format!("({letter}) {sentence}"), RichText::math(symbol))
    }

    #[expect(clippy::too_many_arguments, reason = "the parts of a label")]
    fn label(
        &self,
        canvas: &mut Canvas<'_>,
        name: &str,
        text: RichText,
        anchor: Point,
        clearance: f64,
        prefer: Option<Vec2>,
        priority: u8,
    ) {
        let request = LabelRequest { text, size: LABEL, anchor, clearance, prefer, priority };
        canvas.want(Wanted { request, name: format!("label-{name}"), pen: Pen::Label, number: None, optional: false });
    }

    /// Dots at round values of the drive, with their numbers; tips in one place share them.
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
            if !crate::drawing::clip::holds(canvas.bounds(), center) {
                continue;
            }
            let name = super::significant(6).write(values[0], DecimalMark::Point);
            let dot = Shape::Circle { center, radius: DOT };
            let mark = canvas.draw_named(&format!("tip-{name}"), Pen::Curve, dot);
            mark.number = Some(self.index);
            let numbers: Vec<String> = values.iter().map(|v| self.sheet.number(*v, 6)).collect();
            let away = center - pole;
            let prefer = (away.hypot() > 1.0).then(|| away.normalize());
            let text = RichText::plain(&numbers.join("; "));
            self.label(canvas, &format!("tip-{name}"), text, center, DOT + 0.6, prefer, 1);
        }
    }

    /// Strokes across the way where it ends in a limit position, or runs off to one.
    fn limits(&self, canvas: &mut Canvas<'_>, chains: &[Vec<Point>]) {
        let [low, high] = self.sheet.curves.range;
        let events = self.sheet.curves.events.iter();
        let ends = events.filter(|event| {
            let what = &event.what;
            matches!(what, Happening::Limit { .. } | Happening::Singular { .. })
        });
        for event in ends {
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
            let unit = if self.sheet.curves.path.drive.is_angle() { "°" } else { "" };
            let word = self.sheet.words.language.limit();
            let words = format!("{word} {}{unit}", self.sheet.number(event.at, 5));
            let name = format!("limit-{}", if near(event.at, low) { "low" } else { "high" });
            self.label(canvas, &name, RichText::plain(&words), end, STROKE, None, 2);
        }
    }
}
