//! The two ways to give a mechanism: by lengths, or by a drawing of it.

/// What gives the places of a scene's points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GivenBy {
    /// Ground points, lengths or shapes, and drives with angles: positions have to be found.
    Lengths,
    /// Coordinates of every point: positions are given.
    Drawing,
}

/// Why the drawn form has no room for something, and what it does instead; for hints.
pub(super) const DRAWN: &str = "the drawing, `points`, gives it already";
