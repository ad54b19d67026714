//! The text of a scene file, laid out as a person would write it: a link, a slider, a known motion a line.
//!
//! Nothing is checked here: a key given twice or a number that is none stands in the text, where the reader finds it.

use super::words::number;

/// A value of the file.
#[derive(Debug, Clone)]
pub(super) enum Written {
    Number(f64),
    Truth(bool),
    Text(String),
    List(Vec<Written>),
    Object(Object),
}

/// Keys and values in the order in which they were given.
#[derive(Debug, Clone, Default)]
pub(super) struct Object(Vec<(String, Written)>);

impl Object {
    /// One key and its value.
    pub fn of(key: &str, value: impl Into<Written>) -> Object {
        Object(vec![(key.to_owned(), value.into())])
    }

    /// Adds a key and its value.
    pub fn add(&mut self, key: &str, value: impl Into<Written>) {
        self.0.push((key.to_owned(), value.into()));
    }

    /// Adds a key and its value, if there is one.
    pub fn add_some(&mut self, key: &str, value: Option<impl Into<Written>>) {
        if let Some(value) = value {
            self.add(key, value);
        }
    }

    /// Adds a key and these entries under it, if there are any.
    pub fn add_entries(&mut self, key: &str, entries: &Object) {
        if !entries.0.is_empty() {
            self.add(key, entries.clone());
        }
    }

    /// These entries, and then those.
    pub fn and(mut self, more: Object) -> Object {
        self.0.extend(more.0);
        self
    }

    /// The file's text with this at its top.
    pub fn text(&self) -> String {
        written(&Written::Object(self.clone()), 0) + "\n"
    }
}

impl From<f64> for Written {
    fn from(value: f64) -> Self {
        Written::Number(value)
    }
}

impl From<bool> for Written {
    fn from(value: bool) -> Self {
        Written::Truth(value)
    }
}

impl From<&str> for Written {
    fn from(value: &str) -> Self {
        Written::Text(value.to_owned())
    }
}

impl From<[f64; 2]> for Written {
    fn from(value: [f64; 2]) -> Self {
        Written::List(value.map(Written::Number).to_vec())
    }
}

impl From<Object> for Written {
    fn from(value: Object) -> Self {
        Written::Object(value)
    }
}

/// A list of texts.
pub(super) fn texts<'a>(texts: impl IntoIterator<Item = &'a str>) -> Written {
    Written::List(texts.into_iter().map(Written::from).collect())
}

/// The text of a value that stands `depth` levels below the top.
fn written(value: &Written, depth: usize) -> String {
    match value {
        Written::Number(value) => number(*value),
        Written::Truth(value) => value.to_string(),
        Written::Text(value) => quoted(value),
        Written::List(values) => {
            let parts = values.iter().map(|value| written(value, depth + 1));
            match depth == 1 && values.iter().any(is_object) {
                true => in_lines(["[", "]"], parts, depth),
                false => format!("[{}]", joined(parts, ", ")),
            }
        }
        Written::Object(Object(entries)) => {
            let parts = entries.iter().map(|(key, value)| format!("{}: {}", quoted(key), written(value, depth + 1)));
            let long = depth == 1 && entries.iter().any(|(_, value)| is_object(value));
            match depth == 0 || long {
                true => in_lines(["{", "}"], parts, depth),
                false => format!("{{ {} }}", joined(parts, ", ")),
            }
        }
    }
}

fn is_object(value: &Written) -> bool {
    matches!(value, Written::Object(_))
}

/// The parts with a line each.
fn in_lines([open, close]: [&str; 2], parts: impl Iterator<Item = String>, depth: usize) -> String {
    let line = format!("\n{}", "  ".repeat(depth));
    format!("{open}{line}  {}{line}{close}", joined(parts, &format!(",{line}  ")))
}

fn joined(parts: impl Iterator<Item = String>, between: &str) -> String {
    parts.collect::<Vec<_>>().join(between)
}

/// The text in double quotes, with the escapes of JSON.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
