//! Further sheets for a plan whose names crowd: each shows a part of its construction as large as the sheet allows, and
//! all else of the plan pale.
//!
//! A part is what leads to one crossing of two rays and what follows from it: that of a dyad, or one of a larger group.

use super::canvas::Canvas;
use super::context::SheetContext;
use super::layout::{Layout, Needs, Placed};
use super::lines::Line;
use super::panel::{Frame, Panel, numbered};
use super::sheet::{Drawing, Mark, Pen};
use super::text::RichText;
use super::values::is_hidden;
use super::view::{Extent, View};
use super::{compose::Composition, plan};
use crate::construction::{Action, Aim, Passage, Plan, shown_text};
use crate::geometry;
use crate::scene::ValuesShown;
use crate::sheet::Scales;
use kurbo::Rect;
use std::ops::RangeInclusive;

/// Most names of a plan that stand apart, with leaders, before its parts have sheets of their own.
const MOST_APART: usize = 10;
/// By how much a part must be larger than on the figure to have a sheet.
const LARGER: f64 = 1.25;
/// Largest part of a plan's size that has a sheet: what is hardly less than all of it is seen with that panel alone.
const MOST: f64 = 0.5;
/// By how much a part may grow so that the pole is in sight.
const WITH_POLE: f64 = 1.6;

/// A part of a plan's construction.
struct Part {
    /// The passages with its crossings.
    passages: Vec<Passage>,
    steps: RangeInclusive<u16>,
}

/// The sheets for the parts of the plans that are crowded on a figure.
pub(super) fn sheets_of_parts(context: &SheetContext<'_>, layout: &Layout, figure: &Drawing) -> Vec<Drawing> {
    let context = context.with_values_as(ValuesShown::Hidden);
    let panels = layout.panels.iter().zip(&figure.panels).enumerate();
    let crowded = panels.filter(|(_, (_, (name, frame)))| is_crowded(figure, name, *frame));
    let sheets = crowded.flat_map(|(index, (placed, _))| {
        let plan = context.plan(placed.needs.sheet);
        let parts = plan.map_or_else(Vec::new, |plan| parts(&context, plan));
        let heading = numbered(index, &context.sheet_name(placed.needs.sheet));
        let of = plan.map(|plan| PlanInSteps::new(&context, plan));
        let sheets = parts.iter().filter_map(|part| part.sheet(&context, of.as_ref()?, placed, &heading));
        sheets.collect::<Vec<_>>()
    });
    sheets.collect()
}

/// Whether names of a panel have no room, or many stand apart.
fn is_crowded(figure: &Drawing, name: &str, frame: Rect) -> bool {
    let is_apart = |marks: &&[Mark]| {
        let is_name = marks[1].id.as_deref().is_some_and(|id| id.contains("-label-"));
        marks[0].pen == Pen::Leader && is_name && frame.overlaps(marks[1].shape.bounds())
    };
    figure.unlabelled.iter().any(|unlabelled| unlabelled.panel == name)
        || figure.marks.windows(2).filter(is_apart).count() > MOST_APART
}

/// The parts of a plan's construction; none where there is only one.
fn parts(context: &SheetContext<'_>, plan: &Plan) -> Vec<Part> {
    let construction = context.construction();
    let mut parts: Vec<Part> = Vec::new();
    for passage in construction.passages() {
        if construction.steps_of(&passage).next().is_none_or(|step| step.sheet != plan.sheet()) {
            continue;
        }
        let [first, last] = passage.steps.map(|step| step as u16);
        let is_crossing = passage.aim == Aim::Crossing;
        match parts.last_mut().filter(|part| !is_crossing || part.passages.is_empty()) {
            Some(part) => part.steps = *part.steps.start()..=last,
            None => parts.push(Part { passages: Vec::new(), steps: first..=last }),
        }
        if let Some(part) = parts.last_mut().filter(|_| is_crossing) {
            part.passages.push(passage);
        }
    }
    if parts.len() > 1 { parts } else { Vec::new() }
}

/// What parts ask of their plan, looked up once for all of them.
struct PlanInSteps<'a> {
    plan: &'a Plan,
    /// The points from which its vectors and rays start, with the steps of these.
    starts: Vec<(u16, &'a str)>,
    /// Its points that are shown but the pole, with their steps.
    points: Vec<(u16, &'a str, geometry::Point)>,
    /// Its size.
    size: f64,
}

impl<'a> PlanInSteps<'a> {
    fn new(context: &'a SheetContext<'_>, plan: &'a Plan) -> Self {
        let (construction, steps) = (context.construction(), &context.facts.plan_steps[plan.sheet()]);
        let vectors =
            construction.arrows(plan.order).map(|laid| (steps.vector(&laid.from, &laid.to), laid.from.as_str()));
        let rays = construction.rays(plan.order).map(|ray| (steps.ray(&ray.through, &ray.to), ray.through.as_str()));
        let is_shown = |name: &String| *name != plan.order.pole() && !is_hidden(context.figure(), plan, name);
        let points = plan.points.iter().filter(|(name, _)| is_shown(name));
        PlanInSteps {
            plan,
            starts: vectors.chain(rays).collect(),
            points: points.map(|(name, point)| (steps.point(name), name.as_str(), point.vector.into())).collect(),
            size: plan::on_paper::extent(plan, context.figure().construction).size().norm(),
        }
    }
}

impl Part {
    /// Its sheet, if it is larger there than on the figure.
    fn sheet(
        &self,
        context: &SheetContext<'_>,
        of: &PlanInSteps<'_>,
        on_figure: &Placed,
        heading: &str,
    ) -> Option<Drawing> {
        let (plan, sheet) = (of.plan, of.plan.sheet());
        let starts = self.starts(of);
        let extent = self.extent(of, &starts)?;
        let mut context = context.clone();
        context.surface.mu = Scales::default();
        let heading = [RichText::plain(&format!("{heading}:")), RichText::math(&self.crossings(&context, plan))];
        let frame = Frame::new(Line::new(heading.to_vec()), Pen::Heading).with_scale(&context);
        let needs = Needs { is_part: true, ..frame.needs(&context, sheet, extent) };
        let own = &context;
        let layer = move |canvas: &mut Canvas<'_>, view: &View| {
            plan::draw(canvas, view, own, plan);
            canvas.show_part(&self.steps, &starts);
        };
        let name = &own.sheet_name(sheet);
        let panel = Panel {
            language: Some(own.words.language),
            ..Panel::plain(name, sheet.as_str(), needs, frame, vec![Box::new(layer)])
        };
        let teller = own.teller();
        let captions =
            self.passages.iter().map(|passage| shown_text(&teller.passage_caption(passage), Some(plan), &own.words));
        let description = captions.collect::<Vec<_>>().join(" ");
        let sheet = Composition { description, ..Composition::new(own, vec![panel]) };
        let layout = sheet.layout();
        let is_larger = layout.panels.first().is_some_and(|placed| LARGER * placed.mu <= on_figure.mu);
        is_larger.then(|| sheet.draw(&layout))
    }

    /// The names of the points at which its rays cross, in markup.
    fn crossings(&self, context: &SheetContext<'_>, plan: &Plan) -> String {
        let steps = self.passages.iter().flat_map(|passage| context.construction().steps_of(passage));
        let points = steps.filter_map(|step| match step.action {
            Action::Cross { point, .. } => Some(context.shown(point, Some(plan))),
            _ => None,
        });
        points.collect::<Vec<_>>().join(", ")
    }

    /// The points of the plan from which its vectors and rays start.
    fn starts(&self, of: &PlanInSteps<'_>) -> Vec<String> {
        let own = of.starts.iter().filter(|(step, _)| self.steps.contains(step));
        own.map(|(_, name)| (*name).to_owned()).collect()
    }

    /// What of the plan must be in sight: its points and those from which it starts, and the pole where that is near; none
    /// where that is a single place, to rounding, or most of the plan.
    fn extent(&self, of: &PlanInSteps<'_>, starts: &[String]) -> Option<Extent> {
        let is_own = |step: &u16, name: &str| self.steps.contains(step) || starts.iter().any(|start| start == name);
        let shown = of.points.iter().filter(|(step, name, _)| is_own(step, name));
        let extent = Extent::of(shown.map(|(.., place)| *place));
        let whole = extent.with(geometry::Point::origin());
        let size = extent.size().norm();
        (!of.plan.is_nothing(size) && size <= MOST * of.size)
            .then(|| if whole.size().norm() <= WITH_POLE * size { whole } else { extent })
    }
}
