//! The motion of a body's point, laid off in a plan: from the pole where the scene gives it, else from a point that is there.

use super::name::{coriolis_name, slide_name};
use super::operation::{Along, NumberKind, PlaceId, Product, ProductKind, Rate, Sheet};
use super::step::{Action, Added, Arrow, PointRole, VectorOf};
use super::writer::Writer;
use crate::geometry::{Ball, Pair, UNIT_ROUNDOFF, unit};
use crate::mechanism::{BodyId, DrivenSlide, JointId, JointKind, PointId, Role, SliderId};

/// How a body hangs on one whose motion is there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    /// The joint.
    pub joint: JointId,
    /// The body on its other side.
    pub from: BodyId,
}

impl Writer<'_> {
    /// The rates that the scene gives: of bodies and of driven sliders.
    pub(super) fn take_known_rates(&mut self) {
        let mechanism = self.mechanism;
        for body in (0..mechanism.bodies.len()).map(BodyId) {
            let root = mechanism.body(mechanism.root(body));
            let rates = match root.role {
                Role::Ground => [0.0, 0.0],
                Role::Driver { omega, alpha, .. } | Role::Moving { omega, alpha, .. } => [omega, alpha],
                Role::Pushed { .. } | Role::Carrier { .. } | Role::Stub | Role::Member => continue,
            };
            let omega = self.take(Sheet::Velocity, NumberKind::Rate(Rate::Omega(body)), rates[0]);
            let alpha = self.take(Sheet::Acceleration, NumberKind::Rate(Rate::Alpha(body)), rates[1]);
            self.construction.spins[body.0] = Some([omega, alpha]);
        }
        for id in (0..mechanism.sliders.len()).map(SliderId) {
            if let Some(drive) = mechanism.slider(id).drive {
                let velocity = self.take(Sheet::Velocity, NumberKind::Rate(Rate::SlideVelocity(id)), drive.speed);
                let rate = NumberKind::Rate(Rate::SlideAcceleration(id));
                let acceleration = self.take(Sheet::Acceleration, rate, drive.acceleration);
                self.construction.slides[id.0] = Some([velocity, acceleration]);
            }
        }
    }

    /// The end of the vector of the body's point at `point` in a plan.
    pub(crate) fn motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> PlaceId {
        if let Some(place) = self.moved_point(sheet, body, point) {
            return place;
        }
        let place = match self.mechanism.is_known(body) {
            true => self.known_motion(sheet, body, point),
            false => self.found_motion(sheet, body, point),
        };
        let place = place.unwrap_or_else(|| self.taken_motion(sheet, body, point));
        self.note_motion(sheet, body, point, place);
        place
    }

    pub(crate) fn moved_point(&self, sheet: Sheet, body: BodyId, point: PointId) -> Option<PlaceId> {
        let mut moved = self.moved.iter();
        let found = moved.find(|m| (m.0, m.1, m.2) == (sheet, body, point));
        found.map(|m| m.3)
    }

    fn known_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> Option<PlaceId> {
        let (mechanism, pole) = (self.mechanism, self.pole_of(sheet)?);
        match mechanism.body(body).role {
            Role::Ground => Some(pole),
            Role::Driver { pivot, .. } => self.turn(sheet, body, (pivot, pole), point),
            Role::Pushed { .. } => {
                let root = mechanism.root(body);
                let start = self.motion(sheet, root, point);
                self.slides(sheet, start, &mechanism.way(root, body))
            }
            // Given as a vector.
            _ => Some(self.given_motion(sheet, body, point)),
        }
    }

    /// A vector as the motion has it.
    fn given_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> PlaceId {
        let (motion, at) = (self.motion.body(body), self.pose.point(point));
        let errors = self.motion.error(body);
        let swing = motion.swing(at).norm();
        // The place's vector, and how exactly it is known: by the motion's errors and some roundings of what was added up.
        let (vector, error, size) = match sheet {
            Sheet::Acceleration => {
                let turned = motion.normal(at).norm() + motion.tangential(at).norm();
                let arm = (at - motion.at).norm();
                let error = errors.acceleration.norm() + (errors.alpha + 2.0 * motion.omega.abs() * errors.omega) * arm;
                (motion.acceleration_at(at), error, turned)
            }
            _ => {
                let error = errors.velocity.norm() + errors.omega * (at - motion.at).norm();
                (motion.velocity_at(at), error, swing)
            }
        };
        let pole = self.pole_of(sheet).expect("every plan has a pole");
        let Some(number) = self.take(sheet, NumberKind::Size, vector.norm()) else {
            return pole;
        };
        let along = Along::given(unit(vector).unwrap_or_default());
        let place = self.lay_off(sheet, pole, vec![Product::plain(number)], along);
        let error = error + 8.0 * UNIT_ROUNDOFF * (vector.norm() + size);
        let Pair { x, y } = Pair::<Ball>::from(vector);
        self.exact.set_place(place, Pair { x: x.widened(error), y: y.widened(error) });
        place
    }

    /// The vector of a point that no construction reaches: beyond what a hand finds.
    fn taken_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> PlaceId {
        let by_hand = core::mem::replace(&mut self.by_hand, false);
        let place = self.given_motion(sheet, body, point);
        self.by_hand = by_hand;
        place
    }

    /// From another point of the body that is in the plan, from the body on which it hangs, or from a link of its compound.
    fn found_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> Option<PlaceId> {
        self.construction.spins[body.0]?;
        let mechanism = self.mechanism;
        let own = |m: &&(Sheet, BodyId, PointId, PlaceId)| (m.0, m.1) == (sheet, body);
        if let Some(&(.., from, place)) = self.moved.iter().find(own) {
            return self.turn(sheet, body, (from, place), point);
        }
        if let Some(Anchor { joint, from }) = self.anchors[body.0] {
            let at = mechanism.joint_point(joint);
            let mut place = self.motion(sheet, from, at);
            if let JointKind::Prismatic(slider) = mechanism.joint(joint).kind {
                let guide_first = mechanism.slider(slider).on == from;
                let slide = DrivenSlide { slider, from, to: body, sign: if guide_first { 1.0 } else { -1.0 } };
                place = self.slides(sheet, place, &[slide])?;
            }
            self.note_motion(sheet, body, at, place);
            return self.turn(sheet, body, (at, place), point);
        }
        // Driven sliders join it to a link that hangs on something.
        let root = mechanism.root(body);
        let mut others = mechanism.compound(root).into_iter();
        let is_there = |b: &BodyId| {
            let moved = || self.moved.iter().any(|m| (m.0, m.1) == (sheet, *b));
            self.anchors[b.0].is_some() || moved()
        };
        let other = others.find(|b| *b != body && is_there(b))?;
        let start = self.motion(sheet, other, point);
        self.slides(sheet, start, &mechanism.way(other, body))
    }

    /// What the rotation of a body adds from one of its points to another.
    fn turn(&mut self, sheet: Sheet, body: BodyId, (from, place): (PointId, PlaceId), to: PointId) -> Option<PlaceId> {
        let [omega, alpha] = self.construction.spins[body.0]?;
        let at_rest = omega.is_none() && alpha.is_none();
        // Two pins may have one place.
        if from == to || at_rest || self.pose.arm(from, to).norm() == 0.0 {
            return Some(place);
        }
        let line = Along::line(self.join(from, to));
        let length = self.length(from, to);
        let turned = |rate| vec![Product::new(ProductKind::Turning, 1.0, &[rate, length])];
        if sheet == Sheet::Velocity {
            return Some(self.lay_off(sheet, place, omega.map(turned).unwrap_or_default(), line.turned(1)));
        }
        let normal = omega.map(|omega| vec![Product::new(ProductKind::Normal, -1.0, &[omega, omega, length])]);
        let place = self.lay_off(sheet, place, normal.unwrap_or_default(), line);
        Some(self.lay_off(sheet, place, alpha.map(turned).unwrap_or_default(), line.turned(1)))
    }

    /// What sliders add, one after the other; `None` where a rate is not there.
    fn slides(&mut self, sheet: Sheet, mut place: PlaceId, way: &[DrivenSlide]) -> Option<PlaceId> {
        for slide in way {
            for &added in Added::on(sheet) {
                place = self.added(sheet, place, slide, added)?;
            }
        }
        Some(place)
    }

    /// What driven sliders add from the plan point `start` on, each vector in a step of its own: name and place where the last one ends, which may be called
    /// `last`. Vectors that are there already, and those of nothing, are not laid off.
    pub(super) fn driven_slides(
        &mut self,
        sheet: Sheet,
        start: (String, PlaceId),
        way: &[DrivenSlide],
        role: PointRole,
        last: Option<&str>,
    ) -> (String, PlaceId) {
        let mut entered = String::new();
        let mut vectors: Vec<(String, DrivenSlide, Added)> = Vec::new();
        for slide in way {
            entered.push_str(&self.mechanism.body(slide.to).name);
            for &added in Added::on(sheet) {
                let name = if added == Added::Coriolis { coriolis_name } else { slide_name };
                if self.sum_of(slide, added).is_some_and(|sum| !sum.is_empty()) {
                    vectors.push((name(&start.0, &entered), *slide, added));
                }
            }
        }
        if let (Some((name, ..)), Some(last)) = (vectors.last_mut(), last) {
            *name = last.to_owned();
        }
        let (mut from, mut place) = start;
        for (to, slide, added) in vectors {
            let known = self.construction.place(sheet, &to).filter(|_| self.plan(sheet).points.contains_key(&to));
            place = match known {
                Some(known) => known,
                None => {
                    let of = VectorOf::Driven(slide, added);
                    self.begin(sheet, Action::LayOff(Arrow { from, to: to.clone(), of }));
                    let place = self.added(sheet, place, &slide, added).unwrap_or(place);
                    self.show(sheet, &to, place, role);
                    place
                }
            };
            from = to;
        }
        (from, place)
    }

    /// The end of what a slider adds, laid off from a place.
    fn added(&mut self, sheet: Sheet, place: PlaceId, slide: &DrivenSlide, added: Added) -> Option<PlaceId> {
        let guide = Along::line(self.guide(slide.slider));
        let along = if added == Added::Coriolis { guide.turned(1) } else { guide };
        let sum = self.sum_of(slide, added)?;
        Some(self.lay_off(sheet, place, sum, along))
    }

    /// The size of what a slider adds; empty for nothing, `None` where a rate is not there.
    fn sum_of(&self, slide: &DrivenSlide, added: Added) -> Option<Vec<Product>> {
        let [velocity, acceleration] = self.construction.slides[slide.slider.0]?;
        let sliding = |rate| Product::new(ProductKind::Sliding, slide.sign, &[rate]);
        let product = match added {
            Added::SlidingVelocity => velocity.map(sliding),
            Added::SlidingAcceleration => acceleration.map(sliding),
            Added::Coriolis => {
                let [omega, _] = self.construction.spins[slide.to.0]?;
                let both = omega.zip(velocity);
                both.map(|(omega, rate)| Product::new(ProductKind::Coriolis, 2.0 * slide.sign, &[omega, rate]))
            }
        };
        Some(product.into_iter().collect())
    }
}
