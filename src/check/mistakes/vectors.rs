//! Mistakes with vectors that are laid off: a wrong sense, a wrong size, a part forgotten or added.

use super::candidate::Candidate;
use super::mistake::Mistake;
use super::site::Site;
use crate::check::model::Edit;
use crate::construction::{NumberId, NumberKind, OperationKind, Plan, Product, ProductKind, image_name};

pub(super) fn reversed(site: &Site<'_>) -> Vec<Candidate> {
    let laid = site.operations().filter_map(|(index, operation)| {
        let OperationKind::LayOff { place, from, size, along } = operation.kind else {
            return None;
        };
        let (start, end) = (site.place_name(from), site.place_name(place));
        if end.is_empty() {
            return None;
        }
        let edit = Edit::Instead(OperationKind::LayOff { place, from, size, along: along.turned(2) });
        let arrows = || site.key.solution.construction.plan_on(operation.sheet).into_iter().flat_map(Plan::arrows);
        let laid = arrows().find(|arrow| (arrow.from.as_str(), arrow.to.as_str()) == (start, end));
        let ends = laid.map_or([start, end], |arrow| arrow.ends());
        Some(site.candidate(Mistake::ReversedVector, index, edit, &ends))
    });
    laid.collect()
}

/// One candidate for each product of a kind; `change` gives the product that replaces it, or `None` where it is left
/// out.
fn products(
    site: &Site<'_>,
    mistake: Mistake,
    kind: ProductKind,
    change: impl Fn(&Product) -> Option<Product>,
) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (operation, number, sum, [from, to]) in site.sums() {
        for (place, product) in sum.iter().enumerate().filter(|(_, p)| p.kind == kind) {
            let mut sum = sum.to_vec();
            match change(product) {
                Some(changed) => sum[place] = changed,
                None => drop(sum.remove(place)),
            }
            let name = |number: Option<&NumberId>| number.map_or("", |&n| site.number_name(n));
            let blanks = [from, to, name(product.of.first()), name(product.of.last())];
            found.push(site.candidate(
                mistake,
                operation,
                Edit::Instead(OperationKind::Compute { number, sum }),
                &blanks,
            ));
        }
    }
    found
}

pub(super) fn outward(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::NormalOutward, ProductKind::Normal, |p| Some(p.times(-1.0)))
}

pub(super) fn not_squared(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::OmegaNotSquared, ProductKind::Normal, |p| {
        // The normal part still points inward.
        let omega = site.model.exact.number(p.of[0]);
        Some(Product::new(p.kind, p.factor * omega.signum(), &p.of[1..]))
    })
}

pub(super) fn diameter(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::Diameter, ProductKind::Normal, |p| Some(p.times(2.0)))
}

pub(super) fn normal_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::NormalForgotten, ProductKind::Normal, |_| None)
}

/// v²/L with the absolute velocity of the end in place of that relative to the start.
pub(super) fn from_absolute(site: &Site<'_>) -> Vec<Candidate> {
    let solution = site.key.solution;
    let absolute = |product: &Product| -> Option<f64> {
        let length = *product.of.last()?;
        let NumberKind::Length([_, end]) = site.number_kind(length) else {
            return None;
        };
        let end = solution.construction.end_name(&solution.mechanism, *end);
        let velocity = solution.construction.velocity.points.get(&image_name(end))?.vector.norm();
        let length = site.model.exact.number(length);
        (length != 0.0).then(|| velocity * velocity / length)
    };
    let mut found = products(site, Mistake::NormalFromAbsolute, ProductKind::Normal, |p| {
        let size = absolute(p).unwrap_or(f64::NAN);
        Some(Product::new(p.kind, p.factor * size, &[]))
    });
    // Where the plan has no such velocity, the mistake cannot be made.
    found.retain(|candidate| {
        candidate.edits.iter().all(|(_, edit)| match edit {
            Edit::Instead(OperationKind::Compute { sum, .. }) => sum.iter().all(|p| p.factor.is_finite()),
            _ => true,
        })
    });
    found
}

pub(super) fn coriolis_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisForgotten, ProductKind::Coriolis, |_| None)
}

pub(super) fn coriolis_without_two(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisWithoutTwo, ProductKind::Coriolis, |p| Some(p.times(0.5)))
}

pub(super) fn coriolis_turned(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisTurned, ProductKind::Coriolis, |p| Some(p.times(-1.0)))
}

/// A Coriolis part 2 ω v added to a link between pins, with v = ω L: it lies along the normal part ω² L and makes it
/// three times as large.
pub(super) fn coriolis_where_none(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisWhereNone, ProductKind::Normal, |p| Some(p.times(3.0)))
}
