//! Classical mistakes in measuring, in rates, in units, in copying, and on the scheme.

use super::act::{Act, Doing, Value};
use super::classical::other_length;
use super::mistake::{
    Mistake, Wrong, act_by_lot, anywhere, by, instead, length_for_length, named, one_of, symbol, times,
};
use super::scheme::Scheme;
use super::sheet::ends_of;
use crate::random::Random;
use std::f64::consts::PI;

/// A reading that the form asks for.
fn reading(random: &mut Random, acts: &[Act]) -> Option<Act> {
    act_by_lot(random, acts, |act| act.doing == Doing::Reading && !act.quantity.is_empty() && act.plan > 0).cloned()
}

pub fn other_segment(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = reading(random, acts)?;
    // From another point to the same image.
    let starts = acts.iter().filter(|other| {
        [Doing::Reading, Doing::RayStart, Doing::Size].contains(&other.doing)
            && other.plan == act.plan
            && other.ends[0] != act.ends[0]
    });
    let starts: Vec<String> = starts.map(|other| other.ends[0].clone()).collect();
    let start = one_of(random, &starts)?.clone();
    let (plan, end) = (act.plan, act.ends[1].clone());
    let text = format!("{start} {end} measured");
    let change = by(move |_, sheet| Value::Number(sheet.measured(plan, &start, &end)));
    Some(Mistake::new(&text, &act, change, vec![named("wrong-segment", act.quantity.clone())]))
}

pub fn component(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = reading(random, acts)?;
    let (plan, [start, end], axis) = (act.plan, act.ends.clone(), random.below(2));
    let change = by(move |_, sheet| {
        let vector = sheet.at(plan, &end) - sheet.at(plan, &start);
        Value::Number([vector.re, vector.im][axis].abs() * sheet.scale(plan))
    });
    Some(Mistake::new("a component for the length", &act, change, vec![named("component", act.quantity.clone())]))
}

pub fn segment_in_mm(random: &mut Random, acts: &[Act], scheme: &Scheme) -> Option<Mistake> {
    let act = reading(random, acts)?;
    let change = times(1.0 / scheme.scales[act.plan]);
    if random.below(2) == 0 {
        return Some(Mistake::new("a segment in mm", &act, change, vec![named("wrong-scale", act.quantity.clone())]));
    }
    let mut mistake =
        Mistake::new("all segments of a plan in mm", &act, change.clone(), vec![named("wrong-scale", "all segments")]);
    let others = acts.iter().filter(|other| other.doing == Doing::Written);
    let others = others.filter(|other| ends_of(&other.quantity).is_some_and(|(plan, ..)| plan == act.plan));
    mistake.changes = others.map(|other| (other.key(), change.clone())).collect();
    mistake.begins = acts
        .iter()
        .filter(|other| mistake.changes.iter().any(|(key, _)| *key == other.key()))
        .map(|o| o.quantity.clone())
        .collect();
    Some(mistake)
}

pub fn ruler_misread(random: &mut Random, acts: &[Act], scheme: &Scheme) -> Option<Mistake> {
    let act = reading(random, acts)?;
    let by_mm = [10.0, -10.0][random.below(2)] * scheme.scales[act.plan];
    let names = vec![named("misread-ruler", act.quantity.clone()), named("ruler-misread", act.quantity.clone())];
    let change = by(move |value, _| Value::Number((value.number() + by_mm).abs()));
    Some(Mistake::new("the ruler misread by 10 mm", &act, change, names))
}

pub fn rate_with_other_length(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let fits = |act: &Act| {
        act.doing == Doing::Length && (act.quantity.starts_with("omega(") || act.quantity.starts_with("alpha("))
    };
    let act = act_by_lot(random, acts, fits)?;
    let id = if act.quantity.starts_with("omega") { "omega-from-wrong-length" } else { "alpha-from-wrong-length" };
    if random.below(4) == 0 {
        let names = vec![anywhere("not-divided-by-length"), anywhere("not-divided")];
        return Some(Mistake::new("not divided by the length", act, instead(1000.0), names));
    }
    let ([from, to], length) = other_length(random, acts, act)?;
    let names = vec![named(id, symbol(&act.quantity)), length_for_length(act, [&from, &to])];
    Some(Mistake::new(&format!("{} from {from}{to}", act.quantity), act, instead(length), names))
}

pub fn wrong_sense(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let fits = |act: &Act| [Doing::Sense, Doing::Found, Doing::Written].contains(&act.doing) && is_rate(&act.quantity);
    let act = act_by_lot(random, acts, fits)?;
    if random.below(4) == 0 {
        let all: Vec<&Act> = acts.iter().filter(|act| act.doing == Doing::Written && is_rate(&act.quantity)).collect();
        let names = vec![anywhere("senses-reversed"), ("wrong-sense", Vec::new())];
        let mut mistake = Mistake::new("clockwise counted as positive", act, times(-1.0), names);
        mistake.changes = all.iter().map(|act| (act.key(), times(-1.0))).collect();
        mistake.begins = all.iter().map(|act| act.quantity.clone()).collect();
        return Some(mistake);
    }
    Some(Mistake::new("the wrong sense", act, times(-1.0), vec![named("wrong-sense", symbol(&act.quantity))]))
}

fn is_rate(quantity: &str) -> bool {
    ["omega(", "alpha(", "v_r(", "a_r("].iter().any(|head| quantity.starts_with(head))
}

pub fn wrong_unit(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let fits = |act: &Act| [Doing::Found, Doing::Written].contains(&act.doing) && !act.quantity.is_empty();
    let act = act_by_lot(random, acts, fits)?;
    let turns = act.quantity.starts_with("omega(") || act.quantity.starts_with("alpha(");
    let sign = symbol(&act.quantity);
    Some(match (turns, random.below(2)) {
        (true, 0) => Mistake::new("rpm for rad/s", act, times(30.0 / PI), vec![named("revolutions-for-radians", sign)]),
        (true, _) => {
            Mistake::new("degrees for radians", act, times(180.0 / PI), vec![named("degrees-for-radians", sign)])
        }
        _ => {
            let names = vec![named("other-unit", act.quantity.clone()), named("decimal-slipped", act.quantity.clone())];
            Mistake::new("metres for millimetres", act, times(1e-3), names)
        }
    })
}

pub fn copied_wrong(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Written)?;
    let quantity = act.quantity.clone();
    Some(match random.below(3) {
        0 => {
            let names = vec![named("decimal-slipped", quantity)];
            Mistake::new("a decimal slipped", act, times([10.0, 0.1][random.below(2)]), names)
        }
        1 => {
            let place = random.below(2);
            let change = by(move |value, _| Value::Number(transposed(value.number(), place)));
            Mistake::new("digits transposed", act, change, vec![named("digits-transposed", quantity)])
        }
        _ => {
            let head = |name: &str| name.split('(').next().map(str::to_owned);
            let fits = |other: &Act| {
                other.doing == Doing::Written && other.quantity != quantity && head(&other.quantity) == head(&quantity)
            };
            let other = act_by_lot(random, acts, fits)?;
            let [mine, its] = [act.quantity.clone(), other.quantity.clone()];
            let words = [[&mine, &its], [&its, &mine]].map(|[a, b]| format!("{a} and {b}"));
            let take = |from: String| by(move |_, sheet| Value::Number(sheet.quiet(&from)));
            let mut mistake = Mistake::new("boxes swapped", act, take(its.clone()), vec![("swapped", words.to_vec())]);
            mistake.changes.push((other.key(), take(mine.clone())));
            mistake.begins = vec![mine, its];
            mistake
        }
    })
}

/// Two neighbouring of the first three digits in each other's place.
fn transposed(number: f64, place: usize) -> f64 {
    let text = format!("{number:.3e}");
    let mut written: Vec<char> = text.chars().collect();
    let digits: Vec<usize> = (0..written.len()).filter(|&k| written[k].is_ascii_digit()).collect();
    written.swap(digits[place], digits[place + 1]);
    written.into_iter().collect::<String>().parse().unwrap_or(number)
}

pub fn scheme(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = acts.first()?;
    let is_mode = random.below(2) == 0;
    let names = match is_mode {
        true => vec![anywhere("other-mode")],
        false => {
            vec![anywhere("crank-angle"), anywhere("angle-misread"), anywhere("wrong-angle"), anywhere("drive-angle")]
        }
    };
    let by = [10.0, -10.0, 20.0, -20.0, 30.0][random.below(5)];
    let wrong = if is_mode { Wrong::Mode } else { Wrong::Angle(by) };
    let mut mistake = Mistake::new(&format!("{wrong:?}"), act, times(1.0), names);
    mistake.changes.clear();
    mistake.begins.clear();
    mistake.scheme = Some(wrong);
    Some(mistake)
}
