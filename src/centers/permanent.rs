use super::LinkPair;
use crate::mechanism::{AngularConstraint, BodyId, JointId, Mechanism, PointId, SliderId};

/// What joints alone say of the instant centre of two links, in every position and at rest, too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Permanent {
    /// A pin joins them: it is the centre.
    Pin(PointId),
    /// Wheels on them, or a wheel and a rack, roll on each other: it is their pitch point.
    Mesh(JointId),
    /// One slides along a guide of the other: the centre lies at infinity, normal to the guide.
    Guide(SliderId),
    /// Sliders join them over other links, so that they always turn alike: the centre lies at infinity, normal to their relative velocity.
    Alike,
}

impl Permanent {
    /// What joints say of the centre of this pair; `None` where it depends on the position, with several drives on the rates.
    #[must_use]
    pub fn of(pair: LinkPair, mechanism: &Mechanism) -> Option<Permanent> {
        let links = pair.links();
        let [a, b] = links.map(|link| mechanism.body(link));
        if let Some(&pin) = a.points.iter().find(|&&point| b.has(point)) {
            return Some(Permanent::Pin(pin));
        }
        let meshes = |id: &JointId| {
            let joint = mechanism.joint(*id);
            joint.rolls() && pair.other(joint.bodies[0]) == Some(joint.bodies[1])
        };
        if let Some(mesh) = mechanism.joint_ids().find(meshes) {
            return Some(Permanent::Mesh(mesh));
        }
        let joins = |id: &SliderId| {
            let slider = mechanism.slider(*id);
            pair.other(slider.on) == Some(slider.link)
        };
        let guide = mechanism.slider_ids().find(joins).map(Permanent::Guide);
        guide.or_else(|| turn_alike(mechanism, links).then_some(Permanent::Alike))
    }
}

/// Whether joints that keep angles join one body to the other.
fn turn_alike(mechanism: &Mechanism, [from, to]: [BodyId; 2]) -> bool {
    let angular = mechanism.joints.iter().filter_map(|joint| joint.angular.as_ref());
    let ties: Vec<[BodyId; 2]> = angular.filter_map(AngularConstraint::as_fixed_angle).map(|(tied, _)| tied).collect();
    let mut found = vec![from];
    let mut next = 0;
    while let Some(&here) = found.get(next) {
        next += 1;
        for &[a, b] in &ties {
            let there = if a == here { b } else { a };
            if [a, b].contains(&here) && !found.contains(&there) {
                found.push(there);
            }
        }
    }
    found.contains(&to)
}
