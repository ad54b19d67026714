//! Lines and areas of a plan: images of links, rays, vectors and their values.

use super::sight::{extent, is_hidden, is_image};
use crate::construction::{Arrow, Plan, PlanVector, PointRole, VectorOf, VectorPart, coincident_name, image_name};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{clipped_segment, holds};
use crate::drawing::context::SheetContext;
use crate::drawing::scheme::link_shape::outline;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Mark, Pen};
use crate::drawing::step_numbers::PlanSteps;
use crate::drawing::value::ValueOf;
use crate::drawing::values::label;
use crate::drawing::view::{View, on_sheet};
use crate::geometry;
use crate::mechanism::{Body, Mechanism};
use crate::scene::ConstructionShown;
use crate::sheet::Sheet;
use kurbo::{Point, Vec2};

/// White between the room of a panel and the points in it, in mm.
const EDGE: f64 = 1.5;
/// Length of the shortest vector with a value beside it, in mm.
const SHORT: f64 = 4.0;
/// Length of a ray beyond the crossing, in mm.
const BEYOND: f64 = 5.0;

/// A plan as it stands on a sheet.
pub(super) struct PlanOnPaper<'a> {
    pub view: &'a View,
    pub context: &'a SheetContext<'a>,
    pub plan: &'a Plan,
    pub steps: &'a PlanSteps,
    /// By link: the points of its image.
    images: Vec<Vec<String>>,
}

impl<'a> PlanOnPaper<'a> {
    pub(super) fn new(view: &'a View, context: &'a SheetContext<'a>, plan: &'a Plan) -> Self {
        let steps = context.facts.steps.plan(plan.sheet);
        PlanOnPaper { view, context, plan, steps, images: images(context.mechanism(), plan) }
    }

    pub(super) fn at(&self, name: &str) -> Option<Point> {
        self.plan.points.get(name).map(|point| self.view.at(point.vector.into()))
    }

    /// Whether a point that only leads to others lies off the panel: only its direction is drawn.
    pub(super) fn is_far(&self, canvas: &Canvas<'_>, name: &str) -> bool {
        let leads = self.plan.points.get(name).is_some_and(|point| !is_image(point.role));
        leads && self.at(name).is_some_and(|at| !holds(canvas.room().inset(-EDGE), at))
    }

    pub(super) fn is_hidden(&self, name: &str) -> bool {
        is_hidden(self.context.figure(), self.plan, name)
    }

    /// The corners of an image, and the step that completes it.
    fn corners(&self, image: &[String]) -> (Vec<Point>, u16) {
        let steps = image.iter().map(|name| self.steps.point(name));
        let mut corners: Vec<geometry::Point> =
            image.iter().filter_map(|name| self.plan.points.get(name)).map(|point| point.vector.into()).collect();
        if corners.len() > 3 {
            corners = outline(corners);
        }
        (corners.into_iter().map(|corner| self.view.at(corner)).collect(), steps.max().unwrap_or_default())
    }

    /// The areas of the links' images.
    pub(super) fn areas(&self, canvas: &mut Canvas<'_>) {
        for (number, image) in self.images.iter().enumerate() {
            let (corners, since) = self.corners(image);
            if corners.len() > 2 {
                canvas.set_step(since);
                canvas.draw(Pen::ImageFill, Shape::Polygon(corners)).number = Some(number);
            }
        }
    }

    /// The rays, lines of known direction.
    pub(super) fn rays(&self, canvas: &mut Canvas<'_>) {
        if !(self.context.figure().construction.has_lines() && self.context.figure().special_points) {
            return;
        }
        for ray in self.plan.rays() {
            let (Some(from), Some(to)) = (self.at(&ray.through), self.at(&ray.to)) else {
                continue;
            };
            let along = on_sheet(ray.direction);
            let along = if (to - from).dot(along) < 0.0 { -along } else { along };
            let ends = (from - along * (0.5 * BEYOND), to + along * BEYOND);
            if let Some((a, b)) = clipped_segment(canvas.room(), ends.0, ends.1) {
                let name = format!("ray-{}-{}", ray.through, ray.to);
                canvas.set_step(self.steps.ray(&ray.through, &ray.to));
                canvas.draw_named(&name, Pen::Ray, Shape::Line(a, b));
            }
        }
    }

    /// The outlines of the links' images.
    pub(super) fn outlines(&self, canvas: &mut Canvas<'_>) {
        for (number, image) in self.images.iter().enumerate() {
            let (corners, since) = self.corners(image);
            let outline = match corners.as_slice() {
                [a, b] => Shape::Line(*a, *b),
                [_, _, _, ..] => Shape::Polygon(corners),
                _ => continue,
            };
            canvas.set_step(since);
            canvas.draw(Pen::Image, outline).number = Some(number);
        }
    }

    /// The vectors, those from the pole first.
    pub(super) fn vectors(&self, canvas: &mut Canvas<'_>) {
        let plan = self.plan;
        let whole = match plan.sheet {
            Sheet::Acceleration => Pen::Acceleration,
            _ => Pen::Velocity,
        };
        let pole = plan.sheet.pole();
        // In the source paper's plans no vector goes to a point that a relative motion leads to.
        let is_paper = self.context.figure().construction == ConstructionShown::Paper;
        let from_pole = |name: &str| {
            let is_met = || plan.rays().any(|ray| ray.to == name);
            let is_whole = match plan.points.get(name).map(|p| p.role) {
                Some(PointRole::Special) => true,
                Some(PointRole::Image | PointRole::Known) => !is_paper || is_met(),
                _ => false,
            };
            is_whole && !self.is_hidden(name)
        };
        for name in plan.points.keys().filter(|name| from_pole(name)) {
            canvas.set_step(self.steps.point(name));
            let number = self.link_of(name);
            if let Some(mark) = self.arrow(canvas, pole, name, whole) {
                mark.number = number;
            }
        }
        for laid in plan.arrows() {
            // For a slider on the ground this vector has been drawn from the pole.
            let again = self.at(&laid.from) == self.at(pole) && from_pole(&laid.to);
            if self.is_hidden(&laid.to) || again {
                continue;
            }
            let pen = match laid.part() {
                VectorPart::Whole => whole,
                VectorPart::Normal => Pen::Normal,
                VectorPart::Relative => Pen::Image,
                VectorPart::Tangential => Pen::Tangential,
                VectorPart::Sliding => Pen::Vector,
                VectorPart::Coriolis => Pen::Coriolis,
            };
            canvas.set_step(self.steps.vector(&laid.from, &laid.to));
            let number = match pen {
                // The side of a link's image has the look of the image.
                Pen::Image => {
                    let has_both = |image: &Vec<String>| [&laid.from, &laid.to].iter().all(|n| image.contains(n));
                    self.images.iter().position(has_both)
                }
                _ => self.link_of_vector(laid),
            };
            let [from, to] = laid.ends();
            if let Some(mark) = self.arrow(canvas, from, to, pen) {
                mark.number = number;
            }
        }
    }

    /// Number of the link to which the vector from the pole to a point belongs: of those with an image there, one with
    /// a point at rest if there is one, as this vector is the image of its arm; else the first.
    fn link_of(&self, name: &str) -> Option<usize> {
        let at_rest = |image: &&Vec<String>| image.iter().any(|name| self.plan.points[name].role == PointRole::Pole);
        let with = || self.images.iter().enumerate().filter(|(_, image)| image.iter().any(|own| own == name));
        let arm = with().find(|(_, image)| at_rest(image));
        if let Some((number, _)) = arm.or_else(|| with().next()) {
            return Some(number);
        }
        let mut all = self.context.construction().special.iter();
        let special = all.find(|special| image_name(&special.name) == name)?;
        self.context.number(special.link)
    }

    /// Draws the heads of relative vectors that rays carry, in a figure with values.
    pub(super) fn vectors_on_rays(&self, canvas: &mut Canvas<'_>) {
        for value in self.context.values_of(self.plan.sheet) {
            let ValueOf::Vector(PlanVector { ends: [from, to], link: Some(link), .. }) = &value.of else { continue };
            canvas.set_step(value.since);
            let pen = match self.plan.sheet {
                Sheet::Acceleration => Pen::Tangential,
                _ => Pen::Image,
            };
            let number = self.context.number(*link);
            if let Some(mark) = self.arrow(canvas, from, to, pen) {
                mark.number = number;
            }
        }
    }

    /// Requests the labels of values, each beside the middle of its vector, away from the middle of the plan.
    pub(super) fn values(&self, canvas: &mut Canvas<'_>) {
        let extent = extent(self.plan, self.context.figure().construction);
        let middle = self.view.at(nalgebra::center(&extent.low, &extent.high));
        for value in self.context.values_of(self.plan.sheet) {
            let ValueOf::Vector(PlanVector { ends: [from, to], .. }) = &value.of else { continue };
            let (Some(from), Some(to)) = (self.at(from), self.at(to)) else { continue };
            let along = to - from;
            if along.hypot() < SHORT {
                continue;
            }
            let side = Vec2::new(-along.y, along.x) / along.hypot();
            let outward = if side.dot(from.midpoint(to) - middle) < 0.0 { -side } else { side };
            let (anchor, prefer) = canvas.free_side([from, to], outward);
            label(self.context, canvas, value, anchor, Some(prefer));
        }
    }

    /// Number of the link to which a vector that is laid off belongs.
    fn link_of_vector(&self, laid: &Arrow) -> Option<usize> {
        let mechanism = self.context.mechanism();
        match &laid.of {
            VectorOf::Point(body, _) => self.context.number(*body),
            VectorOf::Normal(special, side) => {
                self.context.number(self.context.construction().special(*special).cuts[*side].carrier)
            }
            VectorOf::Relative { link, .. } => self.context.number(*link),
            VectorOf::Sliding(slider, _) => self.context.number(mechanism.slider(*slider).link),
            VectorOf::Passed(slide, _) => self.context.number(mechanism.slider(slide.slider).link),
        }
    }

    /// Draws the vector from one point to another, unless it is zero; of one that ends far off or starts there, the
    /// part of its line on the panel.
    fn arrow<'c>(&self, canvas: &'c mut Canvas<'_>, from: &str, to: &str, pen: Pen) -> Option<&'c mut Mark> {
        let name = format!("vector-{from}-{to}");
        if self.is_far(canvas, from) || self.is_far(canvas, to) {
            let (from, to) = self.at(from).zip(self.at(to))?;
            let (a, b) = clipped_segment(canvas.room(), from, to)?;
            return Some(canvas.draw_named(&name, Pen::Construction, Shape::Line(a, b)));
        }
        let (from, to) = self.at(from).zip(self.at(to))?;
        ((to - from).hypot() > 1e-3).then(|| canvas.draw_named(&name, pen, canvas.arrow(from, to)))
    }
}

/// By link: the plan points of its image, in the order of the link's points. The image is the link rotated and scaled.
fn images(mechanism: &Mechanism, plan: &Plan) -> Vec<Vec<String>> {
    let image = |body: &Body| {
        let points = body.points.iter().map(|&p| mechanism.point_name(p).to_owned());
        let coincident = mechanism.sliders.iter().filter(|s| mechanism.body(s.on).name == body.name);
        points
            .chain(coincident.map(|s| coincident_name(mechanism.point_name(s.at), &body.name)))
            .map(|name| image_name(&name))
            .filter(|name| plan.points.contains_key(name))
            .collect()
    };
    mechanism.links().map(|(_, body)| image(body)).collect()
}
