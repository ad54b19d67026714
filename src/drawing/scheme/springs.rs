//! Springs: zigzags between their ends, as long as they are in this position.

use super::on_paper::SchemeOnPaper;
use super::sliders::pivot;
use crate::construction::display;
use crate::drawing::canvas::Canvas;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::view::towards;
use crate::forces::spring_ends;
use crate::mechanism::{BodyId, GROUND};
use kurbo::{Point, Vec2};

/// Strokes of the zigzag, and half its width in mm.
const STROKES: usize = 9;
const HALF: f64 = 1.7;
/// The straight part at either end, in mm, and at most this part of the whole.
const STRAIGHT: f64 = 4.0;
const MOST_STRAIGHT: f64 = 0.25;
/// Ends closer than this to a point of the mechanism, in mm, are at that point.
const AT_POINT: f64 = 0.3;

impl SchemeOnPaper<'_> {
    /// Draws the springs; their names where no force of theirs has one.
    pub(super) fn springs(&self, canvas: &mut Canvas<'_>) {
        let Some(loads) = self.mechanism.loads.as_deref() else { return };
        canvas.step = 0;
        let has_forces = self.context.construction().forces.is_some();
        for (spring, ends) in loads.0.springs.iter().zip(spring_ends(self.mechanism, self.pose)) {
            let places = ends.map(|(_, place)| self.view.at(place));
            let zigzag = zigzag(places);
            canvas.draw_named(&format!("spring-{}", spring.name), Pen::Slider, Shape::Polyline(zigzag));
            for ((body, _), at) in ends.into_iter().zip(places) {
                self.spring_end(canvas, body, at);
            }
            if !has_forces {
                let along = towards(places[0], places[1], Vec2::new(1.0, 0.0));
                let beside = Some(Vec2::new(-along.y, along.x));
                let middle = places[0].midpoint(places[1]);
                canvas.label(&spring.name, &display(&spring.name), middle, HALF + 0.8, beside, 2);
            }
        }
    }

    /// The eye at an end that is at no point of the mechanism; on the frame with a pivot's foot.
    fn spring_end(&self, canvas: &mut Canvas<'_>, body: BodyId, at: Point) {
        let is_at_point = |point: &_| (self.at(*point) - at).hypot() < AT_POINT;
        if self.mechanism.body(body).points.iter().any(is_at_point) {
            return;
        }
        if body == GROUND {
            pivot(canvas, at, Vec2::new(0.0, 1.0));
        }
        canvas.draw(Pen::Joint, Shape::Circle { center: at, radius: self.dims().joint });
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
