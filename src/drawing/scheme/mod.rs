//! The scheme of the mechanism. From back to front: ghosts, areas, paths of points, cut lines, guides, the ground, links, blocks with the links
//! on their pins, joints, special points, labels.

mod drives;
pub(super) mod link_shape;
mod links;
mod names;
mod on_paper;
pub(super) mod sight;
mod sliders;
mod special;
mod traces;

pub(super) use sliders::above;

use super::canvas::Canvas;
use super::context::SheetContext;
use super::shape::Shape;
use super::sheet::Pen;
use super::view::View;
use crate::construction::{Action, NumberedStep, Ray, RayOf};
use crate::geometry;
use crate::mechanism::{GROUND, Role};
use on_paper::SchemeOnPaper;
use sight::circles;
use std::f64::consts::PI;
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    SchemeOnPaper::new(context, view).draw(canvas);
}

/// Draws the hints of the steps: the measured length, the line to which a ray is normal, the senses of solved rates.
pub(super) fn hints(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    SchemeOnPaper::new(context, view).hints(canvas);
}

impl SchemeOnPaper<'_> {
    /// Draws the circles larger than that of a pin.
    fn wheels(&self, canvas: &mut Canvas<'_>) {
        for (center, radius) in circles(self.mechanism, self.pose) {
            let (center, rim) = (self.pose.point(center), geometry::Vector::new(radius, 0.0));
            let (center, rim) = (self.view.at(center), self.view.at(center + rim));
            let radius = (rim - center).hypot();
            if radius <= self.dims().joint {
                continue;
            }
            // Two half circles: unlike a full circle they leave the inside free for a label.
            for start in [0.0, PI] {
                canvas.draw(Pen::Guide, Shape::Arc { center, radius, start, sweep: PI });
            }
        }
    }

    fn draw(&self, canvas: &mut Canvas<'_>) {
        self.ghosts(canvas);
        self.other_modes(canvas);
        self.link_areas(canvas);
        self.paths(canvas);
        for special in self.context.special() {
            canvas.set_step(self.context.facts.steps.special(&special.name));
            self.cuts(canvas, special);
        }
        canvas.set_step(0);
        for slider in self.sliders() {
            self.guide(canvas, slider);
        }
        for &point in &self.mechanism.body(GROUND).points {
            self.pivot(canvas, point);
        }
        self.wheels(canvas);
        self.link_lines(canvas);
        self.slide_arrows(canvas);
        for slider in self.sliders() {
            self.block(canvas, slider);
        }
        for (link, body) in self.mechanism.links() {
            if body.role == Role::Unsolved {
                self.stub(canvas, link);
            }
        }
        self.rotation_arrows(canvas);
        self.values(canvas);
        self.joints(canvas);
        for special in self.context.special() {
            canvas.set_step(self.context.facts.steps.special(&special.name));
            self.mark_special(canvas, special);
        }
        canvas.set_step(0);
        self.link_names(canvas);
    }

    fn hints(&self, canvas: &mut Canvas<'_>) {
        for NumberedStep { number, action, .. } in self.context.construction().numbered_steps() {
            let number = number as u16;
            let ends = match action {
                Action::MeasureLength { from, to, .. } => {
                    let joint = self.mechanism.point(from).map(|p| self.pose.point(p));
                    joint.zip(self.context.construction().special_point(to).and_then(|s| s.place.finite()))
                }
                Action::Ray(ray) => self.line_of(ray),
                Action::Solve { unknowns, .. } => {
                    self.rate_arrows(canvas, number, unknowns);
                    None
                }
                _ => None,
            };
            if let Some((from, to)) = ends {
                canvas.hint(number, self.view.at(from), self.view.at(to));
            }
        }
    }

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
