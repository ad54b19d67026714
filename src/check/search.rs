//! Searches for the mistakes that explain all values, right and wrong ones: one mistake first, then more together.

use super::covariance::Hand;
use super::entry::Entry;
use super::fit::Fit;
use super::measured::AnswerKey;
use super::mistakes::{Candidate, Mistake, Told};
use super::model::Model;
use super::score::{Metric, Scorer};
use super::settle::Settling;
use crate::cores::on_all_cores;
use crate::position::first_poses;
use crate::sheet::Scales;
use std::collections::{BTreeMap, BTreeSet};

/// Explanations of one level with mistakes of the catalogue that are compared completely: the best at a first look.
const COMPARED: usize = 20;

/// Explanations of one level with amounts fitted to the values that are compared completely.
const SETTLED: usize = 8;

/// Places of the likeliest fitted amounts at which more mistakes of the catalogue are compared, and how many.
const PLACES: usize = 3;
const BESIDE: usize = 12;

/// Explanations of one level that are tried with a further mistake (the width of the beam search).
const EXTENDED: usize = 6;

/// Cost above the best one of its level above which an explanation is not tried with a further mistake.
const HOPELESS: f64 = 40.0;

/// Explanations of one level that are compared about the errors that they tell.
const NEARER: usize = 12;

/// Most other assembly modes that are compared.
const MODES: usize = 5;

/// Least gain of a further mistake, in −2 ln of the likelihood: ten times likelier.
const MARGIN: f64 = 4.6;

/// Cost of each mistake beside the first: most people make one.
const FURTHER: f64 = 2.5;

/// Cost of each amount that is fitted to the values, at a first look.
const FITTED: f64 = 7.0;

/// Difference in −2 ln of the probability from which on an explanation is clearly likelier: twenty times.
const CLEARLY: f64 = 6.0;

/// An explanation that was compared completely.
#[derive(Clone)]
pub(super) struct Tried {
    /// Indices of its candidates in the pool.
    pub set: Vec<usize>,
    pub fit: Fit,
    /// The cost of the values, the hand and the mistakes.
    pub cost: f64,
}

/// An explanation that is tried with a further mistake.
struct Parent<'a> {
    tried: &'a Tried,
    set: Vec<&'a Candidate>,
    /// By datum: whether a further mistake is wanted that concerns it.
    wanted: Vec<bool>,
    metrics: Vec<Metric>,
}

/// An explanation with one mistake more, at a first look.
struct Child<'a> {
    cost: f64,
    before: &'a [usize],
    hand: Hand,
    /// The further mistake: a candidate of the pool, and what it is with amounts that were fitted to the values.
    index: usize,
    fitted: Option<Candidate>,
}

/// The constructions of the other assembly modes.
pub(super) fn other_modes(key: &AnswerKey<'_>, mu: Scales, entries: &[Entry]) -> Vec<Model> {
    // Groups without a construction take long to assemble and are not drawn.
    if key.solution.construction.agreement.iter().any(Option::is_none) {
        return Vec::new();
    }
    let Ok(all) = first_poses(&key.solution.mechanism, &key.solution.scene.near, MODES + 1) else {
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
    all.into_iter().filter(away).take(MODES).filter_map(model).collect()
}

/// The cost of each candidate, −2 ln of its prior probability: the mistake's share divided by the number of places for
/// it.
fn costs(candidates: &[Candidate]) -> Vec<f64> {
    // Candidates with the same sentences are one place: a slip of writing counts once, whether it is passed on or not.
    let mut places: BTreeMap<Mistake, BTreeSet<&Told>> = BTreeMap::new();
    for candidate in candidates {
        places.entry(candidate.mistake()).or_default().insert(&candidate.told);
    }
    let cost = |candidate: &Candidate| {
        let places = places[&candidate.mistake()].len() as f64;
        2.0 * libm::log(100.0 / candidate.mistake().share() * places)
    };
    candidates.iter().map(cost).collect()
}

pub(super) struct Search<'a> {
    pub scorer: &'a Scorer<'a>,
    /// The candidates of the catalogue, then those with amounts that were fitted to the values.
    pub pool: Vec<Candidate>,
    /// By candidate: its cost.
    costs: Vec<f64>,
    /// The catalogue's candidates by their indices, each with the data that it changes.
    listed: Vec<(usize, Vec<usize>)>,
}

impl<'a> Search<'a> {
    pub fn new(candidates: Vec<Candidate>, scorer: &'a Scorer<'a>) -> Search<'a> {
        let costs = costs(&candidates);
        let right = scorer.predicted(&[]);
        let changed = on_all_cores(&candidates, |candidate| scorer.changed(candidate, &right));
        Search { scorer, costs, listed: changed.into_iter().enumerate().collect(), pool: candidates }
    }

    pub fn set(&self, indices: &[usize]) -> Vec<&Candidate> {
        indices.iter().map(|&i| &self.pool[i]).collect()
    }

    fn cost(&self, indices: &[usize]) -> f64 {
        let further = FURTHER * indices.len().saturating_sub(1) as f64;
        indices.iter().map(|&i| self.costs[i]).sum::<f64>() + further
    }

    /// All explanations that were compared completely, the best first. `none`: how well values fit without a mistake.
    /// `off`: by datum whether its verdict is off.
    pub fn run(&mut self, none: Fit, off: &[bool], depth: usize) -> Vec<Tried> {
        let mut beam = vec![Tried { set: Vec::new(), cost: none.cost, fit: none }];
        self.bring_nearer(&mut beam);
        // A mistake that is passed on looks like a bad hand, for which nothing is left to be explained: as a careful one's it is looked
        // for, too.
        if beam[0].fit.hand.worst() > 1.0 {
            let (cost, careful) = (beam[0].cost, self.scorer.compare_by(&[], Hand::alike(1.0)));
            beam.extend(careful.map(|fit| Tried { set: Vec::new(), cost, fit }));
        }
        let mut tried: Vec<Tried> = Vec::new();
        for depth in 0..=depth {
            let best_before = tried.first().map_or(f64::INFINITY, |t: &Tried| t.cost);
            let compared = if depth == 0 { &beam[..1] } else { &beam[..] };
            tried.extend(compared.iter().cloned());
            tried.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            let best = &tried[0];
            let is_last =
                depth > 0 && (best.cost > best_before - MARGIN || is_explained(best) || is_invented(best, off));
            if is_last {
                break;
            }
            beam.retain(|t| t.cost <= beam_limit(&tried));
            beam.truncate(EXTENDED);
            beam = self.level(&beam, off);
            if beam.is_empty() {
                break;
            }
        }
        tried
    }

    /// Explanations with one mistake more than those of the beam, compared completely; the best first.
    fn level(&mut self, beam: &[Tried], off: &[bool]) -> Vec<Tried> {
        let mut chosen: Vec<(Vec<usize>, Hand)> = Vec::new();
        let mut fitted: Vec<(Candidate, f64)> = Vec::new();
        for child in self.children(beam, off) {
            let mut index = child.index;
            if let Some(candidate) = child.fitted {
                fitted.push((candidate, self.costs[index]));
                index = self.pool.len() + fitted.len() - 1;
            }
            let mut set = child.before.to_vec();
            set.push(index);
            set.sort_unstable();
            if chosen.iter().all(|(other, _)| *other != set) {
                chosen.push((set, child.hand));
            }
        }
        for (candidate, cost) in fitted {
            self.pool.push(candidate);
            self.costs.push(cost);
        }
        let compared = on_all_cores(&chosen, |(set, hand)| self.scorer.compare(&self.set(set), Some(hand)));
        let tried = chosen.into_iter().zip(compared).filter_map(|((set, _), fit)| {
            let fit = fit?;
            let cost = fit.cost + self.cost(&set);
            Some(Tried { set, fit, cost })
        });
        let mut level: Vec<Tried> = tried.collect();
        sort(&mut level);
        self.bring_nearer(&mut level);
        level
    }

    /// Compares the likeliest explanations once more, about the errors that they tell.
    fn bring_nearer(&self, level: &mut [Tried]) {
        let least = level.first().map_or(f64::INFINITY, |best| best.cost);
        let count = level.iter().take(NEARER).take_while(|tried| tried.cost < least + HOPELESS).count();
        let found = on_all_cores(&level[..count], |tried| self.scorer.nearer(&self.set(&tried.set), &tried.fit));
        for (tried, fit) in level.iter_mut().zip(found) {
            if let Some(fit) = fit {
                tried.cost += fit.cost - tried.fit.cost;
                tried.fit = fit;
            }
        }
        sort(level);
    }

    /// The likeliest further mistakes at a first look, the best first.
    fn children<'t>(&self, beam: &'t [Tried], off: &[bool]) -> Vec<Child<'t>> {
        let mut children: Vec<Child<'t>> = Vec::new();
        for tried in beam {
            let parent = self.parent(tried, off);
            let found = on_all_cores(&self.listed, |(index, changed)| self.further(&parent, *index, changed));
            let own = self.cost(&tried.set);
            for (index, found) in found.into_iter().enumerate() {
                children.extend(found.into_iter().map(|(cost, fitted)| Child {
                    cost: cost + own,
                    before: &tried.set,
                    hand: tried.fit.hand,
                    index,
                    fitted,
                }));
            }
        }
        children.retain(|child| child.cost.is_finite());
        children.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        self.chosen(children)
    }

    /// The children that are compared completely: the likeliest of the catalogue, the likeliest with a fitted amount, and
    /// what of the catalogue is done at the same operation or in the same step as the first of these: where lines hardly cross, or an arm is short, a first look
    /// shows only fitted amounts.
    fn chosen<'t>(&self, children: Vec<Child<'t>>) -> Vec<Child<'t>> {
        let fitted: Vec<&Candidate> = children.iter().filter_map(|child| child.fitted.as_ref()).take(PLACES).collect();
        let places: Vec<usize> = fitted.iter().flat_map(|fitted| fitted.operations()).collect();
        let steps: Vec<usize> = fitted.iter().map(|fitted| fitted.step).collect();
        let is_beside = |listed: &Candidate| {
            steps.contains(&listed.step) || listed.operations().any(|operation| places.contains(&operation))
        };
        let (mut listed, mut settled, mut beside) = (COMPARED, SETTLED, BESIDE);
        let mut take = |child: &Child<'t>| {
            let left = match child.fitted {
                Some(_) => &mut settled,
                None if listed > 0 => &mut listed,
                None if is_beside(&self.pool[child.index]) => &mut beside,
                None => return false,
            };
            let is_taken = *left > 0;
            *left = left.saturating_sub(1);
            is_taken
        };
        children.into_iter().filter(|child| take(child)).collect()
    }

    fn parent<'t>(&'t self, tried: &'t Tried, off: &[bool]) -> Parent<'t> {
        let set = self.set(&tried.set);
        let covariances = self.scorer.covariances(&set);
        let is_first = set.is_empty();
        let mut hands = vec![tried.fit.hand, tried.fit.hand.times(0.3), Hand::alike(1.0)];
        if is_first {
            hands.extend([0.2, 0.02].map(Hand::alike));
        }
        let metrics = hands.iter().map(|hand| Metric::new(&covariances, hand, &self.scorer.data)).collect();
        let wanted = tried.fit.outside.iter().zip(off).map(|(outside, off)| *outside || is_first && *off);
        Parent { tried, set, wanted: wanted.collect(), metrics }
    }

    /// The further mistakes at a candidate's place that concern a wanted value, each with its cost and, if it has amounts
    /// to be fitted, as it is with these.
    fn further(&self, parent: &Parent<'_>, index: usize, changed: &[usize]) -> Vec<(f64, Option<Candidate>)> {
        let candidate = &self.pool[index];
        let is_wanted = changed.iter().any(|&datum| parent.wanted.get(datum).is_some_and(|wanted| *wanted));
        if !is_wanted || !self.go_together(&parent.tried.set, index) {
            return Vec::new();
        }
        let look = |candidate: &Candidate| {
            let mut set = parent.set.clone();
            set.push(candidate);
            let meant = self.scorer.meant(&set);
            let look =
                self.scorer.look(&parent.metrics, &parent.tried.fit.predicted, &meant, &self.scorer.predicted(&set));
            look + self.costs[index] + FURTHER + FITTED * candidate.free.len() as f64
        };
        if candidate.free.is_empty() {
            return vec![(look(candidate), None)];
        }
        let settled = Settling::new(self.scorer, &parent.set, &parent.tried.fit, candidate).settled().into_iter();
        settled.map(|fitted| (look(&fitted), Some(fitted))).collect()
    }

    /// Whether a candidate can be combined with a set: two edits of one operation, or two meanings of one value,
    /// cannot; another assembly mode can only with slips of writing.
    fn go_together(&self, set: &[usize], other: usize) -> bool {
        let new = &self.pool[other];
        set.iter().all(|&index| {
            let old = &self.pool[index];
            let operations = old.operations().all(|a| new.operations().all(|b| a != b));
            let values = old.reinterpreted.iter().all(|a| new.reinterpreted.iter().all(|b| a.entry != b.entry));
            let is_slip = |c: &Candidate| c.edits.is_empty() && c.passed_on.is_empty() && c.free.is_empty();
            let positions = old.mode == 0 && new.mode == 0
                || new.mode != old.mode && old.mode * new.mode == 0
                    // One of them only writes otherwise.
                    && [old, new].iter().any(|c| c.mode == 0 && is_slip(c));
            operations && values && positions
        })
    }
}

/// The best first.
fn sort(tried: &mut [Tried]) {
    tried.sort_by(|a, b| a.cost.total_cmp(&b.cost).then_with(|| a.set.cmp(&b.set)));
}

/// The hand of the likeliest explanation. A sheet without mistakes by a bad hand must be clearly likelier than one with
/// a mistake by a better hand to be taken for that.
pub(super) fn hand(tried: &[Tried]) -> Option<Hand> {
    let best = tried.first()?;
    let better = tried.iter().find(|t| !t.set.is_empty() && t.fit.hand.worst() < best.fit.hand.worst());
    let is_near = |t: &&Tried| t.cost < best.cost + CLEARLY;
    Some(better.filter(is_near).unwrap_or(best).fit.hand)
}

/// The cost above which explanations are not tried with a further mistake.
fn beam_limit(tried: &[Tried]) -> f64 {
    let most = tried.iter().map(|t| t.set.len()).max().unwrap_or(0);
    let level = tried.iter().filter(|t| t.set.len() == most);
    level.map(|t| t.cost).fold(f64::INFINITY, f64::min) + HOPELESS
}

/// Fewest values that are off, and the part of them that a first mistake leaves open, from which on no further one is looked for: numbers
/// that nobody has measured are not worth the time.
const INVENTED: (usize, f64) = (40, 0.8);

fn is_invented(tried: &Tried, off: &[bool]) -> bool {
    let count = off.iter().filter(|off| **off).count();
    let open = tried.fit.outside.iter().zip(off).filter(|(outside, off)| **outside && **off).count();
    count >= INVENTED.0 && open as f64 > INVENTED.1 * count as f64
}

/// Whether nothing remains to be explained; never so in a drawing more exact than a hand's, where the tolerance may
/// hide slips.
fn is_explained(tried: &Tried) -> bool {
    tried.fit.hand.is_by_hand() && !tried.fit.outside.iter().any(|&out| out)
}
