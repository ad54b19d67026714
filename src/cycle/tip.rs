use super::curve::Shown;
use super::reading::Reading;
use super::{CycleError, Path};
use crate::geometry::Vector;
use crate::quantity::QuantityRequest;

/// Step between the angles of the drive at which a way is marked, in degrees.
pub(super) const MARKS: f64 = 30.0;
/// Approximate number of marks in a range of a slider, or of an angle that is no whole turn.
const MARKS_OF_RANGE: f64 = 12.0;
/// Difference of two values of the drive that counts as none, in parts of the range.
pub(super) const SAME: f64 = 1e-9;

/// The way of a point of the plane over a path: the tip of a vector, or a point of the mechanism.
pub(super) struct Tip<'a> {
    parts: [Reading<'a>; 2],
}

impl<'a> Tip<'a> {
    /// The point whose coordinates are the quantities of these names.
    pub fn new(path: &'a Path<'a>, [x, y]: [&str; 2]) -> Result<Self, CycleError> {
        let reading =
            |name| -> Result<_, CycleError> { Ok(Reading::new(path, QuantityRequest::new(name, &path.mechanism)?)) };
        Ok(Tip { parts: [reading(x)?, reading(y)?] })
    }

    /// The point at a value of the drive; `None` where it has no place.
    pub fn at(&mut self, value: f64) -> Option<Vector> {
        let [x, y] = &mut self.parts;
        Some(Vector::new(x.at(value, None)?, y.at(value, None)?))
    }
}

impl Shown {
    /// Whether it is a whole turn of the drive.
    pub fn is_turn(&self, path: &Path) -> bool {
        let [low, high] = self.range;
        path.drive.is_angle() && high - low >= 360.0 * (1.0 - SAME)
    }

    /// The scene's own value of the drive, which may be in the range with whole turns added.
    pub fn own(&self, path: &Path) -> Option<f64> {
        let ([low, high], start) = (self.range, path.start());
        let turns = if path.drive.is_angle() { 360.0 * ((low - start) / 360.0 - SAME).ceil() } else { 0.0 };
        Some(start + turns).filter(|at| (low..=high).contains(at))
    }

    /// Round values of the drive at which ways are marked, `step` apart; in a whole turn each once.
    pub fn round_values(&self, path: &Path, step: f64) -> Vec<f64> {
        let [low, high] = self.range;
        let turn = if path.drive.is_angle() { low + 360.0 - SAME * 360.0 } else { f64::INFINITY };
        let first = (low / step - SAME).ceil();
        let count = ((high - low) / step) as usize + 1;
        (0..count).map(|k| (first + k as f64) * step).filter(|at| *at <= high && *at < turn).collect()
    }

    /// A round step that divides the range in about twelve parts.
    pub fn round_step(&self) -> f64 {
        let [low, high] = self.range;
        let rough = (high - low) / MARKS_OF_RANGE;
        let decade = libm::exp10(libm::floor(libm::log10(rough)));
        let steps = [1.0, 2.0, 5.0, 10.0].map(|k| k * decade);
        steps.into_iter().find(|s| *s >= rough).unwrap_or(rough)
    }
}
