/// Why a mechanism cannot be put together.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AssemblyError {
    /// No real assembly mode exists.
    #[error("links {links} cannot be assembled{at}: {miss}\n  try: another drive angle, or other lengths")]
    NoMode {
        /// The group's links.
        links: String,
        /// The drive angles, in words, as in ` at angle(1) = 150°`.
        at: String,
        /// By how much it fails, in words.
        miss: String,
    },
    /// Lengths whose fourth powers, which closing loops takes, leave the range of f64.
    #[error(
        "lengths of about {size:e} are too {way} to assemble from: their fourth powers leave the range of numbers\n  \
         try: another unit of length"
    )]
    Size {
        /// The largest length.
        size: f64,
        /// Which way, in words.
        way: &'static str,
    },
    /// An assembly mode was asked for by a number that it does not have.
    #[error("there is no assembly mode {mode}: there are {count}\n  try: `kinegon modes` lists them")]
    NoSuchMode {
        /// The number.
        mode: usize,
        /// How many modes there are.
        count: usize,
    },
    /// A search has found no assembly mode of a group of higher class.
    #[error(
        "no way to assemble links {links}{at} was found: {tried}\n  try: rough places of their points in `near`, another drive angle, or \
         other lengths"
    )]
    NotFound {
        /// The group's links.
        links: String,
        /// The drive angles, in words, as in ` at angle(1) = 150°`.
        at: String,
        /// How hard it was tried, in words.
        tried: String,
    },
}
