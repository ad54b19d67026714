//! In: the text of a file. Out: JSON, read strictly: no comments, no key twice, no `null`, no number that overflows,
//! limited nesting.

use jsonc_parser::ast::Value;
use jsonc_parser::errors::{ParseError, ParseErrorKind as Kind};
use serde_json::{Map, Number, Value as Json};

use super::digits::within_a_turn;
use super::error::{SceneError, Source, Wrong, parse_tree, range_of, shortened};
use super::says;
use crate::message::Message;

/// A kind of file: its name in messages and the key with the version of its format.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FileKind {
    /// Its name, as "scene".
    pub what: fn() -> Message,
    /// The key of the version.
    pub key: &'static str,
    /// The version that is read.
    pub version: u64,
}

impl FileKind {
    /// A scene.
    pub(super) const SCENE: FileKind = FileKind { what: says::scene, key: "kinegon", version: 1 };

    /// How such a file begins, in a sentence for a hint.
    pub(super) fn beginning(&self) -> Message {
        says::begins_with((self.what)(), self.start())
    }

    /// How such a file begins, as JSON.
    pub(super) fn start(&self) -> String {
        format!(r#"{{ "{}": {}, … }}"#, self.key, self.version)
    }
}

/// The largest scene text that is read, in bytes; a larger one is refused before it is parsed.
pub const MAX_BYTES: usize = 4 << 20;

/// The deepest nesting of brackets that is read; a scene needs five.
const MAX_DEPTH: usize = 64;

/// The largest number that is read: products of three such numbers are finite. No choice of units needs a larger one.
pub(crate) const LARGEST: f64 = 1e100;

/// The text as a tree of JSON with its ranges of bytes; nothing is asked of its keys and values.
pub(super) fn tree<'a>(source: Source<'a>, kind: &FileKind) -> Result<Value<'a>, Wrong> {
    let (what, body, bytes) = (kind.what, source.body(), source.0.len());
    if bytes > MAX_BYTES {
        return Err(Wrong::whole(says::too_many_bytes(what(), bytes, MAX_BYTES, MAX_BYTES >> 20)));
    }
    if body.trim().is_empty() {
        return Err(Wrong::whole(says::is_empty(what())).hint(kind.beginning()));
    }
    scan(body)?;
    let tree = parse_tree(body).map_err(|error| not_json(body, &error, kind))?.value;
    // The parser accepts some texts that are not JSON, as with control characters in strings; serde_json does not.
    serde_json::from_str::<serde::de::IgnoredAny>(body).map_err(|error| {
        let start = offset_of(body, error.line(), error.column());
        let whole = error.to_string();
        let place = format!(" at line {} column {}", error.line(), error.column());
        let what = whole.strip_suffix(&place).unwrap_or(&whole);
        Wrong::whole(says::not_json(what)).at_bytes(start..start)
    })?;
    Ok(tree.expect("a text that is not blank has a value"))
}

/// Refuses what the parser would find too late or not at all: brackets nested too deep, and line breaks within strings.
fn scan(body: &str) -> Result<(), Wrong> {
    let (mut depth, mut in_text, mut escaped) = (0_usize, false, false);
    for (at, byte) in body.bytes().enumerate() {
        let wrong = |message: Message| Wrong::whole(message).at_bytes(at..at + 1);
        match (in_text, byte) {
            (true, b'\n' | b'\r') => {
                return Err(wrong(says::text_over_lines()).hint(says::add_quote_or_n()));
            }
            (true, 0..0x20) => {
                return Err(wrong(says::control_in_text()).hint(says::write_t()));
            }
            (true, _) if escaped => escaped = false,
            (true, b'\\') => escaped = true,
            (_, b'"') => in_text = !in_text,
            (false, b'{' | b'[') => depth += 1,
            (false, b'}' | b']') => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MAX_DEPTH {
            return Err(wrong(says::too_deep(MAX_DEPTH)));
        }
    }
    Ok(())
}

/// The byte offset of a line and a column in bytes, both counted from 1, moved back to the start of its character.
fn offset_of(body: &str, line: usize, column: usize) -> usize {
    let line_start: usize = body.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let at = (line_start + column.saturating_sub(1)).min(body.len());
    (0..=at).rev().find(|&at| body.is_char_boundary(at)).unwrap_or(0)
}

/// The error of a text that is not JSON: place, message and hint.
fn not_json(body: &str, error: &ParseError, kind: &FileKind) -> Wrong {
    let what = kind.what;
    let span = range_of(&error.range());
    let letters = |c: &char| c.is_alphanumeric() || "_+-.".contains(*c);
    let word: String = body[span.start..].chars().take_while(letters).take(40).collect();
    let shown = span.start..span.end.max(span.start + word.len()).min(body.len());
    let not_a_number = |word: String| (says::no_number(word), Some(says::every_number_finite(what())));
    let (message, hint) = match error.kind() {
        Kind::CommentsNotAllowed | Kind::UnterminatedCommentBlock => (says::no_comments(), Some(says::write_note())),
        Kind::TrailingCommasNotAllowed => (says::trailing_comma(), Some(says::remove_comma())),
        _ if body[..span.start].trim().is_empty() && !body[span.start..].starts_with(['{', '[']) => {
            (says::not_json_at_all(), Some(kind.beginning()))
        }
        Kind::ExpectedComma
            if body[..span.start].ends_with('0') && body[span.start..].starts_with(|c: char| c.is_ascii_digit()) =>
        {
            (says::leading_zero(), Some(says::remove_zero()))
        }
        Kind::ExpectedComma => (says::comma_missing(), None),
        Kind::UnterminatedObject => (says::brace_open(), Some(says::add_brace())),
        Kind::UnterminatedArray => (says::bracket_open(), Some(says::add_bracket())),
        Kind::UnexpectedCloseBrace => (says::brace_for_value(), None),
        Kind::UnexpectedCloseBracket => (says::bracket_for_value(), None),
        Kind::UnexpectedComma => (says::comma_for_value(), None),
        Kind::UnexpectedColon => (says::colon_for_value(), None),
        Kind::ExpectedColonAfterObjectKey => (says::colon_missing(), None),
        Kind::ExpectedObjectValue => (says::value_missing(), None),
        Kind::MultipleRootJsonValues => (says::after_end(what()), Some(says::one_in_a_file(what()))),
        Kind::SingleQuotedStringsNotAllowed => (says::single_quotes(), Some(says::write_double())),
        Kind::ExpectedStringObjectProperty => (says::key_needs_quotes(word), Some(says::write_key_value())),
        Kind::NonFiniteNumbersNotAllowed => not_a_number(word),
        Kind::UnexpectedWord | Kind::ExpectedDigitFollowingNegativeSign
            if ["nan", "inf", "infinity"].contains(&word.to_lowercase().as_str()) =>
        {
            not_a_number(word)
        }
        Kind::UnexpectedWord | Kind::UnexpectedToken | Kind::UnexpectedTokenInObject => match word.as_str() {
            "" => (says::not_here(format!("{:?}", body[span.start..].chars().next().unwrap_or(' '))), None),
            "None" => (says::no_value(word), Some(says::leave_key_out())),
            "True" => (says::no_value(word), Some(says::write_true())),
            "False" => (says::no_value(word), Some(says::write_false())),
            _ => (says::no_value(word), Some(says::names_in_quotes())),
        },
        Kind::UnaryPlusNumbersNotAllowed => (says::plus_sign(), Some(says::remove_plus())),
        Kind::HexadecimalNumbersNotAllowed => (says::decimal_only(), None),
        Kind::BareDecimalPointNumbersNotAllowed => (says::digits_both_sides(), Some(says::write_half())),
        Kind::ExpectedDigit
        | Kind::ExpectedDigitFollowingNegativeSign
        | Kind::ExpectedPlusMinusOrDigitInNumberLiteral => (says::number_incomplete(), None),
        Kind::String(_) if body[span.clone()].trim_start_matches('"').contains('\\') => {
            (says::no_escape(), Some(says::write_backslash()))
        }
        Kind::String(_) => (says::text_open(), Some(says::add_quote())),
        other => (says::not_json(other.to_string().to_lowercase()), None),
    };
    Wrong::whole(message).at_bytes(shown).maybe_hint(hint)
}

/// A part of the tree as JSON, without notes; at the top without `$schema`, which is for editors.
pub(super) fn json(source: Source<'_>, value: &Value<'_>, top: bool) -> Result<Json, Wrong> {
    Ok(match value {
        Value::StringLit(text) => Json::String(text.value.clone().into_owned()),
        Value::BooleanLit(truth) => Json::Bool(truth.value),
        Value::NullKeyword(_) => return Err(Wrong::value(&[], says::null()).hint(says::leave_key_out())),
        Value::NumberLit(number) => Json::Number(json_number(number.value)?),
        Value::Array(array) => {
            let elements = array.elements.iter().enumerate().map(|(index, element)| {
                json(source, element, false).map_err(|wrong| wrong.inside(&[&index.to_string()]))
            });
            Json::Array(elements.collect::<Result<_, _>>()?)
        }
        Value::Object(object) => {
            let mut map = Map::new();
            for property in &object.properties {
                let name = property.name.as_str();
                if name == "note" || (top && name == "$schema") {
                    continue;
                }
                if map.contains_key(name) {
                    let line = object.get(name).map_or(0, |first| source.place(range_of(&first.name)).line);
                    let message = says::key_twice(shortened(name), line);
                    let second = range_of(&property.name);
                    return Err(Wrong::key(&[name], message).at_bytes(second).hint(says::keep_one()));
                }
                let value = match &property.value {
                    Value::NumberLit(number) => json_number(&within_a_turn(name, number.value)).map(Json::Number),
                    value => json(source, value, false),
                };
                let value = value.map_err(|wrong| wrong.inside(&[name]))?;
                map.insert(name.to_owned(), value);
            }
            Json::Object(map)
        }
    })
}

fn json_number(text: &str) -> Result<Number, Wrong> {
    if let Ok(integer) = text.parse::<i64>() {
        return Ok(Number::from(integer));
    }
    let number = text.parse::<f64>().ok().filter(|x| x.abs() <= LARGEST);
    number
        .and_then(Number::from_f64)
        .ok_or_else(|| Wrong::value(&[], says::number_too_large(shortened(text))).hint(says::choose_units()))
}

/// The text of a scene as JSON.
#[derive(Debug, Clone)]
pub(crate) struct SceneTree<'a> {
    /// The text without a byte order mark. Ranges of the tree count in its bytes.
    pub body: &'a str,
    /// The value that the text holds.
    pub root: Value<'a>,
}

impl<'a> SceneTree<'a> {
    /// The tree of a text, or why this is not JSON.
    pub fn read(text: &'a str) -> Result<SceneTree<'a>, SceneError> {
        let source = Source(text);
        let root = tree(source, &FileKind::SCENE).map_err(|wrong| source.error(wrong))?;
        Ok(SceneTree { body: source.body(), root })
    }

    /// An error at a JSON path of a text; an index of a list is written in digits.
    pub fn error(text: &str, path: &[&str], message: Message, hint: Option<Message>) -> SceneError {
        Source(text).error(Wrong::value(path, message).maybe_hint(hint))
    }
}
