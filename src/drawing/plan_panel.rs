use super::canvas::Canvas;
use super::clip::{clipped_segment, holds};
use super::held::Inset;
use super::scheme::{Scheme, outline};
use super::shape::Shape;
use super::sheet::{Mark, Pen};
use super::stages::PlanStages;
use super::text::RichText;
use super::values::ValueOf;
use super::view::{Extent, View, on_sheet, towards};
use crate::construction::{
    Action, Arrow, ArrowKind, Plan, PlanVector, PointRole, Relation, VectorOf, coincident_name, image_name,
};
use crate::geometry;
use crate::mechanism::{Body, Mechanism};
use crate::scene::{ConstructionShown, Figure};
use crate::sheet::Sheet;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Vec2};

/// White between the room of a panel and the points in it, in mm.
const EDGE: f64 = 1.5;
/// Plan points closer than this on paper, in mm, share one label.
const SHARED: f64 = 0.35;
/// Most names of coincident points in one label.
const TOGETHER: usize = 5;
/// Length of the shortest vector with a value beside it, in mm.
const SHORT: f64 = 4.0;
/// Length of a ray beyond the crossing, in mm.
const BEYOND: f64 = 5.0;

/// Largest size of a plan with a point that only leads to others over that without it; a more distant one is not drawn
/// at its place, but where its line leaves the panel.
const REACH: f64 = 2.0;

/// The extent of the plan's points, without far ones that only lead to others: with each of those, taken from the
/// nearest on, the plan must not grow by more than `REACH`. A plan as in the source paper has them all.
pub(super) fn extent(plan: &Plan, shown: ConstructionShown) -> Extent {
    let images = extent_of_images(plan);
    let with = |extent: Extent, place: geometry::Point| Extent::of([extent.low, extent.high, place]);
    let leading = plan.points.values().filter(|p| !is_image(p.role)).map(|p| geometry::Point::from(p.vector));
    let mut leading: Vec<geometry::Point> = leading.collect();
    let size = |place: &geometry::Point| with(images, *place).size().norm();
    leading.sort_by(|a, b| size(a).total_cmp(&size(b)));
    let mut extent = images;
    for place in leading {
        let larger = with(extent, place);
        if shown != ConstructionShown::Paper && larger.size().norm() > REACH * extent.size().norm() {
            break;
        }
        extent = larger;
    }
    extent
}

/// Whether a point of a plan is no mere help on the way to others.
fn is_image(role: PointRole) -> bool {
    matches!(role, PointRole::Pole | PointRole::Known | PointRole::Image)
}

/// The same without special points and the points that lead to them.
pub(super) fn extent_of_images(plan: &Plan) -> Extent {
    Extent::of(plan.points.values().filter(|p| is_image(p.role)).map(|p| p.vector.into()))
}

/// Whether a plan point only leads to others, in a figure that does not show such points.
pub(super) fn is_hidden(figure: &Figure, plan: &Plan, name: &str) -> bool {
    let role = plan.points.get(name).map(|p| p.role);
    let on_the_way = match plan.kind {
        Sheet::Acceleration => matches!(role, Some(PointRole::Special | PointRole::Normal | PointRole::Slid)),
        _ => matches!(role, Some(PointRole::Special)),
    };
    on_the_way && !figure.special_points
}

/// Draws a plan from its steps.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, scheme: &Scheme<'_>, plan: &Plan) {
    let stages = scheme.stages.plan(plan.kind);
    let plan = PlanOnPaper { view, scheme, plan, stages, images: images(scheme.mechanism, plan) };
    plan.areas(canvas);
    plan.rays(canvas);
    // Outlines are over all areas and rays: a line on a ray must be visible.
    plan.outlines(canvas);
    plan.vectors(canvas);
    plan.vectors_on_rays(canvas);
    plan.points(canvas);
    plan.values(canvas);
    canvas.set_step(0);
}

/// A plan in progress.
struct PlanOnPaper<'a> {
    view: &'a View,
    scheme: &'a Scheme<'a>,
    plan: &'a Plan,
    stages: &'a PlanStages,
    /// By link: the points of its image.
    images: Vec<Vec<String>>,
}

impl PlanOnPaper<'_> {
    fn at(&self, name: &str) -> Option<Point> {
        self.plan.points.get(name).map(|point| self.view.at(point.vector.into()))
    }

    /// Whether a point that only leads to others lies off the panel: only its direction is drawn.
    fn is_far(&self, canvas: &Canvas<'_>, name: &str) -> bool {
        let leads = self.plan.points.get(name).is_some_and(|point| !is_image(point.role));
        leads && self.at(name).is_some_and(|at| !holds(canvas.room().inset(-EDGE), at))
    }

    fn is_hidden(&self, name: &str) -> bool {
        is_hidden(self.scheme.figure, self.plan, name)
    }

    /// The corners of an image, and the step that completes it.
    fn corners(&self, image: &[String]) -> (Vec<Point>, u16) {
        let steps = image.iter().map(|name| self.stages.point(name));
        let mut corners: Vec<geometry::Point> =
            image.iter().filter_map(|name| self.plan.points.get(name)).map(|point| point.vector.into()).collect();
        if corners.len() > 3 {
            corners = outline(corners);
        }
        (corners.into_iter().map(|corner| self.view.at(corner)).collect(), steps.max().unwrap_or_default())
    }

    /// The areas of the links' images.
    fn areas(&self, canvas: &mut Canvas<'_>) {
        for (number, image) in self.images.iter().enumerate() {
            let (corners, since) = self.corners(image);
            if corners.len() > 2 {
                canvas.set_step(since);
                canvas.draw(Pen::ImageFill, Shape::Polygon(corners)).number = Some(number);
            }
        }
    }

    /// The rays, lines of known direction.
    fn rays(&self, canvas: &mut Canvas<'_>) {
        if !(self.scheme.figure.construction.has_lines() && self.scheme.figure.special_points) {
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
                canvas.set_step(self.stages.ray(&ray.through, &ray.to));
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
                [_, _, _, ..] => Shape::Polygon(corners),
                _ => continue,
            };
            canvas.set_step(since);
            canvas.draw(Pen::Image, outline).number = Some(number);
        }
    }

    /// The vectors, those from the pole first.
    fn vectors(&self, canvas: &mut Canvas<'_>) {
        let plan = self.plan;
        let whole = match plan.kind {
            Sheet::Acceleration => Pen::Acceleration,
            _ => Pen::Velocity,
        };
        let pole = plan.kind.pole();
        // In the source paper's plans no vector goes to a point that a relative motion leads to.
        let is_paper = self.scheme.figure.construction == ConstructionShown::Paper;
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
            canvas.set_step(self.stages.point(name));
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
            let pen = match laid.kind() {
                ArrowKind::Whole => whole,
                ArrowKind::Normal => Pen::Normal,
                ArrowKind::Relative if plan.kind == Sheet::Acceleration => Pen::Tangential,
                ArrowKind::Relative => Pen::Image,
                ArrowKind::Sliding => Pen::Vector,
                ArrowKind::Coriolis => Pen::Coriolis,
            };
            canvas.set_step(self.stages.vector(&laid.from, &laid.to));
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
        let mut all = self.scheme.construction.special.iter().flatten();
        let special = all.find(|special| image_name(&special.name) == name)?;
        self.scheme.number(special.link)
    }

    /// Draws the heads of relative vectors that rays carry, in a figure with values.
    fn vectors_on_rays(&self, canvas: &mut Canvas<'_>) {
        for value in self.scheme.values_of(self.plan.kind) {
            let ValueOf::Vector(PlanVector { ends: [from, to], on_ray: true, link, .. }) = &value.of else { continue };
            canvas.set_step(value.since);
            let pen = match self.plan.kind {
                Sheet::Acceleration => Pen::Tangential,
                _ => Pen::Image,
            };
            let number = link.and_then(|link| self.scheme.number(link));
            if let Some(mark) = self.arrow(canvas, from, to, pen) {
                mark.number = number;
            }
        }
    }

    /// Requests the labels of values, each beside the middle of its vector, away from the middle of the plan.
    fn values(&self, canvas: &mut Canvas<'_>) {
        let extent = extent(self.plan, self.scheme.figure.construction);
        let middle = self.view.at(nalgebra::center(&extent.low, &extent.high));
        for value in self.scheme.values_of(self.plan.kind) {
            let ValueOf::Vector(PlanVector { ends: [from, to], .. }) = &value.of else { continue };
            let (Some(from), Some(to)) = (self.at(from), self.at(to)) else { continue };
            let along = to - from;
            if along.hypot() < SHORT {
                continue;
            }
            let side = Vec2::new(-along.y, along.x) / along.hypot();
            let outward = if side.dot(from.midpoint(to) - middle) < 0.0 { -side } else { side };
            let (anchor, prefer) = canvas.free_side([from, to], outward);
            self.scheme.label_value(canvas, value, anchor, Some(prefer));
        }
    }

    /// Number of the link to which a vector that is laid off belongs.
    fn link_of_vector(&self, laid: &Arrow) -> Option<usize> {
        let mechanism = self.scheme.mechanism;
        match &laid.of {
            VectorOf::Point(body, _) => self.scheme.number(*body),
            VectorOf::Normal(special, side) => {
                self.scheme.number(self.scheme.construction.special(*special).cuts[*side].carrier)
            }
            VectorOf::Relative { link, .. } => self.scheme.number(*link),
            VectorOf::Sliding(slider, _) => self.scheme.number(mechanism.slider(*slider).link),
            VectorOf::Passed(slide, _) => self.scheme.number(mechanism.slider(slide.slider).link),
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

    /// Draws dots and labels of the points; coincident points share a label.
    fn points(&self, canvas: &mut Canvas<'_>) {
        let (far, places): (Vec<_>, Vec<_>) =
            self.places().into_iter().partition(|(_, here, _)| self.is_far(canvas, here[0]));
        let since = |here: &[&str]| here.iter().map(|name| self.stages.point(name)).min().unwrap_or_default();
        for (center, here, role) in &places {
            let (center, (pen, radius)) = (*center, self.dot(*role));
            canvas.set_step(since(here));
            canvas.draw_named(&format!("point-{}", here[0]), pen, Shape::Circle { center, radius });
        }
        let crowded: Vec<Point> = places.iter().map(|(place, ..)| *place).collect();
        let inset = Inset::new(canvas, &crowded);
        if let Some(inset) = &inset {
            inset.draw(canvas, &self.scheme.words);
        }
        let extent = extent(self.plan, self.scheme.figure.construction);
        let middle = self.view.at(nalgebra::center(&extent.low, &extent.high));
        for (place, here, role) in places {
            // The pole is named in the plan itself, not in the detail.
            let (anchor, away) = match inset.filter(|inset| inset.shows(place) && role != PointRole::Pole) {
                Some(inset) => (inset.at(place), Vec2::ZERO),
                None => (place, place - middle),
            };
            let prefer: Option<Vec2> = (away.hypot() > 4.0).then(|| away.normalize());
            for names in here.chunks(TOGETHER).filter(|names| !self.shown(names).is_empty()) {
                let (last, _) = self.growth(names);
                canvas.set_step(last);
                let clearance = self.dot(role).1 + 0.7;
                let label = canvas.label_renamed(names[0], &self.shown(names), anchor, clearance, prefer);
                label.before = self.growing(names, RichText::math);
            }
        }
        for (place, here, _) in far {
            self.mark_far(canvas, place, &here);
        }
    }

    /// Draws an arrow where the line to a far point leaves the panel, with the point's distance on paper.
    fn mark_far(&self, canvas: &mut Canvas<'_>, place: Point, names: &[&str]) {
        const ARROW: f64 = 8.0;
        let pole = self.plan.kind.pole();
        let laid = self.plan.arrows().find(|laid| names.contains(&laid.to.as_str()));
        let start = laid.map_or(pole, |laid| &laid.from);
        let start = if self.is_far(canvas, start) { pole } else { start };
        let Some(from) = self.at(start) else { return };
        let Some((_, edge)) = clipped_segment(canvas.room().inset(-1.0), from, place) else { return };
        let tail = edge - (edge - from).normalize() * ARROW.min(0.5 * (edge - from).hypot());
        let (last, before) = self.growth(names);
        canvas.set_step(before.first().map_or(last, |(first, _)| *first));
        canvas.draw_named(&format!("point-{}", names[0]), Pen::Special, canvas.arrow(tail, edge));
        let mm = (place - from).hypot() * self.scheme.dims.unit;
        let mm = self.scheme.words.write(mm, NumberStyle::decimals(0).on(Medium::Figure));
        let words = |names: &str| RichText::plain(&self.scheme.words.language.far_in_plan(names, &mm));
        canvas.set_step(last);
        let label = canvas.label_renamed(names[0], "", tail, 1.0, None);
        label.request.text = words(&self.shown(names));
        label.before = self.growing(names, words);
    }

    /// The visible points, grouped by place.
    fn places(&self) -> Vec<(Point, Vec<&str>, PointRole)> {
        let plan = self.plan;
        let mut places: Vec<(Point, Vec<&str>, PointRole)> = Vec::new();
        let at_pole = |name: &str| name.ends_with("_ground") && plan.points[name].vector.norm() == 0.0;
        for (name, point) in &plan.points {
            // The image of a ground point under a slider coincides with the pole: it is left out.
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

    /// Pen and radius of a point's dot.
    fn dot(&self, role: PointRole) -> (Pen, f64) {
        let dot = self.scheme.dims.dot;
        match role {
            PointRole::Pole => (Pen::Pole, 2.0 * dot),
            PointRole::Special => (Pen::Special, (16.0 / 9.0) * dot),
            _ => (Pen::ImagePoint, dot),
        }
    }

    /// What stands at coincident points before the step that adds the last name, and from which step.
    fn growing(&self, names: &[&str], set: impl Fn(&str) -> RichText) -> Vec<(u16, RichText)> {
        let (_, steps) = self.growth(names);
        steps.into_iter().map(|(step, names)| (step, set(&names))).collect()
    }

    /// How the names of coincident points grow with the steps that make them: the step that adds the last name, and
    /// which names there are from which step before.
    fn growth(&self, names: &[&str]) -> (u16, Vec<(u16, String)>) {
        let mut steps: Vec<u16> = names.iter().map(|name| self.stages.point(name)).collect();
        steps.sort_unstable();
        steps.dedup();
        let text = |step: u16| {
            let made: Vec<&str> = names.iter().copied().filter(|name| self.stages.point(name) <= step).collect();
            (step, self.shown(&made))
        };
        let last = steps.pop().unwrap_or_default();
        (last, steps.into_iter().map(text).collect())
    }

    /// The names of coincident points.
    fn shown(&self, names: &[&str]) -> String {
        let mut shown: Vec<String> = names.iter().map(|name| self.scheme.shown(name, Some(self.plan))).collect();
        // A fixed point O and the pole o have the same symbol.
        shown.dedup();
        // The scene may give a name no text.
        shown.retain(|name| !name.is_empty());
        shown.join(", ")
    }
}

/// Draws the hints of a plan's steps: the measured segment; at the start of a ray the direction of the mechanism's line
/// with a right angle.
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

/// Draws a piece of the line normal to a ray from `corner`, and the sign of the right angle.
fn right_angle(canvas: &mut Canvas<'_>, step: u16, corner: Point, ray: Vec2) {
    const SIDE: f64 = 2.0;
    const PIECE: f64 = 7.0;
    let line = Vec2::new(-ray.y, ray.x);
    let ends = Shape::Line(corner - line * PIECE, corner + line * PIECE);
    canvas.draw_in_step(step, Pen::Construction, ends);
    let chain = [line * SIDE, (line + ray) * SIDE, ray * SIDE].map(|v| corner + v);
    canvas.draw_in_step(step, Pen::Frame, Shape::Polyline(chain.to_vec()));
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

/// Whether a name is that of the end of a vanishing normal acceleration, which coincides with another point.
fn is_vanished(plan: &Plan, name: &str) -> bool {
    let end = &plan.points[name];
    let mut others = plan.points.values();
    end.role == PointRole::Normal && others.any(|p| p.role != PointRole::Normal && p.vector == end.vector)
}
