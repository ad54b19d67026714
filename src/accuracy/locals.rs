//! The points of bodies in the bodies' own frames, looked up by point.

use super::given::{Given, Vector};
use crate::mechanism::{BodyId, PointId};

/// Of a body with more points its points are looked up by halving.
const FEW: usize = 8;

/// By body: its points in its own frame.
pub(super) struct Locals<'a> {
    given: Given<'a>,
    places: Vec<Vec<Vector>>,
    /// By body: its points' places in the list of its points, in the order of the points; empty of a body with few.
    sorted: Vec<Vec<usize>>,
}

impl<'a> Locals<'a> {
    pub fn new(given: Given<'a>) -> Locals<'a> {
        let mechanism = given.mechanism;
        let sorted = mechanism.body_ids().map(|id| {
            let points = &mechanism.body(id).points;
            let mut sorted: Vec<usize> = if points.len() > FEW { (0..points.len()).collect() } else { Vec::new() };
            sorted.sort_by_key(|&index| points[index].0);
            sorted
        });
        Locals { given, places: mechanism.body_ids().map(|id| given.locals(id)).collect(), sorted: sorted.collect() }
    }

    /// The places of a body's points, in their order.
    pub fn of(&self, body: BodyId) -> &[Vector] {
        &self.places[body.0]
    }

    /// The place of one of a body's points; `None` for a point of other bodies.
    pub fn place(&self, body: BodyId, point: PointId) -> Option<Vector> {
        let (points, sorted) = (&self.given.mechanism.body(body).points, &self.sorted[body.0]);
        let index = if sorted.is_empty() {
            points.iter().position(|&p| p == point)?
        } else {
            sorted[sorted.binary_search_by_key(&point.0, |&index| points[index].0).ok()?]
        };
        self.of(body).get(index).copied()
    }
}
