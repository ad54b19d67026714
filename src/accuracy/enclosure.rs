use super::given::{Given, Vector};
use super::placed::{TruePlaces, relative};
use crate::construction::{Course, CutLine, Special};
use crate::geometry::{self, Ball, Pair, Point};
use crate::mechanism::{BodyId, Mechanism, PointId, Role, SliderId};
use crate::motion::{Places, State, bounded_motion};
use crate::position::Pose;
use crate::scene::Scene;
use crate::sheet::Order;

/// The true position and motion of a scene's mechanism near a pose, each number with a bound of its error.
///
/// Numbers of the scene count as written: each lies between the decimal that the person wrote and the f64 as which it
/// was read. Nothing else is uncertain, whatever the pose has lost by rounding.
#[derive(Clone, Debug)]
pub(super) struct Enclosure {
    pub placed: TruePlaces,
    pub state: State,
}

impl Enclosure {
    /// The true position and motion near `pose`, which belongs to `mechanism`, which was made from `scene`; its drives
    /// may have been given other positions and rates since.
    ///
    /// Bounds are infinite where nothing can be said: the errors of what the scene gives reach a limit position or a
    /// singular one, or numbers leave the range of f64. In a chain bounds about double from group to group: they do not
    /// know that errors with one cause cancel. `None` where a drive has no position.
    pub fn new(scene: &Scene, mechanism: &Mechanism, pose: &Pose, order: Order) -> Option<Enclosure> {
        let placed = TruePlaces::new(&Given { scene, mechanism: mechanism.for_positions() }, pose)?;
        let points = relative(&placed.points);
        let guides: Vec<geometry::Vector> = placed.guides.iter().map(|guide| guide.rounded()).collect();
        let places = PlacesOf { given: Given { scene, mechanism }, placed: &placed, points: &points, guides: &guides };
        let state = bounded_motion(mechanism, &places, order);
        Some(Enclosure { state, placed })
    }

    /// The place of a point.
    pub fn place(&self, point: PointId) -> Pair<Ball> {
        self.placed.points[point.0]
    }

    /// The unit direction of a slider's guide.
    pub fn guide(&self, slider: SliderId) -> Pair<Ball> {
        self.placed.guides[slider.0]
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

    /// The angle of a link's axis in degrees from `axis`, its direction in a pose: the bound of the difference.
    pub(super) fn angle_from(&self, mechanism: &Mechanism, body: BodyId, axis: geometry::Vector) -> Option<f64> {
        let along = self.placed.turns[body.0].or_else(|| self.drawn_axis(mechanism, body))?;
        let rough = Vector::from(axis);
        let (across, size) = (rough.cross(along), libm::hypot(along.x.high, along.y.high) * axis.norm());
        // A small angle is as large as its sine but for the third power.
        let sine = across.error_from(0.0) / size;
        (sine < 0.1).then(|| (sine * (1.0 + sine * sine)).to_degrees())
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

/// Places with their errors, for the computation of the motion.
struct PlacesOf<'a> {
    given: Given<'a>,
    placed: &'a TruePlaces,
    points: &'a [Point],
    guides: &'a [geometry::Vector],
}

impl Places for PlacesOf<'_> {
    const UNCERTAIN: bool = true;

    fn place(&self, point: PointId) -> Vector {
        self.placed.points[point.0]
    }

    fn arm(&self, from: PointId, to: PointId) -> Vector {
        self.placed.points[to.0] - self.placed.points[from.0]
    }

    fn guide(&self, slider: SliderId) -> Vector {
        self.placed.guides[slider.0]
    }

    fn points(&self) -> &[Point] {
        self.points
    }

    fn guides(&self) -> &[geometry::Vector] {
        self.guides
    }

    fn given(&self, number: f64) -> Ball {
        Ball::written(number)
    }

    fn omega(&self, body: BodyId, omega: f64) -> Ball {
        let is_driven = matches!(self.given.mechanism.body(body).role, Role::Driver { .. });
        if is_driven { self.given.omega(body, omega) } else { Ball::written(omega) }
    }
}
