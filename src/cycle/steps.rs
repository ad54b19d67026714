use super::CycleError;
use crate::Problem;

/// Most values that a table may have.
const MOST: f64 = 1e12;

/// Values of a drive at equal steps.
///
/// Where the first value and the step are short decimals, each value is the f64 nearest to its decimal: 0.3, not 0.1 +
/// 0.1 + 0.1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// The first value and the step, both times `scale`: whole numbers where both are short decimals.
    from: f64,
    step: f64,
    scale: f64,
    count: usize,
}

impl Steps {
    /// The values `from`, `from` ± `step` … as far as `to`; the sign of the step follows from the direction.
    ///
    /// # Errors
    /// [`CycleError::Range`] where a number is not finite, the step is zero or leads away from `to`, or there are too
    /// many values.
    pub fn new(from: f64, to: f64, step: f64) -> Result<Steps, CycleError> {
        let refuse = |problem| Err(CycleError::Range(problem));
        let wide = to - from;
        if !wide.is_finite() {
            return refuse("the ends of the range must be finite numbers".into());
        }
        if step == 0.0 || !step.is_finite() {
            let hint = "the distance from one row to the next, as 1";
            return refuse(Problem::new(format!("the step cannot be {step}")).hint(hint));
        }
        if step < 0.0 && wide > 0.0 {
            let hint = "a positive step; its sign follows from the range";
            let message = format!("a step of {step} leads away from the end of the range");
            return refuse(Problem::new(message).hint(hint));
        }
        let step = step.abs().copysign(wide);
        let farthest = from.abs().max(to.abs());
        let (first, by, scale) = match whole_scale([from, step], farthest) {
            Some(scale) => ((from * scale).round(), (step * scale).round(), scale),
            None => (from, step, 1.0),
        };
        // A quotient just below a whole number is that number: the difference is rounding.
        let rounding = 4.0 * f64::EPSILON * (farthest * scale / by).abs();
        let intervals = ((to * scale - first) / by + rounding).floor();
        if intervals >= MOST {
            let message = format!("there are more than {MOST:e} steps of {step} from {from} to {to}");
            return refuse(Problem::new(message).hint("a larger step"));
        }
        Ok(Steps { from: first, step: by, scale, count: intervals as usize + 1 })
    }

    /// All whole multiples of `step` between two values, upwards.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn multiples(low: f64, high: f64, step: f64) -> Result<Steps, CycleError> {
        let steps = Steps::new(0.0, high - low, step)?;
        let from = steps.step * (low / step).ceil();
        Ok(Steps { from, ..steps }.within(low, high))
    }

    /// How many values there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The value of that index.
    #[inline]
    #[must_use]
    pub fn value(&self, index: usize) -> f64 {
        (self.from + self.step * index as f64) / self.scale
    }

    /// Those of the values that lie between two others, both included.
    pub(super) fn within(&self, low: f64, high: f64) -> Steps {
        let inside = |index: &usize| (low..=high).contains(&self.value(*index));
        let rising = self.step > 0.0;
        let (near, far) = if rising { (low, high) } else { (high, low) };
        // The quotients may be one off by rounding.
        let index = |value: f64| {
            let steps = (value * self.scale - self.from) / self.step;
            steps.clamp(0.0, self.count as f64) as usize
        };
        let first = (index(near).saturating_sub(1)..self.count).take(4).find(inside);
        let last = (0..(index(far) + 2).min(self.count)).rev().take(4).find(inside);
        match (first, last) {
            (Some(first), Some(last)) => {
                Steps { from: self.from + self.step * first as f64, count: last + 1 - first, ..*self }
            }
            _ => Steps { count: 0, ..*self },
        }
    }
}

/// The smallest power of ten that makes these decimals whole numbers; `None` where `farthest` times it is not exact in
/// f64.
fn whole_scale(decimals: [f64; 2], farthest: f64) -> Option<f64> {
    let mut scales = (0..=15).map(|digits| libm::exp10(f64::from(digits)));
    let is_whole = |x: f64, scale: f64| (x * scale).round() / scale == x;
    let room = 1.0 / f64::EPSILON;
    scales.find(|scale| decimals.into_iter().all(|x| is_whole(x, *scale))).filter(|scale| farthest * scale < room)
}
