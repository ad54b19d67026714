//! What a mistake teaches: its step worked out with the student's own numbers, by how much what was drawn is off, and what is to be done
//! again.

use super::entry::Entry;
use super::mistakes::{Amount, Candidate, Mistake};
use super::model::{Model, in_order};
use crate::construction::{Change, Disturbance, LineId, NumberId, OperationKind, PlaceId, Product, Values};
use crate::geometry::{Vector, degrees_of, with_turns};
use crate::sheet::{QuantityKind, Sheet};
use std::collections::BTreeSet;

/// What a mistake teaches.
#[derive(Clone, Debug, Default)]
pub(super) struct Lesson {
    /// The number of its step from those that the student has.
    pub worked: Option<Worked>,
    /// By how much what was drawn is off, where no cause is known.
    pub off: Option<Off>,
    /// The numbers of the steps whose results it changes, where that is known.
    pub redo: Option<Vec<usize>>,
}

/// A number worked out: a sum of products, over a product or 1.
#[derive(Clone, Debug)]
pub(super) struct Worked {
    /// The name of what is computed, where it has one.
    pub name: Option<String>,
    pub sum: Vec<Factors>,
    pub over: Option<Factors>,
    pub result: f64,
    pub kind: QuantityKind,
    /// What the student has in its place.
    pub own: Option<f64>,
}

/// The factors of a product: a constant, and numbers by the names of their quantities.
#[derive(Clone, Debug)]
pub(super) struct Factors {
    pub constant: f64,
    pub of: Vec<(String, f64)>,
}

/// By how much what was drawn is off.
#[derive(Clone, Debug)]
pub(super) enum Off {
    /// A line or a vector turned, in degrees, positive counter-clockwise.
    Turned(f64),
    /// A vector too long, in mm.
    Longer(f64),
    /// A point elsewhere, in mm; the places through which its two lines go, with the angles between these and where it lies, in degrees.
    Elsewhere(f64, Vec<(String, f64)>),
}

/// What a mistake teaches beside others that were made.
pub(super) fn lesson(model: &Model, entries: &[Entry], candidate: &Candidate, others: &[&Candidate]) -> Lesson {
    let changes = |all: &mut dyn Iterator<Item = &Candidate>| {
        let all: Vec<Disturbance> = all.flat_map(|c| c.changes().cloned()).collect();
        model.replay(&in_order(all.iter()))
    };
    let before = changes(&mut others.iter().copied());
    let behind = changes(&mut others.iter().copied().chain([candidate]));
    // What no name tells cannot be worked out before a student.
    let is_named = |worked: &Worked| {
        let factors = worked.sum.iter().chain(&worked.over);
        factors.flat_map(|factors| &factors.of).all(|(name, _)| !name.is_empty())
    };
    Lesson {
        worked: candidate.edits.first().and_then(|edit| worked(model, entries, edit.operation)).filter(is_named),
        off: (candidate.mistake() == Mistake::Unknown).then(|| off(model, candidate, &before)).flatten(),
        redo: Some(redo(model, [&before, &behind], candidate)),
    }
}

/// What a wrong value teaches whose cause is not known. `is_alone`: whether nothing else is off.
pub(super) fn of_value(model: &Model, entries: &[Entry], entry: usize, is_alone: bool) -> Lesson {
    let maker = model.readings[entry].ok().and_then(|reading| model.makers[reading.number.0]);
    let worked = maker.and_then(|maker| worked(model, entries, maker));
    // What the student's own numbers give was computed rightly.
    let is_other =
        |worked: &Worked| worked.own.is_some_and(|own| (own - worked.result).abs() > COMPUTED * worked.result.abs());
    Lesson { worked: worked.filter(is_other), off: None, redo: is_alone.then(Vec::new) }
}

/// Difference of a number from what others give, in parts of it, up to which it was computed from them.
const COMPUTED: f64 = 0.02;

/// The number that an operation makes, or that gives its vector its size, from the numbers that the student has.
fn worked(model: &Model, entries: &[Entry], operation: usize) -> Option<Worked> {
    let operations = &model.construction.operations;
    let own = |number: NumberId| {
        let reads = |index: &usize| model.readings[*index].is_ok_and(|reading| reading.number == number);
        (0..entries.len()).find(reads).map(|index| entries[index].value)
    };
    // Lengths and given rates are those of the scene; what the student has not written is not told.
    let is_of_scene = |number: NumberId| {
        let maker = model.makers[number.0].map(|maker| &operations[maker]);
        maker.is_none_or(|maker| maker.sheet == Sheet::Scheme || matches!(maker.kind, OperationKind::Take { .. }))
    };
    let value = |number: NumberId| {
        own(number).or_else(|| is_of_scene(number).then(|| model.exact.number(number))).map(f64::abs)
    };
    let factors = |product: &Product| {
        let of = product.of.iter().map(|&number| Some((model.number_names[number.0].clone(), value(number)?)));
        Some(Factors { constant: product.factor.abs(), of: of.collect::<Option<Vec<_>>>()? })
    };
    let maker = match operations[operation].kind {
        OperationKind::LayOff { size, .. } => model.makers[size.0]?,
        _ => operation,
    };
    match &operations[maker].kind {
        // Of several terms the signs are those of directions, which no number shows.
        OperationKind::Compute { number, sum } if sum.len() == 1 => {
            let sum: Vec<Factors> = sum.iter().map(factors).collect::<Option<_>>()?;
            let laid = operations.iter().find_map(|laid| match laid.kind {
                OperationKind::LayOff { place, from, size, .. } if size == *number => Some([from, place]),
                _ => None,
            });
            let measured = laid.and_then(|[start, end]| {
                let name = operations[maker].sheet.segment_name(model.place_name(start), model.place_name(end));
                entries.iter().find(|entry| entry.asked.name() == name)
            });
            let result = total(&sum);
            let kind = operations[maker].sheet.facts().drawn;
            Some(Worked { name: None, sum, over: None, result, kind, own: measured.map(|entry| entry.value.abs()) })
        }
        OperationKind::Solve { unknowns, equations } => {
            // One that stands alone in its equation; of several the first that is off.
            let alone =
                equations.iter().filter_map(|equation| match (equation.left.as_slice(), equation.right.as_slice()) {
                    ([(unknown, left)], [right]) if !left.of.is_empty() => Some((unknowns[*unknown], left, right)),
                    _ => None,
                });
            let is_off = |number: NumberId| {
                let entry = (0..entries.len()).find(|&i| model.readings[i].is_ok_and(|r| r.number == number));
                entry.is_some_and(|i| (entries[i].value - entries[i].expected).abs() > 0.01 * entries[i].expected.abs())
            };
            let (rate, left, right) = alone.into_iter().find(|(number, ..)| is_off(*number))?;
            let (sum, over) = (vec![factors(right)?], factors(left)?);
            let result = total(&sum) / total(core::slice::from_ref(&over));
            let entry = (0..entries.len()).find(|&i| model.readings[i].is_ok_and(|r| r.number == rate))?;
            let name = Some(model.number_names[rate.0].clone());
            let kind = entries[entry].asked.kind();
            Some(Worked { name, sum, over: Some(over), result, kind, own: own(rate).map(f64::abs) })
        }
        _ => None,
    }
}

fn total(sum: &[Factors]) -> f64 {
    sum.iter().map(|product| product.constant * product.of.iter().map(|(_, value)| value).product::<f64>()).sum()
}

/// By how much what an operation has drawn is off. `right`: the drawing without it.
fn off(model: &Model, candidate: &Candidate, right: &Values) -> Option<Off> {
    let amount = |which: usize| {
        let edits = candidate.edits.iter().filter_map(|edit| match edit.change {
            Change::Error(error, amount) if error == which => Some(amount),
            _ => None,
        });
        edits.sum::<f64>()
    };
    let free = candidate.free.first()?;
    if let Amount::Number(_) = free.what {
        return None;
    }
    let operation = &model.construction.operations[free.operation];
    match operation.kind {
        OperationKind::Draw { .. } => Some(Off::Turned(amount(0))),
        OperationKind::LayOff { .. } if free.is_angle && candidate.free.len() == 1 => Some(Off::Turned(amount(0))),
        OperationKind::LayOff { .. } if candidate.free.len() == 1 => Some(Off::Longer(amount(1))),
        OperationKind::Cross { place, lines } => {
            let by = Vector::new(amount(0), amount(1));
            let own = right.place(place) + by * model.scales[operation.sheet];
            let seen = lines.into_iter().filter_map(|line| seen(model, right, line, own)).collect();
            Some(Off::Elsewhere(by.norm(), seen))
        }
        OperationKind::Divide { .. } => Some(Off::Longer(amount(0))),
        _ => None,
    }
}

/// The name of the place through which a ray goes, and the angle from the ray to a point as seen from there, in degrees.
fn seen(model: &Model, right: &Values, line: LineId, point: Vector) -> Option<(String, f64)> {
    let through = model.construction.operations.iter().find_map(|operation| match operation.kind {
        OperationKind::Draw { line: own, through, .. } if own == line => Some(through),
        OperationKind::Join { line: own, from, .. } if own == line => Some(from),
        _ => None,
    })?;
    let name = model.place_name(through);
    let towards = point - right.place(through);
    if name.is_empty() || towards == Vector::zeros() {
        return None;
    }
    let angle = with_turns(degrees_of(towards) - degrees_of(right.line(line).1), 0.0);
    // A line has no sense.
    let angle = if angle.abs() > 90.0 { angle - 180.0 * angle.signum() } else { angle };
    Some((name.to_owned(), angle))
}

/// The steps whose results two drawings have elsewhere, and that of the mistake, in their order.
fn redo(model: &Model, [before, behind]: [&Values; 2], candidate: &Candidate) -> Vec<usize> {
    let apart = |a: f64, b: f64| (a - b).abs() > 1e-9 * (a.abs() + b.abs());
    let moved = |PlaceId(place): PlaceId| {
        (before.place(PlaceId(place)) - behind.place(PlaceId(place))).norm()
            > 1e-9 * before.place(PlaceId(place)).norm()
    };
    let is_changed = |kind: &OperationKind| {
        let line = |line: LineId| {
            let [(a, u), (b, v)] = [before.line(line), behind.line(line)];
            (a - b).norm() > 1e-9 * a.norm() || (u - v).norm() > 1e-9
        };
        kind.place().is_some_and(moved)
            || kind.line().is_some_and(line)
            || kind.numbers().iter().any(|&number| apart(before.number(number), behind.number(number)))
    };
    let operations = model.construction.operations.iter().zip(&model.steps);
    let changed = operations.filter(|(operation, _)| is_changed(&operation.kind)).map(|(_, &step)| step);
    let own = (!candidate.edits.is_empty()).then_some(candidate.step);
    let all: BTreeSet<usize> = changed.chain(own).filter(|&step| step >= candidate.step.max(1)).collect();
    all.into_iter().collect()
}
