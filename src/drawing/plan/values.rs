//! The values of a plan's vectors: beside their middles, or at the heads at the edge of those that run off the panel.

use super::on_paper::{PlanOnPaper, is_image};
use crate::construction::{PlanVector, VectorPart};
use crate::drawing::canvas::{Canvas, Wanted};
use crate::drawing::clip::{clipped_segment, holds};
use crate::drawing::context::{Purpose, Value, ValueOf};
use crate::drawing::text::RichText;
use crate::drawing::values::label;
use crate::scene::ValuesShown;
use kurbo::{Point, Vec2};
use std::borrow::Cow;

/// Length of the shortest vector with a value beside it, in mm.
const SHORT: f64 = 4.0;
/// The value of a vector that runs off the panel stands at most so far from its head, in mm.
const AT_HEAD: f64 = 14.0;

impl PlanOnPaper<'_> {
    /// Requests the labels of values, each beside the middle of its vector, away from the middle of the plan; of one that
    /// runs off the panel beside its head at the edge, also in a figure without values: its length is not to be seen.
    pub(super) fn values(&self, canvas: &mut Canvas<'_>) {
        for value in self.context.values_of(self.plan.sheet()) {
            let Some((ends, _)) = self.ends_of(value).filter(|([from, to], _)| (*to - *from).hypot() >= SHORT) else {
                continue;
            };
            if self.running_off(canvas, ends).is_none() {
                self.value(canvas, value, ends);
            }
        }
        if canvas.is_part || self.context.purpose != Purpose::Figure || !self.leaves(canvas) {
            return;
        }
        let shown = match self.context.values.is_empty() {
            true => Cow::Owned(self.context.clone().with_values_as(ValuesShown::Shown(None))),
            false => Cow::Borrowed(self.context),
        };
        for value in shown.values_of(self.plan.sheet()) {
            let Some((ends, part)) = self.ends_of(value) else { continue };
            // A point that only leads to others says itself how far it is.
            if matches!(&value.of, ValueOf::Vector(vector) if self.is_far(canvas, &vector.ends[1])) {
                continue;
            }
            let Some([from, edge]) = self.running_off(canvas, ends) else { continue };
            canvas.obstacles.add_boxes(canvas.arrow(from, edge).head_box());
            let along = edge - from;
            let near = edge - along.normalize() * AT_HEAD.min(along.hypot());
            let size = format!("{} {}", value.written, value.unit);
            let wanted = self.value(canvas, value, [near, edge]);
            wanted.short = Some(RichText::plain(size.trim_end()));
            wanted.optional = part != VectorPart::Whole;
        }
    }

    /// Requests the label of a value beside a vector or a part of it.
    fn value<'c>(&self, canvas: &'c mut Canvas<'_>, value: &Value, [from, to]: [Point; 2]) -> &'c mut Wanted {
        let along = to - from;
        let side = Vec2::new(-along.y, along.x) / along.hypot();
        let outward = if side.dot(from.midpoint(to) - self.middle()) < 0.0 { -side } else { side };
        let (anchor, prefer) = canvas.free_side([from, to], outward);
        label(self.context, canvas, value, anchor, Some(prefer))
    }

    /// The ends of a value's vector, and which part of a motion it is.
    fn ends_of(&self, value: &Value) -> Option<([Point; 2], VectorPart)> {
        let ValueOf::Vector(PlanVector { ends: [from, to], part, .. }) = &value.of else { return None };
        Some(([self.at(from)?, self.at(to)?], *part))
    }

    /// The part on the panel of a vector that ends off it; none of another.
    fn running_off(&self, canvas: &Canvas<'_>, [from, to]: [Point; 2]) -> Option<[Point; 2]> {
        let (from, edge) = clipped_segment(canvas.below_header(), from, to).filter(|_| !holds(canvas.frame, to))?;
        ((edge - from).hypot() >= SHORT).then_some([from, edge])
    }

    /// Whether a point of the plan that is drawn at its place is off the panel.
    fn leaves(&self, canvas: &Canvas<'_>) -> bool {
        let images = self.plan.points.values().filter(|point| is_image(point.role));
        images.map(|point| self.view.at(point.vector.into())).any(|place| !holds(canvas.frame, place))
    }
}
