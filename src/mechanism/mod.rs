//! In: a checked [`Scene`](crate::scene::Scene). Out: a [`Mechanism`]: bodies, joints and Assur groups in solving
//! order. Names have become indices, shared points revolute joints, lengths local coordinates. No position is computed
//! here: a mechanism is the same in every position.
//!
//! # The order of the file says nothing
//!
//! Bodies, points and joints stand in the order of their names, so that no stage can decide anything by which of two the file names first: which
//! group is solved first, at which link the joints of a pin are, which link leads a compound one, of which link modes are
//! numbered. The first two points of a link are its axis, and the frame's first point is an origin: these the format says.
//!
//! # A driven slider leaves nothing to find between its two links
//!
//! They have one rotation and slide as the scene says, so to the structure, the loops and the positions they are one
//! *compound link* of changing lengths (`compound`): its lead stands in groups and loops, and `compound` gives the
//! driven sliders between two of its links. Where a loop passes them they add −u ṡ, and −u s̈ − 2 ω ṡ J u, to the
//! right sides; in the plans v_r, a_r and 2 ω × v_r are laid off before the ray. What a drive pushes from a known
//! body is known too.

mod build;
mod compound;
mod drives;
mod group;
mod joint;
mod loaded;
mod loops;
#[doc(hidden)] // for tests
pub mod says;
mod shape;
#[doc(hidden)] // for tests
pub mod structure;

pub use build::mechanism;
#[doc(hidden)] // for tests
pub use build::mechanism_with;
pub(crate) use build::{mirrored_mechanism, renumber};
pub use group::{Carried, Class, Group, Leg, Loop, SpecialPoint};
pub use joint::{
    AngularConstraint, Belt, Constant, Contact, DrivenSlide, Guide, Joint, Mark, Pitch, Rack, Rolling, Slider, Touch,
    Touching, Travel,
};
pub use loops::{
    AngularRate, AngularTerms, Arm, LoopEquations, LoopTerms, Reduction, Slide, SlideRate, TravelTerms, Travelling,
};

use crate::Problem;
use crate::geometry::{Ball, Point, Vector};
use crate::message::Message;
use crate::scene::{GivenBy, Loads, On, SceneError, TimeUnit};
use std::sync::Arc;

/// Index of a named point in [`Mechanism::points`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointId(pub usize);

/// Index of a body in [`Mechanism::bodies`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId(pub usize);

/// Index of a joint in [`Mechanism::joints`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct JointId(pub usize);

/// Index of a slider in [`Mechanism::sliders`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SliderId(pub usize);

/// The bodies and joints of a scene, and its Assur groups in solving order.
#[derive(Clone, Debug, Default)]
pub struct Mechanism {
    /// The scene's unit of time.
    pub time: TimeUnit,
    /// Whether positions are found from lengths or given by a drawing.
    pub given_by: GivenBy,
    /// Names of the points: those of the frame, then those of the bodies in their order.
    pub points: Vec<String>,
    /// The given coordinates of each point in the fixed frame: of the frame's points, or of all points in a drawn
    /// configuration.
    pub given: Vec<Option<Point>>,
    /// The ground first, then the links in the order of their names, a carrier for each point of given motion, a block for
    /// each pin in a slot.
    pub bodies: Vec<Body>,
    /// The frame's first point in the scene: guides on it count from there unless they say from where, and moments on it.
    pub origin: Option<PointId>,
    /// The sliders, in the order of what slides.
    pub sliders: Vec<Slider>,
    /// The joints between bodies; a pin through n bodies counts as n − 1 joints, all at one that is known first.
    pub joints: Vec<Joint>,
    /// The profiles that touch, which move as links or sliders among these do.
    pub contacts: Vec<Contact>,
    /// The Assur groups in the order in which they can be solved.
    pub groups: Vec<Group>,
    /// How positions are found where a link's angle is given in place of a drive's position; `None` if every drive has
    /// its position.
    pub placing: Option<Box<Placing>>,
    /// The links whose three lengths fit a triangle and its mirror image, so flat that rough places hardly tell which:
    /// the side that they are on was taken.
    pub doubtful_sides: Vec<BodyId>,
    /// What loads its links, with the force that one unit of mass needs for one unit of acceleration; none of a scene without
    /// masses, forces and springs.
    pub loads: Option<Arc<(Loads, Ball)>>,
    /// Remarks for the author of the scene that do not stop the computation.
    pub warnings: Vec<Message>,
}

/// The mechanism with the given angle of a link in place of a drive. It has the same positions, but is solved from that
/// link.
#[derive(Clone, Debug)]
pub struct Placing {
    /// The link whose angle is given.
    pub link: BodyId,
    /// Angle of its axis from +x, in degrees.
    pub angle: f64,
    /// The mechanism in which the drive's link is a member of a group. Bodies, points and sliders keep their indices.
    /// Last comes a carriage without a name on two sliders, which leave the given link every place but only this angle.
    pub mechanism: Mechanism,
}

/// The fixed body; always the first.
pub const GROUND: BodyId = BodyId(0);

/// The ground, a link, a block, or the carrier of a point of given motion.
#[derive(Clone, Debug)]
pub struct Body {
    /// The link's name; `"ground"`; for a carrier or a block the name of its point; empty for the carriage of a
    /// [`Placing`].
    pub name: String,
    /// Its points; its axis runs from the first to the second, the others are in the order of their names.
    pub points: Vec<PointId>,
    /// Coordinates of `points` in the body's own frame: origin in the first point, x along the axis, unless the scene
    /// gives a shape. Empty in a drawn configuration.
    pub local: Vec<Point>,
    /// Where its motion comes from.
    pub role: Role,
    /// Whether it is the block of a pin in a slot, without a size, or the carriage of a [`Placing`].
    pub block: bool,
}

/// Where a body's motion comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Role {
    /// The fixed body.
    Ground,
    /// A driven link, which turns about a point of the ground. Angles in degrees, rates in rad per unit of time.
    Driver {
        /// The ground point about which it turns.
        pivot: PointId,
        /// Angle of its axis from +x in degrees; `None` in a drawn configuration and where another link's angle is
        /// given.
        angle: Option<f64>,
        /// Angular velocity.
        omega: f64,
        /// Angular acceleration.
        alpha: f64,
    },
    /// A body that a driven slider joins to another one: it turns as that body does, and slides against it as given.
    Pushed {
        /// The driven slider; the body is its sliding link or carries its guide.
        slider: SliderId,
        /// The other body.
        from: BodyId,
    },
    /// A link of given motion, by that of one of its places and its rotation.
    Moving {
        /// The place whose motion is given, in the fixed frame.
        at: Point,
        /// Velocity there.
        velocity: Vector,
        /// Acceleration there.
        acceleration: Vector,
        /// Angular velocity.
        omega: f64,
        /// Angular acceleration.
        alpha: f64,
    },
    /// The carrier of a point of given motion; its rotation is not defined.
    Carrier {
        /// Velocity of the point.
        velocity: Vector,
        /// Acceleration of the point.
        acceleration: Vector,
    },
    /// A link with points of given motion only, as one that drives the mechanism from outside: shown, but no motion is found for it.
    Unsolved,
    /// A link of an Assur group, whose motion is unknown.
    Member,
}

impl Mechanism {
    /// The mechanism by which positions are found: itself, unless a link's angle is given in place of a drive's
    /// position.
    #[must_use]
    pub fn for_positions(&self) -> &Mechanism {
        self.placing.as_ref().map_or(self, |p| &p.mechanism)
    }

    /// The indices of all bodies.
    pub(crate) fn body_ids(&self) -> impl Iterator<Item = BodyId> + use<> {
        (0..self.bodies.len()).map(BodyId)
    }

    /// The indices of all points.
    pub(crate) fn point_ids(&self) -> impl Iterator<Item = PointId> + use<> {
        (0..self.points.len()).map(PointId)
    }

    /// The indices of all joints.
    pub(crate) fn joint_ids(&self) -> impl Iterator<Item = JointId> + use<> {
        (0..self.joints.len()).map(JointId)
    }

    /// The indices of all sliders.
    pub(crate) fn slider_ids(&self) -> impl Iterator<Item = SliderId> + use<> {
        (0..self.sliders.len()).map(SliderId)
    }

    /// The body of that index.
    #[must_use]
    pub fn body(&self, id: BodyId) -> &Body {
        &self.bodies[id.0]
    }

    /// The first point of a body in the scene.
    pub(crate) fn first_point(&self, body: BodyId) -> Option<PointId> {
        self.origin.filter(|_| body == GROUND).or_else(|| self.body(body).points.first().copied())
    }

    /// A point in the frame of a body; its origin for a point that the body does not have, and in a drawn configuration.
    pub(crate) fn local(&self, body: BodyId, point: PointId) -> Point {
        self.body(body).local_of(point).unwrap_or_else(Point::origin)
    }

    /// The name of a point.
    #[must_use]
    pub fn point_name(&self, id: PointId) -> &str {
        &self.points[id.0]
    }

    /// Names of the drives: driven links by their names, then driven sliders: on the ground by the sliding link, on a
    /// moving link as `3/2`.
    #[must_use]
    pub fn drive_names(&self) -> Vec<String> {
        let turned = self.bodies.iter().filter(|b| matches!(b.role, Role::Driver { .. }));
        let pushed = self.slider_ids().filter(|&id| self.slider(id).drive.is_some());
        turned.map(|body| body.name.clone()).chain(pushed.map(|id| self.push_name(id))).collect()
    }

    /// The point of that name.
    #[must_use]
    pub fn point(&self, name: &str) -> Option<PointId> {
        self.points.iter().position(|p| p == name).map(PointId)
    }

    /// The link of that name (or `ground`).
    #[must_use]
    pub fn link(&self, name: &str) -> Option<BodyId> {
        self.bodies.iter().position(|b| b.name == name && !b.is_nameless()).map(BodyId)
    }

    /// The frame, or the link of that name.
    pub(crate) fn body_named(&self, on: &On) -> Option<BodyId> {
        match on {
            On::Ground => Some(GROUND),
            On::Link(link) => self.link(link),
        }
    }

    /// The links with names of their own: all bodies but ground, carriers and blocks.
    pub fn links(&self) -> impl Iterator<Item = (BodyId, &Body)> {
        self.body_ids().zip(&self.bodies).filter(|(_, b)| b.role != Role::Ground && !b.is_nameless())
    }

    /// By point: the bodies that have it, in their order.
    pub(crate) fn holders(&self) -> Vec<Vec<BodyId>> {
        let mut holders = vec![Vec::new(); self.points.len()];
        for id in self.body_ids() {
            for point in &self.body(id).points {
                // A drawn link may name a point twice.
                if holders[point.0].last() != Some(&id) {
                    holders[point.0].push(id);
                }
            }
        }
        holders
    }

    /// The points of group links that are on no body of known motion: those whose places have to be found.
    #[must_use]
    pub fn inner_points(&self) -> Vec<PointId> {
        let holders = self.holders();
        let holds = |p: &PointId, known: bool| holders[p.0].iter().any(|&b| self.is_known(b) == known);
        self.point_ids().filter(|p| holds(p, false) && !holds(p, true)).collect()
    }
}

impl Body {
    /// Whether it is a carrier, a block or a carriage: neither the ground nor a link of the scene.
    #[must_use]
    pub fn is_nameless(&self) -> bool {
        self.block || matches!(self.role, Role::Carrier { .. })
    }

    /// Whether it has a point.
    #[must_use]
    pub fn has(&self, point: PointId) -> bool {
        self.points.contains(&point)
    }

    /// The coordinates of one of its points in its own frame; `None` in a drawn configuration, and for a point of other
    /// bodies.
    #[must_use]
    pub fn local_of(&self, point: PointId) -> Option<Point> {
        let index = self.points.iter().position(|&p| p == point)?;
        self.local.get(index).copied()
    }
}

/// Why a scene is no mechanism, or one that cannot be solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StructureError {
    /// The scene contradicts itself, or has too few or too many constraints or drives.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A group whose prismatic joints leave it without a definite motion in every position.
    #[error("{}", self.problem())]
    Singular {
        /// Names of the group's links.
        links: String,
        /// Its class.
        class: &'static str,
        /// Its joints in the order of [`Group::pattern`], R revolute, P prismatic.
        pattern: String,
    },
}

impl StructureError {
    /// What is wrong, and what to try.
    #[must_use]
    pub fn problem(&self) -> Problem {
        match self {
            StructureError::Scene(error) => error.problem(),
            StructureError::Singular { links, class, pattern } => {
                Problem::new(says::singular(links, *class, pattern)).hint(says::make_revolute())
            }
        }
    }
}
