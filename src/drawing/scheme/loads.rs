//! The loads on the scheme of a figure with a force plan: forces and couples at their places, centres of mass, the torques of drives; and in
//! the steps that take moments the lines of action with their arms. Loads have no scale: their sizes stand in the plan.

use super::on_paper::SchemeOnPaper;
use crate::construction::{Action, ForceOf, ForcePart, ForcePlan, ForceStep, Found, LoadShown, Moment, NOTHING};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::clipped_segment;
use crate::drawing::context::Purpose;
use crate::drawing::forces::ForceSteps;
use crate::drawing::labels::LabelRequest;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::RichText;
use crate::drawing::view::{on_sheet, towards};
use crate::forces::{Source, friction_circles};
use crate::geometry;
use crate::mechanism::{BodyId, GROUND, JointId, Role};
use kurbo::{Point, Vec2};

/// Length of a load's arrow, in mm; that of weights and inertia forces is shorter.
const LENGTH: [f64; 2] = [12.0, 8.5];
/// Radius and angle of the arc of a couple.
const RADIUS: f64 = 3.6;
const SWEEP: f64 = 3.6;
/// Radius of a torque around a couple, in parts of that of the couple.
const AROUND: f64 = 1.6;
/// How far a line of action goes on beyond its foot, in mm.
const BEYOND: f64 = 3.0;
/// Half the length of a line that touches a circle of friction, in mm.
const ACTION: f64 = 12.0;
/// Radius of a centre of mass, in mm.
const CENTER: f64 = 0.9;

impl SchemeOnPaper<'_> {
    /// Draws the loads.
    pub(super) fn loads(&self, canvas: &mut Canvas<'_>) {
        let Some(plan) = self.context.construction().forces.as_deref() else { return };
        canvas.step = 0;
        let largest = plan.loads.iter().map(|load| load.force.norm()).fold(0.0, f64::max);
        self.centers_of_mass(canvas, plan);
        self.circles_of_friction(canvas);
        // Given forces have a choice of places, weights nearly none.
        let mut all: Vec<(usize, &LoadShown)> = plan.loads.iter().enumerate().collect();
        all.sort_by_key(|(_, load)| is_of_mass(load));
        // Which way inertia acts students find.
        let is_for_students = self.context.purpose == Purpose::Exercise && !self.context.figure().worksheet;
        // Of friction what one side of its joint receives.
        let is_shown = |load: &LoadShown| match load.source {
            Source::Inertia => !is_for_students,
            Source::Friction(joint) => self.mechanism.joint(joint).rubbed() == load.body,
            // What it does to the frame shows in the spring.
            Source::Spring(_) => load.body != GROUND,
            _ => true,
        };
        all.retain(|(_, load)| is_shown(load));
        for (index, load) in all.into_iter().filter(|(_, load)| load.force.norm() > NOTHING * largest) {
            self.force(canvas, index, load);
        }
        let moment = |load: &LoadShown| load.couple.abs();
        let largest =
            plan.loads.iter().map(moment).fold(largest * geometry::span(self.pose.points.iter().copied()), f64::max);
        let couples = plan.loads.iter().enumerate().filter(|(_, load)| is_shown(load));
        for (index, load) in couples.filter(|(_, load)| moment(load) > NOTHING * largest) {
            let symbol = self.context.teller().couple_symbol(load.source, load.body);
            self.couple(
                canvas,
                &format!("couple-{}", index + 1),
                self.view.at(load.at),
                load.couple,
                (&symbol, RADIUS),
            );
        }
        self.torques(canvas, plan);
        if self.context.purpose == Purpose::Figure {
            self.lines_at_circles(canvas, plan);
        }
        canvas.step = 0;
    }

    /// Says that loads have no scale.
    pub(super) fn say_of_loads(&self, canvas: &mut Canvas<'_>) {
        if self.context.construction().forces.as_deref().is_some_and(|plan| !plan.loads.is_empty()) {
            canvas.remark("loads", self.context.words.language.loads_without_scale());
        }
    }

    fn centers_of_mass(&self, canvas: &mut Canvas<'_>, plan: &ForcePlan) {
        let mut seen: Vec<geometry::Point> = Vec::new();
        for load in plan.loads.iter().filter(|load| is_of_mass(load)) {
            if !seen.contains(&load.at) {
                canvas.draw(Pen::ImagePoint, Shape::Circle { center: self.view.at(load.at), radius: CENTER });
                seen.push(load.at);
            }
        }
    }

    /// The circles of friction, true to scale: what a pin carries with its friction is one force that touches its circle.
    fn circles_of_friction(&self, canvas: &mut Canvas<'_>) {
        for (pin, radius) in friction_circles(self.mechanism) {
            let radius = radius / self.view.mu();
            canvas.draw(Pen::Special, Shape::Circle { center: self.at(pin), radius });
        }
    }

    /// Where pins have friction: the lines of what they carry with it, each from the step that finds the force on.
    fn lines_at_circles(&self, canvas: &mut Canvas<'_>, plan: &ForcePlan) {
        let steps = ForceSteps::of(self.context, plan);
        let mut drawn: Vec<JointId> = Vec::new();
        let sides = plan.polygons.iter().zip(&steps.sides).flat_map(|(polygon, steps)| polygon.sides.iter().zip(steps));
        for (side, step) in sides {
            let ForceOf::Joint { joint, on, part: ForcePart::Whole } = side.of else { continue };
            let vector = side.vector;
            let is_its = |load: &&LoadShown| load.source == Source::Friction(joint) && load.body == on;
            let Some(friction) = plan.loads.iter().find(is_its).filter(|load| load.couple != 0.0) else { continue };
            if drawn.contains(&joint) {
                continue;
            }
            drawn.push(joint);
            // About the pin the force has the moment of the couple.
            let size = vector.norm();
            let touch = friction.at - geometry::quarter_turn(vector / size) * (friction.couple / size);
            let along = on_sheet(vector).normalize() * ACTION;
            let touch = self.view.at(touch);
            if let Some((from, to)) = clipped_segment(canvas.room(), touch - along, touch + along) {
                canvas.step = *step;
                canvas.draw_named(&format!("line-{}", drawn.len()), Pen::Ray, Shape::Line(from, to));
            }
        }
        canvas.step = 0;
    }

    /// A force, its arrow where there is most room: from the place where it acts, or to it.
    fn force(&self, canvas: &mut Canvas<'_>, index: usize, load: &LoadShown) {
        let at = self.view.at(load.at);
        let along = on_sheet(load.force).normalize() * LENGTH[usize::from(is_of_mass(load))];
        let bounds = canvas.room();
        let cost = |[from, to]: &[Point; 2]| {
            let is_free = |share: &f64| canvas.is_free(from.lerp(*to, *share), 0.8);
            let free = [0.3, 0.45, 0.6, 0.75].iter().filter(|share| is_free(share)).count();
            (!(bounds.contains(*from) && bounds.contains(*to)), 4 - free)
        };
        let Some([from, to]) = [[at, at + along], [at - along, at]].into_iter().min_by_key(cost) else { return };
        let name = format!("load-{}", index + 1);
        let number = self.context.number(load.body);
        canvas.draw_named(&name, Pen::Acceleration, canvas.arrow(from, to)).number = number;
        let symbol = self.context.teller().load_symbol(load.source, load.body);
        let free = if from == at { to } else { from };
        let request = LabelRequest::new(RichText::math(&symbol), free, 0.8, Some(towards(at, free, Vec2::ZERO)), 3);
        canvas.ask(&name, request);
    }

    /// A couple: an arc with a head, and short strokes across it.
    fn couple(&self, canvas: &mut Canvas<'_>, name: &str, center: Point, couple: f64, (symbol, radius): (&str, f64)) {
        let sweep = -SWEEP * couple.signum();
        let head = canvas.dims.head;
        // Its gap is on the left.
        let start = std::f64::consts::PI + 0.5 * (std::f64::consts::TAU - SWEEP) * -couple.signum();
        canvas.draw_named(name, Pen::Acceleration, Shape::ArcArrow { center, radius, start, sweep, head });
        for part in [0.25, 0.4, 0.55, 0.7] {
            let angle = start + sweep * part;
            let out = Vec2::new(libm::cos(angle), libm::sin(angle));
            let across = |by: f64| center + out * (radius + by) + Vec2::new(-out.y, out.x) * (0.5 * by);
            canvas.draw(Pen::Hatch, Shape::Line(across(-0.9), across(0.9)));
        }
        let up = Vec2::new(0.6, -0.8);
        let request = LabelRequest::new(RichText::math(symbol), center + up * radius, 1.0, Some(up), 3);
        canvas.ask(name, request);
    }

    /// The torques of driven links about their pivots, each with the step that finds it.
    fn torques(&self, canvas: &mut Canvas<'_>, plan: &ForcePlan) {
        for step in self.context.construction().numbered_steps() {
            let Action::Force(ForceStep::Moments(index)) = step.action else { continue };
            let Found::Torque(link) = plan.moments[*index].finds else { continue };
            let Some(pivot) = self.pivot_of(link) else { continue };
            let value = plan.moments[*index].value;
            if value != 0.0 {
                canvas.step = step.number as u16;
                let symbol = self.context.teller().torque_symbol(link);
                let name = format!("torque-{}", self.mechanism.body(link).name);
                // Around the couples that are at the pivot already.
                let is_there =
                    |load: &&LoadShown| load.couple != 0.0 && (self.view.at(load.at) - pivot).hypot() < RADIUS;
                let radius = if plan.loads.iter().any(|load| is_there(&load)) { AROUND } else { 1.25 };
                self.couple(canvas, &name, pivot, value, (&symbol, radius * RADIUS));
            }
        }
        canvas.step = 0;
    }

    fn pivot_of(&self, link: BodyId) -> Option<Point> {
        match self.mechanism.body(link).role {
            Role::Driver { pivot, .. } => Some(self.at(pivot)),
            _ => None,
        }
    }

    /// The arms of each sum of moments, in its step alone.
    pub(super) fn arms(&self, canvas: &mut Canvas<'_>) {
        let Some(plan) = self.context.construction().forces.as_deref() else { return };
        for step in self.context.construction().numbered_steps() {
            let Action::Force(ForceStep::Moments(index)) = step.action else { continue };
            self.arms_of(canvas, step.number as u16, &plan.moments[*index]);
        }
        canvas.step = 0;
    }

    fn arms_of(&self, canvas: &mut Canvas<'_>, step: u16, moment: &Moment) {
        let about = self.view.at(moment.at);
        let room = canvas.room();
        canvas.step = step;
        // Labels need not keep off what is there in one step alone.
        let mut draw = |name: String, pen: Pen, shape: Shape| canvas.draw_below(&name, pen, shape).passing = true;
        let size = geometry::span(self.pose.points.iter().copied());
        for (index, arm) in moment.arms.iter().enumerate().filter(|(_, arm)| arm.length > 1e-9 * size) {
            let [at, foot] = arm.line.map(|place| self.view.at(place));
            let along = towards(at, foot, Vec2::ZERO);
            if let Some((from, to)) = clipped_segment(room, at, foot + along * BEYOND) {
                draw(format!("action-{step}-{index}"), Pen::Ray, Shape::Line(from, to));
            }
            if let Some((from, to)) = clipped_segment(room, about, foot) {
                draw(format!("arm-{step}-{index}"), Pen::Construction, Shape::Line(from, to));
            }
        }
        if room.contains(about) {
            draw(format!("about-{step}"), Pen::Special, Shape::Circle { center: about, radius: 1.3 });
        }
    }
}

/// Whether a load acts in a centre of mass.
fn is_of_mass(load: &LoadShown) -> bool {
    matches!(load.source, Source::Weight | Source::Inertia)
}
