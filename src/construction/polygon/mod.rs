//! The force plan, with ruler and pencil: what joints carry by moments with arms measured on the scheme and by force polygons, group by
//! group from the last one to the first, then the driven links. It is a second route beside the equilibrium equations of
//! `forces/`, with which it is compared; loads are the same in both.
//!
//! In reading order: `statics` (forces with their lines of action, arms, moments), `sides` (polygons, side by side), `leg` (the part of an
//! outer joint's force that one link alone tells), `second`, `third` and `fourth` (groups of these classes), `wheels` (the force between teeth), `guides` (couples in guides), `drive`
//! (driven links and sliders), `named` (the numbers and names of what is found), `corners` (the names of corners), `arms` (those of arms), `rubbed` (friction by what is found), `compared`, `told` (captions, symbols).
//!
//! # One rule for pins and guides
//!
//! What a pin carries has no moment about the pin; what a guide carries has no component along the guide: a guide is a pin at infinity, in the
//! direction normal to it. So the force in the outer joint of a link has one part along the line of its two joints, and another one that the moments of
//! this link about its inner joint tell alone; about a point at infinity these are a force sum, and a polygon with two known
//! directions. Forces along the lines are left: of a dyad two, which its polygon tells; of a group of class III three,
//! of which the moments of the whole group about the crossing of two tell the third; of class IV three on a drag link, along the line of
//! both outer joints and the lines of both closure links, by Ritter's moment. These lines are the cut lines of the velocity plan
//! (O. Shai, G. R. Pennock, J. Mech. Des. 128, 2006).

mod arms;
mod compared;
mod corners;
mod drive;
mod fourth;
mod guides;
mod leg;
mod named;
mod rubbed;
mod second;
mod sides;
mod statics;
mod third;
mod told;
mod wheels;

use super::constructed::Agreement;
use super::number::NumberId;
use super::operation::PlaceId;
use super::step::Action;
use super::writer::Writer;
use crate::forces::{Forces, RubbedJoint, Source, driven, rubbing};
use crate::geometry::{Point, Vector};
use crate::mechanism::{BodyId, Class, Group, JointId, Mechanism, PointId, SliderId};
use crate::scene::Head;
pub use corners::Corner;
use indexmap::IndexMap;
use named::WholeForce;
pub(crate) use named::{FoundForce, FoundNumbers};
pub(crate) use rubbed::{ComingRound, Rubbed, pressing_off};
use statics::Statics;

/// The force polygons of a mechanism, and the moments from which their sides follow.
#[derive(Clone, Debug, Default)]
pub struct ForcePlan {
    /// What loads the links.
    pub loads: Vec<LoadShown>,
    /// The polygons, in the order in which they are drawn.
    pub polygons: Vec<Polygon>,
    /// The sums of moments, in the order in which they are taken.
    pub moments: Vec<Moment>,
    /// By joint that is found: the body on which its force acts, and where that begins and ends in a polygon; no place for a joint that
    /// carries no force.
    pub(super) joints: Vec<(JointId, BodyId, Option<[PlaceId; 2]>)>,
    /// What is found, as numbers of the construction.
    pub(crate) numbers: FoundNumbers,
    /// The joints that rub.
    pub(super) rubbing: Vec<RubbedJoint>,
    /// The corners of the polygons, by their names.
    pub(crate) corners: IndexMap<String, Corner>,
    /// How the forces from these polygons agree with those from the equations of equilibrium, in parts of the largest force.
    pub agreement: Option<Agreement>,
}

/// A load as the scheme shows it.
#[derive(Clone, Copy, Debug)]
pub struct LoadShown {
    /// Where it comes from.
    pub source: Source,
    /// The body on which it acts.
    pub body: BodyId,
    /// The place where its force acts.
    pub at: Point,
    /// The force, in the scene's unit.
    pub force: Vector,
    /// A couple beside it, counter-clockwise positive.
    pub couple: f64,
}

impl LoadShown {
    /// The name of its force as a quantity, `load(F)`.
    #[must_use]
    pub fn name(&self, mechanism: &Mechanism) -> String {
        Head::Load.of(&self.source.name(mechanism, self.body))
    }
}

/// What a force is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceOf {
    /// A load, by its index among [`ForcePlan::loads`].
    Load(usize),
    /// What a joint does to a body, or a part of it.
    Joint {
        /// The joint.
        joint: JointId,
        /// The body that receives it.
        on: BodyId,
        /// Which part of it.
        part: ForcePart,
    },
    /// What two joints do to links across the guide of the second one: their moments tell each alone.
    Both {
        /// The joints.
        joints: [JointId; 2],
        /// The body that receives the force of the first.
        on: BodyId,
    },
}

impl ForceOf {
    /// The body that receives the force, if it is no load.
    pub(super) fn on(self) -> Option<BodyId> {
        match self {
            ForceOf::Joint { on, .. } | ForceOf::Both { on, .. } => Some(on),
            ForceOf::Load(_) => None,
        }
    }
}

/// A part of the force in a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForcePart {
    /// All of it.
    Whole,
    /// Along the line of two joints.
    Normal,
    /// Across that line.
    Tangential,
    /// Along the guide of the link's other joint.
    AlongGuide,
    /// Across that guide.
    AcrossGuide,
}

/// A closed chain of forces on links that are cut free together.
#[derive(Clone, Debug)]
pub struct Polygon {
    /// The links.
    pub links: Vec<BodyId>,
    /// Its sides, in the order in which they are drawn.
    pub sides: Vec<Side>,
}

/// A force in a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// The force.
    pub of: ForceOf,
    /// The body on which it acts.
    pub on: BodyId,
    /// Where it begins and ends.
    pub ends: [PlaceId; 2],
    /// Its places on the sheet, in the scene's unit of force; those are in `vector` where polygons are moved apart.
    pub from: Vector,
    /// The force.
    pub vector: Vector,
    /// How it comes into the polygon.
    pub kind: SideKind,
}

/// How a force comes into its polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SideKind {
    /// It is known before.
    Known,
    /// It closes the polygon: its direction is known, or nothing of it.
    Found,
    /// It joins two corners: the sum of two parts, or what an inner joint carries.
    Diagonal,
}

/// A sum of moments about a point, which tells one unknown.
#[derive(Clone, Debug)]
pub struct Moment {
    /// The links that are cut free together.
    pub links: Vec<BodyId>,
    /// The point about which moments are taken.
    pub about: MomentPoint,
    /// Its place on the scheme.
    pub at: Point,
    /// The arms that are measured.
    pub arms: Vec<ForceArm>,
    /// What it tells …
    pub finds: Found,
    /// … and how much that is.
    pub value: f64,
}

/// A point about which moments are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MomentPoint {
    /// A joint.
    Joint(PointId),
    /// Where the lines of two unknown forces cross.
    Crossing([ForceOf; 2]),
}

/// The arm of a force, measured on the scheme.
#[derive(Clone, Copy, Debug)]
pub struct ForceArm {
    /// The force.
    pub of: ForceOf,
    /// A place of its line of action, and the foot of the normal from the point.
    pub line: [Point; 2],
    /// Its length.
    pub length: f64,
    /// What is measured: the length with a sign, positive where the force turns counter-clockwise.
    pub(crate) number: NumberId,
}

/// What a sum of moments tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// A force along a line.
    Force(ForceOf),
    /// The couple in a guide, about the slider's point.
    Couple(SliderId),
    /// The couple that a guide gives a link about the link's other joint, while its force acts there.
    CoupleAbout(SliderId, PointId),
    /// The torque of a driven link.
    Torque(BodyId),
}

/// What is done in a step of the force plan; polygons, sides and moments by their indices.
#[derive(Clone, Debug, PartialEq)]
pub enum ForceStep {
    /// Take moments.
    Moments(usize),
    /// Lay off a side.
    LayOff(usize, usize),
    /// Draw the direction of a side.
    Direction(usize, usize),
    /// Mark where two directions cross: it ends these two sides.
    Cross(usize, usize),
    /// Close the polygon by a side.
    Close(usize, usize),
    /// Join two corners.
    Join(usize, usize),
    /// Resolve the force in a driven slider along its guide and across.
    Push(SliderId, f64),
    /// There is no construction for these links: what their joints carry comes from the equations.
    ByNumbers(Vec<BodyId>),
}

impl From<ForceStep> for Action {
    fn from(step: ForceStep) -> Action {
        Action::Force(step)
    }
}

/// Draws the force plan, or takes its loads alone; `computed` has these, and what the polygons are compared with.
pub(super) fn force_plan(writer: &mut Writer<'_>, computed: &Forces, has_polygons: bool) {
    let mechanism = writer.mechanism;
    let first = writer.construction.operations.len();
    let mut statics = Statics::new(writer, computed);
    if has_polygons {
        for group in mechanism.groups.iter().rev() {
            statics.group(group);
        }
        for body in driven(mechanism) {
            statics.driven(body);
        }
        statics.move_apart(first);
        statics.compare();
        statics.name_all();
        statics.name_corners();
        if statics.plan.loads.iter().any(|load| matches!(load.source, Source::Friction(_))) {
            statics.plan.rubbing = rubbing(mechanism);
        }
    }
    let plan = statics.plan;
    writer.construction.forces = Some(Box::new(plan));
}

impl Statics<'_, '_> {
    /// Finds what the joints of a group carry, and hands it on to the bodies on which it hangs.
    fn group(&mut self, group: &Group) {
        let bodies = &group.bodies;
        if self.set(bodies).is_empty() {
            return;
        }
        let found = match group.class {
            _ if self.has_teeth(group) => self.wheel(group),
            Class::Second => self.second(group),
            Class::Third => self.third(group),
            Class::Fourth => self.fourth(group),
            Class::Higher => None,
        };
        let links: Vec<Vec<BodyId>> = group.links.iter().map(|&lead| self.mechanism().compound(lead)).collect();
        let found = found.and_then(|()| {
            self.guide_couples(&links, &group.joints)?;
            self.inner_drives(group)
        });
        if found.is_none() {
            self.by_numbers(group);
        }
        self.hand_on(group);
    }
}
