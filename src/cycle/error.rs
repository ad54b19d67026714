/// Why a motion cannot be followed, or a quantity along it not be shown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CycleError {
    /// A drawn configuration has one position.
    #[error(
        "a drawn configuration cannot be moved: it has no lengths\n  \
         try: a scene with `lengths` or `shape` and a drive with its `angle` or `position`"
    )]
    Drawn,
    /// Mechanisms to be computed side by side are not of one kind.
    #[error(
        "mechanism {number} is not of the kind of mechanism 0\n  \
         try: the same links, joints and drives in the same order; only lengths, places and drives may differ"
    )]
    NotOfOneKind {
        /// The number of the mechanism that differs, from 0.
        number: usize,
    },
    /// The mechanism has no drive.
    #[error("there is no drive to move\n  try: give a link a \"drive\"")]
    NoDrive,
    /// The drive that was asked for does not exist.
    #[error("there is no drive `{name}`; the drives are: {known}")]
    NoSuchDrive {
        /// The name asked for.
        name: String,
        /// The names of the drives that exist.
        known: String,
    },
    /// The scene's own position is singular, so it does not decide on which branch the motion goes on.
    #[error(
        "links {links} are in a singular position at {at}, so which way they go on is not decided\n  \
         try: a scene at another position of the drive; the sweep finds its way from there"
    )]
    Singular {
        /// The group's links.
        links: String,
        /// The drive's value, in words.
        at: String,
    },
    /// The range cannot be reached from the scene's position.
    #[error(
        "the range from {from} to {to} cannot be reached: {stop}\n  \
         try: a range that holds a part of {low} to {high}"
    )]
    OutOfReach {
        /// Where the range begins.
        from: String,
        /// Where it ends.
        to: String,
        /// The event that ends the path before the range, in words.
        stop: String,
        /// The lowest reachable value found.
        low: String,
        /// The highest reachable value found.
        high: String,
    },
    /// A range, step or count without meaning.
    #[error("{0}")]
    Range(String),
    /// A hodograph was asked for of a quantity that is no vector.
    #[error("`{0}` is no vector\n  try: v(D), v(D/G), a(D), a_n(D/G), a_t(D/G), a_c(3/2) with names of this scene")]
    NoVector(String),
    /// A path was asked for of what is no point of a moving link.
    #[error("`{0}` is no point of a link that moves, so it has no path")]
    NoPath(String),
    /// A quantity that was asked for has no curve.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
}
use crate::quantity::QuantityError;
