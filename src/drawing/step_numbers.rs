//! Steps of a construction, and which of them makes what is drawn.

use crate::construction::{Action, Construction, NumberedStep};
use crate::sheet::{PerSheet, Sheet};
use indexmap::IndexMap;

/// How finely a construction is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// Every step by itself.
    Fine,
    /// Steps that belong together at once.
    Coarse,
}

/// For points, rays and vectors the step of the construction that makes them. Steps count from 1, through the scheme,
/// the velocity plan and the acceleration plan.
#[derive(Default)]
pub(super) struct StepNumbers {
    special: IndexMap<String, u16>,
    /// Solved rates, by the names of their quantities.
    rates: IndexMap<String, u16>,
    plans: PerSheet<PlanSteps>,
}

/// The steps that make a plan's points, rays and vectors.
#[derive(Default)]
pub(super) struct PlanSteps {
    last: u16,
    points: IndexMap<String, u16>,
    rays: IndexMap<[String; 2], u16>,
    vectors: IndexMap<[String; 2], u16>,
}

impl StepNumbers {
    pub(super) fn new(construction: &Construction) -> Self {
        let mut numbers = Self::default();
        for NumberedStep { number, sheet, action, .. } in construction.numbered_steps() {
            let number = number as u16;
            if let Action::SpecialPoint { point, .. } = action {
                numbers.special.insert(point.clone(), number);
            }
            if let Action::Solve { unknowns, .. } = action {
                numbers.rates.extend(unknowns.iter().map(|(name, _)| (name.clone(), number)));
            }
            numbers.plans[sheet].add(number, sheet, action);
        }
        numbers
    }

    /// The step that finds a special point.
    pub(super) fn special(&self, point: &str) -> u16 {
        self.special.get(point).copied().unwrap_or_default()
    }

    /// The step that solves for a rate; the last of the plan for one that no step solves for.
    pub(super) fn rate(&self, plan: Sheet, name: &str) -> u16 {
        self.rates.get(name).copied().unwrap_or(self.plan(plan).last)
    }
    pub(super) fn plan(&self, sheet: Sheet) -> &PlanSteps {
        &self.plans[sheet]
    }
}

impl PlanSteps {
    /// Adds the next step.
    fn add(&mut self, number: u16, sheet: Sheet, action: &Action) {
        self.last = number;
        let mut made = |point: &str| {
            self.points.entry(point.to_owned()).or_insert(number);
        };
        match action {
            Action::Pole { images } => {
                made(sheet.pole());
                images.iter().for_each(|image| made(image));
            }
            // The start of a vector may have no step of its own.
            Action::LayOff(arrow) => {
                [&arrow.from, &arrow.to].into_iter().for_each(|point| made(point));
                let ends = [arrow.from.clone(), arrow.to.clone()];
                self.vectors.entry(ends).or_insert(number);
            }
            Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => made(point),
            Action::Ray(ray) => {
                let ends = [ray.through.clone(), ray.to.clone()];
                self.rays.entry(ends).or_insert(number);
            }
            _ => {}
        }
    }

    /// The step that makes a point; the plan's last for a point without a step.
    pub(super) fn point(&self, name: &str) -> u16 {
        self.points.get(name).copied().unwrap_or(self.last)
    }

    /// The step that lays off a vector.
    pub(super) fn vector(&self, from: &str, to: &str) -> u16 {
        let ends = [from.to_owned(), to.to_owned()];
        self.vectors.get(&ends).copied().unwrap_or(self.last)
    }

    /// The step that draws the ray through one point to another.
    pub(super) fn ray(&self, through: &str, to: &str) -> u16 {
        let ends = [through.to_owned(), to.to_owned()];
        self.rays.get(&ends).copied().unwrap_or(self.last)
    }
}
