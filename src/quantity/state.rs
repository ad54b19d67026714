use crate::geometry::{Point, Vector};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::motion::Motion;
use crate::position::Pose;
use crate::sheet::Sheet;

/// A position with its rates, as far as quantities are evaluated from it; in the fixed frame and in the scene's units.
pub trait State {
    /// Whether accelerations have been computed.
    fn has_accelerations(&self) -> bool;
    /// The place of a point.
    fn place(&self, point: PointId) -> Point;
    /// A vector along a link's axis; `None` for a link without one.
    fn axis(&self, link: BodyId) -> Option<Vector>;
    /// The unit direction of a slider's guide.
    fn guide(&self, slider: SliderId) -> Vector;
    /// A slider's position along its guide; `None` if there is no point to count from.
    fn slide_position(&self, slider: SliderId) -> Option<f64>;
    /// A slider's velocity and acceleration along its guide.
    fn slide_rates(&self, slider: SliderId) -> [f64; 2];
    /// A body's angular velocity and acceleration, in rad per unit of time.
    fn spin(&self, body: BodyId) -> [f64; 2];
    /// Velocity and acceleration of the body's point at a place.
    fn motion_at(&self, body: BodyId, place: Point) -> [Vector; 2];
}

/// A pose and its motion.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot<'a> {
    /// The position.
    pub pose: &'a Pose,
    /// Its rates.
    pub motion: &'a Motion,
}

impl State for Snapshot<'_> {
    fn has_accelerations(&self) -> bool {
        self.motion.order == Sheet::Acceleration
    }

    fn place(&self, point: PointId) -> Point {
        self.pose.point(point)
    }

    fn axis(&self, link: BodyId) -> Option<Vector> {
        self.pose.axes[link.0]
    }

    fn guide(&self, slider: SliderId) -> Vector {
        self.pose.guide(slider)
    }

    fn slide_position(&self, slider: SliderId) -> Option<f64> {
        self.pose.slides[slider.0]
    }

    fn slide_rates(&self, slider: SliderId) -> [f64; 2] {
        let slide = self.motion.slide(slider);
        [slide.velocity, slide.acceleration]
    }

    fn spin(&self, body: BodyId) -> [f64; 2] {
        let body = self.motion.body(body);
        [body.omega, body.alpha]
    }

    fn motion_at(&self, body: BodyId, place: Point) -> [Vector; 2] {
        let body = self.motion.body(body);
        [body.velocity_at(place), body.acceleration_at(place)]
    }
}
