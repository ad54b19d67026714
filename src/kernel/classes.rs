use super::lengths::Held;
use crate::mechanism::{AngularConstraint, BodyId, GROUND, JointId, Mechanism, Role};

/// By body its class, and by what bodies are held in their classes, in the order in which they are. The ground's class is 0; a class has
/// the rotation of its first body, a driven link where it contains one.
pub(super) fn classes(mechanism: &Mechanism) -> (Vec<usize>, Vec<(BodyId, Option<Held>)>) {
    let bodies = mechanism.bodies.len();
    let mut found: Vec<Option<usize>> = vec![None; bodies];
    let mut order = Vec::with_capacity(bodies);
    let driver = |b: &usize| matches!(mechanism.bodies[*b].role, Role::Driver { .. });
    let (drivers, others): (Vec<usize>, Vec<usize>) = (0..bodies).partition(driver);
    let angular = mechanism.joints.iter().map(|joint| joint.angular.as_ref());
    let fixed = angular.map(|angular| angular.and_then(AngularConstraint::as_fixed_angle));
    let ties: Vec<(JointId, [BodyId; 2])> =
        fixed.enumerate().filter_map(|(joint, fixed)| Some((JointId(joint), fixed?.0))).collect();
    let mut next = 0;
    for root in std::iter::once(GROUND.0).chain(drivers).chain(others) {
        if found[root].is_some() {
            continue;
        }
        found[root] = Some(next);
        order.push((BodyId(root), None));
        while let Some((body, held)) =
            ties.iter().find_map(|&(joint, [first, second])| match (found[first.0], found[second.0]) {
                (Some(_), None) => Some((second, Held { by: first, joint, is_back: false })),
                (None, Some(_)) => Some((first, Held { by: second, joint, is_back: true })),
                _ => None,
            })
        {
            found[body.0] = found[held.by.0];
            order.push((body, Some(held)));
        }
        next += 1;
    }
    (found.into_iter().map(Option::unwrap_or_default).collect(), order)
}
