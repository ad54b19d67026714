//! What is shown of a path where nobody says which part of it.

use super::{CycleError, Event, Path, Steps};
use crate::words::Wording;

impl Path<'_> {
    /// The range of a figure, for the range that [`Path::cover`] gave without ends: one full turn is shown from 0° to 360°.
    pub fn shown_range(&mut self, range: [f64; 2]) -> [f64; 2] {
        if !self.drive.is_angle() || self.end(true).is_some() {
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
        event.text(&self.drive.at(event.at, words), words)
    }

    /// The step of a table: 1° for an angle; for a slider the largest of 1, 2 or 5 times a power of ten that is at most a
    /// two-hundredth of the range.
    #[must_use]
    pub fn usual_step(&self, [from, to]: [f64; 2]) -> f64 {
        if self.drive.is_angle() {
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
