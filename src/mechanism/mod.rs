//! In: a checked [`Scene`](crate::scene::Scene). Out: a [`Mechanism`]: bodies, joints and Assur groups in solving order.
//! Names have become indices, shared points have become revolute joints, lengths have become local coordinates.
//! No position is computed here: a mechanism is the same at every crank angle.

mod build;
mod compound;
mod drives;
mod error;
mod group;
mod grouping;
mod joint;
mod loops;
mod placing;
mod shape;
mod structure;

pub use build::mechanism;
#[cfg(test)]
pub(crate) use build::mechanism_with;
pub use compound::DrivenSlide;
pub use error::StructureError;
pub use group::{Carried, Class, Group, Leg, Loop, SpecialPoint};
pub use joint::{Guide, Joint, Mark, Slider, Tie};
pub use loops::{Arm, LoopEquations, LoopTerms, Reduction, Slide, SlideRate, Spin, TieTerms};

use crate::geometry::{Point, Vector};
use crate::scene::GivenBy;

/// Index of a named point in [`Mechanism::points`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct PointId(pub usize);

/// Index of a body in [`Mechanism::bodies`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct BodyId(pub usize);

/// Index of a joint in [`Mechanism::joints`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct JointId(pub usize);

/// Index of a slider in [`Mechanism::sliders`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SliderId(pub usize);

/// A scene taken apart: what hangs on what, and in which order it can be solved.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Whether positions come from lengths or stand in the scene.
    pub given_by: GivenBy,
    /// Names of the points, in order of appearance.
    pub points: Vec<String>,
    /// The places that the scene gives, by point: the frame's, or all of them in a drawn configuration.
    pub given: Vec<Option<Point>>,
    /// The ground first, then the links in scene order, a carrier for each point of known motion, a block for each pin in a slot.
    pub bodies: Vec<Body>,
    /// The sliders, in scene order.
    pub sliders: Vec<Slider>,
    /// The joints between bodies; a pin through n bodies is n − 1 of them.
    pub joints: Vec<Joint>,
    /// The Assur groups in the order in which they can be solved.
    pub groups: Vec<Group>,
    /// How positions are found where a link's angle is given in place of that of a drive; none where every drive says where it stands.
    pub placing: Option<Box<Placing>>,
    /// What the reader of the scene should hear of, though it does not stop the work.
    pub warnings: Vec<String>,
}

/// A mechanism held by the angle of a link in place of a drive: the same positions, reached from another side.
#[derive(Clone, Debug)]
pub struct Placing {
    /// The link whose angle is given.
    pub link: BodyId,
    /// Degrees from +x to its axis.
    pub angle: f64,
    /// The mechanism with that drive's link a member of a group. Bodies, points and sliders keep their indices; a carriage without
    /// a name comes last, with two sliders, which leave the link every place but only this angle.
    pub mechanism: Mechanism,
}

/// The body that does not move; always the first.
pub const GROUND: BodyId = BodyId(0);

/// The ground, a link, or the unnamed carrier of a point whose motion is known.
#[derive(Clone, Debug)]
pub struct Body {
    /// The link's name; `"ground"`; for a carrier or a block the name of its point; empty for the carriage of a [`Placing`].
    pub name: String,
    /// Its points in scene order; the axis runs from the first to the second.
    pub points: Vec<PointId>,
    /// Coordinates of `points` in the link's own frame (origin and x axis: its axis); empty in a drawn configuration.
    pub local: Vec<Point>,
    /// What makes it move.
    pub role: Role,
    /// Whether it is the block, without a name or size, of a pin that rides in a slot, or a carriage.
    pub block: bool,
}

/// Where a body's motion comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Role {
    /// It does not move.
    Ground,
    /// It turns about a point of the ground as the scene says. Angles in degrees, rates in rad per unit of time.
    Driver {
        /// The ground point it turns about.
        pivot: PointId,
        /// Angle of its axis from +x in degrees; none in a drawn configuration and where another link's angle is given in its place.
        angle: Option<f64>,
        /// Angular velocity.
        omega: f64,
        /// Angular acceleration.
        alpha: f64,
    },
    /// A driven slider joins it to another body: it turns as that one does and slides against it as the scene says.
    Pushed {
        /// The driven slider, of which it is the sliding link or the guide's body.
        slider: SliderId,
        /// The other body.
        from: BodyId,
    },
    /// Its whole motion is given: that of one of its places, and its rotation.
    Moving {
        /// The place whose motion is given.
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
    /// It carries one point whose motion is given; how it turns is neither known nor asked.
    Carrier {
        /// Velocity of the point.
        velocity: Vector,
        /// Acceleration of the point.
        acceleration: Vector,
    },
    /// A link of the neighbouring mechanism, shown but not solved: it ends at a point of known motion.
    Stub,
    /// A link of an Assur group: its motion is what is looked for.
    Member,
}

impl Mechanism {
    /// The mechanism by which positions are found: itself, unless a link's angle is given in place of that of a drive.
    #[must_use]
    pub fn for_positions(&self) -> &Mechanism {
        self.placing.as_ref().map_or(self, |p| &p.mechanism)
    }

    /// The body of that index.
    #[must_use]
    pub fn body(&self, id: BodyId) -> &Body {
        &self.bodies[id.0]
    }

    /// The name of a point.
    #[must_use]
    pub fn point_name(&self, id: PointId) -> &str {
        &self.points[id.0]
    }

    /// Names of the drives: turned links first, then pushed ones: by link on the ground, by slider on a moving link, as in `3/2`.
    #[must_use]
    pub fn drive_names(&self) -> Vec<String> {
        let turned = self.bodies.iter();
        let turned = turned.filter(|b| matches!(b.role, Role::Driver { .. }));
        let pushed = (0..self.sliders.len()).map(SliderId);
        let pushed = pushed.filter(|&id| self.slider(id).drive.is_some());
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
        let mut bodies = self.bodies.iter();
        let index = bodies.position(|b| b.name == name && !b.is_nameless())?;
        Some(BodyId(index))
    }

    /// The links with names of their own: all bodies but ground, carriers and blocks.
    pub fn links(&self) -> impl Iterator<Item = (BodyId, &Body)> {
        self.bodies
            .iter()
            .enumerate()
            .map(|(i, b)| (BodyId(i), b))
            .filter(|(_, b)| b.role != Role::Ground && !b.is_nameless())
    }

    /// The points of group links that no known body holds: those whose places have to be found.
    #[must_use]
    pub fn inner_points(&self) -> Vec<PointId> {
        let holds = |p: &PointId, known: bool| {
            let mut bodies = (0..self.bodies.len()).map(BodyId);
            bodies.any(|b| self.is_known(b) == known && self.body(b).points.contains(p))
        };
        let points = (0..self.points.len()).map(PointId);
        points.filter(|p| holds(p, false) && !holds(p, true)).collect()
    }
}

impl Body {
    /// Whether it is no link of the scene and not the ground.
    #[must_use]
    pub fn is_nameless(&self) -> bool {
        self.block || matches!(self.role, Role::Carrier { .. })
    }

    /// The local coordinates of one of its points; `None` in a drawn configuration or for a foreign point.
    #[must_use]
    pub fn local_of(&self, point: PointId) -> Option<Point> {
        let index = self.points.iter().position(|&p| p == point)?;
        self.local.get(index).copied()
    }
}
