//! Shapes and chains of lines cut off at the edge of an area; chains with no more points than the eye needs.

use super::shape::Shape;
use kurbo::{Point, Rect};

/// Whether a shape lies within `area`.
pub(super) fn is_within(area: Rect, shape: &Shape) -> bool {
    area.union(shape.drawn_box()) == area
}

/// Whether a point is in `area` or, up to rounding, on its border.
pub(super) fn holds(area: Rect, point: Point) -> bool {
    area.inflate(1e-9, 1e-9).contains(point)
}

/// The parts of a shape in `area`. Lines are cut at its border; an arrow whose tip is outside has its head there; round
/// shapes and texts are kept whole if their centre is inside, else dropped.
pub fn clipped(area: Rect, shape: Shape) -> Vec<Shape> {
    if is_within(area, &shape) {
        return vec![shape];
    }
    match &shape {
        Shape::Line(..) | Shape::Polyline(_) => {
            let within = shape.lines().into_iter().filter_map(|(a, b)| clipped_segment(area, a, b));
            within.map(|(a, b)| Shape::Line(a, b)).collect()
        }
        Shape::Arrow { from, to, head } => match clipped_segment(area, *from, *to) {
            Some((from, to)) => vec![Shape::Arrow { from, to, head: *head }],
            None => Vec::new(),
        },
        Shape::Polygon(corners) => {
            let corners = inside(area, corners);
            if corners.len() > 2 { vec![Shape::Polygon(corners)] } else { Vec::new() }
        }
        Shape::Area(chains) => {
            let chains = chains.iter().map(|corners| inside(area, corners)).filter(|corners| corners.len() > 2);
            vec![Shape::Area(chains.collect())]
        }
        Shape::Circle { .. } | Shape::Arc { .. } | Shape::ArcArrow { .. } | Shape::Text(_) => {
            holds(area, shape.bounds().center()).then_some(shape).into_iter().collect()
        }
    }
}

/// The part of the segment between two points that lies in `area`; `None` where it misses.
pub(crate) fn clipped_segment(area: Rect, a: Point, b: Point) -> Option<(Point, Point)> {
    let d = b - a;
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for (start, step, near, far) in [(a.x, d.x, area.x0, area.x1), (a.y, d.y, area.y0, area.y1)] {
        if step == 0.0 {
            if start < near || start > far {
                return None;
            }
        } else {
            let (enters, leaves) = ((near - start) / step, (far - start) / step);
            low = low.max(enters.min(leaves));
            high = high.min(enters.max(leaves));
        }
    }
    let share = |at: f64| ((a + d * at - a).dot(d) / d.hypot2()).clamp(0.0, 1.0);
    let (from, to) = (share(low), share(high));
    (low < high && low.is_finite() && high.is_finite() && from < to)
        .then(|| (within(area, a + d * from), within(area, a + d * to)))
}

/// A cut point, which is in the area but for rounding: of lines that begin 1e300 mm away that is all there is.
fn within(area: Rect, point: Point) -> Point {
    Point::new(point.x.max(area.x0).min(area.x1), point.y.max(area.y0).min(area.y1))
}

/// The part of a polygon in a box, edge by edge (Sutherland and Hodgman 1974).
fn inside(area: Rect, corners: &[Point]) -> Vec<Point> {
    // Distance of a point from each of the four edges, positive inside.
    let depths: [&dyn Fn(Point) -> f64; 4] =
        [&|p| p.x - area.x0, &|p| area.x1 - p.x, &|p| p.y - area.y0, &|p| area.y1 - p.y];
    let mut corners = corners.to_vec();
    for depth in depths {
        let mut kept = Vec::new();
        for (index, &b) in corners.iter().enumerate() {
            let a = corners[(index + corners.len() - 1) % corners.len()];
            let (from, to) = (depth(a), depth(b));
            if (from < 0.0) != (to < 0.0) {
                kept.push(a.lerp(b, from / (from - to)));
            }
            if to >= 0.0 {
                kept.push(b);
            }
        }
        corners = kept;
    }
    corners.into_iter().map(|corner| within(area, corner)).collect()
}

/// Largest distance of the drawn line from the samples, in mm.
pub const TOLERANCE: f64 = 0.012;

/// The parts of a chain of lines within an area.
pub fn clipped_chain(area: Rect, points: &[Point]) -> Vec<Vec<Point>> {
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
pub fn simplified(points: &[Point]) -> Vec<Point> {
    simplified_to(TOLERANCE, points)
}

/// The chain with fewer points, all points left out within a `tolerance` in mm of it (Douglas and Peucker, "Algorithms for the
/// Reduction of the Number of Points Required to Represent a Digitized Line", 1973).
pub(super) fn simplified_to(tolerance: f64, points: &[Point]) -> Vec<Point> {
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
pub fn distance(p: Point, a: Point, b: Point) -> f64 {
    let along = b - a;
    let size = along.hypot2();
    let share = if size > 0.0 { ((p - a).dot(along) / size).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + along * share)).hypot2().sqrt()
}
