//! A marking scheme: the marks that each quantity is worth, and those that checked values earn.

use super::checked::{Checked, Finding, Judged, Verdict};
use super::entry::{Entry, entries_by};
use super::measured::{AnswerKey, CheckError, Given, Measured};
use super::names::Names;
use super::says;
use crate::scene::{FileKind, SceneError, read_as, schema};
use crate::sheet::{PerSheet, QuantityKind};
use crate::text::shown;
use crate::words::Wording;
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

const MARKS: FileKind = FileKind { what: crate::scene::says::marks, key: "kinegon_marks", version: 1 };

/// Most marks that a quantity may be worth.
const MOST: f64 = crate::scene::MOST_MARKS;

/// How many marks the values of a form earn. A value that is right or within the tolerance earns the marks of its quantity; one that is
/// off earns none, or where it follows from a mistake made at an earlier step and is consistent with it, the part `follow_through` of them.
/// Every mistake is charged once: in the value in which it was made, whatever else that follows from, or where no value of its step shows it,
/// as that of a line, in the first that does. From a mistake that has no name nothing follows where it leaves more than half as many wrong
/// values open as it explains. A value that tells nothing earns none, and a rate without its sense earns none. What is too small on the sheet to be
/// judged does not count.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "marks"))]
#[serde(deny_unknown_fields, expecting = r#"a marking scheme as { "kinegon_marks": 1, … }"#)]
pub struct Marks {
    /// Version of the format.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "crate::scene::schema_made::version"))]
    #[serde(rename = "kinegon_marks")]
    _version: u64,
    /// Where an editor finds the schema.
    #[cfg_attr(feature = "schemas", schemars(skip))]
    #[serde(rename = "$schema")]
    _schema: Option<String>,
    /// Marks of every quantity of the scene's form that `values` does not name. Left out: what the scene's `form` says, else 1, where `values`
    /// is left out, too, else only the quantities in `values` count.
    #[cfg_attr(feature = "schemas", schemars(range(min = 0, max = MOST)))]
    each: Option<f64>,
    /// Marks of single quantities by their names, as in the form.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "marks_by_name"))]
    #[serde(default)]
    values: IndexMap<String, f64>,
    /// Which part of its marks a wrong value earns that follows from an earlier mistake and is consistent with it; left out: 1.
    #[cfg_attr(feature = "schemas", schemars(range(min = 0, max = 1)))]
    follow_through: Option<f64>,
    /// Which part of its marks a quantity earns whose value is not there; left out: 0.
    #[cfg_attr(feature = "schemas", schemars(range(min = 0, max = 1)))]
    missing: Option<f64>,
}

#[cfg(feature = "schemas")]
fn marks_by_name(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({
        "type": "object",
        "additionalProperties": { "type": "number", "minimum": 0, "maximum": MOST }
    })
}

impl Marks {
    /// A marking scheme as it is written; [`Marks::of`] applies it to a scene.
    ///
    /// # Errors
    /// The first thing that is wrong with the text, with its place.
    pub fn read(text: &str) -> Result<Marks, SceneError> {
        read_as(text, &MARKS)
    }

    /// The JSON Schema (draft 2020-12) of marking schemes, with descriptions, for editors.
    #[must_use]
    pub fn schema() -> serde_json::Value {
        schema!("marks", Marks, "Kinegon marking scheme, version 1")
    }

    /// The marks of a scene's quantities.
    ///
    /// # Errors
    /// A quantity that the scene does not have, or that stands there twice; marks or parts that are no such numbers; a scheme without any marks.
    pub fn of(&self, key: &AnswerKey<'_>) -> Result<MarkScheme, CheckError> {
        let part = |key: &str, part: f64| match (0.0..=1.0).contains(&part) {
            true => Ok(part),
            false => Err(CheckError::new(says::no_part(part), says::part_from_0()).at(key)),
        };
        let marks = |key: &str, marks: f64| match (0.0..=MOST).contains(&marks) {
            true => Ok(marks),
            false => Err(CheckError::new(says::no_marks(marks), says::marks_from_0(MOST)).at(key)),
        };
        let each = self.each.map(|each| marks("each", each)).transpose()?;
        let names = Names::new(key.solution);
        let mut worth: IndexMap<String, Worth> = IndexMap::new();
        let of = |row: &str, marks: f64| Worth {
            marks,
            step: names.order.get(row).copied().unwrap_or(0),
            row: row.to_owned(),
        };
        if each.is_some() || self.values.is_empty() {
            worth.extend(names.worths().map(|(name, own)| (name.to_owned(), of(name, each.unwrap_or(own)))));
        }
        let mut given: IndexMap<String, &str> = IndexMap::new();
        for (written, value) in &self.values {
            let place = format!("values.{}", shown(written));
            let value = marks(&place, *value)?;
            let Entry { asked, row, .. } = entry_of(written, &place, key, &names)?;
            // Rates of two links that turn together may have marks of their own.
            let same_rates = &key.solution.construction.same_rates;
            let has_both = same_rates.contains_key(asked.name()) && self.values.contains_key(&row);
            let name = if has_both { asked.name().to_owned() } else { row.clone() };
            if let Some(other) = given.insert(name.clone(), written) {
                return Err(CheckError::new(says::marks_twice(shown(other)), says::keep_one()).at(&place));
            }
            worth.insert(name, of(&row, value));
        }
        if worth.values().map(|worth| worth.marks).sum::<f64>() == 0.0 {
            return Err(CheckError::new(says::no_marks_at_all(), says::add_each()));
        }
        Ok(MarkScheme {
            worth,
            follow_through: part("follow_through", self.follow_through.unwrap_or(1.0))?,
            missing: part("missing", self.missing.unwrap_or(0.0))?,
        })
    }
}

/// The entry that a form would have for a quantity that a scheme names.
fn entry_of(written: &str, place: &str, key: &AnswerKey<'_>, names: &Names<'_>) -> Result<Entry, CheckError> {
    let (name, text, place) = (written.to_owned(), "0".to_owned(), place.to_owned());
    let alone = Measured {
        mu: PerSheet::from_fn(|_| Some(1.0)),
        values: vec![Given { name, text, unit: None, place: place.into() }],
        ..Measured::default()
    };
    Ok(entries_by(&alone, key, names)?.swap_remove(0))
}

/// The marks that the quantities of a scene are worth.
#[derive(Clone, Debug)]
pub struct MarkScheme {
    /// By the quantities' names.
    worth: IndexMap<String, Worth>,
    follow_through: f64,
    missing: f64,
}

/// What a quantity is worth.
#[derive(Clone, Debug)]
struct Worth {
    /// The row of the form that asks for it.
    row: String,
    /// The number of the step that gives it.
    step: usize,
    marks: f64,
}

/// The marks that somebody's values earn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Awarded {
    /// Marks earned.
    pub earned: f64,
    /// Marks that could be earned.
    pub of: f64,
    /// Those of the earned ones that are for values which follow from an earlier mistake.
    pub follow_through: f64,
}

impl MarkScheme {
    /// The marks that checked values earn. Values without marks in the scheme earn none.
    #[must_use]
    pub fn award(&self, checked: &Checked) -> Awarded {
        let findings = &checked.diagnosis.best.findings;
        let open = checked.diagnosis.unexplained.len();
        // A mistake without a name has numbers to choose, and some of any numbers fit it.
        let is_shown = |f: &&Finding| f.names_cause() || 2 * open <= f.follows.len();
        let charged: Vec<usize> = findings.iter().flat_map(|finding| self.charged(finding, checked)).collect();
        let follows = |value: usize| {
            // Beside a prediction of nearly nothing any small number would follow.
            let Judged { entry, tolerance, .. } = &checked.values[value];
            let is_later = |f: &&Finding| f.candidate.step < entry.step;
            (entry.value.abs() > *tolerance || entry.asked.kind() == QuantityKind::Angle)
                && findings.iter().filter(is_later).filter(is_shown).any(|f| f.follows.contains(&value))
                && !charged.contains(&value)
                && !entry.has_one_digit()
        };
        let (mut earned, mut follow_through) = (0.0, 0.0);
        let mut of: f64 = self.worth.values().map(|worth| worth.marks).sum();
        for (name, own) in &self.worth {
            let worth = own.marks;
            let by_name = checked.values.iter().position(|v| v.entry.asked.name() == name);
            let Some(index) = by_name.or_else(|| place_of(&own.row, checked)) else {
                earned += self.missing * worth;
                continue;
            };
            match checked.values[index].verdict {
                Verdict::Right | Verdict::WithinTolerance => earned += worth,
                Verdict::Off if follows(index) => follow_through += self.follow_through * worth,
                // It does not count.
                Verdict::TooSmall => of -= worth,
                Verdict::Off | Verdict::TooCoarse | Verdict::SenseMissing => {}
            }
        }
        let tidy = |marks: f64| libm::round(marks * 1e6) / 1e6;
        Awarded { earned: tidy(earned + follow_through), of: tidy(of), follow_through: tidy(follow_through) }
    }

    /// The values in which a mistake is charged: where it was written, else the first that show it, as of a line in a wrong direction or a
    /// wrong ω of the drive; of a point put elsewhere two, as it has two numbers. A value of its step that is asked for and missing is
    /// charged already.
    fn charged(&self, finding: &Finding, checked: &Checked) -> Vec<usize> {
        let step = finding.candidate.step;
        let is_worth = |value: &Judged| self.worth.values().any(|own| own.row == value.entry.row);
        let is_off = |value: &Judged| value.verdict == Verdict::Off && is_worth(value);
        let off = |all: Vec<usize>| all.into_iter().filter(move |value| is_off(&checked.values[*value]));
        let written: Vec<usize> = off(finding.written.clone()).collect();
        if !written.is_empty() {
            return written;
        }
        let is_missing =
            self.worth.values().any(|own| own.step == step && step > 0 && place_of(&own.row, checked).is_none());
        let numbers = finding.candidate.free.len().max(1);
        off(finding.changed()).take(numbers - usize::from(is_missing)).collect()
    }
}

/// The index of the value of a row.
fn place_of(row: &str, checked: &Checked) -> Option<usize> {
    checked.values.iter().position(|value| value.entry.row == row)
}

impl Awarded {
    /// The marks in a sentence.
    #[must_use]
    pub fn line(&self, words: &Wording) -> String {
        let number = |marks: f64| words.number(Awarded::written(marks));
        let [earned, of] = [self.earned, self.of].map(number);
        if self.follow_through > 0.0 {
            words.language.class_marks_following(&earned, &of, &number(self.follow_through))
        } else {
            words.language.class_marks(&earned, &of)
        }
    }

    /// Marks as people write them: two decimals at most.
    #[must_use]
    pub fn written(marks: f64) -> String {
        (libm::round(marks * 100.0) / 100.0).to_string()
    }
}
