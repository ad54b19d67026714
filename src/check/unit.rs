//! Units as people write them beside values.

use super::sheet::CheckError;
use crate::quantity::QuantityKind;
use crate::scene::{LengthUnit, TimeUnit, Units};
use crate::text::shown;

/// The factor from the unit `text` to the scene's unit of quantities of this kind.
pub(super) fn factor(text: &str, kind: QuantityKind, units: Units) -> Result<f64, CheckError> {
    let compact: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let compact = compact.replace("^2", "²").replace("**2", "²");
    let known = || {
        CheckError::new(
            format!("`{}` is no unit of {}", shown(text), said(kind)),
            format!("write `{}`, or leave the unit out", kind.unit(units)),
        )
    };
    let (top, below) = match compact.split_once('/') {
        Some((top, below)) => (top, Some(below)),
        None => (compact.as_str(), None),
    };
    let length = || LENGTHS.iter().find(|l| l.0 == top).map(|l| l.1);
    let to_length = |meters: f64| meters / meters_of(units.length);
    let time = |symbol: &str| TIMES.iter().find(|t| t.0 == symbol).map(|t| t.1);
    let own_time = seconds_of(units.time);
    let turn = || match top {
        "rad" | "1" => Some(1.0),
        "deg" | "°" => Some(1.0_f64.to_radians()),
        "rev" => Some(core::f64::consts::TAU),
        _ => None,
    };
    let found = match (kind, below) {
        (QuantityKind::Angle, None) => match top {
            "°" | "deg" => Some(1.0),
            "rad" => Some(1.0_f64.to_degrees()),
            _ => None,
        },
        (QuantityKind::Length | QuantityKind::Position, None) => length().map(to_length),
        (QuantityKind::Velocity, Some(t)) => length().zip(time(t)).map(|(l, t)| to_length(l) * own_time / t),
        (QuantityKind::Acceleration, Some(t)) => {
            t.strip_suffix('²').and_then(time).zip(length()).map(|(t, l)| to_length(l) * own_time * own_time / (t * t))
        }
        (QuantityKind::AngularVelocity, None) if ["rpm", "r.p.m."].contains(&top) => {
            Some(core::f64::consts::TAU * own_time / 60.0)
        }
        (QuantityKind::AngularVelocity, Some(t)) => turn().zip(time(t)).map(|(a, t)| a * own_time / t),
        (QuantityKind::AngularAcceleration, Some(t)) => {
            t.strip_suffix('²').and_then(time).zip(turn()).map(|(t, a)| a * own_time * own_time / (t * t))
        }
        _ => None,
    };
    found.ok_or_else(known)
}

/// Units of length, in metres.
const LENGTHS: [(&str, f64); 5] = [("m", 1.0), ("mm", 1e-3), ("cm", 1e-2), ("in", 0.0254), ("ft", 0.3048)];

/// Units of time, in seconds.
const TIMES: [(&str, f64); 2] = [("s", 1.0), ("min", 60.0)];

fn meters_of(unit: LengthUnit) -> f64 {
    LENGTHS.iter().find(|l| l.0 == unit.as_str()).map_or(1.0, |l| l.1)
}

fn seconds_of(unit: TimeUnit) -> f64 {
    TIMES.iter().find(|t| t.0 == unit.as_str()).map_or(1.0, |t| t.1)
}

fn said(kind: QuantityKind) -> &'static str {
    match kind {
        QuantityKind::Angle => "an angle",
        QuantityKind::AngularVelocity => "an angular velocity",
        QuantityKind::AngularAcceleration => "an angular acceleration",
        QuantityKind::Position => "a position",
        QuantityKind::Length => "a length",
        QuantityKind::Velocity => "a velocity",
        QuantityKind::Acceleration => "an acceleration",
    }
}
