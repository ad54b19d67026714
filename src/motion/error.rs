use crate::Problem;

/// Reasons why the motion at a pose is not defined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum MotionError {
    /// The group is in a singular position.
    Singular {
        /// The group's links.
        links: String,
        /// The concurrent or parallel lines, in words.
        reason: String,
        /// Condition number of the loop equations; infinite where a pivot vanishes.
        condition: f64,
    },
    /// A number exceeds the range of f64.
    Overflow {
        /// The group's links.
        links: String,
    },
}

impl MotionError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            MotionError::Singular { links, reason, condition } => {
                let how = how_singular(*condition);
                Problem::new(format!("links {links} are in a singular position: {reason} ({how})"))
                    .hint("another crank angle, or move one of these joints off the common line or point")
            }
            MotionError::Overflow { links } => Problem::new(format!(
                "links {links}: a distance, a velocity or an acceleration is too large to be represented"
            ))
            .hint("larger units of length, or slower drives"),
        }
    }
}

/// How nearly singular a group is, in words.
fn how_singular(condition: f64) -> String {
    if condition.is_finite() { format!("condition {condition:.1e}") } else { "exactly".to_owned() }
}
