//! What a hand needs to find forces well.

use super::judge::Refusal;
use crate::check::BANDS;
use crate::construction::{
    Action, Construction, ForceOf, ForcePlan, ForceStep, Moment, OperationKind, OperationRole, Side, Solution, Teller,
    plain_text,
};
use crate::drawing::KeyRow;
use crate::geometry::{cross, unit};
use crate::quantity::{QuantityKind, What};
use crate::sheet::{PerSheet, Scales, Sheet};

/// Smallest sine of the angle at which directions cross: that of 15°.
const SINE: f64 = 0.258;
/// Smallest force on paper, in mm.
const FORCE: f64 = 8.0;
/// Smallest arm on paper, in mm.
const ARM: f64 = 10.0;
/// A moment below this part of the largest of its sum may have a short arm.
const COUNTS: f64 = 0.05;
/// Largest force of a plan over its smallest.
const RATIO: f64 = 40.0;
/// Largest band of a force, a moment or a power, in parts of it.
const BAND: f64 = 0.08;
/// A force below this part of the largest is judged as if it were that large.
const SMALL: f64 = 0.1;
/// What is nothing, in parts of the largest of its kind.
const ZERO: f64 = 1e-9;

/// Whether all groups have a construction, exact and with good crossings.
pub(super) fn are_constructed(construction: &Construction) -> Result<(), Refusal> {
    let Some(plan) = construction.forces.as_deref().filter(|_| construction.by_hand.contains(&Sheet::Forces)) else {
        return Ok(());
    };
    let steps = || {
        construction.steps[Sheet::Forces].iter().filter_map(|action| match action {
            Action::Force(step) => Some(step),
            _ => None,
        })
    };
    if steps().any(|step| matches!(step, ForceStep::ByNumbers(_))) {
        return Err(Refusal::NoConstruction);
    }
    if plan.agreement.is_some_and(|agreement| agreement.difference > agreement.allowed) {
        return Err(Refusal::Routes);
    }
    let of_sides = steps().filter_map(|step| match *step {
        ForceStep::Cross(polygon, side) => {
            let sides = &plan.polygons.get(polygon)?.sides;
            let [a, b] = [side, side + 1].map(|side| unit(sides.get(side)?.vector));
            // A force that is nothing has no direction to cross.
            Some(cross(a?, b?).abs())
        }
        _ => None,
    });
    let values = construction.run(PerSheet::from_fn(|_| 1.0), &[]);
    let of_points = construction.operations.iter().filter_map(|operation| match (operation.role, &operation.kind) {
        (OperationRole::MomentPoint, OperationKind::Cross { lines, .. }) => {
            let [a, b] = lines.map(|line| values.line(line).1);
            Some(cross(a, b).abs())
        }
        _ => None,
    });
    match of_sides.chain(of_points).fold(1.0, f64::min) < SINE {
        true => Err(Refusal::ForcesCross),
        false => Ok(()),
    }
}

/// Whether all forces and arms are long enough on paper.
pub(super) fn are_clear(construction: &Construction, scales: &Scales) -> Result<(), Refusal> {
    let Some(plan) = construction.forces.as_deref() else { return Ok(()) };
    let mut arms: Vec<(f64, Sheet)> = Vec::new();
    let mut forces: Vec<f64> = Vec::new();
    if construction.by_hand.contains(&Sheet::Forces) {
        forces.extend(plan.polygons.iter().flat_map(|polygon| &polygon.sides).map(|side| side.vector.norm()));
        arms.extend(plan.moments.iter().flat_map(|moment| telling(plan, moment)).map(|arm| (arm, Sheet::Scheme)));
    }
    if construction.by_hand.contains(&Sheet::Lever) {
        let own = construction.levers.iter().flat_map(|lever| &lever.forces);
        let largest = own.clone().map(|force| force.size * force.arm.abs()).fold(0.0, f64::max);
        let telling = own.filter(|force| force.size * force.arm.abs() > COUNTS * largest);
        arms.extend(telling.map(|force| (force.arm.abs(), Sheet::Lever)));
    }
    for &(length, sheet) in &arms {
        if length < ARM * scales[sheet].ok_or(Refusal::Sheet)? {
            return Err(Refusal::ArmShort);
        }
    }
    let most = forces.iter().copied().fold(0.0, f64::max);
    let there = || forces.iter().copied().filter(|force| *force > ZERO * most);
    match scales[Sheet::Forces] {
        Some(mu) if there().any(|force| force < FORCE * mu) => Err(Refusal::ForceShort),
        None if most > 0.0 => Err(Refusal::Sheet),
        _ => Ok(()),
    }
}

/// Whether no force of the polygons is much larger than another.
pub(super) fn are_alike(construction: &Construction) -> Result<(), Refusal> {
    match ratio(construction) {
        Some(ratio) if ratio > RATIO => Err(Refusal::ForcesUnequal),
        _ => Ok(()),
    }
}

/// The largest force of the polygons over the smallest that is there; `None` without any.
pub(super) fn ratio(construction: &Construction) -> Option<f64> {
    let plan = construction.forces.as_deref().filter(|_| construction.by_hand.contains(&Sheet::Forces))?;
    let sizes = || plan.polygons.iter().flat_map(|polygon| &polygon.sides).map(|side| side.vector.norm());
    let most = sizes().fold(0.0, f64::max);
    sizes().filter(|size| *size > ZERO * most).reduce(f64::min).map(|least| most / least)
}

/// The symbols of the smallest and the largest force of a scene's polygons, where these are too unequal; of small ones a load, if one is:
/// from loads all others follow.
pub(super) fn too_unequal(solution: &Solution) -> Option<[String; 2]> {
    let plan = solution.construction.forces.as_deref()?;
    let sides = || plan.polygons.iter().flat_map(|polygon| &polygon.sides);
    let size = |side: &&Side| side.vector.norm();
    let large = sides().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let is_small = |side: &&Side| size(side) > ZERO * size(&large) && size(side) * RATIO < size(&large);
    let is_load = |side: &Side| matches!(side.of, ForceOf::Load(_));
    let small =
        sides().filter(is_small).min_by(|a, b| is_load(b).cmp(&is_load(a)).then(size(a).total_cmp(&size(b))))?;
    let words = solution.wording();
    let teller = Teller::new(solution, &words);
    Some([small, large].map(|side| plain_text(&teller.force_symbol(side.of))))
}

/// The arms of a sum of moments that count in it: short ones of small forces do not matter.
fn telling(plan: &ForcePlan, moment: &Moment) -> Vec<f64> {
    let all = || moment.arms.iter().map(|arm| (arm.length, arm.length * force(plan, arm.of)));
    let largest = all().map(|(_, moment)| moment).fold(0.0, f64::max);
    all().filter(|(_, moment)| *moment > COUNTS * largest).map(|(length, _)| length).collect()
}

/// The size of a force of the plan.
fn force(plan: &ForcePlan, of: ForceOf) -> f64 {
    match of {
        ForceOf::Load(index) => plan.loads.get(index).map_or(0.0, |load| load.force.norm()),
        _ => {
            let mut sides = plan.polygons.iter().flat_map(|polygon| &polygon.sides);
            sides.find(|side| is_same(side.of, of)).map_or(f64::INFINITY, |side| side.vector.norm())
        }
    }
}

/// Whether two forces are one, on either link of its joint.
fn is_same(a: ForceOf, b: ForceOf) -> bool {
    match (a, b) {
        (ForceOf::Joint { joint, part, .. }, ForceOf::Joint { joint: other, part: of_other, .. }) => {
            joint == other && part == of_other
        }
        _ => a == b,
    }
}

/// Whether a hand finds all forces, moments and powers well.
pub(super) fn are_sure(rows: &[KeyRow<'_>]) -> Result<(), Refusal> {
    let is_meant = |kind| matches!(kind, QuantityKind::Force | QuantityKind::Moment | QuantityKind::Power);
    let forces = || rows.iter().filter(|row| matches!(row.asked.what, What::Force(..)) && is_meant(row.asked.kind()));
    for KeyRow { asked, value, allowed } in forces() {
        let alike = forces().filter(|other| other.asked.kind() == asked.kind());
        let largest = alike.map(|other| other.value.abs()).fold(0.0, f64::max);
        let size = value.abs().max(SMALL * largest);
        // What only rounding leaves nobody is asked for.
        if value.abs() <= ZERO * largest {
            continue;
        }
        if allowed.is_none_or(|allowed| allowed > BANDS * BAND * size) {
            return Err(Refusal::ForceUnsure);
        }
    }
    Ok(())
}

/// The solution's figure has a force plan or a lever.
pub(super) fn has_forces(solution: &Solution) -> bool {
    let drawn = &solution.construction.by_hand;
    drawn.contains(&Sheet::Forces) || drawn.contains(&Sheet::Lever)
}
