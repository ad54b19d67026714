//! Values as they are compared with predictions; how accurate the hand is that has drawn, measured and computed; and the
//! covariance that its honest errors give the values.

use super::mistakes::{Amount, Free};
use super::model::{COMPUTING, Changes, GROUPS, LEANING, Model, PLOTTED, TOGETHER, in_order};
use crate::construction::{Change, ComingRound, Disturbance, NumberId, Rubbed, Tolerance, Values, pressing_off};
use crate::geometry::{with_turns, without_sense};
use crate::sheet::QuantityKind;

/// A value of the form as it is compared with a prediction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Datum {
    /// The index of its entry.
    pub entry: usize,
    pub value: f64,
    /// Half a unit of its last digit.
    pub rounding: f64,
    /// Whether its sign is unknown.
    pub is_magnitude: bool,
    pub kind: QuantityKind,
    /// Whether it is the direction of a line, which has no sense.
    pub is_line: bool,
    /// The range in which a value of this kind could lie.
    pub span: f64,
}

impl Datum {
    /// The variance of its rounding: errors are uniform up to half a unit of the last digit.
    pub fn variance(&self) -> f64 {
        self.rounding * self.rounding / 3.0
    }

    /// The value less the predicted one; where the sign is unknown, with the sign that brings this difference nearest
    /// to `expected`.
    pub fn off(&self, predicted: f64, expected: f64) -> f64 {
        let off = self.turned(self.value - predicted);
        if !self.is_magnitude {
            return off;
        }
        let reversed = -self.value - predicted;
        if (reversed - expected).abs() < (off - expected).abs() { reversed } else { off }
    }

    /// By how much two predictions differ as far as such a value shows it.
    pub fn seen_apart(&self, predicted: f64, other: f64) -> f64 {
        if self.is_magnitude { predicted.abs() - other.abs() } else { self.turned(predicted - other) }
    }

    /// A difference of two such values; of angles the shorter way round.
    pub fn turned(&self, difference: f64) -> f64 {
        match self.kind {
            QuantityKind::Angle if self.is_line => without_sense(difference, 0.0),
            QuantityKind::Angle => with_turns(difference, 0.0),
            _ => difference,
        }
    }
}

/// Sizes of a hand's errors that are tried, in parts of the tolerance: from a blunt pencil to a drawing program.
pub(super) const SIZES: [f64; 13] = [4.0, 2.8, 2.0, 1.4, 1.0, 0.7, 0.5, 0.2, 0.05, 0.01, 2e-3, 2e-4, 1e-5];

/// Index in [`SIZES`] of the hand for which the tolerance is made.
pub(super) const CAREFUL: usize = 4;

/// Sizes of slips in computed numbers that are tried, in parts of [`SLIP`].
pub(super) const SLIPS: [f64; 3] = [0.0, 0.3, 1.0];

/// Limit of the relative errors of numbers computed carelessly, in per cent.
pub(super) const SLIP: f64 = 1.0;

/// Least size of a hand's errors, in parts of the tolerance; a drawing with smaller errors was not made by hand.
const BY_HAND: f64 = 0.04;

/// Cost of a hand whose errors of one kind are ten times smaller than the tolerance.
const BETTER: f64 = 1.2;

/// Cost of a hand whose errors are twice as large as the tolerance.
const WORSE: f64 = 9.0;

/// Cost of slips in computed numbers.
const SLIPPING: f64 = 6.0;

/// How accurate a hand is, and how it computes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hand {
    /// The size of its errors of each kind, in parts of the tolerance; of computed numbers, of [`SLIP`].
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
    /// A hand whose errors of drawing and measuring are all of one size, and that computes without slips.
    pub fn alike(size: f64) -> Hand {
        let mut errors = [size; GROUPS];
        errors[TOGETHER] = 0.0;
        errors[COMPUTING] = 0.0;
        Hand { errors, habit: Habit::Mixed }
    }

    /// A hand whose errors are all so many times as large.
    pub fn times(mut self, factor: f64) -> Hand {
        self.errors.iter_mut().for_each(|size| *size *= factor);
        self
    }

    /// The size of its largest errors of drawing and measuring, in parts of the tolerance.
    pub fn worst(&self) -> f64 {
        self.errors[..LEANING].iter().copied().fold(0.0, f64::max)
    }

    /// Whether its errors are as large as those of drawings by hand.
    pub fn is_by_hand(&self) -> bool {
        self.errors[..LEANING].iter().all(|&s| s == 0.0 || s >= BY_HAND)
    }

    /// Its cost, −2 ln of its prior probability. A kind of errors of size zero is left out: it is not a better hand.
    pub fn cost(&self) -> f64 {
        let sizes = self.errors[..LEANING].iter().filter(|s| **s > 0.0);
        let better: f64 = sizes.map(|s| -BETTER * libm::log10(s.min(1.0))).sum();
        let worse = WORSE * libm::log2(self.worst().max(1.0));
        let slipping = if self.errors[COMPUTING] > 0.0 { SLIPPING } else { 0.0 };
        better + worse + slipping
    }
}

/// Covariance matrices of the values: one for each kind of errors at the tolerance, and one for roundings of numbers
/// used later.
#[derive(Clone)]
pub(super) struct Covariances {
    pub groups: Groups,
    pub roundings: Vec<f64>,
    /// The covariance of amounts that are not known beforehand, whatever the hand; empty where there are none.
    pub free: Vec<f64>,
    /// By datum: whether later operations use it.
    pub used: Vec<bool>,
}

/// By kind of errors: the covariance matrix of the values at the tolerance; that of what leans is empty where nothing rubs.
pub(super) type Groups = [Vec<f64>; GROUPS];

/// Part of its rounding's variance that a value keeps for itself where later operations use it as written: the rounding
/// then acts through [`Covariances::roundings`].
const OWN_ROUNDING: f64 = 1e-4;

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
pub(super) type Variants = [(Changes, Vec<usize>)];

impl Covariances {
    /// The covariances of the values in drawings with these changes. `free`: amounts among them that were fitted to the
    /// values, each with its size. `groups`: those of the errors of hands, where they are known already.
    pub fn new(
        model: &Model,
        tolerance: &Tolerance,
        data: &[Datum],
        variants: &Variants,
        free: &[(Free, f64)],
        groups: Option<&Groups>,
    ) -> Covariances {
        let count = data.len();
        let mut effects = Effects::new(model, data, variants);
        let mut covariances = Covariances {
            groups: groups.cloned().unwrap_or_else(|| of_hands(&mut effects, tolerance)),
            roundings: vec![0.0; count * count],
            free: Vec::new(),
            used: vec![false; count],
        };
        for (number, rounding, datum) in written_numbers(model, data) {
            if !model.used[number.0] {
                continue;
            }
            let Some(operation) = model.makers[number.0] else { continue };
            if let Some(datum) = datum {
                covariances.used[datum] = true;
            }
            let change = |base: &Values| Change::Written(number, base.number(number) + rounding * DEVIATION);
            add_outer(&mut covariances.roundings, effects.of(operation, change, 1.0));
        }
        covariances.add_free(&mut effects, free);
        covariances
    }

    /// Adds the effects of amounts that are not known beforehand.
    fn add_free(&mut self, effects: &mut Effects<'_>, free: &[(Free, f64)]) {
        if free.is_empty() {
            return;
        }
        let count = effects.exact.len();
        self.free = vec![0.0; count * count];
        for (free, amount) in free {
            let step = NUDGE * free.range;
            let change = |_: &Values| match free.what {
                // Errors add up.
                Amount::Error(_) => free.change(step),
                Amount::Number(_) => free.change(amount + step),
            };
            add_outer(&mut self.free, effects.of(free.operation, change, 1.0 / NUDGE));
        }
    }

    /// Sets `into` to the covariance for a hand, and `own` to the part of each rounding's variance that stays with its
    /// value.
    pub fn sum(&self, hand: &Hand, into: &mut [f64], own: &mut [f64]) {
        match hand.habit {
            Habit::AllDigits => into.fill(0.0),
            Habit::Mixed | Habit::AsWritten => into.copy_from_slice(&self.roundings),
        }
        for (sum, part) in into.iter_mut().zip(&self.free) {
            *sum += part;
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

/// Standard deviation of an error that is equally likely up to its limit, in parts of the limit.
const DEVIATION: f64 = 0.577_350_269_189_625_8;

/// The covariances that the errors of hands cause, whatever digits are written.
fn of_hands(effects: &mut Effects<'_>, tolerance: &Tolerance) -> Groups {
    let (model, count) = (effects.model, effects.exact.len());
    let mut groups: Groups = core::array::from_fn(|kind| vec![0.0; if kind == LEANING { 0 } else { count * count }]);
    let mut plotted: Vec<Vec<f64>> = Vec::new();
    let friction = effects.friction();
    for (operation, which, limit, group) in model.errors(tolerance) {
        let change = |_: &Values| Change::Error(which, STEP * limit);
        let column = effects.of(operation, change, DEVIATION / STEP);
        let plot = match &friction {
            None => {
                add_outer(&mut groups[group], column);
                (group == PLOTTED).then(|| column.to_vec())
            }
            Some((rubbed, coming_round)) => {
                let own = column.to_vec();
                let [this, other] = coming_round.with(&own, &effects.pressing_off(rubbed, DEVIATION / STEP));
                add_outer(&mut groups[group], &this);
                add_outer(&mut groups[group], &other);
                (group == PLOTTED).then_some(this)
            }
        };
        plotted.extend(plot);
    }
    if let Some((rubbed, coming_round)) = &friction {
        for (joint, own) in rubbed.iter().enumerate() {
            let part = own.drawn(model.scales, tolerance) * DEVIATION;
            let column: Vec<f64> = coming_round.of_joint(joint).iter().map(|x| x * part).collect();
            groups[LEANING].resize(count * count, 0.0);
            add_outer(&mut groups[LEANING], &column);
        }
    }
    let mut column = vec![0.0; count];
    for motion in &model.together {
        column.fill(0.0);
        for (part, effect) in motion.iter().zip(&plotted) {
            for (sum, effect) in column.iter_mut().zip(effect) {
                *sum += part * effect;
            }
        }
        add_outer(&mut groups[TOGETHER], &column);
    }
    add_slips(&mut groups[COMPUTING], effects);
    groups
}

/// An error of a hand, and by how much its standard deviation at the tolerance changes the values.
pub(super) struct ErrorEffect {
    pub operation: usize,
    pub which: usize,
    /// Its standard deviation at the tolerance, in mm or degrees.
    pub deviation: f64,
    pub group: usize,
    pub column: Vec<f64>,
}

/// All errors of hands with their effects on drawings with these changes.
pub(super) fn effects_of_errors(
    model: &Model,
    tolerance: &Tolerance,
    data: &[Datum],
    variants: &Variants,
) -> Vec<ErrorEffect> {
    let mut effects = Effects::new(model, data, variants);
    let effect = |(operation, which, limit, group)| {
        let change = |_: &Values| Change::Error(which, STEP * limit);
        let column = effects.of(operation, change, DEVIATION / STEP).to_vec();
        ErrorEffect { operation, which, deviation: DEVIATION * limit, group, column }
    };
    model.errors(tolerance).into_iter().map(effect).collect()
}

/// Adds the effects of slips in computed numbers, and of those in turning millimetres into values.
fn add_slips(group: &mut [f64], effects: &mut Effects<'_>) {
    let model = effects.model;
    let size = 0.01 * SLIP * DEVIATION;
    for (operation, number) in model.computed() {
        let change = |_: &Values| Change::Times(number, 1.0 + size);
        add_outer(group, effects.of(operation, change, 1.0));
    }
    let count = effects.exact.len();
    for (index, datum) in effects.data.iter().enumerate() {
        if model.is_measured(datum.entry) && datum.kind != QuantityKind::Angle {
            let slip = size * effects.exact[index];
            group[index * count + index] += slip * slip;
        }
    }
}

/// Step of a difference quotient by a free amount, in parts of its range.
const NUDGE: f64 = 1e-3;

/// The effects of single changes on the values of a drawing.
struct Effects<'a> {
    model: &'a Model,
    data: &'a [Datum],
    variants: &'a Variants,
    bases: Vec<Values>,
    /// The values without a further change.
    exact: Vec<f64>,
    scratch: Values,
    column: Vec<f64>,
}

impl<'a> Effects<'a> {
    fn new(model: &'a Model, data: &'a [Datum], variants: &'a Variants) -> Effects<'a> {
        let bases: Vec<Values> = variants.iter().map(|(changes, _)| model.replay(changes)).collect();
        let mut exact = vec![0.0; data.len()];
        for ((_, which), base) in variants.iter().zip(&bases) {
            read(model, base, data, which, &mut exact);
        }
        let scratch = model.exact.clone();
        Effects { model, data, variants, bases, column: exact.clone(), exact, scratch }
    }

    /// The joints that rub, and how errors come round by their friction; none where nothing rubs.
    fn friction(&mut self) -> Option<(Vec<Rubbed>, ComingRound)> {
        let rubbed = self.model.construction.rubbed();
        if rubbed.is_empty() {
            return None;
        }
        let (mut of_values, mut of_pressing) = (Vec::new(), Vec::new());
        for own in &rubbed {
            let more = own.taken.iter().filter_map(|&number| {
                let operation = self.model.makers[number.0]?;
                Some(Disturbance { operation, change: Change::Times(number, 1.0 + NUDGE) })
            });
            let more: Vec<Disturbance> = more.collect();
            for (changes, which) in self.variants {
                self.scratch = self.model.replay(&in_order(changes.iter().chain(&more)));
                read(self.model, &self.scratch, self.data, which, &mut self.column);
            }
            self.less_exact(1.0 / NUDGE);
            of_values.push(self.column.clone());
            of_pressing.push(self.pressing_off(&rubbed, 1.0 / NUDGE));
        }
        let coming_round = ComingRound::new(&of_values, &of_pressing);
        Some((rubbed, coming_round))
    }

    /// The error of what presses in joints at the last change, in parts of it, times `factor`.
    fn pressing_off(&self, rubbed: &[Rubbed], factor: f64) -> Vec<f64> {
        let Some(base) = self.bases.last() else { return vec![0.0; rubbed.len()] };
        pressing_off(rubbed, &self.scratch, base).into_iter().map(|off| off * factor).collect()
    }

    /// The data that were read last less the exact ones, times `factor`.
    fn less_exact(&mut self, factor: f64) {
        for ((value, exact), datum) in self.column.iter_mut().zip(&self.exact).zip(self.data) {
            *value = datum.turned(*value - exact) * factor;
        }
    }

    /// By datum: the difference that a change of an operation makes, times `factor`.
    fn of(&mut self, operation: usize, change: impl Fn(&Values) -> Change, factor: f64) -> &[f64] {
        for ((changes, which), base) in self.variants.iter().zip(&self.bases) {
            self.model.replay_after(&mut self.scratch, base, operation, change(base), changes);
            read(self.model, &self.scratch, self.data, which, &mut self.column);
        }
        self.less_exact(factor);
        &self.column
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
        let same = data.iter().filter(|d| d.kind == sheet.facts().drawn);
        let finest = same.map(|d| d.rounding).fold(f64::INFINITY, f64::min);
        (number, if finest.is_finite() { finest } else { 0.0 }, None)
    });
    read.chain(sizes).collect()
}
