//! Friction as somebody takes it by mistake: what it then is in every joint, as that of one joint changes what the others carry.

use super::acting::{LoadList, Rub, Source};
use super::equilibrium::carried;
use super::{AtPose, Forces, Posed};
use crate::geometry::Vector;
use crate::mechanism::{JointId, Mechanism};
use crate::position::Pose;
use crate::scene::Grip;

/// A joint that rubs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RubbedJoint {
    pub joint: JointId,
    /// Whether it is a pin; else it is a guide.
    pub is_pin: bool,
    pub grip: Grip,
    /// The radius of the pin's journal; 0 in a guide.
    pub radius: f64,
    /// Whether what rubs there is what the joint carries, not what several joints of a pin carry together.
    pub is_alone: bool,
}

/// What friction does to a body: a force along a guide or a couple at a pin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrictionLoad {
    pub force: Vector,
    pub couple: f64,
}

/// The joints that rub.
pub(crate) fn rubbing(mechanism: &Mechanism) -> Vec<RubbedJoint> {
    let joints = LoadList::new(mechanism).map(|list| list.friction).unwrap_or_default();
    let joint = |(joint, rub)| {
        let is_alone = mechanism.rubbing_bodies(joint)[1] == mechanism.joint(joint).bodies[1];
        match rub {
            Rub::Pin { grip, radius } => RubbedJoint { joint, is_pin: true, grip, radius, is_alone },
            Rub::Guide(_, grip) => RubbedJoint { joint, is_pin: false, grip, radius: 0.0, is_alone },
        }
    };
    joints.into_iter().map(joint).collect()
}

/// The loads of friction, in their order among all loads, if that of each joint is so many times as large for what the joint carries; `None` where there are no such
/// forces.
pub(crate) fn friction_times(
    mechanism: &Mechanism,
    pose: &Pose,
    factor: &dyn Fn(JointId) -> f64,
) -> Option<Vec<FrictionLoad>> {
    let mut list = LoadList::new(mechanism)?;
    for (joint, rub) in &mut list.friction {
        let factor = factor(*joint);
        *rub = match *rub {
            Rub::Pin { radius, grip } => Rub::Pin { radius: radius * factor, grip },
            Rub::Guide(slider, grip) => Rub::Guide(slider, Grip::Coefficient(grip.tangent() * factor)),
        };
    }
    let forces = carried(mechanism, &AtPose::new(mechanism, pose), &list)?;
    let friction = forces.acting.iter().filter(|load| matches!(load.source, Source::Friction(_)));
    Some(friction.map(|load| FrictionLoad { force: load.force.rounded(), couple: load.couple.high }).collect())
}

/// By joint that rubs: how many times as large as what it carries is what it would carry if all joints were smooth.
pub(crate) fn smooth_over_rough(mechanism: &Mechanism, pose: &Pose) -> Option<Vec<(JointId, f64)>> {
    let posed = AtPose::new(mechanism, pose);
    let list = LoadList::new(mechanism)?;
    let rough = carried(mechanism, &posed, &list)?;
    let smooth = carried(mechanism, &posed, &list.clone().without_friction())?;
    let ratio = |&(joint, rub): &(JointId, Rub)| {
        let size = |forces: &Forces| match rub {
            Rub::Pin { .. } => {
                let [_, body] = mechanism.rubbing_bodies(joint);
                let force = forces.at_pin(mechanism, mechanism.joint_point(joint), body);
                force.unwrap_or_default().rounded().norm()
            }
            Rub::Guide(slider, _) => forces.normal(mechanism, slider, Posed::guide(&posed, slider)).high.abs(),
        };
        (joint, size(&smooth) / size(&rough))
    };
    Some(list.friction.iter().map(ratio).collect())
}
