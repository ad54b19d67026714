use super::name::{coriolis_name, image_name, normal_name, point_on};
use crate::geometry::{Crossing, Line, Place, quarter_turn};
use crate::mechanism::{BodyId, Carried, DrivenSlide, Joint, Leg, Mechanism, PointId, SliderId, SpecialPoint};
use crate::position::Pose;
use crate::words::Wording;
use smallvec::{SmallVec, smallvec};

/// Index of a special point (or a dyad's inner joint) in the mechanism, group by group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SpecialId(pub usize);

/// Contribution of a joint of a leg to the motion of the sought point.
///
/// The sum of the contributions is the velocity's component along the ray, and so the segment that is measured on the
/// ray (Eqs. 7, 8, 15, 16 and 35 to 38 of Quintero et al., 2011).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Term {
    /// Rotation of a link: its angular rate times the length from one joint to another; none stands for the sought
    /// point.
    Turn {
        /// The link.
        link: BodyId,
        /// From this joint …
        from: PointId,
        /// … to this one.
        to: Option<PointId>,
    },
    /// Sliding along a guide, which the leg passes from the base on: the slider's rate.
    Slide(DrivenSlide),
}

/// Course of a cut line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Through two joints; none in second place stands for the sought point.
    Through(PointId, Option<PointId>),
    /// Through a joint, normal to the guide of a slider.
    Normal(SliderId, PointId),
    /// At infinity: both joints of the leg are prismatic, and the link turns as its base does.
    AtInfinity,
}

/// The cut line of a leg: the velocity component along it is known for the link's points on it, whatever the rate of
/// the carrying link.
#[derive(Clone, Debug)]
pub struct CutLine {
    /// The leg.
    pub leg: Leg,
    /// The course of the line.
    pub course: Course,
    /// The line; at infinity also where the leg's two points coincide and give no direction.
    pub line: Line,
    /// Contributions to the motion of the sought point, from the base on.
    pub terms: SmallVec<[Term; 2]>,
    /// The carrying link, or the link itself where it is joined to the base directly.
    pub carrier: BodyId,
    /// The driven sliders within the leg's compound links, from the outer joint to the sought point: their rates are
    /// given.
    pub slides: Vec<DrivenSlide>,
}

impl CutLine {
    /// The cut line of leg `leg` of `point`.
    #[must_use]
    pub fn new(mechanism: &Mechanism, pose: &Pose, point: &SpecialPoint, leg: &Leg) -> Self {
        let carrier = leg.carried.map_or(point.link, |c| c.carrier);
        // The joints of the leg, each with the body before it and the body after it, from the base on.
        let joints: SmallVec<[(BodyId, &Joint, BodyId); 2]> = match leg.carried {
            None => smallvec![(leg.base, mechanism.joint(leg.outer), point.link)],
            Some(Carried { carrier, inner }) => smallvec![
                (leg.base, mechanism.joint(leg.outer), carrier),
                (carrier, mechanism.joint(inner), point.link)
            ],
        };
        let pin = |index: usize| joints.get(index).and_then(|(_, joint, _)| joint.pin);
        let sliders: SmallVec<[SliderId; 2]> = joints.iter().filter_map(|(_, joint, _)| joint.slider).collect();
        let course = match sliders.as_slice() {
            [] => pin(0).map(|from| Course::Through(from, pin(1))),
            [slider] => pin(0).or(pin(1)).or(point.target).map(|at| Course::Normal(*slider, at)),
            _ => None,
        };
        let course = course.unwrap_or(Course::AtInfinity);
        let term = |(index, &(left, joint, entered)): (usize, &(BodyId, &Joint, BodyId))| {
            let turn = joint.pin.map(|from| Term::Turn { link: entered, from, to: pin(index + 1) });
            let slide = |slider: SliderId| {
                let (ends, sign) = (mechanism.slider(slider), mechanism.slide_sign(slider, left));
                Term::Slide(DrivenSlide { slider, from: left, to: if sign > 0.0 { ends.link } else { ends.on }, sign })
            };
            turn.or(joint.slider.map(slide))
        };
        let terms = match course {
            Course::AtInfinity => SmallVec::new(),
            _ => joints.iter().enumerate().filter_map(term).collect(),
        };
        let line = match course {
            Course::Through(from, to) => {
                to.or(point.target).and_then(|to| Line::new(pose.point(from), pose.arm(from, to)))
            }
            Course::Normal(slider, at) => Line::new(pose.point(at), quarter_turn(pose.guide(slider))),
            Course::AtInfinity => None,
        };
        // The driven sliders of the carrying link, then those of the link itself up to the sought point.
        let last = mechanism.side(leg.carried.map_or(leg.outer, |c| c.inner), mechanism.lead(point.link));
        let mut slides = leg.carrier_slides(mechanism);
        slides.extend(mechanism.slides_between(last, point.link));
        Self { leg: *leg, course, line: line.unwrap_or(Line::AtInfinity), terms, carrier, slides }
    }

    /// The slider to whose guide the line is normal, if it is a slider's.
    #[must_use]
    pub fn guide(&self) -> Option<SliderId> {
        match self.course {
            Course::Normal(slider, _) => Some(slider),
            Course::Through(..) | Course::AtInfinity => None,
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

    /// The slider that the leg passes, from the base on, other than driven ones.
    #[must_use]
    pub fn slide(&self) -> Option<DrivenSlide> {
        self.terms.iter().find_map(|term| match *term {
            Term::Slide(slide) => Some(slide),
            Term::Turn { .. } => None,
        })
    }

    /// The joint from which the length to the sought point is measured; none where no equation contains it.
    pub(super) fn measured_from(&self) -> Option<PointId> {
        self.terms.iter().find_map(|term| match term {
            Term::Turn { from, to: None, .. } => Some(*from),
            _ => None,
        })
    }

    /// Name of the line, as in `BC`, or `the normal to the guide of 3/2 through B`; `point` is the name of the sought
    /// point.
    #[must_use]
    pub fn name(&self, words: &Wording, mechanism: &Mechanism, point: &str) -> String {
        let name = |p: PointId| mechanism.point_name(p);
        match self.course {
            Course::Through(from, to) => format!("{}{}", name(from), to.map_or(point, name)),
            Course::Normal(slider, at) => {
                words.language.normal_to_guide(&mechanism.slider_in_words(slider, words), name(at))
            }
            Course::AtInfinity => words.language.line_at_infinity().to_owned(),
        }
    }
}

/// A point of a link found by two legs: a special (Assur) point, the crossing of their cut lines, or a dyad's inner
/// joint.
#[derive(Clone, Debug)]
pub struct Special {
    /// Its name, as in `S3`.
    pub name: String,
    /// Its group, by its index in the mechanism.
    pub group: usize,
    /// Whether it is a special (Assur) point, not a joint.
    pub is_assur: bool,
    /// The joint, where it is not a special (Assur) point.
    pub target: Option<PointId>,
    /// The link to which it belongs.
    pub link: BodyId,
    /// The two cut lines.
    pub cuts: [CutLine; 2],
    /// The crossing of the cut lines, with the sine of their angle.
    pub crossing: Crossing,
    /// Its place on the scheme, finite or at infinity.
    pub place: Place,
}

impl Special {
    /// Names of the ends of the normal parts of both legs, as in `n_b3`; where both legs start from the same point, the
    /// second name has a prime.
    pub(crate) fn normal_names(&self, mechanism: &Mechanism) -> [String; 2] {
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

    /// Name of the end of the Coriolis acceleration of the slider in a leg, as in `k_a3`: laid off from the image of A,
    /// of a slider that leads to link 3. Empty for a leg without a slider.
    pub(crate) fn coriolis_name(&self, mechanism: &Mechanism, side: usize) -> String {
        let cut = &self.cuts[side];
        let start = cut.start().map(|point| image_name(&point_on(mechanism, cut.leg.base, point)));
        let entered = cut.slide().map(|slide| mechanism.body(slide.to).name.as_str());
        start.zip(entered).map(|(start, entered)| coriolis_name(&start, entered)).unwrap_or_default()
    }
}

/// The special points (and dyads' inner joints) by which the plans of a group are drawn.
pub(super) fn special_points(mechanism: &Mechanism, pose: &Pose, index: usize) -> Vec<Special> {
    let points = mechanism.groups[index].special.iter().map(|point| {
        let cuts = point.legs.map(|leg| CutLine::new(mechanism, pose, point, &leg));
        let mut crossing = cuts[0].line.crossing(&cuts[1].line);
        if let Some(target) = point.target {
            crossing = crossing.at(pose.point(target));
        }
        Special {
            is_assur: point.target.is_none(),
            target: point.target,
            name: point.name.clone(),
            group: index,
            link: point.link,
            cuts,
            crossing,
            place: crossing.place(),
        }
    });
    points.collect()
}
