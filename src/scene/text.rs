//! In: the text of a file. Out: JSON, read strictly: no comments, no key twice, no `null`, no number that overflows,
//! limited nesting.

use jsonc_parser::ast::Value;
use jsonc_parser::errors::{ParseError, ParseErrorKind as Kind};
use serde_json::{Map, Number, Value as Json};

use super::error::{SceneError, Source, Wrong, parse_tree, range_of, shortened};

/// A kind of file: its name in messages and the key with the version of its format.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FileKind {
    /// Its name, as `scene`.
    pub what: &'static str,
    /// The key of the version.
    pub key: &'static str,
    /// The version that is read.
    pub version: u64,
}

impl FileKind {
    /// A scene.
    pub(super) const SCENE: FileKind = FileKind { what: "scene", key: "kinegon", version: 1 };

    /// How such a file begins, in a sentence for a hint.
    pub(super) fn beginning(&self) -> String {
        format!("a {} begins with {}", self.what, self.start())
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
pub(super) const LARGEST: f64 = 1e100;

/// The text as JSON, without its notes and its `$schema`.
pub(super) fn parse(source: Source<'_>, kind: &FileKind) -> Result<Json, Wrong> {
    json(source, &tree(source, kind)?, true)
}

/// The text as a tree of JSON with its ranges of bytes; nothing is asked of its keys and values.
pub(super) fn tree<'a>(source: Source<'a>, kind: &FileKind) -> Result<Value<'a>, Wrong> {
    let (what, body, bytes) = (kind.what, source.body(), source.0.len());
    if bytes > MAX_BYTES {
        let most = format!("at most {MAX_BYTES} ({} MiB) are read", MAX_BYTES >> 20);
        return Err(Wrong::whole(format!("the {what} has {bytes} bytes; {most}")));
    }
    if body.trim().is_empty() {
        return Err(Wrong::whole(format!("the {what} is empty")).hint(kind.beginning()));
    }
    scan(body)?;
    let tree = parse_tree(body).map_err(|error| not_json(body, &error, kind))?.value;
    // The parser accepts some texts that are not JSON, as with control characters in strings; serde_json does not.
    serde_json::from_str::<serde::de::IgnoredAny>(body).map_err(|error| {
        let start = offset_of(body, error.line(), error.column());
        let whole = error.to_string();
        let place = format!(" at line {} column {}", error.line(), error.column());
        let what = whole.strip_suffix(&place).unwrap_or(&whole);
        Wrong::whole(format!("this is not JSON: {what}")).at_bytes(start..start)
    })?;
    Ok(tree.expect("a text that is not blank has a value"))
}

/// Refuses what the parser would find too late or not at all: brackets nested too deep, and line breaks within strings.
fn scan(body: &str) -> Result<(), Wrong> {
    let (mut depth, mut in_text, mut escaped) = (0_usize, false, false);
    for (at, byte) in body.bytes().enumerate() {
        let wrong = |message: &str| Wrong::whole(message).at_bytes(at..at + 1);
        match (in_text, byte) {
            (true, b'\n' | b'\r') => {
                let hint = r#"add the missing ", or write \n for a line break"#;
                return Err(wrong("a text ends on the line it begins on").hint(hint));
            }
            (true, 0..0x20) => {
                return Err(wrong("a text holds a tab or another control character").hint(r"write \t for a tab"));
            }
            (true, _) if escaped => escaped = false,
            (true, b'\\') => escaped = true,
            (_, b'"') => in_text = !in_text,
            (false, b'{' | b'[') => depth += 1,
            (false, b'}' | b']') => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MAX_DEPTH {
            return Err(wrong(&format!("brackets are nested deeper than {MAX_DEPTH} levels")));
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
    Wrong::whole(message).at_bytes(shown).maybe_hint(hint.map(str::to_owned))
}

/// A part of the tree as JSON, without notes; at the top without `$schema`, which is for editors.
fn json(source: Source<'_>, value: &Value<'_>, top: bool) -> Result<Json, Wrong> {
    Ok(match value {
        Value::StringLit(text) => Json::String(text.value.clone().into_owned()),
        Value::BooleanLit(truth) => Json::Bool(truth.value),
        Value::NullKeyword(_) => return Err(Wrong::value(&[], "null is not a value here").hint("leave the key out")),
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
                    let message = format!("key `{}` stands twice: first at line {line}", shortened(name));
                    let second = range_of(&property.name);
                    return Err(Wrong::key(&[name], message).at_bytes(second).hint("keep one of them"));
                }
                let value = json(source, &property.value, false).map_err(|wrong| wrong.inside(&[name]))?;
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
    number.and_then(Number::from_f64).ok_or_else(|| {
        Wrong::value(&[], format!("{} is too large to compute with", shortened(text)))
            .hint("choose units that make it less than 1e100")
    })
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
    pub fn error(text: &str, path: &[&str], message: impl Into<String>, hint: Option<&str>) -> SceneError {
        let wrong = Wrong::value(path, message).maybe_hint(hint.map(str::to_owned));
        Source(text).error(wrong)
    }
}
