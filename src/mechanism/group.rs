use super::{AngularConstraint, BodyId, DrivenSlide, JointId, Mechanism, PointId};
use crate::words::Language;

/// The class of an Assur group: class II has two links; class III four, a central link on three legs; class IV four in
/// a closed contour, two of them on known bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    #[must_use]
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
    #[must_use]
    pub(crate) fn hanging(&self, mechanism: &Mechanism) -> Vec<(JointId, BodyId, BodyId)> {
        let mut placed: Vec<BodyId> = self.loops.iter().flat_map(|l| &l.bodies).copied().collect();
        let mut found = Vec::new();
        let holding = || self.joints.iter().filter(|&&joint| mechanism.joint(joint).holds_places());
        while let Some(next) = holding().find_map(|&joint| {
            let is_placed = |b: BodyId| !self.links.contains(&b) || placed.contains(&b);
            let [a, b] = mechanism.joint(joint).bodies.map(|body| match mechanism.lead(body) {
                lead if self.links.contains(&lead) => lead,
                _ => body,
            });
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
        let names = self.links.iter().map(|&l| mechanism.compound_name(l));
        // The carriage of a `Placing` has no name.
        let names = names.filter(|name| !name.is_empty());
        names.collect::<Vec<_>>().join(", ")
    }

    /// Whether the kinds of its joints make its equations singular in every position.
    #[must_use]
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
