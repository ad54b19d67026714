//! A figure in coarse steps: words about each passage of the construction, and marks that come with it.

use super::context::SheetContext;
use super::facts::Steps;
use super::sheet::Drawing;
use super::text::RichText;
use super::words::{BELOW, BETWEEN, EQUATION, FIRST, ROW, SECOND, Writer, width_of};
use crate::construction::{Action, Aim, ForceStep, Known, LeverStep, NumberedStep, Passage, shown_text};
use crate::sheet::Sheet;
use kurbo::{Point, Rect};

impl Writer<'_> {
    /// Equations and values of the steps of a passage.
    pub(super) fn details_of(&mut self, aim: Aim, steps: &[NumberedStep<'_>]) {
        let with_details: Vec<&NumberedStep<'_>> = match aim {
            Aim::SpecialPoints => return self.lengths(steps),
            Aim::Crossing => return self.crossing(steps),
            Aim::Rates => steps.iter().filter(|step| matches!(step.action, Action::Solve { .. })).collect(),
            Aim::Start => steps.iter().filter(|step| matches!(step.action, Action::LayOff(_))).collect(),
            Aim::Center => steps.iter().filter(|step| matches!(step.action, Action::Center(_))).collect(),
            // Its equation is the same in all steps that have it.
            Aim::Polygon => {
                let has_equation = |step: &&NumberedStep<'_>| {
                    matches!(step.action, Action::Force(ForceStep::Cross(..) | ForceStep::Close(..)))
                };
                steps.iter().filter(has_equation).take(1).collect()
            }
            Aim::Lever => {
                steps.iter().filter(|step| matches!(step.action, Action::Lever(LeverStep::Effort(_)))).collect()
            }
            Aim::Images
            | Aim::Nothing
            | Aim::PermanentCenters
            | Aim::CenterVelocity
            | Aim::VelocityLines
            | Aim::SpeedFan
            | Aim::Curvature
            | Aim::Moments => steps.iter().collect(),
        };
        match with_details.as_slice() {
            [step] => self.details(step),
            _ => self.formulas(steps, self.area, &[SECOND, SECOND + ROW]),
        }
    }

    /// The measured lengths of special points, two in a line.
    fn lengths(&mut self, steps: &[NumberedStep<'_>]) {
        let half = 0.5 * self.area.width();
        let measured = steps.iter().filter_map(|step| match &step.action {
            Action::Measure { value, .. } => Some((step, *value)),
            _ => None,
        });
        for (index, (step, value)) in measured.enumerate() {
            let (row, column) = ((index / 2) as f64, (index % 2) as f64);
            let from = Point::new(self.area.x0 + half * column, self.area.y0 + SECOND + ROW * row);
            let symbol = RichText::math(&self.context.teller().formula(step).markup());
            let value = RichText::plain(&format!(" = {}", self.size(value, Sheet::Scheme)));
            self.line(&[symbol, value], EQUATION, from, half - 4.0);
        }
    }

    /// The equations behind both rays, and what has been laid off: below the caption, with the equations beside it;
    /// after the caption, with the equations below; after the equations; or, where that is too long, below them.
    fn crossing(&mut self, steps: &[NumberedStep<'_>]) {
        let laid_off = steps.iter().filter(|step| matches!(step.action, Action::LayOff(_)));
        let laid_off: Vec<NumberedStep<'_>> = laid_off.copied().collect();
        let width = width_of(&self.formula(&laid_off), EQUATION);
        let is_beside = self.area.x0 > self.captions.x0;
        let after_caption = Rect { x0: self.caption_end + BETWEEN, ..self.captions };
        let is_after_caption = !is_beside && width <= after_caption.width();
        let rays = steps.iter().filter_map(|step| match &step.action {
            Action::Ray(ray) => Some((step, ray)),
            _ => None,
        });
        let mut x = self.area.x0;
        for (step, ray) in rays.take(2) {
            let formula = self.context.teller().formula(step);
            let end = self.ray_equation(ray, &formula, step.plan, Point::new(x, self.area.y0 + SECOND));
            let least = if is_after_caption { self.area.center().x } else { x };
            x = (end + BETWEEN).max(least);
        }
        let (area, baseline) = if is_beside {
            (Rect { x1: self.area.x0 - 4.0, ..self.captions }, FIRST + BELOW)
        } else if is_after_caption {
            (after_caption, FIRST)
        } else if width <= self.captions.x1 - x {
            (Rect { x0: x, ..self.captions }, SECOND)
        } else {
            (self.captions, SECOND + BELOW + ROW)
        };
        self.formulas(&laid_off, area, &[baseline]);
    }

    /// The formulas of some steps one after another, in lines with these baselines; in a smaller size where they are
    /// too long.
    fn formulas(&mut self, steps: &[NumberedStep<'_>], area: Rect, baselines: &[f64]) {
        let has_formula = |step: &&NumberedStep<'_>| !self.context.teller().formula(step).is_empty();
        let steps: Vec<NumberedStep<'_>> = steps.iter().filter(has_formula).copied().collect();
        let in_line = steps.len().div_ceil(baselines.len()).max(1);
        for (steps, y) in steps.chunks(in_line).zip(baselines) {
            let pieces = self.formula(steps);
            self.line(&pieces, EQUATION, Point::new(area.x0, area.y0 + y), area.width());
        }
    }

    /// The formulas of some steps, with commas between them.
    fn formula(&self, steps: &[NumberedStep<'_>]) -> Vec<RichText> {
        let mut pieces: Vec<RichText> = Vec::new();
        let written = steps.iter().map(|step| (self.context.teller().formula(step), step.plan));
        for (formula, plan) in written.filter(|(formula, _)| !formula.is_empty()) {
            pieces.extend((!pieces.is_empty()).then(|| RichText::plain(",   ")));
            for term in &formula.terms {
                let set = if term.known == Known::Words { RichText::plain } else { RichText::math };
                pieces.extend(self.pieces(&term.markup, plan, set));
            }
        }
        pieces
    }
}

impl Drawing {
    /// The figure in these steps: in coarse ones marks come with the passage of their step.
    pub(super) fn in_steps(mut self, steps: Steps, context: &SheetContext<'_>) -> Drawing {
        let passages = match steps {
            Steps::Fine => return self,
            Steps::Coarse => context.construction().passages(),
        };
        let number = |step: u16| match passages.iter().position(|passage| step <= passage.steps[1] as u16) {
            Some(index) if step > 0 => index as u16 + 1,
            Some(_) => 0,
            None => passages.len() as u16 + 1,
        };
        for mark in &mut self.marks {
            (mark.since, mark.until) = (number(mark.since), mark.until.map(number));
        }
        self.marks.retain(|mark| mark.until != Some(mark.since));
        let (teller, construction) = (context.teller(), context.construction());
        let caption = |passage: &Passage| {
            let plan = construction.steps_of(passage).next().and_then(|step| step.plan);
            shown_text(&teller.passage_caption(passage), plan, &context.words)
        };
        self.steps = passages.iter().map(caption).collect();
        self
    }
}
