//! In: the text of a file. Out: its typed values, or its first error in plain words, with what to try.

use super::choices::{LengthUnit, Page};
use super::error::{SceneError, Source, Wrong, nearest, shortened, suggestion};
use super::joint::out_of_scope;
use super::reader::{Reader, Refusal, Why};
use super::text;
use super::text::FileKind;
use crate::sheet::{Scales, Sheet};
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

/// The typed values of a file of that kind, or its first error.
pub(crate) fn read_as<T: DeserializeOwned>(text: &str, kind: &FileKind) -> Result<T, SceneError> {
    let source = Source(text);
    let read = || {
        let json = text::parse(source, kind)?;
        check_version(&json, kind)?;
        T::deserialize(Reader(&json)).map_err(|Refusal { mut path, why }| {
            path.reverse();
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            why.in_plain_words(&path, at(&json, &path))
        })
    };
    read().map_err(|wrong| source.error(wrong))
}

/// Checks the version before all else: a file of another version may have other keys.
fn check_version(json: &Json, kind: &FileKind) -> Result<(), Wrong> {
    let FileKind { what, key, version } = *kind;
    let Some(object) = json.as_object() else {
        let start = kind.start();
        return Err(Wrong::value(&[], format!("expected a {what} as {start}, found {}", describe(json))));
    };
    match object.get(key) {
        None => {
            // A key with nearly this name is probably a misspelling of it.
            let hint = match object.keys().find(|other| nearest(other, [key]).is_some()) {
                Some(other) => format!("did you mean `{key}` by `{}`?", shortened(other)),
                None => format!(r#"add "{key}": {version}, the version of the {what} format"#),
            };
            let message = format!("`{key}` is missing, so this may be something other than a {what}");
            Err(Wrong::value(&[], message).hint(hint))
        }
        Some(Json::Number(said)) if said.as_f64() == Some(version as f64) => Ok(()),
        Some(Json::Number(said)) => {
            Err(Wrong::value(&[key], format!("this program reads version {version}, the {what} says {said}")))
        }
        Some(other) => {
            let found = describe(other);
            let message = format!("expected the number {version}, the version of the format, found {found}");
            Err(Wrong::value(&[key], message).hint(format!(r#"write "{key}": {version}"#)))
        }
    }
}

/// The value at a path.
fn at<'a>(json: &'a Json, path: &[&str]) -> Option<&'a Json> {
    path.iter().try_fold(json, |value, part| match value {
        Json::Object(object) => object.get(*part),
        Json::Array(array) => array.get(part.parse::<usize>().ok()?),
        _ => None,
    })
}

/// A JSON value as part of a sentence.
fn describe(value: &Json) -> String {
    match value {
        Json::Null => "nothing".into(),
        Json::Bool(truth) => truth.to_string(),
        Json::Number(number) => format!("the number {number}"),
        Json::String(text) => format!("the text \"{}\"", shortened(text)),
        Json::Array(elements) if elements.is_empty() => "an empty list".into(),
        Json::Array(elements) => format!("a list of {}", elements.len()),
        Json::Object(_) => "an object { … }".into(),
    }
}

impl Why {
    /// The error about the value `found` at the end of `path`.
    fn in_plain_words(self, path: &[&str], found: Option<&Json>) -> Wrong {
        match self {
            Why::UnknownKey(names) => {
                let word = path.last().copied().unwrap_or_default();
                let names = names.iter().copied().filter(|name| !name.starts_with("kinegon")).chain(["note"]);
                let names = names.flat_map(|name| match name {
                    Scales::FIELD => Sheet::ALL.map(|sheet| sheet.facts().scale_key).to_vec(),
                    name => vec![name],
                });
                let hint = out_of_scope(word).or_else(|| suggestion(word, names, "the keys here are"));
                Wrong::key(path, format!("unknown key `{}`", shortened(word))).maybe_hint(hint)
            }
            Why::UnknownWord(word, names) => {
                let hint = suggestion(&word, names.iter().copied(), "write one of");
                Wrong::value(path, format!("unknown word \"{}\"", shortened(&word))).maybe_hint(hint)
            }
            Why::Missing(key) => Wrong::value(path, format!("`{key}` is missing")).maybe_hint(missing_hint(path, key)),
            Why::Type(expected) => {
                let hint = match found {
                    Some(Json::String(text)) if expected.contains("number") => {
                        number_hint(path, &expected, text.trim())
                    }
                    Some(Json::Number(number)) if expected.contains("text") || expected.contains("name") => {
                        Some(format!("write \"{number}\" in double quotes"))
                    }
                    _ => None,
                };
                let found = found.map_or_else(String::new, describe);
                Wrong::value(path, format!("expected {expected}, found {found}")).maybe_hint(hint)
            }
            Why::Said(message) => {
                let hint = match (path.last(), found.and_then(Json::as_str)) {
                    (Some(&"page"), Some(word)) => suggestion(word, Page::NAMES.into_iter().flatten(), "write one of"),
                    (Some(&"values"), Some(word)) => {
                        suggestion(word, LengthUnit::ALL.map(LengthUnit::as_str), "write true, false or one of")
                    }
                    _ => None,
                };
                Wrong::value(path, message).maybe_hint(hint)
            }
        }
    }
}

fn missing_hint(path: &[&str], key: &str) -> Option<String> {
    let example = match (path.last().copied(), key) {
        (None, "units") => r#"add "units": { "length": "mm", "time": "s" }"#,
        (None, "links") => r#"add "links": { "1": { "points": ["A", "B"], … }, … }"#,
        (Some("units"), "length") => r#"add "length": "m", "mm", "cm", "in" or "ft""#,
        (Some("units"), "time") => r#"add "time": "s" or "min""#,
        (_, "on") => r#"add "on", the link that carries the guide, or "ground""#,
        (_, "speed") => r#"add "speed", along the guide"#,
        (_, "velocity") => r#"add "velocity": [x, y]"#,
        _ => return None,
    };
    Some(example.to_owned())
}

/// The hint for a text where a number is expected.
fn number_hint(path: &[&str], expected: &str, text: &str) -> Option<String> {
    let key = path.last().copied().unwrap_or_default();
    let number = text.trim_end_matches(|c: char| !c.is_ascii_digit()).trim_end();
    let pointed = text.replacen(',', ".", 1);
    let is_number = |text: &str| text.parse::<f64>().is_ok_and(f64::is_finite);
    let unit = text[number.len()..].trim().to_lowercase();
    if is_number(text) {
        return Some(format!("write {text} without quotes"));
    }
    if is_number(&pointed) {
        return Some(format!("write {pointed} without quotes and with a point"));
    }
    if let Some(value) = multiple_of_pi(text) {
        let digits = rounded(value);
        return Some(match key {
            "omega" => format!("write {digits} without quotes, or the speed as \"rpm\""),
            "angle" | "along" => {
                format!("angles are in degrees: write {} without quotes", rounded(value.to_degrees()))
            }
            _ => format!("write {digits} without quotes"),
        });
    }
    if !is_number(number) {
        return None;
    }
    if key == "omega" && ["rpm", "r/min", "1/min", "min-1", "u/min"].contains(&unit.as_str()) {
        return Some(format!("write \"rpm\": {number} in place of \"omega\""));
    }
    if key == "angle" && unit.starts_with("rad") {
        let degrees = number.parse::<f64>().unwrap_or_default().to_degrees();
        return Some(format!("angles are in degrees: write {} without quotes", rounded(degrees)));
    }
    Some(match expected.contains(" mm") {
        true => format!("write {number} without quotes"),
        false => format!("write {number} without quotes; units stand in `units`, angles are in degrees"),
    })
}

/// The value of a text like `2pi`, `pi/3`, `-2*π/3` or `2 pi rad/s`.
fn multiple_of_pi(text: &str) -> Option<f64> {
    let compact: String =
        text.to_lowercase().chars().filter(|c| !c.is_whitespace() && *c != '*' && *c != '·').collect();
    let compact =
        ["rad/s", "rad/min", "rad"].into_iter().find_map(|unit| compact.strip_suffix(unit)).unwrap_or(&compact);
    let (times, rest) = compact.split_once("pi").or_else(|| compact.split_once('π'))?;
    let times = match times {
        "" | "+" => 1.0,
        "-" | "−" => -1.0,
        times => times.parse::<f64>().ok()?,
    };
    let parts = match rest {
        "" => 1.0,
        rest => rest.strip_prefix('/')?.parse::<f64>().ok()?,
    };
    let value = times * std::f64::consts::PI / parts;
    value.is_finite().then_some(value)
}

/// Ten digits, without zeros at the end.
fn rounded(value: f64) -> String {
    let text = format!("{value:.9e}");
    text.parse().unwrap_or(value).to_string()
}
