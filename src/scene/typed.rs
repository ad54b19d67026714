//! In: the text of a file. Out: its typed values, or its first error in plain words.

use serde::de::DeserializeOwned;
use serde_json::Value as Json;
use serde_path_to_error::Segment;

use super::error::SceneError;
use super::hint::{out_of_scope, type_hint};
use super::kind::FileKind;
use super::place::Source;
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
    let mut track = serde_path_to_error::Track::new();
    T::deserialize(serde_path_to_error::Deserializer::new(json, &mut track)).map_err(|error| {
        let parts = track.path().iter().filter_map(part).collect::<Vec<_>>();
        let path: Vec<&str> = parts.iter().map(String::as_str).collect();
        in_plain_words(&error.to_string(), &path, at(json, &path))
    })
}

/// A step of a path as text.
fn part(segment: &Segment) -> Option<String> {
    match segment {
        Segment::Seq { index } => Some(index.to_string()),
        Segment::Map { key } => Some(key.clone()),
        Segment::Enum { .. } | Segment::Unknown => None,
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

/// A message of serde about the value `found` at the end of `path`, in plain words.
fn in_plain_words(message: &str, path: &[&str], found: Option<&Json>) -> Wrong {
    if let Some((word, names)) = unknown(message, "unknown field `") {
        return unknown_key(path, word, &names);
    }
    if let Some((word, names)) = unknown(message, "unknown variant `") {
        // In an object whose keys are chosen from a list, the word is a key.
        if found.is_some_and(Json::is_object) {
            return unknown_key(path, word, &names);
        }
        let hint = suggestion(word, names.iter().copied(), "write one of");
        return Wrong::value(path, format!("unknown word \"{}\"", shortened(word))).maybe_hint(hint);
    }
    if let Some(rest) = message.strip_prefix("missing field `") {
        let key = rest.trim_end_matches('`');
        return Wrong::value(path, format!("`{key}` is missing")).maybe_hint(missing_hint(path, key));
    }
    let typed = message.starts_with("invalid type") || message.starts_with("invalid value");
    match (message.rsplit_once(", expected "), found) {
        (Some((_, expected)), Some(found)) if typed => {
            let expected = match expected {
                "f64" => "a number",
                "u16" => "a whole number from 1 to 65535",
                "a string" | "string or map" => "a text in double quotes",
                "a sequence" => "a list [ … ]",
                "a map" => "an object { … }",
                "a boolean" => "true or false",
                other => other,
            };
            let message = format!("expected {expected}, found {}", describe(found));
            Wrong::value(path, message).maybe_hint(type_hint(path, expected, found))
        }
        _ => match message.rsplit_once(HINT) {
            Some((message, hint)) => Wrong::value(path, message).hint(hint),
            None => Wrong::value(path, message),
        },
    }
}

/// Separates message and hint in the errors of types that read themselves.
pub(super) const HINT: &str = "; hint: ";

/// The word and the allowed names of a message like ``unknown field `x`, expected one of `a`, `b` ``.
fn unknown<'a>(message: &'a str, start: &str) -> Option<(&'a str, Vec<&'a str>)> {
    let rest = message.strip_prefix(start)?;
    let (word, rest) = rest.split_once("`, expected ").or_else(|| rest.split_once("`, there are "))?;
    Some((word, rest.split('`').skip(1).step_by(2).collect()))
}

/// The error of an unknown key, which is in the object at `path` or the last part of it.
fn unknown_key(path: &[&str], word: &str, names: &[&str]) -> Wrong {
    let key = if path.last() == Some(&word) { &[][..] } else { &[word] };
    let names = names.iter().copied().filter(|name| !name.starts_with("kinegon")).chain(["note"]);
    let hint = out_of_scope(word).or_else(|| suggestion(word, names, "the keys here are"));
    Wrong::key(&[path, key].concat(), format!("unknown key `{}`", shortened(word))).maybe_hint(hint)
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
