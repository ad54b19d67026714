//! The catalogue of mistakes, each replayed alone, for whoever compares single operations with it.

use super::measured::AnswerKey;
use super::mistakes::{Candidate, Site};
use super::model::{Model, in_order};
use crate::construction::{Change, OperationKind, PlaceId, Solution};
use crate::geometry::Vector;
use crate::sheet::{PerSheet, Sheet};

/// A construction with the mistakes of the catalogue that can be made in it, and what each makes otherwise.
pub(crate) struct Replayed<'a> {
    solution: &'a Solution,
    model: Model,
    candidates: Vec<(Candidate, Vec<Touched>)>,
}

/// What a mistake makes at the operation where it is made, or at the next one that uses its number.
#[derive(Clone, Debug)]
pub(crate) enum Touched {
    /// A line: its sheet, a place of it, its direction.
    Line(Sheet, Vector, Vector),
    /// A point, where it comes to lie, and of a vector where that begins.
    Place(PlaceId, Vector, Option<Vector>),
    /// A number with its name.
    Number(String, f64),
}

impl<'a> Replayed<'a> {
    /// The mistakes that can be made in a construction; `None` where it cannot be gone through.
    pub fn new(solution: &'a Solution, scales: PerSheet<f64>) -> Option<Replayed<'a>> {
        let key = AnswerKey::new(solution, None);
        let model = Model::new(&key, solution, scales.map(Some), &[]).ok()?;
        let site = Site { model: &model, key: &key, entries: &[], other_modes: 0 };
        let candidates = site.candidates();
        let touched: Vec<Vec<Touched>> = candidates.iter().map(|candidate| touched(&model, candidate)).collect();
        let candidates = candidates.into_iter().zip(touched).filter(|(_, touched)| !touched.is_empty()).collect();
        Some(Replayed { solution, model, candidates })
    }

    /// The mistakes, each with what it makes otherwise.
    pub fn candidates(&self) -> impl Iterator<Item = (&Candidate, &[Touched])> {
        self.candidates.iter().map(|(candidate, touched)| (candidate, touched.as_slice()))
    }

    /// Whether a place has this name.
    pub fn is_called(&self, place: PlaceId, sheet: Sheet, name: &str) -> bool {
        let construction = &self.model.construction;
        let name = self.solution.construction.plan_name(sheet, name);
        construction.named_places().any(|(on, own, other)| other == place && on == sheet && own == name)
    }
}

fn touched(model: &Model, candidate: &Candidate) -> Vec<Touched> {
    let changes = in_order(candidate.changes());
    if changes.is_empty() || !candidate.free.is_empty() {
        return Vec::new();
    }
    let values = model.replay(&changes);
    let operations = &model.construction.operations;
    let mut touched = Vec::new();
    let mut see = |index: usize| {
        let operation = &operations[index];
        let replaced = changes.iter().find_map(|change| match &change.change {
            Change::Instead(kind) if change.operation == index => Some(&**kind),
            _ => None,
        });
        let kind = replaced.unwrap_or(&operation.kind);
        if let Some(line) = kind.line() {
            let (at, along) = values.line(line);
            touched.push(Touched::Line(operation.sheet, at, along));
        }
        if let Some(place) = kind.place() {
            let start = match kind {
                OperationKind::LayOff { from, .. } => Some(values.place(*from)),
                _ => None,
            };
            touched.push(Touched::Place(place, values.place(place), start));
        }
        for number in kind.numbers() {
            touched.push(Touched::Number(model.number_names[number.0].clone(), values.number(*number)));
        }
    };
    for change in &changes {
        see(change.operation);
        // The vector that is laid off with a wrong size, the rate that is found from a wrong segment.
        for number in operations[change.operation].kind.numbers() {
            for (index, operation) in operations.iter().enumerate().skip(change.operation + 1) {
                let mut reads = false;
                operation.kind.each_number_read(|read| reads |= read == *number);
                if reads {
                    see(index);
                }
            }
        }
    }
    touched
}
