//! What all lengths that somebody has measured have in common: they are too large or too small by one factor, as on a sheet that was
//! printed to fit its page, or longer or shorter by one amount, as where a ruler was not read from zero. It is found before values are
//! judged and taken out of them: what was drawn may be right all the same.

use super::entry::Entry;
use super::model::Model;
use crate::quantity::Band;
use crate::sheet::PerSheet;
use serde::Serialize;

/// An error that all measured lengths have in common.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "CommonErrorResult"))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum CommonError {
    /// They are so many times as large as they should be, less one: 0.031 is 3.1 % too large.
    Scale(f64),
    /// They are so many millimetres of paper too long.
    Zero(f64),
}

/// Factors, less one, that are told: less is a hand's own, more is another scale.
const FACTORS: [f64; 2] = [0.008, 0.12];

/// Amounts that are told, in mm.
const AMOUNTS: [f64; 2] = [0.8, 12.0];

/// Least number of lengths on a sheet that shows it, and of such sheets.
const ENOUGH: [usize; 2] = [3, 2];

/// Largest part of the squares of the errors that may remain without it.
const REMAINS: f64 = 0.1;

/// Largest difference of what single sheets show from what all do, as a part of it.
const APART: f64 = 0.35;

/// A length on paper: its error and its right size, in mm, and the weight of its error.
#[derive(Clone, Copy)]
struct Length {
    off: f64,
    size: f64,
    weight: f64,
}

/// Of which part of a length an error is a multiple: of the length itself, or of one millimetre.
type Part = fn(&Length) -> f64;

impl CommonError {
    /// The error that all measured lengths have in common, if they are many and agree in it.
    pub(super) fn of(entries: &[Entry], model: &Model, bands: &[Option<Band>]) -> Option<CommonError> {
        let mut sheets: PerSheet<Vec<Length>> = PerSheet::default();
        for (index, entry) in measured(entries, model) {
            let (Some(mu), Some(band)) = (entry.per_mm, bands[index]) else { continue };
            let [value, expected] = [entry.value, entry.expected].map(|x| x.abs() / mu);
            let own = (band.band.max(entry.rounding) / mu).max(f64::MIN_POSITIVE);
            let length = Length { off: value - expected, size: expected, weight: 1.0 / (own * own) };
            sheets[entry.asked.sheet()].push(length);
        }
        let [lengths, least] = ENOUGH;
        let groups: Vec<&Vec<Length>> = sheets.iter().map(|(_, all)| all).filter(|all| all.len() >= lengths).collect();
        if groups.len() < least {
            return None;
        }
        let all: Vec<Length> = groups.iter().flat_map(|group| group.iter().copied()).collect();
        let told = |part: Part, [least, most]: [f64; 2]| {
            let common = fitted(&all, part)?;
            let is_told = (least..=most).contains(&common.abs()) && remains(&all, part, common) <= REMAINS;
            let agrees = |group: &&Vec<Length>| {
                fitted(group, part).is_some_and(|own| (own - common).abs() <= APART * common.abs())
            };
            (is_told && groups.iter().all(agrees)).then_some(common)
        };
        let by_factor: Part = |length| length.size;
        let by_amount: Part = |_| 1.0;
        let (scale, zero) = (told(by_factor, FACTORS), told(by_amount, AMOUNTS));
        match (scale, zero) {
            // Lengths that are nearly equal may agree in both.
            (Some(scale), Some(zero)) if remains(&all, by_amount, zero) < remains(&all, by_factor, scale) => {
                Some(CommonError::Zero(zero))
            }
            (Some(scale), _) => Some(CommonError::Scale(scale)),
            (None, zero) => zero.map(CommonError::Zero),
        }
    }

    /// Takes the error out of all measured lengths.
    pub(super) fn take_out(self, entries: &mut [Entry], model: &Model) {
        let which: Vec<usize> = measured(entries, model).map(|(index, _)| index).collect();
        for index in which {
            let entry = &mut entries[index];
            let Some(mu) = entry.per_mm else { continue };
            match self {
                CommonError::Scale(scale) => entry.value /= 1.0 + scale,
                CommonError::Zero(mm) => entry.value -= mm * mu * entry.value.signum(),
            }
        }
    }
}

/// The lengths that are measured on a sheet.
fn measured<'e>(entries: &'e [Entry], model: &'e Model) -> impl Iterator<Item = (usize, &'e Entry)> {
    let all = entries.iter().enumerate();
    all.filter(|(index, entry)| entry.asked.is_length_on_sheet() && (entry.on_paper || model.is_measured(*index)))
}

/// The multiple of a part that lengths are off by, by weighted least squares.
fn fitted(lengths: &[Length], part: Part) -> Option<f64> {
    let sum = |of: &dyn Fn(&Length) -> f64| lengths.iter().map(|length| length.weight * of(length)).sum::<f64>();
    let fitted = sum(&|length| length.off * part(length)) / sum(&|length| part(length) * part(length));
    fitted.is_finite().then_some(fitted)
}

/// Which part of the squares of the errors remains without this multiple.
fn remains(lengths: &[Length], part: Part, multiple: f64) -> f64 {
    let squares = |multiple: f64| -> f64 {
        lengths.iter().map(|length| length.weight * (length.off - multiple * part(length)).powi(2)).sum()
    };
    squares(multiple) / squares(0.0)
}
