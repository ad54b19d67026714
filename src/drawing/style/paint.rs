//! The values of a style file: colours, lengths, dashes. Messages about a wrong value list the permitted forms.

use super::super::look::{Colour, Dash};
use crate::scene::Measure;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::fmt;

/// The colour of a line or an area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Paint {
    /// Not drawn.
    None,
    /// A colour of its own.
    Of(Colour),
    /// The style's ink.
    Ink,
    /// The colour of the paper.
    Background,
    /// The colour of its link.
    Link,
    /// The tint of its link.
    Tint,
    /// A pale shade of the colour of its link.
    Pale,
    /// The colour of its curve.
    Curve,
}

/// A length in mm of paper, from 0 to [`Millimetres::MOST`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Millimetres(f64);

impl Millimetres {
    /// A larger value is taken for a mistake.
    const MOST: f64 = 10.0;
    const EXPECTED: &str = "a number of mm from 0 to 10";
}

impl From<Millimetres> for f64 {
    fn from(length: Millimetres) -> f64 {
        length.0
    }
}
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Dashes {
    /// Dashes and gaps in turn.
    Of(Dash),
    /// Those of its curve.
    OfCurve,
}

/// Dashes and gaps in turn, as a list.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DashList(pub Dash);

/// A colour from the form `#rrggbb`.
fn colour(text: &str) -> Option<Colour> {
    let digits = text.strip_prefix('#')?;
    let hexadecimal = digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit());
    let rgb = u32::from_str_radix(digits, 16).ok();
    rgb.filter(|_| hexadecimal).map(Colour::new)
}

/// Reads a value from a text.
struct Word<T> {
    value: fn(&str) -> Option<T>,
    expecting: &'static str,
}

impl<T> Visitor<'_> for Word<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        (self.value)(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
    }
}

impl<'de> Deserialize<'de> for Colour {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expecting = "a colour as \"#b5361c\"";
        deserializer.deserialize_any(Word { value: colour, expecting })
    }
}

impl<'de> Deserialize<'de> for Paint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = |text: &str| match text {
            "none" => Some(Paint::None),
            "ink" => Some(Paint::Ink),
            "background" => Some(Paint::Background),
            "link" => Some(Paint::Link),
            "tint" => Some(Paint::Tint),
            "pale" => Some(Paint::Pale),
            "curve" => Some(Paint::Curve),
            _ => colour(text).map(Paint::Of),
        };
        let expecting = "a colour as \"#b5361c\", or one of \"none\", \"ink\", \"background\", \"link\", \"tint\", \"pale\", \"curve\"";
        deserializer.deserialize_any(Word { value, expecting })
    }
}
struct Length;

impl Visitor<'_> for Length {
    type Value = Millimetres;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(Millimetres::EXPECTED)
    }

    fn visit_f64<E: Error>(self, mm: f64) -> Result<Millimetres, E> {
        match (0.0..=Millimetres::MOST).contains(&mm) {
            true => Ok(Millimetres(mm)),
            false => Err(E::invalid_value(Unexpected::Float(mm), &self)),
        }
    }

    fn visit_i64<E: Error>(self, mm: i64) -> Result<Millimetres, E> {
        self.visit_f64(mm as f64)
    }

    fn visit_u64<E: Error>(self, mm: u64) -> Result<Millimetres, E> {
        self.visit_f64(mm as f64)
    }
}

impl<'de> Deserialize<'de> for Millimetres {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Length)
    }
}

/// Reads a size on a sheet.
struct SizeForms;

impl SizeForms {
    /// Smallest and largest size in mm; others are taken for mistakes.
    const MM: [f64; 2] = [0.1, 40.0];
    /// Smallest and largest part of the sheet, in per cent.
    const PERCENT: [f64; 2] = [0.1, 20.0];
}

impl Visitor<'_> for SizeForms {
    type Value = Measure;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number of mm from 0.1 to 40, or a part of the sheet's shorter side from 0.1 to 20 as \"3.6 %\"")
    }

    fn visit_f64<E: Error>(self, mm: f64) -> Result<Measure, E> {
        let [least, most] = SizeForms::MM;
        match (least..=most).contains(&mm) {
            true => Ok(Measure::Millimetres(mm)),
            false => Err(E::invalid_value(Unexpected::Float(mm), &self)),
        }
    }

    fn visit_i64<E: Error>(self, mm: i64) -> Result<Measure, E> {
        self.visit_f64(mm as f64)
    }

    fn visit_u64<E: Error>(self, mm: u64) -> Result<Measure, E> {
        self.visit_f64(mm as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Measure, E> {
        let [least, most] = SizeForms::PERCENT;
        let part = text.strip_suffix('%').and_then(|number| number.trim().parse::<f64>().ok());
        let part = part.filter(|part| (least..=most).contains(part));
        part.map(Measure::Percent).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
    }
}

impl<'de> Deserialize<'de> for Measure {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SizeForms)
    }
}

/// Reads dashes and gaps in turn or, if `word` allows it, the word `curve`.
struct DashForms {
    word: bool,
    expecting: &'static str,
}

impl<'de> Visitor<'de> for DashForms {
    type Value = Dashes;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Dashes, E> {
        match (self.word, text) {
            (true, "curve") => Ok(Dashes::OfCurve),
            _ => Err(E::invalid_value(Unexpected::Str(text), &self)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Dashes, A::Error> {
        let mut dash = Dash::new();
        while let Some(Millimetres(mm)) = seq.next_element()? {
            dash.push(mm);
        }
        // With an odd number dashes and gaps would swap at every repetition; dashes of zero length would have no end.
        match dash.len().is_multiple_of(2) && dash.iter().all(|mm| *mm > 0.0) {
            true => Ok(Dashes::Of(dash)),
            false => Err(A::Error::invalid_value(Unexpected::Seq, &self)),
        }
    }
}

impl<'de> Deserialize<'de> for Dashes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(DashForms {
            word: true,
            expecting: "dashes and gaps above 0 in turn as [1.8, 1.0], [] for a full line, or \"curve\"",
        })
    }
}

impl<'de> Deserialize<'de> for DashList {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let dashes = deserializer.deserialize_any(DashForms {
            word: false,
            expecting: "dashes and gaps above 0 in turn as [1.8, 1.0], or [] for a full line",
        })?;
        match dashes {
            Dashes::Of(dash) => Ok(DashList(dash)),
            Dashes::OfCurve => unreachable!("the word is not allowed"),
        }
    }
}

/// The schema of a value of several forms.
macro_rules! schema_of {
    ($type:ident, $name:literal, $generator:ident => $schema:expr) => {
        impl JsonSchema for $type {
            fn schema_name() -> Cow<'static, str> {
                $name.into()
            }
            fn json_schema($generator: &mut SchemaGenerator) -> Schema {
                $schema
            }
        }
    };
}

schema_of!(Colour, "colour", _generator => json_schema!({
    "description": "Red, green and blue",
    "type": "string", "pattern": "^#[0-9a-fA-F]{6}$"
}));

schema_of!(Paint, "paint", generator => json_schema!({
    "description": "A colour; or the style's ink, the background, the colour, the tint or a pale shade of the mark's link, the colour of its curve",
    "anyOf": [
        generator.subschema_for::<Colour>(),
        { "enum": ["none", "ink", "background", "link", "tint", "pale", "curve"] },
    ]
}));

schema_of!(Millimetres, "millimetres", _generator => json_schema!({
    "type": "number", "minimum": 0, "maximum": Millimetres::MOST
}));

schema_of!(Measure, "measure", _generator => json_schema!({
    "anyOf": [
        { "description": "In mm", "type": "number", "minimum": SizeForms::MM[0], "maximum": SizeForms::MM[1] },
        { "description": "Of the sheet's shorter side", "type": "string", "pattern": "^[0-9]+([.][0-9]+)? ?%$" },
    ]
}));

schema_of!(DashList, "dash", _generator => json_schema!({
    "description": "Dashes and gaps in turn, in mm; [] for a full line",
    "type": "array", "items": { "type": "number", "exclusiveMinimum": 0, "maximum": Millimetres::MOST }
}));

schema_of!(Dashes, "dashes", generator => json_schema!({
    "anyOf": [
        generator.subschema_for::<DashList>(),
        { "const": "curve", "description": "The dash of the mark's curve" },
    ]
}));
