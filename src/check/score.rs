//! How well written values fit a construction with mistakes put in.
//!
//! Honest errors of the hand, of all acts, carry the values together: to first order they are normally distributed with the covariance
//! C = Σ s_g² J_g J_gᵀ, J the difference quotients of the values by each error times its standard deviation, s_g ≤ 1 how good the hand is at each
//! kind of act. The values are gone through in the order of the construction, each held against what the earlier ones let expect (Cholesky's
//! factorisation row by row). One that no error explains stands outside and says nothing about those that follow. Costs
//! are −2 ln of likelihoods, each value's counted from the density of its rounding.

use super::covariance::{Covariances, read};
use super::datum::{Cost, Datum, Without};
use super::entry::Entry;
use super::mistakes::Candidate;
use super::model::{Changes, Model, TOGETHER};
use crate::construction::{Change, Disturbance, Sheet, Tolerance};
use crate::quantity::{Kind, Sense};

/// What is held against each other.
pub(super) struct Scorer<'a> {
    /// The right position first, then other assembly modes.
    pub models: &'a [Model],
    pub data: Vec<Datum>,
    /// What each value costs that nothing explains.
    pub without: Vec<Without>,
    pub tolerance: Tolerance,
    /// Variances of the values of a right drawing at the tolerance, for a first look.
    pub quick: Vec<f64>,
    /// The values of a right drawing.
    right: Vec<f64>,
}

impl<'a> Scorer<'a> {
    pub fn new(models: &'a [Model], entries: &[Entry], tolerance: Tolerance) -> Scorer<'a> {
        let model = &models[0];
        let span = |kind: Kind| {
            let same = entries.iter().filter(|e| e.asked.kind() == kind);
            let both = same.flat_map(|e| [e.value.abs(), e.expected.abs()]);
            both.fold(0.0, f64::max)
        };
        let expected_span = |kind: Kind| {
            let same = entries.iter().filter(|e| e.asked.kind() == kind);
            same.map(|e| e.expected.abs()).fold(0.0, f64::max)
        };
        let data = entries.iter().enumerate().filter_map(|(index, entry)| {
            let reading = model.readings[index].ok()?;
            let kind = entry.asked.kind();
            let span = match kind {
                Kind::Angle => 180.0,
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
                    Kind::Velocity => Some(Sheet::Velocity),
                    Kind::Acceleration => Some(Sheet::Acceleration),
                    _ => None,
                },
                range: 2.0 * libm::log(span),
            })
        });
        let mut scorer = Scorer {
            models,
            data: data.collect(),
            without: Vec::new(),
            tolerance,
            quick: Vec::new(),
            right: Vec::new(),
        };
        scorer.without = scorer.data.iter().map(Datum::without).collect();
        let nominal = scorer.covariances(&[]);
        let count = scorer.data.len();
        let own = &nominal.groups[..TOGETHER];
        let diagonal = (0..count).map(|i| own.iter().map(|g| g[i * count + i]).sum());
        scorer.quick = diagonal.collect();
        scorer.right = scorer.predicted(&[]);
        scorer
    }

    pub fn model(&self, set: &[&Candidate]) -> &'a Model {
        let mode = set.iter().map(|c| c.mode).max().unwrap_or(0);
        &self.models[mode]
    }

    /// What the candidates change; without what one of them goes on with, where its own values are asked for.
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

    /// Which candidate goes on with a written value of a datum.
    fn owner(&self, set: &[&Candidate], datum: usize) -> Option<usize> {
        let entry = self.data[datum].entry;
        set.iter().position(|c| !c.goes_on.is_empty() && c.reinterpreted.iter().any(|s| s.entry == entry))
    }

    /// The replays that a set needs: the changes, and the data that are read there.
    pub fn variants<'c>(&self, set: &[&'c Candidate]) -> Vec<(Changes<'c>, Vec<usize>)> {
        let all = 0..self.data.len();
        if set.iter().all(|c| c.goes_on.is_empty()) {
            return vec![(self.changes(set, None), all.collect())];
        }
        let owners: Vec<Option<usize>> = all.clone().map(|d| self.owner(set, d)).collect();
        let mut variants = Vec::new();
        for owner in core::iter::once(None).chain((0..set.len()).map(Some)) {
            let own: Vec<usize> = all.clone().filter(|&d| owners[d] == owner).collect();
            if !own.is_empty() {
                variants.push((self.changes(set, owner), own));
            }
        }
        variants
    }

    /// What the values should be with the candidates' mistakes made.
    pub fn predicted(&self, set: &[&Candidate]) -> Vec<f64> {
        let model = self.model(set);
        let mut predicted = vec![f64::NAN; self.data.len()];
        for (changes, data) in self.variants(set) {
            let values = model.replay(&changes);
            read(model, &values, &self.data, &data, &mut predicted);
        }
        predicted
    }

    /// How far honest errors carry the values of drawings with these mistakes, together.
    pub fn covariances(&self, set: &[&Candidate]) -> Covariances {
        Covariances::new(self.model(set), &self.tolerance, &self.data, &self.variants(set))
    }

    /// The values as the candidates read them, with their roundings; none where a written value says nothing.
    pub fn meant(&self, set: &[&Candidate]) -> Vec<Option<Datum>> {
        let mut meant: Vec<Option<Datum>> = self.data.iter().copied().map(Some).collect();
        for stand in set.iter().flat_map(|c| &c.reinterpreted) {
            let found = self.data.iter().position(|d| d.entry == stand.entry);
            if let Some(datum) = found {
                meant[datum] = stand.read(&self.data[datum]);
            }
        }
        meant
    }

    /// A first look: the values one by one, as if their errors had nothing to do with each other.
    pub fn first_look(&self, set: &[&Candidate]) -> f64 {
        let predicted = self.predicted(set);
        if predicted.iter().any(|p| !p.is_finite()) {
            return f64::INFINITY;
        }
        let meant = self.meant(set);
        let mut best = f64::INFINITY;
        for hand in [1.0, 0.2, 0.02] {
            let mut cost = Cost::ZERO;
            for (index, datum) in meant.iter().enumerate() {
                let without = &self.without[index];
                let Some(datum) = datum else {
                    cost.add(without.cost);
                    continue;
                };
                let rounding = datum.variance();
                // Errors grow about as the value does.
                let grown = (predicted[index] / self.right[index]).abs();
                let grown = if grown.is_finite() { grown.clamp(1.0, 1000.0) } else { 1.0 };
                let variance = hand * hand * grown * grown * self.quick[index] + rounding;
                let off = datum.off(predicted[index], 0.0);
                cost.add_deviate(off * off / variance, variance / rounding, without);
            }
            let cost = cost.total();
            best = best.min(cost);
        }
        best
    }
}
