use super::name::{normal_name, point_on};
use crate::geometry::{Crossing, Line, Place, quarter_turn};
use crate::mechanism::{BodyId, DrivenSlide, Group, JointKind, Leg, Mechanism, PointId, SliderId, SpecialPoint};
use crate::position::Pose;
use crate::words::Wording;
use smallvec::SmallVec;

/// Index of a special point (or a dyad's joint) among all of a mechanism, group by group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SpecialId(pub usize);

/// What a leg adds to the motion of the point that it leads to.
///
/// A velocity's part along the ray is the sum of these; so is the segment that is measured there (Eqs. 7, 8, 15, 16 and 35 to 38 of Quintero et al.,
/// 2011).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// A link turns: its rate of rotation times the length from one point to another, none for the point looked for.
    Turn {
        /// The link.
        link: BodyId,
        /// From this joint …
        from: PointId,
        /// … to this one.
        to: Option<PointId>,
    },
    /// A slider slides: its rate along the guide.
    Slide {
        /// The slider.
        slider: SliderId,
        /// The body that the way leaves, with which the guide turns.
        from: BodyId,
    },
}

/// How a cut line runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Through two joints; none in second place means the point looked for.
    Through(PointId, Option<PointId>),
    /// Through a joint, normal to the guide of a slider.
    Normal(SliderId, PointId),
    /// At infinity: both joints of the leg slide, and the link turns as its base does.
    AtInfinity,
}

/// The cut line of a leg: the line along which the motion of the link is known whatever the carrying link does.
#[derive(Clone, Debug)]
pub struct CutLine {
    /// The leg.
    pub leg: Leg,
    /// How the line runs.
    pub course: Course,
    /// The line; at infinity, too, where two joints of the leg coincide and give no direction.
    pub line: Line,
    /// What the leg adds to the motion of the point looked for, in order.
    pub terms: SmallVec<[Term; 2]>,
    /// The carrying link, or the link itself where it hangs on the known body.
    pub carrier: BodyId,
    /// The driven sliders within its compound links, from the outer joint to the point looked for: what they add is known.
    pub slides: Vec<DrivenSlide>,
}

impl CutLine {
    /// The cut line of a leg of `point`.
    #[must_use]
    pub fn new(mechanism: &Mechanism, pose: &Pose, point: &SpecialPoint, leg: &Leg) -> Self {
        use JointKind::{Prismatic, Revolute};
        let outer = mechanism.joint(leg.outer).kind;
        let inner = leg.carried.map(|c| mechanism.joint(c.inner).kind);
        let carrier = leg.carried.map_or(point.link, |c| c.carrier);
        let turn = |link, from, to| Term::Turn { link, from, to };
        let slide = |slider, from| Term::Slide { slider, from };
        let (course, terms) = match (outer, inner, point.target) {
            // The link itself hangs on the known body by a pin, or slides on it.
            (Revolute(pin), None, Some(_)) => (Course::Through(pin, None), [Some(turn(point.link, pin, None)), None]),
            (Prismatic(slider), None, Some(at)) => (Course::Normal(slider, at), [Some(slide(slider, leg.base)), None]),
            // A carrying link joins it to the known body.
            (Revolute(outer), Some(Revolute(inner)), _) => {
                let terms = [turn(carrier, outer, Some(inner)), turn(point.link, inner, None)];
                (Course::Through(outer, Some(inner)), terms.map(Some))
            }
            (Revolute(pin), Some(Prismatic(slider)), _) => {
                (Course::Normal(slider, pin), [turn(carrier, pin, None), slide(slider, carrier)].map(Some))
            }
            (Prismatic(slider), Some(Revolute(pin)), _) => {
                (Course::Normal(slider, pin), [slide(slider, leg.base), turn(point.link, pin, None)].map(Some))
            }
            (Prismatic(_), Some(Prismatic(_)), _) | (_, None, None) => (Course::AtInfinity, [None; 2]),
        };
        let line = match course {
            Course::Through(from, to) => {
                to.or(point.target).and_then(|to| Line::new(pose.point(from), pose.arm(from, to)))
            }
            Course::Normal(slider, at) => Line::new(pose.point(at), quarter_turn(pose.guide(slider))),
            Course::AtInfinity => None,
        };
        Self {
            leg: *leg,
            course,
            line: line.unwrap_or(Line::AtInfinity),
            terms: terms.into_iter().flatten().collect(),
            carrier,
            slides: driven_slides(mechanism, point, leg),
        }
    }

    /// The point from which the plan's ray starts: the outer pin, or the inner one where the outer joint is prismatic.
    #[must_use]
    pub fn start(&self) -> Option<PointId> {
        match self.course {
            Course::Through(point, _) | Course::Normal(_, point) => Some(point),
            Course::AtInfinity => None,
        }
    }

    /// The joint from which the length to the point looked for is measured, where one enters an equation.
    #[must_use]
    pub fn measured_from(&self) -> Option<PointId> {
        self.terms.iter().find_map(|term| match term {
            Term::Turn { from, to: None, .. } => Some(*from),
            _ => None,
        })
    }

    /// Name of the line, as in `BC`, or `the normal to the guide of 3/2 through B`; `point` is the name of the point looked for.
    #[must_use]
    pub fn name(&self, words: &Wording, mechanism: &Mechanism, point: &str) -> String {
        let name = |p: PointId| mechanism.point_name(p);
        match self.course {
            Course::Through(from, to) => format!("{}{}", name(from), to.map_or(point, name)),
            Course::Normal(slider, at) => words.language.normal_to_guide(&mechanism.slider_name(slider), name(at)),
            Course::AtInfinity => words.language.line_at_infinity().to_owned(),
        }
    }
}

/// The driven sliders of a leg: those of the carrying link, then those of the link itself up to the point looked for.
fn driven_slides(mechanism: &Mechanism, point: &SpecialPoint, leg: &Leg) -> Vec<DrivenSlide> {
    let link = mechanism.lead(point.link);
    let mut slides = leg.carrier_slides(mechanism);
    let last = leg.carried.map_or(leg.outer, |carried| carried.inner);
    slides.extend(mechanism.way(mechanism.side(last, link), point.link));
    slides
}

/// A point of a link found by two legs: a special (Assur) point, where their cut lines cross, or a dyad's joint.
#[derive(Clone, Debug)]
pub struct Special {
    /// Its name, as in `S3`.
    pub name: String,
    /// Whether it is a special (Assur) point, not a joint.
    pub is_assur: bool,
    /// The joint at which it is, where it is not a special (Assur) point.
    pub target: Option<PointId>,
    /// The link to which it belongs.
    pub link: BodyId,
    /// The two cut lines.
    pub cuts: [CutLine; 2],
    /// Their crossing, with its sine.
    pub crossing: Crossing,
    /// Where it is.
    pub place: Place,
}

impl Special {
    /// The ends of the normal parts on both legs, as in `n_b3`; a prime tells two apart that start from one point.
    #[must_use]
    pub fn normal_names(&self, mechanism: &Mechanism) -> [String; 2] {
        let name = |cut: &CutLine| {
            let start = cut.start().map(|point| point_on(mechanism, cut.leg.base, point));
            normal_name(&start.unwrap_or_default(), &self.name)
        };
        let [first, mut second] = [0, 1].map(|side| name(&self.cuts[side]));
        if first == second {
            second = second.replacen('_', "'_", 1);
        }
        [first, second]
    }
}

/// The points by which the plans of `group` are drawn.
#[must_use]
pub fn special_points(mechanism: &Mechanism, pose: &Pose, group: &Group) -> Vec<Special> {
    let points = group.special.iter().map(|point| {
        let cuts = point.legs.map(|leg| CutLine::new(mechanism, pose, point, &leg));
        let mut crossing = cuts[0].line.crossing(&cuts[1].line);
        if let Some(target) = point.target {
            crossing = crossing.at(pose.point(target));
        }
        Special {
            is_assur: point.target.is_none(),
            target: point.target,
            name: point.name.clone(),
            link: point.link,
            cuts,
            crossing,
            place: crossing.place(),
        }
    });
    points.collect()
}
