//! Equilibrium of every link, group by group from the last one to the first, then of the driven links.

use super::acting::{Acting, Wrench, about};
use super::carried::{Carried, Forces};
use super::{Counted, Posed};
use crate::geometry::{Equations, Pair};
use crate::mechanism::{BodyId, GROUND, JointId, Mechanism, Role};
use smallvec::{SmallVec, smallvec};

/// What an unknown of the equations is.
#[derive(Clone, Copy, Debug)]
enum Unknown<N> {
    /// A part of what a joint carries: a force on its second body at the joint's place, or a couple.
    Joint(JointId, Part<N>),
    /// The torque of a drive.
    Torque(BodyId),
}

#[derive(Clone, Copy, Debug)]
enum Part<N> {
    /// In this direction.
    Force(Pair<N>),
    /// By the relation of angles that the joint keeps.
    Couple,
}

/// What the joints carry, so that all links are in equilibrium; `None` where a group leaves it open.
pub(super) fn carried<N: Counted>(
    mechanism: &Mechanism,
    posed: &impl Posed<N>,
    acting: Vec<Acting<N>>,
) -> Option<Forces<N>> {
    let mut balance = Balance {
        mechanism,
        posed,
        about: mechanism.body_ids().map(|body| about(mechanism, posed, body)).collect(),
        loads: vec![Wrench::default(); mechanism.bodies.len()],
        found: Forces {
            drives: Vec::new(),
            acting: Vec::new(),
            joints: vec![Carried::default(); mechanism.joints.len()],
            torques: vec![N::default(); mechanism.bodies.len()],
            frame: Wrench::default(),
        },
    };
    for load in &acting {
        let moment = load.couple + (load.at - balance.about[load.body.0]).cross(load.force);
        balance.loads[load.body.0].add(Wrench { force: load.force, moment });
    }
    for group in mechanism.groups.iter().rev() {
        balance.solve(&group.bodies, &mechanism.joints_of(group))?;
    }
    for body in driven(mechanism) {
        let joints = own_joint(mechanism, body).into_iter().collect::<Vec<JointId>>();
        balance.solve(&[body], &joints)?;
    }
    let frame = balance.loads[GROUND.0];
    Some(Forces { acting, frame, ..balance.found })
}

/// The driven bodies, those that others push after those that they push.
pub(crate) fn driven(mechanism: &Mechanism) -> Vec<BodyId> {
    let from_frame = |body: &BodyId| {
        let root = mechanism.body(mechanism.root(*body));
        matches!(root.role, Role::Ground | Role::Driver { .. }) && *body != GROUND
    };
    let depth = |body: BodyId| {
        let mut here = body;
        let mut depth = 0;
        while let Role::Pushed { from, .. } = mechanism.body(here).role {
            here = from;
            depth += 1;
        }
        depth
    };
    let is_driven = |body: &BodyId| matches!(mechanism.body(*body).role, Role::Driver { .. } | Role::Pushed { .. });
    let mut driven: Vec<BodyId> = mechanism.body_ids().filter(|body| is_driven(body) && from_frame(body)).collect();
    driven.sort_by_key(|&body| std::cmp::Reverse(depth(body)));
    driven
}

/// The joint by which a driven body hangs on that which drives it.
pub(crate) fn own_joint(mechanism: &Mechanism, body: BodyId) -> Option<JointId> {
    match mechanism.body(body).role {
        Role::Pushed { slider, .. } => Some(mechanism.slider_joint(slider)),
        Role::Driver { pivot, .. } => {
            let is_own = |id: &JointId| {
                let joint = mechanism.joint(*id);
                joint.pin == Some(pivot) && joint.bodies.contains(&body)
            };
            (0..mechanism.joints.len()).map(JointId).find(is_own)
        }
        _ => None,
    }
}

struct Balance<'a, P, N> {
    mechanism: &'a Mechanism,
    posed: &'a P,
    /// By body: the place about which its moments are taken.
    about: Vec<Pair<N>>,
    /// By body: its loads, and what later groups hand on to it.
    loads: Vec<Wrench<N>>,
    found: Forces<N>,
}

impl<N: Counted, P: Posed<N>> Balance<'_, P, N> {
    /// Finds what these joints carry from the equilibrium of these bodies, and hands it on to the bodies on which they hang.
    fn solve(&mut self, bodies: &[BodyId], joints: &[JointId]) -> Option<()> {
        let mut unknowns: Vec<Unknown<N>> = joints.iter().flat_map(|&joint| self.parts(joint)).collect();
        let is_turned = |body: &&BodyId| matches!(self.mechanism.body(**body).role, Role::Driver { .. });
        unknowns.extend(bodies.iter().filter(is_turned).map(|&body| Unknown::Torque(body)));
        let size = 3 * bodies.len();
        if unknowns.len() != size {
            return None;
        }
        let mut equations = Equations::new(size, bodies.len());
        let row = |body: BodyId| bodies.iter().position(|&own| own == body);
        for (column, &unknown) in unknowns.iter().enumerate() {
            for (body, wrench) in self.acts(unknown) {
                if let Some(row) = row(body) {
                    equations.add(2 * row, column, wrench.force.x);
                    equations.add(2 * row + 1, column, wrench.force.y);
                    equations.add(2 * bodies.len() + row, column, wrench.moment);
                }
            }
        }
        for (row, &body) in bodies.iter().enumerate() {
            let Wrench { force, moment } = self.loads[body.0];
            equations.add_right(2 * row, -force.x);
            equations.add_right(2 * row + 1, -force.y);
            equations.add_right(2 * bodies.len() + row, -moment);
        }
        for (&unknown, x) in unknowns.iter().zip(equations.solved()?) {
            for (body, wrench) in self.acts(unknown) {
                if row(body).is_none() {
                    self.loads[body.0].add(wrench.times(x));
                }
            }
            match unknown {
                Unknown::Torque(body) => self.found.torques[body.0] = x,
                Unknown::Joint(joint, Part::Force(along)) => {
                    let carried = &mut self.found.joints[joint.0];
                    carried.force = carried.force.plus_scaled(along, x);
                }
                Unknown::Joint(joint, Part::Couple) => self.found.joints[joint.0].couple = x,
            }
        }
        Some(())
    }

    /// The unknowns of a joint: one for each freedom that it takes away, with the force of its drive.
    fn parts(&self, id: JointId) -> SmallVec<[Unknown<N>; 3]> {
        let joint = self.mechanism.joint(id);
        let mut parts: SmallVec<[Part<N>; 3]> = SmallVec::new();
        if joint.pin.is_some() {
            let [one, none] = [1.0, 0.0].map(N::from);
            parts.push(Part::Force(Pair { x: one, y: none }));
            parts.push(Part::Force(Pair { x: none, y: one }));
        }
        if let Some(slider) = joint.slider {
            let along = self.posed.guide(slider);
            parts.push(Part::Force(along.quarter_turn()));
            if self.mechanism.slider(slider).drive.is_some() {
                parts.push(Part::Force(along));
            }
        }
        if joint.angular.is_some() {
            parts.push(Part::Couple);
        }
        parts.into_iter().map(|part| Unknown::Joint(id, part)).collect()
    }

    /// What an unknown of size 1 does to which bodies.
    fn acts(&self, unknown: Unknown<N>) -> SmallVec<[(BodyId, Wrench<N>); 3]> {
        let couple = |weight: f64| Wrench { force: Pair::default(), moment: weight.into() };
        match unknown {
            Unknown::Torque(body) => smallvec![(body, couple(1.0)), (GROUND, couple(-1.0))],
            Unknown::Joint(joint, Part::Couple) => {
                let angular = self.mechanism.joint(joint).angular.iter();
                let terms = angular.flat_map(|angular| &angular.terms);
                terms.map(|&(body, weight)| (body, couple(f64::from(weight)))).collect()
            }
            Unknown::Joint(joint, Part::Force(along)) => {
                let at = self.posed.place(self.mechanism.joint_point(joint));
                let [first, second] = self.mechanism.joint(joint).bodies;
                let on = |body: BodyId, force: Pair<N>| {
                    (body, Wrench { force, moment: (at - self.about[body.0]).cross(force) })
                };
                smallvec![on(first, -along), on(second, along)]
            }
        }
    }
}
