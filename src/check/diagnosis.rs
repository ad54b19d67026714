//! Chooses the best of the explanations that were tried, and weighs the others against it.

use super::answer_key::AnswerKey;
use super::entry::Entry;
use super::explanation::{Diagnosis, Explanation, Finding};
use super::mistakes::{Candidate, Site};
use super::prepared::Ready;
use super::score::Scorer;
use super::search::{MARGIN, Search, Tried, is_by_hand};
use super::verdict::{Judged, Verdict};

/// The mistakes that explain the values of a drawing.
pub(super) fn diagnose(key: &AnswerKey<'_>, ready: &Ready, values: &[Judged]) -> Diagnosis {
    let entries: Vec<Entry> = values.iter().map(|v| v.entry.clone()).collect();
    let models = ready.models(key, &entries);
    let site = Site { model: &ready.right, key, entries: &entries, other_modes: models.len() - 1 };
    let candidates = site.candidates();
    let scorer = Scorer::new(models, &entries, key.tolerance);
    let search = Search::new(&candidates, &scorer);
    let tried = search.run(key.depth);
    search.diagnosis(tried, values)
}

/// Least gain in −2 ln of the likelihood by which mistakes must explain a hand drawing better than no mistake, where no
/// value is off beyond its tolerance: fifty times likelier.
const DOUBT: f64 = 7.8;

/// Least probability of another explanation that is reported.
const LEAST: f64 = 0.02;

/// Most other explanations that are reported.
const OTHERS: usize = 4;

impl Search<'_> {
    /// The best explanation, the others worth reporting, and the values that remain unexplained.
    pub fn diagnosis(&self, tried: Vec<Tried>, values: &[Judged]) -> Diagnosis {
        let Some(best) = tried.first() else {
            return Diagnosis {
                best: Explanation { findings: Vec::new(), probability: 0.0, is_alike: false },
                others: Vec::new(),
                unexplained: (0..values.len()).filter(|&i| values[i].verdict == Verdict::Off).collect(),
            };
        };
        // No mistake is assumed where mistakes hardly explain more.
        let is_enough = |t: &Tried| {
            let mut data = t.fit.outside.iter().zip(&self.scorer.data);
            let leaves = data.any(|(out, d)| *out && values[d.entry].verdict == Verdict::Off);
            let margin = if is_by_hand(t) { DOUBT } else { MARGIN };
            !leaves && t.cost <= best.cost + margin
        };
        let chosen = tried.iter().position(|t| t.set.is_empty()).filter(|&p| is_enough(&tried[p])).unwrap_or(0);
        let best = &tried[chosen];
        let weight = |t: &Tried| libm::exp(-0.5 * (t.cost - best.cost).max(-60.0));
        let total: f64 = tried.iter().map(weight).sum();
        // Explanations in the same words count as one; one that only leaves out a mistake of the best is no other
        // explanation.
        let is_told = |set: &[usize], other: &[usize]| {
            let told = |i: &usize| set.iter().any(|j| self.candidates[*i].is_told_like(&self.candidates[*j]));
            other.iter().all(told)
        };
        let probability = |of: &Tried| {
            let same = |t: &&Tried| t.set.len() == of.set.len() && is_told(&of.set, &t.set);
            tried.iter().filter(same).map(weight).sum::<f64>() / total
        };
        let best_set = self.set(&best.set);
        let mut others: Vec<&Tried> = Vec::new();
        for (index, other) in tried.iter().enumerate() {
            let is_new = !is_told(&best.set, &other.set) && !others.iter().any(|o| is_told(&o.set, &other.set));
            if index != chosen && !best.set.is_empty() && is_new {
                others.push(other);
            }
        }
        let others = others.into_iter().filter_map(|other| {
            let is_alike = other.set.len() == best.set.len()
                && self.scorer.are_alike(&best.fit, &other.fit, [&best_set, &self.set(&other.set)]);
            let probability = probability(other);
            (is_alike || probability >= LEAST).then(|| self.explanation(other, probability, is_alike))
        });
        let others: Vec<Explanation> = others.take(OTHERS).collect();
        // A value within the errors of the fitted hand needs no explanation.
        let is_outside = |entry: usize| {
            let mut data = best.fit.outside.iter().zip(&self.scorer.data);
            data.find(|(_, datum)| datum.entry == entry).is_none_or(|(outside, _)| *outside)
        };
        let off = (0..values.len()).filter(|&entry| values[entry].verdict == Verdict::Off);
        let unexplained: Vec<usize> = off.filter(|&entry| is_outside(entry)).collect();
        Diagnosis { best: self.explanation(best, probability(best), false), others, unexplained }
    }

    /// The values in which a mistake itself was made: those it makes to be written otherwise than meant, and those read
    /// from the operation that it changes.
    fn written(&self, candidate: &Candidate) -> Vec<usize> {
        let model = &self.scorer.models[0];
        let is_touched = |entry: usize| {
            let reading = model.readings[entry].ok();
            let maker = reading.and_then(|r| model.makers[r.number.0]);
            let is_edited = maker.is_some_and(|m| candidate.edits.iter().any(|(operation, _)| *operation == m));
            is_edited || candidate.reinterpreted.iter().any(|s| s.entry == entry)
        };
        self.scorer.data.iter().map(|d| d.entry).filter(|&entry| is_touched(entry)).collect()
    }

    fn explanation(&self, tried: &Tried, probability: f64, is_alike: bool) -> Explanation {
        let mut findings: Vec<Finding> = tried
            .set
            .iter()
            .map(|&index| {
                let without: Vec<usize> = tried.set.iter().copied().filter(|&i| i != index).collect();
                let before = self.scorer.predicted(&self.set(&without));
                let candidate = self.candidates[index].clone();
                let written = self.written(&candidate);
                let data = self.scorer.data.iter().enumerate();
                let follows = data.filter_map(|(place, datum)| {
                    let moved = tried.fit.predicted[place] - before[place];
                    let seen = 2.0 * self.scorer.deviation(place, &tried.fit);
                    let consistent = !tried.fit.outside[place] && !written.contains(&datum.entry);
                    (moved.abs() > seen && consistent).then_some(datum.entry)
                });
                Finding { follows: follows.collect(), written, candidate }
            })
            .collect();
        findings.sort_by_key(|f| f.candidate.step);
        Explanation { findings, probability, is_alike }
    }
}
