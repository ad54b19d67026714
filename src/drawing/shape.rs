//! The geometry of marks, and what labels ask of it.

use kurbo::{Point, Rect, Vec2};

use super::text::PlacedText;

/// Largest length of a head over that of its vector, so that the length of a short vector remains visible.
const HEAD_SHARE: f64 = 0.5;
/// Half width of a head over its length: slim, as drawn with a ruling pen.
const HEAD_SLIMNESS: f64 = 0.17;
/// Distance of the notch between the barbs from the tip, over the length of the head.
const HEAD_NOTCH: f64 = 0.84;
/// Distance of the shaft's end from the tip, over the length of the head: inside the head, which hides the blunt end.
const SHAFT_END: f64 = 0.7;

/// Distance from the sheet's corner, in mm, from which nothing is drawn: no sheet is a kilometre long, and what reckons with
/// 24 binary digits, as renderers do, fails far beyond.
const FARTHEST: f64 = 1e6;

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
    /// A rectangle, as a closed chain of its sides.
    pub(super) fn rectangle(area: Rect) -> Shape {
        Shape::Polygon(corners(area).to_vec())
    }

    /// The points that part an arc into so many equal parts, with its ends; none for other shapes.
    fn on_arc(&self, parts: u8) -> Option<Vec<Point>> {
        let (Shape::Arc { center, radius, start, sweep } | Shape::ArcArrow { center, radius, start, sweep, .. }) =
            *self
        else {
            return None;
        };
        let at = |part: u8| on_circle(center, radius, start + sweep * f64::from(part) / f64::from(parts));
        Some((0..=parts).map(at).collect())
    }

    /// The filled head of an [`Arrow`](Shape::Arrow) or [`ArcArrow`](Shape::ArcArrow): tip, one barb, the notch where the
    /// shaft enters, the other barb; none for other shapes and for arrows whose length is zero or not finite.
    ///
    /// It is `head` mm long, but at most half as long as the arrow.
    pub fn head(&self) -> Option<[Point; 4]> {
        match *self {
            Shape::Arrow { from, to, head } => {
                let (unit, length) = head_along(from, to, head)?;
                Some(head_at(to, unit, length))
            }
            Shape::ArcArrow { center, radius, start, sweep, head } => {
                let run = (radius * sweep).abs();
                if !(run > 0.0 && run.is_finite()) {
                    return None;
                }
                let length = head_length(run, head);
                // The straight head is a chord of its arc: both its ends lie on the circle.
                let end = start + sweep;
                let tip = on_circle(center, radius, end);
                let back = on_circle(center, radius, end - (length / radius.abs()).copysign(sweep));
                let (unit, _) = head_along(back, tip, head)?;
                Some(head_at(tip, unit, length))
            }
            _ => None,
        }
    }

    /// The line of an arrow, which ends inside its head: a [`Line`](Shape::Line) or an [`Arc`](Shape::Arc); none where
    /// there is no head.
    pub fn shaft(&self) -> Option<Self> {
        match *self {
            Shape::Arrow { from, to, head } => {
                let (unit, length) = head_along(from, to, head)?;
                Some(Shape::Line(from, to - unit * (SHAFT_END * length)))
            }
            Shape::ArcArrow { center, radius, start, sweep, head } => {
                self.head()?;
                let covered = SHAFT_END * head_length((radius * sweep).abs(), head) / radius.abs();
                Some(Shape::Arc { center, radius, start, sweep: sweep - covered.copysign(sweep) })
            }
            _ => None,
        }
    }

    /// The bounding box of the arrowhead; none where [`head`](Shape::head) gives none.
    pub fn head_box(&self) -> Option<Rect> {
        self.head().map(|corners| around(&corners))
    }

    /// The bounding box in mm, without the width of lines; for an arc that of its whole circle.
    ///
    /// A chain without points gives an empty box at the origin.
    pub fn bounds(&self) -> Rect {
        match self {
            Shape::Line(a, b) => Rect::from_points(*a, *b),
            Shape::Polyline(points) | Shape::Polygon(points) => around(points),
            Shape::Area(chains) => around(&chains.concat()),
            Shape::Circle { center, radius }
            | Shape::Arc { center, radius, .. }
            | Shape::ArcArrow { center, radius, .. } => Rect::from_center_size(*center, (2.0 * radius, 2.0 * radius)),
            Shape::Arrow { from, to, .. } => self.with_head(Rect::from_points(*from, *to)),
            Shape::Text(text) => text.ink_box(),
        }
    }

    /// The bounding box of what is drawn, in mm, without the width of lines: for an arc that of the arc itself, exact
    /// to a hundredth of its radius.
    pub fn drawn_box(&self) -> Rect {
        self.on_arc(64).map_or_else(|| self.bounds(), |points| self.with_head(around(&points)))
    }

    /// A box and the arrowhead, if there is one.
    fn with_head(&self, line: Rect) -> Rect {
        self.head_box().map_or(line, |head| line.union(head))
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
            Shape::Arc { .. } | Shape::ArcArrow { .. } => chain(&self.on_arc(8).unwrap_or_default()),
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
                let head = self.head_box().is_some_and(|head| head.overlaps(area));
                head || self.lines().into_iter().any(|(a, b)| crosses(a, b, area))
            }
        }
    }

    /// Whether all its numbers are such as readers of our files reckon with, and a text has letters; formats leave out all
    /// other marks.
    pub fn is_drawable(&self) -> bool {
        // A NaN gives false.
        let is_near = |length: f64| length.abs() < FARTHEST;
        let is_there = |point: &Point| is_near(point.x) && is_near(point.y);
        match self {
            Shape::Line(a, b) | Shape::Arrow { from: a, to: b, .. } => is_there(a) && is_there(b),
            Shape::Polyline(points) | Shape::Polygon(points) => points.iter().all(is_there),
            Shape::Area(chains) => chains.iter().flatten().all(is_there),
            Shape::Circle { center, radius } => is_there(center) && is_near(*radius),
            Shape::Arc { center, radius, start, sweep } | Shape::ArcArrow { center, radius, start, sweep, .. } => {
                is_there(center) && is_near(*radius) && start.is_finite() && sweep.is_finite()
            }
            Shape::Text(text) => is_there(&text.origin) && is_near(text.size) && !text.text.runs().is_empty(),
        }
    }
}

/// The point of a circle at an angle.
fn on_circle(center: Point, radius: f64, angle: f64) -> Point {
    center + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius
}

/// Unit vector of an arrow and the length of its head; none for a length that is zero or not finite.
fn head_along(from: Point, to: Point, head: f64) -> Option<(Vec2, f64)> {
    let along = to - from;
    let size = along.hypot2().sqrt();
    // A NaN length gives false.
    (size > 0.0 && size.is_finite()).then(|| (along / size, head_length(size, head)))
}

fn head_length(arrow: f64, head: f64) -> f64 {
    head.min(HEAD_SHARE * arrow)
}

/// A head of the given length with its tip at `tip`, in the direction of `unit`.
fn head_at(tip: Point, unit: Vec2, length: f64) -> [Point; 4] {
    let across = Vec2::new(-unit.y, unit.x) * (HEAD_SLIMNESS * length);
    let back = tip - unit * length;
    [tip, back + across, tip - unit * (HEAD_NOTCH * length), back - across]
}

/// Whether a line crosses a box: their projections overlap on both axes, and the box has corners on both sides.
fn crosses(a: Point, b: Point, area: Rect) -> bool {
    let along = b - a;
    let sides = [area.x0, area.x1].map(|x| [area.y0, area.y1].map(|y| along.cross(Point::new(x, y) - a)));
    let (some_left, some_right) =
        (sides.as_flattened().iter().any(|&side| side >= 0.0), sides.as_flattened().iter().any(|&side| side <= 0.0));
    Rect::from_points(a, b).overlaps(area) && some_left && some_right
}

/// The distance of a point from a box; 0 inside.
pub(super) fn distance_to_box(area: Rect, point: Point) -> f64 {
    let x = (area.x0 - point.x).max(point.x - area.x1).max(0.0);
    let y = (area.y0 - point.y).max(point.y - area.y1).max(0.0);
    (x * x + y * y).sqrt()
}

/// Whether two lines cross; touching ends do not count.
pub(super) fn crosses_line((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let turn = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}

/// The bounding box of some points.
pub(super) fn around(points: &[Point]) -> Rect {
    let Some(&first) = points.first() else {
        return Rect::ZERO;
    };
    points.iter().fold(Rect::from_points(first, first), |all, &point| all.union_pt(point))
}

/// The corners of a box, in order around it.
pub(super) fn corners(r: Rect) -> [Point; 4] {
    [(r.x0, r.y0), (r.x1, r.y0), (r.x1, r.y1), (r.x0, r.y1)].map(Point::from)
}
