//! A form as a JSON file; the forms that are written: all boxes of a scene's form in their order, empty or with somebody's
//! values; and the boxes for a page that shows them one by one.

use super::measured::{AnswerKey, Given, Measured, ON_PAPER, PlacedPoint, PointsOf, Positive, WIDEST};
use super::names::{Meant, Names};
use super::on_paper::PaperPoints;
use super::table;
use super::written::given;
use crate::construction::Solution;
use crate::drawing::{RichText, SheetLabels};
use crate::quantity::QuantityRequest;
use crate::scene::{FileKind, SceneError, read_as};
use crate::sheet::{PerSheet, Scales, Sheet};
use crate::text::{Untrusted, shown};
use indexmap::{IndexMap, IndexSet};
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value as Json, json};
use std::fmt;

const MEASURED: FileKind = FileKind { what: crate::scene::says::form, key: "kinegon_measured", version: 1 };

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
    points: Option<IndexMap<PlacedSheet, IndexMap<String, PlacedPoint>>>,
    #[serde(default)]
    upright: bool,
    #[serde(default)]
    hints: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Paper {
    Mm,
    Units,
}

impl<'de> Deserialize<'de> for PlacedPoint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<PlacedPoint, D::Error> {
        match Vec::<f64>::deserialize(deserializer)?.as_slice() {
            [x, y] => Ok(PlacedPoint { at: [*x, *y], band: None }),
            [x, y, band] if (0.0..=WIDEST).contains(band) => Ok(PlacedPoint { at: [*x, *y], band: Some(*band) }),
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

/// A sheet whose points have places on paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct PlacedSheet(Sheet);

impl<'de> Deserialize<'de> for PlacedSheet {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<PlacedSheet, D::Error> {
        let word = String::deserialize(deserializer)?;
        let sheet = Sheet::from_word(&word).filter(|sheet| sheet.has_places());
        sheet.map(PlacedSheet).ok_or_else(|| {
            let known = Sheet::ALL.into_iter().filter(|sheet| sheet.has_places());
            let known = known.map(|sheet| format!("`{}`", sheet.as_str())).collect::<Vec<_>>().join(", ");
            D::Error::custom(format!("unknown variant `{}`, expected one of {known}", shown(&word)))
        })
    }
}

impl Serialize for PlacedPoint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.at.iter().chain(&self.band))
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
                f.write_str(r#"a number, one in quotes as "61.5 mm/s", or { "value": 61.5, "unit": "mm/s" }"#)
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<Value, E> {
                self.visit_str(&number.to_string())
            }

            fn visit_u64<E: Error>(self, number: u64) -> Result<Value, E> {
                self.visit_str(&number.to_string())
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<Value, E> {
                self.visit_str(&number.to_string())
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Value, E> {
                Ok(Value { text: text.to_owned(), unit: None })
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

    /// The values of a form as JSON.
    ///
    /// # Errors
    /// The first thing that is wrong with the text, with its place.
    pub fn read_json(text: &str) -> Result<Measured, SceneError> {
        let file: FormFile = read_as(text, &MEASURED)?;
        let filled = file.values.into_iter().filter(|(_, value)| !value.text.trim().is_empty());
        let given = filled.map(|(name, Value { text, unit })| {
            let place = format!("values.{}", shown(&name)).into();
            given(name, text.trim(), unit, place)
        });
        let mut places = file.points.unwrap_or_default();
        let points = Sheet::ALL.into_iter().filter_map(|sheet| {
            let places = places.swap_remove(&PlacedSheet(sheet))?;
            (!places.is_empty()).then_some(PointsOf { sheet, places })
        });
        Ok(Measured {
            name: file.name,
            exercise: file.exercise.map(|name| Untrusted::from(name.trim())).filter(|name| !name.is_blank()),
            mu: file.mu,
            positive: file.positive,
            faults: Vec::new(),
            in_mm: file.written_in == Some(Paper::Mm),
            values: given.collect(),
            points: points.collect(),
            upright: file.upright,
            hints: file.hints,
        })
    }

    /// A form without values: with the scales that stand in it, and the name of the exercise that it belongs to.
    /// Counter-clockwise is positive in every such form, as in scenes and results; a slide is positive along its guide.
    #[must_use]
    pub fn empty(scales: Scales, exercise: Option<&str>) -> Measured {
        Measured {
            name: Some(Untrusted::default()),
            exercise: exercise.map(Untrusted::from),
            mu: scales,
            positive: Some(Positive::CounterClockwise),
            ..Measured::default()
        }
    }

    /// The form of a scene as JSON, with all its boxes: where one is empty, its value is to be written between the
    /// quotes, or as a number in place of them.
    #[must_use]
    pub fn json(&self, solution: &Solution) -> String {
        written(self, &self.boxes(solution))
    }

    /// The form of a scene as a table, with all its boxes.
    #[must_use]
    pub fn csv(&self, solution: &Solution) -> String {
        let boxes = self.boxes(solution);
        let cells = boxes.iter().map(|(name, value)| [name, &value.text, value.unit.as_deref().unwrap_or("")]);
        table::written(self, cells)
    }

    /// All boxes of a scene's form in their order, empty or with a value, then the values that the form does not ask
    /// for. Of two values for one box the second keeps its name.
    fn boxes(&self, solution: &Solution) -> IndexMap<String, Value> {
        let names = Names::new(solution);
        let names_ground = self.names_ground();
        let named = |given: &Given| {
            let (name, is_on_paper) = given.plain_name();
            let row = names.meant(&name, names_ground).ok()?.row;
            Some((names.in_form(&row), is_on_paper))
        };
        let boxes = names.rows().map(|name| (names.in_form(name), Vec::new()));
        let mut filled: IndexMap<String, Vec<(String, Value)>> = boxes.collect();
        for given in &self.values {
            let (row, name) = match named(given) {
                Some((row, true)) => (row.clone(), format!("{row}{ON_PAPER}")),
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
    measured.mu.given().for_each(|(sheet, mu)| put(sheet.facts().scale_key, json!(mu)));
    put("positive", json!(measured.positive));
    put("in", json!(measured.in_mm.then_some(Paper::Mm)));
    put("upright", json!(measured.upright.then_some(true)));
    put("hints", json!((measured.hints > 0).then_some(measured.hints)));
    put("values", json!(values));
    let places_of = |sheet: Sheet| -> IndexMap<&String, &PlacedPoint> {
        measured.points.iter().filter(|points| points.sheet == sheet).flat_map(|points| &points.places).collect()
    };
    let points = Sheet::ALL.into_iter().map(|sheet| (sheet.as_str(), places_of(sheet)));
    let points: IndexMap<_, _> = points.filter(|(_, places)| !places.is_empty()).collect();
    put("points", json!((!measured.points.is_empty()).then_some(points)));
    crate::format::json(&form)
}

/// A box for a value.
#[derive(Clone, Debug)]
pub struct FormBox {
    /// The name under which its value stands in a form.
    pub name: String,
    /// The quantity.
    pub asked: QuantityRequest,
    /// How the sheets write it.
    pub label: RichText,
    /// The number of the step that gives it.
    pub step: usize,
}

/// The boxes of a scene's form, in its order.
#[must_use]
pub fn form_boxes(solution: &Solution) -> Vec<FormBox> {
    let (names, labels) = (Names::new(solution), SheetLabels::of(solution));
    let of_row = |name: &str| {
        let asked = QuantityRequest::new(name, &solution.mechanism).ok()?;
        let step = names.order.get(name).copied().unwrap_or(0);
        Some(FormBox { name: names.in_form(name), label: labels.quantity(&asked), asked, step })
    };
    names.rows().filter_map(of_row).collect()
}

/// Boxes for values of a filled form that the empty one does not ask for; names that are not understood have none.
#[must_use]
pub fn further_boxes(measured: &Measured, key: &AnswerKey<'_>) -> Vec<FormBox> {
    let (names, labels) = (Names::new(key.solution), SheetLabels::of(key.solution));
    let asked_for: Vec<String> = names.rows().map(|name| names.in_form(name)).collect();
    let further = measured.values.iter().map(|given| given.name.trim_end_matches(ON_PAPER));
    let further = further.filter(|name| !asked_for.iter().any(|asked| asked == name));
    let of_name = |name: &str| {
        let Meant { asked, step, .. } = names.quantity(name).ok()?;
        Some(FormBox { name: name.to_owned(), label: labels.quantity(&asked), asked, step })
    };
    further.filter_map(of_name).collect()
}

/// By sheet the points between which the form's segments lie, or whose coordinates it asks for, the origin first: the names under which a form gives their
/// places, and their labels. None of a sheet that is not there.
#[must_use]
pub fn sheet_points(solution: &Solution) -> PerSheet<Vec<(String, RichText)>> {
    let labels = SheetLabels::of(solution);
    let boxes = form_boxes(solution);
    let of_sheet = |points: PaperPoints<'_>| {
        let asked = boxes.iter().flat_map(|found| points.named_by(&found.asked));
        let names: IndexSet<String> = std::iter::once(points.origin().to_owned()).chain(asked).collect();
        names.into_iter().map(|name| (name.clone(), points.label(&labels, &name))).collect()
    };
    PerSheet::from_fn(|sheet| PaperPoints::of(solution, sheet).map_or_else(Vec::new, of_sheet))
}
