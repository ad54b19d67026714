//! How far honest errors carry all values together.

use super::datum::Datum;
use super::model::{Changes, GROUPS, Model, PLOTTED, TOGETHER};
use crate::construction::{Change, NumberId, Tolerance, Values};

/// How good a hand is, and how it computes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hand {
    /// Its errors of each kind, in parts of the tolerance.
    pub errors: [f64; GROUPS],
    /// With what it goes on.
    pub habit: Habit,
}

/// With what somebody goes on who has written a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Habit {
    /// Now with this, now with that.
    Mixed,
    /// With the number as it is written.
    AsWritten,
    /// With all digits of a calculator.
    AllDigits,
}

impl Hand {
    /// The kind of its largest errors.
    pub fn worst(&self) -> f64 {
        self.errors.iter().copied().fold(0.0, f64::max)
    }
}

/// Symmetric matrices, one for each kind of errors, and that of roundings gone on with.
pub(super) struct Covariances {
    pub groups: [Vec<f64>; GROUPS],
    pub roundings: Vec<f64>,
    /// By datum: whether something is computed or drawn with it.
    pub used: Vec<bool>,
}

/// Part of a rounding's variance that is a value's own where what follows takes the value as it is written.
const OWN_ROUNDING: f64 = 1e-4;

impl Covariances {
    /// Their sum for a hand as good as that, and which part of the variance of each value's rounding is its own.
    pub fn sum(&self, hand: &Hand, into: &mut [f64], own: &mut [f64]) {
        match hand.habit {
            Habit::AllDigits => into.fill(0.0),
            Habit::Mixed | Habit::AsWritten => into.copy_from_slice(&self.roundings),
        }
        for (own, used) in own.iter_mut().zip(&self.used) {
            let is_passed_on = hand.habit == Habit::AsWritten && *used;
            *own = if is_passed_on { OWN_ROUNDING } else { 1.0 };
        }
        for (group, s) in self.groups.iter().zip(hand.errors) {
            for (sum, part) in into.iter_mut().zip(group).filter(|_| s != 0.0) {
                *sum += s * s * part;
            }
        }
    }
}

/// Adds a column times itself.
fn add_outer(matrix: &mut [f64], column: &[f64]) {
    let count = column.len();
    for (i, a) in column.iter().enumerate().filter(|(_, a)| **a != 0.0) {
        for (entry, b) in matrix[i * count..(i + 1) * count].iter_mut().zip(column) {
            *entry += a * b;
        }
    }
}

/// Difference quotients are taken with this part of an error's limit: larger errors bend, the least ones drown in rounding.
const STEP: f64 = 0.125;

/// Reads data from values of a run into their places.
pub(super) fn read(model: &Model, values: &Values, data: &[Datum], which: &[usize], into: &mut [f64]) {
    for &datum in which {
        if let Ok(reading) = model.readings[data[datum].entry] {
            into[datum] = values.number(reading.number);
        }
    }
}

/// The runs that values are read from: changes put into the construction, and the data that are read there.
pub(super) type Variants<'c> = [(Changes<'c>, Vec<usize>)];

impl Covariances {
    /// The covariances of the values of drawings with changes.
    pub fn new(model: &Model, tolerance: &Tolerance, data: &[Datum], variants: &Variants<'_>) -> Covariances {
        let count = data.len();
        let bases: Vec<Values> = variants.iter().map(|(c, _)| model.replay(c)).collect();
        let mut exact = vec![0.0; count];
        for ((_, which), base) in variants.iter().zip(&bases) {
            read(model, base, data, which, &mut exact);
        }
        let mut covariances = Covariances {
            groups: core::array::from_fn(|_| vec![0.0; count * count]),
            roundings: vec![0.0; count * count],
            used: vec![false; count],
        };
        let mut scratch = model.exact.clone();
        let mut column = vec![0.0; count];
        let deviation = 1.0 / 3.0_f64.sqrt();
        let mut plotted: Vec<Vec<f64>> = Vec::new();
        for (operation, which, limit, group) in model.errors(tolerance) {
            for ((changes, which_data), base) in variants.iter().zip(&bases) {
                let change = Change::Error(which, STEP * limit);
                model.replay_after(&mut scratch, base, operation, change, changes);
                read(model, &scratch, data, which_data, &mut column);
            }
            for ((own, exact), datum) in column.iter_mut().zip(&exact).zip(data) {
                *own = datum.turned(*own - exact) * (deviation / STEP);
            }
            add_outer(&mut covariances.groups[group], &column);
            if group == PLOTTED {
                plotted.push(column.clone());
            }
        }
        for way in &model.together {
            column.fill(0.0);
            for (part, own) in way.iter().zip(&plotted) {
                for (sum, own) in column.iter_mut().zip(own) {
                    *sum += part * own;
                }
            }
            add_outer(&mut covariances.groups[TOGETHER], &column);
        }
        for (number, rounding, datum) in written_numbers(model, data) {
            let Some(operation) = model.makers[number.0].filter(|_| model.used[number.0]) else {
                continue;
            };
            if let Some(datum) = datum {
                covariances.used[datum] = true;
            }
            let size = rounding * deviation;
            for ((changes, which_data), base) in variants.iter().zip(&bases) {
                let change = Change::Written(number, base.number(number) + size);
                model.replay_after(&mut scratch, base, operation, change, changes);
                read(model, &scratch, data, which_data, &mut column);
            }
            for (own, exact) in column.iter_mut().zip(&exact) {
                *own -= exact;
            }
            add_outer(&mut covariances.roundings, &column);
        }
        covariances
    }
}

/// The numbers with which people go on as they write them, with half a unit of their last digit: those that are read, each with its datum, and
/// the sizes of vectors that are laid off, which are written to the decimals of their sheet.
fn written_numbers(model: &Model, data: &[Datum]) -> Vec<(NumberId, f64, Option<usize>)> {
    let read = data.iter().enumerate().filter_map(|(index, datum)| {
        let reading = model.readings[datum.entry].ok()?;
        Some((reading.number, datum.rounding, Some(index)))
    });
    let sizes = model.sizes.iter().map(|&(number, sheet)| {
        let same = data.iter().filter(|d| d.sheet == Some(sheet));
        let finest = same.map(|d| d.rounding).fold(f64::INFINITY, f64::min);
        (number, if finest.is_finite() { finest } else { 0.0 }, None)
    });
    read.chain(sizes).collect()
}
