//! From a file's text to JSON, strictly: no comments, no doubled keys, no number that overflows, no `null`, not too deep.

use std::ops::Range;

use jsonc_parser::ast::{Object, Value};
use jsonc_parser::errors::{ParseError, ParseErrorKind as Kind};
use serde_json::{Map, Number, Value as Json};

use super::MAX_BYTES;
use super::error::SceneError;
use super::kind::FileKind;
use super::place::{Source, key_range, parse_tree, push_index, push_key, range_of, without_mark};
use super::words::shortened;

/// The deepest nesting of brackets that is read; a scene needs five.
const MAX_DEPTH: usize = 64;

/// The largest number that is read: products of three are still numbers. No unit makes a larger one necessary.
pub(super) const LARGEST: f64 = 1e100;

/// Bytes, what is wrong with them, and what to try.
type Wrong = (Range<usize>, String, Option<&'static str>);
type NotJson = (Range<usize>, String, Option<String>);

/// The text as JSON, without its notes and its `$schema`.
pub(super) fn parse(source: Source<'_>, kind: &FileKind) -> Result<Json, SceneError> {
    let what = kind.what;
    let (body, offset) = without_mark(source.0);
    let at = |span: Range<usize>| Some(source.place(span.start + offset..span.end + offset));
    let failure = |span: Option<Range<usize>>, message: String, hint: Option<&str>| SceneError {
        path: String::new(),
        place: span.and_then(at),
        message,
        hint: hint.map(str::to_owned),
    };
    if source.0.len() > MAX_BYTES {
        let message =
            format!("the {what} has {} bytes; at most {MAX_BYTES} ({} MiB) are read", source.0.len(), MAX_BYTES >> 20);
        return Err(failure(None, message, None));
    }
    if body.trim().is_empty() {
        return Err(failure(None, format!("the {what} is empty"), Some(&kind.beginning())));
    }
    if let Some((span, message, hint)) = scan(body) {
        return Err(failure(Some(span), message, hint));
    }
    let tree = match parse_tree(body) {
        Ok(tree) => tree.value,
        Err(error) => {
            let (span, message, hint) = not_json(body, &error, kind);
            return Err(failure(Some(span), message, hint.as_deref()));
        }
    };
    // What the parser lets through although it is not JSON, such as control characters in texts.
    if let Err(error) = serde_json::from_str::<serde::de::IgnoredAny>(body) {
        let start = offset_of(body, error.line(), error.column());
        let whole = error.to_string();
        let what = whole.split(" at line ").next().unwrap_or(&whole);
        return Err(failure(Some(start..start), format!("this is not JSON: {what}"), None));
    }
    let root = tree.expect("a text that is not blank has a value");
    let mut reader = ToJson { source, offset, path: String::new() };
    reader.value(&root)
}

/// What the parser would not find in time, or at all: brackets nested too deep, and line breaks inside texts.
fn scan(body: &str) -> Option<Wrong> {
    let (mut depth, mut in_text, mut escaped) = (0_usize, false, false);
    for (at, byte) in body.bytes().enumerate() {
        match (in_text, byte) {
            (true, b'\n' | b'\r') => {
                let message = "a text ends on the line it begins on".into();
                return Some((at..at + 1, message, Some(r#"add the missing ", or write \n for a line break"#)));
            }
            (true, 0..0x20) => {
                let message = "a text holds a tab or another control character".into();
                return Some((at..at + 1, message, Some(r"write \t for a tab")));
            }
            (true, _) if escaped => escaped = false,
            (true, b'\\') => escaped = true,
            (_, b'"') => in_text = !in_text,
            (false, b'{' | b'[') => depth += 1,
            (false, b'}' | b']') => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MAX_DEPTH {
            let message = format!("brackets are nested deeper than {MAX_DEPTH} levels");
            return Some((at..at + 1, message, None));
        }
    }
    None
}

/// The byte at a line and a column of bytes, both counted from 1, moved back to the start of its character.
fn offset_of(body: &str, line: usize, column: usize) -> usize {
    let line_start: usize = body.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let mut at = (line_start + column.saturating_sub(1)).min(body.len());
    while !body.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Where a text stops being JSON, why, and what to try.
fn not_json(body: &str, error: &ParseError, kind: &FileKind) -> NotJson {
    let what = kind.what;
    let span = range_of(&error.range());
    let word: String = body[span.start..].chars().take_while(|c| c.is_alphanumeric() || "_+-.".contains(*c)).collect();
    let word: String = word.chars().take(40).collect();
    let shown = span.start..span.end.max(span.start + word.len()).min(body.len());
    let not_a_number = format!("every number of a {what} is finite; leave the key out where a value is not known");
    let beginning = kind.beginning();
    let one = format!("a file holds one {what}, in one pair of {{ }}");
    let (message, hint): (String, Option<&str>) = match error.kind() {
        Kind::CommentsNotAllowed | Kind::UnterminatedCommentBlock => {
            ("JSON has no comments".into(), Some(r#"write "note": "…", which is allowed anywhere"#))
        }
        Kind::TrailingCommasNotAllowed => {
            ("a comma stands before the closing bracket".into(), Some("remove the comma"))
        }
        _ if body[..span.start].trim().is_empty() && !body[span.start..].starts_with(['{', '[']) => {
            ("this is not JSON".into(), Some(&beginning))
        }
        Kind::ExpectedComma
            if body[..span.start].ends_with('0') && body[span.start..].starts_with(|c: char| c.is_ascii_digit()) =>
        {
            ("a number does not begin with 0".into(), Some("remove the leading 0"))
        }
        Kind::ExpectedComma => ("a comma is missing here".into(), None),
        Kind::UnterminatedObject => ("this { is never closed".into(), Some("add the missing }")),
        Kind::UnterminatedArray => ("this [ is never closed".into(), Some("add the missing ]")),
        Kind::UnexpectedCloseBrace => ("a } stands where a value should be".into(), None),
        Kind::UnexpectedCloseBracket => ("a ] stands where a value should be".into(), None),
        Kind::UnexpectedComma => ("a comma stands where a value should be".into(), None),
        Kind::UnexpectedColon => ("a colon stands where a value should be".into(), None),
        Kind::ExpectedColonAfterObjectKey => ("a colon is missing after this key".into(), None),
        Kind::ExpectedObjectValue => ("the value of this key is missing".into(), None),
        Kind::MultipleRootJsonValues => (format!("something stands after the end of the {what}"), Some(&one)),
        Kind::SingleQuotedStringsNotAllowed => {
            ("texts stand in double quotes".into(), Some(r#"write "A" in place of 'A'"#))
        }
        Kind::ExpectedStringObjectProperty => {
            (format!("the key {word} needs double quotes"), Some(r#"write "key": value"#))
        }
        Kind::NonFiniteNumbersNotAllowed => (format!("{word} is not a number"), Some(&not_a_number)),
        Kind::UnexpectedWord | Kind::ExpectedDigitFollowingNegativeSign
            if ["nan", "inf", "infinity"].contains(&word.to_lowercase().as_str()) =>
        {
            (format!("{word} is not a number"), Some(&not_a_number))
        }
        Kind::UnexpectedWord | Kind::UnexpectedToken | Kind::UnexpectedTokenInObject => match word.as_str() {
            "" => (format!("{:?} does not belong here", body[span.start..].chars().next().unwrap_or(' ')), None),
            "None" => ("None is not a value".into(), Some("leave the key out")),
            "True" => ("True is not a value".into(), Some("write true")),
            "False" => ("False is not a value".into(), Some("write false")),
            _ => (format!("{word} is not a value"), Some("texts and names stand in double quotes")),
        },
        Kind::UnaryPlusNumbersNotAllowed => ("a number has no plus sign before it".into(), Some("remove the +")),
        Kind::HexadecimalNumbersNotAllowed => ("numbers are decimal".into(), None),
        Kind::BareDecimalPointNumbersNotAllowed => {
            ("a decimal point needs digits on both sides".into(), Some("write 0.5 for .5, and 5.0 for 5."))
        }
        Kind::ExpectedDigit
        | Kind::ExpectedDigitFollowingNegativeSign
        | Kind::ExpectedPlusMinusOrDigitInNumberLiteral => ("this number is not complete".into(), None),
        Kind::String(_) if body[span.clone()].trim_start_matches('"').contains('\\') => {
            (r"a \ in a text begins an escape, and this is none".into(), Some(r"write \\ for the character \"))
        }
        Kind::String(_) => ("this text is never closed".into(), Some("add the missing \"")),
        other => (format!("this is not JSON: {}", other.to_string().to_lowercase()), None),
    };
    (shown, message, hint.map(str::to_owned))
}

/// Turns the tree into JSON and knows the path it is at.
struct ToJson<'a> {
    source: Source<'a>,
    offset: usize,
    path: String,
}

impl ToJson<'_> {
    fn error(&self, span: Range<usize>, message: String, hint: &str) -> SceneError {
        let place = self.source.place(span.start + self.offset..span.end + self.offset);
        SceneError { path: self.path.clone(), place: Some(place), message, hint: Some(hint.to_owned()) }
    }

    fn value(&mut self, value: &Value<'_>) -> Result<Json, SceneError> {
        Ok(match value {
            Value::StringLit(text) => Json::String(text.value.clone().into_owned()),
            Value::BooleanLit(truth) => Json::Bool(truth.value),
            Value::NullKeyword(null) => {
                return Err(self.error(range_of(null), "null is not a value here".into(), "leave the key out"));
            }
            Value::NumberLit(number) => Json::Number(self.number(number.value, range_of(number))?),
            Value::Array(array) => {
                let mut elements = Vec::with_capacity(array.elements.len());
                for (index, element) in array.elements.iter().enumerate() {
                    let length = self.path.len();
                    push_index(&mut self.path, &index.to_string());
                    elements.push(self.value(element)?);
                    self.path.truncate(length);
                }
                Json::Array(elements)
            }
            Value::Object(object) => Json::Object(self.object(object)?),
        })
    }

    fn object(&mut self, object: &Object<'_>) -> Result<Map<String, Json>, SceneError> {
        let mut map = Map::new();
        let top = self.path.is_empty();
        for property in &object.properties {
            let name = property.name.as_str();
            if name == "note" || (top && name == "$schema") {
                continue;
            }
            let length = self.path.len();
            push_key(&mut self.path, name);
            if map.contains_key(name) {
                let first = object.properties.iter().find(|other| other.name.as_str() == name);
                let first = first.map_or(0..0, key_range);
                let line = self.source.place(first.start + self.offset..first.end + self.offset).line;
                let message = format!("key `{}` stands twice: first at line {line}", shortened(name));
                return Err(self.error(key_range(property), message, "keep one of them"));
            }
            map.insert(name.to_owned(), self.value(&property.value)?);
            self.path.truncate(length);
        }
        Ok(map)
    }

    fn number(&self, text: &str, span: Range<usize>) -> Result<Number, SceneError> {
        if let Ok(integer) = text.parse::<i64>() {
            return Ok(Number::from(integer));
        }
        let number = text.parse::<f64>().ok().filter(|x| x.abs() <= LARGEST);
        number.and_then(Number::from_f64).ok_or_else(|| {
            let message = format!("{} is too large to compute with", shortened(text));
            self.error(span, message, "choose units that make it less than 1e100")
        })
    }
}
