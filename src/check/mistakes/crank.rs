//! Mistakes with a crank, whose motion the scene gives: its length in all products, its direction in both plans.

use super::candidate::Candidate;
use super::lengths::{Length, lengths};
use super::site::{Laid, Site};
use super::told::{Blank, Told, tell};
use crate::construction::{Along, Product, ProductKind};
use crate::geometry::{Vector, turn_of_degrees};

/// Whether a product is of a given rate with an arm of its link.
fn is_of_crank(site: &Site<'_>, product: &Product) -> bool {
    let turns = matches!(product.kind, ProductKind::Turning | ProductKind::Normal);
    turns && product.of.first().is_some_and(|&rate| site.is_given(rate))
}

/// The lengths of the links whose rates are given.
fn crank_lengths<'s>(site: &'s Site<'_>) -> Vec<Length<'s>> {
    let sums = site.sums();
    let products = || sums.iter().flat_map(|(_, _, sum, _)| sum.iter()).filter(|product| is_of_crank(site, product));
    let is_its = |length: &Length<'_>| products().any(|product| product.of.last().copied() == length.number);
    lengths(site).into_iter().filter(|length| length.number.is_some()).filter(is_its).collect()
}

/// A crank's length taken `factor` times as long in all its products.
fn of_other_length(site: &Site<'_>, tell: fn(Blank) -> Told, factor: f64) -> Vec<Candidate> {
    let lengths = crank_lengths(site).into_iter();
    let all = lengths.filter_map(|length| {
        let told = tell(site.symbol(length.number?));
        length.throughout(site, told, factor)
    });
    all.collect()
}

/// The crank's diameter, or a slider-crank's stroke, in all products.
pub(super) fn diameter(site: &Site<'_>) -> Vec<Candidate> {
    of_other_length(site, tell::diameter_throughout, 2.0)
}

pub(super) fn half_the_radius(site: &Site<'_>) -> Vec<Candidate> {
    of_other_length(site, tell::half_the_radius, 0.5)
}

/// Angles by which a protractor is commonly misread, in degrees.
const MISREAD: [f64; 8] = [10.0, -10.0, 20.0, -20.0, 30.0, -30.0, 90.0, -90.0];

/// The vectors of a crank's point in both plans, all turned by one angle.
pub(super) fn turned(site: &Site<'_>) -> Vec<Candidate> {
    let vectors = site.vectors();
    let of_crank: Vec<&Laid<'_>> =
        vectors.iter().filter(|vector| vector.sum.iter().any(|product| is_of_crank(site, product))).collect();
    let mut found = Vec::new();
    for (place, first) in of_crank.iter().enumerate() {
        // From the first of one point's vectors on.
        let same = |vector: &&&Laid<'_>| vector.ends[1] == first.ends[1];
        if of_crank[..place].iter().any(|vector| same(&vector)) {
            continue;
        }
        let all: Vec<&&Laid<'_>> = of_crank.iter().filter(same).collect();
        if all.len() < 2 {
            continue;
        }
        for degrees in MISREAD {
            let edit = |vector: &Laid<'_>| {
                let sense = site.model.exact.number(vector.size).signum();
                let direction = turned_by(vector.direction(site) * sense, degrees);
                (vector.operation, vector.turned(Along::given(direction)))
            };
            let [from, to] = first.blanks();
            let (operation, own) = edit(first);
            let told = tell::turned_vectors(from, to, Blank::Number(degrees.abs().to_string()));
            let mut candidate = site.candidate(told, operation, own);
            candidate.edits.extend(all[1..].iter().map(|vector| edit(vector)));
            found.push(candidate);
        }
    }
    found
}

fn turned_by(vector: Vector, degrees: f64) -> Vector {
    let turn = turn_of_degrees(degrees);
    Vector::new(turn.re * vector.x - turn.im * vector.y, turn.im * vector.x + turn.re * vector.y)
}
