use kurbo::{Point, Rect, Vec2};

use super::look::look;
use super::text::PlacedText;

/// A sheet of paper and everything drawn on it; later marks cover earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width of the sheet in mm.
    pub width: f64,
    /// Height of the sheet in mm.
    pub height: f64,
    /// What the figure is called; written into the file, not drawn.
    pub title: String,
    /// What the figure shows, in a sentence for readers who cannot see it; written into the file,
    /// not drawn.
    pub description: String,
    /// Everything drawn, in drawing order.
    pub marks: Vec<Mark>,
}

impl Drawing {
    /// An empty sheet of `width` by `height` mm.
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            title: String::new(),
            description: String::new(),
            marks: Vec::new(),
        }
    }

    /// Draws a nameless mark on top of the others.
    pub fn draw(&mut self, pen: Pen, shape: Shape) {
        self.marks.push(Mark {
            id: None,
            pen,
            shape,
        });
    }

    /// Draws a mark that slide programs and scripts can find by `id`.
    pub fn draw_named(&mut self, id: impl Into<String>, pen: Pen, shape: Shape) {
        self.marks.push(Mark {
            id: Some(id.into()),
            pen,
            shape,
        });
    }
}

impl Drawing {
    /// For each mark, whether it is a text that needs its halo: one with lines of earlier marks
    /// running through it.
    ///
    /// Over blank paper a halo is not seen, and over a tinted area it would be a stain.
    pub fn halos(&self) -> Vec<bool> {
        let bounds: Vec<Rect> = self.marks.iter().map(|mark| mark.shape.bounds()).collect();
        let needs = self.marks.iter().enumerate().map(|(index, mark)| {
            let halo = look(mark.pen).halo;
            let Shape::Text(text) = &mark.shape else {
                return false;
            };
            let area = text.ink_box().inflate(0.5 * halo, 0.5 * halo);
            let below = self.marks[..index].iter().zip(&bounds);
            halo > 0.0
                && below.into_iter().any(|(other, bounds)| {
                    overlap(*bounds, area)
                        && look(other.pen).stroke.is_some()
                        && other.shape.lines_cross(area)
                })
        });
        needs.collect()
    }
}

/// Whether two boxes have a point in common.
fn overlap(a: Rect, b: Rect) -> bool {
    a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1
}

/// One thing drawn on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// A stable name such as `point-S3`, unique in its drawing, or none.
    pub id: Option<String>,
    /// What the mark is; its look follows from that.
    pub pen: Pen,
    /// Where it is.
    pub shape: Shape,
}

/// What a mark *is*. Colour, width, dash and fill come from [`look`](super::look()), so a figure is
/// restyled in one place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Pen {
    /// The border of a panel, axes, the bar of a scale.
    Frame,
    /// The line of the frame that a pivot or a guide stands on.
    Ground,
    /// The short strokes under a ground line.
    Hatch,
    /// A link drawn as a line, or the outline of one drawn as an area.
    Link,
    /// The tinted area of a link; the number picks the tint (four of them, repeating).
    LinkFill(u8),
    /// A sliding block: outlined and white inside.
    Slider,
    /// The straight guide that a block slides on.
    Guide,
    /// A revolute joint: a small circle, white inside.
    Joint,
    /// The path of a point over a cycle.
    Trace,
    /// A helping line: thin, grey, dashed.
    Construction,
    /// A line of known direction in a plan: thin, coloured, dash-dotted.
    Ray,
    /// A vector that is neither of the kinds below.
    Vector,
    /// A velocity.
    Velocity,
    /// A total acceleration.
    Acceleration,
    /// A normal part of an acceleration, known before the plan is closed.
    Normal,
    /// A tangential part, found by closing the plan.
    Tangential,
    /// A Coriolis part.
    Coriolis,
    /// The pole of a plan.
    Pole,
    /// The outline of the image of a link in a plan.
    Image,
    /// The area of such an image.
    ImageFill,
    /// The end of a vector in a plan, the image of a point: a small dot.
    ImagePoint,
    /// A special (Assur) point and what belongs to it.
    Special,
    /// The sense of turning: curved arrows of ω and α.
    Turning,
    /// The line from a label to what it names when it had to stand apart.
    Leader,
    /// The name of a point, a link or a vector; haloed, so that it reads across lines.
    Label,
    /// Running text: scales, equations, captions.
    Caption,
    /// The heading of a panel or a sheet.
    Heading,
}

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
        /// Where the arc starts.
        start: f64,
        /// How far it runs, signed.
        sweep: f64,
    },
    /// Part of a circle with an arrowhead at its end: the sense of a rotation.
    ArcArrow {
        /// The circle's centre.
        center: Point,
        /// The circle's radius in mm.
        radius: f64,
        /// Where the arc starts.
        start: f64,
        /// How far it runs, signed; the head is at the end.
        sweep: f64,
    },
    /// A vector: a straight line with a slim filled head at its end.
    Arrow {
        /// Its tail.
        from: Point,
        /// Its tip.
        to: Point,
    },
    /// A line of text.
    Text(PlacedText),
}

/// Length of an arrowhead in mm where its vector leaves room for it.
const HEAD_LENGTH: f64 = 2.6;
/// Longest share of its vector that a head may take, so that a head never hides how long a short
/// vector is.
const HEAD_SHARE: f64 = 0.5;
/// Half width of a head over its length: slim, as drawn with a ruling pen.
const HEAD_SLIMNESS: f64 = 0.17;
/// Where the notch between the barbs is, from the tip, over the length of the head.
const HEAD_NOTCH: f64 = 0.84;
/// Where the shaft ends, from the tip, over the length of the head: inside the head, so that its
/// blunt end never shows.
const SHAFT_END: f64 = 0.7;

/// The head of an arrow from `from` to `to`: tip, one barb, the notch where the shaft enters, the
/// other barb; none for an arrow without length.
///
/// The head is `min(2.6 mm, half the arrow)` long.
pub fn arrow_head(from: Point, to: Point) -> Option<[Point; 4]> {
    let (unit, length) = head_along(from, to)?;
    Some(head_at(to, unit, length))
}

/// The direction of an arrow and the length of its head.
fn head_along(from: Point, to: Point) -> Option<(Vec2, f64)> {
    let along = to - from;
    let size = along.hypot2().sqrt();
    // Written so that a NaN has no head either.
    (size > 0.0 && size.is_finite()).then(|| (along / size, head_length(size)))
}

fn head_length(arrow: f64) -> f64 {
    HEAD_LENGTH.min(HEAD_SHARE * arrow)
}

/// A head of the given length whose tip is at `tip` and which points along `unit`.
fn head_at(tip: Point, unit: Vec2, length: f64) -> [Point; 4] {
    let across = Vec2::new(-unit.y, unit.x) * (HEAD_SLIMNESS * length);
    let back = tip - unit * length;
    [
        tip,
        back + across,
        tip - unit * (HEAD_NOTCH * length),
        back - across,
    ]
}

/// The point of a circle at an angle.
fn on_circle(center: Point, radius: f64, angle: f64) -> Point {
    center + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius
}

impl Shape {
    /// The filled head of an [`Arrow`](Shape::Arrow) or [`ArcArrow`](Shape::ArcArrow): tip, barb,
    /// notch, barb; none for other shapes and for arrows without length.
    pub fn head(&self) -> Option<[Point; 4]> {
        match *self {
            Shape::Arrow { from, to } => arrow_head(from, to),
            Shape::ArcArrow {
                center,
                radius,
                start,
                sweep,
            } => {
                let run = (radius * sweep).abs();
                if !(run > 0.0 && run.is_finite()) {
                    return None;
                }
                let length = head_length(run);
                // The head is straight and lies along the chord of the arc it covers, so that both
                // its ends are on the circle.
                let end = start + sweep;
                let tip = on_circle(center, radius, end);
                let back = on_circle(
                    center,
                    radius,
                    end - (length / radius.abs()).copysign(sweep),
                );
                let (unit, _) = head_along(back, tip)?;
                Some(head_at(tip, unit, length))
            }
            _ => None,
        }
    }

    /// The line of an arrow as it is drawn, ending inside its head: a [`Line`](Shape::Line) or an
    /// [`Arc`](Shape::Arc); none where there is no head.
    pub fn shaft(&self) -> Option<Self> {
        match *self {
            Shape::Arrow { from, to } => {
                let (unit, length) = head_along(from, to)?;
                Some(Shape::Line(from, to - unit * (SHAFT_END * length)))
            }
            Shape::ArcArrow {
                center,
                radius,
                start,
                sweep,
            } => {
                self.head()?;
                let covered = SHAFT_END * head_length((radius * sweep).abs()) / radius.abs();
                Some(Shape::Arc {
                    center,
                    radius,
                    start,
                    sweep: sweep - covered.copysign(sweep),
                })
            }
            _ => None,
        }
    }

    /// The box around the arrowhead, for keeping labels off it; none where [`head`](Shape::head)
    /// gives none.
    pub fn head_box(&self) -> Option<Rect> {
        self.head().map(|corners| around(&corners))
    }

    /// Where the arc of an [`Arc`](Shape::Arc) or [`ArcArrow`](Shape::ArcArrow) starts and ends;
    /// none for other shapes.
    pub fn ends_of_arc(&self) -> Option<(Point, Point)> {
        match *self {
            Shape::Arc {
                center,
                radius,
                start,
                sweep,
            }
            | Shape::ArcArrow {
                center,
                radius,
                start,
                sweep,
            } => Some((
                on_circle(center, radius, start),
                on_circle(center, radius, start + sweep),
            )),
            _ => None,
        }
    }

    /// The box around the shape in mm, without the width of its line; for an arc that of its whole
    /// circle.
    ///
    /// A chain without points gives an empty box at the origin.
    pub fn bounds(&self) -> Rect {
        match self {
            Shape::Line(a, b) => Rect::from_points(*a, *b),
            Shape::Polyline(points) | Shape::Polygon(points) => around(points),
            Shape::Circle { center, radius }
            | Shape::Arc { center, radius, .. }
            | Shape::ArcArrow { center, radius, .. } => {
                Rect::from_center_size(*center, (2.0 * radius, 2.0 * radius))
            }
            Shape::Arrow { from, to } => {
                let line = Rect::from_points(*from, *to);
                self.head_box().map_or(line, |head| line.union(head))
            }
            Shape::Text(text) => text.ink_box(),
        }
    }

    /// The box around what is drawn of the shape, in mm, without the width of its line: for an arc
    /// that of its own stretch of the circle, to a hundredth of its radius.
    pub fn drawn_box(&self) -> Rect {
        const PARTS: u8 = 64;
        match *self {
            Self::Arc {
                center,
                radius,
                start,
                sweep,
            }
            | Self::ArcArrow {
                center,
                radius,
                start,
                sweep,
            } => {
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

    /// Whether the lines of the shape come through a box; for an arc those of its whole circle, and
    /// no line of a text does.
    fn lines_cross(&self, area: Rect) -> bool {
        let through = |a: Point, b: Point| crosses(a, b, area);
        match self {
            Shape::Line(a, b) | Shape::Arrow { from: a, to: b } => {
                through(*a, *b) || self.head_box().is_some_and(|head| overlap(head, area))
            }
            Shape::Polyline(points) => points.windows(2).any(|ends| through(ends[0], ends[1])),
            Shape::Polygon(points) => {
                let next = points.iter().cycle().skip(1);
                points.iter().zip(next).any(|(a, b)| through(*a, *b))
            }
            Shape::Circle { center, radius }
            | Shape::Arc { center, radius, .. }
            | Shape::ArcArrow { center, radius, .. } => {
                let nearest = Point::new(
                    center.x.max(area.x0).min(area.x1),
                    center.y.max(area.y0).min(area.y1),
                );
                let farthest = Vec2::new(
                    (center.x - area.x0).abs().max((center.x - area.x1).abs()),
                    (center.y - area.y0).abs().max((center.y - area.y1).abs()),
                );
                (nearest - *center).hypot2() <= radius * radius
                    && radius * radius <= farthest.hypot2()
            }
            Shape::Text(_) => false,
        }
    }

    /// Whether every number of the shape is finite; a format leaves out a mark whose shape is not.
    pub fn is_finite(&self) -> bool {
        match self {
            Shape::Line(a, b) | Shape::Arrow { from: a, to: b } => a.is_finite() && b.is_finite(),
            Shape::Polyline(points) | Shape::Polygon(points) => {
                points.iter().all(|point| point.is_finite())
            }
            Shape::Circle { center, radius } => center.is_finite() && radius.is_finite(),
            Shape::Arc {
                center,
                radius,
                start,
                sweep,
            }
            | Shape::ArcArrow {
                center,
                radius,
                start,
                sweep,
            } => center.is_finite() && radius.is_finite() && start.is_finite() && sweep.is_finite(),
            Shape::Text(text) => text.origin.is_finite() && text.size.is_finite(),
        }
    }
}

/// Whether a line comes through a box: their shadows overlap on both axes and across the line.
fn crosses(a: Point, b: Point, area: Rect) -> bool {
    let along = b - a;
    let sides =
        [area.x0, area.x1].map(|x| [area.y0, area.y1].map(|y| along.cross(Point::new(x, y) - a)));
    let (some_left, some_right) = (
        sides.as_flattened().iter().any(|&side| side >= 0.0),
        sides.as_flattened().iter().any(|&side| side <= 0.0),
    );
    overlap(Rect::from_points(a, b), area) && some_left && some_right
}

/// The smallest box around some points.
fn around(points: &[Point]) -> Rect {
    let Some(&first) = points.first() else {
        return Rect::ZERO;
    };
    points
        .iter()
        .fold(Rect::from_points(first, first), |all, &point| {
            all.union_pt(point)
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::RichText;

    #[test]
    fn heads_are_shorter_than_their_vectors() {
        for size in [1e-6, 0.01, 0.3, 1.0, 2.0, 5.2, 5.3, 40.0, 1e4] {
            for turn in 0..12 {
                let angle = f64::from(turn) * 0.55;
                let from = Point::new(20.0, 30.0);
                let to = on_circle(from, size, angle);
                let [tip, left, notch, right] = arrow_head(from, to).expect("the arrow has length");
                assert_eq!(tip, to);
                let unit = (to - from) / size;
                for corner in [left, notch, right] {
                    let back = (to - corner).dot(unit);
                    assert!(
                        back > 0.0 && back <= 0.5001 * size && back <= 2.6001,
                        "{back} of {size}"
                    );
                }
                let Some(Shape::Line(start, end)) = (Shape::Arrow { from, to }).shaft() else {
                    panic!("no shaft")
                };
                assert_eq!(start, from);
                assert!((end - from).hypot2() < size * size);
            }
        }
        assert_eq!(arrow_head(Point::new(1.0, 1.0), Point::new(1.0, 1.0)), None);
        assert_eq!(
            arrow_head(Point::new(f64::NAN, 1.0), Point::new(1.0, 1.0)),
            None
        );
    }

    #[test]
    fn heads_of_arcs_point_along_them() {
        for sweep in [2.0, -2.0, 0.1, -5.0] {
            let arrow = Shape::ArcArrow {
                center: Point::new(5.0, 5.0),
                radius: 8.0,
                start: 0.3,
                sweep,
            };
            let [tip, .., right] = arrow.head().expect("the arc has length");
            let (_, end) = arrow.ends_of_arc().expect("it is an arc");
            assert!((tip - end).hypot2() < 1e-20);
            let tangent =
                Vec2::new(-libm::sin(0.3 + sweep), libm::cos(0.3 + sweep)) * sweep.signum();
            assert!((tip - right).dot(tangent) > 0.0);
            assert!(
                matches!(arrow.shaft(), Some(Shape::Arc { sweep: less, .. }) if less.abs() < sweep.abs() && less * sweep > 0.0)
            );
        }
        let none = Shape::ArcArrow {
            center: Point::ORIGIN,
            radius: 8.0,
            start: 0.3,
            sweep: 0.0,
        };
        assert_eq!((none.head(), none.shaft()), (None, None));
    }

    #[test]
    fn halos_only_where_lines_run_through() {
        let mut drawing = Drawing::new(100.0, 100.0);
        let text = |x, y| {
            Shape::Text(PlacedText::new(
                RichText::math("S_3"),
                4.0,
                Point::new(x, y),
            ))
        };
        drawing.draw(
            Pen::Link,
            Shape::Line(Point::new(0.0, 0.0), Point::new(100.0, 100.0)),
        );
        drawing.draw(
            Pen::LinkFill(0),
            Shape::Polygon(vec![
                Point::new(60.0, 0.0),
                Point::new(90.0, 0.0),
                Point::new(75.0, 40.0),
            ]),
        );
        drawing.draw(
            Pen::Joint,
            Shape::Circle {
                center: Point::new(20.0, 80.0),
                radius: 10.0,
            },
        );
        drawing.draw(Pen::Label, text(50.0, 51.0));
        drawing.draw(Pen::Label, text(10.0, 51.0));
        drawing.draw(Pen::Label, text(59.0, 1.0));
        drawing.draw(Pen::Label, text(29.0, 81.0));
        drawing.draw(Pen::Label, text(18.0, 81.0));
        drawing.draw(Pen::Caption, text(50.0, 51.0));
        drawing.draw(
            Pen::Link,
            Shape::Line(Point::new(0.0, 51.0), Point::new(30.0, 51.0)),
        );
        assert_eq!(
            drawing.halos()[3..9],
            [true, false, false, true, false, false]
        );
    }

    #[test]
    fn numbers_that_are_not_finite_do_no_harm() {
        let mut drawing = Drawing::new(f64::NAN, -1.0);
        for wrong in [f64::NAN, f64::INFINITY, -3.0] {
            let (center, radius) = (Point::new(wrong, 1.0), wrong);
            drawing.draw(Pen::Joint, Shape::Circle { center, radius });
            drawing.draw(
                Pen::Turning,
                Shape::ArcArrow {
                    center,
                    radius,
                    start: wrong,
                    sweep: wrong,
                },
            );
            drawing.draw(
                Pen::Velocity,
                Shape::Arrow {
                    from: center,
                    to: Point::ORIGIN,
                },
            );
            drawing.draw(Pen::Link, Shape::Polygon(vec![]));
            let text = PlacedText::new(RichText::math("S_3"), wrong, center);
            drawing.draw(Pen::Label, Shape::Text(text));
        }
        assert_eq!(drawing.halos().len(), drawing.marks.len());
        assert!(!crate::format::svg(&drawing).contains("NaN"));
    }
}
