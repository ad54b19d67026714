//! What a hand does with ruler, set squares, dividers, pencil and calculator: the entries of a drawing file, key by key.

use super::direction::Direction;
use super::formula::Formula;
use crate::sheet::Sheet;
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value as Json};

/// The longest name or formula, in characters.
const LONGEST: usize = 500;

/// Something that a hand does.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(untagged))]
#[non_exhaustive]
pub enum Entry {
    /// A line through two points.
    Join(Join),
    /// A line of known direction through a point.
    Line(Line),
    /// A point where two lines cross.
    Cross(Cross),
    /// A vector of known size and direction.
    LayOff(LayOff),
    /// The image of a point by a similar triangle.
    Like(Like),
    /// A point put down with nothing said of how.
    Mark(Mark),
    /// The distance of two points.
    Measure(Measure),
    /// A number from others.
    Compute(Compute),
    /// Numbers from equations.
    Solve(Solve),
    /// Takes back what was done last.
    Undo(Undo),
}

/// A line through two points of a sheet.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Join {
    /// The line's name.
    pub join: String,
    /// The sheet; left out where a name decides it.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "sheet"))]
    #[serde(default, deserialize_with = "on")]
    pub on: Option<Sheet>,
    /// The points.
    pub points: [String; 2],
}

/// A line of known direction through a point.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// The line's name.
    pub line: String,
    /// The sheet; left out where a name decides it.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "sheet"))]
    #[serde(default, deserialize_with = "on")]
    pub on: Option<Sheet>,
    /// A point of it; may be left out where `drawn` stands.
    pub through: Option<String>,
    /// Its direction; may be left out where `drawn` stands.
    pub along: Option<Direction>,
    /// As a free hand drew it: a place of it in millimetres from the pole, or from the scheme's first point, x right, y up; and its
    /// direction in degrees.
    pub drawn: Option<[f64; 3]>,
}

/// A point where two lines cross.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Cross {
    /// The point's name.
    pub cross: String,
    /// The lines.
    pub of: [String; 2],
    /// As a free hand marked it, in millimetres.
    pub drawn: Option<[f64; 2]>,
}

/// A vector of known size and direction, laid off from a point.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct LayOff {
    /// The name of its end.
    pub lay_off: String,
    /// The sheet; left out where a name decides it.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "sheet"))]
    #[serde(default, deserialize_with = "on")]
    pub on: Option<Sheet>,
    /// Where it begins.
    pub from: String,
    /// Its size in the scene's units; a negative one runs against the direction.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "formula"))]
    pub size: Formula,
    /// Its direction.
    pub along: Direction,
    /// Where a free hand put its end, in millimetres.
    pub drawn: Option<[f64; 2]>,
}

/// The image of a third point of a link by a similar triangle; where the three are on a line, by their ratio.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Like {
    /// The name of the image.
    pub like: String,
    /// The sheet; left out where a name decides it.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "sheet"))]
    #[serde(default, deserialize_with = "on")]
    pub on: Option<Sheet>,
    /// The images of the first two points.
    pub ends: [String; 2],
    /// On the scheme: two points of a link, and the third.
    pub points: [String; 3],
    /// Whether the triangle is turned over.
    #[serde(default)]
    pub mirrored: bool,
}

/// A point put down with nothing said of how.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Mark {
    /// The point's name.
    pub mark: String,
    /// The sheet.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "sheet"))]
    #[serde(default, deserialize_with = "on")]
    pub on: Option<Sheet>,
    /// Where it is, in millimetres.
    pub drawn: [f64; 2],
}

/// The distance of two points of a sheet, in the scene's units.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Measure {
    /// The number's name: a quantity, as "vplan(b,c)", or one's own, as "bc".
    pub measure: String,
    /// The sheet; left out where a name decides it.
    #[cfg_attr(feature = "schemas", schemars(schema_with = "sheet"))]
    #[serde(default, deserialize_with = "on")]
    pub on: Option<Sheet>,
    /// From this point …
    pub from: String,
    /// … to this one.
    pub to: String,
    /// The number as it was read; left out: as the drawing has it.
    pub read: Option<f64>,
}

/// A number from others, or typed.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Compute {
    /// The number's name: a quantity, as "omega(2)", or one's own.
    pub compute: String,
    /// How it is computed.
    #[serde(rename = "as")]
    #[cfg_attr(feature = "schemas", schemars(schema_with = "formula"))]
    pub by: Option<Formula>,
    /// The number, where it was computed elsewhere.
    pub value: Option<f64>,
    /// The sense of a link's rate; then the number is its size. Left out: the number has its own sign.
    pub sense: Option<Sense>,
}

/// Linear equations for as many numbers.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Solve {
    /// The names of the unknowns.
    #[cfg_attr(feature = "schemas", schemars(length(min = 1, max = 4)))]
    pub solve: Vec<String>,
    /// As many equations, each as "L(B,S3) * omega(2) = vplan(p,b)".
    #[cfg_attr(feature = "schemas", schemars(length(min = 1, max = 4)))]
    pub equations: Vec<String>,
}

/// Takes back the last entries that still stand.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(deny_unknown_fields)]
pub struct Undo {
    /// How many.
    #[cfg_attr(feature = "schemas", schemars(range(min = 1)))]
    pub undo: usize,
}

/// The sense in which a link turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// Counter-clockwise: positive.
    Ccw,
    /// Clockwise.
    Cw,
}

impl Sense {
    /// The sign of such a rate.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Sense::Ccw => 1.0,
            Sense::Cw => -1.0,
        }
    }
}

/// The key by which an entry is known, and how it is read.
type Tool = (&'static str, fn(Json) -> Result<Entry, serde_json::Error>);

fn read<T: DeserializeOwned>(keys: Json, of: fn(T) -> Entry) -> Result<Entry, serde_json::Error> {
    serde_json::from_value(keys).map(of)
}

const TOOLS: [Tool; 10] = [
    ("join", |keys| read(keys, Entry::Join)),
    ("line", |keys| read(keys, Entry::Line)),
    ("cross", |keys| read(keys, Entry::Cross)),
    ("lay_off", |keys| read(keys, Entry::LayOff)),
    ("like", |keys| read(keys, Entry::Like)),
    ("mark", |keys| read(keys, Entry::Mark)),
    ("measure", |keys| read(keys, Entry::Measure)),
    ("compute", |keys| read(keys, Entry::Compute)),
    ("solve", |keys| read(keys, Entry::Solve)),
    ("undo", |keys| read(keys, Entry::Undo)),
];

impl<'de> Deserialize<'de> for Entry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Entry, D::Error> {
        let mut keys = Map::<String, Json>::deserialize(deserializer)?;
        // When it was done; a replay shows it, nothing else asks.
        if let Some(time) = keys.remove("t")
            && time.as_f64().is_none()
        {
            return Err(D::Error::custom("`t` is a number of milliseconds"));
        }
        let known = TOOLS.iter().find(|(key, _)| keys.contains_key(*key));
        let Some((_, read)) = known else {
            let all: Vec<&str> = TOOLS.iter().map(|(key, _)| *key).collect();
            return Err(D::Error::custom(format!("an entry has one of the keys {}", all.join(", "))));
        };
        if keys.values().any(is_too_long) {
            return Err(D::Error::custom(format!("names and formulas have at most {LONGEST} characters")));
        }
        let entry = read(Json::Object(keys)).map_err(D::Error::custom)?;
        entry.checked().map_err(D::Error::custom)
    }
}

fn is_too_long(value: &Json) -> bool {
    match value {
        Json::String(text) => text.chars().count() > LONGEST,
        Json::Array(all) => all.len() > 8 || all.iter().any(is_too_long),
        Json::Object(all) => all.values().any(is_too_long),
        _ => false,
    }
}

impl Entry {
    /// What the types do not say.
    fn checked(self) -> Result<Entry, &'static str> {
        match &self {
            Entry::Line(Line { through, along, drawn: None, .. }) if through.is_none() || along.is_none() => {
                Err("a line has `through` and `along`, or `drawn`")
            }
            Entry::Compute(Compute { by, value, .. }) if by.is_some() == value.is_some() => {
                Err("a number is computed `as` a formula, or has a `value`")
            }
            Entry::Solve(Solve { solve, equations })
                if solve.is_empty() || solve.len() > 4 || solve.len() != equations.len() =>
            {
                Err("one to four numbers are solved for, by as many equations")
            }
            _ => Ok(self),
        }
    }

    /// The names that it makes.
    pub(super) fn made(&self) -> Vec<&str> {
        match self {
            Entry::Join(Join { join: name, .. })
            | Entry::Line(Line { line: name, .. })
            | Entry::Cross(Cross { cross: name, .. })
            | Entry::LayOff(LayOff { lay_off: name, .. })
            | Entry::Like(Like { like: name, .. })
            | Entry::Mark(Mark { mark: name, .. })
            | Entry::Measure(Measure { measure: name, .. })
            | Entry::Compute(Compute { compute: name, .. }) => vec![name],
            Entry::Solve(Solve { solve, .. }) => solve.iter().map(String::as_str).collect(),
            Entry::Undo(_) => Vec::new(),
        }
    }
}

fn on<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Sheet>, D::Error> {
    let Some(word) = Option::<String>::deserialize(deserializer)? else {
        return Ok(None);
    };
    let known = Sheet::from_word(&word);
    known
        .map(Some)
        .ok_or_else(|| D::Error::custom(r#"a sheet is "scheme", "velocity", "acceleration", "centers" or "forces""#))
}

#[cfg(feature = "schemas")]
fn sheet(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({ "enum": Sheet::ALL.map(Sheet::as_str) })
}

#[cfg(feature = "schemas")]
fn formula(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({ "type": ["string", "number"], "description": "A number, or a formula as \"omega(1)^2 * L(A,B)\"" })
}
