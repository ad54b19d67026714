//! Steps of a construction, and which of them makes what is drawn.

use crate::construction::{Action, Construction, Plan};
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
        let mut before = construction.scheme.len();
        let special = (1..).zip(&construction.scheme).filter_map(|(number, step)| match &step.action {
            Action::SpecialPoint { point, .. } => Some((point.clone(), number)),
            _ => None,
        });
        let special = special.collect();
        let mut plan = |plan: Option<&Plan>| {
            let steps = plan.map(|plan| PlanSteps::new(plan, before));
            before += plan.map_or(0, |plan| plan.steps.len());
            steps.unwrap_or_default()
        };
        let solved = construction.numbered_steps().filter_map(|step| match &step.step.action {
            Action::Solve { unknowns, .. } => Some((step.number as u16, unknowns)),
            _ => None,
        });
        let rates = solved.flat_map(|(number, unknowns)| unknowns.iter().map(move |(name, _)| (name.clone(), number)));
        Self { rates: rates.collect(), special, plans: PerSheet::from_fn(|sheet| plan(construction.plan_on(sheet))) }
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
    fn new(plan: &Plan, before: usize) -> Self {
        let number = |index: usize| (before + index + 1) as u16;
        let mut steps = Self { last: number(plan.steps.len().saturating_sub(1)), ..Self::default() };
        for (index, step) in plan.steps.iter().enumerate() {
            let number = number(index);
            let mut made = |point: &String| {
                steps.points.entry(point.clone()).or_insert(number);
            };
            match &step.action {
                Action::Pole { images } => {
                    made(&plan.kind.pole().to_owned());
                    images.iter().for_each(made);
                }
                // The start of a vector may have no step of its own.
                Action::LayOff(arrow) => {
                    [&arrow.from, &arrow.to].into_iter().for_each(made);
                    let ends = [arrow.from.clone(), arrow.to.clone()];
                    steps.vectors.entry(ends).or_insert(number);
                }
                Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => {
                    made(point)
                }
                Action::Ray(ray) => {
                    let ends = [ray.through.clone(), ray.to.clone()];
                    steps.rays.entry(ends).or_insert(number);
                }
                _ => {}
            }
        }
        steps
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
