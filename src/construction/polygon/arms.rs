//! The arms that moments need, by the names of quantities.

use super::named::line_name;
use super::{ForceArm, ForceOf, ForcePlan, Moment, MomentPoint};
use crate::construction::constructed::Construction;
use crate::construction::number::NumberId;
use crate::construction::operation::StepId;
use crate::mechanism::Mechanism;
use crate::sheet::Sheet;
use indexmap::IndexSet;

impl ForcePlan {
    /// The arms that are measured on the scheme, in order, each with the sum of moments for which it is measured.
    pub(crate) fn arms(&self) -> impl Iterator<Item = (&Moment, &ForceArm)> {
        self.moments.iter().flat_map(|moment| moment.arms.iter().map(move |arm| (moment, arm)))
    }

    /// The name of an arm, as `arm(P,C)`; none of a force that has no name, as that between teeth.
    fn arm_name(&self, mechanism: &Mechanism, about: MomentPoint, arm: &ForceArm) -> Option<String> {
        let line = |of: ForceOf| match of {
            ForceOf::Load(index) => self.loads.get(index).map(|load| load.source.name(mechanism, load.body)),
            of => line_name(mechanism, of),
        };
        let point = match about {
            MomentPoint::Joint(point) => mechanism.point_name(point).to_owned(),
            MomentPoint::Crossing([first, second]) => format!("{},{}", line(first)?, line(second)?),
        };
        Some(format!("arm({},{point})", line(arm.of)?))
    }
}

impl Construction {
    /// The names of the arms that a hand measures for its force polygons, in order, each once.
    pub(crate) fn arm_names(&self, mechanism: &Mechanism) -> IndexSet<String> {
        let drawn = self.forces.as_deref().filter(|_| self.by_hand.contains(&Sheet::Forces));
        let arms = drawn
            .into_iter()
            .flat_map(|plan| plan.arms().filter_map(|(moment, arm)| plan.arm_name(mechanism, moment.about, arm)));
        arms.collect()
    }

    /// The step in which a number is found; none of one that the scene gives.
    pub(crate) fn step_of_number(&self, number: NumberId) -> Option<StepId> {
        let found = self.operations.iter().find(|operation| operation.kind.numbers().contains(&number));
        found.and_then(|operation| operation.step)
    }
}
