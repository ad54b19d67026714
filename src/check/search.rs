//! Looks for the mistakes that explain all values, right and wrong ones: one mistake first, then more together.

use super::answer_key::AnswerKey;
use super::entry::Entry;
use super::fit::{Fit, Hands};
use super::mistakes::{Candidate, Mistake};
use super::model::Model;
use super::score::Scorer;
use crate::cores::{on_all_cores, on_each_core};
use crate::position::poses;

/// How many candidates of a level are compared as a whole.
const COMPARED: usize = 40;

/// How many explanations are tried with a further mistake.
const EXTENDED: usize = 12;

/// By how much a further mistake must explain the values better, in −2 ln of likelihoods: ten times likelier.
pub(super) const MARGIN: f64 = 4.6;

/// How many of them are compared with hands that are not equally good at everything.
const REFINED: usize = 16;

/// How many slips of writing are compared as a whole where a first look does not see them.
const SLIPS: usize = 12;

/// A drawing this much better than the tolerance is none by hand.
const BY_HAND: f64 = 0.04;

/// An explanation that was compared as a whole.
pub(super) struct Tried {
    /// The candidates, by their places.
    pub set: Vec<usize>,
    pub fit: Fit,
    /// The cost with that of the mistakes.
    pub cost: f64,
}

/// The same construction in the other positions in which the links fit together.
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
    let others = all.into_iter().filter(away).take(5);
    let models = others.filter_map(|pose| {
        let model = Model::new(key, &key.solution.moved(pose).ok()?, mu, entries).ok()?;
        let same = model.readings.iter().zip(entries).all(|(r, _)| r.is_ok());
        let finite = model.read(&model.exact).iter().all(|x| x.is_finite());
        (same && finite).then_some(model)
    });
    models.collect()
}

/// The cost of each candidate: how rare the mistake is, and in how many places it could be made.
fn costs(candidates: &[Candidate]) -> Vec<f64> {
    // Gone on with or not, a slip of writing is made at one place.
    let count = |mistake: Mistake| {
        let own = candidates.iter().filter(|c| c.mistake == mistake);
        let mut blanks: Vec<&[String]> = own.map(|c| c.blanks.as_slice()).collect();
        blanks.sort_unstable();
        blanks.dedup();
        blanks.len()
    };
    let counts: Vec<(Mistake, usize)> = Mistake::all().map(|m| (m, count(m))).collect();
    let costs = candidates.iter().map(|candidate| {
        let listed = candidate.mistake.listed();
        let places = counts[candidate.mistake as usize].1 as f64;
        2.0 * libm::log(100.0 / listed.percent * places)
    });
    costs.collect()
}

pub(super) struct Search<'a> {
    pub candidates: &'a [Candidate],
    costs: Vec<f64>,
    /// Places of all candidates.
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

    /// All explanations compared as a whole, the best first.
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

    /// Slips of writing that an exact drawing shows beside the best explanation, the likeliest few.
    fn slips(&self, best: &Tried) -> Vec<Vec<usize>> {
        if is_by_hand(best) {
            return Vec::new();
        }
        let is_slip = |c: &Candidate| c.edits.is_empty() && c.goes_on.is_empty() && c.mode == 0;
        let all = self.all.iter().copied();
        let all = all.filter(|&i| is_slip(&self.candidates[i]) && self.go_together(&best.set, i));
        let all: Vec<usize> = all.collect();
        let costs = self.scorer.slips(&self.set(&best.set), &best.fit, &self.set(&all));
        let costs = costs.into_iter().zip(&all).map(|(cost, &i)| (cost + self.costs[i], i));
        let mut costs: Vec<(f64, usize)> = costs.collect();
        costs.sort_by(|a, b| a.0.total_cmp(&b.0));
        // The same slips, too, with which the student went on.
        let likeliest = costs.into_iter().take(SLIPS).flat_map(|(_, index)| {
            let slip = &self.candidates[index];
            let twins = self.all.iter().copied();
            let twins = twins.filter(move |&twin| self.candidates[twin].is_told_like(slip));
            twins.filter(|&twin| self.go_together(&best.set, twin))
        });
        let sets = likeliest.map(|index| {
            let mut set = best.set.clone();
            set.push(index);
            set.sort_unstable();
            set
        });
        sets.collect()
    }

    /// Explanations of one mistake more than those of the beam; the best first.
    fn level(&self, beam: &[Vec<usize>], best: Option<&Tried>) -> Vec<Tried> {
        let looks = beam.iter().map(|before| {
            on_all_cores(&self.all, |&index| {
                if before.contains(&index) || !self.go_together(before, index) {
                    return None;
                }
                let mut set = before.clone();
                set.push(index);
                set.sort_unstable();
                let cost = self.scorer.first_look(&self.set(&set)) + self.cost(&set);
                cost.is_finite().then_some((cost, set))
            })
        });
        let mut looked: Vec<(f64, Vec<usize>)> = looks.flatten().flatten().collect();
        looked.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
        looked.dedup_by(|a, b| a.1 == b.1);
        looked.truncate(COMPARED);
        // Slips that only an exact drawing shows cannot be seen before every kind of hand is tried.
        let slips = best.map(|best| self.slips(best)).unwrap_or_default();
        let looked = looked.into_iter().map(|(_, set)| set);
        let looked = looked.filter(|set| !slips.contains(set)).collect();
        let mut level = self.compared(looked, REFINED);
        level.extend(self.compared(slips, usize::MAX));
        level.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        level
    }

    /// Explanations compared as a whole; the likeliest of them, so many, with hands that are not equally good at everything.
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
        let tried = both.into_iter().map(|(set, hands)| {
            let fit = Fit::from(hands);
            let cost = fit.cost + self.cost(&set);
            Tried { set, fit, cost }
        });
        tried.collect()
    }

    /// Two changes of one act, or two meanings of one value, do not go together; another position only with slips of writing.
    fn go_together(&self, set: &[usize], other: usize) -> bool {
        let new = &self.candidates[other];
        set.iter().all(|&index| {
            let old = &self.candidates[index];
            let acts = old.edits.iter().all(|(a, _)| new.edits.iter().all(|(b, _)| a != b));
            let values = old.reinterpreted.iter().all(|a| new.reinterpreted.iter().all(|b| a.entry != b.entry));
            let positions = old.mode == 0 && new.mode == 0
                || (old.edits.is_empty() && old.goes_on.is_empty() && new.mode != old.mode && old.mode * new.mode == 0)
                    && new.edits.is_empty()
                    && new.goes_on.is_empty();
            acts && values && positions
        })
    }
}

/// Whether the hand is as good as hands are, and no better.
pub(super) fn is_by_hand(tried: &Tried) -> bool {
    tried.fit.hand.errors.iter().all(|&s| s == 0.0 || s >= BY_HAND)
}

/// Whether nothing remains to be explained: in a drawing more exact than hands draw there may be slips that its tolerance hides.
fn is_explained(tried: &Tried) -> bool {
    is_by_hand(tried) && !tried.fit.outside.iter().any(|&out| out)
}
