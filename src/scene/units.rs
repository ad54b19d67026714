//! The units of a scene. Numbers of a scene and of results are never converted; a figure may show values in another unit
//! of length.

use schemars::JsonSchema;
use serde::Deserialize;

use super::value::choice;
use super::write::write_keys;

/// Units of every length and time of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"units as { "length": "mm", "time": "s" }"#)]
#[schemars(rename = "units")]
pub struct Units {
    /// Unit of length.
    pub length: LengthUnit,
    /// Unit of time.
    pub time: TimeUnit,
}

write_keys!(Units { length, time });

choice! {
    /// A unit of length.
    LengthUnit {
        /// metre
        M = "m",
        /// millimetre
        Mm = "mm",
        /// centimetre
        Cm = "cm",
        /// inch
        In = "in",
        /// foot
        Ft = "ft",
    }
}

impl LengthUnit {
    /// Its length in metres.
    #[must_use]
    pub fn metres(self) -> f64 {
        match self {
            LengthUnit::M => 1.0,
            LengthUnit::Mm => 1e-3,
            LengthUnit::Cm => 1e-2,
            LengthUnit::In => 0.0254,
            LengthUnit::Ft => 0.3048,
        }
    }
}

choice! {
    /// A unit of time.
    TimeUnit {
        /// second
        S = "s",
        /// minute
        Min = "min",
    }
}
