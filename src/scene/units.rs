//! The units of a scene: labels that are printed and never converted.

use schemars::JsonSchema;
use serde::Deserialize;

use super::choice::choice;
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

choice! {
    /// A unit of time.
    TimeUnit {
        /// second
        S = "s",
        /// minute
        Min = "min",
    }
}
