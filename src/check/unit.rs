//! Units as people write them beside values.

use super::error::CheckError;
use super::sheet::Given;
use crate::quantity::QuantityKind;
use crate::scene::{LengthUnit, TimeUnit, Units};
use crate::sheet::Sheet;
use crate::text::shown;

/// The factor from a written number to the scene's units, and the factor if the unit beside it were left out. `paper`: the
/// sheet on which it was measured in millimetres, if it was, with the scale that the form has for it.
pub(super) fn factors(
    given: &Given,
    name: &str,
    kind: QuantityKind,
    paper: Option<(Sheet, Option<f64>)>,
    units: Units,
) -> Result<(f64, f64), CheckError> {
    let Some((sheet, scale)) = paper else {
        let factor = given.unit.as_ref().map_or(Ok(1.0), |unit| factor(unit, kind, units))?;
        return Ok((factor, 1.0));
    };
    let scale = scale.ok_or_else(|| {
        let mu = sheet.scale_key();
        let hint = format!("add {mu}: how many {} are 1 mm of your {}", kind.unit(units), sheet.name());
        CheckError::about(name, &format!("is in millimetres of paper, but your scale {mu} is missing"), hint)
    })?;
    match &given.unit {
        // Beside millimetres of paper no unit may stand but mm.
        Some(unit) if unit.trim() != "mm" => {
            let says = format!("is in millimetres of paper, but `{}` stands beside it", shown(unit));
            Err(CheckError::about(name, &says, "leave the unit out, or the `/mu`"))
        }
        _ => Ok((scale, scale)),
    }
}

/// The factor from the unit `text` to the scene's unit of quantities of this kind.
fn factor(text: &str, kind: QuantityKind, units: Units) -> Result<f64, CheckError> {
    let compact: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let compact = compact.replace("^2", "²").replace("**2", "²");
    let known = || {
        let hint = format!("write `{}`, or leave the unit out", kind.unit(units));
        CheckError::about(text, &format!("is no unit of {}", said(kind)), hint)
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
