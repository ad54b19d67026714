//! The values of a form with the quantities for which they stand: those that are written, and what given places tell.

use super::measured::{AnswerKey, CheckError, Given, Measured, Positive};
use super::names::{Meant, Names};
use super::placed;
use super::says;
use super::written::{Precision, factors, few_digits, is_by_ruler, number, rounding_to, whole_rounding};
use crate::quantity::QuantityRequest;
use crate::text;

/// A written value and the quantity it stands for.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The quantity, by the name that steps and results give it.
    pub asked: QuantityRequest,
    /// The name by which the form asks for it.
    pub row: String,
    /// Its digits as they were written; empty for a distance computed from places on paper.
    pub text: String,
    /// Its value in the scene's units and sign conventions.
    pub value: f64,
    /// Half a unit of the last digit, in the same unit.
    pub rounding: f64,
    /// How much farther off it may be, in the same unit, as the radii of its places say that are too large to count.
    pub doubt: f64,
    /// How finely values of its kind are written.
    pub precision: Precision,
    /// Whether it is a rate without a sign in a form that does not say which sense is positive: only its size is known.
    pub is_magnitude: bool,
    /// `value` over the written number: unit, scale on paper and sense of rotation.
    pub factor: f64,
    /// What `factor` would be if no unit had been written beside the number.
    pub factor_without_unit: f64,
    /// The unit that was written beside it.
    pub unit: Option<String>,
    /// Whether it is a length on paper.
    pub on_paper: bool,
    /// Scale of its sheet, in units of the scene per millimetre, where it is a length there; `None` for rates and
    /// angles.
    pub per_mm: Option<f64>,
    /// The number of the step that gives it.
    pub step: usize,
    /// The exact value.
    pub expected: f64,
}

/// Largest half unit of a last digit of a value that shows what it follows from, in parts of it: that of two digits, and of most written
/// to half a millimetre.
const FINE: f64 = 0.08;

impl Entry {
    /// Whether it has hardly more than one digit: nearly any mistake would explain it.
    pub(super) fn has_one_digit(&self) -> bool {
        !self.text.is_empty() && self.rounding > FINE * self.value.abs() && self.value != 0.0
    }
}

/// The values of a form with their quantities, in the order of the construction.
///
/// # Errors
/// All that is not understood: lines of the file, unknown quantities, wrong units, missing scales, contradictory
/// entries; or an empty form.
pub fn entries(measured: &Measured, key: &AnswerKey<'_>) -> Result<Vec<Entry>, CheckError> {
    let entries = entries_by(measured, key, &Names::new(key.solution))?;
    if entries.is_empty() { Err(is_empty()) } else { Ok(entries) }
}

/// Why a form without any value is not checked.
pub(super) fn is_empty() -> CheckError {
    CheckError::new(says::form_empty(), says::write_values())
}

/// The entries of a form by the names of the scene's quantities, which many forms have in common.
pub(super) fn entries_by(
    measured: &Measured,
    key: &AnswerKey<'_>,
    names: &Names<'_>,
) -> Result<Vec<Entry>, CheckError> {
    let mut faults = measured.all_faults()?;
    let reader = Reader::new(measured, key, names);
    let mut entries: Vec<Entry> = Vec::new();
    for given in &measured.values {
        let entry = match reader.entry(given) {
            Ok(entry) => entry,
            Err(fault) => {
                faults.push(fault.at(&given.place));
                continue;
            }
        };
        let same = |other: &&Entry| other.asked.name() == entry.asked.name();
        if let Some(other) = entries.iter().find(same) {
            let apart = (other.value - entry.value).abs();
            if apart > (other.rounding + entry.rounding) * 1.001 {
                let [one, two] = [&other.text, &entry.text].map(|text| text::shown(text));
                let message = says::two_values(text::shown(&given.name), one, two);
                faults.push(CheckError::new(message, says::keep_one()).at(&given.place));
            }
            continue;
        }
        entries.push(entry);
    }
    faults.extend(placed::add(&mut entries, measured, names).err());
    if let Some(error) = CheckError::all(faults) {
        return Err(error);
    }
    find_precisions(&mut entries);
    let place = |e: &Entry| names.order.get_index_of(e.asked.name());
    // An arm is measured before its step computes with it.
    entries.sort_by_key(|e| (e.step, !e.asked.is_arm(), place(e).unwrap_or(usize::MAX)));
    Ok(entries)
}

/// The values of a form that are not understood by themselves: their places among its values, each with why.
#[must_use]
pub fn faults(measured: &Measured, key: &AnswerKey<'_>) -> Vec<(usize, CheckError)> {
    let names = Names::new(key.solution);
    let reader = Reader::new(measured, key, &names);
    let fault = |(place, given): (usize, &Given)| Some((place, reader.entry(given).err()?));
    measured.values.iter().enumerate().filter_map(fault).collect()
}

/// Sets the precision and rounding of each entry from all values of its kind.
fn find_precisions(entries: &mut [Entry]) {
    let Precision { digits, .. } = Precision::of(entries.iter().map(|entry| entry.text.as_str()));
    let few = few_digits(entries.iter().map(|entry| entry.text.as_str()));
    // Of each kind an entry, and the precision of all.
    let mut known: Vec<(usize, Precision)> = Vec::new();
    for index in 0..entries.len() {
        let entry = &entries[index];
        if entry.text.is_empty() {
            continue;
        }
        let is_alike = |other: &&Entry| {
            other.asked.kind() == entry.asked.kind() && other.on_paper == entry.on_paper && other.unit == entry.unit
        };
        let precision = known.iter().find(|(first, _)| is_alike(&&entries[*first])).map(|(_, precision)| *precision);
        let precision = precision.unwrap_or_else(|| {
            let all = Precision::of(entries.iter().filter(is_alike).map(|e| e.text.as_str()));
            known.push((index, all));
            all
        });
        let entry = &mut entries[index];
        entry.precision = precision;
        let rounding = match few {
            Some(few) => precision.rounding(&entry.text).max(rounding_to(&entry.text, few)),
            None => precision.rounding(&entry.text).min(whole_rounding(&entry.text, digits)),
        };
        entry.rounding = rounding * entry.factor.abs();
    }
}

/// Reads the values of a form.
struct Reader<'a> {
    measured: &'a Measured,
    key: &'a AnswerKey<'a>,
    names: &'a Names<'a>,
    names_ground: bool,
}

impl<'a> Reader<'a> {
    fn new(measured: &'a Measured, key: &'a AnswerKey<'a>, names: &'a Names<'a>) -> Reader<'a> {
        Reader { measured, key, names, names_ground: measured.names_ground() }
    }

    fn entry(&self, given: &Given) -> Result<Entry, CheckError> {
        let (number, precision, rounding) = number(&given.text)?;
        let (name, marked) = given.plain_name();
        let Meant { asked, row, expected, step } = self.names.meant(&name, self.names_ground)?;
        let (kind, sheet) = (asked.kind(), asked.sheet());
        let has_length = asked.is_length_on_sheet();
        let on_paper = marked || (self.measured.in_mm && asked.is_distance() && is_by_ruler(given));
        if marked && !has_length {
            let hint = says::write_in(kind.unit(self.key.solution.scene.units));
            return Err(CheckError::new(says::no_length_on_paper(text::shown(&name)), hint));
        }
        let paper = on_paper.then_some((sheet, self.measured.mu[sheet]));
        let (factor, factor_without_unit) = factors(given, &name, kind, paper, self.key.solution.scene.units)?;
        let turns = asked.turns();
        let flips = turns && self.measured.positive == Some(Positive::Clockwise);
        let factor = if flips { -factor } else { factor };
        let signed = given.text.starts_with(['-', '+']);
        Ok(Entry {
            text: given.text.clone(),
            value: number * factor,
            rounding: rounding * factor.abs(),
            doubt: 0.0,
            precision,
            is_magnitude: asked.is_rate() && !signed && self.measured.positive.is_none(),
            factor,
            factor_without_unit: if flips { -factor_without_unit } else { factor_without_unit },
            unit: given.unit.clone(),
            on_paper,
            per_mm: if has_length { self.measured.mu.or(self.key.scales)[sheet] } else { None },
            step,
            expected,
            row,
            asked,
        })
    }
}
