//! The complete comparison of values with a construction: with the covariance that honest errors give them.

use super::covariance::{Covariances, Habit, Hand};
use super::datum::{Cost, Datum};
use super::mistakes::Candidate;
use super::model::{GROUPS, TOGETHER};
use super::score::Scorer;

/// Sizes of a hand's errors that are tried, in parts of the tolerance: from the pencil to a drawing program.
const HANDS: [f64; 9] = [1.0, 0.5, 0.2, 0.05, 0.01, 2e-3, 4e-4, 8e-5, 1e-5];

/// The kind of errors of the velocity plan.
const VELOCITY: usize = 2;

/// Difference in −2 ln of the likelihood below which two explanations fit equally well: a factor of two.
const SAME_FIT: f64 = 1.4;

/// Cost of a hand whose errors of one kind are ten times smaller than the tolerance.
const BETTER_HAND: f64 = 1.2;

/// How well values fit.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    /// The cost of the values, without that of the mistakes.
    pub cost: f64,
    /// By datum: the value that a drawing with the mistakes should have.
    pub predicted: Vec<f64>,
    /// By datum: whether the value remains unexplained.
    pub outside: Vec<bool>,
    /// The hand for which the values are likeliest.
    pub hand: Hand,
}

/// The best hand found so far for a set of mistakes.
pub(super) struct Hands<'a, 's> {
    scorer: &'a Scorer<'s>,
    covariances: Covariances,
    meant: Vec<Option<Datum>>,
    predicted: Vec<f64>,
    walk: Walk,
    /// The cost of the best hand.
    pub cost: f64,
    outside: Vec<bool>,
    hand: Hand,
    /// The best hand of equal errors of all kinds, as an index of [`HANDS`].
    level: usize,
}

impl Hands<'_, '_> {
    /// Tries a hand; whether it is the best so far.
    fn consider(&mut self, hand: Hand) -> bool {
        self.walk.begin(&self.covariances, &hand);
        let cost = self.walk.run(self.scorer, &self.meant, &self.predicted, None);
        // A kind of errors of size zero is left out: it is not a better hand.
        let sizes = hand.errors.iter().filter(|s| **s > 0.0);
        let cost = cost.total() - sizes.map(|s| BETTER_HAND * libm::log10(*s)).sum::<f64>();
        let is_better = cost < self.cost;
        if is_better {
            self.cost = cost;
            self.outside.clone_from(&self.walk.outside);
            self.hand = hand;
        }
        is_better
    }

    /// Tries the other habits for the best hand so far.
    fn consider_habits(&mut self) {
        let hand = self.hand;
        for habit in [Habit::Mixed, Habit::AsWritten, Habit::AllDigits] {
            if habit != hand.habit {
                self.consider(Hand { habit, ..hand });
            }
        }
    }

    /// Searches for the best hand whose errors of all kinds are of equal size.
    fn search_alike(&mut self) {
        for (index, &size) in HANDS.iter().enumerate() {
            let mut hand = Hand { errors: [size; GROUPS], habit: Habit::Mixed };
            hand.errors[TOGETHER] = 0.0;
            if self.consider(hand) {
                self.level = index;
            } else if index > self.level + 1 {
                break;
            }
        }
        self.consider_habits();
    }

    /// Goes on searching with a size for each kind of errors; only for drawings more exact than a hand's.
    pub fn search_each(&mut self) {
        if self.level <= 1 {
            return;
        }
        let mut program = Hand { errors: [HANDS[HANDS.len() - 1]; GROUPS], habit: Habit::Mixed };
        program.errors[TOGETHER] = HANDS[self.level];
        program.errors[VELOCITY] = HANDS[self.level];
        self.consider(program);
        for _ in 0..2 {
            self.consider_habits();
            for group in 0..GROUPS {
                let mut hand = self.hand;
                let tried = hand.errors[group];
                for size in HANDS.into_iter().filter(|s| *s != tried) {
                    hand.errors[group] = size;
                    self.consider(hand);
                }
            }
        }
    }
}

impl From<Hands<'_, '_>> for Fit {
    fn from(hands: Hands<'_, '_>) -> Fit {
        Fit { cost: hands.cost, predicted: hands.predicted, outside: hands.outside, hand: hands.hand }
    }
}

impl Scorer<'_> {
    /// The approximate standard deviation of a value drawn by the hand of the fit.
    pub fn deviation(&self, datum: usize, fit: &Fit) -> f64 {
        let hand = fit.hand.worst();
        (hand * hand * self.quick[datum] + self.data[datum].variance()).sqrt()
    }

    /// Whether the values cannot tell two explanations apart: both fit equally well, and each value is about as far
    /// from both predictions.
    pub fn are_alike(&self, a: &Fit, b: &Fit, sets: [&[&Candidate]; 2]) -> bool {
        let [meant_a, meant_b] = sets.map(|set| self.meant(set));
        let hand = a.hand.worst();
        let same = |index: usize| match (&meant_a[index], &meant_b[index]) {
            (Some(m), Some(n)) => {
                let [p, q] = [a.predicted[index], b.predicted[index]];
                let [r, s] = [m.off(p, 0.0) / m.rounding, n.off(q, 0.0) / n.rounding];
                let deviation = hand * self.quick[index].sqrt() / m.rounding.max(n.rounding);
                // Where no sign is written, the explanations may differ in it.
                let same_sense = m.is_magnitude || (p * q > 0.0) == (m.value * n.value > 0.0);
                same_sense && (r - s).abs() <= 0.5 * (1.0 + deviation)
            }
            (None, None) => true,
            _ => false,
        };
        (a.cost - b.cost).abs() <= SAME_FIT && (0..self.data.len()).all(same)
    }

    /// The complete comparison, with the covariances of a drawing with these mistakes, for hands with errors of one
    /// size. `None` where a predicted value is not finite.
    pub fn compare(&self, set: &[&Candidate]) -> Option<Hands<'_, '_>> {
        let predicted = self.predicted(set);
        if predicted.iter().any(|p| !p.is_finite()) {
            return None;
        }
        let mut hands = Hands {
            scorer: self,
            covariances: self.covariances(set),
            meant: self.meant(set),
            predicted,
            walk: Walk::new(self.data.len()),
            cost: f64::INFINITY,
            outside: Vec::new(),
            hand: Hand { errors: [1.0; GROUPS], habit: Habit::Mixed },
            level: 0,
        };
        hands.search_alike();
        Some(hands)
    }

    /// The cost of each slip of writing made beside a set that has been compared already. For drawings so exact that a
    /// first look does not show slips: the covariances stay, but the hand may turn out better at one kind of errors.
    pub fn slips(&self, set: &[&Candidate], fit: &Fit, slips: &[&Candidate]) -> Vec<f64> {
        let covariances = self.covariances(set);
        let meant = self.meant(set);
        let mut costs = vec![f64::INFINITY; slips.len()];
        let mut hands = vec![fit.hand];
        for group in 0..GROUPS {
            for better in [5.0, 25.0, 125.0] {
                let mut hand = fit.hand;
                hand.errors[group] /= better;
                hands.push(hand);
            }
        }
        let mut walk = Walk::new(self.data.len());
        for (index, datum) in self.data.iter().enumerate() {
            let touches = |slip: &Candidate| matches!(slip.reinterpreted.as_slice(), [one] if one.entry == datum.entry);
            let touching: Vec<usize> = (0..slips.len()).filter(|&s| touches(slips[s])).collect();
            if touching.is_empty() {
                continue;
            }
            for hand in &hands {
                walk.begin(&covariances, hand);
                let others = walk.run(self, &meant, &fit.predicted, Some(index));
                for &slip in &touching {
                    let meant = slips[slip].reinterpreted[0].read(datum);
                    let mut cost = others;
                    walk.add(self, &mut cost, index, meant.as_ref(), &fit.predicted);
                    costs[slip] = costs[slip].min(cost.total());
                }
            }
        }
        // Two swapped numbers: compared only where both could be right in each other's place.
        for (slip, cost) in slips.iter().zip(&mut costs) {
            if slip.reinterpreted.len() < 2 {
                continue;
            }
            let all: Vec<&Candidate> = set.iter().copied().chain([*slip]).collect();
            let meant = self.meant(&all);
            let mut both = meant.iter().zip(&fit.predicted).enumerate();
            let could_be = both.all(|(index, (datum, predicted))| {
                let touched = slip.reinterpreted.iter().any(|s| s.entry == self.data[index].entry);
                let near = |d: &Datum| d.off(*predicted, 0.0).abs() <= 4.0 * self.quick[index].sqrt();
                !touched || datum.as_ref().is_none_or(near)
            });
            if !could_be {
                continue;
            }
            for hand in &hands {
                walk.begin(&covariances, hand);
                *cost = cost.min(walk.run(self, &meant, &fit.predicted, None).total());
            }
        }
        costs
    }
}

/// A walk through the values in their order, each compared with its distribution given the earlier ones.
struct Walk {
    /// The covariance of the values; behind the walk, that of later values given the earlier ones.
    matrix: Vec<f64>,
    /// By value: the part of its rounding's variance that stays with it.
    own: Vec<f64>,
    /// By value: its expected error given the earlier values.
    means: Vec<f64>,
    /// By value: whether it is unexplained.
    outside: Vec<bool>,
}

impl Walk {
    fn new(count: usize) -> Walk {
        Walk {
            matrix: vec![0.0; count * count],
            own: vec![1.0; count],
            means: vec![0.0; count],
            outside: vec![false; count],
        }
    }

    /// Prepares a walk for a hand.
    fn begin(&mut self, covariances: &Covariances, hand: &Hand) {
        covariances.sum(hand, &mut self.matrix, &mut self.own);
    }

    /// The cost of all values but `last`, whose mean and variance given all others are left in the walk.
    fn run(&mut self, scorer: &Scorer<'_>, meant: &[Option<Datum>], predicted: &[f64], last: Option<usize>) -> Cost {
        let count = meant.len();
        self.means.fill(0.0);
        self.outside.fill(false);
        let mut cost = Cost::ZERO;
        for index in (0..count).filter(|&i| last != Some(i)) {
            let datum = meant[index].as_ref();
            let Some((variance, off)) = self.add(scorer, &mut cost, index, datum, predicted) else {
                continue;
            };
            // The later values given this one: Gaussian elimination of its row.
            let (passed, later) = self.matrix.split_at_mut((index + 1) * count);
            let (passed, row) = passed.split_at_mut(index * count);
            for (other, below) in (index + 1..count).zip(later.chunks_exact_mut(count)) {
                let part = row[other] / variance;
                self.means[other] += part * off;
                eliminate(&mut below[other..], part, &row[other..]);
            }
            if let Some(last) = last.filter(|&l| l < index) {
                let kept = &mut passed[last * count..(last + 1) * count];
                let part = kept[index] / variance;
                self.means[last] += part * off;
                kept[last] -= part * kept[index];
                eliminate(&mut kept[index + 1..], part, &row[index + 1..]);
            }
        }
        cost
    }

    /// Adds the cost of a value; returns its variance and the difference from its mean, or `None` where it is
    /// unexplained.
    fn add(
        &mut self,
        scorer: &Scorer<'_>,
        cost: &mut Cost,
        index: usize,
        datum: Option<&Datum>,
        predicted: &[f64],
    ) -> Option<(f64, f64)> {
        let without = &scorer.without[index];
        let Some(datum) = datum else {
            cost.add(without.cost);
            return None;
        };
        let rounding = datum.variance();
        // Roundings are independent of each other, so at least a quarter of the own rounding's variance always remains.
        let others = self.matrix[index * self.means.len() + index];
        let own = self.own[index] * rounding;
        let variance = (others + own).max(0.25 * own);
        let off = datum.off(predicted[index], self.means[index]) - self.means[index];
        let is_inside = cost.add_deviate(off * off / variance, variance / rounding, without);
        self.outside[index] = !is_inside;
        is_inside.then_some((variance, off))
    }
}

/// Subtracts `part` times a row.
fn eliminate(entries: &mut [f64], part: f64, row: &[f64]) {
    for (entry, pivot) in entries.iter_mut().zip(row) {
        *entry -= part * pivot;
    }
}
