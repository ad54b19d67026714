//! Mistakes with lengths and segments: the wrong one measured or taken.

use super::candidate::Candidate;
use super::mistake::Mistake;
use super::site::Site;
use crate::check::model::Edit;
use crate::construction::{Disturbance, End, MeasuredAs, NumberId, NumberKind, OperationKind, PlaceId, Product, Sheet};

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

/// A length of the scheme.
#[derive(Clone, Copy)]
pub(super) struct Length<'s> {
    pub number: NumberId,
    /// The operation that gives it.
    maker: usize,
    ends: [End; 2],
    /// The names of its ends.
    pub names: [&'s str; 2],
}

/// Most lengths of a construction among which any is taken for any other; of more only neighbours are.
const FEW: usize = 4;

/// The lengths of the scheme.
pub(super) fn lengths<'s>(site: &'s Site<'_>) -> Vec<Length<'s>> {
    let solution = site.key.solution;
    let numbers = site.numbers_before(usize::MAX);
    let all = numbers.filter_map(|(number, kind)| match kind {
        NumberKind::Length(ends) => {
            let names = ends.map(|end| solution.construction.end_name(&solution.mechanism, end));
            Some(Length { number, maker: site.model.makers[number.0]?, ends: *ends, names })
        }
        _ => None,
    });
    all.collect()
}

impl<'s> Length<'s> {
    pub fn exact(&self, site: &Site<'_>) -> f64 {
        site.model.exact.number(self.number)
    }

    /// The lengths that somebody takes for this one: those that share an end with it, and any where there are few.
    pub fn mistakable<'l>(&'l self, all: &'l [Length<'s>]) -> impl Iterator<Item = &'l Length<'s>> {
        let is_near = |other: &Length<'_>| all.len() <= FEW || other.ends.iter().any(|end| self.ends.contains(end));
        all.iter().filter(move |other| other.number != self.number && is_near(other))
    }

    /// The length taken `factor` times as large wherever it is used, from the first step that uses it on; `None` if it
    /// is measured, or never used.
    pub fn throughout(&self, site: &Site<'_>, mistake: Mistake, factor: f64, blanks: &[&str]) -> Option<Candidate> {
        let is_given = matches!(site.operation(self.maker).kind, OperationKind::Take { .. });
        let first = self.uses(site).next().filter(|_| is_given && factor.is_finite())?;
        let mut candidate = site.candidate(mistake, self.maker, Edit::Times(self.number, factor), blanks);
        candidate.step = site.model.steps[first];
        Some(candidate)
    }

    /// The operations that use it.
    fn uses(&self, site: &Site<'_>) -> impl Iterator<Item = usize> {
        let uses = |kind: &OperationKind| {
            let mut found = false;
            kind.each_number_read(|number| found |= number == self.number);
            found
        };
        site.operations().filter(move |(_, operation)| uses(&operation.kind)).map(|(index, _)| index)
    }
}

/// The product with another length in place of its last factor. The sign comes from the scheme, not from the length.
pub(super) fn with_length(site: &Site<'_>, product: &Product, wrong: NumberId) -> Product {
    let mut product = product.clone();
    if let Some(last) = product.of.last_mut() {
        product.factor *= (site.model.exact.number(*last) * site.model.exact.number(wrong)).signum();
        *last = wrong;
    }
    product
}

/// A neighbouring length measured, or used in a vector's size, or used wherever the right one should be.
pub(super) fn wrong_length(site: &Site<'_>) -> Vec<Candidate> {
    let mistake = Mistake::WrongLength;
    let mut found = ends_elsewhere(site, mistake, |sheet| sheet == Sheet::Scheme);
    let lengths = lengths(site);
    for (operation, number, sum, _) in site.sums() {
        for (at, product) in sum.iter().enumerate() {
            let Some(right) = lengths.iter().find(|length| product.of.last() == Some(&length.number)) else {
                continue;
            };
            for wrong in right.mistakable(&lengths).filter(|wrong| wrong.maker < operation) {
                let mut sum = sum.to_vec();
                sum[at] = with_length(site, product, wrong.number);
                let edit = Edit::Instead(OperationKind::Compute { number, sum });
                let [a, b] = wrong.names;
                found.push(site.candidate(mistake, operation, edit, &[site.number_name(right.number), a, b]));
            }
        }
    }
    for right in lengths.iter().filter(|length| length.uses(site).count() > 1) {
        for wrong in right.mistakable(&lengths) {
            let [a, b] = wrong.names;
            let factor = (wrong.exact(site) / right.exact(site)).abs();
            let blanks = [site.number_name(right.number), a, b, "throughout"];
            found.extend(right.throughout(site, mistake, factor, &blanks));
        }
    }
    found
}
