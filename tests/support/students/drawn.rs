//! Classical mistakes in rays, Coriolis parts and images.

use super::act::{Act, Doing, Formula, Value};
use super::mistake::{Mistake, act_by_lot, anywhere, by, from_to, named, one_of, pole, times, turned};
use super::plane::QUARTER;
use super::scheme::Scheme;
use crate::random::Random;

pub fn ray_turned(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::Ray)?;
    let mut mistake = Mistake::new("a ray turned by 90°", act, turned(QUARTER), vec![from_to("turned-ray", act)]);
    // Along a link nobody can say in which sense a segment turns it.
    mistake.beside = vec![anywhere("wrong-sense")];
    Some(mistake)
}

pub fn ray_from_other_point(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
    let act = act_by_lot(random, acts, |act| act.doing == Doing::RayStart)?;
    let places = acts.iter().filter(|other| {
        let is_earlier = [Doing::Size, Doing::RayStart].contains(&other.doing) && other.plan == act.plan;
        is_earlier && other.key() != act.key() && !other.ends[0].is_empty()
    });
    let mut others: Vec<String> =
        places.map(|other| other.ends[0].clone()).filter(|name| *name != act.ends[0]).collect();
    others.dedup();
    let other = one_of(random, &others)?.clone();
    let words =
        [other.as_str(), pole(act.plan)].map(|other| format!("to {} was drawn through {other} ", act.ends[1])).to_vec();
    let (plan, text) = (act.plan, format!("a ray through {other}"));
    let change = by(move |_, sheet| Value::Place(sheet.at(plan, &other)));
    Some(Mistake::new(&text, act, change, vec![("ray-from-wrong-point", words)]))
}

pub fn coriolis(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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
            let names = vec![anywhere("coriolis-turned"), from_to("reversed-vector", act)];
            Mistake::new("Coriolis reversed", act, times(-1.0), names)
        }
        _ => {
            let act = act_by_lot(random, acts, fits(Doing::Heading))?;
            let names =
                vec![anywhere("coriolis-along-guide"), from_to("turned-vector", act), anywhere("coriolis-direction")];
            Mistake::new("Coriolis along the guide", act, turned(QUARTER), names)
        }
    })
}

pub fn image(random: &mut Random, acts: &[Act], _: &Scheme) -> Option<Mistake> {
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
