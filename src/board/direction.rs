//! A direction as a drawing writes it.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A direction on a sheet. What gives it is two points, as "B,C", a link with two points, as "2", the guide of a slider, as "3/2", or
/// a line that is drawn.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(untagged, inline))]
pub enum Direction {
    /// Along what is named.
    Parallel {
        /// What gives the direction.
        parallel: String,
    },
    /// A quarter turn counter-clockwise from what is named.
    Normal {
        /// What gives the direction.
        normal: String,
    },
    /// Along a line, turned by the angle from one direction to another.
    Turned {
        /// From the first to the second.
        turned: [String; 2],
        /// The line that is turned.
        base: String,
    },
    /// Degrees from +x.
    Angle {
        /// Counter-clockwise.
        angle: f64,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = r#"a direction as { "parallel": "3" }"#)]
struct DirectionKeys {
    parallel: Option<String>,
    normal: Option<String>,
    turned: Option<[String; 2]>,
    base: Option<String>,
    angle: Option<f64>,
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Direction, D::Error> {
        let keys = DirectionKeys::deserialize(deserializer)?;
        match keys {
            DirectionKeys { parallel: Some(parallel), normal: None, turned: None, base: None, angle: None } => {
                Ok(Direction::Parallel { parallel })
            }
            DirectionKeys { parallel: None, normal: Some(normal), turned: None, base: None, angle: None } => {
                Ok(Direction::Normal { normal })
            }
            DirectionKeys { parallel: None, normal: None, turned: Some(turned), base: Some(base), angle: None } => {
                Ok(Direction::Turned { turned, base })
            }
            DirectionKeys { parallel: None, normal: None, turned: None, base: None, angle: Some(angle) } => {
                Ok(Direction::Angle { angle })
            }
            _ => Err(D::Error::custom(
                r#"a direction is one of { "parallel": "2" }, { "normal": "B,C" }, { "turned": ["B,C", "B,D"], "base": "b,c" }, { "angle": 30 }"#,
            )),
        }
    }
}

impl Serialize for Direction {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let keys = match self {
            Direction::Parallel { parallel } => serde_json::json!({ "parallel": parallel }),
            Direction::Normal { normal } => serde_json::json!({ "normal": normal }),
            Direction::Turned { turned, base } => serde_json::json!({ "turned": turned, "base": base }),
            Direction::Angle { angle } => serde_json::json!({ "angle": angle }),
        };
        keys.serialize(serializer)
    }
}
