//! Mistakes with lengths and segments: the wrong one measured or taken.

use super::candidate::Candidate;
use super::mistake::Mistake;
use super::site::Site;
use crate::check::model::Edit;
use crate::construction::{Disturbance, End, MeasuredAs, NumberId, NumberKind, OperationKind, PlaceId, Sheet};

/// The candidate, with the right sign of the number measured: people take the sign from the sheets, not from the
/// measurement.
fn with_same_sense(site: &Site<'_>, mut candidate: Candidate, operation: usize, number: NumberId) -> Candidate {
    let change = candidate.edits[0].1.change();
    let values = site.model.replay(&[Disturbance { operation, change }]);
    if values.number(number) * site.model.exact.number(number) < 0.0 {
        candidate.edits.push((operation, Edit::Times(number, -1.0)));
    }
    candidate
}

/// The operations that measure a length: index, sheet, number, ends.
fn measures<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, Sheet, NumberId, [PlaceId; 2])> {
    site.operations().filter_map(|(index, operation)| match operation.kind {
        OperationKind::Measure { number, from, to, how: MeasuredAs::Along(_) | MeasuredAs::Size } => {
            Some((index, operation.sheet, number, [from, to]))
        }
        _ => None,
    })
}

pub(super) fn component(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, _, number, [from, to]) in measures(site) {
        for (how, axis) in [(MeasuredAs::X, "x"), (MeasuredAs::Y, "y")] {
            let edit = Edit::Instead(OperationKind::Measure { number, from, to, how });
            let blanks = [site.number_name(number), axis, site.place_name(from), site.place_name(to)];
            let candidate = site.candidate(Mistake::Component, index, edit, &blanks);
            found.push(with_same_sense(site, candidate, index, number));
        }
    }
    found
}

/// A segment of a plan measured from or to another point.
pub(super) fn wrong_segment(site: &Site<'_>) -> Vec<Candidate> {
    ends_elsewhere(site, Mistake::WrongSegment, |sheet| sheet != Sheet::Scheme)
}

fn ends_elsewhere(site: &Site<'_>, mistake: Mistake, is_meant: fn(Sheet) -> bool) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, sheet, number, [from, to]) in measures(site).filter(|measure| is_meant(measure.1)) {
        for other in site.model.places_before(sheet, index) {
            if [from, to].contains(&other) {
                continue;
            }
            for [from, to] in [[other, to], [from, other]] {
                let edit = Edit::Instead(OperationKind::Measure { number, from, to, how: MeasuredAs::Size });
                let blanks = [site.number_name(number), site.place_name(from), site.place_name(to)];
                let candidate = site.candidate(mistake, index, edit, &blanks);
                found.push(with_same_sense(site, candidate, index, number));
            }
        }
    }
    found
}

/// The ends of a number that is a length of the scheme; `None` for other numbers.
fn ends(site: &Site<'_>, number: NumberId) -> Option<[End; 2]> {
    match site.number_kind(number) {
        NumberKind::Length(ends) => Some(*ends),
        _ => None,
    }
}

/// A neighbouring length measured, or used in a vector's size.
pub(super) fn wrong_length(site: &Site<'_>) -> Vec<Candidate> {
    let mistake = Mistake::WrongLength;
    let mut found = ends_elsewhere(site, mistake, |sheet| sheet == Sheet::Scheme);
    let numbers = (0..site.model.makers.len()).map(NumberId);
    let lengths: Vec<(NumberId, [End; 2], usize)> =
        numbers.filter_map(|n| Some((n, ends(site, n)?, site.model.makers[n.0]?))).collect();
    for (operation, number, sum, _) in site.sums() {
        for (at, product) in sum.iter().enumerate() {
            let Some((right, own)) = product.of.last().and_then(|&n| Some((n, ends(site, n)?))) else {
                continue;
            };
            for &(wrong, [a, b], made) in &lengths {
                let is_neighbour = own.contains(&a) || own.contains(&b);
                if wrong == right || made >= operation || !is_neighbour {
                    continue;
                }
                let mut sum = sum.to_vec();
                if let Some(last) = sum[at].of.last_mut() {
                    *last = wrong;
                }
                // The sign comes from the scheme, not from the length.
                let exact = |n: NumberId| site.model.exact.number(n);
                sum[at].factor *= (exact(wrong) * exact(right)).signum();
                let edit = Edit::Instead(OperationKind::Compute { number, sum });
                let solution = site.key.solution;
                let [a, b] = [a, b].map(|end| solution.construction.end_name(&solution.mechanism, end));
                found.push(site.candidate(mistake, operation, edit, &[site.number_name(right), a, b]));
            }
        }
    }
    found
}
