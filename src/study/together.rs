//! Mechanisms followed side by side from position to position, as long as each surely stays on its branch.

use super::samples::{Spaced, Spot, mean, unwrap};
use super::task::{Outcome, Status, Summary, Task, Wanted};
use crate::cycle::{Kept, Position, Variants};
use crate::geometry::{Many, with_turns};
use crate::mechanism::Mechanism;
use crate::position::Pose;
use crate::quantity::Quantity;

/// Difference of a quantity at the ends of a turn, in parts of its height, that is rounding.
const SAME: f64 = 1e-9;

/// What becomes of mechanisms; `None` of those that have to be followed by themselves.
pub(super) fn follow(task: &Task, mechanisms: &[Mechanism], poses: &[Pose]) -> Vec<Option<Outcome>> {
    let nothing = mechanisms.iter().map(|_| None).collect();
    if mechanisms.is_empty() || task.errors || task.wanted.iter().any(|w| w.asked.needs_construction()) {
        return nothing;
    }
    let Ok(variants) = Variants::new(mechanisms, poses) else {
        return nothing;
    };
    Walk::new(task, variants).map_or(nothing, Walk::outcomes)
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
    /// By mechanism, quantity and step.
    samples: Vec<Vec<Vec<f64>>>,
    /// By mechanism and quantity.
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
        let quantities = task.wanted.len();
        let mut walk = Walk {
            task,
            first: first as usize,
            origin,
            sure: vec![true; count],
            kept: vec![None; last + 1],
            samples: vec![vec![vec![f64::NAN; last + 1]; quantities]; count],
            at_scene: vec![Vec::new(); count],
            variants,
        };
        for (mechanism, at_scene) in walk.at_scene.iter_mut().enumerate() {
            let position = walk.variants.position(mechanism);
            at_scene.extend(task.wanted.iter().map(|wanted| read(wanted, position.as_ref())));
        }
        Some(walk)
    }

    fn outcomes(mut self) -> Vec<Option<Outcome>> {
        let start = self.variants.kept();
        let steps = self.task.range.steps;
        for sure in 0..self.sure.len() {
            self.sure[sure] = self.variants.position(sure).is_some();
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
                if self.task.wanted[quantity].has_extreme(sign) {
                    self.refine(quantity, sign, &mut outcomes);
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
                let closed = self.variants.position(mechanism).is_some();
                if !closed {
                    // It stays where it is.
                    self.variants.set_along(mechanism, &self.task.range.drive, was);
                }
                if !closed || !kept_branch {
                    self.sure[mechanism] = false;
                    continue;
                }
                let position = self.variants.position(mechanism);
                for (wanted, samples) in self.task.wanted.iter().zip(&mut self.samples[mechanism]) {
                    samples[step] = read(wanted, position.as_ref());
                }
            }
            self.kept[step] = Some(self.variants.kept());
            last = Some(step);
            was = value;
        }
    }

    /// What the samples tell.
    fn summed(&mut self) -> Vec<Option<Outcome>> {
        let range = &self.task.range;
        let mut outcomes = Vec::new();
        for (mechanism, sure) in self.sure.iter().enumerate() {
            let mut summaries = Vec::new();
            for (quantity, wanted) in self.task.wanted.iter().enumerate() {
                let samples = &mut self.samples[mechanism][quantity];
                if wanted.turns() {
                    unwrap(samples);
                }
                let at_scene = Some(self.at_scene[mechanism][quantity]).filter(|y| y.is_finite());
                let mean = if wanted.has_mean() { mean(samples) } else { None };
                summaries.push(Summary { mean, at_scene, ..Summary::default() });
            }
            let whole = Outcome { status: Status::Whole, reach: Some(range.ends()), summaries };
            outcomes.push(sure.then_some(whole));
        }
        outcomes
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
            let sample = self.samples[mechanism][quantity][spot.sample];
            let moved = read(wanted, self.variants.position(mechanism).as_ref());
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
        let values = &self.samples[mechanism][quantity];
        let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], y| [l.min(*y), h.max(*y)]);
        let closes = (values[0] - values[values.len() - 1]).abs() <= SAME * (high - low);
        let periodic = self.task.range.is_turn && closes && !wanted.turns();
        Spaced { values, sign, periodic }.peak()
    }
}

/// The value of a quantity that needs no construction in a position, of a vector its size; NaN where it has none.
fn read(wanted: &Wanted, position: Option<&Position<'_, Many>>) -> f64 {
    let value = position.and_then(|position| wanted.asked.value(position, None, None).ok());
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
