use super::operation::NumberId;
use super::writer::Writer;
use crate::mechanism::{Group, LoopEquations, SliderId};

/// How the two routes to the rates compare.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The largest difference of an angular or slide rate between the routes, velocity or acceleration,
    /// relative to the largest rate of its kind.
    pub difference: f64,
    /// The difference that rounding, the condition and the sines of the crossings allow, in the same measure.
    pub allowed: f64,
}

/// A rate by both routes: the number of the construction, the loop equations' value with the bound of its error.
type Both = (NumberId, f64, f64);

impl Writer<'_> {
    /// Compares the solved rates of a group, as large as `size`, with the motion from the loop equations.
    pub(super) fn agreement(&self, group: &Group, equations: &LoopEquations, size: f64) -> Agreement {
        let mut result = Agreement { difference: 0.0, allowed: 0.0 };
        for order in 0..self.plans().len() {
            let (spins, slides) = (self.spins_of(group, equations, order), self.slides_of(equations, order));
            // One measure for both kinds: a slide rate counts as the rate at the mechanism's size.
            let largest = |rates: &[Both]| rates.iter().fold(0.0, |m: f64, rate| m.max(rate.1.abs()));
            let scale = largest(&spins).max(largest(&slides) / size);
            // Rates too small to have all their digits are zero but for rounding.
            if scale < f64::MIN_POSITIVE {
                continue;
            }
            let spins = spins.iter().map(|rate| (rate, scale));
            for (&(number, rate, error), scale) in spins.chain(slides.iter().map(|rate| (rate, scale * size))) {
                let constructed = self.exact.exact_number(number);
                let difference = (constructed.high - rate).abs() / scale;
                let allowed = (constructed.error() + error) / scale;
                // A rate may be that much smaller than its rounding; what is not a number, of no size at all, is no difference.
                let finite = |x: f64| if x == f64::INFINITY { f64::MAX } else { x };
                result.difference = result.difference.max(finite(difference));
                result.allowed = result.allowed.max(finite(allowed));
            }
        }
        result
    }

    fn spins_of(&self, group: &Group, equations: &LoopEquations, order: usize) -> Vec<Both> {
        let unknown = group.bodies.iter().filter(|&&link| equations.spin_unknown(link).is_some());
        let both = unknown.filter_map(|&link| {
            let (body, errors) = (self.motion.body(link), self.motion.error(link));
            let (rate, error) = [(body.omega, errors.omega), (body.alpha, errors.alpha)][order];
            Some((self.construction.spins[link.0]?[order]?, rate, error))
        });
        both.collect()
    }

    fn slides_of(&self, equations: &LoopEquations, order: usize) -> Vec<Both> {
        let unknown =
            (0..self.mechanism.sliders.len()).map(SliderId).filter(|&id| equations.slide_unknown(id).is_some());
        let both = unknown.filter_map(|id| {
            let slide = self.motion.slide(id);
            let (rate, error) =
                [(slide.velocity, slide.velocity_error), (slide.acceleration, slide.acceleration_error)][order];
            Some((self.construction.slides[id.0]?[order]?, rate, error))
        });
        both.collect()
    }
}
