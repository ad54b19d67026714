//! The construction of all groups, one after another, and its comparison with the loop equations.

use super::construction::{Agreement, Construction, Extent};
use super::cut::{Special, SpecialId, special_points};
use super::leg::DrawnSpecial;
use super::number::NumberId;
use super::step::Action;
use super::writer::Writer;
use crate::geometry::span;
use crate::mechanism::{AngularRate, BodyId, Group, LoopEquations, Mechanism, PointId, SliderId};
use crate::motion::Motion;
use crate::position::Pose;
use crate::sheet::Sheet;

/// The construction of both plans from one pole each, for every group of `mechanism`.
///
/// Joints are plotted at their places. Lengths between two points of one link are taken from the scene, other lengths
/// are measured, as are all in a drawn configuration. A guide that runs through two points of its link is drawn through
/// them, any other in its direction. For a group without a construction, and for bodies whose motion follows from it,
/// rates and vectors are taken from `motion`.
#[must_use]
pub fn construct(mechanism: &Mechanism, pose: &Pose, motion: &Motion, extent: Extent) -> Construction {
    let mut writer = Writer::new(mechanism, pose, motion, extent);
    for group in &mechanism.groups {
        writer.group(group);
        if extent == Extent::Points {
            group.bodies.iter().for_each(|&body| writer.further_images(body));
        }
    }
    if extent == Extent::Points {
        mechanism.body_ids().filter(|&body| mechanism.is_known(body)).for_each(|body| writer.further_images(body));
    }
    writer.construction.note_makers();
    writer.construction
}

/// An unknown rate: its number in the construction, and its value from the loop equations with the bound of its error.
type UnknownRate = (NumberId, f64, f64);

impl Writer<'_> {
    /// Constructs the next group: each of its special points by two rays, then the rates from measured segments.
    /// Without such a construction the rates come from the motion.
    fn group(&mut self, group: &Group) {
        let first = self.construction.special_count();
        let special = special_points(self.mechanism, self.pose, group);
        let equations = LoopEquations::new(self.mechanism, group);
        for &link in &group.bodies {
            if let AngularRate::Known(body) = equations.angular_rate_of(link) {
                self.construction.angular_rates[link.0] = self.construction.angular_rates[body.0];
            }
        }
        let has_crossing =
            |s: &Special| s.place.finite().is_some() && s.cuts.iter().all(|c| c.line.direction().is_some());
        let equation_count = 2 * special.len() + equations.angular.len();
        let has_rays = equation_count == equations.unknowns && special.iter().all(has_crossing);
        let ids = (first..).map(SpecialId);
        let drawn: Vec<Option<DrawnSpecial<'_>>> =
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
        let drawn: Option<Vec<DrawnSpecial<'_>>> = drawn.into_iter().collect();
        let constructed = drawn.filter(|_| has_rays).and_then(|drawn| self.rates(group, &equations, &drawn));
        if constructed.is_none() {
            self.without_construction(group, &equations, &special);
        }
        let agreement = constructed.map(|()| self.agreement(group, &equations));
        self.construction.agreement.push(agreement);
        self.construction.add_special(special);
    }

    /// Constructs both plans; `None` where rays are parallel or the equations have no solution.
    fn rates(&mut self, group: &Group, equations: &LoopEquations, drawn: &[DrawnSpecial<'_>]) -> Option<()> {
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
            let step = self.begin(sheet);
            self.finish(step, Action::NoConstruction { far: far.clone() });
        }
        self.take_computed_rates(group, equations);
        self.note_anchors(group);
        for &sheet in self.plans() {
            self.relative_images(sheet, group);
        }
    }

    /// Compares the solved rates of a group with those from the loop equations.
    fn agreement(&self, group: &Group, equations: &LoopEquations) -> Agreement {
        let mut result = Agreement { difference: 0.0, allowed: 0.0 };
        let size = span(self.pose.points.iter().copied());
        for order in 0..self.plans().len() {
            let angular = self.unknown_angular_rates(group, equations, order);
            let slides = self.unknown_slide_rates(equations, order);
            let scale = self.largest_rate(order, size);
            // Subnormal rates have lost digits: they count as zero.
            if scale < f64::MIN_POSITIVE {
                continue;
            }
            let angular = angular.iter().map(|rate| (rate, scale));
            for (&(number, rate, error), scale) in angular.chain(slides.iter().map(|rate| (rate, scale * size))) {
                let constructed = self.construction.record.exact.exact_number(number);
                let difference = (constructed.high - rate).abs() / scale;
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

    /// The mechanism's largest angular velocity or acceleration; it also counts other velocities and accelerations, over
    /// the mechanism's size, and ω². A group that stands still has no measure of its own.
    fn largest_rate(&self, order: usize, size: f64) -> f64 {
        let bodies = self.motion.bodies.iter().map(|body| {
            [body.omega.abs().max(body.velocity.norm() / size), {
                let turning = body.alpha.abs().max(body.omega * body.omega);
                turning.max(body.acceleration.norm() / size)
            }]
        });
        let slides = self.motion.slides.iter();
        let slides = slides.map(|slide| [slide.velocity.abs() / size, slide.acceleration.abs() / size]);
        // `max` ignores NaN, as of a mechanism without size.
        bodies.chain(slides).fold(0.0, |largest: f64, rates| largest.max(rates[order]))
    }

    fn unknown_angular_rates(&self, group: &Group, equations: &LoopEquations, order: usize) -> Vec<UnknownRate> {
        let unknown = group.bodies.iter().filter(|&&link| equations.angular_unknown(link).is_some());
        let rates = unknown.filter_map(|&link| {
            let (body, errors) = (self.motion.body(link), self.motion.error(link));
            let (rate, error) = [(body.omega, errors.omega), (body.alpha, errors.alpha)][order];
            Some((self.construction.angular_rates[link.0]?[order]?, rate, error))
        });
        rates.collect()
    }

    fn unknown_slide_rates(&self, equations: &LoopEquations, order: usize) -> Vec<UnknownRate> {
        let unknown =
            (0..self.mechanism.sliders.len()).map(SliderId).filter(|&id| equations.slide_unknown(id).is_some());
        let rates = unknown.filter_map(|id| {
            let slide = self.motion.slide(id);
            let (rate, error) =
                [(slide.velocity, slide.velocity_error), (slide.acceleration, slide.acceleration_error)][order];
            Some((self.construction.slide_rates[id.0]?[order]?, rate, error))
        });
        rates.collect()
    }
}
