//! Values on the scheme: rates with arrows in their sense around the links' centres, given lengths beside the links.

use super::drives::RATE_RADIUS;
use super::on_paper::SchemeOnPaper;
use crate::drawing::canvas::Canvas;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::value::{Value, ValueOf};
use crate::drawing::values::{is_at_drive, label};
use crate::drawing::view::towards;
use crate::mechanism::{BodyId, PointId};
use crate::quantity::QuantityKind;
use crate::sheet::Sheet;
use kurbo::{Point, Vec2};

/// Radius of the arrow of an angular acceleration, around that of the angular velocity, in mm.
const ALPHA_RADIUS: f64 = 6.6;

impl SchemeOnPaper<'_> {
    /// Draws the arrows of rates and requests the labels of all values.
    pub(super) fn values(&self, canvas: &mut Canvas<'_>) {
        let mut taken: Vec<Point> = Vec::new();
        for value in self.context.values_of(Sheet::Scheme) {
            if let ValueOf::Rate(link) = value.of {
                self.arrow_of_rate(canvas, value, link, &mut taken);
            }
        }
        for value in self.context.values_of(Sheet::Scheme) {
            match value.of {
                ValueOf::Rate(link) => self.label_rate(canvas, value, link),
                ValueOf::Length(ends) => self.label_length(canvas, value, ends),
                ValueOf::Vector(_) => {}
            }
        }
        canvas.set_step(0);
    }

    /// The arrow of a rate of a link; that of a drive's angular velocity is at its pivot. Without room between the joints
    /// and the arrows around the centres `taken` there is none.
    fn arrow_of_rate(&self, canvas: &mut Canvas<'_>, value: &Value, link: BodyId, taken: &mut Vec<Point>) {
        if value.number == 0.0 || is_at_drive(self.context, value, link) {
            return;
        }
        let (radius, name) = match value.kind {
            QuantityKind::AngularAcceleration => (ALPHA_RADIUS, "alpha"),
            _ => (RATE_RADIUS, "omega"),
        };
        if let Some(shape) = self.rate_arrow(link, radius, value.number)
            && let Shape::ArcArrow { center, .. } = shape
        {
            let mut joints = self.pose.points.iter().map(|&place| self.view.at(place));
            let is_near = |other: &Point| (*other - center).hypot() < 2.0 * ALPHA_RADIUS + 1.0;
            let is_apart = joints.all(|joint| (joint - center).hypot() > radius + self.dims().joint + 1.0);
            if !is_apart || taken.iter().any(|other| *other != center && is_near(other)) {
                return;
            }
            taken.push(center);
            canvas.set_step(value.since);
            let name = format!("{name}-{}", self.mechanism.body(link).name);
            canvas.draw_named(&name, Pen::Turning, shape).number = self.number(link);
        }
    }

    fn label_rate(&self, canvas: &mut Canvas<'_>, value: &Value, link: BodyId) {
        let Some(Shape::ArcArrow { center, radius, .. }) = self.rate_arrow(link, ALPHA_RADIUS, 1.0) else {
            return;
        };
        if is_at_drive(self.context, value, link) {
            return;
        }
        let side = if value.kind == QuantityKind::AngularAcceleration { 1.0 } else { -1.0 };
        let anchor = center + Vec2::new(0.0, side * radius);
        label(self.context, canvas, value, anchor, Some(Vec2::new(0.0, side)));
    }

    /// A length stands beside the middle of its line, away from the middle of the mechanism.
    fn label_length(&self, canvas: &mut Canvas<'_>, value: &Value, [a, b]: [PointId; 2]) {
        let [a, b] = [a, b].map(|point| self.at(point));
        let anchor: Point = a.lerp(b, 0.66);
        let along = towards(a, b, Vec2::new(1.0, 0.0));
        let beside = Vec2::new(-along.y, along.x);
        let outer = self.outward(anchor).is_some_and(|outward| outward.dot(beside) < 0.0);
        label(self.context, canvas, value, anchor, Some(if outer { -beside } else { beside }));
    }
}
