//! How the text of a scene is laid out, so that what is added looks like what is there.

use serde_json::Value as Json;
use std::ops::Range;

/// The layout of a text of JSON.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    /// What ends a line.
    pub newline: &'static str,
    /// What stands between a key and its value.
    colon: &'static str,
    /// What stands between two entries on one line.
    pub comma: &'static str,
    /// What stands within the braces of an object on one line.
    pub pad: &'static str,
}

impl Layout {
    /// The layout of that text.
    pub fn of(body: &str) -> Layout {
        let is_dense = !body.contains("\": ") && body.contains("\":");
        Layout {
            newline: if body.contains("\r\n") { "\r\n" } else { "\n" },
            colon: if is_dense { ":" } else { ": " },
            comma: if is_dense { "," } else { ", " },
            pad: if is_dense || (body.contains("{\"") && !body.contains("{ \"")) { "" } else { " " },
        }
    }

    /// A value on one line.
    pub fn one_line(self, value: &Json) -> String {
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
    pub fn entry(self, key: &str, value: &Json) -> String {
        format!("{}{}{}", quoted(key), self.colon, self.one_line(value))
    }
}

/// A text in double quotes, with the escapes of JSON.
pub(super) fn quoted(text: &str) -> String {
    Json::from(text).to_string()
}

/// The spaces before a part of the text that begins its line; `None` if something stands before it there.
pub(super) fn indent<'a>(body: &'a str, part: &Range<usize>) -> Option<&'a str> {
    let start = body[..part.start].rfind('\n')? + 1;
    let before = &body[start..part.start];
    before.chars().all(char::is_whitespace).then_some(before)
}
