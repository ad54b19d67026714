//! Images of all points of a link whose motion is known: by the image theorem (the image of a link is similar to it,
//! turned and scaled; Mehmke 1883, Burmester 1888) from two images of the link, else by the motion relative to one.

use super::name::{coriolis_name, image_name, normal_name, point_on, slide_name};
use super::operation::{Along, LineId, Part, PlaceId};
use super::step::{Action, Added, Arrow, PointRole, Ray, RayOf, Relation, RelativePart, VectorOf};
use super::writer::Writer;
use crate::geometry::{Ball, Pair, Vector, cross};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId};
use crate::sheet::Sheet;

/// Least sine of the angle at a point between its arms to two others, for its image to be crossed by two rays.
const LEAST_SINE: f64 = 0.3;

/// Least distance of two images from which a third is constructed, in parts of the plan's longest vector.
const LEAST_BASE: f64 = 0.02;

/// How many points of a link are looked at for the two that give a third best.
const MOST_IMAGED: usize = 16;

/// A point of a link with its image in a plan.
#[derive(Clone)]
struct Imaged {
    point: PointId,
    name: String,
    place: PlaceId,
}

impl Writer<'_> {
    /// Constructs the images of all points of a link that have none yet, in all plans.
    pub(super) fn further_images(&mut self, body: BodyId) {
        let mechanism = self.mechanism;
        for &sheet in self.plans() {
            for &point in &mechanism.body(body).points {
                let name = image_name(mechanism.point_name(point));
                if self.plan(sheet).points.contains_key(&name) {
                    continue;
                }
                let made = self.similar_image(sheet, body, point, &name);
                if made.is_none() {
                    self.relative_image(sheet, body, point);
                }
            }
        }
        self.step = None;
    }

    /// The first points of a body that have an image in a plan.
    fn imaged(&mut self, sheet: Sheet, body: BodyId) -> Vec<Imaged> {
        let mechanism = self.mechanism;
        let under = mechanism.sliders.iter().filter(|slider| slider.on == body).map(|slider| slider.at);
        let mut found: Vec<Imaged> = Vec::new();
        for point in mechanism.body(body).points.iter().copied().chain(under) {
            if found.len() == MOST_IMAGED {
                break;
            }
            let name = image_name(&point_on(mechanism, body, point));
            let is_there = self.plan(sheet).points.contains_key(&name) && found.iter().all(|f| f.point != point);
            if let (true, Some(place)) = (is_there, self.construction.place(sheet, &name)) {
                found.push(Imaged { point, name, place });
            }
        }
        found
    }

    /// The image of a point from those of two others of its link; `None` without two that give it well.
    fn similar_image(&mut self, sheet: Sheet, body: BodyId, point: PointId, name: &str) -> Option<()> {
        let imaged = self.imaged(sheet, body);
        let arm = |from: PointId| self.pose.arm(from, point);
        let mut best: Option<(f64, [&Imaged; 2])> = None;
        for (index, first) in imaged.iter().enumerate() {
            for second in &imaged[index + 1..] {
                let (a, b) = (arm(first.point), arm(second.point));
                let between = self.pose.arm(first.point, second.point);
                let coincide = [a, b, between].iter().any(|arm| arm.norm() <= self.near);
                if coincide || !self.are_apart(sheet, first.place, second.place) {
                    continue;
                }
                let on_line = (cross(a, between) / between.norm()).abs() <= self.near;
                // A division is drawn most simply; between the two images it is most exact.
                let inside = if a.dot(&b) < 0.0 { 3.0 } else { 2.0 };
                let worth = if on_line { inside } else { (cross(a, b) / (a.norm() * b.norm())).abs() };
                if worth > best.as_ref().map_or(LEAST_SINE, |(worth, _)| *worth) {
                    best = Some((worth, [first, second]));
                }
            }
        }
        let (worth, pair) = best?;
        let place = match worth >= 2.0 {
            true => self.divided_image(sheet, body, point, name, pair),
            false => self.crossed_image(sheet, body, point, name, pair)?,
        };
        self.note_motion(sheet, body, point, place);
        Some(())
    }

    /// Narrows the bounds of an image to those of the rotation about another point of its link, with the constructed
    /// rates. From crossing to crossing bounds would grow; the place that a hand draws stays the same.
    fn narrow(&mut self, sheet: Sheet, body: BodyId, point: PointId, place: PlaceId) {
        let base = self.first_motions.get(&(sheet, body)).copied();
        let (Some((from, base)), Some(rates)) = (base, self.construction.spins[body.0]) else {
            return;
        };
        let [omega, alpha] = rates.map(|rate| rate.map_or(Ball::default(), |rate| self.exact.exact_number(rate)));
        let arm = Pair::between(self.pose.point(from), self.pose.point(point));
        let turned = match sheet {
            Sheet::Acceleration => arm.quarter_turn() * alpha - arm * (omega * omega),
            _ => arm.quarter_turn() * omega,
        };
        let rotated = self.exact.exact_place(base) + turned;
        if rotated.errors().norm() < self.exact.exact_place(place).errors().norm() {
            self.exact.set_place(place, rotated);
        }
    }

    /// Whether two plan points are so far apart that the image of their link can be drawn from them, in parts of the
    /// plan drawn so far.
    fn are_apart(&mut self, sheet: Sheet, a: PlaceId, b: PlaceId) -> bool {
        let between = (self.exact.exact_place(b) - self.exact.exact_place(a)).rounded();
        between.norm() > LEAST_BASE * self.plan(sheet).largest
    }

    /// The image of a point on the line of two others, by division of the line of their images.
    fn divided_image(&mut self, sheet: Sheet, body: BodyId, point: PointId, name: &str, pair: [&Imaged; 2]) -> PlaceId {
        let [first, second] = pair;
        let points = [first.point, second.point, point];
        let between = [first.name.clone(), second.name.clone()];
        self.begin(sheet, Action::Divide { point: name.to_owned(), between, points });
        let like = points.map(|point| self.plot(point));
        let place = self.divide(sheet, [first.place, second.place], like);
        self.narrow(sheet, body, point, place);
        self.show(sheet, name, place, PointRole::Image);
        place
    }

    /// The image of a point by two rays from the images of two others; `None` where they do not cross.
    fn crossed_image(
        &mut self,
        sheet: Sheet,
        body: BodyId,
        point: PointId,
        name: &str,
        pair: [&Imaged; 2],
    ) -> Option<PlaceId> {
        let base = {
            let [from, to] = pair.map(|end| end.place);
            self.join_places(from, to, Part::Line)
        };
        let side = self.join(pair[0].point, pair[1].point);
        let mut lines: Vec<LineId> = Vec::new();
        for (end, other) in [(pair[0], pair[1]), (pair[1], pair[0])] {
            let arm = self.join(end.point, point);
            let (along, relation) = match sheet {
                Sheet::Acceleration => (Along::angle(base, [side, arm]), Relation::Angle),
                _ => (Along::line(arm).turned(1), Relation::Perpendicular),
            };
            let of = RayOf::Arm { link: body, from: end.point, to: point, other: other.point };
            let (through, to) = (end.name.clone(), name.to_owned());
            self.begin(sheet, Action::Ray(Ray { through, to, direction: Vector::x(), relation, of }));
            let line = self.draw(sheet, Part::Ray, end.place, along);
            self.set_direction(sheet, line);
            lines.push(line);
        }
        let [a, b] = pair.map(|end| self.pose.arm(end.point, point));
        let sine = cross(a, b) / (a.norm() * b.norm());
        let from = pair.map(|end| end.name.clone());
        self.begin(sheet, Action::Cross { point: name.to_owned(), from, sine });
        let Some(place) = self.cross(sheet, Part::Image, [lines[0], lines[1]]) else {
            let steps = &mut self.plan(sheet).steps;
            steps.truncate(steps.len() - 3);
            return None;
        };
        self.narrow(sheet, body, point, place);
        self.show(sheet, name, place, PointRole::Image);
        Some(place)
    }

    /// The image of a body's point by its motion relative to points that have one, each part of it in a step of its
    /// own. The ways to the body's own joint come first.
    pub(super) fn relative_image(&mut self, sheet: Sheet, body: BodyId, point: PointId) {
        let mechanism = self.mechanism;
        let name = image_name(&point_on(mechanism, body, point));
        if self.plan(sheet).points.contains_key(&name) {
            return;
        }
        if body == GROUND {
            let pole = self.motion(sheet, body, point);
            self.show(sheet, &name, pole, PointRole::Pole);
            return;
        }
        if let Some(anchor) = self.anchors[body.0] {
            let at = mechanism.joint_point(anchor.joint);
            if at != point {
                for body in [anchor.from, body] {
                    self.relative_image(sheet, body, at);
                }
            }
        }
        // Its operations belong to the steps below, not to the step before.
        self.step = None;
        let place = self.motion(sheet, body, point);
        // Back to a plan point that is there.
        let (mut at, mut vectors) = (place, Vec::new());
        let start = loop {
            if let Some(name) = self.shown_name(sheet, at) {
                break Some(name);
            }
            match self.laid_off.get(&at).cloned() {
                Some(laid) => {
                    at = laid.start;
                    vectors.push(laid);
                }
                None => break None,
            }
        };
        let Some(mut from) = start else {
            // The scene gives the vector, or no construction does.
            let from = self.plan(sheet).kind.pole().to_owned();
            let of = VectorOf::Point(body, point);
            self.begin(sheet, Action::LayOff(Arrow { from, to: name.clone(), of }));
            self.show(sheet, &name, place, PointRole::Image);
            self.claim(place);
            return;
        };
        if vectors.is_empty() {
            self.begin(sheet, Action::Coincide { point: name.clone(), with: from, link: body });
            self.show(sheet, &name, place, PointRole::Image);
            return;
        }
        while let Some(laid) = vectors.pop() {
            let (to, role) = match vectors.is_empty() {
                true => (name.clone(), PointRole::Image),
                false => (self.free_name(sheet, part_name(mechanism, &from, &laid.of)), part_role(&laid.of)),
            };
            self.begin(sheet, Action::LayOff(Arrow { from, to: to.clone(), of: laid.of }));
            self.show(sheet, &to, laid.end, role);
            self.claim(laid.end);
            from = to;
        }
    }

    /// The name of the plan point at a place.
    fn shown_name(&mut self, sheet: Sheet, place: PlaceId) -> Option<String> {
        let names = self.names.get(place.0).cloned().unwrap_or_default();
        let points = &self.plan(sheet).points;
        names.into_iter().find(|(on, name)| *on == sheet && points.contains_key(name)).map(|(_, name)| name)
    }

    /// The name, with primes if another plan point has it.
    pub(super) fn free_name(&mut self, sheet: Sheet, mut name: String) -> String {
        while self.plan(sheet).points.contains_key(&name) {
            name = match name.contains('_') {
                true => name.replacen('_', "'_", 1),
                false => format!("{name}'"),
            };
        }
        name
    }
}

/// A vector laid off in a plan.
#[derive(Clone, Debug)]
pub(super) struct LaidOff {
    pub start: PlaceId,
    pub end: PlaceId,
    pub of: VectorOf,
}

/// The name of the end of a part of a relative motion that leads on, laid off from the plan point `from`.
fn part_name(mechanism: &Mechanism, from: &str, of: &VectorOf) -> String {
    match of {
        VectorOf::Relative { from, to, part: RelativePart::Normal, .. } => normal_name(from, to),
        VectorOf::Relative { to, .. } => image_name(to),
        VectorOf::Passed(slide, Added::Coriolis) => coriolis_name(from, &mechanism.body(slide.to).name),
        VectorOf::Passed(slide, _) => slide_name(from, &mechanism.body(slide.to).name),
        VectorOf::Point(..) | VectorOf::Normal(..) | VectorOf::Sliding(..) => from.to_owned(),
    }
}

fn part_role(of: &VectorOf) -> PointRole {
    match of {
        VectorOf::Relative { part: RelativePart::Normal, .. } => PointRole::Normal,
        VectorOf::Relative { .. } => PointRole::Image,
        _ => PointRole::Slid,
    }
}
