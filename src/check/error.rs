use crate::text::shown;

/// Why values cannot be checked: what, and what to try.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}{message}")]
#[non_exhaustive]
pub struct CheckError {
    /// The place in the file, followed by a colon; may be empty.
    pub place: String,
    /// What is wrong.
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
}

impl CheckError {
    /// An error about the form as a whole.
    pub(super) fn new(message: impl Into<String>, hint: impl Into<String>) -> CheckError {
        CheckError { place: String::new(), message: message.into(), hint: Some(hint.into()) }
    }

    /// An error about something that somebody wrote, which begins the message.
    pub(super) fn about(written: &str, says: &str, hint: impl Into<String>) -> CheckError {
        CheckError::new(format!("`{}` {says}", shown(written)), hint)
    }

    /// All errors of a form in one: each with its place, and what to try; `None` where there are none.
    pub(super) fn all(mut errors: Vec<CheckError>) -> Option<CheckError> {
        if errors.len() < 2 {
            return errors.pop();
        }
        let lines = errors.iter().map(|error| match &error.hint {
            Some(hint) => format!("\n  {error}: {hint}"),
            None => format!("\n  {error}"),
        });
        let message = format!("{} things in this form are not understood:{}", errors.len(), lines.collect::<String>());
        Some(CheckError { place: String::new(), message, hint: None })
    }

    /// The error with its place in the file.
    pub(super) fn at(mut self, place: &str) -> CheckError {
        self.place = format!("{place}: ");
        self
    }
}
