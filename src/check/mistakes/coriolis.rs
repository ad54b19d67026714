//! Mistakes with Coriolis accelerations.

use super::candidate::Candidate;
use super::site::Site;
use super::told::{Blank, tell};
use super::vectors::{products, terms, velocities};
use crate::check::model::Edit;
use crate::construction::{Action, NumberId, NumberKind, OperationKind, Product, ProductKind, Rate, RayOf};
use crate::mechanism::{GROUND, SliderId};
use crate::sheet::Sheet;

pub(super) fn forgotten(site: &Site<'_>) -> Vec<Candidate> {
    products(site, tell::coriolis_forgotten, ProductKind::Coriolis, |_| None)
}

pub(super) fn without_two(site: &Site<'_>) -> Vec<Candidate> {
    products(site, tell::coriolis_without_two, ProductKind::Coriolis, |p| Some(p.times(0.5)))
}

pub(super) fn turned(site: &Site<'_>) -> Vec<Candidate> {
    products(site, tell::coriolis_turned, ProductKind::Coriolis, |p| Some(p.times(-1.0)))
}

/// A Coriolis part 2 ω v added to a link between pins, with v = ω L: it lies along the normal part ω² L and makes it
/// three times as large.
pub(super) fn where_none(site: &Site<'_>) -> Vec<Candidate> {
    products(site, tell::coriolis_where_none, ProductKind::Normal, |p| Some(p.times(3.0)))
}

/// A Coriolis acceleration laid off along its guide.
pub(super) fn along(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for vector in site.vectors().iter().filter(|vector| vector.is_only(ProductKind::Coriolis)) {
        for quarter_turns in [1, 3] {
            let edit = vector.turned(vector.along.turned(quarter_turns));
            let [from, to] = vector.blanks();
            let [rate, velocity] = [0, 1].map(|factor| site.symbol_or_none(vector.sum[0].of.get(factor)));
            let told = tell::coriolis_along(from, to, rate, velocity);
            found.push(site.candidate(told, vector.operation, edit));
        }
    }
    found
}

/// The size with another velocity in place of the sliding one, as the absolute one.
pub(super) fn of_wrong_velocity(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for term in terms(site, ProductKind::Coriolis) {
        let product = term.product();
        let [omega, right] = product.of.as_slice() else { continue };
        let exact = |number: NumberId| site.model.exact.number(number);
        for (wrong, name) in velocities(site, term.operation()) {
            if (exact(wrong).abs() - exact(*right).abs()).abs() <= 1e-6 * exact(*right).abs() {
                continue;
            }
            // The direction is that of the sliding velocity all the same.
            let factor = product.factor * (exact(wrong) * exact(*right)).signum();
            let size = Product::new(product.kind, factor, &[*omega, wrong]);
            let [from, to, rate, velocity] = term.blanks(site);
            let told = tell::coriolis_velocity(from, to, rate, velocity, name.as_str().into());
            found.push(term.candidate(site, told, Some(size)));
            // With a crank's ω besides, as of somebody who takes the pin's motion for that in the slot.
            let given = site.numbers_before(term.operation()).filter(|(number, _)| site.is_given(*number));
            let cranks = given.filter(|(_, kind)| matches!(kind, NumberKind::Rate(Rate::Omega(_))));
            for (crank, _) in cranks.filter(|(crank, _)| crank != omega) {
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
pub(super) fn at_rest(site: &Site<'_>) -> Vec<Candidate> {
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
        let Some((velocity, _)) = slides.find(|(_, kind)| **kind == NumberKind::Rate(Rate::SlideVelocity(slider)))
        else {
            continue;
        };
        for (omega, _) in
            site.numbers_before(index).filter(|(_, kind)| matches!(kind, NumberKind::Rate(Rate::Omega(_))))
        {
            for factor in [2.0, -2.0] {
                let edit = Edit::Aside(line, Product::new(ProductKind::Coriolis, factor, &[omega, velocity]));
                let [from, to] = [ray.through.as_str(), &ray.to].map(Blank::from);
                let told = tell::coriolis_at_rest(from, to, site.symbol(omega), site.symbol(velocity));
                found.push(site.candidate(told, index, edit));
            }
        }
    }
    found
}
