use super::given::Vector;
use crate::geometry::{Ball, Pair};

/// A rigid placement with bounds of its errors: rotation, then translation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// Cosine and sine of its angle.
    pub turn: Vector,
    /// The place of its origin.
    pub origin: Vector,
}

impl Frame {
    /// No rotation and no translation.
    pub fn identity() -> Frame {
        Frame { turn: Pair { x: Ball::from(1.0), y: Ball::default() }, origin: Vector::default() }
    }

    /// The placement with rotation `turn` that brings the point `local` to `place`.
    pub fn pinned(turn: Vector, local: Vector, place: Vector) -> Frame {
        Frame { turn, origin: place - turn.turn(local) }
    }

    /// The place of a point.
    pub fn place(&self, local: Vector) -> Vector {
        self.origin + self.turn.turn(local)
    }

    /// `inner`, which is seen from this frame, as seen from outside.
    pub fn of(&self, inner: &Frame) -> Frame {
        Frame { turn: self.turn.turn(inner.turn), origin: self.place(inner.origin) }
    }

    /// The placement that undoes this one.
    pub fn inverse(&self) -> Frame {
        let turn = self.turn.reversed();
        Frame { turn, origin: -turn.turn(self.origin) }
    }
}
