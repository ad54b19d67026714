//! Groups of class III: the moments of the whole group about the crossing of two legs' lines tell what the third leg carries along its own.

use super::leg::Leg;
use super::statics::Statics;
use crate::mechanism::{BodyId, Group, JointId};

/// A leg of the group: its outer and its inner joint, and its links.
type Joints = (JointId, JointId, Vec<BodyId>);

impl Statics<'_, '_> {
    /// Finds what the joints of a group of class III carry.
    pub fn third(&mut self, group: &Group) -> Option<()> {
        let [first, second] = group.loops.as_slice() else { return None };
        let compound = |lead: &BodyId| self.mechanism().compound(*lead);
        let joints: [Joints; 3] = [
            (*first.joints.first()?, *first.joints.get(1)?, compound(first.bodies.get(1)?)),
            (*first.joints.get(3)?, *first.joints.get(2)?, compound(first.bodies.get(3)?)),
            (*second.joints.get(3)?, *second.joints.get(2)?, compound(second.bodies.get(3)?)),
        ];
        let central = compound(first.bodies.get(2)?);
        let legs: Vec<Leg> =
            joints.iter().map(|(outer, inner, links)| self.leg(*outer, *inner, links)).collect::<Option<_>>()?;
        let [a, k, b] = self.steepest([&legs[0], &legs[1], &legs[2]]);
        let all = self
            .set(&group.bodies)
            .with(legs.iter().filter_map(|leg| leg.across), legs.iter().filter_map(|leg| leg.couple));
        let rest = self.rest_by_moments(&group.bodies, all, [&legs[a], &legs[b]], &legs[k])?;
        let mut chain = self.chain(&group.bodies);
        let polygon = chain.polygon;
        self.lay_off_all(&mut chain, legs[a].across.iter());
        self.lay_off_loads(&mut chain, &joints[a].2);
        let after_a = chain.end;
        self.lay_off_loads(&mut chain, &central);
        let before_k = chain.end;
        self.lay_off_loads(&mut chain, &joints[k].2);
        let reaction_k = chain.end;
        self.lay_off_all(&mut chain, legs[k].across.iter().chain(&rest));
        let after_k = chain.end;
        self.lay_off_loads(&mut chain, &joints[b].2);
        let reaction_b = chain.end;
        self.lay_off_all(&mut chain, legs[b].across.iter());
        let (_, corner) = self.close_by_two(&chain, [legs[a].unknown()?, legs[b].unknown()?])?;
        let end = self.end_of_first(&legs[a], polygon, chain.start);
        self.join(polygon, joints[a].0, legs[a].on, [corner, end]);
        self.join(polygon, joints[k].0, legs[k].on, [reaction_k, after_k]);
        self.join(polygon, joints[b].0, legs[b].on, [reaction_b, corner]);
        for (leg, ends) in [(a, [after_a, corner]), (k, [after_k, before_k]), (b, [corner, after_k])] {
            let (_, inner, links) = &joints[leg];
            self.join(polygon, *inner, self.mechanism().side(*inner, links[0]), ends);
        }
        Some(())
    }

    /// Three legs in an order in which the lines of the first and the last cross at the largest angle.
    pub fn steepest(&mut self, legs: [&Leg; 3]) -> [usize; 3] {
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2]];
        let sines = orders.map(|[a, _, b]| self.sine(legs[a], legs[b]));
        let best = (1..orders.len()).fold(0, |best, next| if sines[next] > sines[best] { next } else { best });
        orders[best]
    }
}
