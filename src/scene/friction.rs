//! Friction in joints: a coefficient or an angle of a guide, and with the radius of its journal of a pin.

use super::error::{Wrong, number};
use super::joint::On;
use super::name::no_point;
use super::names::Names;
use super::says;
use super::write::write_keys;
use crate::text::shown;
use indexmap::IndexSet;
use serde::Deserialize;

/// Angles of friction are below this one, in degrees: a right angle has no tangent.
const RIGHT_ANGLE: f64 = 90.0;

/// Friction in the joints at a pin or in a guide, in the file.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = r#"friction as { "pin": "B", "coefficient": 0.1, "radius": 12 } or { "guide": "3/ground", "coefficient": 0.1 }"#
)]
#[cfg_attr(feature = "schemas", schemars(rename = "friction"))]
pub(super) struct FrictionFile {
    /// The point of a pin.
    pin: Option<String>,
    /// The name of a slider, as "3/ground" or "P/3".
    guide: Option<String>,
    /// The coefficient of friction.
    coefficient: Option<f64>,
    /// The angle of friction in degrees, in place of the coefficient.
    angle: Option<f64>,
    /// The radius of the pin's journal, in the scene's unit of length; of a pin alone.
    radius: Option<f64>,
    /// The link in which the pin is fixed, or "ground"; of a pin through three or more links, which all turn on it, alone.
    fixed_in: Option<String>,
}

write_keys!(FrictionFile { pin, guide, coefficient, angle, radius, fixed_in });

/// Coulomb friction in a joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Friction {
    /// Where it is.
    pub joint: RubbingJoint,
    /// How much of it there is.
    pub grip: Grip,
}

/// A joint with friction.
#[derive(Debug, Clone, PartialEq)]
pub enum RubbingJoint {
    /// All joints at the pin of this point.
    Pin {
        /// The point.
        point: String,
        /// The radius of the journal, in the scene's unit of length.
        radius: f64,
        /// What the pin is fixed in, where three or more links share it; the others turn on it.
        fixed_in: Option<On>,
    },
    /// The guide of the slider of this name.
    Guide(String),
}

/// How much friction there is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Grip {
    /// The coefficient μ.
    Coefficient(f64),
    /// The angle of friction φ in degrees, with tan φ = μ.
    Angle(f64),
}

impl FrictionFile {
    /// The checked friction; `taken` holds the joints that have some. Whether there is a slider of that name the mechanism tells.
    pub fn read(self, names: &Names<'_>, taken: &mut IndexSet<String>) -> Result<Friction, Wrong> {
        let FrictionFile { pin, guide, coefficient, angle, radius, fixed_in } = self;
        let (key, name) = match (&pin, &guide) {
            (Some(pin), None) => ("pin", pin.clone()),
            (None, Some(guide)) => ("guide", guide.clone()),
            (Some(_), Some(_)) => return Err(Wrong::key(&["guide"], says::pin_and_guide()).hint(says::keep_one())),
            (None, None) => return Err(Wrong::value(&[], says::friction_nowhere()).hint(says::pin_or_guide())),
        };
        let joint = match (pin, guide, radius) {
            (Some(point), _, Some(radius)) => {
                names.point(&["pin"], &point)?;
                let fixed_in = fixed_in.map(|link| holder(names, link, &point)).transpose()?;
                RubbingJoint::Pin { point, radius: at_least_zero("radius", radius)?, fixed_in }
            }
            (Some(point), _, None) => {
                return Err(Wrong::value(&[], says::friction_without_radius(shown(&point))).hint(says::add_radius()));
            }
            (None, _, Some(_)) => {
                return Err(Wrong::key(&["radius"], says::guide_has_no_radius()).hint(says::leave_key_out()));
            }
            (None, ..) if fixed_in.is_some() => {
                return Err(Wrong::key(&["fixed_in"], says::guide_has_no_pin()).hint(says::leave_key_out()));
            }
            (None, guide, None) => RubbingJoint::Guide(guide.unwrap_or_default()),
        };
        if !taken.insert(name.clone()) {
            return Err(Wrong::value(&[key], says::friction_twice(shown(&name))).hint(says::keep_one()));
        }
        let grip = match (coefficient, angle) {
            (Some(_), Some(_)) => {
                return Err(Wrong::key(&["angle"], says::coefficient_and_angle()).hint(says::keep_one()));
            }
            (None, None) => {
                return Err(Wrong::value(&[], says::no_coefficient()).hint(says::add(r#""coefficient": 0.1"#)));
            }
            (Some(coefficient), None) => Grip::Coefficient(at_least_zero("coefficient", coefficient)?),
            (None, Some(angle)) if angle >= RIGHT_ANGLE => {
                return Err(Wrong::value(&["angle"], says::angle_of_friction(angle)).hint(says::below_right_angle()));
            }
            (None, Some(angle)) => Grip::Angle(at_least_zero("angle", angle)?),
        };
        Ok(Friction { joint, grip })
    }
}

/// The frame or the link of this name, which must have the pin.
fn holder(names: &Names<'_>, link: String, pin: &str) -> Result<On, Wrong> {
    if link == "ground" {
        return match names.on_ground(pin) {
            true => Ok(On::Ground),
            false => Err(Wrong::value(&["fixed_in"], no_point(says::the_ground(), pin, names.ground))),
        };
    }
    names.link(&["fixed_in"], &link)?;
    names.point_of_link(&["fixed_in"], &link, pin)?;
    Ok(On::Link(link))
}

/// A number that may be zero but not less.
pub(super) fn at_least_zero(key: &str, value: f64) -> Result<f64, Wrong> {
    if value < 0.0 { Err(Wrong::value(&[key], says::below_zero(key, number(value)))) } else { Ok(value) }
}
