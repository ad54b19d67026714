//! Words about each step below the panels: caption, equation, results.

use super::context::SheetContext;
use super::facts::Steps;
use super::layout::{Item, Layout, Needs, Placed};
use super::lines::PAD;
use super::panel::extents;
use super::remarks::{HUNDREDTHS, VALUE};
use super::scale_bar::SCALE;
use super::shape::Shape;
use super::sheet::{Drawing, Mark, Pen};
use super::text::{CAPTION, PlacedText, RichText};
use super::view::{Extent, fitting_scale};
use crate::construction::{
    Action, Formula, Known, NumberedStep, Passage, Plan, RateEquation, Ray, Relation, VectorPart,
};
use crate::geometry::{Vector, degrees_of};
use crate::scene::QuantityName;
use crate::sheet::Sheet;
use indexmap::IndexMap;
use kurbo::{Point, Rect};

/// Size of the caption, in mm of one em.
const SIZE: f64 = 1.05 * CAPTION;
/// Size of equations, in mm of one em.
pub(super) const EQUATION: f64 = 1.05 * CAPTION;
/// Size of the words under an equation, in mm of one em.
const SMALL: f64 = CAPTION;

// Baselines below the upper edge of the words, in mm.
pub(super) const FIRST: f64 = 5.0;
pub(super) const SECOND: f64 = 11.0;
const LAST: f64 = 24.0;
/// Distance of baselines without lines under vectors, in mm.
pub(super) const ROW: f64 = 6.0;
// Below the baseline of an equation, in mm: lines under vectors, and their names.
const UNDER: f64 = 1.9;
pub(super) const BELOW: f64 = 6.4;
/// White below the lowest ink, in mm.
const FOOT: f64 = 1.0;
/// White between a caption and details on its line, in mm, and the number of places along the line where they start.
pub(super) const BETWEEN: f64 = 8.0;
const TABS: f64 = 12.0;
/// Usual width and height of a plan, in mm.
const USUAL: f64 = 100.0;

/// Words about each step, shown in their own step only; their area is as high as the tallest needs.
pub(super) struct StepWords<'a> {
    context: &'a SheetContext<'a>,
    passages: Option<Vec<Passage>>,
    /// By step or passage, from 0: where its details start on the line of its caption; none where they stand below.
    starts: IndexMap<usize, Option<f64>>,
    /// In mm.
    height: f64,
}

impl<'a> StepWords<'a> {
    /// The words of all steps or, in coarse steps, of all passages; or of `only` one of them, from 1.
    pub(super) fn new(context: &'a SheetContext<'a>, steps: Steps, only: Option<usize>) -> Self {
        let passages = (steps == Steps::Coarse).then(|| context.construction().passages());
        let mut words = Self { context, passages, starts: IndexMap::new(), height: 0.0 };
        // Scales of plans of a usual size: they are part of the words.
        let usual = Rect::new(0.0, 0.0, USUAL, USUAL);
        let placed = |(sheet, extent): (Sheet, Extent)| Placed {
            needs: Needs::usual(sheet, extent, 0.0),
            frame: usual,
            area: usual,
            mu: context.surface.mu[sheet].unwrap_or_else(|| fitting_scale(&extent, usual)),
            unit: context.surface.dims.unit,
        };
        let panels = extents(context).into_iter().map(placed).collect();
        let below = Rect::new(0.0, 0.0, context.surface.dims.width_below(), 0.0);
        let layout = Layout { below, asides: Vec::new(), panels, worth: [0.0; 3] };
        for number in (0..words.count()).filter(|number| only.is_none_or(|only| only == number + 1)) {
            let (mut caption, mut details) = (Vec::new(), Vec::new());
            let caption_end = words.write_caption(&mut caption, &layout, number);
            let caption = extent(&caption);
            let tab = (layout.below.width() - 2.0 * PAD) / TABS;
            let start = tab * libm::ceil((caption.x1 - PAD + BETWEEN) / tab);
            words.write_details(&mut details, &layout, number, Some(start), caption_end);
            let is_whole = |mark: &Mark| match &mark.shape {
                Shape::Text(text) => text.size >= SMALL,
                _ => true,
            };
            let fits = extent(&details).x1 <= layout.below.x1 - PAD && details.iter().all(is_whole);
            let start = Some(start).filter(|_| fits);
            if !fits {
                details.clear();
                words.write_details(&mut details, &layout, number, None, caption_end);
            }
            words.height = words.height.max(caption.y1.max(extent(&details).y1) + FOOT);
            words.starts.insert(number, start);
        }
        words
    }

    fn count(&self) -> usize {
        self.passages.as_ref().map_or_else(|| self.context.construction().step_count(), Vec::len)
    }

    /// The passage with this number, from 0, if these are words of passages; and its steps or the step.
    fn steps_of(&self, index: usize) -> (Option<&Passage>, Vec<NumberedStep<'_>>) {
        let (passage, construction) =
            (self.passages.as_ref().map(|passages| &passages[index]), self.context.construction());
        let steps = match passage {
            Some(passage) => construction.steps_of(passage).collect(),
            None => construction.numbered_step(index + 1).into_iter().collect(),
        };
        (passage, steps)
    }

    fn writer<'w>(&'w self, marks: &'w mut Vec<Mark>, layout: &'w Layout, index: usize) -> Writer<'w> {
        let captions = Rect { x0: layout.below.x0 + PAD, x1: layout.below.x1 - PAD, ..layout.below };
        let since = self.passages.as_ref().map_or(index + 1, |passages| passages[index].steps[1]) as u16;
        Writer { marks, layout, context: self.context, captions, area: captions, since, caption_end: captions.x0 }
    }

    /// Writes the caption of a step or passage; returns its right end.
    fn write_caption(&self, marks: &mut Vec<Mark>, layout: &Layout, index: usize) -> f64 {
        let (passage, steps) = self.steps_of(index);
        let sentence = match passage {
            Some(passage) => self.context.teller().passage_caption(passage),
            None => steps.first().map_or_else(String::new, |step| self.context.teller().caption(step)),
        };
        let mut writer = self.writer(marks, layout, index);
        let number = format!("{} / {}", index + 1, self.count());
        writer.caption(&number, &sentence, steps.first().and_then(|step| step.plan));
        writer.caption_end
    }

    /// Writes the details of a step or passage, below its caption, which ends there, or from `start` on its line.
    fn write_details(
        &self,
        marks: &mut Vec<Mark>,
        layout: &Layout,
        index: usize,
        start: Option<f64>,
        caption_end: f64,
    ) {
        let (passage, steps) = self.steps_of(index);
        let mut writer = Writer { caption_end, ..self.writer(marks, layout, index) };
        if let Some(start) = start {
            let Rect { x0, y0, .. } = writer.captions;
            writer.area = Rect { x0: x0 + start, y0: y0 + FIRST - SECOND, ..writer.captions };
        }
        match (passage, steps.as_slice()) {
            (Some(passage), steps) => writer.details_of(passage.aim, steps),
            (None, [step]) => writer.details(step),
            (None, _) => {}
        }
    }
}

/// Width of a piece; a slanted letter may lean beyond its advance.
fn advance(text: &RichText, size: f64) -> f64 {
    text.width(size).max(text.ink_box(size).x1)
}

/// Width of pieces one after another.
pub(super) fn width_of(texts: &[RichText], size: f64) -> f64 {
    texts.iter().map(|text| advance(text, size)).sum()
}

/// The box around all marks.
fn extent(marks: &[Mark]) -> Rect {
    let all = marks.iter().map(|mark| mark.shape.bounds());
    all.reduce(|a, b| a.union(b)).unwrap_or_default()
}

impl Item for StepWords<'_> {
    fn height(&self) -> f64 {
        self.height
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout, _: Option<Rect>) {
        for (&index, &start) in &self.starts {
            let caption_end = self.write_caption(&mut drawing.marks, layout, index);
            self.write_details(&mut drawing.marks, layout, index, start, caption_end);
        }
    }
}

/// The vector between two points of a plan that a step draws: its ends as they are shown, and what lies between them.
pub(crate) fn drawn_vector<'s>(step: &NumberedStep<'s>) -> Option<([&'s str; 2], Vector)> {
    let plan = step.plan?;
    let [from, to] = match step.action {
        Action::LayOff(arrow) => arrow.ends(),
        Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => {
            [plan.order.pole(), point]
        }
        _ => return None,
    };
    Some(([from, to], plan.shown_segment(from, to)?))
}

/// Writes the words of a step.
pub(super) struct Writer<'a> {
    pub marks: &'a mut Vec<Mark>,
    pub layout: &'a Layout,
    pub context: &'a SheetContext<'a>,
    /// The area of all words.
    pub captions: Rect,
    /// That of the details, with room for a caption above them.
    pub area: Rect,
    /// The step with which its marks appear.
    pub since: u16,
    /// The right end of the caption.
    pub caption_end: f64,
}

impl Writer<'_> {
    fn put(&mut self, pen: Pen, shape: Shape) {
        self.marks.push(Mark { since: self.since, passing: true, ..Mark::new(pen, shape) });
    }

    fn write(&mut self, pen: Pen, text: RichText, size: f64, from: Point) {
        self.put(pen, Shape::Text(PlacedText::new(text, size, from)));
    }

    /// Sets pieces one after another, in a smaller size where they are too wide; returns the right end.
    pub(super) fn line(&mut self, texts: &[RichText], size: f64, from: Point, room: f64) -> f64 {
        let size = size * (room / width_of(texts, size)).min(1.0);
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
            _ => RichText::math(&self.context.told(piece, plan)),
        };
        text.split('`').enumerate().map(piece).collect()
    }

    /// A sentence in markup after its number.
    fn caption(&mut self, number: &str, sentence: &str, plan: Option<&Plan>) {
        let number = RichText::plain(number);
        let from = Point::new(self.captions.x0, self.captions.y0 + FIRST);
        let after = from.x + number.width(SIZE) + 4.0;
        self.write(Pen::Heading, number, SIZE, from);
        let caption = self.pieces(sentence, plan, RichText::plain);
        self.caption_end = self.line(&caption, SIZE, Point::new(after, from.y), self.captions.x1 - after);
    }

    /// Equation and values of a step.
    pub(super) fn details(&mut self, step: &NumberedStep<'_>) {
        let plan = step.plan;
        let from = Point::new(self.area.x0, self.area.y0 + SECOND);
        let sheet = step.sheet;
        let formula = self.context.teller().formula(step);
        let action = &step.action;
        let end = match action {
            Action::Solve { equations, unknowns } => return self.solution(equations, unknowns, plan),
            Action::Ray(ray) => self.ray_equation(ray, &formula, plan, from),
            _ => self.equation(&formula, plan, None, from),
        };
        let drawn = drawn_vector(step);
        let value = match (action, drawn) {
            (Action::Measure { value, .. }, _) => self.size(*value, sheet),
            (_, Some((_, vector))) => self.vector(vector, sheet),
            _ if self.context.teller().force_of_step(action).is_some() => {
                let force = self.context.teller().force_of_step(action).unwrap_or_default();
                self.vector(force, sheet)
            }
            _ => match self.context.teller().value_of_step(action) {
                Some((value, kind)) => {
                    let unit = kind.unit(self.context.solution.scene.units);
                    format!("{} {unit}", self.context.words.write(value, VALUE))
                }
                None => return,
            },
        };
        let name = |name: &str| [RichText::math(&self.context.told(name, plan)), RichText::plain(" ")];
        let mut texts: Vec<RichText> = drawn.into_iter().flat_map(|(ends, _)| ends).flat_map(name).collect();
        texts.push(RichText::plain(&format!("= {value}")));
        let x = match (end > self.area.x0, drawn) {
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
        let along = format!("{sign} {}", self.context.teller().line_of(ray));
        self.equation(formula, plan, Some(along.trim_start()), from)
    }

    /// The equations of the step, at least two in a line, and their solution.
    fn solution(&mut self, equations: &[RateEquation], unknowns: &[(String, f64)], plan: Option<&Plan>) {
        let set =
            |equation: &RateEquation| self.pieces(&self.context.teller().equation(equation), plan, RichText::math);
        let written: Vec<Vec<RichText>> = equations.iter().map(set).collect();
        let widest = written.iter().map(|pieces| width_of(pieces, EQUATION)).fold(0.0, f64::max);
        let fitting = (self.area.width() / (widest + BETWEEN)) as usize;
        let columns = fitting.clamp(2, written.len().max(2));
        let (lines, column) = (written.len().div_ceil(columns) as f64, self.area.width() / columns as f64);
        // Many equations are closer together.
        let row_height = ((LAST - SECOND) / lines.max(1.0)).min(ROW);
        for (index, equation) in written.iter().enumerate() {
            let (row, place) = ((index / columns) as f64, (index % columns) as f64);
            let from = Point::new(self.area.x0 + column * place, self.area.y0 + SECOND + row_height * row);
            self.line(equation, EQUATION, from, column - 4.0);
        }
        let teller = self.context.teller();
        let found = unknowns.iter().enumerate().flat_map(|(index, (name, value))| {
            let unit = QuantityName::parse(name).map(|name| name.kind().unit(self.context.solution.scene.units));
            let value = format!(" = {} {}", self.context.words.write(*value, VALUE), unit.unwrap_or_default());
            let comma = RichText::plain(if index > 0 { ",   " } else { "" });
            [comma, RichText::math(&teller.rate(name)), RichText::plain(&value)]
        });
        let found: Vec<RichText> = found.collect();
        let from = Point::new(self.area.x0, self.area.y0 + SECOND + row_height * lines);
        self.line(&found, EQUATION, from, self.area.width());
    }

    /// Writes an equation and lines under its vectors: two where they are known entirely, one where in direction; below
    /// these the name of the part, and `along`, the known direction. Returns the right end.
    fn equation(&mut self, equation: &Formula, plan: Option<&Plan>, along: Option<&str>, from: Point) -> f64 {
        let language = self.context.words.language;
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
                Some(VectorPart::Normal) => language.normal(),
                Some(VectorPart::Tangential) => language.tangential(),
                Some(VectorPart::Sliding) => language.sliding(),
                Some(VectorPart::Coriolis) => language.coriolis(),
                Some(VectorPart::Whole | VectorPart::Relative) | None => "",
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
    pub(super) fn size(&self, value: f64, sheet: Sheet) -> String {
        let unit = sheet.facts().drawn.unit(self.context.solution.scene.units);
        let words = &self.context.words;
        let mu = self.context.surface.told.map_or_else(|| self.layout.mu_of(sheet), |told| told[sheet]);
        let on_paper = mu.and_then(|mu| {
            let mm = words.on_paper(value, mu, HUNDREDTHS)?;
            Some(format!(" ({mm} mm × {})", words.write(mu, SCALE)))
        });
        format!("{} {unit}{}", words.write(value, VALUE), on_paper.unwrap_or_default())
    }

    /// Size and direction of a vector, with its length on paper.
    fn vector(&self, vector: Vector, sheet: Sheet) -> String {
        let size = self.size(vector.norm(), sheet);
        if vector == Vector::zeros() {
            return size;
        }
        let words = &self.context.words;
        words.language.with_direction(&size, &words.write(degrees_of(vector), HUNDREDTHS))
    }
}
