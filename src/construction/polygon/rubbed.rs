//! Friction as a hand finds it that does not know it: by what presses in its own drawing. What is drawn wrongly comes round by the friction once more.

use super::{ForcePart, FoundNumbers};
use crate::construction::constructed::Construction;
use crate::construction::number::NumberId;
use crate::construction::run::Values;
use crate::construction::{ForceOf, Tolerance};
use crate::forces::{RubbedJoint, Source};
use crate::mechanism::JointId;
use crate::sheet::{PerSheet, Sheet};
use nalgebra::DMatrix;

/// The part of its friction that a hand is taken to have found from the very drawing that it hands in, corrected until all polygons close; the rest is from a
/// drawing before it, with errors of its own. Books teach both.
const OF_THIS_DRAWING: f64 = 0.5;

/// A joint that rubs, in the numbers of the force plan.
#[derive(Clone, Debug)]
pub(crate) struct Rubbed {
    joint: RubbedJoint,
    /// The friction on its bodies, as it is taken: forces or couples, and the forces on levers that stand for these.
    pub taken: Vec<NumberId>,
    /// What presses, as the plan finds it.
    pub pressing: NumberId,
}

impl Rubbed {
    /// The part of the friction by which it is wrong for the largest error of a hand that draws its angle, or a line that touches its circle.
    pub fn drawn(&self, scales: PerSheet<f64>, tolerance: &Tolerance) -> f64 {
        let RubbedJoint { is_pin, grip, radius, .. } = self.joint;
        let (tangent, sine) = (grip.tangent(), grip.sine());
        match is_pin {
            true => tolerance.mm * scales[Sheet::Scheme] / (radius * sine),
            // The derivative of ln tan φ is 1/(sin φ cos φ).
            false => tolerance.degrees.to_radians() * tangent / (sine * sine),
        }
    }
}

impl Construction {
    /// The joints that rub and whose forces the polygons find.
    pub(crate) fn rubbed(&self) -> Vec<Rubbed> {
        let Some(plan) = self.forces.as_deref() else { return Vec::new() };
        let rubbed = plan.rubbing.iter().filter(|joint| joint.is_alone).filter_map(|joint| {
            let own = |load: &usize| plan.loads[*load].source == Source::Friction(joint.joint);
            let loads: Vec<usize> = (0..plan.loads.len()).filter(own).collect();
            let in_plan = loads.iter().flat_map(|load| plan.numbers.loads[*load]).flatten();
            let on_levers = self.levers.iter().flat_map(|lever| &lever.forces).filter(|f| loads.contains(&f.load));
            let taken: Vec<NumberId> = in_plan.chain(on_levers.map(|force| force.numbers[0])).collect();
            let pressing = plan.numbers.pressing(joint.joint)?;
            (!taken.is_empty()).then_some(Rubbed { joint: *joint, taken, pressing })
        });
        rubbed.collect()
    }
}

impl FoundNumbers {
    /// What presses in a joint.
    fn pressing(&self, joint: JointId) -> Option<NumberId> {
        let whole = self.whole.iter().find(|force| force.joint == joint).map(|force| force.size);
        // A guide that closes a polygon.
        let is_it = |of: ForceOf| matches!(of, ForceOf::Joint { joint: own, part, .. } if own == joint && part != ForcePart::AlongGuide);
        whole.or_else(|| self.parts.iter().find(|part| is_it(part.of)).map(|part| part.size))
    }
}

/// What friction adds to the errors of values, to first order. A friction that is wrong by the part ε of itself changes values by A ε, and what presses by B ε, in parts of
/// it. A drawing in which p is wrong of what presses has ε = p + B ε, so its values are off by A (I − B)⁻¹ p more.
#[derive(Clone, Debug)]
pub(crate) struct ComingRound {
    /// By joint that rubs: a column of A (I − B)⁻¹.
    columns: Vec<Vec<f64>>,
}

impl ComingRound {
    /// `values` and `pressing` have a column for each joint, of A and of B.
    pub fn new(values: &[Vec<f64>], pressing: &[Vec<f64>]) -> ComingRound {
        let count = values.len();
        let own = DMatrix::from_fn(count, count, |i, j| f64::from(u8::from(i == j)) - pressing[j][i]);
        // Where friction all but locks nobody comes to an end.
        let inverse = own.lu().try_inverse().filter(|inverse| inverse.iter().all(|x| x.is_finite()));
        let inverse = inverse.unwrap_or_else(|| DMatrix::identity(count, count));
        let column = |joint: usize| combined(values, inverse.column(joint).iter().copied());
        ComingRound { columns: (0..count).map(column).collect() }
    }

    /// By how much values are off where the friction of a joint is wrong by itself, in parts of it.
    pub fn of_joint(&self, joint: usize) -> &[f64] {
        &self.columns[joint]
    }

    /// The errors of values with those that come round, as two that are independent: `own` are without friction, `pressing` those of what presses, in parts of it.
    pub fn with(&self, own: &[f64], pressing: &[f64]) -> [Vec<f64>; 2] {
        let round = combined(&self.columns, pressing.iter().copied());
        // So that covariances are the mean of those of drawings that are corrected and of drawings with friction from another one.
        let rest = (1.0 - OF_THIS_DRAWING * OF_THIS_DRAWING).sqrt();
        let this = own.iter().zip(&round).map(|(own, round)| own + OF_THIS_DRAWING * round);
        [this.collect(), round.iter().map(|round| rest * round).collect()]
    }
}

fn combined(columns: &[Vec<f64>], factors: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sum = vec![0.0; columns.first().map_or(0, Vec::len)];
    for (column, factor) in columns.iter().zip(factors) {
        for (sum, value) in sum.iter_mut().zip(column) {
            *sum += factor * value;
        }
    }
    sum
}

/// The error of what presses in each joint, in parts of it.
pub(crate) fn pressing_off(rubbed: &[Rubbed], values: &Values, exact: &Values) -> Vec<f64> {
    let off = |own: &Rubbed| {
        let right = exact.number(own.pressing);
        if right == 0.0 { 0.0 } else { values.number(own.pressing) / right - 1.0 }
    };
    rubbed.iter().map(off).collect()
}
