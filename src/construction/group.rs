//! Construction of a group: special points, rays and their crossings, measured segments, and the rates that are solved
//! for, or taken from the computed motion, and compared with it.

use super::constructed::Agreement;
use super::cut::{CutLine, Special, SpecialId};
use super::leg::{DrawnSpecial, LegLines};
use super::name::{image_name, point_on};
use super::number::{End, NumberId, NumberKind, Rate};
use super::operation::{LineId, MeasuredAs, OperationRole, PlaceId};
use super::step::{Action, Arrow, LegEquation, PointRole, RateEquation, Ray, RayOf, Relation, VectorOf};
use super::writer::Writer;
use crate::geometry::{Vector, quarter_turn};
use crate::mechanism::{BodyId, Carried, GROUND, Group, JointId, LoopEquations, PointId, Role, SliderId};
use crate::sheet::{Order, Sheet};
use core::cmp::Reverse;

impl Writer<'_> {
    /// Draws the cut lines and crosses them; a dyad's inner joint is only plotted. `None` for a special point at
    /// infinity.
    pub(super) fn special_point<'s>(
        &mut self,
        special: &'s Special,
        id: SpecialId,
        has_rays: bool,
    ) -> Option<DrawnSpecial<'s>> {
        let step = self.begin(Sheet::Scheme);
        let found = self.crossed_legs(special, id, has_rays);
        if special.is_assur {
            let sine = special.crossing.sine();
            self.finish(step, Action::SpecialPoint { point: special.name.clone(), special: id, sine });
        }
        let (legs, place) = found?;
        let mut drawn = DrawnSpecial { special, id, legs, place, lengths: [None; 2] };
        for side in 0..2 {
            drawn.lengths[side] = self.measured_length(&drawn, side);
        }
        Some(drawn)
    }

    /// The legs of a special point, and its place on the scheme.
    fn crossed_legs(&mut self, special: &Special, id: SpecialId, has_rays: bool) -> Option<([LegLines; 2], PlaceId)> {
        let leg = |writer: &mut Self, cut: &CutLine| writer.leg(cut, special.target);
        let mut legs = [leg(self, &special.cuts[0])?, leg(self, &special.cuts[1])?];
        if let Some(target) = special.target {
            return Some((legs, self.plot(target)));
        }
        special.place.finite()?;
        let [first, second] = &mut legs;
        let lines = [self.cut_line(first, &special.cuts[0], id)?, self.cut_line(second, &special.cuts[1], id)?];
        let place = self.cross(has_rays, Sheet::Scheme, OperationRole::SpecialPoint(id), lines)?;
        self.name_place(Sheet::Scheme, &special.name, place);
        Some((legs, place))
    }

    /// The length from a leg's joint to the sought point, where an equation contains it; to a special point it is
    /// measured along the cut line, in a step of its own.
    fn measured_length(&mut self, drawn: &DrawnSpecial<'_>, side: usize) -> Option<NumberId> {
        let special = drawn.special;
        let from = special.cuts[side].measured_from()?;
        if let Some(target) = special.target {
            return (target != from).then(|| self.length(from, target));
        }
        let (line, place) = (drawn.legs[side].line?, special.place.finite()?);
        let step = self.begin(Sheet::Scheme);
        let ends = [self.plot(from), drawn.place];
        let kind = NumberKind::Length([End::Joint(from), End::Special(drawn.id)]);
        let length = self.measure(Sheet::Scheme, kind, ends, MeasuredAs::Along(line));
        let value = (place - self.pose.point(from)).norm();
        let (from, to) = (self.mechanism.point_name(from).to_owned(), special.name.clone());
        self.finish(step, Action::Measure { from, to, value });
        Some(length)
    }

    /// The plan name of the point from which a leg starts: `b`, or `c_iB` for the point of base `iB` that coincides
    /// with C.
    fn start_name(&self, base: BodyId, point: PointId) -> String {
        image_name(&point_on(self.mechanism, base, point))
    }

    /// Lays off the known vector of the point from which a ray starts.
    pub(super) fn known_vector(&mut self, order: Order, base: BodyId, point: PointId) {
        let name = self.start_name(base, point);
        // An earlier group may have constructed it.
        if let Some(shown) = self.plan(order).points.get_mut(&name).filter(|shown| shown.role != PointRole::Pole) {
            shown.role = PointRole::Known;
            return;
        }
        match self.mechanism.body(base).role {
            Role::Pushed { from, .. } if from != GROUND && self.mechanism.is_known(base) => {
                self.pushed_vector(order, base, point, &name);
            }
            // A fixed point: its image is the pole, with a name of its own where the point coincides with a slider's.
            Role::Ground => {
                let pole = self.motion(order, base, point);
                self.show(order, &name, pole, PointRole::Pole);
            }
            _ => {
                let from = order.pole().to_owned();
                let of = VectorOf::Point(base, point);
                let step = self.begin(order);
                let place = self.motion(order, base, point);
                // The start of a ray has the role of a known point, even if it was another point's image before.
                self.show(order, &name, place, PointRole::Known);
                if let Some(shown) = self.plan(order).points.get_mut(&name) {
                    shown.role = PointRole::Known;
                }
                self.finish(step, Action::LayOff(Arrow { order, from, to: name, of }));
            }
        }
    }

    /// Lays off the vector of a body that driven sliders connect with one of known motion: first the coincident point
    /// of that body, then the sliders' relative motions.
    fn pushed_vector(&mut self, order: Order, base: BodyId, point: PointId, name: &str) {
        let root = self.mechanism.root(base);
        self.known_vector(order, root, point);
        let start = (self.start_name(root, point), self.motion(order, root, point));
        let slides = self.mechanism.slides_between(root, base);
        let (_, place) = self.driven_slides(order, start, &slides, PointRole::Known, Some(name));
        self.show(order, name, place, PointRole::Known);
        self.construction.record.note_motion(order, base, point, place);
    }

    /// Draws rays, crosses them, measures segments, and solves for the rates with the equations of relations between
    /// angles. `None` where rays are parallel or the equations have no solution.
    pub(super) fn rays(
        &mut self,
        order: Order,
        group: &Group,
        equations: &LoopEquations,
        drawn: &[DrawnSpecial<'_>],
    ) -> Option<()> {
        let (mut rows, mut written) = (Vec::new(), Vec::new());
        for point in drawn {
            let image = image_name(&point.special.name);
            let rays = [self.ray(order, point, 0)?, self.ray(order, point, 1)?];
            let from = rays.each_ref().map(|((from, _), _)| from.clone());
            let sine = point.special.crossing.sine();
            let step = self.begin(order);
            let crossing = self.cross(true, order, OperationRole::Image, rays.each_ref().map(|(_, line)| *line))?;
            self.finish(step, Action::Cross { point: image.clone(), from, sine });
            let role = if point.special.is_assur { PointRole::Special } else { PointRole::Image };
            self.show(order, &image, crossing, role);
            for (side, ((from, start), line)) in rays.into_iter().enumerate() {
                let kind = NumberKind::Segment(order, [from.clone(), image.clone()]);
                let step = self.begin(order);
                let segment = self.measure(order, kind, [start, crossing], MeasuredAs::Along(line));
                let length = self.construction.record.exact.numbers[segment.0].high;
                let measured = Action::Measure { from: from.clone(), to: image.clone(), value: length.abs() };
                self.finish(step, measured);
                rows.push(self.equation(order, equations, point, side, segment)?);
                let own = LegEquation { order, special: point.id, side, from, segment: length };
                written.push(RateEquation::Leg(own));
            }
            self.note_joint_motion(order, point, crossing);
        }
        for terms in &equations.angular {
            rows.push(self.angular_equation(order, terms)?);
        }
        // Without an angular acceleration that is given there is none.
        if drawn.is_empty() && rows.iter().any(|row| !row.right.is_empty()) {
            written.extend(self.rolling_in(group).map(|joint| RateEquation::Rolling(order, joint)));
        }
        let unknown = self.unknown_rates(order, group, equations);
        // Links with one angular rate have one unknown: it has the name of the last of them. A block that is only a pin has no
        // name, and turns with its guide.
        let has_name =
            |(_, rate): &&(usize, Rate)| rate.link().is_none_or(|link| !self.mechanism.body(link).is_nameless());
        let named: Vec<(usize, Rate)> = unknown.iter().filter(has_name).copied().collect();
        let mut rates = vec![Rate::Angular(order, GROUND); equations.unknowns];
        named.iter().for_each(|&(index, rate)| rates[index] = rate);
        let step = self.begin(order);
        let kinds = rates.iter().copied().map(NumberKind::Rate).collect();
        let numbers = self.solve(order, kinds, rows)?;
        // Rates that follow from constant angles alone are computed without a step.
        if !written.is_empty() {
            let solved = |&(_, rate): &(usize, Rate)| (rate.name(self.mechanism), self.computed_rate(rate)[0]);
            let unknowns = named.iter().map(solved).collect();
            self.finish(step, Action::Solve { equations: written, unknowns });
        }
        self.note_rates(&unknown, &numbers);
        Some(())
    }

    /// The meshes, racks and belts of a group.
    fn rolling_in<'g>(&self, group: &'g Group) -> impl Iterator<Item = JointId> + use<'g, '_> {
        let mechanism = self.mechanism;
        group.joints.iter().copied().filter(move |&joint| {
            let own = mechanism.joint(joint);
            own.rolls() || own.belt.is_some()
        })
    }

    /// Notes the image of a dyad's inner joint: it is the image of a pin for both links, of a slider's point for its
    /// own link only.
    fn note_joint_motion(&mut self, order: Order, point: &DrawnSpecial<'_>, place: PlaceId) {
        let Some(target) = point.special.target else { return };
        self.construction.record.note_motion(order, point.special.link, target, place);
        for Carried { carrier, inner } in point.special.cuts.iter().filter_map(|cut| cut.leg.carried) {
            if self.mechanism.joint(inner).pin.is_some() {
                let side = self.mechanism.side(inner, carrier);
                self.construction.record.note_motion(order, side, target, place);
            }
        }
    }

    /// Draws the ray of a leg, after the driven sliders' vectors and the normal part that lead to its start; gives name
    /// and place of its first point, and its line.
    fn ray(&mut self, order: Order, point: &DrawnSpecial<'_>, side: usize) -> Option<((String, PlaceId), LineId)> {
        let (cut, leg) = (&point.special.cuts[side], &point.legs[side]);
        let base = cut.leg.base;
        let start = cut.start()?;
        let start = (self.start_name(base, start), self.motion(order, base, start));
        let mut from = self.driven_slides(order, start, &cut.slides, PointRole::Slid, None);
        if order == Order::Acceleration {
            from = self.known_parts(point, side, from)?;
        }
        // The ray is drawn against the guide where there is one, else against the line through two joints.
        let relation = if cut.guide().is_some() { Relation::Parallel } else { Relation::Perpendicular };
        let ray = Ray {
            order,
            through: from.0.clone(),
            to: image_name(&point.special.name),
            direction: quarter_turn(cut.line.direction().unwrap_or_else(Vector::x)),
            relation,
            of: RayOf::Leg(point.id, side),
        };
        let step = self.begin(order);
        // Two special points may have a ray in common.
        let drawn = self.drawn(from.1, leg.ray);
        let line = drawn.unwrap_or_else(|| self.draw(order, OperationRole::Ray, from.1, leg.ray));
        self.finish(step, Action::Ray(ray));
        Some((from, line))
    }

    /// The rates of links, then of sliders, that the equations of a plan are solved for, each with its index among the
    /// unknowns; several links may have the same.
    pub(super) fn unknown_rates(&self, order: Order, group: &Group, equations: &LoopEquations) -> Vec<(usize, Rate)> {
        let of_link = |&link: &BodyId| Some((equations.angular_unknown(link)?, Rate::Angular(order, link)));
        let of_slider = |id: SliderId| Some((equations.slide_unknown(id)?, Rate::Slide(order, id)));
        let links = group.bodies.iter().filter_map(of_link);
        links.chain(self.mechanism.slider_ids().filter_map(of_slider)).collect()
    }

    /// A rate in the computed motion, and the bound of its error.
    pub(super) fn computed_rate(&self, rate: Rate) -> [f64; 2] {
        let motion = self.motion;
        match rate {
            Rate::Angular(Order::Velocity, link) => [motion.body(link).omega, motion.error(link).omega],
            Rate::Angular(Order::Acceleration, link) => [motion.body(link).alpha, motion.error(link).alpha],
            Rate::Slide(Order::Velocity, id) => [motion.slide(id).velocity, motion.slide(id).velocity_error],
            Rate::Slide(Order::Acceleration, id) => {
                [motion.slide(id).acceleration, motion.slide(id).acceleration_error]
            }
        }
    }

    /// Notes the numbers of solved rates. Of links that turn alike the one with most points gives the rate its name.
    pub(super) fn note_rates(&mut self, unknown: &[(usize, Rate)], numbers: &[NumberId]) {
        for &(index, rate) in unknown {
            self.construction.set_rate(rate, numbers[index]);
            let alike = unknown.iter().filter(|(other, _)| *other == index);
            let alike = alike.filter_map(|&(_, rate)| Some((rate, rate.link()?)));
            let most = alike.min_by_key(|(_, link)| Reverse(self.mechanism.body(*link).points.len()));
            if let Some((most, _)) = most.filter(|(most, _)| *most != rate) {
                let [name, most] = [rate, most].map(|rate| rate.name(self.mechanism));
                self.construction.same_rates.insert(name, most);
            }
        }
    }

    /// Takes the rates of a group without a construction from the motion; marked as not found by hand.
    pub(super) fn take_computed_rates(&mut self, group: &Group, equations: &LoopEquations) {
        let both = Order::ALL.map(|order| self.unknown_rates(order, group, equations));
        for at in 0..both[0].len() {
            for unknown in &both {
                let (_, rate) = unknown[at];
                let [value, error] = self.computed_rate(rate);
                let number = self.take_computed(rate, value, error);
                self.construction.set_rate(rate, number);
            }
        }
    }

    /// Compares the solved rates of a group with those from the loop equations.
    pub(super) fn agreement(&self, group: &Group, equations: &LoopEquations) -> Agreement {
        let mut result = Agreement { difference: 0.0, allowed: 0.0 };
        let size = self.size;
        for &order in self.orders() {
            let scale = self.largest_rates[order];
            // Subnormal rates have lost digits: they count as zero.
            if scale < f64::MIN_POSITIVE {
                continue;
            }
            for (_, rate) in self.unknown_rates(order, group, equations) {
                let [value, error] = self.computed_rate(rate);
                let Some(number) = self.construction.rate(rate).flatten() else { continue };
                let scale = if rate.link().is_some() { scale } else { scale * size };
                let constructed = self.construction.record.exact.numbers[number.0];
                let difference = (constructed.high - value).abs() / scale;
                let allowed = (constructed.error() + error) / scale;
                // Division by a small scale can overflow; an infinite difference becomes the largest f64. `max` ignores
                // NaN.
                let finite = |x: f64| if x == f64::INFINITY { f64::MAX } else { x };
                result.difference = result.difference.max(finite(difference));
                result.allowed = result.allowed.max(finite(allowed));
            }
        }
        result
    }
}
