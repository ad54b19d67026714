use super::enclosure::Enclosure;
use super::says;
use crate::construction::{Rate, Special};
use crate::geometry::{Ball, Pair, Point, UNIT_ROUNDOFF, Vector, degrees_of};
use crate::mechanism::{BodyId, Mechanism, PointId, Role, SliderId};
use crate::message::Message;
use crate::motion::Motion;
use crate::position::Pose;
use crate::quantity::{AccelerationPart, Component, Quantity, QuantityRequest, Snapshot, Spot, State, What};
use crate::scene::Scene;
use crate::sheet::Order;
use std::f64::consts::SQRT_2;

/// Roundings in a number that is read from a pose and its motion.
const ROUNDINGS: f64 = 8.0 * UNIT_ROUNDOFF;

/// Bounds of the whole error of every number of a pose and its motion, in the scene's units, angles in degrees: of
/// places, rates, velocities and accelerations. Infinite where none can be given.
///
/// An error is the distance from what follows exactly from the numbers of the scene as they are written, with all their
/// digits. So rounding of the scene's numbers to f64, of lengths and angles that follow from them, of the position and of
/// rates all count in. Vectors have one bound, that of each component. A number that the scene gives has the bound 0.
///
/// All of this is proved, in numbers that carry their own errors: that one and only one assembly of the mechanism lies
/// within the bounds, and that its rates do ([`Self::is_proved`]).
#[derive(Clone, Debug)]
pub struct Bounds<'a> {
    scene: &'a Scene,
    mechanism: &'a Mechanism,
    pose: &'a Pose,
    motion: &'a Motion,
    enclosure: Option<Enclosure>,
}

/// Bounds of the errors of `pose` and `motion`, which belong to `mechanism`, which was made from `scene`.
///
/// The mechanism's drives may have been given other positions and rates since: these then count as given.
#[must_use]
pub fn bounds<'a>(scene: &'a Scene, mechanism: &'a Mechanism, pose: &'a Pose, motion: &'a Motion) -> Bounds<'a> {
    let enclosure = Enclosure::new(scene, mechanism, pose, motion.order);
    Bounds { scene, mechanism, pose, motion, enclosure }
}

impl Bounds<'_> {
    fn snapshot(&self) -> Snapshot<'_> {
        Snapshot { pose: self.pose, motion: self.motion }
    }

    /// The bound that the enclosure gives; infinite where it gives none.
    fn from<T>(&self, of: impl Fn(&Enclosure) -> Option<T>, error: impl Fn(T) -> f64) -> f64 {
        let bound = self.enclosure.as_ref().and_then(of).map_or(f64::INFINITY, error);
        if bound.is_nan() { f64::INFINITY } else { bound }
    }

    /// The bound of the error of a number with the true value `ball`; zero for one that the scene gives, which is printed
    /// as it is written.
    fn of_number(&self, ball: Ball, value: f64) -> f64 {
        if self.is_as_written(ball, value) { 0.0 } else { ball.error_from(value) + of_printing(value) }
    }

    fn is_as_written(&self, ball: Ball, value: f64) -> bool {
        // Only what the scene gives is so near to its f64.
        let is_near = ball.error_from(value) <= f64::EPSILON * value.abs();
        is_near && self.scene.is_written(value) && ball == self.scene.as_written(value)
    }

    /// That of a number that the scene gives, or that a drive has been given since.
    fn of_given(&self, value: f64) -> f64 {
        let written = self.scene.as_written(value);
        if self.scene.is_written(value) || written == Ball::decimal(value) { 0.0 } else { written.error_from(value) }
    }

    /// The larger of the bounds of both components.
    fn of_vector(&self, ball: Pair<Ball>, value: Vector) -> f64 {
        let both = [(ball.x, value.x), (ball.y, value.y)];
        let is_zero = |&(ball, value): &(Ball, f64)| self.of_number(ball, value) == 0.0;
        if both.iter().all(is_zero) {
            return 0.0;
        }
        // `max` ignores NaN.
        let [x, y] = both.map(|(ball, value)| ball.error_from(value) + of_printing(value));
        if x.is_nan() || y.is_nan() { f64::NAN } else { x.max(y) }
    }

    /// Whether the bounds of a group's places and motions are proved: that one and only one assembly lies within them,
    /// and that its rates do. Where nothing is proved they are infinite.
    #[must_use]
    pub fn is_proved(&self, group: usize) -> bool {
        let group = &self.mechanism.groups[group];
        self.enclosure.as_ref().is_some_and(|enclosure| enclosure.is_proved(self.mechanism, group))
    }

    /// What is said of the groups of which nothing is proved.
    #[must_use]
    pub fn warnings(&self) -> Vec<Message> {
        let groups = self.mechanism.groups.iter().enumerate().filter(|(index, _)| !self.is_proved(*index));
        groups.map(|(_, group)| says::unproved(group.link_names(self.mechanism))).collect()
    }

    /// Of a point's coordinates.
    #[must_use]
    pub fn place(&self, point: PointId) -> f64 {
        let place = self.pose.point(point).coords;
        self.from(|e| Some(e.place(point)), |ball| self.of_vector(ball, place))
    }

    /// Of the angle of a link's axis, in degrees; `None` for a body without one.
    #[must_use]
    pub fn angle(&self, body: BodyId) -> Option<f64> {
        let axis = self.pose.axes[body.0]?;
        let given = match self.mechanism.body(body).role {
            Role::Driver { angle, .. } => angle,
            _ => self.mechanism.placing.as_ref().filter(|p| p.link == body).map(|p| p.angle),
        };
        if given == Some(degrees_of(axis)) {
            return given.map(|given| self.of_given(given));
        }
        let degrees = degrees_of(axis);
        Some(self.from(|e| e.degrees_from(self.mechanism, body, degrees), |error| error + of_printing(degrees)))
    }

    /// Of a slider's position along its guide; `None` where there is no point to count from.
    #[must_use]
    pub fn slide_position(&self, slider: SliderId) -> Option<f64> {
        let position = self.pose.slides[slider.0]?;
        if self.mechanism.slider(slider).drive.is_some_and(|drive| drive.position == Some(position)) {
            return Some(self.of_given(position));
        }
        Some(self.from(|e| e.placed.slides[slider.0], |ball| self.of_number(ball, position)))
    }

    /// Of a body's angular velocity and acceleration.
    #[must_use]
    pub fn angular_rates(&self, body: BodyId) -> [f64; 2] {
        let rates = self.snapshot().angular_rates(body);
        Order::ALL.map(|order| {
            let of = |e: &Enclosure| Some([e.state.body(body).omega, e.state.body(body).alpha][order]);
            self.from(of, |ball| self.of_number(ball, rates[order]))
        })
    }

    /// Of a slider's velocity and acceleration along its guide.
    #[must_use]
    pub fn slide(&self, slider: SliderId) -> [f64; 2] {
        let rates = self.snapshot().slide_rates(slider);
        Order::ALL.map(|order| {
            let of = |e: &Enclosure| Some([e.state.slide(slider).velocity, e.state.slide(slider).acceleration][order]);
            self.from(of, |ball| self.of_number(ball, rates[order]))
        })
    }

    /// Of velocity and acceleration of a point that moves with a body.
    #[must_use]
    pub(crate) fn motion_of(&self, body: BodyId, point: PointId) -> [f64; 2] {
        self.motion_at(body, self.pose.point(point), |e| Some(e.place(point)))
    }

    fn motion_at(&self, body: BodyId, at: Point, place: impl Fn(&Enclosure) -> Option<Pair<Ball>>) -> [f64; 2] {
        let values = self.snapshot().motion_at(body, at);
        Order::ALL.map(|order| {
            let of = |e: &Enclosure| Some(e.motion_at(body, place(e)?)[order]);
            self.from(of, |ball| self.of_vector(ball, values[order]))
        })
    }

    /// Of place, velocity and acceleration of a special point of a construction; `None` at infinity.
    #[must_use]
    pub fn special(&self, special: &Special) -> Option<[f64; 3]> {
        let at = special.place.finite()?;
        let place = |e: &Enclosure| e.special(special);
        let [velocity, acceleration] = self.motion_at(special.link, at, place);
        Some([self.from(place, |ball| self.of_vector(ball, at.coords)), velocity, acceleration])
    }

    /// Of a slider's Coriolis acceleration 2 ω ẑ × v_r.
    #[must_use]
    pub fn coriolis(&self, slider: SliderId) -> f64 {
        let on = self.mechanism.slider(slider).on;
        let value = self.motion.coriolis(self.pose, slider, on);
        self.from(|e| Some(e.coriolis(slider, on)), |ball| self.of_vector(ball, value))
    }

    /// Bound of the error of a quantity: of a vector in each component, of angles in degrees.
    ///
    /// `None` for special points and for what is measured on a plan, and for the direction of a vector that may be zero.
    #[must_use]
    pub fn of(&self, asked: &QuantityRequest) -> Option<f64> {
        let mut whole = asked.clone();
        whole.written.component = None;
        let whole = whole.value(&self.snapshot(), None, None).ok()?;
        let rounding = |whole: &Quantity| whole.as_number().abs() * ROUNDINGS;
        let bound = match &asked.what {
            What::Rate(Rate::Angular(order, link)) => self.angular_rates(*link)[*order],
            What::Rate(Rate::Slide(order, slider)) => self.slide(*slider)[*order],
            What::Angle(link) => self.angle(*link)?,
            What::SlidePosition(slider) => self.slide_position(*slider)?,
            What::Coriolis(slider, _) => self.coriolis(*slider),
            What::Coordinate(_, spot) => self.of_place(spot)?,
            What::Length(a, b) => SQRT_2 * (self.of_place(a)? + self.of_place(b)?) + rounding(&whole),
            What::Motion(order, a, b) => self.of_motion(*order, a, b.as_ref())?,
            What::Part(part, a, b, link) => self.of_part(*part, a, b, (*link)?)?,
            What::Segment(..) => return None,
        };
        let (Quantity::Vector(whole), off) = (whole, SQRT_2 * bound) else {
            return Some(bound);
        };
        match asked.written.component {
            Some(Component::Size) => Some(off + whole.norm() * ROUNDINGS),
            Some(Component::Angle) => {
                (off < whole.norm()).then(|| libm::asin(off / whole.norm()).to_degrees() + 180.0 * ROUNDINGS)
            }
            _ => Some(bound),
        }
    }

    /// Bound of the error of a place's coordinates.
    fn of_place(&self, spot: &Spot) -> Option<f64> {
        let Spot::Point(_, point, _) = spot else {
            return None;
        };
        Some(self.place(*point))
    }

    /// Bound of the error of a velocity or an acceleration, or of the difference of two.
    fn of_motion(&self, order: Order, a: &Spot, b: Option<&Spot>) -> Option<f64> {
        // The bound and the size of one.
        let of = |spot: &Spot| {
            let Spot::Point(body, point, _) = spot else {
                return None;
            };
            let motion = self.snapshot().motion_at(*body, self.pose.point(*point));
            Some((self.motion_of(*body, *point)[order], motion[order].norm()))
        };
        let (error, size) = of(a)?;
        let Some(b) = b else {
            return Some(error);
        };
        // The difference of two is rounded once more.
        let (other_error, other_size) = of(b)?;
        Some(error + other_error + ROUNDINGS * (size + other_size))
    }

    /// Bound of the error of the normal or tangential part of a relative acceleration within a link.
    fn of_part(&self, part: AccelerationPart, a: &Spot, b: &Spot, link: BodyId) -> Option<f64> {
        let (Spot::Point(_, first, _), Spot::Point(_, second, _)) = (a, b) else {
            return None;
        };
        let arm = self.pose.arm(*second, *first).norm();
        let off = self.of_place(a)? + self.of_place(b)?;
        let ([omega, alpha], motion) = (self.angular_rates(link), self.motion.body(link));
        let (factor, error) = match part {
            AccelerationPart::Normal => (motion.omega * motion.omega, (2.0 * motion.omega.abs() + omega) * omega),
            AccelerationPart::Tangential => (motion.alpha.abs(), alpha),
        };
        Some(error * arm + (factor + error) * off + factor * arm * ROUNDINGS)
    }
}

/// Whether [`Bounds::of`] bounds the error of a quantity: all but special points and what is measured on a plan.
#[must_use]
pub(crate) fn is_bounded(asked: &QuantityRequest) -> bool {
    let joint = |spot: &Spot| matches!(spot, Spot::Point(..));
    match &asked.what {
        What::Coordinate(_, spot) => joint(spot),
        What::Length(a, b) => joint(a) && joint(b),
        What::Motion(_, a, b) => joint(a) && b.as_ref().is_none_or(joint),
        What::Part(_, a, b, link) => link.is_some() && joint(a) && joint(b),
        What::Segment(..) => false,
        _ => true,
    }
}

/// How far the shortest decimal that reads as a number, as which it is printed, can be from it: so a bound holds for
/// both. Whole numbers are printed exactly.
fn of_printing(value: f64) -> f64 {
    if value.trunc() == value && value.abs() < 1e15 { 0.0 } else { UNIT_ROUNDOFF * value.abs() * (1.0 + f64::EPSILON) }
}
