use super::mistake::Mistake;
use crate::check::datum::Datum;
use crate::check::model::Edit;
use crate::construction::NumberId;

/// A mistake at one place of a construction.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Which mistake.
    pub mistake: Mistake,
    /// The number of the step at which it was made.
    pub step: usize,
    /// What the sentences about it name, in their order.
    pub blanks: Vec<String>,
    /// What is done otherwise, by operation.
    pub(in crate::check) edits: Vec<(usize, Edit)>,
    /// What written values are read as.
    pub(in crate::check) reinterpreted: Vec<Reinterpretation>,
    /// Numbers with which the person goes on as they were written: operation, number, value.
    pub(in crate::check) goes_on: Vec<(usize, NumberId, f64)>,
    /// Which construction is replayed: 0 for the right position, then those of other assembly modes.
    pub(in crate::check) mode: usize,
}

impl Candidate {
    /// Whether both are told in the same words.
    pub(in crate::check) fn is_told_like(&self, other: &Candidate) -> bool {
        self.mistake == other.mistake && self.blanks == other.blanks
    }
}

/// What a written value stands for in a mistake.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) struct Reinterpretation {
    pub entry: usize,
    /// The value meant; none where the written one says nothing.
    pub value: Option<f64>,
    /// Half a unit of its last digit.
    pub rounding: f64,
}

impl Reinterpretation {
    /// The value as it is meant; none where the written one says nothing.
    pub fn read(&self, written: &Datum) -> Option<Datum> {
        self.value.map(|value| Datum { value, rounding: self.rounding.max(f64::MIN_POSITIVE), ..*written })
    }
}
