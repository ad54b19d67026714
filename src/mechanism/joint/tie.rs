//! What a joint says of rotations.

use crate::geometry::Turn;
use crate::mechanism::BodyId;
use smallvec::{SmallVec, smallvec};

/// How a joint ties rotations: the angles of some bodies, each taken as often as its weight says, add up to a constant angle.
///
/// Weights are whole numbers, as those of teeth are: so the sum is the same angle where a body has gone round once more. Together they are zero: bodies that
/// turn as one satisfy every tie.
#[derive(Clone, Debug, PartialEq)]
pub struct Tie {
    /// The bodies and their weights.
    pub turns: SmallVec<[(BodyId, i32); 3]>,
    /// The constant angle. Nothing asks for it in a drawn configuration.
    pub apart: Turn,
}

impl Tie {
    /// The second body turns as the first does; `apart` is its frame seen from that of the first.
    #[must_use]
    pub fn alike([first, second]: [BodyId; 2], apart: Turn) -> Self {
        Self { turns: smallvec![(first, -1), (second, 1)], apart }
    }

    /// The two bodies that turn alike, and the second one's frame seen from that of the first; `None` for any other tie.
    #[must_use]
    pub fn as_alike(&self) -> Option<([BodyId; 2], Turn)> {
        match *self.turns.as_slice() {
            [(first, -1), (second, 1)] => Some(([first, second], self.apart)),
            _ => None,
        }
    }
}
