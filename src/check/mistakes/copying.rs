//! Slips of writing: they change the written value, and what follows from it where later operations use the written
//! value.

use super::site::{Candidate, Reinterpretation, Site};
use super::told::{Blank, Told, tell};
use crate::check::entry::Entry;
use crate::construction::{Change, Disturbance};
use crate::scene::DecimalMark;
use crate::sheet::{QuantityKind, Sheet};
use crate::words::NumberStyle;

/// The candidates for values written otherwise than meant: one where later operations use the written values, if any
/// do, and one where they do not.
fn misread(site: &Site<'_>, told: Told, meant: Vec<Reinterpretation>) -> Vec<Candidate> {
    let Some(first) = meant.first().map(|s| s.entry) else {
        return Vec::new();
    };
    let passed_on = meant.iter().filter_map(|one| {
        let entry = &site.entries[one.entry];
        let reading = site.model.readings[one.entry].ok()?;
        let number = reading.number;
        let operation = site.model.makers[number.0].filter(|_| site.model.used[number.0])?;
        let is_unsigned = reading.is_size() || entry.is_magnitude;
        let value = if is_unsigned { libm::copysign(entry.value, site.exact(number)) } else { entry.value };
        Some(Disturbance { operation, change: Change::Written(number, value) })
    });
    let passed_on: Vec<Disturbance> = passed_on.collect();
    let only_written = Candidate { reinterpreted: meant, ..Candidate::at(told, site.entries[first].step) };
    let mut found = Vec::new();
    // Several entries may name one number; its use later is counted once.
    let reads = |entry: usize| site.model.readings[entry].ok().map(|r| r.number);
    if !passed_on.is_empty() && (0..first).all(|earlier| reads(earlier) != reads(first)) {
        found.push(Candidate { passed_on, ..only_written.clone() });
    }
    found.push(only_written);
    found
}

fn meant_as(entry: usize, value: f64, rounding: f64) -> Reinterpretation {
    Reinterpretation { entry, value, rounding }
}

fn named(entry: &Entry) -> Blank {
    Blank::Quantity(entry.asked.name().to_owned())
}

/// A number as it was written.
fn digits(text: &str) -> Blank {
    Blank::Number(text.to_owned())
}

pub(super) fn decimal(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, entry) in written(site) {
        for power in [-2, -1, 1, 2] {
            let factor = libm::exp10(f64::from(power));
            let text = shifted(&entry.text, power);
            let rounding = entry.precision.rounding(&text) * entry.factor.abs();
            // No line is read beyond a turn.
            if entry.asked.is_line() && (entry.value * factor).abs() > 360.0 {
                continue;
            }
            let meant = meant_as(index, entry.value * factor, rounding);
            let told = tell::decimal_slipped(named(entry), digits(&entry.text), digits(&text));
            found.extend(misread(site, told, vec![meant]));
        }
    }
    found
}

/// Written digits with the decimal point moved.
fn shifted(text: &str, power: i32) -> String {
    let number: f64 = text.parse().unwrap_or(0.0);
    let decimals = text.split_once('.').map_or(0, |(_, d)| d.len() as i32);
    let decimals = (decimals - power).max(0) as usize;
    format!("{:.decimals$}", number * libm::exp10(f64::from(power)))
}

/// Entries that were written as digits and are read from the drawing, with their indices.
fn written<'a>(site: &'a Site<'a>) -> impl Iterator<Item = (usize, &'a Entry)> {
    let all = site.entries.iter().enumerate();
    all.filter(|(index, entry)| !entry.text.is_empty() && site.model.readings[*index].is_ok())
}

pub(super) fn transposed(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, entry) in written(site) {
        // Zeros at the end of a whole number only hold places: nobody means more digits than values of the kind are
        // written with.
        let alike = |other: &Entry| other.asked.kind() == entry.asked.kind() && other.on_paper == entry.on_paper;
        let same = written(site).filter(|(_, other)| alike(other));
        let most = same.map(|(_, other)| significant(&other.text)).max().unwrap_or(0);
        for meant in transpositions(&entry.text) {
            let Ok(number) = meant.parse::<f64>() else {
                continue;
            };
            if !meant.contains('.') && significant(&meant) > most {
                continue;
            }
            let meant_value = meant_as(index, number * entry.factor, entry.rounding);
            let told = tell::digits_transposed(named(entry), digits(&entry.text), digits(&meant));
            found.extend(misread(site, told, vec![meant_value]));
        }
    }
    found
}

/// The significant digits of a written number; zeros at the end of a whole number only hold places.
fn significant(text: &str) -> usize {
    let mantissa = text.split(['e', 'E']).next().unwrap_or("");
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let digits = digits.trim_start_matches('0');
    if mantissa.contains('.') { digits.len() } else { digits.trim_end_matches('0').len() }
}

/// The numbers that arise from swapping two neighbouring digits; the decimal point stays. Those with a superfluous
/// leading zero are left out.
fn transpositions(text: &str) -> Vec<String> {
    let characters: Vec<char> = text.chars().collect();
    let digits: Vec<usize> = (0..characters.len()).filter(|&i| characters[i].is_ascii_digit()).collect();
    let pairs = digits.windows(2).filter(|p| characters[p[0]] != characters[p[1]]);
    let swapped = pairs.map(|pair| {
        let mut other = characters.clone();
        other.swap(pair[0], pair[1]);
        other.into_iter().collect()
    });
    // A mantissa before a power of ten never begins with a zero.
    let has_power = text.contains(['e', 'E']);
    let begins_with_zero = |number: &String| {
        let number = number.trim_start_matches(['+', '-']).as_bytes();
        number.len() > 1 && number[0] == b'0' && (has_power || number[1].is_ascii_digit())
    };
    swapped.filter(|n| !begins_with_zero(n)).collect()
}

pub(super) fn swapped(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    let all: Vec<(usize, &Entry)> = written(site).collect();
    for (at, &(i, a)) in all.iter().enumerate() {
        for &(j, b) in &all[at + 1..] {
            let same = a.asked.kind() == b.asked.kind() && a.on_paper == b.on_paper;
            if !same || (a.value - b.value).abs() <= a.rounding + b.rounding {
                continue;
            }
            let meant = vec![meant_as(i, b.value, b.rounding), meant_as(j, a.value, a.rounding)];
            found.extend(misread(site, tell::swapped(named(a), named(b)), meant));
        }
    }
    found
}

/// Every value cut off in place of rounded: the value meant is on average half a unit of the last digit larger.
pub(super) fn truncated(site: &Site<'_>) -> Vec<Candidate> {
    let meant: Vec<Reinterpretation> = written(site)
        .map(|(index, entry)| {
            let half = libm::copysign(entry.rounding, entry.value);
            meant_as(index, entry.value + half, entry.rounding)
        })
        .collect();
    // One or two values do not show a habit.
    if meant.len() < 3 {
        return Vec::new();
    }
    vec![Candidate { reinterpreted: meant, ..Candidate::at(tell::truncated(), 0) }]
}

/// Metric units of length, in millimetres.
const METRIC: [(&str, f64); 3] = [("m", 1000.0), ("cm", 10.0), ("mm", 1.0)];

/// The same unit with each other metric length in place of its own, and the factor between the two; empty if it has no metric length.
fn in_metric(own: &str) -> impl Iterator<Item = (String, f64)> {
    let head = own.split('/').next().unwrap_or("");
    let metric = METRIC.iter().find(|m| m.0 == head);
    let others = metric.into_iter().flat_map(move |(_, one)| METRIC.iter().map(move |(name, size)| (name, size / one)));
    others.filter(move |(name, _)| **name != head).map(move |(name, factor)| (own.replacen(head, name, 1), factor))
}

/// The number is right in the scene's unit, not in the one written beside it.
pub(super) fn unit(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (index, entry) in written(site) {
        let Some(unit) = &entry.unit else { continue };
        let factor = entry.factor_without_unit / entry.factor;
        let own = || entry.asked.kind().unit(site.key.solution.scene.units);
        let right = if entry.on_paper { "mm".to_owned() } else { own() };
        found.extend(in_unit(site, tell::wrong_unit, index, factor, [unit, &right]));
    }
    found
}

/// Values where millimetres of paper are asked for: one, or all of a sheet. Millimetres written beside a number may be those of the value.
fn values_for_paper(site: &Site<'_>) -> Vec<Candidate> {
    let is_in_mm = |entry: &Entry| entry.unit.as_deref().is_none_or(|unit| unit == "mm");
    let on_paper = || written(site).filter(|(_, entry)| entry.on_paper && is_in_mm(entry));
    let number = |x: f64| Blank::Number(NumberStyle::significant(5).trimmed().write(x, DecimalMark::Point));
    let unit = |entry: &Entry| Blank::from(entry.asked.kind().unit(site.key.solution.scene.units).as_str());
    let meant = |(index, entry): (usize, &Entry)| {
        let per_mm = entry.factor.abs();
        meant_as(index, entry.value / per_mm, entry.rounding / per_mm)
    };
    let is_other = |entry: &Entry| (entry.factor.abs() - 1.0).abs() > 1e-9;
    let mut found = Vec::new();
    for (index, entry) in on_paper().filter(|(_, entry)| is_other(entry)) {
        let mm = entry.text.parse::<f64>().unwrap_or(0.0) / entry.factor;
        let numbers = (digits(&entry.text), number(entry.factor), number(mm));
        let told = tell::value_for_paper(named(entry), numbers.0, unit(entry), numbers.1, numbers.2);
        found.extend(misread(site, told, vec![meant((index, entry))]));
    }
    for sheet in Sheet::ALL {
        let all: Vec<(usize, &Entry)> = on_paper().filter(|(_, entry)| entry.asked.sheet() == sheet).collect();
        if let Some((_, first)) = all.first().filter(|(_, first)| all.len() > 1 && is_other(first)) {
            let told = tell::values_for_paper(Blank::AllSegments, unit(first), number(first.factor));
            found.extend(misread(site, told, all.iter().map(|one| meant(*one)).collect()));
        }
    }
    found
}

/// No unit is written, and the number is right in another metric unit than the scene's; or it is the value where millimetres of paper
/// are asked for.
pub(super) fn other_unit(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = values_for_paper(site);
    for (index, entry) in written(site) {
        let own = entry.asked.kind().unit(site.key.solution.scene.units);
        // Nothing is nothing in every unit.
        if entry.unit.is_some() || entry.on_paper || entry.value == 0.0 {
            continue;
        }
        let kind = entry.asked.kind();
        let is_like = |other: &Entry| other.asked.kind() == kind && other.unit.is_none() && !other.on_paper;
        let all: Vec<(usize, &Entry)> =
            written(site).filter(|(_, other)| is_like(other) && other.value != 0.0).collect();
        let is_first = all.first().is_some_and(|(first, _)| *first == index);
        for (other, factor) in in_metric(&own) {
            found.extend(in_unit(site, tell::other_unit, index, factor, [&other, &own]));
            if is_first {
                let told = tell::all_in_other_unit(
                    Blank::AllOf(kind),
                    named(entry),
                    other.as_str().into(),
                    own.as_str().into(),
                );
                found.extend(all_meant(site, told, &all, factor));
            }
        }
    }
    found
}

/// What may be said of values of one kind that are all too large or too small by one factor.
type CommonFactor = (f64, fn(Blank, Blank, Blank) -> Told);

/// Factors of rates of rotation in other units than radians per second, and of what is computed with them.
const TURNING: [CommonFactor; 4] = [
    (180.0 / core::f64::consts::PI, tell::common_factor_degrees),
    (core::f64::consts::TAU, tell::common_factor_turns),
    (60.0 / core::f64::consts::TAU, tell::common_factor_rpm),
    (60.0, tell::common_factor_minutes),
];

/// Factors between metric units.
const UNITS: [CommonFactor; 3] =
    [(10.0, tell::common_factor_units), (100.0, tell::common_factor_units), (1000.0, tell::common_factor_units)];

/// The factors that values of a kind may have in common: accelerations those of ω and of ω².
fn common_factors(kind: QuantityKind) -> Vec<CommonFactor> {
    let squares = TURNING.map(|(factor, told)| (factor * factor, told));
    match kind {
        QuantityKind::AngularVelocity => TURNING.to_vec(),
        QuantityKind::AngularAcceleration => [TURNING, squares].concat(),
        QuantityKind::Velocity => [&TURNING[..], &UNITS].concat(),
        QuantityKind::Acceleration => [&TURNING[..], &squares, &UNITS].concat(),
        QuantityKind::Length | QuantityKind::Force | QuantityKind::Moment => UNITS.to_vec(),
        _ => Vec::new(),
    }
}

/// The kinds of values that are looked at for a common factor.
const COMMON: [QuantityKind; 7] = [
    QuantityKind::Length,
    QuantityKind::Velocity,
    QuantityKind::Acceleration,
    QuantityKind::AngularVelocity,
    QuantityKind::AngularAcceleration,
    QuantityKind::Force,
    QuantityKind::Moment,
];

/// All values of a kind, two at least, that one factor brings to the right ones.
pub(super) fn common_factor(site: &Site<'_>) -> Vec<Candidate> {
    let mut found = Vec::new();
    for kind in COMMON {
        // Nothing is nothing times any factor.
        let all: Vec<(usize, &Entry)> =
            written(site).filter(|(_, entry)| entry.asked.kind() == kind && entry.value != 0.0).collect();
        let both = common_factors(kind).into_iter().flat_map(|(factor, told)| [(factor, told), (1.0 / factor, told)]);
        // What a metric unit explains is `other_unit`.
        let unit = kind.unit(site.key.solution.scene.units);
        let is_metric = |factor: f64| in_metric(&unit).any(|(_, other)| (other * factor - 1.0).abs() < 1e-9);
        for (factor, told) in both.filter(|(factor, _)| !is_metric(*factor)) {
            let number = NumberStyle::significant(4).trimmed().write(factor, DecimalMark::Point);
            let Some((_, first)) = all.first() else { continue };
            let told = told(Blank::AllOf(kind), named(first), Blank::Number(number));
            found.extend(all_meant(site, told, &all, 1.0 / factor));
        }
    }
    found
}

/// All values of a kind, two at least, that are meant `factor` times as large.
fn all_meant(site: &Site<'_>, told: Told, all: &[(usize, &Entry)], factor: f64) -> Vec<Candidate> {
    if all.len() < 2 {
        return Vec::new();
    }
    let meant = all.iter().map(|(index, entry)| meant_as(*index, entry.value * factor, entry.rounding * factor));
    let found = misread(site, told, meant.collect());
    found.into_iter().map(|candidate| Candidate { step: 0, ..candidate }).collect()
}

/// A value that is meant in another unit: `factor` times as large. `units`: as the sentences name them.
fn in_unit(
    site: &Site<'_>,
    tell: fn(Blank, Blank, Blank, Blank) -> Told,
    index: usize,
    factor: f64,
    units: [&str; 2],
) -> Vec<Candidate> {
    if !factor.is_finite() || (factor.abs() - 1.0).abs() < 1e-9 {
        return Vec::new();
    }
    let entry = &site.entries[index];
    let meant = meant_as(index, entry.value * factor, entry.rounding * factor.abs());
    let [unit, own] = units.map(Blank::from);
    misread(site, tell(named(entry), digits(&entry.text), unit, own), vec![meant])
}
