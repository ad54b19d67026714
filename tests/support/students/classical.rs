//! What students do, written down from sheets and from teachers' lists, not from the check's catalogue.

use super::act::{Act, Doing, Formula, Value};
use super::mistake::{
    Mistake, Wrong, act_by_lot, anywhere, by, from_to, instead, is_normal, length_for_length, named, one_of, symbol,
    times, turned,
};
use super::plane::QUARTER;
use super::scheme::Scheme;
use super::sheet::ends_of;
use crate::support::random::Random;
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
    (6, normal_left_out),
    (5, normal_outward),
    (5, normal_not_squared),
    (4, normal_with_other_length),
    (4, normal_with_other_rate),
    (3, normal_twice),
    (3, normal_of_absolute),
    (6, ray_turned),
    (5, ray_from_other_point),
    (6, coriolis),
    (4, image),
    (5, other_segment),
    (3, component),
    (3, segment_in_mm),
    (4, ruler_misread),
    (5, rate_with_other_length),
    (5, wrong_sense),
    (6, wrong_unit),
    (6, copied_wrong),
    (3, scheme),
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
fn other_length(random: &mut Random, acts: &[Act], act: &Act) -> Option<([String; 2], f64)> {
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
            let names = vec![named("wrong-sense", &sign), named("reversed-vector", from_to(pin))];
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
        (true, true) => vec![named("normal-outward", from_to(act)), named("reversed-vector", from_to(act))],
        (true, false) => vec![named("reversed-vector", from_to(act))],
        _ => vec![named("turned-vector", from_to(act))],
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

/// The size of a normal part that a ray follows.
fn part(random: &mut Random, acts: &[Act], doing: Doing) -> Option<Act> {
    let fits = |act: &Act| act.doing == doing && is_normal(act) && act.ends[1].starts_with("n_");
    act_by_lot(random, acts, fits).cloned()
}

fn normal_left_out(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = part(random, acts, Doing::Size)?;
    let [from, to] = act.ends.clone();
    let is_blank = random.below(2) == 0;
    let change = by(move |_, sheet| {
        if is_blank {
            sheet.leave_out(2, &from, &to);
        }
        Value::Number(0.0)
    });
    let names = vec![named("normal-forgotten", from_to(&act))];
    Some(Mistake::new("a normal part left out", &act, change, names))
}

fn normal_outward(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = part(random, acts, Doing::Heading)?;
    Some(match random.below(4) {
        0 => Mistake::new(
            "a normal part across its link",
            &act,
            turned(QUARTER),
            vec![named("turned-vector", from_to(&act))],
        ),
        _ => {
            let names = vec![named("normal-outward", from_to(&act)), named("reversed-vector", from_to(&act))];
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

fn normal_not_squared(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = factor_of_part(random, acts, Doing::Rate)?;
    let names = vec![named("omega-not-squared", symbol(&act.link))];
    let change = by(|value, _| Value::Number(libm::sqrt(value.number().abs())));
    Some(Mistake::new("ω not squared", &act, change, names))
}

fn normal_with_other_length(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = factor_of_part(random, acts, Doing::Length)?;
    let ([from, to], length) = other_length(random, acts, &act)?;
    let names = vec![length_for_length(&act, [&from, &to]), anywhere("normal-from-wrong-length")];
    Some(Mistake::new(&format!("a normal part with {from}{to}"), &act, instead(length), names))
}

fn normal_with_other_rate(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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

fn normal_twice(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = part(random, acts, Doing::Size)?;
    Some(match random.below(2) {
        0 => Mistake::new("a normal part with the diameter", &act, times(2.0), vec![named("diameter", from_to(&act))]),
        _ => {
            let names = vec![anywhere("half-the-radius"), anywhere("half-length")];
            Mistake::new("a normal part with half the length", &act, times(0.5), names)
        }
    })
}

fn normal_of_absolute(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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
        vec![named("normal-from-absolute", from_to(size))],
    ))
}

fn ray_turned(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Ray)?;
    let plain =
        |name: &str| if name.ends_with("_ground") { ["p", "π"][act.plan - 1].to_owned() } else { name.to_owned() };
    let words = vec![from_to(act), format!("from {} to {}", plain(&act.ends[0]), act.ends[1])];
    Some(Mistake::new("a ray turned by 90°", act, turned(QUARTER), vec![("turned-ray", words)]))
}

fn ray_from_other_point(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::RayStart)?;
    let places = acts.iter().filter(|other| {
        let is_earlier = [Doing::Size, Doing::RayStart].contains(&other.doing) && other.plan == act.plan;
        is_earlier && other.key() != act.key() && !other.ends[0].is_empty()
    });
    let mut others: Vec<String> =
        places.map(|other| other.ends[0].clone()).filter(|name| *name != act.ends[0]).collect();
    others.dedup();
    let other = one_of(random, &others)?.clone();
    let words = vec![format!("to {} was drawn through {other}", act.ends[1])];
    let (plan, text) = (act.plan, format!("a ray through {other}"));
    let change = by(move |_, sheet| Value::Place(sheet.at(plan, &other)));
    Some(Mistake::new(&text, act, change, vec![("ray-from-wrong-point", words)]))
}

fn coriolis(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let fits = |doing| move |act: &Act| act.doing == doing && act.formula == Formula::Coriolis;
    let act = act_by_lot(random, acts, fits(Doing::Size))?;
    let [from, to] = act.ends.clone();
    Some(match random.below(5) {
        0 | 1 => {
            let change = by(move |_, sheet| {
                sheet.leave_out(2, &from, &to);
                Value::Number(0.0)
            });
            Mistake::new("Coriolis left out", act, change, vec![anywhere("coriolis-forgotten")])
        }
        2 => Mistake::new("Coriolis without 2", act, times(0.5), vec![anywhere("coriolis-without-2")]),
        3 => {
            let names = vec![anywhere("coriolis-turned"), named("reversed-vector", from_to(act))];
            Mistake::new("Coriolis reversed", act, times(-1.0), names)
        }
        _ => {
            let act = act_by_lot(random, acts, fits(Doing::Heading))?;
            let names = vec![
                anywhere("coriolis-along-guide"),
                named("turned-vector", from_to(act)),
                anywhere("coriolis-direction"),
            ];
            Mistake::new("Coriolis along the guide", act, turned(QUARTER), names)
        }
    })
}

fn image(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Ratio)?;
    let point = super::sheet::image_of(&act.ends[1]);
    Some(match random.below(2) {
        0 => {
            let change = by(|value, _| Value::Place(value.place().conj()));
            Mistake::new("an image on the wrong side", act, change, vec![named("mirrored-image", format!("{point} "))])
        }
        _ => {
            let change = by(|value, _| Value::Place(super::plane::Place::new(1.0, 0.0) - value.place().conj()));
            let names = vec![named("wrong-ratio", format!("{point} ")), named("ends-exchanged", point.clone())];
            Mistake::new("an image with its ends exchanged", act, change, names)
        }
    })
}

/// A reading that the form asks for.
fn reading(random: &mut Random, acts: &[Act]) -> Option<Act> {
    act_by_lot(random, acts, |act| act.doing == Doing::Reading && !act.quantity.is_empty() && act.plan > 0).cloned()
}

fn other_segment(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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

fn component(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = reading(random, acts)?;
    let (plan, [start, end], axis) = (act.plan, act.ends.clone(), random.below(2));
    let change = by(move |_, sheet| {
        let vector = sheet.at(plan, &end) - sheet.at(plan, &start);
        Value::Number([vector.re, vector.im][axis].abs() * sheet.scale(plan))
    });
    Some(Mistake::new("a component for the length", &act, change, vec![named("component", act.quantity.clone())]))
}

fn segment_in_mm(random: &mut Random, acts: &[Act], scheme: &Scheme) -> Option<Mistake> {
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

fn ruler_misread(random: &mut Random, acts: &[Act], scheme: &Scheme) -> Option<Mistake> {
    let act = reading(random, acts)?;
    let by_mm = [10.0, -10.0][random.below(2)] * scheme.scales[act.plan];
    let names = vec![named("misread-ruler", act.quantity.clone()), named("ruler-misread", act.quantity.clone())];
    let change = by(move |value, _| Value::Number((value.number() + by_mm).abs()));
    Some(Mistake::new("the ruler misread by 10 mm", &act, change, names))
}

fn rate_with_other_length(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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

fn wrong_sense(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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

fn wrong_unit(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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

fn copied_wrong(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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

fn scheme(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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
