use super::name::{normal_name, point_on};
use crate::geometry::{Crossing, Line, Place, quarter_turn};
use crate::mechanism::{BodyId, DrivenSlide, Group, JointKind, Leg, Mechanism, PointId, SliderId, SpecialPoint};
use crate::position::Pose;
use crate::words::Wording;

/// The kinds of a leg's joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LegKind {
    /// The link itself hangs on the known body by a pin.
    Pin {
        /// The pin K.
        outer: PointId,
    },
    /// The link itself slides on the known body; the cut line runs normal to the guide, through the point looked for.
    Slider {
        /// The slider.
        outer: SliderId,
        /// The point looked for.
        at: PointId,
    },
    /// A carrying link with two pins: the cut line runs through both.
    Pins {
        /// Outer joint K.
        outer: PointId,
        /// Inner joint J.
        inner: PointId,
    },
    /// Outer revolute, inner prismatic: the cut line runs through the pin, normal to the guide.
    PinThenSlider {
        /// Outer joint K.
        outer: PointId,
        /// Inner joint.
        inner: SliderId,
    },
    /// Outer prismatic, inner revolute: likewise.
    SliderThenPin {
        /// Outer joint.
        outer: SliderId,
        /// Inner joint J.
        inner: PointId,
    },
    /// Both prismatic: the cut line is at infinity, the link turns as its base does.
    Sliders,
}

/// The cut line of a leg: the line along which the motion of the link is known whatever the carrying link does.
#[derive(Clone, Debug)]
pub struct CutLine {
    /// The leg.
    pub leg: Leg,
    /// Its joints.
    pub kind: LegKind,
    /// The line.
    pub line: Line,
    /// The carrying link, or the link itself where it hangs on the known body.
    pub carrier: BodyId,
    /// The driven sliders within its compound links, from the outer joint to the point looked for: what they add is known.
    pub slides: Vec<DrivenSlide>,
}

impl CutLine {
    /// The cut line of a leg of `point`; at infinity where two joints of the leg coincide and give no direction.
    #[must_use]
    pub fn new(mechanism: &Mechanism, pose: &Pose, point: &SpecialPoint, leg: &Leg) -> Self {
        let outer = mechanism.joint(leg.outer).kind;
        let inner = leg.carried.map(|c| mechanism.joint(c.inner).kind);
        let kind = match (outer, inner, point.target) {
            (JointKind::Revolute(outer), None, _) => LegKind::Pin { outer },
            (JointKind::Prismatic(outer), None, Some(at)) => LegKind::Slider { outer, at },
            (JointKind::Revolute(outer), Some(JointKind::Revolute(inner)), _) => LegKind::Pins { outer, inner },
            (JointKind::Revolute(outer), Some(JointKind::Prismatic(inner)), _) => {
                LegKind::PinThenSlider { outer, inner }
            }
            (JointKind::Prismatic(outer), Some(JointKind::Revolute(inner)), _) => {
                LegKind::SliderThenPin { outer, inner }
            }
            (JointKind::Prismatic(_), _, _) => LegKind::Sliders,
        };
        let line = match kind {
            LegKind::Pin { outer } => {
                point.target.and_then(|target| Line::new(pose.point(outer), pose.arm(outer, target)))
            }
            LegKind::Pins { outer, inner } => Line::new(pose.point(outer), pose.arm(outer, inner)),
            LegKind::PinThenSlider { outer: pin, inner: slider }
            | LegKind::SliderThenPin { outer: slider, inner: pin }
            | LegKind::Slider { outer: slider, at: pin } => {
                Line::new(pose.point(pin), quarter_turn(pose.guide(slider)))
            }
            LegKind::Sliders => None,
        };
        Self {
            leg: *leg,
            kind,
            line: line.unwrap_or(Line::AtInfinity),
            carrier: leg.carried.map_or(point.link, |c| c.carrier),
            slides: driven_slides(mechanism, point, leg),
        }
    }

    /// The point from which the plan's ray starts: the outer pin, or the inner one where the outer joint is prismatic.
    #[must_use]
    pub fn start(&self) -> Option<PointId> {
        match self.kind {
            LegKind::Pin { outer } | LegKind::Pins { outer, .. } | LegKind::PinThenSlider { outer, .. } => Some(outer),
            LegKind::SliderThenPin { inner: point, .. } | LegKind::Slider { at: point, .. } => Some(point),
            LegKind::Sliders => None,
        }
    }

    /// Name of the line, as in `BC`, or `the normal to the guide of 3/2 through B`.
    #[must_use]
    pub fn name(&self, words: &Wording, mechanism: &Mechanism, point: &str) -> String {
        let name = |p: PointId| mechanism.point_name(p);
        match self.kind {
            LegKind::Pin { outer } => format!("{}{point}", name(outer)),
            LegKind::Pins { outer, inner } => format!("{}{}", name(outer), name(inner)),
            LegKind::PinThenSlider { outer: pin, inner: slider }
            | LegKind::SliderThenPin { outer: slider, inner: pin }
            | LegKind::Slider { outer: slider, at: pin } => {
                let guide = mechanism.slider_name(slider);
                words.language.normal_to_guide(&guide, name(pin))
            }
            LegKind::Sliders => words.language.line_at_infinity().to_owned(),
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
