//! A figure in coarse steps: words about each passage of the construction, and marks that come with it.

use super::scheme::Scheme;
use super::sheet::Drawing;
use super::text::RichText;
use super::words::{BELOW, EQUATION, ROW, SECOND, Writer};
use crate::construction::{Action, Aim, Formula, Known, NumberedStep, Passage, Plan, shown_text};
use kurbo::Point;

impl Writer<'_> {
    /// The words of all passages.
    pub(super) fn passages(&mut self, passages: &[Passage]) {
        let scheme = self.scheme;
        for (index, passage) in passages.iter().enumerate() {
            let steps: Vec<NumberedStep<'_>> = scheme.construction.steps_of(passage).collect();
            self.number = passage.steps[1] as u16;
            let caption = scheme.teller().passage_caption(passage);
            self.numbered(index + 1, passages.len(), &caption, steps.first().and_then(|step| step.plan));
            self.passage(passage.aim, &steps);
        }
    }

    /// Equations and values of a passage.
    fn passage(&mut self, aim: Aim, steps: &[NumberedStep<'_>]) {
        let with_details: Vec<&NumberedStep<'_>> = match aim {
            Aim::SpecialPoints => return self.lengths(steps),
            Aim::Crossing => return self.crossing(steps),
            Aim::Rates => steps.iter().filter(|step| matches!(step.step.action, Action::Solve { .. })).collect(),
            Aim::Start => steps.iter().filter(|step| matches!(step.step.action, Action::LayOff(_))).collect(),
            Aim::Images | Aim::Nothing => steps.iter().collect(),
        };
        match with_details.as_slice() {
            [step] => self.details(step),
            _ => self.formulas(steps, &[SECOND, SECOND + ROW + 1.0]),
        }
    }

    /// The measured lengths of special points, two in a line.
    fn lengths(&mut self, steps: &[NumberedStep<'_>]) {
        let half = 0.5 * self.area.width();
        let measured = steps.iter().filter_map(|step| match &step.step.action {
            Action::MeasureLength { value, .. } => Some((step, *value)),
            _ => None,
        });
        for (index, (step, value)) in measured.enumerate() {
            let (row, column) = ((index / 2) as f64, (index % 2) as f64);
            let from = Point::new(self.area.x0 + half * column, self.area.y0 + SECOND - 0.4 + ROW * row);
            let symbol = RichText::math(&self.scheme.teller().formula(step).markup());
            let value = RichText::plain(&format!(" = {}", self.size(value, None)));
            self.line(&[symbol, value], EQUATION, from, half - 4.0);
        }
    }

    /// The equations behind both rays, and below them what has been laid off.
    fn crossing(&mut self, steps: &[NumberedStep<'_>]) {
        let half = 0.5 * self.area.width();
        let rays = steps.iter().filter_map(|step| match &step.step.action {
            Action::Ray(ray) => Some((step, ray)),
            _ => None,
        });
        for (index, (step, ray)) in rays.take(2).enumerate() {
            let from = Point::new(self.area.x0 + half * index as f64, self.area.y0 + SECOND);
            let formula = self.scheme.teller().formula(step);
            self.ray_equation(ray, &formula, step.plan, from);
        }
        let laid_off = steps.iter().filter(|step| matches!(step.step.action, Action::LayOff(_)));
        let laid_off: Vec<NumberedStep<'_>> = laid_off.copied().collect();
        self.formulas(&laid_off, &[SECOND + BELOW + ROW]);
    }

    /// The formulas of some steps one after another, in lines with these baselines; in a smaller size where they are
    /// too long.
    fn formulas(&mut self, steps: &[NumberedStep<'_>], baselines: &[f64]) {
        let written = steps.iter().map(|step| (self.scheme.teller().formula(step), step.plan));
        let written: Vec<(Formula, Option<&Plan>)> = written.filter(|(formula, _)| !formula.is_empty()).collect();
        let in_line = written.len().div_ceil(baselines.len()).max(1);
        for (formulas, y) in written.chunks(in_line).zip(baselines) {
            let mut pieces: Vec<RichText> = Vec::new();
            for (index, (formula, plan)) in formulas.iter().enumerate() {
                pieces.extend((index > 0).then(|| RichText::plain(",   ")));
                for term in &formula.terms {
                    let set = if term.known == Known::Words { RichText::plain } else { RichText::math };
                    pieces.extend(self.pieces(&term.markup, *plan, set));
                }
            }
            self.line(&pieces, EQUATION, Point::new(self.area.x0, self.area.y0 + y), self.area.width());
        }
    }
}

impl Drawing {
    /// The figure in coarse steps: marks come with the passage of their step.
    pub(super) fn in_passages(mut self, scheme: &Scheme<'_>, passages: &[Passage]) -> Drawing {
        let number = |step: u16| match passages.iter().position(|passage| step <= passage.steps[1] as u16) {
            Some(index) if step > 0 => index as u16 + 1,
            Some(_) => 0,
            None => passages.len() as u16 + 1,
        };
        for mark in &mut self.marks {
            (mark.since, mark.until) = (number(mark.since), mark.until.map(number));
        }
        self.marks.retain(|mark| mark.until != Some(mark.since));
        let (teller, construction) = (scheme.teller(), scheme.construction);
        let caption = |passage: &Passage| {
            let plan = construction.steps_of(passage).next().and_then(|step| step.plan);
            shown_text(&teller.passage_caption(passage), plan, &scheme.words)
        };
        self.steps = passages.iter().map(caption).collect();
        self
    }
}
