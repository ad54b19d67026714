//! Equilibrium of every link, group by group from the last one to the first, then of the driven links.

use super::acting::{LoadList, Wrench, about};
use super::carried::{Carried, Forces};
use super::friction::{Resisting, as_loads, resisting};
use super::{Counted, Posed};
use crate::geometry::{Equations, Pair};
use crate::mechanism::{BodyId, GROUND, Group, Joint, JointId, Mechanism, Role, Rolling};
use smallvec::{SmallVec, smallvec};

/// What an unknown of the equations is.
#[derive(Clone, Debug)]
enum Unknown<N> {
    /// A part of what a joint carries: a force on its second body at the joint's place, or a couple.
    Joint(JointId, Part<N>),
    /// The torque of a drive.
    Torque(BodyId),
}

#[derive(Clone, Debug)]
enum Part<N> {
    /// Of a pin's force in this direction, with the couples of friction that it brings in joints of the pin.
    Pin(Pair<N>, SmallVec<[(JointId, N); 1]>),
    /// Across a guide in this direction, with the friction along the guide that it brings.
    Across(Pair<N>, Pair<N>),
    /// The force of a drive along its guide.
    Push(Pair<N>),
    /// By the relation of angles that the joint keeps.
    Couple,
    /// Between the teeth of wheels, or of a wheel and a rack, on the first body.
    Tooth(Tooth<N>),
}

/// Where teeth touch.
#[derive(Clone, Copy, Debug)]
struct Tooth<N> {
    /// The pitch point.
    at: Pair<N>,
    /// The unit vector along which the tangential force on the first body counts.
    tangent: Pair<N>,
    /// The unit vector in which the teeth push the first body away.
    apart: Pair<N>,
    /// The tangent of the pressure angle; none where the teeth do not push.
    slope: Option<N>,
    /// What the teeth push the first body away with, by the tangential force.
    push: Pair<N>,
}

/// How often forces that lean are found anew before friction counts as locking; most are found in three or four times.
const MOST_TIMES: usize = 60;
/// How often the room around balls is widened until they hold a solution.
const MOST_ROOMS: usize = 12;

/// What the joints carry, so that all links are in equilibrium; `None` where a group leaves it open.
pub(super) fn carried<N: Counted>(mechanism: &Mechanism, posed: &impl Posed<N>, list: &LoadList) -> Option<Forces<N>> {
    let acting = list.acting(posed)?;
    let mut balance = Balance {
        mechanism,
        posed,
        about: mechanism.body_ids().map(|body| about(mechanism, posed, body)).collect(),
        loads: vec![Wrench::default(); mechanism.bodies.len()],
        resisting: resisting(mechanism, posed, list),
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
    for Cut { bodies, joints } in cuts(mechanism, list) {
        balance.solve(&bodies, &joints)?;
    }
    let frame = balance.loads[GROUND.0];
    let friction = list.friction.iter().map(|&(joint, _)| (joint, balance.found.joints[joint.0].friction));
    let acting = acting.into_iter().chain(as_loads(mechanism, posed, friction)).collect();
    Some(Forces { acting, frame, ..balance.found })
}

/// Bodies that are cut free together.
struct Cut {
    bodies: Vec<BodyId>,
    joints: Vec<JointId>,
}

/// What is cut free, one after the other: the groups, the last one first, and the driven bodies.
///
/// Where a pin rubs that is fixed in another body than that at which its joints are, the friction of each joint depends on what others carry: all
/// that it joins is cut free together.
fn cuts(mechanism: &Mechanism, list: &LoadList) -> Vec<Cut> {
    let of_group = |group: &Group| Cut { bodies: group.bodies.clone(), joints: mechanism.joints_of(group) };
    let of_driven = |body| Cut { bodies: vec![body], joints: own_joint(mechanism, body).into_iter().collect() };
    let groups = mechanism.groups.iter().rev().map(of_group);
    let mut cuts: Vec<Cut> = groups.chain(driven(mechanism).into_iter().map(of_driven)).collect();
    for &(joint, _) in list.friction.iter().filter(|(joint, _)| mechanism.is_fixed_elsewhere(*joint)) {
        let pin = mechanism.joint(joint).pin;
        let is_at_pin = |cut: &Cut| cut.joints.iter().any(|&own| mechanism.joint(own).pin == pin);
        if let (Some(first), Some(last)) = (cuts.iter().position(is_at_pin), cuts.iter().rposition(is_at_pin)) {
            let (mut bodies, mut joints) = (Vec::new(), Vec::new());
            for cut in cuts.drain(first..=last) {
                bodies.extend(cut.bodies);
                joints.extend(cut.joints);
            }
            cuts.insert(first, Cut { bodies, joints });
        }
    }
    cuts
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
    /// By joint: what resists its motion; empty without friction.
    resisting: Vec<Option<Resisting<N>>>,
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
        let mut found = self.solved(bodies, &unknowns, &[])?;
        if unknowns.iter().any(|unknown| self.leans(unknown)) {
            found = self.leaning(bodies, &mut unknowns, found)?;
        }
        self.hand_on(bodies, &unknowns, found);
        Some(())
    }

    /// Whether a force brings another one with it: friction, or what pushes teeth apart.
    fn leans(&self, unknown: &Unknown<N>) -> bool {
        match unknown {
            Unknown::Joint(_, Part::Tooth(tooth)) => tooth.slope.is_some(),
            Unknown::Joint(joint, Part::Pin(..) | Part::Across(..)) => {
                self.resisting.get(joint.0).is_some_and(Option::is_some)
            }
            _ => false,
        }
    }

    /// The forces with what they bring with them, from those without; `None` where friction locks, and where no bound is proved.
    ///
    /// What they bring hangs on their directions and signs alone, so that the solution with those of the last one is a step of
    /// Newton's. Balls that hold all that comes of what is within them hold a solution, by Brouwer's theorem.
    fn leaning(&self, bodies: &[BodyId], unknowns: &mut [Unknown<N>], mut found: Vec<N>) -> Option<Vec<N>> {
        let mut is_settled = false;
        for _ in 0..MOST_TIMES {
            let rounded: Vec<N> = found.iter().map(|number| number.rounded()).collect();
            self.lean(unknowns, &rounded);
            let next = self.solved(bodies, unknowns, &[])?;
            is_settled = N::are_settled(&found, &next);
            found = next;
            if is_settled {
                break;
            }
        }
        if !is_settled {
            return None;
        }
        for _ in 0..MOST_ROOMS {
            let largest = found.iter().fold(N::default(), |largest, &x| largest.larger(x).larger(-x));
            let room: Vec<N> = found.iter().map(|number| number.roomier(largest)).collect();
            self.lean(unknowns, &room);
            found = self.solved(bodies, unknowns, &self.beside(unknowns, &room))?;
            if found.iter().zip(room).all(|(number, room)| number.is_within(room)) {
                return Some(found);
            }
        }
        None
    }

    /// +1 if the force of a pin's joint acts on the second of the bodies between which another joint of the pin rubs, −1 if its reaction does;
    /// `None` if neither.
    fn share(&self, joint: JointId, rubbing: JointId) -> Option<N> {
        let [_, body] = self.mechanism.rubbing_bodies(rubbing);
        let (joint, rubbing) = (self.mechanism.joint(joint), self.mechanism.joint(rubbing));
        let side = joint.bodies.iter().position(|&own| own == body).filter(|_| joint.pin == rubbing.pin)?;
        Some(N::from([-1, 1][side]))
    }

    /// What rubs at a joint of a pin: the force with which the pin acts on the second body.
    fn of_pin(&self, unknowns: &[Unknown<N>], found: &[N], joint: JointId) -> Pair<N> {
        let parts = unknowns.iter().zip(found).filter_map(|(unknown, &x)| match unknown {
            Unknown::Joint(own, Part::Pin(along, _)) => Some(*along * (self.share(*own, joint)? * x)),
            _ => None,
        });
        parts.fold(Pair::default(), |sum, part| sum + part)
    }

    /// By joint: the couple of friction on the second body that is beside that of a pin's force as it leans, while it may be anywhere within
    /// its bounds.
    fn beside(&self, unknowns: &[Unknown<N>], found: &[N]) -> Vec<(JointId, N)> {
        let beside = |(joint, by_size)| (joint, by_size * N::beyond_way(self.of_pin(unknowns, found, joint)));
        self.couples().map(beside).collect()
    }

    /// The joints of pins that rub, with the couples by the sizes of what rubs.
    fn couples(&self) -> impl Iterator<Item = (JointId, N)> {
        self.resisting.iter().enumerate().filter_map(|(joint, resisting)| match resisting {
            Some(Resisting::Couple(by_size)) => Some((JointId(joint), *by_size)),
            _ => None,
        })
    }

    /// Makes forces lean as these ask for.
    fn lean(&self, unknowns: &mut [Unknown<N>], found: &[N]) {
        // The couples by the components of what rubs, along its way.
        let by_parts = |(joint, by_size)| (joint, N::way(self.of_pin(unknowns, found, joint)) * by_size);
        let by_parts: Vec<(JointId, Pair<N>)> = self.couples().map(by_parts).collect();
        for (unknown, &x) in unknowns.iter_mut().zip(found) {
            let Unknown::Joint(joint, part) = unknown else { continue };
            match (part, self.resisting.get(joint.0).copied().flatten()) {
                (Part::Pin(along, couples), Some(Resisting::Couple(_))) => {
                    let of = |&(rubbing, by_parts): &(JointId, Pair<N>)| {
                        Some((rubbing, by_parts.dot(*along) * self.share(*joint, rubbing)?))
                    };
                    *couples = by_parts.iter().filter_map(of).collect();
                }
                (Part::Across(_, friction), Some(Resisting::Along(by_size))) => {
                    *friction = by_size * x.sense(N::default());
                }
                (Part::Tooth(tooth), _) => {
                    if let Some(slope) = tooth.slope {
                        tooth.push = tooth.apart * (slope * x.sense(N::default()));
                    }
                }
                _ => {}
            }
        }
    }

    /// The unknowns that keep these bodies in equilibrium; `beside` has couples on the second bodies of joints.
    fn solved(&self, bodies: &[BodyId], unknowns: &[Unknown<N>], beside: &[(JointId, N)]) -> Option<Vec<N>> {
        let mut equations = Equations::new(3 * bodies.len(), bodies.len());
        let row = |body: BodyId| bodies.iter().position(|&own| own == body);
        for (column, unknown) in unknowns.iter().enumerate() {
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
        for &(joint, couple) in beside {
            for (body, couple) in self.mechanism.rubbing_bodies(joint).into_iter().zip([-couple, couple]) {
                if let Some(row) = row(body) {
                    equations.add_right(2 * bodies.len() + row, -couple);
                }
            }
        }
        equations.solved()
    }

    /// Notes what is found, and hands it on to the bodies on which these hang.
    fn hand_on(&mut self, bodies: &[BodyId], unknowns: &[Unknown<N>], found: Vec<N>) {
        for (unknown, x) in unknowns.iter().zip(found) {
            for (body, wrench) in self.acts(unknown) {
                if !bodies.contains(&body) {
                    self.loads[body.0].add(wrench.times(x));
                }
            }
            match *unknown {
                Unknown::Torque(body) => self.found.torques[body.0] = x,
                Unknown::Joint(joint, Part::Pin(along, ref couples)) => {
                    let carried = &mut self.found.joints[joint.0];
                    carried.force = carried.force.plus_scaled(along, x);
                    for &(rubbing, couple) in couples {
                        let friction = &mut self.found.joints[rubbing.0].friction;
                        friction.moment = friction.moment + couple * x;
                    }
                }
                Unknown::Joint(joint, Part::Across(along, friction)) => {
                    let carried = &mut self.found.joints[joint.0];
                    carried.force = carried.force.plus_scaled(along, x);
                    carried.friction.force = friction * x;
                }
                Unknown::Joint(joint, Part::Push(along)) => {
                    let carried = &mut self.found.joints[joint.0];
                    carried.force = carried.force.plus_scaled(along, x);
                }
                Unknown::Joint(joint, Part::Couple) => self.found.joints[joint.0].couple = x,
                Unknown::Joint(joint, Part::Tooth(tooth)) => {
                    let carried = &mut self.found.joints[joint.0];
                    carried.force = carried.force - (tooth.tangent + tooth.push) * x;
                    carried.tangential = x;
                }
            }
        }
    }

    /// Where the teeth of a joint touch; `None` of other joints.
    fn tooth(&self, joint: &Joint) -> Option<Tooth<N>> {
        let rolling = joint.rolling()?;
        let at = rolling.point(
            |point| self.posed.place(point),
            |slider| self.posed.guide(slider),
            |number| self.posed.given(number),
        );
        // Pushing apart: wheels along their line of centres, a ring away from its centre.
        let (outwards, apart, pressure) = match rolling {
            Rolling::Wheels(pitch) => {
                let [first, second] = pitch.centers.map(|center| self.posed.place(center));
                let way = second - first;
                let outwards = way * (N::from(1) / way.dot(way).sqrt());
                let has_ring = pitch.teeth.iter().any(|teeth| *teeth < 0);
                (outwards, if has_ring { outwards } else { -outwards }, pitch.pressure_deg)
            }
            Rolling::Rack(rack) => {
                let outwards =
                    self.posed.guide(rack.slider).quarter_turn() * N::from(if rack.side < 0.0 { 1 } else { -1 });
                (outwards, if rack.wheel == 0 { -outwards } else { outwards }, rack.pressure_deg)
            }
        };
        let slope = (pressure > 0.0).then(|| self.posed.given(pressure).tangent_and_sine()[0]);
        Some(Tooth { at, tangent: outwards.quarter_turn(), apart, slope, push: Pair::default() })
    }

    /// The unknowns of a joint: one for each freedom that it takes away, with the force of its drive.
    fn parts(&self, id: JointId) -> SmallVec<[Unknown<N>; 3]> {
        let joint = self.mechanism.joint(id);
        let mut parts: SmallVec<[Part<N>; 3]> = SmallVec::new();
        if joint.pin.is_some() {
            let [one, none] = [1, 0].map(N::from);
            parts.push(Part::Pin(Pair { x: one, y: none }, SmallVec::new()));
            parts.push(Part::Pin(Pair { x: none, y: one }, SmallVec::new()));
        }
        if let Some(slider) = joint.slider {
            let along = self.posed.guide(slider);
            parts.push(Part::Across(along.quarter_turn(), Pair::default()));
            if self.mechanism.slider(slider).drive.is_some() {
                parts.push(Part::Push(along));
            }
        }
        match self.tooth(joint) {
            Some(tooth) => parts.push(Part::Tooth(tooth)),
            None if joint.angular.is_some() => parts.push(Part::Couple),
            None => {}
        }
        parts.into_iter().map(|part| Unknown::Joint(id, part)).collect()
    }

    /// What an unknown of size 1 does to which bodies.
    fn acts(&self, unknown: &Unknown<N>) -> SmallVec<[(BodyId, Wrench<N>); 3]> {
        let couple = |weight: i32| Wrench { force: Pair::default(), moment: weight.into() };
        match *unknown {
            Unknown::Torque(body) => smallvec![(body, couple(1)), (GROUND, couple(-1))],
            Unknown::Joint(joint, Part::Couple) => {
                let angular = self.mechanism.joint(joint).angular.iter();
                let terms = angular.flat_map(|angular| &angular.terms);
                terms.map(|&(body, weight)| (body, couple(weight))).collect()
            }
            Unknown::Joint(joint, Part::Tooth(Tooth { at, tangent, push, .. })) => {
                self.on_both(joint, at, -(tangent + push))
            }
            Unknown::Joint(joint, ref part) => {
                let at = self.posed.place(self.mechanism.joint_point(joint));
                match *part {
                    Part::Pin(along, ref couples) => {
                        let mut acts = self.on_both(joint, at, along);
                        for &(rubbing, moment) in couples {
                            let [first, second] = self.mechanism.rubbing_bodies(rubbing);
                            let couple = |moment| Wrench { force: Pair::default(), moment };
                            acts.extend([(first, couple(-moment)), (second, couple(moment))]);
                        }
                        acts
                    }
                    Part::Across(along, friction) => self.on_both(joint, at, along + friction),
                    Part::Push(along) => self.on_both(joint, at, along),
                    Part::Couple | Part::Tooth(_) => SmallVec::new(),
                }
            }
        }
    }

    /// A force at a place on the second body of a joint, and its opposite on the first.
    fn on_both(&self, joint: JointId, at: Pair<N>, force: Pair<N>) -> SmallVec<[(BodyId, Wrench<N>); 3]> {
        let [first, second] = self.mechanism.joint(joint).bodies;
        let on =
            |body: BodyId, force: Pair<N>| (body, Wrench { force, moment: (at - self.about[body.0]).cross(force) });
        smallvec![on(first, -force), on(second, force)]
    }
}
