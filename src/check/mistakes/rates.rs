//! Mistakes of rates and scales.

use super::{Candidate, Mistake, Site, Stand};
use crate::check::model::{Put, numbers_made};
use crate::drafting::{Deed, NumberId, Sheet};
use crate::plan::Kind;

/// Rates that are solved for or given, with the act that gives them.
fn rates<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, NumberId, &'a str)> {
    site.acts().flat_map(move |(index, act)| {
        let numbers = match act.deed {
            Deed::Solve { .. } | Deed::Take { .. } => numbers_made(&act.deed),
            _ => smallvec::SmallVec::new(),
        };
        let named = numbers.into_iter().map(move |n| (index, n, site.number_name(n)));
        named.filter(|(_, _, name)| ["omega(", "alpha(", "v_r(", "a_r("].iter().any(|head| name.starts_with(head)))
    })
}

pub(super) fn wrong_sense(site: &Site<'_>) -> Vec<Candidate> {
    let found = rates(site).map(|(act, number, name)| {
        let put = Put::Times(number, -1.0);
        site.candidate(Mistake::WrongSense, act, put, &[name])
    });
    found.collect()
}

/// A rate that comes out by a factor wrong, gone on with or only written so.
fn by_factor(site: &Site<'_>, mistake: Mistake, heads: &[&str], factor: f64) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (act, number, name) in rates(site) {
        if !heads.iter().any(|head| name.starts_with(head)) {
            continue;
        }
        for factor in [factor, 1.0 / factor] {
            let put = Put::Times(number, factor);
            found.push(site.candidate(mistake, act, put, &[name]));
        }
    }
    for (index, entry) in site.entries.iter().enumerate() {
        if !heads.iter().any(|head| entry.asked.name().starts_with(head)) {
            continue;
        }
        for factor in [factor, 1.0 / factor] {
            found.push(Candidate {
                mistake,
                step: entry.step,
                blanks: vec![entry.asked.name().to_owned()],
                puts: Vec::new(),
                stands: vec![Stand {
                    entry: index,
                    value: Some(entry.value * factor),
                    rounding: entry.rounding * factor,
                }],
                goes_on: Vec::new(),
                mode: 0,
            });
        }
    }
    found
}

pub(super) fn revolutions(site: &Site<'_>) -> Vec<Candidate> {
    let factor = 30.0 / core::f64::consts::PI;
    by_factor(site, Mistake::RevolutionsForRadians, &["omega("], factor)
}

pub(super) fn degrees(site: &Site<'_>) -> Vec<Candidate> {
    let factor = 180.0 / core::f64::consts::PI;
    by_factor(site, Mistake::DegreesForRadians, &["omega(", "alpha("], factor)
}

/// Segments turned into values by the scale of another sheet: one of them, or all of a sheet.
pub(super) fn wrong_scale(site: &Site<'_>) -> Vec<Candidate> {
    let [l, v, a] = site.model.scales.per_mm;
    let scales = [("μ_l", l), ("μ_v", v), ("μ_a", a), ("μ_v²/μ_l", v * v / l)];
    let mut found = Vec::new();
    for sheet in Sheet::ALL {
        let (own, right) = scales[sheet as usize];
        let measured: Vec<(usize, NumberId, &str)> = site
            .acts()
            .filter(|(_, act)| act.sheet == sheet)
            .filter_map(|(index, act)| match act.deed {
                Deed::Measure { number, .. } => Some((index, number, act.makes.as_str())),
                _ => None,
            })
            .collect();
        let entry_of = |name: &str| site.entries.iter().position(|e| e.asked.name() == name);
        let is_angle = |name: &str| {
            let own = entry_of(name).map(|e| &site.entries[e]);
            own.is_some_and(|e| e.asked.kind() == Kind::Angle)
        };
        for (name, scale) in scales.into_iter().chain([("", 1.0)]) {
            let ratio = scale / right;
            if name == own || (ratio - 1.0).abs() < 1e-9 {
                continue;
            }
            let mut all = None;
            for &(act, number, segment) in measured.iter().filter(|m| !is_angle(m.2)) {
                let put = Put::Times(number, ratio);
                let blanks = [segment, name, own];
                let mut one = site.candidate(Mistake::WrongScale, act, put.clone(), &blanks);
                // Millimetres stand as they were measured; the scale tells in what follows from them.
                let written = entry_of(segment).filter(|&e| site.entries[e].on_paper);
                if let Some(index) = written {
                    let entry = &site.entries[index];
                    one.puts.clear();
                    one.stands.push(Stand { entry: index, value: Some(entry.value), rounding: entry.rounding });
                    let exact = site.model.exact.number(number);
                    let value = libm::copysign(entry.value, exact) * ratio;
                    if site.model.used[number.0] {
                        one.goes_on.push((act, number, value));
                    }
                }
                let together = all.get_or_insert_with(|| {
                    let mut first = one.clone();
                    first.puts.clear();
                    first.stands.clear();
                    first.goes_on.clear();
                    first.blanks[0] = String::new();
                    first
                });
                together.puts.extend(one.puts.iter().cloned());
                together.stands.extend(one.stands.iter().copied());
                together.goes_on.extend(one.goes_on.iter().copied());
                if !(one.puts.is_empty() && one.goes_on.is_empty()) {
                    found.push(one);
                }
            }
            found.extend(all.filter(|all| all.puts.len() + all.goes_on.len() > 1));
        }
    }
    found
}
