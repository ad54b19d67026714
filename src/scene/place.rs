//! From a JSON path, or a range of bytes, to a place in the text.

use std::ops::Range;

use jsonc_parser::ast::{ObjectProp, Value};
use jsonc_parser::common::Ranged;
use jsonc_parser::{CollectOptions, ParseOptions, ParseResult, errors::ParseError, parse_to_ast};

use super::error::{Place, SceneError};

/// Which part of `"key": value` an error means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spot {
    /// The key.
    Key,
    /// The value; of a value that holds others, its key.
    Value,
}

/// The text of a scene, as the place where errors are made.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a>(pub &'a str);

impl<'a> Source<'a> {
    /// An error about the value at `path`.
    pub fn error(self, path: &[&str], message: impl Into<String>) -> SceneError {
        self.error_with(path, Spot::Value, message.into(), None)
    }

    /// An error about the key at the end of `path`.
    pub fn key_error(self, path: &[&str], message: impl Into<String>) -> SceneError {
        self.error_with(path, Spot::Key, message.into(), None)
    }

    /// An error about a part of `path`, or of the nearest part around it that is there.
    pub fn error_with(self, path: &[&str], spot: Spot, message: String, hint: Option<String>) -> SceneError {
        self.make(&[path], spot, message, hint)
    }

    /// An error about the first of these paths that the scene has: a part may be written in several ways.
    pub fn error_at_first(self, paths: &[&[&str]], message: String, hint: Option<String>) -> SceneError {
        self.make(paths, Spot::Key, message, hint)
    }

    fn make(self, paths: &[&[&str]], spot: Spot, message: String, hint: Option<String>) -> SceneError {
        let (body, offset) = without_mark(self.0);
        let Ok(ParseResult { value: Some(root), .. }) = parse_tree(body) else {
            return SceneError { path: String::new(), place: None, message, hint };
        };
        let walks = paths.iter().map(|path| walk(&root, path, spot));
        let found = walks.clone().find(|walk| walk.complete).or_else(|| walks.clone().next());
        let place = found.as_ref().map(|walk| self.place(walk.span.start + offset..walk.span.end + offset));
        SceneError { path: found.map(|walk| walk.shown).unwrap_or_default(), place, message, hint }
    }

    /// The place of a range of bytes of the text.
    pub fn place(self, span: Range<usize>) -> Place {
        let before = &self.0[..span.start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line_text = before[line_start..].trim_start_matches(MARK);
        Place { line: before.matches('\n').count() + 1, column: line_text.chars().count() + 1, span }
    }
}

impl SceneError {
    /// The same error with a hint.
    pub(super) fn hint(mut self, hint: impl Into<String>) -> SceneError {
        self.hint = Some(hint.into());
        self
    }

    /// The same error with a hint, if there is one.
    pub(super) fn maybe_hint(mut self, hint: Option<String>) -> SceneError {
        self.hint = hint;
        self
    }
}

/// The byte order mark some editors put before the text.
const MARK: char = '\u{feff}';

/// The text without its byte order mark, and the number of bytes taken away.
pub(super) fn without_mark(text: &str) -> (&str, usize) {
    match text.strip_prefix(MARK) {
        Some(body) => (body, MARK.len_utf8()),
        None => (text, 0),
    }
}

/// The tree of the text with its ranges of bytes; nothing beyond JSON is let through that the parser can refuse.
pub(super) fn parse_tree(body: &str) -> Result<ParseResult<'_>, ParseError> {
    let strict = ParseOptions {
        allow_comments: false,
        allow_loose_object_property_names: false,
        allow_trailing_commas: false,
        allow_missing_commas: false,
        allow_single_quoted_strings: false,
        allow_hexadecimal_numbers: false,
        allow_unary_plus_numbers: false,
        allow_bare_decimal_point_numbers: false,
        allow_non_finite_numbers: false,
        allow_extended_string_escapes: false,
    };
    parse_to_ast(body, &CollectOptions::default(), &strict)
}

/// Where a path leads.
struct Walk {
    /// The path as shown in messages.
    shown: String,
    /// The bytes meant.
    span: Range<usize>,
    /// Whether every part of the path is there.
    complete: bool,
}

/// Follows a path as far as it goes.
fn walk(root: &Value<'_>, path: &[&str], spot: Spot) -> Walk {
    let mut shown = String::new();
    let mut node = Some(root);
    let mut span = value_span(root, None);
    for (depth, part) in path.iter().enumerate() {
        let last = depth + 1 == path.len();
        let next = match node {
            Some(Value::Array(array)) => {
                let element = part.parse::<usize>().ok().and_then(|index| array.elements.get(index));
                push_index(&mut shown, part);
                element.map(|element| (element, None))
            }
            Some(Value::Object(object)) => {
                push_key(&mut shown, part);
                let property = object.properties.iter().find(|property| property.name.as_str() == *part);
                property.map(|property| (&property.value, Some(property)))
            }
            _ => {
                push_key(&mut shown, part);
                None
            }
        };
        node = next.map(|(value, _)| value);
        if let Some((value, property)) = next {
            span = match (spot, last, property.map(key_range)) {
                (Spot::Key, true, Some(key)) => key,
                (_, _, key) => value_span(value, key),
            };
        }
    }
    Walk { shown, span, complete: node.is_some() }
}

/// Adds `.key` to a shown path.
pub(super) fn push_key(shown: &mut String, key: &str) {
    if !shown.is_empty() {
        shown.push('.');
    }
    match key {
        "" => shown.push_str("\"\""),
        _ => shown.push_str(&super::words::shortened(key)),
    }
}

/// Adds `[index]` to a shown path.
pub(super) fn push_index(shown: &mut String, index: &str) {
    shown.push('[');
    shown.push_str(index);
    shown.push(']');
}

/// The bytes of a property's key, with its quotes.
pub(super) fn key_range(property: &ObjectProp<'_>) -> Range<usize> {
    range_of(&property.name)
}

/// The bytes of a part of the tree.
pub(super) fn range_of(part: &impl Ranged) -> Range<usize> {
    part.start()..part.end()
}

/// What to point at for a value: itself, or for one that holds others its key, or else its opening bracket.
fn value_span(value: &Value<'_>, key: Option<Range<usize>>) -> Range<usize> {
    match value {
        Value::Object(_) | Value::Array(_) => key.unwrap_or(value.start()..value.start() + 1),
        _ => range_of(value),
    }
}
