//! Chains of lines: cut off at a border, and with no more points than the eye needs.

use super::clip::clipped_segment;
use kurbo::{Point, Rect};

/// Largest distance of the drawn line from the samples, in mm.
const TOLERANCE: f64 = 0.012;

/// The parts of a chain of lines within an area.
pub(in crate::drawing) fn clipped_chain(area: Rect, points: &[Point]) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for ends in points.windows(2) {
        let whole = area.contains(ends[0]) && area.contains(ends[1]);
        let inside = if whole { Some((ends[0], ends[1])) } else { clipped_segment(area, ends[0], ends[1]) };
        let Some((a, b)) = inside else { continue };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&a) => part.push(b),
            _ => parts.push(vec![a, b]),
        }
    }
    parts
}

/// The chain with fewer points, within [`TOLERANCE`] of all points left out.
pub(in crate::drawing) fn simplified(points: &[Point]) -> Vec<Point> {
    simplified_to(TOLERANCE, points)
}

/// The chain with fewer points, all points left out within a `tolerance` in mm of it (Douglas and Peucker, "Algorithms for the
/// Reduction of the Number of Points Required to Represent a Digitized Line", 1973).
pub(in crate::drawing) fn simplified_to(tolerance: f64, points: &[Point]) -> Vec<Point> {
    let Some(last) = points.len().checked_sub(1).filter(|last| *last > 0) else {
        return points.to_vec();
    };
    let mut keep = vec![false; points.len()];
    (keep[0], keep[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let (a, b) = (points[from], points[to]);
        let away = |index: &usize| distance(points[*index], a, b);
        let furthest = (from + 1..to).max_by(|i, j| away(i).total_cmp(&away(j)));
        if let Some(middle) = furthest.filter(|i| away(i) > tolerance) {
            keep[middle] = true;
            open.extend([(from, middle), (middle, to)]);
        }
    }
    points.iter().zip(keep).filter(|(_, keep)| *keep).map(|(point, _)| *point).collect()
}

/// The distance of a point from the straight segment between two others.
pub(in crate::drawing) fn distance(p: Point, a: Point, b: Point) -> f64 {
    let along = b - a;
    let size = along.hypot2();
    let share = if size > 0.0 { ((p - a).dot(along) / size).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + along * share)).hypot2().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_are_cut_at_the_border() {
        let area = Rect::new(0.0, 0.0, 10.0, 10.0);
        let points = [(1.0, 5.0), (3.0, 15.0), (5.0, 5.0), (6.0, 5.0)].map(Point::from);
        let parts = clipped_chain(area, &points);
        let cut = [vec![(1.0, 5.0), (2.0, 10.0)], vec![(4.0, 10.0), (5.0, 5.0), (6.0, 5.0)]];
        let cut = cut.map(|part| part.into_iter().map(Point::from).collect::<Vec<_>>());
        assert_eq!(parts, cut);
    }

    #[test]
    fn what_is_left_out_is_not_seen() {
        let on = |k: i32| {
            let x = f64::from(k) / 10.0;
            Point::new(x, 20.0 * libm::sin(x / 10.0))
        };
        let points: Vec<Point> = (0..=2000).map(on).collect();
        let few = simplified(&points);
        assert!(few.len() < 400, "{}", few.len());
        for p in &points {
            let off = few.windows(2).map(|w| distance(*p, w[0], w[1]));
            assert!(off.fold(f64::INFINITY, f64::min) <= TOLERANCE);
        }
    }
}
