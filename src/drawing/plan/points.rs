//! Points of a plan with their names: coincident ones share a label, crowds have an enlarged detail, and far ones stand
//! as arrows at the edge.

use super::on_paper::PlanOnPaper;
use super::sight::extent;
use crate::construction::{Plan, PointRole};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::clipped_segment;
use crate::drawing::held::Inset;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::RichText;
use crate::geometry;
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Vec2};

/// Plan points closer than this on paper, in mm, share one label.
const SHARED: f64 = 0.35;
/// Most names of coincident points in one label.
const TOGETHER: usize = 5;

impl PlanOnPaper<'_> {
    /// Draws dots and labels of the points; coincident points share a label.
    pub(super) fn points(&self, canvas: &mut Canvas<'_>) {
        let (far, places): (Vec<_>, Vec<_>) =
            self.places().into_iter().partition(|(_, here, _)| self.is_far(canvas, here[0]));
        let since = |here: &[&str]| here.iter().map(|name| self.steps.point(name)).min().unwrap_or_default();
        for (center, here, role) in &places {
            let (center, (pen, radius)) = (*center, self.dot(*role));
            canvas.set_step(since(here));
            canvas.draw_named(&format!("point-{}", here[0]), pen, Shape::Circle { center, radius });
        }
        let crowded: Vec<Point> = places.iter().map(|(place, ..)| *place).collect();
        let inset = Inset::new(canvas, &crowded);
        if let Some(inset) = &inset {
            inset.draw(canvas, &self.context.words);
        }
        let extent = extent(self.plan, self.context.figure().construction);
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
        let pole = self.plan.sheet.pole();
        let laid = self.plan.arrows().find(|laid| names.contains(&laid.to.as_str()));
        let start = laid.map_or(pole, |laid| &laid.from);
        let start = if self.is_far(canvas, start) { pole } else { start };
        let Some(from) = self.at(start) else { return };
        let Some((_, edge)) = clipped_segment(canvas.room().inset(-1.0), from, place) else { return };
        let tail = edge - (edge - from).normalize() * ARROW.min(0.5 * (edge - from).hypot());
        let (last, before) = self.growth(names);
        canvas.set_step(before.first().map_or(last, |(first, _)| *first));
        canvas.draw_named(&format!("point-{}", names[0]), Pen::Special, canvas.arrow(tail, edge));
        let mm = (place - from).hypot() * self.context.surface.dims.unit;
        let mm = self.context.words.write(mm, NumberStyle::decimals(0).on(Medium::Figure));
        let words = |names: &str| RichText::plain(&self.context.words.language.far_in_plan(names, &mm));
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
        let dot = self.context.surface.dims.dot;
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
        let mut steps: Vec<u16> = names.iter().map(|name| self.steps.point(name)).collect();
        steps.sort_unstable();
        steps.dedup();
        let text = |step: u16| {
            let made: Vec<&str> = names.iter().copied().filter(|name| self.steps.point(name) <= step).collect();
            (step, self.shown(&made))
        };
        let last = steps.pop().unwrap_or_default();
        (last, steps.into_iter().map(text).collect())
    }

    /// The names of coincident points.
    fn shown(&self, names: &[&str]) -> String {
        let mut shown: Vec<String> = names.iter().map(|name| self.context.shown(name, Some(self.plan))).collect();
        // A fixed point O and the pole o have the same symbol.
        shown.dedup();
        // The scene may give a name no text.
        shown.retain(|name| !name.is_empty());
        shown.join(", ")
    }
}

/// Whether a name is that of the end of a vanishing normal acceleration, which coincides with another point.
fn is_vanished(plan: &Plan, name: &str) -> bool {
    let end = &plan.points[name];
    let mut others = plan.points.values();
    end.role == PointRole::Normal && others.any(|p| p.role != PointRole::Normal && p.vector == end.vector)
}
