use super::candidate::Candidate;
use super::mistake::Mistake;
use crate::check::answer_key::AnswerKey;
use crate::check::entry::Entry;
use crate::check::model::{Edit, Model};
use crate::construction::{NumberId, NumberKind, Operation, OperationKind, PlaceId, Product};

/// A construction in which mistakes are looked for.
pub(in crate::check) struct Site<'a> {
    pub model: &'a Model,
    pub key: &'a AnswerKey<'a>,
    pub entries: &'a [Entry],
    /// Number of other assembly modes.
    pub other_modes: usize,
}

impl Site<'_> {
    pub fn operations(&self) -> impl Iterator<Item = (usize, &Operation)> {
        self.model.construction.operations.iter().enumerate()
    }

    pub fn operation(&self, index: usize) -> &Operation {
        &self.model.construction.operations[index]
    }

    pub fn candidate(&self, mistake: Mistake, operation: usize, edit: Edit, blanks: &[&str]) -> Candidate {
        Candidate {
            mistake,
            step: self.model.steps[operation],
            blanks: blanks.iter().map(|b| (*b).to_owned()).collect(),
            edits: vec![(operation, edit)],
            reinterpreted: Vec::new(),
            goes_on: Vec::new(),
            free: Vec::new(),
            mode: 0,
        }
    }

    pub fn number_name(&self, number: NumberId) -> &str {
        &self.model.number_names[number.0]
    }

    pub fn number_kind(&self, number: NumberId) -> &NumberKind {
        &self.model.construction.numbers[number.0]
    }

    pub fn place_name(&self, place: PlaceId) -> &str {
        self.model.place_name(place)
    }

    /// The sums from which vectors' sizes are computed: the operation, the number it makes, the sum, the names of the
    /// vector's ends.
    pub fn sums(&self) -> Vec<(usize, NumberId, &[Product], [&str; 2])> {
        let laid = self.operations().filter_map(|(_, operation)| match &operation.kind {
            OperationKind::LayOff { place, from, size, .. } => {
                let maker = self.model.makers[size.0]?;
                match &self.operation(maker).kind {
                    OperationKind::Compute { number, sum } => {
                        Some((maker, *number, sum.as_slice(), [self.place_name(*from), self.place_name(*place)]))
                    }
                    _ => None,
                }
            }
            _ => None,
        });
        // A vector that is laid off only to be read has no name at its end.
        laid.filter(|(.., ends)| !ends[1].is_empty()).collect()
    }
}
