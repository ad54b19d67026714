use super::closing::Assembled;
use super::frames::{Frames, Hold, local, pinned, turned_towards, within};
use super::legs::{LegCondition, joined_placements, placements, smallest_miss};
use crate::geometry::{Placement, cross};
use crate::mechanism::{BodyId, Class, Group, JointId, Mechanism, SliderId};

/// A group seen as a planar platform: rigid bodies a and b joined by legs, each a middle body with a joint to either.
///
/// Third class: the fixed frame (known bodies, which stand still for this purpose) and the central link, joined by three legs.
/// Fourth class: the two drag links, joined by the closure links and the fixed frame. Second class: the fixed frame and one
/// link, joined by a joint and by the other link as a leg.
pub(super) struct Platform<'a> {
    mechanism: &'a Mechanism,
    /// Body b; body a too, where it is not the fixed frame.
    b: BodyId,
    a: Option<BodyId>,
    /// The middle bodies that are links, with the number of their leg.
    middles: Vec<(usize, BodyId)>,
    legs: Vec<[Hold; 2]>,
    /// For a dyad: how the fixed frame holds body b directly.
    direct: Option<Hold>,
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
        // A link holds its frame; one of a compound link stands at its place in the lead's.
        let own = |link: BodyId, joint: JointId| {
            let side = mechanism.side(joint, link);
            (side, within(mechanism, link, side))
        };
        // A leg along part of a loop: side a, joint, middle, joint, side b.
        let hold = |joint, side, middle| Hold::new(mechanism, joint, side, middle);
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
            let number = platform.legs.len();
            let holds = [hold(near, a, own(middle, near)), hold(far, b, own(middle, far))];
            platform.legs.push(holds);
            platform.names.push(name([near, far]));
            platform.middles.push((number, middle));
        };
        match group.class {
            Class::Second => {
                let (bodies, joints) = (&chain(0).bodies, &chain(0).joints);
                // A link that slides on the known body keeps its angle: it is found first, by a line or a circle.
                let ties = |joint: JointId| mechanism.joint(joint).tie.is_some();
                let from_end = ties(joints[2]) && !ties(joints[0]);
                let at = |forward: usize, backward: usize| if from_end { backward } else { forward };
                let (start, b) = (bodies[at(0, 3)], bodies[at(1, 2)]);
                let (middle, end) = (bodies[at(2, 1)], bodies[at(3, 0)]);
                let (near, far, direct) = (joints[at(2, 0)], joints[1], joints[at(0, 2)]);
                leg(near, fixed(end), middle, far, own(b, far));
                platform.direct = Some(hold(direct, own(b, direct), fixed(start)));
                platform.b = b;
            }
            Class::Third => {
                let central = chain(0).bodies[2];
                for (k, from_end) in [(0, false), (0, true), (1, true)] {
                    let (bodies, joints) = (&chain(k).bodies, &chain(k).joints);
                    let at = |forward: usize, backward: usize| if from_end { backward } else { forward };
                    let (base, middle) = (bodies[at(0, 4)], bodies[at(1, 3)]);
                    let (outer, inner) = (joints[at(0, 3)], joints[at(1, 2)]);
                    leg(outer, fixed(base), middle, inner, own(central, inner));
                }
                platform.b = central;
            }
            Class::Fourth => {
                let (a, b) = (chain(0).bodies[1], chain(0).bodies[3]);
                for k in 0..2 {
                    let (near, far) = (chain(k).joints[1], chain(k).joints[2]);
                    leg(near, own(a, near), chain(k).bodies[2], far, own(b, far));
                }
                let (bodies, joints) = (&chain(0).bodies, &chain(0).joints);
                let base = [
                    hold(joints[0], own(a, joints[0]), fixed(bodies[0])),
                    hold(joints[3], own(b, joints[3]), fixed(bodies[4])),
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

    /// Approximate assemblies, one for each way in which the legs' conditions are met.
    pub(super) fn starts(&self, known: &Frames, slides: &[f64]) -> Vec<Assembled> {
        let relative = match (&self.direct, self.conditions().as_slice()) {
            (Some(direct), &[condition]) => joined_placements(direct, condition),
            (None, &[first, second, third]) => placements([first, second, third]),
            _ => Vec::new(),
        };
        let starts = relative.iter();
        starts.filter_map(|r| self.assembled(known, slides, r)).collect()
    }

    /// All bodies placed, for a placement of b in a's frame.
    fn assembled(&self, known: &Frames, slides: &[f64], relative: &Placement) -> Option<Assembled> {
        let mut frames = known.clone();
        let mut frame_a = Placement::identity();
        if let Some(a) = self.a {
            // The last leg's middle is the fixed frame: where a's frame stands in it is what is looked for.
            frame_a = middle(self.legs.last()?, relative)?.inverse();
            frames.set_compound(self.mechanism, a, frame_a);
        }
        frames.set_compound(self.mechanism, self.b, frame_a * relative);
        for &(leg, body) in &self.middles {
            let frame = frame_a * middle(&self.legs[leg], relative)?;
            frames.set_compound(self.mechanism, body, frame);
        }
        let mut slides = slides.to_vec();
        for id in &self.sliders {
            let slider = self.mechanism.slider(*id);
            let (on, link) = (frames.of(slider.on)?, frames.of(slider.link)?);
            let (through, direction) = slider.line();
            let at = link * local(self.mechanism, slider.link, slider.at);
            slides[id.0] = (on.inverse() * at - through).dot(&direction);
        }
        Some(Assembled { frames, slides, gap: f64::INFINITY })
    }

    /// By how much the legs fail to meet at best, in words.
    pub(super) fn miss(&self) -> String {
        let conditions = self.conditions();
        let is_distance = |c: &LegCondition| matches!(c, LegCondition::Distance { .. });
        let leg = conditions.iter().position(is_distance);
        let miss = leg.and_then(|_| smallest_miss(self.direct.as_ref(), &conditions));
        match (leg, miss) {
            (Some(leg), Some(m)) => format!(
                "with everything else closed, {} would have to be {:.4} {}",
                self.names[leg],
                m.abs(),
                if m > 0.0 { "longer" } else { "shorter" }
            ),
            _ => "its guides and lengths never meet".to_owned(),
        }
    }
}

/// The condition that a leg with these holds puts on body b in a's frame.
fn condition([near, far]: [Hold; 2]) -> LegCondition {
    match (near, far) {
        (Hold::Pin { local: a, place: p }, Hold::Pin { local: b, place: q }) => {
            LegCondition::Distance { a, b, length: (q - p).norm() }
        }
        (Hold::Slide { frame, along }, Hold::Pin { local: b, place }) => {
            let inverse = frame.inverse();
            LegCondition::OnLineOfA { point: inverse * place, direction: inverse * along, b }
        }
        (Hold::Pin { local: a, place }, Hold::Slide { frame, along }) => {
            let inverse = frame.inverse();
            LegCondition::OnLineOfB { point: inverse * place, direction: inverse * along, a }
        }
        (Hold::Slide { frame: a, .. }, Hold::Slide { frame: b, .. }) => {
            LegCondition::Turned(a.rotation.inverse() * b.rotation)
        }
    }
}

/// The middle body's frame in a's frame, for a placement `relative` of b in a's frame.
fn middle([near, far]: &[Hold; 2], relative: &Placement) -> Option<Placement> {
    match (near, far) {
        (Hold::Pin { local: a, place: p }, Hold::Pin { local: b, place: q }) => {
            Some(turned_towards(*p, *q, *a, relative * b))
        }
        (Hold::Slide { frame, .. }, Hold::Pin { local: b, place }) => {
            Some(pinned(frame.rotation.inverse(), *place, relative * b))
        }
        (Hold::Pin { local: a, place }, Hold::Slide { frame, .. }) => {
            let turn = relative.rotation * frame.rotation.inverse();
            Some(pinned(turn, *place, *a))
        }
        (Hold::Slide { frame: fa, along: ua }, Hold::Slide { frame: fb, along: ub }) => {
            // In the middle frame a stands at fa + s ua and b at fb + t ub, and b is a times `relative`.
            let (from, to) = (fa.translation.vector, fb.translation.vector);
            let gap = to - from - fa.rotation * relative.translation.vector;
            let s = cross(gap, *ub) / cross(*ua, *ub);
            s.is_finite().then(|| Placement::from_parts((from + ua * s).into(), fa.rotation).inverse())
        }
    }
}
