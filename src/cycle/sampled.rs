use super::{CycleError, Event, Path, says};
use crate::Problem;

/// Step between the angles of the drive at which curves of points are marked, in degrees.
pub(super) const MARKS: f64 = 30.0;

/// Approximate number of marks in a range of a slider, or of an angle that is no whole turn.
const MARKS_OF_RANGE: f64 = 12.0;

/// Equal parts of the range at which a curve is sampled first.
pub(super) const PARTS: usize = 128;

/// Parts into which first samples divide every segment of the path: no feature of the motion is smaller.
const PARTS_OF_SEGMENT: usize = 2;

/// Difference of two values of the drive that counts as none, in parts of a turn or of the range.
pub(super) const SAME: f64 = 1e-9;

/// Curves over the part of a range that a path has reached.
#[derive(Clone, Debug)]
pub struct Sampled<'a, T> {
    /// The path.
    pub path: &'a Path<'a>,
    /// Lowest and highest value of the drive that are shown: the part of the range that the path has reached, limits
    /// included.
    pub range: [f64; 2],
    /// The curves, in the order in which they were asked for.
    pub curves: Vec<T>,
    /// The events in the range, in the order of the drive's value.
    pub events: Vec<Event>,
}

impl<'a, T> Sampled<'a, T> {
    /// The part of this range that the path has reached, without curves yet.
    pub(super) fn reached(path: &'a Path<'a>, range: [f64; 2]) -> Result<Self, CycleError> {
        let mut low = range[0].min(range[1]).max(path.low());
        let mut high = range[0].max(range[1]).min(path.high());
        // There is no curve in a range without width, or of a few roundings' width.
        if high.is_nan() || low.is_nan() || high - low <= SAME * path.unit() {
            let [from, to] = [low, high].map(|v| path.drive.amount(v));
            return Err(CycleError::Range(Problem::new(says::no_room(from, to)).hint(says::more_room())));
        }
        // The path stops just before its limits; the range includes them.
        if low == path.low() {
            low = path.limit(false).unwrap_or(low);
        }
        if high == path.high() {
            high = path.limit(true).unwrap_or(high);
        }
        let mut events = path.events();
        events.retain(|event| (low..=high).contains(&event.at));
        Ok(Sampled { path, range: [low, high], curves: Vec::new(), events })
    }

    /// Whether the range is a whole turn of the drive.
    fn is_turn(&self) -> bool {
        let [low, high] = self.range;
        self.path.drive.is_angle && high - low >= 360.0 * (1.0 - SAME)
    }

    /// A value of the drive as marks show it: an angle of a whole turn is counted from 0° to 360°.
    pub(super) fn called(&self, value: f64) -> f64 {
        if self.is_turn() { value.rem_euclid(360.0) } else { value }
    }

    /// The scene's own value of the drive, which may be in the range with whole turns added.
    pub(super) fn own(&self) -> Option<f64> {
        let ([low, high], start) = (self.range, self.path.start());
        let turns = if self.path.drive.is_angle { 360.0 * ((low - start) / 360.0 - SAME).ceil() } else { 0.0 };
        Some(start + turns).filter(|at| (low..=high).contains(at))
    }

    /// Round values of the drive at which curves are marked, `step` apart; in a whole turn each once.
    pub(super) fn round_values(&self, step: f64) -> Vec<f64> {
        let [low, high] = self.range;
        let turn = if self.path.drive.is_angle { low + 360.0 - SAME * 360.0 } else { f64::INFINITY };
        let first = (low / step - SAME).ceil();
        let count = ((high - low) / step) as usize + 1;
        (0..count).map(|k| (first + k as f64) * step).filter(|at| *at <= high && *at < turn).collect()
    }

    /// A round step that divides the range in about twelve parts.
    pub(super) fn round_step(&self) -> f64 {
        let [low, high] = self.range;
        let rough = (high - low) / MARKS_OF_RANGE;
        let decade = libm::exp10(libm::floor(libm::log10(rough)));
        let steps = [1.0, 2.0, 5.0, 10.0].map(|k| k * decade);
        steps.into_iter().find(|s| *s >= rough).unwrap_or(rough)
    }

    /// The step between the ticks of a point's path: 30° of a drive that turns all the way round, else
    /// [`Self::round_step`].
    pub(super) fn tick_step(&self) -> f64 {
        if self.is_turn() { MARKS } else { self.round_step() }
    }

    /// Values of the drive at which all curves are sampled first.
    pub(super) fn grid(&self) -> Vec<f64> {
        let [low, high] = self.range;
        let part = |k: usize, parts: usize, [a, b]: [f64; 2]| a + (b - a) * k as f64 / parts as f64;
        let mut grid: Vec<f64> = (0..=PARTS).map(|k| part(k, PARTS, [low, high])).collect();
        for segment in &self.path.segments {
            let inner = (0..PARTS_OF_SEGMENT).map(|k| part(k, PARTS_OF_SEGMENT, [segment.from, segment.to]));
            grid.extend(inner.filter(|x| (low..high).contains(x)));
        }
        grid.sort_by(f64::total_cmp);
        grid.dedup_by(|b, a| *b - *a <= SAME * (high - low));
        let last = grid.len() - 1;
        grid[last] = high;
        grid
    }
}
