//! Values as they are written in a form's cells: numbers, how finely people write them, and the units beside them.

use super::measured::{CheckError, Given};
use super::says;
use super::units::factor;
use crate::message::Message;
use crate::scene::{LengthUnit, Units};
use crate::sheet::{QuantityKind, Sheet};
use crate::text::shown;
use crate::words::sheet_told;

/// The decimals and the significant digits to which somebody writes values of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Precision {
    /// Digits after the decimal point.
    pub decimals: i32,
    /// Significant digits: all from the first that is not zero.
    pub digits: i32,
}

impl Precision {
    /// The precision of written numbers of one kind. Files drop zeros at the end, so the longest numbers show it; but a
    /// single number with more decimals than all others does not count: its point may have slipped.
    pub fn of<'t>(texts: impl Iterator<Item = &'t str>) -> Precision {
        let plain = texts.filter(|t| !t.is_empty() && !t.contains(['e', 'E']));
        let (mut decimals, digits): (Vec<i32>, Vec<i32>) = plain.map(counts).unzip();
        decimals.sort_unstable_by(|a, b| b.cmp(a));
        let common = usize::from(decimals.len() > 2);
        Precision {
            decimals: decimals.get(common).copied().unwrap_or(0),
            digits: digits.into_iter().max().unwrap_or(0),
        }
    }

    /// Half a unit of the last digit of a number written to this precision, dropped zeros included.
    pub fn rounding(self, text: &str) -> f64 {
        let unit = |decimals: i32| 0.5 * libm::exp10(-f64::from(decimals));
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, ""));
        if let Ok(exponent) = exponent.parse::<i32>() {
            return unit(counts(mantissa).0 - exponent);
        }
        let value: f64 = text.parse().unwrap_or(0.0);
        let mut usual = unit(self.decimals);
        if value != 0.0 {
            let first = libm::floor(libm::log10(value.abs())) as i32;
            usual = usual.max(unit(self.digits - 1 - first));
        }
        usual.min(unit(counts(text).0))
    }
}

/// Most significant digits that a short whole number is taken to have.
const WHOLE: i32 = 3;

/// Half a unit of the last digit of a whole number with fewer digits than others of its form have, which are at most
/// `digits`: `3` beside `8.36` is 3.00 of which the zeros were dropped, not any number from 2.5 to 3.5. Infinite for
/// numbers that say their digits.
pub fn whole_rounding(text: &str, digits: i32) -> f64 {
    let value: f64 = text.parse().unwrap_or(0.0);
    if text.contains(['.', 'e', 'E']) || value == 0.0 {
        return f64::INFINITY;
    }
    half_unit(value, digits.min(WHOLE))
}

/// Most significant digits that a form may have in all its numbers for the zeros at their ends to be no digits.
const FEW: i32 = 2;

/// To how many significant digits all numbers of a form are written, where they are so few that `40` beside `0.4` and `3`
/// is any number from 35 to 45; `None` where more digits are written, or too few numbers to see it.
pub fn few_digits<'t>(texts: impl Iterator<Item = &'t str>) -> Option<i32> {
    let digits = texts.filter(|text| text.contains(|c: char| ('1'..='9').contains(&c))).map(|text| {
        let mantissa = text.split(['e', 'E']).next().unwrap_or("");
        let counted = counts(mantissa.trim_end_matches('0')).1;
        if mantissa.contains('.') { counts(mantissa).1 } else { counted }
    });
    let digits: Vec<i32> = digits.collect();
    let most = *digits.iter().max()?;
    (digits.len() > 2 && most <= FEW).then_some(most)
}

/// Half a unit of the last of so many significant digits of a written number.
pub fn rounding_to(text: &str, digits: i32) -> f64 {
    half_unit(text.parse().unwrap_or(0.0), digits)
}

/// The same of a number; 0 of zero.
pub(super) fn half_unit(value: f64, digits: i32) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let first = libm::floor(libm::log10(value.abs())) as i32;
    0.5 * libm::exp10(f64::from(first + 1 - digits))
}

/// Decimals and significant digits of a number as it is written.
fn counts(text: &str) -> (i32, i32) {
    let decimals = text.split_once('.').map_or(0, |(_, d)| d.len());
    let digits = text.chars().filter(char::is_ascii_digit).skip_while(|c| *c == '0').count();
    (decimals as i32, digits as i32)
}

/// A value as it stands in a cell; its unit may stand in a place of its own or behind its digits.
pub(super) fn given(name: String, cell: &str, unit: Option<String>, place: Message) -> Given {
    let (text, unit) = if unit.is_some() { (with_point(cell), unit) } else { with_unit(cell) };
    Given { name, text, unit, place }
}

/// A number with a decimal point in place of a comma, and a plain minus; any other text only with a plain minus.
pub(super) fn with_point(text: &str) -> String {
    let text = text.replace('−', "-");
    let is_number = text.chars().all(|c| c.is_ascii_digit() || matches!(c, ',' | '+' | '-' | 'e' | 'E'));
    let commas = text.matches(',').count();
    if is_number && commas == 1 { text.replace(',', ".") } else { text }
}

/// The number in a form's cell with a decimal point, and the unit behind it where one stands in the same cell, as `6,6 m/s`.
pub(super) fn with_unit(text: &str) -> (String, Option<String>) {
    let whole = with_point(text);
    if whole.parse::<f64>().is_ok() {
        return (whole, None);
    }
    // The longest number before a letter, what is behind the last digit of an exponent; or before `1/min`.
    let number = |at: usize| with_point(text[..at].trim());
    let begins = |at: usize, c: char| c.is_alphabetic() || matches!(c, '°' | 'º') || text[at..].starts_with(" 1/");
    let units = text.char_indices().take(LONGEST).filter(|(at, c)| begins(*at, *c));
    match units.map(|(at, _)| at).filter(|at| number(*at).parse::<f64>().is_ok()).last() {
        Some(at) => (number(at), Some(text[at..].trim().to_owned())),
        None => (whole, None),
    }
}

/// Most characters of a number with a unit behind it: whoever writes more has written something else.
const LONGEST: usize = 60;

/// The number in a form's cell, its precision as it stands alone, and half a unit of its last digit.
pub(super) fn number(text: &str) -> Result<(f64, Precision, f64), CheckError> {
    let precision = Precision::of(core::iter::once(text));
    let rounding = precision.rounding(text);
    // Rust reads the words NaN and infinity as numbers too.
    let has_digits = text.contains(|c: char| c.is_ascii_digit());
    let number = if has_digits { text.parse::<f64>().ok() } else { None };
    let number = number.ok_or_else(|| CheckError::new(says::no_number(shown(text)), says::write_digits()))?;
    if !(number.is_finite() && number.abs() <= 1e100) {
        return Err(CheckError::new(says::too_large(shown(text)), says::wrong_digit()));
    }
    Ok((number, precision, rounding))
}

/// Millimetres of a unit in which people measure on paper.
fn on_ruler(unit: &str) -> Option<f64> {
    let ruler = [LengthUnit::Mm, LengthUnit::Cm, LengthUnit::In].into_iter().find(|own| own.as_str() == unit.trim())?;
    Some(ruler.metres() / LengthUnit::Mm.metres())
}

/// Whether a distance of a form in millimetres of paper is one itself: a unit that no ruler has makes it a value.
pub(super) fn is_by_ruler(given: &Given) -> bool {
    given.unit.as_ref().is_none_or(|unit| on_ruler(unit).is_some())
}

/// The factor from a written number to the scene's units, and the factor if the unit beside it were left out. `paper`: the
/// sheet on which it was measured in millimetres, if it was, with the scale that the form has for it.
pub(super) fn factors(
    given: &Given,
    name: &str,
    kind: QuantityKind,
    paper: Option<(Sheet, Option<f64>)>,
    units: Units,
) -> Result<(f64, f64), CheckError> {
    let Some((sheet, scale)) = paper else {
        let factor = given.unit.as_ref().map_or(Ok(1.0), |unit| factor(unit, kind, units))?;
        return Ok((factor, 1.0));
    };
    let scale = scale.ok_or_else(|| {
        let mu = sheet.facts().scale_key;
        let hint = says::add_scale(mu, kind.unit(units), sheet_told(sheet));
        CheckError::new(says::paper_without_scale(shown(name), mu), hint)
    })?;
    match given.unit.as_deref().map(|unit| (unit, on_ruler(unit))) {
        None => Ok((scale, scale)),
        Some((_, Some(mm))) => Ok((scale * mm, scale)),
        Some((unit, None)) => Err(CheckError::new(says::unit_on_paper(shown(name), shown(unit)), says::unit_or_mu())),
    }
}
