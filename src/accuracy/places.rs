use super::given::{Given, Vector};
use crate::geometry::Ball;
use crate::mechanism::{BodyId, PointId, Role, SliderId};
use crate::motion::Places;

/// Places with their errors, from which equations and motions are computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlacesOf<'a> {
    pub given: Given<'a>,
    pub points: &'a [Vector],
    pub guides: &'a [Vector],
}

impl Places for PlacesOf<'_> {
    fn place(&self, point: PointId) -> Vector {
        self.points[point.0]
    }

    fn arm(&self, from: PointId, to: PointId) -> Vector {
        self.points[to.0] - self.points[from.0]
    }

    fn guide(&self, slider: SliderId) -> Vector {
        self.guides[slider.0]
    }

    fn given(&self, number: f64) -> Ball {
        self.given.number(number)
    }

    fn rate(&self, rate: f64) -> Ball {
        self.given.chosen(rate)
    }

    fn omega(&self, body: BodyId, omega: f64) -> Ball {
        let is_driven = matches!(self.given.mechanism.body(body).role, Role::Driver { .. });
        if is_driven { self.given.omega(body, omega) } else { self.given.chosen(omega) }
    }
}
