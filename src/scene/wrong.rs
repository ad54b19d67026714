//! Errors of a file by their JSON paths; `place.rs` finds the place in the text.

use std::ops::Range;

/// The first error of a file.
#[derive(Debug, Clone)]
pub(super) struct Wrong {
    /// The JSON path; if a part may be written in several ways, all its paths, of which the first that the text has
    /// counts.
    pub paths: Vec<Vec<String>>,
    /// Whether key or value is meant.
    pub spot: Spot,
    /// The range of bytes, if it is known.
    pub bytes: Option<Range<usize>>,
    /// The message.
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
}

/// The part of `"key": value` that an error means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spot {
    /// The key.
    Key,
    /// The value; of an object or a list its key.
    Value,
}

impl Wrong {
    /// An error about the text as a whole.
    pub fn whole(message: impl Into<String>) -> Wrong {
        Wrong { paths: Vec::new(), spot: Spot::Value, bytes: None, message: message.into(), hint: None }
    }

    /// An error at these bytes of a text that is not JSON.
    pub fn bytes(bytes: Range<usize>, message: impl Into<String>) -> Wrong {
        Wrong::whole(message).at_bytes(bytes)
    }

    /// An error at the value at `path`.
    pub fn value(path: &[&str], message: impl Into<String>) -> Wrong {
        Wrong { paths: vec![owned(path)], ..Wrong::whole(message) }
    }

    /// An error at the key at the end of `path`.
    pub fn key(path: &[&str], message: impl Into<String>) -> Wrong {
        Wrong { spot: Spot::Key, ..Wrong::value(path, message) }
    }

    /// The same error at these bytes of the text.
    pub fn at_bytes(self, bytes: Range<usize>) -> Wrong {
        Wrong { bytes: Some(bytes), ..self }
    }

    /// The same error with a hint.
    pub fn hint(self, hint: impl Into<String>) -> Wrong {
        self.maybe_hint(Some(hint.into()))
    }

    /// The same error with a hint, if there is one.
    pub fn maybe_hint(self, hint: Option<String>) -> Wrong {
        Wrong { hint, ..self }
    }

    /// The same error with `path` before its paths.
    pub fn inside(self, path: &[&str]) -> Wrong {
        let paths = self.paths.into_iter().map(|rest| [owned(path), rest].concat()).collect();
        Wrong { paths, ..self }
    }

    /// The same error at the first of these paths that the text has.
    pub fn at_first(self, paths: &[&[&str]]) -> Wrong {
        Wrong { paths: paths.iter().map(|path| owned(path)).collect(), ..self }
    }
}

fn owned(path: &[&str]) -> Vec<String> {
    path.iter().map(|&part| part.to_owned()).collect()
}
