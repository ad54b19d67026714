use super::action::{
    Action, Closing, Input, InputKind, Kernel, Placing, Reducing, Seat, Shape, Tied, TiedClass, TiedSlide, Unknown,
};
use super::classes::classes;
use super::lengths::{Recipe, Span, Spot, Way};
use crate::geometry::Turn;
use crate::mechanism::{
    AngularConstraint, Body, BodyId, GROUND, Group, Joint, JointId, LoopEquations, Mechanism, PointId, Reduction, Role,
    SliderId,
};
use crate::scene::GivenBy;

impl Kernel {
    /// The kernel of `mechanism`; `None` for a drawn configuration, which has one position only.
    #[must_use]
    pub fn new(mechanism: &Mechanism) -> Option<Kernel> {
        (mechanism.given_by == GivenBy::Lengths).then(|| Compiler::new(mechanism).run())
    }
}

pub(super) struct Compiler<'a> {
    pub(super) mechanism: &'a Mechanism,
    /// By body: its class.
    pub(super) classes: Vec<usize>,
    /// By body: its rotation in its class.
    pub(super) turns: Vec<Turn>,
    /// By body: slot and place of its first point.
    pub(super) anchors: Vec<Option<(usize, Spot)>>,
    placed: Vec<bool>,
    pub(super) kernel: Kernel,
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
    pub(super) fn joint_on(&self, joint: JointId, body: BodyId) -> Spot {
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
        let mut tied = Tied { classes: Vec::new(), slides: Vec::new(), apart: angle(tie.constant.rounded()) };
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
}

/// The angle of a rotation in radians.
fn angle(turn: Turn) -> f64 {
    libm::atan2(turn.im, turn.re)
}
