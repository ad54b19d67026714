//! Which part of a path is followed and shown, at which steps, and what is said of it.

use super::{CycleError, Event, Path, says};
use crate::Problem;
use crate::words::Wording;

/// The widest range that is followed, in turns to each side.
const MOST_TURNS: f64 = 100.0;

/// How far a slider's path is followed where its ends are searched, in sizes of the mechanism.
const FAR: f64 = 10.0;

/// Distance that a slider without ends is followed either way, in parts of the mechanism's size.
const OPEN_RANGE: f64 = 0.3;

/// Narrowest part that is told, in turns.
const NARROW: f64 = 0.01;

/// A part of a range that a drive reaches the other way round: beyond a limit position, but a whole turn away between the
/// limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detour {
    /// The values of the drive on the path.
    pub part: [f64; 2],
    /// The same positions by the values that were asked for, a whole turn away.
    pub asked: [f64; 2],
    /// The least and the greatest value that hold this part and what was reached at once.
    pub both: [f64; 2],
}

impl Path<'_> {
    /// Follows the branch over the range from one value of the drive to another, as far as it can be reached; with
    /// neither end given, once around or from end to end. Returns the range from the first to the second value.
    ///
    /// A crank that cannot turn fully has the same positions a whole turn further on: where only those are in the
    /// range, values of the drive are counted anew from there.
    ///
    /// # Errors
    /// No part of the range can be reached, or it is wider than a hundred turns.
    pub fn cover(&mut self, from: Option<f64>, to: Option<f64>) -> Result<[f64; 2], CycleError> {
        let turn = self.unit();
        let range = match (from, to) {
            (Some(from), Some(to)) => [from, to],
            (Some(from), None) if self.drive.is_angle => [from, from + turn],
            (None, Some(to)) => [self.origin, to],
            (None, None) => self.once()?,
            (Some(_), None) => return Err(self.no_range()),
        };
        if !range.iter().all(|end| end.is_finite()) {
            return Err(CycleError::Range(says::not_finite().into()));
        }
        let widest = MOST_TURNS * turn;
        if range.iter().any(|v| (v - self.origin).abs() > widest) {
            let [low, high] = [-widest, widest].map(|by| self.drive.amount(self.origin + by));
            let message = if self.drive.is_angle { says::too_many_turns() } else { says::too_far() };
            return Err(CycleError::Range(Problem::new(message).hint(says::values_between(low, high))));
        }
        range.iter().for_each(|v| self.follow_to(*v));
        let (low, high) = (range[0].min(range[1]), range[0].max(range[1]));
        let outside = |path: &Self| low > path.high() || high < path.low();
        if outside(self) && self.drive.is_angle {
            self.once()?;
            let turns = ((low - self.high()) / turn).ceil();
            if self.low() + turns * turn <= high {
                self.count_from(self.origin + turns * turn);
                range.iter().for_each(|v| self.follow_to(*v));
            }
        }
        if outside(self) {
            let end = self.end(low > self.high());
            let stop = end.map(|end| self.told(end, &Wording::default()));
            let [from, to] = range.map(|v| self.drive.amount(v));
            let reached = [(false, self.low()), (true, self.high())];
            let [low, high] = reached.map(|(above, v)| match self.end(above) {
                Some(end) => self.drive.amount_within(end.at, end.within),
                None => self.drive.amount(v),
            });
            return Err(CycleError::OutOfReach { from, to, stop: stop.unwrap_or_default(), low, high });
        }
        Ok(range)
    }

    /// How far a branch is followed to find its ends: a turn, or ten sizes of the mechanism.
    pub(super) fn far(&self) -> f64 {
        let units = if self.drive.is_angle { 1.0 } else { FAR };
        units * self.unit()
    }

    /// Follows the branch once around, or from end to end; that of a slider must have two ends.
    pub(super) fn once(&mut self) -> Result<[f64; 2], CycleError> {
        let far = self.far();
        self.follow_to(self.origin + far);
        if self.is_round() {
            return Ok([self.origin, self.origin + far]);
        }
        self.follow_to(self.origin - far);
        if self.drive.is_angle || self.ends.iter().all(Option::is_some) {
            Ok([self.low(), self.high()])
        } else {
            Err(self.no_range())
        }
    }

    fn no_range(&self) -> CycleError {
        let quantity = &self.drive.quantity;
        CycleError::Range(Problem::new(says::no_range(quantity)).hint(says::both_ends()))
    }

    /// Follows the branch once around or from end to end, that of a slider without ends a part of the mechanism's size
    /// either way; returns that range.
    pub(super) fn whole_range(&mut self) -> Result<[f64; 2], CycleError> {
        match self.cover(None, None) {
            Err(CycleError::Range(_)) => {
                let (start, reach) = (self.start(), OPEN_RANGE * self.unit());
                self.cover(Some(start - reach), Some(start + reach))
            }
            range => range,
        }
    }

    /// Whether the drive turns all the way round, as far as the path has been followed.
    pub(super) fn is_round(&self) -> bool {
        self.drive.is_angle && self.end(true).is_none()
    }

    /// What of a range beyond a limit position the drive reaches the other way round; the wider part where there are
    /// two. `None` where there is nothing of that kind, and where other drives run along, which stand elsewhere a turn
    /// further on.
    #[must_use]
    pub fn other_way_round(&self, range: [f64; 2]) -> Option<Detour> {
        let runs_along = |(index, [_, ratio]): (usize, &[f64; 2])| index != self.drive.input && *ratio != 0.0;
        if !self.drive.is_angle || self.inputs.iter().enumerate().any(runs_along) {
            return None;
        }
        let mut whole = self.clone();
        whole.once().ok()?;
        whole.end(false).and(whole.end(true))?;
        let turn = self.unit();
        let [low, high] = [range[0].min(range[1]), range[0].max(range[1])];
        let reached = [low.max(self.low()), high.min(self.high())];
        let above = [reached[1].max(low + turn), whole.high().min(reached[0] + turn)];
        let below = [whole.low().max(reached[1] - turn), reached[0].min(high - turn)];
        let width = |part: [f64; 2]| part[1] - part[0];
        let (part, turns) = if width(above) >= width(below) { (above, -1.0) } else { (below, 1.0) };
        (width(part) > NARROW * turn).then(|| Detour {
            part,
            asked: part.map(|v| v + turns * turn),
            both: [part[0].min(reached[0]), part[1].max(reached[1])],
        })
    }

    /// The range of a figure, for the range that [`Path::cover`] gave without ends: one full turn is shown from 0° to 360°.
    pub fn shown_range(&mut self, range: [f64; 2]) -> [f64; 2] {
        if !self.is_round() {
            return range;
        }
        let turn = 360.0 * (range[0] / 360.0).floor();
        self.follow_to(turn);
        if self.low() <= turn { [turn, turn + 360.0] } else { range }
    }

    /// What happens on the path within a range, in words: extreme and change points.
    #[must_use]
    pub fn happenings(&self, range: [f64; 2], words: &Wording) -> Vec<String> {
        let mut events = self.events();
        events.retain(|event| !event.is_end() && self.touches(event, range));
        events.iter().map(|event| self.told(event, words)).collect()
    }

    /// The limits that end the path within a range, in words; all of them without a range.
    #[must_use]
    pub fn limits(&self, range: Option<[f64; 2]>, words: &Wording) -> Vec<String> {
        let is_inside = |at: f64| range.is_none_or(|[a, b]| (a.min(b)..=a.max(b)).contains(&at));
        let ends = [false, true].into_iter().filter_map(|above| self.end(above));
        ends.filter(|end| is_inside(end.at)).map(|end| self.told(end, words)).collect()
    }

    /// An event with its place, in words.
    #[must_use]
    pub fn told(&self, event: &Event, words: &Wording) -> String {
        event.text(&self.drive.at_within(event.at, event.within, words), words)
    }

    /// The step of a table: 1° for an angle; for a slider the largest of 1, 2 or 5 times a power of ten that is at most a
    /// two-hundredth of the range.
    #[must_use]
    pub fn usual_step(&self, [from, to]: [f64; 2]) -> f64 {
        if self.drive.is_angle {
            return 1.0;
        }
        let rough = (to - from).abs() / 200.0;
        if rough == 0.0 {
            return 1.0;
        }
        let decade = libm::exp10(libm::floor(libm::log10(rough)));
        let round = [1.0, 2.0, 5.0, 10.0].map(|k| k * decade);
        round.into_iter().rfind(|s| *s <= rough).unwrap_or(1.0)
    }

    /// The rows of a table over the whole motion: once around from the scene's own position, or, between limit positions,
    /// at multiples of the step.
    ///
    /// # Errors
    /// As for [`Steps::new`].
    pub fn rows(&self, [from, to]: [f64; 2], step: f64) -> Result<Steps, CycleError> {
        match self.end(false) {
            Some(_) => Steps::multiples(from, to, step),
            None => Steps::new(from, to, step),
        }
    }
}

/// Most values that a table may have.
const MOST_VALUES: f64 = 1e12;

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
            return refuse(says::not_finite().into());
        }
        if step == 0.0 || !step.is_finite() {
            return refuse(Problem::new(says::no_step(step)).hint(says::distance_of_rows()));
        }
        if step < 0.0 && wide > 0.0 {
            return refuse(Problem::new(says::step_leads_away(step)).hint(says::positive_step()));
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
        if intervals >= MOST_VALUES {
            let message = says::too_many_steps(format!("{MOST_VALUES:e}"), step, from, to);
            return refuse(Problem::new(message).hint(says::larger_step()));
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
