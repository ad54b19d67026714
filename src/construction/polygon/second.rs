//! Groups of class II.

use super::MomentPoint;
use super::leg::{Held, Leg, Rest};
use super::statics::Statics;
use crate::construction::operation::PlaceId;
use crate::mechanism::{BodyId, Group, JointId};

impl Statics<'_, '_> {
    /// Finds what the joints of a dyad carry.
    pub fn second(&mut self, group: &Group) -> Option<()> {
        let chain = group.loops.first()?;
        let &[first, inner, last] = chain.joints.as_slice() else { return None };
        let &[_, a, b, _] = chain.bodies.as_slice() else { return None };
        let [a, b] = [(first, a), (last, b)].map(|(joint, lead)| (joint, self.mechanism().compound(lead)));
        match self.held(inner)? {
            Held::Pin(_) => self.dyad_by_two(a, inner, b),
            Held::Guide(_) => match self.held(a.0)? {
                Held::Pin(_) => self.dyad_with_slide(a, inner, b),
                Held::Guide(_) => self.dyad_with_slide(b, inner, a),
            },
        }
    }

    /// Two directions close the polygon of a dyad with an inner pin.
    fn dyad_by_two(
        &mut self,
        (first, a): (JointId, Vec<BodyId>),
        inner: JointId,
        (last, b): (JointId, Vec<BodyId>),
    ) -> Option<()> {
        let legs = [self.leg(first, inner, &a)?, self.leg(last, inner, &b)?];
        let mut chain = self.chain(&[a.clone(), b.clone()].concat());
        self.lay_off_all(&mut chain, legs[0].across.iter());
        self.lay_off_loads(&mut chain, &a);
        let between = chain.end;
        self.lay_off_loads(&mut chain, &b);
        let before = chain.end;
        self.lay_off_all(&mut chain, legs[1].across.iter());
        let (_, corner) = self.close_by_two(&chain, [legs[0].unknown()?, legs[1].unknown()?])?;
        let polygon = chain.polygon;
        let end = self.end_of_first(&legs[0], polygon, chain.start);
        self.join(polygon, first, legs[0].on, [corner, end]);
        self.join(polygon, last, legs[1].on, [before, corner]);
        let on = self.mechanism().side(inner, self.mechanism().lead(a[0]));
        self.join(polygon, inner, on, [between, corner]);
        Some(())
    }

    /// Where the part of a leg's force ends that begins a polygon.
    pub fn end_of_first(&self, leg: &Leg, polygon: usize, start: PlaceId) -> PlaceId {
        let sides = &self.plan.polygons[polygon].sides;
        leg.across.and(sides.first()).map_or(start, |side| side.ends[1])
    }

    /// A dyad with an inner guide: of its outer pin `first` nothing is known but that it closes the polygon.
    fn dyad_with_slide(
        &mut self,
        (first, a): (JointId, Vec<BodyId>),
        inner: JointId,
        (last, b): (JointId, Vec<BodyId>),
    ) -> Option<()> {
        let Held::Pin(pin) = self.held(first)? else { return None };
        let on = self.mechanism().joint(first).bodies.into_iter().find(|body| a.contains(body))?;
        let leg = self.leg(last, inner, &b)?;
        let links = [a.clone(), b.clone()].concat();
        let rest = match leg.rest {
            Rest::Line(at, along) => {
                let step = self.begin();
                let set = self.set(&links).with(leg.across, leg.couple);
                let place = self.writer.plot(pin);
                let about = (MomentPoint::Joint(pin), place);
                self.force_by_moments(step, &links, &set, about, (leg.of, at, along))?
            }
            Rest::Couple => None,
        };
        let mut chain = self.chain(&links);
        self.lay_off_loads(&mut chain, &a);
        let between = chain.end;
        self.lay_off_loads(&mut chain, &b);
        let before = chain.end;
        self.lay_off_all(&mut chain, leg.across.iter().chain(&rest));
        self.close(&chain, first, on);
        self.join(chain.polygon, last, leg.on, [before, chain.end]);
        let on = self.mechanism().side(inner, self.mechanism().lead(a[0]));
        self.join(chain.polygon, inner, on, [between, chain.end]);
        Some(())
    }
}
