//! The words of messages: what was found, what is near it, and what a type error means in plain words.

use serde_json::Value as Json;

/// The text on one line for a message, cut after 80 characters; control characters cannot reach a terminal.
pub(super) fn shortened(text: &str) -> String {
    let end = text.char_indices().nth(80).map_or(text.len(), |(end, _)| end);
    let shown = text[..end].chars().map(|c| if c.is_control() { '\u{fffd}' } else { c });
    let more = if end < text.len() { "…" } else { "" };
    shown.chain(more.chars()).collect()
}

/// A number as a person would write it.
pub(super) fn number(value: f64) -> String {
    match value.abs() {
        0.0 | 1e-5..1e16 => value.to_string(),
        _ => format!("{value:e}"),
    }
}

/// Names joined by commas; of many the first twelve.
pub(super) fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut names = names.into_iter();
    let mut shown = names.by_ref().take(12).map(shortened).collect::<Vec<_>>().join(", ");
    if names.next().is_some() {
        shown.push_str(", …");
    }
    shown
}

/// The name closest to `word`, if one is close enough that a slip of the pen explains it: one letter in three wrong, or the rest left out.
pub(crate) fn nearest<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    nearest_within(word, names, 3)
}

/// The same where one letter in so many may be wrong: names of points have few.
pub(crate) fn nearest_within<'a>(
    word: &str,
    names: impl IntoIterator<Item = &'a str>,
    letters: usize,
) -> Option<&'a str> {
    let word = shortened(&word.to_lowercase());
    let mut best: Option<(usize, &str)> = None;
    // A scene may hold a million names; comparing the first thousands is enough to be helpful.
    for name in names.into_iter().take(4096) {
        let lower = name.to_lowercase();
        let begins = word.chars().count() >= 3 && lower.starts_with(&word);
        let distance = if begins { 1 } else { strsim::osa_distance(&word, &lower) };
        let slips = lower.chars().count().max(word.chars().count()) / letters;
        if (distance <= slips || begins) && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, name));
        }
    }
    best.map(|(_, name)| name)
}

/// `did you mean …?` for the nearest name.
pub(super) fn close<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<String> {
    nearest(word, names).map(|name| format!("did you mean `{name}`?"))
}

/// `did you mean …?` for the nearest name, or else the list of all after `otherwise`.
pub(super) fn suggestion<'a>(
    word: &str,
    names: impl IntoIterator<Item = &'a str> + Clone,
    otherwise: &str,
) -> Option<String> {
    close(word, names.clone()).or_else(|| {
        let all = list(names);
        (!all.is_empty()).then(|| format!("{otherwise} {all}"))
    })
}

/// What a JSON value is, as part of a sentence.
pub(super) fn describe(value: &Json) -> String {
    match value {
        Json::Null => "nothing".into(),
        Json::Bool(truth) => truth.to_string(),
        Json::Number(number) => format!("the number {number}"),
        Json::String(text) => format!("the text \"{}\"", shortened(text)),
        Json::Array(elements) => match elements.len() {
            0 => "an empty list".into(),
            count => format!("a list of {count}"),
        },
        Json::Object(_) => "an object { … }".into(),
    }
}

/// A message of serde in plain words.
pub(super) struct Plain {
    pub message: String,
    pub hint: Option<String>,
    /// The key meant, where it is not the value that is wrong.
    pub key: Option<String>,
}

/// Puts the message of a type error, made about `found` at the end of `path`, in plain words.
pub(super) fn plain(message: &str, path: &[&str], found: Option<&Json>) -> Plain {
    if let Some((word, names)) = unknown(message, "unknown field `") {
        return unknown_key(word, &names);
    }
    if let Some((word, names)) = unknown(message, "unknown variant `") {
        // The word may be a key of an object whose keys are chosen from a list.
        if found.is_some_and(Json::is_object) {
            return unknown_key(word, &names);
        }
        return Plain {
            message: format!("unknown word \"{}\"", shortened(word)),
            hint: suggestion(word, names.iter().copied(), "write one of"),
            key: None,
        };
    }
    if let Some(rest) = message.strip_prefix("missing field `") {
        let key = rest.trim_end_matches('`');
        return Plain { message: format!("`{key}` is missing"), hint: missing_hint(path, key), key: None };
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
            Plain { message, hint: type_hint(expected, found), key: None }
        }
        _ => Plain { message: message.to_owned(), hint: None, key: None },
    }
}

/// The word and the names allowed in a message like ``unknown field `x`, expected one of `a`, `b` ``.
fn unknown<'a>(message: &'a str, start: &str) -> Option<(&'a str, Vec<&'a str>)> {
    let rest = message.strip_prefix(start)?;
    let (word, rest) = rest.split_once("`, expected ").or_else(|| rest.split_once("`, there are "))?;
    Some((word, rest.split('`').skip(1).step_by(2).collect()))
}

fn unknown_key(word: &str, names: &[&str]) -> Plain {
    let key = Some(word.to_owned());
    let names = names.iter().copied().filter(|name| !name.starts_with("kinegon")).chain(["note"]);
    Plain {
        message: format!("unknown key `{}`", shortened(word)),
        hint: suggestion(word, names, "the keys here are"),
        key,
    }
}

fn missing_hint(path: &[&str], key: &str) -> Option<String> {
    let example = match (path.last().copied(), key) {
        (None, "units") => r#"add "units": { "length": "mm", "time": "s" }"#,
        (None, "links") => r#"add "links": { "1": { "points": ["A", "B"], … }, … }"#,
        (Some("units"), "length") => r#"add "length": "m", "mm", "cm", "in" or "ft""#,
        (_, "on") => r#"add "on", the link that carries the guide, or "ground""#,
        (_, "speed") => r#"add "speed", along the guide"#,
        (_, "velocity") => r#"add "velocity": [x, y]"#,
        (Some("units"), "time") => r#"add "time": "s" or "min""#,
        _ => return None,
    };
    Some(example.to_owned())
}

fn type_hint(expected: &str, found: &Json) -> Option<String> {
    match found {
        Json::String(text) if expected.contains("number") => {
            let text = text.trim();
            let number = text.trim_end_matches(|c: char| !c.is_ascii_digit()).trim_end();
            let pointed = text.replacen(',', ".", 1);
            if text.parse::<f64>().is_ok_and(f64::is_finite) {
                Some(format!("write {text} without quotes"))
            } else if pointed.parse::<f64>().is_ok_and(f64::is_finite) {
                Some(format!("write {pointed} without quotes and with a point"))
            } else if !number.parse::<f64>().is_ok_and(f64::is_finite) {
                None
            } else if expected.contains(" mm") {
                Some(format!("write {number} without quotes"))
            } else {
                Some(format!("write {number} without quotes; units stand in `units`, angles are in degrees"))
            }
        }
        Json::Number(number) if expected.contains("text") || expected.contains("name") => {
            Some(format!("write \"{number}\" in double quotes"))
        }
        _ => None,
    }
}
