//! How a hand reads forces and moments from its force plan or its lever.

use super::{Reader, Sense, Unread, measured_as};
use crate::construction::{
    Along, Construction, Equation, ForceOf as Drawn, ForcePart, LoadShown, MeasuredAs, MomentPoint, NumberId,
    NumberKind, OperationRole, Product,
};
use crate::forces::{Driven, Source};
use crate::mechanism::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::quantity::force_name::{ArmPoint, ForceOf, LinePart, LoadOf};
use crate::quantity::name::{QuantityRequest, Spot, What};
use crate::scene::Component;
use crate::sheet::Sheet;

impl Reader<'_> {
    /// A force or a moment: the number that the plan finds for it, or measured in its polygon.
    pub(super) fn force(&mut self, asked: &QuantityRequest, of: &ForceOf) -> Result<(NumberId, Sense), Unread> {
        let by_hand = &self.writer.construction.by_hand;
        if !by_hand.contains(&Sheet::Forces) && !by_hand.contains(&Sheet::Lever) {
            return Err(Unread::NoSheet(Sheet::Forces));
        }
        match *of {
            ForceOf::Reaction(pin, body) => self.reaction(asked, pin, body),
            ForceOf::ReactionPart(part, pin, body, _) => {
                Ok((self.part_of_reaction(part, pin, body)?, Sense::Magnitude))
            }
            ForceOf::Offset(slider) => self.offset(asked, slider),
            ForceOf::InertiaForce(body) if asked.written.component == Some(Component::Size) => {
                Ok((self.inertia(body, 0)?, Sense::Magnitude))
            }
            ForceOf::InertiaCouple(body) => Ok((self.inertia(body, 1)?, Sense::Signed)),
            ForceOf::Normal(slider) => Ok((self.normal(slider)?, Sense::Signed)),
            ForceOf::Couple(slider) => Ok((self.couple(slider)?, Sense::Signed)),
            ForceOf::Torque(link) => {
                let in_plan = self.numbers()?.torques.get(&link).copied();
                let number = in_plan.or_else(|| self.on_lever(Driven::Body(link)));
                Ok((number.ok_or(Unread::NotDrawn)?, Sense::Signed))
            }
            ForceOf::Push(slider) => {
                let in_plan = self.numbers()?.pushes.get(&slider).copied();
                match in_plan {
                    Some((number, sign)) => Ok((self.signed(number, sign), Sense::Signed)),
                    None => Ok((self.on_lever(Driven::Slider(slider)).ok_or(Unread::NotDrawn)?, Sense::Signed)),
                }
            }
            ForceOf::Arm(..) => {
                let mechanism = self.writer.mechanism;
                let arm = asked.measured_arm(&self.writer.construction, mechanism).ok_or(Unread::NotDrawn)?;
                Ok((arm, Sense::Magnitude))
            }
            ForceOf::Power(load) => Ok((self.power(load)?, Sense::Signed)),
            _ => Err(Unread::NotDrawn),
        }
    }

    /// What lies between two corners of a force polygon, measured there.
    pub(super) fn corners(&mut self, asked: &QuantityRequest, ends: &[String; 2]) -> Result<(NumberId, Sense), Unread> {
        let construction = &self.writer.construction;
        if !construction.by_hand.contains(&Sheet::Forces) {
            return Err(Unread::NoSheet(Sheet::Forces));
        }
        let place = |name: &String| construction.place(Sheet::Forces, name).ok_or(Unread::NotDrawn);
        let ends = self.drawn([place(&ends[0])?, place(&ends[1])?])?;
        let (how, sense) = measured_as(asked.written.component.unwrap_or(Component::Size));
        Ok((self.measure(Sheet::Forces, asked.name(), ends, how), sense))
    }

    /// The power of a load, from its moment on the lever.
    fn power(&self, of: LoadOf) -> Result<NumberId, Unread> {
        let construction = &self.writer.construction;
        let plan = construction.forces.as_deref().ok_or(Unread::NotDrawn)?;
        let mut parts = (0..plan.loads.len()).filter(|&index| {
            let load = &plan.loads[index];
            of.is(self.writer.mechanism, load.source, load.body)
        });
        // The lever has each part by itself, and no line for their sum.
        let (Some(index), None) = (parts.next(), parts.next()) else { return Err(Unread::NotDrawn) };
        let mut powers = construction.levers.iter().flat_map(|lever| &lever.powers);
        let found = powers.find(|power| power.load == index && power.name.is_some());
        found.map(|power| power.number).ok_or(Unread::NotDrawn)
    }

    /// The force of inertia of a link, or its couple, as it is taken. Where accelerations are drawn it is as good as these are.
    fn inertia(&self, body: BodyId, which: usize) -> Result<NumberId, Unread> {
        let construction = &self.writer.construction;
        if construction.by_hand.contains(&Sheet::Acceleration) {
            return Err(Unread::NotDrawn);
        }
        let plan = construction.forces.as_deref().ok_or(Unread::NotDrawn)?;
        let is_it = |load: &LoadShown| load.source == Source::Inertia && load.body == body;
        let index = plan.loads.iter().position(is_it).ok_or(Unread::NotDrawn)?;
        plan.numbers.loads.get(index).and_then(|numbers| numbers[which]).ok_or(Unread::Given)
    }

    /// A part of what a pin does to a link, along the line of its two joints or across.
    fn part_of_reaction(&self, part: LinePart, pin: PointId, body: BodyId) -> Result<NumberId, Unread> {
        let mechanism = self.writer.mechanism;
        let is_it = |of: &Drawn| match of {
            Drawn::Joint { joint, part: drawn, .. } => {
                let joint = mechanism.joint(*joint);
                joint.pin == Some(pin) && joint.bodies.contains(&body) && part.is_drawn_as(*drawn)
            }
            _ => false,
        };
        let mut parts = self.numbers()?.parts.iter();
        parts.find(|part| is_it(&part.of)).map(|part| part.size).ok_or(Unread::NotDrawn)
    }

    fn numbers(&self) -> Result<&crate::construction::FoundNumbers, Unread> {
        self.writer.construction.forces.as_deref().map(|plan| &plan.numbers).ok_or(Unread::NotDrawn)
    }

    fn on_lever(&self, drive: Driven) -> Option<NumberId> {
        let mut levers = self.writer.construction.levers.iter();
        levers.find(|lever| lever.drive == drive).map(|lever| lever.number())
    }

    /// A number, or its negative.
    fn signed(&mut self, number: NumberId, sign: f64) -> NumberId {
        if sign > 0.0 {
            return number;
        }
        self.writer.compute(Sheet::Forces, NumberKind::Size, vec![Product::plain(number).times(-1.0)])
    }

    /// What a pin does to a body: its size is measured in the polygon where later steps need it; its direction and its
    /// components are measured once more.
    fn reaction(&mut self, asked: &QuantityRequest, pin: PointId, body: BodyId) -> Result<(NumberId, Sense), Unread> {
        let Some(component) = asked.written.component else { return Err(Unread::Vector) };
        let mechanism = self.writer.mechanism;
        let joints = mechanism.joints.iter().enumerate();
        let at_pin = joints.filter(|(_, joint)| joint.pin == Some(pin) && joint.bodies.contains(&body));
        let [(joint, _)] = at_pin.collect::<Vec<_>>()[..] else { return Err(Unread::NotDrawn) };
        let found = self.numbers()?.whole.iter().find(|force| force.joint == JointId(joint)).copied();
        let found = found.ok_or(Unread::NotDrawn)?;
        let ends = if found.on == body { found.ends } else { [found.ends[1], found.ends[0]] };
        if component == Component::Size {
            return Ok((found.size, Sense::Magnitude));
        }
        let (how, sense) = measured_as(component);
        let ends = self.drawn(ends)?;
        Ok((self.measure(Sheet::Forces, asked.name(), ends, how), sense))
    }

    /// The force across a guide on the sliding link, positive a quarter turn counter-clockwise from the guide.
    fn normal(&mut self, slider: SliderId) -> Result<NumberId, Unread> {
        let mechanism = self.writer.mechanism;
        let joint = mechanism.slider_joint(slider);
        let link = mechanism.slider(slider).link;
        let guide = Along::line(self.writer.guide(slider));
        let is_across = |of: &Drawn| matches!(of, Drawn::Joint { joint: own, part, .. } if *own == joint && *part != ForcePart::AlongGuide);
        let numbers = self.numbers()?;
        let part = numbers.parts.iter().find(|part| is_across(&part.of) && part.along == guide.turned(1)).copied();
        if let Some(part) = part {
            let on = match part.of {
                Drawn::Joint { on, .. } => on,
                _ => link,
            };
            return Ok(self.signed(part.size, if on == link { 1.0 } else { -1.0 }));
        }
        // A diagonal of a polygon: what an inner guide carries.
        let whole = numbers.whole.iter().find(|force| force.joint == joint).copied().ok_or(Unread::NotDrawn)?;
        let ends = if whole.on == link { whole.ends } else { [whole.ends[1], whole.ends[0]] };
        let ends = self.drawn(ends)?;
        let across = self.writer.draw(Sheet::Forces, OperationRole::Line, ends[0], guide.turned(1));
        Ok(self.writer.measure(Sheet::Forces, NumberKind::Force, ends, MeasuredAs::Along(across)))
    }

    /// The couple of a guide on the sliding link, about the slider's point.
    fn couple(&mut self, slider: SliderId) -> Result<NumberId, Unread> {
        let (number, sign) = self.numbers()?.couples.get(&slider).copied().ok_or(Unread::NotDrawn)?;
        Ok(self.signed(number, sign))
    }

    /// How far from the slider's point the force across a guide acts: its couple over the force.
    pub(super) fn offset(&mut self, asked: &QuantityRequest, slider: SliderId) -> Result<(NumberId, Sense), Unread> {
        let couple = self.couple(slider)?;
        let force = self.normal(slider)?;
        let equation = Equation { left: vec![(0, Product::plain(force))], right: vec![Product::plain(couple)] };
        let kind = NumberKind::Reading(asked.name().to_owned());
        let found = self.writer.solve(Sheet::Forces, vec![kind], vec![equation]).ok_or(Unread::NotDrawn)?;
        Ok((*found.first().ok_or(Unread::NotDrawn)?, Sense::Signed))
    }
}

impl LinePart {
    /// Whether a part of a joint's force in a plan is this one.
    fn is_drawn_as(self, part: ForcePart) -> bool {
        match self {
            LinePart::Along => matches!(part, ForcePart::Normal | ForcePart::AcrossGuide),
            LinePart::Across => matches!(part, ForcePart::Tangential | ForcePart::AlongGuide),
        }
    }
}

impl QuantityRequest {
    /// The number by which a force plan has an arm; `None` of other quantities, and of arms that it does not need.
    pub(crate) fn measured_arm(&self, construction: &Construction, mechanism: &Mechanism) -> Option<NumberId> {
        let What::Force(ForceOf::Arm(of, about), _) = &self.what else { return None };
        let plan = construction.forces.as_deref()?;
        let is_line = |of: &ForceOf, drawn: Drawn| of.has_line_of(drawn, &plan.loads, mechanism);
        let is_point = |point: MomentPoint| match (about, point) {
            (ArmPoint::Spot(Spot::Point(_, own, _)), MomentPoint::Joint(point)) => *own == point,
            (ArmPoint::Crossing(lines), MomentPoint::Crossing([first, second])) => {
                let are = |first, second| is_line(&lines[0], first) && is_line(&lines[1], second);
                are(first, second) || are(second, first)
            }
            _ => false,
        };
        let mut arms = plan.arms();
        arms.find(|(moment, arm)| is_point(moment.about) && is_line(of, arm.of)).map(|(_, arm)| arm.number)
    }

    /// Whether it is the arm of a force.
    pub(crate) fn is_arm(&self) -> bool {
        matches!(self.what, What::Force(ForceOf::Arm(..), _))
    }
}

impl ForceOf {
    /// Whether it has the line of action of a force in a plan: what a joint does to one link and to the other has one line.
    fn has_line_of(&self, drawn: Drawn, loads: &[LoadShown], mechanism: &Mechanism) -> bool {
        match (self, drawn) {
            (ForceOf::Load(load), Drawn::Load(index)) => {
                loads.get(index).is_some_and(|own| own.source == load.source && own.body == load.body)
            }
            (ForceOf::Reaction(pin, body), Drawn::Joint { joint, part: ForcePart::Whole, .. }) => {
                let joint = mechanism.joint(joint);
                joint.pin == Some(*pin) && joint.bodies.contains(body)
            }
            (ForceOf::ReactionPart(part, pin, body, _), Drawn::Joint { joint, part: drawn, .. }) => {
                let joint = mechanism.joint(joint);
                joint.pin == Some(*pin) && joint.bodies.contains(body) && part.is_drawn_as(drawn)
            }
            (ForceOf::Normal(slider), Drawn::Joint { joint, part, .. }) => {
                joint == mechanism.slider_joint(*slider) && part != ForcePart::AlongGuide
            }
            _ => false,
        }
    }
}
