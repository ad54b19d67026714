//! Mechanisms followed side by side from position to position, as long as each surely stays on its branch.

use super::samples::{Spaced, Spot, mean, unwrap};
use super::task::{Outcome, Status, Summary, Task, Wanted};
use crate::cycle::{Kept, Variants};
use crate::geometry::with_turns;
use crate::quantity::Quantity;

/// Difference of a quantity at the ends of a turn, in parts of its height, that is rounding.
const SAME: f64 = 1e-9;

/// Whether mechanisms can be followed side by side: bounds of errors, and what needs a construction, are found for one at a time.
pub(super) fn suits(task: &Task) -> bool {
    !task.errors && !task.wanted.iter().any(|w| w.asked.needs_construction())
}

/// What becomes of mechanisms; `None` of those that have to be followed by themselves.
pub(super) fn follow(task: &Task, variants: Variants<'_>) -> Vec<Option<Outcome>> {
    let count = variants.count();
    Walk::new(task, variants).map_or_else(|| vec![None; count], Walk::outcomes)
}

/// Mechanisms on their way through the cycle.
struct Walk<'a> {
    task: &'a Task,
    variants: Variants<'a>,
    /// The step next to the scene's position.
    first: usize,
    origin: f64,
    /// By mechanism: whether it surely stayed on its branch.
    sure: Vec<bool>,
    /// By step: where all mechanisms were.
    kept: Vec<Option<Kept>>,
    /// By quantity: its values, by mechanism and step.
    samples: Vec<Vec<f64>>,
    /// By quantity and mechanism.
    at_scene: Vec<Vec<f64>>,
}

impl<'a> Walk<'a> {
    /// The mechanisms in their first position; `None` where the scene's position lies outside the cycle, or the drive's rates are such that
    /// they do not tell how far the next position is.
    fn new(task: &'a Task, variants: Variants<'a>) -> Option<Self> {
        let range = &task.range;
        let (count, last) = (variants.count(), range.steps.count() - 1);
        let origin = variants.start(0, &range.drive);
        let first = ((origin - range.from) / (range.to - range.from) * last as f64).round();
        let is_inside = (0.0..=last as f64).contains(&first);
        let starts_there = (0..count).all(|i| variants.start(i, &range.drive) == origin);
        if !is_inside || !starts_there || !(0..count).all(|i| variants.runs_evenly(i, &range.drive)) {
            return None;
        }
        let numbers = |count| vec![vec![f64::NAN; count]; task.wanted.len()];
        let mut walk = Walk {
            task,
            first: first as usize,
            origin,
            sure: vec![true; count],
            kept: vec![None; last + 1],
            samples: numbers(count * (last + 1)),
            at_scene: numbers(count),
            variants,
        };
        for (wanted, at_scene) in task.wanted.iter().zip(&mut walk.at_scene) {
            for (mechanism, value) in at_scene.iter_mut().enumerate() {
                *value = read(wanted, &walk.variants, mechanism);
            }
        }
        Some(walk)
    }

    fn outcomes(mut self) -> Vec<Option<Outcome>> {
        let start = self.variants.kept();
        let steps = self.task.range.steps;
        for sure in 0..self.sure.len() {
            self.sure[sure] = self.variants.is_closed(sure);
        }
        self.go(&start, (self.first..steps.count()).collect());
        for mechanism in 0..self.sure.len() {
            if self.sure[mechanism] {
                self.variants.put_back(mechanism, &start);
            }
        }
        self.go(&start, (0..self.first).rev().collect());
        let mut outcomes = self.summed();
        for sign in [1.0, -1.0] {
            for quantity in 0..self.task.wanted.len() {
                match self.task.wanted[quantity].has_extreme(sign) {
                    true if self.task.at_steps => self.pick(quantity, sign, &mut outcomes),
                    true => self.refine(quantity, sign, &mut outcomes),
                    false => {}
                }
            }
        }
        outcomes
    }

    /// Moves all mechanisms from the start through these steps and reads their quantities.
    fn go(&mut self, start: &Kept, steps: Vec<usize>) {
        let mut last = None;
        let mut was = self.origin;
        for step in steps {
            let value = self.task.range.steps.value(step);
            for mechanism in (0..self.sure.len()).filter(|i| self.sure[*i]) {
                self.variants.set_along(mechanism, &self.task.range.drive, value);
            }
            self.variants.compute();
            let times: Vec<f64> =
                (0..self.sure.len()).map(|m| self.variants.time(m, &self.task.range.drive, value - was)).collect();
            let before = last.and_then(|last: usize| self.kept[last].as_ref()).unwrap_or(start);
            let kept_branch = self.variants.kept_branch(before, &times);
            for (mechanism, kept_branch) in kept_branch.into_iter().enumerate() {
                if !self.sure[mechanism] {
                    continue;
                }
                let is_closed = self.variants.is_closed(mechanism);
                if !is_closed {
                    // It stays where it is.
                    self.variants.set_along(mechanism, &self.task.range.drive, was);
                }
                self.sure[mechanism] = is_closed && kept_branch;
            }
            let steps = self.kept.len();
            for (wanted, samples) in self.task.wanted.iter().zip(&mut self.samples) {
                // Most studies ask for rates, which stand in a row.
                if let Some(rate) = wanted.asked.as_rate() {
                    let values = self.variants.rates(rate).flatten();
                    samples
                        .iter_mut()
                        .skip(step)
                        .step_by(steps)
                        .zip(values)
                        .for_each(|(sample, value)| *sample = *value);
                    continue;
                }
                for mechanism in (0..self.sure.len()).filter(|m| self.sure[*m]) {
                    samples[mechanism * steps + step] = read(wanted, &self.variants, mechanism);
                }
            }
            self.kept[step] = Some(self.variants.kept());
            last = Some(step);
            was = value;
        }
    }

    /// What the samples tell.
    fn summed(&mut self) -> Vec<Option<Outcome>> {
        let (range, steps) = (&self.task.range, self.kept.len());
        let whole = Outcome {
            status: Status::Whole,
            reach: Some(range.ends()),
            summaries: vec![Summary::default(); self.task.wanted.len()],
        };
        let mut outcomes: Vec<Option<Outcome>> = self.sure.iter().map(|sure| sure.then(|| whole.clone())).collect();
        for (quantity, wanted) in self.task.wanted.iter().enumerate() {
            let samples = self.samples[quantity].chunks_exact_mut(steps);
            for ((outcome, samples), at_scene) in outcomes.iter_mut().zip(samples).zip(&self.at_scene[quantity]) {
                let Some(outcome) = outcome else { continue };
                if wanted.turns() {
                    unwrap(samples);
                }
                let summary = &mut outcome.summaries[quantity];
                summary.at_scene = Some(*at_scene).filter(|y| y.is_finite());
                summary.mean = if wanted.has_mean() { mean(samples) } else { None };
            }
        }
        outcomes
    }

    /// The values of a quantity of a mechanism, by step.
    fn samples(&self, mechanism: usize, quantity: usize) -> &[f64] {
        let steps = self.kept.len();
        &self.samples[quantity][mechanism * steps..][..steps]
    }

    /// Takes the greatest of the samples of a quantity (`sign` 1), or the least ones; none of those with a sample without a value.
    fn pick(&self, quantity: usize, sign: f64, outcomes: &mut [Option<Outcome>]) {
        for (mechanism, outcome) in outcomes.iter_mut().enumerate() {
            let Some(outcome) = outcome else { continue };
            let samples = self.samples(mechanism, quantity);
            let better = |best: f64, y: &f64| if sign * y > sign * best { *y } else { best };
            let value = samples.iter().fold(f64::NEG_INFINITY * sign, better);
            let at = samples.iter().position(|y| *y == value).map(|step| self.task.range.steps.value(step));
            let found = at.filter(|_| samples.iter().all(|y| y.is_finite())).map(|at| [at, value]);
            let summary = &mut outcome.summaries[quantity];
            if sign > 0.0 { summary.max = found } else { summary.min = found }
        }
    }

    /// Finds the greatest values of a quantity (`sign` 1), or the least ones: each mechanism is moved to where its samples let it expect.
    fn refine(&mut self, quantity: usize, sign: f64, outcomes: &mut [Option<Outcome>]) {
        let (range, wanted) = (&self.task.range, &self.task.wanted[quantity]);
        let spots: Vec<Option<Spot>> = (0..self.sure.len()).map(|i| self.peak(i, quantity, sign, wanted)).collect();
        let step = range.steps.value(1) - range.steps.value(0);
        let at = |spot: Spot| range.steps.value(spot.sample) + spot.beyond * step;
        for (mechanism, spot) in spots.iter().enumerate() {
            if let Some(spot) = *spot
                && let Some(kept) = &self.kept[spot.sample]
            {
                self.variants.put_back(mechanism, kept);
                self.variants.set_along(mechanism, &self.task.range.drive, at(spot));
            }
        }
        self.variants.compute();
        for (mechanism, spot) in spots.into_iter().enumerate() {
            let (Some(spot), Some(outcome)) = (spot, &mut outcomes[mechanism]) else {
                continue;
            };
            let sample = self.samples(mechanism, quantity)[spot.sample];
            let moved = read(wanted, &self.variants, mechanism);
            let moved = if wanted.turns() { with_turns(moved, sample) } else { moved };
            let found = match sign * (moved - sample) > 0.0 {
                true => [within(at(spot), range.ends()), moved],
                false => [range.steps.value(spot.sample), sample],
            };
            let summary = &mut outcome.summaries[quantity];
            if sign > 0.0 { summary.max = Some(found) } else { summary.min = Some(found) }
        }
    }

    fn peak(&self, mechanism: usize, quantity: usize, sign: f64, wanted: &Wanted) -> Option<Spot> {
        if !self.sure[mechanism] {
            return None;
        }
        let values = self.samples(mechanism, quantity);
        let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], y| [l.min(*y), h.max(*y)]);
        let closes = (values[0] - values[values.len() - 1]).abs() <= SAME * (high - low);
        let periodic = self.task.range.is_turn && closes && !wanted.turns();
        Spaced { values, sign, periodic }.peak()
    }
}

/// The value of a quantity that needs no construction where a mechanism is, of a vector its size; NaN where it has none.
fn read(wanted: &Wanted, variants: &Variants<'_>, mechanism: usize) -> f64 {
    let position = variants.position(mechanism);
    let value = position.and_then(|position| wanted.asked.value(&position, None, None).ok());
    value.map_or(f64::NAN, Quantity::as_number)
}

/// A value of the drive within a turn.
fn within(value: f64, [low, high]: [f64; 2]) -> f64 {
    if value < low {
        value + 360.0
    } else if value > high {
        value - 360.0
    } else {
        value
    }
}
