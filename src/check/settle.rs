//! Fits the amounts of mistakes that are not known beforehand: so that the first value that they move is the written one.

use super::fit::Fit;
use super::mistakes::{Amount, Blank, Candidate, Free, Mistake, measured_there, tell};
use super::score::Scorer;
use crate::construction::Disturbance;

/// Angles that are tried first, in degrees apart.
const GRID: f64 = 15.0;

/// Sizes of amounts that are tried first, in parts of their range.
const SIZES: [f64; 12] = [-8.0, -4.0, -2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0, 8.0];

/// Values among which the first is that an amount is fitted to.
const NEAR: usize = 3;

/// Most iterations for a root.
const ITERATIONS: usize = 40;

/// A mistake of unknown amount beside the mistakes of an explanation.
pub(super) struct Settling<'a> {
    scorer: &'a Scorer<'a>,
    /// The mistakes of the explanation, and how well values fit it.
    set: &'a [&'a Candidate],
    fit: &'a Fit,
    template: &'a Candidate,
    /// The amounts without the mistake.
    none: Vec<f64>,
}

impl<'a> Settling<'a> {
    pub fn new(
        scorer: &'a Scorer<'a>,
        set: &'a [&'a Candidate],
        fit: &'a Fit,
        template: &'a Candidate,
    ) -> Settling<'a> {
        let model = scorer.model(set);
        let values = model.replay(&scorer.changes(set, None));
        let none = template.free.iter().map(|free| match free.what {
            Amount::Error(_) => 0.0,
            Amount::Number(number) => values.number(number),
        });
        Settling { scorer, set, fit, template, none: none.collect() }
    }

    /// The mistake with amounts that make the first value it moves the written one; none where that value is as
    /// expected without it. There may be several ways.
    pub fn settled(&self) -> Vec<Candidate> {
        let moved = self.moved();
        // Values before the first that is wrong may happen to be near.
        let Some(at) = moved.iter().take(NEAR).position(|&datum| self.fit.outside[datum]) else {
            return Vec::new();
        };
        let first = moved[at];
        // Amounts of two operations: the first value that the later one moves besides.
        let second = match self.template.free.as_slice() {
            [one, other] if one.operation != other.operation => {
                self.moved_by(1).into_iter().find(|&datum| datum != first && self.fit.outside[datum])
            }
            _ => moved.get(at + 1).copied(),
        };
        let roots = match (self.none.len(), second) {
            (1, _) => self.roots(first),
            (_, Some(second)) => self.points([first, second]),
            _ => Vec::new(),
        };
        let entry = self.scorer.entry(first);
        // What is wrong before the first step shows at the step of the first value.
        let step = if self.template.step == 0 { entry.step } else { self.template.step };
        let named = |amounts: Vec<f64>| -> Vec<Candidate> {
            let settled = Candidate { step, ..self.with(&amounts) };
            if self.template.mistake() == Mistake::Unknown {
                let told = tell::unknown(Blank::Quantity(entry.asked.name().to_owned()));
                return vec![Candidate { told, ..settled }];
            }
            let model = self.scorer.model(self.set);
            let place = |free: &Free| model.construction.operations[free.operation].kind.place();
            // Lines that are moved go through what is marked on them.
            let marked = if self.template.edits.is_empty() { &[] } else { self.template.free.as_slice() };
            let places = marked.iter().filter_map(place);
            places.fold(vec![settled], |all, place| {
                all.into_iter().flat_map(|settled| measured_there(model, settled, place)).collect()
            })
        };
        roots.into_iter().flat_map(named).collect()
    }

    /// The mistake with these amounts.
    fn with(&self, amounts: &[f64]) -> Candidate {
        let amounts = self.template.free.iter().zip(amounts);
        let edits =
            amounts.map(|(free, &amount)| Disturbance { operation: free.operation, change: free.change(amount) });
        // The amounts first, each beside what is free (`Scorer::free`).
        Candidate { edits: edits.chain(self.template.edits.iter().cloned()).collect(), ..self.template.clone() }
    }

    fn predicted(&self, amounts: &[f64]) -> Vec<f64> {
        let candidate = self.with(amounts);
        let mut set = self.set.to_vec();
        set.push(&candidate);
        self.scorer.predicted(&set)
    }

    /// The data that the mistake moves, in the order of the construction.
    fn moved(&self) -> Vec<usize> {
        let mut moved: Vec<usize> = (0..self.template.free.len()).flat_map(|which| self.moved_by(which)).collect();
        moved.sort_unstable();
        moved.dedup();
        moved
    }

    /// The data that one of its amounts moves.
    fn moved_by(&self, which: usize) -> Vec<usize> {
        let mut amounts = self.none.clone();
        amounts[which] += 0.5 * self.template.free[which].range;
        let predicted = self.predicted(&amounts);
        let is_moved = |index: &usize| {
            let datum = &self.scorer.data[*index];
            let by = datum.seen_apart(predicted[*index], self.fit.predicted[*index]);
            by.abs() > 1e-3 * datum.span
        };
        (0..self.fit.predicted.len()).filter(is_moved).collect()
    }

    /// How far a predicted value is from the written one.
    fn apart(&self, datum: usize, predicted: f64) -> f64 {
        let datum = &self.scorer.data[datum];
        datum.seen_apart(datum.value, predicted)
    }

    /// The amounts at which a value is the written one.
    fn roots(&self, datum: usize) -> Vec<Vec<f64>> {
        let free = &self.template.free[0];
        let at = |amount: f64| self.apart(datum, self.predicted(&[amount])[datum]);
        let grid: Vec<f64> = if free.is_angle {
            (-12..=12).map(|i| f64::from(i) * GRID).collect()
        } else {
            SIZES.iter().map(|size| self.none[0] + size * free.range).collect()
        };
        let apart: Vec<f64> = grid.iter().map(|&amount| at(amount)).collect();
        // A root between two places is told by the signs there, one at a place, as of twice the right number, by nothing else.
        let mut roots: Vec<Vec<f64>> =
            grid.iter().zip(&apart).filter(|(_, apart)| **apart == 0.0).map(|(&amount, _)| vec![amount]).collect();
        for (x, f) in grid.windows(2).zip(apart.windows(2)) {
            if f[0].is_finite() && f[1].is_finite() && f[0] * f[1] < 0.0 {
                let tolerance = 0.1 * self.scorer.data[datum].rounding;
                roots.extend(root([x[0], x[1]], [f[0], f[1]], tolerance, at).map(|amount| vec![amount]));
            }
        }
        if free.keeps_sign {
            roots.retain(|root| root[0] * self.none[0] > 0.0);
        }
        roots.truncate(4);
        roots
    }

    /// The two amounts at which two values are the written ones, by Newton's method from several starts.
    fn points(&self, data: [usize; 2]) -> Vec<Vec<f64>> {
        let range = self.template.free[0].range;
        let starts = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [-0.5, 0.0], [0.0, -0.5]];
        let mut found: Vec<Vec<f64>> = Vec::new();
        for start in starts {
            let mut amounts = vec![self.none[0] + range * start[0], self.none[1] + range * start[1]];
            let apart = |amounts: &[f64]| {
                let predicted = self.predicted(amounts);
                data.map(|datum| self.apart(datum, predicted[datum]))
            };
            let tolerance = data.map(|datum| 0.1 * self.scorer.data[datum].rounding);
            for _ in 0..12 {
                let [f, g] = apart(&amounts);
                if f.abs() <= tolerance[0] && g.abs() <= tolerance[1] {
                    let is_new =
                        |other: &Vec<f64>| libm::hypot(other[0] - amounts[0], other[1] - amounts[1]) > 1e-3 * range;
                    if found.iter().all(is_new) {
                        found.push(amounts);
                    }
                    break;
                }
                let step = 1e-4 * range;
                let [fx, gx] = apart(&[amounts[0] + step, amounts[1]]);
                let [fy, gy] = apart(&[amounts[0], amounts[1] + step]);
                let [a, b, c, d] = [(fx - f) / step, (fy - f) / step, (gx - g) / step, (gy - g) / step];
                let determinant = a * d - b * c;
                let by = [(b * g - d * f) / determinant, (c * f - a * g) / determinant];
                let length = libm::hypot(by[0], by[1]);
                if !length.is_finite() {
                    break;
                }
                let shorter = (range / length).min(1.0);
                amounts[0] += by[0] * shorter;
                amounts[1] += by[1] * shorter;
            }
        }
        found
    }
}

/// The root of a function between two places at which its signs differ, by false position with halved ends (Illinois
/// method; Dowell and Jarratt 1971). `None` at a pole.
fn root([mut a, mut b]: [f64; 2], [mut f, mut g]: [f64; 2], tolerance: f64, at: impl Fn(f64) -> f64) -> Option<f64> {
    let largest = f.abs().max(g.abs());
    for _ in 0..ITERATIONS {
        let c = (a * g - b * f) / (g - f);
        let h = at(c);
        if !h.is_finite() || h.abs() > 4.0 * largest {
            return None;
        }
        if h.abs() <= tolerance {
            return Some(c);
        }
        if h * g < 0.0 {
            (a, f) = (b, g);
        } else {
            f *= 0.5;
        }
        (b, g) = (c, h);
    }
    None
}
