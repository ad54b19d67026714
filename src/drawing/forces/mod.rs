//! The panel of the force plan: polygons, each link's part of them in its tint, with the directions that close them.

pub(super) mod values;

use super::canvas::{Canvas, Wanted};
use super::clip::clipped_segment;
use super::context::SheetContext;
use super::labels::LabelRequest;
use super::layout::ROW;
use super::shape::{Shape, around};
use super::sheet::Pen;
use super::text::RichText;
use super::view::{Extent, View, towards};
use crate::construction::{
    Action, Construction, ForceOf, ForcePart, ForcePlan, ForceStep, NOTHING, Polygon, Side, SideKind, display,
};
use crate::geometry;
use crate::mechanism::{BodyId, Mechanism};
use crate::scene::{Head, QuantityName};
use crate::sheet::Sheet;
use kurbo::{Point, Vec2};

/// White below the heading for the name of the uppermost polygon, in mm.
pub(super) const ABOVE: f64 = ROW;
/// Length of a direction beyond the ends of its side, in mm.
const BEYOND: f64 = 5.0;

/// The extent of all polygons.
pub(super) fn extent(construction: &Construction) -> Option<Extent> {
    let plan = construction.forces.as_deref()?;
    let ends = plan
        .polygons
        .iter()
        .flat_map(|polygon| &polygon.sides)
        .flat_map(|side| [side.from, side.from + side.vector].map(geometry::Point::from));
    Some(Extent::of(ends))
}

/// Draws the panel.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let Some(plan) = context.construction().forces.as_deref() else { return };
    let steps = ForceSteps::of(context, plan);
    let panel = PolygonsOnPaper { view, context, plan, steps };
    panel.areas(canvas);
    panel.directions(canvas);
    panel.sides(canvas);
    panel.corners(canvas);
    canvas.step = 0;
}

/// Draws the points in which polygons begin, each with the links that are cut free, for a hand that draws the rest.
pub(super) fn draw_starts(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let Some(plan) = context.construction().forces.as_deref() else { return };
    canvas.step = 0;
    for (index, polygon) in plan.polygons.iter().enumerate() {
        let name = format!("o{}", index + 1);
        let Some(corner) = plan.corner(&name) else { continue };
        let (center, radius) = (view.at(corner.at.into()), 2.0 * context.surface.dims.dot);
        canvas.draw_named(&format!("point-{name}"), Pen::Pole, Shape::Circle { center, radius });
        let label = RichText::math(&display(&name));
        canvas.ask(&format!("{name}-"), LabelRequest::new(label, center, radius + 0.7, None, 2));
        let links = RichText::plain(&context.teller().links_in_words(&polygon.links));
        let request =
            LabelRequest { priority: 0, ..LabelRequest::new(links, center, 4.0, Some(Vec2::new(0.0, -1.0)), 0) };
        let wanted = Wanted::new(format!("links-{}", index + 1), request);
        canvas.request_label(Wanted { pen: Pen::Caption, optional: true, last: true, ..wanted });
    }
}

/// The steps with which things appear.
pub(in crate::drawing) struct ForceSteps {
    /// By polygon and side.
    pub(in crate::drawing) sides: Vec<Vec<u16>>,
    /// By polygon and side: the step that draws its direction.
    directions: Vec<Vec<Option<u16>>>,
}

impl ForceSteps {
    pub(in crate::drawing) fn of(context: &SheetContext<'_>, plan: &ForcePlan) -> ForceSteps {
        let mut steps = ForceSteps {
            sides: plan.polygons.iter().map(|polygon| vec![0; polygon.sides.len()]).collect(),
            directions: plan.polygons.iter().map(|polygon| vec![None; polygon.sides.len()]).collect(),
        };
        for step in context.construction().numbered_steps() {
            let number = step.number as u16;
            let Action::Force(action) = step.action else { continue };
            match *action {
                ForceStep::LayOff(polygon, side) | ForceStep::Close(polygon, side) | ForceStep::Join(polygon, side) => {
                    steps.sides[polygon][side] = number
                }
                ForceStep::Direction(polygon, side) => steps.directions[polygon][side] = Some(number),
                ForceStep::Cross(polygon, side) => steps.sides[polygon][side..=side + 1].fill(number),
                _ => {}
            }
        }
        steps
    }
}

/// The polygons as they stand on a sheet.
struct PolygonsOnPaper<'a> {
    view: &'a View,
    context: &'a SheetContext<'a>,
    plan: &'a ForcePlan,
    steps: ForceSteps,
}

impl PolygonsOnPaper<'_> {
    fn ends(&self, side: &Side) -> [Point; 2] {
        [side.from, side.from + side.vector].map(|end| self.view.at(end.into()))
    }

    /// Whether something of a force is seen.
    fn is_seen(&self, side: &Side) -> bool {
        let all = self.plan.polygons.iter().flat_map(|polygon| &polygon.sides);
        let largest = all.map(|side| side.vector.norm()).fold(0.0, f64::max);
        side.vector.norm() > NOTHING * largest
    }

    /// The part of each link in its tint, once the polygon is closed.
    fn areas(&self, canvas: &mut Canvas<'_>) {
        for (polygon, steps) in self.plan.polygons.iter().zip(&self.steps.sides) {
            for link in links(self.context.mechanism(), polygon) {
                let Some(corners) = corners(self.context.mechanism(), polygon, link) else { continue };
                canvas.step = steps.iter().copied().max().unwrap_or_default();
                let corners: Vec<Point> = corners.into_iter().map(|corner| self.view.at(corner.into())).collect();
                canvas.draw(Pen::LinkFill, Shape::Polygon(corners)).number = self.context.number(link);
            }
        }
    }

    /// The lines of known direction.
    fn directions(&self, canvas: &mut Canvas<'_>) {
        if !self.context.figure().construction.has_lines() {
            return;
        }
        for (polygon, steps) in self.plan.polygons.iter().zip(&self.steps.directions) {
            for (side, step) in polygon.sides.iter().zip(steps) {
                let Some(step) = step else { continue };
                let [from, to] = self.ends(side);
                let along = towards(from, to, Vec2::new(1.0, 0.0));
                if let Some((a, b)) = clipped_segment(canvas.room(), from - along * BEYOND, to + along * BEYOND) {
                    canvas.step = *step;
                    canvas.draw(Pen::Ray, Shape::Line(a, b));
                }
            }
        }
    }

    /// The forces with their symbols.
    fn sides(&self, canvas: &mut Canvas<'_>) {
        let teller = self.context.teller();
        for (number, (polygon, steps)) in self.plan.polygons.iter().zip(&self.steps.sides).enumerate() {
            for (index, (side, step)) in polygon.sides.iter().zip(steps).enumerate() {
                if !self.is_seen(side) {
                    continue;
                }
                canvas.step = *step;
                let [from, to] = self.ends(side);
                let name = format!("force-{}-{}", number + 1, index + 1);
                canvas.draw_named(&name, pen(side), canvas.arrow(from, to)).number = self.context.number(side.on);
                let along = towards(from, to, Vec2::new(1.0, 0.0));
                let across = Vec2::new(-along.y, along.x);
                let (at, _) = canvas.free_side([from, to], across);
                let request = LabelRequest::new(RichText::math(&teller.force_symbol(side.of)), at, 0.9, None, 2);
                canvas.ask(&name, request);
            }
            self.name(canvas, number, polygon, steps);
        }
    }
}

impl PolygonsOnPaper<'_> {
    /// The names of corners, where the scene asks for what lies between them.
    fn corners(&self, canvas: &mut Canvas<'_>) {
        let scene = &self.context.solution.scene;
        let form = scene.form.iter().flat_map(|form| form.keys());
        let asked = scene.want.iter().flatten().chain(form).filter_map(|name| QuantityName::parse(name));
        if !asked.into_iter().any(|name| name.head == Head::Between(Sheet::Forces)) {
            return;
        }
        let radius = self.context.surface.dims.dot;
        for (name, corner) in self.plan.named_corners() {
            // It is there once a side begins or ends in it.
            let polygon = &self.plan.polygons[corner.polygon];
            let steps = polygon.sides.iter().zip(&self.steps.sides[corner.polygon]);
            let here = steps.filter(|(side, _)| side.ends.contains(&corner.place));
            canvas.step = here.map(|(_, step)| *step).min().unwrap_or_default();
            let center = self.view.at(corner.at.into());
            canvas.draw_named(&format!("corner-{name}"), Pen::Pole, Shape::Circle { center, radius });
            let label = RichText::math(&display(name));
            canvas.ask(&format!("corner-{name}-"), LabelRequest::new(label, center, radius + 0.7, None, 2));
        }
    }

    /// The links whose polygon it is, above it.
    fn name(&self, canvas: &mut Canvas<'_>, number: usize, polygon: &Polygon, steps: &[u16]) {
        let Some(first) = steps.iter().copied().filter(|step| *step > 0).min() else { return };
        let ends: Vec<Point> = polygon.sides.iter().flat_map(|side| self.ends(side)).collect();
        let around = around(&ends);
        canvas.step = first;
        let text = RichText::plain(&self.context.teller().links_in_words(&polygon.links));
        let at = Point::new(around.center().x, around.y0);
        let request = LabelRequest::new(text, at, 4.0, Some(Vec2::new(0.0, -1.0)), 3);
        let wanted = Wanted::new(format!("links-{}", number + 1), request);
        canvas.request_label(Wanted { pen: Pen::Caption, optional: true, ..wanted });
    }
}

/// The pen of a side.
pub(super) fn pen(side: &Side) -> Pen {
    match (side.of, side.kind) {
        (ForceOf::Load(_), _) => Pen::Acceleration,
        (ForceOf::Both { .. }, _) => Pen::Normal,
        (ForceOf::Joint { part: ForcePart::Whole, .. }, _) => Pen::Velocity,
        (ForceOf::Joint { part: ForcePart::Normal | ForcePart::AcrossGuide, .. }, _) => Pen::Normal,
        (ForceOf::Joint { part: ForcePart::Tangential | ForcePart::AlongGuide, .. }, _) => Pen::Tangential,
    }
}

/// The links on which the forces of a polygon act: of a compound link its lead.
fn links(mechanism: &Mechanism, polygon: &Polygon) -> Vec<BodyId> {
    let mut links: Vec<BodyId> = polygon.links.iter().map(|&body| mechanism.lead(body)).collect();
    links.sort_unstable();
    links.dedup();
    links
}

/// The corners of the closed chain of the forces on one link; `None` where they do not stand head to tail.
fn corners(mechanism: &Mechanism, polygon: &Polygon, link: BodyId) -> Option<Vec<geometry::Vector>> {
    let is_part = |side: &&Side| mechanism.lead(side.on) == link;
    let has_parts = |side: &Side| {
        match side.of {
        ForceOf::Joint { joint, part: ForcePart::Whole, .. } => polygon.sides.iter().any(|other| {
            matches!(other.of, ForceOf::Joint { joint: own, part, .. } if own == joint && part != ForcePart::Whole)
        }),
        _ => false,
    }
    };
    let mut left: Vec<&Side> = polygon
        .sides
        .iter()
        .filter(is_part)
        .filter(|side| side.kind != SideKind::Diagonal || !has_parts(side))
        .collect();
    let first = left.pop()?;
    let (mut corners, mut end) = (vec![first.from], first.ends[1]);
    while !left.is_empty() {
        let next = left.iter().position(|side| side.ends[0] == end)?;
        let side = left.swap_remove(next);
        corners.push(side.from);
        end = side.ends[1];
    }
    (end == first.ends[0] && corners.len() > 2).then_some(corners)
}
