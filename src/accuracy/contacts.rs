//! What is known of profiles that touch, with bounds of the errors: their point, how they slide, how fast a roller turns.

use super::Bounds;
use super::enclosure::Enclosure;
use crate::geometry::{Ball, Pair, Vector};
use crate::mechanism::{BodyId, Contact, PointId, SliderId, Touching};
use crate::quantity::{Snapshot, State};
use crate::scene::Scene;

/// Two profiles that touch, in a position and a motion. Each number stands beside the bound of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contacting {
    /// Where they touch; the bound is that of each coordinate.
    pub point: Option<([f64; 2], f64)>,
    /// The common normal, of length 1: from the first centre of curvature towards the second, or into the flat profile.
    pub normal: ([f64; 2], f64),
    /// The velocity of the first profile on the second where they touch, positive along the normal turned by +90°; none of a roller, which rolls.
    pub sliding: Option<(f64, f64)>,
    /// The angular velocity of the roller.
    pub roller: Option<(f64, f64)>,
}

impl Bounds<'_> {
    /// What is known of a contact.
    #[must_use]
    pub fn contact(&self, contact: &Contact) -> Contacting {
        let now = self.snapshot();
        let scene = self.scene;
        let vector = |at: Pair<f64>, of: &dyn Fn(&Enclosed<'_>) -> Option<Pair<Ball>>| {
            let error = self
                .from(|e| of(&Enclosed { enclosure: e, scene }), |ball| self.of_vector(ball, Vector::new(at.x, at.y)));
            // Without a negative zero.
            ([at.x + 0.0, at.y + 0.0], error)
        };
        let number = |x: f64, of: &dyn Fn(&Enclosed<'_>) -> Option<Ball>| {
            (x, self.from(|e| of(&Enclosed { enclosure: e, scene }), |ball| self.of_number(ball, x)))
        };
        Contacting {
            point: contact.point(&now).map(|at| vector(at, &|e| contact.point(e))),
            normal: vector(contact.normal(&now), &|e| Some(contact.normal(e))),
            sliding: contact.sliding(&now).filter(|_| !contact.has_roller).map(|x| number(x, &|e| contact.sliding(e))),
            roller: contact.roller(&now).map(|x| number(x, &|e| contact.roller(e))),
        }
    }
}

impl Touching<f64> for Snapshot<'_> {
    fn place(&self, point: PointId) -> Pair<f64> {
        self.pose.point(point).coords.into()
    }

    fn guide(&self, slider: SliderId) -> Pair<f64> {
        self.pose.guide(slider).into()
    }

    fn given(&self, number: f64) -> f64 {
        number
    }

    fn omega(&self, body: BodyId) -> f64 {
        self.angular_rates(body)[0]
    }

    fn slide(&self, slider: SliderId) -> f64 {
        self.slide_rates(slider)[0]
    }
}

/// An enclosure with the numbers of its scene.
struct Enclosed<'a> {
    enclosure: &'a Enclosure,
    scene: &'a Scene,
}

impl Touching<Ball> for Enclosed<'_> {
    fn place(&self, point: PointId) -> Pair<Ball> {
        self.enclosure.place(point)
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        self.enclosure.guide(slider)
    }

    fn given(&self, number: f64) -> Ball {
        self.scene.as_written(number)
    }

    fn omega(&self, body: BodyId) -> Ball {
        self.enclosure.angular_rates(body)[0]
    }

    fn slide(&self, slider: SliderId) -> Ball {
        self.enclosure.slide_rates(slider)[0]
    }
}
