use super::operation::NumberId;
use super::writer::Writer;
use crate::geometry::span;
use crate::mechanism::{Group, LoopEquations, SliderId};

/// Comparison of the rates from the construction with those from the loop equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The largest difference of an angular or slide rate, velocity or acceleration, relative to the mechanism's largest
    /// rate of its kind.
    pub difference: f64,
    /// The largest difference that rounding, the condition and the sines of the crossings allow, relative in the same
    /// way.
    pub allowed: f64,
}

/// An unknown rate: its number in the construction, and its value from the loop equations with the bound of its error.
type UnknownRate = (NumberId, f64, f64);

impl Writer<'_> {
    /// Compares the solved rates of a group with those from the loop equations.
    pub(super) fn agreement(&self, group: &Group, equations: &LoopEquations) -> Agreement {
        let mut result = Agreement { difference: 0.0, allowed: 0.0 };
        let size = span(self.pose.points.iter().copied());
        for order in 0..self.plans().len() {
            let (spins, slides) = (self.unknown_spins(group, equations, order), self.unknown_slides(equations, order));
            let scale = self.largest_rate(order, size);
            // Subnormal rates have lost digits: they count as zero.
            if scale < f64::MIN_POSITIVE {
                continue;
            }
            let spins = spins.iter().map(|rate| (rate, scale));
            for (&(number, rate, error), scale) in spins.chain(slides.iter().map(|rate| (rate, scale * size))) {
                let constructed = self.exact.exact_number(number);
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

    fn unknown_spins(&self, group: &Group, equations: &LoopEquations, order: usize) -> Vec<UnknownRate> {
        let unknown = group.bodies.iter().filter(|&&link| equations.angular_unknown(link).is_some());
        let rates = unknown.filter_map(|&link| {
            let (body, errors) = (self.motion.body(link), self.motion.error(link));
            let (rate, error) = [(body.omega, errors.omega), (body.alpha, errors.alpha)][order];
            Some((self.construction.spins[link.0]?[order]?, rate, error))
        });
        rates.collect()
    }

    fn unknown_slides(&self, equations: &LoopEquations, order: usize) -> Vec<UnknownRate> {
        let unknown =
            (0..self.mechanism.sliders.len()).map(SliderId).filter(|&id| equations.slide_unknown(id).is_some());
        let rates = unknown.filter_map(|id| {
            let slide = self.motion.slide(id);
            let (rate, error) =
                [(slide.velocity, slide.velocity_error), (slide.acceleration, slide.acceleration_error)][order];
            Some((self.construction.slides[id.0]?[order]?, rate, error))
        });
        rates.collect()
    }
}
