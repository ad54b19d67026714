//! Special points and the cut lines that cross there.

use super::on_paper::SchemeOnPaper;
use super::sight::is_near;
use crate::construction::Special;
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::clipped_segment;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::view::{on_sheet, towards};
use crate::geometry::Place;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Vec2};

/// Number style of the distances of special points far away.
const DISTANCE: NumberStyle = NumberStyle::significant(4).in_full(-3, 6).on(Medium::Figure);

impl SchemeOnPaper<'_> {
    /// The cut lines of a special point, from their joints to it.
    pub(super) fn cuts(&self, canvas: &mut Canvas<'_>, special: &Special) {
        if !self.context.figure().construction.has_lines() {
            return;
        }
        let bounds = canvas.room();
        for cut in &special.cuts {
            let (Some(start), Some(direction)) = (cut.start(), cut.line.direction()) else {
                continue;
            };
            let from = self.at(start);
            // For a distant special point the cut line runs towards it to the panel's edge.
            let to = match special.place {
                Place::At(place) => self.view.at(place),
                Place::AtInfinity(_) => from + on_sheet(direction) * (bounds.width() + bounds.height()),
            };
            let name = format!("cut-{}-{}", special.name, self.mechanism.point_name(start));
            // A special point may coincide with the joint.
            let way = towards(from, to, on_sheet(direction));
            let end = if is_near(self.context, special) { to + way * 3.0 } else { to };
            if let Some((a, b)) = clipped_segment(bounds, from, end) {
                canvas.draw_named(&name, Pen::Construction, Shape::Line(a, b));
            }
            if let Some(slider) = cut.guide() {
                let along = on_sheet(self.pose.guide(slider));
                self.right_angle(canvas, from, along, way);
            }
        }
    }

    /// Draws the sign of a right angle at `corner`.
    fn right_angle(&self, canvas: &mut Canvas<'_>, corner: Point, a: Vec2, b: Vec2) {
        const SIDE: f64 = 2.4;
        let chain = vec![corner + a * SIDE, corner + (a + b) * SIDE, corner + b * SIDE];
        canvas.draw(Pen::Frame, Shape::Polyline(chain));
    }

    /// Draws a special point at its place, or a distant one as an arrow with its distance.
    pub(super) fn mark_special(&self, canvas: &mut Canvas<'_>, special: &Special) {
        let label = self.context.facts.markup(&special.name);
        if is_near(self.context, special) {
            let Some(place) = special.place.finite() else {
                return;
            };
            let center = self.view.at(place);
            let name = format!("point-{}", special.name);
            let shape = Shape::Circle { center, radius: self.dims().joint };
            canvas.draw_named(&name, Pen::Special, shape);
            canvas.label(&special.name, &label, center, self.dims().joint + 0.7, None, 3);
            return;
        }
        // The arrow is on the first cut line with a direction.
        let bounds = canvas.room().inset(-2.0);
        let start = special.cuts.iter().find_map(|c| Some((c.start()?, c.line.direction()?)));
        let Some((start, direction)) = start else {
            return;
        };
        let from = self.at(start);
        let towards = match special.place {
            Place::At(place) => self.view.at(place) - from,
            Place::AtInfinity(_) => on_sheet(direction),
        };
        let far = from + towards.normalize() * (bounds.width() + bounds.height());
        let Some((_, edge)) = clipped_segment(bounds, from, far) else {
            return;
        };
        let tail = edge - towards.normalize() * 9.0;
        let distance = match special.place {
            Place::At(place) => {
                let distance = (place - self.pose.point(start)).norm();
                let name = self.mechanism.point_name(start);
                let distance = self.context.words.write(distance, DISTANCE);
                self.context.words.language.far_away(&label, &distance, name)
            }
            Place::AtInfinity(_) => self.context.words.language.at_infinity(&label),
        };
        let name = format!("point-{}", special.name);
        canvas.draw_named(&name, Pen::Special, canvas.arrow(tail, edge));
        canvas.words(&special.name, &distance, tail);
    }
}
