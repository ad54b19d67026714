//! What is wrong by an amount that no mistake of the catalogue gives, at any place of the construction, and is used in what
//! follows.

use super::site::{Amount, Candidate, Free, Site};
use super::told::{Blank, tell};
use crate::construction::{NumberId, Operation, OperationKind};
use crate::sheet::{PerSheet, Sheet};
use smallvec::{SmallVec, smallvec};

/// Range of the angles by which lines and vectors are wrong, in degrees.
const TURN: f64 = 60.0;

/// Every vector laid off, in its size or its direction, every line in its direction, every point that is marked, and
/// every number that later operations use. The amounts are fitted to the values later.
pub(super) fn everywhere(site: &Site<'_>) -> Vec<Candidate> {
    let extents = PerSheet::from_fn(|sheet| extent(site, sheet));
    let mut found = Vec::new();
    for (index, operation) in site.operations() {
        for amounts in amounts(site, operation) {
            let free = |&what: &Amount| {
                let turns = matches!(operation.kind, OperationKind::Draw { .. } | OperationKind::LayOff { .. });
                let is_angle = turns && matches!(what, Amount::Error(0));
                let range = match what {
                    Amount::Number(number) => number_range(site, number),
                    Amount::Error(_) if is_angle => TURN,
                    Amount::Error(_) => extents[operation.sheet],
                };
                let is_measured = matches!(operation.kind, OperationKind::Measure { .. });
                Free {
                    operation: index,
                    what,
                    is_angle,
                    range,
                    keeps_sign: is_measured && operation.sheet == Sheet::Centers,
                }
            };
            let free: Vec<Free> = amounts.iter().map(free).collect();
            // The name of the first value that is wrong follows; until then each place has a name of its own.
            let place = format!("{index} {:?}", free.iter().map(|f| f.what).collect::<Vec<_>>());
            let told = tell::unknown(Blank::Words(place));
            found.push(Candidate { free, ..Candidate::at(told, site.model.steps[index]) });
        }
    }
    found
}

/// What can be wrong in an operation: each time one amount, or two where a point is marked.
fn amounts(site: &Site<'_>, operation: &Operation) -> SmallVec<[SmallVec<[Amount; 2]>; 4]> {
    let is_used = |number: &&NumberId| site.model.used[number.0];
    match &operation.kind {
        OperationKind::Plot { .. } | OperationKind::Cross { .. } => {
            smallvec![smallvec![Amount::Error(0), Amount::Error(1)]]
        }
        OperationKind::Draw { .. } | OperationKind::Divide { .. } => smallvec![smallvec![Amount::Error(0)]],
        OperationKind::LayOff { size, .. } => {
            let is_computed = site.model.sizes.iter().any(|(number, _)| number == size);
            let direction = smallvec![Amount::Error(0)];
            // Both amounts: the vector ends anywhere.
            let both = smallvec![Amount::Error(0), Amount::Error(1)];
            // The computation has the wrong size otherwise.
            let size = smallvec![Amount::Error(1)];
            if is_computed { smallvec![direction, both] } else { smallvec![direction, both, size] }
        }
        OperationKind::Measure { .. }
        | OperationKind::ReadDirection { .. }
        | OperationKind::Compute { .. }
        | OperationKind::Solve { .. } => {
            let numbers = operation.kind.numbers().iter().filter(is_used);
            numbers.map(|&number| smallvec![Amount::Number(number)]).collect()
        }
        // The last two are mistakes already.
        OperationKind::Pole { .. }
        | OperationKind::Join { .. }
        | OperationKind::Take { .. }
        | OperationKind::Meet { .. }
        | OperationKind::OnLine { .. } => SmallVec::new(),
    }
}

/// The range of a number that is wrong: its own size, or a part of the largest of its sheet where it is small.
fn number_range(site: &Site<'_>, number: NumberId) -> f64 {
    let exact = |n: usize| site.exact(NumberId(n)).abs();
    let kind = core::mem::discriminant(site.number_kind(number));
    let sheet = |n: usize| site.model.makers[n].map(|maker| site.operation(maker).sheet);
    let same = (0..site.model.makers.len())
        .filter(|&n| sheet(n) == sheet(number.0) && core::mem::discriminant(site.number_kind(NumberId(n))) == kind);
    let largest = same.map(exact).filter(|x| x.is_finite()).fold(0.0, f64::max);
    exact(number.0).max(0.1 * largest).max(f64::MIN_POSITIVE)
}

/// The largest distance of a point of a sheet from its first one, in mm of paper.
fn extent(site: &Site<'_>, sheet: Sheet) -> f64 {
    let places = site.operations().filter(|(_, operation)| operation.sheet == sheet);
    let places = places.filter_map(|(_, operation)| Some(site.model.exact.place(operation.kind.place()?)));
    let places: Vec<_> = places.filter(|place| place.iter().all(|x| x.is_finite())).collect();
    let largest = places.iter().map(|place| (place - places[0]).norm()).fold(0.0, f64::max);
    (largest / site.model.scales[sheet]).max(1.0)
}
