use super::{AngularConstraint, BodyId, DrivenSlide, JointId, Mechanism, PointId};
use crate::words::Language;
use std::collections::VecDeque;

/// The class of an Assur group: class II has two links; class III four, a central link on three legs; class IV four in
/// a closed contour, two of them on known bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// Two links: a dyad.
    Second,
    /// A central link and three legs.
    Third,
    /// Two drag links, which hang on known bodies, and two closure links between them.
    Fourth,
    /// More links, another way to join them, or joints of other than two constraints.
    Higher,
}

impl Class {
    /// The Roman numeral, or the word for a higher class.
    #[must_use]
    pub fn in_words(self, language: &Language) -> &str {
        match self {
            Class::Higher => language.higher(),
            other => other.numeral(),
        }
    }

    /// The Roman numeral.
    #[must_use]
    pub fn numeral(self) -> &'static str {
        match self {
            Class::Second => "II",
            Class::Third => "III",
            Class::Fourth => "IV",
            Class::Higher => "higher",
        }
    }
}

/// An Assur group: links whose motion follows from that of the bodies on which they hang.
#[derive(Clone, Debug)]
pub struct Group {
    /// Its class.
    pub class: Class,
    /// Its links. Class III: first leg, central link, the other legs. Class IV: drag link, closure link, drag link,
    /// closure link (2, 3, 4, 5 of the source paper). Of a compound link the lead.
    pub links: Vec<BodyId>,
    /// All its bodies: after each lead the links that driven sliders push from it.
    pub bodies: Vec<BodyId>,
    /// Its joints, with those on known bodies.
    pub joints: Vec<JointId>,
    /// Its independent loops.
    pub loops: Vec<Loop>,
    /// The points by which its plans are drawn: special points, or for a dyad its inner joint; none for a higher class.
    pub special: Vec<SpecialPoint>,
}

/// A chain of joints from one known body to another, or around a closed contour within the group.
///
/// `bodies[i]` and `bodies[i + 1]` meet in `joints[i]`. Of a compound link the lead is listed, whichever of its links
/// the joint touches.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// Known body, links of the group, known body; in a closed contour links only, of which the first is also the last.
    pub bodies: Vec<BodyId>,
    /// The joints between them.
    pub joints: Vec<JointId>,
    /// Whether it runs around a closed contour within the group.
    pub closed: bool,
}

/// A point of a link on which two legs from known bodies meet: the image of the point is the crossing of two rays.
#[derive(Clone, Debug)]
pub struct SpecialPoint {
    /// Its name, as `S3`; for a dyad that of the inner joint, or of the point of a link that coincides with an outer
    /// pin, as `B_3`.
    pub name: String,
    /// The link to which it belongs; within a compound link that very link, not the lead.
    pub link: BodyId,
    /// The joint where it lies; `None` for a special (Assur) point, which is the crossing of the cut lines of its legs.
    pub target: Option<PointId>,
    /// The two legs by which the link hangs on known bodies.
    pub legs: [Leg; 2],
}

/// The joints from a known body to a link, over one other link at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leg {
    /// The known body.
    pub base: BodyId,
    /// The joint on the known body.
    pub outer: JointId,
    /// The carrying link and its joint with the link; `None` where the link itself hangs on the known body.
    pub carried: Option<Carried>,
}

impl Leg {
    /// The driven sliders within the carrying link, from its outer to its inner joint; none for a leg without a
    /// carrying link.
    pub(crate) fn carrier_slides(&self, mechanism: &Mechanism) -> Vec<DrivenSlide> {
        let Some(Carried { carrier, inner }) = self.carried else {
            return Vec::new();
        };
        let [from, to] = [self.outer, inner].map(|joint| mechanism.side(joint, carrier));
        mechanism.slides_between(from, to)
    }
}

/// The carrying link of a leg.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Carried {
    /// The link between the known body and the link of the leg; of a compound link its lead.
    pub carrier: BodyId,
    /// The joint between the carrying link and the link of the leg.
    pub inner: JointId,
}

/// Patterns of the joints B C D E F G of a group of class IV whose equations are singular in every position.
const SINGULAR_PATTERNS: [&str; 10] =
    ["RPPRPP", "RPPPPP", "PRRPPP", "PRPPPP", "PPRPPP", "PPPRPP", "PPPPRR", "PPPPRP", "PPPPPR", "PPPPPP"];

impl Group {
    /// The kinds of the joints, R revolute or P prismatic. Class II: outer, inner, outer. Class III: outer and inner of
    /// each leg, with `-` between legs. Class IV: B C D E F G of the source paper. Higher classes: in the order of
    /// `joints`.
    #[must_use]
    pub fn pattern(&self, mechanism: &Mechanism) -> String {
        let letter = |&j: &JointId| mechanism.joint(j).letter;
        let joints = |k: usize| self.loops[k].joints.iter();
        match self.class {
            Class::Second => joints(0).map(letter).collect(),
            Class::Third => {
                let legs = self.legs().map(|[outer, inner]| [letter(&outer), letter(&inner)].iter().collect());
                legs.collect::<Vec<String>>().join("-")
            }
            Class::Fourth => joints(0).chain(joints(1).rev().skip(1).take(2)).map(letter).collect(),
            Class::Higher => self.joints.iter().map(letter).collect(),
        }
    }

    /// The links that no loop passes, each as the joint that places it, the body at that joint whose place is found
    /// before, and the link; in an order in which they can be placed.
    pub(crate) fn hanging(&self, mechanism: &Mechanism) -> Vec<(JointId, BodyId, BodyId)> {
        let mut placed: Vec<BodyId> = self.loops.iter().flat_map(|l| &l.bodies).copied().collect();
        let mut found = Vec::new();
        let holding = || self.joints.iter().filter(|&&joint| mechanism.joint(joint).holds_places());
        while let Some(next) = holding().find_map(|&joint| {
            let is_placed = |b: BodyId| !self.links.contains(&b) || placed.contains(&b);
            let [a, b] = ends(mechanism, &self.links, joint);
            match (is_placed(a), is_placed(b)) {
                (true, false) => Some((joint, a, b)),
                (false, true) => Some((joint, b, a)),
                _ => None,
            }
        }) {
            placed.push(next.2);
            found.push(next);
        }
        found
    }

    /// The relations between angles that need an equation of their own: all but constant angles between two bodies.
    pub(crate) fn gears<'a>(&'a self, mechanism: &'a Mechanism) -> impl Iterator<Item = &'a AngularConstraint> {
        let angular = self.joints.iter().filter_map(|&joint| mechanism.joint(joint).angular.as_ref());
        angular.filter(|angular| angular.as_fixed_angle().is_none())
    }

    /// Outer and inner joint of each leg of a group of class III.
    fn legs(&self) -> impl Iterator<Item = [JointId; 2]> {
        let chain = |k: usize| &self.loops[k].joints;
        [[chain(0)[0], chain(0)[1]], [chain(0)[3], chain(0)[2]], [chain(1)[3], chain(1)[2]]].into_iter()
    }

    /// Names of the links, as `2, 3, 4, 5`; of a compound link all, as `2+3`.
    #[must_use]
    pub fn link_names(&self, mechanism: &Mechanism) -> String {
        let name = |&lead: &BodyId| {
            let names = mechanism.compound(lead).into_iter().map(|body| mechanism.body(body).name.as_str());
            names.collect::<Vec<_>>().join("+")
        };
        // The carriage of a `Placing` has no name.
        self.links.iter().map(name).filter(|name| !name.is_empty()).collect::<Vec<_>>().join(", ")
    }

    /// Whether the kinds of its joints make its equations singular in every position.
    pub(super) fn is_singular_by_structure(&self, mechanism: &Mechanism) -> bool {
        let pattern = self.pattern(mechanism);
        match self.class {
            Class::Second => pattern == "PPP",
            // Two legs each fix the angle of the central link.
            Class::Third => pattern.matches("PP").count() >= 2,
            Class::Fourth => SINGULAR_PATTERNS.contains(&pattern.as_str()),
            Class::Higher => false,
        }
    }
}

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

/// The bodies that a joint joins; for compound links of the group of these links the leads.
fn ends(mechanism: &Mechanism, links: &[BodyId], joint: JointId) -> [BodyId; 2] {
    mechanism.joint(joint).bodies.map(|body| match mechanism.lead(body) {
        lead if links.contains(&lead) => lead,
        _ => body,
    })
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

    /// The body at the other end of the joint from `link`; `None` if the joint does not touch `link`.
    fn other(&self, joint: JointId, link: BodyId) -> Option<BodyId> {
        match ends(self.mechanism, self.links, joint) {
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
                let [a, b] = ends(self.mechanism, self.links, j).map(branch);
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
        let of = |chain: &Loop| {
            // Both loops of class III go over the central link, and each is named after its legs; those of class IV go over a
            // closure link each.
            let link = chain.bodies[2];
            let named = if class == Class::Third { vec![chain.bodies[1], chain.bodies[3]] } else { vec![link] };
            let name: String = named.into_iter().map(|body| self.mechanism.body(body).name.as_str()).collect();
            SpecialPoint { name: format!("S{name}"), link, target: None, legs: [leg(chain, false), leg(chain, true)] }
        };
        match (class, loops) {
            (Class::Second, [chain]) => self.dyad_point(chain).into_iter().collect(),
            (Class::Third | Class::Fourth, chains) => chains.iter().map(of).collect(),
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
