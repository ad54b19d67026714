//! Construction of a group: special points, rays and their crossings, measured segments, rates, and images of its
//! points.

use super::body::Anchor;
use super::construct::Extent;
use super::cut::{CutLine, Special, SpecialId, special_points};
use super::leg::Drawn;
use super::name::{coincident_name, image_name, point_on};
use super::operation::{LineId, MeasuredAs, NumberId, NumberKind, Part, PlaceId, Rate};
use super::step::{Action, Arrow, LegEquation, PointRole, Ray, RayOf, Relation, RelativePart, VectorOf};
use super::writer::Writer;
use crate::geometry::{Vector, quarter_turn};
use crate::mechanism::{AngularRate, BodyId, Carried, GROUND, Group, LoopEquations, PointId, Role, SliderId};
use crate::sheet::Sheet;
use core::cmp::Reverse;

/// The ray of a leg.
struct DrawnRay {
    /// Its first point in the plan: name and place.
    from: (String, PlaceId),
    line: LineId,
}

impl Writer<'_> {
    /// Constructs the next group: each of its special points by two rays, then the rates from measured segments.
    /// Without such a construction the rates come from the motion.
    pub(super) fn group(&mut self, group: &Group) {
        let first = self.construction.special_count();
        let special = special_points(self.mechanism, self.pose, group);
        let equations = LoopEquations::new(self.mechanism, group);
        for &link in &group.bodies {
            if let AngularRate::Known(body) = equations.angular_rate_of(link) {
                self.construction.spins[link.0] = self.construction.spins[body.0];
            }
        }
        let has_crossing =
            |s: &Special| s.place.finite().is_some() && s.cuts.iter().all(|c| c.line.direction().is_some());
        let equation_count = 2 * special.len() + equations.angular.len();
        let has_rays = equation_count == equations.unknowns && special.iter().all(has_crossing);
        let ids = (first..).map(SpecialId);
        let drawn: Vec<Option<Drawn<'_>>> =
            special.iter().zip(ids).map(|(special, id)| self.special_point(special, id, has_rays)).collect();
        let mut starts: Vec<(BodyId, PointId)> = Vec::new();
        let cuts = special.iter().flat_map(|s| &s.cuts);
        let legs = cuts.filter_map(|cut| cut.start().map(|point| (cut.leg.base, point)));
        let hanging = group.hanging(self.mechanism).into_iter();
        for (base, point) in legs.chain(hanging.map(|(joint, base, _)| (base, self.mechanism.joint_point(joint)))) {
            if !starts.contains(&(base, point)) {
                starts.push((base, point));
                self.plans().iter().for_each(|&sheet| self.known_vector(sheet, base, point));
            }
        }
        let drawn: Option<Vec<Drawn<'_>>> = drawn.into_iter().collect();
        let constructed = drawn.filter(|_| has_rays).and_then(|drawn| self.rates(group, &equations, &drawn));
        if constructed.is_none() {
            self.without_construction(group, &equations, &special);
        }
        let agreement = constructed.map(|()| self.agreement(group, &equations));
        self.construction.agreement.push(agreement);
        self.construction.add_special(special);
        self.step = None;
    }

    /// Constructs both plans; `None` where rays are parallel or the equations have no solution.
    fn rates(&mut self, group: &Group, equations: &LoopEquations, drawn: &[Drawn<'_>]) -> Option<()> {
        for &sheet in self.plans() {
            self.rays(sheet, group, equations, drawn)?;
            if sheet == Sheet::Velocity {
                self.note_anchors(group);
            }
            if sheet == Sheet::Velocity || self.construction.extent == Extent::Rates {
                self.images(sheet, group);
            }
        }
        self.image_steps(group);
        if self.construction.extent == Extent::Points && self.plans().contains(&Sheet::Acceleration) {
            self.relative_images(Sheet::Acceleration, group);
        }
        Some(())
    }

    /// Notes that the group has no construction, and takes its rates from the motion.
    fn without_construction(&mut self, group: &Group, equations: &LoopEquations, special: &[Special]) {
        let far = special.iter().filter(|s| s.place.finite().is_none()).map(|s| s.name.clone());
        let far: Vec<String> = far.collect();
        for &sheet in self.plans() {
            self.begin(sheet, Action::NoConstruction { far: far.clone() });
        }
        self.step = None;
        self.take_computed_rates(group, equations);
        self.note_anchors(group);
        for &sheet in self.plans() {
            self.relative_images(sheet, group);
        }
    }

    /// Draws the cut lines and crosses them; a dyad's inner joint is only plotted. `None` for a special point at
    /// infinity.
    fn special_point<'s>(&mut self, special: &'s Special, id: SpecialId, has_rays: bool) -> Option<Drawn<'s>> {
        self.step = None;
        if special.is_assur {
            let sine = special.crossing.sine();
            self.begin(Sheet::Scheme, Action::SpecialPoint { point: special.name.clone(), special: id, sine });
        }
        let leg = |writer: &mut Self, cut: &CutLine| writer.leg(cut, special.target);
        let mut legs = [leg(self, &special.cuts[0])?, leg(self, &special.cuts[1])?];
        let place = match special.target {
            Some(target) => self.plot(target),
            None => {
                special.place.finite()?;
                let [first, second] = &mut legs;
                let lines = [self.cut_line(first, &special.cuts[0], id)?, self.cut_line(second, &special.cuts[1], id)?];
                self.by_hand = has_rays;
                let place = self.cross(Sheet::Scheme, Part::SpecialPoint(id), lines);
                self.by_hand = true;
                self.name_place(Sheet::Scheme, &special.name, place?);
                place?
            }
        };
        let mut drawn = Drawn { special, id, legs, place, lengths: [None; 2] };
        for side in 0..2 {
            drawn.lengths[side] = self.measured_length(&drawn, side);
        }
        Some(drawn)
    }

    /// The length from the joint of a leg to the sought point; to a special point it is measured, in a step of its own.
    fn measured_length(&mut self, drawn: &Drawn<'_>, side: usize) -> Option<NumberId> {
        let special = drawn.special;
        let from = special.cuts[side].measured_from()?;
        if let Some(place) = special.place.finite().filter(|_| special.is_assur) {
            let value = (place - self.pose.point(from)).norm();
            let (from, to) = (self.mechanism.point_name(from).to_owned(), special.name.clone());
            self.begin(Sheet::Scheme, Action::MeasureLength { from, to, value });
        }
        self.length_to_point(drawn, side)
    }

    /// The plan name of the point from which a leg starts: `b`, or `c_iB` for the point of base `iB` that coincides
    /// with C.
    fn start_name(&self, base: BodyId, point: PointId) -> String {
        image_name(&point_on(self.mechanism, base, point))
    }

    /// Lays off the known vector of the point from which a ray starts.
    fn known_vector(&mut self, sheet: Sheet, base: BodyId, point: PointId) {
        let name = self.start_name(base, point);
        // An earlier group may have constructed it.
        if let Some(shown) = self.plan(sheet).points.get_mut(&name).filter(|shown| shown.role != PointRole::Pole) {
            shown.role = PointRole::Known;
            return;
        }
        match self.mechanism.body(base).role {
            Role::Pushed { from, .. } if from != GROUND && self.mechanism.is_known(base) => {
                self.pushed_vector(sheet, base, point, &name);
            }
            // A fixed point: its image is the pole, with a name of its own where the point coincides with a slider's.
            Role::Ground => {
                let pole = self.motion(sheet, base, point);
                self.show(sheet, &name, pole, PointRole::Pole);
            }
            _ => {
                let from = self.plan(sheet).kind.pole().to_owned();
                let of = VectorOf::Point(base, point);
                self.begin(sheet, Action::LayOff(Arrow { from, to: name.clone(), of }));
                let place = self.motion(sheet, base, point);
                // The start of a ray has the role of a known point, even if it was another point's image before.
                self.show(sheet, &name, place, PointRole::Known);
                if let Some(shown) = self.plan(sheet).points.get_mut(&name) {
                    shown.role = PointRole::Known;
                }
            }
        }
        self.step = None;
    }

    /// Lays off the vector of a body that driven sliders connect with one of known motion: first the coincident point
    /// of that body, then the sliders' relative motions.
    fn pushed_vector(&mut self, sheet: Sheet, base: BodyId, point: PointId, name: &str) {
        let root = self.mechanism.root(base);
        self.known_vector(sheet, root, point);
        let start = (self.start_name(root, point), self.motion(sheet, root, point));
        let way = self.mechanism.slides_between(root, base);
        let (_, place) = self.driven_slides(sheet, start, &way, PointRole::Known, Some(name));
        self.show(sheet, name, place, PointRole::Known);
        self.note_motion(sheet, base, point, place);
    }

    /// Draws rays, crosses them, measures segments, and solves for the rates with the ties' equations. `None`
    /// where rays are parallel or the equations have no solution.
    fn rays(&mut self, sheet: Sheet, group: &Group, equations: &LoopEquations, drawn: &[Drawn<'_>]) -> Option<()> {
        let (mut rows, mut written) = (Vec::new(), Vec::new());
        for point in drawn {
            let image = image_name(&point.special.name);
            let rays = [self.ray(sheet, point, 0)?, self.ray(sheet, point, 1)?];
            let from = rays.each_ref().map(|ray| ray.from.0.clone());
            let sine = point.special.crossing.sine();
            self.begin(sheet, Action::Cross { point: image.clone(), from, sine });
            let lines = rays.each_ref().map(|ray| ray.line);
            let Some(crossing) = self.cross(sheet, Part::Image, lines) else {
                self.plan(sheet).steps.pop();
                return None;
            };
            let role = if point.special.is_assur { PointRole::Special } else { PointRole::Image };
            self.show(sheet, &image, crossing, role);
            for (side, DrawnRay { from: (from, start), line }) in rays.into_iter().enumerate() {
                let kind = NumberKind::Segment(sheet, [from.clone(), image.clone()]);
                self.begin(sheet, Action::Measure { from: from.clone(), to: image.clone(), value: 0.0 });
                let segment = self.measure(sheet, kind, [start, crossing], MeasuredAs::Along(line));
                let length = self.exact.exact_number(segment).high;
                self.set_measured(sheet, length.abs());
                rows.push(self.equation(sheet, equations, point, side, segment)?);
                written.push(LegEquation { special: point.id, side, from, segment: length });
            }
            self.note_joint_motion(sheet, point, crossing);
        }
        for terms in &equations.angular {
            rows.push(self.tie_equation(sheet, terms)?);
        }
        let rates = self.unknown_rates(sheet, group, equations);
        // Rates that follow from ties alone are computed without a step.
        let is_step = !written.is_empty();
        if is_step {
            let unknowns = self.solved_rates(sheet, group, equations);
            self.begin(sheet, Action::Solve { equations: written, unknowns });
        }
        let numbers = self.solve(sheet, &rates, rows);
        if numbers.is_none() && is_step {
            self.plan(sheet).steps.pop();
        }
        self.note_rates(sheet, group, equations, &numbers?);
        self.step = None;
        Some(())
    }

    /// Notes the image of a dyad's inner joint: it is the image of a pin for both links, of a slider's point for its
    /// own link only.
    fn note_joint_motion(&mut self, sheet: Sheet, point: &Drawn<'_>, place: PlaceId) {
        let Some(target) = point.special.target else { return };
        self.note_motion(sheet, point.special.link, target, place);
        for Carried { carrier, inner } in point.special.cuts.iter().filter_map(|cut| cut.leg.carried) {
            if self.mechanism.joint(inner).pin.is_some() {
                self.note_motion(sheet, self.mechanism.side(inner, carrier), target, place);
            }
        }
    }

    /// The rate behind each unknown of the group's equations.
    fn unknown_rates(&self, sheet: Sheet, group: &Group, equations: &LoopEquations) -> Vec<Rate> {
        let is_second = sheet == Sheet::Acceleration;
        let mut rates = vec![Rate::Omega(GROUND); equations.unknowns];
        for &link in &group.bodies {
            if let Some(unknown) = equations.angular_unknown(link) {
                rates[unknown] = if is_second { Rate::Alpha(link) } else { Rate::Omega(link) };
            }
        }
        for slider in (0..self.mechanism.sliders.len()).map(SliderId) {
            if let Some(unknown) = equations.slide_unknown(slider) {
                let rate = if is_second { Rate::SlideAcceleration } else { Rate::SlideVelocity };
                rates[unknown] = rate(slider);
            }
        }
        rates
    }

    /// Notes the numbers of the solved rates by link and by slider.
    fn note_rates(&mut self, sheet: Sheet, group: &Group, equations: &LoopEquations, numbers: &[NumberId]) {
        let order = sheet.order();
        let name = |link| [Rate::Omega(link), Rate::Alpha(link)][order].name(self.mechanism);
        for &link in &group.bodies {
            if let Some(unknown) = equations.angular_unknown(link) {
                self.construction.spins[link.0].get_or_insert_default()[order] = Some(numbers[unknown]);
                let alike = group.bodies.iter().copied().filter(|&b| equations.angular_unknown(b) == Some(unknown));
                let most = alike.min_by_key(|&b| Reverse(self.mechanism.body(b).points.len()));
                if let Some(other) = most.filter(|&other| other != link) {
                    self.construction.same_rates.insert(name(link), name(other));
                }
            }
        }
        for slider in (0..self.mechanism.sliders.len()).map(SliderId) {
            if let Some(unknown) = equations.slide_unknown(slider) {
                self.construction.slides[slider.0].get_or_insert_default()[order] = Some(numbers[unknown]);
            }
        }
    }

    /// Names and values of the rates that a group is solved for.
    fn solved_rates(&self, sheet: Sheet, group: &Group, equations: &LoopEquations) -> Vec<(String, f64)> {
        let (motion, order) = (self.motion, sheet.order());
        let links = group.bodies.iter().filter(|&&link| equations.angular_unknown(link).is_some()).map(|&link| {
            let body = motion.body(link);
            [(Rate::Omega(link), body.omega), (Rate::Alpha(link), body.alpha)][order]
        });
        let sliders = (0..self.mechanism.sliders.len()).map(SliderId);
        let slides = sliders.filter(|&slider| equations.slide_unknown(slider).is_some()).map(|slider| {
            let slide = motion.slide(slider);
            [(Rate::SlideVelocity(slider), slide.velocity), (Rate::SlideAcceleration(slider), slide.acceleration)]
                [order]
        });
        links.chain(slides).map(|(rate, value)| (rate.name(self.mechanism), value)).collect()
    }

    /// Takes the rates of a group without a construction from the motion; marked as not found by hand.
    fn take_computed_rates(&mut self, group: &Group, equations: &LoopEquations) {
        for &link in &group.bodies {
            if equations.angular_unknown(link).is_none() {
                continue;
            }
            let (body, errors) = (*self.motion.body(link), *self.motion.error(link));
            let omega = self.take_computed(Sheet::Velocity, Rate::Omega(link), body.omega, errors.omega);
            let alpha = self.take_computed(Sheet::Acceleration, Rate::Alpha(link), body.alpha, errors.alpha);
            self.construction.spins[link.0] = Some([Some(omega), Some(alpha)]);
        }
        for id in (0..self.mechanism.sliders.len()).map(SliderId) {
            if equations.slide_unknown(id).is_none() {
                continue;
            }
            let slide = *self.motion.slide(id);
            let velocity =
                self.take_computed(Sheet::Velocity, Rate::SlideVelocity(id), slide.velocity, slide.velocity_error);
            let rate = Rate::SlideAcceleration(id);
            let acceleration =
                self.take_computed(Sheet::Acceleration, rate, slide.acceleration, slide.acceleration_error);
            self.construction.slides[id.0] = Some([Some(velocity), Some(acceleration)]);
        }
    }

    /// Draws the ray of a leg, after the driven sliders' vectors and the normal part that lead to its start.
    fn ray(&mut self, sheet: Sheet, point: &Drawn<'_>, side: usize) -> Option<DrawnRay> {
        let (cut, leg) = (&point.special.cuts[side], &point.legs[side]);
        let base = cut.leg.base;
        let start = cut.start()?;
        let start = (self.start_name(base, start), self.motion(sheet, base, start));
        let mut from = self.driven_slides(sheet, start, &cut.slides, PointRole::Slid, None);
        if sheet == Sheet::Acceleration {
            from = self.known_parts(point, side, from)?;
        }
        // The ray is drawn against the guide where there is one, else against the line through two joints.
        let relation = if cut.guide().is_some() { Relation::Parallel } else { Relation::Perpendicular };
        self.begin(
            sheet,
            Action::Ray(Ray {
                through: from.0.clone(),
                to: image_name(&point.special.name),
                direction: quarter_turn(cut.line.direction().unwrap_or_else(Vector::x)),
                relation,
                of: RayOf::Leg(point.id, side),
            }),
        );
        // Two special points may have a ray in common.
        let drawn = self.drawn(from.1, leg.ray);
        let line = drawn.unwrap_or_else(|| self.draw(sheet, Part::Ray, from.1, leg.ray));
        Some(DrawnRay { from, line })
    }

    /// Notes an anchor for each link, whose motion can follow from that joint once the rates are known.
    fn note_anchors(&mut self, group: &Group) {
        let mechanism = self.mechanism;
        let legs = || group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg)));
        for (special, leg) in legs() {
            let link = leg.carried.map_or_else(|| mechanism.lead(special.link), |carried| carried.carrier);
            let outer = mechanism.side(leg.outer, link);
            self.anchors[outer.0].get_or_insert(Anchor { joint: leg.outer, from: leg.base });
        }
        for (special, leg) in legs() {
            if let Some(Carried { carrier, inner }) = leg.carried {
                let holder = mechanism.side(inner, mechanism.lead(special.link));
                let from = mechanism.side(inner, carrier);
                self.anchors[holder.0].get_or_insert(Anchor { joint: inner, from });
            }
        }
        for (joint, from, link) in group.hanging(mechanism) {
            let [from, holder] = [from, link].map(|body| mechanism.side(joint, body));
            self.anchors[holder.0].get_or_insert(Anchor { joint, from });
        }
        while let Some((link, anchor)) = self.next_anchor(group) {
            self.anchors[link.0] = Some(anchor);
        }
    }

    /// A joint of the group from a body that is known or has an anchor to a link that no leg reaches, as in a group of
    /// higher class. Pins go before sliders.
    fn next_anchor(&self, group: &Group) -> Option<(BodyId, Anchor)> {
        let mechanism = self.mechanism;
        let is_anchored = |body: BodyId| {
            let mut bodies = mechanism.compound(mechanism.root(body)).into_iter();
            !group.bodies.contains(&body) || bodies.any(|other| self.anchors[other.0].is_some())
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
            Some((link, Anchor { joint, from }))
        })
    }

    /// Adds the velocity plan's steps from the images of a group's outer joints to those of its inner ones.
    ///
    /// With known rates every point of a carrying link follows from its outer joint. At a prismatic joint the point of
    /// the guide's body under the slider comes first, then the sliding velocity.
    fn image_steps(&mut self, group: &Group) {
        let mut carried: Vec<(crate::mechanism::Leg, Carried)> = Vec::new();
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
        self.step = None;
    }

    fn image_step_of_leg(&mut self, leg: &crate::mechanism::Leg, second: &Carried) {
        let (mechanism, sheet) = (self.mechanism, Sheet::Velocity);
        let outer = mechanism.joint_point(leg.outer);
        // The links of the carrying compound link at the outer and at the inner joint.
        let [outer_link, inner_link] = [leg.outer, second.inner].map(|joint| mechanism.side(joint, second.carrier));
        let mut from = image_name(mechanism.point_name(outer));
        if let Some(slider) = mechanism.joint(leg.outer).slider {
            let [guide_image, slider_image] = self.sliding_velocity_step(slider);
            from = if mechanism.slide_sign(slider, second.carrier) > 0.0 { guide_image } else { slider_image };
        }
        let way = leg.carrier_slides(mechanism);
        if !way.is_empty() {
            let start = (from, self.motion(sheet, outer_link, outer));
            let (name, place) = self.driven_slides(sheet, start, &way, PointRole::Slid, None);
            self.note_motion(sheet, inner_link, outer, place);
            from = name;
        }
        let inner = mechanism.joint_point(second.inner);
        let name = mechanism.point_name(inner);
        let slider = mechanism.joint(second.inner).slider;
        let end = match slider.is_some_and(|id| mechanism.slider(id).on == inner_link) {
            true => coincident_name(name, &mechanism.body(inner_link).name),
            false => name.to_owned(),
        };
        let to = image_name(&end);
        // A dyad's inner joint has its image already, the crossing of its rays.
        if !self.plan(sheet).points.contains_key(&to) {
            let of = VectorOf::Relative {
                link: inner_link,
                from: mechanism.point_name(outer).to_owned(),
                to: end,
                part: RelativePart::Velocity,
            };
            self.begin(sheet, Action::LayOff(Arrow { from, to: to.clone(), of }));
            let place = self.motion(sheet, inner_link, inner);
            self.show(sheet, &to, place, PointRole::Image);
            self.claim(place);
        }
        if let Some(slider) = slider {
            self.sliding_velocity_step(slider);
        }
    }

    /// Adds the step of a sliding velocity, from the image of the guide's point to that of the slider's; returns both
    /// names.
    fn sliding_velocity_step(&mut self, id: SliderId) -> [String; 2] {
        let (mechanism, sheet) = (self.mechanism, Sheet::Velocity);
        let slider = mechanism.slider(id);
        let at = mechanism.point_name(slider.at);
        let under = coincident_name(at, &mechanism.body(slider.on).name);
        let names = [image_name(&under), image_name(at)];
        let of = VectorOf::Sliding(id, under);
        self.begin(sheet, Action::LayOff(Arrow { from: names[0].clone(), to: names[1].clone(), of }));
        let image = self.motion(sheet, slider.link, slider.at);
        let guide_image = self.motion(sheet, slider.on, slider.at);
        self.show(sheet, &names[0], guide_image, PointRole::Image);
        self.show(sheet, &names[1], image, PointRole::Image);
        self.claim(image);
        names
    }

    /// Constructs the images of the group's joints by relative motions: first of pins, then of sliders.
    fn relative_images(&mut self, sheet: Sheet, group: &Group) {
        let mechanism = self.mechanism;
        for joint in mechanism.joints_of(group) {
            if let Some(point) = mechanism.joint(joint).pin {
                let bodies = mechanism.joint(joint).bodies;
                let body = bodies.into_iter().find(|&body| self.place_of_motion(sheet, body, point).is_some());
                let anchored = || bodies.into_iter().find(|&body| self.anchors[body.0].is_some());
                if let Some(body) = body.or_else(anchored) {
                    self.relative_image(sheet, body, point);
                    let place = self.motion(sheet, body, point);
                    for other in bodies {
                        if self.place_of_motion(sheet, other, point).is_none() {
                            self.note_motion(sheet, other, point, place);
                        }
                    }
                }
            }
        }
        for joint in mechanism.joints_of(group) {
            let Some(slider) = mechanism.joint(joint).slider else { continue };
            let ends = mechanism.slider(slider);
            for body in [ends.on, ends.link] {
                self.relative_image(sheet, body, ends.at);
            }
        }
        self.step = None;
    }

    /// Names the images of the group's joints: first of pins, each by the motion of its carrying link, then of sliders.
    fn images(&mut self, sheet: Sheet, group: &Group) {
        let mechanism = self.mechanism;
        for (special, leg) in group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg))) {
            let Some(Carried { carrier, inner }) = leg.carried else { continue };
            if let Some(point) = mechanism.joint(inner).pin {
                let place = self.motion(sheet, mechanism.side(inner, carrier), point);
                self.name_place(sheet, &image_name(mechanism.point_name(point)), place);
                let other = mechanism.side(inner, mechanism.lead(special.link));
                if self.place_of_motion(sheet, other, point).is_none() {
                    self.note_motion(sheet, other, point, place);
                }
            }
        }
        for joint in mechanism.joints_of(group) {
            let Some(slider) = mechanism.joint(joint).slider else { continue };
            let ends = mechanism.slider(slider);
            let at = mechanism.point_name(ends.at);
            let under = coincident_name(at, &mechanism.body(ends.on).name);
            for (body, name) in [(ends.link, at), (ends.on, under.as_str())] {
                let place = self.motion(sheet, body, ends.at);
                self.name_place(sheet, &image_name(name), place);
            }
        }
    }
}
