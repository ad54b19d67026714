//! The units of a scene: the words for them in a scene file, and their sizes. Numbers of a scene and of results are never converted; a
//! figure may show values in another unit of length.

use super::value::choice;
use super::write::write_keys;
use crate::geometry::Ball;
use serde::Deserialize;

/// Units of every length and time of the scene, and of masses and forces where it has some.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "units"))]
#[serde(deny_unknown_fields, expecting = r#"units as { "length": "mm", "time": "s" }"#)]
pub struct Units {
    /// Unit of length.
    pub length: LengthUnit,
    /// Unit of time.
    pub time: TimeUnit,
    /// Unit of mass, where links have masses.
    pub mass: Option<MassUnit>,
    /// Unit of force, where there are masses, forces or springs.
    pub force: Option<ForceUnit>,
}

write_keys!(Units { length, time, mass, force });

impl Units {
    /// Units of length and time alone, of a scene without masses and forces.
    #[must_use]
    pub const fn new(length: LengthUnit, time: TimeUnit) -> Units {
        Units { length, time, mass: None, force: None }
    }
}

impl TimeUnit {
    /// How many of this unit are a minute.
    #[must_use]
    pub const fn in_a_minute(self) -> f64 {
        match self {
            TimeUnit::S => 60.0,
            TimeUnit::Min => 1.0,
        }
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
        self.in_metres().high
    }

    fn in_metres(self) -> Ball {
        Ball::of_decimal(match self {
            LengthUnit::M => "1",
            LengthUnit::Mm => "0.001",
            LengthUnit::Cm => "0.01",
            LengthUnit::In => "0.0254",
            LengthUnit::Ft => "0.3048",
        })
    }
}

choice! {
    /// A unit of time.
    #[derive(Default)]
    TimeUnit {
        /// second
        #[default]
        S = "s",
        /// minute
        Min = "min",
    }
}

choice! {
    /// A unit of mass.
    MassUnit {
        /// kilogram
        Kg = "kg",
        /// gram
        G = "g",
        /// tonne
        T = "t",
        /// pound: 0.45359237 kg
        Lb = "lb",
        /// slug: lbf s²/ft
        Slug = "slug",
        /// blob: lbf s²/in
        Blob = "blob",
    }
}

choice! {
    /// A unit of force.
    ForceUnit {
        /// newton
        N = "N",
        /// kilonewton
        Kn = "kN",
        /// millinewton
        Mn = "mN",
        /// kilogram-force: 9.80665 N
        Kgf = "kgf",
        /// pound-force: 0.45359237 kgf
        Lbf = "lbf",
    }
}

/// Newtons in a kilogram-force: standard gravity in m/s².
const STANDARD_GRAVITY: &str = "9.80665";
/// Kilograms in a pound.
const POUND: &str = "0.45359237";

fn pound_force() -> Ball {
    Ball::of_decimal(POUND) * Ball::of_decimal(STANDARD_GRAVITY)
}

impl MassUnit {
    fn in_kilograms(self) -> Ball {
        match self {
            MassUnit::Kg => Ball::from(1),
            MassUnit::G => Ball::of_decimal("0.001"),
            MassUnit::T => Ball::of_decimal("1000"),
            MassUnit::Lb => Ball::of_decimal(POUND),
            MassUnit::Slug => pound_force() / LengthUnit::Ft.in_metres(),
            MassUnit::Blob => pound_force() / LengthUnit::In.in_metres(),
        }
    }
}

impl ForceUnit {
    /// Its size in newtons.
    #[must_use]
    pub fn newtons(self) -> f64 {
        self.in_newtons().high
    }

    fn in_newtons(self) -> Ball {
        match self {
            ForceUnit::N => Ball::from(1),
            ForceUnit::Kn => Ball::of_decimal("1000"),
            ForceUnit::Mn => Ball::of_decimal("0.001"),
            ForceUnit::Kgf => Ball::of_decimal(STANDARD_GRAVITY),
            ForceUnit::Lbf => pound_force(),
        }
    }
}

impl Units {
    /// The force that one unit of mass needs for one unit of acceleration, in units of force: 0.001 for mm, s, kg and N. All units are
    /// exact decimals of SI units, or quotients of such. One where a unit of mass or force is missing.
    pub(crate) fn force_of_mass_times_acceleration(self) -> Ball {
        let (Some(mass), Some(force)) = (self.mass, self.force) else { return Ball::from(1) };
        let seconds = match self.time {
            TimeUnit::S => Ball::from(1),
            TimeUnit::Min => Ball::from(60),
        };
        // Numerator and denominator first: what stands in both cancels to the last digit.
        mass.in_kilograms() * self.length.in_metres() / (seconds * seconds * force.in_newtons())
    }
}
