//! What a panel has of a student's drawing: lines, crosses with names, numbers of steps.

use super::{CROSS, Overlay, OwnKind, OwnLine, OwnPoint, WrongStep, cross, is_of};
use crate::drawing::canvas::Canvas;
use crate::drawing::clip::{clipped_segment, holds};
use crate::drawing::plan_panel::is_hidden;
use crate::drawing::scheme::Scheme;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Mark, Pen};
use crate::drawing::text::RichText;
use crate::drawing::view::{View, towards};
use crate::plan::Plan;
use crate::scene::Panel;
use kurbo::{Point, Vec2};

/// Points closer than this on paper, in mm, share a name.
const SHARED: f64 = 0.35;

impl Overlay {
    /// Keeps what is drawn before the student's marks off them.
    pub(in crate::drawing) fn announce(&self, canvas: &mut Canvas<'_>, view: &View, scheme: &Scheme<'_>, panel: Panel) {
        canvas.overlay();
        for line in self.lines_in(scheme, panel) {
            canvas.expect(&Shape::Line(view.at(line.ends[0]), view.at(line.ends[1])));
        }
        for point in self.points_in(scheme, panel) {
            let center = view.at(point.at);
            let radius = CROSS;
            canvas.expect(&Shape::Circle { center, radius });
        }
    }

    /// Draws what a panel has of it, over all else.
    pub(in crate::drawing) fn draw(&self, canvas: &mut Canvas<'_>, view: &View, scheme: &Scheme<'_>, panel: Panel) {
        let plan = plan_of(scheme, panel);
        for wrong in self.steps.iter().filter(|wrong| wrong.panel == panel) {
            self.name_step(canvas, scheme, wrong);
        }
        let room = canvas.room();
        for (line, number) in self.lines_in(scheme, panel).zip(1..) {
            let [from, to] = line.ends.map(|place| view.at(place));
            let Some((a, b)) = clipped_segment(room, from, to) else {
                continue;
            };
            let (pen, shape) = match line.kind {
                OwnKind::Vector if holds(room, to) => (Pen::Student, Shape::Arrow { from: a, to }),
                OwnKind::Line | OwnKind::Vector => (Pen::Student, Shape::Line(a, b)),
                OwnKind::Helper => (Pen::Construction, Shape::Line(a, b)),
            };
            let name = format!("student-line-{number}");
            canvas.draw_named(&name, pen, shape);
            if let Some(label) = &line.label {
                let wanted = canvas.label(&name, label, a.midpoint(b), 1.5, None, 2);
                wanted.request.text = RichText::plain(label);
                wanted.pen = Pen::StudentPoint;
            }
        }
        let mut places: Vec<(Point, Vec<String>, &OwnPoint)> = Vec::new();
        for point in self.points_in(scheme, panel) {
            let at = view.at(point.at);
            let label = format!("{}^*", scheme.shown(&point.name, plan));
            let shared = places.iter_mut().find(|(p, ..)| (*p - at).hypot() < SHARED);
            let labels = match shared {
                Some((_, labels, _)) => labels,
                None => {
                    places.push((at, Vec::new(), point));
                    &mut places.last_mut().expect("a place was added").1
                }
            };
            labels.extend(point.is_named.then_some(label));
        }
        for (center, labels, point) in places {
            let label = labels.join(", ");
            if !holds(room, center) {
                self.beyond(canvas, view, scheme, point, &label);
                continue;
            }
            for arm in cross(center) {
                canvas.draw(Pen::StudentPoint, arm);
            }
            let radius = CROSS;
            canvas.keep_off(Shape::Circle { center, radius }.bounds());
            if !label.is_empty() {
                let name = format!("student-{}", point.name);
                let wanted = canvas.label(&name, &label, center, CROSS + 0.7, None, 2);
                wanted.pen = Pen::StudentPoint;
            }
        }
    }

    /// Writes the number of a step beside what it draws or measures.
    fn name_step(&self, canvas: &mut Canvas<'_>, scheme: &Scheme<'_>, wrong: &WrongStep) {
        let own = canvas.marks().iter().filter(|m| is_of(m, scheme, wrong));
        let size = |mark: &Mark| {
            let area = mark.shape.bounds();
            // A special point says more than its lines.
            let is_point = mark.pen == Pen::Special && matches!(mark.shape, Shape::Circle { .. });
            (is_point, area.width() + area.height())
        };
        let largest = own.max_by(|a, b| {
            let ((a, p), (b, q)) = (size(a), size(b));
            a.cmp(&b).then(p.total_cmp(&q))
        });
        let Some(mark) = largest else { return };
        let (anchor, clearance, prefer) = match &mark.shape {
            Shape::Line(a, b) | Shape::Arrow { from: a, to: b } => {
                let (anchor, prefer) = beside(canvas, *a, *b);
                (anchor, 1.6, prefer)
            }
            Shape::ArcArrow { center, radius, .. } => (*center, radius + 0.8, None),
            other => (other.bounds().center(), 2.0, None),
        };
        canvas.since(wrong.step as u16);
        let name = format!("step-{}", wrong.step);
        let request = canvas.label(&name, &wrong.label, anchor, clearance, prefer, 3);
        request.request.text = RichText::plain(&wrong.label);
        canvas.since(0);
    }

    /// A point outside its panel: how far it lies beyond the edge, where a line that leads to it leaves the panel, else at an arrow towards it.
    fn beyond(&self, canvas: &mut Canvas<'_>, view: &View, scheme: &Scheme<'_>, point: &OwnPoint, label: &str) {
        const ARROW: f64 = 9.0;
        let room = canvas.room().inset(-2.0);
        let target = view.at(point.at);
        let leads = self.lines_in(scheme, point.panel);
        let leads = leads.filter(|l| l.leads_to == point.name && l.ends[1] == point.at);
        let seen = leads.filter_map(|l| clipped_segment(room, view.at(l.ends[0]), target));
        let left = |(_, edge): &(Point, Point)| (target - *edge).hypot();
        let seen = seen.min_by(|a, b| left(a).total_cmp(&left(b)));
        let from = seen.or_else(|| clipped_segment(room, room.center(), target));
        let Some((start, edge)) = from else {
            return;
        };
        let way = towards(start, edge, Vec2::new(1.0, 0.0));
        let tail = edge - way * ARROW;
        let name = format!("student-{}", point.name);
        if seen.is_none() {
            let shape = Shape::Arrow { from: tail, to: edge };
            canvas.draw_named(&name, Pen::StudentPoint, shape);
        }
        let mm = (target - edge).hypot();
        let mm = scheme.words.number(format!("{mm:.0}"));
        let words = (scheme.words.language.check.beyond)(label, &mm);
        let wanted = canvas.label(&name, &words, tail, 1.0, None, 3);
        wanted.request.text = RichText::plain(&words);
        wanted.pen = Pen::StudentPoint;
    }

    fn points_in<'a>(&'a self, scheme: &'a Scheme<'_>, panel: Panel) -> impl Iterator<Item = &'a OwnPoint> {
        let own = self.points.iter();
        own.filter(move |p| p.panel == panel && shows(scheme, panel, &p.name))
    }

    fn lines_in<'a>(&'a self, scheme: &'a Scheme<'_>, panel: Panel) -> impl Iterator<Item = &'a OwnLine> {
        let own = self.lines.iter();
        own.filter(move |l| l.panel == panel && shows(scheme, panel, &l.leads_to))
    }
}

fn plan_of<'a>(scheme: &'a Scheme<'_>, panel: Panel) -> Option<&'a Plan> {
    match panel {
        Panel::Scheme => None,
        Panel::Velocity => Some(&scheme.construction.velocity),
        Panel::Acceleration => scheme.construction.acceleration.as_ref(),
    }
}

/// Whether the right figure shows a point of that name too.
fn shows(scheme: &Scheme<'_>, panel: Panel, name: &str) -> bool {
    match plan_of(scheme, panel) {
        None => {
            let mut special = scheme.special();
            scheme.mechanism.point(name).is_some() || special.any(|s| s.name == name)
        }
        Some(plan) => plan.points.contains_key(name) && !is_hidden(scheme.figure, plan, name),
    }
}

/// A place of a line, and a side of it, where a name has room.
fn beside(canvas: &Canvas<'_>, from: Point, to: Point) -> (Point, Option<Vec2>) {
    const FREE: f64 = 2.6;
    let way = towards(from, to, Vec2::new(1.0, 0.0));
    let normal = Vec2::new(way.y, -way.x);
    let places = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8].map(|share| from.lerp(to, share));
    let mut sides = places.into_iter().flat_map(|p| [(p, normal), (p, -normal)]);
    let free = sides.find(|(p, side)| canvas.is_free(*p + *side * (FREE + 1.4), FREE));
    match free {
        Some((place, side)) => (place, Some(side)),
        None => (from.midpoint(to), None),
    }
}
