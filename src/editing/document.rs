//! The text of a scene that is changed value by value; all that is not changed stays as it is, to the byte.

use jsonc_parser::ast::{Object, Value};
use serde_json::Value as Json;
use std::ops::Range;

use super::says;
use crate::message::Message;
use crate::scene::{JointKind, SceneError, SceneTree, key_order, quoted, range_of};

/// A text in the course of changes. Paths are JSON paths; an index of a list is written in digits.
#[derive(Clone, Debug)]
pub(super) struct Document<'a> {
    /// The text that was handed over, for the places of errors.
    given: &'a str,
    /// The text as it is now, without a byte order mark.
    body: String,
}

impl<'a> Document<'a> {
    /// The document of a text.
    ///
    /// # Errors
    /// The text is not JSON, or not an object.
    pub fn new(given: &'a str) -> Result<Self, SceneError> {
        let tree = SceneTree::read(given)?;
        match tree.root {
            Value::Object(_) => Ok(Document { given, body: tree.body.to_owned() }),
            _ => Err(SceneTree::error(given, &[], says::no_object(), None)),
        }
    }

    /// The text as it is now, with the byte order mark that it had.
    pub fn text(&self) -> String {
        let mark = if self.given.starts_with('\u{feff}') { "\u{feff}" } else { "" };
        format!("{mark}{}", self.body)
    }

    /// The text as JSON; of a key that stands twice the last value.
    pub fn json(&self) -> Json {
        self.tree().map_or(Json::Null, |tree| value_of(&tree.root))
    }

    /// An error at a path of the text that was handed over.
    pub fn error(&self, path: &[&str], message: Message, hint: Option<Message>) -> SceneError {
        SceneTree::error(self.given, path, message, hint)
    }

    fn tree(&self) -> Result<SceneTree<'_>, SceneError> {
        SceneTree::read(&self.body)
    }

    /// Puts values in place of numbers and lists of numbers that are there, all at once; what is not there is added.
    pub fn set_all(&mut self, values: &[(Vec<String>, Json)]) -> Result<(), SceneError> {
        let tree = self.tree()?;
        let layout = Layout::of(tree.body);
        let mut splices = Vec::new();
        let mut others = Vec::new();
        for (path, value) in values {
            let path: Vec<&str> = path.iter().map(String::as_str).collect();
            let node = find(&tree.root, &path);
            if !node.is_some_and(|node| replaced(node, value, layout, &mut splices)) {
                others.push((path, value));
            }
        }
        self.body = spliced(&self.body, splices);
        others.into_iter().try_for_each(|(path, value)| self.set(&path, value))
    }

    /// Puts values in place of whole values that are there, all at once: the bytes of each before and after, in the order of the text and with
    /// its byte order mark.
    pub fn put_all(&mut self, values: &[(Vec<String>, Json)]) -> Vec<[Range<usize>; 2]> {
        let mut splices = Vec::new();
        if let Ok(tree) = self.tree() {
            let layout = Layout::of(tree.body);
            for (path, value) in values {
                let path: Vec<&str> = path.iter().map(String::as_str).collect();
                splices.extend(find(&tree.root, &path).map(|node| (range_of(node), layout.one_line(value))));
            }
        }
        splices.sort_by_key(|(range, _)| range.start);
        // How far the text before has become longer; a mark stands before both texts.
        let mark = self.given.len() - self.given.trim_start_matches('\u{feff}').len();
        let mut longer = 0_isize;
        let put = splices.iter().map(|(before, text)| {
            let start = before.start.saturating_add_signed(longer);
            longer += text.len() as isize - before.len() as isize;
            [before.clone(), start..start + text.len()].map(|range| range.start + mark..range.end + mark)
        });
        let put = put.collect();
        self.body = spliced(&self.body, splices);
        put
    }

    /// Puts a value at a path, in place of what is there; parts of an object or a list that do not change stay as they
    /// are, and notes stay. `null` removes.
    pub fn set(&mut self, path: &[&str], value: &Json) -> Result<(), SceneError> {
        if value.is_null() {
            return self.remove(path);
        }
        let tree = self.tree()?;
        let Some(node) = find(&tree.root, path) else {
            return self.insert(path, value);
        };
        match (node, value) {
            (Value::Object(object), Json::Object(entries)) => {
                let names = object.properties.iter().map(|property| property.name.as_str().to_owned());
                let gone = names.filter(|name| name != "note" && !entries.contains_key(name)).collect::<Vec<_>>();
                gone.iter().try_for_each(|name| self.remove(&[path, &[name]].concat()))?;
                entries.iter().try_for_each(|(name, value)| self.set(&[path, &[name]].concat(), value))
            }
            (Value::Array(array), Json::Array(elements)) => {
                let gone = (elements.len()..array.elements.len()).rev().map(|index| index.to_string());
                let gone = gone.collect::<Vec<_>>();
                gone.iter().try_for_each(|index| self.remove(&[path, &[index]].concat()))?;
                let mut elements = elements.iter().enumerate();
                elements.try_for_each(|(index, value)| self.set(&[path, &[&index.to_string()]].concat(), value))
            }
            _ if path.is_empty() => Err(self.error(&[], says::no_object(), None)),
            _ if same(node, value) => Ok(()),
            _ => {
                let splice = (range_of(node), Layout::of(tree.body).one_line(value));
                self.splice(splice);
                Ok(())
            }
        }
    }

    /// Adds a value where the text has only the first parts of its path.
    fn insert(&mut self, path: &[&str], value: &Json) -> Result<(), SceneError> {
        let tree = self.tree()?;
        let layout = Layout::of(tree.body);
        let is_there = |known: &usize| find(&tree.root, &path[..*known]).is_some();
        let known = (0..path.len()).rev().find(is_there).unwrap_or(0);
        let (around, key, rest) = (&path[..known], path[known], &path[known + 1..]);
        let nested = rest
            .iter()
            .rev()
            .fold(value.clone(), |inner, key| Json::Object(std::iter::once(((*key).to_owned(), inner)).collect()));
        let node = find(&tree.root, around);
        let (text, index) = match node {
            Some(Value::Object(object)) => (layout.entry(key, &nested), place(object, key, around)),
            Some(Value::Array(array)) if key.parse() == Ok(array.elements.len()) => {
                (layout.one_line(&nested), array.elements.len())
            }
            Some(Value::Array(array)) => {
                return Err(self.error(around, says::no_entry(array.elements.len(), shown(key)), None));
            }
            _ => return Err(self.error(around, says::no_room(shown(key)), None)),
        };
        let splice = node.map(|node| added(&tree, layout, node, index, &text, around));
        splice.into_iter().for_each(|splice| self.splice(splice));
        Ok(())
    }

    /// Removes what is at a path, if something is.
    pub fn remove(&mut self, path: &[&str]) -> Result<(), SceneError> {
        let Some((last, around)) = path.split_last() else {
            return Err(self.error(&[], says::not_all(), None));
        };
        let tree = self.tree()?;
        let cut = find(&tree.root, around).and_then(|node| {
            let index = match node {
                Value::Object(object) => object.properties.iter().position(|property| property.name.as_str() == *last),
                Value::Array(array) => last.parse().ok().filter(|index| *index < array.elements.len()),
                _ => None,
            };
            index.map(|index| cut(&tree, node, index))
        });
        if let Some(cut) = cut {
            self.splice((cut, String::new()));
        }
        Ok(())
    }

    /// Gives keys and texts other words, but for notes; `None` where the old one stays.
    pub fn reword(&mut self, rename: Rename<'_>) -> Result<(), SceneError> {
        let mut splices = Vec::new();
        reworded(&self.tree()?.root, &mut Vec::new(), rename, &mut splices);
        self.body = spliced(&self.body, splices);
        Ok(())
    }

    fn splice(&mut self, (range, text): Splice) {
        self.body.replace_range(range, &text);
    }
}

/// Gives a word its new form.
type Rename<'r> = &'r dyn Fn(Word<'_>) -> Option<String>;

/// Bytes of the text, and what comes in their place.
type Splice = (Range<usize>, String);

fn spliced(body: &str, mut splices: Vec<Splice>) -> String {
    splices.sort_by_key(|(range, _)| range.start);
    let mut text = String::with_capacity(body.len() + 64);
    let mut end = 0;
    for (range, new) in splices.into_iter() {
        // The same value set twice would overlap; the first counts.
        if range.start >= end {
            text.push_str(&body[end..range.start]);
            text.push_str(&new);
            end = range.end;
        }
    }
    text + &body[end..]
}

fn shown(key: &str) -> String {
    format!("`{}`", crate::text::shown(key))
}

/// The value at a path.
fn find<'t, 'a>(root: &'t Value<'a>, path: &[&str]) -> Option<&'t Value<'a>> {
    path.iter().try_fold(root, |node, key| match node {
        Value::Object(object) => object.get(key).map(|property| &property.value),
        Value::Array(array) => array.elements.get(key.parse::<usize>().ok()?),
        _ => None,
    })
}

/// A part of the tree as JSON. Numbers are read to the last bit, which serde_json does not do.
fn value_of(node: &Value<'_>) -> Json {
    match node {
        Value::StringLit(text) => Json::from(text.value.as_ref()),
        Value::NumberLit(number) => match number.value.parse::<i64>() {
            Ok(whole) => Json::from(whole),
            Err(_) => Json::from(number.value.parse::<f64>().unwrap_or(0.0)),
        },
        Value::BooleanLit(truth) => Json::from(truth.value),
        Value::NullKeyword(_) => Json::Null,
        Value::Array(array) => array.elements.iter().map(value_of).collect(),
        Value::Object(object) => {
            let entries = object.properties.iter();
            entries.map(|property| (property.name.as_str().to_owned(), value_of(&property.value))).collect()
        }
    }
}

/// Whether a part of the text says this.
fn same(node: &Value<'_>, value: &Json) -> bool {
    let own = value_of(node);
    own == *value || own.as_f64().is_some_and(|number| value.as_f64() == Some(number))
}

/// Puts a number or a list of numbers in place of one that is there; false where something else is there.
fn replaced(node: &Value<'_>, value: &Json, layout: Layout, splices: &mut Vec<Splice>) -> bool {
    match (node, value) {
        (Value::NumberLit(number), Json::Number(_)) => {
            if !same(node, value) {
                splices.push((range_of(number), layout.one_line(value)));
            }
            true
        }
        (Value::Array(array), Json::Array(values)) if array.elements.len() == values.len() => {
            let mut pairs = array.elements.iter().zip(values);
            let are_numbers =
                |(node, value): (&Value<'_>, &Json)| matches!(node, Value::NumberLit(_)) && value.is_number();
            let is_plain = pairs.clone().all(are_numbers);
            is_plain && pairs.all(|(node, value)| replaced(node, value, layout, splices))
        }
        _ => false,
    }
}

/// The bytes of each property of an object, or of each element of a list.
fn parts(node: &Value<'_>) -> Vec<Range<usize>> {
    match node {
        Value::Object(object) => object.properties.iter().map(range_of).collect(),
        Value::Array(array) => array.elements.iter().map(range_of).collect(),
        _ => Vec::new(),
    }
}

/// Where a new key belongs: behind those that people write before it, else before those that they write after it, else
/// last, but before a note.
fn place(object: &Object<'_>, key: &str, path: &[&str]) -> usize {
    let order = key_order(path);
    let rank = |name: &str| order.iter().position(|known| *known == name);
    let names: Vec<&str> = object.properties.iter().map(|property| property.name.as_str()).collect();
    let before = rank(key).and_then(|own| names.iter().rposition(|name| rank(name).is_some_and(|rank| rank < own)));
    let after = rank(key).and_then(|own| names.iter().position(|name| rank(name).is_some_and(|rank| rank > own)));
    let last = names.len() - usize::from(names.last() == Some(&"note"));
    before.map(|index| index + 1).or(after).unwrap_or(last)
}

/// Adds a part to an object or a list, as the part of that index.
fn added(tree: &SceneTree<'_>, layout: Layout, node: &Value<'_>, index: usize, text: &str, path: &[&str]) -> Splice {
    let (body, parts) = (tree.body, parts(node));
    let line = |indent: &str| format!("{}{indent}", layout.newline);
    let (before, after) = (index.checked_sub(1).map(|before| &parts[before]), parts.get(index));
    match (before, after) {
        (Some(before), after) => {
            let is_inline = after.is_some_and(|after| indent(body, after).is_none());
            let gap = match indent(body, before).filter(|_| !is_inline) {
                Some(indent) => format!(",{}", line(indent)),
                None => {
                    // As between the two parts before, unless more than a comma and spaces stands there.
                    let last = index.checked_sub(2).map(|last| &body[parts[last].end..before.start]);
                    last.filter(|gap| gap.chars().all(|c| c == ' ' || c == ',')).unwrap_or(layout.comma).to_owned()
                }
            };
            (before.end..before.end, gap + text)
        }
        (None, Some(after)) => {
            let gap = match indent(body, after) {
                Some(indent) => format!(",{}", line(indent)),
                None => layout.comma.to_owned(),
            };
            (after.start..after.start, text.to_owned() + &gap)
        }
        (None, None) => {
            let has_lines = |key: &str| matches!(key, "links" | "known") || JointKind::of_list(key).is_some();
            let first = tree.root.as_object().and_then(|object| object.properties.first());
            let top = first.and_then(|first| indent(body, &range_of(first)));
            let top = top.filter(|_| path.len() == 1 && has_lines(path[0]));
            let (open, close) = if node.as_array().is_some() { ("[", "]") } else { ("{", "}") };
            let inside = match (top, open) {
                (Some(indent), _) => format!("{}{text}{}", line(&indent.repeat(2)), line(indent)),
                (None, "[") => text.to_owned(),
                (None, _) => format!("{pad}{text}{pad}", pad = layout.pad),
            };
            (range_of(node), format!("{open}{inside}{close}"))
        }
    }
}

/// The bytes that go with a part of an object or a list.
fn cut(tree: &SceneTree<'_>, node: &Value<'_>, index: usize) -> Range<usize> {
    let parts = parts(node);
    let this = &parts[index];
    let (before, after) = (index.checked_sub(1).map(|before| &parts[before]), parts.get(index + 1));
    let starts_line = |part: &Range<usize>| indent(tree.body, part).is_some();
    match (before, after) {
        (None, None) => range_of(node).start + 1..range_of(node).end - 1,
        (None, Some(after)) => this.start..after.start,
        (Some(_), Some(after)) if starts_line(this) && !starts_line(after) => this.start..after.start,
        (Some(before), _) => before.end..this.end,
    }
}

/// A key or a text of the scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'w> {
    /// Where it stands: the path of its value, or of the object whose key it is.
    pub path: &'w [String],
    /// Whether it is a key.
    pub is_key: bool,
    /// What it says.
    pub word: &'w str,
}

fn reworded(node: &Value<'_>, path: &mut Vec<String>, rename: Rename<'_>, splices: &mut Vec<Splice>) {
    match node {
        Value::StringLit(text) => {
            let new = rename(Word { path, is_key: false, word: &text.value });
            splices.extend(new.map(|word| (range_of(text), quoted(&word))));
        }
        Value::Object(object) => {
            for property in object.properties.iter().filter(|property| property.name.as_str() != "note") {
                let name = property.name.as_str();
                let new = rename(Word { path, is_key: true, word: name });
                splices.extend(new.map(|word| (range_of(&property.name), quoted(&word))));
                path.push(name.to_owned());
                reworded(&property.value, path, rename, splices);
                path.pop();
            }
        }
        Value::Array(array) => {
            for (index, element) in array.elements.iter().enumerate() {
                path.push(index.to_string());
                reworded(element, path, rename, splices);
                path.pop();
            }
        }
        _ => {}
    }
}

/// How the text of a scene is laid out, so that what is added looks like what is there.
#[derive(Clone, Copy, Debug)]
struct Layout {
    /// What ends a line.
    newline: &'static str,
    /// What stands between a key and its value.
    colon: &'static str,
    /// What stands between two entries on one line.
    comma: &'static str,
    /// What stands within the braces of an object on one line.
    pad: &'static str,
}

impl Layout {
    /// The layout of that text.
    fn of(body: &str) -> Layout {
        let is_dense = !body.contains("\": ") && body.contains("\":");
        Layout {
            newline: if body.contains("\r\n") { "\r\n" } else { "\n" },
            colon: if is_dense { ":" } else { ": " },
            comma: if is_dense { "," } else { ", " },
            pad: if is_dense || (body.contains("{\"") && !body.contains("{ \"")) { "" } else { " " },
        }
    }

    /// A value on one line.
    fn one_line(self, value: &Json) -> String {
        match value {
            Json::Array(elements) => {
                let elements: Vec<String> = elements.iter().map(|element| self.one_line(element)).collect();
                format!("[{}]", elements.join(self.comma))
            }
            Json::Object(entries) if entries.is_empty() => "{}".to_owned(),
            Json::Object(entries) => {
                let entries: Vec<String> = entries.iter().map(|(key, value)| self.entry(key, value)).collect();
                format!("{{{pad}{}{pad}}}", entries.join(self.comma), pad = self.pad)
            }
            _ => value.to_string(),
        }
    }

    /// A key with its value on one line.
    fn entry(self, key: &str, value: &Json) -> String {
        format!("{}{}{}", quoted(key), self.colon, self.one_line(value))
    }
}

/// The spaces before a part of the text that begins its line; `None` if something stands before it there.
fn indent<'a>(body: &'a str, part: &Range<usize>) -> Option<&'a str> {
    let start = body[..part.start].rfind('\n')? + 1;
    let before = &body[start..part.start];
    before.chars().all(char::is_whitespace).then_some(before)
}
