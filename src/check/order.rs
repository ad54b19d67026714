use crate::drafting::{Act, Deed, Sheet};
use crate::plan::{Action, Construction, Plan, Step};

/// A step of the construction with the number that `kinegon steps` gives it.
#[derive(Clone, Copy, Debug)]
pub struct NumberedStep<'a> {
    /// Counted from 1 through all sheets.
    pub number: usize,
    /// Where it is drawn.
    pub sheet: Sheet,
    /// The plan to which it belongs; none for the scheme.
    pub plan: Option<&'a Plan>,
    /// What is done.
    pub step: &'a Step,
}

/// All steps of a construction, numbered.
#[must_use]
pub fn numbered_steps(construction: &Construction) -> Vec<NumberedStep<'_>> {
    let scheme = construction.scheme.iter();
    let scheme = scheme.map(|step| (Sheet::Scheme, None, step));
    let plans = construction.plans().flat_map(|plan| {
        let steps = plan.steps.iter();
        steps.map(move |step| (Sheet::of(plan.kind), Some(plan), step))
    });
    let all = scheme.chain(plans).zip(1..);
    all.map(|((sheet, plan, step), number)| NumberedStep { number, sheet, plan, step }).collect()
}

impl NumberedStep<'_> {
    /// The quantities that the step gives, by name.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let segment = |from: &str, to: &str| self.plan.map(|p| p.kind.segment_name(from, to));
        match &self.step.action {
            Action::MeasureLength { from, to, .. } => vec![format!("L({from},{to})")],
            Action::LayOff(arrow) => segment(&arrow.from, &arrow.to).into_iter().collect(),
            Action::Cross { point, .. } => {
                let pole = self.plan.map_or("", |p| p.kind.pole());
                segment(pole, point).into_iter().collect()
            }
            Action::Measure { from, to, .. } => segment(from, to).into_iter().collect(),
            Action::Solve { unknowns, .. } => unknowns.iter().map(|u| u.0.clone()).collect(),
            _ => Vec::new(),
        }
    }

    /// The point that the step makes, where it makes one.
    fn point(&self) -> Option<&str> {
        match &self.step.action {
            Action::SpecialPoint { point, .. } | Action::Cross { point, .. } => Some(point),
            Action::LayOff(arrow) => Some(&arrow.to),
            _ => None,
        }
    }
}

/// The number of the step that an act belongs to, where `place_name` gives the points' names; none for acts before all steps.
pub(super) fn step_of(act: &Act, steps: &[NumberedStep<'_>], made: &[String], before: usize) -> usize {
    let here = || steps.iter().filter(|s| s.sheet == act.sheet);
    let by_point = || {
        let mut found = here().filter(|s| s.point().is_some_and(|p| made.iter().any(|m| m == p)));
        found.next().map(|s| s.number)
    };
    let number = match &act.deed {
        Deed::Cross { .. } | Deed::LayOff { .. } => by_point(),
        Deed::Measure { .. } => {
            let mut found = here().filter(|s| s.names().contains(&act.makes));
            found.next().map(|s| s.number)
        }
        Deed::Draw { .. } => here()
            .find(|s| match &s.step.action {
                Action::Ray(ray) => {
                    let point = crate::plan::image_name(&ray.to);
                    act.makes == format!("ray from {} to {point}", ray.through)
                }
                Action::SpecialPoint { point, .. } => act.makes == format!("cut line of {point}"),
                _ => false,
            })
            .map(|s| s.number),
        Deed::Solve { .. } => here()
            .find(|s| {
                matches!(s.step.action, Action::Solve { .. })
                    && s.names().join(", ").contains(act.makes.split(", ").next().unwrap_or("?"))
            })
            .map(|s| s.number),
        _ => None,
    };
    number.unwrap_or(before)
}
