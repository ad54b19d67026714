//! An exercise in front of a student, and what comes of it: a form, and what a teacher knows about it.

use super::act::{Act, Change};
use super::classical::classical;
use super::hand::{Hand, RIGHT, Skill};
use super::mistake::{Mistake, Name, Wrong};
use super::plane::{Place, direction, unit};
use super::scheme::Scheme;
use super::script::{draw, joints, place_specials};
use super::sheet::{Sheet, ends_of};
use super::slips::slip;
use crate::random::Random;
use kinegon::Solution;
use kinegon::check::{Given, Measured, Positive};
use serde_json::{Value, json};

/// What is longer on paper leaves every sheet (A2), in mm.
const SHEET: f64 = 594.0;
/// Of 100 mistakes, so many are classical.
const CLASSICAL: usize = 60;
/// A mistake of a rate that is smaller than this part of it shows nowhere.
const PART: f64 = 0.06;

/// An exercise.
pub struct Task {
    pub kind: &'static str,
    text: String,
    pub scheme: Scheme,
    pub solution: Solution,
    /// Values of the form and acts of a drawing without any error.
    pub values: Vec<Option<f64>>,
    acts: Vec<Act>,
}

/// What went wrong at one place of a sheet.
pub struct Cause {
    pub text: String,
    pub is_classical: bool,
    pub names: Vec<Name>,
    pub beside: Vec<Name>,
    /// The quantity at which it first shows, or several that show the same.
    pub begins: Vec<String>,
}

/// Mistakes that can be seen, on a scheme that may be wrong itself.
pub struct Planned {
    pub causes: Vec<Cause>,
    changes: Vec<(String, Change)>,
    scheme: Option<Scheme>,
}

impl Task {
    pub fn new(kind: &'static str, text: &str) -> Option<Task> {
        let (mut scheme, solution) = Scheme::new(text)?;
        place_specials(kind, &mut scheme);
        let mut task = Task { kind, text: text.to_owned(), scheme, solution, values: Vec::new(), acts: Vec::new() };
        let (values, acts, _) = task.exact(&task.scheme, &[]);
        (task.values, task.acts) = (values, acts);
        Some(task)
    }

    /// The scene.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Values, acts and the longest length on paper of a drawing without any error of the hand.
    fn exact(&self, scheme: &Scheme, changes: &[(String, Change)]) -> (Vec<Option<f64>>, Vec<Act>, f64) {
        let mut sheet = draw(self.kind, scheme, Hand::new(RIGHT, 1), changes);
        let values = scheme.form.iter().map(|name| sheet.write(name)).collect();
        (values, core::mem::take(&mut sheet.acts), sheet.extent())
    }

    /// One mistake by lot, or two; none where it cannot be made here, or cannot be seen.
    pub fn plan(&self, random: &mut Random, skill: &Skill) -> Option<Planned> {
        let mut planned = Planned { causes: Vec::new(), changes: Vec::new(), scheme: None };
        for _ in 0..=usize::from(random.below(8) == 0) {
            let mistake = match random.below(100) < CLASSICAL {
                true => classical(random, &self.acts, &self.scheme)?,
                false => slip(random, &self.acts, &self.scheme)?,
            };
            let scheme = match mistake.scheme {
                Some(wrong) => Some(self.wrong_scheme(wrong)?),
                None => None,
            };
            let begins = self.begins(&mistake, scheme.as_ref().unwrap_or(&self.scheme), skill)?;
            let is_apart = planned.causes.iter().all(|other| other.begins != begins);
            if !is_apart || planned.changes.iter().any(|(key, _)| mistake.changes.iter().any(|(k, _)| k == key)) {
                return None;
            }
            planned.changes.extend(mistake.changes);
            planned.scheme = scheme.or(planned.scheme);
            let Mistake { text, is_classical, names, beside, .. } = mistake;
            planned.causes.push(Cause { text, is_classical, names, beside, begins });
        }
        // Both together must stay on the sheet, too.
        let (values, _, extent) = self.exact(planned.scheme.as_ref().unwrap_or(&self.scheme), &planned.changes);
        let is_drawn = extent < SHEET && values.iter().flatten().all(|value| value.is_finite());
        is_drawn.then_some(planned)
    }

    /// Where a mistake begins; none where it shows nowhere or leaves the sheet.
    fn begins(&self, mistake: &Mistake, scheme: &Scheme, skill: &Skill) -> Option<Vec<String>> {
        let (values, _, extent) = self.exact(scheme, &mistake.changes);
        if extent > SHEET || values.iter().flatten().any(|value| !value.is_finite()) {
            return None;
        }
        let mut changed = Vec::new();
        let mut is_seen = false;
        for ((name, right), wrong) in self.scheme.form.iter().zip(&self.values).zip(&values) {
            let by = match (right, wrong) {
                (Some(right), Some(wrong)) => (wrong - right).abs(),
                (None, None) => continue,
                _ => f64::INFINITY,
            };
            let right = right.unwrap_or_default().abs();
            if by > 1e-6 * right.max(1e-3) && !is_seen {
                changed.push(name.clone());
            }
            let limit = match ends_of(name) {
                Some((plan, ..)) => self.scheme.scales[plan] * (1.5 + 6.0 * skill.mm),
                None => right * (PART + 0.1 * skill.mm),
            };
            is_seen |= by > limit;
        }
        if !is_seen {
            return None;
        }
        if !mistake.begins.is_empty() {
            return Some(self.with_same(&mistake.begins));
        }
        // Rates that are found side by side show the same.
        let head = |name: &str| name.split('(').next().map(str::to_owned);
        let first = changed.first()?.clone();
        if ends_of(&first).is_none() {
            let others = self.scheme.form.iter().zip(&self.values).zip(&values);
            let others = others.filter(|((name, right), wrong)| right != wrong && head(name) == head(&first));
            changed.extend(others.map(|((name, _), _)| name.clone()));
        }
        Some(changed)
    }

    /// These quantities, and rates of links that turn together with theirs.
    fn with_same(&self, begins: &[String]) -> Vec<String> {
        let head = |name: &str| name.split('(').next().map(str::to_owned);
        let value = |name: &str| self.scheme.form.iter().position(|own| own == name).and_then(|k| self.values[k]);
        let is_same = |name: &str| {
            let mut begins = begins.iter();
            begins.any(|other| other == name || (head(other) == head(name) && value(other) == value(name)))
        };
        let all =
            self.scheme.form.iter().filter(|name| is_same(name) && (begins.contains(*name) || ends_of(name).is_none()));
        all.cloned().collect()
    }

    /// The scheme as it is drawn by mistake.
    fn wrong_scheme(&self, wrong: Wrong) -> Option<Scheme> {
        let mut json: Value = serde_json::from_str(&self.text).ok()?;
        match wrong {
            Wrong::Angle(by) => {
                let links = json["links"].as_object_mut()?;
                let drive = links.values_mut().find(|link| link["drive"]["angle"].is_number())?;
                drive["drive"]["angle"] = json!(drive["drive"]["angle"].as_f64()? + by);
            }
            Wrong::Mode => {
                let (joint, from, towards) = joints(self.kind, &self.scheme)?;
                let near = json["near"].as_object_mut()?;
                let arm = self.scheme.at(&joint) - from;
                let place: Place = from + unit(2.0 * direction(towards)) * arm.conj();
                near.insert(joint, json!([place.re, place.im]));
            }
        }
        let (mut scheme, _) = Scheme::new(&json.to_string())?;
        place_specials(self.kind, &mut scheme);
        scheme.form = self.scheme.form.clone();
        Some(scheme)
    }

    /// A sheet with these mistakes, or without any, drawn but not measured yet.
    pub fn drawn<'a>(&'a self, planned: Option<&'a Planned>, skill: Skill, seed: u64) -> Sheet<'a> {
        let scheme = planned.and_then(|planned| planned.scheme.as_ref()).unwrap_or(&self.scheme);
        let changes = planned.map_or(&[][..], |planned| &planned.changes);
        draw(self.kind, scheme, Hand::new(skill, seed), changes)
    }

    /// The form of the same sheet, as it is handed in.
    pub fn hand_in(&self, planned: Option<&Planned>, skill: Skill, seed: u64) -> Measured {
        let mut sheet = self.drawn(planned, skill, seed);
        let scheme = sheet.scheme;
        let values = scheme.form.iter().filter_map(|name| Some((name, sheet.write(name)?)));
        let values = values.map(|(name, value)| Given {
            name: name.clone(),
            text: written(value, skill.digits, ends_of(name).is_none()),
            unit: None,
            place: format!("values.{name}").into(),
        });
        Measured {
            mu: kinegon::PerSheet::from_fn(|sheet| self.scheme.scales.get(sheet as usize).copied()),
            positive: Some(Positive::CounterClockwise),
            values: values.collect(),
            ..Measured::default()
        }
    }
}

/// A number with so many significant digits, rates with their sign.
fn written(value: f64, digits: usize, is_signed: bool) -> String {
    let power = libm::floor(libm::log10(value.abs().max(1e-9))) as i64;
    let decimals = (digits as i64 - 1 - power).clamp(0, 9) as usize;
    let value = super::hand::rounded(value, digits);
    if is_signed { format!("{value:+.decimals$}") } else { format!("{value:.decimals$}") }
}
