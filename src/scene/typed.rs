//! In: the text of a file. Out: its typed values, or its first error in plain words.

use serde::de::DeserializeOwned;
use serde_json::Value as Json;

use super::error::SceneError;
use super::hint::{out_of_scope, type_hint, word_hint};
use super::kind::FileKind;
use super::place::Source;
use super::reader::{Reader, Refusal, Why};
use super::text;
use super::words::{nearest, shortened, suggestion};
use super::wrong::Wrong;

/// The typed values of a file of that kind, or its first error.
pub(crate) fn read_as<T: DeserializeOwned>(text: &str, kind: &FileKind) -> Result<T, SceneError> {
    let source = Source(text);
    let read = || {
        let json = text::parse(source, kind)?;
        check_version(&json, kind)?;
        typed(&json)
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

/// The JSON as typed values.
fn typed<T: DeserializeOwned>(json: &Json) -> Result<T, Wrong> {
    T::deserialize(Reader(json)).map_err(|Refusal { mut path, why }| {
        path.reverse();
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        why.in_plain_words(&path, at(json, &path))
    })
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
                let hint = out_of_scope(word).or_else(|| suggestion(word, names, "the keys here are"));
                Wrong::key(path, format!("unknown key `{}`", shortened(word))).maybe_hint(hint)
            }
            Why::UnknownWord(word, names) => {
                let hint = suggestion(&word, names.iter().copied(), "write one of");
                Wrong::value(path, format!("unknown word \"{}\"", shortened(&word))).maybe_hint(hint)
            }
            Why::Missing(key) => Wrong::value(path, format!("`{key}` is missing")).maybe_hint(missing_hint(path, key)),
            Why::Type(expected) => {
                let hint = found.and_then(|found| type_hint(path, &expected, found));
                let found = found.map_or_else(String::new, describe);
                Wrong::value(path, format!("expected {expected}, found {found}")).maybe_hint(hint)
            }
            Why::Said(message) => {
                let word = found.and_then(Json::as_str);
                Wrong::value(path, message).maybe_hint(word.and_then(|word| word_hint(path, word)))
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
