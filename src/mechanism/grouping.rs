//! Makes a group of its links and joints: class, loops, special points.

use super::{BodyId, Carried, Class, Group, JointId, Leg, Loop, Mechanism, SpecialPoint};
use std::collections::VecDeque;

/// The group that `links`, of compound links the leads, form with `joints`; all other bodies count as known.
pub(super) fn group(mechanism: &Mechanism, links: &[BodyId], joints: &[JointId]) -> Group {
    let holding: Vec<JointId> = joints.iter().copied().filter(|&j| mechanism.joint(j).holds_places()).collect();
    let builder = Builder { mechanism, links, joints: &holding };
    let loops = builder.loops();
    let outer = |b: &&BodyId| builder.outer(**b).is_some();
    let hanging = links.iter().filter(outer).count();
    // Three bars pinned to a triangle are rigid. As part of four links they give a loop of another length, and no class
    // III or IV.
    let three_links_each = loops.iter().all(|l| l.bodies.len() == 5);
    // Classes II to IV are defined for joints of two constraints.
    let is_plain = joints.iter().all(|&j| mechanism.joint(j).constraints() == 2);
    let class = match (links.len(), hanging) {
        (2, _) if is_plain => Class::Second,
        (4, 3) if is_plain && three_links_each => Class::Third,
        (4, 2) if is_plain && three_links_each => Class::Fourth,
        _ => Class::Higher,
    };
    let special = builder.special(class, &loops);
    let mut ordered = Vec::new();
    for body in loops.iter().flat_map(|l| &l.bodies).chain(links) {
        if links.contains(body) && !ordered.contains(body) {
            ordered.push(*body);
        }
    }
    let compounds = ordered.iter().map(|&lead| mechanism.compound(lead));
    Group { class, bodies: compounds.flatten().collect(), links: ordered, joints: joints.to_vec(), loops, special }
}

struct Builder<'a> {
    mechanism: &'a Mechanism,
    links: &'a [BodyId],
    /// The joints of the group that constrain places: pins and sliders.
    joints: &'a [JointId],
}

impl Builder<'_> {
    fn is_known(&self, body: BodyId) -> bool {
        !self.links.contains(&body)
    }

    /// The bodies that a joint joins; for compound links of the group the leads.
    fn ends(&self, joint: JointId) -> [BodyId; 2] {
        let bodies = self.mechanism.joint(joint).bodies;
        bodies.map(|body| {
            let lead = self.mechanism.lead(body);
            if self.is_known(lead) { body } else { lead }
        })
    }

    /// The body at the other end of the joint from `link`; `None` if the joint does not touch `link`.
    fn other(&self, joint: JointId, link: BodyId) -> Option<BodyId> {
        match self.ends(joint) {
            [a, b] if a == link => Some(b),
            [a, b] if b == link => Some(a),
            _ => None,
        }
    }

    /// The first joint by which a link hangs on a known body, and that body.
    fn outer(&self, link: BodyId) -> Option<(JointId, BodyId)> {
        self.joints.iter().find_map(|&j| {
            let other = self.other(j, link).filter(|b| self.is_known(*b));
            Some((j, other?))
        })
    }

    /// The loops: for each joint outside a spanning tree that grows from the known bodies, the two branches from that
    /// joint back to known bodies.
    fn loops(&self) -> Vec<Loop> {
        // Each link in the order in which the tree reaches it, the joint over which and the body from which.
        let mut reached: Vec<(BodyId, JointId, BodyId)> = Vec::new();
        let mut used: Vec<JointId> = Vec::new();
        let mut queue: VecDeque<BodyId> = VecDeque::new();
        for &link in self.links {
            if let Some((joint, base)) = self.outer(link) {
                reached.push((link, joint, base));
                used.push(joint);
                queue.push_back(link);
            }
        }
        while let Some(body) = queue.pop_front() {
            for &j in self.joints {
                let Some(other) = self.other(j, body) else {
                    continue;
                };
                if !self.is_known(other) && !reached.iter().any(|r| r.0 == other) {
                    reached.push((other, j, body));
                    used.push(j);
                    queue.push_back(other);
                }
            }
        }
        let branch = |mut body: BodyId| {
            let mut bodies = vec![body];
            let mut joints = Vec::new();
            while let Some((_, joint, from)) = reached.iter().find(|r| r.0 == body) {
                joints.push(*joint);
                bodies.push(*from);
                body = *from;
            }
            (bodies, joints)
        };
        let outside = self.joints.iter().filter(|j| !used.contains(j));
        let mut loops: Vec<Loop> = outside
            .map(|&j| {
                let [a, b] = self.ends(j).map(branch);
                // The loop starts with the branch whose first link the tree reached first.
                let root = |(bodies, _): &(Vec<BodyId>, Vec<JointId>)| {
                    let root = bodies.iter().rev().nth(1);
                    reached.iter().position(|r| Some(&r.0) == root)
                };
                let (a, b) = if root(&a) <= root(&b) { (a, b) } else { (b, a) };
                closed_by(a, j, b)
            })
            .collect();
        // Ordered by the inner links as in the scene; a closed contour comes after the loops that lead to its first
        // link.
        loops.sort_by_key(|l| {
            let inner = l.bodies.iter().filter(|b| self.outer(**b).is_none() && !self.is_known(**b));
            let closes_on = reached.iter().position(|r| r.0 == l.bodies[0]);
            (closes_on, inner.min().copied())
        });
        loops
    }

    fn special(&self, class: Class, loops: &[Loop]) -> Vec<SpecialPoint> {
        let name = |b: BodyId| self.mechanism.body(b).name.clone();
        match (class, loops) {
            (Class::Second, [chain]) => self.dyad_point(chain).into_iter().collect(),
            (Class::Third, [first, second]) => {
                let central = first.bodies[2];
                let of = |chain: &Loop| {
                    let legs = [leg(chain, false), leg(chain, true)];
                    let [a, b] = [chain.bodies[1], chain.bodies[3]].map(name);
                    SpecialPoint { name: format!("S{a}{b}"), link: central, target: None, legs }
                };
                vec![of(first), of(second)]
            }
            (Class::Fourth, chains) => {
                let of = |chain: &Loop| SpecialPoint {
                    name: format!("S{}", name(chain.bodies[2])),
                    link: chain.bodies[2],
                    target: None,
                    legs: [leg(chain, false), leg(chain, true)],
                };
                chains.iter().map(of).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The point by which a dyad's plan is drawn: its inner pin; with an inner slider the point of one link that
    /// coincides with the outer pin of the other. `None` with three sliders.
    fn dyad_point(&self, chain: &Loop) -> Option<SpecialPoint> {
        let mechanism = self.mechanism;
        let pin = |j: JointId| mechanism.joint(j).pin;
        let [start, a, b, end] = *chain.bodies.as_slice() else {
            return None;
        };
        let [outer_a, inner, outer_b] = *chain.joints.as_slice() else {
            return None;
        };
        // The link of the point hangs on its base directly; the other link is the carrying link of the second leg.
        let legs = |direct: (BodyId, JointId), base: BodyId, outer: JointId, carrier: BodyId| {
            let direct = Leg { base: direct.0, outer: direct.1, carried: None };
            let carried = Some(Carried { carrier, inner });
            [direct, Leg { base, outer, carried }]
        };
        if let Some(point) = pin(inner) {
            return Some(SpecialPoint {
                name: mechanism.point_name(point).to_owned(),
                link: mechanism.side(inner, a),
                target: Some(point),
                legs: legs((start, outer_a), end, outer_b, b),
            });
        }
        // With an inner slider the outer pin of the sliding link is taken, as with a crank pin in a slot; the outer pin
        // of the guide's link if the sliding link slides at both ends.
        let slides = |link: BodyId| {
            mechanism.joint(inner).slider.is_some_and(|id| mechanism.lead(mechanism.slider(id).link) == link)
        };
        let choices = [
            (pin(outer_b), a, legs((start, outer_a), end, outer_b, b), slides(b)),
            (pin(outer_a), b, legs((end, outer_b), start, outer_a, a), slides(a)),
        ];
        let best = choices.iter().filter(|w| w.0.is_some()).max_by_key(|w| w.3)?;
        let (point, link) = (best.0?, mechanism.side(inner, best.1));
        Some(SpecialPoint {
            name: format!("{}_{}", mechanism.point_name(point), mechanism.body(link).name),
            link,
            target: Some(point),
            legs: best.2,
        })
    }
}

/// The leg at the start or at the end of a loop of three links.
fn leg(chain: &Loop, from_end: bool) -> Leg {
    let at = |forward: usize, backward: usize| if from_end { backward } else { forward };
    Leg {
        base: chain.bodies[at(0, 4)],
        outer: chain.joints[at(0, 3)],
        carried: Some(Carried { carrier: chain.bodies[at(1, 3)], inner: chain.joints[at(1, 2)] }),
    }
}

/// The loop made of two branches and the joint between their ends. The part that both branches share is left out; then
/// the loop is a closed contour.
fn closed_by(
    (mut bodies, mut joints): (Vec<BodyId>, Vec<JointId>),
    joint: JointId,
    (mut others, mut other_joints): (Vec<BodyId>, Vec<JointId>),
) -> Loop {
    let mut closed = false;
    while !joints.is_empty() && joints.last() == other_joints.last() {
        joints.pop();
        other_joints.pop();
        bodies.pop();
        others.pop();
        closed = true;
    }
    bodies.reverse();
    joints.reverse();
    bodies.append(&mut others);
    joints.push(joint);
    joints.append(&mut other_joints);
    Loop { bodies, joints, closed }
}
