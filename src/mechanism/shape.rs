use crate::geometry::{Point, Vector, cross, unit};
use crate::scene::{Length, Link, Shape};

/// The local coordinates of a link's points, origin in the first, x axis towards the second.
///
/// `approximate` gives rough places, which settle on which side of its axis a triangle's third point
/// lies. The second value is true where that was not settled and the counter-clockwise side was taken.
pub(super) fn local_points(link: &Link, approximate: impl Fn(&str) -> Option<Point>) -> (Vec<Point>, bool) {
    match &link.shape {
        Shape::Bare => (vec![Point::origin(); link.points.len()], false),
        Shape::Local(places) => {
            let at = |name: &String| places.get(name).map_or_else(Point::origin, |&p| p.into());
            (link.points.iter().map(at).collect(), false)
        }
        Shape::Lengths(lengths) => match link.points.as_slice() {
            [a, b] => (vec![Point::origin(), Point::new(between(lengths, a, b), 0.0)], false),
            [a, b, c] => {
                let rough = [a, b, c].map(|name| approximate(name));
                let hand = match rough {
                    [Some(a), Some(b), Some(c)] => Some(cross(b - a, c - a)),
                    _ => None,
                };
                let third = triangle(between(lengths, a, b), between(lengths, a, c), between(lengths, b, c));
                let side = if hand.is_some_and(|h| h < 0.0) { -1.0 } else { 1.0 };
                let points =
                    vec![Point::origin(), Point::new(between(lengths, a, b), 0.0), Point::new(third.x, side * third.y)];
                let straight = third.y == 0.0;
                (points, hand.is_none() && !straight)
            }
            more => (vec![Point::origin(); more.len()], false),
        },
    }
}

/// The given length between two points; the scene has been checked to state it.
fn between(lengths: &[Length], a: &str, b: &str) -> f64 {
    lengths.iter().find(|l| (l.from == a && l.to == b) || (l.from == b && l.to == a)).map_or(0.0, |l| l.value)
}

/// Lengths that add up within this part of the longest make a straight link.
const STRAIGHT: f64 = 1e-12;

/// The third corner, above the axis, of a triangle with base `ab` and sides `ac`, `bc`.
///
/// Differences before products; the height by Kahan's stable form of Heron's formula (W. Kahan,
/// *Miscalculating Area and Angles of a Needle-like Triangle*, 2014). Lengths that only just fail to
/// close count as a straight link.
fn triangle(ab: f64, ac: f64, bc: f64) -> Point {
    let x = 0.5 * (ab + (ac - bc) * ((ac + bc) / ab));
    let mut sides = [ab, ac, bc];
    sides.sort_by(f64::total_cmp);
    let [c, b, a] = sides;
    if (a - b - c).abs() <= STRAIGHT * a {
        return Point::new(x, 0.0);
    }
    let sixteen_areas = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    Point::new(x, 0.5 * sixteen_areas.max(0.0).sqrt() / ab)
}

/// The unit vector along `v`, which the scene has been checked not to let vanish.
pub(super) fn direction(v: Vector) -> Vector {
    unit(v).unwrap_or_else(Vector::x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_triangle() {
        let p = triangle(4.0, 3.0, 5.0);
        assert!((p - Point::new(0.0, 3.0)).norm() < 1e-15);
    }

    #[test]
    fn straight_link() {
        assert_eq!(triangle(3.0, 1.0, 2.0).y, 0.0);
        // 0.5 + 0.2 is 0.7 but for rounding, whose square root would be seen.
        assert_eq!(triangle(0.5, 0.2, 0.7).y, 0.0);
    }
}
