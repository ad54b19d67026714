//! A student's drawing in a panel: lines, crosses with names, numbers of steps.

use super::{Overlay, OwnKind, OwnLine, OwnPoint, WrongStep};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{clipped_segment, holds};
use crate::drawing::context::SheetContext;
use crate::drawing::labels::LabelRequest;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Emphasis, Mark, Pen};
use crate::drawing::text::RichText;
use crate::drawing::values::is_hidden;
use crate::drawing::view::{View, together, towards};
use crate::sheet::Sheet;
use crate::words::NumberStyle;
use kurbo::{Point, Vec2};

/// Points closer than this on paper, in mm, share a label.
const SHARED: f64 = 0.35;
/// Half the width of a cross that marks a point, in mm.
pub(super) const CROSS: f64 = 1.1;

/// The layer of a student's drawing in a panel of the right figure.
pub(in crate::drawing) struct OwnLayer<'a> {
    pub overlay: &'a Overlay,
    pub context: &'a SheetContext<'a>,
    pub panel: Sheet,
}

impl<'a> OwnLayer<'a> {
    /// Reserves room before the layers below are drawn: they and all labels keep off it.
    pub(in crate::drawing) fn reserve(&self, canvas: &mut Canvas<'_>, view: &View) {
        canvas.is_overlaid = true;
        for line in self.lines() {
            canvas.reserve(&Shape::Line(view.at(line.ends[0]), view.at(line.ends[1])));
        }
        for point in self.points() {
            canvas.reserve(&Shape::Circle { center: view.at(point.at), radius: CROSS });
        }
    }

    pub(in crate::drawing) fn draw(&self, canvas: &mut Canvas<'_>, view: &View) {
        for wrong in self.overlay.steps.iter().filter(|wrong| wrong.panel == self.panel) {
            self.name_step(canvas, wrong);
        }
        for (line, number) in self.lines().zip(1..) {
            self.line(canvas, view, line, number);
        }
        let label = |point: &OwnPoint| format!("{}^*", self.context.shown(&point.name, self.context.plan(self.panel)));
        for (center, points) in together(self.points().map(|point| (view.at(point.at), point)), SHARED) {
            let named = points.iter().filter(|point| point.is_named);
            let labels = named.map(|point| label(point)).collect::<Vec<_>>().join(", ");
            if holds(canvas.room(), center) {
                self.point(canvas, center, points[0], &labels);
            } else {
                self.name_outside(canvas, view, points[0], &labels);
            }
        }
    }

    /// Makes all marks paler except the student's and those of wrong steps, and shows all steps together.
    pub(in crate::drawing) fn retouch(&self, marks: &mut Vec<Mark>) {
        marks.retain_mut(|mark| {
            let is_wrong = self.overlay.steps.iter().any(|wrong| self.belongs_to(mark, wrong));
            let stays = is_wrong || !mark.passing;
            (mark.since, mark.passing) = (0, false);
            mark.emphasis = match mark.pen {
                Pen::Student | Pen::StudentPoint | Pen::Frame => Emphasis::Plain,
                _ if is_wrong => Emphasis::New,
                _ => Emphasis::Earlier,
            };
            stays
        });
    }

    fn line(&self, canvas: &mut Canvas<'_>, view: &View, line: &OwnLine, number: usize) {
        let room = canvas.room();
        let [from, to] = line.ends.map(|place| view.at(place));
        let Some((a, b)) = clipped_segment(room, from, to) else {
            return;
        };
        let (pen, shape) = match line.kind {
            OwnKind::Vector if holds(room, to) => (Pen::Student, canvas.arrow(a, to)),
            OwnKind::Line | OwnKind::Vector => (Pen::Student, Shape::Line(a, b)),
            OwnKind::Helper => (Pen::Construction, Shape::Line(a, b)),
        };
        let name = format!("student-line-{number}");
        canvas.draw_named(&name, pen, shape);
        if let Some(label) = &line.label {
            let request = LabelRequest::new(RichText::plain(label), a.midpoint(b), 1.5, None, 2);
            canvas.ask(&name, request).pen = Pen::StudentPoint;
        }
    }

    fn point(&self, canvas: &mut Canvas<'_>, center: Point, point: &OwnPoint, label: &str) {
        for arm in cross(center, CROSS) {
            canvas.draw(Pen::StudentPoint, arm);
        }
        canvas.obstacles.add_boxes([Shape::Circle { center, radius: CROSS }.bounds()]);
        if !label.is_empty() {
            let name = format!("student-{}", point.name);
            let request = LabelRequest::new(RichText::math(label), center, CROSS + 0.7, None, 2);
            canvas.ask(&name, request).pen = Pen::StudentPoint;
        }
    }

    /// Writes the number of a step beside its largest mark.
    fn name_step(&self, canvas: &mut Canvas<'_>, wrong: &WrongStep) {
        let marks = canvas.marks().iter().filter(|m| self.belongs_to(m, wrong));
        let size = |mark: &Mark| {
            let area = mark.shape.bounds();
            // A special point is preferred to its lines.
            let is_point = mark.pen == Pen::Special && matches!(mark.shape, Shape::Circle { .. });
            (is_point, area.width() + area.height())
        };
        let largest = marks.max_by(|a, b| {
            let ((a, p), (b, q)) = (size(a), size(b));
            a.cmp(&b).then(p.total_cmp(&q))
        });
        let Some(mark) = largest else { return };
        let (anchor, clearance, prefer) = match &mark.shape {
            Shape::Line(a, b) | Shape::Arrow { from: a, to: b, .. } => {
                let (anchor, prefer) = beside(canvas, *a, *b);
                (anchor, 1.6, prefer)
            }
            Shape::ArcArrow { center, radius, .. } => (*center, radius + 0.8, None),
            other => (other.bounds().center(), 2.0, None),
        };
        canvas.step = wrong.step as u16;
        let name = format!("step-{}", wrong.step);
        canvas.ask(&name, LabelRequest::new(RichText::plain(&wrong.label), anchor, clearance, prefer, 3));
        canvas.step = 0;
    }

    /// Names a point outside its panel, with its distance beyond the edge: where a line to it leaves the panel, else at
    /// an arrow towards it.
    fn name_outside(&self, canvas: &mut Canvas<'_>, view: &View, point: &OwnPoint, label: &str) {
        const ARROW: f64 = 9.0;
        let room = canvas.room().inset(-2.0);
        let target = view.at(point.at);
        let leads = self.lines().filter(|l| l.leads_to == point.name && l.ends[1] == point.at);
        let seen = leads.filter_map(|l| clipped_segment(room, view.at(l.ends[0]), target));
        let left = |(_, edge): &(Point, Point)| (target - *edge).hypot();
        let seen = seen.min_by(|a, b| left(a).total_cmp(&left(b)));
        let from = seen.or_else(|| clipped_segment(room, room.center(), target));
        let Some((start, edge)) = from else {
            return;
        };
        let along = towards(start, edge, Vec2::new(1.0, 0.0));
        let tail = edge - along * ARROW;
        let name = format!("student-{}", point.name);
        if seen.is_none() {
            let shape = canvas.arrow(tail, edge);
            canvas.draw_named(&name, Pen::StudentPoint, shape);
        }
        let words = self.context.words;
        let mm = words.write((target - edge).hypot(), NumberStyle::decimals(0));
        let words = words.language.check_beyond(label, &mm);
        canvas.ask(&name, LabelRequest::new(RichText::plain(&words), tail, 1.0, None, 3)).pen = Pen::StudentPoint;
    }

    fn points(&self) -> impl Iterator<Item = &'a OwnPoint> {
        self.overlay.points.iter().filter(|point| point.panel == self.panel && self.shows(&point.name))
    }

    fn lines(&self) -> impl Iterator<Item = &'a OwnLine> {
        self.overlay.lines.iter().filter(|line| line.panel == self.panel && self.shows(&line.leads_to))
    }

    /// Whether the right figure shows a point of that name.
    fn shows(&self, name: &str) -> bool {
        let context = self.context;
        match context.plan(self.panel) {
            None => context.mechanism().point(name).is_some() || context.special().any(|special| special.name == name),
            Some(plan) => plan.points.contains_key(name) && !is_hidden(context.figure(), plan, name),
        }
    }

    /// Whether a mark appears with a step and belongs to the link with the wrong rate.
    fn belongs_to(&self, mark: &Mark, wrong: &WrongStep) -> bool {
        let link = |name: &String| {
            let id = self.context.mechanism().link(name);
            id.is_some() && mark.number == id.and_then(|id| self.context.number(id))
        };
        // The factor of an enlarged detail belongs to no step.
        let is_scale = mark.pen == Pen::Label && mark.id.is_none();
        usize::from(mark.since) == wrong.step && !is_scale && wrong.link.as_ref().is_none_or(link)
    }
}

/// The two strokes of a cross, whose width is twice `half`.
pub(in crate::drawing) fn cross(center: Point, half: f64) -> [Shape; 2] {
    [1.0, -1.0].map(|sign| {
        let arm = Vec2::new(half, sign * half);
        Shape::Line(center - arm, center + arm)
    })
}

/// A point of a line and a side of it where a name has room.
fn beside(canvas: &Canvas<'_>, from: Point, to: Point) -> (Point, Option<Vec2>) {
    const FREE: f64 = 2.6;
    let along = towards(from, to, Vec2::new(1.0, 0.0));
    let normal = Vec2::new(along.y, -along.x);
    let places = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8].map(|share| from.lerp(to, share));
    let mut sides = places.into_iter().flat_map(|p| [(p, normal), (p, -normal)]);
    let free = sides.find(|(p, side)| canvas.is_free(*p + *side * (FREE + 1.4), FREE));
    match free {
        Some((place, side)) => (place, Some(side)),
        None => (from.midpoint(to), None),
    }
}
