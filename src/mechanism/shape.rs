use crate::geometry::{Point, Vector, cross, unit};
use crate::scene::{Length, Link, Shape};

/// The coordinates of a link's points in its own frame: origin in the first point, x axis towards the second, unless
/// the link has a shape of its own.
///
/// `approximate` gives rough places in the fixed frame, which decide on which side of the axis the third point of a
/// triangle lies. The second value is true if they do not, and the counter-clockwise side was taken.
pub(super) fn local_points(link: &Link, approximate: impl Fn(&str) -> Option<Point>) -> (Vec<Point>, bool) {
    match &link.shape {
        Shape::Bare => (vec![Point::origin(); link.points.len()], false),
        Shape::Local(places) => {
            let at = |name: &String| places.get(name).map_or_else(Point::origin, |&p| p.into());
            (link.points.iter().map(at).collect(), false)
        }
        Shape::Lengths(lengths) => match link.points.as_slice() {
            [a, b] => (vec![Point::origin(), Point::new(length_between(lengths, a, b), 0.0)], false),
            [a, b, c] => {
                let rough = [a, b, c].map(|name| approximate(name));
                let area = match rough {
                    [Some(a), Some(b), Some(c)] => Some(cross(b - a, c - a)),
                    _ => None,
                };
                let [ab, ac, bc] = [(a, b), (a, c), (b, c)].map(|(p, q)| length_between(lengths, p, q));
                let third = triangle(ab, ac, bc);
                let side = if area.is_some_and(|area| area < 0.0) { -1.0 } else { 1.0 };
                let points = vec![Point::origin(), Point::new(ab, 0.0), Point::new(third.x, side * third.y)];
                let is_straight = third.y == 0.0;
                (points, area.is_none() && !is_straight)
            }
            more => (vec![Point::origin(); more.len()], false),
        },
    }
}

/// The given length between two points, which a checked scene has.
fn length_between(lengths: &[Length], a: &str, b: &str) -> f64 {
    lengths.iter().find(|l| (l.from == a && l.to == b) || (l.from == b && l.to == a)).map_or(0.0, |l| l.value)
}

/// Relative tolerance of three lengths that add up, in parts of the longest: within it the link is straight.
const STRAIGHT: f64 = 1e-12;

/// The third corner, at y ≥ 0, of a triangle with base `ab` on the x axis and sides `ac`, `bc`.
///
/// Sums and differences come before products, and the height from Kahan's stable form of Heron's formula (W. Kahan,
/// *Miscalculating Area and Angles of a Needle-like Triangle*, 2014). Lengths that fail to close by rounding only make
/// a straight link.
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

/// The unit vector along `v`, which is not zero in a checked scene.
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
        // 0.5 + 0.2 differs from 0.7 by rounding, of which the height would be the square root.
        assert_eq!(triangle(0.5, 0.2, 0.7).y, 0.0);
    }
}
