//! In: an error with its JSON path or its range of bytes. Out: its place in the text.

use std::ops::Range;

use jsonc_parser::ast::{ObjectProp, Value};
use jsonc_parser::common::Ranged;
use jsonc_parser::{CollectOptions, ParseOptions, ParseResult, errors::ParseError, parse_to_ast};

use super::error::{Place, SceneError};
use super::words::shortened;
use super::wrong::{Spot, Wrong};

/// The text of a file, in which the places of errors are found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a>(pub &'a str);

impl<'a> Source<'a> {
    /// The text without a byte order mark, which some editors add. Ranges count in bytes of this text.
    pub fn body(self) -> &'a str {
        self.0.strip_prefix('\u{feff}').unwrap_or(self.0)
    }

    /// The error with its place: that of its path, or of the nearest part around it that the text has.
    pub fn error(self, Wrong { paths, spot, bytes, message, hint }: Wrong) -> SceneError {
        // An error in a text that is not JSON has no paths.
        let tree = if paths.is_empty() { None } else { parse_tree(self.body()).ok() };
        let root = tree.and_then(|tree| tree.value);
        let walks = paths.iter().filter_map(|path| root.as_ref().map(|root| walk(root, path, spot)));
        let found = walks.clone().find(|walk| walk.complete).or_else(|| walks.clone().next());
        let (path, span) = found.map_or_else(Default::default, |walk| (walk.shown, Some(walk.span)));
        SceneError { path, place: bytes.or(span).map(|span| self.place(span)), message, hint }
    }

    /// The place of a range of bytes.
    pub fn place(self, span: Range<usize>) -> Place {
        let before = &self.body()[..span.start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let mark = self.0.len() - self.body().len();
        Place {
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            span: span.start + mark..span.end + mark,
        }
    }
}

/// The JSON tree of the text with its ranges of bytes; every extension of JSON that the parser can refuse is refused.
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

/// The part of the text to which a path leads.
struct Walk {
    /// The path as it is shown in messages.
    shown: String,
    /// Its range of bytes.
    span: Range<usize>,
    /// Whether the text has every part of the path.
    complete: bool,
}

/// Follows a path as far as the text has it.
fn walk(root: &Value<'_>, path: &[String], spot: Spot) -> Walk {
    let (mut shown, mut span, mut node) = (String::new(), value_span(root, None), Some(root));
    for (depth, part) in path.iter().enumerate() {
        let next = if let Some(Value::Array(array)) = node {
            shown += &format!("[{part}]");
            part.parse::<usize>().ok().and_then(|index| array.elements.get(index)).map(|element| (element, None))
        } else {
            let name = if part.is_empty() { "\"\"".into() } else { shortened(part) };
            shown += &if shown.is_empty() { name } else { format!(".{name}") };
            let property = node.and_then(Value::as_object).and_then(|object| object.get(part));
            property.map(|property| (&property.value, Some(key_range(property))))
        };
        node = next.as_ref().map(|(value, _)| *value);
        if let Some((value, key)) = next {
            span = match key {
                Some(key) if spot == Spot::Key && depth + 1 == path.len() => key,
                key => value_span(value, key),
            };
        }
    }
    Walk { shown, span, complete: node.is_some() }
}

/// The bytes of a property's key, with its quotes.
pub(super) fn key_range(property: &ObjectProp<'_>) -> Range<usize> {
    range_of(&property.name)
}

/// The bytes of a part of the tree.
pub(super) fn range_of(part: &impl Ranged) -> Range<usize> {
    part.start()..part.end()
}

/// The range that is shown for a value: the value itself; of an object or a list its key, else its opening bracket.
fn value_span(value: &Value<'_>, key: Option<Range<usize>>) -> Range<usize> {
    match value {
        Value::Object(_) | Value::Array(_) => key.unwrap_or(value.start()..value.start() + 1),
        _ => range_of(value),
    }
}
