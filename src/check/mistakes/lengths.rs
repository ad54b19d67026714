//! Mistakes with lengths and segments: the wrong one measured or taken.

use super::candidate::Candidate;
use super::site::Site;
use super::told::{Blank, Told, tell};
use crate::check::model::Edit;
use crate::construction::{Disturbance, MeasuredAs, NumberId, NumberKind, OperationKind, PlaceId};
use crate::sheet::Sheet;

/// The candidate, with the right sign of the number measured: people take the sign from the sheets, not from the
/// measurement.
pub(super) fn with_same_sense(
    site: &Site<'_>,
    mut candidate: Candidate,
    operation: usize,
    number: NumberId,
) -> Candidate {
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
        for (how, axis) in [(MeasuredAs::X, Blank::Horizontal), (MeasuredAs::Y, Blank::Vertical)] {
            let edit = Edit::Instead(OperationKind::Measure { number, from, to, how });
            let told = tell::component(site.quantity(number), axis, site.place(from), site.place(to));
            let candidate = site.candidate(told, index, edit);
            found.push(with_same_sense(site, candidate, index, number));
        }
    }
    found
}

/// A segment of a plan measured from or to another point.
pub(super) fn wrong_segment(site: &Site<'_>) -> Vec<Candidate> {
    let told = |number, from, to| tell::wrong_segment(site.quantity(number), from, to);
    ends_elsewhere(site, told, |sheet| sheet != Sheet::Scheme)
}

/// Measures from or to another place of a sheet that is meant, told by the number and the places.
fn ends_elsewhere(
    site: &Site<'_>,
    told: impl Fn(NumberId, Blank, Blank) -> Told,
    is_meant: fn(Sheet) -> bool,
) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, sheet, number, [from, to]) in measures(site).filter(|measure| is_meant(measure.1)) {
        for other in site.model.places_before(sheet, index) {
            if [from, to].contains(&other) {
                continue;
            }
            for [from, to] in [[other, to], [from, other]] {
                let edit = Edit::Instead(OperationKind::Measure { number, from, to, how: MeasuredAs::Size });
                let candidate = site.candidate(told(number, site.place(from), site.place(to)), index, edit);
                found.push(with_same_sense(site, candidate, index, number));
            }
        }
    }
    found
}

/// A length of the scheme, or one of a link that the construction does without.
#[derive(Clone, Copy)]
pub(super) struct Length<'s> {
    /// Its number, where the construction uses it.
    pub number: Option<NumberId>,
    /// Its size.
    pub exact: f64,
    /// The names of its ends.
    pub names: [&'s str; 2],
}

/// Most lengths among which any is taken for any other; of more only neighbours are.
const FEW: usize = 4;

/// The lengths of the scheme, then the links' other lengths.
pub(super) fn lengths<'s>(site: &'s Site<'_>) -> Vec<Length<'s>> {
    let solution = site.key.solution;
    let numbers = site.numbers_before(usize::MAX);
    let used = numbers.filter_map(|(number, kind)| match kind {
        NumberKind::Length(ends) => {
            let names = ends.map(|end| solution.construction.end_name(&solution.mechanism, end));
            Some(Length { number: Some(number), exact: site.model.exact.number(number).abs(), names })
        }
        _ => None,
    });
    let mut found: Vec<Length<'_>> = used.collect();
    for (_, link) in solution.mechanism.links() {
        for (at, &from) in link.points.iter().enumerate() {
            for &to in &link.points[at + 1..] {
                let names = [from, to].map(|point| solution.mechanism.point_name(point));
                let is_there = found.iter().any(|length| names.iter().all(|name| length.names.contains(name)));
                let exact = solution.pose.arm(from, to).norm();
                if !is_there && exact > 0.0 {
                    found.push(Length { number: None, exact, names });
                }
            }
        }
    }
    found
}

impl<'s> Length<'s> {
    /// The lengths that somebody takes for this one, with their ratios to it: those that share an end with it, and any
    /// where there are few.
    pub fn mistakable<'l>(&'l self, all: &'l [Length<'s>]) -> impl Iterator<Item = (&'l Length<'s>, f64)> {
        let is_near = |other: &Length<'_>| all.len() <= FEW || other.names.iter().any(|end| self.names.contains(end));
        let others = all.iter().filter(move |other| other.names != self.names && is_near(other));
        let ratios = others.map(|other| (other, other.exact / self.exact));
        ratios.filter(|(_, ratio)| ratio.is_finite() && *ratio > 0.0 && (ratio - 1.0).abs() > 1e-6)
    }

    /// The length taken `factor` times as large wherever it is used, from the first step that uses it on; `None` if it
    /// is measured, or never used.
    pub fn throughout(&self, site: &Site<'_>, told: Told, factor: f64) -> Option<Candidate> {
        let number = self.number.filter(|&number| site.is_given(number))?;
        let first = self.uses(site).next()?;
        let maker = site.model.makers[number.0]?;
        let mut candidate = site.candidate(told, maker, Edit::Times(number, factor));
        candidate.step = site.model.steps[first];
        Some(candidate)
    }

    /// The operations that use it.
    fn uses(&self, site: &Site<'_>) -> impl Iterator<Item = usize> {
        let uses = |kind: &OperationKind| {
            let mut found = false;
            kind.each_number_read(|number| found |= Some(number) == self.number);
            found
        };
        site.operations().filter(move |(_, operation)| uses(&operation.kind)).map(|(index, _)| index)
    }
}

/// A neighbouring length measured, or used in a vector's size, or used wherever the right one should be.
pub(super) fn wrong_length(site: &Site<'_>) -> Vec<Candidate> {
    let told = |number, from, to| tell::wrong_length(site.symbol(number), from, to);
    let mut found = ends_elsewhere(site, told, |sheet| sheet == Sheet::Scheme);
    let lengths = lengths(site);
    let used = || lengths.iter().filter_map(|length| Some((length, length.number?)));
    for (operation, number, sum, _) in site.sums() {
        for (at, product) in sum.iter().enumerate() {
            let Some((right, own)) = used().find(|(_, own)| product.of.last() == Some(own)) else {
                continue;
            };
            for (wrong, ratio) in right.mistakable(&lengths) {
                let mut sum = sum.to_vec();
                sum[at] = product.times(ratio);
                let edit = Edit::Instead(OperationKind::Compute { number, sum });
                let [from, to] = wrong.names.map(Blank::from);
                found.push(site.candidate(told(own, from, to), operation, edit));
            }
        }
    }
    for (right, own) in used().filter(|(length, _)| length.uses(site).count() > 1) {
        for (wrong, ratio) in right.mistakable(&lengths) {
            let [from, to] = wrong.names.map(Blank::from);
            let told = tell::wrong_length_throughout(site.symbol(own), from, to);
            found.extend(right.throughout(site, told, ratio));
        }
    }
    found
}
