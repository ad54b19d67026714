//! The catalogue of mistakes, each replayed alone, for whoever compares single operations with it.

use super::measured::AnswerKey;
use super::mistakes::{Candidate, Site};
use super::model::{Model, in_order};
use super::prepared::SEARCHED;
use crate::construction::{Change, LineId, OperationKind, PlaceId, Solution};
use crate::geometry::Vector;
use crate::sheet::{PerSheet, Sheet};

/// A construction with the mistakes of the catalogue that can be made in it, and what each makes otherwise.
pub(crate) struct Replayed<'a> {
    solution: &'a Solution,
    model: Model,
    candidates: Vec<(Candidate, Vec<Touched>)>,
}

/// What a mistake makes at the operation where it is made, or at the next one that uses its result.
#[derive(Clone, Debug)]
pub(crate) enum Touched {
    /// A line: its sheet, a place of it, its direction.
    Line(Sheet, Vector, Vector),
    /// A point.
    Place {
        /// Which.
        place: PlaceId,
        /// Where it comes to lie.
        at: Vector,
        /// Of a vector, where that begins.
        start: Option<Vector>,
        /// Where it lies without the mistake.
        right: Vector,
        /// Of a vector, where that begins without the mistake.
        right_start: Vector,
        /// Whether it is where lines cross.
        is_crossing: bool,
        /// Whether it is made at the operation where the mistake is.
        is_edited: bool,
    },
    /// A number.
    Number {
        /// Its name.
        name: String,
        /// Its value.
        value: f64,
        /// Whether it comes from a segment that was measured wrongly.
        is_measured: bool,
    },
}

impl<'a> Replayed<'a> {
    /// The mistakes that can be made in a construction; `None` where it cannot be gone through, or nobody draws so much by hand.
    pub fn new(solution: &'a Solution, scales: PerSheet<f64>) -> Option<Replayed<'a>> {
        if solution.construction.operations.len() > SEARCHED {
            return None;
        }
        let key = AnswerKey::new(solution, None);
        let model = Model::new(&key, solution, scales.map(Some), &[]).ok()?;
        let site = Site { model: &model, key: &key, entries: &[], tolerances: &[], other_modes: 0 };
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

    /// The sheet of a place that has a name.
    pub fn sheet_of(&self, place: PlaceId) -> Option<Sheet> {
        let mut named = self.model.construction.named_places();
        named.find(|(_, _, other)| *other == place).map(|(sheet, ..)| sheet)
    }
}

fn touched(model: &Model, candidate: &Candidate) -> Vec<Touched> {
    let changes = in_order(candidate.changes());
    if changes.is_empty() || !candidate.free.is_empty() {
        return Vec::new();
    }
    let values = model.replay(&changes);
    let operations = &model.construction.operations;
    let is_measured =
        changes.iter().any(|change| matches!(operations[change.operation].kind, OperationKind::Measure { .. }));
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
            let starts = |kind: &OperationKind| match kind {
                OperationKind::LayOff { from, .. } => Some(*from),
                _ => None,
            };
            touched.push(Touched::Place {
                place,
                at: values.place(place),
                start: starts(kind).map(|from| values.place(from)),
                right: model.exact.place(place),
                right_start: starts(&operation.kind).map_or(Vector::zeros(), |from| model.exact.place(from)),
                is_crossing: matches!(operation.kind, OperationKind::Cross { .. }),
                is_edited: changes.iter().any(|change| change.operation == index),
            });
        }
        for number in kind.numbers() {
            let name = model.number_names[number.0].clone();
            let is_measured = is_measured && matches!(kind, OperationKind::Solve { .. });
            touched.push(Touched::Number { name, value: values.number(*number), is_measured });
        }
    };
    for change in &changes {
        see(change.operation);
        let (made, line) = (operations[change.operation].kind.numbers(), operations[change.operation].kind.line());
        for (index, operation) in operations.iter().enumerate().skip(change.operation + 1) {
            // The vector that is laid off with a wrong size, the rate that is found from a wrong segment, the crossing of a wrong line.
            let mut reads = false;
            operation.kind.each_number_read(|read| reads |= made.contains(&read));
            if reads || line.is_some_and(|line| crosses(&operation.kind, line)) {
                see(index);
                // What is laid off in a polygon has its size computed, with its sign, in between.
                if let (Sheet::Forces, OperationKind::Compute { number, .. }) = (operation.sheet, &operation.kind) {
                    let laid =
                        |kind: &OperationKind| matches!(kind, OperationKind::LayOff { size, .. } if size == number);
                    let mut later = operations.iter().enumerate().skip(index + 1);
                    later.by_ref().filter(|(_, own)| laid(&own.kind)).for_each(|(later, _)| see(later));
                }
            }
        }
    }
    touched
}

fn crosses(kind: &OperationKind, line: LineId) -> bool {
    matches!(kind, OperationKind::Cross { lines, .. } if lines.contains(&line))
}
