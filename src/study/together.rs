//! Mechanisms followed side by side from position to position, as long as each surely stays on its branch.

use super::samples::{Spaced, Spot, unwrap};
use super::task::{Outcome, Status, Summary, Task, Wanted};
use crate::cycle::{Kept, Variants};
use crate::geometry::{MANY, Many, Row, with_turns};
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
    /// Where all mechanisms were at the scene's position.
    start: Kept,
    /// By mechanism: whether it surely stayed on its branch.
    sure: Vec<bool>,
    /// By step: where all mechanisms were.
    kept: Vec<Option<Kept>>,
    /// By quantity: its values, by [`MANY`] mechanisms and step.
    samples: Vec<Vec<Many>>,
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
        let rows = count.div_ceil(MANY) * (last + 1);
        let mut walk = Walk {
            task,
            first: first as usize,
            origin,
            start: variants.kept(),
            sure: (0..count).map(|mechanism| variants.is_closed(mechanism)).collect(),
            kept: vec![None; last + 1],
            samples: vec![vec![Many::splat(f64::NAN); rows]; task.wanted.len()],
            at_scene: vec![vec![f64::NAN; count]; task.wanted.len()],
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
        let (first, count) = (self.first, self.kept.len());
        self.go_to(first, [None; 2]);
        for step in first + 1..count {
            self.go_to(step, [Some(step - 1), step.checked_sub(2).filter(|before| *before >= first)]);
        }
        for step in (0..first).rev() {
            self.go_to(step, [Some(step + 1), Some(step + 2).filter(|before| *before < count)]);
        }
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

    /// Moves all mechanisms to a step from the one beside it, else from the scene's position, and reads their quantities; the step before
    /// that helps to find them.
    fn go_to(&mut self, step: usize, [last, before]: [Option<usize>; 2]) {
        let Walk { variants, kept, sure, samples, .. } = self;
        let (range, steps) = (&self.task.range, kept.len());
        let value = range.steps.value(step);
        let was = last.map_or(self.origin, |last| range.steps.value(last));
        let times = variants.times(&range.drive, value - was, sure);
        let at = |step: Option<usize>| step.and_then(|step| kept[step].as_ref());
        let last = at(last).unwrap_or(&self.start);
        variants.run_on(at(before), last, &times);
        for mechanism in (0..sure.len()).filter(|m| sure[*m]) {
            variants.set_along(mechanism, &range.drive, value);
        }
        variants.compute();
        for (mechanism, kept_branch) in variants.kept_branch(last, &times).into_iter().enumerate() {
            let is_closed = variants.is_closed(mechanism);
            if sure[mechanism] && !is_closed {
                // It stays where it was.
                variants.put_back(mechanism, last);
                variants.set_along(mechanism, &range.drive, was);
            }
            sure[mechanism] &= is_closed && kept_branch;
        }
        for (wanted, samples) in self.task.wanted.iter().zip(samples) {
            // Most studies ask for rates, which stand in a row.
            if let Some(rate) = wanted.asked.as_rate() {
                let samples = samples.iter_mut().skip(step).step_by(steps);
                samples.zip(variants.rates(rate)).for_each(|(row, values)| *row = *values);
                continue;
            }
            for mechanism in (0..sure.len()).filter(|m| sure[*m]) {
                samples[mechanism / MANY * steps + step][mechanism % MANY] = read(wanted, variants, mechanism);
            }
        }
        kept[step] = Some(variants.kept());
    }

    /// What the samples tell.
    fn summed(&mut self) -> Vec<Option<Outcome>> {
        for quantity in (0..self.task.wanted.len()).filter(|quantity| self.task.wanted[*quantity].turns()) {
            for mechanism in 0..self.sure.len() {
                let mut samples = self.samples(mechanism, quantity);
                unwrap(&mut samples);
                let rows = self.samples[quantity][mechanism / MANY * samples.len()..].iter_mut();
                rows.zip(samples).for_each(|(row, sample)| row[mechanism % MANY] = sample);
            }
        }
        let whole = Outcome {
            status: Status::Whole,
            reach: Some(self.task.range.ends()),
            summaries: vec![Summary::default(); self.task.wanted.len()],
        };
        let mut outcomes: Vec<Option<Outcome>> = self.sure.iter().map(|sure| sure.then(|| whole.clone())).collect();
        for (mechanism, outcome) in outcomes.iter_mut().enumerate() {
            let Some(outcome) = outcome else { continue };
            for (quantity, (wanted, summary)) in self.task.wanted.iter().zip(&mut outcome.summaries).enumerate() {
                summary.at_scene = Some(self.at_scene[quantity][mechanism]).filter(|y| y.is_finite());
                if wanted.has_sum() {
                    summary.sum(wanted, &self.samples(mechanism, quantity), &self.task.range);
                }
            }
        }
        outcomes
    }

    /// The values of a quantity of a mechanism, by step.
    fn samples(&self, mechanism: usize, quantity: usize) -> Vec<f64> {
        let steps = self.kept.len();
        let rows = &self.samples[quantity][mechanism / MANY * steps..][..steps];
        rows.iter().map(|row| row[mechanism % MANY]).collect()
    }

    /// Takes the greatest of the samples of a quantity (`sign` 1), or the least ones; none of those with a sample without a value.
    fn pick(&self, quantity: usize, sign: f64, outcomes: &mut [Option<Outcome>]) {
        let rows = self.samples[quantity].chunks_exact(self.kept.len());
        for (rows, outcomes) in rows.zip(outcomes.chunks_mut(MANY)) {
            let [places, values] = greatest(rows, sign);
            for (lane, outcome) in outcomes.iter_mut().enumerate() {
                let Some(outcome) = outcome else { continue };
                let at = self.task.range.steps.value(places[lane] as usize);
                let found = Some([at, sign * values[lane]]).filter(|[_, value]| value.is_finite());
                let summary = &mut outcome.summaries[quantity];
                if sign > 0.0 { summary.max = found } else { summary.min = found }
            }
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
            let sample = spot.value;
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
        let values = &self.samples(mechanism, quantity)[..];
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

/// Of each lane of some rows the place of the greatest value (`sign` 1) or the least one, the first of equal ones, and that value times the sign;
/// infinite where a value is not finite.
fn greatest(rows: &[Many], sign: f64) -> [Many; 2] {
    let [mut places, mut values, mut wrong] = [0.0, f64::NEG_INFINITY, 0.0].map(Many::splat);
    for (place, row) in rows.iter().enumerate() {
        // Chosen and counted in numbers, so that the compiler uses registers of many.
        for lane in 0..MANY {
            let value = sign * row[lane];
            let is_greater = value > values[lane];
            places[lane] = if is_greater { place as f64 } else { places[lane] };
            values[lane] = if is_greater { value } else { values[lane] };
            wrong[lane] += if value.is_finite() { 0.0 } else { f64::INFINITY };
        }
    }
    (0..MANY).for_each(|lane| values[lane] += wrong[lane]);
    [places, values]
}
