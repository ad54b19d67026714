//! The two ways to give the positions of a mechanism: by lengths, or by a drawing.

/// How a scene gives the places of its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GivenBy {
    /// By ground points, lengths or shapes, and angles of drives: positions have to be found.
    Lengths,
    /// By the coordinates of every point, as drawn.
    Drawing,
}

/// End of hints: why a drawn configuration refuses a key.
pub(super) const DRAWN: &str = "the drawing, `points`, gives it already";
