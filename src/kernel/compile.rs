use super::action::{Action, Chain, Closing, Member, Placing, Rail, ReducedColumns, Tied, TiedClass, Unknown, ZERO};
use super::classes::classes;
use crate::geometry::{Point, Turn, Vector};
use crate::mechanism::{
    Body, BodyId, GROUND, Group, Joint, JointId, Loop, LoopEquations, Mechanism, Reduction, Role, Slider, SliderId, Tie,
};
use crate::scene::GivenBy;
use std::collections::BTreeSet;

/// A mechanism compiled for many positions.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// By body: how it sits in its class.
    pub seats: Vec<Seat>,
    /// The drives, in the order of [`Mechanism::drive_names`].
    pub inputs: Vec<Input>,
    /// By group: what its equations solve for.
    pub unknowns: Vec<Vec<Unknown>>,
    pub(super) classes: usize,
    pub(super) sliders: usize,
    /// The most loops that a group has, and the most ties.
    pub(super) loops: usize,
    pub(super) ties: usize,
    /// Points first, then places of guides on bodies without points.
    pub(super) slots: usize,
    /// Columns of loop equations, the zero column first.
    pub(super) columns: usize,
    pub(super) placings: usize,
    /// Places in a block count from here, a place of the ground: far from the fixed frame's own origin no digits are lost.
    pub origin: Vector,
    pub(super) fixed: Vec<(usize, Point)>,
    pub(super) actions: Vec<Action>,
}

/// How a body sits in its class of bodies that turn together, and a place of it from which the others are counted.
#[derive(Clone, Copy, Debug)]
pub struct Seat {
    /// Its class.
    pub class: usize,
    /// Its own frame, seen from that of the class.
    pub turn: Turn,
    /// The slot of its first place.
    pub slot: usize,
    /// That place in the body's frame.
    pub local: Point,
}

/// A drive: what a scene or a sweep sets.
#[derive(Clone, Debug)]
pub struct Input {
    /// The driven body; of a slider the sliding link.
    pub body: BodyId,
    /// Whether it turns or slides.
    pub kind: InputKind,
    /// The scene's angle in degrees, or position along the guide; none where something else says where it stands.
    pub value: Option<f64>,
    /// The scene's angular velocity, or speed along the guide.
    pub rate: f64,
    /// The scene's angular acceleration, or acceleration along the guide.
    pub second: f64,
}

/// What a drive moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputKind {
    /// The angle of a class.
    Turning {
        /// The class.
        class: usize,
    },
    /// A slider along its guide.
    Sliding {
        /// The slider.
        slider: usize,
    },
}

impl Kernel {
    /// The kernel of `mechanism`; `None` for a drawn configuration, which has one position only.
    #[must_use]
    pub fn new(mechanism: &Mechanism) -> Option<Kernel> {
        (mechanism.given_by == GivenBy::Lengths).then(|| Compiler::new(mechanism).run())
    }

    /// Whether `other` is of the same kind: the same actions in the same order, but for lengths.
    #[must_use]
    pub fn is_like(&self, other: &Kernel) -> bool {
        let slots = |k: &Kernel| k.fixed.iter().map(|f| f.0).collect::<Vec<_>>();
        let bare = |k: &Kernel| k.actions.iter().map(Action::bare).collect::<Vec<_>>();
        slots(self) == slots(other) && bare(self) == bare(other)
    }

    /// The kernel that leaves out the places of all points that no loop begins or ends at: for angles, slides and their rates.
    #[must_use]
    pub fn without_places(&self) -> Kernel {
        let mut wanted = BTreeSet::new();
        let mut kept: Vec<Action> = Vec::new();
        for action in self.actions.iter().rev() {
            match action {
                Action::Close(closing) => {
                    wanted.extend(closing.chains.iter().filter_map(|c| c.ends).flatten());
                }
                Action::Place(placing) if wanted.contains(&placing.to) => {
                    wanted.insert(placing.from);
                }
                Action::Place(_) => continue,
            }
            kept.push(action.clone());
        }
        kept.reverse();
        Kernel { actions: kept, ..self.clone() }
    }

    /// How a body sits in its class, and its first place.
    #[must_use]
    pub fn seat(&self, body: BodyId) -> &Seat {
        &self.seats[body.0]
    }
}

struct Compiler<'a> {
    mechanism: &'a Mechanism,
    /// By body: class and turn.
    classes: Vec<(usize, Turn)>,
    /// By body: slot and local place of what is placed first.
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
            },
            classes,
        }
    }

    fn run(mut self) -> Kernel {
        let bodies = self.mechanism.bodies.iter().enumerate();
        for (id, body) in bodies.map(|(id, body)| (BodyId(id), body)) {
            match body.role {
                Role::Ground => self.ground(body),
                Role::Driver { pivot, angle, omega, alpha, .. } => {
                    let local = body.local_of(pivot).unwrap_or_else(Point::origin);
                    self.anchor(id, pivot.0, local);
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
        self.reach(&all, |body| mechanism.is_known(body));
        for (index, group) in self.mechanism.groups.iter().enumerate() {
            let closing = self.closing(index, group);
            self.kernel.ties = self.kernel.ties.max(closing.ties.len());
            self.kernel.unknowns.push(closing.unknowns.clone());
            self.kernel.actions.push(Action::Close(closing));
            let joints = self.mechanism.joints_of(group);
            self.reach(&joints, |_| true);
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

    fn ground(&mut self, body: &Body) {
        for (point, place) in body.points.iter().zip(&body.local) {
            self.kernel.fixed.push((point.0, *place));
            self.placed[point.0] = true;
        }
        let first = body.points.first().map(|p| p.0).zip(body.local.first().copied());
        self.anchors[GROUND.0] = first;
        // A frame without points is known by a place of its first guide.
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

    /// `local` of a body's frame in the frame of its class.
    fn in_class(&self, body: BodyId, local: Vector) -> Vector {
        self.classes[body.0].1 * local
    }

    /// The body's place is known at a slot: places its other points from there.
    fn anchor(&mut self, body: BodyId, slot: usize, local: Point) {
        self.anchors[body.0] = Some((slot, local));
        let own = self.mechanism.body(body);
        for (point, place) in own.points.iter().zip(&own.local) {
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

    /// Places every body of the kind asked for that hangs by one of `joints` on a body placed before.
    fn reach(&mut self, joints: &[JointId], wanted: impl Fn(BodyId) -> bool) {
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
                self.anchor(to, point.0, self.mechanism.joint_on(joint, to));
            }
            if let Some(id) = slider {
                self.across(id, from, to);
            }
        }
    }

    /// Places `to`, which a slider joins to the placed body `from`.
    fn across(&mut self, id: SliderId, from: BodyId, to: BodyId) {
        let slider = self.mechanism.slider(id);
        let (through, direction) = slider.line();
        let direction = self.in_class(slider.on, direction);
        let at = self.mechanism.slider_at(id);
        let (slot, anchor) = self.anchors[from.0].unwrap_or((0, Point::origin()));
        if slider.on == from {
            // A carriage slides without a point of its own.
            let own = self.mechanism.body(to).points.contains(&slider.at);
            let here = if own { slider.at.0 } else { self.new_slot() };
            if !own || !self.placed[here] {
                self.place(here, slot, from, through - anchor, Some((id.0, direction)));
            }
            self.anchor(to, here, at);
        } else {
            let own = self.mechanism.body(to);
            let first = own.points.iter().zip(&own.local);
            let (next, local) = match first.clone().find(|(p, _)| !self.placed[p.0]) {
                Some((point, local)) => (point.0, *local),
                None => (self.new_slot(), through),
            };
            // The guide's place lies one slide behind the sliding point.
            let behind = Some((id.0, -direction));
            let here = self.slot_of(from, slider.at.0);
            self.place(next, here, to, local - through, behind);
            self.anchor(to, next, local);
        }
    }

    /// The slot of a body's point; of a carriage without points its own place.
    fn slot_of(&self, body: BodyId, point: usize) -> usize {
        let own = self.mechanism.body(body).points.iter().any(|p| p.0 == point);
        let place = self.anchors[body.0].map(|(slot, _)| slot);
        if own { point } else { place.unwrap_or(point) }
    }

    fn closing(&mut self, index: usize, group: &Group) -> Closing {
        let equations = LoopEquations::new(self.mechanism, group);
        let mut unknowns = vec![Unknown::Spin(0); equations.unknowns];
        for &link in &group.links {
            if let Some(unknown) = equations.spin_unknown(link) {
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
        let ties =
            group.joints.iter().filter_map(|&joint| self.tied(self.mechanism.joint(joint).tie.as_ref()?, &unknowns));
        let ties = ties.collect();
        let mut closing = Closing { group: index, chains: Vec::new(), ties, reduced: None, unknowns, reach: 0.0 };
        for chain in &group.loops {
            self.chain(chain, &mut closing);
        }
        let members = closing.chains.iter().flat_map(|c| &c.members);
        let components = members.flat_map(|m| [m.local.x.abs(), m.local.y.abs()]);
        closing.reach = components.fold(f64::MIN_POSITIVE, f64::max);
        let reduction = equations.reduction;
        closing.reduced = reduction.and_then(|r| ReducedColumns::new(r, &closing.chains));
        closing
    }

    /// A tie of rotations in terms of classes; `None` for one that has made one class of its bodies.
    fn tied(&self, tie: &Tie, unknowns: &[Unknown]) -> Option<Tied> {
        if tie.as_alike().is_some() {
            return None;
        }
        let mut tied = Tied { classes: Vec::new(), apart: angle(tie.apart) };
        for &(body, weight) in &tie.turns {
            let (class, turn) = self.classes[body.0];
            let spin = unknowns.iter().position(|u| *u == Unknown::Spin(class));
            let weight = f64::from(weight);
            tied.classes.push(TiedClass { class, weight, spin });
            tied.apart -= weight * angle(turn);
        }
        Some(tied)
    }

    /// Walks a loop and adds up what it passes of each class.
    fn chain(&mut self, chain: &Loop, closing: &mut Closing) {
        // A loop names a compound link by its lead; its joints may be on others of the compound.
        let side = |joint, link| self.mechanism.side(joint, link);
        let last = chain.joints.len() - 1;
        let first = side(chain.joints[0], chain.bodies[0]);
        let (start, from) = self.end(first, chain.joints[0], chain.closed);
        let mut walk = Walk { body: first, here: from };
        let mut passed =
            Passed { classes: &self.classes, unknowns: &closing.unknowns, members: Vec::new(), rails: Vec::new() };
        for (&joint, sides) in chain.joints.iter().zip(chain.bodies.windows(2)) {
            let [body, next] = [sides[0], sides[1]].map(|link| side(joint, link));
            self.within(&mut passed, &mut walk, body);
            self.pass(&mut passed, &mut walk, joint, next);
        }
        let ends = if chain.closed {
            self.within(&mut passed, &mut walk, first);
            passed.pass(first, from - walk.here);
            None
        } else {
            let (end, there) = self.end(walk.body, chain.joints[last], false);
            passed.pass(walk.body, there - walk.here);
            Some([start, end])
        };
        let (mut members, mut rails) = (passed.members, passed.rails);
        // A known body at whose pin the loop begins or ends adds nothing.
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
        closing.chains.push(Chain { ends, members, rails, columns });
    }

    /// Walks over the driven sliders of a compound link to another of its bodies.
    fn within(&self, passed: &mut Passed, walk: &mut Walk, to: BodyId) {
        for driven in self.mechanism.way(walk.body, to) {
            self.pass(passed, walk, self.mechanism.slider_joint(driven.slider), driven.to);
        }
    }

    /// Walks over a joint to the body on its other side: to where it is on this body, along its guide if it has one, on from where it is on that body.
    fn pass(&self, passed: &mut Passed, walk: &mut Walk, joint: JointId, to: BodyId) {
        let [leave, arrive] = [walk.body, to].map(|body| self.mechanism.joint_on(joint, body));
        passed.pass(walk.body, leave - walk.here);
        if let Some(id) = self.mechanism.joint(joint).slider {
            let slider = self.mechanism.slider(id);
            let direction = self.in_class(slider.on, slider.line().1);
            passed.slide(walk.body, id.0, if slider.on == walk.body { direction } else { -direction });
        }
        *walk = Walk { body: to, here: arrive };
    }

    /// Where a loop begins or ends on a known body: at the pin, or at the body's first place.
    fn end(&self, body: BodyId, joint: JointId, closed: bool) -> (usize, Point) {
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

/// Where a walk along a loop stands: a body, and a place in its frame.
struct Walk {
    body: BodyId,
    here: Point,
}

/// What a walk along a loop has passed so far.
struct Passed<'a> {
    classes: &'a [(usize, Turn)],
    unknowns: &'a [Unknown],
    members: Vec<Member>,
    rails: Vec<Rail>,
}

impl Passed<'_> {
    fn unknown(&self, unknown: Unknown) -> Option<usize> {
        self.unknowns.iter().position(|u| *u == unknown)
    }

    /// Adds a vector of a body to the member of its class.
    fn pass(&mut self, body: BodyId, local: Vector) {
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

    /// Adds a slider on a guide of the body's class.
    fn slide(&mut self, body: BodyId, slider: usize, direction: Vector) {
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
