//! What the explanations that were tried come to.

use super::answer_key::AnswerKey;
use super::entry::Entry;
use super::explanation::{Diagnosis, Explanation, Finding};
use super::mistakes::{Candidate, Site};
use super::model::Model;
use super::score::Scorer;
use super::search::{MARGIN, Search, Tried, is_by_hand, other_modes};
use super::verdict::{Judged, Verdict};

/// What explains the values of an own drawing.
pub(super) fn diagnose(key: &AnswerKey<'_>, mu: [Option<f64>; 3], model: &Model, values: &[Judged]) -> Diagnosis {
    let entries: Vec<Entry> = values.iter().map(|v| v.entry.clone()).collect();
    let mut models = vec![model.clone()];
    models.extend(other_modes(key, mu, &entries));
    let site = Site { model, key, entries: &entries, other_modes: models.len() - 1 };
    let candidates = site.candidates();
    let scorer = Scorer::new(&models, &entries, key.tolerance);
    let search = Search::new(&candidates, &scorer);
    let tried = search.run(key.depth);
    search.diagnosis(tried, values)
}

/// By how much mistakes must explain the values of a hand drawing better than no mistake, where none is off beyond its tolerance: fifty times likelier.
const DOUBT: f64 = 7.8;

/// Explanations less sure than this are not told.
const LEAST: f64 = 0.02;

/// At most so many other explanations are told.
const OTHERS: usize = 4;

impl Search<'_> {
    /// The best explanation, the others that are worth telling, and what remains.
    pub fn diagnosis(&self, tried: Vec<Tried>, values: &[Judged]) -> Diagnosis {
        let Some(best) = tried.first() else {
            return Diagnosis {
                best: Explanation { findings: Vec::new(), probability: 0.0, is_alike: false },
                others: Vec::new(),
                unexplained: (0..values.len()).filter(|&i| values[i].verdict == Verdict::Off).collect(),
            };
        };
        // Without mistakes where they hardly explain more.
        let plain = tried.iter().position(|t| t.set.is_empty());
        let plain = plain.filter(|&p| {
            let mut data = tried[p].fit.outside.iter().zip(&self.scorer.data);
            let leaves = data.any(|(out, d)| *out && values[d.entry].verdict == Verdict::Off);
            let margin = if is_by_hand(&tried[p]) { DOUBT } else { MARGIN };
            !leaves && tried[p].cost <= best.cost + margin
        });
        let chosen = plain.unwrap_or(0);
        let best = &tried[chosen];
        let weight = |t: &Tried| libm::exp(-0.5 * (t.cost - best.cost).max(-60.0));
        let total: f64 = tried.iter().map(weight).sum();
        // Explanations that are told in the same words are one; those that leave out one of the best's mistakes say nothing else.
        let is_told = |set: &[usize], other: &[usize]| {
            let told = |i: &usize| set.iter().any(|j| self.candidates[*i].is_told_like(&self.candidates[*j]));
            other.iter().all(told)
        };
        let probability = |of: &Tried| {
            let same = |t: &&Tried| t.set.len() == of.set.len() && is_told(&of.set, &t.set);
            tried.iter().filter(same).map(weight).sum::<f64>() / total
        };
        let own_set = self.set(&best.set);
        let mut others: Vec<&Tried> = Vec::new();
        for (index, other) in tried.iter().enumerate() {
            let is_new = !is_told(&best.set, &other.set) && !others.iter().any(|o| is_told(&o.set, &other.set));
            if index != chosen && !best.set.is_empty() && is_new {
                others.push(other);
            }
        }
        let others = others.into_iter().filter_map(|other| {
            let is_alike = other.set.len() == best.set.len()
                && self.scorer.are_alike(&best.fit, &other.fit, [&own_set, &self.set(&other.set)]);
            let probability = probability(other);
            (is_alike || probability >= LEAST).then(|| self.explanation(other, probability, is_alike))
        });
        let others: Vec<Explanation> = others.take(OTHERS).collect();
        // What a hand may be off by needs no explanation.
        let is_outside = |entry: usize| {
            let mut data = best.fit.outside.iter().zip(&self.scorer.data);
            data.find(|(_, datum)| datum.entry == entry).is_none_or(|(outside, _)| *outside)
        };
        let off = (0..values.len()).filter(|&entry| values[entry].verdict == Verdict::Off);
        let unexplained: Vec<usize> = off.filter(|&entry| is_outside(entry)).collect();
        Diagnosis { best: self.explanation(best, probability(best), false), others, unexplained }
    }

    /// The values that a mistake touches itself: written otherwise than meant, or read where it was made.
    fn written(&self, candidate: &Candidate) -> Vec<usize> {
        let model = &self.scorer.models[0];
        let own = |entry: usize| {
            let reading = model.readings[entry].ok();
            let maker = reading.and_then(|r| model.makers[r.number.0]);
            let at_it = maker.is_some_and(|m| candidate.edits.iter().any(|(operation, _)| *operation == m));
            at_it || candidate.reinterpreted.iter().any(|s| s.entry == entry)
        };
        let entries = self.scorer.data.iter().map(|d| d.entry);
        entries.filter(|&entry| own(entry)).collect()
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
