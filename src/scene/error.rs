//! Errors of a scene: message, place in the text, hint.

use std::fmt;
use std::ops::Range;

use crate::Problem;

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
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
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
        f.write_str(&self.message)?;
        match &self.hint {
            Some(hint) => write!(f, "; hint: {hint}"),
            None => Ok(()),
        }
    }
}
