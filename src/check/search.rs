//! Searches for the mistakes that explain all values, right and wrong ones: one mistake first, then more together.

use super::answer_key::AnswerKey;
use super::entry::Entry;
use super::fit::{Fit, Hands};
use super::mistakes::{Candidate, Mistake};
use super::model::Model;
use super::score::Scorer;
use crate::cores::{on_all_cores, on_each_core};
use crate::position::poses;

/// Explanations of one level that are compared completely: the best at a first look.
const COMPARED: usize = 40;

/// Explanations of one level that are tried with a further mistake (the width of the beam search).
const EXTENDED: usize = 12;

/// Least gain of a further mistake, in −2 ln of the likelihood: ten times likelier.
pub(super) const MARGIN: f64 = 4.6;

/// Compared explanations for which hands with errors of different sizes are tried.
const REFINED: usize = 16;

/// Slips of writing that are compared completely where a first look does not show them.
const SLIPS: usize = 12;

/// Least size of a hand's errors, in parts of the tolerance; a drawing with smaller errors was not made by hand.
const BY_HAND: f64 = 0.04;

/// An explanation that was compared completely.
pub(super) struct Tried {
    /// Indices of its candidates.
    pub set: Vec<usize>,
    pub fit: Fit,
    /// The cost of the values and of the mistakes.
    pub cost: f64,
}

/// The constructions of the other assembly modes.
pub(super) fn other_modes(key: &AnswerKey<'_>, mu: [Option<f64>; 3], entries: &[Entry]) -> Vec<Model> {
    // Groups without a construction take long to assemble and are not drawn.
    if key.solution.construction.agreement.iter().any(Option::is_none) {
        return Vec::new();
    }
    let Ok(all) = poses(&key.solution.mechanism, &key.solution.scene.near) else {
        return Vec::new();
    };
    let away = |pose: &crate::position::Pose| {
        let places = pose.points.iter().zip(&key.solution.pose.points);
        let size = crate::geometry::span(key.solution.pose.points.iter().copied());
        places.map(|(p, q)| (p - q).norm()).fold(0.0, f64::max) > 1e-6 * size
    };
    let model = |pose| {
        let model = Model::new(key, &key.solution.moved(pose).ok()?, mu, entries).ok()?;
        let same = model.readings.iter().zip(entries).all(|(r, _)| r.is_ok());
        let finite = model.read(&model.exact).iter().all(|x| x.is_finite());
        (same && finite).then_some(model)
    };
    all.into_iter().filter(away).take(5).filter_map(model).collect()
}

/// The cost of each candidate, −2 ln of its prior probability: the mistake's share divided by the number of places for
/// it.
fn costs(candidates: &[Candidate]) -> Vec<f64> {
    // Candidates with the same blanks are one place: a slip of writing counts once, whether it is passed on or not.
    let count = |mistake: Mistake| {
        let same = candidates.iter().filter(|c| c.mistake == mistake);
        let mut blanks: Vec<&[String]> = same.map(|c| c.blanks.as_slice()).collect();
        blanks.sort_unstable();
        blanks.dedup();
        blanks.len()
    };
    let counts: Vec<(Mistake, usize)> = Mistake::all().map(|m| (m, count(m))).collect();
    let cost = |candidate: &Candidate| {
        let listed = candidate.mistake.listed();
        let places = counts[candidate.mistake as usize].1 as f64;
        2.0 * libm::log(100.0 / listed.percent * places)
    };
    candidates.iter().map(cost).collect()
}

pub(super) struct Search<'a> {
    pub candidates: &'a [Candidate],
    /// By candidate: its cost.
    costs: Vec<f64>,
    /// Indices of all candidates.
    all: Vec<usize>,
    pub scorer: &'a Scorer<'a>,
}

impl<'a> Search<'a> {
    pub fn new(candidates: &'a [Candidate], scorer: &'a Scorer<'a>) -> Search<'a> {
        Search { costs: costs(candidates), all: (0..candidates.len()).collect(), candidates, scorer }
    }

    pub fn set(&self, indices: &[usize]) -> Vec<&'a Candidate> {
        indices.iter().map(|&i| &self.candidates[i]).collect()
    }

    fn cost(&self, indices: &[usize]) -> f64 {
        indices.iter().map(|&i| self.costs[i]).sum()
    }

    /// All explanations that were compared completely, the best first.
    pub fn run(&self, depth: usize) -> Vec<Tried> {
        let mut tried: Vec<Tried> = Vec::new();
        tried.extend(self.compared(vec![Vec::new()], 1));
        let mut beam: Vec<Vec<usize>> = vec![Vec::new()];
        for _ in 0..depth {
            let best_before = tried.first().map_or(f64::INFINITY, |t| t.cost);
            let mut level = self.level(&beam, tried.first());
            if level.is_empty() {
                break;
            }
            beam = level.iter().take(EXTENDED).map(|t| t.set.clone()).collect();
            tried.append(&mut level);
            tried.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            let best = &tried[0];
            if best.cost > best_before - MARGIN || is_explained(best) {
                break;
            }
        }
        tried
    }

    /// The best explanation with one slip of writing more: the likeliest slips that an exact drawing shows. None for
    /// hand drawings.
    fn slips(&self, best: &Tried) -> Vec<Vec<usize>> {
        if is_by_hand(best) {
            return Vec::new();
        }
        let is_slip = |c: &Candidate| c.edits.is_empty() && c.goes_on.is_empty() && c.mode == 0;
        let fits = |i: &usize| is_slip(&self.candidates[*i]) && self.go_together(&best.set, *i);
        let all: Vec<usize> = self.all.iter().copied().filter(fits).collect();
        let costs = self.scorer.slips(&self.set(&best.set), &best.fit, &self.set(&all));
        let mut costs: Vec<(f64, usize)> =
            costs.into_iter().zip(&all).map(|(cost, &i)| (cost + self.costs[i], i)).collect();
        costs.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Each slip, and its twin that is passed on to later operations.
        let likeliest = costs.into_iter().take(SLIPS).flat_map(|(_, index)| {
            let slip = &self.candidates[index];
            let twins = self.all.iter().copied().filter(move |&twin| self.candidates[twin].is_told_like(slip));
            twins.filter(|&twin| self.go_together(&best.set, twin))
        });
        likeliest.map(|index| with(&best.set, index)).collect()
    }

    /// Explanations with one mistake more than those of the beam, compared completely; the best first.
    fn level(&self, beam: &[Vec<usize>], best: Option<&Tried>) -> Vec<Tried> {
        let looks = beam.iter().map(|before| {
            on_all_cores(&self.all, |&index| {
                if before.contains(&index) || !self.go_together(before, index) {
                    return None;
                }
                let set = with(before, index);
                let cost = self.scorer.first_look(&self.set(&set)) + self.cost(&set);
                cost.is_finite().then_some((cost, set))
            })
        });
        let mut looked: Vec<(f64, Vec<usize>)> = looks.flatten().flatten().collect();
        looked.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
        looked.dedup_by(|a, b| a.1 == b.1);
        looked.truncate(COMPARED);
        // Slips that only an exact drawing shows are invisible at a first look, which supposes a hand's errors.
        let slips = best.map(|best| self.slips(best)).unwrap_or_default();
        let looked = looked.into_iter().map(|(_, set)| set).filter(|set| !slips.contains(set)).collect();
        let mut level = self.compared(looked, REFINED);
        level.extend(self.compared(slips, usize::MAX));
        level.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        level
    }

    /// Explanations compared completely; the `refined` likeliest of them with hands that have errors of different
    /// sizes.
    fn compared(&self, sets: Vec<Vec<usize>>, refined: usize) -> Vec<Tried> {
        let compared = on_all_cores(&sets, |set| self.scorer.compare(&self.set(set)));
        let mut both: Vec<(Vec<usize>, Hands<'_, '_>)> =
            sets.into_iter().zip(compared).filter_map(|(set, hands)| Some((set, hands?))).collect();
        both.sort_by(|(a, x), (b, y)| {
            let costs = [x.cost + self.cost(a), y.cost + self.cost(b)];
            costs[0].total_cmp(&costs[1]).then_with(|| a.cmp(b))
        });
        let likeliest = refined.min(both.len());
        on_each_core(&mut both[..likeliest], |(_, hands)| hands.search_each());
        let tried = |(set, hands): (Vec<usize>, Hands<'_, '_>)| {
            let fit = Fit::from(hands);
            let cost = fit.cost + self.cost(&set);
            Tried { set, fit, cost }
        };
        both.into_iter().map(tried).collect()
    }

    /// Whether a candidate can be combined with a set: two edits of one operation, or two meanings of one value,
    /// cannot; another assembly mode can only with slips of writing.
    fn go_together(&self, set: &[usize], other: usize) -> bool {
        let new = &self.candidates[other];
        set.iter().all(|&index| {
            let old = &self.candidates[index];
            let operations = old.edits.iter().all(|(a, _)| new.edits.iter().all(|(b, _)| a != b));
            let values = old.reinterpreted.iter().all(|a| new.reinterpreted.iter().all(|b| a.entry != b.entry));
            let positions = old.mode == 0 && new.mode == 0
                || (old.edits.is_empty() && old.goes_on.is_empty() && new.mode != old.mode && old.mode * new.mode == 0)
                    && new.edits.is_empty()
                    && new.goes_on.is_empty();
            operations && values && positions
        })
    }
}

/// A sorted set with one index more.
fn with(set: &[usize], index: usize) -> Vec<usize> {
    let mut set = set.to_vec();
    set.push(index);
    set.sort_unstable();
    set
}

/// Whether the hand's errors are as large as those of drawings by hand.
pub(super) fn is_by_hand(tried: &Tried) -> bool {
    tried.fit.hand.errors.iter().all(|&s| s == 0.0 || s >= BY_HAND)
}

/// Whether nothing remains to be explained; never so in a drawing more exact than a hand's, where the tolerance may
/// hide slips.
fn is_explained(tried: &Tried) -> bool {
    is_by_hand(tried) && !tried.fit.outside.iter().any(|&out| out)
}
