use crate::geometry::{Crossing, Line, Place, quarter_turn};
use crate::mechanism::{BodyId, Group, JointKind, Leg, Mechanism, PointId, SliderId};
use crate::position::Pose;

/// The kinds of a leg's outer and inner joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LegKind {
    /// Both revolute: the cut line runs through both.
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
#[derive(Clone, Copy, Debug)]
pub struct CutLine {
    /// The leg.
    pub leg: Leg,
    /// Its joints.
    pub kind: LegKind,
    /// The line.
    pub line: Line,
}

impl CutLine {
    /// The cut line of `leg`; at infinity where two joints of the leg coincide and give no direction.
    #[must_use]
    pub fn new(mechanism: &Mechanism, pose: &Pose, leg: &Leg) -> Self {
        let kind = match (
            mechanism.joint(leg.outer).kind,
            mechanism.joint(leg.inner).kind,
        ) {
            (JointKind::Revolute(outer), JointKind::Revolute(inner)) => {
                LegKind::Pins { outer, inner }
            }
            (JointKind::Revolute(outer), JointKind::Prismatic(inner)) => {
                LegKind::PinThenSlider { outer, inner }
            }
            (JointKind::Prismatic(outer), JointKind::Revolute(inner)) => {
                LegKind::SliderThenPin { outer, inner }
            }
            (JointKind::Prismatic(_), JointKind::Prismatic(_)) => LegKind::Sliders,
        };
        let line = match kind {
            LegKind::Pins { outer, inner } => Line::new(pose.point(outer), pose.arm(outer, inner)),
            LegKind::PinThenSlider {
                outer: pin,
                inner: slider,
            }
            | LegKind::SliderThenPin {
                outer: slider,
                inner: pin,
            } => Line::new(pose.point(pin), quarter_turn(pose.guide(slider))),
            LegKind::Sliders => None,
        };
        Self {
            leg: *leg,
            kind,
            line: line.unwrap_or(Line::AtInfinity),
        }
    }

    /// The joint from which the plan's ray starts: the outer pin, or the inner one where the outer joint is prismatic.
    #[must_use]
    pub fn start(&self) -> Option<PointId> {
        match self.kind {
            LegKind::Pins { outer, .. } | LegKind::PinThenSlider { outer, .. } => Some(outer),
            LegKind::SliderThenPin { inner, .. } => Some(inner),
            LegKind::Sliders => None,
        }
    }

    /// Name of the line, as in `BC`, or `the normal to the guide of 3/2 through B`.
    #[must_use]
    pub fn name(&self, mechanism: &Mechanism) -> String {
        let name = |p: PointId| mechanism.point_name(p);
        match self.kind {
            LegKind::Pins { outer, inner } => format!("{}{}", name(outer), name(inner)),
            LegKind::PinThenSlider {
                outer: pin,
                inner: slider,
            }
            | LegKind::SliderThenPin {
                outer: slider,
                inner: pin,
            } => {
                let guide = mechanism.slider_name(slider);
                format!("the normal to the guide of {guide} through {}", name(pin))
            }
            LegKind::Sliders => "the line at infinity".to_owned(),
        }
    }
}

/// A special (Assur) point: where the cut lines of two legs cross.
#[derive(Clone, Debug)]
pub struct Special {
    /// Its name, as in `S3`.
    pub name: String,
    /// The link to which it belongs.
    pub link: BodyId,
    /// The two cut lines.
    pub cuts: [CutLine; 2],
    /// Their crossing, with its sine.
    pub crossing: Crossing,
    /// Where it is.
    pub place: Place,
}

/// The special points of `group`.
#[must_use]
pub fn special_points(mechanism: &Mechanism, pose: &Pose, group: &Group) -> Vec<Special> {
    let points = group.special.iter().map(|point| {
        let cuts = point.legs.map(|leg| CutLine::new(mechanism, pose, &leg));
        let crossing = cuts[0].line.crossing(&cuts[1].line);
        Special {
            name: point.name.clone(),
            link: point.link,
            cuts,
            crossing,
            place: crossing.place(),
        }
    });
    points.collect()
}
