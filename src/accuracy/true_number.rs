//! Quantities that are one number, as enclosures that can be compared with each other.

use super::bounds::Bounds;
use super::given::Vector;
use super::quantities::TrueValue;
use crate::construction::Rate;
use crate::geometry::{Ball, DEGREES_PER_RADIAN, Number};
use crate::quantity::{Component, QuantityRequest, What};

/// The true value of a quantity that is one number: of a vector its size.
#[derive(Clone, Copy, Debug)]
pub(crate) enum TrueNumber {
    /// A number.
    Number(Ball),
    /// An angle, as a vector in its direction.
    Angle(Vector),
}

impl TrueNumber {
    /// By how much it is greater than another; of angles, which must be less than a quarter turn apart, the tangent of that, in degrees per radian.
    pub fn minus(self, other: TrueNumber) -> Ball {
        match (self, other) {
            (TrueNumber::Number(a), TrueNumber::Number(b)) => a - b,
            (TrueNumber::Angle(a), TrueNumber::Angle(b)) => b.cross(a) / b.dot(a) * DEGREES_PER_RADIAN,
            _ => Ball::default().widened(f64::INFINITY),
        }
    }

    /// Bound of its distance from `value`, of an angle in degrees.
    pub fn error_from(self, value: f64) -> f64 {
        let error = match self {
            TrueNumber::Number(number) => number.error_from(value),
            TrueNumber::Angle(along) => along.degrees_from(value),
        };
        if error.is_nan() { f64::INFINITY } else { error }
    }
}

impl Bounds<'_> {
    /// The true value of a quantity that is one number; `None` where nothing bounds it.
    pub(crate) fn true_number(&self, asked: &QuantityRequest) -> Option<TrueNumber> {
        let e = self.enclosure.as_ref()?;
        let number = match &asked.what {
            What::Rate(Rate::Angular(order, link)) => e.angular_rates(*link)[*order],
            What::Rate(Rate::Slide(order, slider)) => e.slide_rates(*slider)[*order],
            What::SlidePosition(slider) => e.placed.slides[slider.0]?,
            What::Angle(link) => return Some(TrueNumber::Angle(e.placed.turns[link.0]?)),
            _ => match (self.true_value(e, asked)?, asked.written.component) {
                (TrueValue::Vector(v), Some(Component::Angle)) => return Some(TrueNumber::Angle(v)),
                (TrueValue::Vector(v), Some(Component::X)) => v.x,
                (TrueValue::Vector(v), Some(Component::Y)) => v.y,
                (TrueValue::Vector(v), _) => v.dot(v).sqrt(),
                (TrueValue::Number(number), _) => number,
            },
        };
        number.is_known().then_some(TrueNumber::Number(number))
    }
}
