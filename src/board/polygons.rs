//! What the scene gives to force polygons: of each where it begins and which forces close it, and the places at which loads act.
//!
//! The corners of a polygon have no names of their own on the board: whichever force a hand lays off first, the polygon closes. So a
//! corner is known by the forces that lie between it and the start.

use crate::construction::{
    Construction, ForceOf, ForcePart, ForcePlan, LoadShown, Operation, OperationRole, Polygon, Side, SideKind, Solution,
};
use crate::forces::Source;
use crate::geometry::{Point, Vector, quarter_turn, unit};
use crate::mechanism::{BodyId, JointId, Mechanism};
use crate::quantity::{ForceOf as Asked, LinePart, QuantityRequest, What};
use crate::sheet::{PerSheet, Sheet};

/// Forces of a polygon, as bits by their indices.
pub(super) type Forces = u32;

/// Most forces of a polygon that is judged: of so many all sums are looked at.
pub(super) const MOST_FORCES: usize = 16;

/// A polygon.
#[derive(Clone, Debug)]
pub(super) struct GivenPolygon {
    /// The name of its start.
    pub start: String,
    /// The forces that add up to nothing.
    pub forces: Vec<GivenForce>,
}

/// A force of a polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct GivenForce {
    pub of: ForceOf,
    pub vector: Vector,
    /// Whether its direction alone is known before.
    pub is_found: bool,
    /// Whether somebody may draw its direction to close the polygon: of the forces that are found here those that another choice of moments
    /// leaves, too.
    pub may_be_found: bool,
    /// The direction in which a guide carries it, also where it is nothing.
    pub along: Option<Vector>,
}

impl GivenPolygon {
    /// All its forces.
    pub fn all(&self) -> Forces {
        (1 << self.forces.len()) - 1
    }

    /// The forces that close it.
    pub fn closing(&self) -> Forces {
        let found = self.forces.iter().enumerate().filter(|(_, force)| force.is_found);
        found.fold(0, |all, (index, _)| all | 1 << index)
    }

    /// The forces among some.
    pub fn among(&self, forces: Forces) -> impl Iterator<Item = (usize, &GivenForce)> {
        self.forces.iter().enumerate().filter(move |(index, _)| forces >> index & 1 == 1)
    }

    /// The sum of some of them.
    pub fn sum(&self, forces: Forces) -> Vector {
        self.among(forces).map(|(_, force)| force.vector).sum()
    }

    /// The largest of them.
    pub fn size(&self) -> f64 {
        self.forces.iter().map(|force| force.vector.norm()).fold(0.0, f64::max)
    }

    /// Whether another one is made of the same forces.
    pub fn is_like(&self, other: &GivenPolygon) -> bool {
        self.forces.len() == other.forces.len() && self.forces.iter().zip(&other.forces).all(|(a, b)| a.of == b.of)
    }

    /// The forces that a quantity is: a load, what a joint does to a link, or a part of that.
    pub fn named(&self, asked: &QuantityRequest, mechanism: &Mechanism, loads: &[LoadShown]) -> Forces {
        let What::Force(named, _) = &asked.what else { return 0 };
        let is_it = |force: &GivenForce| match (force.of, named) {
            (ForceOf::Load(index), Asked::Load(load)) => {
                loads.get(index).is_some_and(|own| own.source == load.source && own.body == load.body)
            }
            (ForceOf::Load(index), Asked::InertiaForce(body)) => {
                loads.get(index).is_some_and(|own| own.source == Source::Inertia && own.body == *body)
            }
            (ForceOf::Joint { joint, .. }, Asked::Reaction(pin, body)) => {
                let joint = mechanism.joint(joint);
                joint.pin == Some(*pin) && joint.bodies.contains(body)
            }
            (ForceOf::Joint { joint, part, .. }, Asked::ReactionPart(line, pin, body, _)) => {
                let joint = mechanism.joint(joint);
                let is_part = match line {
                    LinePart::Along => matches!(part, ForcePart::Normal | ForcePart::AcrossGuide),
                    LinePart::Across => matches!(part, ForcePart::Tangential | ForcePart::AlongGuide),
                };
                joint.pin == Some(*pin) && joint.bodies.contains(body) && is_part
            }
            (ForceOf::Joint { joint, part, .. }, Asked::Push(slider)) => {
                mechanism.joint(joint).slider == Some(*slider) && part == ForcePart::AlongGuide
            }
            (ForceOf::Joint { joint, part, .. }, Asked::Normal(slider)) => {
                mechanism.joint(joint).slider == Some(*slider) && part != ForcePart::AlongGuide
            }
            _ => false,
        };
        let own = self.forces.iter().enumerate().filter(|(_, force)| is_it(force));
        own.fold(0, |all, (index, _)| all | 1 << index)
    }
}

/// The polygons of a solution in whose figure a hand draws force polygons.
pub(super) fn polygons(solution: &Solution) -> Vec<GivenPolygon> {
    let construction = &solution.construction;
    let drawn = construction.forces.as_deref().filter(|_| construction.by_hand.contains(&Sheet::Forces));
    let of_sides = |index: usize, polygon: &Polygon| {
        let sides = polygon.sides.iter().filter(|side| side.kind != SideKind::Diagonal);
        sides.flat_map(|side| drawn.map_or_else(Vec::new, |plan| of_side(solution, plan, (index, side)))).collect()
    };
    let polygons = drawn.into_iter().flat_map(|plan| plan.polygons.iter().enumerate());
    polygons
        .map(|(index, own)| GivenPolygon { start: format!("o{}", index + 1), forces: of_sides(index, own) })
        .collect()
}

/// The forces of a side: what a driven slider carries has two parts, that of its drive along the guide and that across.
fn of_side(solution: &Solution, plan: &ForcePlan, (polygon, side): (usize, &Side)) -> Vec<GivenForce> {
    let Solution { mechanism, pose, .. } = solution;
    let is_found = side.kind == SideKind::Found;
    // What an earlier polygon has is handed on from there.
    let is_new = |own: JointId| {
        let mut earlier = plan.polygons[..polygon].iter().flat_map(|polygon| &polygon.sides);
        !earlier.any(|side| matches!(side.of, ForceOf::Joint { joint, part, .. } if joint == own && part != ForcePart::Tangential))
    };
    let one = |of, vector, along| {
        let may_be_found = is_found
            || matches!(of, ForceOf::Joint { joint, part, .. }
                if !matches!(part, ForcePart::Tangential | ForcePart::AlongGuide) && is_new(joint));
        GivenForce { of, vector, is_found, may_be_found, along }
    };
    let ForceOf::Joint { joint, on, part } = side.of else { return vec![one(side.of, side.vector, None)] };
    let Some(slider) = mechanism.joint(joint).slider else {
        let parts = parts_of(plan, side, joint, on);
        let parts = parts.into_iter().map(|(part, vector)| one(ForceOf::Joint { joint, on, part }, vector, None));
        let parts: Vec<GivenForce> = parts.collect();
        return if parts.is_empty() { vec![one(side.of, side.vector, None)] } else { parts };
    };
    let guide = pose.guide(slider);
    if mechanism.slider(slider).drive.is_some() && part == ForcePart::Whole {
        let parts = [(ForcePart::AcrossGuide, quarter_turn(guide)), (ForcePart::AlongGuide, guide)];
        let of = |(part, along): (ForcePart, Vector)| {
            one(ForceOf::Joint { joint, on, part }, along * along.dot(&side.vector), Some(along))
        };
        return parts.map(of).to_vec();
    }
    let along = if part == ForcePart::AlongGuide { guide } else { quarter_turn(guide) };
    vec![one(side.of, side.vector, Some(along))]
}

/// The parts in which the whole force of a pin has been found in another polygon, as they act on this side's body: a hand may lay them off
/// one by one. None of what was found as a whole.
fn parts_of(plan: &ForcePlan, whole: &Side, joint: JointId, on: BodyId) -> Vec<(ForcePart, Vector)> {
    if !matches!(whole.of, ForceOf::Joint { part: ForcePart::Whole, .. }) || whole.kind != SideKind::Known {
        return Vec::new();
    }
    let mut found: Vec<(ForcePart, Vector)> = Vec::new();
    for side in plan.polygons.iter().flat_map(|polygon| &polygon.sides) {
        let ForceOf::Joint { joint: own, on: receives, part } = side.of else { continue };
        if own == joint && part != ForcePart::Whole && found.iter().all(|(known, _)| *known != part) {
            found.push((part, if receives == on { side.vector } else { -side.vector }));
        }
    }
    let sum: Vector = found.iter().map(|(_, vector)| vector).sum();
    let are_all = found.len() == 2 && (sum - whole.vector).norm() <= 1e-9 * whole.vector.norm();
    if are_all { found } else { Vec::new() }
}

/// The pitch points of the meshes whose teeth carry forces, by their names, from the scheme's first point.
pub(super) fn pitch_points(solution: &Solution) -> Vec<(String, Vector)> {
    let construction = &solution.construction;
    let values = construction.run(PerSheet::from_fn(|_| 1.0), &[]);
    let of = |operation: &Operation| match (operation.role, operation.kind.place()) {
        (OperationRole::Pitch(mesh), Some(place)) if operation.sheet == Sheet::Scheme => {
            Some((pitch_name(&solution.mechanism, mesh), values.place(place)))
        }
        _ => None,
    };
    construction.operations.iter().filter_map(of).collect()
}

/// The name of a pitch point, as `W12` of the wheels 1 and 2.
pub(super) fn pitch_name(mechanism: &Mechanism, mesh: JointId) -> String {
    let [a, b] = mechanism.joint(mesh).bodies.map(|body| mechanism.body(body).name.as_str());
    let mut name = format!("W{a}{b}");
    while mechanism.point(&name).is_some() {
        name.push('\'');
    }
    name
}

/// By load: the name of the place at which its force acts, and whether that place is none of the mechanism's points: the centre of a link's mass is `G2`, the
/// place of a force of its own has the force's name.
pub(super) fn load_places(
    construction: &Construction,
    mechanism: &Mechanism,
    places: &[Point],
) -> Vec<(String, Point, bool)> {
    let Some(plan) = construction.forces.as_deref() else { return Vec::new() };
    let size = crate::geometry::span(places.iter().copied());
    let named = plan.loads.iter().map(|load| {
        let near = |at: &Point| (at - load.at).norm() <= 1e-9 * size;
        if let Some(point) = places.iter().position(near) {
            return (mechanism.points[point].clone(), load.at, false);
        }
        let mut name = match load.source {
            Source::Weight | Source::Inertia => format!("G{}", mechanism.body(load.body).name),
            source => source.name(mechanism, load.body),
        };
        while mechanism.point(&name).is_some() {
            name.push('\'');
        }
        (name, load.at, true)
    });
    named.collect()
}

/// The direction of a load's force, by the name of the quantity.
pub(super) fn direction_of_load(construction: &Construction, asked: &QuantityRequest) -> Option<Vector> {
    let (What::Force(named, _), Some(plan)) = (&asked.what, construction.forces.as_deref()) else { return None };
    let is_it = |load: &&LoadShown| match named {
        Asked::Load(own) => own.source == load.source && own.body == load.body,
        Asked::InertiaForce(body) => load.source == Source::Inertia && load.body == *body,
        _ => false,
    };
    plan.loads.iter().find(is_it).and_then(|load| unit(load.force))
}
