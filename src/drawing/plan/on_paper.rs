//! A plan in a view: images of links, rays and vectors; points with their names. Coincident points share a
//! label, crowds have an enlarged detail, and far points stand as arrows at the edge. And what of a plan is in sight: its extent,
//! and which points are drawn.

use crate::construction::{Arrow, Plan, PlanVector, PointRole, VectorOf, VectorPart, coincident_name, image_name};
use crate::drawing::canvas::{Canvas, Inset};
use crate::drawing::clip::{clipped_segment, holds};
use crate::drawing::context::SheetContext;
use crate::drawing::facts::PlanSteps;
use crate::drawing::labels::LabelRequest;
use crate::drawing::scheme::on_paper::outline;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Mark, Pen};
use crate::drawing::text::RichText;
use crate::drawing::values::{VALUE, is_hidden};
use crate::drawing::view::{Extent, ONE_PLACE, Series, View, on_sheet, together_where};
use crate::geometry;
use crate::mechanism::{Body, Mechanism};
use crate::scene::ConstructionShown;
use crate::words::{Medium, NumberStyle};
use indexmap::IndexMap;
use kurbo::{Point, Vec2};

/// White between the room of a panel and the points in it, in mm.
const EDGE: f64 = 1.5;
/// That at the frame itself, in mm: no head or dot is cut off there.
const DOT: f64 = 1.0;
/// Length of a ray beyond the crossing, in mm.
const BEYOND: f64 = 5.0;

/// Plan points closer than this on paper, in mm, share one label.
const SHARED: f64 = 0.35;
/// Most names of coincident points in one label.
const TOGETHER: usize = 5;

/// Largest size of a plan with a point that only leads to others over that without it; a more distant one is not drawn
/// at its place, but where its line leaves the panel.
const REACH: f64 = 2.0;

/// A plan as it stands on a sheet.
pub(super) struct PlanOnPaper<'a> {
    pub view: &'a View,
    pub context: &'a SheetContext<'a>,
    pub plan: &'a Plan,
    pub steps: &'a PlanSteps,
    /// By link: the points of its image.
    images: Vec<Vec<String>>,
    /// By point: the numbers of the links that have an image there, in rising order.
    images_at: IndexMap<String, Vec<usize>>,
    /// By link: whether its image has a point at rest.
    arms: Vec<bool>,
    /// By the image of a special point: the number of its link.
    special: IndexMap<String, Option<usize>>,
    /// What the plan's scale makes room for.
    extent: Extent,
}

impl<'a> PlanOnPaper<'a> {
    pub(super) fn new(view: &'a View, context: &'a SheetContext<'a>, plan: &'a Plan) -> Self {
        let steps = &context.facts.plan_steps[plan.sheet()];
        let extent = extent(plan, context.figure().construction);
        let images = images(context.mechanism(), plan);
        let mut images_at: IndexMap<String, Vec<usize>> = IndexMap::new();
        for (number, image) in images.iter().enumerate() {
            image.iter().for_each(|name| images_at.entry(name.clone()).or_default().push(number));
        }
        let is_at_rest = |name: &String| plan.points[name].role == PointRole::Pole;
        let arms = images.iter().map(|image| image.iter().any(is_at_rest)).collect();
        let mut special = IndexMap::new();
        for own in &context.construction().special {
            special.entry(image_name(&own.name)).or_insert_with(|| context.number(own.link));
        }
        PlanOnPaper { view, context, plan, steps, images, images_at, arms, special, extent }
    }

    pub(super) fn at(&self, name: &str) -> Option<Point> {
        self.plan.points.get(name).map(|point| self.view.at(point.vector.into()))
    }

    /// The middle of the plan on the sheet.
    pub(super) fn middle(&self) -> Point {
        self.view.at(nalgebra::center(&self.extent.low, &self.extent.high))
    }

    /// Whether a point that only leads to others is not drawn at its place, but where its line leaves the panel: one that
    /// would make the plan small, where the panel has no room for it; and one that the panel's scale puts off it.
    pub(super) fn is_far(&self, canvas: &Canvas<'_>, name: &str) -> bool {
        let Some(point) = self.plan.points.get(name).filter(|point| !is_image(point.role)) else { return false };
        let place = point.vector.into();
        let is_of_extent = self.extent.with(place) == self.extent;
        let room = if is_of_extent { canvas.frame.inset(-DOT) } else { canvas.room().inset(-EDGE) };
        !holds(room, self.view.at(place))
    }

    fn is_hidden(&self, name: &str) -> bool {
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

    /// The links' images: their areas, or with the pen of images their outlines.
    pub(super) fn images(&self, canvas: &mut Canvas<'_>, pen: Pen) {
        for (number, image) in self.images.iter().enumerate() {
            let (corners, since) = self.corners(image);
            let shape = match corners.as_slice() {
                [_, _, _, ..] => Shape::Polygon(corners),
                [a, b] if pen == Pen::Image => Shape::Line(*a, *b),
                _ => continue,
            };
            canvas.step = since;
            canvas.draw(pen, shape).number = Some(number);
        }
    }

    /// The rays, lines of known direction.
    pub(super) fn rays(&self, canvas: &mut Canvas<'_>) {
        if !(self.context.figure().construction.has_lines() && self.context.figure().special_points) {
            return;
        }
        for ray in self.context.construction().rays(self.plan.order) {
            let (Some(from), Some(to)) = (self.at(&ray.through), self.at(&ray.to)) else {
                continue;
            };
            let along = on_sheet(ray.direction);
            let along = if (to - from).dot(along) < 0.0 { -along } else { along };
            let ends = (from - along * (0.5 * BEYOND), to + along * BEYOND);
            if let Some((a, b)) = clipped_segment(canvas.room(), ends.0, ends.1) {
                let name = format!("ray-{}-{}", ray.through, ray.to);
                canvas.step = self.steps.ray(&ray.through, &ray.to);
                canvas.draw_named(&name, Pen::Ray, Shape::Line(a, b));
            }
        }
    }

    /// The vectors, those from the pole first.
    pub(super) fn vectors(&self, canvas: &mut Canvas<'_>) {
        let (plan, construction) = (self.plan, self.context.construction());
        let (order, pole) = (plan.order, plan.order.pole());
        for name in plan.points.keys().filter(|name| self.is_end_of_whole(name)) {
            canvas.step = self.steps.point(name);
            self.arrow(canvas, [pole, name], VectorPart::Whole, self.link_of(name));
        }
        for laid in construction.arrows(order) {
            // For a slider on the ground this vector has been drawn from the pole.
            let again = self.at(&laid.from) == self.at(pole) && self.is_end_of_whole(&laid.to);
            if self.is_hidden(&laid.to) || again {
                continue;
            }
            canvas.step = self.steps.vector(&laid.from, &laid.to);
            let part = laid.part();
            let number = match Pen::of_vectors(order, part) {
                // The side of a link's image has the look of the image.
                Pen::Image => {
                    let [from, to] = [&laid.from, &laid.to].map(|name| self.images_at(name));
                    from.iter().copied().find(|number| to.contains(number))
                }
                _ => self.link_of_vector(laid),
            };
            self.arrow(canvas, laid.ends(), part, number);
        }
    }

    /// Whether a vector from the pole ends at a point.
    fn is_end_of_whole(&self, name: &str) -> bool {
        // In the source paper's plans no such vector goes to a point that a relative motion leads to.
        let is_paper = self.context.figure().construction == ConstructionShown::Paper;
        let is_met = || self.context.construction().rays(self.plan.order).any(|ray| ray.to == name);
        let is_whole = match self.plan.points.get(name).map(|p| p.role) {
            Some(PointRole::Special) => true,
            Some(PointRole::Image | PointRole::Known) => !is_paper || is_met(),
            _ => false,
        };
        is_whole && !self.is_hidden(name)
    }

    /// The vectors that rays carry, once the points on them are there; where a later step lays off the same vector, until
    /// then.
    pub(super) fn vectors_on_rays(&self, canvas: &mut Canvas<'_>) {
        let (construction, order) = (self.context.construction(), self.plan.order);
        let teller = self.context.teller();
        let mut all_laid: IndexMap<[&str; 2], u16> = IndexMap::new();
        for laid in construction.arrows(order) {
            all_laid.entry(laid.ends()).or_insert_with(|| self.steps.vector(&laid.from, &laid.to));
        }
        for ray in construction.rays(order) {
            let ends = [&ray.through, &ray.to];
            let is_shown = !ends.into_iter().any(|name| self.is_hidden(name) || self.is_far(canvas, name));
            // From a point at rest it is the vector from the pole.
            let again = self.at(&ray.through) == self.at(order.pole()) && self.is_end_of_whole(&ray.to);
            let vector = if is_shown && !again { teller.vector_on(ray) } else { None };
            let Some(PlanVector { ends: [from, to], part, made, link, .. }) = vector else { continue };
            let laid = all_laid.get(&[from.as_str(), to.as_str()]).copied();
            canvas.step = self.steps.point(&made);
            if laid.is_some_and(|laid| laid <= canvas.step) {
                continue;
            }
            let number = link.and_then(|link| self.context.number(link));
            if let (Some(mark), Some(_)) = (self.arrow(canvas, [&from, &to], part, number), laid) {
                (mark.id, mark.until) = (None, laid);
            }
        }
    }

    /// Number of the link to which the vector from the pole to a point belongs: of those with an image there, one with
    /// a point at rest if there is one, as this vector is the image of its arm; else the first.
    fn link_of(&self, name: &str) -> Option<usize> {
        let with = self.images_at(name);
        let arm = with.iter().find(|number| self.arms[**number]);
        let image = arm.or_else(|| with.first()).copied();
        image.or_else(|| self.special.get(name).copied().flatten())
    }

    /// The numbers of the links that have an image at a point.
    fn images_at(&self, name: &str) -> &[usize] {
        self.images_at.get(name).map_or(&[], Vec::as_slice)
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
    fn arrow<'c>(
        &self,
        canvas: &'c mut Canvas<'_>,
        [from, to]: [&str; 2],
        part: VectorPart,
        number: Option<usize>,
    ) -> Option<&'c mut Mark> {
        let pen = Pen::of_vectors(self.plan.order, part);
        let name = format!("vector-{from}-{to}");
        let is_far = self.is_far(canvas, from) || self.is_far(canvas, to);
        let (from, to) = self.at(from).zip(self.at(to))?;
        let (pen, shape) = match is_far {
            true => clipped_segment(canvas.room(), from, to).map(|(a, b)| (Pen::Construction, Shape::Line(a, b))),
            false => ((to - from).hypot() > 1e-3).then(|| (pen, canvas.arrow(from, to))),
        }?;
        let mark = canvas.draw_named(&name, pen, shape);
        mark.number = number;
        Some(mark)
    }

    /// Draws dots and labels of the points; coincident points share a label.
    pub(super) fn points(&self, canvas: &mut Canvas<'_>) {
        let (far, places): (Vec<_>, Vec<_>) =
            self.places().into_iter().partition(|(_, here, _)| self.is_far(canvas, here[0]));
        let since = |here: &[&str]| here.iter().map(|name| self.steps.point(name)).min().unwrap_or_default();
        for (center, here, role) in &places {
            let (center, (pen, radius)) = (*center, self.dot(*role));
            canvas.step = since(here);
            canvas.draw_named(&format!("point-{}", here[0]), pen, Shape::Circle { center, radius });
        }
        let crowded: Vec<Point> = places.iter().map(|(place, ..)| *place).collect();
        let inset = if self.context.surface.details { Inset::new(canvas, &crowded) } else { None };
        if let Some(inset) = &inset {
            inset.draw(canvas, &self.context.words);
        }
        let middle = self.middle();
        for (place, here, role) in places {
            // The pole is named in the plan itself, not in the detail.
            let (anchor, away) = match inset.filter(|inset| inset.shows(place) && role != PointRole::Pole) {
                Some(inset) => (inset.at(place), Vec2::ZERO),
                None => (place, place - middle),
            };
            let prefer: Option<Vec2> = (away.hypot() > 4.0).then(|| away.normalize());
            for names in here.chunks(TOGETHER).filter(|names| !self.shown(names).is_empty()) {
                let (last, before) = self.growth(names, RichText::math);
                canvas.step = last;
                let clearance = self.dot(role).1 + 0.7;
                let text = RichText::math(&self.shown(names));
                let label = canvas.ask(&id(names), LabelRequest::new(text, anchor, clearance, prefer, 2));
                label.before = before;
            }
        }
        for (place, here, _) in far {
            self.mark_far(canvas, place, &here);
        }
    }

    /// Draws an arrow where the line to a far point leaves the panel, with the point's distance on paper.
    fn mark_far(&self, canvas: &mut Canvas<'_>, place: Point, names: &[&str]) {
        const ARROW: f64 = 8.0;
        let pole = self.plan.order.pole();
        let mut arrows = self.context.construction().arrows(self.plan.order);
        let laid = arrows.find(|laid| names.contains(&laid.to.as_str()));
        let start = laid.map_or(pole, |laid| &laid.from);
        let start = if self.is_far(canvas, start) { pole } else { start };
        let Some(from) = self.at(start) else { return };
        let Some((_, edge)) = clipped_segment(canvas.room().inset(-1.0), from, place) else { return };
        let tail = edge - (edge - from).normalize() * ARROW.min(0.5 * (edge - from).hypot());
        let distance = self.distance((place - from).hypot());
        let words = |names: &str| match names {
            "" => RichText::plain(&distance),
            names => RichText::plain(&self.context.words.language.far_in_plan(names, &distance)),
        };
        let (last, before) = self.growth(names, words);
        canvas.step = before.first().map_or(last, |(first, _)| *first);
        canvas.draw_named(&format!("point-{}", names[0]), Pen::Special, canvas.arrow(tail, edge));
        canvas.step = last;
        let text = words(&self.shown(names));
        let label = canvas.ask(&id(names), LabelRequest::new(text, tail, 1.0, None, 2));
        let shown = self.shown(names);
        label.short = (before.is_empty() && !shown.is_empty()).then(|| RichText::math(&shown));
        label.before = before;
    }

    /// A distance on the sheet as it is told: on paper in mm, and in the plan's own unit where nobody measures.
    fn distance(&self, of: f64) -> String {
        let words = &self.context.words;
        if self.context.surface.series != Series::Any {
            let mm = words.write(of * self.context.surface.dims.unit, NumberStyle::decimals(0).on(Medium::Figure));
            return format!("{mm} mm");
        }
        let unit = self.plan.sheet().facts().drawn.unit(self.context.solution.scene.units);
        format!("{} {unit}", words.write(of * self.view.mu(), VALUE))
    }

    /// The visible points, those of one place together; what only lies close on paper has a name of its own.
    fn places(&self) -> Vec<(Point, Vec<&'a str>, PointRole)> {
        let plan = self.plan;
        // The image of a ground point under a slider coincides with the pole: it is left out.
        let at_pole = |name: &str| name.ends_with("_ground") && plan.points[name].vector.norm() == 0.0;
        let names = plan.points.keys().map(String::as_str);
        // A normal acceleration that vanishes ends where it starts. Another one may end in a point, too, as in a dead centre: it is named there.
        let is_vanished = |name: &str| {
            let end = &plan.points[name];
            let mut laid = self.context.construction().arrows(plan.order);
            let start = laid.find(|laid| laid.to == name).and_then(|laid| plan.points.get(&laid.from));
            end.role == PointRole::Normal && start.is_some_and(|start| start.vector == end.vector)
        };
        let shown = names.filter(|name| !self.is_hidden(name) && !at_pole(name) && !is_vanished(name));
        let places = shown.map(|name| (self.view.at(plan.points[name].vector.into()), name));
        let role = |(place, here): (Point, Vec<&'a str>)| {
            let role = plan.points[here[0]].role;
            (place, here, role)
        };
        let largest = plan.points.values().map(|point| point.vector.norm()).fold(0.0, f64::max);
        let place = |name: &str| plan.points[name].vector;
        let is_one = |a: &&str, b: &&str| (place(a) - place(b)).norm() <= ONE_PLACE * largest;
        together_where(places, SHARED, is_one).into_iter().map(role).collect()
    }

    /// Pen and radius of a point's dot.
    fn dot(&self, role: PointRole) -> (Pen, f64) {
        let dot = self.context.surface.dims.dot;
        match role {
            PointRole::Pole => (Pen::Pole, 2.0 * dot),
            PointRole::Special => (Pen::Special, (16.0 / 9.0) * dot),
            _ => (Pen::ImagePoint, dot),
        }
    }

    /// How the names of coincident points grow with the steps that make them: the step that adds the last name, and what
    /// stands there before, from which step.
    fn growth(&self, names: &[&str], set: impl Fn(&str) -> RichText) -> (u16, Vec<(u16, RichText)>) {
        let mut steps: Vec<u16> = names.iter().map(|name| self.steps.point(name)).collect();
        steps.sort_unstable();
        steps.dedup();
        let text = |step: u16| {
            let made: Vec<&str> = names.iter().copied().filter(|name| self.steps.point(name) <= step).collect();
            (step, set(&self.shown(&made)))
        };
        let last = steps.pop().unwrap_or_default();
        (last, steps.into_iter().map(text).collect())
    }

    /// The names of coincident points.
    fn shown(&self, names: &[&str]) -> String {
        let labelled = names.iter().filter(|name| !self.context.is_unlabelled(name));
        let mut shown: Vec<String> = labelled.map(|name| self.context.shown(name, Some(self.plan))).collect();
        // A fixed point O and the pole o have the same symbol.
        shown.dedup();
        shown.join(", ")
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

/// The id of the label of coincident points; the hyphen at its end tells it from the label of a joint of this name.
fn id(names: &[&str]) -> String {
    format!("{}-", names[0])
}

/// The extent of the plan's points, without far ones that only lead to others: with each of those, taken from the
/// nearest on, the plan must not grow by more than `REACH`. A plan as in the source paper has them all.
pub(in crate::drawing) fn extent(plan: &Plan, shown: ConstructionShown) -> Extent {
    let images = extent_of_images(plan);
    let leading = plan.points.values().filter(|p| !is_image(p.role)).map(|p| p.vector.into());
    let mut leading: Vec<geometry::Point> = leading.collect();
    let size = |place: &geometry::Point| images.with(*place).size().norm();
    leading.sort_by(|a, b| size(a).total_cmp(&size(b)));
    let mut extent = images;
    for place in leading {
        let larger = extent.with(place);
        if shown != ConstructionShown::Paper && larger.size().norm() > REACH * extent.size().norm() {
            break;
        }
        extent = larger;
    }
    extent
}

/// Whether a point stands for one of the mechanism, and does not only lead to others.
pub(super) fn is_image(role: PointRole) -> bool {
    matches!(role, PointRole::Pole | PointRole::Known | PointRole::Image)
}

/// The extent of the pole and the images alone, without the points that lead to them.
pub(in crate::drawing) fn extent_of_images(plan: &Plan) -> Extent {
    Extent::of(plan.points.values().filter(|p| is_image(p.role)).map(|p| p.vector.into()))
}
