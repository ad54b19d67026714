//! Pins: revolute joints, which follow from points that bodies share.

use super::{Joint, Mark};
use crate::mechanism::{BodyId, Mechanism, PointId};
use smallvec::smallvec;

impl Joint {
    /// A pin at a common point of both bodies.
    #[must_use]
    pub fn pin(point: PointId, bodies: [BodyId; 2]) -> Self {
        let circle = Mark::Circle { center: point, towards: point, part: 0.0 };
        Self { letter: 'R', bodies, pin: Some(point), slider: None, tie: None, marks: smallvec![circle] }
    }
}

/// Adds the pins: for a point of n bodies n − 1 of them, all at the first body of known motion, or else at the first.
pub(in crate::mechanism) fn add_pins(mechanism: &mut Mechanism) {
    for (point, mut bodies) in mechanism.point_ids().zip(mechanism.holders()) {
        bodies.sort_by_key(|&b| !mechanism.is_known(b));
        let Some((&first, others)) = bodies.split_first() else {
            continue;
        };
        mechanism.joints.extend(others.iter().map(|&other| Joint::pin(point, [first, other])));
    }
}
