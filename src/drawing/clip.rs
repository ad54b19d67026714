//! Clipping of shapes to the area of a panel.

use super::shape::Shape;
use kurbo::{Point, Rect, Vec2};

/// Whether a shape lies within `area`.
pub(super) fn is_within(area: Rect, shape: &Shape) -> bool {
    area.union(shape.drawn_box()) == area
}

/// Whether a point is in `area` or, up to rounding, on its border.
pub(super) fn holds(area: Rect, point: Point) -> bool {
    area.inflate(1e-9, 1e-9).contains(point)
}

/// The parts of a shape in `area`. Lines are cut at its border; an arrow whose tip is outside becomes a line; round
/// shapes and texts are kept whole if their centre is inside, else dropped.
pub(super) fn clipped(area: Rect, shape: Shape) -> Vec<Shape> {
    if is_within(area, &shape) {
        return vec![shape];
    }
    let line = |a: &Point, b: &Point| {
        let within = clipped_segment(area, *a, *b);
        within.map(|(a, b)| Shape::Line(a, b))
    };
    match &shape {
        Shape::Line(a, b) => line(a, b).into_iter().collect(),
        Shape::Arrow { from, to, head } => match clipped_segment(area, *from, *to) {
            Some((from, tip)) if (tip - *to).hypot() < 1e-9 => vec![Shape::Arrow { from, to: *to, head: *head }],
            Some((a, b)) => vec![Shape::Line(a, b)],
            None => Vec::new(),
        },
        Shape::Polyline(points) => points.windows(2).filter_map(|ends| line(&ends[0], &ends[1])).collect(),
        Shape::Polygon(corners) => {
            let corners = inside(area, corners);
            let some = corners.len() > 2;
            some.then_some(Shape::Polygon(corners)).into_iter().collect()
        }
        Shape::Area(chains) => {
            let chains = chains.iter().map(|corners| inside(area, corners)).filter(|corners| corners.len() > 2);
            vec![Shape::Area(chains.collect())]
        }
        Shape::Circle { center, .. } | Shape::Arc { center, .. } | Shape::ArcArrow { center, .. } => {
            let middle = *center;
            holds(area, middle).then_some(shape).into_iter().collect()
        }
        Shape::Text(text) => {
            let middle = text.ink_box().center();
            holds(area, middle).then_some(shape).into_iter().collect()
        }
    }
}

/// The part of the line through `p` along `d` that lies in `area`, from the first to the last crossing of its border;
/// `None` where it misses.
fn line_in(area: Rect, p: Point, d: Vec2) -> Option<(Point, Point)> {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for (start, step, near, far) in [(p.x, d.x, area.x0, area.x1), (p.y, d.y, area.y0, area.y1)] {
        if step == 0.0 {
            if start < near || start > far {
                return None;
            }
        } else {
            let (a, b) = ((near - start) / step, (far - start) / step);
            low = low.max(a.min(b));
            high = high.min(a.max(b));
        }
    }
    (low < high && low.is_finite() && high.is_finite()).then(|| (p + d * low, p + d * high))
}

/// The part of the segment between two points that lies in `area`.
pub(super) fn clipped_segment(area: Rect, a: Point, b: Point) -> Option<(Point, Point)> {
    let d = b - a;
    let (p, q) = line_in(area, a, d)?;
    let size = d.hypot2();
    if size == 0.0 {
        return None;
    }
    let share = |x: Point| ((x - a).dot(d) / size).clamp(0.0, 1.0);
    let (from, to) = (share(p), share(q));
    (from < to).then(|| (a + d * from, a + d * to))
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
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Rect = Rect::new(0.0, 0.0, 10.0, 10.0);

    #[test]
    fn lines_and_arrows_end_at_the_edge() {
        let (a, b) = (Point::new(5.0, 5.0), Point::new(25.0, 5.0));
        let cut = vec![Shape::Line(a, Point::new(10.0, 5.0))];
        assert_eq!(clipped(AREA, Shape::Line(a, b)), cut);
        assert_eq!(clipped(AREA, Shape::Arrow { from: a, to: b, head: 2.6 }), cut);
        let back = clipped(AREA, Shape::Arrow { from: b, to: a, head: 2.6 });
        let from = Point::new(10.0, 5.0);
        assert_eq!(back, [Shape::Arrow { from, to: a, head: 2.6 }]);
        let away = Shape::Line(Point::new(11.0, 0.0), Point::new(12.0, 9.0));
        assert!(clipped(AREA, away).is_empty());
        let within = Shape::Line(a, Point::new(6.0, 6.0));
        assert_eq!(clipped(AREA, within.clone()), [within]);
    }

    #[test]
    fn polygons_keep_what_is_inside() {
        let corner = |x: f64, y: f64| Point::new(x, y);
        let triangle = vec![corner(5.0, 5.0), corner(15.0, 5.0), corner(5.0, 15.0)];
        let shapes = clipped(AREA, Shape::Polygon(triangle));
        let [Shape::Polygon(corners)] = shapes.as_slice() else {
            panic!("{shapes:?}");
        };
        // The square from (5, 5) to (10, 10), whose corner (10, 10) the long side just meets.
        for want in [corner(5.0, 5.0), corner(10.0, 5.0), corner(10.0, 10.0), corner(5.0, 10.0)] {
            let near = corners.iter().any(|c| (*c - want).hypot() < 1e-9);
            assert!(near, "{want:?} in {corners:?}");
        }
        let all = corners.iter().all(|c| AREA.inflate(1e-9, 1e-9).contains(*c));
        assert!(all, "{corners:?}");
    }
}
