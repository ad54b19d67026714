//! Slips with vectors and images: another start, size or sense, a normal part worked out otherwise, a triangle turned over.

use super::direction::Direction;
use super::entry::{Entry, LayOff, Like};
use super::names::LENGTH;
use super::slips::Slip;
use super::table::Made;
use crate::check::{Blank, Told, tell};
use crate::geometry::{Vector, cross, quarter_turn};
use crate::scene::Head;
use crate::sheet::Sheet;

impl Slip<'_, '_> {
    /// A vector of a wrong size, sense or start.
    pub(super) fn laid_off(&self, laid: &LayOff, sheet: Sheet, name: &str, [at, right]: [Vector; 2]) -> Option<Told> {
        let start = self.table.place(sheet, &laid.from)?;
        let (found, meant) = (at - start, right - start);
        if let Some((from, vector)) = self.vector_to(sheet, name)
            && self.table.place(sheet, &from) != Some(start)
            && (found - vector).norm() <= self.tolerance * vector.norm()
        {
            return Some(tell::vector_from_wrong_point(name.into(), laid.from.as_str().into(), from.as_str().into()));
        }
        if let Some(start) = self.other_start(sheet, right - found).filter(|other| *other != laid.from) {
            let is_known =
                self.table.given.vectors(sheet).iter().any(|v| (found - v).norm() <= self.tolerance * v.norm());
            if is_known {
                return Some(tell::vector_from_wrong_point(name.into(), laid.from.as_str().into(), start.into()));
            }
        }
        let [from, to] = [Blank::from(laid.from.as_str()), Blank::from(name)];
        if let Some(told) = self.coriolis(sheet, [from.clone(), to.clone()], found, meant) {
            return Some(told);
        }
        let sizes = found.norm() * meant.norm();
        if found.dot(&meant).abs() <= self.tolerance * sizes && self.is_same(found.norm(), meant.norm()) {
            return Some(tell::turned_vector(from, to));
        }
        let is_along = cross(found, meant).abs() <= 10.0 * self.tolerance * sizes;
        if !is_along || meant.norm() == 0.0 {
            return None;
        }
        let ratio = found.dot(&meant) / meant.norm_squared();
        let sign = self.table.formula(&laid.size).ok()?.signum() * ratio.signum();
        if self.is_same(ratio, -1.0) {
            let is_normal = sheet == Sheet::Acceleration && matches!(laid.along, Direction::Parallel { .. });
            let length = laid.size.names().into_iter().find(|name| LENGTH.begins(name));
            return Some(match length {
                Some(length) if is_normal => {
                    tell::normal_outward(from, to, self.rate_of(&laid.size), Blank::Symbol(length.to_owned()))
                }
                _ => tell::reversed_vector(from, to),
            });
        }
        let diameter = self.diameter(&laid.size, name, ratio);
        if diameter.is_some() {
            return diameter;
        }
        let formula = || self.formula(&laid.size, name, meant.norm() * sign);
        let factor = || self.factor(name, Some(&laid.size), ratio * meant.norm(), meant.norm());
        let told = if laid.size.has_numbers() { factor().or_else(formula) } else { formula().or_else(factor) };
        told.or_else(|| self.normal(laid, sheet, name, found.norm(), meant.norm()))
    }

    /// A Coriolis acceleration along its guide, turned the wrong way, without its 2, with another velocity or another ω.
    fn coriolis(&self, sheet: Sheet, [from, to]: [Blank; 2], found: Vector, right: Vector) -> Option<Told> {
        let given = self.table.given;
        let mechanism = given.mechanism();
        let is_near = |a: Vector, b: Vector| (a - b).norm() <= self.tolerance.max(1e-6) * b.norm();
        let mut sliders = mechanism.slider_ids().filter(|_| sheet == Sheet::Acceleration);
        let part = |id| {
            let size = given.number(&Head::Coriolis.of(&mechanism.slider_name(id))).unwrap_or(0.0);
            quarter_turn(given.solution.pose.guide(id)) * size
        };
        let id = sliders
            .find(|&id| part(id) != Vector::zeros() && (is_near(right, part(id)) || is_near(right, -part(id))))?;
        let slider = mechanism.slider_name(id);
        let link = &mechanism.body(mechanism.slider(id).on).name;
        let [rate, velocity] = [Head::Omega.of(link), Head::SlideVelocity.of(&slider)].map(Blank::Symbol);
        let (along, across) = (quarter_turn(right), -right);
        if is_near(found, along) || is_near(found, -along) {
            return Some(tell::coriolis_along(from, to, rate, velocity));
        }
        if is_near(found, across) {
            // Laid off backwards it ends at what is known; its direction is that from its own beginning.
            let [from, to] = if right.dot(&part(id)) < 0.0 { [to, from] } else { [from, to] };
            return Some(tell::coriolis_turned(from, to, rate, velocity));
        }
        let ratio = found.norm() / right.norm();
        if cross(found, right).abs() > 10.0 * self.tolerance * found.norm() * right.norm() {
            return None;
        }
        if self.is_same(ratio, 0.5) {
            return Some(tell::coriolis_without_two(from, to, rate, velocity));
        }
        let sliding = given.number(&Head::SlideVelocity.of(&slider))?.abs();
        let other = given.places(Sheet::Velocity).find(|(_, v)| self.is_same(ratio, v.norm() / sliding))?;
        Some(tell::coriolis_velocity(from, to, rate, velocity, other.0.into()))
    }

    /// A normal part whose size was worked out otherwise: with ω, the ω of another link, an absolute velocity, the diameter.
    fn normal(&self, laid: &LayOff, sheet: Sheet, name: &str, found: f64, right: f64) -> Option<Told> {
        let given = self.table.given;
        let mechanism = given.mechanism();
        let [from, to] = [Blank::from(laid.from.as_str()), Blank::from(name)];
        let pairs = mechanism.links().flat_map(|(id, _)| {
            let points = given.points_of(id);
            let ends = points.clone();
            points.into_iter().flat_map(move |a| ends.clone().into_iter().map(move |b| (id, a.clone(), b)))
        });
        for (id, [a, at], [b, end]) in pairs.filter(|(_, a, b)| sheet == Sheet::Acceleration && a != b) {
            let part = given.number(&Head::Normal.of_two(&a, &b)).unwrap_or(0.0);
            if !self.is_same(part, right) || part == 0.0 {
                continue;
            }
            let length = (given.place(Sheet::Scheme, &at)? - given.place(Sheet::Scheme, &end)?).norm();
            let link = &mechanism.body(id).name;
            let [rate, arm] = [Head::Omega.of(link), Sheet::Scheme.segment_name(&at, &end)].map(Blank::Symbol);
            let omega = given.number(&Head::Omega.of(link))?.abs();
            if self.is_same(found, omega * length) {
                return Some(tell::omega_not_squared(from, to, rate, arm));
            }
            let absolute = [&a, &b].into_iter().find(|point| {
                let velocity = given.number(&Head::Velocity.of(point)).unwrap_or(0.0);
                self.is_same(found, velocity * velocity / length)
            });
            if let Some(point) = absolute {
                let image = crate::construction::image_name(point);
                return Some(tell::normal_from_absolute(from, to, rate, arm, image.as_str().into()));
            }
            let other = mechanism.links().map(|(_, body)| Head::Omega.of(&body.name)).find(|other| {
                let omega = given.number(other).unwrap_or(0.0);
                self.is_same(found, omega * omega * length)
            });
            if let Some(other) = other {
                return Some(tell::omega_of_another_link(from, to, rate, arm, Blank::Symbol(other)));
            }
            if self.is_same(found, 2.0 * right) {
                return Some(tell::diameter(from, to, rate, arm));
            }
        }
        None
    }

    /// The point at a place, from which a vector should have been laid off.
    fn other_start(&self, sheet: Sheet, at: Vector) -> Option<&str> {
        let near = self.tolerance.max(1e-6) * self.table.given.size(sheet);
        let all = self.table.given.places(sheet).chain(self.table.places(sheet));
        let mut there = all.filter(|(_, place)| (place - at).norm() <= near);
        there.next().map(|(name, _)| name)
    }

    /// The vector of the construction that leads to a point, and where it begins.
    fn vector_to(&self, sheet: Sheet, name: &str) -> Option<(String, Vector)> {
        let construction = self.table.given.construction();
        let arrow = construction.arrows(sheet).find(|arrow| arrow.to == name)?;
        let vector = self.table.given.place(sheet, &arrow.to)? - self.table.given.place(sheet, &arrow.from)?;
        Some((arrow.from.clone(), vector))
    }

    /// An image on the wrong side, or with its distances exchanged.
    pub(super) fn image(&self, like: &Like, sheet: Sheet, right: Vector) -> Option<Told> {
        let would_be = |changed: Like| {
            let made = self.table.carried_out_again(&Entry::Like(changed));
            let small = 1e-6 * self.table.given.size(sheet);
            matches!(made, Ok(Made::Place(_, _, at)) if (at - right).norm() <= small)
        };
        let [from, to] = like.ends.each_ref().map(|end| Blank::from(end.as_str()));
        let point = Blank::from(like.like.as_str());
        if would_be(Like { mirrored: !like.mirrored, ..like.clone() }) {
            return Some(tell::mirrored_image(from, point, to));
        }
        let [a, b, c] = &like.points;
        for mirrored in [false, true] {
            let orders = [[b, a, c], [a, c, b], [c, b, a], [b, c, a], [c, a, b]];
            let exchanged = orders
                .into_iter()
                .find(|points| would_be(Like { points: points.map(Clone::clone), mirrored, ..like.clone() }));
            if exchanged.is_some() {
                return Some(tell::wrong_ratio(from, to, point));
            }
        }
        None
    }
}
