//! A filled form as a file: all boxes of the scene's form in their order, with the values that are given.

use super::answer_key::AnswerKey;
use super::entry::{Names, Reader};
use super::sheet::{Given, Measured, PointsOf, Positive};
use super::shown::ShownNames;
use super::template::quoted;
use crate::sheet::Scales;
use crate::text::{Untrusted, cell};
use indexmap::IndexMap;
use serde::Serialize;

/// The values of somebody, to be written by the names of the scene's own form.
#[derive(Clone, Copy, Debug)]
pub struct FilledForm<'a> {
    /// The values.
    pub measured: &'a Measured,
    /// The scene whose form it is.
    pub key: &'a AnswerKey<'a>,
}

#[derive(Debug, Serialize)]
struct FilledFile<'a> {
    kinegon_measured: u64,
    name: Untrusted,
    #[serde(skip_serializing_if = "Option::is_none")]
    exercise: Option<&'a Untrusted>,
    #[serde(flatten, serialize_with = "Scales::by_key")]
    scales: Scales,
    #[serde(skip_serializing_if = "Option::is_none")]
    positive: Option<&'static str>,
    #[serde(rename = "in", skip_serializing_if = "Option::is_none")]
    written_in: Option<&'static str>,
    values: IndexMap<String, Value<'a>>,
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    points: IndexMap<&'static str, IndexMap<&'a str, Vec<f64>>>,
}

/// Digits as they were written, and a unit.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Value<'a> {
    Digits(&'a str),
    WithUnit { value: &'a str, unit: &'a str },
}

impl<'a> Value<'a> {
    fn of(given: &'a Given) -> Value<'a> {
        match &given.unit {
            Some(unit) => Value::WithUnit { value: &given.text, unit },
            None => Value::Digits(&given.text),
        }
    }
}

impl<'a> FilledForm<'a> {
    /// The form as JSON.
    #[must_use]
    pub fn json(&self) -> String {
        let measured = self.measured;
        let points = measured.points.iter().map(|plan| (plan.kind.as_str(), places(plan).collect()));
        crate::format::json(&FilledFile {
            kinegon_measured: 1,
            name: measured.name.clone().unwrap_or_default(),
            exercise: measured.exercise.as_ref(),
            scales: measured.mu,
            positive: self.positive(),
            written_in: measured.in_mm.then_some("mm"),
            values: self.values(),
            points: points.collect(),
        })
    }

    /// The form as a table.
    #[must_use]
    pub fn csv(&self) -> String {
        let measured = self.measured;
        let own = |text: &Untrusted| quoted(&text.for_cell());
        let mut lines = vec!["quantity,value,unit".to_owned()];
        lines.extend(measured.name.as_ref().map(|name| format!("name,{},", own(name))));
        lines.extend(measured.exercise.as_ref().map(|exercise| format!("exercise,{},", own(exercise))));
        lines.extend(measured.mu.given().map(|(sheet, mu)| format!("{},{mu},", sheet.scale_key())));
        lines.extend(self.positive().map(|sense| format!("positive,{sense},")));
        lines.extend(measured.in_mm.then(|| "in,mm,".to_owned()));
        lines.extend(self.values().iter().map(|(name, value)| match value {
            Value::Digits(digits) => format!("{},{},", quoted(name), cell(digits)),
            Value::WithUnit { value, unit } => format!("{},{},{}", quoted(name), cell(value), quoted(&cell(unit))),
        }));
        for plan in &measured.points {
            let written = |place: Vec<f64>| place.iter().map(|x| format!(",{x}")).collect::<String>();
            let line =
                |(name, place)| format!("{}{}", quoted(&format!("{}:{name}", plan.kind.as_str())), written(place));
            lines.extend(places(plan).map(line));
        }
        lines.join("\n") + "\n"
    }

    fn positive(&self) -> Option<&'static str> {
        self.measured.positive.map(|sense| match sense {
            Positive::CounterClockwise => "counter-clockwise",
            Positive::Clockwise => "clockwise",
        })
    }

    /// All boxes in their order, then the values that the form does not ask for. Of two values for one box the second
    /// keeps its name.
    fn values(&self) -> IndexMap<String, Value<'a>> {
        let names = Names::new(self.key);
        let shown = ShownNames::of(self.key.solution);
        let reader = Reader { measured: self.measured, key: self.key, names: &names };
        let boxes: Vec<String> = names.rows.names().map(|name| shown.in_form(name, &names.rows)).collect();
        let named = |given: &Given| {
            let (row, is_on_paper) = reader.row(&given.name)?;
            Some((shown.in_form(&row, &names.rows), is_on_paper))
        };
        let mut filled: IndexMap<String, Vec<(String, Value<'a>)>> =
            boxes.iter().map(|name| (name.clone(), Vec::new())).collect();
        for given in &self.measured.values {
            let (row, name) = match named(given) {
                Some((row, true)) => (row.clone(), format!("{row}/mu")),
                Some((row, false)) => (row.clone(), row),
                None => (given.name.clone(), given.name.clone()),
            };
            let values = filled.entry(row).or_default();
            let name = if values.is_empty() { name } else { given.name.clone() };
            values.push((name, Value::of(given)));
        }
        let of_row = |(row, values): (String, Vec<(String, Value<'a>)>)| match values.is_empty() {
            true => vec![(row, Value::Digits(""))],
            false => values,
        };
        filled.into_iter().flat_map(of_row).collect()
    }
}

/// The places of a plan's points: x and y, and the radius where there is one.
fn places(points: &PointsOf) -> impl Iterator<Item = (&str, Vec<f64>)> {
    points.places.iter().map(|(name, at)| {
        let band = points.bands.get(name);
        (name.as_str(), at.iter().chain(band).copied().collect())
    })
}
