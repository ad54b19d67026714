//! True vectors between corners of force polygons: sums of the true forces that lead from one to the other.

use super::bounds::Bounds;
use super::enclosure::Enclosure;
use super::given::Vector;
use crate::construction::{ForceOf, ForcePart, Side};
use crate::geometry::{Number, Pair};
use crate::mechanism::BodyId;
use crate::quantity::{ForceOf as Asked, ForceRead, LinePart, QuantityRequest, Towards, What};

impl Bounds<'_> {
    /// The true vector from one corner to another; `None` where no forces with true values lead there.
    pub(super) fn true_side(&self, e: &Enclosure, [from, to]: [&str; 2]) -> Option<Vector> {
        let plan = self.construction?.forces.as_deref()?;
        let of_side = |side: &Side| self.true_force(e, side.of);
        let way = plan.way(plan.corner(from)?, plan.corner(to)?, |side| of_side(side).is_some())?;
        let sum = way.iter().map(|(side, is_along)| Some((of_side(side)?, *is_along)));
        sum.into_iter().try_fold(Pair::default(), |sum, force| {
            let (force, is_along) = force?;
            Some(if is_along { sum + force } else { sum - force })
        })
    }

    fn true_force(&self, e: &Enclosure, of: ForceOf) -> Option<Vector> {
        let forces = self.forces()?;
        match of {
            ForceOf::Load(index) => forces.acting.get(index).map(|load| load.force),
            ForceOf::Both { .. } => None,
            ForceOf::Joint { joint, on, part: ForcePart::Whole } => {
                let carried = forces.joints.get(joint.0)?.force;
                Some(if self.mechanism.joint(joint).bodies[1] == on { carried } else { -carried })
            }
            ForceOf::Joint { on, .. } => self.true_part_of_force(e, of, on),
        }
    }

    /// A part of a joint's force: its true size along its true line.
    fn true_part_of_force(&self, e: &Enclosure, of: ForceOf, on: BodyId) -> Option<Vector> {
        let name = of.part_name(self.mechanism)?;
        let asked = QuantityRequest::new(&name, self.mechanism).ok()?;
        let What::Force(own, compiled) = &asked.what else { return None };
        let posed = self.loaded(e);
        let ForceRead::Number(size) = own.read(&compiled.mechanism, self.forces()?, &posed, None)? else { return None };
        let (along, receives) = match own {
            Asked::ReactionPart(part, pin, body, towards) => {
                let line = match towards {
                    Towards::Point(other) => e.place(*other) - e.place(*pin),
                    Towards::Guide(slider) => e.guide(*slider).quarter_turn(),
                };
                (if *part == LinePart::Along { line } else { line.quarter_turn() }, *body)
            }
            Asked::Normal(slider) => (e.guide(*slider).quarter_turn(), self.mechanism.slider(*slider).link),
            _ => return None,
        };
        let force = along * (size / along.dot(along).sqrt());
        Some(if receives == on { force } else { -force })
    }
}
