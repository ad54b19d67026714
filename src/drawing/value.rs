//! A value to be written at a vector, a link or a length.

use super::text::RichText;
use crate::construction::{PlanVector, VectorPart};
use crate::mechanism::{BodyId, PointId};
use crate::quantity::QuantityKind;
use crate::sheet::Sheet;
#[derive(Clone, Debug)]
pub(super) struct Value {
    /// Where its label belongs.
    pub panel: Sheet,
    /// Its label's id without the panel.
    pub name: String,
    /// Its symbol in markup; several with signs of equality where they have the same value.
    pub symbol: String,
    pub number: f64,
    pub kind: QuantityKind,
    /// The number as written.
    pub written: String,
    /// Its unit.
    pub unit: String,
    /// The step that finds it.
    pub since: u16,
    pub of: ValueOf,
}

/// What a value belongs to.
#[derive(Clone, Debug)]
pub(super) enum ValueOf {
    /// A vector of the panel's plan.
    Vector(PlanVector),
    /// The angular velocity or acceleration of a link.
    Rate(BodyId),
    /// A given length of a link.
    Length([PointId; 2]),
}

impl Value {
    pub(super) fn text(&self) -> RichText {
        RichText::math(&self.symbol).followed_by(&self.equals())
    }

    /// Whether it is a result that is listed; relative motions of two points of a link and given lengths are not.
    pub(super) fn is_listed(&self) -> bool {
        match &self.of {
            ValueOf::Rate(_) => true,
            ValueOf::Vector(vector) => {
                matches!(vector.part, VectorPart::Whole | VectorPart::Sliding | VectorPart::Coriolis)
            }
            ValueOf::Length(_) => false,
        }
    }

    fn equals(&self) -> RichText {
        RichText::plain(format!("= {} {}", self.written, self.unit).trim_end())
    }
}
