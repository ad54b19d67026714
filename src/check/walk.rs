//! A walk through the values in the order of the construction: each is compared with its distribution given the earlier
//! ones (Cholesky factorisation row by row).

use super::covariance::Covariances;
use super::datum::{Cost, Datum, Without};
use super::hand::Hand;

/// What a walk compares: the values meant, and those that a construction predicts.
#[derive(Clone, Copy)]
pub(super) struct Compared<'a> {
    /// By datum: the value meant; `None` where the written one tells nothing about it.
    pub meant: &'a [Option<Datum>],
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
}

impl Walk {
    pub fn new(count: usize) -> Walk {
        Walk {
            matrix: vec![0.0; count * count],
            own: vec![1.0; count],
            means: vec![0.0; count],
            outside: vec![false; count],
        }
    }

    /// The cost of all values for a hand.
    pub fn run(&mut self, covariances: &Covariances, hand: &Hand, compared: Compared<'_>) -> f64 {
        covariances.sum(hand, &mut self.matrix, &mut self.own);
        let count = compared.meant.len();
        self.means.fill(0.0);
        self.outside.fill(false);
        let mut cost = Cost::ZERO;
        for index in 0..count {
            let without = &compared.without[index];
            let Some(datum) = &compared.meant[index] else {
                cost.add(without.cost);
                continue;
            };
            let rounding = datum.variance();
            let variance = remaining(self.matrix[index * count + index], self.own[index] * rounding);
            let off = datum.off(compared.predicted[index], self.means[index]) - self.means[index];
            if !cost.add_deviate(off * off / variance, variance / rounding, without) {
                self.outside[index] = true;
                continue;
            }
            // The later values given this one: Gaussian elimination of its row.
            let (passed, later) = self.matrix.split_at_mut((index + 1) * count);
            let row = &passed[index * count..];
            for (other, below) in (index + 1..count).zip(later.chunks_exact_mut(count)) {
                let part = row[other] / variance;
                if part != 0.0 {
                    self.means[other] += part * off;
                    eliminate(&mut below[other..], part, &row[other..]);
                }
            }
        }
        cost.total()
    }
}

/// The variance of a value given earlier ones. Roundings are independent of each other, so at least a quarter of the own
/// rounding's variance always remains.
fn remaining(others: f64, own: f64) -> f64 {
    (others + own).max(0.25 * own)
}

/// Subtracts `part` times a row.
fn eliminate(entries: &mut [f64], part: f64, row: &[f64]) {
    for (entry, pivot) in entries.iter_mut().zip(row) {
        *entry -= part * pivot;
    }
}

/// The factors of a covariance, for quick comparisons of many predictions with the same values. An unexplained value is
/// taken to be what the earlier ones let expect.
pub(super) struct Metric {
    /// By row: the parts of earlier values' deviations that a value is expected to have.
    lower: Vec<f64>,
    /// By value: its variance given the earlier ones.
    variances: Vec<f64>,
    /// The same without its own rounding's.
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
            let (passed, later) = matrix.split_at_mut((index + 1) * count);
            let row = &passed[index * count..];
            for (other, below) in (index + 1..count).zip(later.chunks_exact_mut(count)) {
                let part = row[other] / variance;
                if part != 0.0 {
                    metric.lower[other * count + index] = part;
                    eliminate(&mut below[other..], part, &row[other..]);
                }
            }
        }
        metric
    }

    /// The cost of the values at a first look. `grown`: how many times as large as usual a value's errors are.
    pub fn look(&self, compared: Compared<'_>, grown: impl Fn(usize) -> f64, deviations: &mut Vec<f64>) -> f64 {
        let count = compared.meant.len();
        let mut cost = Cost::ZERO;
        deviations.clear();
        for index in 0..count {
            let without = &compared.without[index];
            let Some(datum) = &compared.meant[index] else {
                cost.add(without.cost);
                deviations.push(0.0);
                continue;
            };
            let row = &self.lower[index * count..index * count + index];
            let mean: f64 = row.iter().zip(deviations.iter()).map(|(part, deviation)| part * deviation).sum();
            let off = datum.off(compared.predicted[index], mean) - mean;
            let grown = grown(index);
            let variance = self.variances[index] + (grown * grown - 1.0) * self.drawn[index];
            let is_inside = cost.add_deviate(off * off / variance, variance / datum.variance(), without);
            deviations.push(if is_inside { off } else { 0.0 });
        }
        cost.total()
    }
}
