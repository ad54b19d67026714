//! Instant centres in the result file.

use crate::accuracy::Bounds;
use crate::centers::Center;
use crate::quantity::{Head, Quantity, QuantityRequest};
use serde::Serialize;

/// An instant centre: its place, or the direction in which it lies at infinity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(untagged)]
#[non_exhaustive]
pub enum CenterResult {
    /// At a place.
    At {
        /// Its coordinates.
        position: [f64; 2],
        /// Bound of the error of each.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        error: f64,
    },
    /// At infinity, as far as it is certain.
    AtInfinity {
        /// The direction in which it lies, of length 1.
        at_infinity: [f64; 2],
        /// Bound of the error of that direction, in degrees.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        angle_error: f64,
        /// How far away it is at least, where it is not at infinity in every position: bounds of rates can tell no more.
        #[serde(skip_serializing_if = "Option::is_none")]
        farther_than: Option<f64>,
    },
}

impl CenterResult {
    /// The result for a whole centre that is asked for; `None` for other quantities. Where no bound can be proved it is the place without one.
    pub(super) fn of(asked: &QuantityRequest, bounds: &Bounds<'_>) -> Option<Option<CenterResult>> {
        if asked.written.head != Head::Center || !asked.written.is_plain() {
            return None;
        }
        let found = match bounds.center(asked) {
            Some(Center::At { place, error }) => Some(CenterResult::At { position: place.into(), error }),
            Some(Center::AtInfinity { direction, error, beyond }) => Some(CenterResult::AtInfinity {
                at_infinity: direction.into(),
                angle_error: error,
                farther_than: beyond.is_finite().then_some(beyond),
            }),
            Some(_) => None,
            None => match bounds.valued(asked, None) {
                Ok((Quantity::Vector(place), error)) => Some(CenterResult::At { position: place.into(), error }),
                _ => None,
            },
        };
        Some(found)
    }
}
