use super::{BodyId, DrivenSlide, JointId, Mechanism, PointId};

/// The class of an Assur group, by the convention that two links make class II, four links with a central link that hangs on
/// three others class III, and four links in a closed contour, two of them on known bodies, class IV.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Two links: a dyad.
    Second,
    /// A central link and three legs.
    Third,
    /// Two drag links and two closure links.
    Fourth,
    /// Anything larger, or joined in another way.
    Higher,
}

impl Class {
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

/// An Assur group: links whose motion follows from the bodies that it hangs on.
#[derive(Clone, Debug)]
pub struct Group {
    /// Its class.
    pub class: Class,
    /// Its links. Class III: first leg, central link, the other legs. Class IV: drag link, closure link, drag link, closure link
    /// (2, 3, 4, 5 of the source paper). Links that driven sliders join count as one, of which the lead stands here.
    pub links: Vec<BodyId>,
    /// All its links one by one: after each lead those that driven sliders push from it.
    pub bodies: Vec<BodyId>,
    /// Its joints, outer ones included.
    pub joints: Vec<JointId>,
    /// Its independent loops, two unknown rates each.
    pub loops: Vec<Loop>,
    /// The points by which its plans are drawn: special points, or for a dyad its inner joint.
    pub special: Vec<SpecialPoint>,
}

/// A chain of joints from one known body to another, or around a closed contour from a link back to it.
///
/// `bodies[i]` and `bodies[i + 1]` meet in `joints[i]`; for a compound link its lead stands here, whichever of its links the joint
/// touches.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// Known body, links of the group, known body; or a link, others, the same link.
    pub bodies: Vec<BodyId>,
    /// The joints between them.
    pub joints: Vec<JointId>,
    /// Whether it runs around a closed contour within the group.
    pub closed: bool,
}

/// A point of a link that two legs lead to from known bodies: its motion is where two rays cross.
#[derive(Clone, Debug)]
pub struct SpecialPoint {
    /// Its name, as in `S3`; for a dyad that of the joint, or of the link's point under it, as in `B_3`.
    pub name: String,
    /// The link to which it belongs, of a compound link the very one.
    pub link: BodyId,
    /// The joint at which it is; none for a special (Assur) point, which is where the cut lines of the legs cross.
    pub target: Option<PointId>,
    /// The two legs by which the link hangs on known bodies.
    pub legs: [Leg; 2],
}

/// A way from a known body to a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leg {
    /// The known body.
    pub base: BodyId,
    /// The joint on the known body.
    pub outer: JointId,
    /// The carrying link and its joint with the link; none where the link itself hangs on the known body.
    pub carried: Option<Carried>,
}

impl Leg {
    /// The driven sliders within the carrying link, from its outer to its inner joint.
    #[must_use]
    pub fn carrier_slides(&self, mechanism: &Mechanism) -> Vec<DrivenSlide> {
        let Some(Carried { carrier, inner }) = self.carried else {
            return Vec::new();
        };
        let [from, to] = [self.outer, inner].map(|joint| mechanism.side(joint, carrier));
        mechanism.way(from, to)
    }
}

/// The second half of a leg.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Carried {
    /// The carrying link, between known body and link; of a compound link its lead.
    pub carrier: BodyId,
    /// The joint between carrying link and link.
    pub inner: JointId,
}

/// Patterns of the joints B C D E F G (R revolute, P prismatic) of a fourth-class group whose equations are singular in every
/// position.
const SINGULAR_PATTERNS: [&str; 10] =
    ["RPPRPP", "RPPPPP", "PRRPPP", "PRPPPP", "PPRPPP", "PPPRPP", "PPPPRR", "PPPPRP", "PPPPPR", "PPPPPP"];

impl Group {
    /// The kinds of the joints, R revolute or P prismatic. Class II: outer, inner, outer. Class III: outer and inner of each leg,
    /// separated by `-`. Class IV: B C D E F G. Higher: outer joints first.
    #[must_use]
    pub fn pattern(&self, mechanism: &Mechanism) -> String {
        let letter = |&j: &JointId| mechanism.joint(j).letter;
        let joints = |k: usize| self.loops[k].joints.iter();
        match self.class {
            Class::Second => joints(0).map(letter).collect(),
            Class::Third => {
                let legs = self.legs();
                let legs = legs.map(|[outer, inner]| [letter(&outer), letter(&inner)].iter().collect());
                legs.collect::<Vec<String>>().join("-")
            }
            Class::Fourth => joints(0).chain(joints(1).rev().skip(1).take(2)).map(letter).collect(),
            Class::Higher => self.joints.iter().map(letter).collect(),
        }
    }

    /// How links that no loop passes hang on bodies whose motion is known by then: joint, that body and the link, one after another.
    #[must_use]
    pub fn hanging(&self, mechanism: &Mechanism) -> Vec<(JointId, BodyId, BodyId)> {
        let mut placed: Vec<BodyId> = self.loops.iter().flat_map(|l| &l.bodies).copied().collect();
        let mut found = Vec::new();
        let holding = || self.joints.iter().filter(|&&joint| mechanism.joint(joint).holds_places());
        while let Some(next) = holding().find_map(|&joint| {
            let is_there = |b: BodyId| !self.links.contains(&b) || placed.contains(&b);
            let [a, b] = mechanism.joint(joint).bodies.map(|body| match mechanism.lead(body) {
                lead if self.links.contains(&lead) => lead,
                _ => body,
            });
            match (is_there(a), is_there(b)) {
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

    /// Outer and inner joint of each leg of a third-class group.
    fn legs(&self) -> impl Iterator<Item = [JointId; 2]> {
        let chain = |k: usize| &self.loops[k].joints;
        [[chain(0)[0], chain(0)[1]], [chain(0)[3], chain(0)[2]], [chain(1)[3], chain(1)[2]]].into_iter()
    }

    /// Names of the links, as in `2, 3, 4, 5`; of a compound link all, as in `2+3`.
    #[must_use]
    pub fn link_names(&self, mechanism: &Mechanism) -> String {
        let names = self.links.iter().map(|&l| mechanism.compound_name(l));
        // A carriage has none.
        let names = names.filter(|name| !name.is_empty());
        names.collect::<Vec<_>>().join(", ")
    }

    /// Whether its joints leave it without a definite motion in every position.
    #[must_use]
    pub(super) fn is_singular_by_structure(&self, mechanism: &Mechanism) -> bool {
        let pattern = self.pattern(mechanism);
        match self.class {
            Class::Second => pattern == "PPP",
            // Two legs that each fix the central link's angle.
            Class::Third => pattern.matches("PP").count() >= 2,
            Class::Fourth => SINGULAR_PATTERNS.contains(&pattern.as_str()),
            Class::Higher => false,
        }
    }
}
