//! What students do, written down from sheets and from teachers' lists, not from the check's catalogue.

use super::act::{Act, Doing, Formula, Value};
use super::copied;
use super::drawn;
use super::mistake::{
    Mistake, act_by_lot, anywhere, by, from_to, instead, is_normal, length_for_length, named, one_of, symbol, times,
    turned,
};
use super::parts;
use super::plane::QUARTER;
use super::scheme::Scheme;
use crate::random::Random;
use std::f64::consts::PI;

/// Chooses an act and says what becomes of it; none where the sheet has no such act.
type Kind = fn(&mut Random, &[Act], &Scheme) -> Option<Mistake>;

/// The kinds with how often each is made.
const KINDS: [(u32, Kind); 25] = [
    (3, crank_length),
    (3, crank_rate),
    (3, crank_direction),
    (2, crank_normal),
    (2, crank_tangential),
    (6, parts::normal_left_out),
    (5, parts::normal_outward),
    (5, parts::normal_not_squared),
    (4, parts::normal_with_other_length),
    (4, parts::normal_with_other_rate),
    (3, parts::normal_twice),
    (3, parts::normal_of_absolute),
    (6, drawn::ray_turned),
    (5, drawn::ray_from_other_point),
    (6, drawn::coriolis),
    (4, drawn::image),
    (5, copied::other_segment),
    (3, copied::component),
    (3, copied::segment_in_mm),
    (4, copied::ruler_misread),
    (5, copied::rate_with_other_length),
    (5, copied::wrong_sense),
    (6, copied::wrong_unit),
    (6, copied::copied_wrong),
    (3, copied::scheme),
];

/// A classical mistake by lot.
pub fn classical(random: &mut Random, acts: &[Act], scheme: &Scheme) -> Option<Mistake> {
    let all: u32 = KINDS.iter().map(|(often, _)| often).sum();
    let mut lot = random.below(all as usize) as u32;
    let kind = KINDS.iter().find(|(often, _)| {
        let is_here = lot < *often;
        lot = lot.wrapping_sub(if is_here { 0 } else { *often });
        is_here
    });
    kind.and_then(|(_, kind)| kind(random, acts, scheme))
}

fn is_crank(act: &Act) -> bool {
    act.quantity == "crank"
}

/// Another given or measured length, with its ends.
pub fn other_length(random: &mut Random, acts: &[Act], act: &Act) -> Option<([String; 2], f64)> {
    let mut own = act.ends.clone();
    own.sort();
    let others = acts.iter().filter(|other| {
        let mut ends = other.ends.clone();
        ends.sort();
        other.doing == Doing::Length && ends != own
    });
    let others: Vec<&Act> = others.collect();
    one_of(random, &others).map(|other| (other.ends.clone(), other.value.number()))
}

fn crank_length(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Length && is_crank(act))?;
    let own = format!("L_{}{}", act.ends[0], act.ends[1]);
    Some(match random.below(3) {
        0 => {
            let words = vec![own, format!("ω_{}", act.link)];
            Mistake::new("the crank's diameter", act, times(2.0), vec![("diameter", words)])
        }
        1 => Mistake::new(
            "half the crank's radius",
            act,
            times(0.5),
            vec![anywhere("half-the-radius"), anywhere("half-length")],
        ),
        _ => {
            let ([from, to], length) = other_length(random, acts, act)?;
            let names = vec![length_for_length(act, [&from, &to])];
            Mistake::new(&format!("{from}{to} for the crank's length"), act, instead(length), names)
        }
    })
}

fn crank_rate(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Rate && is_crank(act))?;
    let sign = symbol(&act.link);
    let pin =
        acts.iter().find(|other| other.formula == Formula::Turning && act.link == format!("omega({})", other.link))?;
    Some(match random.below(3) {
        0 => {
            let names = vec![named("wrong-sense", &sign), from_to("reversed-vector", pin)];
            Mistake::new("the crank turned the wrong way", act, times(-1.0), names)
        }
        1 => {
            let names = vec![named("revolutions-for-radians", sign)];
            Mistake::new("rad/s taken for rpm", act, times(PI / 30.0), names)
        }
        _ => Mistake::new("rad/s taken for rev/s", act, times(2.0 * PI), vec![anywhere("revolutions-per-second")]),
    })
}

fn crank_direction(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let fits = |act: &Act| {
        act.doing == Doing::Heading
            && (act.formula == Formula::Turning || act.ends[0] == "π")
            && act.formula != Formula::Tangential
    };
    let act = act_by_lot(random, acts, fits)?;
    let names = |half: bool| match (half, is_normal(act)) {
        (true, true) => vec![from_to("normal-outward", act), from_to("reversed-vector", act)],
        (true, false) => vec![from_to("reversed-vector", act)],
        _ => vec![from_to("turned-vector", act)],
    };
    Some(match random.below(2) {
        0 => Mistake::new("the crank's vector reversed", act, turned(PI), names(true)),
        _ => Mistake::new("the crank's vector turned by 90°", act, turned(QUARTER), names(false)),
    })
}

fn crank_normal(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let fits = |act: &Act| {
        act.doing == Doing::Rate && act.plan == 2 && act.quantity.starts_with("π ") && act.link.starts_with("omega")
    };
    let act = act_by_lot(random, acts, fits)?;
    let names = vec![named("omega-not-squared", symbol(&act.link))];
    let change = by(|value, _| Value::Number(libm::sqrt(value.number().abs())));
    Some(Mistake::new("the crank's ω not squared", act, change, names))
}

fn crank_tangential(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let fits = |act: &Act| act.doing == Doing::Size && act.formula == Formula::Tangential && act.ends[0] == "π";
    let act = act_by_lot(random, acts, fits)?;
    if act.value.number() != 0.0 {
        let names = vec![anywhere("tangential-forgotten")];
        return Some(Mistake::new("the crank's tangential part left out", act, instead(0.0), names));
    }
    let pin = act.ends[1].clone();
    let change = by(move |_, sheet| Value::Number(sheet.read(1, "p", &pin)));
    let names = vec![anywhere("tangential-where-none")];
    Some(Mistake::new("a tangential part of a crank that turns evenly", act, change, names))
}
