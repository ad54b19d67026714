//! Velocity and acceleration of a body's point, laid off in a plan: from the pole where the scene gives the vector,
//! else from a point of known motion.

use super::arrow::{Arrow, VectorOf, VectorPart};
use super::name::{coriolis_name, point_on, slide_name};
use super::number::{NumberId, NumberKind, Product, ProductKind, Rate};
use super::operation::{Along, PlaceId};
use super::plan::PointRole;
use super::step::Action;
use super::writer::Writer;
use crate::geometry::{Pair, UNIT_ROUNDOFF, unit};
use crate::mechanism::{BodyId, Carried, DrivenSlide, Group, JointId, PointId, Role};
use crate::sheet::Order;

impl Writer<'_> {
    /// Takes the given rates of bodies and of driven sliders from the scene.
    pub(super) fn take_known_rates(&mut self) {
        let mechanism = self.mechanism;
        for body in mechanism.body_ids() {
            let root = mechanism.body(mechanism.root(body));
            let rates = match root.role {
                Role::Ground => [0.0, 0.0],
                Role::Driver { omega, alpha, .. } | Role::Moving { omega, alpha, .. } => [omega, alpha],
                Role::Pushed { .. } | Role::Carrier { .. } | Role::Unsolved | Role::Member => continue,
            };
            let numbers = Order::ALL.map(|order| self.take_given(Rate::Angular(order, body), rates[order]));
            self.construction.angular_rates[body.0] = Some(numbers);
        }
        for id in mechanism.slider_ids() {
            if let Some(drive) = mechanism.slider(id).drive {
                let rates = [drive.speed, drive.acceleration];
                let numbers = Order::ALL.map(|order| self.take_given(Rate::Slide(order, id), rates[order]));
                self.construction.slide_rates[id.0] = Some(numbers);
            }
        }
    }

    /// The number of a rate that the scene gives; none for zero.
    fn take_given(&mut self, rate: Rate, value: f64) -> Option<NumberId> {
        self.take(true, rate.order(), NumberKind::Rate(rate), value)
    }

    /// The end of the velocity or acceleration of the body's point at `point` in a plan.
    pub(crate) fn motion(&mut self, order: Order, body: BodyId, point: PointId) -> PlaceId {
        if let Some(place) = self.place_of_motion(order, body, point) {
            return place;
        }
        let place = match self.mechanism.is_known(body) {
            true => self.known_motion(order, body, point),
            false => self.connected_motion(order, body, point),
        };
        // No construction reaches it: it is taken from the computed motion.
        let place = place.unwrap_or_else(|| self.computed_motion(false, order, body, point));
        self.construction.record.note_motion(order, body, point, place);
        place
    }

    pub(crate) fn place_of_motion(&self, order: Order, body: BodyId, point: PointId) -> Option<PlaceId> {
        self.construction.record.motions.get(&(order, body, point)).copied()
    }

    fn known_motion(&mut self, order: Order, body: BodyId, point: PointId) -> Option<PlaceId> {
        let (mechanism, pole) = (self.mechanism, self.pole_of(order)?);
        match mechanism.body(body).role {
            Role::Ground => Some(pole),
            Role::Driver { pivot, .. } => self.add_rotation(order, body, (pivot, pole), point),
            Role::Pushed { .. } => {
                let root = mechanism.root(body);
                let start = self.motion(order, root, point);
                self.add_slides(order, start, &mechanism.slides_between(root, body))
            }
            // The scene gives the vector itself.
            _ => Some(self.computed_motion(true, order, body, point)),
        }
    }

    /// Lays off a vector from the pole with size and direction of the computed motion; `by_hand` where the scene gives
    /// it.
    fn computed_motion(&mut self, by_hand: bool, order: Order, body: BodyId, point: PointId) -> PlaceId {
        let (motion, at) = (self.motion.body(body), self.pose.point(point));
        let errors = self.motion.error(body);
        let arm = (at - motion.at).norm();
        // The vector, the error that it inherits from the motion, and the size of the relative motion in it, which adds
        // rounding.
        let (vector, error, size) = match order {
            Order::Velocity => {
                let error = errors.velocity.norm() + errors.omega * arm;
                (motion.velocity_at(at), error, motion.swing(at).norm())
            }
            Order::Acceleration => {
                let turned = motion.normal(at).norm() + motion.tangential(at).norm();
                let error = errors.acceleration.norm() + (errors.alpha + 2.0 * motion.omega.abs() * errors.omega) * arm;
                (motion.acceleration_at(at), error, turned)
            }
        };
        let pole = self.pole_of(order).expect("every plan has a pole");
        let Some(number) = self.take(by_hand, order, NumberKind::Size, vector.norm()) else {
            return pole;
        };
        let along = Along::given(unit(vector).unwrap_or_default());
        let place = self.lay_off(order, pole, vec![Product::plain(number)], along);
        let error = error + 8.0 * UNIT_ROUNDOFF * (vector.norm() + size);
        self.construction.record.exact.places[place.0] = Pair::within(vector, error);
        place
    }

    /// Constructs the point's motion from another point of the body, from the neighbour to which the body is anchored,
    /// or from a link of the same compound link; `None` where the motion of none of these is in the plan.
    fn connected_motion(&mut self, order: Order, body: BodyId, point: PointId) -> Option<PlaceId> {
        self.construction.angular_rates[body.0]?;
        let mechanism = self.mechanism;
        if let Some(&(from, place)) = self.construction.record.first_motions.get(&(order, body)) {
            return self.add_rotation(order, body, (from, place), point);
        }
        if let Some(&(joint, from)) = self.construction.record.anchors.get(&body) {
            let at = mechanism.joint_point(joint);
            let mut place = self.motion(order, from, at);
            if let Some(slider) = mechanism.joint(joint).slider {
                let guide_first = mechanism.slider(slider).on == from;
                let slide = DrivenSlide { slider, from, to: body, sign: if guide_first { 1.0 } else { -1.0 } };
                place = self.add_slides(order, place, &[slide])?;
            }
            self.construction.record.note_motion(order, body, at, place);
            return self.add_rotation(order, body, (at, place), point);
        }
        // Driven sliders connect the body with an anchored link of its compound link.
        let root = mechanism.root(body);
        let mut others = mechanism.compound(root).into_iter();
        let record = &self.construction.record;
        let is_there = |b: &BodyId| record.anchors.contains_key(b) || record.first_motions.contains_key(&(order, *b));
        let other = others.find(|b| *b != body && is_there(b))?;
        let start = self.motion(order, other, point);
        self.add_slides(order, start, &mechanism.slides_between(other, body))
    }

    /// Adds the relative motion of two points of one body, ω × r or α × r − ω² r, to `place`; `None` where the body's
    /// rates are unknown.
    fn add_rotation(
        &mut self,
        order: Order,
        body: BodyId,
        (from, place): (PointId, PlaceId),
        to: PointId,
    ) -> Option<PlaceId> {
        let [omega, alpha] = self.construction.angular_rates[body.0]?;
        let at_rest = omega.is_none() && alpha.is_none();
        // Two pins may coincide.
        if from == to || at_rest || self.pose.arm(from, to).norm() == 0.0 {
            return Some(place);
        }
        let line = Along::line(self.join(from, to));
        let length = self.length(from, to);
        let [from, to] = [from, to].map(|point| point_on(self.mechanism, body, point));
        let of = |part| VectorOf::Relative { link: body, from: from.clone(), to: to.clone(), part };
        let turned = |rate: Option<_>| {
            rate.map(|rate| Product::new(ProductKind::Turning, 1.0, &[rate, length])).into_iter().collect()
        };
        let place = match order {
            Order::Velocity => self.lay_off_part(order, place, turned(omega), line.turned(1), of(VectorPart::Relative)),
            Order::Acceleration => {
                let normal = omega.map(|omega| Product::new(ProductKind::Normal, -1.0, &[omega, omega, length]));
                let normal = normal.into_iter().collect();
                let place = self.lay_off_part(order, place, normal, line, of(VectorPart::Normal));
                self.lay_off_part(order, place, turned(alpha), line.turned(1), of(VectorPart::Tangential))
            }
        };
        Some(place)
    }

    /// Lays off a vector and notes its meaning.
    fn lay_off_part(&mut self, order: Order, start: PlaceId, sum: Vec<Product>, along: Along, of: VectorOf) -> PlaceId {
        let end = self.lay_off(order, start, sum, along);
        if end != start {
            self.construction.record.laid_off.entry(end).or_insert((start, of));
        }
        end
    }

    /// Adds the relative motions of driven sliders, one after another; `None` where a rate is unknown.
    fn add_slides(&mut self, order: Order, mut place: PlaceId, slides: &[DrivenSlide]) -> Option<PlaceId> {
        for slide in slides {
            for &part in VectorPart::of_slide(order) {
                place = self.lay_off_slide_part(order, place, slide, part)?;
            }
        }
        Some(place)
    }

    /// Lays off the relative motions of driven sliders from the plan point `start` on, each vector in a step of its
    /// own. Returns name and place of the last end, which is called `last` if that is given. Vectors already in the
    /// plan and zero vectors are not laid off.
    pub(super) fn driven_slides(
        &mut self,
        order: Order,
        start: (String, PlaceId),
        slides: &[DrivenSlide],
        role: PointRole,
        last: Option<&str>,
    ) -> (String, PlaceId) {
        let mut entered = String::new();
        let mut vectors: Vec<(String, DrivenSlide, VectorPart)> = Vec::new();
        for slide in slides {
            entered.push_str(&self.mechanism.body(slide.to).name);
            for &part in VectorPart::of_slide(order) {
                let name = if part == VectorPart::Coriolis { coriolis_name } else { slide_name };
                if self.slide_part_size(order, slide, part).is_some_and(|sum| !sum.is_empty()) {
                    vectors.push((name(&start.0, &entered), *slide, part));
                }
            }
        }
        if let (Some((name, ..)), Some(last)) = (vectors.last_mut(), last) {
            *name = last.to_owned();
        }
        let (mut from, mut place) = start;
        for (to, slide, part) in vectors {
            let known = self.construction.place(order, &to).filter(|_| self.shows(order, &to));
            place = match known {
                Some(known) => known,
                None => {
                    let of = VectorOf::Passed(slide, part);
                    let step = self.begin(order);
                    let place = self.lay_off_slide_part(order, place, &slide, part).unwrap_or(place);
                    self.show(order, &to, place, role);
                    self.finish(step, Action::LayOff(Arrow { order, from, to: to.clone(), of }));
                    place
                }
            };
            from = to;
        }
        (from, place)
    }

    /// Lays off a slider's relative velocity or acceleration from `place`; returns its end.
    pub(super) fn lay_off_slide_part(
        &mut self,
        order: Order,
        place: PlaceId,
        slide: &DrivenSlide,
        part: VectorPart,
    ) -> Option<PlaceId> {
        let guide = Along::line(self.guide(slide.slider));
        let along = if part == VectorPart::Coriolis { guide.turned(1) } else { guide };
        let sum = self.slide_part_size(order, slide, part)?;
        Some(self.lay_off_part(order, place, sum, along, VectorOf::Passed(*slide, part)))
    }

    /// The signed size of a slider's relative velocity or acceleration: an empty sum for zero, `None` where a rate is
    /// unknown.
    pub(super) fn slide_part_size(&self, order: Order, slide: &DrivenSlide, part: VectorPart) -> Option<Vec<Product>> {
        let rates = self.construction.slide_rates[slide.slider.0]?;
        let product = match part {
            VectorPart::Coriolis => {
                // Both bodies of a slider turn alike.
                let turning = &self.construction.angular_rates;
                let [omega, _] = turning[slide.to.0].or(turning[slide.from.0])?;
                let both = omega.zip(rates[0]);
                both.map(|(omega, rate)| Product::new(ProductKind::Coriolis, 2.0 * slide.sign, &[omega, rate]))
            }
            _ => rates[order].map(|rate| Product::new(ProductKind::Sliding, slide.sign, &[rate])),
        };
        Some(product.into_iter().collect())
    }

    /// Notes an anchor for each link, whose motion can follow from that joint once the rates are known.
    pub(super) fn note_anchors(&mut self, group: &Group) {
        let mechanism = self.mechanism;
        let legs = || group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg)));
        for (special, leg) in legs() {
            let link = leg.carried.map_or_else(|| mechanism.lead(special.link), |carried| carried.carrier);
            let outer = mechanism.side(leg.outer, link);
            self.construction.record.anchors.entry(outer).or_insert((leg.outer, leg.base));
        }
        for (special, leg) in legs() {
            if let Some(Carried { carrier, inner }) = leg.carried {
                let holder = mechanism.side(inner, mechanism.lead(special.link));
                let from = mechanism.side(inner, carrier);
                self.construction.record.anchors.entry(holder).or_insert((inner, from));
            }
        }
        for (joint, from, link) in group.hanging(mechanism) {
            let [from, holder] = [from, link].map(|body| mechanism.side(joint, body));
            self.construction.record.anchors.entry(holder).or_insert((joint, from));
        }
        while let Some((link, anchor)) = self.next_anchor(group) {
            self.construction.record.anchors.insert(link, anchor);
        }
    }

    /// A joint of the group from a body that is known or has an anchor to a link that no leg reaches, as in a group of
    /// higher class. Pins go before sliders.
    fn next_anchor(&self, group: &Group) -> Option<(BodyId, (JointId, BodyId))> {
        let mechanism = self.mechanism;
        let is_anchored = |body: BodyId| {
            let mut bodies = mechanism.compound(mechanism.root(body)).into_iter();
            !group.bodies.contains(&body) || bodies.any(|other| self.construction.record.anchors.contains_key(&other))
        };
        let mut joints = mechanism.joints_of(group);
        joints.retain(|&joint| mechanism.joint(joint).holds_places());
        joints.sort_by_key(|&joint| mechanism.joint(joint).pin.is_none());
        joints.into_iter().find_map(|joint| {
            let [a, b] = mechanism.joint(joint).bodies;
            let (from, link) = match (is_anchored(a), is_anchored(b)) {
                (true, false) => (a, b),
                (false, true) => (b, a),
                _ => return None,
            };
            Some((link, (joint, from)))
        })
    }
}
