use kurbo::{Point, Rect, Vec2};

use super::shape::{Shape, around, on_circle};

/// Largest length of a head over that of its vector, so that the length of a short vector remains visible.
const HEAD_SHARE: f64 = 0.5;
/// Half width of a head over its length: slim, as drawn with a ruling pen.
const HEAD_SLIMNESS: f64 = 0.17;
/// Distance of the notch between the barbs from the tip, over the length of the head.
const HEAD_NOTCH: f64 = 0.84;
/// Distance of the shaft's end from the tip, over the length of the head: inside the head, which hides the blunt end.
const SHAFT_END: f64 = 0.7;

/// The head of an arrow from `from` to `to`: tip, one barb, the notch where the shaft enters, the other barb; none for
/// an arrow of length zero or not finite.
///
/// It is `head` mm long, but at most half as long as the arrow.
pub fn arrow_head(from: Point, to: Point, head: f64) -> Option<[Point; 4]> {
    let (unit, length) = head_along(from, to, head)?;
    Some(head_at(to, unit, length))
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

impl Shape {
    /// The filled head of an [`Arrow`](Shape::Arrow) or [`ArcArrow`](Shape::ArcArrow): tip, barb,
    /// notch, barb; none for other shapes and for arrows without length.
    pub fn head(&self) -> Option<[Point; 4]> {
        match *self {
            Shape::Arrow { from, to, head } => arrow_head(from, to, head),
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
}
