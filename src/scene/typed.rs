//! In: the text of a file. Out: its typed values, or its first error in plain words, with what to try.

use super::digits::without_turns;
use super::error::{SceneError, Source, Wrong, nearest, number, shortened, suggestion};
use super::joint::out_of_scope;
use super::page::Page;
use super::reader::{Reader, Refusal, Why};
use super::says;
use super::text;
use super::text::FileKind;
use super::units::LengthUnit;
use crate::message::Message;
use crate::sheet::{Scales, Sheet};
use jsonc_parser::ast::Value;
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

/// The typed values of a file of that kind, or its first error.
pub(crate) fn read_as<T: DeserializeOwned>(text: &str, kind: &FileKind) -> Result<T, SceneError> {
    read_with(text, kind, |_| ()).map(|(values, ())| values)
}

/// The typed values of a file, and what `of` makes of its tree, in which numbers stand as they are written.
pub(super) fn read_with<T: DeserializeOwned, U>(
    text: &str,
    kind: &FileKind,
    of: impl Fn(&Value<'_>) -> U,
) -> Result<(T, U), SceneError> {
    let source = Source(text);
    let read = || {
        let tree = text::tree(source, kind)?;
        let json = text::json(source, &tree, true)?;
        keeps_turns(&tree)?;
        check_version(&json, kind)?;
        let values = T::deserialize(Reader(&json)).map_err(|Refusal { mut path, why }| {
            path.reverse();
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            why.in_plain_words(&path, at(&json, &path))
        })?;
        Ok((values, of(&tree)))
    };
    read().map_err(|wrong| source.error(wrong))
}

/// Refuses angles that would lose their whole turns beside gears, where a turn of one wheel is not one of the other.
fn keeps_turns(tree: &Value<'_>) -> Result<(), Wrong> {
    let has_gears =
        tree.as_object().and_then(|scene| scene.get_array("gears")).is_some_and(|gears| !gears.elements.is_empty());
    match without_turns(tree).filter(|_| has_gears) {
        None => Ok(()),
        Some((path, angle)) => {
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            Err(Wrong::value(&path, says::turns_beside_gears(shortened(angle))).hint(says::take_turns_off()))
        }
    }
}

/// Checks the version before all else: a file of another version may have other keys.
fn check_version(json: &Json, kind: &FileKind) -> Result<(), Wrong> {
    let FileKind { what, key, version } = *kind;
    let Some(object) = json.as_object() else {
        let start = kind.start();
        return Err(Wrong::value(&[], says::expected_object(what(), start, describe(json))));
    };
    match object.get(key) {
        None => {
            // A key with nearly this name is probably a misspelling of it.
            let hint = match object.keys().find(|other| nearest(other, [key]).is_some()) {
                Some(other) => says::meant_key(key, shortened(other)),
                None => says::add_version(key, version, what()),
            };
            Err(Wrong::value(&[], says::no_version(key, what())).hint(hint))
        }
        Some(Json::Number(said)) if said.as_f64() == Some(version as f64) => Ok(()),
        Some(Json::Number(said)) => Err(Wrong::value(&[key], says::other_version(version, what(), said.to_string()))),
        Some(other) => {
            let message = says::version_is_number(version, describe(other));
            Err(Wrong::value(&[key], message).hint(says::write_version(key, version)))
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
fn describe(value: &Json) -> Message {
    match value {
        Json::Null => says::nothing(),
        Json::Bool(truth) => truth.to_string().into(),
        Json::Number(number) => says::a_number(number.to_string()),
        Json::String(text) => says::a_text(shortened(text)),
        Json::Array(elements) if elements.is_empty() => says::empty_list(),
        Json::Array(elements) => says::list_of(elements.len()),
        Json::Object(_) => says::an_object(),
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
                let hint = out_of_scope(word).or_else(|| suggestion(word, names, says::the_keys_are));
                Wrong::key(path, says::unknown_key(shortened(word))).maybe_hint(hint)
            }
            Why::UnknownWord(word, names) => {
                let hint = suggestion(&word, names.iter().copied(), says::write_one_of);
                Wrong::value(path, says::unknown_word(shortened(&word))).maybe_hint(hint)
            }
            Why::Missing(key) => Wrong::value(path, says::missing(key)).maybe_hint(missing_hint(path, key)),
            Why::Type(expected) => {
                let hint = match found {
                    Some(Json::String(_)) if matches!(path, [.., "along", _]) => Some(says::points_as_one_text()),
                    Some(Json::String(text)) if expected.contains("number") => {
                        number_hint(path, &expected, text.trim())
                    }
                    Some(Json::Number(number)) if expected.contains("text") || expected.contains("name") => {
                        Some(says::in_double_quotes(number.to_string()))
                    }
                    _ => None,
                };
                let found = found.map_or_else(|| "".into(), describe);
                Wrong::value(path, says::expected_found(says::expected(&expected), found)).maybe_hint(hint)
            }
            Why::Length(found) => Wrong::value(path, says::two_numbers(found)),
            Why::Said(message) => {
                let size = found.and_then(|found| found.get("size")?.as_f64()).filter(|size| *size < 0.0);
                match (path.last(), found.and_then(Json::as_str), size) {
                    (Some(&"page"), Some(word), _) => {
                        let hint = suggestion(word, Page::NAMES.into_iter().flatten(), says::write_one_of);
                        Wrong::value(path, says::no_page(shortened(word))).maybe_hint(hint)
                    }
                    (Some(&"values"), Some(word), _) => {
                        let units = LengthUnit::ALL.map(LengthUnit::as_str);
                        let hint = suggestion(word, units, says::write_truth_or_one_of);
                        Wrong::value(path, says::no_unit(shortened(word))).maybe_hint(hint)
                    }
                    (_, _, Some(size)) => Wrong::value(path, says::negative_size(number(size))),
                    _ => Wrong::value(path, message),
                }
            }
        }
    }
}

fn missing_hint(path: &[&str], key: &str) -> Option<Message> {
    Some(match (path.last().copied(), key) {
        (None, "units") => says::add(r#""units": { "length": "mm", "time": "s" }"#),
        (None, "links") => says::add(r#""links": { "1": { "points": ["A", "B"], … }, … }"#),
        (Some("units"), "length") => says::add_length_unit(),
        (Some("units"), "time") => says::add_time_unit(),
        (_, "on") => says::add_on(),
        (_, "speed") => says::add_speed(),
        (_, "velocity") => says::add(r#""velocity": [x, y]"#),
        _ => return None,
    })
}

/// The hint for a text where a number is expected.
fn number_hint(path: &[&str], expected: &str, text: &str) -> Option<Message> {
    let key = path.last().copied().unwrap_or_default();
    let number = text.trim_end_matches(|c: char| !c.is_ascii_digit()).trim_end();
    let pointed = text.replacen(',', ".", 1);
    let is_number = |text: &str| text.parse::<f64>().is_ok_and(f64::is_finite);
    let unit = text[number.len()..].trim().to_lowercase();
    if is_number(text) {
        return Some(says::without_quotes(text));
    }
    if is_number(&pointed) {
        return Some(says::with_a_point(pointed));
    }
    if let Some(value) = multiple_of_pi(text) {
        let digits = rounded(value);
        return Some(match key {
            "omega" => says::or_as_rpm(digits),
            "angle" | "along" => says::in_degrees(rounded(value.to_degrees())),
            _ => says::without_quotes(digits),
        });
    }
    if !is_number(number) {
        return None;
    }
    if key == "omega" && ["rpm", "r/min", "1/min", "min-1", "u/min"].contains(&unit.as_str()) {
        return Some(says::rpm_for_omega(number));
    }
    if key == "angle" && unit.starts_with("rad") {
        let degrees = number.parse::<f64>().unwrap_or_default().to_degrees();
        return Some(says::in_degrees(rounded(degrees)));
    }
    Some(match expected.contains(" mm") {
        true => says::without_quotes(number),
        false => says::units_in_units(number),
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
