//! A student's mistake: which acts it changes, and what a teacher who sees the sheet would say of it.

use super::act::{Act, Change, Doing, Formula, Value};
use super::sheet::Sheet;
use crate::random::Random;
use std::rc::Rc;

/// An id of the check, and words of which its sentence must hold one; no words: any sentence will do.
pub type Name = (&'static str, Vec<String>);

/// A mistake as it is put into a drawing.
#[derive(Clone)]
pub struct Mistake {
    pub text: String,
    /// What every student does now and then; else a slip that no catalogue can name.
    pub is_classical: bool,
    /// The acts by their keys, and what becomes of them.
    pub changes: Vec<(String, Change)>,
    /// The scene by which the scheme is drawn, where that is not the given one.
    pub scheme: Option<Wrong>,
    /// The names under which it may be told.
    pub names: Vec<Name>,
    /// What may be told beside these, as it is true, too, but does not name it.
    pub beside: Vec<Name>,
    /// Where it begins, if that is said by the mistake itself; else the first value that it changes.
    pub begins: Vec<String>,
}

/// A scheme that is drawn wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wrong {
    /// The drive's angle is misread: by so many degrees.
    Angle(f64),
    /// The position of the joints is another one.
    Mode,
}

impl Mistake {
    pub fn new(text: &str, act: &Act, change: Change, names: Vec<Name>) -> Mistake {
        Mistake {
            text: format!("{text}: {}", act.key()),
            is_classical: true,
            changes: vec![(act.key(), change)],
            scheme: None,
            names,
            beside: Vec::new(),
            begins: match act.doing {
                Doing::Found | Doing::Written => vec![act.quantity.clone()],
                Doing::Sense | Doing::Length if act.quantity.ends_with(')') => vec![act.quantity.clone()],
                _ => Vec::new(),
            },
        }
    }

    pub fn random(mut self) -> Mistake {
        self.is_classical = false;
        self
    }
}

/// The value times a factor.
pub fn times(factor: f64) -> Change {
    Rc::new(move |value, _| Value::Number(value.number() * factor))
}

/// Another number in its place.
pub fn instead(number: f64) -> Change {
    Rc::new(move |_, _| Value::Number(number))
}

/// A direction turned by so many radians.
pub fn turned(angle: f64) -> Change {
    Rc::new(move |value, _| Value::Number(value.number() + angle))
}

/// A change that asks the sheet.
pub fn by(change: impl Fn(Value, &mut Sheet<'_>) -> Value + 'static) -> Change {
    Rc::new(change)
}

/// One that fits of a list, by lot.
pub fn one_of<'a, T>(random: &mut Random, all: &'a [T]) -> Option<&'a T> {
    (!all.is_empty()).then(|| &all[random.below(all.len())])
}

/// An act by lot, of those that fit.
pub fn act_by_lot<'a>(random: &mut Random, acts: &'a [Act], fits: impl Fn(&Act) -> bool) -> Option<&'a Act> {
    let fitting: Vec<&Act> = acts.iter().filter(|act| fits(act)).collect();
    one_of(random, &fitting).copied()
}

/// The symbol of a rate in sentences: `ω_2` for `omega(2)`.
pub fn symbol(rate: &str) -> String {
    let inner = |head: &str| rate.strip_prefix(head).and_then(|name| name.strip_suffix(')'));
    match (inner("omega("), inner("alpha(")) {
        (Some(link), _) => format!("ω_{link}"),
        (_, Some(link)) => format!("α_{link}"),
        _ => rate.to_owned(),
    }
}

/// How sentences name the ends of a vector or ray; what is at rest has its image in the pole.
pub fn from_to(id: &'static str, act: &Act) -> Name {
    let [from, to] = &act.ends;
    // A crank's normal part is told with its pin.
    let pin = to.strip_prefix("n_").filter(|pin| pin.chars().all(|c| !c.is_uppercase())).unwrap_or(to);
    let both = [from.as_str(), pole(act.plan)].into_iter();
    (id, both.flat_map(|from| [to.as_str(), pin].map(|to| format!("from {from} to {to} "))).collect())
}

/// The name of a plan's pole.
pub fn pole(plan: usize) -> &'static str {
    ["", "p", "π"][plan]
}

/// A name with one text that its sentence must hold.
pub fn named(id: &'static str, word: impl Into<String>) -> Name {
    (id, vec![word.into()])
}

/// A name that is right wherever it is told.
pub fn anywhere(id: &'static str) -> Name {
    (id, Vec::new())
}

/// How sentences say that another length was taken for the one of an act.
pub fn length_for_length(act: &Act, [from, to]: [&str; 2]) -> Name {
    // The point of a link under a joint has the joint's place.
    let ways = |[a, b]: [&str; 2]| {
        let [c, d] = [a, b].map(|name| name.split('_').next().unwrap_or_default().to_owned());
        [[a.to_owned(), b.to_owned()], [b.to_owned(), a.to_owned()], [c.clone(), d.clone()], [d, c]]
    };
    let own = ways([&act.ends[0], &act.ends[1]]).map(|[a, b]| format!("L_{a}{b}"));
    let ends = ways([from, to]).map(|[a, b]| format!("the length from {a} to {b}"));
    let all = own.iter().flat_map(|own| ends.iter().map(move |ends| format!("for {own} {ends}")));
    ("wrong-length", all.collect())
}

pub fn is_normal(act: &Act) -> bool {
    act.formula == Formula::Normal && act.plan == 2
}
