//! Forces in joints and drives, and what is read from them.

use super::acting::{Acting, Source, Wrench, about};
use super::{Counted, Posed};
use crate::geometry::{Ball, Pair, Solvable};
use crate::mechanism::{BodyId, GROUND, JointId, Mechanism, PointId, SliderId};

/// What a joint carries: the force on its second body at the joint's place, and a couple. A slider's second body is the sliding link.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Carried<N = Ball> {
    pub force: Pair<N>,
    pub couple: N,
    /// Between teeth, at their pitch point: the part of the force on the first body along the tangent, which is the direction from the first wheel's
    /// centre to the second's, or from a wheel's centre to its rack, turned by +90°.
    pub tangential: N,
    /// What friction in the joint does to the second of the bodies between which it rubs, about the joint's place: a couple at a pin, a force
    /// along a guide.
    pub friction: Wrench<N>,
}

/// What a drive needs.
#[derive(Clone, Debug)]
pub struct Drive {
    /// The link that it turns, if it does.
    pub body: Option<BodyId>,
    /// The slider that it pushes, if it does.
    pub slider: Option<SliderId>,
    /// The torque on the link, counter-clockwise positive, or the force along the guide, from the equilibrium of the links.
    pub(crate) effort: Ball,
    /// The same from virtual power.
    pub(crate) by_power: Ball,
    /// By load: its power while this drive runs at rate 1 and the others stand.
    pub(crate) powers: Vec<Ball>,
}

/// How far the two routes to what the drives need differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The largest difference, in parts of the largest such number.
    pub difference: f64,
    /// What rounding allows.
    pub allowed: f64,
}

/// The forces in the joints and drives of a mechanism, in the scene's unit of force; moments in force · length.
#[derive(Clone, Debug)]
pub struct Forces<N = Ball> {
    pub(crate) acting: Vec<Acting<N>>,
    /// By joint.
    pub(crate) joints: Vec<Carried<N>>,
    /// By body: the torque of its drive; zero of others.
    pub(crate) torques: Vec<N>,
    /// What links and springs do to the frame, about its first point.
    pub(crate) frame: Wrench<N>,
    /// What each drive needs, by both routes: links first, then sliders.
    pub drives: Vec<Drive>,
}

impl<N: Solvable> Forces<N> {
    /// The force on a body at a pin, from all other bodies there; `None` where the body has no joint with that pin.
    ///
    /// What a carrier of given motion receives is not known to be in equilibrium with anything: it is the reaction alone.
    pub(crate) fn at_pin(&self, mechanism: &Mechanism, pin: PointId, body: BodyId) -> Option<Pair<N>> {
        let mut sum = None;
        for (joint, carried) in mechanism.joints.iter().zip(&self.joints).filter(|(joint, _)| joint.pin == Some(pin)) {
            let force = match joint.bodies {
                [_, second] if second == body => carried.force,
                [first, _] if first == body => -carried.force,
                _ => continue,
            };
            sum = Some(sum.map_or(force, |sum| sum + force));
        }
        sum
    }

    /// The tangential force between the teeth of a joint, on its first body.
    pub(crate) fn tangential(&self, joint: JointId) -> N {
        self.joints[joint.0].tangential
    }

    /// The force between the teeth of a joint, on its first body.
    pub(crate) fn tooth_force(&self, joint: JointId) -> Pair<N> {
        -self.joints[joint.0].force
    }

    /// The couple of friction that a body receives at a pin from all other bodies there, counter-clockwise positive.
    pub(crate) fn friction_at_pin(&self, mechanism: &Mechanism, pin: PointId, body: BodyId) -> N {
        let at_pin = mechanism.joint_ids().zip(&self.joints).filter(|(id, _)| mechanism.joint(*id).pin == Some(pin));
        at_pin.fold(N::default(), |sum, (id, carried)| match mechanism.rubbing_bodies(id) {
            [_, second] if second == body => sum + carried.friction.moment,
            [first, _] if first == body => sum - carried.friction.moment,
            _ => sum,
        })
    }

    /// The friction that a sliding link receives along its guide, whose direction is `guide`.
    pub(crate) fn friction_along(&self, mechanism: &Mechanism, slider: SliderId, guide: Pair<N>) -> N {
        // Of a slider at rest it is zero, not the negative one.
        N::default() + self.slider(mechanism, slider).friction.force.dot(guide)
    }

    /// The load of a kind on a body.
    pub(crate) fn load(&self, source: Source, body: BodyId) -> Option<&Acting<N>> {
        self.acting.iter().find(|load| load.source == source && load.body == body)
    }

    fn slider(&self, mechanism: &Mechanism, slider: SliderId) -> &Carried<N> {
        let JointId(joint) = mechanism.slider_joint(slider);
        &self.joints[joint]
    }

    /// The force on a sliding link across its guide, along the guide's direction turned by +90°; `guide` is that direction.
    pub(crate) fn normal(&self, mechanism: &Mechanism, slider: SliderId, guide: Pair<N>) -> N {
        self.slider(mechanism, slider).force.dot(guide.quarter_turn())
    }

    /// The couple on a sliding link from its guide, about the slider's point.
    pub(crate) fn couple(&self, mechanism: &Mechanism, slider: SliderId) -> N {
        self.slider(mechanism, slider).couple
    }

    /// The moment of what the links do to the frame, about a place.
    pub(crate) fn frame_moment(&self, mechanism: &Mechanism, posed: &impl Posed<N>, place: Pair<N>) -> N
    where
        N: Counted,
    {
        self.frame.moment + (about(mechanism, posed, GROUND) - place).cross(self.frame.force)
    }

    /// The torque of a link's drive.
    pub(crate) fn torque(&self, link: BodyId) -> N {
        self.torques[link.0]
    }

    /// The force of a slider's drive along the guide, whose direction is `guide`.
    pub(crate) fn push(&self, mechanism: &Mechanism, slider: SliderId, guide: Pair<N>) -> N {
        self.slider(mechanism, slider).force.dot(guide)
    }
}

impl Forces {
    /// How far both routes to the drives' torques and forces differ.
    #[must_use]
    pub fn agreement(&self) -> Agreement {
        let none = Agreement { difference: 0.0, allowed: 0.0 };
        self.drives.iter().fold(none, |worst, drive| {
            // Parts of the powers of its loads, as these may nearly cancel.
            let size = drive.powers.iter().map(|power| power.largest()).fold(drive.effort.largest(), f64::max);
            if size == 0.0 {
                return worst;
            }
            let apart = drive.effort - drive.by_power;
            Agreement {
                difference: worst.difference.max(apart.high.abs() / size),
                allowed: worst.allowed.max((drive.effort.error() + drive.by_power.error()) / size),
            }
        })
    }
}
