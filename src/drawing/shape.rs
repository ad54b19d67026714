use kurbo::{Point, Rect, Vec2};

use super::text::PlacedText;

/// The geometry of a mark. Angles are in radians from +x towards +y, which is clockwise to the eye
/// because y points down.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A straight line.
    Line(Point, Point),
    /// An open chain of straight lines.
    Polyline(Vec<Point>),
    /// A closed chain of straight lines.
    Polygon(Vec<Point>),
    /// An area within closed chains of straight lines: holes run round the other way.
    Area(Vec<Vec<Point>>),
    /// A full circle.
    Circle {
        /// Its centre.
        center: Point,
        /// Its radius in mm.
        radius: f64,
    },
    /// Part of a circle.
    Arc {
        /// The circle's centre.
        center: Point,
        /// The circle's radius in mm.
        radius: f64,
        /// Angle of the arc's start.
        start: f64,
        /// Signed angle from start to end.
        sweep: f64,
    },
    /// Part of a circle with an arrowhead at its end: the sense of a rotation.
    ArcArrow {
        /// The circle's centre.
        center: Point,
        /// The circle's radius in mm.
        radius: f64,
        /// Angle of the arc's start.
        start: f64,
        /// Signed angle from start to end; the head is at the end.
        sweep: f64,
        /// Length of the head in mm; on a short arc the head is shorter.
        head: f64,
    },
    /// A vector: a straight line with a slim filled head at its end.
    Arrow {
        /// Its tail.
        from: Point,
        /// Its tip.
        to: Point,
        /// Length of the head in mm; on a short vector the head is shorter.
        head: f64,
    },
    /// A line of text.
    Text(PlacedText),
}

impl Shape {
    /// Start and end of an [`Arc`](Shape::Arc) or [`ArcArrow`](Shape::ArcArrow); none for other shapes.
    pub fn ends_of_arc(&self) -> Option<(Point, Point)> {
        match *self {
            Shape::Arc { center, radius, start, sweep } | Shape::ArcArrow { center, radius, start, sweep, .. } => {
                Some((on_circle(center, radius, start), on_circle(center, radius, start + sweep)))
            }
            _ => None,
        }
    }

    /// The bounding box in mm, without the width of lines; for an arc that of its whole circle.
    ///
    /// A chain without points gives an empty box at the origin.
    pub fn bounds(&self) -> Rect {
        match self {
            Shape::Line(a, b) => Rect::from_points(*a, *b),
            Shape::Polyline(points) | Shape::Polygon(points) => around(points),
            Shape::Area(chains) => around(chains.as_slice().concat().as_slice()),
            Shape::Circle { center, radius }
            | Shape::Arc { center, radius, .. }
            | Shape::ArcArrow { center, radius, .. } => Rect::from_center_size(*center, (2.0 * radius, 2.0 * radius)),
            Shape::Arrow { from, to, .. } => {
                let line = Rect::from_points(*from, *to);
                self.head_box().map_or(line, |head| line.union(head))
            }
            Shape::Text(text) => text.ink_box(),
        }
    }

    /// The bounding box of what is drawn, in mm, without the width of lines: for an arc that of the arc itself, exact
    /// to a hundredth of its radius.
    pub fn drawn_box(&self) -> Rect {
        const PARTS: u8 = 64;
        match *self {
            Self::Arc { center, radius, start, sweep } | Self::ArcArrow { center, radius, start, sweep, .. } => {
                let on = |part: u8| {
                    let share = f64::from(part) / f64::from(PARTS);
                    on_circle(center, radius, start + sweep * share)
                };
                let line = around(&std::array::from_fn::<Point, 65, _>(|part| on(part as u8)));
                self.head_box().map_or(line, |head| line.union(head))
            }
            _ => self.bounds(),
        }
    }

    /// Its straight lines; an arc as eight of them, none for a circle or a text.
    pub(super) fn lines(&self) -> Vec<(Point, Point)> {
        let chain = |points: &[Point]| points.windows(2).map(|ends| (ends[0], ends[1])).collect();
        let round = |points: &[Point]| {
            let mut lines: Vec<(Point, Point)> = chain(points);
            lines.extend(points.last().copied().zip(points.first().copied()));
            lines
        };
        match self {
            Shape::Line(a, b) | Shape::Arrow { from: a, to: b, .. } => vec![(*a, *b)],
            Shape::Polyline(points) => chain(points),
            Shape::Polygon(points) => round(points),
            Shape::Area(chains) => chains.iter().flat_map(|points| round(points)).collect(),
            &(Shape::Arc { center, radius, start, sweep } | Shape::ArcArrow { center, radius, start, sweep, .. }) => {
                let on = |part: u8| on_circle(center, radius, start + sweep * f64::from(part) / 8.0);
                chain(&(0..=8).map(on).collect::<Vec<_>>())
            }
            Shape::Circle { .. } | Shape::Text(_) => Vec::new(),
        }
    }

    /// Whether lines of the shape cross a box; for an arc those of its whole circle, false for a text.
    pub(super) fn lines_cross(&self, area: Rect) -> bool {
        match self {
            Shape::Circle { center, radius }
            | Shape::Arc { center, radius, .. }
            | Shape::ArcArrow { center, radius, .. } => {
                let nearest = Point::new(center.x.max(area.x0).min(area.x1), center.y.max(area.y0).min(area.y1));
                let farthest = Vec2::new(
                    (center.x - area.x0).abs().max((center.x - area.x1).abs()),
                    (center.y - area.y0).abs().max((center.y - area.y1).abs()),
                );
                (nearest - *center).hypot2() <= radius * radius && radius * radius <= farthest.hypot2()
            }
            _ => {
                let head = self.head_box().is_some_and(|head| overlap(head, area));
                head || self.lines().into_iter().any(|(a, b)| crosses(a, b, area))
            }
        }
    }

    /// Whether all its numbers are finite, and a text has letters; formats leave out all other marks.
    pub fn is_drawable(&self) -> bool {
        match self {
            Shape::Line(a, b) | Shape::Arrow { from: a, to: b, .. } => a.is_finite() && b.is_finite(),
            Shape::Polyline(points) | Shape::Polygon(points) => points.iter().all(|point| point.is_finite()),
            Shape::Area(chains) => chains.iter().flatten().all(|point| point.is_finite()),
            Shape::Circle { center, radius } => center.is_finite() && radius.is_finite(),
            Shape::Arc { center, radius, start, sweep } | Shape::ArcArrow { center, radius, start, sweep, .. } => {
                center.is_finite() && radius.is_finite() && start.is_finite() && sweep.is_finite()
            }
            Shape::Text(text) => text.origin.is_finite() && text.size.is_finite() && !text.text.runs().is_empty(),
        }
    }
}

/// The point of a circle at an angle.
pub(super) fn on_circle(center: Point, radius: f64, angle: f64) -> Point {
    center + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius
}

/// Whether two boxes have a point in common.
pub(super) fn overlap(a: Rect, b: Rect) -> bool {
    a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1
}

/// Whether a line crosses a box: their projections overlap on both axes, and the box has corners on both sides.
fn crosses(a: Point, b: Point, area: Rect) -> bool {
    let along = b - a;
    let sides = [area.x0, area.x1].map(|x| [area.y0, area.y1].map(|y| along.cross(Point::new(x, y) - a)));
    let (some_left, some_right) =
        (sides.as_flattened().iter().any(|&side| side >= 0.0), sides.as_flattened().iter().any(|&side| side <= 0.0));
    overlap(Rect::from_points(a, b), area) && some_left && some_right
}

/// The bounding box of some points.
pub(super) fn around(points: &[Point]) -> Rect {
    let Some(&first) = points.first() else {
        return Rect::ZERO;
    };
    points.iter().fold(Rect::from_points(first, first), |all, &point| all.union_pt(point))
}

/// The corners of a box, in order around it.
pub(super) fn corners(r: Rect) -> Vec<Point> {
    vec![Point::new(r.x0, r.y0), Point::new(r.x1, r.y0), Point::new(r.x1, r.y1), Point::new(r.x0, r.y1)]
}
