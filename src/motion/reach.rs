//! How far a dyad on a crank reaches: where it can go no further, and whether branches cross there. Both follow from sums
//! of lengths, whose signs are certain.

use super::moving::guide_error;
use crate::geometry::{Ball, Number, Pair, Point, UNIT_ROUNDOFF, degrees_of, quarter_turn};
use crate::mechanism::{BodyId, Class, GROUND, Group, Guide, Mechanism, PointId, Role};
use crate::position::Pose;

/// What coordinates that were found from lengths may be off, in parts of themselves.
const FOUND: f64 = 8.0 * UNIT_ROUNDOFF;

/// A dyad between a crank and the ground.
///
/// With crank a, frame f and links b, c of the dyad the crank's end comes as near to the other pivot as |f − a| and as
/// far as f + a; the dyad reaches from |b − c| to b + c. With a slider at the end of a rod l, the crank's end comes as
/// near to the guide's line as h − a and as far as h + a; the rod reaches to l on either side.
pub(crate) struct Reach {
    /// The driven link.
    pub crank: BodyId,
    /// From its pivot to its end, in its own frame.
    arm: Pair<Ball>,
    /// From the pivot to the other one, or along the guide.
    base: Pair<Ball>,
    /// What the dyad reaches: stretched and folded, or on either side of the guide.
    reaches: [Stretch; 2],
    /// The one of these near which the pose is.
    near: usize,
    /// The side on which the crank is there, if it lies in line.
    side: usize,
    /// The arm's directions in line with the dyad on either side, against the base.
    lines: [Pair<Ball>; 2],
}

/// A reach of the dyad against those of the crank's end.
struct Stretch {
    /// What is left between it and the crank's reach on either side; zero where crank and dyad lie in one line.
    left: [Ball; 2],
    /// The crank's directions where the dyad is stretched so, of any length, against the base.
    turns: [Pair<Ball>; 2],
}

impl Reach {
    /// That of a dyad near the position `pose`; `None` for other groups.
    pub fn new(mechanism: &Mechanism, group: &Group, pose: &Pose) -> Option<Reach> {
        let [chain] = group.loops.as_slice() else { return None };
        if group.class != Class::Second || chain.closed {
            return None;
        }
        let (&[start, first, second, end], &[outer, middle, last]) = (chain.bodies.as_slice(), chain.joints.as_slice())
        else {
            return None;
        };
        let (crank, [first, second], [outer, last]) = match (start, end) {
            (crank, GROUND) => (crank, [first, second], [outer, last]),
            (GROUND, crank) => (crank, [second, first], [last, outer]),
            _ => return None,
        };
        let Role::Driver { pivot, .. } = mechanism.body(crank).role else { return None };
        let pin = |joint| mechanism.joint(joint).slider.is_none().then(|| mechanism.joint_point(joint));
        let [driven, middle] = [pin(outer)?, pin(middle)?];
        let from = mechanism.given[pivot.0]?;
        let arm = between(mechanism.body(crank).local_of(pivot)?, mechanism.body(crank).local_of(driven)?);
        let on = |body: BodyId, p: PointId, q: PointId| {
            let body = mechanism.body(body);
            Some(length(between(body.local_of(p)?, body.local_of(q)?)))
        };
        let (a, rod) = (length(arm), on(first, driven, middle)?);
        let turned = |p: PointId| pose.point(p) - pose.point(pivot);
        if let Some(id) = mechanism.joint(last).slider {
            let slider = mechanism.slider(id);
            let Guide::Local { through, direction } = slider.guide else { return None };
            if slider.on != GROUND || slider.at != middle {
                return None;
            }
            let base = Pair::within(direction, guide_error(direction));
            let height = between(through, from).dot(base.quarter_turn());
            let reaches = [rod, -rod].map(|reach| Stretch::from_guide(a, reach - height));
            let up = quarter_turn(direction);
            let near = usize::from((pose.point(driven) - pose.point(middle)).dot(&up) < 0.0);
            let side = usize::from(turned(driven).dot(&up) < 0.0);
            let lines = [1, -1].map(|y| Pair { x: Ball::default(), y: Ball::from(y) });
            return Some(Reach { crank, arm, base, reaches, near, side, lines });
        }
        let fixed = mechanism.joint_point(last);
        let base = between(from, mechanism.given[fixed.0]?);
        let (f, other) = (length(base), on(second, middle, fixed)?);
        let reaches = [rod + other, rod - other].map(|reach| Stretch::from_pivot(a, f, reach));
        let [to_driven, to_fixed] = [driven, fixed].map(|p| pose.point(p) - pose.point(middle));
        let near = usize::from(to_driven.dot(&to_fixed) > 0.0);
        let side = usize::from(turned(driven).dot(&turned(fixed)) < 0.0);
        let lines = [1, -1].map(|x| Pair { x: Ball::from(x), y: Ball::default() });
        Some(Reach { crank, arm, base, reaches, near, side, lines })
    }

    /// Whether two branches cross where the dyad lies in one line with the crank, near the pose: a change point. If
    /// lengths only nearly add up to that, branches either pass each other or end at two limits close together, and
    /// whoever follows them may not leap.
    pub fn branches_cross(&self) -> bool {
        may_be_zero(self.reaches[self.near].left[self.side])
    }

    /// The angles of the crank in degrees, next to `near`, at which the dyad can go no further, each with the bound of its
    /// error. Those where branches cross are none.
    pub fn limits(&self, near: f64) -> Vec<[f64; 2]> {
        let is_limit = |stretch: &&Stretch| stretch.left.iter().all(|left| left.high > 0.0 && !may_be_zero(*left));
        let turns = self.reaches.iter().filter(is_limit).flat_map(|stretch| stretch.turns);
        turns.map(|turn| self.angle(turn, near)).collect()
    }

    /// The angle of the crank in degrees at which it lies in line with the dyad, near the pose, likewise.
    pub fn in_line(&self, near: f64) -> [f64; 2] {
        self.angle(self.lines[self.side], near)
    }

    /// The angle next to `near` of the crank's axis, where the arm has this direction against the base.
    fn angle(&self, turn: Pair<Ball>, near: f64) -> [f64; 2] {
        let axis = self.base.turn(turn).turn(self.arm.reversed());
        let degrees = degrees_of([axis.x.high, axis.y.high].into());
        let degrees = degrees + 360.0 * ((near - degrees) / 360.0).round();
        [degrees, axis.degrees_from(degrees)]
    }
}

impl Stretch {
    /// By half-angle formulas, which lose nothing where crank and frame are nearly in line.
    fn from_pivot(a: Ball, f: Ball, reach: Ball) -> Stretch {
        let sine = (reach - (f - a)) * (reach + (f - a));
        let cosine = (f + a - reach) * (f + a + reach);
        let across = (sine * cosine).sqrt().twice();
        Stretch { left: [sine, cosine], turns: [across, -across].map(|y| Pair { x: cosine - sine, y }) }
    }

    fn from_guide(a: Ball, height: Ball) -> Stretch {
        let left = [a - height, a + height];
        let along = (left[0] * left[1]).sqrt();
        Stretch { left, turns: [along, -along].map(|x| Pair { x, y: height }) }
    }
}

/// Whether a number may be zero.
fn may_be_zero(x: Ball) -> bool {
    x.high.abs() <= x.error()
}

/// From one place to another, each coordinate as it is printed; one that may have been found from lengths has their errors.
fn between(p: Point, q: Point) -> Pair<Ball> {
    let is_given = p.y == 0.0 && q.y == 0.0 || p.x == 0.0 && q.x == 0.0;
    let off = if is_given { 0.0 } else { FOUND * (p.coords.amax() + q.coords.amax()) };
    let [x, y] = [0, 1].map(|axis| written(q[axis]) - written(p[axis]));
    Pair { x, y }.widened(off)
}

/// The decimal that was read as a number: the shortest one where that has at most thirteen digits, else any.
fn written(x: f64) -> Ball {
    let is_short = format!("{x:.12e}").parse() == Ok(x);
    Ball::decimal(x).widened(if is_short { 0.0 } else { UNIT_ROUNDOFF * x.abs() })
}

fn length(v: Pair<Ball>) -> Ball {
    match (v.x == Ball::default(), v.y == Ball::default()) {
        (_, true) => size(v.x),
        (true, _) => size(v.y),
        _ => v.dot(v).sqrt(),
    }
}

fn size(x: Ball) -> Ball {
    if x.high < 0.0 { -x } else { x }
}
