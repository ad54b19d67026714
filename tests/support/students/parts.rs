//! Classical mistakes in normal parts.

use super::act::{Act, Doing, Value};
use super::classical::other_length;
use super::mistake::{
    Mistake, act_by_lot, anywhere, by, from_to, instead, is_normal, length_for_length, named, one_of, pole, symbol,
    times, turned,
};
use super::plane::QUARTER;
use super::scheme::Scheme;
use crate::random::Random;
use std::f64::consts::PI;

/// The size of a normal part that a ray follows.
fn part(random: &mut Random, acts: &[Act], doing: Doing) -> Option<Act> {
    let fits = |act: &Act| act.doing == doing && is_normal(act) && act.ends[1].starts_with("n_");
    act_by_lot(random, acts, fits).cloned()
}

pub fn normal_left_out(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = part(random, acts, Doing::Size)?;
    let [from, to] = act.ends.clone();
    let is_blank = random.below(2) == 0;
    let change = by(move |_, sheet| {
        if is_blank {
            sheet.leave_out(2, &from, &to);
        }
        Value::Number(0.0)
    });
    // What comes after it begins where it would have begun.
    let begun = [act.ends[0].as_str(), pole(2)].map(|from| format!(" was drawn through {from} "));
    let names = vec![from_to("normal-forgotten", &act), ("ray-from-wrong-point", begun.to_vec())];
    Some(Mistake::new("a normal part left out", &act, change, names))
}

pub fn normal_outward(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = part(random, acts, Doing::Heading)?;
    Some(match random.below(4) {
        0 => Mistake::new("a normal part across its link", &act, turned(QUARTER), vec![from_to("turned-vector", &act)]),
        _ => {
            let names = vec![from_to("normal-outward", &act), from_to("reversed-vector", &act)];
            Mistake::new("a normal part outward", &act, turned(PI), names)
        }
    })
}

/// A rate or length that enters a normal part.
fn factor_of_part(random: &mut Random, acts: &[Act], doing: Doing) -> Option<Act> {
    let fits = |act: &Act| {
        act.doing == doing
            && act.plan == 2
            && act.quantity.contains(" n_")
            && (doing != Doing::Rate || act.link.starts_with("omega"))
    };
    act_by_lot(random, acts, fits).cloned()
}

pub fn normal_not_squared(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = factor_of_part(random, acts, Doing::Rate)?;
    let names = vec![named("omega-not-squared", symbol(&act.link))];
    let change = by(|value, _| Value::Number(libm::sqrt(value.number().abs())));
    Some(Mistake::new("ω not squared", &act, change, names))
}

pub fn normal_with_other_length(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = factor_of_part(random, acts, Doing::Length)?;
    let ([from, to], length) = other_length(random, acts, &act)?;
    let names = vec![length_for_length(&act, [&from, &to]), anywhere("normal-from-wrong-length")];
    Some(Mistake::new(&format!("a normal part with {from}{to}"), &act, instead(length), names))
}

pub fn normal_with_other_rate(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = factor_of_part(random, acts, Doing::Rate)?;
    let others = acts.iter().filter(|other| {
        other.doing == Doing::Found && other.quantity.starts_with("omega") && other.quantity != act.link
    });
    let others: Vec<String> = others.map(|other| other.quantity.clone()).chain(["omega(1)".to_owned()]).collect();
    let other = one_of(random, &others)?.clone();
    let text = format!("a normal part with {other}");
    let change = by(move |value, sheet| Value::Number(sheet.rates.get(&other).copied().unwrap_or(value.number())));
    Some(Mistake::new(&text, &act, change, vec![anywhere("omega-of-another-link")]))
}

pub fn normal_twice(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = part(random, acts, Doing::Size)?;
    Some(match random.below(2) {
        0 => Mistake::new("a normal part with the diameter", &act, times(2.0), vec![from_to("diameter", &act)]),
        _ => {
            let names = vec![anywhere("half-the-radius"), anywhere("half-length")];
            Mistake::new("a normal part with half the length", &act, times(0.5), names)
        }
    })
}

pub fn normal_of_absolute(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = factor_of_part(random, acts, Doing::Rate)?;
    let size = acts
        .iter()
        .find(|size| size.doing == Doing::Size && format!("{} {}", size.ends[0], size.ends[1]) == act.quantity)?;
    let length = acts.iter().find(|length| length.doing == Doing::Length && length.quantity == act.quantity)?;
    let image = super::sheet::image_of(&length.ends[1]);
    let length = length.value.number();
    let change = by(move |_, sheet| {
        let speed = sheet.read(1, "p", &image);
        Value::Number(speed * speed / length)
    });
    Some(Mistake::new(
        "a normal part from the absolute velocity",
        size,
        change,
        vec![from_to("normal-from-absolute", size)],
    ))
}
