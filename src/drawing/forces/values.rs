//! What joints carry and drives need, as results beside the force plan.

use crate::construction::{ForceOf, ForcePart, NOTHING};
use crate::drawing::context::SheetContext;
use crate::geometry::{Pair, span};
use crate::mechanism::{BodyId, JointId};
use crate::sheet::QuantityKind;

/// A result: its symbol in markup, its number and kind.
pub(in crate::drawing) type Result = (String, f64, QuantityKind);

/// The results of a figure with a force plan: what pins carry; what guides carry, and how far from the slider's point; what drives need.
pub(in crate::drawing) fn results(context: &SheetContext<'_>) -> Vec<Result> {
    let forces = context.construction().forces.as_ref().and_then(|_| context.solution.forces());
    let Some(forces) = forces else { return Vec::new() };
    let (mechanism, teller) = (context.mechanism(), context.teller());
    let largest = forces.joints.iter().map(|carried| carried.force.rounded().norm()).fold(0.0, f64::max);
    let size = span(context.solution.pose.points.iter().copied());
    let shown = |value: f64, largest: f64| if value.abs() <= NOTHING * largest { 0.0 } else { value };
    let mut all = Vec::new();
    for (index, (joint, carried)) in mechanism.joints.iter().zip(&forces.joints).enumerate() {
        let is_nameless = |body: BodyId| mechanism.body(body).is_nameless();
        if !(joint.holds_places() || joint.rolls()) || joint.bodies.into_iter().any(is_nameless) {
            continue;
        }
        let of = ForceOf::Joint { joint: JointId(index), on: joint.bodies[1], part: ForcePart::Whole };
        let force = shown(carried.force.rounded().norm(), largest);
        let Some(slider) = joint.slider else {
            all.push((teller.force_symbol(of), force, QuantityKind::Force));
            continue;
        };
        let guide = Pair::within(context.solution.pose.guide(slider), 0.0);
        let normal = shown(forces.normal(mechanism, slider, guide).high, largest);
        let couple = shown(forces.couple(mechanism, slider).high, largest * size);
        all.push((teller.guide_symbol(slider), normal, QuantityKind::Force));
        // Of a force that is nearly nothing the arm tells nobody anything.
        let arm = couple / normal;
        if arm.abs() <= size {
            all.push((teller.guide_arm(slider), shown(arm, size), QuantityKind::Length));
        } else if couple != 0.0 {
            all.push((teller.guide_couple(slider), couple, QuantityKind::Moment));
        }
        if mechanism.slider(slider).drive.is_some() {
            let push = shown(forces.push(mechanism, slider, guide).high, largest);
            all.push((teller.push_symbol(slider), push, QuantityKind::Force));
        }
    }
    for drive in &forces.drives {
        if let Some(body) = drive.body {
            let torque = shown(forces.torque(body).high, largest * size);
            all.push((teller.torque_symbol(body), torque, QuantityKind::Moment));
        }
    }
    all
}
