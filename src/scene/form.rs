//! The two ways to give a mechanism.

/// The two ways to give a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Ground points, lengths or shapes, and drives with angles: positions have to be found.
    Lengths,
    /// Coordinates of every point: positions are given.
    Drawn,
}

/// Why the drawn form has no room for something, and what it does instead; for hints.
pub(super) const DRAWN: &str = "the drawing, `points`, gives it already";
