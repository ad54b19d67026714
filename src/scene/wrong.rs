//! What is wrong with what a file says, by its JSON path; `place.rs` finds the line in the text.

use std::ops::Range;

/// The first thing that is wrong with what a file says.
#[derive(Debug, Clone)]
pub(super) struct Wrong {
    /// Where: the first of these JSON paths that the text has, for a part that may be written in several ways.
    pub paths: Vec<Vec<String>>,
    /// Which part of `"key": value` is meant.
    pub spot: Spot,
    /// The bytes of the text that are meant, where they are known.
    pub bytes: Option<Range<usize>>,
    /// What is wrong.
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
}

/// Which part of `"key": value` an error means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spot {
    /// The key.
    Key,
    /// The value; of a value that holds others, its key.
    Value,
}

impl Wrong {
    /// An error about the text as a whole.
    pub fn whole(message: impl Into<String>) -> Wrong {
        Wrong { paths: Vec::new(), spot: Spot::Value, bytes: None, message: message.into(), hint: None }
    }

    /// An error about these bytes of a text that is no JSON.
    pub fn bytes(bytes: Range<usize>, message: impl Into<String>) -> Wrong {
        Wrong::whole(message).at_bytes(bytes)
    }

    /// An error about the value at `path`.
    pub fn value(path: &[&str], message: impl Into<String>) -> Wrong {
        Wrong { paths: vec![owned(path)], ..Wrong::whole(message) }
    }

    /// An error about the key at the end of `path`.
    pub fn key(path: &[&str], message: impl Into<String>) -> Wrong {
        Wrong { spot: Spot::Key, ..Wrong::value(path, message) }
    }

    /// The same about these bytes of the text.
    pub fn at_bytes(self, bytes: Range<usize>) -> Wrong {
        Wrong { bytes: Some(bytes), ..self }
    }

    /// The same with a hint.
    pub fn hint(self, hint: impl Into<String>) -> Wrong {
        self.maybe_hint(Some(hint.into()))
    }

    /// The same with a hint, if there is one.
    pub fn maybe_hint(self, hint: Option<String>) -> Wrong {
        Wrong { hint, ..self }
    }

    /// The same, where its path begins in the part at `path`.
    pub fn inside(self, path: &[&str]) -> Wrong {
        let paths = self.paths.into_iter().map(|rest| [owned(path), rest].concat()).collect();
        Wrong { paths, ..self }
    }

    /// The same about the first of these paths that the text has.
    pub fn at_first(self, paths: &[&[&str]]) -> Wrong {
        Wrong { paths: paths.iter().map(|path| owned(path)).collect(), ..self }
    }
}

fn owned(path: &[&str]) -> Vec<String> {
    path.iter().map(|&part| part.to_owned()).collect()
}
