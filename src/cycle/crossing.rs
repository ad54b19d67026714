//! Whether two branches of a four-bar linkage cross, or only come near each other: by the signs of sums of its lengths.

use crate::geometry::{Ball, Number, Pair, Point, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{BodyId, Class, GROUND, Group, Mechanism, PointId, Role};
use crate::position::Pose;

/// Sums of lengths count as zero within so many roundings of these: decimals that add up to nothing do not as f64.
const ROUNDINGS: f64 = 16.0;

/// Whether two branches cross where the dyad `group` lies in one line with the crank that moves it, near the position
/// `pose`. `None` for other groups.
///
/// With crank a, frame f and links b, c of the dyad the crank's end comes as near to the other pivot as |f − a| and as
/// far as f + a; the dyad reaches from |b − c| to b + c. If the two are equal, the branches cross: a change point. If they
/// are nearly equal, the branches either pass each other or end at two limits close together, and whoever follows them
/// may not leap.
pub(super) fn branches_cross(mechanism: &Mechanism, group: &Group, pose: &Pose) -> Option<bool> {
    let [chain] = group.loops.as_slice() else { return None };
    if group.class != Class::Second || chain.closed {
        return None;
    }
    let (&[start, first, second, end], &[outer, middle, last]) = (chain.bodies.as_slice(), chain.joints.as_slice())
    else {
        return None;
    };
    let pin = |joint| mechanism.joint(joint).slider.is_none().then(|| mechanism.joint_point(joint));
    let [outer, middle, last] = [pin(outer)?, pin(middle)?, pin(last)?];
    // The crank's end, and the pivot on the ground.
    let (crank, driven, fixed) = match (start, end) {
        (crank, GROUND) => (crank, outer, last),
        (GROUND, crank) => (crank, last, outer),
        _ => return None,
    };
    let Role::Driver { pivot, .. } = mechanism.body(crank).role else { return None };
    let given = |point: PointId| mechanism.given[point.0];
    let on = |body: BodyId, p: PointId, q: PointId| {
        let body = mechanism.body(body);
        Some(distance(body.local_of(p)?, body.local_of(q)?))
    };
    let (a, f) = (on(crank, pivot, driven)?, distance(given(pivot)?, given(fixed)?));
    let (b, c) = (on(first, outer, middle)?, on(second, middle, last)?);
    let along = |from: PointId, p: PointId, q: PointId| {
        let vector = |to: PointId| -> Vector { pose.points[to.0] - pose.points[from.0] };
        vector(p).dot(&vector(q)) > 0.0
    };
    let reached = if along(pivot, driven, fixed) { f - a } else { f + a };
    let reach = if along(middle, outer, last) { b - c } else { b + c };
    let apart = (size(reached) - size(reach)).error_from(0.0);
    Some(apart <= ROUNDINGS * UNIT_ROUNDOFF * (a + f + b + c).high)
}

fn distance(p: Point, q: Point) -> Ball {
    let arm = Pair::between(p, q);
    arm.dot(arm).sqrt()
}

fn size(x: Ball) -> Ball {
    if x.high < 0.0 { -x } else { x }
}
