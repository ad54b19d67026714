//! Ties: the relations between angles of bodies that joints keep.

use crate::geometry::Turn;
use crate::mechanism::BodyId;
use smallvec::{SmallVec, smallvec};

/// A tie of rotations: the angles of some bodies, each times its weight, add up to a constant angle.
///
/// Weights are whole numbers, as numbers of teeth are, so that a full turn of a body does not change the sum as an
/// angle. The sum of the weights is zero, so that bodies that turn as one satisfy every tie.
#[derive(Clone, Debug, PartialEq)]
pub struct Tie {
    /// The bodies and their weights.
    pub turns: SmallVec<[(BodyId, i32); 3]>,
    /// The constant angle; not used in a drawn configuration.
    pub apart: Turn,
}

impl Tie {
    /// The second body turns as the first does; `apart` is the rotation from the frame of the first to that of the
    /// second.
    #[must_use]
    pub fn alike([first, second]: [BodyId; 2], apart: Turn) -> Self {
        Self { turns: smallvec![(first, -1), (second, 1)], apart }
    }

    /// The two bodies that turn alike, and the rotation from the frame of the first to that of the second; `None` for
    /// any other tie.
    #[must_use]
    pub fn as_alike(&self) -> Option<([BodyId; 2], Turn)> {
        match *self.turns.as_slice() {
            [(first, -1), (second, 1)] => Some(([first, second], self.apart)),
            _ => None,
        }
    }
}
