use crate::Problem;

/// Reasons why a mechanism cannot be assembled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum AssemblyError {
    /// No real assembly mode exists.
    NoMode {
        /// The group's links.
        links: String,
        /// The drive angles, in words, as in ` at angle(1) = 150°`.
        at: String,
        /// The distance by which its links fail to meet, in words.
        miss: String,
    },
    /// Lengths too large or too small: closing a loop takes fourth powers, which leave the range of f64.
    Size {
        /// The largest length, in the scene's unit.
        size: f64,
        /// `large` or `small`.
        how: &'static str,
    },
    /// There is no assembly mode of this number.
    NoSuchMode {
        /// The number asked for.
        mode: usize,
        /// Number of modes.
        count: usize,
    },
    /// The assembly modes are too many to go through them up to this number.
    TooManyModes {
        /// The number asked for.
        mode: usize,
        /// Number of modes counted.
        count: usize,
    },
    /// No assembly was found among many ways to put the first groups together.
    TooMuchWork,
    /// The search has found no assembly mode of a group of higher class.
    NotFound {
        /// The group's links.
        links: String,
        /// The drive angles, in words, as in ` at angle(1) = 150°`.
        at: String,
        /// The number of starts and the smallest gap, in words.
        tried: String,
    },
}

impl AssemblyError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        let (message, hint) = match self {
            AssemblyError::NoMode { links, at, miss } => {
                (format!("links {links} cannot be assembled{at}: {miss}"), "another drive angle, or other lengths")
            }
            AssemblyError::Size { size, how } => (
                format!(
                    "lengths of about {size:e} are too {how} to assemble from: their fourth powers leave the range of numbers"
                ),
                "another unit of length",
            ),
            AssemblyError::NoSuchMode { mode, count } => {
                (format!("there is no assembly mode {mode}: there are {count}"), "`kinegon modes` lists them")
            }
            AssemblyError::TooManyModes { mode, count } => (
                format!("assembly mode {mode} is too far on: counting was stopped after {count}"),
                "rough places in `near`, which choose without counting",
            ),
            AssemblyError::TooMuchWork => (
                "no way to assemble all links was found: the first ones can be put together in too many ways"
                    .to_owned(),
                "rough places of their points in `near`",
            ),
            AssemblyError::NotFound { links, at, tried } => (
                format!("no way to assemble links {links}{at} was found: {tried}"),
                "rough places of their points in `near`, another drive angle, or other lengths",
            ),
        };
        Problem::new(message).hint(hint)
    }
}
