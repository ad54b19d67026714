//! The form of measured values as a JSON file.

use super::sheet::{Given, Measured, PointsOf, Positive, WIDEST};
use super::table::with_point;
use crate::scene::{FileKind, SceneError, read_as};
use crate::sheet::{PerSheet, Sheet};
use crate::text::{Untrusted, shown};
use indexmap::IndexMap;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

const MEASURED: FileKind = FileKind { what: "form of measured values", key: "kinegon_measured", version: 1 };

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = r#"a form of measured values as { "kinegon_measured": 1, … }"#)]
struct MeasuredFile {
    #[serde(rename = "kinegon_measured")]
    _version: u64,
    #[serde(rename = "$schema")]
    _schema: Option<String>,
    name: Option<Untrusted>,
    exercise: Option<String>,
    mu_l: Option<f64>,
    mu_v: Option<f64>,
    mu_a: Option<f64>,
    positive: Option<Sense>,
    #[serde(rename = "in")]
    written_in: Option<Paper>,
    #[serde(default)]
    values: IndexMap<String, Value>,
    points: Option<Points>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Sense {
    CounterClockwise,
    Clockwise,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Paper {
    Mm,
    Units,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Points {
    #[serde(default)]
    velocity: IndexMap<String, Place>,
    #[serde(default)]
    acceleration: IndexMap<String, Place>,
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

/// Digits, and perhaps a unit.
#[derive(Debug)]
struct Value {
    text: String,
    unit: Option<String>,
}

#[derive(Deserialize)]
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
        let file: MeasuredFile = read_as(text, &MEASURED)?;
        let filled = file.values.into_iter().filter(|(_, value)| !value.text.trim().is_empty());
        let given = filled.map(|(name, value)| Given {
            place: format!("values.{}", shown(&name)),
            text: with_point(value.text.trim()),
            unit: value.unit,
            name,
        });
        let points = file.points.map(|p| [p.velocity, p.acceleration]);
        let points = Sheet::PLANS.into_iter().zip(points.into_iter().flatten());
        Ok(Measured {
            name: file.name,
            exercise: file.exercise.map(|name| Untrusted::from(name.trim())).filter(|name| !name.is_blank()),
            mu: PerSheet::from_fn(|sheet| match sheet {
                Sheet::Scheme => file.mu_l,
                Sheet::Velocity => file.mu_v,
                Sheet::Acceleration => file.mu_a,
            }),
            positive: file.positive.map(|sense| match sense {
                Sense::CounterClockwise => Positive::CounterClockwise,
                Sense::Clockwise => Positive::Clockwise,
            }),
            faults: Vec::new(),
            in_mm: matches!(file.written_in, Some(Paper::Mm)),
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
