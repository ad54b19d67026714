//! Mistakes with rates and scales.

use super::lengths::{Length, lengths};
use super::site::{Candidate, Reinterpretation, Site, Term, times};
use super::teeth;
use super::told::{Blank, Mistake, Told, tell};
use super::vectors::OfTerm;
use crate::check::entry::Entry;
use crate::construction::{Change, Disturbance, MeasuredAs, NumberId, NumberKind, OperationKind, ProductKind, Rate};
use crate::quantity::{QuantityKind, What};
use crate::scene::{LengthUnit, TimeUnit};
use crate::sheet::{Order, Sheet};

/// Rates that are solved for or given: the operation that gives each, its number, which rate it is.
fn rates<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, NumberId, Rate)> {
    site.operations().flat_map(move |(index, operation)| {
        let rates = operation.kind.numbers().iter().map(move |&number| (number, site.number_kind(number)));
        rates.filter_map(move |(number, kind)| match kind {
            NumberKind::Rate(rate) => Some((index, number, *rate)),
            NumberKind::RateByCenters(link) => Some((index, number, Rate::Angular(Order::Velocity, *link))),
            _ => None,
        })
    })
}

/// A rate taken with the wrong sense: in all that follows, or only as it is written.
pub(super) fn wrong_sense(site: &Site<'_>) -> Vec<Candidate> {
    // `teeth::sense` has those of wheels.
    let of_wheels = teeth::reversed(site);
    // `centers::sense_by_center` has those by centres.
    let of_plans = rates(site).filter(|(_, number, _)| {
        matches!(site.number_kind(*number), NumberKind::Rate(_)) && !of_wheels.contains(number)
    });
    let taken = of_plans.filter_map(|(operation, number, _)| {
        let mut candidate = site.candidate(tell::wrong_sense(as_asked(site, number)), times(operation, number, -1.0));
        if site.is_given(number) {
            let Some(first) = site.all_terms().find(|term| term.product().of.contains(&number)) else {
                // On the figure of centres no vector shows it.
                let reads = |kind: &OperationKind| {
                    let mut reads = false;
                    kind.each_number_read(|other| reads |= other == number);
                    reads
                };
                // Where one operation alone reads it, the sense is rather wrong in what that finds.
                let mut all = site.operations().filter(|(_, operation)| reads(&operation.kind));
                let ((first, _), _) = (all.next()?, all.next()?);
                candidate.step = site.model.steps[first];
                return Some(candidate);
            };
            let first = first.vector;
            candidate.step = site.model.steps[first.operation];
            let [from, to] = first.blanks();
            candidate.told = tell::wrong_sense_given(site.symbol(number), from, to);
        }
        Some(candidate)
    });
    let mut found: Vec<Candidate> = taken.collect();
    for (index, entry) in site.entries.iter().enumerate() {
        let number = site.model.readings[index].ok().map(|reading| reading.number);
        let Some(number) = number.filter(|number| !of_wheels.contains(number)) else { continue };
        if !matches!(site.number_kind(number), NumberKind::Rate(_)) || entry.is_magnitude {
            continue;
        }
        let mut candidate = only_written(site, tell::wrong_sense(entry_symbol(entry)), &[index], -1.0);
        // What passes with the other sign has the wrong sense, however exactly the other values are drawn.
        let off = (entry.value + entry.expected).abs();
        let passes = site.tolerances.get(index).is_some_and(|tolerance| off <= *tolerance);
        for meant in candidate.reinterpreted.iter_mut().filter(|_| passes) {
            meant.rounding = meant.rounding.max(off);
        }
        // Of a number that nothing uses it is the same as above.
        if passes || site.model.used[number.0] {
            found.push(candidate);
        }
    }
    found
}

/// A rate as the form asks for it: of links that turn together, that of any.
fn as_asked(site: &Site<'_>, number: NumberId) -> Blank {
    let reads = |index: &usize| site.model.readings[*index].is_ok_and(|reading| reading.number == number);
    (0..site.entries.len()).find(reads).map_or_else(|| site.symbol(number), |index| entry_symbol(&site.entries[index]))
}

/// The senses of all rates of rotation reversed on the form, as by somebody who counts clockwise as positive.
pub(super) fn senses_reversed(site: &Site<'_>) -> Vec<Candidate> {
    let is_turning = |what: &What| matches!(what, What::Rate(Rate::Angular(..)));
    let signed = site.entries.iter().enumerate().filter(|(index, entry)| {
        is_turning(&entry.asked.what) && !entry.is_magnitude && site.model.readings[*index].is_ok()
    });
    let all: Vec<usize> = signed.map(|(index, _)| index).collect();
    // Of wheels alone it is `teeth::sense` in the first mesh.
    let of_wheels = teeth::rates(site);
    let is_of_wheel = |index: &usize| site.model.readings[*index].is_ok_and(|r| of_wheels.contains(&r.number));
    if !of_wheels.is_empty() && all.iter().all(is_of_wheel) {
        return Vec::new();
    }
    // Of a single rate this is `wrong_sense`.
    match all.len() {
        0 | 1 => Vec::new(),
        _ => vec![only_written(site, tell::senses_reversed(), &all, -1.0)],
    }
}

/// Values that are meant `factor` times as large as they are written.
fn only_written(site: &Site<'_>, told: Told, entries: &[usize], factor: f64) -> Candidate {
    let meant = entries.iter().map(|&entry| {
        let written = &site.entries[entry];
        Reinterpretation { entry, value: written.value * factor, rounding: written.rounding * factor.abs() }
    });
    let step = entries.first().map_or(0, |&entry| site.entries[entry].step);
    Candidate { reinterpreted: meant.collect(), ..Candidate::at(told, step) }
}

/// The quantity of a written rate as it stands in formulas.
fn entry_symbol(entry: &Entry) -> Blank {
    Blank::Symbol(entry.asked.name().to_owned())
}

/// Rates that one length alone divides, solved for with another one.
struct Divided<'s> {
    /// The operation that solves for the rate.
    operation: usize,
    rate: NumberId,
    is_omega: bool,
    length: Length<'s>,
}

fn divided<'s>(site: &'s Site<'_>, all: &[Length<'s>]) -> Vec<Divided<'s>> {
    let mut found = Vec::new();
    for (operation, kind) in site.operations().map(|(index, operation)| (index, &operation.kind)) {
        let OperationKind::Solve { unknowns, equations } = kind else { continue };
        for equation in equations {
            let [(unknown, product)] = equation.left.as_slice() else { continue };
            let length = all.iter().find(|length| length.number.is_some_and(|own| product.of.as_slice() == [own]));
            let rate = unknowns[*unknown];
            let is_omega = match site.number_kind(rate) {
                NumberKind::Rate(Rate::Angular(order, _)) => *order == Order::Velocity,
                _ => continue,
            };
            found.extend(length.map(|&length| Divided { operation, rate, is_omega, length }));
        }
    }
    found
}

/// ω or α found with another length: the rate alone, or the normal part with that length, too.
fn from_wrong_length(site: &Site<'_>, tell: OfTerm, is_omega: bool) -> Vec<Candidate> {
    let lengths = lengths(site);
    let normals = site.terms(ProductKind::Normal);
    let mut found = Vec::new();
    for Divided { operation, rate, length, .. } in
        divided(site, &lengths).into_iter().filter(|divided| divided.is_omega == is_omega)
    {
        let Some(own_length) = length.number else { continue };
        for (wrong, ratio) in length.mistakable(&lengths) {
            let [from, to] = wrong.names.map(Blank::from);
            let (rate_symbol, length) = (site.symbol(rate), site.symbol(own_length));
            let told = tell(rate_symbol.clone(), from.clone(), to.clone(), length.clone());
            let alone = site.candidate(told, times(operation, rate, 1.0 / ratio));
            let own = |term: &&Term<'_>| {
                let product = term.product();
                product.of.first() == Some(&rate) && product.of.last() == Some(&own_length)
            };
            if let Some(normal) = normals.iter().find(own) {
                let mut both = alone.clone();
                let [_, end, ..] = normal.blanks(site);
                both.told = tell::omega_and_normal_from_wrong_length(rate_symbol, from, to, length, end);
                both.edits.push(normal.instead(Some(normal.product().times(ratio))));
                found.push(both);
            }
            found.push(alone);
        }
    }
    found
}

pub(super) fn omega_from_wrong_length(site: &Site<'_>) -> Vec<Candidate> {
    from_wrong_length(site, tell::omega_from_wrong_length, true)
}

pub(super) fn alpha_from_wrong_length(site: &Site<'_>) -> Vec<Candidate> {
    from_wrong_length(site, tell::alpha_from_wrong_length, false)
}

/// A rate that was not divided by its length: the segment as it is, or only turned into metres.
pub(super) fn not_divided(site: &Site<'_>) -> Vec<Candidate> {
    let per_metre = libm::round(1.0 / site.key.solution.scene.units.length.metres());
    let is_metric = matches!(site.key.solution.scene.units.length, LengthUnit::Mm | LengthUnit::Cm);
    let divisors = if is_metric { vec![1.0, per_metre] } else { vec![1.0] };
    let mut found = Vec::new();
    for Divided { operation, rate, length, .. } in divided(site, &lengths(site)) {
        for divisor in &divisors {
            let told = tell::not_divided_by_length(site.symbol(rate), site.symbol_or_none(length.number.as_ref()));
            found.push(site.candidate(told, times(operation, rate, length.exact / divisor)));
        }
    }
    found
}

/// An angular velocity, or with `also_alpha` an angular acceleration, that is wrong by `factor` or its inverse: used so
/// in later operations, or only written so.
fn by_factor(site: &Site<'_>, tell: fn(Blank) -> Told, also_alpha: bool, factor: f64) -> Vec<Candidate> {
    let is_meant = |rate: &Rate| matches!(rate, Rate::Angular(order, _) if also_alpha || *order == Order::Velocity);
    let mut found = Vec::new();
    for (operation, number, _) in rates(site).filter(|(.., rate)| is_meant(rate)) {
        for factor in [factor, 1.0 / factor] {
            let told = tell(site.symbol(number));
            let taken = site.is_given(number).then(|| taken_as(site, told.mistake, number, factor)).flatten();
            let edit = times(operation, number, factor);
            found.push(site.candidate(taken.unwrap_or_else(|| told.clone()), edit));
            found.extend(in_normal_part(site, told, number, factor));
        }
    }
    for (index, entry) in site.entries.iter().enumerate() {
        if matches!(&entry.asked.what, What::Rate(rate) if is_meant(rate)) {
            let as_written = |factor| only_written(site, tell(entry_symbol(entry)), &[index], factor);
            found.extend([factor, 1.0 / factor].map(as_written));
        }
    }
    found
}

/// A rate that is written right, but enters its normal part `factor` times as large. With a rate much too small the
/// part would be nearly nothing, as if it were forgotten: nobody takes that for a size.
fn in_normal_part(site: &Site<'_>, told: Told, rate: NumberId, factor: f64) -> Option<Candidate> {
    if factor < 1.0 {
        return None;
    }
    let own = |term: &Term<'_>| !site.is_given(rate) && term.product().of.first() == Some(&rate);
    let term = site.terms(ProductKind::Normal).into_iter().find(own)?;
    Some(term.candidate(site, told, Some(term.product().times(factor * factor))))
}

/// What is told of a given rate taken in another unit; `None` where somebody must have converted it to a unit that was
/// not asked for.
fn taken_as(site: &Site<'_>, mistake: Mistake, rate: NumberId, factor: f64) -> Option<Told> {
    if site.key.solution.scene.units.time != TimeUnit::S {
        return None;
    }
    let (other, in_other) = match mistake {
        Mistake::RevolutionsForRadians => ("rpm", 30.0 / core::f64::consts::PI),
        Mistake::RevolutionsPerSecond => ("rev/s", 0.5 / core::f64::consts::PI),
        _ => ("deg/s", 180.0 / core::f64::consts::PI),
    };
    let exact = site.exact(rate).abs();
    // A scene may give revolutions per minute: then these are the round number.
    let is_round = |x: f64| (x * 1000.0 - libm::round(x * 1000.0)).abs() < 1e-6;
    let is_other = other == "rpm" && is_round(exact * in_other) && !is_round(exact);
    let (number, own, taken, by) = match is_other {
        true => (exact * in_other, other, "rad/s", in_other),
        false => (exact, "rad/s", other, 1.0 / in_other),
    };
    let is_taken = (factor / by - 1.0).abs() < 1e-9;
    is_taken.then(|| {
        let number = Blank::Number((libm::round(number * 1000.0) / 1000.0).to_string());
        Told { mistake, ..tell::rate_in_other_unit(site.symbol(rate), number, own.into(), taken.into()) }
    })
}

pub(super) fn revolutions(site: &Site<'_>) -> Vec<Candidate> {
    by_factor(site, tell::revolutions_for_radians, false, 30.0 / core::f64::consts::PI)
}

pub(super) fn revolutions_per_second(site: &Site<'_>) -> Vec<Candidate> {
    by_factor(site, tell::revolutions_per_second, false, 2.0 * core::f64::consts::PI)
}

pub(super) fn degrees(site: &Site<'_>) -> Vec<Candidate> {
    by_factor(site, tell::degrees_for_radians, true, 180.0 / core::f64::consts::PI)
}

/// Segments converted to values with the scale of another sheet: one of them, or all of a sheet.
pub(super) fn wrong_scale(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = at_wrong_scales(site);
    found.retain(|candidate| candidate.mistake() == Mistake::WrongScale);
    found
}

/// The same without a scale on the figure of instant centres.
pub(super) fn without_scale(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = at_wrong_scales(site);
    found.retain(|candidate| candidate.mistake() == Mistake::LengthsWithoutScale);
    found
}

fn at_wrong_scales(site: &Site<'_>) -> Vec<Candidate> {
    let own = site.model.scales;
    let drawn = &site.model.construction.by_hand;
    let squared = own[Sheet::Velocity] * own[Sheet::Velocity] / own[Sheet::Scheme];
    let squared = drawn.contains(&Sheet::Velocity).then_some(("μ_v²/μ_l", squared));
    let scales = drawn.iter().map(|sheet| (sheet.facts().scale_symbol, own[*sheet])).chain(squared);
    let mut found = Vec::new();
    for &sheet in drawn {
        let right = own[sheet];
        let own = sheet.facts().scale_symbol;
        let measured: Vec<(usize, NumberId, &str, MeasuredAs)> = site
            .operations()
            .filter(|(_, operation)| operation.sheet == sheet)
            .filter_map(|(index, operation)| match operation.kind {
                // Of arms `moments::in_paper_mm`.
                OperationKind::Measure { number, how, .. } if *site.number_kind(number) != NumberKind::Arm => {
                    Some((index, number, site.number_name(number), how))
                }
                _ => None,
            })
            .collect();
        let is_angle = |name: &str| {
            let mut named = site.entries.iter().filter(|e| e.asked.name() == name);
            named.next().is_some_and(|e| e.asked.kind() == QuantityKind::Angle)
        };
        let others = scales.clone().filter(|(name, _)| *name != own).map(|(name, scale)| (Some(name), scale));
        for (wrong, scale) in others.chain([(None, 1.0)]) {
            let ratio = scale / right;
            if (ratio - 1.0).abs() < 1e-9 {
                continue;
            }
            let told = |segment| match wrong {
                Some(wrong) => tell::wrong_scale(segment, wrong.into(), own.into()),
                None if sheet == Sheet::Centers => tell::lengths_without_scale(segment, own.into()),
                None => tell::scale_forgotten(segment, own.into()),
            };
            let (mut all, mut distances) = (None, None);
            for &(operation, number, _, how) in measured.iter().filter(|m| !is_angle(m.2)) {
                let one = at_wrong_scale(site, told(site.quantity(number)), operation, number, ratio);
                let add = |all: &mut Option<Candidate>| {
                    let together = all.get_or_insert_with(|| Candidate::at(told(Blank::AllSegments), one.step));
                    together.edits.extend(one.edits.iter().cloned());
                    together.reinterpreted.extend(one.reinterpreted.iter().copied());
                    together.passed_on.extend(one.passed_on.iter().cloned());
                };
                add(&mut all);
                if !matches!(how, MeasuredAs::X | MeasuredAs::Y) {
                    add(&mut distances);
                }
                if one.changes().next().is_some() {
                    found.push(one);
                }
            }
            // The distances alone, where coordinates are measured, too.
            let distances = distances.filter(|some| {
                all.as_ref().is_some_and(|all: &Candidate| all.changes().count() > some.changes().count())
            });
            found.extend([all, distances].into_iter().flatten().filter(|all| all.changes().count() > 1));
        }
    }
    found
}

/// One segment converted to a value with another scale, `ratio` times the right one.
fn at_wrong_scale(site: &Site<'_>, told: Told, operation: usize, number: NumberId, ratio: f64) -> Candidate {
    let mut candidate = site.candidate(told, times(operation, number, ratio));
    // A value written in millimetres is right; the wrong scale shows only in what follows from it.
    let entries = site.entries.iter().enumerate();
    let mut on_paper = entries.filter(|(_, entry)| entry.asked.name() == site.number_name(number) && entry.on_paper);
    if let Some((index, entry)) = on_paper.next() {
        candidate.edits.clear();
        let Entry { value, rounding, .. } = *entry;
        candidate.reinterpreted.push(Reinterpretation { entry: index, value, rounding });
        if site.model.used[number.0] {
            let change = Change::Written(number, libm::copysign(value, site.exact(number)) * ratio);
            candidate.passed_on.push(Disturbance { operation, change });
        }
    }
    candidate
}
