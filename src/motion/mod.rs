//! In: a mechanism and its [`Pose`]. Out: a [`Motion`]: velocities and accelerations of every body, with bounds of
//! their errors. They come from the loop equations alone, never from a special point (those are for drawing, see
//! `construction`). One matrix serves velocities and accelerations; groups near a singular position get a warning,
//! singular ones an error. Numbers are computed with twice the digits of f64 and a bound of the error, and rounded once
//! at the end.
//!
//! # Why numbers come from loop equations
//!
//! For each independent loop of a group, from known body to known body, with the revolute joints p_k, arms r_k =
//! p_(k+1) − p_k, J the quarter turn, u the unit guides:
//!
//! ```text
//! velocity      Σ ω_k J r_k + Σ ṡ u = v_end − v_start
//! acceleration  Σ α_k J r_k + Σ s̈ u = a_end − a_start + Σ ω_k² r_k − Σ 2 ω ṡ J u          (same matrix)
//! ```
//!
//! Links that a prismatic joint ties together share one ω; so there are two unknowns for each loop whatever the
//! joints: one computation for every class. Any other constraint between rotations is one equation more, Σ weight ω =
//! 0, for one unknown more; its weights are whole numbers, as of teeth, so that angles need no counting of turns. A
//! dyad's one loop is a 2 × 2 system. In classes III and IV each loop has one rate of its own (unless a closure link
//! has two sliders); crossing with that rate's column leaves one 2 × 2 system (`refine`). Only differences of
//! coordinates and of input motions enter, so far origins, odd units and large common velocities cost no digits.
//!
//! # How accuracy is stated
//!
//! Every number on the way to a motion is a ball: twice the digits of f64 and a bound of its error, which sums and
//! products carry along (`geometry/ball.rs`). The loop equations are solved in f64; what the solution leaves of them,
//! computed with all digits, gives a correction, until it is small enough (`refine`). The last one's bound is |R|
//! (|residual| + what the inputs bring + rounding) and what I − R A leaves of it, element by element, R the computed
//! inverse: a bound that is proved, not estimated (`geometry/system.rs`). A group that hangs on another inherits its
//! balls. Rounded once at the end, each ω and α of hard groups, given their joints' places, errs by less than 4 u of
//! its own value whatever the condition, and velocities and accelerations stay below 1 u·condition
//! (`tests/library/accuracy.rs`). The condition number is that of the matrix scaled by powers of two, in the row-sum
//! norm: about how much errors of the vectors between joints, each in parts of itself, are enlarged in the largest rates, each
//! counted with the size of its link. A group counts as singular from condition 0.05/u (u = 2⁻⁵³):
//! coordinates rounded to f64 would determine no digit.
//!
//! # Limit, change point or neither
//!
//! Where a group is singular, `singular` says what it is: the rates that the drives demand grow without bound at a limit, and
//! are not determined at a change point. Of a dyad on a crank `reach` tells it by the signs of sums of lengths, and where it is.

mod moving;
mod reach;
mod refine;
#[doc(hidden)] // for tests
pub mod says;
mod singular;
mod solve;
mod train;

pub use moving::Places;
pub(crate) use moving::guide_error;
pub use refine::ClosedForm;
pub use singular::{Standing, drive_stands};
pub use solve::motion;
pub use train::{Train, TrainWheel};

pub(crate) use moving::{BoundedMotion, State};
pub(crate) use reach::Reach;
pub(crate) use refine::coefficient_errors;
pub(crate) use solve::{bounded_motion, standing_of};

use crate::Problem;
use crate::geometry::{Point, Vector, quarter_turn};
use crate::mechanism::{BodyId, SliderId};
use crate::message::Message;
use crate::position::Pose;
use crate::sheet::Order;

/// The motion of a rigid body: its rotation, and the motion of a reference point, in the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMotion {
    /// The reference point.
    pub at: Point,
    /// Velocity of the body's point at `at`.
    pub velocity: Vector,
    /// Acceleration of the body's point at `at`; zero for [`Order::Velocity`].
    pub acceleration: Vector,
    /// Angular velocity, counter-clockwise positive, rad per unit of time.
    pub omega: f64,
    /// Angular acceleration, rad per unit of time squared; zero for [`Order::Velocity`].
    pub alpha: f64,
}

impl BodyMotion {
    /// Velocity of the body's point at `p`: v + ω × (p − at).
    #[must_use]
    pub fn velocity_at(&self, p: Point) -> Vector {
        self.velocity + self.swing(p)
    }

    /// Acceleration of the body's point at `p`: a + α × (p − at) − ω² (p − at).
    #[must_use]
    pub fn acceleration_at(&self, p: Point) -> Vector {
        self.acceleration + self.tangential(p) + self.normal(p)
    }

    /// Velocity of the point at `p` relative to that at [`Self::at`].
    #[must_use]
    pub fn swing(&self, p: Point) -> Vector {
        quarter_turn(p - self.at) * self.omega
    }

    /// Tangential acceleration of the point at `p` relative to that at [`Self::at`].
    #[must_use]
    pub fn tangential(&self, p: Point) -> Vector {
        quarter_turn(p - self.at) * self.alpha
    }

    /// Normal acceleration of the point at `p` relative to that at [`Self::at`].
    #[must_use]
    pub fn normal(&self, p: Point) -> Vector {
        (p - self.at) * -(self.omega * self.omega)
    }
}

/// Bounds on the errors of a body's motion, the positions taken as exact; zero where the motion is given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionErrors {
    /// Bounds on the errors of the components of the velocity at [`BodyMotion::at`].
    pub velocity: Vector,
    /// Bounds on the errors of the components of the acceleration there.
    pub acceleration: Vector,
    /// Bound on the error of ω.
    pub omega: f64,
    /// Bound on the error of α.
    pub alpha: f64,
}

/// The motion of a slider along its guide, relative to the guide's body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlideMotion {
    /// Sliding velocity v_r, positive along the guide.
    pub velocity: f64,
    /// Sliding acceleration a_r.
    pub acceleration: f64,
    /// Bound on the error of `velocity`.
    pub velocity_error: f64,
    /// Bound on the error of `acceleration`.
    pub acceleration_error: f64,
}

/// Velocities and accelerations of a mechanism at a pose.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Motion {
    /// Up to which order it is computed.
    pub order: Order,
    /// By body. For an unsolved link or a carrier only the motion of the carried point has a meaning.
    pub bodies: Vec<BodyMotion>,
    /// By body: bounds on its errors.
    pub errors: Vec<MotionErrors>,
    /// By slider.
    pub slides: Vec<SlideMotion>,
    /// By group: the condition number of its scaled loop equations, at least 1.
    pub conditions: Vec<f64>,
    /// Warnings on groups near a singular position.
    pub warnings: Vec<Message>,
}

impl Motion {
    /// The motion of a body.
    #[must_use]
    pub fn body(&self, id: BodyId) -> &BodyMotion {
        &self.bodies[id.0]
    }

    /// Bounds on the errors of a body's motion.
    #[must_use]
    pub fn error(&self, id: BodyId) -> &MotionErrors {
        &self.errors[id.0]
    }

    /// The motion of a slider along its guide.
    #[must_use]
    pub fn slide(&self, id: SliderId) -> &SlideMotion {
        &self.slides[id.0]
    }

    /// The Coriolis acceleration 2 ω ẑ × v_r of a slider, ω the angular velocity of body `on` of its guide.
    #[must_use]
    pub fn coriolis(&self, pose: &Pose, id: SliderId, on: BodyId) -> Vector {
        let sliding = pose.guide(id) * self.slide(id).velocity;
        quarter_turn(sliding) * (2.0 * self.body(on).omega)
    }
}

/// Reasons why the motion at a pose is not defined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", self.problem())]
#[non_exhaustive]
pub enum MotionError {
    /// The group is in a singular position.
    Singular {
        /// The group's links.
        links: String,
        /// The concurrent or parallel lines.
        reason: Message,
        /// Condition number of the loop equations; infinite where a pivot vanishes.
        condition: f64,
        /// Whether it is a limit or a change point.
        standing: Standing,
        /// Where the drive stands, in words; empty without one.
        at: String,
    },
    /// A number of the group with these links exceeds the range of f64.
    Overflow(String),
}

impl MotionError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            MotionError::Singular { links, reason, condition, standing, at } => {
                let reason = reason.clone();
                let message = match standing {
                    Standing::Limit => says::at_limit(at, links, reason),
                    Standing::Change => says::at_change(at, links, reason),
                    _ if condition.is_finite() => says::singular(links, reason, format!("{condition:.1e}")),
                    _ => says::singular_exactly(links, reason),
                };
                Problem::new(message).hint(says::move_a_joint())
            }
            MotionError::Overflow(links) => Problem::new(says::overflow(links)).hint(says::larger_units()),
        }
    }
}
