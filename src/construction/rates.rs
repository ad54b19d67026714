//! The unknown rates of a group: solved for, or taken from the computed motion, and compared with it.

use super::constructed::Agreement;
use super::number::{NumberId, Rate};
use super::writer::Writer;
use crate::geometry::span;
use crate::mechanism::{Group, LoopEquations};
use crate::sheet::Sheet;
use core::cmp::Reverse;

/// An unknown rate of a group.
#[derive(Clone, Copy)]
pub(super) struct UnknownRate {
    /// Its index among the unknowns of the group's equations.
    pub index: usize,
    /// The rate; several links may have the same.
    pub rate: Rate,
    /// Its value in the computed motion, with the bound of its error.
    pub value: f64,
    error: f64,
}

impl Writer<'_> {
    /// The rates of links, then of sliders, that the equations of a plan are solved for.
    pub(super) fn unknown_rates(&self, sheet: Sheet, group: &Group, equations: &LoopEquations) -> Vec<UnknownRate> {
        let (motion, order) = (self.motion, sheet.order());
        let links = group.bodies.iter().filter_map(|&link| {
            let (body, errors) = (motion.body(link), motion.error(link));
            let omega = (Rate::Omega(link), body.omega, errors.omega);
            let alpha = (Rate::Alpha(link), body.alpha, errors.alpha);
            Some((equations.angular_unknown(link)?, [omega, alpha]))
        });
        let sliders = self.mechanism.slider_ids().filter_map(|id| {
            let slide = motion.slide(id);
            let velocity = (Rate::SlideVelocity(id), slide.velocity, slide.velocity_error);
            let acceleration = (Rate::SlideAcceleration(id), slide.acceleration, slide.acceleration_error);
            Some((equations.slide_unknown(id)?, [velocity, acceleration]))
        });
        let of_order = |(index, rates): (usize, [(Rate, f64, f64); 2])| {
            let (rate, value, error) = rates[order];
            UnknownRate { index, rate, value, error }
        };
        links.chain(sliders).map(of_order).collect()
    }

    /// Notes the numbers of solved rates. Of links that turn alike the one with most points gives the rate its name.
    pub(super) fn note_rates(&mut self, unknown: &[UnknownRate], numbers: &[NumberId]) {
        for &UnknownRate { index, rate, .. } in unknown {
            self.construction.set_rate(rate, numbers[index]);
            let alike = unknown.iter().filter(|other| other.index == index);
            let alike = alike.filter_map(|other| Some((other.rate, other.rate.link()?)));
            let most = alike.min_by_key(|(_, link)| Reverse(self.mechanism.body(*link).points.len()));
            if let Some((most, _)) = most.filter(|(most, _)| *most != rate) {
                let [name, most] = [rate, most].map(|rate| rate.name(self.mechanism));
                self.construction.same_rates.insert(name, most);
            }
        }
    }

    /// Takes the rates of a group without a construction from the motion; marked as not found by hand.
    pub(super) fn take_computed_rates(&mut self, group: &Group, equations: &LoopEquations) {
        let both = Sheet::PLANS.map(|sheet| self.unknown_rates(sheet, group, equations));
        for at in 0..both[0].len() {
            for (sheet, unknown) in Sheet::PLANS.into_iter().zip(&both) {
                let UnknownRate { rate, value, error, .. } = unknown[at];
                let number = self.take_computed(sheet, rate, value, error);
                self.construction.set_rate(rate, number);
            }
        }
    }

    /// Compares the solved rates of a group with those from the loop equations.
    pub(super) fn agreement(&self, group: &Group, equations: &LoopEquations) -> Agreement {
        let mut result = Agreement { difference: 0.0, allowed: 0.0 };
        let size = span(self.pose.points.iter().copied());
        for &sheet in self.plans() {
            let scale = self.largest_rate(sheet.order(), size);
            // Subnormal rates have lost digits: they count as zero.
            if scale < f64::MIN_POSITIVE {
                continue;
            }
            for UnknownRate { rate, value, error, .. } in self.unknown_rates(sheet, group, equations) {
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
}
