use super::{BodyId, GROUND, Group, Joint, JointId, Mechanism, Role, Slider, SliderId};

/// A driven slider on the way from one link to another that turns as it does.
///
/// Two bodies that a driven slider joins have one rotation, and the sliding between them is known: no motion between them is left
/// to be found. So all links that driven sliders join, directly or over others, are one *compound link* to groups and loops, whose
/// lengths change as the scene says: a hydraulic cylinder with its rod is a link of varying length between its two pins. One of
/// them, its lead, stands for all; where that one's motion is known, so is the others'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrivenSlide {
    /// The slider.
    pub slider: SliderId,
    /// The body that the way leaves here.
    pub from: BodyId,
    /// The body that it enters.
    pub to: BodyId,
    /// +1 from the guide to the sliding link, −1 the other way.
    pub sign: f64,
}

impl DrivenSlide {
    fn new(mechanism: &Mechanism, slider: SliderId, from: BodyId) -> Self {
        let ends = mechanism.slider(slider);
        let forward = ends.on == from;
        Self { slider, from, to: if forward { ends.link } else { ends.on }, sign: if forward { 1.0 } else { -1.0 } }
    }
}

impl Mechanism {
    /// The body that stands for `body` in groups and loops: the lead of its compound link; itself where its motion is known, and
    /// where no driven slider joins it to another.
    #[must_use]
    pub fn lead(&self, body: BodyId) -> BodyId {
        let root = self.root(body);
        if self.body(root).role == Role::Member { root } else { body }
    }

    /// Whether the body's motion (or at least its carried point's) is known before any group is solved.
    #[must_use]
    pub fn is_known(&self, body: BodyId) -> bool {
        !matches!(self.body(self.root(body)).role, Role::Member | Role::Stub)
    }

    /// Whether the body's motion is what is looked for.
    #[must_use]
    pub fn is_sought(&self, body: BodyId) -> bool {
        self.body(self.root(body)).role == Role::Member
    }

    /// `body` and those that driven sliders push from it, each after the one from which it is pushed.
    #[must_use]
    pub fn compound(&self, body: BodyId) -> Vec<BodyId> {
        let mut found = vec![body];
        let mut next = 0;
        while next < found.len() {
            let from_here = |b: &BodyId| matches!(self.body(*b).role, Role::Pushed { from, .. } if from == found[next]);
            let pushed: Vec<BodyId> = (0..self.bodies.len()).map(BodyId).filter(from_here).collect();
            found.extend(pushed);
            next += 1;
        }
        found
    }

    /// The names of a compound link's links, as in `2+3`; of any other link its own.
    #[must_use]
    pub fn compound_name(&self, lead: BodyId) -> String {
        let names = self.compound(lead).into_iter();
        let names: Vec<&str> = names.map(|b| self.body(b).name.as_str()).collect();
        names.join("+")
    }

    /// The body of `link`'s compound that a joint touches; `link` itself where it is none.
    #[must_use]
    pub fn side(&self, joint: JointId, link: BodyId) -> BodyId {
        let mut sides = self.joint(joint).bodies.into_iter();
        let side = sides.find(|&b| b == link || self.lead(b) == link);
        side.unwrap_or(link)
    }

    /// The joints of a group, and those of the driven sliders within its compound links.
    #[must_use]
    pub fn joints_of(&self, group: &Group) -> Vec<JointId> {
        let within = |id: &JointId| {
            let joint = self.joint(*id);
            joint.bodies.iter().all(|b| group.bodies.contains(b))
        };
        let inner = (0..self.joints.len()).map(JointId).filter(within);
        let inner = inner.filter(|id| !group.joints.contains(id));
        group.joints.iter().copied().chain(inner).collect()
    }

    /// +1 where `from`, or a link of its compound, carries the slider's guide, −1 where it slides.
    #[must_use]
    pub fn slide_sign(&self, slider: SliderId, from: BodyId) -> f64 {
        let on = self.slider(slider).on;
        let carries = on == from || self.lead(on) == self.lead(from);
        if carries { 1.0 } else { -1.0 }
    }

    /// The driven sliders on the way from one body to another of the same compound link; none from a body to itself.
    #[must_use]
    pub fn way(&self, from: BodyId, to: BodyId) -> Vec<DrivenSlide> {
        let (mut up, mut down) = (self.climb(from), self.climb(to));
        while !up.is_empty() && up.last() == down.last() {
            up.pop();
            down.pop();
        }
        let back = |slide: DrivenSlide| DrivenSlide::new(self, slide.slider, slide.to);
        up.extend(down.into_iter().rev().map(back));
        up
    }

    /// The driven sliders from a body to the root from which it is pushed.
    fn climb(&self, body: BodyId) -> Vec<DrivenSlide> {
        let mut way = Vec::new();
        let mut here = body;
        while let Role::Pushed { slider, from } = self.body(here).role {
            way.push(DrivenSlide::new(self, slider, here));
            here = from;
        }
        way
    }

    /// The body from which, directly or over others, driven sliders push `body`; itself where none does.
    #[must_use]
    pub fn root(&self, body: BodyId) -> BodyId {
        let mut here = body;
        while let Role::Pushed { from, .. } = self.body(here).role {
            here = from;
        }
        here
    }

    /// Makes compound links: gives every body that a driven slider joins to another its role.
    ///
    /// Bodies that move by themselves come first; among links still to be found the first in the scene leads.
    pub(super) fn join_driven(&mut self) {
        let leads_itself = |b: &BodyId| {
            let role = &self.body(*b).role;
            !matches!(role, Role::Member | Role::Stub)
        };
        let all = || (0..self.bodies.len()).map(BodyId);
        let (known, sought): (Vec<BodyId>, Vec<BodyId>) = all().partition(leads_itself);
        let mut reached = known.clone();
        for start in known.into_iter().chain(sought) {
            if !reached.contains(&start) {
                reached.push(start);
            }
            let mut pending = vec![start];
            while let Some(from) = pending.pop() {
                for slider in (0..self.sliders.len()).map(SliderId) {
                    let Slider { on, link, drive, .. } = *self.slider(slider);
                    let touches = drive.is_some() && (on == from || link == from);
                    let other = if on == from { link } else { on };
                    if touches && !reached.contains(&other) {
                        self.bodies[other.0].role = Role::Pushed { slider, from };
                        reached.push(other);
                        pending.push(other);
                    }
                }
            }
        }
    }

    /// How many constraints drives leave without a motion to take, and the bodies between which they are: a free joint within a
    /// compound link, a joint between two bodies that drives move, a driven slider that closes a ring of such. Given motions of
    /// points and links of a drawn configuration are taken to fit together.
    pub(super) fn surplus(&self) -> (usize, Vec<BodyId>) {
        let (mut surplus, mut bodies) = (0, Vec::new());
        for joint in &self.joints {
            let [a, b] = joint.bodies;
            let driven = joint.slider.filter(|&id| self.slider(id).drive.is_some());
            let idle = match driven {
                Some(id) => ![a, b].into_iter().any(|b| self.is_pushed_by(b, id)),
                None => self.is_rigid_between(a, b) && !self.is_pivot_of_driver(joint),
            };
            if !idle {
                continue;
            }
            surplus += joint.constraints() + usize::from(driven.is_some());
            let way = self.way(a, b).into_iter();
            bodies.extend([a, b].into_iter().chain(way.map(|slide| slide.to)));
        }
        bodies.retain(|&b| b != GROUND);
        bodies.sort_unstable();
        bodies.dedup();
        (surplus, bodies)
    }

    fn is_pushed_by(&self, body: BodyId, id: SliderId) -> bool {
        matches!(self.body(body).role, Role::Pushed { slider, .. } if slider == id)
    }

    /// Whether drives alone say how two bodies move against each other.
    fn is_rigid_between(&self, a: BodyId, b: BodyId) -> bool {
        let roots = [a, b].map(|body| self.root(body));
        let driven = |b: BodyId| matches!(self.body(b).role, Role::Ground | Role::Driver { .. });
        roots[0] == roots[1] || roots.into_iter().all(driven)
    }

    fn is_pivot_of_driver(&self, joint: &Joint) -> bool {
        let pivots = |b: BodyId| match self.body(b).role {
            Role::Driver { pivot, .. } => joint.pin == Some(pivot),
            Role::Ground => true,
            _ => false,
        };
        joint.bodies.into_iter().all(pivots)
    }
}
