//! Groups of class IV: a drag link, cut free, has three unknown forces left, along the line of both outer joints and the lines of both
//! closure links; Ritter's moment about the crossing of two of them tells the third.

use super::leg::Leg;
use super::statics::Statics;
use crate::mechanism::{BodyId, Group, JointId};

impl Statics<'_, '_> {
    /// Finds what the joints of a group of class IV carry. Its joints are called as in the source paper: B and E hold the drag links 2 and 4,
    /// closure link 3 has C and D, closure link 5 has G and F.
    pub fn fourth(&mut self, group: &Group) -> Option<()> {
        let [first, second] = group.loops.as_slice() else { return None };
        let &[joint_b, joint_c, joint_d, joint_e] = first.joints.as_slice() else { return None };
        let &[_, joint_g, joint_f, _] = second.joints.as_slice() else { return None };
        let compound = |lead: &BodyId| self.mechanism().compound(*lead);
        let [drag, closure, other] = [1, 2, 3].map(|index| first.bodies.get(index).map(compound));
        let (drag, closure, other) = (drag?, closure?, other?);
        let second_closure = compound(second.bodies.get(2)?);
        // Either end of the second closure link may stand first.
        let is_on_drag = |joint: JointId| self.mechanism().joint(joint).bodies.iter().any(|body| drag.contains(body));
        let (joint_g, joint_f) = if is_on_drag(joint_g) { (joint_g, joint_f) } else { (joint_f, joint_g) };
        let joints = [joint_b, joint_c, joint_g];
        let legs: [Leg; 3] = [
            self.leg(joint_b, joint_e, &group.bodies)?,
            self.leg(joint_c, joint_d, &closure)?.reversed(self),
            self.leg(joint_g, joint_f, &second_closure)?.reversed(self),
        ];
        let [a, k, b] = self.steepest([&legs[0], &legs[1], &legs[2]]);
        let own =
            self.set(&drag).with(legs.iter().filter_map(|leg| leg.across), legs.iter().filter_map(|leg| leg.couple));
        let rest = self.rest_by_moments(&drag, own, [&legs[a], &legs[b]], &legs[k])?;
        let mut chain = self.chain(&drag);
        let polygon = chain.polygon;
        self.lay_off_all(&mut chain, legs[a].across.iter());
        self.lay_off_loads(&mut chain, &drag);
        let reaction_k = chain.end;
        self.lay_off_all(&mut chain, legs[k].across.iter().chain(&rest));
        let reaction_b = chain.end;
        self.lay_off_all(&mut chain, legs[b].across.iter());
        let (_, corner) = self.close_by_two(&chain, [legs[a].unknown()?, legs[b].unknown()?])?;
        let end = self.end_of_first(&legs[a], polygon, chain.start);
        self.join(polygon, joints[a], legs[a].on, [corner, end]);
        self.join(polygon, joints[k], legs[k].on, [reaction_k, reaction_b]);
        self.join(polygon, joints[b], legs[b].on, [reaction_b, corner]);
        self.last_of(&closure, &[joint_c], joint_d)?;
        self.last_of(&second_closure, &[joint_g], joint_f)?;
        self.last_of(&other, &[joint_d, joint_f], joint_e)
    }

    /// Closes the polygon of links by the force in their last joint, those in the others being known.
    fn last_of(&mut self, links: &[BodyId], known: &[JointId], last: JointId) -> Option<()> {
        let on = |statics: &Self, joint: JointId| {
            statics.mechanism().joint(joint).bodies.into_iter().find(|body| links.contains(body))
        };
        let mut forces = Vec::new();
        for &joint in known {
            forces.extend(self.on(joint, on(self, joint)?));
        }
        forces.extend(self.set(links).forces);
        let last_on = on(self, last)?;
        if forces.is_empty() {
            self.joints.insert(last, None);
            return Some(());
        }
        let mut chain = self.chain(links);
        self.lay_off_all(&mut chain, &forces);
        self.close(&chain, last, last_on);
        Some(())
    }
}
