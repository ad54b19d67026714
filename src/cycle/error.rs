use crate::Problem;
use crate::quantity::QuantityError;

/// Why a motion cannot be followed, or a quantity along it not be shown.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum CycleError {
    /// A drawn configuration has one position.
    Drawn,
    /// Mechanisms to be computed side by side are not of one kind.
    NotOfOneKind {
        /// The number of the mechanism that differs, from 0.
        number: usize,
    },
    /// The mechanism has no drive.
    NoDrive,
    /// The drive that was asked for does not exist.
    NoSuchDrive {
        /// The name asked for.
        name: String,
        /// The names of the drives that exist.
        known: String,
    },
    /// The scene's own position is singular, so it does not decide on which branch the motion goes on.
    Singular {
        /// The group's links.
        links: String,
        /// The drive's value, in words.
        at: String,
    },
    /// The range cannot be reached from the scene's position.
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
    Range(Problem),
    /// A hodograph was asked for of a quantity that is no vector.
    NoVector(String),
    /// A path was asked for of what is no point of a moving link.
    NoPath(String),
    /// A quantity that was asked for has no curve.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
}

impl CycleError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            CycleError::Drawn => Problem::new("a drawn configuration cannot be moved: it has no lengths")
                .hint("a scene with `lengths` or `shape` and a drive with its `angle` or `position`"),
            CycleError::NotOfOneKind { number } => Problem::new(format!(
                "mechanism {number} is not of the kind of mechanism 0"
            ))
            .hint("the same links, joints and drives in the same order; only lengths, places and drives may differ"),
            CycleError::NoDrive => Problem::new("there is no drive to move").hint(r#"give a link a "drive""#),
            CycleError::NoSuchDrive { name, known } => {
                Problem::new(format!("there is no drive `{name}`; the drives are: {known}"))
            }
            CycleError::Singular { links, at } => Problem::new(format!(
                "links {links} are in a singular position at {at}, so which way they go on is not decided"
            ))
            .hint("a scene at another position of the drive; the sweep finds its way from there"),
            CycleError::OutOfReach { from, to, stop, low, high } => {
                Problem::new(format!("the range from {from} to {to} cannot be reached: {stop}"))
                    .hint(format!("a range that holds a part of {low} to {high}"))
            }
            CycleError::Range(problem) => problem.clone(),
            CycleError::NoVector(name) => Problem::new(format!("`{name}` is no vector"))
                .hint("v(D), v(D/G), a(D), a_n(D/G), a_t(D/G), a_c(3/2) with names of this scene"),
            CycleError::NoPath(name) => {
                Problem::new(format!("`{name}` is no point of a link that moves, so it has no path"))
            }
            CycleError::Quantity(error) => error.problem(),
        }
    }
}
