//! Mistakes of vectors that are laid off: their sense, their size, what belongs to them.

use super::{Candidate, Mistake, Site};
use crate::check::model::Put;
use crate::drafting::{Deed, NumberId, Product, Reference, Sheet};
use crate::geometry::Vector;
use crate::plan::image_name;

/// Whether a product is a normal part, ω² L.
fn is_normal(product: &Product) -> bool {
    matches!(product.of.as_slice(), [a, b, _] if a == b)
}

/// Whether a product is a Coriolis part, 2 ω v.
fn is_coriolis(product: &Product) -> bool {
    product.of.len() == 2 && product.factor.abs() == 2.0
}

pub(super) fn reversed(site: &Site<'_>) -> Vec<Candidate> {
    let laid = site.acts().filter_map(|(index, act)| {
        let Deed::LayOff { place, from, size, reference, quarter_turns } = act.deed else {
            return None;
        };
        let (start, end) = (site.place_name(from), site.place_name(place));
        if end.is_empty() {
            return None;
        }
        let deed = Deed::LayOff { place, from, size, reference, quarter_turns: quarter_turns + 2 };
        let put = site.instead(index, deed);
        Some(site.candidate(Mistake::ReversedVector, index, put, &[start, end]))
    });
    laid.collect()
}

/// Changes each product that is meant, alone; `change` gives what stands in its place.
fn products(
    site: &Site<'_>,
    mistake: Mistake,
    is_meant: fn(&Product) -> bool,
    change: impl Fn(&Product) -> Option<Product>,
) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (act, sum, [from, to]) in site.sums() {
        for (place, product) in sum.iter().enumerate().filter(|(_, p)| is_meant(p)) {
            let mut sum = sum.to_vec();
            match change(product) {
                Some(changed) => sum[place] = changed,
                None => drop(sum.remove(place)),
            }
            let Deed::Compute { number, .. } = site.model.drafting.acts[act].deed else {
                continue;
            };
            let put = site.instead(act, Deed::Compute { number, sum });
            let names: Vec<&str> = product.of.iter().map(|&n| site.number_name(n)).collect();
            let first = names.first().copied().unwrap_or("");
            let last = names.last().copied().unwrap_or("");
            found.push(site.candidate(mistake, act, put, &[from, to, first, last]));
        }
    }
    found
}

fn times(product: &Product, factor: f64) -> Option<Product> {
    Some(Product { factor: product.factor * factor, of: product.of.clone() })
}

pub(super) fn outward(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::NormalOutward, is_normal, |p| times(p, -1.0))
}

pub(super) fn not_squared(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::OmegaNotSquared, is_normal, |p| {
        // The normal part still points inward.
        let omega = site.model.exact.number(p.of[0]);
        Some(Product::new(p.factor * omega.signum(), &p.of[1..]))
    })
}

pub(super) fn diameter(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::Diameter, is_normal, |p| times(p, 2.0))
}

pub(super) fn normal_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::NormalForgotten, is_normal, |_| None)
}

/// v²/L with the velocity of the end from the pole in place of that relative to the start.
pub(super) fn from_absolute(site: &Site<'_>) -> Vec<Candidate> {
    let absolute = |product: &Product| -> Option<f64> {
        let length = *product.of.last()?;
        let name = site.number_name(length);
        let (_, end) = name.strip_prefix("L(")?.strip_suffix(')')?.split_once(',')?;
        let plan = &site.key.solution.construction.velocity;
        let velocity = plan.points.get(&image_name(end))?.vector.norm();
        let length = site.model.exact.number(length);
        (length != 0.0).then(|| velocity * velocity / length)
    };
    let mut found = products(site, Mistake::NormalFromAbsolute, is_normal, |p| {
        let size = absolute(p).unwrap_or(f64::NAN);
        Some(Product::new(p.factor * size, &[]))
    });
    found.retain(|candidate| {
        candidate.puts.iter().all(|(_, put)| match put {
            Put::Act(act) => match &act.deed {
                Deed::Compute { sum, .. } => sum.iter().all(|p| p.factor.is_finite()),
                _ => true,
            },
            _ => true,
        })
    });
    found
}

pub(super) fn coriolis_forgotten(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisForgotten, is_coriolis, |_| None)
}

pub(super) fn coriolis_without_two(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisWithoutTwo, is_coriolis, |p| times(p, 0.5))
}

pub(super) fn coriolis_turned(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisTurned, is_coriolis, |p| times(p, -1.0))
}

/// 2 ω v added to a link between pins, where v = ω L: it lies along the link, with the normal part, and makes three of it.
pub(super) fn coriolis_where_none(site: &Site<'_>) -> Vec<Candidate> {
    products(site, Mistake::CoriolisWhereNone, is_normal, |p| times(p, 3.0))
}

/// The image of a link with three points: one of its sides laid off on the wrong side of another.
pub(super) fn mirrored(site: &Site<'_>) -> Vec<Candidate> {
    // Vectors of the velocity plan from one point, normal to lines of the mechanism.
    let mut laid: Vec<(usize, [&str; 2], NumberId, Vector)> = Vec::new();
    for (index, act) in site.acts() {
        let Deed::LayOff { place, from, size, reference: Reference::Line(line), quarter_turns: 1 } = act.deed else {
            continue;
        };
        let ends = [from, place].map(|p| site.place_name(p));
        if act.sheet == Sheet::Scheme || ends[1].is_empty() {
            continue;
        }
        let joined = site.acts().find_map(|(_, a)| match a.deed {
            Deed::Join { line: own, from, towards } if own == line => Some([from, towards]),
            _ => None,
        });
        let Some(joined) = joined else { continue };
        let [a, b] = joined.map(|p| site.model.exact.place(p));
        if let Some(along) = crate::geometry::unit(b - a) {
            laid.push((index, ends, size, along));
        }
    }
    let mut found = Vec::new();
    for &(index, [from, to], size, along) in &laid {
        for &(other, [from_other, to_other], _, axis) in &laid {
            let same_sheet = site.model.drafting.acts[other].sheet == site.model.drafting.acts[index].sheet;
            if other >= index || from_other != from || !same_sheet {
                continue;
            }
            let mirrored = axis * (2.0 * along.dot(&axis)) - along;
            let Deed::LayOff { place, from: start, .. } = site.model.drafting.acts[index].deed else {
                continue;
            };
            let deed =
                Deed::LayOff { place, from: start, size, reference: Reference::Given(mirrored), quarter_turns: 1 };
            let put = site.instead(index, deed);
            found.push(site.candidate(Mistake::MirroredImage, index, put, &[from, to, to_other]));
        }
    }
    found
}
