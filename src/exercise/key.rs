//! The teacher's key of an exercise: every value of the form.

use super::judge::Exercise;
use super::sheets::key_rows;
use crate::check::Measured;
use crate::construction::Solution;
use crate::drawing::{Drawing, KeyRow, key_sheet};
use crate::scene::schema;
use crate::sheet::Scales;
use crate::text::Untrusted;
use indexmap::IndexMap;
use serde::{Serialize, Serializer};

/// The values of an exercise.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct KeyResult {
    /// Version of the format.
    pub kinegon_key: u64,
    /// The title of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<Untrusted>,
    /// The scales of the sheets.
    pub scales: KeyScales,
    /// The values by the names of their quantities, in the order of the form.
    pub values: IndexMap<String, KeyValue>,
}

/// Scales, in units of the scene per millimetre of paper.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct KeyScales {
    /// By sheet; `null` for a sheet that is not there.
    #[serde(flatten, serialize_with = "with_null")]
    #[cfg_attr(feature = "schemas", schemars(schema_with = "scales_schema"))]
    pub of: Scales,
}

fn with_null<S: Serializer>(scales: &Scales, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(scales.iter().map(|(sheet, scale)| (sheet.facts().scale_key, scale)))
}

#[cfg(feature = "schemas")]
fn scales_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    Scales::schema(generator, |sheet| serde_json::json!({ "description": format!("Of the {}.", sheet.name()) }))
}

/// The value of a quantity.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct KeyValue {
    /// The exact value.
    pub value: f64,
    /// Its unit.
    pub unit: String,
    /// By how much the value of a careful hand may differ, as `kinegon check` judges it; not there for what is given. A check
    /// allows half a unit of the last digit more, in which the value is written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub allowed: Option<f64>,
    /// The number of the step that gives it.
    pub step: usize,
}

impl Exercise {
    /// All values of the form, with the differences that a careful hand is allowed.
    #[must_use]
    pub fn key(&self) -> KeyResult {
        let Solution { scene, construction, .. } = &self.solution;
        let steps = construction.steps_of_quantities();
        let rows = key_rows(&self.solution, &self.pencil).into_iter();
        let values = rows.map(|KeyRow { asked, value, allowed }| {
            let of_arm = || construction.step_of_number(asked.measured_arm(construction, &self.solution.mechanism)?);
            let step = steps.get(asked.name()).copied().or_else(of_arm);
            let step = step.map_or(0, |step| construction.step_number(step));
            (asked.name().to_owned(), KeyValue { value, unit: asked.kind().unit(scene.units), allowed, step })
        });
        KeyResult {
            kinegon_key: 1,
            title: scene.title.clone(),
            scales: KeyScales { of: self.scales },
            values: values.collect(),
        }
    }

    /// The key as a figure: scheme and plans with a table of all quantities of the form.
    #[must_use]
    pub fn key_sheet(&self) -> Drawing {
        key_sheet(&self.solution, &key_rows(&self.solution, &self.pencil))
    }

    /// The empty form of the exercise with that name.
    #[must_use]
    pub fn form(&self, name: &str) -> Measured {
        Measured::empty(self.scales, Some(name))
    }
}

/// The JSON Schema of keys.
#[must_use]
pub fn key_schema() -> serde_json::Value {
    schema!("key", KeyResult, "Kinegon key of an exercise, version 1")
}
