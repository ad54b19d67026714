use crate::geometry::Turn;
use crate::mechanism::{AngularConstraint, BodyId, GROUND, Joint, Mechanism, Role};

/// By body: its class and its rotation relative to the class. The ground's class is 0; a class has the rotation of its
/// first body, a driven link where it contains one.
pub(super) fn classes(mechanism: &Mechanism) -> Vec<(usize, Turn)> {
    let bodies = mechanism.bodies.len();
    let mut found: Vec<Option<(usize, Turn)>> = vec![None; bodies];
    let driver = |b: &usize| matches!(mechanism.bodies[*b].role, Role::Driver { .. });
    let (drivers, others): (Vec<usize>, Vec<usize>) = (0..bodies).partition(driver);
    let tie = |joint: &Joint| joint.angular.as_ref().and_then(AngularConstraint::as_fixed_angle);
    let ties: Vec<([BodyId; 2], Turn)> = mechanism.joints.iter().filter_map(tie).collect();
    let mut next = 0;
    for root in std::iter::once(GROUND.0).chain(drivers).chain(others) {
        if found[root].is_some() {
            continue;
        }
        found[root] = Some((next, Turn::identity()));
        while let Some((body, seat)) =
            ties.iter().find_map(|&([first, second], turn)| match (found[first.0], found[second.0]) {
                (Some((class, seat)), None) => Some((second, (class, seat * turn))),
                (None, Some((class, seat))) => Some((first, (class, seat * turn.inverse()))),
                _ => None,
            })
        {
            found[body.0] = Some(seat);
        }
        next += 1;
    }
    found.into_iter().map(|seat| seat.unwrap_or((0, Turn::identity()))).collect()
}
