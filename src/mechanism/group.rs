use super::{BodyId, JointId, Mechanism, Role, StructureError};
use crate::scene::Scene;

/// The class of an Assur group, by the convention that class IV is two links carried by known
/// bodies and two closure links between them (one closed contour of four).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Fourth class.
    Fourth,
}

impl Class {
    /// The Roman numeral.
    #[must_use]
    pub fn numeral(self) -> &'static str {
        match self {
            Class::Fourth => "IV",
        }
    }
}

/// An Assur group: links whose motion follows from the bodies that it hangs on.
#[derive(Clone, Debug)]
pub struct Group {
    /// Its class.
    pub class: Class,
    /// Its links. Fourth class: drag link, closure link, drag link, closure link (2, 3, 4, 5 of the paper).
    pub links: Vec<BodyId>,
    /// Its independent loops, two unknown rates each.
    pub loops: Vec<Loop>,
    /// Its special points.
    pub special: Vec<SpecialPoint>,
}

/// A chain of joints from one known body to another.
///
/// `bodies[i]` and `bodies[i + 1]` meet in `joints[i]`; the first and the last body are known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// Known body, links of the group, known body.
    pub bodies: Vec<BodyId>,
    /// The joints between them.
    pub joints: Vec<JointId>,
}

/// The special (Assur) point of a link: where the cut lines of two of its legs cross.
#[derive(Clone, Debug)]
pub struct SpecialPoint {
    /// Its name: `S` and the link's name.
    pub name: String,
    /// The link to which it belongs.
    pub link: BodyId,
    /// The two legs by which the link hangs on known bodies.
    pub legs: [Leg; 2],
}

/// A way from a known body to a link: known body, outer joint, carrying link, inner joint, link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leg {
    /// The known body.
    pub base: BodyId,
    /// Joint between the known body and the carrying link.
    pub outer: JointId,
    /// The carrying link.
    pub carrier: BodyId,
    /// Joint between the carrying link and the link.
    pub inner: JointId,
}

/// Patterns of the joints B C D E F G (R revolute, P prismatic) whose equations are singular in every position.
const SINGULAR_PATTERNS: [&str; 10] = [
    "RPPRPP", "RPPPPP", "PRRPPP", "PRPPPP", "PPRPPP", "PPPRPP", "PPPPRR", "PPPPRP", "PPPPPR",
    "PPPPPP",
];

impl Group {
    /// The kinds of the joints, in the order in which the loops meet them: for the fourth class B C D E F G.
    #[must_use]
    pub fn pattern(&self, mechanism: &Mechanism) -> String {
        let letter = |&j: &JointId| {
            if mechanism.is_prismatic(j) { 'P' } else { 'R' }
        };
        let inner = self.loops[1].joints[1..3].iter().rev();
        self.loops[0]
            .joints
            .iter()
            .chain(inner)
            .map(letter)
            .collect()
    }

    /// Names of the links, as in `2, 3, 4, 5`.
    #[must_use]
    pub fn link_names(&self, mechanism: &Mechanism) -> String {
        let names = self.links.iter().map(|&l| mechanism.body(l).name.as_str());
        names.collect::<Vec<_>>().join(", ")
    }
}

/// The fourth-class group that the member links of `mechanism` form.
///
/// # Errors
/// Says what the links form instead, where they form no such group.
pub(super) fn fourth_class(scene: &Scene, mechanism: &Mechanism) -> Result<Group, StructureError> {
    let members: Vec<BodyId> = (0..mechanism.bodies.len())
        .map(BodyId)
        .filter(|&b| mechanism.body(b).role == Role::Member)
        .collect();
    let touching = |b: BodyId| {
        (0..mechanism.joints.len())
            .map(JointId)
            .filter(move |&j| mechanism.joint(j).bodies.contains(&b))
    };
    let known = |b: BodyId| mechanism.body(b).role.is_known();
    let outer_of = |b: BodyId| -> Vec<JointId> {
        touching(b)
            .filter(|&j| known(mechanism.joint(j).other(b)))
            .collect()
    };
    let (drags, closures): (Vec<BodyId>, Vec<BodyId>) =
        members.iter().partition(|&&b| !outer_of(b).is_empty());
    let joints: usize = (0..mechanism.joints.len())
        .filter(|&j| {
            let bodies = mechanism.joints[j].bodies;
            bodies.iter().any(|b| members.contains(b))
        })
        .count();
    let refuse = || StructureError::not_fourth_class(scene, mechanism, &members, joints);

    let ([first, second], [third, fourth]) = (drags.as_slice(), closures.as_slice()) else {
        return Err(refuse());
    };
    let outer = |b: BodyId| match outer_of(b).as_slice() {
        [one] => Ok(*one),
        _ => Err(refuse()),
    };
    let (first_outer, second_outer) = (outer(*first)?, outer(*second)?);
    let between = |a: BodyId, b: BodyId| {
        let common: Vec<JointId> = touching(a)
            .filter(|&j| mechanism.joint(j).bodies.contains(&b))
            .collect();
        match common.as_slice() {
            [one] => Ok(*one),
            _ => Err(refuse()),
        }
    };
    let mut loops = Vec::new();
    let mut special = Vec::new();
    for &closure in [third, fourth] {
        let (near, far) = (between(*first, closure)?, between(closure, *second)?);
        let start = mechanism.joint(first_outer).other(*first);
        let end = mechanism.joint(second_outer).other(*second);
        loops.push(Loop {
            bodies: vec![start, *first, closure, *second, end],
            joints: vec![first_outer, near, far, second_outer],
        });
        let leg = |base, outer, carrier, inner| Leg {
            base,
            outer,
            carrier,
            inner,
        };
        special.push(SpecialPoint {
            name: format!("S{}", mechanism.body(closure).name),
            link: closure,
            legs: [
                leg(start, first_outer, *first, near),
                leg(end, second_outer, *second, far),
            ],
        });
    }
    if joints != 6 {
        return Err(refuse());
    }
    let group = Group {
        class: Class::Fourth,
        links: vec![*first, *third, *second, *fourth],
        loops,
        special,
    };
    let pattern = group.pattern(mechanism);
    if SINGULAR_PATTERNS.contains(&pattern.as_str()) {
        return Err(StructureError::Singular {
            links: group.link_names(mechanism),
            pattern,
        });
    }
    Ok(group)
}
