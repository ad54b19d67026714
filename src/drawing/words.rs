//! Words about each step below the panels: caption, equation, results.

use super::figure::Steps;
use super::layout::{Item, Layout, MARGIN};
use super::legend::SCALE;
use super::lines::PAD;
use super::plan_panel;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Mark, Pen};
use super::text::{CAPTION, PlacedText, RichText};
use crate::construction::{
    Action, Formula, Known, LegEquation, NamedPart, NumberedStep, Passage, Plan, PlanKind, Ray, Relation, rate_symbol,
};
use crate::geometry::{Vector, degrees_of};
use crate::quantity::Kind;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Rect};

/// Number style of values.
pub(super) const VALUE: NumberStyle = NumberStyle::significant(5).in_full(-4, 7).on(Medium::Figure);
/// Number style of lengths on paper and angles.
pub(super) const HUNDREDTHS: NumberStyle = NumberStyle::decimals(2).on(Medium::Figure);

/// Size of the caption, in mm of one em.
const SIZE: f64 = 1.05 * CAPTION;
/// Size of equations, in mm of one em.
pub(super) const EQUATION: f64 = 1.05 * CAPTION;
/// Size of the words under an equation, in mm of one em.
const SMALL: f64 = CAPTION;

// Baselines below the upper edge of the words, in mm.
const FIRST: f64 = 5.4;
pub(super) const SECOND: f64 = 12.4;
/// The lowest baseline.
const LAST: f64 = 25.0;
/// Distance of baselines without lines under vectors, in mm.
pub(super) const ROW: f64 = 6.0;
// Below the baseline of an equation, in mm: lines under vectors, and their names.
const UNDER: f64 = 1.9;
pub(super) const BELOW: f64 = 6.7;
/// White below the lowest ink, in mm.
const FOOT: f64 = 1.4;

/// Words about each step, shown in their own step only; their area is as high as the tallest needs.
pub(super) struct StepWords<'a> {
    scheme: &'a Scheme<'a>,
    passages: Option<Vec<Passage>>,
    /// In mm.
    height: f64,
}

impl<'a> StepWords<'a> {
    /// The words of all steps or, in coarse steps, of all passages.
    pub(super) fn new(scheme: &'a Scheme<'a>, steps: Steps) -> Self {
        let passages = (steps == Steps::Coarse).then(|| scheme.construction.passages());
        let words = Self { scheme, passages, height: 0.0 };
        let [width, height] = scheme.dims.page;
        let mut trial = Drawing::new(width, height);
        let layout = Layout::of_words(Rect::new(0.0, 0.0, width - 2.0 * MARGIN, 0.0));
        words.write(&mut trial, &layout);
        let lowest = trial.marks.iter().map(|mark| mark.shape.bounds().y1).fold(0.0, f64::max);
        Self { height: lowest + FOOT, ..words }
    }

    fn write(&self, drawing: &mut Drawing, layout: &Layout) {
        let (scheme, area) = (self.scheme, layout.below());
        let area = Rect { x0: area.x0 + PAD, x1: area.x1 - PAD, ..area };
        let mut writer = Writer { drawing, layout, scheme, area, number: 0 };
        if let Some(passages) = &self.passages {
            return writer.passages(passages);
        }
        let count = scheme.construction.numbered_steps().count();
        for step in scheme.construction.numbered_steps() {
            writer.number = step.number as u16;
            writer.caption(&step, count);
            writer.details(&step);
        }
    }
}

impl Item for StepWords<'_> {
    fn height(&self) -> f64 {
        self.height
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let area = layout.below();
        drawing.draw(Pen::Frame, Shape::Line(area.origin(), Point::new(area.x1, area.y0)));
        self.write(drawing, layout);
    }
}

/// Writes the words of a step.
pub(super) struct Writer<'a> {
    pub drawing: &'a mut Drawing,
    pub layout: &'a Layout,
    pub scheme: &'a Scheme<'a>,
    /// The area of the words.
    pub area: Rect,
    /// Number of the step.
    pub number: u16,
}

impl Writer<'_> {
    fn put(&mut self, pen: Pen, shape: Shape) {
        self.drawing.marks.push(Mark { since: self.number, passing: true, ..Mark::new(pen, shape) });
    }

    fn write(&mut self, pen: Pen, text: RichText, size: f64, from: Point) {
        self.put(pen, Shape::Text(PlacedText::new(text, size, from)));
    }

    /// Sets pieces one after another, in a smaller size where they are too wide; returns the right end.
    pub(super) fn line(&mut self, texts: &[RichText], size: f64, from: Point, room: f64) -> f64 {
        // A slanted letter may lean beyond its advance.
        let advance = |text: &RichText, size: f64| text.width(size).max(text.ink_box(size).x1);
        let width: f64 = texts.iter().map(|text| advance(text, size)).sum();
        let size = size * (room / width).min(1.0);
        let mut x = from.x;
        for text in texts {
            if !text.is_empty() {
                self.write(Pen::Caption, text.clone(), size, Point::new(x, from.y));
            }
            x += advance(text, size);
        }
        x
    }

    /// The pieces of a text: names between backticks in their notation, the rest by `set`.
    pub(super) fn pieces(&self, text: &str, plan: Option<&Plan>, set: fn(&str) -> RichText) -> Vec<RichText> {
        let piece = |(index, piece): (usize, &str)| match index % 2 {
            0 => set(piece),
            _ => RichText::math(&self.scheme.shown(piece, plan)),
        };
        text.split('`').enumerate().map(piece).collect()
    }

    /// Number and caption of a step.
    fn caption(&mut self, step: &NumberedStep<'_>, count: usize) {
        let caption = self.scheme.teller().caption(step);
        self.numbered(step.number, count, &caption, step.plan);
    }

    /// A numbered sentence in markup.
    pub(super) fn numbered(&mut self, number: usize, count: usize, sentence: &str, plan: Option<&Plan>) {
        let number = RichText::plain(&format!("{number} / {count}"));
        let from = Point::new(self.area.x0, self.area.y0 + FIRST);
        let after = from.x + number.width(SIZE) + 4.0;
        self.write(Pen::Heading, number, SIZE, from);
        let caption = self.pieces(sentence, plan, RichText::plain);
        self.line(&caption, SIZE, Point::new(after, from.y), self.area.x1 - after);
    }

    /// Equation and values of a step.
    pub(super) fn details(&mut self, step: &NumberedStep<'_>) {
        let plan = step.plan;
        let from = Point::new(self.area.x0, self.area.y0 + SECOND);
        let kind = plan.map(|p| p.kind);
        let formula = self.scheme.teller().formula(step);
        let action = &step.step.action;
        let end = match action {
            Action::Solve { equations, unknowns } => return self.solution(equations, unknowns, plan),
            Action::Ray(ray) => self.ray_equation(ray, &formula, plan, from),
            _ => self.equation(&formula, plan, None, from),
        };
        let ends = match action {
            Action::LayOff(arrow) => Some(arrow.ends()),
            Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => {
                kind.map(|kind| [kind.pole(), point.as_str()])
            }
            _ => None,
        };
        let vector = ends.and_then(|[from, to]| plan?.shown_segment(from, to));
        let value = match (action, vector) {
            (Action::Measure { value, .. }, _) => self.size(*value, kind),
            (Action::MeasureLength { value, .. }, _) => self.size(*value, None),
            (_, Some(vector)) => self.vector(vector, kind),
            _ => return,
        };
        let name = |name: &str| [RichText::math(&self.scheme.shown(name, plan)), RichText::plain(" ")];
        let mut texts: Vec<RichText> = ends.into_iter().flatten().flat_map(name).collect();
        texts.push(RichText::plain(&format!("= {value}")));
        let x = match (end > self.area.x0, ends) {
            (false, _) => end,
            (true, None) => end + 1.2,
            (true, Some(_)) => end + 8.0,
        };
        self.line(&texts, EQUATION, Point::new(x, from.y), self.area.x1 - x);
    }

    /// The equation behind a ray, with the ray's direction below; returns the right end.
    pub(super) fn ray_equation(&mut self, ray: &Ray, formula: &Formula, plan: Option<&Plan>, from: Point) -> f64 {
        let sign = match ray.relation {
            Relation::Perpendicular => "⊥",
            Relation::Parallel => "∥",
            Relation::Angle => "",
        };
        let along = format!("{sign} {}", self.scheme.teller().line_of(ray));
        self.equation(formula, plan, Some(along.trim_start()), from)
    }

    /// The equations of the step, two in a line, and their solution.
    fn solution(&mut self, equations: &[LegEquation], unknowns: &[(String, f64)], plan: Option<&Plan>) {
        let half = 0.5 * self.area.width();
        let lines = equations.len().div_ceil(2) as f64;
        // Many equations are closer together.
        let row_height = ((LAST - SECOND) / lines.max(1.0)).min(ROW);
        for (index, equation) in equations.iter().enumerate() {
            let (row, column) = ((index / 2) as f64, (index % 2) as f64);
            let from = Point::new(self.area.x0 + half * column, self.area.y0 + SECOND - 0.4 + row_height * row);
            let kind = plan.map_or(PlanKind::Velocity, |plan| plan.kind);
            let equation = self.pieces(&self.scheme.teller().equation(kind, equation), plan, RichText::math);
            self.line(&equation, EQUATION, from, half - 4.0);
        }
        let found = unknowns.iter().enumerate().flat_map(|(index, (name, value))| {
            let (symbol, unit) = self.rate(name);
            let value = RichText::plain(&format!(" = {} {unit}", self.significant(*value)));
            [RichText::plain(if index > 0 { ",   " } else { "" }), RichText::math(&symbol), value]
        });
        let found: Vec<RichText> = found.collect();
        let from = Point::new(self.area.x0, self.area.y0 + SECOND + row_height * lines);
        self.line(&found, EQUATION, from, self.area.width());
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

    /// Writes an equation and lines under its vectors: two where they are known entirely, one where in direction; below
    /// these the name of the part, and `along`, the known direction. Returns the right end.
    fn equation(&mut self, equation: &Formula, plan: Option<&Plan>, along: Option<&str>, from: Point) -> f64 {
        let language = self.scheme.words.language;
        let mut x = from.x;
        for term in &equation.terms {
            let set: Option<fn(&str) -> RichText> = match term.known {
                Known::Words => Some(RichText::plain),
                Known::Sign => Some(RichText::math),
                _ => None,
            };
            if let Some(set) = set {
                let pieces = self.pieces(&term.markup, plan, set);
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
            let (text_width, below) = (text.width(EQUATION), name.width(SMALL));
            // White between the names of neighbouring parts.
            let width = text_width.max(below + if below > 0.0 { 1.6 } else { 0.0 });
            let middle = x + 0.5 * width;
            let start = middle - 0.5 * text_width;
            self.write(Pen::Caption, text, EQUATION, Point::new(start, from.y));
            let lines = match term.known {
                Known::Sign | Known::Words | Known::Nothing => 0,
                Known::Direction => 1,
                Known::Entirely => 2,
            };
            for line in 0..lines {
                let y = from.y + UNDER + 0.7 * f64::from(line);
                let under = Shape::Line(Point::new(start, y), Point::new(start + text_width, y));
                self.put(Pen::Guide, under);
            }
            if !name.is_empty() {
                let at = Point::new(middle - 0.5 * below, from.y + BELOW);
                self.write(Pen::Caption, name, SMALL, at);
            }
            x += width;
        }
        x
    }

    /// A size in a plan or on the mechanism, with its length on paper.
    pub(super) fn size(&self, value: f64, kind: Option<PlanKind>) -> String {
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

    /// Size and direction of a vector, with its length on paper.
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
