//! Mistakes in force polygons: with what is laid off, closes them, and is handed on.

use super::forces::{Drawn, found};
use super::site::{Candidate, Site, instead, times};
use super::told::{Blank, Told, tell};
use crate::construction::{ForceOf, ForcePart, FoundForce, NumberId, OperationKind};
use crate::forces::Source;
use crate::sheet::Sheet;

impl Drawn<'_> {
    /// The forces that are laid off in polygons: the operation that computes the size, the size, the force's number and what it is.
    fn laid_off(&self) -> Vec<(usize, NumberId, NumberId, usize)> {
        let laid = self.site.operations().filter_map(|(index, operation)| match operation.kind {
            OperationKind::LayOff { size, .. } if operation.sheet == Sheet::Forces => {
                let maker = self.site.model.makers[size.0]?;
                let OperationKind::Compute { sum, .. } = &self.site.operation(maker).kind else { return None };
                Some((maker, size, *sum.first()?.of.first()?, index))
            }
            _ => None,
        });
        laid.collect()
    }

    /// What a number of a force is.
    fn force_of(&self, number: NumberId) -> Option<ForceOf> {
        let numbers = &self.plan.numbers;
        let load = numbers.loads.iter().position(|own| own[0] == Some(number)).map(ForceOf::Load);
        let part = || numbers.parts.iter().find(|part| part.size == number).map(|part| part.of);
        let whole = || {
            let force = numbers.whole.iter().find(|force| force.size == number)?;
            Some(ForceOf::Joint { joint: force.joint, on: force.on, part: ForcePart::Whole })
        };
        load.or_else(part).or_else(whole)
    }

    /// A force of a polygon `factor` times as large there.
    fn in_polygon(&self, factor: f64, tell: fn(Blank) -> Told) -> Vec<Candidate> {
        let laid = self.laid_off().into_iter().filter_map(|(maker, size, number, index)| {
            let told = tell(self.symbol(self.force_of(number)?));
            Some(Candidate {
                step: self.site.model.steps[index],
                ..self.site.candidate(told, times(maker, size, factor))
            })
        });
        laid.collect()
    }
}

/// A force left out of a polygon.
pub(super) fn missing(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let mut all = drawn.in_polygon(0.0, tell::force_missing_in_polygon);
        // Friction that is left out is `friction-left-out`.
        let friction = drawn.loads().filter(|(_, load)| matches!(load.source, Source::Friction(_)));
        let friction: Vec<Blank> = friction.map(|(_, load)| drawn.load_symbol(load)).collect();
        all.retain(|candidate| candidate.told.blanks.iter().all(|(_, blank)| !friction.contains(blank)));
        all
    })
}

/// A force laid off twice.
pub(super) fn twice(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| drawn.in_polygon(2.0, tell::force_twice))
}

/// What a joint does to one link handed on to the other without being reversed; or written as it acts on the other one.
pub(super) fn not_reversed(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let whole = drawn.plan.numbers.whole.iter().filter(|force| drawn.uses(force.size).next().is_some());
        let handed = whole.filter_map(|force| {
            let of = ForceOf::Joint { joint: force.joint, on: force.on, part: ForcePart::Whole };
            let step = drawn.first_step(force.size);
            let told = tell::reaction_not_reversed(drawn.symbol(of));
            drawn.together(told, vec![drawn.times(force.size, -1.0)?], Some(step))
        });
        handed.collect()
    })
}

/// The part across a link, found negative, laid off as if it were positive.
pub(super) fn negative_kept(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let is_across = |part: &&FoundForce| {
            matches!(part.of, ForceOf::Joint { part: ForcePart::Tangential | ForcePart::Normal, .. })
                && site.model.makers[part.size.0]
                    .is_some_and(|maker| matches!(site.operation(maker).kind, OperationKind::Solve { .. }))
        };
        let kept = drawn.plan.numbers.parts.iter().filter(is_across).filter_map(|part| {
            let told = tell::negative_tangential_kept(drawn.symbol(part.of));
            drawn.together(told, vec![drawn.times(part.size, -1.0)?], Some(drawn.first_step(part.size)))
        });
        kept.collect()
    })
}

impl Drawn<'_> {
    /// A found force drawn quarter turns off, in its polygon.
    fn across(&self, part: &FoundForce, turns: u8, told: Told) -> Option<Candidate> {
        let mut edits = Vec::new();
        for (index, operation) in self.site.operations() {
            let kind = match operation.kind {
                OperationKind::Draw { line, through, along }
                    if along == part.along && operation.sheet == Sheet::Forces =>
                {
                    OperationKind::Draw { line, through, along: along.turned(turns) }
                }
                OperationKind::LayOff { place, from, size, along }
                    if along == part.along && self.sizes_of(&[part.size]).contains(&size) =>
                {
                    OperationKind::LayOff { place, from, size, along: along.turned(turns) }
                }
                _ => continue,
            };
            edits.push(instead(index, kind));
        }
        self.together(told, edits, None)
    }
}

/// The part along a link drawn across it.
pub(super) fn normal_across(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let is_pin = |joint| drawn.solution().mechanism.joint(joint).slider.is_none();
        let across = drawn.plan.numbers.parts.iter().filter_map(|part| match part.of {
            ForceOf::Joint { joint, part: ForcePart::Normal, .. } if is_pin(joint) => {
                drawn.across(part, 1, tell::normal_across(drawn.symbol(part.of)))
            }
            _ => None,
        });
        across.collect()
    })
}

/// What a guide does, drawn along the guide.
pub(super) fn along_guide(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let solution = drawn.solution();
        let along = drawn.plan.numbers.parts.iter().flat_map(|part| {
            let slider = match part.of {
                ForceOf::Joint { joint, part, .. } if part != ForcePart::AlongGuide => {
                    solution.mechanism.joint(joint).slider
                }
                _ => None,
            };
            let told = slider.map(|slider| {
                let guide = Blank::Guide(solution.mechanism.slider_in_words(slider, &solution.wording()));
                tell::guide_reaction_along_rod(drawn.symbol(part.of), guide)
            });
            // Along a guide its force has no sense.
            [1, 3].map(|turns| drawn.across(part, turns, told.clone()?))
        });
        let along = along.flatten();
        along.collect()
    })
}

/// What a guide does taken to act in the slider's point.
pub(super) fn through_pin(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let solution = drawn.solution();
        let couples = drawn.plan.numbers.couples.iter().filter_map(|(slider, (number, _))| {
            let point = solution.mechanism.point_name(solution.mechanism.slider(*slider).at);
            let guide = Blank::Guide(solution.mechanism.slider_in_words(*slider, &solution.wording()));
            let edit = drawn.times(*number, 0.0)?;
            Some(site.candidate(tell::guide_reaction_through_pin(guide, point.into()), edit))
        });
        couples.collect()
    })
}

/// The torque of a drive with the sense of what it works against.
pub(super) fn torque_sense(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let torques = drawn.plan.numbers.torques.values().copied();
        let on_levers = site.model.construction.levers.iter().map(|lever| lever.number());
        let all = torques.chain(on_levers).chain(drawn.plan.numbers.pushes.values().map(|push| push.0));
        let all = all.filter_map(|number| {
            Some(site.candidate(tell::torque_sense(site.quantity(number)), drawn.times(number, -1.0)?))
        });
        all.collect()
    })
}
