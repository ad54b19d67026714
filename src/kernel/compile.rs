use super::action::{
    Action, Chain, Closing, Input, InputKind, Kernel, Member, Placing, Rail, Reducing, Seat, Shape, Tied, TiedClass,
    Unknown, ZERO,
};
use super::classes::classes;
use crate::geometry::{Point, Turn, Vector};
use crate::mechanism::{
    AngularConstraint, Body, BodyId, GROUND, Group, Joint, JointId, Loop, LoopEquations, Mechanism, Reduction, Role,
    Slider, SliderId,
};
use crate::scene::GivenBy;

impl Kernel {
    /// The kernel of `mechanism`; `None` for a drawn configuration, which has one position only.
    #[must_use]
    pub fn new(mechanism: &Mechanism) -> Option<Kernel> {
        (mechanism.given_by == GivenBy::Lengths).then(|| Compiler::new(mechanism).run())
    }
}

struct Compiler<'a> {
    mechanism: &'a Mechanism,
    /// By body: its class and its rotation in it.
    classes: Vec<(usize, Turn)>,
    /// By body: slot and local coordinates of its first point.
    anchors: Vec<Option<(usize, Point)>>,
    placed: Vec<bool>,
    kernel: Kernel,
}

impl<'a> Compiler<'a> {
    fn new(mechanism: &'a Mechanism) -> Self {
        let classes = classes(mechanism);
        let points = mechanism.points.len();
        Self {
            mechanism,
            anchors: vec![None; mechanism.bodies.len()],
            placed: vec![false; points],
            kernel: Kernel {
                seats: Vec::new(),
                inputs: Vec::new(),
                unknowns: Vec::new(),
                classes: classes.iter().map(|c| c.0 + 1).max().unwrap_or(1),
                sliders: mechanism.sliders.len(),
                loops: mechanism.groups.iter().map(|g| g.loops.len()).max().unwrap_or(0),
                ties: 0,
                slots: points,
                columns: ZERO + 1,
                placings: 0,
                origin: Vector::zeros(),
                fixed: Vec::new(),
                actions: Vec::new(),
                closings: Vec::new(),
            },
            classes,
        }
    }

    fn run(mut self) -> Kernel {
        let bodies = self.mechanism.bodies.iter().enumerate();
        for (id, body) in bodies.map(|(id, body)| (BodyId(id), body)) {
            match body.role {
                Role::Ground => self.place_ground(body),
                Role::Driver { pivot, angle, omega, alpha, .. } => {
                    let local = body.local_of(pivot).unwrap_or_else(Point::origin);
                    self.place_body(id, pivot.0, local);
                    let class = self.classes[id.0].0;
                    self.kernel.inputs.push(Input {
                        body: id,
                        kind: InputKind::Turning { class },
                        value: angle,
                        rate: omega,
                        second: alpha,
                    });
                }
                _ => {}
            }
        }
        for (id, slider) in self.mechanism.sliders.iter().enumerate() {
            if let Some(drive) = slider.drive {
                self.kernel.inputs.push(Input {
                    body: slider.link,
                    kind: InputKind::Sliding { slider: id },
                    value: drive.position,
                    rate: drive.speed,
                    second: drive.acceleration,
                });
            }
        }
        let all: Vec<JointId> = (0..self.mechanism.joints.len()).map(JointId).collect();
        let mechanism = self.mechanism;
        self.place_connected(&all, |body| mechanism.is_known(body));
        for (index, group) in self.mechanism.groups.iter().enumerate() {
            let closing = self.compile_group(index, group);
            self.kernel.ties = self.kernel.ties.max(closing.ties.len());
            self.kernel.unknowns.push(closing.unknowns.clone());
            self.kernel.closings.push(self.kernel.actions.len());
            self.kernel.actions.push(Action::Close(closing));
            let joints = self.mechanism.joints_of(group);
            self.place_connected(&joints, |_| true);
        }
        let origin = (0, Point::origin());
        self.kernel.seats = self
            .classes
            .iter()
            .zip(&self.anchors)
            .map(|(&(class, turn), anchor)| {
                let (slot, local) = anchor.unwrap_or(origin);
                Seat { class, turn, slot, local }
            })
            .collect();
        self.kernel
    }

    fn place_ground(&mut self, body: &Body) {
        for (point, place) in body.points.iter().zip(&body.local) {
            self.kernel.fixed.push((point.0, *place));
            self.placed[point.0] = true;
        }
        let first = body.points.first().map(|p| p.0).zip(body.local.first().copied());
        self.anchors[GROUND.0] = first;
        // A ground without points is represented by a point of its first guide.
        let mut sliders = self.mechanism.sliders.iter();
        let guide = sliders.find(|s| s.on == GROUND).map(Slider::line);
        if let (None, Some((through, _))) = (first, guide) {
            let slot = self.new_slot();
            self.kernel.fixed.push((slot, through));
            self.anchors[GROUND.0] = Some((slot, through));
        }
        if let Some((_, first)) = self.kernel.fixed.first().copied() {
            self.kernel.origin = first.coords;
            for (_, place) in &mut self.kernel.fixed {
                *place -= first.coords;
            }
        }
    }

    fn new_slot(&mut self) -> usize {
        self.kernel.slots += 1;
        self.kernel.slots - 1
    }

    /// The vector `local` of a body's frame in the frame of its class.
    fn in_class(&self, body: BodyId, local: Vector) -> Vector {
        self.classes[body.0].1 * local
    }

    /// Makes a placed point the body's first one, and places the body's other points relative to it.
    fn place_body(&mut self, body: BodyId, slot: usize, local: Point) {
        self.anchors[body.0] = Some((slot, local));
        let placed_body = self.mechanism.body(body);
        for (point, place) in placed_body.points.iter().zip(&placed_body.local) {
            if !self.placed[point.0] && point.0 != slot {
                self.place(point.0, slot, body, place - local, None);
            }
        }
    }

    fn place(&mut self, to: usize, from: usize, body: BodyId, local: Vector, slide: Option<(usize, Vector)>) {
        let reach = self.kernel.placings;
        self.kernel.placings += 1;
        let local = self.in_class(body, local);
        let class = self.classes[body.0].0;
        self.kernel.actions.push(Action::Place(Placing { to, from, class, local, slide, reach }));
        if let Some(placed) = self.placed.get_mut(to) {
            *placed = true;
        }
    }

    /// Places every `wanted` body that one of `joints` connects with a placed body.
    fn place_connected(&mut self, joints: &[JointId], wanted: impl Fn(BodyId) -> bool) {
        let open = |this: &Self, body: BodyId| this.anchors[body.0].is_none() && wanted(body);
        let holding = || joints.iter().filter(|&&joint| self.mechanism.joint(joint).holds_places());
        while let Some((joint, from, to)) = holding().find_map(|&joint| {
            let [a, b] = self.mechanism.joint(joint).bodies;
            let ways = [(a, b), (b, a)];
            let way = ways.into_iter().find(|(from, to)| self.anchors[from.0].is_some() && open(self, *to));
            way.map(|(from, to)| (joint, from, to))
        }) {
            let Joint { pin, slider, .. } = *self.mechanism.joint(joint);
            if let Some(point) = pin {
                self.place_body(to, point.0, self.mechanism.joint_on(joint, to));
            }
            if let Some(id) = slider {
                self.place_across(id, from, to);
            }
        }
    }

    /// Places body `to`, which a slider connects with the placed body `from`.
    fn place_across(&mut self, id: SliderId, from: BodyId, to: BodyId) {
        let slider = self.mechanism.slider(id);
        let (through, direction) = slider.line();
        let direction = self.in_class(slider.on, direction);
        let at = self.mechanism.local(slider.link, slider.at);
        let (slot, anchor) = self.anchors[from.0].unwrap_or((0, Point::origin()));
        if slider.on == from {
            // A link without points slides: its place gets a slot of its own.
            let has_point = self.mechanism.body(to).points.contains(&slider.at);
            let slot_at = if has_point { slider.at.0 } else { self.new_slot() };
            if !has_point || !self.placed[slot_at] {
                self.place(slot_at, slot, from, through - anchor, Some((id.0, direction)));
            }
            self.place_body(to, slot_at, at);
        } else {
            let to_body = self.mechanism.body(to);
            let first = to_body.points.iter().zip(&to_body.local);
            let (next, local) = match first.clone().find(|(p, _)| !self.placed[p.0]) {
                Some((point, local)) => (point.0, *local),
                None => (self.new_slot(), through),
            };
            // The guide's point is the sliding point less the slide.
            let behind = Some((id.0, -direction));
            let from_slot = self.slot_of(from, slider.at.0);
            self.place(next, from_slot, to, local - through, behind);
            self.place_body(to, next, local);
        }
    }

    /// The slot of a body's point; for a body without points that of its own place.
    fn slot_of(&self, body: BodyId, point: usize) -> usize {
        let has_point = self.mechanism.body(body).points.iter().any(|p| p.0 == point);
        let place = self.anchors[body.0].map(|(slot, _)| slot);
        if has_point { point } else { place.unwrap_or(point) }
    }

    fn compile_group(&mut self, index: usize, group: &Group) -> Closing {
        let equations = LoopEquations::new(self.mechanism, group);
        let mut unknowns = vec![Unknown::Spin(0); equations.unknowns];
        for &link in &group.links {
            if let Some(unknown) = equations.angular_unknown(link) {
                unknowns[unknown] = Unknown::Spin(self.classes[link.0].0);
            }
        }
        for slider in 0..self.mechanism.sliders.len() {
            if let Some(unknown) = equations.slide_unknown(SliderId(slider)) {
                unknowns[unknown] = Unknown::Slide(slider);
            }
        }
        // Shared unknowns first, then those of single loops.
        if let Some(Reduction::TwoLoops { shared, own }) = equations.reduction {
            let order = [shared[0], shared[1], own[0], own[1]];
            unknowns = order.map(|unknown| unknowns[unknown]).to_vec();
        }
        let ties = group
            .joints
            .iter()
            .filter_map(|&joint| self.compile_tie(self.mechanism.joint(joint).angular.as_ref()?, &unknowns));
        let ties = ties.collect();
        let mut closing = Closing {
            group: index,
            chains: Vec::new(),
            ties,
            unknowns,
            reduced: None,
            shape: None,
            size: 0.0,
            scales: Vec::new(),
        };
        for chain in &group.loops {
            self.compile_loop(chain, &mut closing);
        }
        let members = closing.chains.iter().flat_map(|c| &c.members);
        let components = members.flat_map(|m| [m.local.x.abs(), m.local.y.abs()]);
        closing.size = components.fold(f64::MIN_POSITIVE, f64::max);
        let scale = |unknown: &Unknown| if let Unknown::Slide(_) = unknown { 1.0 / closing.size } else { 1.0 };
        closing.scales = closing.unknowns.iter().map(scale).collect();
        let reduction = equations.reduction;
        closing.reduced = reduction.and_then(|r| Reducing::new(r, &closing.chains));
        closing.shape = Shape::of(&closing);
        closing
    }

    /// A tie in terms of classes; `None` for a tie that makes its bodies one class.
    fn compile_tie(&self, tie: &AngularConstraint, unknowns: &[Unknown]) -> Option<Tied> {
        if tie.as_fixed_angle().is_some() {
            return None;
        }
        let mut tied = Tied { classes: Vec::new(), apart: angle(tie.constant) };
        for &(body, weight) in &tie.terms {
            let (class, turn) = self.classes[body.0];
            let spin = unknowns.iter().position(|u| *u == Unknown::Spin(class));
            let weight = f64::from(weight);
            tied.classes.push(TiedClass { class, weight, spin });
            tied.apart -= weight * angle(turn);
        }
        Some(tied)
    }

    /// Compiles a loop: sums its vectors by class, and assigns columns.
    fn compile_loop(&mut self, chain: &Loop, closing: &mut Closing) {
        // A loop names the lead of a compound link; the joints may be on others of its links.
        let side = |joint, link| self.mechanism.side(joint, link);
        let last = chain.joints.len() - 1;
        let first = side(chain.joints[0], chain.bodies[0]);
        let (start, from) = self.loop_end(first, chain.joints[0], chain.closed);
        let mut walk = Walk { body: first, here: from };
        let mut sums =
            LoopSums { classes: &self.classes, unknowns: &closing.unknowns, members: Vec::new(), rails: Vec::new() };
        for (&joint, sides) in chain.joints.iter().zip(chain.bodies.windows(2)) {
            let [body, next] = [sides[0], sides[1]].map(|link| side(joint, link));
            self.walk_compound(&mut sums, &mut walk, body);
            self.walk_joint(&mut sums, &mut walk, joint, next);
        }
        let ends = if chain.closed {
            self.walk_compound(&mut sums, &mut walk, first);
            sums.add_vector(first, from - walk.here);
            None
        } else {
            let (end, there) = self.loop_end(walk.body, chain.joints[last], false);
            sums.add_vector(walk.body, there - walk.here);
            Some([start, end])
        };
        let (mut members, mut rails) = (sums.members, sums.rails);
        // A class whose vector vanishes and that has no slider contributes nothing: a known body with a pin at the
        // loop's end.
        let slides = |m: &Member| rails.iter().any(|r| r.class == m.class);
        members.retain(|m| m.local != Vector::zeros() || slides(m));
        for member in &mut members {
            member.column = self.kernel.columns;
            self.kernel.columns += 1;
            for rail in rails.iter_mut().filter(|r| r.class == member.class) {
                rail.arm = member.column;
            }
        }
        for rail in &mut rails {
            rail.column = self.kernel.columns;
            self.kernel.columns += 1;
        }
        let column = |unknown: &Unknown| match *unknown {
            Unknown::Spin(class) => {
                let member = members.iter().find(|m| m.class == class);
                member.map_or(ZERO, |m| m.column)
            }
            Unknown::Slide(slider) => {
                let rail = rails.iter().find(|r| r.slider == slider);
                rail.map_or(ZERO, |r| r.column)
            }
        };
        let columns = closing.unknowns.iter().map(column).collect();
        let has_known = members.iter().any(|m| m.spin.is_none()) || rails.iter().any(|r| r.slide.is_none());
        closing.chains.push(Chain { ends, members, rails, has_known, columns });
    }

    /// Continues the walk over the driven sliders of a compound link to its body `to`.
    fn walk_compound(&self, sums: &mut LoopSums, walk: &mut Walk, to: BodyId) {
        for driven in self.mechanism.slides_between(walk.body, to) {
            self.walk_joint(sums, walk, self.mechanism.slider_joint(driven.slider), driven.to);
        }
    }

    /// Continues the walk over a joint to body `to`: on the present body to the joint, then along the guide, if there
    /// is one, to the joint on body `to`.
    fn walk_joint(&self, sums: &mut LoopSums, walk: &mut Walk, joint: JointId, to: BodyId) {
        let [leave, arrive] = [walk.body, to].map(|body| self.mechanism.joint_on(joint, body));
        sums.add_vector(walk.body, leave - walk.here);
        if let Some(id) = self.mechanism.joint(joint).slider {
            let slider = self.mechanism.slider(id);
            let direction = self.in_class(slider.on, slider.line().1);
            sums.add_slider(walk.body, id.0, if slider.on == walk.body { direction } else { -direction });
        }
        *walk = Walk { body: to, here: arrive };
    }

    /// Slot and local coordinates of a loop's end on a known body: its pin, or the body's first point at a slider.
    fn loop_end(&self, body: BodyId, joint: JointId, closed: bool) -> (usize, Point) {
        match self.mechanism.joint(joint).pin {
            Some(point) => (point.0, self.mechanism.joint_on(joint, body)),
            None if closed => (0, Point::origin()),
            None => self.anchors[body.0].unwrap_or((0, Point::origin())),
        }
    }
}

/// The angle of a rotation in radians.
fn angle(turn: Turn) -> f64 {
    libm::atan2(turn.im, turn.re)
}

/// Present place of a walk along a loop: a body, and a point in its frame.
struct Walk {
    body: BodyId,
    here: Point,
}

/// The vectors and sliders of a loop, summed by class during a walk.
struct LoopSums<'a> {
    classes: &'a [(usize, Turn)],
    unknowns: &'a [Unknown],
    members: Vec<Member>,
    rails: Vec<Rail>,
}

impl LoopSums<'_> {
    fn unknown(&self, unknown: Unknown) -> Option<usize> {
        self.unknowns.iter().position(|u| *u == unknown)
    }

    /// Adds a vector in a body's frame to the member of its class.
    fn add_vector(&mut self, body: BodyId, local: Vector) {
        let (class, turn) = self.classes[body.0];
        let index = self.members.iter().position(|m| m.class == class);
        let index = index.unwrap_or_else(|| {
            self.members.push(Member {
                class,
                local: Vector::zeros(),
                spin: self.unknown(Unknown::Spin(class)),
                column: ZERO,
            });
            self.members.len() - 1
        });
        self.members[index].local += turn * local;
    }

    /// Adds a slider whose guide has the rotation of the body's class.
    fn add_slider(&mut self, body: BodyId, slider: usize, direction: Vector) {
        self.rails.push(Rail {
            class: self.classes[body.0].0,
            slider,
            direction,
            spin: self.unknown(Unknown::Spin(self.classes[body.0].0)),
            slide: self.unknown(Unknown::Slide(slider)),
            arm: ZERO,
            column: ZERO,
        });
    }
}
