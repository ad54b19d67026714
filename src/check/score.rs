//! How well written values fit a construction with mistakes.
//!
//! Honest errors of the hand make the values correlated: to first order they are normally distributed with the
//! covariance C = Σ s_g² J_g J_gᵀ. J_g are the difference quotients of the values by each error of kind g, times its
//! standard deviation; s_g is the size of the hand's errors of that kind in parts of the tolerance. The values are
//! compared in the order of the construction, each with its distribution given the earlier ones (Cholesky factorisation
//! row by row). A value that no error explains is left out of what later ones are compared with. Costs are −2 ln of
//! likelihoods, for each value relative to the density of its rounding.

use super::covariance::{Covariances, Groups, read};
use super::datum::{Datum, Without};
use super::entry::Entry;
use super::hand::Hand;
use super::mistakes::{Candidate, Free};
use super::model::{Changes, Edit, GROUPS, Model, TOGETHER};
use super::walk::{Compared, Metric};
use crate::construction::{Change, Disturbance, Tolerance};
use crate::quantity::{QuantityKind, Sense};
use crate::sheet::Sheet;
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
    /// By datum: its variance in a right drawing with errors at the tolerance.
    pub quick: Vec<f64>,
    /// The same by kind of errors.
    kinds: [Vec<f64>; GROUPS],
    /// The covariances of a right drawing.
    nominal: Covariances,
    /// By datum: its value in a right drawing.
    right: Vec<f64>,
    entries: &'a [Entry],
}

impl<'a> Scorer<'a> {
    /// `groups`: the covariances of a right drawing that the errors of hands cause, from an earlier form of the same
    /// models; they are put there if there are none yet.
    pub fn new(
        models: &'a [Model],
        entries: &'a [Entry],
        tolerance: Tolerance,
        groups: &OnceLock<Groups>,
    ) -> Scorer<'a> {
        let model = &models[0];
        let span = |kind: QuantityKind| {
            let same = entries.iter().filter(|e| e.asked.kind() == kind);
            let both = same.flat_map(|e| [e.value.abs(), e.expected.abs()]);
            both.fold(0.0, f64::max)
        };
        let expected_span = |kind: QuantityKind| {
            let same = entries.iter().filter(|e| e.asked.kind() == kind);
            same.map(|e| e.expected.abs()).fold(0.0, f64::max)
        };
        let data = entries.iter().enumerate().filter_map(|(index, entry)| {
            let reading = model.readings[index].ok()?;
            let kind = entry.asked.kind();
            let span = match kind {
                QuantityKind::Angle => 180.0,
                // A value a thousand times too large must not make all others imprecise.
                _ => span(kind).min(4.0 * expected_span(kind).max(f64::MIN_POSITIVE)),
            };
            let rounding = entry.rounding.max(1e-7 * span);
            Some(Datum {
                entry: index,
                value: entry.value,
                rounding,
                is_magnitude: entry.is_magnitude || reading.is_size(),
                is_angle: reading.sense == Sense::Angle,
                sheet: match kind {
                    QuantityKind::Velocity => Some(Sheet::Velocity),
                    QuantityKind::Acceleration => Some(Sheet::Acceleration),
                    _ => None,
                },
                span,
            })
        });
        let data: Vec<Datum> = data.collect();
        let count = data.len();
        let all = [(Changes::new(), (0..count).collect())];
        let nominal = Covariances::new(model, &tolerance, &data, &all, &[], groups.get());
        groups.get_or_init(|| nominal.groups.clone());
        let by_hand = &nominal.groups[..TOGETHER];
        let mut right = vec![f64::NAN; count];
        read(model, &model.exact, &data, &all[0].1, &mut right);
        Scorer {
            models,
            without: data.iter().map(Datum::without).collect(),
            tolerance,
            quick: (0..count).map(|i| by_hand.iter().map(|g| g[i * count + i]).sum()).collect(),
            kinds: core::array::from_fn(|kind| (0..count).map(|i| nominal.groups[kind][i * count + i]).collect()),
            nominal,
            right,
            entries,
            data,
        }
    }

    pub fn model(&self, set: &[&Candidate]) -> &'a Model {
        let mode = set.iter().map(|c| c.mode).max().unwrap_or(0);
        &self.models[mode]
    }

    /// The changes that the candidates make. `without`: the candidate whose wrong numbers are not passed on, for the
    /// replay from which its own values are read.
    pub fn changes<'c>(&self, set: &[&'c Candidate], without: Option<usize>) -> Changes<'c> {
        let mut changes = Changes::new();
        for (index, candidate) in set.iter().enumerate() {
            for (operation, edit) in &candidate.edits {
                let change = edit.change();
                changes.push(Disturbance { operation: *operation, change });
            }
            if without == Some(index) {
                continue;
            }
            for &(operation, number, value) in &candidate.goes_on {
                let change = Change::Written(number, value);
                changes.push(Disturbance { operation, change });
            }
        }
        changes.sort_by_key(|c| c.operation);
        changes
    }

    /// The candidate that passes a datum's written value on to later operations.
    fn owner(&self, set: &[&Candidate], datum: usize) -> Option<usize> {
        let entry = self.data[datum].entry;
        set.iter().position(|c| !c.goes_on.is_empty() && c.reinterpreted.iter().any(|s| s.entry == entry))
    }

    /// The replays that a set of candidates needs: the changes of each, and the data read from it.
    pub fn variants<'c>(&self, set: &[&'c Candidate]) -> Vec<(Changes<'c>, Vec<usize>)> {
        let all = 0..self.data.len();
        if set.iter().all(|c| c.goes_on.is_empty()) {
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
        let model = self.model(set);
        let mut predicted = vec![f64::NAN; self.data.len()];
        for (changes, data) in self.variants(set) {
            let values = model.replay(&changes);
            read(model, &values, &self.data, &data, &mut predicted);
        }
        predicted
    }

    /// The covariances of the values of drawings with the candidates' mistakes.
    pub fn covariances(&self, set: &[&Candidate]) -> Cow<'_, Covariances> {
        if set.is_empty() {
            return Cow::Borrowed(&self.nominal);
        }
        let (variants, free) = (self.variants(set), Scorer::free(set));
        Cow::Owned(Covariances::new(self.model(set), &self.tolerance, &self.data, &variants, &free, None))
    }

    /// By datum: the value meant if the candidates' mistakes were made; `None` where the written value tells nothing
    /// about it.
    pub fn meant(&self, set: &[&Candidate]) -> Vec<Option<Datum>> {
        let mut meant: Vec<Option<Datum>> = self.data.iter().copied().map(Some).collect();
        for reinterpreted in set.iter().flat_map(|c| &c.reinterpreted) {
            let found = self.data.iter().position(|d| d.entry == reinterpreted.entry);
            if let Some(datum) = found {
                meant[datum] = reinterpreted.read(&self.data[datum]);
            }
        }
        meant
    }

    /// The standard deviation of a value in a right drawing by a hand, its rounding left out.
    pub fn spread(&self, datum: usize, hand: &Hand) -> f64 {
        let parts = self.kinds.iter().zip(hand.errors).map(|(kind, size)| size * size * kind[datum]);
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

    /// How well values fit a prediction at a first look, by the likeliest of these metrics.
    pub fn look(&self, metrics: &[Metric], meant: &[Option<Datum>], predicted: &[f64]) -> f64 {
        if predicted.iter().any(|p| !p.is_finite()) {
            return f64::INFINITY;
        }
        let compared = Compared { meant, predicted, without: &self.without };
        // Errors are assumed to grow in proportion to the value.
        let grown = |index: usize| {
            let small = 0.05 * self.data[index].span;
            let grown = (predicted[index].abs() + small) / (self.right[index].abs() + small);
            grown.clamp(1.0, 1000.0)
        };
        let mut deviations = Vec::with_capacity(predicted.len());
        let costs = metrics.iter().map(|metric| metric.look(compared, grown, &mut deviations));
        costs.fold(f64::INFINITY, f64::min)
    }

    /// The amounts of a set's edits that were fitted to the values.
    fn free(set: &[&Candidate]) -> Vec<(Free, f64)> {
        let of = |candidate: &Candidate| -> Vec<(Free, f64)> {
            let edits = candidate.edits.iter().rev().zip(candidate.free.iter().rev());
            let amounts = edits.filter_map(|((_, edit), free)| match edit {
                Edit::Error(_, amount) | Edit::Becomes(_, amount) => Some((*free, *amount)),
                _ => None,
            });
            amounts.collect()
        };
        set.iter().flat_map(|candidate| of(candidate)).collect()
    }
}
