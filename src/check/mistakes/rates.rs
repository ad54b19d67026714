//! Mistakes with rates and scales.

use super::candidate::{Candidate, Reinterpretation};
use super::mistake::Mistake;
use super::site::Site;
use crate::check::model::Edit;
use crate::construction::{NumberId, NumberKind, OperationKind, Rate, Sheet};
use crate::quantity::{Kind, What};

/// Rates that are solved for or given: the operation that gives each, its number, which rate it is.
fn rates<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, NumberId, Rate)> {
    site.operations().flat_map(move |(index, operation)| {
        let rates = operation.kind.numbers().iter().map(move |&number| (number, site.number_kind(number)));
        rates.filter_map(move |(number, kind)| match kind {
            NumberKind::Rate(rate) => Some((index, number, *rate)),
            _ => None,
        })
    })
}

pub(super) fn wrong_sense(site: &Site<'_>) -> Vec<Candidate> {
    let candidate = |(operation, number, _)| {
        let edit = Edit::Times(number, -1.0);
        site.candidate(Mistake::WrongSense, operation, edit, &[site.number_name(number)])
    };
    rates(site).map(candidate).collect()
}

/// An angular velocity, or with `also_alpha` an angular acceleration, that is wrong by `factor` or its inverse: used so
/// in later operations, or only written so.
fn by_factor(site: &Site<'_>, mistake: Mistake, also_alpha: bool, factor: f64) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (operation, number, rate) in rates(site) {
        if matches!(rate, Rate::Omega(_)) || also_alpha && matches!(rate, Rate::Alpha(_)) {
            for factor in [factor, 1.0 / factor] {
                let edit = Edit::Times(number, factor);
                found.push(site.candidate(mistake, operation, edit, &[site.number_name(number)]));
            }
        }
    }
    for (index, entry) in site.entries.iter().enumerate() {
        let what = entry.asked.what();
        if !(matches!(what, What::Omega(_)) || also_alpha && matches!(what, What::Alpha(_))) {
            continue;
        }
        for factor in [factor, 1.0 / factor] {
            let meant =
                Reinterpretation { entry: index, value: Some(entry.value * factor), rounding: entry.rounding * factor };
            found.push(Candidate {
                mistake,
                step: entry.step,
                blanks: vec![entry.asked.name().to_owned()],
                edits: Vec::new(),
                reinterpreted: vec![meant],
                goes_on: Vec::new(),
                free: Vec::new(),
                mode: 0,
            });
        }
    }
    found
}

pub(super) fn revolutions(site: &Site<'_>) -> Vec<Candidate> {
    by_factor(site, Mistake::RevolutionsForRadians, false, 30.0 / core::f64::consts::PI)
}

pub(super) fn degrees(site: &Site<'_>) -> Vec<Candidate> {
    by_factor(site, Mistake::DegreesForRadians, true, 180.0 / core::f64::consts::PI)
}

/// Segments converted to values with the scale of another sheet: one of them, or all of a sheet.
pub(super) fn wrong_scale(site: &Site<'_>) -> Vec<Candidate> {
    let [l, v, a] = site.model.scales.per_mm;
    let scales = [("μ_l", l), ("μ_v", v), ("μ_a", a), ("μ_v²/μ_l", v * v / l)];
    let mut found = Vec::new();
    for sheet in Sheet::ALL {
        let (own, right) = scales[sheet as usize];
        let measured: Vec<(usize, NumberId, &str)> = site
            .operations()
            .filter(|(_, operation)| operation.sheet == sheet)
            .filter_map(|(index, operation)| match operation.kind {
                OperationKind::Measure { number, .. } => Some((index, number, site.number_name(number))),
                _ => None,
            })
            .collect();
        let is_angle = |name: &str| {
            let mut named = site.entries.iter().filter(|e| e.asked.name() == name);
            named.next().is_some_and(|e| e.asked.kind() == Kind::Angle)
        };
        for (name, scale) in scales.into_iter().chain([("", 1.0)]) {
            let ratio = scale / right;
            if name == own || (ratio - 1.0).abs() < 1e-9 {
                continue;
            }
            let mut all = None;
            for &(operation, number, segment) in measured.iter().filter(|m| !is_angle(m.2)) {
                let one = at_wrong_scale(site, operation, number, ratio, &[segment, name, own]);
                let together = all.get_or_insert_with(|| {
                    let mut first = one.clone();
                    first.edits.clear();
                    first.reinterpreted.clear();
                    first.goes_on.clear();
                    first.blanks[0] = String::new();
                    first
                });
                together.edits.extend(one.edits.iter().cloned());
                together.reinterpreted.extend(one.reinterpreted.iter().copied());
                together.goes_on.extend(one.goes_on.iter().copied());
                if !(one.edits.is_empty() && one.goes_on.is_empty()) {
                    found.push(one);
                }
            }
            found.extend(all.filter(|all| all.edits.len() + all.goes_on.len() > 1));
        }
    }
    found
}

/// One segment converted to a value with another scale, `ratio` times the right one. The blanks: the segment, the scale
/// taken, the right scale.
fn at_wrong_scale(site: &Site<'_>, operation: usize, number: NumberId, ratio: f64, blanks: &[&str; 3]) -> Candidate {
    let mut candidate = site.candidate(Mistake::WrongScale, operation, Edit::Times(number, ratio), blanks);
    // A value written in millimetres is right; the wrong scale shows only in what follows from it.
    let entries = site.entries.iter().enumerate();
    let mut on_paper = entries.filter(|(_, entry)| entry.asked.name() == blanks[0] && entry.on_paper);
    if let Some((index, entry)) = on_paper.next() {
        candidate.edits.clear();
        let (value, rounding) = (Some(entry.value), entry.rounding);
        candidate.reinterpreted.push(Reinterpretation { entry: index, value, rounding });
        if site.model.used[number.0] {
            let exact = site.model.exact.number(number);
            candidate.goes_on.push((operation, number, libm::copysign(entry.value, exact) * ratio));
        }
    }
    candidate
}
