//! The values of a style file: colours, lengths, dashes. Messages about a wrong value list the permitted forms.

use super::super::look::{Colour, Dash};
use crate::scene::{Measure, several_forms};
use serde::de::{Error, SeqAccess, Unexpected, Visitor};
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
pub(super) struct Millimetres(pub f64);

impl Millimetres {
    /// A larger value is taken for a mistake.
    const MOST: f64 = 10.0;
}

/// The dashes of a pen's lines.
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

/// Smallest and largest size on a sheet in mm; others are taken for mistakes.
const SIZE_MM: [f64; 2] = [0.1, 40.0];
/// Smallest and largest size as a part of the sheet, in per cent.
const SIZE_PERCENT: [f64; 2] = [0.1, 20.0];

/// Reads a value that a file may write as a number, a text or a list of lengths. Each form that is allowed has a function
/// that gives none for a value that is out of range or unknown.
struct Forms<T> {
    expecting: &'static str,
    number: Option<fn(f64) -> Option<T>>,
    text: Option<fn(&str) -> Option<T>>,
    list: Option<fn(Dash) -> Option<T>>,
}

impl<T> Forms<T> {
    /// No forms yet; messages say that this was expected.
    fn new(expecting: &'static str) -> Self {
        Self { expecting, number: None, text: None, list: None }
    }
}

impl<'de, T> Visitor<'de> for Forms<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expecting)
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<T, E> {
        match self.number {
            Some(read) => read(number).ok_or_else(|| E::invalid_value(Unexpected::Float(number), &self)),
            None => Err(E::invalid_type(Unexpected::Float(number), &self)),
        }
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<T, E> {
        match self.number {
            Some(_) => self.visit_f64(number as f64),
            None => Err(E::invalid_type(Unexpected::Signed(number), &self)),
        }
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        match self.number {
            Some(_) => self.visit_f64(number as f64),
            None => Err(E::invalid_type(Unexpected::Unsigned(number), &self)),
        }
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        match self.text {
            Some(read) => read(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self)),
            None => Err(E::invalid_type(Unexpected::Str(text), &self)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<T, A::Error> {
        let Some(read) = self.list else { return Err(A::Error::invalid_type(Unexpected::Seq, &self)) };
        let mut list = Dash::new();
        while let Some(Millimetres(mm)) = seq.next_element()? {
            list.push(mm);
        }
        read(list).ok_or_else(|| A::Error::invalid_value(Unexpected::Seq, &self))
    }
}

/// A colour from the form `#rrggbb`.
fn colour(text: &str) -> Option<Colour> {
    let digits = text.strip_prefix('#')?;
    let hexadecimal = digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit());
    let rgb = u32::from_str_radix(digits, 16).ok();
    rgb.filter(|_| hexadecimal).map(Colour::new)
}

fn paint(text: &str) -> Option<Paint> {
    match text {
        "none" => Some(Paint::None),
        "ink" => Some(Paint::Ink),
        "background" => Some(Paint::Background),
        "link" => Some(Paint::Link),
        "tint" => Some(Paint::Tint),
        "pale" => Some(Paint::Pale),
        "curve" => Some(Paint::Curve),
        _ => colour(text).map(Paint::Of),
    }
}

fn millimetres(mm: f64) -> Option<Millimetres> {
    (0.0..=Millimetres::MOST).contains(&mm).then_some(Millimetres(mm))
}

/// A size in mm.
fn size(mm: f64) -> Option<Measure> {
    let [least, most] = SIZE_MM;
    (least..=most).contains(&mm).then_some(Measure::Millimetres(mm))
}

/// A size as a part of the sheet, from a form as `3.6 %`.
fn percent(text: &str) -> Option<Measure> {
    let part = text.strip_suffix('%')?.trim().parse::<f64>().ok()?;
    let [least, most] = SIZE_PERCENT;
    (least..=most).contains(&part).then_some(Measure::Percent(part))
}

/// Whether dashes and gaps can be repeated: with an odd number they would swap at every repetition, and dashes of zero
/// length would have no end.
fn is_in_turn(dash: &Dash) -> bool {
    dash.len().is_multiple_of(2) && dash.iter().all(|mm| *mm > 0.0)
}

several_forms!(Colour, "colour", Forms { text: Some(colour), ..Forms::new("a colour as \"#b5361c\"") }, _generator => {
    "description": "Red, green and blue",
    "type": "string", "pattern": "^#[0-9a-fA-F]{6}$"
});

const PAINTS: &str =
    "a colour as \"#b5361c\", or one of \"none\", \"ink\", \"background\", \"link\", \"tint\", \"pale\", \"curve\"";

several_forms!(Paint, "paint", Forms { text: Some(paint), ..Forms::new(PAINTS) }, generator => {
    "description": "A colour; or the style's ink, the background, the colour, the tint or a pale shade of the mark's link, the colour of its curve",
    "anyOf": [
        generator.subschema_for::<Colour>(),
        { "enum": ["none", "ink", "background", "link", "tint", "pale", "curve"] },
    ]
});

const MILLIMETRES: &str = "a number of mm from 0 to 10";

several_forms!(Millimetres, "millimetres", Forms { number: Some(millimetres), ..Forms::new(MILLIMETRES) }, _generator => {
    "type": "number", "minimum": 0, "maximum": Millimetres::MOST
});

const SIZES: &str = "a number of mm from 0.1 to 40, or a part of the sheet's shorter side from 0.1 to 20 as \"3.6 %\"";

several_forms!(Measure, "measure", Forms { number: Some(size), text: Some(percent), ..Forms::new(SIZES) }, _generator => {
    "anyOf": [
        { "description": "In mm", "type": "number", "minimum": SIZE_MM[0], "maximum": SIZE_MM[1] },
        { "description": "Of the sheet's shorter side", "type": "string", "pattern": "^[0-9]+([.][0-9]+)? ?%$" },
    ]
});

const DASHES: &str = "dashes and gaps above 0 in turn as [1.8, 1.0], [] for a full line, or \"curve\"";

several_forms!(Dashes, "dashes", Forms {
    text: Some(|text| (text == "curve").then_some(Dashes::OfCurve)),
    list: Some(|dash| is_in_turn(&dash).then_some(Dashes::Of(dash))),
    ..Forms::new(DASHES)
}, generator => {
    "anyOf": [
        generator.subschema_for::<DashList>(),
        { "const": "curve", "description": "The dash of the mark's curve" },
    ]
});

several_forms!(DashList, "dash", Forms {
    // A word is a wrong value, not a value of a wrong kind: a pen's dashes may be a word.
    text: Some(|_| None),
    list: Some(|dash| is_in_turn(&dash).then_some(DashList(dash))),
    ..Forms::new("dashes and gaps above 0 in turn as [1.8, 1.0], or [] for a full line")
}, _generator => {
    "description": "Dashes and gaps in turn, in mm; [] for a full line",
    "type": "array", "items": { "type": "number", "exclusiveMinimum": 0, "maximum": Millimetres::MOST }
});
