//! Springs: zigzags between their ends, as long as they are in this position.

use super::on_paper::SchemeOnPaper;
use super::sliders::pivot;
use crate::construction::display;
use crate::drawing::canvas::Canvas;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::view::towards;
use crate::forces::spring_ends;
use crate::mechanism::GROUND;
use kurbo::{Point, Vec2};

/// Strokes of the zigzag, and half its width in mm.
const STROKES: usize = 9;
const HALF: f64 = 1.7;
/// The straight part at either end, in mm, and at most this part of the whole.
const STRAIGHT: f64 = 4.0;
const MOST_STRAIGHT: f64 = 0.25;
/// Ends closer than this to a point of the mechanism, in mm, are at that point.
const AT_POINT: f64 = 0.3;

/// What an end of a spring is fixed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::drawing) enum SpringEnd {
    /// A point of the mechanism, which is drawn by itself.
    Point,
    /// Another place of a link: an eye.
    Link,
    /// Another place of the frame: an eye on a pivot's foot.
    Ground,
}

impl SpringEnd {
    /// That of an end at a place of a body with these points.
    pub(in crate::drawing) fn at(place: Point, mut points: impl Iterator<Item = Point>, is_ground: bool) -> SpringEnd {
        if points.any(|point| (point - place).hypot() < AT_POINT) {
            return SpringEnd::Point;
        }
        if is_ground { SpringEnd::Ground } else { SpringEnd::Link }
    }
}

/// Draws a spring between two places.
pub(in crate::drawing) fn spring(canvas: &mut Canvas<'_>, name: &str, ends: [(Point, SpringEnd); 2]) {
    canvas.draw_named(name, Pen::Slider, Shape::Polyline(zigzag(ends.map(|(at, _)| at))));
    for (center, end) in ends {
        if end == SpringEnd::Ground {
            pivot(canvas, center, Vec2::new(0.0, 1.0));
        }
        if end != SpringEnd::Point {
            canvas.draw(Pen::Joint, Shape::Circle { center, radius: canvas.dims.joint });
        }
    }
}

impl SchemeOnPaper<'_> {
    /// Draws the springs; their names where no force of theirs has one.
    pub(super) fn springs(&self, canvas: &mut Canvas<'_>) {
        let Some(loads) = self.mechanism.loads.as_deref() else { return };
        canvas.step = 0;
        let has_forces = self.context.construction().forces.is_some();
        for (own, ends) in loads.0.springs.iter().zip(spring_ends(self.mechanism, self.pose)) {
            let ends = ends.map(|(body, place)| {
                let at = self.view.at(place);
                let points = self.mechanism.body(body).points.iter().map(|&point| self.at(point));
                (at, SpringEnd::at(at, points, body == GROUND))
            });
            spring(canvas, &format!("spring-{}", own.name), ends);
            if !has_forces {
                let [from, to] = ends.map(|(at, _)| at);
                let along = towards(from, to, Vec2::new(1.0, 0.0));
                let beside = Some(Vec2::new(-along.y, along.x));
                canvas.label(&own.name, &display(&own.name), from.midpoint(to), HALF + 0.8, beside, 2);
            }
        }
    }
}

/// The corners of a spring between two places.
fn zigzag([from, to]: [Point; 2]) -> Vec<Point> {
    let whole = (to - from).hypot();
    let along = towards(from, to, Vec2::new(1.0, 0.0));
    let across = Vec2::new(-along.y, along.x) * HALF;
    let straight = STRAIGHT.min(MOST_STRAIGHT * whole);
    let stroke = (whole - 2.0 * straight) / STROKES as f64;
    let turns = (0..STROKES).map(|index| {
        let side = if index % 2 == 0 { across } else { -across };
        from + along * (straight + (index as f64 + 0.5) * stroke) + side
    });
    [from, from + along * straight].into_iter().chain(turns).chain([to - along * straight, to]).collect()
}
