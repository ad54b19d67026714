//! Given motions of points and links, in the fixed frame.

use schemars::JsonSchema;
use serde::Deserialize;

use super::schema::without_defaults;
use super::value::{At, Vector, vector};
use super::write::write_keys;

/// Known motion of a point.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a motion as { "velocity": [x, y], "acceleration": [x, y] }"#)]
#[schemars(rename = "pointMotion", transform = without_defaults)]
pub struct PointMotion {
    /// Velocity, in length per time.
    #[serde(deserialize_with = "vector")]
    #[schemars(with = "Vector")]
    pub velocity: [f64; 2],
    /// Acceleration, in length per time squared; left out: zero.
    #[serde(default, deserialize_with = "vector")]
    #[schemars(with = "Option<Vector>")]
    pub acceleration: [f64; 2],
}

write_keys!(PointMotion { velocity, acceleration });

/// Known motion of a link.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a motion as { "at": "B", "velocity": [x, y], "omega": 1 }"#)]
#[schemars(rename = "linkMotion", transform = without_defaults)]
pub struct LinkMotion {
    /// The point or the place where the link has the velocity and the acceleration given here.
    pub at: At,
    /// Velocity there, in length per time.
    #[serde(deserialize_with = "vector")]
    #[schemars(with = "Vector")]
    pub velocity: [f64; 2],
    /// Acceleration there, in length per time squared; left out: zero.
    #[serde(default, deserialize_with = "vector")]
    #[schemars(with = "Option<Vector>")]
    pub acceleration: [f64; 2],
    /// Angular velocity, in radians per unit of time; left out: zero.
    #[serde(default)]
    pub omega: f64,
    /// Angular acceleration, in radians per unit of time squared; left out: zero.
    #[serde(default)]
    pub alpha: f64,
}

write_keys!(LinkMotion { at, velocity, acceleration, omega, alpha });
