//! Where a joint may go: everywhere, along a line or a circle, or nowhere.

use crate::geometry::{Point, Vector, cross, quarter_turn, unit};

/// What holds a joint. Each rule holds where the joint is now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// It stays on the line through its place in this direction, a unit vector.
    Line(Vector),
    /// It stays at its distance from this place.
    Circle(Point),
}

/// Sine of the angle below which two directions count as one.
const PARALLEL: f64 = 1e-9;

impl Rule {
    /// Whether two rules are one.
    pub fn is(self, other: Rule) -> bool {
        match (self, other) {
            (Rule::Line(a), Rule::Line(b)) => cross(a, b).abs() < PARALLEL,
            (Rule::Circle(a), Rule::Circle(b)) => a == b,
            _ => false,
        }
    }
}

/// The allowed place nearest to `wanted` of a joint that is at `now`.
pub fn allowed(now: Point, rules: &[Rule], wanted: Point) -> Point {
    match *rules {
        [] => wanted,
        [Rule::Line(along)] => now + along * along.dot(&(wanted - now)),
        [Rule::Circle(center)] => match unit(wanted - center) {
            Some(direction) => center + direction * (now - center).norm(),
            None => now,
        },
        // Two lines through one place cross there.
        [Rule::Line(_), Rule::Line(_)] => now,
        [Rule::Line(along), Rule::Circle(center)] | [Rule::Circle(center), Rule::Line(along)] => {
            nearest(wanted, [now, now + along * (2.0 * along.dot(&(center - now)))])
        }
        // The other crossing is the mirror image in the line of both centres.
        [Rule::Circle(a), Rule::Circle(b)] => match unit(b - a) {
            Some(axis) => {
                let across = quarter_turn(axis);
                nearest(wanted, [now, now - across * (2.0 * across.dot(&(now - a)))])
            }
            None => now,
        },
        _ => now,
    }
}

fn nearest(wanted: Point, [one, other]: [Point; 2]) -> Point {
    if (other - wanted).norm() < (one - wanted).norm() { other } else { one }
}
