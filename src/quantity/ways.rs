//! What lies between two corners of a force polygon as a sum of forces: those that lead from one corner to the other. In another position a
//! polygon may begin with other forces; the sum is there, too.

use super::error::QuantityError;
use super::force_name::{ForceOf, LoadOf};
use super::forces::part_as_vector;
use super::name::{QuantityRequest, What};
use super::says;
use super::value::Snapshot;
use crate::construction::{Corner, ForceOf as Drawn, ForcePart, ForcePlan, Side, force_polygons};
use crate::forces::{Compiled, Counted, Forces, Posed};
use crate::geometry::Pair;
use crate::mechanism::{BodyId, JointId, Mechanism};
use crate::motion::motion;
use crate::position::Pose;
use crate::sheet::Order;
use std::sync::Arc;

/// Two corners of a force polygon.
#[derive(Clone, Debug)]
pub struct Corners {
    /// Their names.
    pub ends: [String; 2],
    /// The forces that lead from one to the other, where they are asked for in many positions.
    pub(super) way: Option<(ForceWay, Arc<Compiled>)>,
}

impl Corners {
    /// Those of these names, in the position in which they are drawn.
    pub(super) fn new(ends: [String; 2]) -> Corners {
        Corners { ends, way: None }
    }

    /// The forces that lead from one to the other: those of every position, else those of this plan.
    pub(crate) fn way(&self, plan: Option<&ForcePlan>, mechanism: &Mechanism) -> Option<ForceWay> {
        if let Some((way, _)) = &self.way {
            return Some(way.clone());
        }
        let [from, to] = self.ends.each_ref().map(|name| plan?.corner(name));
        ForceWay::between(plan?, [from?, to?], mechanism)
    }
}

/// Forces one after another, each with its sense: against it where that is false.
#[derive(Clone, Debug)]
pub(crate) struct ForceWay(Vec<(Stretch, bool)>);

/// A force of a polygon.
#[derive(Clone, Debug)]
enum Stretch {
    /// A load.
    Load(LoadOf),
    /// What a joint does to a body.
    Joint(JointId, BodyId),
    /// A part of what a joint does to the body.
    Part(ForceOf, BodyId),
}

impl ForceWay {
    fn between(plan: &ForcePlan, [from, to]: [&Corner; 2], mechanism: &Mechanism) -> Option<ForceWay> {
        let force = |side: &Side| Stretch::of(side.of, plan, mechanism);
        let way = plan.way(from, to, |side| force(side).is_some())?;
        let way = way.iter().map(|(side, is_along)| Some((force(side)?, *is_along)));
        way.collect::<Option<Vec<_>>>().map(ForceWay)
    }

    /// The sum in a position.
    pub fn read<N: Counted>(
        &self,
        mechanism: &Mechanism,
        forces: &Forces<N>,
        posed: &impl Posed<N>,
    ) -> Option<Pair<N>> {
        let zero = posed.given(0.0);
        self.0.iter().try_fold(Pair { x: zero, y: zero }, |sum, (force, is_along)| {
            let force = force.read(mechanism, forces, posed)?;
            Some(if *is_along { sum + force } else { sum - force })
        })
    }
}

impl Stretch {
    /// `None` of a force without a value of its own.
    fn of(of: Drawn, plan: &ForcePlan, mechanism: &Mechanism) -> Option<Stretch> {
        match of {
            Drawn::Load(index) => {
                plan.loads.get(index).map(|load| Stretch::Load(LoadOf { source: load.source, body: load.body }))
            }
            Drawn::Both { .. } => None,
            Drawn::Joint { joint, on, part: ForcePart::Whole } => Some(Stretch::Joint(joint, on)),
            Drawn::Joint { on, .. } => {
                let asked = QuantityRequest::new(&of.part_name(mechanism)?, mechanism).ok()?;
                match asked.what {
                    What::Force(part, _) => Some(Stretch::Part(part, on)),
                    _ => None,
                }
            }
        }
    }

    fn read<N: Counted>(&self, mechanism: &Mechanism, forces: &Forces<N>, posed: &impl Posed<N>) -> Option<Pair<N>> {
        match self {
            Stretch::Load(load) => Some(forces.load(load.source, load.body)?.force),
            Stretch::Joint(joint, on) => {
                let carried = forces.joints.get(joint.0)?.force;
                Some(if mechanism.joint(*joint).bodies[1] == *on { carried } else { -carried })
            }
            Stretch::Part(part, on) => part_as_vector(part, *on, mechanism, forces, posed),
        }
    }
}

impl QuantityRequest {
    /// The quantity as one of many positions: what lies between corners of polygons, as they are drawn in this one, becomes a sum of forces.
    ///
    /// # Errors
    /// There are no such corners here, or no forces with values of their own lead from one to the other.
    pub(crate) fn for_many(
        self,
        mechanism: &Mechanism,
        pose: impl FnOnce() -> Option<Pose>,
    ) -> Result<Self, QuantityError> {
        let What::Corners(corners) = &self.what else { return Ok(self) };
        if mechanism.loads.is_none() {
            return Err(self.none(says::no_loads()));
        }
        let moved = pose().and_then(|pose| {
            let motion = motion(mechanism, &pose, Order::Acceleration).ok()?;
            Some((force_polygons(mechanism, &pose, &motion)?, pose, motion))
        });
        let (drawn, pose, motion) = moved.ok_or_else(|| self.none(says::no_forces()))?;
        self.value(&Snapshot { pose: &pose, motion: &motion }, Some(&drawn), None)?;
        let way = corners.way(drawn.forces.as_deref(), mechanism).ok_or_else(|| self.none(says::no_way()))?;
        let way = Some((way, Arc::new(Compiled::new(mechanism))));
        let what = What::Corners(Corners { ends: corners.ends.clone(), way });
        Ok(QuantityRequest { what, ..self })
    }
}
