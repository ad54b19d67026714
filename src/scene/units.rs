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

/// The dimension of a quantity: the exponents of length, mass, time and angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    length: i8,
    mass: i8,
    time: i8,
    angle: i8,
}

impl Dimension {
    const NONE: Dimension = Dimension { length: 0, mass: 0, time: 0, angle: 0 };
    /// Of lengths.
    pub const LENGTH: Dimension = Dimension { length: 1, ..Dimension::NONE };
    /// Of angles, in radians.
    pub const ANGLE: Dimension = Dimension { angle: 1, ..Dimension::NONE };
    /// Of masses; no scene has one yet.
    pub const MASS: Dimension = Dimension { mass: 1, ..Dimension::NONE };
    /// Of forces; no scene has one yet.
    pub const FORCE: Dimension = Dimension { mass: 1, length: 1, time: -2, angle: 0 };

    /// The dimension of the first or second derivative by time.
    #[must_use]
    pub fn per_time(self, times: i8) -> Dimension {
        Dimension { time: self.time - times, ..self }
    }

    /// Whether it is a rate.
    #[must_use]
    pub fn is_per_time(self) -> bool {
        self.time < 0
    }

    /// The name of its unit, as `mm/s²`. Masses are in kilograms, so that the force of a scene in metres and seconds is
    /// in newtons, `N`, and that of other scenes as `kg mm/s²`.
    #[must_use]
    pub fn unit(self, units: Units) -> String {
        if self == Dimension::FORCE && (units.length, units.time) == (LengthUnit::M, TimeUnit::S) {
            return "N".to_owned();
        }
        let parts = [
            ("kg", self.mass),
            (units.length.as_str(), self.length),
            ("rad", self.angle),
            (units.time.as_str(), self.time),
        ];
        let power = |name: &str, exponent: i8| match exponent {
            1 => name.to_owned(),
            2 => format!("{name}²"),
            3 => format!("{name}³"),
            _ => format!("{name}^{exponent}"),
        };
        let written = |sign: i8| -> Vec<String> {
            let own = parts.iter().filter(|(_, exponent)| exponent * sign > 0);
            own.map(|(name, exponent)| power(name, exponent.abs())).collect()
        };
        let (above, below) = (written(1), written(-1));
        let above = if above.is_empty() { "1".to_owned() } else { above.join(" ") };
        if below.is_empty() { above } else { format!("{above}/{}", below.join(" ")) }
    }
}

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
