//! What is said of each step below the panels: what to do, the equation, what comes out.

use super::canvas::CAPTION;
use super::item::Item;
use super::layout::Layout;
use super::legend::SCALE;
use super::lines::PAD;
use super::plan_panel;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Mark, Pen};
use super::text::{PlacedText, RichText};
use crate::construction::{
    Action, Formula, Known, LegEquation, NamedPart, NumberedStep, Plan, PlanKind, Relation, rate_symbol,
};
use crate::geometry::{Vector, degrees_of};
use crate::quantity::Kind;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Rect};

/// Room that the words need below the scales, in mm.
const HEIGHT: f64 = 30.0;

/// How values are written.
pub(super) const VALUE: NumberStyle = NumberStyle::significant(5).in_full(-4, 7).on(Medium::Figure);
/// How lengths on paper and angles are written.
pub(super) const HUNDREDTHS: NumberStyle = NumberStyle::decimals(2).on(Medium::Figure);

/// Size of the words.
const SIZE: f64 = 1.05 * CAPTION;
/// Size of equations.
const EQUATION: f64 = 1.05 * CAPTION;
/// Size of the words under an equation.
const SMALL: f64 = CAPTION;

// Baselines below the upper edge of the words.
const FIRST: f64 = 6.0;
const SECOND: f64 = 14.4;
const LAST: f64 = 27.0;
// Below the baseline of an equation: lines under vectors, and what they are called.
const UNDER: f64 = 1.9;
const BELOW: f64 = 7.4;

/// The words of every step, each to be seen in its own step.
pub(super) struct StepWords<'a>(pub &'a Scheme<'a>);

impl Item for StepWords<'_> {
    fn height(&self) -> f64 {
        HEIGHT
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let scheme = self.0;
        let area = layout.below();
        drawing.draw(Pen::Frame, Shape::Line(area.origin(), Point::new(area.x1, area.y0)));
        let area = Rect { x0: area.x0 + PAD, x1: area.x1 - PAD, ..area };
        let count = scheme.construction.numbered_steps().count();
        for step in scheme.construction.numbered_steps() {
            let mut writer = Writer { drawing, layout, scheme, area, number: step.number as u16 };
            writer.caption(&step, count);
            writer.details(&step);
        }
    }
}

/// Writes the words of a step.
struct Writer<'a> {
    drawing: &'a mut Drawing,
    layout: &'a Layout,
    scheme: &'a Scheme<'a>,
    /// Where words go.
    area: Rect,
    /// Of the step.
    number: u16,
}

/// A piece of a line, set in one way.
enum Piece {
    Words(String),
    Math(String),
}

impl Writer<'_> {
    fn put(&mut self, pen: Pen, shape: Shape) {
        self.drawing.marks.push(Mark { since: self.number, passing: true, ..Mark::new(pen, shape) });
    }

    /// Sets pieces one after another; smaller where they would not fit.
    fn line(&mut self, pieces: &[Piece], size: f64, from: Point, room: f64) -> f64 {
        let set = |piece: &Piece| match piece {
            Piece::Words(words) => RichText::plain(words),
            Piece::Math(markup) => RichText::math(markup),
        };
        let texts: Vec<RichText> = pieces.iter().map(set).collect();
        // A slanted letter may lean beyond its width.
        let advance = |text: &RichText, size: f64| text.width(size).max(text.ink_box(size).x1);
        let width: f64 = texts.iter().map(|text| advance(text, size)).sum();
        let size = size * (room / width).min(1.0);
        let mut x = from.x;
        for text in texts {
            let after = x + advance(&text, size);
            if !text.is_empty() {
                let placed = PlacedText::new(text, size, Point::new(x, from.y));
                self.put(Pen::Caption, Shape::Text(placed));
            }
            x = after;
        }
        x
    }

    /// A text of one kind with names between backticks.
    fn pieces(&self, text: &str, plan: Option<&Plan>, kind: impl Fn(String) -> Piece) -> Vec<Piece> {
        let pieces = text.split('`').enumerate();
        let pieces = pieces.map(|(index, piece)| match index % 2 {
            0 => kind(piece.to_owned()),
            _ => Piece::Math(self.scheme.shown(piece, plan)),
        });
        pieces.collect()
    }

    /// Which step it is, and what to do.
    fn caption(&mut self, step: &NumberedStep<'_>, count: usize) {
        let number = RichText::plain(&format!("{} / {count}", self.number));
        let from = Point::new(self.area.x0, self.area.y0 + FIRST);
        let after = from.x + number.width(SIZE) + 4.0;
        let placed = PlacedText::new(number, SIZE, from);
        self.put(Pen::Heading, Shape::Text(placed));
        let caption = self.scheme.teller().caption(step);
        let pieces = self.pieces(&caption, step.plan, Piece::Words);
        let room = self.area.x1 - after;
        self.line(&pieces, SIZE, Point::new(after, from.y), room);
    }

    /// Equation and values of a step.
    fn details(&mut self, step: &NumberedStep<'_>) {
        let plan = step.plan;
        let from = Point::new(self.area.x0, self.area.y0 + SECOND);
        let kind = plan.map(|p| p.kind);
        let segment = |from: &str, to: &str| plan.and_then(|p| p.segment(from, to));
        let formula = self.scheme.teller().formula(step);
        let action = &step.step.action;
        let end = match action {
            Action::Solve { equations, unknowns } => return self.solved(equations, unknowns, plan),
            Action::Ray(ray) => {
                let sign = match ray.relation {
                    Relation::Perpendicular => "⊥",
                    Relation::Parallel => "∥",
                };
                let along = format!("{sign} {}", self.scheme.teller().line_of(ray));
                self.equation(&formula, plan, Some(&along), from)
            }
            _ => self.equation(&formula, plan, None, from),
        };
        let value = match action {
            Action::Measure { value, .. } => Some(self.size(*value, kind)),
            Action::MeasureLength { value, .. } => Some(self.size(*value, None)),
            Action::LayOff(arrow) => segment(&arrow.from, &arrow.to).map(|v| self.vector(v, kind)),
            Action::Cross { point, .. } => {
                kind.and_then(|kind| segment(kind.pole(), point)).map(|v| self.vector(v, kind))
            }
            _ => None,
        };
        let Some(value) = value else { return };
        let (from, to) = match action {
            Action::LayOff(arrow) => (arrow.from.as_str(), arrow.to.as_str()),
            Action::Cross { point, .. } => (kind.map_or("", PlanKind::pole), point.as_str()),
            _ => ("", ""),
        };
        let mut pieces = Vec::new();
        if !from.is_empty() {
            for name in [from, to] {
                pieces.push(Piece::Math(self.scheme.shown(name, plan)));
                pieces.push(Piece::Words(" ".to_owned()));
            }
        }
        pieces.push(Piece::Words(format!("= {value}")));
        let x = match (end > self.area.x0, from.is_empty()) {
            (false, _) => end,
            (true, true) => end + 1.2,
            (true, false) => end + 8.0,
        };
        let y = self.area.y0 + SECOND;
        self.line(&pieces, EQUATION, Point::new(x, y), self.area.x1 - x);
    }

    /// The equations that are solved, two in a line, and what comes out.
    fn solved(&mut self, equations: &[LegEquation], unknowns: &[(String, f64)], plan: Option<&Plan>) {
        let half = 0.5 * self.area.width();
        let lines = equations.len().div_ceil(2) as f64;
        let step = (LAST - SECOND + 1.6) / lines.max(1.0);
        for (index, equation) in equations.iter().enumerate() {
            let (row, column) = ((index / 2) as f64, (index % 2) as f64);
            let from = Point::new(self.area.x0 + half * column, self.area.y0 + SECOND - 1.6 + step.min(6.0) * row);
            let kind = plan.map_or(PlanKind::Velocity, |plan| plan.kind);
            let equation = self.scheme.teller().equation(kind, equation);
            let pieces = self.pieces(&equation, plan, Piece::Math);
            self.line(&pieces, EQUATION, from, half - 4.0);
        }
        let mut pieces = Vec::new();
        for (index, (name, value)) in unknowns.iter().enumerate() {
            let (symbol, unit) = self.rate(name);
            let between = if index > 0 { ",   " } else { "" };
            pieces.push(Piece::Words(between.to_owned()));
            pieces.push(Piece::Math(symbol));
            pieces.push(Piece::Words(format!(" = {} {unit}", self.significant(*value))));
        }
        let from = Point::new(self.area.x0, self.area.y0 + LAST);
        self.line(&pieces, EQUATION, from, self.area.width());
    }

    /// Symbol and unit of a rate by its quantity name.
    fn rate(&self, name: &str) -> (String, String) {
        let kind = match name.split('(').next() {
            Some("omega") => Kind::AngularVelocity,
            Some("alpha") => Kind::AngularAcceleration,
            Some("v_r") => Kind::Velocity,
            _ => Kind::Acceleration,
        };
        (rate_symbol(name), kind.unit(self.scheme.scene.units))
    }

    /// Writes an equation, with lines under what is known: two under whole vectors, one under directions; below them what they are
    /// called, and `along` what the direction is. Where it ends.
    fn equation(&mut self, equation: &Formula, plan: Option<&Plan>, along: Option<&str>, from: Point) -> f64 {
        let language = self.scheme.words.language;
        let mut x = from.x;
        for term in &equation.terms {
            let kind = match term.known {
                Known::Words => Some(Piece::Words as fn(String) -> Piece),
                Known::Sign => Some(Piece::Math as fn(String) -> Piece),
                _ => None,
            };
            if let Some(kind) = kind {
                let pieces = self.pieces(&term.markup, plan, kind);
                x = self.line(&pieces, EQUATION, Point::new(x, from.y), self.area.x1 - x);
                continue;
            }
            let text = RichText::math(&term.markup);
            let mut name = match term.part {
                Some(NamedPart::Normal) => language.normal(),
                Some(NamedPart::Tangential) => language.tangential(),
                Some(NamedPart::Sliding) => language.sliding(),
                Some(NamedPart::Coriolis) => language.coriolis(),
                None => "",
            }
            .to_owned();
            if let (Known::Direction, Some(along)) = (term.known, along) {
                name = if name.is_empty() { along.to_owned() } else { format!("{name}, {along}") };
            }
            let name = RichText::plain(&name);
            let (own, below) = (text.width(EQUATION), name.width(SMALL));
            // White between the names of parts beside each other.
            let width = own.max(below + if below > 0.0 { 1.6 } else { 0.0 });
            let middle = x + 0.5 * width;
            let start = middle - 0.5 * own;
            let placed = PlacedText::new(text, EQUATION, Point::new(start, from.y));
            self.put(Pen::Caption, Shape::Text(placed));
            let lines = match term.known {
                Known::Sign | Known::Words | Known::Nothing => 0,
                Known::Direction => 1,
                Known::Entirely => 2,
            };
            for line in 0..lines {
                let y = from.y + UNDER + 0.7 * f64::from(line);
                let under = Shape::Line(Point::new(start, y), Point::new(start + own, y));
                self.put(Pen::Guide, under);
            }
            if !name.is_empty() {
                let at = Point::new(middle - 0.5 * below, from.y + BELOW);
                let placed = PlacedText::new(name, SMALL, at);
                self.put(Pen::Caption, Shape::Text(placed));
            }
            x += width;
        }
        x
    }

    /// A size of a plan, or of the mechanism, with its length on paper.
    fn size(&self, value: f64, kind: Option<PlanKind>) -> String {
        let kind = plan_panel::kind(kind);
        let unit = kind.unit(self.scheme.scene.units);
        let words = &self.scheme.words;
        let on_paper = self.layout.mu(kind).map(|mu| {
            let mm = words.write(value / mu, HUNDREDTHS);
            format!(" ({mm} mm × {})", words.write(mu, SCALE))
        });
        let value = self.significant(value);
        format!("{value} {unit}{}", on_paper.unwrap_or_default())
    }

    /// The same of a vector, with its direction.
    fn vector(&self, vector: Vector, kind: Option<PlanKind>) -> String {
        let size = self.size(vector.norm(), kind);
        if vector == Vector::zeros() {
            return size;
        }
        let words = &self.scheme.words;
        words.language.with_direction(&size, &words.write(degrees_of(vector), HUNDREDTHS))
    }

    fn significant(&self, value: f64) -> String {
        self.scheme.words.write(value, VALUE)
    }
}
