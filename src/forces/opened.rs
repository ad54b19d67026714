//! A group of links cut open in as many pins as it has loops, so that every link hangs on one other by one joint.

use super::equilibrium::own_joint;
use crate::mechanism::{BodyId, Group, JointId, Mechanism, PointId, Role, SliderId};
use std::collections::VecDeque;

/// A group cut open.
#[derive(Clone, Debug)]
pub(super) struct Opened {
    /// Its bodies, the outermost first.
    pub hung: Vec<Hung>,
    /// The pins in which it is cut.
    pub cuts: Vec<Cut>,
    /// The terms of its equations.
    pub terms: Vec<Term>,
}

/// A body as it hangs on another one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hung {
    pub body: BodyId,
    pub on: BodyId,
    /// The place of the latter among the group's bodies; none where it is no body of the group.
    pub within: Option<usize>,
    pub joint: JointId,
    /// Whether the joint's force is that on this body, not on the other one.
    pub is_second: bool,
    pub at: PointId,
    pub by: By,
}

/// How a body hangs on another one.
#[derive(Clone, Copy, Debug)]
pub(super) enum By {
    /// By a pin; the row of its rate's equation.
    Pin(usize),
    /// By a guide; the row of its rate's equation, none where its rate is given.
    Guide(SliderId, Option<usize>),
    /// By a pin about which it is driven.
    Drive,
}

/// A pin in which a group is cut; its force is that on the second body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub joint: JointId,
    pub at: PointId,
    pub bodies: [BodyId; 2],
}

/// What the force in a cut does at rate 1: its product with this vector.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    pub row: usize,
    pub cut: usize,
    pub sign: f64,
    pub vector: Along,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Along {
    /// The arm from the first to the second point, turned by +90°.
    Arm(PointId, PointId),
    /// The direction of the guide.
    Guide(SliderId),
}

impl Hung {
    /// A body of given motion, as it hangs on what drives it.
    pub fn driven(mechanism: &Mechanism, body: BodyId) -> Option<Hung> {
        let joint = own_joint(mechanism, body)?;
        let by = match (mechanism.joint(joint).slider, &mechanism.body(body).role) {
            (Some(slider), _) => By::Guide(slider, None),
            (None, Role::Driver { .. }) => By::Drive,
            _ => return None,
        };
        Hung::new(mechanism, body, joint, by, None)
    }

    fn new(mechanism: &Mechanism, body: BodyId, joint: JointId, by: By, within: Option<usize>) -> Option<Hung> {
        let [first, second] = mechanism.joint(joint).bodies;
        let is_second = second == body;
        let on = if is_second { first } else { second };
        Some(Hung { body, on, within, joint, is_second, at: mechanism.joint_point(joint), by })
    }
}

impl Opened {
    pub fn new(mechanism: &Mechanism, group: &Group) -> Option<Opened> {
        let joints = mechanism.joints_of(group);
        let (guides, pins): (Vec<JointId>, Vec<JointId>) =
            joints.into_iter().partition(|&joint| mechanism.joint(joint).slider.is_some());
        // Bodies that are joined so far; all known ones count as one.
        let known = group.bodies.len();
        let index = |body: &BodyId| group.bodies.iter().position(|own| own == body).unwrap_or(known);
        let mut parts: Vec<usize> = (0..=known).collect();
        let (mut kept, mut cuts) = (Vec::new(), Vec::new());
        // Guides first: what they carry has a couple, so none of them is cut.
        for (joint, is_guide) in
            guides.into_iter().map(|joint| (joint, true)).chain(pins.into_iter().map(|joint| (joint, false)))
        {
            let bodies = mechanism.joint(joint).bodies;
            let [a, b] = bodies.each_ref().map(|body| parts[index(body)]);
            match (a == b, is_guide) {
                (true, true) => return None,
                (true, false) => cuts.push(Cut { joint, at: mechanism.joint_point(joint), bodies }),
                (false, _) => {
                    parts.iter_mut().filter(|part| **part == b).for_each(|part| *part = a);
                    kept.push(joint);
                }
            }
        }
        let mut hung = Vec::new();
        let (mut next, mut rows) = (VecDeque::from([known]), 0);
        while let Some(here) = next.pop_front() {
            let from_here = |joint: &JointId| mechanism.joint(*joint).bodies.iter().any(|body| index(body) == here);
            let (own, rest): (Vec<JointId>, Vec<JointId>) = kept.into_iter().partition(from_here);
            kept = rest;
            for joint in own {
                let body = mechanism.joint(joint).bodies.into_iter().find(|body| index(body) != here)?;
                let slider = mechanism.joint(joint).slider;
                let is_sought = slider.is_none_or(|slider| mechanism.slider(slider).drive.is_none());
                let row = is_sought.then_some(rows);
                rows += usize::from(is_sought);
                let by = match (slider, row) {
                    (Some(slider), row) => By::Guide(slider, row),
                    (None, row) => By::Pin(row?),
                };
                hung.push(Hung::new(mechanism, body, joint, by, None)?);
                next.push_back(index(&body));
            }
        }
        if hung.len() != known || rows != 2 * cuts.len() {
            return None;
        }
        hung.reverse();
        let order: Vec<BodyId> = hung.iter().map(|hung| hung.body).collect();
        for own in &mut hung {
            own.within = order.iter().position(|body| *body == own.on);
        }
        let mut opened = Opened { hung, cuts, terms: Vec::new() };
        opened.add_terms();
        Some(opened)
    }

    /// Adds what the force in each cut does: along the chain of bodies on which each side of it hangs.
    fn add_terms(&mut self) {
        for (index, cut) in self.cuts.iter().enumerate() {
            for (mut body, sign) in [(cut.bodies[1], 1.0), (cut.bodies[0], -1.0)] {
                let mut at = cut.at;
                while let Some(hung) = self.hung.iter().find(|hung| hung.body == body) {
                    let mut add = |row, vector| self.terms.push(Term { row, cut: index, sign, vector });
                    match hung.by {
                        By::Pin(row) => {
                            add(row, Along::Arm(hung.at, at));
                            at = hung.at;
                        }
                        By::Guide(slider, Some(row)) => add(row, Along::Guide(slider)),
                        // A guide passes the moment on.
                        By::Guide(_, None) | By::Drive => {}
                    }
                    body = hung.on;
                }
            }
        }
    }
}
