//! Mistakes with friction. Whoever takes it wrongly in one joint finds others that carry something else, and with it other friction there; or goes on with
//! that of the right forces. Both are tried.

use super::forces::{Drawn, found};
use super::site::{Candidate, Site};
use super::told::{Blank, Told, tell};
use crate::construction::{Change, NumberId};
use crate::forces::{FrictionLoad, RubbedJoint, Source, friction_times, rubbing, smooth_over_rough};
use crate::mechanism::JointId;
use crate::scene::Grip;

/// Changes smaller than this part are none.
const LEAST: f64 = 1e-6;

/// The friction of a force plan.
struct Friction<'s> {
    drawn: &'s Drawn<'s>,
    /// The joints that rub.
    joints: Vec<RubbedJoint>,
    /// The indices of the loads, in their order, with their joints.
    loads: Vec<(usize, JointId)>,
}

impl<'s> Friction<'s> {
    fn of(drawn: &'s Drawn<'s>) -> Friction<'s> {
        let loads = drawn.loads().filter_map(|(index, load)| match load.source {
            Source::Friction(joint) => Some((index, joint)),
            _ => None,
        });
        Friction { drawn, joints: rubbing(&drawn.solution().mechanism), loads: loads.collect() }
    }

    /// What is told of joints: the symbols of their friction.
    fn symbols(&self, joints: &[JointId]) -> Blank {
        let symbol = |joint: &JointId| {
            let (index, _) = self.loads.iter().find(|(_, own)| own == joint)?;
            Some(self.drawn.load_symbol(&self.drawn.plan.loads[*index]).text().to_owned())
        };
        Blank::Words(joints.iter().filter_map(symbol).collect::<Vec<_>>().join(", "))
    }

    /// Each joint of some alone, then all of them together.
    fn targets(&self, joints: &[JointId]) -> Vec<Vec<JointId>> {
        let mut all: Vec<Vec<JointId>> = joints.iter().map(|joint| vec![*joint]).collect();
        if joints.len() > 1 {
            all.push(joints.to_vec());
        }
        all
    }

    /// The loads of friction so many times as large, by their indices.
    fn times(&self, told: Told, factors: impl Iterator<Item = (usize, f64)>) -> Option<Candidate> {
        let changed = factors.filter(|(_, factor)| factor.is_finite() && (factor - 1.0).abs() > LEAST);
        let edits = changed.flat_map(|(load, factor)| {
            let numbers: Vec<NumberId> =
                self.drawn.force_numbers(load).into_iter().chain(self.drawn.couple_numbers(load)).collect();
            numbers.into_iter().map(move |number| (number, Change::Times(number, factor)))
        });
        self.drawn.of_numbers(told, edits.collect())
    }

    /// Joints whose friction is so many times as large: what the others then have goes with what they carry, or stays.
    fn wrong(&self, told: &Told, factor: &dyn Fn(JointId) -> f64) -> Vec<Candidate> {
        let stays = self.times(told.clone(), self.loads.iter().map(|(load, joint)| (*load, factor(*joint))));
        let solution = self.drawn.solution();
        let again = friction_times(&solution.mechanism, &solution.pose, factor).and_then(|found| {
            let ratio = |(&(index, _), new): (&(usize, JointId), &FrictionLoad)| {
                let old = &self.drawn.plan.loads[index];
                let ratio = match old.couple == 0.0 {
                    true => new.force.dot(&old.force) / old.force.norm_squared(),
                    false => new.couple / old.couple,
                };
                (index, ratio)
            };
            self.times(told.clone(), self.loads.iter().zip(&found).map(ratio))
        });
        stays.into_iter().chain(again).collect()
    }

    /// The candidates for each target, with the factor of each joint in it.
    fn each(&self, joints: &[JointId], tell: fn(Blank) -> Told, factor: impl Fn(JointId) -> f64) -> Vec<Candidate> {
        let candidates = |target: Vec<JointId>| {
            let told = tell(self.symbols(&target));
            self.wrong(&told, &|joint| if target.contains(&joint) { factor(joint) } else { 1.0 })
        };
        self.targets(joints).into_iter().flat_map(candidates).collect()
    }

    fn all(&self) -> Vec<JointId> {
        self.joints.iter().map(|own| own.joint).collect()
    }

    fn own(&self, joint: JointId) -> Option<&RubbedJoint> {
        self.joints.iter().find(|own| own.joint == joint)
    }
}

/// Friction in the sense of the motion.
pub(super) fn reversed(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let friction = Friction::of(drawn);
        friction.each(&friction.all(), tell::friction_sense, |_| -1.0)
    })
}

/// Friction left out.
pub(super) fn left_out(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let friction = Friction::of(drawn);
        friction.each(&friction.all(), tell::friction_left_out, |_| 0.0)
    })
}

/// Circles of friction by the diameter of the journal.
pub(super) fn diameter(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let friction = Friction::of(drawn);
        let pins = friction.joints.iter().filter(|own| own.is_pin).map(|own| own.joint);
        friction.each(&pins.collect::<Vec<_>>(), tell::friction_circle_diameter, |_| 2.0)
    })
}

/// The angle of friction in radians, its tangent and its sine for each other.
pub(super) fn angle_for_coefficient(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let friction = Friction::of(drawn);
        let by = |which: usize| {
            friction.each(&friction.all(), tell::angle_for_coefficient, |joint| {
                friction.own(joint).map_or(1.0, |own| wrong_grips(own)[which])
            })
        };
        (0..2).flat_map(by).collect()
    })
}

/// By what a grip is wrong: the angle for what is meant, or tangent and sine for each other; of a coefficient that counts as an angle its tangent.
fn wrong_grips(RubbedJoint { is_pin, grip, .. }: &RubbedJoint) -> [f64; 2] {
    let (tangent, sine) = (grip.tangent(), grip.sine());
    let [right, other] = if *is_pin { [sine, tangent] } else { [tangent, sine] };
    let angle = match *grip {
        Grip::Angle(degrees) => degrees.to_radians(),
        Grip::Coefficient(coefficient) if *is_pin => libm::sin(coefficient),
        Grip::Coefficient(coefficient) => libm::tan(coefficient),
    };
    [angle / right, other / right]
}

/// Friction by what joints would carry if they were smooth.
pub(super) fn without_lean(site: &Site<'_>) -> Vec<Candidate> {
    found(site, |drawn| {
        let friction = Friction::of(drawn);
        let solution = drawn.solution();
        let Some(ratios) = smooth_over_rough(&solution.mechanism, &solution.pose) else { return Vec::new() };
        let ratio = |joint: JointId| ratios.iter().find(|(own, _)| *own == joint).map_or(1.0, |(_, ratio)| *ratio);
        let told = |target: &[JointId]| tell::normal_without_lean(friction.symbols(target));
        let candidate = |target: Vec<JointId>| {
            let factor = |joint: JointId| if target.contains(&joint) { ratio(joint) } else { 1.0 };
            friction.times(told(&target), friction.loads.iter().map(|(load, joint)| (*load, factor(*joint))))
        };
        friction.targets(&friction.all()).into_iter().filter_map(candidate).collect()
    })
}
