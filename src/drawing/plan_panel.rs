use super::canvas::Canvas;
use super::clip::clipped_segment;
use super::inset::Inset;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Mark, Pen};
use super::stages::PlanStages;
use super::view::{Extent, View, on_sheet, towards};
use crate::construction::{Action, ArrowKind, Plan, PlanKind, PointRole, Relation, coincident_name, image_name};
use crate::geometry;
use crate::mechanism::{Body, Mechanism};
use crate::quantity::Kind;
use crate::scene::Figure;
use kurbo::{Point, Vec2};

/// Plan points closer than this on paper (mm) share one label.
const SHARED: f64 = 0.35;
/// How far a ray runs beyond the crossing, in mm.
const BEYOND: f64 = 5.0;

/// The kind of quantity that a millimetre of a plan stands for; of the scheme, where there is no plan.
pub(super) fn kind(plan: Option<PlanKind>) -> Kind {
    match plan {
        None => Kind::Length,
        Some(PlanKind::Velocity) => Kind::Velocity,
        Some(PlanKind::Acceleration) => Kind::Acceleration,
    }
}

/// What must find room: all points of the plan.
pub(super) fn extent(plan: &Plan) -> Extent {
    Extent::of(plan.points.values().map(|p| p.vector.into()))
}

/// The same without special points and what leads to them.
pub(super) fn extent_of_images(plan: &Plan) -> Extent {
    let own = |role| matches!(role, PointRole::Pole | PointRole::Known | PointRole::Image);
    Extent::of(plan.points.values().filter(|p| own(p.role)).map(|p| p.vector.into()))
}

/// Whether a plan point is only on the way to others, and a figure shows no such points.
pub(super) fn is_hidden(figure: &Figure, plan: &Plan, name: &str) -> bool {
    let role = plan.points.get(name).map(|p| p.role);
    let on_the_way = match plan.kind {
        PlanKind::Velocity => matches!(role, Some(PointRole::Special)),
        PlanKind::Acceleration => matches!(role, Some(PointRole::Special | PointRole::Normal | PointRole::Slid)),
    };
    on_the_way && !figure.special_points
}

/// Draws a plan from its steps.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, scheme: &Scheme<'_>, plan: &Plan) {
    let stages = scheme.stages.plan(plan.kind);
    let plan = PlanOnPaper { view, scheme, plan, stages, images: images(scheme.mechanism, plan) };
    plan.areas(canvas);
    plan.rays(canvas);
    // Over all areas and rays, so that a line that lies on a ray is seen as one.
    plan.outlines(canvas);
    plan.vectors(canvas);
    plan.points(canvas);
    canvas.since(0);
}

/// A plan that is being drawn.
struct PlanOnPaper<'a> {
    view: &'a View,
    scheme: &'a Scheme<'a>,
    plan: &'a Plan,
    stages: &'a PlanStages,
    /// The points that make the image of each link.
    images: Vec<Vec<String>>,
}

impl PlanOnPaper<'_> {
    fn at(&self, name: &str) -> Option<Point> {
        self.plan.points.get(name).map(|point| self.view.at(point.vector.into()))
    }

    fn is_hidden(&self, name: &str) -> bool {
        is_hidden(self.scheme.figure, self.plan, name)
    }

    /// The corners of an image, and the step that completes it.
    fn corners(&self, image: &[String]) -> (Vec<Point>, u16) {
        let steps = image.iter().map(|name| self.stages.point(name));
        (image.iter().filter_map(|name| self.at(name)).collect(), steps.max().unwrap_or_default())
    }

    /// The areas of the links' images.
    fn areas(&self, canvas: &mut Canvas<'_>) {
        for (number, image) in self.images.iter().enumerate() {
            if image.len() > 2 {
                let (corners, since) = self.corners(image);
                canvas.since(since);
                canvas.draw(Pen::ImageFill, Shape::Polygon(corners)).number = Some(number);
            }
        }
    }

    /// The lines of known direction.
    fn rays(&self, canvas: &mut Canvas<'_>) {
        if !(self.scheme.figure.construction && self.scheme.figure.special_points) {
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
                canvas.since(self.stages.ray(&ray.through, &ray.to));
                canvas.draw_named(&name, Pen::Ray, Shape::Line(a, b));
            }
        }
    }

    /// The outlines of the links' images.
    fn outlines(&self, canvas: &mut Canvas<'_>) {
        for (number, image) in self.images.iter().enumerate() {
            let (corners, since) = self.corners(image);
            let outline = match corners.as_slice() {
                [a, b] => Shape::Line(*a, *b),
                [_, _, _] => Shape::Polygon(corners),
                _ => continue,
            };
            canvas.since(since);
            canvas.draw(Pen::Image, outline).number = Some(number);
        }
    }

    /// The vectors, whole ones from the pole first.
    fn vectors(&self, canvas: &mut Canvas<'_>) {
        let plan = self.plan;
        let whole = match plan.kind {
            PlanKind::Velocity => Pen::Velocity,
            PlanKind::Acceleration => Pen::Acceleration,
        };
        let pole = plan.kind.pole();
        let from_pole = |name: &str| {
            let special = plan.points.get(name).map(|p| p.role) == Some(PointRole::Special);
            (special || plan.rays().any(|ray| ray.to == name)) && !self.is_hidden(name)
        };
        for name in plan.points.keys().filter(|name| from_pole(name)) {
            canvas.since(self.stages.point(name));
            self.arrow(canvas, pole, name, whole);
        }
        for laid in plan.arrows() {
            // What slides on the ground has the vector from the pole already.
            let again = self.at(&laid.from) == self.at(pole) && from_pole(&laid.to);
            if self.is_hidden(&laid.to) || again {
                continue;
            }
            let pen = match laid.kind() {
                ArrowKind::Whole => whole,
                ArrowKind::Normal => Pen::Normal,
                ArrowKind::Relative => Pen::Image,
                ArrowKind::Sliding => Pen::Vector,
                ArrowKind::Coriolis => Pen::Coriolis,
            };
            canvas.since(self.stages.vector(&laid.from, &laid.to));
            let drawn = self.arrow(canvas, &laid.from, &laid.to, pen);
            // A side of a link's image looks like the image.
            if let (Some(mark), Pen::Image) = (drawn, pen) {
                let has_both = |image: &Vec<String>| [&laid.from, &laid.to].iter().all(|n| image.contains(n));
                mark.number = self.images.iter().position(has_both);
            }
        }
    }

    /// The vector from one point to another, if it has a length.
    fn arrow<'c>(&self, canvas: &'c mut Canvas<'_>, from: &str, to: &str, pen: Pen) -> Option<&'c mut Mark> {
        let name = format!("vector-{from}-{to}");
        let (from, to) = self.at(from).zip(self.at(to))?;
        ((to - from).hypot() > 1e-3).then(|| canvas.draw_named(&name, pen, Shape::Arrow { from, to }))
    }

    /// Dots and names of the points; points in one place share a label.
    fn points(&self, canvas: &mut Canvas<'_>) {
        let places = self.places();
        let since = |here: &[&str]| here.iter().map(|name| self.stages.point(name)).min().unwrap_or_default();
        for (center, here, role) in &places {
            let (center, (pen, radius)) = (*center, dot(*role));
            canvas.since(since(here));
            canvas.draw_named(&format!("point-{}", here[0]), pen, Shape::Circle { center, radius });
        }
        let crowded: Vec<Point> = places.iter().map(|(place, ..)| *place).collect();
        let inset = self.scheme.insets.then(|| Inset::new(canvas, &crowded)).flatten();
        if let Some(inset) = &inset {
            inset.draw(canvas, &self.scheme.words);
        }
        let extent = extent(self.plan);
        let middle = self.view.at(nalgebra::center(&extent.low, &extent.high));
        for (place, here, role) in places {
            // The pole is looked for in the plan itself.
            let (anchor, away) = match inset.filter(|inset| inset.shows(place) && role != PointRole::Pole) {
                Some(inset) => (inset.at(place), Vec2::ZERO),
                None => (place, place - middle),
            };
            let prefer: Option<Vec2> = (away.hypot() > 4.0).then(|| away.normalize());
            canvas.since(since(&here));
            // The renamed names are joined already; the joint label goes by the first one's id.
            let joined = format!("{} ", here[0]);
            canvas.label(&joined, &self.shown(&here), anchor, dot(role).1 + 0.7, prefer, 2);
        }
    }

    /// The visible points, those in one place together.
    fn places(&self) -> Vec<(Point, Vec<&str>, PointRole)> {
        let plan = self.plan;
        let mut places: Vec<(Point, Vec<&str>, PointRole)> = Vec::new();
        let at_pole = |name: &str| name.ends_with("_ground") && plan.points[name].vector.norm() == 0.0;
        for (name, point) in &plan.points {
            // A point of the ground under a slider says no more than the pole.
            if self.is_hidden(name) || at_pole(name) || is_vanished(plan, name) {
                continue;
            }
            let place = self.view.at(geometry::Point::from(point.vector));
            let shared = places.iter_mut().find(|(p, ..)| (*p - place).hypot() < SHARED);
            match shared {
                Some((_, here, _)) => here.push(name),
                None => places.push((place, vec![name], point.role)),
            }
        }
        places
    }

    /// The names of points in one place.
    fn shown(&self, names: &[&str]) -> String {
        let mut shown: Vec<String> = names.iter().map(|name| self.scheme.shown(name, Some(self.plan))).collect();
        // The fixed point O has its image at the pole o.
        shown.dedup();
        shown.join(", ")
    }
}

/// The pen of a point's dot, and its radius.
fn dot(role: PointRole) -> (Pen, f64) {
    match role {
        PointRole::Pole => (Pen::Pole, 0.9),
        PointRole::Special => (Pen::Special, 0.8),
        _ => (Pen::ImagePoint, 0.45),
    }
}

/// What each step of a plan is about: the segment that it measures, and where its ray starts the line of the mechanism that gives
/// the direction, with a mark of the right angle.
pub(super) fn hints(canvas: &mut Canvas<'_>, view: &View, scheme: &Scheme<'_>, plan: &Plan) {
    let at = |name: &str| plan.points.get(name).map(|p| view.at(p.vector.into()));
    let steps = scheme.construction.numbered_steps();
    for step in steps.filter(|step| step.plan.is_some_and(|of| of.kind == plan.kind)) {
        let number = step.number as u16;
        match &step.step.action {
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

/// A piece of the line to which a ray from `corner` is square, and the mark of the right angle.
fn right_angle(canvas: &mut Canvas<'_>, step: u16, corner: Point, ray: Vec2) {
    const SIDE: f64 = 2.0;
    const PIECE: f64 = 7.0;
    let line = Vec2::new(-ray.y, ray.x);
    let ends = Shape::Line(corner - line * PIECE, corner + line * PIECE);
    canvas.passing(step, Pen::Construction, ends);
    let chain = [line * SIDE, (line + ray) * SIDE, ray * SIDE].map(|v| corner + v);
    canvas.passing(step, Pen::Frame, Shape::Polyline(chain.to_vec()));
}

/// The plan points that make the images of all links, in their order: a link's image is the link turned and scaled.
fn images(mechanism: &Mechanism, plan: &Plan) -> Vec<Vec<String>> {
    let image = |body: &Body| {
        let own = body.points.iter().map(|&p| mechanism.point_name(p).to_owned());
        let under = mechanism.sliders.iter().filter(|s| mechanism.body(s.on).name == body.name);
        own.chain(under.map(|s| coincident_name(mechanism.point_name(s.at), &body.name)))
            .map(|name| image_name(&name))
            .filter(|name| plan.points.contains_key(name))
            .collect()
    };
    mechanism.links().map(|(_, body)| image(body)).collect()
}

/// Whether a name is that of the end of a normal acceleration that is nothing at all: it lies on another kind of point.
fn is_vanished(plan: &Plan, name: &str) -> bool {
    let own = &plan.points[name];
    let mut others = plan.points.values();
    own.role == PointRole::Normal && others.any(|p| p.role != PointRole::Normal && p.vector == own.vector)
}
