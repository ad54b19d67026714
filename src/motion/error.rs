/// Reasons why the motion at a pose is not defined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// The group is in a singular position.
    #[error("links {links} are in a singular position: {reason} ({})\n  try: {hint}", how_singular(*condition))]
    Singular {
        /// The group's links.
        links: String,
        /// The concurrent or parallel lines, in words.
        reason: String,
        /// Condition number of the loop equations; infinite where a pivot vanishes.
        condition: f64,
        /// A way out, in words.
        hint: String,
    },
    /// A number exceeds the range of f64.
    #[error(
        "links {links}: a distance, a velocity or an acceleration is too large to be represented\n  \
         try: larger units of length, or slower drives"
    )]
    Overflow {
        /// The group's links.
        links: String,
    },
}

/// How nearly singular a group is, in words.
fn how_singular(condition: f64) -> String {
    if condition.is_finite() { format!("condition {condition:.1e}") } else { "exactly".to_owned() }
}
