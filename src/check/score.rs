//! How well written values fit a construction with mistakes put in.
//!
//! Honest errors of the hand, of all acts, carry the values together: to first order they are normally distributed with the covariance
//! C = Σ s_g² J_g J_gᵀ, J the difference quotients of the values by each error times its standard deviation, s_g ≤ 1 how good the hand is at each
//! kind of act. The values are gone through in the order of the construction, each held against what the earlier ones let expect (Cholesky's
//! factorisation row by row). One that no error explains stands outside and says nothing about those that follow. Costs
//! are −2 ln of likelihoods, each value's counted from the density of its rounding.

use super::covariance::{Covariances, add_outer};
use super::datum::Datum;
use super::entry::Entry;
use super::mistakes::Candidate;
use super::model::{Changes, GROUPS, Model, PLOTTED, TOGETHER};
use crate::drafting::{Change, Disturbance, Sheet, Tolerance, Values};
use crate::plan::Kind;

/// How good a hand may be, in parts of the tolerance: from the pencil to a drawing program.
const HANDS: [f64; 9] = [1.0, 0.5, 0.2, 0.05, 0.01, 2e-3, 4e-4, 8e-5, 1e-5];

/// The errors of the velocity plan.
const VELOCITY: usize = 2;

/// Cost of a value that nothing explains, beyond the range in which it could lie: one of some hundred.
const UNEXPLAINED: f64 = 11.0;

/// Cost of a hand ten times better than the tolerance says, at one kind of acts.
const BETTER_HAND: f64 = 1.2;

/// What is held against each other.
pub(super) struct Scorer<'a> {
    /// The right position first, then other assembly modes.
    pub models: &'a [Model],
    pub data: Vec<Datum>,
    tolerance: Tolerance,
    /// Variances of the values of a right drawing at the tolerance, for a first look.
    quick: Vec<f64>,
    /// The values of a right drawing.
    right: Vec<f64>,
}

/// How well values fit.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    /// The cost of the values, without that of the mistakes.
    pub cost: f64,
    /// What the values should be with the mistakes made, by datum.
    pub predicted: Vec<f64>,
    /// Which values remain outside, by datum.
    pub outside: Vec<bool>,
    /// How good the hand is at each kind of acts.
    pub hand: [f64; GROUPS],
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
                is_magnitude: entry.is_magnitude || reading.is_magnitude || reading.is_distance,
                is_angle: reading.is_angle,
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
            tolerance,
            quick: Vec::new(),
            right: Vec::new(),
        };
        let nominal = scorer.covariances(&[]);
        let count = scorer.data.len();
        let own = &nominal.groups[..TOGETHER];
        let diagonal = (0..count).map(|i| own.iter().map(|g| g[i * count + i]).sum());
        scorer.quick = diagonal.collect();
        scorer.right = scorer.predicted(&[]);
        scorer
    }

    fn model(&self, set: &[&Candidate]) -> &'a Model {
        let mode = set.iter().map(|c| c.mode).max().unwrap_or(0);
        &self.models[mode]
    }

    /// What the candidates change; without what one of them goes on with, where its own values are asked for.
    fn changes<'c>(&self, set: &[&'c Candidate], without: Option<usize>) -> Changes<'c> {
        let mut changes = Changes::new();
        for (index, candidate) in set.iter().enumerate() {
            for (act, put) in &candidate.puts {
                let change = put.change();
                changes.push(Disturbance { act: *act, change });
            }
            if without == Some(index) {
                continue;
            }
            for &(act, number, value) in &candidate.goes_on {
                let change = Change::Written(number, value);
                changes.push(Disturbance { act, change });
            }
        }
        changes.sort_by_key(|c| c.act);
        changes
    }

    /// Which candidate goes on with a written value of a datum.
    fn owner(&self, set: &[&Candidate], datum: usize) -> Option<usize> {
        let entry = self.data[datum].entry;
        set.iter()
            .position(|c| !c.goes_on.is_empty() && c.stands.iter().any(|s| s.entry == entry))
    }

    /// The replays that a set needs: the changes, and the data that are read there.
    fn variants<'c>(&self, set: &[&'c Candidate]) -> Vec<(Changes<'c>, Vec<usize>)> {
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
            self.read(model, &values, &data, &mut predicted);
        }
        predicted
    }

    fn read(&self, model: &Model, values: &Values, data: &[usize], into: &mut [f64]) {
        for &datum in data {
            if let Ok(reading) = model.readings[self.data[datum].entry] {
                into[datum] = values.number(reading.number);
            }
        }
    }

    /// The values as the candidates read them, with their roundings; none where a written value says nothing.
    fn meant(&self, set: &[&Candidate]) -> Vec<Option<Datum>> {
        let mut meant: Vec<Option<Datum>> = self.data.iter().copied().map(Some).collect();
        for stand in set.iter().flat_map(|c| &c.stands) {
            let found = self.data.iter().position(|d| d.entry == stand.entry);
            if let Some(datum) = found {
                meant[datum] = stand.value.map(|value| Datum {
                    value,
                    rounding: stand.rounding.max(f64::MIN_POSITIVE),
                    ..self.data[datum]
                });
            }
        }
        meant
    }

    /// The cost of a value that nothing explains.
    fn outside(&self, datum: &Datum) -> f64 {
        datum.range - libm::log(datum.variance()) + UNEXPLAINED
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
            let mut cost = 0.0;
            for (index, datum) in meant.iter().enumerate() {
                let outside = self.outside(&self.data[index]);
                cost += match datum {
                    Some(datum) => {
                        let rounding = datum.variance();
                        // Errors grow about as the value does.
                        let grown = (predicted[index] / self.right[index]).abs();
                        let grown = if grown.is_finite() {
                            grown.clamp(1.0, 10.0)
                        } else {
                            1.0
                        };
                        let variance = hand * hand * grown * grown * self.quick[index] + rounding;
                        let off = datum.off(predicted[index], 0.0);
                        let own = off * off / variance + libm::log(variance / rounding);
                        own.min(outside)
                    }
                    None => outside,
                };
            }
            best = best.min(cost);
        }
        best
    }

    /// The whole comparison, with the covariances that the mistakes bring with them.
    pub fn fit(&self, set: &[&Candidate]) -> Option<Fit> {
        let predicted = self.predicted(set);
        if predicted.iter().any(|p| !p.is_finite()) {
            return None;
        }
        let covariances = self.covariances(set);
        let meant = self.meant(set);
        let count = self.data.len();
        let mut matrix = vec![0.0; count * count];
        let mut best: Option<(f64, Vec<bool>, [f64; GROUPS])> = None;
        let mut consider =
            |hand: [f64; GROUPS], best: &mut Option<(f64, Vec<bool>, [f64; GROUPS])>| {
                covariances.sum(&hand, &mut matrix);
                let (mut cost, outside) = self.walk(&meant, &predicted, &matrix);
                // A kind of errors that there is not is no better hand.
                let better = hand.iter().filter(|s| **s > 0.0);
                cost -= better.map(|s| BETTER_HAND * libm::log10(*s)).sum::<f64>();
                if best.as_ref().is_none_or(|b| cost < b.0) {
                    *best = Some((cost, outside, hand));
                    true
                } else {
                    false
                }
            };
        // All alike first; then, for drawings more exact than hands draw, each kind for itself.
        let mut level = 0;
        for (index, &size) in HANDS.iter().enumerate() {
            let mut hand = [size; GROUPS];
            hand[TOGETHER] = 0.0;
            if consider(hand, &mut best) {
                level = index;
            } else if index > level + 1 {
                break;
            }
        }
        if level > 1 {
            let finest = HANDS[HANDS.len() - 1];
            let mut program = [finest; GROUPS];
            program[TOGETHER] = HANDS[level];
            program[VELOCITY] = HANDS[level];
            consider(program, &mut best);
            for _ in 0..2 {
                for group in 0..GROUPS {
                    let mut hand = best.as_ref().map_or(program, |b| b.2);
                    for &size in &HANDS {
                        hand[group] = size;
                        consider(hand, &mut best);
                    }
                }
            }
        }
        best.map(|(cost, outside, hand)| Fit {
            cost,
            predicted,
            outside,
            hand,
        })
    }

    /// The costs of slips of writing beside a set that has been compared already, for drawings so exact that a first look sees nothing: the covariances
    /// stay, the hand may turn out better at one kind of acts.
    pub fn slips(&self, set: &[&Candidate], fit: &Fit, slips: &[&Candidate]) -> Vec<f64> {
        let covariances = self.covariances(set);
        let count = self.data.len();
        let mut hands = vec![fit.hand];
        for group in 0..GROUPS {
            for better in [5.0, 25.0, 125.0] {
                let mut hand = fit.hand;
                hand[group] /= better;
                hands.push(hand);
            }
        }
        let matrices = hands.iter().map(|hand| {
            let mut matrix = vec![0.0; count * count];
            covariances.sum(hand, &mut matrix);
            matrix
        });
        let matrices: Vec<Vec<f64>> = matrices.collect();
        let costs = slips.iter().map(|slip| {
            let all: Vec<&Candidate> = set.iter().copied().chain([*slip]).collect();
            let meant = self.meant(&all);
            let costs = matrices
                .iter()
                .map(|m| self.walk(&meant, &fit.predicted, m).0);
            costs.fold(f64::INFINITY, f64::min)
        });
        costs.collect()
    }

    /// The values in their order, each held against what the earlier ones let expect.
    fn walk(&self, meant: &[Option<Datum>], predicted: &[f64], matrix: &[f64]) -> (f64, Vec<bool>) {
        let count = self.data.len();
        let mut rows: Vec<(usize, Vec<f64>)> = Vec::with_capacity(count);
        let mut shifts: Vec<f64> = Vec::with_capacity(count);
        let mut outside = vec![false; count];
        let mut cost = 0.0;
        for index in 0..count {
            let without = self.outside(&self.data[index]);
            let Some(datum) = &meant[index] else {
                cost += without;
                continue;
            };
            let rounding = datum.variance();
            let mut row = Vec::with_capacity(rows.len() + 1);
            let (mut mean, mut variance) = (0.0, matrix[index * count + index] + rounding);
            for (other, earlier) in &rows {
                let known: f64 = row
                    .iter()
                    .zip(earlier)
                    .map(|(a, b): (&f64, &f64)| a * b)
                    .sum();
                let entry = (matrix[index * count + other] - known) / earlier[row.len()];
                mean += entry * shifts[row.len()];
                variance -= entry * entry;
                row.push(entry);
            }
            // Roundings are independent: less than a part of them never remains.
            let variance = variance.max(0.25 * rounding);
            let off = datum.off(predicted[index], mean) - mean;
            let own = off * off / variance + libm::log(variance / rounding);
            if own <= without {
                cost += own;
                let deviation = variance.sqrt();
                row.push(deviation);
                rows.push((index, row));
                shifts.push(off / deviation);
            } else {
                cost += without;
                outside[index] = true;
            }
        }
        (cost, outside)
    }

    fn covariances(&self, set: &[&Candidate]) -> Covariances {
        let model = self.model(set);
        let count = self.data.len();
        let variants = self.variants(set);
        let bases: Vec<Values> = variants.iter().map(|(c, _)| model.replay(c)).collect();
        let mut exact = vec![0.0; count];
        for ((_, data), base) in variants.iter().zip(&bases) {
            self.read(model, base, data, &mut exact);
        }
        let mut covariances = Covariances {
            groups: core::array::from_fn(|_| vec![0.0; count * count]),
            roundings: vec![0.0; count * count],
        };
        let mut scratch = model.exact.clone();
        let mut pair = [vec![0.0; count], vec![0.0; count]];
        let deviation = 1.0 / 3.0_f64.sqrt();
        let mut plotted: Vec<Vec<f64>> = Vec::new();
        for (act, which, limit, group) in model.errors(&self.tolerance) {
            for (column, size) in pair.iter_mut().zip([limit, -limit]) {
                for ((changes, data), base) in variants.iter().zip(&bases) {
                    let change = Change::Error(which, size);
                    model.replay_after(&mut scratch, base, act, change, changes);
                    self.read(model, &scratch, data, column);
                }
            }
            let column: Vec<f64> = pair[0]
                .iter()
                .zip(&pair[1])
                .zip(&self.data)
                .map(|((up, down), datum)| 0.5 * deviation * datum.turned(up - down))
                .collect();
            add_outer(&mut covariances.groups[group], &column);
            if group == PLOTTED {
                plotted.push(column);
            }
        }
        for way in &model.together {
            let mut column = vec![0.0; count];
            for (part, own) in way.iter().zip(&plotted) {
                for (sum, own) in column.iter_mut().zip(own) {
                    *sum += part * own;
                }
            }
            add_outer(&mut covariances.groups[TOGETHER], &column);
        }
        // People go on with numbers as they write them: those that are read here, and sizes of vectors that are laid off, to the same decimals.
        let read = self.data.iter().filter_map(|datum| {
            let reading = model.readings[datum.entry].ok()?;
            Some((reading.number, datum.rounding))
        });
        let sizes = model.sizes.iter().map(|&(number, sheet)| {
            let same = self.data.iter().filter(|d| d.sheet == Some(sheet));
            let finest = same.map(|d| d.rounding).fold(f64::INFINITY, f64::min);
            (number, if finest.is_finite() { finest } else { 0.0 })
        });
        for (number, rounding) in read.chain(sizes) {
            let Some(act) = model.makers[number.0].filter(|_| model.used[number.0]) else {
                continue;
            };
            let size = rounding * deviation;
            let column = &mut pair[0];
            for ((changes, data), base) in variants.iter().zip(&bases) {
                let change = Change::Written(number, base.number(number) + size);
                model.replay_after(&mut scratch, base, act, change, changes);
                self.read(model, &scratch, data, column);
            }
            let column: Vec<f64> = column.iter().zip(&exact).map(|(a, b)| a - b).collect();
            add_outer(&mut covariances.roundings, &column);
        }
        covariances
    }

    /// About how far honest errors of a hand as good as the fit says let a value be off.
    pub fn deviation(&self, datum: usize, fit: &Fit) -> f64 {
        let hand = fit.hand.iter().copied().fold(0.0, f64::max);
        (hand * hand * self.quick[datum] + self.data[datum].variance()).sqrt()
    }

    /// Whether two predictions are the same for all that the values can show.
    pub fn are_alike(&self, a: &Fit, b: &Fit, sets: [&[&Candidate]; 2]) -> bool {
        let [meant_a, meant_b] = sets.map(|set| self.meant(set));
        let pairs = a.predicted.iter().zip(&b.predicted).enumerate();
        let mut all = pairs.map(|(index, (p, q))| {
            let (m, n) = (&meant_a[index], &meant_b[index]);
            let same_meaning = match (m, n) {
                (Some(m), Some(n)) => (m.value - n.value).abs() <= 0.01 * m.rounding,
                (None, None) => true,
                _ => false,
            };
            let datum = &self.data[index];
            let fine = 0.05 * self.deviation(index, a);
            let apart = if datum.is_magnitude {
                (p.abs() - q.abs()).abs()
            } else {
                datum.turned(p - q).abs()
            };
            same_meaning && apart <= fine
        });
        all.all(|same| same)
    }
}
