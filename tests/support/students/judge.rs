//! Whether the check names what a student did wrong.

use super::mistake::Name;
use super::task::{Cause, Planned};
use kinegon::check::CheckResult;

/// A mistake that the check tells.
#[derive(Clone, Debug)]
pub struct Told {
    pub id: &'static str,
    pub sentence: String,
    /// The first value that it touches; none where it is told of the whole drawing.
    pub first: Option<String>,
}

/// Mistakes that the check tells together.
#[derive(Clone, Debug)]
pub struct Explanation {
    pub told: Vec<Told>,
    pub probability: f64,
}

/// What the check says of a sheet.
#[derive(Clone, Debug)]
pub struct Said {
    /// The diagnosis, and behind it what the values cannot tell from it.
    pub explanations: Vec<Explanation>,
    pub unexplained: Vec<String>,
    pub has_passed: bool,
}

impl Said {
    pub fn new(result: &CheckResult) -> Said {
        let alike = result.others.iter().filter(|other| other.indistinguishable);
        let explanations = core::iter::once(&result.diagnosis).chain(alike).map(|explanation| {
            let told = explanation.mistakes.iter().map(|told| {
                let values = if told.written.is_empty() { &told.follows } else { &told.written };
                let first = values.first().filter(|_| told.step > 0).cloned();
                Told { id: told.mistake, sentence: told.done.clone(), first }
            });
            Explanation { told: told.collect(), probability: explanation.probability }
        });
        Said {
            explanations: explanations.collect(),
            unexplained: result.unexplained.clone(),
            has_passed: result.passed,
        }
    }

    /// What it tells in the first place.
    pub fn diagnosis(&self) -> &Explanation {
        &self.explanations[0]
    }
}

/// What is told of a sheet with mistakes, from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// Every mistake is told, and nothing false beside it.
    Named,
    /// Nothing false is told, but a mistake is only placed: something that begins at the same value.
    Located,
    /// No mistake is told, values are off.
    Honest,
    /// Something false is told, with a probability of ½ or more.
    Wrong,
    /// Something false is told, with less.
    WeaklyWrong,
    /// No mistake is told, no value is off.
    NotFlagged,
}

pub const CLASSES: [(Class, &str); 6] = [
    (Class::Named, "named"),
    (Class::Located, "located"),
    (Class::Honest, "honest"),
    (Class::Wrong, "wrong"),
    (Class::WeaklyWrong, "weakly wrong"),
    (Class::NotFlagged, "not flagged"),
];

/// Whether a told mistake is one of the names of a cause.
fn is_named(told: &Told, cause: &Cause) -> bool {
    is_among(told, &cause.names)
}

/// Whether a told mistake is one of these; a word ends where a comma, a colon or the sentence does.
fn is_among(told: &Told, names: &[Name]) -> bool {
    let sentence = format!("{} ", told.sentence).replace(", ", " ").replace(": ", " ");
    let fits = |words: &[String]| words.is_empty() || words.iter().any(|word| sentence.contains(word));
    names.iter().any(|(id, words)| *id == told.id && fits(words))
}

/// Whether the first value that a told mistake touches is where a cause begins.
fn begins_at(told: &Told, cause: &Cause) -> bool {
    told.first.as_ref().is_some_and(|first| cause.begins.contains(first))
}

/// The class of what is told: the best of those that the values cannot tell apart.
pub fn class(said: &Said, planned: &Planned) -> Class {
    let all = said.explanations.iter().map(|explanation| class_of(explanation, said, planned));
    all.min().unwrap_or(Class::NotFlagged)
}

fn class_of(explanation: &Explanation, said: &Said, planned: &Planned) -> Class {
    let (told, causes) = (&explanation.told, &planned.causes);
    if told.is_empty() {
        let is_placed = |value: &String| causes.iter().any(|cause| cause.begins.contains(value));
        return match said.has_passed {
            _ if !said.unexplained.is_empty() && said.unexplained.iter().all(is_placed) => Class::Located,
            true => Class::NotFlagged,
            false => Class::Honest,
        };
    }
    let is_right = |told: &Told| {
        let is_true = |cause: &Cause| is_named(told, cause) || begins_at(told, cause) || is_among(told, &cause.beside);
        causes.iter().any(is_true)
    };
    if told.iter().all(is_right) {
        let all = causes.iter().all(|cause| told.iter().any(|told| is_named(told, cause)));
        return if all { Class::Named } else { Class::Located };
    }
    if explanation.probability >= 0.5 { Class::Wrong } else { Class::WeaklyWrong }
}

/// Whether what is told is right: only true causes by their names, or `unknown` where one begins.
pub fn is_right(said: &Said, planned: Option<&Planned>) -> bool {
    let Some(planned) = planned else {
        return false;
    };
    let is_placed =
        |told: &Told, cause: &Cause| is_named(told, cause) || (told.id == "unknown" && begins_at(told, cause));
    let names_one = |told: &Told| planned.causes.iter().any(|cause| is_placed(told, cause));
    let is_true = |told: &Told| names_one(told) || planned.causes.iter().any(|cause| is_among(told, &cause.beside));
    let mut explanations = said.explanations.iter();
    explanations.any(|explanation| explanation.told.iter().any(names_one) && explanation.told.iter().all(is_true))
}
