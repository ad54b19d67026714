use super::closing::Assembled;
use super::frames::{Frames, LegJoint, pinned, placement_in_compound, placement_towards};
use super::legs::{LegCondition, joined_placements, placements, smallest_deviation};
use super::says;
use crate::geometry::{Placement, Vector, cross};
use crate::mechanism::{BodyId, Class, Group, JointId, Mechanism, SliderId};
use crate::message::Message;

/// Sine of the angle between guides below which they are parallel: degrees in files are rounded.
const PARALLEL: f64 = 1e-9;

/// A group as a planar parallel platform: rigid bodies a and b connected by legs, each a middle body with a joint to
/// either.
///
/// Third class: the fixed frame (with all known bodies, at rest for this purpose) and the central link, connected by
/// three legs. Fourth class: the two drag links, connected by the closure links and the fixed frame. Second class: the
/// fixed frame and one link, connected by a joint and, as a leg, by the other link.
pub(super) struct Platform<'a> {
    mechanism: &'a Mechanism,
    /// Body b, and body a where it is not the fixed frame.
    b: BodyId,
    a: Option<BodyId>,
    legs: Vec<[LegJoint; 2]>,
    /// By leg: its middle body, but for a last leg whose middle body is the fixed frame.
    middles: Vec<BodyId>,
    /// For a dyad: the joint between body b and the fixed frame.
    direct: Option<LegJoint>,
    names: Vec<String>,
    sliders: Vec<SliderId>,
}

impl<'a> Platform<'a> {
    /// The platform of a group of class II, III or IV; `None` for a higher class.
    pub(super) fn new(mechanism: &'a Mechanism, group: &Group, known: &Frames) -> Option<Platform<'a>> {
        let fixed = |body: BodyId| {
            let frame = known.of(body).copied();
            (body, frame.unwrap_or_else(Placement::identity))
        };
        // The link of a compound link at `joint`, with its placement in the compound's frame.
        let at_joint = |link: BodyId, joint: JointId| {
            let side = mechanism.side(joint, link);
            (side, placement_in_compound(mechanism, link, side))
        };
        // A leg along part of a loop: body a, joint, middle body, joint, body b.
        let leg_joint = |joint, side, middle| LegJoint::new(mechanism, joint, side, middle);
        let chain = |k: usize| &group.loops[k];
        let name = |[near, far]: [JointId; 2]| {
            let point = |j| mechanism.point_name(mechanism.joint_point(j));
            format!("{}{}", point(near), point(far))
        };
        let mut platform = Platform {
            mechanism,
            b: group.links[0],
            a: None,
            middles: Vec::new(),
            legs: Vec::new(),
            direct: None,
            names: Vec::new(),
            sliders: group.joints.iter().filter_map(|&j| mechanism.joint(j).slider).collect(),
        };
        let mut leg = |near: JointId, a, middle: BodyId, far: JointId, b| {
            let joints_of_leg = [leg_joint(near, a, at_joint(middle, near)), leg_joint(far, b, at_joint(middle, far))];
            platform.legs.push(joints_of_leg);
            platform.names.push(name([near, far]));
            platform.middles.push(middle);
        };
        match group.class {
            Class::Second => {
                let (bodies, joints) = (&chain(0).bodies, &chain(0).joints);
                // A link joined to a known body by a slider keeps its angle: it is body b, placed by a line or a
                // circle.
                let turns_alike = |joint: JointId| mechanism.joint(joint).angular.is_some();
                let from_end = turns_alike(joints[2]) && !turns_alike(joints[0]);
                let at = |forward: usize, backward: usize| if from_end { backward } else { forward };
                let (start, b) = (bodies[at(0, 3)], bodies[at(1, 2)]);
                let (middle, end) = (bodies[at(2, 1)], bodies[at(3, 0)]);
                let (near, far, direct) = (joints[at(2, 0)], joints[1], joints[at(0, 2)]);
                leg(near, fixed(end), middle, far, at_joint(b, far));
                platform.direct = Some(leg_joint(direct, at_joint(b, direct), fixed(start)));
                platform.b = b;
            }
            Class::Third => {
                let central = chain(0).bodies[2];
                for (k, from_end) in [(0, false), (0, true), (1, true)] {
                    let (bodies, joints) = (&chain(k).bodies, &chain(k).joints);
                    let at = |forward: usize, backward: usize| if from_end { backward } else { forward };
                    let (base, middle) = (bodies[at(0, 4)], bodies[at(1, 3)]);
                    let (outer, inner) = (joints[at(0, 3)], joints[at(1, 2)]);
                    leg(outer, fixed(base), middle, inner, at_joint(central, inner));
                }
                platform.b = central;
            }
            Class::Fourth => {
                let (a, b) = (chain(0).bodies[1], chain(0).bodies[3]);
                for k in 0..2 {
                    let (near, far) = (chain(k).joints[1], chain(k).joints[2]);
                    leg(near, at_joint(a, near), chain(k).bodies[2], far, at_joint(b, far));
                }
                let (bodies, joints) = (&chain(0).bodies, &chain(0).joints);
                let base = [
                    leg_joint(joints[0], at_joint(a, joints[0]), fixed(bodies[0])),
                    leg_joint(joints[3], at_joint(b, joints[3]), fixed(bodies[4])),
                ];
                platform.legs.push(base);
                platform.names.push(name([joints[0], joints[3]]));
                (platform.a, platform.b) = (Some(a), b);
            }
            Class::Higher => return None,
        }
        Some(platform)
    }

    fn conditions(&self) -> Vec<LegCondition> {
        self.legs.iter().map(|leg| condition(*leg)).collect()
    }

    /// Approximate assemblies, one for each solution of the legs' conditions.
    pub(super) fn starts(&self, known: &Frames, slides: &[f64]) -> Vec<Assembled> {
        let relative = match (&self.direct, self.conditions().as_slice()) {
            (Some(direct), &[condition]) => joined_placements(direct, condition),
            (None, &[first, second, third]) => placements([first, second, third]),
            _ => Vec::new(),
        };
        relative.iter().filter_map(|r| self.assembled(known, slides, r)).collect()
    }

    /// The frames of all bodies, for a placement of b in the frame of a.
    fn assembled(&self, known: &Frames, slides: &[f64], relative: &Placement) -> Option<Assembled> {
        let mut frames = known.clone();
        let mut frame_a = Placement::identity();
        if let Some(a) = self.a {
            // The middle body of the last leg is the fixed frame; its placement in the frame of a is known, the inverse
            // is sought.
            frame_a = middle(self.legs.last()?, relative)?.inverse();
            frames.set_compound(self.mechanism, a, frame_a);
        }
        frames.set_compound(self.mechanism, self.b, frame_a * relative);
        for (leg, body) in self.legs.iter().zip(&self.middles) {
            frames.set_compound(self.mechanism, *body, frame_a * middle(leg, relative)?);
        }
        let mut slides = slides.to_vec();
        for id in &self.sliders {
            slides[id.0] = frames.slide(self.mechanism, *id)?;
        }
        Some(Assembled { frames, slides, gap: f64::INFINITY })
    }

    /// The link between two parallel guides, which nothing holds along them.
    pub(super) fn on_parallel_guides(&self) -> Option<BodyId> {
        let is_parallel = |a: Vector, b: Vector| cross(a, b).abs() <= PARALLEL;
        // Of a dyad that may be the link on the fixed frame: both guides in its own frame.
        if let (Some(LegJoint::Slide { frame: at_a, along: a }), [[_, LegJoint::Slide { frame: at_b, along: b }]]) =
            (&self.direct, self.legs.as_slice())
            && is_parallel(at_a.rotation.inverse() * a, at_b.rotation.inverse() * b)
        {
            return Some(self.b);
        }
        let mut legs = self.legs.iter().zip(&self.middles);
        let between = legs.find(|(leg, _)| match leg {
            [LegJoint::Slide { along: a, .. }, LegJoint::Slide { along: b, .. }] => is_parallel(*a, *b),
            _ => false,
        });
        between.map(|(_, middle)| *middle)
    }

    /// The smallest distance by which the legs fail to meet, in words.
    pub(super) fn miss(&self) -> Message {
        match smallest_deviation(self.direct.as_ref(), &self.conditions()) {
            // Both circles are the same one.
            Some((_, 0.0)) => says::any_direction(),
            Some((leg, miss)) => {
                let by = if miss.abs() < 1e-3 { format!("{:.1e}", miss.abs()) } else { format!("{:.4}", miss.abs()) };
                let leg = &self.names[leg];
                if miss > 0.0 { says::longer(leg, by) } else { says::shorter(leg, by) }
            }
            None => says::never_meet(),
        }
    }
}

/// The condition that a leg with these joints imposes on body b in the frame of a.
fn condition([near, far]: [LegJoint; 2]) -> LegCondition {
    match (near, far) {
        (LegJoint::Pin { local: a, place: p }, LegJoint::Pin { local: b, place: q }) => {
            LegCondition::Distance { a, b, length: (q - p).norm() }
        }
        (LegJoint::Slide { frame, along }, LegJoint::Pin { local: b, place }) => {
            let inverse = frame.inverse();
            LegCondition::OnLineOfA { point: inverse * place, direction: inverse * along, b }
        }
        (LegJoint::Pin { local: a, place }, LegJoint::Slide { frame, along }) => {
            let inverse = frame.inverse();
            LegCondition::OnLineOfB { point: inverse * place, direction: inverse * along, a }
        }
        (LegJoint::Slide { frame: a, .. }, LegJoint::Slide { frame: b, .. }) => {
            LegCondition::Turned(a.rotation.inverse() * b.rotation)
        }
    }
}

/// Placement of the middle body in the frame of a, for a placement `relative` of b in the frame of a; `None` for
/// parallel guides.
fn middle([near, far]: &[LegJoint; 2], relative: &Placement) -> Option<Placement> {
    match (near, far) {
        (LegJoint::Pin { local: a, place: p }, LegJoint::Pin { local: b, place: q }) => {
            Some(placement_towards(*p, *q, *a, relative * b))
        }
        (LegJoint::Slide { frame, .. }, LegJoint::Pin { local: b, place }) => {
            Some(pinned(frame.rotation.inverse(), *place, relative * b))
        }
        (LegJoint::Pin { local: a, place }, LegJoint::Slide { frame, .. }) => {
            let turn = relative.rotation * frame.rotation.inverse();
            Some(pinned(turn, *place, *a))
        }
        (LegJoint::Slide { frame: fa, along: ua }, LegJoint::Slide { frame: fb, along: ub }) => {
            // In the middle frame a is at fa + s ua and b at fb + t ub; b is at `relative` in the frame of a.
            let (from, to) = (fa.translation.vector, fb.translation.vector);
            let gap = to - from - fa.rotation * relative.translation.vector;
            let s = cross(gap, *ub) / cross(*ua, *ub);
            s.is_finite().then(|| Placement::from_parts((from + ua * s).into(), fa.rotation).inverse())
        }
    }
}
