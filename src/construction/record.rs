//! What the operations written so far have found, and where: nothing is drawn twice, and readings can be added later.

use super::number::NumberId;
use super::operation::{Along, LineId, PlaceId};
use super::run::Values;
use super::step::VectorOf;
use crate::geometry::Ball;
use crate::mechanism::{BodyId, JointId, PointId, SliderId};
use crate::sheet::Sheet;
use indexmap::IndexMap;

/// The results of the operations written so far, by what they are results of.
#[derive(Clone, Debug, Default)]
pub(super) struct Record {
    /// The results, with bounds of their rounding errors.
    pub exact: Values<Ball>,
    /// By place, by line and by number: the index of the operation that makes it.
    pub makers: [Vec<usize>; 3],
    /// By place: its names, as indices of [`Construction::places`](super::Construction).
    pub names: Vec<Vec<usize>>,
    /// The guides on the scheme.
    pub guides: IndexMap<SliderId, LineId>,
    /// The lines through two places, from the first towards the second.
    pub joins: IndexMap<[PlaceId; 2], LineId>,
    /// The distances of joints.
    pub lengths: IndexMap<[PointId; 2], NumberId>,
    /// By place: the lines drawn through it in a direction.
    pub rays: IndexMap<PlaceId, Vec<(Along, LineId)>>,
    /// By plan, body and point: the place of that motion in the plan.
    pub motions: IndexMap<(Sheet, BodyId, PointId), PlaceId>,
    /// By plan and body: the point whose motion was there first, and its place.
    pub first_motions: IndexMap<(Sheet, BodyId), (PointId, PlaceId)>,
    /// The vectors laid off between images of points, by their ends.
    pub laid_off: IndexMap<PlaceId, LaidOff>,
    /// The joint by which the motion of a body follows from a known one.
    pub anchors: IndexMap<BodyId, Anchor>,
}

/// A vector laid off in a plan.
#[derive(Clone, Debug)]
pub(super) struct LaidOff {
    pub start: PlaceId,
    pub end: PlaceId,
    pub of: VectorOf,
}

/// The joint by which the motion of a body follows from that of a neighbour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    /// The joint.
    pub joint: JointId,
    /// The neighbour, whose motion is known.
    pub from: BodyId,
}

impl Record {
    /// How many places, lines and numbers the operations make.
    pub fn counts(&self) -> [usize; 3] {
        self.makers.each_ref().map(Vec::len)
    }

    /// Notes the place of the motion of a body's point in a plan; an earlier one stays.
    pub fn note_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId, place: PlaceId) {
        self.motions.entry((sheet, body, point)).or_insert(place);
        self.first_motions.entry((sheet, body)).or_insert((point, place));
    }
}
