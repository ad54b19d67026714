//! The vectors that a plan may show, and the points of a link between which they lie.

use super::given::Given;
use crate::construction::coincident_name;
use crate::geometry::Vector;
use crate::mechanism::{BodyId, Role};
use crate::quantity::{Quantity, QuantityRequest};
use crate::scene::Head;
use crate::sheet::{Order, Sheet};

impl Given {
    /// The sizes of all vectors that a plan may show, and the vectors: parts of the motion of one point of a link relative to another,
    /// of sliders, and whole ones.
    pub(super) fn vectors(&self, sheet: Sheet) -> Vec<Vector> {
        let Some(order) = sheet.order() else { return Vec::new() };
        let mechanism = self.mechanism();
        let (heads, sliding): (&[Head], Head) = match order {
            Order::Velocity => (&[Head::Velocity], Head::SlideVelocity),
            Order::Acceleration => (&[Head::Acceleration, Head::Normal, Head::Tangential], Head::SlideAcceleration),
        };
        let mut names = Vec::new();
        for (id, _) in mechanism.links() {
            let points = self.points_of(id);
            for [a, _] in &points {
                names.push(heads[0].of(a));
                for [b, _] in points.iter().filter(|[b, _]| b != a) {
                    names.extend(heads.iter().map(|head| head.of_two(a, b)));
                }
            }
        }
        let mut vectors: Vec<Vector> = names.iter().filter_map(|name| self.vector(name)).collect();
        for id in mechanism.slider_ids() {
            let (name, guide) = (mechanism.slider_name(id), self.solution.pose.guide(id));
            let size = |head: Head| self.number(&head.of(&name)).unwrap_or(0.0);
            vectors.push(guide * size(sliding));
            if order == Order::Acceleration {
                let coriolis = crate::geometry::quarter_turn(guide) * size(Head::Coriolis);
                vectors.extend([coriolis, -coriolis]);
            }
        }
        vectors
    }

    /// The points of a link: its joints, its special points and those that coincide with what slides on it; each by its name and by that of
    /// its place on the scheme.
    pub(super) fn points_of(&self, link: BodyId) -> Vec<[String; 2]> {
        let (mechanism, body) = (self.mechanism(), self.mechanism().body(link));
        let joints = body.points.iter().map(|point| mechanism.point_name(*point));
        let special = self.construction().special.iter().filter(|special| special.link == link);
        let mut points: Vec<[String; 2]> = joints
            .chain(special.map(|special| special.name.as_str()))
            .map(|name| [(); 2].map(|()| name.to_owned()))
            .collect();
        for slider in mechanism.sliders.iter().filter(|slider| slider.on == link && !body.has(slider.at)) {
            let at = mechanism.point_name(slider.at);
            points.push([coincident_name(at, &body.name), at.to_owned()]);
        }
        points
    }

    /// The parts along x and y of the vectors that the scene gives.
    pub(super) fn given_parts(&self, sheet: Sheet) -> Vec<Vector> {
        let Some(order) = sheet.order() else { return Vec::new() };
        let mechanism = self.mechanism();
        let head = [Head::Velocity, Head::Acceleration][order];
        let moving = mechanism.bodies.iter().filter(|b| matches!(b.role, Role::Moving { .. } | Role::Carrier { .. }));
        let points = moving.flat_map(|body| &body.points);
        let given = points.filter_map(|point| self.vector(&head.of(mechanism.point_name(*point))));
        given.flat_map(|v| [Vector::new(v.x, 0.0), Vector::new(0.0, v.y)]).collect()
    }

    fn vector(&self, name: &str) -> Option<Vector> {
        let asked = QuantityRequest::new(name, self.mechanism()).ok()?;
        match asked.value(&self.solution.snapshot(), Some(self.construction()), None).ok()? {
            Quantity::Vector(v) => Some(v),
            Quantity::Number(_) => None,
        }
    }
}
