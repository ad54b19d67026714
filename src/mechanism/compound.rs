use super::{BodyId, DrivenSlide, GROUND, Group, Joint, JointId, Mechanism, Role, Slider, SliderId};

impl Mechanism {
    /// The body that stands for `body` in groups and loops: the lead of its compound link, or `body` itself if no
    /// driven slider joins it to another or its motion is known.
    #[must_use]
    pub fn lead(&self, body: BodyId) -> BodyId {
        let root = self.root(body);
        if self.body(root).role == Role::Member { root } else { body }
    }

    /// Whether the body's motion, or for a carrier that of its point, is known before any group is solved.
    #[must_use]
    pub fn is_known(&self, body: BodyId) -> bool {
        !matches!(self.body(self.root(body)).role, Role::Member | Role::Unsolved)
    }

    /// Whether the body is a link of an Assur group, whose motion is unknown.
    #[must_use]
    pub fn is_sought(&self, body: BodyId) -> bool {
        self.body(self.root(body)).role == Role::Member
    }

    /// `body` and the links that driven sliders push from it, each after the one from which it is pushed.
    #[must_use]
    pub fn compound(&self, body: BodyId) -> Vec<BodyId> {
        let mut found = vec![body];
        let mut next = 0;
        while next < found.len() {
            let here = found[next];
            // Whoever is pushed has a driven slider: of bodies there are many more.
            let driven = self.sliders.iter().filter(|slider| slider.drive.is_some());
            let others = driven.flat_map(|slider| [slider.on, slider.link]);
            let from_here = |b: &BodyId| matches!(self.body(*b).role, Role::Pushed { from, .. } if from == here);
            let mut pushed: Vec<BodyId> = others.filter(from_here).collect();
            pushed.sort_unstable();
            pushed.dedup();
            found.append(&mut pushed);
            next += 1;
        }
        found
    }

    /// The body of `link`'s compound link that a joint touches; `link` itself if the joint touches none of them.
    #[must_use]
    pub fn side(&self, joint: JointId, link: BodyId) -> BodyId {
        self.joint(joint).bodies.into_iter().find(|&b| b == link || self.lead(b) == link).unwrap_or(link)
    }

    /// The joints of a group, then those of the driven sliders within its compound links.
    #[must_use]
    pub fn joints_of(&self, group: &Group) -> Vec<JointId> {
        if group.bodies.len() == group.links.len() {
            return group.joints.clone();
        }
        let is_within = |id: &JointId| self.joint(*id).bodies.iter().all(|b| group.bodies.contains(b));
        let within = (0..self.joints.len()).map(JointId).filter(|id| is_within(id) && !group.joints.contains(id));
        group.joints.iter().copied().chain(within).collect()
    }

    /// +1 if `from`, or another link of its compound link, carries the slider's guide; −1 if it slides.
    pub(crate) fn slide_sign(&self, slider: SliderId, from: BodyId) -> f64 {
        let on = self.slider(slider).on;
        let carries = on == from || self.lead(on) == self.lead(from);
        if carries { 1.0 } else { -1.0 }
    }

    /// The driven sliders between one body and another of the same compound link, in the order from the first to the
    /// second; none from a body to itself.
    pub(crate) fn slides_between(&self, from: BodyId, to: BodyId) -> Vec<DrivenSlide> {
        let (mut up, mut down) = (self.slides_to_root(from), self.slides_to_root(to));
        while !up.is_empty() && up.last() == down.last() {
            up.pop();
            down.pop();
        }
        let back = |slide: DrivenSlide| DrivenSlide::new(self, slide.slider, slide.to);
        up.extend(down.into_iter().rev().map(back));
        up
    }

    /// The driven sliders from a body to the root of its compound link.
    fn slides_to_root(&self, body: BodyId) -> Vec<DrivenSlide> {
        let mut found = Vec::new();
        let mut here = body;
        while let Role::Pushed { slider, from } = self.body(here).role {
            found.push(DrivenSlide::new(self, slider, here));
            here = from;
        }
        found
    }

    /// The body from which, directly or over others, driven sliders push `body`; `body` itself if none does.
    #[must_use]
    pub fn root(&self, body: BodyId) -> BodyId {
        let mut here = body;
        while let Role::Pushed { from, .. } = self.body(here).role {
            here = from;
        }
        here
    }

    /// Makes compound links: gives every body that a driven slider pushes from another the role of a pushed one.
    ///
    /// Bodies of known motion come first as roots; among links of groups the first by name is the lead.
    pub(super) fn join_driven(&mut self) {
        let all = self.body_ids();
        let (known, sought): (Vec<BodyId>, Vec<BodyId>) = all.partition(|&b| self.is_known(b));
        let mut reached = known.clone();
        for start in known.into_iter().chain(sought) {
            if !reached.contains(&start) {
                reached.push(start);
            }
            let mut pending = vec![start];
            while let Some(from) = pending.pop() {
                for slider in self.slider_ids() {
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

    /// The number of constraints that only repeat what drives determine, and the bodies that they join: a joint other
    /// than a driven slider within a compound link or between two bodies that drives move, and a driven slider that
    /// closes a ring of such. The given motions of points and links of a drawn configuration are taken to be
    /// consistent.
    pub(super) fn surplus(&self) -> (usize, Vec<BodyId>) {
        let (mut surplus, mut bodies) = (0, Vec::new());
        let is_driven = |body| matches!(self.body(self.root(body)).role, Role::Ground | Role::Driver { .. });
        for joint in &self.joints {
            let [a, b] = joint.bodies;
            let driven = joint.slider.filter(|&id| self.slider(id).drive.is_some());
            let is_pushed_by = |body, id| matches!(self.body(body).role, Role::Pushed { slider, .. } if slider == id);
            let is_redundant = match driven {
                Some(id) => !is_pushed_by(a, id) && !is_pushed_by(b, id),
                // Drives alone determine the relative motion of the two.
                None => {
                    (self.root(a) == self.root(b) || [a, b].into_iter().all(is_driven))
                        && !self.is_pivot_of_driver(joint)
                }
            };
            if !is_redundant {
                continue;
            }
            surplus += joint.constraints() + usize::from(driven.is_some());
            let slides = self.slides_between(a, b).into_iter();
            bodies.extend([a, b].into_iter().chain(slides.map(|slide| slide.to)));
        }
        bodies.retain(|&b| b != GROUND);
        bodies.sort_unstable();
        bodies.dedup();
        (surplus, bodies)
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
