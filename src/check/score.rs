//! How well written values fit a construction with mistakes.
//!
//! Honest errors of the hand make the values correlated: to first order they are normally distributed with the
//! covariance C = Σ s_g² J_g J_gᵀ. J_g are the difference quotients of the values by each error of kind g, times its
//! standard deviation; s_g is the size of the hand's errors of that kind in parts of the tolerance. The values are
//! compared in the order of the construction, each with its distribution given the earlier ones (Cholesky factorisation
//! row by row). A value that no error explains is left out of what later ones are compared with. Costs are −2 ln of
//! likelihoods, for each value relative to the density of its rounding.

use super::covariance::{Covariances, Datum, Groups, Hand, read};
use super::entry::Entry;
use super::measured::AnswerKey;
use super::mistakes::{Candidate, Free};
use super::model::{Changes, LEANING, Model, TOGETHER, in_order};
use super::own_rates::{from_given_numbers, from_own_rates};
use crate::construction::{Change, Tolerance};
use crate::sheet::QuantityKind;
use std::borrow::Cow;
use std::sync::OnceLock;

/// The values, and the constructions with which they are compared.
pub(super) struct Scorer<'a> {
    /// The right position first, then other assembly modes.
    pub models: &'a [Model],
    pub data: Vec<Datum>,
    /// By datum: its cost if nothing explains it.
    pub without: Vec<Without>,
    pub tolerance: Tolerance,
    /// The covariances of a right drawing.
    nominal: Covariances,
    pub entries: &'a [Entry],
    /// By entry: whether the numbers that the scene gives are enough for it.
    pub given: Vec<bool>,
}

impl<'a> Scorer<'a> {
    /// `groups`: the covariances of a right drawing that the errors of hands cause, from an earlier form of the same
    /// models; they are put there if there are none yet.
    pub fn new(
        models: &'a [Model],
        entries: &'a [Entry],
        key: &AnswerKey<'_>,
        groups: &OnceLock<Groups>,
    ) -> Scorer<'a> {
        let model = &models[0];
        let largest = |kind: QuantityKind, of: fn(&Entry) -> f64| {
            let same = entries.iter().filter(|e| e.asked.kind() == kind);
            same.map(|e| of(e).abs()).fold(0.0, f64::max)
        };
        let data = entries.iter().enumerate().filter_map(|(index, entry)| {
            let reading = model.readings[index].ok()?;
            let kind = entry.asked.kind();
            let span = match kind {
                QuantityKind::Angle => 180.0,
                // A value a thousand times too large must not make all others imprecise.
                _ => {
                    let expected = largest(kind, |e| e.expected);
                    largest(kind, |e| e.value).max(expected).min(4.0 * expected.max(f64::MIN_POSITIVE))
                }
            };
            let rounding = entry.rounding.max(1e-7 * span);
            Some(Datum {
                entry: index,
                value: entry.value,
                rounding,
                is_magnitude: entry.is_magnitude || reading.is_size(),
                kind,
                is_line: entry.asked.is_line(),
                span,
            })
        });
        let data: Vec<Datum> = data.collect();
        let count = data.len();
        let all = [(Changes::new(), (0..count).collect())];
        let (own, given) = (from_own_rates(model, entries, key.solution), from_given_numbers(entries, key.solution));
        let tolerance = key.tolerance;
        let nominal = Covariances::new(model, &tolerance, &data, &all, &[], groups.get());
        groups.get_or_init(|| nominal.groups.clone());
        let without = data.iter().map(|datum| Without::of(datum, own[datum.entry])).collect();
        Scorer { models, without, tolerance, nominal, entries, data, given }
    }

    pub fn model(&self, set: &[&Candidate]) -> &'a Model {
        let mode = set.iter().map(|c| c.mode).max().unwrap_or(0);
        &self.models[mode]
    }

    /// The changes that the candidates make. `without`: the candidate whose wrong numbers are not passed on, for the
    /// replay from which its own values are read.
    pub fn changes(&self, set: &[&Candidate], without: Option<usize>) -> Changes {
        in_order(set.iter().enumerate().flat_map(|(index, candidate)| {
            let passed_on = if without == Some(index) { &[] } else { candidate.passed_on.as_slice() };
            candidate.edits.iter().chain(passed_on)
        }))
    }

    /// The candidate that passes a datum's written value on to later operations.
    fn owner(&self, set: &[&Candidate], datum: usize) -> Option<usize> {
        let entry = self.data[datum].entry;
        set.iter().position(|c| !c.passed_on.is_empty() && c.reinterpreted.iter().any(|s| s.entry == entry))
    }

    /// The replays that a set of candidates needs: the changes of each, and the data read from it.
    pub fn variants(&self, set: &[&Candidate]) -> Vec<(Changes, Vec<usize>)> {
        let all = 0..self.data.len();
        if set.iter().all(|c| c.passed_on.is_empty()) {
            return vec![(self.changes(set, None), all.collect())];
        }
        let owners: Vec<Option<usize>> = all.clone().map(|d| self.owner(set, d)).collect();
        let mut variants = Vec::new();
        for owner in core::iter::once(None).chain((0..set.len()).map(Some)) {
            let owned: Vec<usize> = all.clone().filter(|&d| owners[d] == owner).collect();
            if !owned.is_empty() {
                variants.push((self.changes(set, owner), owned));
            }
        }
        variants
    }

    /// By datum: the value that a drawing with the candidates' mistakes should have.
    pub fn predicted(&self, set: &[&Candidate]) -> Vec<f64> {
        self.read_from(set, &self.variants(set))
    }

    /// The data read from these replays.
    pub fn read_from(&self, set: &[&Candidate], variants: &[(Changes, Vec<usize>)]) -> Vec<f64> {
        let model = self.model(set);
        let mut predicted = vec![f64::NAN; self.data.len()];
        for (changes, data) in variants {
            let values = model.replay(changes);
            read(model, &values, &self.data, data, &mut predicted);
        }
        predicted
    }

    /// Whether there is friction that a hand may find in its drawing.
    pub fn rubs(&self) -> bool {
        !self.nominal.groups[LEANING].is_empty()
    }

    /// The covariances of the values of drawings with the candidates' mistakes.
    pub fn covariances(&self, set: &[&Candidate]) -> Cow<'_, Covariances> {
        if set.is_empty() {
            return Cow::Borrowed(&self.nominal);
        }
        let (variants, free) = (self.variants(set), Scorer::free(set));
        Cow::Owned(Covariances::new(self.model(set), &self.tolerance, &self.data, &variants, &free, None))
    }

    /// By datum: the value meant if the candidates' mistakes were made.
    pub fn meant(&self, set: &[&Candidate]) -> Vec<Datum> {
        let mut meant = self.data.clone();
        for reinterpreted in set.iter().flat_map(|c| &c.reinterpreted) {
            if let Some(datum) = meant.iter_mut().find(|datum| datum.entry == reinterpreted.entry) {
                // As much coarser than it is written as the datum itself.
                let coarser = datum.rounding / self.entries[datum.entry].rounding;
                let coarser = if coarser.is_finite() { coarser.max(1.0) } else { 1.0 };
                datum.value = reinterpreted.value;
                datum.rounding = (reinterpreted.rounding * coarser).max(f64::MIN_POSITIVE);
            }
        }
        meant
    }

    /// The variances of a value in a right drawing by kind of errors, at the tolerance.
    fn variances(&self, datum: usize) -> impl Iterator<Item = f64> {
        let diagonal = datum * (self.data.len() + 1);
        self.nominal.groups.iter().map(move |group| group.get(diagonal).copied().unwrap_or_default())
    }

    /// The variance of a value in a right drawing by hand with errors at the tolerance.
    pub fn variance(&self, datum: usize) -> f64 {
        let is_by_hand = |(kind, variance): (usize, f64)| (kind < TOGETHER || kind == LEANING).then_some(variance);
        self.variances(datum).enumerate().filter_map(is_by_hand).sum()
    }

    /// The standard deviation of a value in a right drawing by a hand, its rounding left out.
    pub fn spread(&self, datum: usize, hand: &Hand) -> f64 {
        let parts = self.variances(datum).zip(hand.errors).map(|(variance, size)| size * size * variance);
        parts.sum::<f64>().sqrt()
    }

    /// The written value behind a datum.
    pub fn entry(&self, datum: usize) -> &'a Entry {
        &self.entries[self.data[datum].entry]
    }

    /// The data that a candidate changes when it is the only mistake; one of unknown amount may change any.
    pub fn changed(&self, candidate: &Candidate, right: &[f64]) -> Vec<usize> {
        let all = 0..self.data.len();
        if !candidate.free.is_empty() {
            return all.collect();
        }
        let predicted = self.predicted(&[candidate]);
        let is_changed = |&index: &usize| {
            let datum = &self.data[index];
            // What is not finite changes everything.
            let is_same = (predicted[index] - right[index]).abs() <= 1e-9 * datum.span;
            !is_same || candidate.reinterpreted.iter().any(|r| r.entry == datum.entry)
        };
        all.filter(is_changed).collect()
    }

    /// How well values fit a prediction at a first look, by the likeliest of these metrics, which are of a drawing that predicts `before`.
    pub fn look(&self, metrics: &[Metric], before: &[f64], meant: &[Datum], predicted: &[f64]) -> f64 {
        if predicted.iter().any(|p| !p.is_finite()) {
            return f64::INFINITY;
        }
        let compared = Compared { meant, predicted, without: &self.without };
        // Errors are assumed to grow in proportion to the value, and to turn round with its sign.
        let grown = |index: usize| {
            let small = 0.05 * self.data[index].span;
            let grown = (predicted[index].abs() + small) / (before[index].abs() + small);
            let is_turned = self.data[index].kind != QuantityKind::Angle && predicted[index] * before[index] < 0.0;
            grown.clamp(1.0, 1000.0) * if is_turned { -1.0 } else { 1.0 }
        };
        let mut deviations = Vec::with_capacity(predicted.len());
        let costs = metrics.iter().map(|metric| metric.look(compared, grown, &mut deviations));
        costs.fold(f64::INFINITY, f64::min)
    }

    /// The amounts of a set's edits that were fitted to the values.
    pub fn free(set: &[&Candidate]) -> Vec<(Free, f64)> {
        let fitted = set.iter().flat_map(|candidate| candidate.free.iter().zip(&candidate.edits));
        let amounts = fitted.filter_map(|(free, edit)| match edit.change {
            Change::Error(_, amount) | Change::Written(_, amount) => Some((*free, amount)),
            _ => None,
        });
        amounts.collect()
    }
}

/// A sum of costs, −2 ln of likelihoods: of a normal deviate its square over its variance, plus the logarithm of the
/// variance.
#[derive(Clone, Copy, Debug)]
struct Cost {
    sum: f64,
    /// The product of variances whose logarithm is not in the sum yet: one logarithm of many is the quickest.
    product: f64,
}

impl Cost {
    pub const ZERO: Cost = Cost { sum: 0.0, product: 1.0 };

    /// Adds the cost of a deviate, or that of an unexplained value where it is less; whether it is the deviate's.
    /// `square` is in variances of the deviate, `variance` in variances of the value's rounding.
    pub fn add_deviate(&mut self, square: f64, variance: f64, without: &Without) -> bool {
        let is_near = square <= UNEXPLAINED && variance <= without.widest;
        if !is_near && square + libm::log(variance) > without.cost {
            self.sum += without.cost;
            return false;
        }
        self.sum += square;
        self.product *= variance;
        if !(1e-200..1e200).contains(&self.product) {
            self.sum += libm::log(self.product);
            self.product = 1.0;
        }
        true
    }

    pub fn total(self) -> f64 {
        self.sum + libm::log(self.product)
    }
}

/// The cost of an unexplained value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Without {
    pub cost: f64,
    /// The square of the range in which the value could lie, over the variance of its rounding.
    widest: f64,
    /// Whether it follows from other values of the sheet.
    is_own: bool,
}

/// Cost of a value that follows from others of the sheet, where the drawing gives another one: one of twenty is computed.
const COMPUTED: f64 = 6.0;

/// Cost of an unexplained value beyond that of the range in which it could lie: one value of some hundred is so.
const UNEXPLAINED: f64 = 11.0;

impl Without {
    /// The cost of a value if nothing explains it.
    pub fn of(datum: &Datum, own: Option<f64>) -> Without {
        let of_width = |width: f64| 2.0 * libm::log(width) - libm::log(datum.variance());
        let range = of_width(datum.span);
        let cost = own.map_or(range + UNEXPLAINED, |within| COMPUTED + of_width(within));
        Without { cost, widest: libm::exp(range), is_own: own.is_some() }
    }
}

/// What a walk compares: the values meant, and those that a construction predicts.
#[derive(Clone, Copy)]
pub(super) struct Compared<'a> {
    /// By datum: the value meant.
    pub meant: &'a [Datum],
    pub predicted: &'a [f64],
    /// By datum: its cost if nothing explains it.
    pub without: &'a [Without],
}

/// A walk through the values. A value that no error explains is left out of what later ones are compared with.
pub(super) struct Walk {
    /// The covariance of the values; behind the walk, that of later values given the earlier ones.
    matrix: Vec<f64>,
    /// By value: the part of its rounding's variance that stays with it.
    own: Vec<f64>,
    /// By value: its expected error given the earlier values.
    means: Vec<f64>,
    /// By value: whether it is unexplained.
    pub outside: Vec<bool>,
    /// By value: by how much it is off what is predicted.
    pub off: Vec<f64>,
    /// By value: its variance given the earlier ones.
    pub given: Vec<f64>,
}

impl Walk {
    pub fn new(count: usize) -> Walk {
        Walk {
            matrix: vec![0.0; count * count],
            own: vec![1.0; count],
            means: vec![0.0; count],
            outside: vec![false; count],
            off: vec![0.0; count],
            given: vec![0.0; count],
        }
    }

    /// The cost of all values for a hand.
    pub fn run(&mut self, covariances: &Covariances, hand: &Hand, compared: Compared<'_>) -> f64 {
        covariances.sum(hand, &mut self.matrix, &mut self.own);
        let count = compared.meant.len();
        self.means.fill(0.0);
        self.outside.fill(false);
        let mut cost = Cost::ZERO;
        for (index, datum) in compared.meant.iter().enumerate() {
            let rounding = datum.variance();
            let variance = remaining(self.matrix[index * count + index], self.own[index] * rounding);
            let off = datum.off(compared.predicted[index], self.means[index]) - self.means[index];
            self.off[index] = off + self.means[index];
            self.given[index] = variance;
            if !cost.add_deviate(off * off / variance, variance / rounding, &compared.without[index]) {
                self.outside[index] = !compared.without[index].is_own;
                continue;
            }
            // The later values given this one.
            eliminate(&mut self.matrix, index, count, variance, |other, part| self.means[other] += part * off);
        }
        cost.total()
    }
}

/// The variance of a value given earlier ones. Roundings are independent of each other, so at least a quarter of the own
/// rounding's variance always remains.
fn remaining(others: f64, own: f64) -> f64 {
    (others + own).max(0.25 * own)
}

/// Gaussian elimination of a row of a covariance of `count` values: behind it, the covariance of later values given this one.
/// Tells of each of them which part of this value's deviation it is expected to have, unless none.
fn eliminate(matrix: &mut [f64], index: usize, count: usize, variance: f64, mut expect: impl FnMut(usize, f64)) {
    let (passed, later) = matrix.split_at_mut((index + 1) * count);
    let row = &passed[index * count..];
    for (other, below) in (index + 1..count).zip(later.chunks_exact_mut(count)) {
        let part = row[other] / variance;
        if part != 0.0 {
            expect(other, part);
            for (entry, pivot) in below[other..].iter_mut().zip(&row[other..]) {
                *entry -= part * pivot;
            }
        }
    }
}

/// The factors of a covariance, for quick comparisons of many predictions with the same values. An unexplained value is
/// taken to be what the earlier ones let expect.
pub(super) struct Metric {
    /// By row: the parts of earlier values' deviations that a value is expected to have.
    lower: Vec<f64>,
    /// By value: its variance given the earlier ones.
    variances: Vec<f64>,
    /// By value: that variance without its own rounding's.
    drawn: Vec<f64>,
}

impl Metric {
    pub fn new(covariances: &Covariances, hand: &Hand, data: &[Datum]) -> Metric {
        let count = data.len();
        let mut metric = Metric { lower: vec![0.0; count * count], variances: Vec::new(), drawn: Vec::new() };
        let (mut matrix, mut own) = (vec![0.0; count * count], vec![1.0; count]);
        covariances.sum(hand, &mut matrix, &mut own);
        for (index, datum) in data.iter().enumerate() {
            let own = own[index] * datum.variance();
            let drawn = matrix[index * count + index].max(0.0);
            let variance = remaining(drawn, own);
            metric.variances.push(variance);
            metric.drawn.push(variance - own.min(variance));
            eliminate(&mut matrix, index, count, variance, |other, part| metric.lower[other * count + index] = part);
        }
        metric
    }

    /// The cost of the values at a first look. `grown`: how many times as large as usual a value's errors are, negative where their signs are
    /// the other way round.
    pub fn look(&self, compared: Compared<'_>, grown: impl Fn(usize) -> f64, deviations: &mut Vec<f64>) -> f64 {
        let count = compared.meant.len();
        let mut cost = Cost::ZERO;
        deviations.clear();
        for (index, datum) in compared.meant.iter().enumerate() {
            let row = &self.lower[index * count..index * count + index];
            let mean: f64 = row.iter().zip(deviations.iter()).map(|(part, deviation)| part * deviation).sum();
            let grown = grown(index);
            let sign = grown.signum();
            let off = sign * datum.off(compared.predicted[index], sign * mean) - mean;
            let variance = self.variances[index] + (grown * grown - 1.0) * self.drawn[index];
            let without = &compared.without[index];
            let is_inside = cost.add_deviate(off * off / variance, variance / datum.variance(), without);
            deviations.push(if is_inside { off } else { 0.0 });
        }
        cost.total()
    }
}
