//! The numbers that a field knows: the right one, and those that a known mistake gives.

use crate::exercise::KeyValue;
use crate::words::Wording;

/// A number that a field knows, with what it earns.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The number, in the field's unit.
    pub value: f64,
    /// By how much a written number may differ from it.
    pub tolerance: f64,
    /// The part of the marks, in per cent.
    pub percent: u8,
    /// What is said of it; nothing of the right one.
    pub said: Option<String>,
}

/// The part of the marks, in per cent, for a rate of the right size with the wrong sense, and for a value that follows from an earlier mistake.
pub const PART: u8 = 50;

/// Least share, of all mistakes that give about the same number, of one that is named: as the check tells a cause.
const TOLD: f64 = 0.6;

/// How many times as large as the largest of its unit a number may be to be expected at all: no paper holds it.
const GROWN: f64 = 100.0;

/// What part of the largest number of its unit is nothing but rounding: whoever does not know may write 0, so it earns nothing.
const NOTHING: f64 = 1e-9;

/// Significant digits that are asked for.
const DIGITS: i32 = 3;

/// Most wrong numbers that a field knows: Moodle reads a field with one regular expression, whose work grows with its length.
const MOST: usize = 8;

/// A number that a known mistake gives in place of the right one.
#[derive(Clone, Debug)]
pub(super) struct Wrong {
    pub value: f64,
    /// How common the mistake is at its place.
    pub share: f64,
    /// What the check says of it.
    pub told: String,
    /// Whether it was made at an earlier step than the value's.
    pub is_earlier: bool,
}

impl Answer {
    /// Whether a number can be within the tolerances of both.
    fn overlaps(&self, other: &Answer) -> bool {
        (self.value - other.value).abs() <= self.tolerance + other.tolerance
    }
}

/// The answers of a field: the right number, for a size also with a minus; for a rate the other sense; then the commonest of the numbers that
/// known mistakes give and nothing else does. `largest` is the largest number of the unit, `is_size` whether a sign says nothing.
///
/// A tolerance is that of a careful hand and half a unit of the last digit that is asked for; that of a wrong number, which has grown, has grown
/// with it. Numbers that overlap a better one are left out, and those that other mistakes give, too, unless one is clearly the commonest.
pub(super) fn answers(right: &KeyValue, largest: f64, is_size: bool, wrong: &[Wrong], words: &Wording) -> Vec<Answer> {
    let allowed = right.allowed.unwrap_or(0.0);
    let answer = |value: f64, percent, said| {
        let grown = if right.value == 0.0 { 1.0 } else { (value / right.value).abs().max(1.0) };
        Answer { value, tolerance: grown * allowed + half_digit(value, largest), percent, said }
    };
    let mut answers = vec![answer(right.value, 100, None)];
    let other = match is_size {
        true => answer(-right.value, 100, None),
        false => answer(-right.value, PART, Some(words.language.course_other_sense().to_owned())),
    };
    if right.value != 0.0 && (is_size || !other.overlaps(&answers[0])) {
        answers.push(other);
    }
    let expected = wrong.iter().filter(|wrong| (NOTHING * largest..=GROWN * largest).contains(&wrong.value.abs()));
    let known = |wrong: &Wrong| {
        let cause = words.language.course_cause(&wrong.told);
        let (part, said) = match wrong.is_earlier {
            true => (PART, format!("{cause} {}", words.language.course_follows())),
            false => (0, cause),
        };
        (wrong.share, answer(wrong.value, part, Some(said)))
    };
    let wrong: Vec<(f64, Answer)> = expected.map(known).collect();
    let is_sure = |own: &Answer| {
        let near = || wrong.iter().filter(|(_, other)| other.overlaps(own));
        let all: f64 = near().map(|(share, _)| share).sum();
        let alike: f64 = near().filter(|(_, other)| other.said == own.said).map(|(share, _)| share).sum();
        answers.iter().all(|better| !better.overlaps(own)) && alike >= TOLD * all
    };
    let mut sure: Vec<&(f64, Answer)> = wrong.iter().filter(|(_, own)| is_sure(own)).collect();
    sure.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut known: Vec<Answer> = Vec::new();
    for (_, own) in sure {
        if known.len() < MOST && known.iter().all(|other| !other.overlaps(own)) {
            known.push(own.clone());
        }
    }
    answers.extend(known);
    answers
}

/// Half a unit of the last significant digit that is asked for; of nearly nothing beside the largest number of its unit that of a thousandth of it.
fn half_digit(value: f64, largest: f64) -> f64 {
    let size = value.abs().max(1e-3 * largest).max(f64::MIN_POSITIVE);
    0.5 * libm::exp10(libm::floor(libm::log10(size)) - f64::from(DIGITS - 1))
}
