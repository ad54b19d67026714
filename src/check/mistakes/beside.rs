//! What follows where a point is marked beside the lines on which it should lie.

use super::site::{Candidate, instead, times};
use crate::check::model::{Model, in_order};
use crate::construction::{Along, Disturbance, MeasuredAs, NumberId, OperationKind, PlaceId, Values};
use crate::geometry::unit;

/// A candidate that puts a point beside the lines along which distances to it are measured: these are distances then. Whether it lies between the two
/// places from which they are measured people see by their ends, or along the line; where both differ there are two candidates.
pub(in crate::check) fn measured_there(model: &Model, candidate: Candidate, place: PlaceId) -> Vec<Candidate> {
    let drawn = model.replay(&in_order(candidate.edits.iter()));
    let measured: Vec<Distance> = distances(model, &drawn, place).collect();
    let edits = measured.iter().flat_map(Distance::edits);
    let along = Candidate { edits: candidate.edits.into_iter().chain(edits).collect(), ..candidate };
    let mut found = vec![along];
    if let [first, second] = measured.as_slice() {
        let arm = |from: PlaceId| drawn.place(place) - drawn.place(from);
        let is_between = arm(first.from).dot(&arm(second.from)) < 0.0;
        if is_between != (first.sense * second.sense < 0.0) {
            let mut other = found[0].clone();
            other.edits.push(times(second.operation, second.number, -1.0));
            found.push(other);
        }
    }
    found
}

/// A distance that is measured along a line.
struct Distance {
    operation: usize,
    number: NumberId,
    from: PlaceId,
    to: PlaceId,
    /// The sign that it has along the line.
    sense: f64,
}

impl Distance {
    fn edits(&self) -> [Disturbance; 2] {
        let &Distance { operation, number, from, to, sense } = self;
        let kind = OperationKind::Measure { number, from, to, how: MeasuredAs::Size };
        [instead(operation, kind), times(operation, number, sense)]
    }
}

/// The distances to a place that are measured along lines.
fn distances<'m>(model: &'m Model, drawn: &'m Values, place: PlaceId) -> impl Iterator<Item = Distance> + 'm {
    model.construction.operations.iter().enumerate().filter_map(move |(operation, done)| match done.kind {
        OperationKind::Measure { number, from, to, how: MeasuredAs::Along(line) } if to == place => {
            let sense = (drawn.place(to) - drawn.place(from)).dot(&drawn.line(line).1).signum();
            Some(Distance { operation, number, from, to, sense })
        }
        _ => None,
    })
}

/// The same mistake by somebody who does not use the wrong place for further lines, as he finds the next points on lines of his own choice; `None` where no line runs
/// through the place.
pub(super) fn not_gone_on_with(model: &Model, candidate: &Candidate, place: PlaceId) -> Option<Candidate> {
    let exact = &model.exact;
    let right = |operation: usize, line, other: PlaceId| {
        let along = unit(exact.line(line).1).map(Along::given)?;
        Some(instead(operation, OperationKind::Draw { line, through: other, along }))
    };
    let mut edits = candidate.edits.clone();
    for (index, operation) in model.construction.operations.iter().enumerate() {
        match operation.kind {
            OperationKind::Join { line, from, towards } if from == place => edits.push(right(index, line, towards)?),
            OperationKind::Join { line, from, towards } if towards == place => edits.push(right(index, line, from)?),
            OperationKind::Draw { through, .. } if through == place => return None,
            _ => {}
        }
    }
    (edits.len() > candidate.edits.len()).then(|| Candidate { edits, ..candidate.clone() })
}
