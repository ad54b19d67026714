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
        let heading = numbered(index, context.words.language.sheet(placed.needs.sheet));
        let sheets = parts.iter().filter_map(|part| part.sheet(&context, plan?, placed, &heading));
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

impl Part {
    /// Its sheet, if it is larger there than on the figure.
    fn sheet(&self, context: &SheetContext<'_>, plan: &Plan, on_figure: &Placed, heading: &str) -> Option<Drawing> {
        let sheet = plan.sheet();
        let mut context = context.clone();
        context.surface.mu = Scales::default();
        let starts = self.starts(&context, plan);
        let extent = self.extent(&context, plan, &starts)?;
        let heading = [RichText::plain(&format!("{heading}:")), RichText::math(&self.crossings(&context, plan))];
        let frame = Frame::new(Line::new(heading.to_vec()), Pen::Heading).with_scale(&context);
        let needs = Needs { is_part: true, ..frame.needs(&context, sheet, extent) };
        let own = &context;
        let layer = move |canvas: &mut Canvas<'_>, view: &View| {
            plan::draw(canvas, view, own, plan);
            canvas.show_part(&self.steps, &starts);
        };
        let name = own.words.language.sheet(sheet);
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
    fn starts(&self, context: &SheetContext<'_>, plan: &Plan) -> Vec<String> {
        let (construction, steps) = (context.construction(), &context.facts.plan_steps[plan.sheet()]);
        let vectors =
            construction.arrows(plan.order).filter(|laid| self.steps.contains(&steps.vector(&laid.from, &laid.to)));
        let rays = construction.rays(plan.order).filter(|ray| self.steps.contains(&steps.ray(&ray.through, &ray.to)));
        vectors.map(|laid| laid.from.clone()).chain(rays.map(|ray| ray.through.clone())).collect()
    }

    /// What of the plan must be in sight: its points and those from which it starts, and the pole where that is near; none
    /// where that is a single place, to rounding, or most of the plan.
    fn extent(&self, context: &SheetContext<'_>, plan: &Plan, starts: &[String]) -> Option<Extent> {
        let steps = &context.facts.plan_steps[plan.sheet()];
        let is_own = |name: &String| self.steps.contains(&steps.point(name)) || starts.contains(name);
        let shown = plan
            .points
            .iter()
            .filter(|(name, _)| is_own(name) && *name != plan.order.pole() && !is_hidden(context.figure(), plan, name));
        let places: Vec<geometry::Point> = shown.map(|(_, point)| point.vector.into()).collect();
        let extent = Extent::of(places.iter().copied());
        let whole = extent.with(geometry::Point::origin());
        let size = extent.size().norm();
        let all = plan::on_paper::extent(plan, context.figure().construction).size().norm();
        (!plan.is_nothing(size) && size <= MOST * all)
            .then(|| if whole.size().norm() <= WITH_POLE * size { whole } else { extent })
    }
}
