//! Mistakes of lengths and segments: what is measured, and which length is taken.

use super::{Candidate, Mistake, Site};
use crate::check::model::Put;
use crate::drafting::{Act, Change, Deed, Disturbance, How, NumberId, Sheet};

/// What stands on the sheets in place of a measured number keeps the sense that the number should have.
fn same_sense(site: &Site<'_>, act: usize, put: Put, number: NumberId) -> Vec<(usize, Put)> {
    let mut puts = vec![(act, put)];
    let instead = match &puts[0].1 {
        Put::Act(act) => act,
        _ => return puts,
    };
    let change = Change::Instead(instead);
    let values = site.model.replay(&[Disturbance { act, change }]);
    if values.number(number) * site.model.exact.number(number) < 0.0 {
        puts.push((act, Put::Times(number, -1.0)));
    }
    puts
}

/// The acts that measure a length of the construction or one that is read off.
fn measures<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, &'a Act, NumberId, [crate::drafting::PlaceId; 2])> {
    site.acts().filter_map(|(index, act)| match act.deed {
        Deed::Measure { number, from, to, how: How::Along(_) | How::Size } => Some((index, act, number, [from, to])),
        _ => None,
    })
}

pub(super) fn component(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, act, number, [from, to]) in measures(site) {
        for (how, axis) in [(How::X, "x"), (How::Y, "y")] {
            let deed = Deed::Measure { number, from, to, how };
            let put = site.instead(index, deed);
            let ends = [from, to].map(|p| site.place_name(p));
            let blanks = [act.makes.as_str(), axis, ends[0], ends[1]];
            let mut candidate = site.candidate(Mistake::Component, index, put.clone(), &blanks);
            candidate.puts = same_sense(site, index, put, number);
            found.push(candidate);
        }
    }
    found
}

/// Segments of plans measured from or to another point.
pub(super) fn wrong_segment(site: &Site<'_>) -> Vec<Candidate> {
    ends_elsewhere(site, Mistake::WrongSegment, |sheet| sheet != Sheet::Scheme)
}

fn ends_elsewhere(site: &Site<'_>, mistake: Mistake, is_meant: fn(Sheet) -> bool) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, act, number, [from, to]) in measures(site) {
        if !is_meant(act.sheet) {
            continue;
        }
        for other in site.model.places_before(act.sheet, index) {
            if [from, to].contains(&other) {
                continue;
            }
            for ends in [[other, to], [from, other]] {
                let deed = Deed::Measure { number, from: ends[0], to: ends[1], how: How::Size };
                let put = site.instead(index, deed);
                let [a, b] = ends.map(|p| site.place_name(p));
                let blanks = [act.makes.as_str(), a, b];
                let mut candidate = site.candidate(mistake, index, put.clone(), &blanks);
                candidate.puts = same_sense(site, index, put, number);
                found.push(candidate);
            }
        }
    }
    found
}

/// A neighbouring length measured, or taken for a vector or an equation.
pub(super) fn wrong_length(site: &Site<'_>) -> Vec<Candidate> {
    let mistake = Mistake::WrongLength;
    let mut found = ends_elsewhere(site, mistake, |sheet| sheet == Sheet::Scheme);
    let lengths: Vec<(NumberId, usize)> = (0..site.model.number_names.len())
        .map(NumberId)
        .filter(|&n| site.number_name(n).starts_with("L("))
        .filter_map(|n| Some((n, site.model.makers[n.0]?)))
        .collect();
    for (act, sum, _) in site.sums() {
        for (at, product) in sum.iter().enumerate() {
            let Some(&right) = product.of.last() else {
                continue;
            };
            if !lengths.iter().any(|l| l.0 == right) {
                continue;
            }
            for &(wrong, made) in &lengths {
                if wrong == right || made >= act || !is_neighbour(site, wrong, right) {
                    continue;
                }
                let Deed::Compute { number, .. } = site.model.drafting.acts[act].deed else {
                    continue;
                };
                let mut sum = sum.to_vec();
                if let Some(last) = sum[at].of.last_mut() {
                    *last = wrong;
                }
                // The sense comes from the scheme, not from the length.
                let exact = |n: NumberId| site.model.exact.number(n);
                sum[at].factor *= (exact(wrong) * exact(right)).signum();
                let put = site.instead(act, Deed::Compute { number, sum });
                let [w, r] = [wrong, right].map(|n| site.number_name(n));
                let blanks = [r, ends(w).0, ends(w).1];
                found.push(site.candidate(mistake, act, put, &blanks));
            }
        }
    }
    found
}

/// Whether two lengths share a point.
fn is_neighbour(site: &Site<'_>, a: NumberId, b: NumberId) -> bool {
    let (a, b) = (ends(site.number_name(a)), ends(site.number_name(b)));
    [b.0, b.1].contains(&a.0) || [b.0, b.1].contains(&a.1)
}

fn ends(name: &str) -> (&str, &str) {
    let inner = name.strip_prefix("L(").and_then(|n| n.strip_suffix(')'));
    inner.and_then(|n| n.split_once(',')).unwrap_or(("", ""))
}
