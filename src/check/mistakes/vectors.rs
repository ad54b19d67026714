//! Mistakes with vectors that are laid off: a wrong sense, a wrong size, a part forgotten or added; those with Coriolis
//! accelerations among them.

use super::site::{Candidate, Laid, Site, Term, instead, times};
use super::teeth;
use super::told::{Blank, Told, tell};
use crate::construction::{
    Action, Along, Change, Disturbance, NumberId, NumberKind, OperationKind, PlaceId, Product, ProductKind, Rate,
    RayOf, image_name,
};
use crate::geometry::quarter_turn;
use crate::mechanism::{GROUND, SliderId};
use crate::sheet::{Order, Sheet};

/// The reversed vectors that have no name of their own: a normal part alone is laid off outward, a Coriolis
/// acceleration alone is turned the wrong way, and the velocity of a crank has the wrong sense of its ω.
pub(super) fn reversed(site: &Site<'_>) -> Vec<Candidate> {
    let to_rings = teeth::laid_off_to_rings(site);
    let vectors = site.vectors().into_iter().filter(|vector| {
        let of_crank = || vector.sum.iter().all(|product| site.is_of_crank(product));
        let is_crank = vector.is_only(ProductKind::Turning) && vector.sheet == Sheet::Velocity && of_crank();
        let is_other = vector.is_only(ProductKind::Normal) || vector.is_only(ProductKind::Coriolis) || is_crank;
        // `teeth::wrong_side` has those to rings.
        !is_other && !to_rings.contains(&vector.operation)
    });
    let laid = vectors.map(|vector| {
        let [start, end] = vector.ends;
        let mut arrows = site.key.solution.construction.arrows(vector.sheet);
        let laid = arrows.find(|arrow| (arrow.from.as_str(), arrow.to.as_str()) == (start, end));
        let [from, to] = laid.map_or([start, end], |arrow| arrow.ends()).map(Blank::from);
        site.candidate(tell::reversed_vector(from, to), vector.turned(vector.along.turned(2)))
    });
    laid.collect()
}

/// Tells of a vector from one point to another with two of its factors, as ω and the length of a normal part.
pub(super) type OfTerm = fn(Blank, Blank, Blank, Blank) -> Told;

/// One candidate for each product of a kind; `change` gives the product that replaces it, or `None` where it is left
/// out.
fn products(
    site: &Site<'_>,
    tell: OfTerm,
    kind: ProductKind,
    change: impl Fn(&Product) -> Option<Product>,
) -> Vec<Candidate> {
    let changed = |term: Term<'_>| {
        let [from, to, first, last] = term.blanks(site);
        term.candidate(site, tell(from, to, first, last), change(term.product()))
    };
    site.terms(kind).into_iter().map(changed).collect()
}

/// Normal parts one by one, two behind each other, and as a habit, which `tell_all` tells: those of all links that are solved for, and
/// with `also_crank` those of the crank besides.
fn normals(
    site: &Site<'_>,
    tell: OfTerm,
    tell_all: fn(Blank) -> Told,
    also_crank: bool,
    change: impl Fn(&Product) -> Option<Product>,
) -> Vec<Candidate> {
    let mut found = products(site, tell, ProductKind::Normal, &change);
    let all = site.terms(ProductKind::Normal);
    let links: Vec<Term<'_>> = all.iter().filter(|term| !site.is_of_crank(term.product())).copied().collect();
    found.extend(all_of(site, tell_all, &links, &change));
    // Those of one pair of rays, too: both are laid off for one point.
    if links.len() > 2 {
        found.extend(links.windows(2).filter_map(|pair| all_of(site, tell_all, pair, &change)));
    }
    if also_crank && links.len() < all.len() {
        found.extend(all_of(site, tell_all, &all, &change));
    }
    found
}

/// One candidate for several products together, told by a list of their vectors; none for fewer than two.
fn all_of(
    site: &Site<'_>,
    tell: fn(Blank) -> Told,
    terms: &[Term<'_>],
    change: &impl Fn(&Product) -> Option<Product>,
) -> Option<Candidate> {
    let [first, _, ..] = terms else { return None };
    let mut edits: Vec<Disturbance> = Vec::new();
    let mut names: Vec<String> = Vec::new();
    for Term { vector, .. } in terms {
        names.push(vector.ends.join(" – "));
        if edits.iter().any(|edit| edit.operation == vector.maker) {
            continue;
        }
        let is_changed = |at: usize| terms.iter().any(|t| (t.vector.maker, t.at) == (vector.maker, at));
        let sum = vector.sum.iter().enumerate().filter_map(|(at, product)| match is_changed(at) {
            true => change(product),
            false => Some(product.clone()),
        });
        edits.push(instead(vector.maker, OperationKind::Compute { number: vector.size, sum: sum.collect() }));
    }
    names.dedup();
    let step = site.model.steps[first.vector.maker];
    Some(Candidate { edits, ..Candidate::at(tell(Blank::Words(names.join(", "))), step) })
}

pub(super) fn outward(site: &Site<'_>) -> Vec<Candidate> {
    normals(site, tell::normal_outward, tell::normals_outward, true, |p| Some(p.times(-1.0)))
}

pub(super) fn not_squared(site: &Site<'_>) -> Vec<Candidate> {
    normals(site, tell::omega_not_squared, tell::omegas_not_squared, true, |p| {
        // The normal part still points inward.
        Some(Product::new(p.kind, p.factor * site.exact(p.of[0]).signum(), &p.of[1..]))
    })
}

pub(super) fn normal_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    normals(site, tell::normal_forgotten, tell::normals_forgotten, false, |_| None)
}

/// The normal part alone with the diameter. (Throughout: `lengths::diameter_throughout`.)
pub(super) fn diameter(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = products(site, tell::diameter, ProductKind::Normal, |p| Some(p.times(2.0)));
    found.extend(super::lengths::diameter_throughout(site));
    found
}

/// v²/L with an absolute velocity, or with the relative velocity of another link, in place of that of the link's ends.
pub(super) fn from_absolute(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    let told = |term: &Term<'_>, velocity: &str| {
        let [from, to, rate, length] = term.blanks(site);
        tell::normal_from_absolute(from, to, rate, length, velocity.into())
    };
    let mut found = Vec::new();
    for term in site.terms(ProductKind::Normal) {
        let product = term.product();
        let (omega, Some(&length)) = (product.of[0], product.of.last()) else { continue };
        let right = (site.exact(omega) * site.exact(length)).abs();
        // A crank has no relative velocity, and without a length there is no quotient.
        if site.is_given(omega) || site.exact(length) == 0.0 {
            continue;
        }
        let factor = product.factor / site.exact(length);
        let NumberKind::Length(ends) = site.number_kind(length) else { continue };
        let ends = ends.map(|end| image_name(solution.construction.end_name(&solution.mechanism, end)));
        let images = &solution.construction.plans[Order::Velocity].points;
        let segments = velocities(site, term.vector.maker);
        let is_there = |velocity: f64| segments.iter().any(|(number, _)| !differ(site.exact(*number).abs(), velocity));
        for end in ends {
            let absolute = images.get(&end).map(|point| point.vector.norm()).filter(|velocity| *velocity > 0.0);
            if let Some(velocity) = absolute.filter(|v| differ(*v, right) && !is_there(*v)) {
                let size = Product::new(product.kind, factor * velocity * velocity, &[]);
                found.push(term.candidate(site, told(&term, &format!("p – {end}")), Some(size)));
            }
        }
        for (number, name) in segments.iter().filter(|(number, _)| differ(site.exact(*number).abs(), right)) {
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
fn velocities(site: &Site<'_>, before: usize) -> Vec<(NumberId, String)> {
    let mut found: Vec<(NumberId, String)> = Vec::new();
    let exact = |number: NumberId| site.exact(number).abs();
    let vectors = site.vectors().into_iter().filter(|v| v.sheet == Sheet::Velocity && v.operation < before);
    let laid = vectors.map(|vector| (vector.size, vector.ends.join(" – ")));
    let measured = site.numbers_before(before).filter_map(|(number, kind)| match kind {
        NumberKind::Segment(Order::Velocity, ends) => Some((number, ends.join(" – "))),
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
    let mut found = omegas_interchanged(site);
    for term in site.terms(ProductKind::Normal).into_iter().chain(site.terms(ProductKind::Coriolis)) {
        let product = term.product();
        let right = product.of[0];
        // Nobody takes another ω for the crank's.
        if site.is_given(right) && product.kind == ProductKind::Normal {
            continue;
        }
        let exact = site.exact(right);
        for wrong in site.omegas_before(term.vector.maker) {
            if wrong == right || (site.exact(wrong) - exact).abs() < 1e-9 * exact.abs() {
                continue;
            }
            let product = with(product, right, wrong);
            let [from, to, rate, factor] = term.blanks(site);
            let told = tell::omega_of_another_link(from, to, rate, factor, site.symbol(wrong));
            found.push(term.candidate(site, told, Some(product)));
        }
    }
    found
}

/// The ω of two links interchanged in their normal parts.
fn omegas_interchanged(site: &Site<'_>) -> Vec<Candidate> {
    let terms: Vec<Term<'_>> =
        site.terms(ProductKind::Normal).into_iter().filter(|term| !site.is_given(term.product().of[0])).collect();
    let mut found = Vec::new();
    for (at, first) in terms.iter().enumerate() {
        for second in &terms[at + 1..] {
            let [one, other] = [first, second].map(|term| term.product().of[0]);
            let is_known = |rate: NumberId, at: usize| site.omegas_before(at).any(|known| known == rate);
            if one == other || !is_known(other, first.vector.maker) || !is_known(one, second.vector.maker) {
                continue;
            }
            let [from, to, ..] = first.blanks(site);
            let told = tell::omegas_interchanged(from, to, site.symbol(one), site.symbol(other));
            let edits = [(first, one, other), (second, other, one)]
                .map(|(term, right, wrong)| term.instead(Some(with(term.product(), right, wrong))));
            let step = site.model.steps[first.vector.operation];
            found.push(Candidate { edits: edits.to_vec(), ..Candidate::at(told, step) });
        }
    }
    found
}

/// A product with one number in place of another.
fn with(product: &Product, right: NumberId, wrong: NumberId) -> Product {
    let mut product = product.clone();
    product.of.iter_mut().filter(|number| **number == right).for_each(|number| *number = wrong);
    product
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
        let pole = site.model.construction.place(vector.sheet, Order::Acceleration.pole());
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
    let told = tell::vector_from_wrong_point(site.place(place), site.place(start), site.place(from));
    let edit = instead(vector.operation, OperationKind::LayOff { place, from: start, size, along });
    let mut candidate = site.candidate(told, edit);
    for (index, operation) in site.operations() {
        if let OperationKind::Measure { number, from: own, to, how } = operation.kind
            && (own, to) == (from, place)
        {
            candidate.edits.push(instead(index, OperationKind::Measure { number, from: start, to, how }));
        }
    }
    candidate
}

/// A vector laid off across its direction: the crank's velocity along the crank, a normal part across its link.
pub(super) fn turned(site: &Site<'_>) -> Vec<Candidate> {
    let told = |vector: &Laid<'_>| {
        let [from, to] = vector.blanks();
        tell::turned_vector(from, to)
    };
    let mut found = across(site, told, |vector| !vector.is_only(ProductKind::Coriolis));
    found.extend(super::lengths::crank_turned(site));
    found
}

/// Vectors of a kind laid off across their directions, either way.
fn across(site: &Site<'_>, told: impl Fn(&Laid<'_>) -> Told, is_meant: fn(&Laid<'_>) -> bool) -> Vec<Candidate> {
    let vectors = site.vectors().into_iter().filter(is_meant);
    let turned = vectors.flat_map(|vector| {
        [1, 3].map(|quarters| site.candidate(told(&vector), vector.turned(vector.along.turned(quarters))))
    });
    turned.collect()
}

/// A tangential part ω r laid off besides the normal part of a crank that turns evenly, either way.
pub(super) fn tangential_where_none(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    let vectors = site.vectors();
    let is_even = |rate: NumberId| {
        let NumberKind::Rate(Rate::Angular(Order::Velocity, link)) = site.number_kind(rate) else { return false };
        let mut kinds = site.model.construction.numbers.iter();
        site.is_given(rate) && !kinds.any(|kind| *kind == NumberKind::Rate(Rate::Angular(Order::Acceleration, *link)))
    };
    for vector in vectors.iter().filter(|vector| vector.is_only(ProductKind::Normal)) {
        let [omega, .., length] = vector.sum[0].of.as_slice() else { continue };
        if !is_even(*omega) {
            continue;
        }
        let [omega_value, length_value] = [*omega, *length].map(|number| site.exact(number).abs());
        let direction = vector.direction(site);
        let normal = direction * (omega_value * omega_value * length_value);
        for side in [1.0, -1.0] {
            let whole = normal + quarter_turn(direction) * (side * omega_value * length_value);
            let size = whole.norm() / normal.norm();
            let towards = whole / whole.norm() * site.exact(vector.size).signum();
            if !size.is_finite() {
                continue;
            }
            let [from, to] = vector.blanks();
            let told = tell::tangential_where_none(from, to, site.symbol(*omega), site.symbol(*length));
            let edits = vec![times(vector.maker, vector.size, size), vector.turned(Along::given(towards))];
            found.push(Candidate { edits, ..Candidate::at(told, site.model.steps[vector.operation]) });
        }
    }
    found
}

pub(super) fn coriolis_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    products(site, tell::coriolis_forgotten, ProductKind::Coriolis, |_| None)
}

pub(super) fn coriolis_without_two(site: &Site<'_>) -> Vec<Candidate> {
    products(site, tell::coriolis_without_two, ProductKind::Coriolis, |p| Some(p.times(0.5)))
}

pub(super) fn coriolis_turned(site: &Site<'_>) -> Vec<Candidate> {
    let turned = |term: Term<'_>| {
        let [from, to, rate, velocity] = term.blanks(site);
        // Where it ends at what is known it is laid off backwards; its direction is that from its own beginning.
        let [from, to] = if term.product().factor < 0.0 { [to, from] } else { [from, to] };
        term.candidate(site, tell::coriolis_turned(from, to, rate, velocity), Some(term.product().times(-1.0)))
    };
    site.terms(ProductKind::Coriolis).into_iter().map(turned).collect()
}

/// A Coriolis part 2 ω v added to a link between pins, with v = ω L: it lies along the normal part ω² L and makes it
/// three times as large.
pub(super) fn coriolis_where_none(site: &Site<'_>) -> Vec<Candidate> {
    products(site, tell::coriolis_where_none, ProductKind::Normal, |p| Some(p.times(3.0)))
}

/// A Coriolis acceleration laid off along its guide.
pub(super) fn coriolis_along(site: &Site<'_>) -> Vec<Candidate> {
    let told = |vector: &Laid<'_>| {
        let [from, to] = vector.blanks();
        let [rate, velocity] = [0, 1].map(|factor| site.symbol_or_none(vector.sum[0].of.get(factor)));
        tell::coriolis_along(from, to, rate, velocity)
    };
    across(site, told, |vector| vector.is_only(ProductKind::Coriolis))
}

/// The size with another velocity in place of the sliding one, as the absolute one.
pub(super) fn coriolis_of_wrong_velocity(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for term in site.terms(ProductKind::Coriolis) {
        let product = term.product();
        let [omega, right] = product.of.as_slice() else { continue };
        let exact = site.exact(*right);
        let others = velocities(site, term.vector.maker).into_iter();
        for (wrong, name) in others.filter(|(number, _)| differ(site.exact(*number).abs(), exact.abs())) {
            // The direction is that of the sliding velocity all the same.
            let factor = product.factor * (site.exact(wrong) * exact).signum();
            let size = Product::new(product.kind, factor, &[*omega, wrong]);
            let [from, to, rate, velocity] = term.blanks(site);
            let told = tell::coriolis_velocity(from, to, rate, velocity, name.as_str().into());
            found.push(term.candidate(site, told, Some(size)));
            // With a crank's ω besides, as of somebody who takes the pin's motion for that in the slot.
            let cranks = site.omegas_before(term.vector.maker).filter(|&crank| site.is_given(crank));
            for crank in cranks.filter(|crank| crank != omega) {
                let size = Product::new(product.kind, factor, &[crank, wrong]);
                let [from, to, rate, velocity] = term.blanks(site);
                let (wrong, omega) = (name.as_str().into(), site.symbol(crank));
                let told = tell::coriolis_velocity_and_omega(from, to, rate, velocity, wrong, omega);
                found.push(term.candidate(site, told, Some(size)));
            }
        }
    }
    found
}

/// A Coriolis acceleration 2 ω v of the slider laid off at a guide that is at rest, before its ray: either way across
/// the guide, with any ω.
pub(super) fn coriolis_at_rest(site: &Site<'_>) -> Vec<Candidate> {
    let construction = &site.key.solution.construction;
    let mut found = Vec::new();
    for (index, operation) in site.operations().filter(|(_, operation)| operation.sheet == Sheet::Acceleration) {
        let OperationKind::Draw { line, .. } = operation.kind else { continue };
        let Some(Action::Ray(ray)) = operation.step.and_then(|step| construction.step(step)) else { continue };
        let RayOf::Leg(special, side) = ray.of else { continue };
        let cut = &construction.special(special).cuts[side];
        let at_rest = |slider: &SliderId| site.key.solution.mechanism.slider(*slider).on == GROUND;
        let Some(slider) = cut.guide().filter(|slider| cut.leg.base == GROUND && at_rest(slider)) else { continue };
        let mut slides = site.numbers_before(index);
        let Some((velocity, _)) =
            slides.find(|(_, kind)| **kind == NumberKind::Rate(Rate::Slide(Order::Velocity, slider)))
        else {
            continue;
        };
        for omega in site.omegas_before(index) {
            for factor in [2.0, -2.0] {
                let [from, to] = [ray.through.as_str(), &ray.to].map(Blank::from);
                let told = tell::coriolis_at_rest(from, to, site.symbol(omega), site.symbol(velocity));
                let size = Product::new(ProductKind::Coriolis, factor, &[omega, velocity]);
                let edit = Disturbance { operation: index, change: Change::Aside(line, size) };
                found.push(site.candidate(told, edit));
            }
        }
    }
    found
}
