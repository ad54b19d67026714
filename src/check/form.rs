//! A form as a JSON file; and the forms that are written: all boxes of a scene's form in their order, empty or with
//! somebody's values.

use super::answer_key::AnswerKey;
use super::names::Names;
use super::rows::FormNames;
use super::sheet::{Given, Measured, PointsOf, Positive, WIDEST};
use super::shown::ShownNames;
use super::table;
use crate::construction::Solution;
use crate::scene::{FileKind, SceneError, read_as};
use crate::sheet::{Scales, Sheet};
use crate::text::{Untrusted, shown};
use indexmap::IndexMap;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value as Json, json};
use std::fmt;
use std::sync::LazyLock;

const MEASURED: FileKind = FileKind { what: "form of measured values", key: "kinegon_measured", version: 1 };

/// A form as it is read.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = r#"a form of measured values as { "kinegon_measured": 1, … }"#)]
struct FormFile {
    #[serde(rename = "kinegon_measured")]
    _version: u64,
    #[serde(rename = "$schema")]
    _schema: Option<String>,
    name: Option<Untrusted>,
    exercise: Option<String>,
    #[serde(rename = "mu_*", default)]
    mu: Scales,
    positive: Option<Positive>,
    #[serde(rename = "in")]
    written_in: Option<Paper>,
    #[serde(default)]
    values: IndexMap<String, Value>,
    points: Option<IndexMap<Plan, IndexMap<String, Place>>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Paper {
    Mm,
    Units,
}

/// The key of a plan, under which the places of its points stand.
#[derive(Debug, PartialEq, Eq, Hash)]
struct Plan(Sheet);

static PLAN_WORDS: LazyLock<Vec<&str>> = LazyLock::new(|| Sheet::PLANS.map(Sheet::as_str).to_vec());

impl<'de> Deserialize<'de> for Plan {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Plan, D::Error> {
        let word = String::deserialize(deserializer)?;
        let plan = Sheet::PLANS.into_iter().find(|plan| plan.as_str() == word);
        plan.map(Plan).ok_or_else(|| D::Error::unknown_variant(&word, &PLAN_WORDS))
    }
}

/// The place of a point, and its radius where there is one.
#[derive(Debug)]
struct Place([f64; 2], Option<f64>);

impl<'de> Deserialize<'de> for Place {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Place, D::Error> {
        match Vec::<f64>::deserialize(deserializer)?.as_slice() {
            [x, y] => Ok(Place([*x, *y], None)),
            [x, y, band] if (0.0..=WIDEST).contains(band) => Ok(Place([*x, *y], Some(*band))),
            [_, _, band] => Err(D::Error::custom(format!(
                "{band} is no radius: behind x and y stands how far the point may be from there, 0 to {WIDEST} mm"
            ))),
            others => Err(D::Error::custom(format!(
                "{} numbers are no place; a place is [x, y] in millimetres of paper, or [x, y, radius]",
                others.len()
            ))),
        }
    }
}

impl Serialize for Place {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().chain(&self.1))
    }
}

/// Digits, and perhaps a unit.
#[derive(Clone, Debug, Default)]
struct Value {
    text: String,
    unit: Option<String>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct WithUnit {
    value: Value,
    unit: String,
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Value, D::Error> {
        struct Forms;
        impl<'de> Visitor<'de> for Forms {
            type Value = Value;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(r#"a number, a number in quotes, or { "value": 61.5, "unit": "mm/s" }"#)
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<Value, E> {
                self.visit_string(number.to_string())
            }

            fn visit_u64<E: Error>(self, number: u64) -> Result<Value, E> {
                self.visit_string(number.to_string())
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<Value, E> {
                self.visit_string(number.to_string())
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Value, E> {
                self.visit_string(text.to_owned())
            }

            fn visit_string<E: Error>(self, text: String) -> Result<Value, E> {
                Ok(Value { text, unit: None })
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Value, A::Error> {
                let form = serde::de::value::MapAccessDeserializer::new(map);
                let WithUnit { value, unit } = WithUnit::deserialize(form)?;
                Ok(Value { text: value.text, unit: Some(unit) })
            }
        }
        deserializer.deserialize_any(Forms)
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let digits = |text: &str| Value { text: text.to_owned(), unit: None };
        match &self.unit {
            None => serializer.serialize_str(&self.text),
            Some(unit) => WithUnit { value: digits(&self.text), unit: unit.clone() }.serialize(serializer),
        }
    }
}

impl Measured {
    /// Whether a form's text is JSON: it begins with a bracket. All else is a table.
    #[must_use]
    pub fn is_json(text: &str) -> bool {
        text.trim_start_matches(['\u{feff}', ' ', '\n', '\r', '\t']).starts_with(['{', '['])
    }

    /// The values of a form as JSON; blanks are left out.
    ///
    /// # Errors
    /// The first thing that is wrong with the text, with its place.
    pub fn read_json(text: &str) -> Result<Measured, SceneError> {
        let file: FormFile = read_as(text, &MEASURED)?;
        let filled = file.values.into_iter().filter(|(_, value)| !value.text.trim().is_empty());
        let given = filled.map(|(name, value)| Given {
            place: format!("values.{}", shown(&name)),
            text: table::with_point(value.text.trim()),
            unit: value.unit,
            name,
        });
        let mut places = file.points.unwrap_or_default();
        let points = Sheet::PLANS.into_iter().filter_map(|plan| Some((plan, places.swap_remove(&Plan(plan))?)));
        Ok(Measured {
            name: file.name,
            exercise: file.exercise.map(|name| Untrusted::from(name.trim())).filter(|name| !name.is_blank()),
            mu: file.mu,
            positive: file.positive,
            faults: Vec::new(),
            in_mm: file.written_in == Some(Paper::Mm),
            values: given.collect(),
            points: points
                .filter(|(_, places)| !places.is_empty())
                .map(|(kind, places)| {
                    let mut points = PointsOf::new(kind);
                    places.into_iter().for_each(|(name, Place(at, band))| points.put(name, at, band));
                    points
                })
                .collect(),
        })
    }
}

/// The JSON of somebody's form with these values.
fn written(measured: &Measured, values: &IndexMap<String, Value>) -> String {
    let mut form = Map::new();
    let mut put = |key: &str, value: Json| {
        if !value.is_null() {
            form.insert(key.to_owned(), value);
        }
    };
    put(MEASURED.key, json!(MEASURED.version));
    put("name", json!(measured.name.clone().unwrap_or_default()));
    put("exercise", json!(measured.exercise.as_ref().map(Untrusted::for_comparing)));
    measured.mu.given().for_each(|(sheet, mu)| put(sheet.scale_key(), json!(mu)));
    put("positive", json!(measured.positive));
    put("in", json!(measured.in_mm.then_some(Paper::Mm)));
    put("values", json!(values));
    let places_on = |sheet: Sheet| -> IndexMap<&str, Place> {
        let plans = measured.points.iter().filter(|plan| plan.kind == sheet);
        plans.flat_map(|plan| plan.all().map(|(name, at, band)| (name, Place(at, band)))).collect()
    };
    let points = Sheet::PLANS.into_iter().map(|plan| (plan.as_str(), places_on(plan)));
    let points: IndexMap<_, _> = points.filter(|(_, places)| !places.is_empty()).collect();
    put("points", json!((!measured.points.is_empty()).then_some(points)));
    crate::format::json(&form)
}

/// A form without values.
#[derive(Clone, Copy, Debug)]
pub struct EmptyForm<'a> {
    /// The scene whose quantities are asked for.
    pub solution: &'a Solution,
    /// The scales that stand in it.
    pub scales: Scales,
    /// The name of the exercise that it belongs to.
    pub exercise: Option<&'a str>,
}

impl EmptyForm<'_> {
    /// The form as JSON: values are to be written between the quotes, or as numbers in place of them.
    #[must_use]
    pub fn json(&self) -> String {
        written(&self.head(), &self.values())
    }

    /// The form as a table.
    #[must_use]
    pub fn csv(&self) -> String {
        table::written(&self.head(), cells(&self.values()))
    }

    /// What stands above the values. Counter-clockwise is positive in every form, as in scenes and results; a slide is
    /// positive along its guide.
    fn head(&self) -> Measured {
        Measured {
            name: Some(Untrusted::default()),
            exercise: self.exercise.map(Untrusted::from),
            mu: self.scales,
            positive: Some(Positive::CounterClockwise),
            ..Measured::default()
        }
    }

    /// The boxes, by the names of the quantities in the notation of the figure.
    fn values(&self) -> IndexMap<String, Value> {
        let shown = ShownNames::of(self.solution);
        let rows = FormNames::new(&self.solution.construction);
        rows.names().map(|name| (shown.in_form(name, &rows), Value::default())).collect()
    }
}

/// The values of somebody, to be written by the names of the scene's own form.
#[derive(Clone, Copy, Debug)]
pub struct FilledForm<'a> {
    /// The values.
    pub measured: &'a Measured,
    /// The scene whose form it is.
    pub key: &'a AnswerKey<'a>,
}

impl FilledForm<'_> {
    /// The form as JSON.
    #[must_use]
    pub fn json(&self) -> String {
        written(self.measured, &self.values())
    }

    /// The form as a table.
    #[must_use]
    pub fn csv(&self) -> String {
        table::written(self.measured, cells(&self.values()))
    }

    /// All boxes in their order, then the values that the form does not ask for. Of two values for one box the second
    /// keeps its name.
    fn values(&self) -> IndexMap<String, Value> {
        let names = Names::new(self.key.solution);
        let shown = ShownNames::of(self.key.solution);
        let names_ground = self.measured.names_ground();
        let named = |given: &Given| {
            let (name, is_on_paper) = given.plain_name();
            let row = names.meant(&name, names_ground).ok()?.row;
            Some((shown.in_form(&row, &names.rows), is_on_paper))
        };
        let boxes = names.rows.names().map(|name| (shown.in_form(name, &names.rows), Vec::new()));
        let mut filled: IndexMap<String, Vec<(String, Value)>> = boxes.collect();
        for given in &self.measured.values {
            let (row, name) = match named(given) {
                Some((row, true)) => (row.clone(), format!("{row}/mu")),
                Some((row, false)) => (row.clone(), row),
                None => (given.name.clone(), given.name.clone()),
            };
            let values = filled.entry(row).or_default();
            let name = if values.is_empty() { name } else { given.name.clone() };
            values.push((name, Value { text: given.text.clone(), unit: given.unit.clone() }));
        }
        let of_row = |(row, values): (String, Vec<(String, Value)>)| match values.is_empty() {
            true => vec![(row, Value::default())],
            false => values,
        };
        filled.into_iter().flat_map(of_row).collect()
    }
}

/// The values as cells of a table.
fn cells(values: &IndexMap<String, Value>) -> impl Iterator<Item = [&str; 3]> {
    values.iter().map(|(name, value)| [name.as_str(), &value.text, value.unit.as_deref().unwrap_or("")])
}
