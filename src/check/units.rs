//! Units as people write them beside a value: products and quotients of units with exponents, in all usual spellings. Every unit that Kinegon
//! prints is one of them, as a value's factor is the quotient of two units read in the same way.

use super::measured::CheckError;
use super::says;
use crate::message::Message;
use crate::scene::{ForceUnit, LengthUnit, TimeUnit, Units};
use crate::sheet::QuantityKind;
use crate::text::shown;
use core::f64::consts::TAU;

/// A unit's size in SI units, and its powers of length, time, force and angle.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Size {
    si: f64,
    powers: [i32; 4],
}

const NONE: Size = Size { si: 1.0, powers: [0; 4] };

const MINUTE: Size = Size { si: 60.0, powers: [0, 1, 0, 0] };

/// Units that no scene has, beside those that scenes have.
const FURTHER: [(&str, f64, [i32; 4]); 21] = [
    ("inch", 0.0254, [1, 0, 0, 0]),
    ("km", 1000.0, [1, 0, 0, 0]),
    ("dm", 0.1, [1, 0, 0, 0]),
    ("sec", 1.0, [0, 1, 0, 0]),
    ("h", 3600.0, [0, 1, 0, 0]),
    ("daN", 10.0, [0, 0, 1, 0]),
    ("MN", 1e6, [0, 0, 1, 0]),
    ("kp", 9.80665, [0, 0, 1, 0]),
    ("J", 1.0, [1, 0, 1, 0]),
    ("W", 1.0, [1, -1, 1, 0]),
    ("kW", 1000.0, [1, -1, 1, 0]),
    ("mW", 0.001, [1, -1, 1, 0]),
    // 550 foot-pounds a second.
    ("hp", 745.699_871_582_270_2, [1, -1, 1, 0]),
    ("rad", 1.0, [0, 0, 0, 1]),
    ("deg", TAU / 360.0, [0, 0, 0, 1]),
    ("°", TAU / 360.0, [0, 0, 0, 1]),
    ("rev", TAU, [0, 0, 0, 1]),
    ("r", TAU, [0, 0, 0, 1]),
    ("U", TAU, [0, 0, 0, 1]),
    ("rpm", TAU / 60.0, [0, -1, 0, 1]),
    ("1", 1.0, [0; 4]),
];

/// The unit of a symbol.
fn symbol(text: &str) -> Option<Size> {
    let of = |si: f64, powers: [i32; 4]| Some(Size { si, powers });
    if let Some(unit) = LengthUnit::ALL.into_iter().find(|unit| unit.as_str() == text) {
        return of(unit.metres(), [1, 0, 0, 0]);
    }
    if let Some(unit) = TimeUnit::ALL.into_iter().find(|unit| unit.as_str() == text) {
        return of(60.0 / unit.in_a_minute(), [0, 1, 0, 0]);
    }
    if let Some(unit) = ForceUnit::ALL.into_iter().find(|unit| unit.as_str() == text) {
        return of(unit.newtons(), [0, 0, 1, 0]);
    }
    let (_, si, powers) = FURTHER.into_iter().find(|(own, ..)| *own == text)?;
    of(si, powers)
}

impl Size {
    fn times(self, other: Size, power: i32) -> Size {
        let powers = core::array::from_fn(|k| self.powers[k] + power * other.powers[k]);
        let factor = (0..power.abs()).fold(1.0, |product, _| product * other.si);
        Size { si: if power < 0 { self.si / factor } else { self.si * factor }, powers }
    }

    /// The unit of a text; `None` for what is none.
    fn read(text: &str) -> Option<Size> {
        let text = text.replace("r.p.m.", "rpm").replace("**", "^").replace('º', "°");
        let mut size = NONE;
        for (index, factors) in text.split('/').enumerate() {
            let sign = if index == 0 { 1 } else { -1 };
            let separated: Vec<char> = factors.chars().collect();
            let is_dash =
                |at: usize| separated[at] == '-' && separated.get(at + 1).is_some_and(|next| next.is_alphabetic());
            let is_between = |at: usize| "·⋅*×.()".contains(separated[at]) || is_dash(at);
            let spaced: String =
                (0..separated.len()).map(|at| if is_between(at) { ' ' } else { separated[at] }).collect();
            let words: Vec<&str> = spaced.split_whitespace().collect();
            if words.is_empty() {
                return None;
            }
            for word in words {
                let (name, power) = with_power(word)?;
                // The exponent of `Nm²` is that of its last unit.
                let mut parts = parts(name)?;
                let last = parts.pop()?;
                size = parts.into_iter().fold(size, |size, part| size.times(part, sign));
                size = size.times(last, sign * power);
            }
        }
        Some(size)
    }
}

/// A word without its exponent, and that.
fn with_power(word: &str) -> Option<(&str, i32)> {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let digit = |c: char| c.to_digit(10).or_else(|| RAISED.chars().position(|own| own == c).map(|at| at as u32));
    if word == "1" {
        return Some((word, 1));
    }
    let name = word.trim_end_matches(|c: char| digit(c).is_some() || "^-−⁻".contains(c));
    let exponent = word[name.len()..].trim_start_matches('^');
    let (is_negative, digits) = match exponent.strip_prefix(['-', '−', '⁻']) {
        Some(digits) => (true, digits),
        None => (false, exponent),
    };
    if word.len() == name.len() {
        return Some((name, 1));
    }
    let mut digits = digits.chars();
    let power = i32::try_from(digit(digits.next()?)?).ok()?;
    digits.next().is_none().then_some((name, if is_negative { -power } else { power }))
}

/// The units that stand in a word without anything between them, as in `Nmm`: as few as can be.
fn parts(word: &str) -> Option<Vec<Size>> {
    if let Some(whole) = symbol(word) {
        return Some(vec![whole]);
    }
    let ends = word.char_indices().map(|(at, _)| at).skip(1).take(LONGEST);
    let split = |end: usize| {
        let mut all = vec![symbol(&word[..end])?];
        all.extend(parts(&word[end..])?);
        Some(all)
    };
    ends.filter_map(split).min_by_key(Vec::len)
}

/// Most letters of a unit's symbol.
const LONGEST: usize = 4;

/// Most letters of a unit as somebody writes it.
const MOST: usize = 24;

/// The factor from the unit `text` to the scene's unit of quantities of this kind.
pub(super) fn factor(text: &str, kind: QuantityKind, units: Units) -> Result<f64, CheckError> {
    let own_unit = kind.unit(units);
    let own = Size::read(if own_unit.is_empty() { "1" } else { &own_unit });
    let given = (text.chars().count() <= MOST).then(|| Size::read(text)).flatten();
    let found = given.zip(own).and_then(|(given, own)| {
        if given.powers == own.powers {
            return Some(given.si / own.si);
        }
        // A rate without a unit of angle: of turns where these are counted, as machines have them in a minute, else of radians.
        let is_of_machines = given == NONE.times(MINUTE, -1) && units.time != TimeUnit::Min;
        let turn = match kind {
            QuantityKind::AngularVelocity if is_of_machines => TAU,
            QuantityKind::AngularVelocity | QuantityKind::AngularAcceleration => 1.0,
            QuantityKind::RotationalSpeed => TAU,
            _ => return None,
        };
        let with_turn = given.times(Size { si: turn, powers: [0, 0, 0, 1] }, 1);
        (with_turn.powers == own.powers).then_some(with_turn.si / own.si)
    });
    // A scene may have no unit of force, and forces all the same.
    let is_own = || text.split_whitespace().eq(own_unit.split_whitespace());
    found
        .or_else(|| is_own().then_some(1.0))
        .ok_or_else(|| CheckError::new(says::no_unit_of(shown(text), said(kind)), says::write_unit(own_unit.clone())))
}

fn said(kind: QuantityKind) -> Message {
    match kind {
        QuantityKind::Angle => says::angle(),
        QuantityKind::AngularVelocity => says::angular_velocity(),
        QuantityKind::RotationalSpeed => says::rotational_speed(),
        QuantityKind::SpeedRatio => says::speed_ratio(),
        QuantityKind::AngularAcceleration => says::angular_acceleration(),
        QuantityKind::Position => says::position(),
        QuantityKind::Length => says::length(),
        QuantityKind::Velocity => says::velocity(),
        QuantityKind::Acceleration => says::acceleration(),
        QuantityKind::Force => says::force(),
        QuantityKind::Moment => says::moment(),
        QuantityKind::Power => says::power(),
    }
}
