use crate::geometry::{Ball, Pair, Point, UNIT_ROUNDOFF, Vector};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::position::Pose;

/// Where a mechanism's points and guides are when its motion is computed, and the numbers that the scene gives for it.
///
/// A [`Pose`] stands for itself: its f64 numbers count as exact. Enclosures of the true places are the other kind
/// ([`accuracy`](crate::accuracy)).
pub trait Places {
    /// The place of a point.
    fn place(&self, point: PointId) -> Pair<Ball>;
    /// The vector from one point to another.
    fn arm(&self, from: PointId, to: PointId) -> Pair<Ball>;
    /// The unit direction of a slider's guide.
    fn guide(&self, slider: SliderId) -> Pair<Ball>;
    /// All points, rounded, from any common origin.
    fn points(&self) -> &[Point];
    /// The directions of all guides, rounded.
    fn guides(&self) -> &[Vector];
    /// A number of the scene.
    fn given(&self, number: f64) -> Ball;
    /// The given angular velocity of a driven body.
    fn omega(&self, body: BodyId, omega: f64) -> Ball;
    /// Whether errors of the places are so large that the loop equations themselves are uncertain.
    const UNCERTAIN: bool;

    /// A place that the scene gives.
    fn given_pair(&self, v: Vector) -> Pair<Ball> {
        Pair { x: self.given(v.x), y: self.given(v.y) }
    }
}

impl Places for Pose {
    const UNCERTAIN: bool = false;

    fn place(&self, point: PointId) -> Pair<Ball> {
        self.point(point).coords.into()
    }

    fn arm(&self, from: PointId, to: PointId) -> Pair<Ball> {
        Pair::between(self.points[from.0], self.points[to.0])
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        let u = self.guides[slider.0];
        let error = guide_error(u);
        let Pair { x, y } = Pair::<Ball>::from(u);
        Pair { x: x.widened(u.x * error), y: y.widened(u.y * error) }
    }

    fn points(&self) -> &[Point] {
        &self.points
    }

    fn guides(&self) -> &[Vector] {
        &self.guides
    }

    fn given(&self, number: f64) -> Ball {
        number.into()
    }

    fn omega(&self, _: BodyId, omega: f64) -> Ball {
        omega.into()
    }
}

/// Bound of the relative error of a guide's unit vector: roundings since the scene's direction, and the deviation of
/// its length from 1.
pub(crate) fn guide_error(u: Vector) -> f64 {
    const FROM_THE_SCENE: f64 = 4.0;
    let stretch = 0.5 * (u.norm_squared() - 1.0).abs();
    FROM_THE_SCENE * UNIT_ROUNDOFF + stretch
}
