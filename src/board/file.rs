//! The drawing file, version 1, key by key; `entry` has what a hand does.

use super::entry::{Entry, Undo};
use crate::check;
use crate::scene::{FileKind, SceneError, read_as, schema};
use crate::sheet::Scales;
use crate::text::Untrusted;
use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

const DRAWING: FileKind = FileKind { what: crate::scene::says::drawing, key: "kinegon_drawing", version: 1 };

/// Most entries of a drawing: a hand that draws Figure 2 of the source paper, with all its errors rubbed out, needs some hundred.
pub const MOST_ENTRIES: usize = 2_000;

/// The plans as somebody drew them, operation by operation.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "drawing"))]
#[serde(deny_unknown_fields, expecting = r#"a drawing as { "kinegon_drawing": 1, … }"#)]
pub struct HandDrawing {
    /// Version of the format.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "crate::scene::schema_made::version"))]
    #[serde(rename = "kinegon_drawing")]
    _version: u64,
    /// Where an editor finds the schema.
    #[cfg_attr(feature = "schemas", schemars(skip))]
    #[serde(rename = "$schema")]
    _schema: Option<String>,
    /// The student's name.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<String>"))]
    pub name: Option<Untrusted>,
    /// The name of the exercise, as "four-bar-7-2".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<String>"))]
    pub exercise: Option<Untrusted>,
    /// What the board let the hand catch; left out: all. It decides nothing, as free lines have their places beside them.
    #[serde(default)]
    pub snap: Snap,
    /// Scales of the sheets, units of the scene per millimetre of paper; left out: those of the scene's figure.
    #[serde(rename = "mu_*", default)]
    #[cfg_attr(feature = "schemas", schemars(flatten, schema_with = "scales"))]
    pub mu: Scales,
    /// How many hints the student has taken.
    #[serde(default)]
    pub hints: u64,
    /// The operations in the order in which they were done; nothing is ever taken out.
    #[cfg_attr(feature = "schemas", schemars(length(max = MOST_ENTRIES)))]
    pub did: Vec<Entry>,
}

#[cfg(feature = "schemas")]
fn scales(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    Scales::schema(generator, |sheet| {
        let units = sheet.facts().scaled_units;
        serde_json::json!({ "description": format!("Scale of the {}, in {units} per millimetre of paper", sheet.name()) })
    })
}

/// What a board lets the hand catch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "kebab-case")]
pub enum Snap {
    /// Points, crossings and directions: what is drawn is exact.
    #[default]
    All,
    /// Points, but no directions and no crossings.
    Points,
    /// Nothing.
    None,
}

impl HandDrawing {
    /// The drawing of a text.
    ///
    /// # Errors
    /// The first thing that is wrong with the text, with its place.
    pub fn read(text: &str) -> Result<HandDrawing, SceneError> {
        let drawing: HandDrawing = read_as(text, &DRAWING)?;
        if drawing.did.len() > MOST_ENTRIES {
            let message = super::says::too_many(MOST_ENTRIES, drawing.did.len());
            return Err(crate::scene::SceneTree::error(text, &["did"], message, None));
        }
        if let Some((sheet, _)) = drawing.mu.given().find(|(_, mu)| !(mu.is_finite() && *mu > 0.0)) {
            let key = sheet.facts().scale_key;
            let hint = check::says::scale_is_positive();
            return Err(crate::scene::SceneTree::error(text, &[key], check::says::no_scale(key), Some(hint)));
        }
        Ok(drawing)
    }

    /// Whether a text is meant as a drawing: it has the key of one.
    #[must_use]
    pub fn is_one(text: &str) -> bool {
        serde_json::from_str::<Json>(text.trim_start_matches('\u{feff}'))
            .is_ok_and(|json| json.get(DRAWING.key).is_some())
    }

    /// For each entry whether it still stands at the end, and is no undo.
    #[must_use]
    pub fn standing(&self) -> Vec<bool> {
        let mut standing = vec![false; self.did.len()];
        let mut stack: Vec<usize> = Vec::new();
        for (index, entry) in self.did.iter().enumerate() {
            match entry {
                Entry::Undo(Undo { undo }) => stack.truncate(stack.len().saturating_sub(*undo)),
                _ => stack.push(index),
            }
        }
        stack.into_iter().for_each(|index| standing[index] = true);
        standing
    }
}

/// The JSON Schema of drawings.
#[must_use]
pub fn drawing_schema() -> Json {
    schema!("drawing", HandDrawing, "A drawing of plans by hand for Kinegon")
}
