//! The units of a scene: labels that are printed, never converted.

use schemars::JsonSchema;
use serde::Deserialize;

/// The units of a scene. Nothing is converted between them; they are printed beside the numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Units {
    /// Unit of every length.
    pub length: LengthUnit,
    /// Unit of every time.
    pub time: TimeUnit,
}

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LengthUnit {
    /// metre
    M,
    /// millimetre
    Mm,
    /// centimetre
    Cm,
    /// inch
    In,
    /// foot
    Ft,
}

/// A unit of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum TimeUnit {
    /// second
    S,
    /// minute
    Min,
}

impl LengthUnit {
    /// The unit's symbol, as in the scene file: `"mm"`.
    pub fn as_str(self) -> &'static str {
        match self {
            LengthUnit::M => "m",
            LengthUnit::Mm => "mm",
            LengthUnit::Cm => "cm",
            LengthUnit::In => "in",
            LengthUnit::Ft => "ft",
        }
    }
}

impl TimeUnit {
    /// The unit's symbol, as in the scene file: `"s"`.
    pub fn as_str(self) -> &'static str {
        match self {
            TimeUnit::S => "s",
            TimeUnit::Min => "min",
        }
    }
}
