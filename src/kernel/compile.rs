use super::action::{
    Action, Chain, Closing, Input, InputKind, Kernel, Member, Placing, Rail, Reducing, Seat, Shape, Tied, TiedClass,
    TiedSlide, Unknown,
};
use super::classes::classes;
use super::lengths::{Column, Recipe, Span, Spot, Sum, Way, ZERO, total};
use crate::geometry::{Turn, Vector};
use crate::mechanism::{
    AngularConstraint, Body, BodyId, GROUND, Group, Joint, JointId, Loop, LoopEquations, Mechanism, PointId, Reduction,
    Role, SliderId,
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
    /// By body: its class.
    classes: Vec<usize>,
    /// By body: its rotation in its class.
    turns: Vec<Turn>,
    /// By body: slot and place of its first point.
    anchors: Vec<Option<(usize, Spot)>>,
    placed: Vec<bool>,
    kernel: Kernel,
}

impl<'a> Compiler<'a> {
    fn new(mechanism: &'a Mechanism) -> Self {
        let (classes, turns) = classes(mechanism);
        let points = mechanism.points.len();
        let recipe = Recipe { turns, ..Recipe::default() };
        Self {
            turns: recipe.turns(mechanism),
            mechanism,
            anchors: vec![None; mechanism.bodies.len()],
            placed: vec![false; points],
            kernel: Kernel {
                seats: Vec::new(),
                inputs: Vec::new(),
                unknowns: Vec::new(),
                classes: classes.iter().map(|class| class + 1).max().unwrap_or(1),
                sliders: mechanism.sliders.len(),
                loops: mechanism.groups.iter().map(|g| g.loops.len()).max().unwrap_or(0),
                ties: 0,
                slots: points,
                fixed: Vec::new(),
                lengths: recipe.nothing(),
                recipe,
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
                    self.place_body(id, pivot.0, self.spot(id, pivot));
                    let class = self.classes[id.0];
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
        let seat = |(class, anchor): (&usize, &Option<(usize, Spot)>)| {
            let (slot, spot) = anchor.unwrap_or((0, Spot::Origin));
            Seat { class: *class, slot, spot }
        };
        self.kernel.seats = self.classes.iter().zip(&self.anchors).map(seat).collect();
        let Kernel { recipe, lengths, .. } = &mut self.kernel;
        *lengths = recipe.nothing();
        recipe.measure(mechanism, lengths, 0);
        self.kernel
    }

    /// A point of a body.
    fn spot(&self, body: BodyId, point: PointId) -> Spot {
        let index = self.mechanism.body(body).points.iter().position(|p| *p == point);
        index.map_or(Spot::Origin, Spot::Point)
    }

    /// The place of a joint on one of its bodies, as [`Mechanism::joint_on`] has it.
    fn joint_on(&self, joint: JointId, body: BodyId) -> Spot {
        match self.mechanism.joint(joint).slider {
            Some(id) if self.mechanism.slider(id).on == body => Spot::Guide(id),
            _ => self.spot(body, self.mechanism.joint_point(joint)),
        }
    }

    fn place_ground(&mut self, body: &Body) {
        for (index, point) in body.points.iter().enumerate().take(body.local.len()) {
            self.fix(point.0, Spot::Point(index));
            self.placed[point.0] = true;
        }
        // A ground without points is represented by a point of its first guide.
        let mut sliders = self.mechanism.slider_ids();
        let guide = sliders.find(|slider| self.mechanism.slider(*slider).on == GROUND);
        if let (None, Some(guide)) = (self.anchors[GROUND.0], guide) {
            let slot = self.new_slot();
            self.fix(slot, Spot::Guide(guide));
        }
    }

    /// Gives a slot to a place of the ground.
    fn fix(&mut self, slot: usize, spot: Spot) {
        self.kernel.fixed.push(slot);
        self.kernel.recipe.fixed.push(spot);
        self.anchors[GROUND.0].get_or_insert((slot, spot));
    }

    fn new_slot(&mut self) -> usize {
        self.kernel.slots += 1;
        self.kernel.slots - 1
    }

    /// Makes a placed point the body's first one, and places the body's other points relative to it.
    fn place_body(&mut self, body: BodyId, slot: usize, spot: Spot) {
        self.anchors[body.0] = Some((slot, spot));
        let placed_body = self.mechanism.body(body);
        for (index, point) in placed_body.points.iter().enumerate().take(placed_body.local.len()) {
            if !self.placed[point.0] && point.0 != slot {
                self.place(point.0, slot, Span { body, from: spot, to: Spot::Point(index) }, None);
            }
        }
    }

    fn place(&mut self, to: usize, from: usize, span: Span, way: Option<Way>) {
        let class = self.classes[span.body.0];
        let (reach, slide) = (self.kernel.recipe.reaches.len(), way.map(|way| way.slider.0));
        self.kernel.recipe.reaches.push(span);
        self.kernel.recipe.guides.push(way);
        self.kernel.actions.push(Action::Place(Placing { to, from, class, slide, reach }));
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
                self.place_body(to, point.0, self.joint_on(joint, to));
            }
            if let Some(id) = slider {
                self.place_across(id, from, to);
            }
        }
    }

    /// Places body `to`, which a slider connects with the placed body `from`.
    fn place_across(&mut self, id: SliderId, from: BodyId, to: BodyId) {
        let slider = self.mechanism.slider(id);
        let through = Spot::Guide(id);
        let (slot, anchor) = self.anchors[from.0].unwrap_or((0, Spot::Origin));
        if slider.on == from {
            // A link without points slides: its place gets a slot of its own.
            let has_point = self.mechanism.body(to).points.contains(&slider.at);
            let slot_at = if has_point { slider.at.0 } else { self.new_slot() };
            if !has_point || !self.placed[slot_at] {
                let span = Span { body: from, from: anchor, to: through };
                self.place(slot_at, slot, span, Some(Way { slider: id, is_back: false }));
            }
            self.place_body(to, slot_at, self.spot(slider.link, slider.at));
        } else {
            let to_body = self.mechanism.body(to);
            let mut points = to_body.points.iter().enumerate().take(to_body.local.len());
            let (next, spot) = match points.find(|(_, point)| !self.placed[point.0]) {
                Some((index, point)) => (point.0, Spot::Point(index)),
                None => (self.new_slot(), through),
            };
            // The guide's point is the sliding point less the slide.
            let behind = Way { slider: id, is_back: true };
            let from_slot = self.slot_of(from, slider.at.0);
            self.place(next, from_slot, Span { body: to, from: through, to: spot }, Some(behind));
            self.place_body(to, next, spot);
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
                unknowns[unknown] = Unknown::Spin(self.classes[link.0]);
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
            size: f64::MIN_POSITIVE,
            scales: Vec::new(),
        };
        for chain in &group.loops {
            self.compile_loop(chain, &mut closing);
        }
        for travel in group.gears(self.mechanism).filter_map(|tie| tie.travel.as_ref()) {
            closing.size = closing.size.max(travel.radius);
        }
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
        let mut tied = Tied { classes: Vec::new(), slides: Vec::new(), apart: angle(tie.constant) };
        if let Some(travel) = &tie.travel {
            tied.apart -= travel.start / travel.radius;
            tied.slides.extend(travel.slides.iter().map(|&(SliderId(slider), sign)| TiedSlide {
                slider,
                weight: -sign / travel.radius,
                slide: unknowns.iter().position(|u| *u == Unknown::Slide(slider)),
            }));
        }
        for &(body, weight) in &tie.terms {
            let class = self.classes[body.0];
            let spin = unknowns.iter().position(|u| *u == Unknown::Spin(class));
            let weight = f64::from(weight);
            tied.classes.push(TiedClass { class, weight, spin });
            tied.apart -= weight * angle(self.turns[body.0]);
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
        let mut sums = LoopSums {
            classes: &self.classes,
            unknowns: &closing.unknowns,
            members: Vec::new(),
            rails: Vec::new(),
            ways: Vec::new(),
        };
        for (&joint, sides) in chain.joints.iter().zip(chain.bodies.windows(2)) {
            let [body, next] = [sides[0], sides[1]].map(|link| side(joint, link));
            self.walk_compound(&mut sums, &mut walk, body);
            self.walk_joint(&mut sums, &mut walk, joint, next);
        }
        let ends = if chain.closed {
            self.walk_compound(&mut sums, &mut walk, first);
            sums.add_vector(Span { body: first, from: walk.here, to: from });
            None
        } else {
            let (end, there) = self.loop_end(walk.body, chain.joints[last], false);
            sums.add_vector(Span { body: walk.body, from: walk.here, to: there });
            Some([start, end])
        };
        let LoopSums { members: summed, mut rails, ways, .. } = sums;
        let recipe = &mut self.kernel.recipe;
        let mut members = Vec::with_capacity(summed.len());
        for (mut member, sum) in summed {
            let vector = total(&sum, self.mechanism, |body| self.turns[body.0]);
            // A class whose vector vanishes and that has no slider contributes nothing: a known body with a pin at the
            // loop's end.
            if vector == Vector::zeros() && !rails.iter().any(|r: &Rail| r.class == member.class) {
                recipe.vanishing.push(sum);
                continue;
            }
            closing.size = closing.size.max(vector.x.abs()).max(vector.y.abs());
            member.column = recipe.add_column(Column::Member(sum));
            for rail in rails.iter_mut().filter(|r| r.class == member.class) {
                rail.arm = member.column;
            }
            members.push(member);
        }
        for (rail, way) in rails.iter_mut().zip(ways) {
            rail.column = recipe.add_column(Column::Guide(way));
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
        let [leave, arrive] = [walk.body, to].map(|body| self.joint_on(joint, body));
        sums.add_vector(Span { body: walk.body, from: walk.here, to: leave });
        if let Some(slider) = self.mechanism.joint(joint).slider {
            sums.add_slider(walk.body, Way { slider, is_back: self.mechanism.slider(slider).on != walk.body });
        }
        *walk = Walk { body: to, here: arrive };
    }

    /// Slot and place of a loop's end on a known body: its pin, or the body's first point at a slider.
    fn loop_end(&self, body: BodyId, joint: JointId, closed: bool) -> (usize, Spot) {
        match self.mechanism.joint(joint).pin {
            Some(point) => (point.0, self.joint_on(joint, body)),
            None if closed => (0, Spot::Origin),
            None => self.anchors[body.0].unwrap_or((0, Spot::Origin)),
        }
    }
}

/// The angle of a rotation in radians.
fn angle(turn: Turn) -> f64 {
    libm::atan2(turn.im, turn.re)
}

/// Present place of a walk along a loop.
struct Walk {
    body: BodyId,
    here: Spot,
}

/// The vectors and sliders of a loop, summed by class during a walk.
struct LoopSums<'a> {
    classes: &'a [usize],
    unknowns: &'a [Unknown],
    members: Vec<(Member, Sum)>,
    rails: Vec<Rail>,
    /// By rail: its unit vector, positive along the loop.
    ways: Vec<Way>,
}

impl LoopSums<'_> {
    fn unknown(&self, unknown: Unknown) -> Option<usize> {
        self.unknowns.iter().position(|u| *u == unknown)
    }

    /// Adds a vector to the member of its class.
    fn add_vector(&mut self, span: Span) {
        let class = self.classes[span.body.0];
        let index = self.members.iter().position(|(member, _)| member.class == class);
        let index = index.unwrap_or_else(|| {
            let member = Member { class, spin: self.unknown(Unknown::Spin(class)), column: ZERO };
            self.members.push((member, Sum::new()));
            self.members.len() - 1
        });
        self.members[index].1.push(span);
    }

    /// Adds a slider whose guide has the rotation of the body's class.
    fn add_slider(&mut self, body: BodyId, way: Way) {
        let (class, slider) = (self.classes[body.0], way.slider.0);
        self.rails.push(Rail {
            class,
            slider,
            spin: self.unknown(Unknown::Spin(class)),
            slide: self.unknown(Unknown::Slide(slider)),
            arm: ZERO,
            column: ZERO,
        });
        self.ways.push(way);
    }
}
