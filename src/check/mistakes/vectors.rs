//! Mistakes with vectors that are laid off: a wrong sense, a wrong size, a part forgotten or added.

use super::candidate::Candidate;
use super::site::{Laid, Site};
use super::told::{Blank, Told, tell};
use crate::check::model::Edit;
use crate::construction::{
    Along, NumberId, NumberKind, OperationKind, PlaceId, Product, ProductKind, Rate, image_name,
};
use crate::geometry::quarter_turn;
use crate::sheet::Sheet;

/// The reversed vectors that have no name of their own: a normal part alone is laid off outward, a Coriolis
/// acceleration alone is turned the wrong way, and the velocity of a crank has the wrong sense of its ω.
pub(super) fn reversed(site: &Site<'_>) -> Vec<Candidate> {
    let vectors = site.vectors().into_iter().filter(|vector| {
        let of_crank = || vector.sum.iter().all(|product| product.of.first().is_some_and(|&rate| site.is_given(rate)));
        let is_crank = vector.is_only(ProductKind::Turning) && vector.sheet == Sheet::Velocity && of_crank();
        !(vector.is_only(ProductKind::Normal) || vector.is_only(ProductKind::Coriolis) || is_crank)
    });
    let laid = vectors.map(|vector| {
        let edit = vector.turned(vector.along.turned(2));
        let [start, end] = vector.ends;
        let mut arrows = site.key.solution.construction.sheets[vector.sheet].arrows();
        let laid = arrows.find(|arrow| (arrow.from.as_str(), arrow.to.as_str()) == (start, end));
        let [from, to] = laid.map_or([start, end], |arrow| arrow.ends()).map(Blank::from);
        site.candidate(tell::reversed_vector(from, to), vector.operation, edit)
    });
    laid.collect()
}

/// A product in the sum that gives a vector's size.
pub(super) struct Term<'s> {
    /// The operation that computes the sum.
    operation: usize,
    number: NumberId,
    sum: &'s [Product],
    /// Its place in the sum.
    at: usize,
    /// The names of the vector's ends.
    ends: [&'s str; 2],
}

impl<'s> Term<'s> {
    /// The operation that computes the sum.
    pub fn operation(&self) -> usize {
        self.operation
    }

    pub fn product(&self) -> &'s Product {
        &self.sum[self.at]
    }

    /// The sum with this product in place of the term, or without it.
    pub fn instead(&self, product: Option<Product>) -> (usize, Edit) {
        let mut sum = self.sum.to_vec();
        match product {
            Some(changed) => sum[self.at] = changed,
            None => drop(sum.remove(self.at)),
        }
        (self.operation, Edit::Instead(OperationKind::Compute { number: self.number, sum }))
    }

    /// The names of the vector's ends and of the first and the last factor.
    pub fn blanks(&self, site: &Site<'_>) -> [Blank; 4] {
        let [from, to] = self.ends.map(Blank::from);
        let [first, last] = [self.product().of.first(), self.product().of.last()];
        [from, to, site.symbol_or_none(first), site.symbol_or_none(last)]
    }

    /// A candidate that takes this product in place of the term.
    pub fn candidate(&self, site: &Site<'_>, told: Told, product: Option<Product>) -> Candidate {
        let (operation, edit) = self.instead(product);
        site.candidate(told, operation, edit)
    }

    /// The same, told by the names of the vector's ends and of the first and the last factor.
    fn changed(&self, site: &Site<'_>, tell: OfTerm, change: &impl Fn(&Product) -> Option<Product>) -> Candidate {
        let [from, to, first, last] = self.blanks(site);
        self.candidate(site, tell(from, to, first, last), change(self.product()))
    }
}

/// Tells of a vector from one point to another with two of its factors, as ω and the length of a normal part.
pub(super) type OfTerm = fn(Blank, Blank, Blank, Blank) -> Told;

/// The products of a kind in the sizes of vectors.
pub(super) fn terms<'s>(site: &'s Site<'_>, kind: ProductKind) -> Vec<Term<'s>> {
    let sums = site.sums().into_iter();
    let all = sums.flat_map(move |(operation, number, sum, ends)| {
        (0..sum.len()).map(move |at| Term { operation, number, sum, at, ends })
    });
    all.filter(|term| term.product().kind == kind).collect()
}

/// One candidate for each product of a kind; `change` gives the product that replaces it, or `None` where it is left
/// out.
pub(super) fn products(
    site: &Site<'_>,
    tell: OfTerm,
    kind: ProductKind,
    change: impl Fn(&Product) -> Option<Product>,
) -> Vec<Candidate> {
    terms(site, kind).iter().map(|term| term.changed(site, tell, &change)).collect()
}

/// Normal parts one by one, and as a habit, which `tell_all` tells: those of all links that are solved for, and with
/// `also_crank` those of the crank besides.
fn normals(
    site: &Site<'_>,
    tell: OfTerm,
    tell_all: fn(Blank) -> Told,
    also_crank: bool,
    change: impl Fn(&Product) -> Option<Product>,
) -> Vec<Candidate> {
    let terms = terms(site, ProductKind::Normal);
    let mut found: Vec<Candidate> = terms.iter().map(|term| term.changed(site, tell, &change)).collect();
    let of_crank = |term: &&Term<'_>| term.product().of.first().is_some_and(|&omega| site.is_given(omega));
    let links: Vec<&Term<'_>> = terms.iter().filter(|term| !of_crank(term)).collect();
    found.extend(all_of(site, tell_all, &links, &change));
    if also_crank && links.len() < terms.len() {
        let all: Vec<&Term<'_>> = terms.iter().collect();
        found.extend(all_of(site, tell_all, &all, &change));
    }
    found
}

/// One candidate for several products together, told by a list of their vectors; none for fewer than two.
fn all_of(
    site: &Site<'_>,
    tell: fn(Blank) -> Told,
    terms: &[&Term<'_>],
    change: &impl Fn(&Product) -> Option<Product>,
) -> Option<Candidate> {
    let [first, _, ..] = terms else { return None };
    let mut edits: Vec<(usize, Edit)> = Vec::new();
    let mut names: Vec<String> = Vec::new();
    for term in terms {
        names.push(format!("{} – {}", term.ends[0], term.ends[1]));
        if edits.iter().any(|(operation, _)| *operation == term.operation) {
            continue;
        }
        let own = |at: usize| terms.iter().any(|t| (t.operation, t.at) == (term.operation, at));
        let sum = term.sum.iter().enumerate().filter_map(|(at, product)| match own(at) {
            true => change(product),
            false => Some(product.clone()),
        });
        let kind = OperationKind::Compute { number: term.number, sum: sum.collect() };
        edits.push((term.operation, Edit::Instead(kind)));
    }
    names.dedup();
    let (operation, edit) = edits.remove(0);
    let mut candidate = site.candidate(tell(Blank::Words(names.join(", "))), operation, edit);
    candidate.edits.extend(edits);
    candidate.step = site.model.steps[first.operation];
    Some(candidate)
}

pub(super) fn outward(site: &Site<'_>) -> Vec<Candidate> {
    normals(site, tell::normal_outward, tell::normals_outward, true, |p| Some(p.times(-1.0)))
}

pub(super) fn not_squared(site: &Site<'_>) -> Vec<Candidate> {
    normals(site, tell::omega_not_squared, tell::omegas_not_squared, true, |p| {
        // The normal part still points inward.
        let omega = site.model.exact.number(p.of[0]);
        Some(Product::new(p.kind, p.factor * omega.signum(), &p.of[1..]))
    })
}

pub(super) fn normal_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    normals(site, tell::normal_forgotten, tell::normals_forgotten, false, |_| None)
}

/// The normal part alone with the diameter. (Throughout: `crank::diameter`.)
pub(super) fn diameter(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = products(site, tell::diameter, ProductKind::Normal, |p| Some(p.times(2.0)));
    found.extend(super::crank::diameter(site));
    found
}

/// v²/L with an absolute velocity, or with the relative velocity of another link, in place of that of the link's ends.
pub(super) fn from_absolute(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    let exact = |number: NumberId| site.model.exact.number(number);
    let told = |term: &Term<'_>, velocity: &str| {
        let [from, to, rate, length] = term.blanks(site);
        tell::normal_from_absolute(from, to, rate, length, velocity.into())
    };
    let mut found = Vec::new();
    for term in terms(site, ProductKind::Normal) {
        let product = term.product();
        let (omega, Some(&length)) = (product.of[0], product.of.last()) else { continue };
        let right = (exact(omega) * exact(length)).abs();
        // A crank has no relative velocity, and without a length there is no quotient.
        let is_other = |velocity: f64| (velocity - right).abs() > 1e-6 * right;
        if site.is_given(omega) || exact(length) == 0.0 {
            continue;
        }
        let factor = product.factor / exact(length);
        let end = match site.number_kind(length) {
            NumberKind::Length([_, end]) => image_name(solution.construction.end_name(&solution.mechanism, *end)),
            _ => continue,
        };
        let images = &solution.construction.sheets[Sheet::Velocity].points;
        let absolute = images.get(&end).map(|point| point.vector.norm());
        let segments = velocities(site, term.operation);
        let is_there = |velocity: f64| segments.iter().any(|(number, _)| !differ(exact(*number).abs(), velocity));
        if let Some(velocity) = absolute.filter(|v| is_other(*v) && !is_there(*v)) {
            let size = Product::new(product.kind, factor * velocity * velocity, &[]);
            found.push(term.candidate(site, told(&term, &format!("p – {end}")), Some(size)));
        }
        for (number, name) in segments.iter().filter(|(number, _)| is_other(exact(*number).abs())) {
            let size = Product::new(product.kind, factor, &[*number, *number]);
            found.push(term.candidate(site, told(&term, name), Some(size)));
        }
    }
    found
}

/// Whether two sizes differ by more than rounding.
fn differ(a: f64, b: f64) -> bool {
    (a - b).abs() > 1e-6 * b.abs()
}

/// The velocities that are laid off or measured before an operation, each size once, with the ends of their segments.
pub(super) fn velocities(site: &Site<'_>, before: usize) -> Vec<(NumberId, String)> {
    let mut found: Vec<(NumberId, String)> = Vec::new();
    let exact = |number: NumberId| site.model.exact.number(number).abs();
    let vectors = site.vectors().into_iter().filter(|v| v.sheet == Sheet::Velocity && v.operation < before);
    let laid = vectors.map(|vector| (vector.size, vector.ends.join(" – ")));
    let measured = site.numbers_before(before).filter_map(|(number, kind)| match kind {
        NumberKind::Segment(Sheet::Velocity, ends) => Some((number, ends.join(" – "))),
        _ => None,
    });
    for (number, name) in laid.chain(measured) {
        if exact(number) > 0.0 && found.iter().all(|(other, _)| differ(exact(*other), exact(number))) {
            found.push((number, name));
        }
    }
    found
}

/// The ω of another link in a normal part, or in a Coriolis acceleration.
pub(super) fn omega_of_another(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for term in terms(site, ProductKind::Normal).into_iter().chain(terms(site, ProductKind::Coriolis)) {
        let product = term.product();
        let right = product.of[0];
        // Nobody takes another ω for the crank's.
        if site.is_given(right) && product.kind == ProductKind::Normal {
            continue;
        }
        let exact = |number: NumberId| site.model.exact.number(number);
        for (wrong, kind) in site.numbers_before(term.operation) {
            let is_omega = matches!(kind, NumberKind::Rate(Rate::Omega(_)));
            if !is_omega || wrong == right || (exact(wrong) - exact(right)).abs() < 1e-9 * exact(right).abs() {
                continue;
            }
            let mut product = product.clone();
            product.of.iter_mut().filter(|number| **number == right).for_each(|number| *number = wrong);
            let [from, to, rate, factor] = term.blanks(site);
            let told = tell::omega_of_another_link(from, to, rate, factor, site.symbol(wrong));
            found.push(term.candidate(site, told, Some(product)));
        }
    }
    found
}

/// A normal part or a Coriolis acceleration laid off from the pole, or from the start of a vector beside it.
pub(super) fn from_wrong_point(site: &Site<'_>) -> Vec<Candidate> {
    let vectors = site.vectors();
    let mut found = Vec::new();
    for (at, vector) in vectors.iter().enumerate() {
        let is_part = vector.is_only(ProductKind::Normal) || vector.is_only(ProductKind::Coriolis);
        let is_named = !site.place_name(vector.from).is_empty() && !site.place_name(vector.place).is_empty();
        if !(is_part && is_named && vector.sheet == Sheet::Acceleration) {
            continue;
        }
        let pole = site.operations().find_map(|(_, operation)| match operation.kind {
            OperationKind::Pole { place, .. } if operation.sheet == vector.sheet => Some(place),
            _ => None,
        });
        let (before, after) = (at.checked_sub(1).map(|before| &vectors[before]), vectors.get(at + 1));
        let beside = [before.map(|v| v.from), before.map(|v| v.place), after.map(|v| v.from)];
        let mut starts: Vec<PlaceId> = Vec::new();
        for start in pole.into_iter().chain(beside.into_iter().flatten()) {
            let is_there = site.model.places_before(vector.sheet, vector.operation).contains(&start);
            if is_there && start != vector.from && !starts.contains(&start) {
                starts.push(start);
            }
        }
        found.extend(starts.into_iter().map(|start| laid_off_from(site, vector, start)));
    }
    found
}

/// A vector laid off from another place; its size is read from there.
fn laid_off_from(site: &Site<'_>, vector: &Laid<'_>, start: PlaceId) -> Candidate {
    let &Laid { place, from, size, along, .. } = vector;
    let edit = Edit::Instead(OperationKind::LayOff { place, from: start, size, along });
    let told = tell::vector_from_wrong_point(site.place(place), site.place(start), site.place(from));
    let mut candidate = site.candidate(told, vector.operation, edit);
    for (index, operation) in site.operations() {
        if let OperationKind::Measure { number, from: own, to, how } = operation.kind
            && (own, to) == (from, place)
        {
            let kind = OperationKind::Measure { number, from: start, to, how };
            candidate.edits.push((index, Edit::Instead(kind)));
        }
    }
    candidate
}

/// A vector laid off across its direction: the crank's velocity along the crank, a normal part across its link.
pub(super) fn turned(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for vector in site.vectors().iter().filter(|vector| !vector.is_only(ProductKind::Coriolis)) {
        for quarter_turns in [1, 3] {
            let edit = vector.turned(vector.along.turned(quarter_turns));
            let [from, to] = vector.blanks();
            found.push(site.candidate(tell::turned_vector(from, to), vector.operation, edit));
        }
    }
    found.extend(super::crank::turned(site));
    found
}

/// A tangential part ω r laid off besides the normal part of a crank that turns evenly, either way.
pub(super) fn tangential_where_none(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    let vectors = site.vectors();
    let is_even = |rate: NumberId| {
        let NumberKind::Rate(Rate::Omega(link)) = site.number_kind(rate) else { return false };
        let mut kinds = site.model.construction.numbers.iter();
        site.is_given(rate) && !kinds.any(|kind| *kind == NumberKind::Rate(Rate::Alpha(*link)))
    };
    for vector in vectors.iter().filter(|vector| vector.is_only(ProductKind::Normal)) {
        let [omega, .., length] = vector.sum[0].of.as_slice() else { continue };
        if !is_even(*omega) {
            continue;
        }
        let [omega_value, length_value] = [*omega, *length].map(|number| site.model.exact.number(number).abs());
        let direction = vector.direction(site);
        let normal = direction * (omega_value * omega_value * length_value);
        for side in [1.0, -1.0] {
            let whole = normal + quarter_turn(direction) * (side * omega_value * length_value);
            let size = whole.norm() / normal.norm();
            let towards = whole / whole.norm() * site.model.exact.number(vector.size).signum();
            if !size.is_finite() {
                continue;
            }
            let [from, to] = vector.blanks();
            let told = tell::tangential_where_none(from, to, site.symbol(*omega), site.symbol(*length));
            let edit = vector.turned(Along::given(towards));
            let mut candidate = site.candidate(told, vector.operation, edit);
            candidate.edits.insert(0, (vector.maker, Edit::Times(vector.size, size)));
            found.push(candidate);
        }
    }
    found
}
