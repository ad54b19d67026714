//! Names of forces, moments and powers, looked up in a mechanism with loads.

use super::error::{Part, QuantityError, unknown};
use super::name::{Finder, Spot};
use super::says;
use crate::forces::{Source, rubbed_joints};
use crate::mechanism::{BodyId, Class, GROUND, JointId, Mechanism, PointId, Role, SliderId};
use crate::message::Message;
use crate::scene::{Analysis, Head, Loads, QuantityName};
use crate::text::shown;
use indexmap::IndexSet;

/// A force, a moment, or what belongs to one.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum ForceOf {
    /// The force on a body at a pin.
    Reaction(PointId, BodyId),
    /// A part of it, along the line of two joints of the link or across.
    ReactionPart(LinePart, PointId, BodyId, Towards),
    /// The force on a sliding link across its guide.
    Normal(SliderId),
    /// The couple on a sliding link from its guide.
    Couple(SliderId),
    /// How far from the slider's point, along the guide, the line of that force runs.
    Offset(SliderId),
    /// The torque of a link's drive.
    Torque(BodyId),
    /// The force of a slider's drive along its guide.
    Push(SliderId),
    /// The inertia force of a link, −m a.
    InertiaForce(BodyId),
    /// The inertia couple of a link, −J α.
    InertiaCouple(BodyId),
    /// The friction on a sliding link along its guide.
    Friction(SliderId),
    /// The couple of friction on a body at a pin.
    FrictionCouple(PointId, BodyId),
    /// The acceleration of a link's centre of mass.
    CenterAcceleration(BodyId),
    /// The moment of a load about a place.
    LoadMoment(LoadOf, Spot),
    /// The arm of a force: how far its line of action runs from a point.
    Arm(Box<ForceOf>, ArmPoint),
    /// The force of a load.
    Load(LoadOf),
    /// The power of a load.
    Power(LoadOf),
    /// What the links do to the frame.
    Shaking,
    /// The moment of that about a place.
    ShakingMoment(Spot),
}

/// The point about which an arm is taken.
#[derive(Clone, Debug)]
pub enum ArmPoint {
    /// A named place.
    Spot(Spot),
    /// Where the lines of two forces cross.
    Crossing(Box<[ForceOf; 2]>),
}

/// Which part of a joint's force is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinePart {
    /// Along the line: positive from the joint towards the other one, so that it presses the link.
    Along,
    /// Across it: positive turned by +90° from there.
    Across,
}

/// The joint towards which a line of two joints runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Towards {
    /// A joint at this point.
    Point(PointId),
    /// A guide, which is a pin at infinity, in its direction turned by +90°.
    Guide(SliderId),
}

/// A load: where it comes from and on which body it acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoadOf {
    /// Where it comes from.
    pub source: Source,
    /// The body on which it acts.
    pub body: BodyId,
}

impl ForceOf {
    /// Whether it is a vector.
    #[must_use]
    pub fn is_vector(&self) -> bool {
        use ForceOf::{CenterAcceleration, InertiaForce, Load, Reaction, Shaking};
        matches!(self, Load(_) | Reaction(..) | InertiaForce(_) | CenterAcceleration(_) | Shaking)
    }

    /// The place about which moments are taken, if any.
    pub(crate) fn about(&self) -> Option<&Spot> {
        match self {
            ForceOf::LoadMoment(_, about) | ForceOf::ShakingMoment(about) | ForceOf::Arm(_, ArmPoint::Spot(about)) => {
                Some(about)
            }
            _ => None,
        }
    }
}

impl LoadOf {
    /// The name of the load in results: that which the scene gives it, `weight(2)`, `inertia(2)`; of a spring with the link on which
    /// it pulls; of friction with the link and what rubs on it, `friction(3/2)` in a guide and `friction(B,2)` at a pin.
    #[must_use]
    pub fn name(self, mechanism: &Mechanism) -> String {
        self.source.name(mechanism, self.body)
    }

    /// Whether a load from there on a body has this name, or is a part of what has it.
    pub(super) fn is(&self, mechanism: &Mechanism, source: Source, body: BodyId) -> bool {
        let pin = |source: Source| match source {
            Source::Friction(joint) => mechanism.joint(joint).pin,
            _ => None,
        };
        body == self.body && (source == self.source || pin(source).is_some() && pin(source) == pin(self.source))
    }

    /// All loads of a mechanism, weights and inertia of its links first.
    fn all(mechanism: &Mechanism, loads: &Loads) -> Vec<LoadOf> {
        let mut all = Vec::new();
        let mut add = |source, on: Option<BodyId>| all.extend(on.map(|body| LoadOf { source, body }));
        for link in loads.masses.keys() {
            let body = mechanism.link(link);
            if loads.gravity != [0.0; 2] {
                add(Source::Weight, body);
            }
            if loads.analysis == Analysis::Dynamic {
                add(Source::Inertia, body);
            }
        }
        for (index, load) in loads.loads.iter().enumerate() {
            add(Source::Given(index), mechanism.link(&load.on));
        }
        for (index, spring) in loads.springs.iter().enumerate() {
            for end in &spring.ends {
                add(Source::Spring(index), mechanism.body_named(&end.on));
            }
        }
        for joint in rubbed_joints(mechanism) {
            for body in mechanism.rubbing_bodies(joint).into_iter().filter(|body| *body != GROUND) {
                add(Source::Friction(joint), Some(body));
            }
        }
        let mut taken = IndexSet::new();
        all.retain(|load| taken.insert(load.name(mechanism)));
        all
    }
}

/// Names of what joints carry and drives need in a mechanism with loads; none without.
#[must_use]
pub fn force_names(mechanism: &Mechanism) -> Vec<String> {
    if mechanism.loads.is_none() {
        return Vec::new();
    }
    let rubbed = rubbed_joints(mechanism);
    let mut names = Vec::new();
    for pin in mechanism.point_ids() {
        let at_pin = |joint: &JointId| mechanism.joint(*joint).pin == Some(pin);
        let has_friction = rubbed.iter().any(at_pin);
        let joints: Vec<JointId> = mechanism.joint_ids().filter(at_pin).collect();
        let is_joined = |body: &BodyId| joints.iter().any(|joint| mechanism.joint(*joint).bodies.contains(body));
        for body in mechanism.body_ids().filter(|body| is_joined(body) && !mechanism.body(*body).is_nameless()) {
            let subject = format!("{},{}", mechanism.point_name(pin), mechanism.body(body).name);
            names.push(Head::Reaction.of(&subject));
            names.extend(has_friction.then(|| Head::FrictionCouple.of(&subject)));
        }
    }
    for id in mechanism.slider_ids() {
        let name = mechanism.slider_name(id);
        names.extend([Head::GuideForce, Head::GuideCouple, Head::GuideOffset].map(|head| head.of(&name)));
        names.extend(rubbed.contains(&mechanism.slider_joint(id)).then(|| Head::FrictionForce.of(&name)));
        names.extend(mechanism.slider(id).drive.map(|_| Head::Push.of(&name)));
    }
    let turned = mechanism.bodies.iter().filter(|body| matches!(body.role, Role::Driver { .. }));
    names.extend(turned.map(|body| Head::Torque.of(&body.name)));
    names.push(Head::Shaking.word().to_owned());
    names
}

impl Finder<'_> {
    /// The force of a name, in a mechanism with loads.
    pub(super) fn force(&self, head: Head, arguments: &[String]) -> Result<ForceOf, QuantityError> {
        let first = arguments.first().map_or("", String::as_str);
        let second = || arguments.get(1).map(String::as_str).ok_or_else(|| self.form());
        let pin_and_link = || Ok((self.pin(first)?, self.link(second()?)?));
        let force = match head {
            Head::Torque => ForceOf::Torque(self.link(first)?),
            Head::GuideForce => ForceOf::Normal(self.slider(first)?),
            Head::GuideCouple => ForceOf::Couple(self.slider(first)?),
            Head::GuideOffset => ForceOf::Offset(self.slider(first)?),
            Head::Push => ForceOf::Push(self.slider(first)?),
            Head::InertiaForce => ForceOf::InertiaForce(self.link(first)?),
            Head::InertiaCouple => ForceOf::InertiaCouple(self.link(first)?),
            Head::FrictionForce => ForceOf::Friction(self.slider(first)?),
            Head::FrictionCouple => pin_and_link().map(|(pin, link)| ForceOf::FrictionCouple(pin, link))?,
            Head::CenterAcceleration => ForceOf::CenterAcceleration(self.link(first)?),
            Head::LoadMoment => ForceOf::LoadMoment(self.load(first)?, self.spot(second()?)?),
            Head::Arm => {
                let about = match arguments.get(2) {
                    None => ArmPoint::Spot(self.spot(second()?)?),
                    Some(third) => ArmPoint::Crossing(Box::new([self.line(second()?)?, self.line(third)?])),
                };
                ForceOf::Arm(Box::new(self.line(first)?), about)
            }
            Head::Load => ForceOf::Load(self.load(first)?),
            Head::Power => ForceOf::Power(self.load(first)?),
            Head::Shaking => ForceOf::Shaking,
            Head::ShakingMoment => ForceOf::ShakingMoment(self.spot(first)?),
            Head::ReactionAlong | Head::ReactionAcross => {
                let (pin, link) = pin_and_link()?;
                let part = if head == Head::ReactionAlong { LinePart::Along } else { LinePart::Across };
                self.is_there(&ForceOf::Reaction(pin, link))?;
                let towards = self.mechanism.other_joint(pin, link);
                let towards = towards.ok_or_else(|| self.has_none(says::no_line_of_joints()))?;
                ForceOf::ReactionPart(part, pin, link, towards)
            }
            _ => pin_and_link().map(|(pin, link)| ForceOf::Reaction(pin, link))?,
        };
        self.is_there(&force)?;
        Ok(force)
    }

    /// A force that has a line of action: a load by its name, or what a pin or a guide carries by that of the quantity.
    fn line(&self, name: &str) -> Result<ForceOf, QuantityError> {
        let of_joint = QuantityName::parse(name).filter(|parsed| {
            let heads = [Head::Reaction, Head::ReactionAlong, Head::ReactionAcross, Head::GuideForce];
            parsed.is_plain() && heads.contains(&parsed.head)
        });
        match of_joint {
            Some(QuantityName { head, arguments, .. }) => self.force(head, &arguments),
            None => Ok(ForceOf::Load(self.load(name)?)),
        }
    }

    fn has_none(&self, why: Message) -> QuantityError {
        QuantityError::NoValue(shown(self.name), why)
    }

    /// Whether the mechanism has what a force asks for.
    fn is_there(&self, force: &ForceOf) -> Result<(), QuantityError> {
        let mechanism = self.mechanism;
        let loads = &self.loads()?;
        let has_mass = |body: &BodyId| loads.masses.contains_key(&mechanism.body(*body).name);
        let why = match force {
            ForceOf::Reaction(pin, link) | ForceOf::FrictionCouple(pin, link) => {
                let mut joints = mechanism.joints.iter();
                let is_joint = joints.any(|joint| joint.pin == Some(*pin) && joint.bodies.contains(link));
                (!is_joint).then(says::not_at_pin)
            }
            ForceOf::Torque(link) => {
                (!matches!(mechanism.body(*link).role, Role::Driver { .. })).then(says::not_driven)
            }
            ForceOf::Push(slider) => mechanism.slider(*slider).drive.is_none().then(says::not_driven),
            ForceOf::InertiaForce(link) | ForceOf::InertiaCouple(link) | ForceOf::CenterAcceleration(link)
                if !has_mass(link) =>
            {
                Some(says::no_mass())
            }
            ForceOf::InertiaForce(_) | ForceOf::InertiaCouple(_) => {
                (loads.analysis == Analysis::Static).then(says::no_inertia)
            }
            _ => None,
        };
        why.map_or(Ok(()), |why| Err(self.has_none(why)))
    }

    fn loads(&self) -> Result<&Loads, QuantityError> {
        let loads = self.mechanism.loads.as_ref().map(|loads| &loads.0);
        loads.ok_or_else(|| self.has_none(says::no_loads()))
    }

    fn pin(&self, name: &str) -> Result<PointId, QuantityError> {
        let points = self.mechanism.points.iter().map(String::as_str);
        self.mechanism.point(name).ok_or_else(|| unknown(self.name, Part::Point, name, points))
    }

    fn load(&self, name: &str) -> Result<LoadOf, QuantityError> {
        let all = LoadOf::all(self.mechanism, self.loads()?);
        let names: Vec<String> = all.iter().map(|load| load.name(self.mechanism)).collect();
        // White space has no meaning in a quantity's name.
        let is_it = |own: &String| own.chars().filter(|c| !c.is_whitespace()).eq(name.chars());
        match names.iter().position(is_it) {
            Some(index) => Ok(all[index]),
            None => Err(unknown(self.name, Part::Load, name, names.iter().map(String::as_str))),
        }
    }
}

impl Mechanism {
    /// The other joint of a link, seen from a pin: of its group, where it is a link of one, else of all. Of the links of a group of class
    /// IV that have three joints in it, for the pin by which they hang, the pin of the other one. `None` where no other joint or more
    /// than one could be meant.
    fn other_joint(&self, pin: PointId, link: BodyId) -> Option<Towards> {
        let lead = self.lead(link);
        let group = self.groups.iter().find(|group| group.links.contains(&lead));
        let bodies = if group.is_some() { self.compound(lead) } else { vec![link] };
        let all: Vec<JointId> = match group {
            Some(group) => group.joints.clone(),
            None => (0..self.joints.len()).map(JointId).collect(),
        };
        let holds =
            |joint: &JointId| self.joint(*joint).bodies.iter().filter(|body| bodies.contains(body)).count() == 1;
        let others = |joints: &mut dyn Iterator<Item = JointId>| {
            let mut others: Vec<Towards> = Vec::new();
            for joint in joints {
                let towards = self.towards(joint);
                if towards != Some(Towards::Point(pin)) {
                    others.extend(towards.filter(|other| !others.contains(other)));
                }
            }
            match others[..] {
                [other] => Some(other),
                _ => None,
            }
        };
        others(&mut all.iter().copied().filter(holds)).or_else(|| {
            let group = group.filter(|group| group.class == Class::Fourth)?;
            let is_outer = |joint: &JointId| self.joint(*joint).bodies.iter().any(|body| !group.bodies.contains(body));
            let mut outer = all.iter().copied().filter(is_outer);
            let hangs = outer.clone().any(|joint| self.joint(joint).pin == Some(pin) && holds(&joint));
            if hangs { others(&mut outer) } else { None }
        })
    }

    fn towards(&self, joint: JointId) -> Option<Towards> {
        let joint = self.joint(joint);
        let guide = || joint.slider.map(Towards::Guide);
        joint.pin.map(Towards::Point).or_else(guide)
    }
}
