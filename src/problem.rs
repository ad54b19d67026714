use crate::message::Message;
use std::fmt;

/// What is wrong, and what to try: the parts of every error, so that nobody who shows one has to find them in a text.
///
/// Displayed as the message, and the hint on a second line after `try:`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// What is wrong.
    pub message: Message,
    /// What to try, where something is known to help.
    pub hint: Option<Message>,
}

impl Problem {
    /// A problem with this message and no hint.
    #[must_use]
    pub fn new(message: impl Into<Message>) -> Problem {
        Problem { message: message.into(), hint: None }
    }

    /// The problem with what to try.
    #[must_use]
    pub fn hint(self, hint: impl Into<Message>) -> Problem {
        Problem { hint: Some(hint.into()), ..self }
    }
}

impl<T: Into<Message>> From<T> for Problem {
    fn from(message: T) -> Problem {
        Problem::new(message)
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        self.hint.iter().try_for_each(|hint| write!(f, "\n  try: {hint}"))
    }
}
