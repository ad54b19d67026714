//! The part of an outer joint's force that one link alone tells, and the line along which the rest of it acts.

use super::statics::{Couple, Force, Set, Statics};
use super::{ForceOf, ForcePart, Found, MomentPoint};
use crate::construction::operation::{Along, LineId, OperationRole, PlaceId};
use crate::mechanism::{BodyId, JointId, PointId, SliderId};
use crate::sheet::Sheet;

/// What a joint holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Held {
    /// A pin at this point.
    Pin(PointId),
    /// A guide: a pin at infinity, normal to it.
    Guide(SliderId),
}

/// What is left of a joint's force.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rest {
    /// A force along a line of the scheme, through this place.
    Line(PlaceId, Along),
    /// A couple alone: the line of both joints is that at infinity.
    Couple,
}

/// What is known of the force of a joint on links that are cut free together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// The body that receives the force.
    pub on: BodyId,
    /// The part that the links' moments tell; none where it is zero.
    pub across: Option<Force>,
    /// The couple that goes with it, where the rest counts as acting in the other joint.
    pub couple: Option<Couple>,
    pub rest: Rest,
    /// What the rest is a part of.
    pub of: ForceOf,
}

impl Leg {
    /// The line of its rest, drawn on the scheme, and the place through which it is drawn.
    pub fn line(&self, statics: &mut Statics<'_, '_>) -> Option<LineId> {
        match self.rest {
            Rest::Line(at, along) => Some(statics.line(at, along, None)),
            Rest::Couple => None,
        }
    }

    /// Its rest as an unknown of a polygon; `None` for a couple.
    pub fn unknown(&self) -> Option<(ForceOf, PlaceId, Along)> {
        match self.rest {
            Rest::Line(at, along) => Some((self.of, at, along)),
            Rest::Couple => None,
        }
    }

    /// The same force on the other body of the joint.
    pub fn reversed(self, statics: &Statics<'_, '_>) -> Leg {
        let other = |of: ForceOf| match of {
            ForceOf::Joint { joint, on, part } => {
                let [first, second] = statics.mechanism().joint(joint).bodies;
                Statics::part(joint, if on == first { second } else { first }, part)
            }
            load => load,
        };
        let of = other(self.of);
        let ForceOf::Joint { on, .. } = of else { return self };
        let (across, couple) = (self.across.map(|force| statics.reversed(force)), self.couple.map(Couple::reversed));
        Leg { on, across, couple, of, ..self }
    }
}

impl Statics<'_, '_> {
    /// What a joint holds; `None` for one that is neither a pin nor a guide that keeps an angle.
    pub fn held(&self, joint: JointId) -> Option<Held> {
        let joint = self.mechanism().joint(joint);
        match (joint.pin, joint.slider) {
            (Some(pin), None) => Some(Held::Pin(pin)),
            (None, Some(slider)) => joint.angular.as_ref()?.as_fixed_angle().map(|_| Held::Guide(slider)),
            _ => None,
        }
    }

    /// The direction in which a guide carries forces.
    pub fn across_guide(&mut self, slider: SliderId) -> Along {
        Along::line(self.writer.guide(slider)).turned(1)
    }

    /// What the links `bodies`, cut free, tell of the force in joint `x` on them, if they have no other unknown than in joint `y`.
    pub fn leg(&mut self, x: JointId, y: JointId, bodies: &[BodyId]) -> Option<Leg> {
        let on = self.mechanism().joint(x).bodies.into_iter().find(|body| bodies.contains(body))?;
        let other = self.mechanism().joint(y).bodies.into_iter().find(|body| bodies.contains(body))?;
        let set = self.set(bodies);
        let part = |part| Statics::part(x, on, part);
        let leg = |across, couple, rest, of| Leg { on, across, couple, rest, of };
        match (self.held(x)?, self.held(y)?) {
            (Held::Pin(from), Held::Pin(to)) => {
                let line = Along::line(self.writer.join(from, to));
                let (at, about) = (self.writer.plot(from), self.writer.plot(to));
                let step = self.begin();
                let unknown = (part(ForcePart::Tangential), at, line.turned(1));
                let found = self.force_by_moments(step, bodies, &set, (MomentPoint::Joint(to), about), unknown)?;
                Some(leg(found, None, Rest::Line(at, line), part(ForcePart::Normal)))
            }
            (Held::Pin(from), Held::Guide(slider)) => {
                let at = self.writer.plot(from);
                let guide = Along::line(self.writer.guide(slider));
                let rest = Rest::Line(at, guide.turned(1));
                let of = part(ForcePart::AcrossGuide);
                if set.forces.is_empty() {
                    return Some(leg(None, None, rest, of));
                }
                let at_guide = self.place(y);
                let mut chain = self.chain(bodies);
                self.lay_off_all(&mut chain, &set.forces);
                let along = (part(ForcePart::AlongGuide), at, guide);
                let across = (ForceOf::Both { joints: [x, y], on }, at_guide, guide.turned(1));
                let ([along, _], _) = self.close_by_two(&chain, [along, across])?;
                Some(leg(Some(along), None, rest, of))
            }
            (Held::Guide(slider), Held::Pin(pin)) => {
                let normal = self.across_guide(slider);
                let at = self.writer.plot(pin);
                let finds = Found::CoupleAbout(slider, pin);
                let size = self.couple_by_moments(bodies, &set, pin, finds);
                let couple = size.map(|size| Couple { size, sign: 1.0 });
                Some(leg(None, couple, Rest::Line(at, normal), part(ForcePart::Normal)))
            }
            (Held::Guide(slider), Held::Guide(inner)) => {
                let [own, others] = [slider, inner].map(|slider| self.across_guide(slider));
                let of = part(ForcePart::Whole);
                if set.forces.is_empty() {
                    return Some(leg(None, None, Rest::Couple, of));
                }
                let [at, at_inner] = [self.place(x), self.place(y)];
                let mut chain = self.chain(bodies);
                self.lay_off_all(&mut chain, &set.forces);
                let unknown = [(of, at, own), (Statics::part(y, other, ForcePart::Whole), at_inner, others)];
                let ([found, _], _) = self.close_by_two(&chain, unknown)?;
                Some(leg(Some(found), None, Rest::Couple, of))
            }
        }
    }

    /// The sine of the angle between the lines of two rests: of a couple 0.
    pub fn sine(&mut self, a: &Leg, b: &Leg) -> f64 {
        let (Some(a), Some(b)) = (a.line(self), b.line(self)) else { return 0.0 };
        let [a, b] = [a, b].map(|line| self.writer.construction.record.exact.lines[line.0].1);
        a.cross(b).high.abs()
    }

    /// Finds the rest of a leg from moments about the crossing of the rests of two others; gives it with the leg.
    pub fn rest_by_moments(
        &mut self,
        links: &[BodyId],
        set: Set,
        [a, b]: [&Leg; 2],
        leg: &Leg,
    ) -> Option<Option<Force>> {
        let Rest::Line(at, along) = leg.rest else { return Some(None) };
        let step = self.begin();
        let place = match (a.rest, b.rest) {
            (Rest::Line(first, _), Rest::Line(second, _)) if first == second => first,
            _ => {
                let lines = [a.line(self)?, b.line(self)?];
                self.writer.cross(true, Sheet::Scheme, OperationRole::MomentPoint, lines)?
            }
        };
        let about = (MomentPoint::Crossing([a.of, b.of]), place);
        self.force_by_moments(step, links, &set, about, (leg.of, at, along))
    }
}
