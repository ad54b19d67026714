//! In: the loads of a scene, its mechanism, its places and its motion. Out: [`Forces`]: what every joint carries, and what every drive
//! needs. Nothing here runs for a scene without loads.
//!
//! In reading order: `acting` makes loads of masses, gravity, inertia, forces and springs; `equilibrium` finds what joints carry, `friction`
//! what resists their motion;
//! `otherwise` has friction as it is taken by mistake; `power` finds the drives' torques a second time, from velocities; `opened` and `compiled` are quick for many positions; `carried` holds the result.
//!
//! # Forces in joints
//!
//! Each link is cut free. By d'Alembert's principle its loads, inertia among them, and what its joints carry are in equilibrium: two
//! equations of forces and one of moments for each link, about one of its own points, so that far origins cost no digits. An Assur
//! group has as many unknowns in its joints as its links have equations, so groups are solved one after the other, the last one first, and
//! what a group carries is handed to the bodies on which it hangs, reversed. In the end a drive's link gives its torque, or its force
//! along the guide. The equations of a group are the transposed ones of its velocities (Shai and Pennock, *A study of the duality
//! between planar kinematics and statics*, J. Mech. Des. 128 (2006)): they are singular in the same positions.
//!
//! # Two routes
//!
//! The virtual power of all loads, with one drive at rate 1 and the others locked, gives each drive's torque from places and
//! velocities alone (d'Alembert and Lagrange; the moments on Zhukovsky's lever). [`Forces::agreement`] states how far both routes differ.
//!
//! # Bounds
//!
//! All numbers are [`Ball`]s, and the same code runs at a pose and within an enclosure of the true position and
//! motion (`accuracy/`): a stated error is the distance of the one from the other. It runs in f64, too, for one of many positions
//! (`Counted`): without bounds that takes a fraction of the time, and where all joints are pins and guides, it is done by what `compiled` has
//! found once for all positions, several of them side by side ([`Several`]).

mod acting;
mod carried;
mod compiled;
mod equilibrium;
mod friction;
mod opened;
mod otherwise;
mod power;
#[doc(hidden)] // for tests
pub mod says;

use acting::LoadList;
pub use acting::Source;
pub(crate) use acting::{Acting, center, friction_circles, places_of_loads, rubbed_joints, spring_ends};
pub use carried::{Agreement, Drive, Forces};
pub use compiled::Compiled;
pub(crate) use equilibrium::{driven, own_joint};
pub(crate) use otherwise::{FrictionLoad, RubbedJoint, friction_times, rubbing, smooth_over_rough};
pub use power::Driven;
pub(crate) use power::lever_states;

use crate::geometry::{Ball, Number, Pair, SEVERAL, Several, Solvable, Vector, degrees_of};
use crate::mechanism::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::message::Message;
use crate::motion::{Places, State, bounded_motion};
use crate::position::Pose;
use crate::scene::Over;
use crate::sheet::Order;
use indexmap::IndexSet;

/// Where bodies are and how they move, for their forces.
pub(crate) trait Posed<N> {
    /// The place of a point in the fixed frame.
    fn place(&self, point: PointId) -> Pair<N>;
    /// The unit direction of a slider's guide.
    fn guide(&self, slider: SliderId) -> Pair<N>;
    /// A number of the scene.
    fn given(&self, number: f64) -> N;
    /// The unit vector along a link's axis: where lengths are given, the x axis of its own frame. `None` of a body without an axis.
    fn axis(&self, body: BodyId) -> Option<Pair<N>>;
    /// The position of a slider along its guide; `None` where it counts from no point.
    fn slide_position(&self, slider: SliderId) -> Option<N>;
    /// A point in the frame of its body.
    fn local(&self, body: BodyId, point: PointId) -> Pair<N>;
    /// The acceleration of the body's point at a place.
    fn acceleration(&self, body: BodyId, place: Pair<N>) -> Pair<N>;
    /// The velocity of the body's point at a place, and the body's angular velocity.
    fn rates(&self, body: BodyId, place: Pair<N>) -> (Pair<N>, N);
    /// The angular acceleration of a body.
    fn alpha(&self, body: BodyId) -> N;
}

/// The numbers that forces are computed in.
pub(crate) trait Counted: Solvable {
    /// The number that a ball stands for.
    fn of_ball(ball: Ball) -> Self;
    /// The direction of a vector in degrees.
    fn degrees(axis: Pair<Self>) -> Self;
    /// How often a load acts at this place of its table; `given` makes such a number of one of the table.
    fn factor(self, over: &Over, given: impl Fn(f64) -> Self) -> Self;
    /// Tangent and sine of an angle in degrees.
    fn tangent_and_sine(self) -> [Self; 2];
    /// 1 or −1 by its sign; 0 up to the size `least`. A number that may be smaller, or have either sign, has all from −1 to 1.
    fn sense(self, least: Self) -> Self;
    /// The unit vector along a vector, without its bounds; none of what is zero.
    fn way(vector: Pair<Self>) -> Pair<Self>;
    /// By how much the size of a vector exceeds its part along [`Self::way`], anywhere within its bounds.
    fn beyond_way(vector: Pair<Self>) -> Self;
    /// The number without its bound.
    fn rounded(self) -> Self;
    /// Whether all numbers are what they were, to the digits of f64 in parts of the largest.
    fn are_settled(before: &[Self], after: &[Self]) -> bool;
    /// The number with more room around it, in parts of the largest.
    fn roomier(self, largest: Self) -> Self;
    /// Whether all that it may be is within another one.
    fn is_within(self, other: Self) -> bool;
}

/// The part of the largest of several numbers by which they may change and still count as found: the next change is its square.
const SETTLED: f64 = 1e-13;

/// Whether numbers are what they were.
fn are_settled(pairs: impl Iterator<Item = (f64, f64)> + Clone) -> bool {
    let largest = pairs.clone().fold(0.0_f64, |largest, (_, after)| largest.max(after.abs()));
    pairs.fold(0.0_f64, |most, (before, after)| most.max((after - before).abs())) <= SETTLED * largest
}

impl Counted for Ball {
    fn of_ball(ball: Ball) -> Ball {
        ball
    }

    fn degrees(axis: Pair<Ball>) -> Ball {
        let degrees = degrees_of(axis.rounded());
        Ball::within(degrees, axis.degrees_from(degrees))
    }

    fn factor(self, over: &Over, given: impl Fn(f64) -> Ball) -> Ball {
        over.at(self, given)
    }

    fn tangent_and_sine(self) -> [Ball; 2] {
        let line = Pair::direction_of_degrees(self);
        [line.y / line.x, line.y]
    }

    fn sense(self, least: Ball) -> Ball {
        let is_certain = self.smallest() > least.largest();
        if is_certain { Ball::from(1).signed(self.high) } else { Ball { radius: 1.0, ..Ball::default() } }
    }

    fn way(vector: Pair<Ball>) -> Pair<Ball> {
        let size = vector.dot(vector).sqrt();
        let way = if size.smallest() > 0.0 { vector * (Ball::from(1) / size) } else { Pair::default() };
        Pair { x: way.x.middle(), y: way.y.middle() }
    }

    fn beyond_way(vector: Pair<Ball>) -> Ball {
        let way = Ball::way(vector);
        let (size, along, across) = (vector.dot(vector).sqrt(), vector.dot(way), vector.cross(way));
        // |v|² = along² + across², but for the rounding of the unit vector, which all of it is allowed for.
        let whole = size - along;
        let by_parts = across * across / (size + along);
        if by_parts.is_known() && by_parts.radius < whole.radius {
            by_parts.widened(vector.x.largest().max(vector.y.largest()) * ROOM)
        } else {
            whole
        }
    }

    fn rounded(self) -> Ball {
        self.middle()
    }

    fn are_settled(before: &[Ball], after: &[Ball]) -> bool {
        are_settled(before.iter().zip(after).map(|(before, after)| (before.high, after.high)))
    }

    fn roomier(self, largest: Ball) -> Ball {
        self.widened(2.0 * self.radius + ROOM * largest.largest())
    }

    fn is_within(self, other: Ball) -> bool {
        (self - other.middle()).largest() <= other.radius
    }
}

impl Counted for f64 {
    fn of_ball(ball: Ball) -> f64 {
        ball.high
    }

    fn degrees(axis: Pair<f64>) -> f64 {
        degrees_of(Vector::new(axis.x, axis.y))
    }

    fn factor(self, over: &Over, _: impl Fn(f64) -> f64) -> f64 {
        over.at_exactly(self)
    }

    fn tangent_and_sine(self) -> [f64; 2] {
        Ball::decimal(self).tangent_and_sine().map(|ball| ball.high)
    }

    fn sense(self, least: f64) -> f64 {
        if self.abs() <= least { 0.0 } else { self.signum() }
    }

    fn way(vector: Pair<f64>) -> Pair<f64> {
        let size = vector.dot(vector).sqrt();
        if size == 0.0 { vector } else { vector * (1.0 / size) }
    }

    fn beyond_way(_: Pair<f64>) -> f64 {
        0.0
    }

    fn rounded(self) -> f64 {
        self
    }

    fn are_settled(before: &[f64], after: &[f64]) -> bool {
        are_settled(before.iter().copied().zip(after.iter().copied()))
    }

    fn roomier(self, _: f64) -> f64 {
        self
    }

    fn is_within(self, _: f64) -> bool {
        true
    }
}

/// What balls get around them before they are proved to hold a solution, in parts of the largest: more than rounding leaves.
const ROOM: f64 = 1e-28;

impl Counted for Several {
    fn of_ball(ball: Ball) -> Several {
        ball.high.into()
    }

    fn degrees(axis: Pair<Several>) -> Several {
        Several(std::array::from_fn(|lane| degrees_of(Vector::new(axis.x.0[lane], axis.y.0[lane]))))
    }

    fn factor(self, over: &Over, _: impl Fn(f64) -> Several) -> Several {
        self.map(|at| over.at_exactly(at))
    }

    fn tangent_and_sine(self) -> [Several; 2] {
        [0, 1].map(|which: usize| self.map(|degrees| degrees.tangent_and_sine()[which]))
    }

    fn sense(self, least: Several) -> Several {
        Several(std::array::from_fn(|lane| self.0[lane].sense(least.0[lane])))
    }

    fn way(vector: Pair<Several>) -> Pair<Several> {
        let ways: [Pair<f64>; SEVERAL] =
            std::array::from_fn(|lane| f64::way(Pair { x: vector.x.0[lane], y: vector.y.0[lane] }));
        Pair { x: Several(ways.map(|way| way.x)), y: Several(ways.map(|way| way.y)) }
    }

    fn beyond_way(_: Pair<Several>) -> Several {
        Several::default()
    }

    fn rounded(self) -> Several {
        self
    }

    fn are_settled(before: &[Several], after: &[Several]) -> bool {
        let of_lane = |lane: usize| before.iter().zip(after).map(move |(a, b)| (a.0[lane], b.0[lane]));
        (0..SEVERAL).all(|lane| are_settled(of_lane(lane)))
    }

    fn roomier(self, _: Several) -> Several {
        self
    }

    fn is_within(self, _: Several) -> bool {
        true
    }
}

/// The forces in a mechanism, with the drives' torques by both routes; `None` without loads, and where the equations of a group leave a
/// number open, as they do in a singular position and beyond the range of f64.
pub(crate) fn forces(mechanism: &Mechanism, posed: &(impl Posed<Ball> + Places)) -> Option<Forces> {
    let forces = equilibrium::carried(mechanism, posed, &LoadList::new(mechanism)?)?;
    let drives = power::drives(mechanism, posed, &forces)?;
    Some(Forces { drives, ..forces })
}

/// Why forces are not shown at a pose, or what their errors allow for: a spring without length has no direction, friction locks or leaves
/// forces open, or counts as nothing in joints at rest.
pub(crate) fn warnings_of_forces(mechanism: &Mechanism, posed: &(impl Posed<Ball> + Places)) -> Option<Message> {
    let list = LoadList::new(mechanism)?;
    if let Some(&spring) = list.collapsed_springs(posed).first() {
        let (loads, _) = &**mechanism.loads.as_ref()?;
        return Some(says::spring_without_direction(&loads.springs[spring].name));
    }
    if list.friction.is_empty() {
        return None;
    }
    let at_rest = friction::at_rest(mechanism, posed, &list);
    let name = |joint: JointId| {
        let joint = mechanism.joint(joint);
        match (joint.pin, joint.slider) {
            (Some(pin), _) => mechanism.point_name(pin).to_owned(),
            (None, slider) => slider.map_or_else(String::new, |slider| mechanism.slider_name(slider)),
        }
    };
    let names: IndexSet<String> = at_rest.into_iter().map(name).collect();
    let names: Vec<String> = names.into_iter().collect();
    let is_found = equilibrium::carried(mechanism, posed, &list).is_some();
    match (is_found, names.is_empty()) {
        (true, true) => None,
        (true, false) => Some(says::friction_at_rest(names.join(", "))),
        (false, false) => Some(says::friction_leaves_open(names.join(", "))),
        (false, true) => {
            let smooth = equilibrium::carried(mechanism, posed, &list.without_friction());
            smooth.map(|_| says::friction_locks())
        }
    }
}

/// A pose and its motion, whose numbers count as exact.
pub(crate) struct AtPose<'a> {
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub state: State,
}

impl AtPose<'_> {
    pub fn new<'a>(mechanism: &'a Mechanism, pose: &'a Pose) -> AtPose<'a> {
        AtPose { mechanism, pose, state: bounded_motion(mechanism, pose, Order::Acceleration) }
    }
}

impl Places for AtPose<'_> {
    fn place(&self, point: PointId) -> Pair<Ball> {
        self.pose.place(point)
    }

    fn arm(&self, from: PointId, to: PointId) -> Pair<Ball> {
        Places::arm(self.pose, from, to)
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        Places::guide(self.pose, slider)
    }

    fn given(&self, number: f64) -> Ball {
        self.pose.given(number)
    }

    fn rate(&self, rate: f64) -> Ball {
        self.pose.rate(rate)
    }

    fn omega(&self, body: BodyId, omega: f64) -> Ball {
        self.pose.omega(body, omega)
    }
}

impl Posed<Ball> for AtPose<'_> {
    fn place(&self, point: PointId) -> Pair<Ball> {
        self.pose.place(point)
    }

    fn guide(&self, slider: SliderId) -> Pair<Ball> {
        Places::guide(self.pose, slider)
    }

    fn given(&self, number: f64) -> Ball {
        self.pose.given(number)
    }

    fn axis(&self, body: BodyId) -> Option<Pair<Ball>> {
        self.pose.axes[body.0].map(|axis| Pair::within(axis, 0.0).unit())
    }

    fn slide_position(&self, slider: SliderId) -> Option<Ball> {
        self.pose.slides[slider.0].map(|position| Ball::within(position, 0.0))
    }

    fn local(&self, body: BodyId, point: PointId) -> Pair<Ball> {
        Pair::within(self.mechanism.local(body, point).coords, 0.0)
    }

    fn acceleration(&self, body: BodyId, place: Pair<Ball>) -> Pair<Ball> {
        self.state.body(body).referred_to(place).acceleration
    }

    fn rates(&self, body: BodyId, place: Pair<Ball>) -> (Pair<Ball>, Ball) {
        let motion = self.state.body(body).referred_to(place);
        (motion.velocity, motion.omega)
    }

    fn alpha(&self, body: BodyId) -> Ball {
        self.state.body(body).alpha
    }
}
