use super::enclosure::{Enclosure, Loaded};
use super::given::Room;
use super::says;
use crate::construction::{Construction, Special, Values};
use crate::forces::{Forces, forces};
use crate::geometry::{Ball, Pair, Point, UNIT_ROUNDOFF, Vector, degrees_of};
use crate::mechanism::{BodyId, Group, Mechanism, PointId, Role, SliderId};
use crate::message::Message;
use crate::motion::{Motion, Standing, drive_stands, standing_of};
use crate::position::Pose;
use crate::quantity::{Snapshot, State};
use crate::scene::Scene;
use crate::sheet::Order;
use std::cell::OnceCell;

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
    pub(super) scene: &'a Scene,
    pub(super) mechanism: &'a Mechanism,
    pose: &'a Pose,
    motion: &'a Motion,
    pub(super) enclosure: Option<Enclosure>,
    pub(super) construction: Option<&'a Construction>,
    /// The construction carried out within the enclosure, once it is asked for.
    pub(super) plans: OnceCell<Option<Values<Ball>>>,
    /// The forces within the enclosure, once they are asked for.
    forces: OnceCell<Option<Forces>>,
}

/// Bounds of the errors of `pose` and `motion`, which belong to `mechanism`, which was made from `scene`.
///
/// The mechanism's drives may have been given other positions and rates since: these then count as given.
#[must_use]
pub fn bounds<'a>(scene: &'a Scene, mechanism: &'a Mechanism, pose: &'a Pose, motion: &'a Motion) -> Bounds<'a> {
    bounds_within(scene, mechanism, pose, motion, Room::default())
}

/// The same where drives may stand anywhere within `room` of their values.
pub(crate) fn bounds_within<'a>(
    scene: &'a Scene,
    mechanism: &'a Mechanism,
    pose: &'a Pose,
    motion: &'a Motion,
    room: Room,
) -> Bounds<'a> {
    let enclosure = Enclosure::new(scene, mechanism, pose, motion.order, room);
    Bounds {
        scene,
        mechanism,
        pose,
        motion,
        enclosure,
        construction: None,
        plans: OnceCell::new(),
        forces: OnceCell::new(),
    }
}

impl<'a> Bounds<'a> {
    /// With what the plans of that motion show, and the special points.
    #[must_use]
    pub fn with_plans(self, construction: &'a Construction) -> Self {
        Bounds { construction: Some(construction), plans: OnceCell::new(), ..self }
    }

    /// The forces within the enclosure; `None` without loads or an enclosure, or where the equations of a group may be singular.
    pub(crate) fn forces(&self) -> Option<&Forces> {
        let enclosed = || {
            let enclosure = self.enclosure.as_ref().filter(|_| self.mechanism.loads.is_some())?;
            forces(self.mechanism, &self.loaded(enclosure))
        };
        self.forces.get_or_init(enclosed).as_ref()
    }

    /// What forces ask of an enclosure.
    pub(super) fn loaded<'e>(&'e self, enclosure: &'e Enclosure) -> Loaded<'e> {
        Loaded::new(self.scene, self.mechanism, enclosure)
    }

    /// Bound of the error of a number that is read from forces, and from the directions of guides.
    pub(crate) fn of_force(
        &self,
        value: f64,
        read: impl Fn(&Forces, &dyn Fn(SliderId) -> Pair<Ball>) -> Option<Ball>,
    ) -> f64 {
        let of = |e: &Enclosure| read(self.forces()?, &|slider| e.guide(slider));
        self.from(of, |ball| self.of_number(ball, value))
    }

    /// The same of a vector: of each component.
    pub(crate) fn of_force_vector(&self, value: Vector, read: impl Fn(&Forces) -> Option<Pair<Ball>>) -> f64 {
        self.from(|_| read(self.forces()?), |ball| self.of_vector(ball, value))
    }

    pub(super) fn snapshot(&self) -> Snapshot<'_> {
        Snapshot { pose: self.pose, motion: self.motion }
    }

    pub(super) fn enclosure(&self) -> Option<&Enclosure> {
        self.enclosure.as_ref()
    }

    /// The plans within the enclosure; `None` without them, or without an enclosure.
    pub(super) fn plans(&self) -> Option<&Values<Ball>> {
        let enclosed = || Some(self.construction?.enclosed(self.enclosure.as_ref()?));
        self.plans.get_or_init(enclosed).as_ref()
    }

    /// The bound that the enclosure gives; infinite where it gives none.
    pub(super) fn from<T>(&self, of: impl Fn(&Enclosure) -> Option<T>, error: impl Fn(T) -> f64) -> f64 {
        let bound = self.enclosure.as_ref().and_then(of).map_or(f64::INFINITY, error);
        if bound.is_nan() { f64::INFINITY } else { bound }
    }

    /// The bound of the error of a number with the true value `ball`; zero for one that the scene gives, which is printed
    /// as it is written.
    pub(super) fn of_number(&self, ball: Ball, value: f64) -> f64 {
        if self.is_as_written(ball, value) { 0.0 } else { ball.error_from(value) + of_printing(value) }
    }

    fn is_as_written(&self, ball: Ball, value: f64) -> bool {
        // Only what the scene gives is so near to its f64.
        let is_near = ball.error_from(value) <= f64::EPSILON * value.abs();
        is_near && self.scene.is_written(value) && ball == self.scene.as_written_or_printed(value)
    }

    /// That of a number that the scene gives, or that a drive has been given since.
    fn of_given(&self, value: f64) -> f64 {
        let written = self.scene.as_written_or_printed(value);
        let is_printed_alike = self.scene.is_written(value) || written == Ball::decimal(value);
        if is_printed_alike { 0.0 } else { written.error_from(value) + of_printing(value) }
    }

    /// The larger of the bounds of both components.
    pub(super) fn of_vector(&self, ball: Pair<Ball>, value: Vector) -> f64 {
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
        let of_group = |(index, group): (usize, &Group)| {
            let links = group.link_names(self.mechanism);
            let place = || drive_stands(self.mechanism, self.pose).join(" = ");
            match standing_of(self.mechanism, self.pose, index) {
                Standing::Limit => says::at_limit(place(), links),
                Standing::Change => says::at_change(place(), links),
                Standing::Unknown => says::unproved(links),
            }
        };
        groups.map(of_group).collect()
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
        Order::ALL
            .map(|order| self.from(|e| Some(e.angular_rates(body)[order]), |ball| self.of_number(ball, rates[order])))
    }

    /// Of a slider's velocity and acceleration along its guide.
    #[must_use]
    pub fn slide(&self, slider: SliderId) -> [f64; 2] {
        let rates = self.snapshot().slide_rates(slider);
        Order::ALL
            .map(|order| self.from(|e| Some(e.slide_rates(slider)[order]), |ball| self.of_number(ball, rates[order])))
    }

    /// Of velocity and acceleration of a point that moves with a body.
    #[must_use]
    pub fn motion_of(&self, body: BodyId, point: PointId) -> [f64; 2] {
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
}

/// How far the shortest decimal that reads as a number, as which it is printed, can be from it: so a bound holds for
/// both. Whole numbers are printed exactly.
pub(super) fn of_printing(value: f64) -> f64 {
    if value.trunc() == value && value.abs() < 1e15 { 0.0 } else { UNIT_ROUNDOFF * value.abs() * (1.0 + f64::EPSILON) }
}
