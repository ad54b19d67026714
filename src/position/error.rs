/// Reasons why a mechanism cannot be assembled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// No real assembly mode exists.
    #[error("links {links} cannot be assembled{at}: {miss}\n  try: another drive angle, or other lengths")]
    NoMode {
        /// The group's links.
        links: String,
        /// The drive angles, in words, as in ` at angle(1) = 150°`.
        at: String,
        /// The distance by which its links fail to meet, in words.
        miss: String,
    },
    /// Lengths too large or too small: closing a loop takes fourth powers, which leave the range of f64.
    #[error(
        "lengths of about {size:e} are too {how} to assemble from: their fourth powers leave the range of numbers\n  \
         try: another unit of length"
    )]
    Size {
        /// The largest length, in the scene's unit.
        size: f64,
        /// `large` or `small`.
        how: &'static str,
    },
    /// There is no assembly mode of this number.
    #[error("there is no assembly mode {mode}: there are {count}\n  try: `kinegon modes` lists them")]
    NoSuchMode {
        /// The number asked for.
        mode: usize,
        /// Number of modes.
        count: usize,
    },
    /// The assembly modes are too many to go through them up to this number.
    #[error(
        "assembly mode {mode} is too far on: counting was stopped after {count}\n  try: rough places in `near`, which choose without counting"
    )]
    TooManyModes {
        /// The number asked for.
        mode: usize,
        /// Number of modes counted.
        count: usize,
    },
    /// No assembly was found among many ways to put the first groups together.
    #[error(
        "no way to assemble all links was found: the first ones can be put together in too many ways\n  try: rough places of their points in `near`"
    )]
    TooMuchWork,
    /// The search has found no assembly mode of a group of higher class.
    #[error(
        "no way to assemble links {links}{at} was found: {tried}\n  try: rough places of their points in `near`, another drive angle, or \
         other lengths"
    )]
    NotFound {
        /// The group's links.
        links: String,
        /// The drive angles, in words, as in ` at angle(1) = 150°`.
        at: String,
        /// The number of starts and the smallest gap, in words.
        tried: String,
    },
}
