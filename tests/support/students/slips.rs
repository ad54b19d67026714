//! Slips that no catalogue can name: any act, by any factor, angle or way.

use super::act::{Act, Doing, Value};
use super::mistake::{Mistake, act_by_lot, anywhere, by, named, times, turned};
use super::plane::{DEGREE, Place, unit};
use super::scheme::Scheme;
use crate::random::Random;

/// Between ½ and 2, which a diameter would be, but not nearly 1.
fn factor(random: &mut Random) -> f64 {
    loop {
        let factor = libm::pow(2.0, random.within(0.9));
        if !(0.9..=1.1).contains(&factor) {
            return factor;
        }
    }
}

/// From 5° to 90°, either way.
fn angle(random: &mut Random) -> f64 {
    (5.0 + 85.0 * random.unit()) * [DEGREE, -DEGREE][random.below(2)]
}

/// A slip by lot.
pub fn slip(random: &mut Random, acts: &[Act], scheme: &Scheme) -> Option<Mistake> {
    let mistake = match random.below(10) {
        0..=4 => number(random, acts)?,
        5 | 6 => direction(random, acts)?,
        7 => place(random, acts)?,
        8 => ruler(random, acts, scheme)?,
        _ => ratio(random, acts).or_else(|| number(random, acts))?,
    };
    Some(mistake.random())
}

/// A number that comes out wrong: in a computation, on the ruler, or where it is written.
fn number(random: &mut Random, acts: &[Act]) -> Option<Mistake> {
    let kinds = [Doing::Size, Doing::Found, Doing::Written, Doing::Length, Doing::Rate, Doing::Reading];
    let doing = kinds[random.below(kinds.len())];
    let act = act_by_lot(random, acts, |act| act.doing == doing && act.value != Value::Number(0.0))?;
    let factor = factor(random);
    Some(Mistake::new(&format!("× {factor:.3}"), act, times(factor), slip_names(act)))
}

/// A slip of arithmetic, told where it begins.
fn slip_names(act: &Act) -> Vec<super::mistake::Name> {
    match act.quantity.ends_with(')') {
        true => vec![named("arithmetic-slip", act.quantity.clone())],
        false => vec![anywhere("arithmetic-slip")],
    }
}

fn direction(random: &mut Random, acts: &[Act]) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| [Doing::Heading, Doing::Ray].contains(&act.doing))?;
    let angle = angle(random);
    let mut mistake = Mistake::new(&format!("turned by {:.0}°", angle / DEGREE), act, turned(angle), Vec::new());
    // Along a link nobody can say in which sense a segment turns it.
    mistake.beside = vec![anywhere("wrong-sense")];
    Some(mistake)
}

/// A vector or ray that begins somewhere else.
fn place(random: &mut Random, acts: &[Act]) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| [Doing::Start, Doing::RayStart].contains(&act.doing))?;
    let away = unit(random.angle()) * (10.0 + 20.0 * random.unit());
    let change = by(move |value, _| Value::Place(value.place() + away));
    Some(Mistake::new("begun elsewhere", act, change, Vec::new()))
}

/// A ruler that does not lie with its zero at the segment's end.
fn ruler(random: &mut Random, acts: &[Act], scheme: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Reading)?;
    let off = (4.0 + 10.0 * random.unit()) * [1.0, -1.0][random.below(2)] * scheme.scales[act.plan];
    let change = by(move |value, _| Value::Number((value.number() + off).abs()));
    Some(Mistake::new("the ruler shifted", act, change, slip_names(act)))
}

fn ratio(random: &mut Random, acts: &[Act]) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Ratio)?;
    let turn: Place = unit(angle(random)) * factor(random);
    let change = by(move |value, _| Value::Place(value.place() * turn));
    Some(Mistake::new("an image anywhere", act, change, Vec::new()))
}
