//! In: what is wrong in a file, with its JSON path or its range of bytes. Out: the error that a person sees, with its place
//! in the text; how messages show names and numbers, and what they suggest for misspelt names.

pub(super) use crate::text::shown as shortened;

use super::says;
use crate::Problem;
use crate::message::Message;
use jsonc_parser::ast::Value;
use jsonc_parser::common::Ranged;
use jsonc_parser::{CollectOptions, ParseOptions, ParseResult, errors::ParseError, parse_to_ast};
use std::fmt;
use std::ops::Range;

/// The first error of a scene, or of a file that is read as strictly (a drawing style).
///
/// Displayed as `line:column: path: message; hint: what to try`, without the parts that are not known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct SceneError {
    /// The JSON path: `links.4.lengths.GD`, `sliders[0].at`; empty for the scene as a whole.
    pub path: String,
    /// The place in the text; `None` for the text as a whole.
    pub place: Option<Place>,
    /// What is wrong.
    pub message: Message,
    /// What to try.
    pub hint: Option<Message>,
}

/// A place in the scene's text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
    /// The bytes of the text.
    pub span: Range<usize>,
}

impl SceneError {
    /// The error at these bytes of another text.
    #[cfg(feature = "cli")]
    #[must_use]
    pub(crate) fn placed(self, text: &str, span: Range<usize>) -> SceneError {
        let source = Source(text);
        let mark = text.len() - source.body().len();
        let place = (span.start >= mark).then(|| source.place(span.start - mark..span.end - mark));
        SceneError { place, ..self }
    }

    /// What is wrong, and what to try, without the place.
    #[must_use]
    pub fn problem(&self) -> Problem {
        Problem { message: self.message.clone(), hint: self.hint.clone() }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(f, "{}:{}: ", place.line, place.column)?;
        }
        if !self.path.is_empty() {
            write!(f, "{}: ", self.path)?;
        }
        write!(f, "{}", self.message)?;
        match &self.hint {
            Some(hint) => write!(f, "; hint: {hint}"),
            None => Ok(()),
        }
    }
}

/// An error of a file whose place in the text is not found yet.
#[derive(Debug, Clone)]
pub(super) struct Wrong {
    /// The JSON path; if a part may be written in several ways, all its paths, of which the first that the text has
    /// counts.
    pub paths: Vec<Vec<String>>,
    /// Whether the key at the end of the path is meant, and not its value; of an object or a list that is its key, too.
    pub is_key: bool,
    /// The range of bytes, if it is known.
    pub bytes: Option<Range<usize>>,
    /// The message.
    pub message: Message,
    /// What to try.
    pub hint: Option<Message>,
}

impl Wrong {
    /// An error about the text as a whole.
    pub fn whole(message: impl Into<Message>) -> Wrong {
        Wrong { paths: Vec::new(), is_key: false, bytes: None, message: message.into(), hint: None }
    }

    /// An error at the value at `path`.
    pub fn value(path: &[&str], message: impl Into<Message>) -> Wrong {
        Wrong { paths: vec![owned(path)], ..Wrong::whole(message) }
    }

    /// An error at the key at the end of `path`.
    pub fn key(path: &[&str], message: impl Into<Message>) -> Wrong {
        Wrong { is_key: true, ..Wrong::value(path, message) }
    }

    /// Puts the error at these bytes of the text, whatever its path.
    pub fn at_bytes(self, bytes: Range<usize>) -> Wrong {
        Wrong { bytes: Some(bytes), ..self }
    }

    pub fn hint(self, hint: impl Into<Message>) -> Wrong {
        self.maybe_hint(Some(hint.into()))
    }

    pub fn maybe_hint(self, hint: Option<Message>) -> Wrong {
        Wrong { hint, ..self }
    }

    /// Puts the error of a part into the whole: `path` leads to the part.
    pub fn inside(self, path: &[&str]) -> Wrong {
        let paths = self.paths.into_iter().map(|rest| [owned(path), rest].concat()).collect();
        Wrong { paths, ..self }
    }

    /// The error with its first path, where there is no text in which it could be found.
    pub fn without_place(self) -> SceneError {
        let path = self.paths.first().map_or_else(String::new, |path| path.join("."));
        SceneError { path, place: None, message: self.message, hint: self.hint }
    }

    /// Puts the error at the first of these paths that the text has, as a part may be written in several ways.
    pub fn at_first(self, paths: &[&[&str]]) -> Wrong {
        Wrong { paths: paths.iter().map(|path| owned(path)).collect(), ..self }
    }
}

fn owned(path: &[&str]) -> Vec<String> {
    path.iter().map(|&part| part.to_owned()).collect()
}

/// The text of a file, in which the places of errors are found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a>(pub &'a str);

impl<'a> Source<'a> {
    /// The text without a byte order mark, which some editors add. Ranges count in bytes of this text.
    pub fn body(self) -> &'a str {
        self.0.strip_prefix('\u{feff}').unwrap_or(self.0)
    }

    /// The error with its place: that of its path, or of the nearest part around it that the text has.
    pub fn error(self, Wrong { paths, is_key, bytes, message, hint }: Wrong) -> SceneError {
        // An error in a text that is not JSON has no paths.
        let tree = if paths.is_empty() { None } else { parse_tree(self.body()).ok() };
        let root = tree.and_then(|tree| tree.value);
        let walks = paths.iter().filter_map(|path| root.as_ref().map(|root| walk(root, path, is_key)));
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
fn walk(root: &Value<'_>, path: &[String], is_key: bool) -> Walk {
    let (mut shown, mut span, mut node) = (String::new(), value_span(root, None), Some(root));
    for (depth, part) in path.iter().enumerate() {
        let next = if let Some(Value::Array(array)) = node {
            shown += &format!("[{part}]");
            part.parse::<usize>().ok().and_then(|index| array.elements.get(index)).map(|element| (element, None))
        } else {
            let name = if part.is_empty() { "\"\"".into() } else { shortened(part) };
            shown += &if shown.is_empty() { name } else { format!(".{name}") };
            let property = node.and_then(Value::as_object).and_then(|object| object.get(part));
            property.map(|property| (&property.value, Some(range_of(&property.name))))
        };
        node = next.as_ref().map(|(value, _)| *value);
        if let Some((value, key)) = next {
            span = match key {
                Some(key) if is_key && depth + 1 == path.len() => key,
                key => value_span(value, key),
            };
        }
    }
    Walk { shown, span, complete: node.is_some() }
}

/// The bytes of a part of the tree; of a key with its quotes.
pub(crate) fn range_of(part: &impl Ranged) -> Range<usize> {
    part.start()..part.end()
}

/// The range that is shown for a value: the value itself; of an object or a list its key, else its opening bracket.
fn value_span(value: &Value<'_>, key: Option<Range<usize>>) -> Range<usize> {
    match value {
        Value::Object(_) | Value::Array(_) => key.unwrap_or(value.start()..value.start() + 1),
        _ => range_of(value),
    }
}

/// A number as a person would write it, very small and large ones with a power of ten.
pub(super) fn number(value: f64) -> String {
    match value.abs() {
        0.0 | 1e-5..1e16 => value.to_string(),
        _ => format!("{value:e}"),
    }
}

/// Names joined by commas; only the first thirteen: so many keys has a scene.
pub(crate) fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut names = names.into_iter();
    let mut shown = names.by_ref().take(13).map(shortened).collect::<Vec<_>>().join(", ");
    if names.next().is_some() {
        shown.push_str(", …");
    }
    shown
}

/// The most similar name, if at most one letter in three differs or the name only goes on; else `None`.
pub(crate) fn nearest<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    nearest_within(word, names, 3)
}

/// The most similar name, if at most one letter in `letters` differs: names of points are short.
pub(crate) fn nearest_within<'a>(
    word: &str,
    names: impl IntoIterator<Item = &'a str>,
    letters: usize,
) -> Option<&'a str> {
    let word = shortened(&word.to_lowercase());
    let mut best: Option<(usize, &str)> = None;
    // A scene may have a million names; comparing the first thousands is enough for a hint.
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
pub(crate) fn close<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<Message> {
    nearest(word, names).map(says::did_you_mean)
}

/// `did you mean …?` for the nearest name, or else `otherwise` with the list of all.
pub(super) fn suggestion<'a>(
    word: &str,
    names: impl IntoIterator<Item = &'a str> + Clone,
    otherwise: impl Fn(String) -> Message,
) -> Option<Message> {
    close(word, names.clone()).or_else(|| {
        let all = list(names);
        (!all.is_empty()).then(|| otherwise(all))
    })
}
