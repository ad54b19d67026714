//! Looks for the mistakes that explain all values, right and wrong ones: one mistake first, then more together.

use super::entry::Entry;
use super::fit::{Fit, Hands};
use super::mistakes::{Candidate, Mistake, Site};
use super::model::Model;
use super::score::Scorer;
use super::verdict::{Drawn, Judged, Verdict};
use crate::cores::{on_all_cores, on_each_core};
use crate::motion::{Order, motion};
use crate::plan::construction;
use crate::position::poses;

/// What explains the values.
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// The mistakes that explain them best, in the order of the construction; none where nothing is to be explained or nothing in the
    /// catalogue does.
    pub best: Explanation,
    /// What explains them, too, less surely.
    pub others: Vec<Explanation>,
    /// The values, by their places in the list, that remain without an explanation.
    pub unexplained: Vec<usize>,
}

/// Mistakes that explain values together.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// The mistakes, in the order of the construction.
    pub findings: Vec<Finding>,
    /// How sure it is among all explanations that were tried, from 0 to 1.
    pub probability: f64,
    /// Whether it is here because the given values alone cannot tell it from the best one.
    pub is_alike: bool,
}

/// A mistake that was probably made.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The mistake, and where it was made.
    pub candidate: Candidate,
    /// Values, by their places in the list, that differ from the right ones because of it and are consistent with it.
    pub follows: Vec<usize>,
    /// Values that it touches itself: written otherwise than meant, or read where it was made.
    pub written: Vec<usize>,
}

/// How many candidates of a level are compared as a whole.
const COMPARED: usize = 40;

/// How many explanations are tried with a further mistake.
const EXTENDED: usize = 12;

/// By how much a further mistake must explain the values better, in −2 ln of likelihoods: ten times likelier.
const MARGIN: f64 = 4.6;

/// How many of them are compared with hands that are not equally good at everything.
const REFINED: usize = 16;

/// How many slips of writing are compared as a whole where a first look does not see them.
const SLIPS: usize = 12;

/// A drawing this much better than the tolerance is none by hand.
const BY_HAND: f64 = 0.04;

/// Explanations less sure than this are not told.
const LEAST: f64 = 0.02;

/// At most so many other explanations are told.
const OTHERS: usize = 4;

/// An explanation that was compared as a whole.
struct Tried {
    /// The candidates, by their places.
    set: Vec<usize>,
    fit: Fit,
    /// The cost with that of the mistakes.
    cost: f64,
}

/// What explains the values of an own drawing.
pub(super) fn diagnose(
    drawn: &Drawn<'_>,
    mu: [Option<f64>; 3],
    model: &Model,
    values: &[Judged],
) -> Diagnosis {
    let entries: Vec<Entry> = values.iter().map(|v| v.entry.clone()).collect();
    let mut models = vec![model.clone()];
    models.extend(other_modes(drawn, mu, &entries));
    let site = Site {
        model,
        drawn,
        entries: &entries,
        other_modes: models.len() - 1,
    };
    let candidates = site.candidates();
    let scorer = Scorer::new(&models, &entries, drawn.tolerance);
    let search = Search {
        costs: costs(&candidates),
        all: (0..candidates.len()).collect(),
        candidates: &candidates,
        scorer: &scorer,
    };
    let tried = search.run(drawn.depth);
    search.diagnosis(tried, values)
}

/// The same construction in the other positions in which the links fit together.
pub(super) fn other_modes(
    drawn: &Drawn<'_>,
    mu: [Option<f64>; 3],
    entries: &[Entry],
) -> Vec<Model> {
    // Groups without a construction take long to assemble and are not drawn.
    if drawn.construction.agreement.iter().any(Option::is_none) {
        return Vec::new();
    }
    let Ok(all) = poses(drawn.mechanism, drawn.near) else {
        return Vec::new();
    };
    let away = |pose: &crate::position::Pose| {
        let places = pose.points.iter().zip(&drawn.pose.points);
        let size = crate::geometry::span(drawn.pose.points.iter().copied());
        places.map(|(p, q)| (p - q).norm()).fold(0.0, f64::max) > 1e-6 * size
    };
    let others = all.into_iter().filter(away).take(5);
    let models = others.filter_map(|pose| {
        let motion = motion(drawn.mechanism, &pose, Order::Acceleration).ok()?;
        let construction = construction(drawn.mechanism, &pose, &motion);
        let model = Model::new(drawn, &pose, &motion, &construction, mu, entries).ok()?;
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

struct Search<'a> {
    candidates: &'a [Candidate],
    costs: Vec<f64>,
    /// Places of all candidates.
    all: Vec<usize>,
    scorer: &'a Scorer<'a>,
}

impl<'a> Search<'a> {
    fn set(&self, indices: &[usize]) -> Vec<&'a Candidate> {
        indices.iter().map(|&i| &self.candidates[i]).collect()
    }

    fn cost(&self, indices: &[usize]) -> f64 {
        indices.iter().map(|&i| self.costs[i]).sum()
    }

    /// All explanations compared as a whole, the best first.
    fn run(&self, depth: usize) -> Vec<Tried> {
        let mut tried: Vec<Tried> = Vec::new();
        tried.extend(self.compared(vec![Vec::new()]));
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
        let is_slip = |c: &Candidate| c.puts.is_empty() && c.goes_on.is_empty() && c.mode == 0;
        let all = self.all.iter().copied();
        let all = all.filter(|&i| is_slip(&self.candidates[i]) && self.go_together(&best.set, i));
        let all: Vec<usize> = all.collect();
        let costs = self
            .scorer
            .slips(&self.set(&best.set), &best.fit, &self.set(&all));
        let costs = costs
            .into_iter()
            .zip(&all)
            .map(|(cost, &i)| (cost + self.costs[i], i));
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
        let mut sets: Vec<Vec<usize>> = best.map(|best| self.slips(best)).unwrap_or_default();
        sets.retain(|set| looked.iter().all(|l| l.1 != *set));
        sets.extend(looked.into_iter().map(|(_, set)| set));
        let mut level = self.compared(sets);
        level.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        level
    }

    /// Explanations compared as a whole; the likeliest of them with hands that are not equally good at everything.
    fn compared(&self, sets: Vec<Vec<usize>>) -> Vec<Tried> {
        let compared = on_all_cores(&sets, |set| self.scorer.compare(&self.set(set)));
        let both = sets.into_iter().zip(compared);
        let both =
            both.filter_map(|(set, hands)| hands.map(|h| (h.cost + self.cost(&set), set, h)));
        let mut all: Vec<(f64, Vec<usize>, Hands<'_, '_>)> = both.collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
        let mut all: Vec<(bool, Vec<usize>, Hands<'_, '_>)> = all
            .into_iter()
            .enumerate()
            .map(|(place, (_, set, hands))| (place < REFINED, set, hands))
            .collect();
        on_each_core(&mut all, |(is_likely, _, hands)| {
            if *is_likely {
                hands.search_each();
            }
        });
        let tried = all.into_iter().map(|(_, set, hands)| {
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
            let acts = old
                .puts
                .iter()
                .all(|(a, _)| new.puts.iter().all(|(b, _)| a != b));
            let values = old
                .stands
                .iter()
                .all(|a| new.stands.iter().all(|b| a.entry != b.entry));
            let positions = old.mode == 0 && new.mode == 0
                || (old.puts.is_empty()
                    && old.goes_on.is_empty()
                    && new.mode != old.mode
                    && old.mode * new.mode == 0)
                    && new.puts.is_empty()
                    && new.goes_on.is_empty();
            acts && values && positions
        })
    }

    fn diagnosis(&self, tried: Vec<Tried>, values: &[Judged]) -> Diagnosis {
        let Some(best) = tried.first() else {
            return Diagnosis {
                best: Explanation {
                    findings: Vec::new(),
                    probability: 0.0,
                    is_alike: false,
                },
                others: Vec::new(),
                unexplained: (0..values.len())
                    .filter(|&i| values[i].verdict == Verdict::Off)
                    .collect(),
            };
        };
        // Without mistakes where they hardly explain more.
        let plain = tried.iter().position(|t| t.set.is_empty());
        let plain = plain.filter(|&p| {
            let mut data = tried[p].fit.outside.iter().zip(&self.scorer.data);
            let leaves = data.any(|(out, d)| *out && values[d.entry].verdict == Verdict::Off);
            !leaves && tried[p].cost <= best.cost + MARGIN
        });
        let chosen = plain.unwrap_or(0);
        let best = &tried[chosen];
        let weight = |t: &Tried| libm::exp(-0.5 * (t.cost - best.cost).max(-60.0));
        let total: f64 = tried.iter().map(weight).sum();
        // Explanations that are told in the same words are one; those that leave out one of the best's mistakes say nothing else.
        let is_told = |set: &[usize], other: &[usize]| {
            let told = |i: &usize| {
                set.iter()
                    .any(|j| self.candidates[*i].is_told_like(&self.candidates[*j]))
            };
            other.iter().all(told)
        };
        let probability = |of: &Tried| {
            let same = |t: &&Tried| t.set.len() == of.set.len() && is_told(&of.set, &t.set);
            tried.iter().filter(same).map(weight).sum::<f64>() / total
        };
        let own_set = self.set(&best.set);
        let mut others: Vec<&Tried> = Vec::new();
        for (index, other) in tried.iter().enumerate() {
            let is_new = !is_told(&best.set, &other.set)
                && !others.iter().any(|o| is_told(&o.set, &other.set));
            if index != chosen && !best.set.is_empty() && is_new {
                others.push(other);
            }
        }
        let others = others.into_iter().filter_map(|other| {
            let is_alike = other.set.len() == best.set.len()
                && self
                    .scorer
                    .are_alike(&best.fit, &other.fit, [&own_set, &self.set(&other.set)]);
            let probability = probability(other);
            (is_alike || probability >= LEAST)
                .then(|| self.explanation(other, probability, is_alike))
        });
        let others: Vec<Explanation> = others.take(OTHERS).collect();
        // What a hand may be off by needs no explanation.
        let is_outside = |entry: usize| {
            let mut data = best.fit.outside.iter().zip(&self.scorer.data);
            data.find(|(_, datum)| datum.entry == entry)
                .is_none_or(|(outside, _)| *outside)
        };
        let off = (0..values.len()).filter(|&entry| values[entry].verdict == Verdict::Off);
        let unexplained: Vec<usize> = off.filter(|&entry| is_outside(entry)).collect();
        Diagnosis {
            best: self.explanation(best, probability(best), false),
            others,
            unexplained,
        }
    }

    /// The values that a mistake touches itself: written otherwise than meant, or read where it was made.
    fn written(&self, candidate: &Candidate) -> Vec<usize> {
        let model = &self.scorer.models[0];
        let own = |entry: usize| {
            let reading = model.readings[entry].ok();
            let maker = reading.and_then(|r| model.makers[r.number.0]);
            let at_it = maker.is_some_and(|m| candidate.puts.iter().any(|(act, _)| *act == m));
            at_it || candidate.stands.iter().any(|s| s.entry == entry)
        };
        let entries = self.scorer.data.iter().map(|d| d.entry);
        entries.filter(|&entry| own(entry)).collect()
    }

    fn explanation(&self, tried: &Tried, probability: f64, is_alike: bool) -> Explanation {
        let mut findings: Vec<Finding> = tried
            .set
            .iter()
            .map(|&index| {
                let without: Vec<usize> =
                    tried.set.iter().copied().filter(|&i| i != index).collect();
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
                Finding {
                    follows: follows.collect(),
                    written,
                    candidate,
                }
            })
            .collect();
        findings.sort_by_key(|f| f.candidate.step);
        Explanation {
            findings,
            probability,
            is_alike,
        }
    }
}

/// Whether the hand is as good as hands are, and no better.
fn is_by_hand(tried: &Tried) -> bool {
    tried
        .fit
        .hand
        .errors
        .iter()
        .all(|&s| s == 0.0 || s >= BY_HAND)
}

/// Whether nothing remains to be explained: in a drawing more exact than hands draw there may be slips that its tolerance hides.
fn is_explained(tried: &Tried) -> bool {
    is_by_hand(tried) && !tried.fit.outside.iter().any(|&out| out)
}
