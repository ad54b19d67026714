//! Driven sliders within a group, driven links, and what a group hands on to the bodies on which it hangs.

use super::statics::{Couple, Force, Set, Statics};
use super::{ForcePart, ForceStep, Found};
use crate::construction::number::NumberKind;
use crate::construction::operation::{Along, MeasuredAs};
use crate::forces::own_joint;
use crate::geometry::{Ball, Number, Pair, unit};
use crate::mechanism::{BodyId, GROUND, Group, JointId, Role, SliderId};
use crate::sheet::Sheet;

impl Statics<'_, '_> {
    /// Finds what the driven sliders within compound links of a group carry: the last links first.
    pub fn inner_drives(&mut self, group: &Group) -> Option<()> {
        for &body in group.bodies.iter().rev() {
            let Role::Pushed { slider, from } = self.mechanism().body(body).role else { continue };
            if !group.bodies.contains(&from) {
                continue;
            }
            let mut set = self.set(&[body]);
            for &joint in &group.joints {
                if self.mechanism().joint(joint).bodies.contains(&body) {
                    set = set.with(self.on(joint, body), self.couple_on(joint, body));
                }
            }
            // Those that it pushes itself are found before.
            for other in self.pushed_by(body) {
                let joint = self.mechanism().slider_joint(other);
                set = set.with(self.on(joint, body), self.couple_on(joint, body));
            }
            self.push(body, slider, set)?;
        }
        Some(())
    }

    /// The driven sliders by which a body pushes others.
    fn pushed_by(&self, body: BodyId) -> Vec<SliderId> {
        let of = |other: BodyId| match self.mechanism().body(other).role {
            Role::Pushed { slider, from } if from == body => Some(slider),
            _ => None,
        };
        self.mechanism().body_ids().filter_map(of).collect()
    }

    /// Finds what a driven slider does to the body that it pushes, on which all else is known.
    fn push(&mut self, body: BodyId, slider: SliderId, set: Set) -> Option<()> {
        let joint = self.mechanism().slider_joint(slider);
        if !set.forces.is_empty() {
            let mut chain = self.chain(&[body]);
            self.lay_off_all(&mut chain, &set.forces);
            self.close(&chain, joint, body);
            let step = self.begin();
            let guide = self.writer.guide(slider);
            let ends = [chain.end, chain.start];
            let how = MeasuredAs::Along(guide);
            let along = self.writer.measure(Sheet::Forces, NumberKind::Force, ends, how);
            let is_sliding = self.mechanism().slider(slider).link == body;
            let sign = if is_sliding { 1.0 } else { -1.0 };
            let value = self.number(along) * sign;
            self.plan.numbers.pushes.insert(slider, (along, sign));
            self.finish(step, ForceStep::Push(slider, value));
        }
        self.guide_couple(&[body], set, joint, body)
    }

    /// Finds what a driven link needs, and what its own joint carries; hands that on where another driven link carries it.
    pub fn driven(&mut self, body: BodyId) {
        let Some(joint) = own_joint(self.mechanism(), body) else { return };
        let set = self.set(&[body]);
        if set.is_empty() {
            return;
        }
        match self.mechanism().body(body).role {
            Role::Driver { pivot, .. } => {
                if let Some(torque) = self.couple_by_moments(&[body], &set, pivot, Found::Torque(body)) {
                    self.plan.numbers.torques.insert(body, torque);
                }
                if !set.forces.is_empty() {
                    let mut chain = self.chain(&[body]);
                    self.lay_off_all(&mut chain, &set.forces);
                    self.close(&chain, joint, body);
                }
            }
            Role::Pushed { slider, from } => {
                let found = self.push(body, slider, set);
                if found.is_some() {
                    self.hand(joint, from);
                }
            }
            _ => {}
        }
    }

    /// Hands what a group's outer joints carry on to the bodies on which it hangs, reversed.
    pub fn hand_on(&mut self, group: &Group) {
        for &joint in &group.joints {
            let bodies = self.mechanism().joint(joint).bodies;
            for body in bodies.into_iter().filter(|body| !group.bodies.contains(body)) {
                self.hand(joint, body);
            }
        }
    }

    fn hand(&mut self, joint: JointId, body: BodyId) {
        if body != GROUND {
            let (force, couple) = (self.on(joint, body), self.couple_on(joint, body));
            self.loads[body.0].forces.extend(force);
            self.loads[body.0].couples.extend(couple);
        }
    }

    /// Takes what the joints of a group carry from the equations, and lays it off as the polygons of its links.
    pub fn by_numbers(&mut self, group: &Group) {
        let step = self.begin();
        self.finish(step, ForceStep::ByNumbers(group.bodies.clone()));
        let joints = self.mechanism().joints_of(group);
        for &joint in &joints {
            let carried = self.computed.joints[joint.0];
            let [_, second] = self.mechanism().joint(joint).bodies;
            let force = self.taken(joint, second, carried.force);
            self.joints.insert(joint, force);
            if let Some(slider) = self.mechanism().joint(joint).slider {
                let couple = carried.couple.high;
                if let Some(size) = self.writer.take(false, Sheet::Forces, NumberKind::Moment, couple) {
                    self.writer.construction.record.exact.numbers[size.0] = carried.couple;
                    self.couples.insert(slider, Couple { size, sign: 1.0 });
                }
            }
        }
        for &body in &group.bodies {
            let own = joints.iter().filter(|joint| self.mechanism().joint(**joint).bodies.contains(&body));
            let own: Vec<Force> = own.filter_map(|joint| self.on(*joint, body)).collect();
            let forces = [self.set(&[body]).forces, own].concat();
            if !forces.is_empty() {
                let mut chain = self.chain(&[body]);
                self.lay_off_all(&mut chain, &forces);
            }
        }
    }

    /// A joint's force from the equations; none for zero.
    fn taken(&mut self, joint: JointId, on: BodyId, force: Pair<Ball>) -> Option<Force> {
        let rounded = force.rounded();
        let own = self.mechanism().joint(joint);
        if !(own.holds_places() || own.rolls()) || self.is_nothing(force) {
            return None;
        }
        let size = self.writer.take(false, Sheet::Forces, NumberKind::Force, rounded.norm())?;
        self.writer.construction.record.exact.numbers[size.0] = force.dot(force).sqrt();
        let at = self.place(joint);
        let along = Along::given(unit(rounded)?);
        let of = Statics::part(joint, on, ForcePart::Whole);
        Some(Force { of, on, at, along, size, sign: 1.0, exact: Some(force) })
    }
}
