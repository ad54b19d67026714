//! Numbers with few digits.

use crate::geometry::{Point, span};
use serde_json::{Number, Value as Json};

/// A number of decimals: −1 for tens.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Decimals(pub i32);

impl Decimals {
    /// Of angles in degrees that follow from places.
    pub const ANGLE: Decimals = Decimals(2);

    /// Of places on a mechanism of that size, in its unit of length: steps of a thousandth of the size, or finer by less
    /// than ten times.
    pub fn of_size(size: f64) -> Decimals {
        let is_sound = size > 0.0 && size.is_finite();
        Decimals(if is_sound { -libm::floor(libm::log10(size) - 3.0) as i32 } else { 1 })
    }

    /// Of places in a mechanism with these points.
    pub fn of_points(points: impl IntoIterator<Item = Point>) -> Decimals {
        Decimals::of_size(span(points))
    }

    /// So many decimals more.
    pub fn finer(self, by: i32) -> Decimals {
        Decimals(self.0 + by)
    }

    /// The distance of two neighbouring numbers.
    pub fn step(self) -> f64 {
        libm::exp10(f64::from(-self.0))
    }

    /// The nearest number with so many decimals, as reading its digits gives it.
    pub fn round(self, x: f64) -> f64 {
        let steps = libm::round(x / self.step());
        // Beyond that a number has no more digits than it has.
        if !steps.is_finite() || steps.abs() > 1e15 {
            return x;
        }
        format!("{steps}e{}", -self.0).parse().unwrap_or(x) + 0.0
    }

    /// The rounded number as JSON.
    pub fn json(self, x: f64) -> Json {
        json(self.round(x))
    }

    /// A rounded place.
    pub fn place(self, place: Point) -> Point {
        Point::new(self.round(place.x), self.round(place.y))
    }

    /// A rounded place as JSON.
    pub fn place_json(self, place: Point) -> Json {
        Json::Array(vec![self.json(place.x), self.json(place.y)])
    }
}

/// A number as JSON, a whole one without decimals.
pub(super) fn json(x: f64) -> Json {
    match x == libm::trunc(x) && x.abs() < 1e15 {
        true => Json::from(x as i64),
        false => Number::from_f64(x).map_or(Json::Null, Json::Number),
    }
}
