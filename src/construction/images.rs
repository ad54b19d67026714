//! Images of all points of a link whose motion is known: by the image theorem (the image of a link is similar to it,
//! turned and scaled; Mehmke 1883, Burmester 1888) from two images of the link, else by the motion relative to one. Of a
//! group the images of its joints come first, once its rates are known.

use super::arrow::{Arrow, Ray, RayOf, Relation, VectorOf, VectorPart};
use super::name::{coincident_name, coriolis_name, image_name, normal_name, point_on, slide_name};
use super::operation::{Along, OperationRole, PlaceId};
use super::plan::PointRole;
use super::step::Action;
use super::writer::Writer;
use crate::geometry::{Ball, Pair, cross};
use crate::mechanism::{BodyId, Carried, GROUND, Group, Leg, Mechanism, PointId, SliderId};
use crate::sheet::{Order, Sheet};

/// Least sine of the angle at a point between its arms to two others, for its image to be crossed by two rays.
const LEAST_SINE: f64 = 0.3;

/// Least distance of two images from which a third is constructed, in parts of the plan's longest vector.
const LEAST_BASE: f64 = 0.02;

/// How many points of a link are looked at for the two that give a third best.
const MOST_IMAGED: usize = 16;

/// A point of a link with its image in a plan.
#[derive(Clone)]
struct Imaged {
    point: PointId,
    name: String,
    place: PlaceId,
}

/// Name and role of the end of a part of a relative motion that leads on, laid off from the plan point `from`.
fn part_end(mechanism: &Mechanism, from: &str, of: &VectorOf) -> (String, PointRole) {
    match of {
        VectorOf::Relative { from, to, part: VectorPart::Normal, .. } => (normal_name(from, to), PointRole::Normal),
        VectorOf::Relative { to, .. } => (image_name(to), PointRole::Image),
        VectorOf::Passed(slide, VectorPart::Coriolis) => {
            (coriolis_name(from, &mechanism.body(slide.to).name), PointRole::Slid)
        }
        VectorOf::Passed(slide, _) => (slide_name(from, &mechanism.body(slide.to).name), PointRole::Slid),
        VectorOf::Point(..) | VectorOf::Normal(..) | VectorOf::Sliding(..) => (from.to_owned(), PointRole::Slid),
    }
}

impl Writer<'_> {
    /// Constructs the images of all points of a link that have none yet, in all plans.
    pub(super) fn further_images(&mut self, body: BodyId) {
        let mechanism = self.mechanism;
        for &order in self.orders() {
            let (mut imaged, mut are_first) = (Vec::new(), false);
            for (index, &point) in mechanism.body(body).points.iter().enumerate() {
                let name = image_name(mechanism.point_name(point));
                if self.shows(order, &name) {
                    continue;
                }
                if !are_first {
                    imaged = self.imaged(order, body);
                    // All points before this one have an image: those that are looked at remain the same.
                    are_first = index >= MOST_IMAGED;
                }
                let made = self.similar_image(order, body, point, &name, &imaged);
                if made.is_none() {
                    self.relative_image(order, body, point);
                }
            }
        }
    }

    /// The first points of a body that have an image in a plan.
    fn imaged(&mut self, order: Order, body: BodyId) -> Vec<Imaged> {
        let mechanism = self.mechanism;
        let under = mechanism.sliders.iter().filter(|slider| slider.on == body).map(|slider| slider.at);
        let mut found: Vec<Imaged> = Vec::new();
        for point in mechanism.body(body).points.iter().copied().chain(under) {
            if found.len() == MOST_IMAGED {
                break;
            }
            let name = image_name(&point_on(mechanism, body, point));
            let is_there = self.shows(order, &name) && found.iter().all(|f| f.point != point);
            if let (true, Some(place)) = (is_there, self.construction.place(order, &name)) {
                found.push(Imaged { point, name, place });
            }
        }
        found
    }

    /// The image of a point from those of two of these others of its link; `None` without two that give it well.
    fn similar_image(
        &mut self,
        order: Order,
        body: BodyId,
        point: PointId,
        name: &str,
        imaged: &[Imaged],
    ) -> Option<()> {
        let arm = |from: PointId| self.pose.arm(from, point);
        let mut best: Option<(f64, [&Imaged; 2])> = None;
        for (index, first) in imaged.iter().enumerate() {
            for second in &imaged[index + 1..] {
                let (a, b) = (arm(first.point), arm(second.point));
                let between = self.pose.arm(first.point, second.point);
                let coincide = [a, b, between].iter().any(|arm| arm.norm() <= self.near);
                if coincide {
                    continue;
                }
                let on_line = (cross(a, between) / between.norm()).abs() <= self.near;
                // A division is drawn most simply; between the two images it is most exact.
                let inside = if a.dot(&b) < 0.0 { 3.0 } else { 2.0 };
                let worth = if on_line { inside } else { (cross(a, b) / (a.norm() * b.norm())).abs() };
                let is_better = worth > best.as_ref().map_or(LEAST_SINE, |(worth, _)| *worth);
                if is_better && self.are_apart(order, first.place, second.place) {
                    best = Some((worth, [first, second]));
                }
            }
        }
        let (worth, pair) = best?;
        let place = match worth >= 2.0 {
            true => self.divided_image(order, body, point, name, pair),
            false => self.crossed_image(order, body, point, name, pair)?,
        };
        self.construction.record.note_motion(order, body, point, place);
        Some(())
    }

    /// Narrows the bounds of an image to those of the rotation about another point of its link, with the constructed
    /// rates. From crossing to crossing bounds would grow; the place that a hand draws stays the same.
    fn narrow(&mut self, order: Order, body: BodyId, point: PointId, place: PlaceId) {
        let base = self.construction.record.first_motions.get(&(order, body)).copied();
        let (Some((from, base)), Some(rates)) = (base, self.construction.angular_rates[body.0]) else {
            return;
        };
        let [omega, alpha] =
            rates.map(|rate| rate.map_or(Ball::default(), |rate| self.construction.record.exact.numbers[rate.0]));
        let arm = Pair::between(self.pose.point(from), self.pose.point(point));
        let turned = match order {
            Order::Velocity => arm.quarter_turn() * omega,
            Order::Acceleration => arm.quarter_turn() * alpha - arm * (omega * omega),
        };
        let rotated = self.construction.record.exact.places[base.0] + turned;
        if rotated.errors().norm() < self.construction.record.exact.places[place.0].errors().norm() {
            self.construction.record.exact.places[place.0] = rotated;
        }
    }

    /// Whether two plan points are so far apart that the image of their link can be drawn from them, in parts of the
    /// plan drawn so far.
    fn are_apart(&mut self, order: Order, a: PlaceId, b: PlaceId) -> bool {
        let between =
            (self.construction.record.exact.places[b.0] - self.construction.record.exact.places[a.0]).rounded();
        between.norm() > LEAST_BASE * self.plan(order).largest
    }

    /// The image of a point on the line of two others, by division of the line of their images.
    fn divided_image(&mut self, order: Order, body: BodyId, point: PointId, name: &str, pair: [&Imaged; 2]) -> PlaceId {
        let [first, second] = pair;
        let points = [first.point, second.point, point];
        let between = [first.name.clone(), second.name.clone()];
        let step = self.begin(order);
        let like = points.map(|point| self.plot(point));
        let place = self.divide(order, [first.place, second.place], like);
        self.narrow(order, body, point, place);
        self.show(order, name, place, PointRole::Image);
        self.finish(step, Action::Divide { point: name.to_owned(), between, points });
        place
    }

    /// The image of a point by two rays from the images of two others; `None` where they do not cross.
    fn crossed_image(
        &mut self,
        order: Order,
        body: BodyId,
        point: PointId,
        name: &str,
        pair: [&Imaged; 2],
    ) -> Option<PlaceId> {
        let base = {
            let [from, to] = pair.map(|end| end.place);
            self.join_places(Sheet::Scheme, OperationRole::Line, [from, to])
        };
        let side = self.join(pair[0].point, pair[1].point);
        let rays = [(pair[0], pair[1]), (pair[1], pair[0])].map(|(end, other)| {
            let arm = self.join(end.point, point);
            let (along, relation) = match order {
                Order::Velocity => (Along::line(arm).turned(1), Relation::Perpendicular),
                Order::Acceleration => (Along::angle(base, [side, arm]), Relation::Angle),
            };
            let of = RayOf::Arm { link: body, from: end.point, to: point, other: other.point };
            let (through, to) = (end.name.clone(), name.to_owned());
            let step = self.begin(order);
            let line = self.draw(order, OperationRole::Ray, end.place, along);
            let direction = self.construction.record.exact.lines[line.0].1.rounded();
            (line, step, self.construction.operations.len(), Ray { order, through, to, direction, relation, of })
        });
        let [a, b] = pair.map(|end| self.pose.arm(end.point, point));
        let sine = cross(a, b) / (a.norm() * b.norm());
        let from = pair.map(|end| end.name.clone());
        let step = self.begin(order);
        let place = self.cross(true, order, OperationRole::Image, rays.each_ref().map(|(line, ..)| *line))?;
        for (_, step, end, ray) in rays {
            self.take_step(step, end, Action::Ray(ray));
        }
        self.finish(step, Action::Cross { point: name.to_owned(), from, sine });
        self.narrow(order, body, point, place);
        self.show(order, name, place, PointRole::Image);
        Some(place)
    }

    /// The image of a body's point by its motion relative to points that have one, each part of it in a step of its
    /// own. Those that lead to the body's own joint come first.
    pub(super) fn relative_image(&mut self, order: Order, body: BodyId, point: PointId) {
        let mechanism = self.mechanism;
        let name = image_name(&point_on(mechanism, body, point));
        if self.shows(order, &name) {
            return;
        }
        if body == GROUND {
            let pole = self.motion(order, body, point);
            self.show(order, &name, pole, PointRole::Pole);
            return;
        }
        if let Some(&(joint, from)) = self.construction.record.anchors.get(&body) {
            let at = mechanism.joint_point(joint);
            if at != point {
                for body in [from, body] {
                    self.relative_image(order, body, at);
                }
            }
        }
        let place = self.motion(order, body, point);
        // Back to a plan point that is there.
        let (mut at, mut vectors) = (place, Vec::new());
        let start = loop {
            if let Some(name) = self.shown_name(order, at) {
                break Some(name);
            }
            match self.construction.record.laid_off.get(&at).cloned() {
                Some((start, of)) => {
                    vectors.push((at, of));
                    at = start;
                }
                None => break None,
            }
        };
        let Some(mut from) = start else {
            // The scene gives the vector, or no construction does.
            self.show(order, &name, place, PointRole::Image);
            let (from, of) = (order.pole().to_owned(), VectorOf::Point(body, point));
            self.add_step_of(order, Arrow { order, from, to: name, of }, place);
            return;
        };
        if vectors.is_empty() {
            self.show(order, &name, place, PointRole::Image);
            let step = self.begin(order);
            self.finish(step, Action::Coincide { point: name, with: from, link: body });
            return;
        }
        while let Some((end, of)) = vectors.pop() {
            let (to, role) = match vectors.is_empty() {
                true => (name.clone(), PointRole::Image),
                false => {
                    let (name, role) = part_end(mechanism, &from, &of);
                    (self.free_name(order, name), role)
                }
            };
            self.show(order, &to, end, role);
            self.add_step_of(order, Arrow { order, from, to: to.clone(), of }, end);
            from = to;
        }
    }

    /// Adds the step of a vector that has been laid off to a place already.
    fn add_step_of(&mut self, order: Order, arrow: Arrow, end: PlaceId) {
        let step = self.begin(order);
        let step = self.finish(step, Action::LayOff(arrow));
        self.claim(step, end);
    }

    /// The name, with primes if another plan point has it.
    pub(super) fn free_name(&mut self, order: Order, mut name: String) -> String {
        while self.shows(order, &name) {
            name = match name.contains('_') {
                true => name.replacen('_', "'_", 1),
                false => format!("{name}'"),
            };
        }
        name
    }

    /// Adds the velocity plan's steps from the images of a group's outer joints to those of its inner ones.
    ///
    /// With known rates every point of a carrying link follows from its outer joint. At a prismatic joint the point of
    /// the guide's body under the slider comes first, then the sliding velocity.
    pub(super) fn image_steps(&mut self, group: &Group) {
        let mut carried: Vec<(Leg, Carried)> = Vec::new();
        for leg in group.special.iter().flat_map(|s| s.legs) {
            if let Some(second) = leg.carried.filter(|_| !carried.iter().any(|(known, _)| *known == leg)) {
                carried.push((leg, second));
            }
        }
        // Pins first: the image of a slider's point is there before the step of its sliding velocity.
        carried.sort_by_key(|(_, second)| self.mechanism.joint(second.inner).pin.is_none());
        for (leg, second) in &carried {
            self.image_step_of_leg(leg, second);
        }
    }

    fn image_step_of_leg(&mut self, leg: &Leg, second: &Carried) {
        let (mechanism, order) = (self.mechanism, Order::Velocity);
        let outer = mechanism.joint_point(leg.outer);
        // The links of the carrying compound link at the outer and at the inner joint.
        let [outer_link, inner_link] = [leg.outer, second.inner].map(|joint| mechanism.side(joint, second.carrier));
        let mut from = image_name(mechanism.point_name(outer));
        if let Some(slider) = mechanism.joint(leg.outer).slider {
            let [guide_image, slider_image] = self.sliding_velocity_step(slider);
            from = if mechanism.slide_sign(slider, second.carrier) > 0.0 { guide_image } else { slider_image };
        }
        let slides = leg.carrier_slides(mechanism);
        if !slides.is_empty() {
            let start = (from, self.motion(order, outer_link, outer));
            let (name, place) = self.driven_slides(order, start, &slides, PointRole::Slid, None);
            self.construction.record.note_motion(order, inner_link, outer, place);
            from = name;
        }
        let inner = mechanism.joint_point(second.inner);
        let end = point_on(mechanism, inner_link, inner);
        let to = image_name(&end);
        // A dyad's inner joint has its image already, the crossing of its rays.
        if !self.shows(order, &to) {
            let of = VectorOf::Relative {
                link: inner_link,
                from: mechanism.point_name(outer).to_owned(),
                to: end,
                part: VectorPart::Relative,
            };
            let step = self.begin(order);
            let place = self.motion(order, inner_link, inner);
            self.show(order, &to, place, PointRole::Image);
            let step = self.finish(step, Action::LayOff(Arrow { order, from, to, of }));
            self.claim(step, place);
        }
        if let Some(slider) = mechanism.joint(second.inner).slider {
            self.sliding_velocity_step(slider);
        }
    }

    /// Adds the step of a sliding velocity, from the image of the guide's point to that of the slider's; returns both
    /// names.
    fn sliding_velocity_step(&mut self, id: SliderId) -> [String; 2] {
        let (mechanism, order) = (self.mechanism, Order::Velocity);
        let slider = mechanism.slider(id);
        let at = mechanism.point_name(slider.at);
        let under = coincident_name(at, &mechanism.body(slider.on).name);
        let names = [image_name(&under), image_name(at)];
        let of = VectorOf::Sliding(id, under);
        let step = self.begin(order);
        let image = self.motion(order, slider.link, slider.at);
        let guide_image = self.motion(order, slider.on, slider.at);
        self.show(order, &names[0], guide_image, PointRole::Image);
        self.show(order, &names[1], image, PointRole::Image);
        let [from, to] = names.clone();
        let step = self.finish(step, Action::LayOff(Arrow { order, from, to, of }));
        self.claim(step, image);
        names
    }

    /// Constructs the images of the group's joints by relative motions: first of pins, then of sliders.
    pub(super) fn relative_images(&mut self, order: Order, group: &Group) {
        let mechanism = self.mechanism;
        for joint in mechanism.joints_of(group) {
            if let Some(point) = mechanism.joint(joint).pin {
                let bodies = mechanism.joint(joint).bodies;
                let body = bodies.into_iter().find(|&body| self.place_of_motion(order, body, point).is_some());
                let anchored = || bodies.into_iter().find(|&body| self.construction.record.anchors.contains_key(&body));
                if let Some(body) = body.or_else(anchored) {
                    self.relative_image(order, body, point);
                    let place = self.motion(order, body, point);
                    for other in bodies {
                        self.construction.record.note_motion(order, other, point, place);
                    }
                }
            }
        }
        for slider in mechanism.joints_of(group).into_iter().filter_map(|joint| mechanism.joint(joint).slider) {
            let ends = mechanism.slider(slider);
            for body in [ends.on, ends.link] {
                self.relative_image(order, body, ends.at);
            }
        }
    }

    /// Names the images of the group's joints: first of pins, each by the motion of its carrying link, then of sliders.
    pub(super) fn images(&mut self, order: Order, group: &Group) {
        let mechanism = self.mechanism;
        for (special, leg) in group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg))) {
            let Some(Carried { carrier, inner }) = leg.carried else { continue };
            if let Some(point) = mechanism.joint(inner).pin {
                let place = self.motion(order, mechanism.side(inner, carrier), point);
                self.name_place(order, &image_name(mechanism.point_name(point)), place);
                let other = mechanism.side(inner, mechanism.lead(special.link));
                self.construction.record.note_motion(order, other, point, place);
            }
        }
        for slider in mechanism.joints_of(group).into_iter().filter_map(|joint| mechanism.joint(joint).slider) {
            let ends = mechanism.slider(slider);
            for body in [ends.link, ends.on] {
                let place = self.motion(order, body, ends.at);
                self.name_place(order, &image_name(&point_on(mechanism, body, ends.at)), place);
            }
        }
    }
}
