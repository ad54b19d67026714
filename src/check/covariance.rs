//! The covariance of all values that the honest errors of a hand cause.

use super::datum::Datum;
use super::model::{Changes, GROUPS, Model, PLOTTED, TOGETHER};
use crate::construction::{Change, NumberId, Tolerance, Values};

/// How accurate a hand is, and how it computes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hand {
    /// The size of its errors of each kind, in parts of the tolerance.
    pub errors: [f64; GROUPS],
    /// Which digits of a number it uses later.
    pub habit: Habit,
}

/// Which digits of a written number somebody uses in later operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Habit {
    /// Sometimes those that are written, sometimes all.
    Mixed,
    /// Those that are written.
    AsWritten,
    /// All digits of a calculator.
    AllDigits,
}

impl Hand {
    /// The size of its largest errors, in parts of the tolerance.
    pub fn worst(&self) -> f64 {
        self.errors.iter().copied().fold(0.0, f64::max)
    }
}

/// Covariance matrices of the values: one for each kind of errors at the tolerance, and one for roundings of numbers
/// used later.
pub(super) struct Covariances {
    pub groups: [Vec<f64>; GROUPS],
    pub roundings: Vec<f64>,
    /// By datum: whether later operations use it.
    pub used: Vec<bool>,
}

/// Part of its rounding's variance that a value keeps for itself where later operations use it as written: the rounding
/// then acts through [`Covariances::roundings`].
const OWN_ROUNDING: f64 = 1e-4;

impl Covariances {
    /// Sets `into` to the covariance for a hand, and `own` to the part of each rounding's variance that stays with its
    /// value.
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
            if s != 0.0 {
                for (sum, part) in into.iter_mut().zip(group) {
                    *sum += s * s * part;
                }
            }
        }
    }
}

/// Adds the product of a column and its transpose.
fn add_outer(matrix: &mut [f64], column: &[f64]) {
    let count = column.len();
    for (i, a) in column.iter().enumerate().filter(|(_, a)| **a != 0.0) {
        for (entry, b) in matrix[i * count..(i + 1) * count].iter_mut().zip(column) {
            *entry += a * b;
        }
    }
}

/// Step of difference quotients, in parts of an error's limit: larger steps are not linear, much smaller ones are lost
/// in rounding.
const STEP: f64 = 0.125;

/// Reads the data `which` from the values of a replay into their elements of `into`.
pub(super) fn read(model: &Model, values: &Values, data: &[Datum], which: &[usize], into: &mut [f64]) {
    for &datum in which {
        if let Ok(reading) = model.readings[data[datum].entry] {
            into[datum] = values.number(reading.number);
        }
    }
}

/// The replays from which values are read: the changes of each, and the data read from it.
pub(super) type Variants<'c> = [(Changes<'c>, Vec<usize>)];

impl Covariances {
    /// The covariances of the values in drawings with these changes.
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
            for ((value, exact), datum) in column.iter_mut().zip(&exact).zip(data) {
                *value = datum.turned(*value - exact) * (deviation / STEP);
            }
            add_outer(&mut covariances.groups[group], &column);
            if group == PLOTTED {
                plotted.push(column.clone());
            }
        }
        for motion in &model.together {
            column.fill(0.0);
            for (part, effect) in motion.iter().zip(&plotted) {
                for (sum, effect) in column.iter_mut().zip(effect) {
                    *sum += part * effect;
                }
            }
            add_outer(&mut covariances.groups[TOGETHER], &column);
        }
        for (number, rounding, datum) in written_numbers(model, data) {
            if !model.used[number.0] {
                continue;
            }
            let Some(operation) = model.makers[number.0] else { continue };
            if let Some(datum) = datum {
                covariances.used[datum] = true;
            }
            let size = rounding * deviation;
            for ((changes, which_data), base) in variants.iter().zip(&bases) {
                let change = Change::Written(number, base.number(number) + size);
                model.replay_after(&mut scratch, base, operation, change, changes);
                read(model, &scratch, data, which_data, &mut column);
            }
            for (value, exact) in column.iter_mut().zip(&exact) {
                *value -= exact;
            }
            add_outer(&mut covariances.roundings, &column);
        }
        covariances
    }
}

/// The numbers that people may use as written, each with half a unit of its last digit: those that are read, with their
/// data, and the sizes of vectors that are laid off, which are written to the decimals of their sheet.
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
