use crate::drawing::text::RichText;
use crate::drawing::view::next_of;
use crate::words::{Medium, NumberStyle, Wording};

/// Round steps of angles, in degrees.
const DEGREES: [f64; 17] =
    [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0, 720.0, 1800.0, 3600.0, 7200.0, 18000.0, 36000.0];

/// Tolerance for a round value at an end of the axis, in steps.
const ROUNDING: f64 = 1e-6;

/// An axis with round values.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Values at its ends.
    pub ends: [f64; 2],
    /// Coordinates of its ends on the sheet, in mm along its direction.
    pub places: [f64; 2],
    /// Round values, in rising order.
    pub ticks: Vec<f64>,
    /// Decimal exponent: numbers are shown in units of ten to this power.
    pub power: i32,
    decimals: usize,
    words: Wording,
}

impl Axis {
    /// The axis from `ends[0]` at `places[0]` to `ends[1]` at `places[1]`, with round values at least `apart` mm from
    /// each other.
    pub fn new(words: Wording, ends: [f64; 2], places: [f64; 2], apart: f64, degrees: bool) -> Axis {
        let width = ends[1] - ends[0];
        let least = width * apart / (places[1] - places[0]).abs();
        let of_degrees = DEGREES.into_iter().find(|step| *step >= least);
        let step = match of_degrees {
            Some(step) if degrees && least > 0.5 => step,
            _ => next_of(&[1.0, 2.0, 5.0], least),
        };
        let largest = ends[0].abs().max(ends[1].abs());
        let decade = libm::floor(libm::log10(largest)) as i32;
        let power = if degrees || (-2..5).contains(&decade) { 0 } else { 3 * decade.div_euclid(3) };
        // Rounding of the step must not change the number of decimals.
        let step_decade = libm::floor(libm::log10(step) + 1e-9) as i32 - power;
        let first = (ends[0] / step - ROUNDING).ceil();
        let last = (ends[1] / step + ROUNDING).floor();
        let count = (last - first) as usize;
        Axis {
            ends,
            places,
            ticks: (0..=count).map(|k| (first + k as f64) * step).collect(),
            power,
            decimals: usize::try_from(-step_decade).unwrap_or(0),
            words,
        }
    }

    /// The coordinate of a value, in mm.
    pub fn at(&self, value: f64) -> f64 {
        let share = (value - self.ends[0]) / (self.ends[1] - self.ends[0]);
        self.places[0] + share * (self.places[1] - self.places[0])
    }

    /// The round values as written beside the axis, with their coordinates in mm.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (f64, RichText)> {
        self.ticks.iter().map(|tick| (self.at(*tick), RichText::plain(&self.tick(*tick))))
    }

    /// A round value as written beside the axis.
    pub fn tick(&self, value: f64) -> String {
        let shown = value / libm::exp10(f64::from(self.power));
        self.words.write(shown + 0.0, NumberStyle::decimals(self.decimals).on(Medium::Figure))
    }

    /// A value as written beside its curve, in the axis's unit, with four digits.
    pub fn value(&self, value: f64) -> String {
        let shown = value / libm::exp10(f64::from(self.power));
        self.words.write(shown, significant(4))
    }
}

/// Number style of so many digits, without trailing zeros.
pub(super) const fn significant(digits: usize) -> NumberStyle {
    NumberStyle::significant(digits).trimmed().on(Medium::Figure)
}
