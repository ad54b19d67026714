//! The velocity plan turned by 90°, as some schools draw it: images of links then lie as the links do, and rays are parallel to what they
//! are normal to otherwise. It is turned here alone, as it is shown; the operations and all values stay what they are.

use super::arrow::Relation;
use super::constructed::Construction;
use super::step::Action;
use crate::geometry::{Vector, quarter_turn};
use crate::scene::TurnedName;
use crate::sheet::{Order, Sheet};

impl Construction {
    /// This construction as it is shown with the velocity plan turned: its points, its rays and what these are parallel to.
    pub(super) fn turned(&self, sense: TurnedName) -> Construction {
        let turn = |v: Vector| match sense {
            TurnedName::CounterClockwise => quarter_turn(v),
            TurnedName::Clockwise => -quarter_turn(v),
        };
        let mut shown = Construction { turned: Some(sense), ..self.clone() };
        shown.plans[Order::Velocity].points.values_mut().for_each(|point| point.vector = turn(point.vector));
        for action in &mut shown.steps[Sheet::Velocity] {
            if let Action::Ray(ray) = action {
                ray.direction = turn(ray.direction);
                ray.relation = match ray.relation {
                    Relation::Perpendicular => Relation::Parallel,
                    Relation::Parallel => Relation::Perpendicular,
                    Relation::Angle => Relation::Angle,
                };
            }
        }
        shown
    }
}
