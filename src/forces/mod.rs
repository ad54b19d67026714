//! In: the loads of a scene, its mechanism, its places and its motion. Out: [`Forces`]: what every joint carries, and what every drive
//! needs. Nothing here runs for a scene without loads.
//!
//! In reading order: `acting` makes loads of masses, gravity, inertia, forces and springs; `equilibrium` finds what joints carry;
//! `power` finds the drives' torques a second time, from velocities; `opened` and `compiled` are quick for many positions; `carried` holds the result.
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
mod opened;
mod power;

use acting::LoadList;
pub use acting::Source;
pub(crate) use acting::center;
pub use carried::{Agreement, Drive, Forces};
pub use compiled::Compiled;
pub(crate) use equilibrium::{driven, own_joint};
pub use power::Driven;
pub(crate) use power::lever_states;

use crate::geometry::{Ball, Pair, Several, Solvable, Vector, degrees_of};
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId};
use crate::motion::{Places, State, bounded_motion};
use crate::position::Pose;
use crate::scene::Over;
use crate::sheet::Order;

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
    /// How often a load acts at this place of its table.
    fn factor(self, over: &Over) -> Self;
}

impl Counted for Ball {
    fn of_ball(ball: Ball) -> Ball {
        ball
    }

    fn degrees(axis: Pair<Ball>) -> Ball {
        let degrees = degrees_of(axis.rounded());
        Ball::from(degrees).widened(axis.degrees_from(degrees))
    }

    fn factor(self, over: &Over) -> Ball {
        over.at(self)
    }
}

impl Counted for f64 {
    fn of_ball(ball: Ball) -> f64 {
        ball.high
    }

    fn degrees(axis: Pair<f64>) -> f64 {
        degrees_of(Vector::new(axis.x, axis.y))
    }

    fn factor(self, over: &Over) -> f64 {
        over.at_exactly(self)
    }
}

impl Counted for Several {
    fn of_ball(ball: Ball) -> Several {
        ball.high.into()
    }

    fn degrees(axis: Pair<Several>) -> Several {
        Several(std::array::from_fn(|lane| degrees_of(Vector::new(axis.x.0[lane], axis.y.0[lane]))))
    }

    fn factor(self, over: &Over) -> Several {
        self.map(|at| over.at_exactly(at))
    }
}

/// The forces in a mechanism, with the drives' torques by both routes; `None` without loads, and where the equations of a group leave a
/// number open, as they do in a singular position and beyond the range of f64.
pub(crate) fn forces(mechanism: &Mechanism, posed: &(impl Posed<Ball> + Places)) -> Option<Forces> {
    let acting = LoadList::new(mechanism)?.acting(posed)?;
    let forces = equilibrium::carried(mechanism, posed, acting)?;
    let drives = power::drives(mechanism, posed, &forces)?;
    Some(Forces { drives, ..forces })
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
        self.pose.axes[body.0].map(|axis| Pair::from(axis).unit())
    }

    fn slide_position(&self, slider: SliderId) -> Option<Ball> {
        self.pose.slides[slider.0].map(Ball::from)
    }

    fn local(&self, body: BodyId, point: PointId) -> Pair<Ball> {
        self.mechanism.local(body, point).coords.into()
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
