//! Equilibrium in many positions: what hangs on joints alone is found once, and each position then costs a few sums for each link and,
//! by group, as many equations as its velocities have.
//!
//! Each group is cut open in as many pins as it has loops, so that every link hangs on one other by one joint. Virtual power of all loads at rate
//! 1 of each unknown ω and ṡ, Q, is a sum over what hangs on a joint; with f, the forces in the cut pins, Aᵀ f = −Q, where A is the
//! matrix of the velocities of these loops (Shai and Pennock 2006). What the other joints carry follows link by link, the outermost first.

use super::acting::{Acting, LoadList, Wrench};
use super::carried::{Carried, Forces};
use super::equilibrium::{driven, own_joint};
use super::{Posed, equilibrium};
use crate::geometry::Pair;
use crate::mechanism::{AngularConstraint, BodyId, GROUND, Group, JointId, Mechanism, PointId, Role, SliderId};
use smallvec::{SmallVec, smallvec};
use std::collections::VecDeque;

/// A mechanism with its loads, compiled for the forces of many positions.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The mechanism.
    pub mechanism: Mechanism,
    loads: Option<LoadList>,
    plan: Option<Plan>,
}

/// The order in which links are cut free.
#[derive(Clone, Debug)]
struct Plan {
    /// By body: the point about which its moments are taken.
    about: Vec<Option<PointId>>,
    groups: Vec<Opened>,
    driven: Vec<Hung>,
}

/// A group cut open.
#[derive(Clone, Debug)]
struct Opened {
    /// Its bodies, the outermost first.
    hung: Vec<Hung>,
    /// The pins in which it is cut.
    cuts: Vec<Cut>,
    /// The terms of its equations.
    terms: Vec<Term>,
}

/// A body as it hangs on another one.
#[derive(Clone, Copy, Debug)]
struct Hung {
    body: BodyId,
    on: BodyId,
    /// The place of the latter among the group's bodies; none where it is no body of the group.
    within: Option<usize>,
    joint: JointId,
    /// Whether the joint's force is that on this body, not on the other one.
    is_second: bool,
    at: PointId,
    by: By,
}

/// How a body hangs on another one.
#[derive(Clone, Copy, Debug)]
enum By {
    /// By a pin; the row of its rate's equation.
    Pin(usize),
    /// By a guide; the row of its rate's equation, none where its rate is given.
    Guide(SliderId, Option<usize>),
    /// By a pin about which it is driven.
    Drive,
}

/// A pin in which a group is cut; its force is that on the second body.
#[derive(Clone, Copy, Debug)]
struct Cut {
    joint: JointId,
    at: PointId,
    bodies: [BodyId; 2],
}

/// What the force in a cut does at rate 1: its product with this vector.
#[derive(Clone, Copy, Debug)]
struct Term {
    row: usize,
    cut: usize,
    sign: f64,
    vector: Along,
}

#[derive(Clone, Copy, Debug)]
enum Along {
    /// The arm from the first to the second point, turned by +90°.
    Arm(PointId, PointId),
    /// The direction of the guide.
    Guide(SliderId),
}

impl Compiled {
    /// A mechanism compiled.
    #[must_use]
    pub fn new(mechanism: &Mechanism) -> Compiled {
        let plan = Plan::new(mechanism);
        Compiled { mechanism: mechanism.clone(), loads: LoadList::new(mechanism), plan }
    }

    /// The forces in a position; their [`Forces::drives`] are empty. `None` without loads and in a singular position.
    pub(crate) fn forces(&self, posed: &impl Posed<f64>) -> Option<Forces<f64>> {
        let acting = self.loads.as_ref()?.acting(posed)?;
        match &self.plan {
            Some(plan) => plan.carried(&self.mechanism, posed, acting),
            None => equilibrium::carried(&self.mechanism, posed, acting),
        }
    }
}

impl Plan {
    /// `None` for a mechanism with joints that are neither pins nor guides which keep an angle, or with a group that is singular by
    /// structure.
    fn new(mechanism: &Mechanism) -> Option<Plan> {
        let is_plain = |joint: &crate::mechanism::Joint| match &joint.angular {
            Some(angular) => AngularConstraint::as_fixed_angle(angular).is_some() && joint.slider.is_some(),
            None => joint.pin.is_some() && joint.slider.is_none(),
        };
        if !mechanism.joints.iter().all(is_plain) {
            return None;
        }
        let mut about: Vec<Option<PointId>> =
            mechanism.bodies.iter().map(|body| body.points.first().copied()).collect();
        let groups: Option<Vec<Opened>> =
            mechanism.groups.iter().rev().map(|group| Opened::new(mechanism, group)).collect();
        let groups = groups?;
        let driven: Option<Vec<Hung>> =
            driven(mechanism).into_iter().map(|body| Hung::driven(mechanism, body)).collect();
        let driven = driven?;
        for hung in groups.iter().flat_map(|group| &group.hung).chain(&driven) {
            about[hung.body.0] = Some(hung.at);
        }
        Some(Plan { about, groups, driven })
    }

    fn carried(&self, mechanism: &Mechanism, posed: &impl Posed<f64>, acting: Vec<Acting<f64>>) -> Option<Forces<f64>> {
        let places: SmallVec<[Pair<f64>; 16]> =
            (0..mechanism.points.len()).map(|point| posed.place(PointId(point))).collect();
        let bodies = mechanism.bodies.len();
        let mut here = Here {
            plan: self,
            posed,
            places,
            loads: smallvec![Wrench::default(); bodies],
            joints: vec![Carried::default(); mechanism.joints.len()],
            torques: vec![0.0; bodies],
        };
        for load in &acting {
            here.receive(load.body, load.at, load.force, load.couple);
        }
        for group in &self.groups {
            here.solve(group)?;
        }
        for hung in &self.driven {
            here.hand_on(hung);
        }
        let frame = here.frame(mechanism);
        Some(Forces { acting, joints: here.joints, torques: here.torques, frame, drives: Vec::new() })
    }
}

/// Equilibrium in a position.
struct Here<'a, P> {
    plan: &'a Plan,
    posed: &'a P,
    places: SmallVec<[Pair<f64>; 16]>,
    /// By body: what it has received, with the moment about its own point.
    loads: SmallVec<[Wrench<f64>; 12]>,
    joints: Vec<Carried<f64>>,
    torques: Vec<f64>,
}

impl<P: Posed<f64>> Here<'_, P> {
    fn receive(&mut self, body: BodyId, at: Pair<f64>, force: Pair<f64>, couple: f64) {
        let about = self.plan.about[body.0].map_or_else(Pair::default, |point| self.places[point.0]);
        self.loads[body.0].add(Wrench { force, moment: couple + (at - about).cross(force) });
    }

    /// What a joint passes on, and the couple among it: a pin none.
    fn passed(&self, hung: &Hung, wrench: Wrench<f64>) -> f64 {
        if matches!(hung.by, By::Guide(..)) { wrench.moment } else { 0.0 }
    }

    /// Finds what the joints of a group carry.
    fn solve(&mut self, group: &Opened) -> Option<()> {
        let rows = 2 * group.cuts.len();
        let mut right: SmallVec<[f64; 4]> = smallvec![0.0; rows];
        let mut wrenches: SmallVec<[Wrench<f64>; 6]> = group.hung.iter().map(|hung| self.loads[hung.body.0]).collect();
        for (index, hung) in group.hung.iter().enumerate() {
            let wrench = wrenches[index];
            match hung.by {
                By::Pin(row) => right[row] = wrench.moment,
                By::Guide(slider, Some(row)) => right[row] = wrench.force.dot(self.posed.guide(slider)),
                By::Guide(_, None) | By::Drive => {}
            }
            if let Some(within) = hung.within {
                let arm = self.places[hung.at.0] - self.places[group.hung[within].at.0];
                let moment = self.passed(hung, wrench) + arm.cross(wrench.force);
                wrenches[within].add(Wrench { force: wrench.force, moment });
            }
        }
        let forces = self.cut_forces(group, &right)?;
        for (cut, &force) in group.cuts.iter().zip(&forces) {
            self.joints[cut.joint.0].force = force;
            let [first, second] = cut.bodies;
            let at = self.places[cut.at.0];
            self.receive(first, at, -force, 0.0);
            self.receive(second, at, force, 0.0);
        }
        group.hung.iter().for_each(|hung| self.hand_on(hung));
        Some(())
    }

    /// The forces in the cuts; `right` is the virtual power of all that is known.
    fn cut_forces(&self, group: &Opened, right: &[f64]) -> Option<SmallVec<[Pair<f64>; 2]>> {
        let cuts = group.cuts.len();
        let mut matrix: SmallVec<[Pair<f64>; 8]> = smallvec![Pair::default(); 2 * cuts * cuts];
        for term in &group.terms {
            let vector = match term.vector {
                Along::Arm(from, to) => (self.places[to.0] - self.places[from.0]).quarter_turn(),
                Along::Guide(slider) => self.posed.guide(slider),
            };
            let own = &mut matrix[term.row * cuts + term.cut];
            *own = own.plus_scaled(vector, term.sign);
        }
        let forces = match *matrix {
            [first, second] => {
                let whole = 1.0 / first.cross(second);
                smallvec![(second * right[0] - first * right[1]).quarter_turn() * whole]
            }
            _ => solved(cuts, &matrix, right)?,
        };
        forces.iter().all(|force| force.x.is_finite() && force.y.is_finite()).then_some(forces)
    }

    /// Notes what a body's joint carries when all else on the body is known, and hands it on.
    fn hand_on(&mut self, hung: &Hung) {
        let wrench = self.loads[hung.body.0];
        let mut couple = self.passed(hung, wrench);
        let (force, own) = if hung.is_second { (-wrench.force, -couple) } else { (wrench.force, couple) };
        self.joints[hung.joint.0] = Carried { force, couple: own, tangential: 0.0 };
        if matches!(hung.by, By::Drive) {
            self.torques[hung.body.0] = -wrench.moment;
            // The frame receives the torque's reaction.
            self.loads[GROUND.0].moment += wrench.moment;
            couple = 0.0;
        }
        self.receive(hung.on, self.places[hung.at.0], wrench.force, couple);
    }

    /// What the frame has received, about its first point.
    fn frame(&self, mechanism: &Mechanism) -> Wrench<f64> {
        debug_assert_eq!(self.plan.about[GROUND.0], mechanism.body(GROUND).points.first().copied());
        self.loads[GROUND.0]
    }
}

/// The forces f with Aᵀ f = −Q, by elimination with the largest pivot, each row in parts of its largest coefficient; `None` where one is zero.
fn solved(cuts: usize, matrix: &[Pair<f64>], right: &[f64]) -> Option<SmallVec<[Pair<f64>; 2]>> {
    let size = 2 * cuts;
    let mut rows: SmallVec<[SmallVec<[f64; 5]>; 4]> = SmallVec::new();
    for (row, &right) in matrix.chunks(cuts).zip(right) {
        let largest = row.iter().fold(0.0_f64, |most, v| most.max(v.x.abs()).max(v.y.abs()));
        let numbers = row.iter().flat_map(|v| [v.x, v.y]).chain([-right]);
        rows.push(numbers.map(|x| x / largest).collect());
    }
    for step in 0..size {
        let pivot = (step..size).max_by(|&a, &b| rows[a][step].abs().total_cmp(&rows[b][step].abs()))?;
        rows.swap(step, pivot);
        let (done, rest) = rows.split_at_mut(step + 1);
        let own = &done[step];
        if own[step] == 0.0 {
            return None;
        }
        for row in rest {
            let factor = row[step] / own[step];
            if factor != 0.0 {
                for (x, y) in row[step..].iter_mut().zip(&own[step..]) {
                    *x -= factor * y;
                }
            }
        }
    }
    let mut found: SmallVec<[f64; 4]> = smallvec![0.0; size];
    for step in (0..size).rev() {
        let row = &rows[step];
        let sum = (step + 1..size).fold(row[size], |left, other| left - row[other] * found[other]);
        found[step] = sum / row[step];
    }
    Some(found.chunks(2).map(|force| Pair { x: force[0], y: force[1] }).collect())
}

impl Hung {
    /// A body of given motion, as it hangs on what drives it.
    fn driven(mechanism: &Mechanism, body: BodyId) -> Option<Hung> {
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
    fn new(mechanism: &Mechanism, group: &Group) -> Option<Opened> {
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
