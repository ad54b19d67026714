//! A plan in its panel, drawn from the steps of its construction.

pub(super) mod on_paper;
mod values;

use super::canvas::Canvas;
use super::clip::clipped_segment;
use super::context::SheetContext;
use super::shape::Shape;
use super::sheet::Pen;
use super::view::{View, on_sheet, towards};
use crate::construction::{Action, Plan, Relation};
use kurbo::{Point, Vec2};
use on_paper::PlanOnPaper;

/// Draws a plan from its steps.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>, plan: &Plan) {
    let plan = PlanOnPaper::new(view, context, plan);
    plan.images(canvas, Pen::ImageFill);
    plan.rays(canvas);
    // Outlines are over all areas and rays: a line on a ray must be visible.
    plan.images(canvas, Pen::Image);
    plan.vectors(canvas);
    plan.vectors_on_rays(canvas);
    plan.points(canvas);
    plan.values(canvas);
    canvas.step = 0;
}

/// Draws the hints of a plan's steps: the measured segment; at the start of a ray the direction of the mechanism's line
/// with a right angle.
pub(super) fn hints(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>, plan: &Plan) {
    let at = |name: &str| plan.points.get(name).map(|p| view.at(p.vector.into()));
    let steps = context.construction().numbered_steps();
    for step in steps.filter(|step| step.sheet == plan.sheet()) {
        let number = step.number as u16;
        match &step.action {
            Action::Measure { from, to, .. } => {
                if let (Some(from), Some(to)) = (at(from), at(to)) {
                    canvas.hint(number, from, to);
                }
            }
            Action::Ray(ray) if ray.relation == Relation::Perpendicular => {
                if let (Some(from), Some(to)) = (at(&ray.through), at(&ray.to)) {
                    let along = towards(from, to, on_sheet(ray.direction));
                    right_angle(canvas, number, from, along);
                }
            }
            _ => {}
        }
    }
}

/// Draws a piece of the line normal to a ray from `corner`, and the sign of the right angle.
fn right_angle(canvas: &mut Canvas<'_>, step: u16, corner: Point, ray: Vec2) {
    const SIDE: f64 = 2.0;
    const PIECE: f64 = 7.0;
    let line = Vec2::new(-ray.y, ray.x);
    if let Some((a, b)) = clipped_segment(canvas.room(), corner - line * PIECE, corner + line * PIECE) {
        canvas.draw_in_step(step, Pen::Construction, Shape::Line(a, b));
    }
    let chain = [line * SIDE, (line + ray) * SIDE, ray * SIDE].map(|v| corner + v);
    canvas.draw_in_step(step, Pen::Frame, Shape::Polyline(chain.to_vec()));
}
