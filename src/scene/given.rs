//! What a scene gives: its places by lengths or by a drawing, and motions by drives or as they are known.

use super::error::Wrong;
use super::says;
use super::units::TimeUnit;
use super::value::{At, vector};
use super::write::write_keys;
use serde::Deserialize;
use std::f64::consts::{PI, TAU};

/// How a scene gives the places of its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum GivenBy {
    /// By ground points, lengths or shapes, and angles of drives: positions have to be found.
    #[default]
    Lengths,
    /// By the coordinates of every point, as drawn.
    Drawing,
}

/// A drive: it turns the link (angle, omega or rpm, alpha), or pushes a sliding link (position, speed, acceleration).
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "linkDrive"))]
#[serde(deny_unknown_fields, expecting = r#"a drive as { "angle": 70, "omega": -1 }"#)]
pub(super) struct LinkDriveFile {
    /// Angle of the link's axis from +x, in degrees.
    pub angle: Option<f64>,
    /// Angular velocity, in radians per unit of time.
    pub omega: Option<f64>,
    /// Speed of rotation in turns per minute, in place of omega.
    pub rpm: Option<f64>,
    /// Angular acceleration, in radians per unit of time squared; left out: zero.
    pub alpha: Option<f64>,
    /// Of a sliding link: distance along its guide from the guide's `through`.
    pub position: Option<f64>,
    /// Of a sliding link: speed along its guide.
    pub speed: Option<f64>,
    /// Of a sliding link: acceleration along its guide; left out: zero.
    pub acceleration: Option<f64>,
}

write_keys!(LinkDriveFile { omega, rpm, angle, alpha, position, speed, acceleration });

/// A drive that turns a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// Angle of the link's axis from +x, in degrees; always `None` in the drawn form.
    pub angle_deg: Option<f64>,
    /// Angular velocity, in radians per unit of time, counter-clockwise positive.
    pub omega: f64,
    /// Turns per minute, where the scene gives these in place of `omega`, which is then rounded.
    pub rpm: Option<f64>,
    /// Angular acceleration, in radians per unit of time squared; zero unless given.
    pub alpha: f64,
}

/// A drive that pushes a slider along its guide.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "sliderDrive", transform = super::schema_made::without_defaults))]
#[serde(deny_unknown_fields, expecting = r#"a drive as { "position": 40, "speed": 10 }"#)]
pub struct SliderDrive {
    /// Distance along the guide from `through`.
    pub position: Option<f64>,
    /// Speed along the guide.
    pub speed: f64,
    /// Acceleration along the guide; left out: zero.
    #[serde(default)]
    pub acceleration: f64,
}

write_keys!(SliderDrive { speed, position, acceleration } unless SliderDrive { position: None, speed: 0.0, acceleration: 0.0 });

impl LinkDriveFile {
    /// Refuses keys of a position in a drawn configuration, which gives it already.
    pub fn check_given_by(&self, given_by: GivenBy, link: &str) -> Result<(), Wrong> {
        match first_given(&[("angle", self.angle.is_some()), ("position", self.position.is_some())]) {
            Some(key) if given_by == GivenBy::Drawing => {
                Err(Wrong::key(&[key], says::drive_is_drawn(link, key)).hint(says::remove_drawn(key)))
            }
            _ => Ok(()),
        }
    }

    /// The checked drive, which turns its link `link` or pushes it along a guide.
    pub fn read(&self, time: TimeUnit, link: &str) -> Result<(Option<Drive>, Option<SliderDrive>), Wrong> {
        let pushes = self.position.is_some() || self.speed.is_some() || self.acceleration.is_some();
        Ok(if pushes { (None, Some(self.pushing(link)?)) } else { (Some(self.turning(time, link)?), None) })
    }

    fn turning(&self, time: TimeUnit, link: &str) -> Result<Drive, Wrong> {
        let omega = match (self.omega, self.rpm) {
            (Some(omega), None) => omega,
            (None, Some(rpm)) => match time {
                TimeUnit::S => rpm * (PI / 30.0),
                TimeUnit::Min => rpm * TAU,
            },
            (Some(_), Some(_)) => {
                return Err(Wrong::key(&["rpm"], says::omega_and_rpm(link)).hint(says::keep_one()));
            }
            (None, None) => {
                return Err(Wrong::value(&[], says::drive_without_speed(link)).hint(says::add_omega()));
            }
        };
        Ok(Drive { angle_deg: self.angle, omega, rpm: self.rpm, alpha: self.alpha.unwrap_or(0.0) })
    }

    fn pushing(&self, link: &str) -> Result<SliderDrive, Wrong> {
        let turns = [
            ("angle", self.angle.is_some()),
            ("omega", self.omega.is_some()),
            ("rpm", self.rpm.is_some()),
            ("alpha", self.alpha.is_some()),
        ];
        if let Some(key) = first_given(&turns) {
            return Err(Wrong::key(&[key], says::pushes_and_turns(link)).hint(says::push_or_turn()));
        }
        let Some(speed) = self.speed else {
            return Err(Wrong::value(&[], says::push_without_speed(link)).hint(says::add_speed()));
        };
        Ok(SliderDrive { position: self.position, speed, acceleration: self.acceleration.unwrap_or(0.0) })
    }
}

/// The first key that is given.
pub(super) fn first_given<'a>(keys: &[(&'a str, bool)]) -> Option<&'a str> {
    keys.iter().find(|(_, given)| *given).map(|(key, _)| *key)
}

/// Known motion of a point.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "pointMotion", transform = super::schema_made::without_defaults))]
#[serde(deny_unknown_fields, expecting = r#"a motion as { "velocity": [x, y], "acceleration": [x, y] }"#)]
pub struct PointMotion {
    /// Velocity, in length per time.
    #[serde(deserialize_with = "vector")]
    #[cfg_attr(feature = "schemas", schemars(with = "super::value::Vector"))]
    pub velocity: [f64; 2],
    /// Acceleration, in length per time squared; left out: zero.
    #[serde(default, deserialize_with = "vector")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<super::value::Vector>"))]
    pub acceleration: [f64; 2],
}

write_keys!(PointMotion { velocity, acceleration });

/// Known motion of a link.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "linkMotion", transform = super::schema_made::without_defaults))]
#[serde(deny_unknown_fields, expecting = r#"a motion as { "at": "B", "velocity": [x, y], "omega": 1 }"#)]
pub struct LinkMotion {
    /// The point or the place where the link has the velocity and the acceleration given here.
    pub at: At,
    /// Velocity there, in length per time.
    #[serde(deserialize_with = "vector")]
    #[cfg_attr(feature = "schemas", schemars(with = "super::value::Vector"))]
    pub velocity: [f64; 2],
    /// Acceleration there, in length per time squared; left out: zero.
    #[serde(default, deserialize_with = "vector")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<super::value::Vector>"))]
    pub acceleration: [f64; 2],
    /// Angular velocity, in radians per unit of time; left out: zero.
    #[serde(default)]
    pub omega: f64,
    /// Angular acceleration, in radians per unit of time squared; left out: zero.
    #[serde(default)]
    pub alpha: f64,
}

write_keys!(LinkMotion { at, velocity, acceleration, omega, alpha });
