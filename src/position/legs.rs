use super::frames::Hold;
use super::roots::real_roots;
use crate::geometry::{Placement, Point, Vector, cross, quarter_turn};

/// A leg between two rigid bodies a and b: one condition on the placement of b in a's frame.
///
/// A binary link between two revolute joints keeps a distance; one with a prismatic joint on either side
/// keeps a point of one body on a line of the other; one with two prismatic joints keeps the angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum LegCondition {
    /// Point `a` of body a and point `b` of body b are `length` apart.
    Distance { a: Point, b: Point, length: f64 },
    /// Point `b` of body b lies on a line of body a.
    OnLineOfA { point: Point, direction: Vector, b: Point },
    /// Point `a` of body a lies on a line of body b.
    OnLineOfB { point: Point, direction: Vector, a: Point },
    /// Body b is turned against a by this rotation.
    Turned(crate::geometry::Turn),
}

/// Every real placement of body b in a's frame that meets three conditions.
///
/// For a given relative turn each leg is a circle or a straight line for the translation t; two linear
/// rows M t = r (circles enter as differences with the first circle) and one remaining condition leave a
/// trigonometric polynomial of the turn of degree 3 at most, so 6 placements at most. Its real roots are found
/// by subdivision between the roots of its derivatives, which loses none. Order of the placements: by the
/// relative turn, counter-clockwise from 0. Placements are good to about half the digits near a double
/// root; the caller closes the loops to full accuracy and drops what does not close.
pub(super) fn placements(conditions: [LegCondition; 3]) -> Vec<Placement> {
    if let Some(k) = conditions.iter().position(|c| matches!(c, LegCondition::Turned(_))) {
        let LegCondition::Turned(turn) = conditions[k] else {
            return Vec::new();
        };
        let rest = [conditions[(k + 1) % 3], conditions[(k + 2) % 3]];
        let turn = Vector::new(turn.re, turn.im);
        let rows = rest.map(|c| Row::new(&c, turn));
        return translations(&rows).into_iter().map(|t| placement(t, turn)).collect();
    }
    let rows_at = |turn: Vector| conditions.map(|c| Row::new(&c, turn));
    let mut found = Vec::new();
    for turn in real_roots(|turn| closing_polynomial(&rows_at(turn))) {
        let rows = rows_at(turn);
        for t in candidates(&rows) {
            found.push(placement(t, turn));
        }
    }
    found
}

/// Every real placement of body b that the fixed frame holds by a joint, `direct`, and that meets one condition more.
///
/// About a pin the condition is a trigonometric polynomial of degree 1: two placements at most. Along a guide it is a line or a
/// circle cut by a line.
pub(super) fn joined_placements(direct: &Hold, condition: LegCondition) -> Vec<Placement> {
    match *direct {
        Hold::Pin { local, place } => {
            let at = |turn: Vector| place.coords - turned(turn, local.coords);
            if let LegCondition::Turned(turn) = condition {
                let turn = Vector::new(turn.re, turn.im);
                return vec![placement(at(turn), turn)];
            }
            let turns = real_roots(|turn| Row::new(&condition, turn).excess(at(turn)));
            turns.into_iter().map(|turn| placement(at(turn), turn)).collect()
        }
        Hold::Slide { frame, along } => {
            let turn = Vector::new(frame.rotation.re, frame.rotation.im);
            let normal = quarter_turn(along);
            let guide = Row { circle: false, arm: normal, constant: normal.dot(&frame.translation.vector) };
            let rows = [guide, Row::new(&condition, turn)];
            translations(&rows).into_iter().map(|t| placement(t, turn)).collect()
        }
    }
}

/// The smallest amount by which the first distance condition is missed over all relative turns with the other conditions met,
/// signed (positive: the leg would have to be longer); `None` without a distance condition or where the others never meet.
pub(super) fn smallest_miss(direct: Option<&Hold>, conditions: &[LegCondition]) -> Option<f64> {
    let is_distance = |c: &LegCondition| matches!(c, LegCondition::Distance { .. });
    let first = conditions.iter().position(is_distance)?;
    let circle = &conditions[first];
    let others: Vec<&LegCondition> =
        conditions.iter().enumerate().filter(|(k, _)| *k != first).map(|(_, c)| c).collect();
    const SAMPLES: usize = 720;
    let fixed = others.iter().find_map(|c| match c {
        LegCondition::Turned(turn) => Some(Vector::new(turn.re, turn.im)),
        _ => None,
    });
    let turns: Vec<Vector> = match (fixed, direct) {
        (Some(turn), _) => vec![turn],
        (None, Some(Hold::Slide { frame, .. })) => {
            vec![Vector::new(frame.rotation.re, frame.rotation.im)]
        }
        (None, _) => (0..SAMPLES)
            .map(|k| std::f64::consts::TAU * k as f64 / SAMPLES as f64)
            .map(|angle| Vector::new(libm::cos(angle), libm::sin(angle)))
            .collect(),
    };
    let misses = turns.into_iter().flat_map(|turn| {
        let found = match (direct, others.as_slice()) {
            (Some(Hold::Pin { local, place }), _) => {
                vec![place.coords - turned(turn, local.coords)]
            }
            // The place of the guide nearest to the circle's centre.
            (Some(Hold::Slide { frame, along }), _) => {
                let centre = -Row::new(circle, turn).arm;
                let start = frame.translation.vector;
                vec![start + along * (centre - start).dot(along)]
            }
            (None, &[a, b]) => translations(&[Row::new(a, turn), Row::new(b, turn)]),
            (None, _) => Vec::new(),
        };
        found.into_iter().map(move |t| miss(circle, turn, t))
    });
    misses.filter(|m| m.is_finite()).min_by(|a, b| a.abs().total_cmp(&b.abs()))
}

/// How much longer a distance is than it should be.
fn miss(circle: &LegCondition, turn: Vector, t: Vector) -> f64 {
    let row = Row::new(circle, turn);
    (t + row.arm).norm() - row.constant
}

/// A vector turned by the rotation with this cosine and sine.
fn turned(turn: Vector, v: Vector) -> Vector {
    Vector::new(turn.x * v.x - turn.y * v.y, turn.x * v.y + turn.y * v.x)
}

fn placement(t: Vector, turn: Vector) -> Placement {
    Placement::from_parts(t.into(), crate::geometry::Turn::from_cos_sin_unchecked(turn.x, turn.y))
}

/// A condition at a given turn, on the translation t alone.
#[derive(Clone, Copy)]
struct Row {
    /// Circle: |t + arm| = constant. Line: arm · t = constant.
    circle: bool,
    arm: Vector,
    constant: f64,
}

impl Row {
    fn new(condition: &LegCondition, turn: Vector) -> Row {
        let turned = |v: Vector| turned(turn, v);
        match *condition {
            LegCondition::Distance { a, b, length } => {
                Row { circle: true, arm: turned(b.coords) - a.coords, constant: length }
            }
            LegCondition::OnLineOfA { point, direction, b } => {
                let normal = quarter_turn(direction);
                Row { circle: false, arm: normal, constant: normal.dot(&(point.coords - turned(b.coords))) }
            }
            LegCondition::OnLineOfB { point, direction, a } => {
                let normal = turned(quarter_turn(direction));
                Row { circle: false, arm: normal, constant: normal.dot(&(a.coords - turned(point.coords))) }
            }
            // Its angle is met already: no condition on t.
            LegCondition::Turned(_) => Row { circle: false, arm: Vector::zeros(), constant: 0.0 },
        }
    }

    /// Zero where the condition is met, of one sign on either side.
    fn excess(&self, t: Vector) -> f64 {
        if self.circle {
            let distance = (t + self.arm).norm();
            (distance - self.constant) * (distance + self.constant)
        } else {
            self.arm.dot(&t) - self.constant
        }
    }

    /// The line on which this circle and `other` have equal power: (arm_1 − arm_0) · t = constant.
    fn minus(&self, other: &Row) -> Row {
        let (s, d) = (self.arm + other.arm, self.arm - other.arm);
        // |t + arm|² = L²: the difference of two such equations, squares taken as products of differences.
        let lengths = (self.constant - other.constant) * (self.constant + other.constant);
        Row { circle: false, arm: d, constant: 0.5 * (lengths - d.dot(&s)) }
    }
}

/// Two straight rows and the remaining one, of three.
fn reduced(rows: &[Row; 3]) -> (Row, Row, Row) {
    let mut straight = Vec::with_capacity(2);
    let mut last = None;
    for row in rows {
        match (row.circle, last) {
            (true, None) => last = Some(*row),
            (true, Some(first)) => straight.push(row.minus(&first)),
            (false, _) => straight.push(*row),
        }
    }
    match (last, straight.as_slice()) {
        (Some(circle), [p, q]) => (*p, *q, circle),
        _ => (straight[0], straight[1], straight[2]),
    }
}

/// Zero where the three rows have a common t: a trigonometric polynomial of the turn of degree 3 at most.
fn closing_polynomial(rows: &[Row; 3]) -> f64 {
    let (p, q, last) = reduced(rows);
    let determinant = cross(p.arm, q.arm);
    let t = undivided(&p, &q);
    if last.circle {
        let v = t + last.arm * determinant;
        let radius = last.constant * determinant;
        (v.norm() - radius.abs()) * (v.norm() + radius.abs())
    } else {
        last.arm.dot(&t) - last.constant * determinant
    }
}

/// The translation that solves two straight rows, times their determinant.
fn undivided(p: &Row, q: &Row) -> Vector {
    Vector::new(p.constant * q.arm.y - q.constant * p.arm.y, q.constant * p.arm.x - p.constant * q.arm.x)
}

/// The translations at a root: one where two straight rows cross well, else those of a row and the remaining condition.
fn candidates(rows: &[Row; 3]) -> Vec<Vector> {
    let (p, q, last) = reduced(rows);
    let size = p.arm.norm() * q.arm.norm();
    let determinant = cross(p.arm, q.arm);
    if determinant.abs() > 1e-6 * size {
        return vec![undivided(&p, &q) / determinant];
    }
    let stronger = if p.arm.norm_squared() >= q.arm.norm_squared() { p } else { q };
    translations(&[stronger, last])
}

/// The common translations of two rows: none, one or two.
fn translations(rows: &[Row; 2]) -> Vec<Vector> {
    let (line, circle) = match (rows[0].circle, rows[1].circle) {
        (false, false) => {
            let determinant = cross(rows[0].arm, rows[1].arm);
            let t = undivided(&rows[0], &rows[1]) / determinant;
            return if t.x.is_finite() && t.y.is_finite() { vec![t] } else { Vec::new() };
        }
        (true, true) => (rows[1].minus(&rows[0]), rows[0]),
        (true, false) => (rows[1], rows[0]),
        (false, true) => (rows[0], rows[1]),
    };
    let length = line.arm.norm();
    if length == 0.0 {
        return Vec::new();
    }
    let normal = line.arm / length;
    let centre = -circle.arm;
    let distance = line.constant / length - normal.dot(&centre);
    let half = (circle.constant - distance) * (circle.constant + distance);
    // A line that only touches within rounding counts as touching; closing the loops decides.
    if half < -1e-9 * circle.constant * circle.constant {
        return Vec::new();
    }
    let foot = centre + normal * distance;
    let along = quarter_turn(normal) * half.max(0.0).sqrt();
    vec![foot + along, foot - along]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planted_placement_is_found() {
        let turn = crate::geometry::turn_of_degrees(40.0);
        let planted = Placement::from_parts(Vector::new(3.0, 1.0).into(), turn);
        let leg = |a: Point, b: Point| LegCondition::Distance { a, b, length: (planted * b - a).norm() };
        let legs = [
            leg(Point::new(0.0, 0.0), Point::new(0.5, 0.2)),
            leg(Point::new(2.0, -1.0), Point::new(1.5, 0.0)),
            leg(Point::new(1.0, 2.5), Point::new(-0.5, 1.0)),
        ];
        let found = placements(legs);
        assert!(found.iter().any(|p| {
            (p.translation.vector - planted.translation.vector).norm() < 1e-9
                && p.rotation.angle_to(&planted.rotation).abs() < 1e-9
        }));
        assert!(found.len().is_multiple_of(2) && found.len() <= 6);
    }
}
