//! The scheme of the mechanism. From back to front: ghosts, areas, paths of points, cut lines, guides, the ground, springs, links, blocks with the links
//! on their pins, joints, special points, labels.

pub(super) mod centrodes;
mod contacts;
mod drives;
mod links;
mod loads;
pub(super) mod on_paper;
mod points;
mod rack;
pub(super) mod sliders;
mod springs;
mod values;
mod wheels;

pub(super) use rack::{hatch_line, tangents};
pub(super) use sliders::{BLOCK, above};
pub(super) use wheels::hatch_rim;

use super::canvas::Canvas;
use super::context::SheetContext;
use super::view::View;
use crate::construction::{Action, NumberedStep, Ray, RayOf};
use crate::geometry;
use crate::mechanism::{GROUND, PointId, Role};
use on_paper::SchemeOnPaper;

/// Draws the scheme.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let scheme = SchemeOnPaper::new(context, view).within(canvas.room());
    scheme.ghosts(canvas);
    scheme.other_modes(canvas);
    scheme.link_areas(canvas);
    scheme.discs(canvas);
    scheme.paths(canvas);
    scheme.centrodes(canvas);
    scheme.inflection_circles(canvas);
    for special in context.special() {
        canvas.step = context.facts.step_of_special(&special.name);
        scheme.cuts(canvas, special);
    }
    canvas.step = 0;
    for slider in scheme.sliders() {
        scheme.guide(canvas, slider);
    }
    for &point in &scheme.mechanism.body(GROUND).points {
        scheme.pivot(canvas, point);
    }
    scheme.wheels(canvas);
    scheme.contacts(canvas);
    scheme.springs(canvas);
    scheme.link_lines(canvas);
    scheme.slide_arrows(canvas);
    for slider in scheme.sliders() {
        scheme.block(canvas, slider);
    }
    for (link, body) in scheme.mechanism.links() {
        if body.role == Role::Unsolved {
            scheme.neighbour(canvas, link);
        }
    }
    scheme.rotation_arrows(canvas);
    scheme.loads(canvas);
    scheme.values(canvas);
    scheme.joints(canvas, |_| true);
    for special in context.special() {
        canvas.step = context.facts.step_of_special(&special.name);
        scheme.mark_special(canvas, special);
    }
    canvas.step = 0;
    scheme.link_names(canvas);
    scheme.say_of_loads(canvas);
}

/// Draws the mechanism alone, for other things to be drawn on it, with the names of the links and of these points.
pub(super) fn draw_bare(
    canvas: &mut Canvas<'_>,
    view: &View,
    context: &SheetContext<'_>,
    is_named: impl Fn(PointId) -> bool,
) {
    let scheme = SchemeOnPaper::new(context, view).within(canvas.room());
    canvas.step = 0;
    scheme.link_areas(canvas);
    for slider in scheme.sliders() {
        scheme.guide(canvas, slider);
    }
    for &point in &scheme.mechanism.body(GROUND).points {
        scheme.pivot(canvas, point);
    }
    scheme.contacts(canvas);
    scheme.link_lines(canvas);
    for slider in scheme.sliders() {
        scheme.block(canvas, slider);
    }
    scheme.joints(canvas, is_named);
    scheme.link_names(canvas);
}

/// Draws the hints of the steps: the measured length, the line to which a ray is normal, the senses of solved rates.
pub(super) fn hints(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let scheme = SchemeOnPaper::new(context, view);
    scheme.arms(canvas);
    for NumberedStep { number, plan, action, .. } in context.construction().numbered_steps() {
        let number = number as u16;
        let ends = match action {
            Action::Measure { from, to, .. } if plan.is_none() => {
                let joint = scheme.mechanism.point(from).map(|p| scheme.pose.point(p));
                joint.zip(context.construction().special_point(to).and_then(|s| s.place.finite()))
            }
            Action::Ray(ray) => scheme.line_of(ray),
            Action::Solve { unknowns, .. } => {
                scheme.solved_rates(canvas, number, unknowns);
                None
            }
            _ => None,
        };
        if let Some((from, to)) = ends {
            canvas.hint(number, scheme.view.at(from), scheme.view.at(to));
        }
    }
}

impl SchemeOnPaper<'_> {
    /// The segment of the cut line to which a ray is normal, from its joint to the special point.
    fn line_of(&self, ray: &Ray) -> Option<(geometry::Point, geometry::Point)> {
        match ray.of {
            RayOf::Leg(special, side) => {
                let special = self.context.construction().special(special);
                Some((self.pose.point(special.cuts[side].start()?), special.place.finite()?))
            }
            RayOf::Arm { from, to, .. } => Some((self.pose.point(from), self.pose.point(to))),
        }
    }
}
