use super::given::{Given, Room, Vector};
use super::locals::Locals;
use super::placed::TruePlaces;
use super::places::PlacesOf;
use crate::construction::{Course, CutLine, Rate, Special, Truth};
use crate::forces::Posed;
use crate::geometry::{Ball, Pair};
use crate::mechanism::{BodyId, Group, Mechanism, PointId, SliderId};
use crate::motion::{Places, State, bounded_motion};
use crate::position::Pose;
use crate::scene::Scene;
use crate::sheet::Order;

/// The true position and motion of a scene's mechanism near a pose, each number with a bound of its error: those that
/// follow from the numbers of the scene as they are written, whatever the pose has lost by rounding.
#[derive(Clone, Debug)]
pub(super) struct Enclosure {
    pub placed: TruePlaces,
    pub state: State,
}

impl Enclosure {
    /// The true position and motion near `pose`, which belongs to `mechanism`, which was made from `scene`; its drives
    /// may have been given other positions and rates since, and stand anywhere within `room` of these.
    ///
    /// Bounds are infinite where nothing is proved: that there is one assembly near the pose and no other, or that its
    /// equations are regular; or numbers leave the range of f64. `None` where a drive has no position.
    pub fn new(scene: &Scene, mechanism: &Mechanism, pose: &Pose, order: Order, room: Room) -> Option<Enclosure> {
        let placed = TruePlaces::new(&Given { scene, mechanism: mechanism.for_positions(), room }, pose)?;
        let places =
            PlacesOf { given: Given { scene, mechanism, room }, points: &placed.points, guides: &placed.guides };
        let state = bounded_motion(mechanism, &places, order);
        Some(Enclosure { state, placed })
    }

    /// Whether all of a group has bounds: then they hold by proof.
    pub fn is_proved(&self, mechanism: &Mechanism, group: &Group) -> bool {
        group.bodies.iter().all(|&body| {
            let motion = self.state.body(body);
            let places = mechanism.body(body).points.iter().map(|&point| self.place(point));
            let vectors = places.chain([motion.velocity, motion.acceleration]);
            let numbers = vectors.flat_map(|v| [v.x, v.y]).chain([motion.omega, motion.alpha]);
            numbers.into_iter().all(Ball::is_known)
        })
    }

    /// The place of a point.
    pub fn place(&self, point: PointId) -> Pair<Ball> {
        self.placed.points[point.0]
    }

    /// The unit direction of a slider's guide.
    pub fn guide(&self, slider: SliderId) -> Pair<Ball> {
        self.placed.guides[slider.0]
    }

    /// A body's angular velocity and acceleration.
    pub fn angular_rates(&self, body: BodyId) -> [Ball; 2] {
        let motion = self.state.body(body);
        [motion.omega, motion.alpha]
    }

    /// A slider's velocity and acceleration along its guide.
    pub fn slide_rates(&self, slider: SliderId) -> [Ball; 2] {
        let slide = self.state.slide(slider);
        [slide.velocity, slide.acceleration]
    }

    /// Velocity and acceleration of the body's point at a place.
    pub fn motion_at(&self, body: BodyId, place: Pair<Ball>) -> [Pair<Ball>; 2] {
        let motion = self.state.body(body).referred_to(place);
        [motion.velocity, motion.acceleration]
    }

    /// The Coriolis acceleration 2 ω ẑ × v_r of a slider, ω the angular velocity of body `on` of its guide.
    pub fn coriolis(&self, slider: SliderId, on: BodyId) -> Pair<Ball> {
        let rate = self.state.body(on).omega * self.state.slide(slider).velocity;
        self.guide(slider).quarter_turn() * rate.twice()
    }

    /// The place of a special point; `None` where its cut lines may be parallel.
    pub fn special(&self, special: &Special) -> Option<Pair<Ball>> {
        let [a, b] = [0, 1].map(|side| self.line(&special.cuts[side], special.target));
        let ([start, along], [other, across]) = (a?, b?);
        // start + along t lies on the other line.
        let t = (other - start).cross(across) / along.cross(across);
        let place = start.plus_scaled(along, t);
        (place.x.is_known() && place.y.is_known()).then_some(place)
    }

    /// A place and the direction of a cut line.
    fn line(&self, cut: &CutLine, target: Option<PointId>) -> Option<[Vector; 2]> {
        match cut.course {
            Course::Through(from, to) => {
                let to = to.or(target)?;
                Some([self.place(from), self.place(to) - self.place(from)])
            }
            Course::Normal(slider, at) => Some([self.place(at), self.guide(slider).quarter_turn()]),
            Course::AtInfinity => None,
        }
    }

    /// The bound of the difference of a link's axis from an angle in degrees.
    pub fn degrees_from(&self, mechanism: &Mechanism, body: BodyId, degrees: f64) -> Option<f64> {
        Some(self.axis(mechanism, body)?.degrees_from(degrees))
    }

    /// The direction of a link's axis.
    fn axis(&self, mechanism: &Mechanism, body: BodyId) -> Option<Vector> {
        self.placed.turns[body.0].or_else(|| self.drawn_axis(mechanism, body))
    }

    /// The axis of a link as drawn: through its first two points, or else along its guide.
    fn drawn_axis(&self, mechanism: &Mechanism, body: BodyId) -> Option<Vector> {
        match mechanism.body(body).points.as_slice() {
            [a, b, ..] => Some(self.place(*b) - self.place(*a)),
            _ => {
                let of_body = |id: &SliderId| [mechanism.slider(*id).on, mechanism.slider(*id).link].contains(&body);
                mechanism.slider_ids().find(of_body).map(|id| self.guide(id))
            }
        }
    }
}

/// The true position and motion with what the scene gives, for forces.
pub(super) struct Loaded<'a> {
    pub places: PlacesOf<'a>,
    pub enclosure: &'a Enclosure,
    locals: Locals<'a>,
}

impl<'a> Loaded<'a> {
    pub fn new(scene: &'a Scene, mechanism: &'a Mechanism, enclosure: &'a Enclosure) -> Loaded<'a> {
        // Where drives stand is in the enclosure.
        let given = Given { scene, mechanism, room: Room::default() };
        let TruePlaces { points, guides, .. } = &enclosure.placed;
        Loaded { places: PlacesOf { given, points, guides }, enclosure, locals: Locals::new(given) }
    }
}

impl Places for Loaded<'_> {
    fn place(&self, point: PointId) -> Vector {
        self.places.place(point)
    }

    fn arm(&self, from: PointId, to: PointId) -> Vector {
        self.places.arm(from, to)
    }

    fn guide(&self, slider: SliderId) -> Vector {
        Places::guide(&self.places, slider)
    }

    fn given(&self, number: f64) -> Ball {
        self.places.given(number)
    }

    fn rate(&self, rate: f64) -> Ball {
        self.places.rate(rate)
    }

    fn omega(&self, body: BodyId, omega: f64) -> Ball {
        self.places.omega(body, omega)
    }
}

impl Posed<Ball> for Loaded<'_> {
    fn place(&self, point: PointId) -> Vector {
        self.places.place(point)
    }

    fn guide(&self, slider: SliderId) -> Vector {
        Places::guide(&self.places, slider)
    }

    fn given(&self, number: f64) -> Ball {
        self.places.given(number)
    }

    fn axis(&self, body: BodyId) -> Option<Vector> {
        self.enclosure.axis(self.places.given.mechanism, body)
    }

    fn slide_position(&self, slider: SliderId) -> Option<Ball> {
        self.enclosure.placed.slides[slider.0]
    }

    fn local(&self, body: BodyId, point: PointId) -> Vector {
        self.locals.place(body, point).unwrap_or_default()
    }

    fn acceleration(&self, body: BodyId, place: Vector) -> Vector {
        let [_, acceleration] = self.enclosure.motion_at(body, place);
        acceleration
    }

    fn rates(&self, body: BodyId, place: Vector) -> (Vector, Ball) {
        let motion = self.enclosure.state.body(body).referred_to(place);
        (motion.velocity, motion.omega)
    }

    fn alpha(&self, body: BodyId) -> Ball {
        self.enclosure.state.body(body).alpha
    }
}

impl Truth for Enclosure {
    fn place(&self, point: PointId) -> Pair<Ball> {
        Enclosure::place(self, point)
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        Enclosure::guide(self, slider)
    }

    fn rate(&self, rate: Rate) -> Ball {
        match rate {
            Rate::Angular(order, body) => self.angular_rates(body)[order],
            Rate::Slide(order, slider) => self.slide_rates(slider)[order],
        }
    }

    fn motion(&self, order: Order, body: BodyId, point: PointId) -> Pair<Ball> {
        self.motion_at(body, Enclosure::place(self, point))[order]
    }
}
