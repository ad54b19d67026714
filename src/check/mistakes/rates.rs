//! Mistakes of rates and scales.

use super::{Candidate, Mistake, Site, Stand};
use crate::check::model::{Put, numbers_made};
use crate::drafting::{Deed, NumberId, Sheet};
use crate::plan::{Kind, What};

/// Rates that are solved for or given, with the act that gives them.
fn rates<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, NumberId, &'a str)> {
    site.acts().flat_map(move |(index, act)| {
        let numbers = match act.deed {
            Deed::Solve { .. } | Deed::Take { .. } => numbers_made(&act.deed),
            _ => smallvec::SmallVec::new(),
        };
        let named = numbers
            .into_iter()
            .map(move |n| (index, n, site.number_name(n)));
        named.filter(|(_, _, name)| {
            ["omega(", "alpha(", "v_r(", "a_r("]
                .iter()
                .any(|head| name.starts_with(head))
        })
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
        if !heads
            .iter()
            .any(|head| entry.asked.name().starts_with(head))
        {
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
    by_factor(
        site,
        Mistake::DegreesForRadians,
        &["omega(", "alpha("],
        factor,
    )
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
        let in_units = |name: &str| {
            let mut own = site.entries.iter().filter(|e| e.asked.name() == name);
            own.all(|e| {
                !e.on_paper
                    && !matches!(e.asked.what(), What::Angle(_))
                    && e.asked.kind() != Kind::Angle
            })
        };
        for (name, scale) in scales.into_iter().chain([("", 1.0)]) {
            let ratio = scale / right;
            if name == own || (ratio - 1.0).abs() < 1e-9 {
                continue;
            }
            let mut all = None;
            for &(act, number, segment) in measured.iter().filter(|m| in_units(m.2)) {
                let put = Put::Times(number, ratio);
                let one =
                    site.candidate(Mistake::WrongScale, act, put.clone(), &[segment, name, own]);
                let together = all.get_or_insert_with(|| {
                    let mut first = one.clone();
                    first.puts.clear();
                    first.blanks[0] = String::new();
                    first
                });
                together.puts.push((act, put));
                found.push(one);
            }
            found.extend(all.filter(|all| all.puts.len() > 1));
        }
    }
    found
}
