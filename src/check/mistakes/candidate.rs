use super::told::{Mistake, Told};
use crate::check::datum::Datum;
use crate::check::model::Edit;
use crate::construction::{Change, NumberId};

/// A mistake at one place of a construction.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// The mistake, and what is told of it: candidates with the same sentences are one to a person.
    pub told: Told,
    /// The number of the step at which it was made.
    pub step: usize,
    /// The edits it makes, each with the index of the operation.
    pub(in crate::check) edits: Vec<(usize, Edit)>,
    /// The written values that it makes to be read otherwise.
    pub(in crate::check) reinterpreted: Vec<Reinterpretation>,
    /// Wrong numbers that later operations use: the operation that makes each, the number, its value.
    pub(in crate::check) goes_on: Vec<(usize, NumberId, f64)>,
    /// What of it is not known beforehand but fitted to the values; the edits at these places have the fitted amounts.
    pub(in crate::check) free: Vec<Free>,
    /// The assembly mode that is replayed: 0 for the right one, then the others.
    pub(in crate::check) mode: usize,
}

impl Candidate {
    /// A mistake at a step, without anything that it changes.
    pub(super) fn at(told: Told, step: usize) -> Candidate {
        Candidate {
            told,
            step,
            edits: Vec::new(),
            reinterpreted: Vec::new(),
            goes_on: Vec::new(),
            free: Vec::new(),
            mode: 0,
        }
    }

    /// Which mistake.
    #[must_use]
    pub fn mistake(&self) -> Mistake {
        self.told.mistake
    }

    /// The operations that it changes.
    pub(in crate::check) fn operations(&self) -> impl Iterator<Item = usize> {
        self.edits.iter().map(|(operation, _)| *operation).chain(self.free.iter().map(|free| free.operation))
    }
}

/// An amount by which an operation is wrong and which is not known beforehand.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) struct Free {
    /// The operation.
    pub operation: usize,
    /// What of it is wrong.
    pub what: Amount,
    /// Whether it is an angle in degrees.
    pub is_angle: bool,
    /// Standard deviation of the amounts that occur: mm, degrees, or the unit of the number.
    pub range: f64,
}

/// What is wrong by a free amount.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) enum Amount {
    /// An elementary error of the operation, by its index.
    Error(usize),
    /// A number that the operation makes.
    Number(NumberId),
}

impl Free {
    /// The change of a replay in which the amount is this one.
    pub fn change(&self, amount: f64) -> Change<'static> {
        match self.what {
            Amount::Error(which) => Change::Error(which, amount),
            Amount::Number(number) => Change::Written(number, amount),
        }
    }

    /// The edit with this amount.
    pub fn edit(&self, amount: f64) -> (usize, Edit) {
        let edit = match self.what {
            Amount::Error(which) => Edit::Error(which, amount),
            Amount::Number(number) => Edit::Becomes(number, amount),
        };
        (self.operation, edit)
    }
}

/// The value that is meant by a written one, if a mistake was made.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) struct Reinterpretation {
    pub entry: usize,
    /// The value meant; `None` where the written one tells nothing about it.
    pub value: Option<f64>,
    /// Half a unit of its last digit.
    pub rounding: f64,
}

impl Reinterpretation {
    /// The datum with the value meant; `None` where the written one tells nothing about it.
    pub fn read(&self, written: &Datum) -> Option<Datum> {
        self.value.map(|value| Datum { value, rounding: self.rounding.max(f64::MIN_POSITIVE), ..*written })
    }
}
