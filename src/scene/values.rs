//! The layer of values of a figure.

use super::units::LengthUnit;
use super::value::several_forms;
use super::words::shortened;
use super::write::write_forms;
use serde::de::{Error, Visitor};
use std::fmt;

/// Whether a figure shows the values of its vectors, of the links' rates and of given lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValuesShown {
    /// No values.
    Hidden,
    /// All values; those of velocities and accelerations with this unit of length, without one with the scene's.
    Shown(Option<LengthUnit>),
}

write_forms! { ValuesShown {
    ValuesShown::Hidden => &false,
    ValuesShown::Shown(None) => &true,
    ValuesShown::Shown(Some(unit)) => unit.as_str(),
} }

several_forms!(ValuesShown, "values", Shown, _generator => {
    "description": "Whether values stand at vectors and links; a unit of length: in this unit, as \"m\" for m/s",
    "anyOf": [{ "type": "boolean" }, { "enum": LengthUnit::ALL.map(LengthUnit::as_str) }]
});

/// Reads [`ValuesShown`].
struct Shown;

impl Visitor<'_> for Shown {
    type Value = ValuesShown;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("true, false or a unit of length")
    }

    fn visit_bool<E: Error>(self, shown: bool) -> Result<ValuesShown, E> {
        Ok(if shown { ValuesShown::Shown(None) } else { ValuesShown::Hidden })
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<ValuesShown, E> {
        let unit = LengthUnit::ALL.into_iter().find(|unit| unit.as_str() == name);
        unit.map(|unit| ValuesShown::Shown(Some(unit)))
            .ok_or_else(|| E::custom(format!("there is no unit of length \"{}\"", shortened(name))))
    }
}
