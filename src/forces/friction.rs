//! Coulomb friction in joints.
//!
//! A guide resists its slider with μ|N| along the guide; a pin resists its links with the couple ρ|R| that the force has about it when it
//! touches the circle of friction, ρ = r sin φ. Both hang on what is to be found, and the relations are not linear. But they are homogeneous: with
//! the direction of R and the sign of N as they were found last, the friction is a fixed part of each component, and the equations of
//! equilibrium are linear with forces that lean (N by the angle of friction, R off its pin). To solve these again and again is Newton's
//! iteration, and it ends where a solution no longer changes what leans. Where it does not end, friction locks the
//! mechanism: no forces keep it moving so.
//!
//! Friction counts against the motion of the position. A joint that stands still, or nearly, keeps what it carries anywhere within the cone of
//! friction; it is counted without friction, and the bounds of errors allow the whole of it.

use super::acting::{Acting, LoadList, Rub, Source, Wrench};
use super::{Counted, Posed};
use crate::geometry::{Ball, Pair, Solvable};
use crate::mechanism::{GROUND, JointId, Mechanism};

/// Rates below the largest over the square of this are none: what is left of zero by rounding.
const AT_REST: i32 = 100_000;

/// What resists the motion of the second of the bodies between which a joint rubs against the first.
#[derive(Clone, Copy, Debug)]
pub(super) enum Resisting<N> {
    /// A couple, by the size of the force with which the pin acts on the second body.
    Couple(N),
    /// A force along the guide, by the size of the force across it.
    Along(Pair<N>),
}

/// By joint: what resists its motion.
pub(super) fn resisting<N: Counted>(
    mechanism: &Mechanism,
    posed: &impl Posed<N>,
    list: &LoadList,
) -> Vec<Option<Resisting<N>>> {
    if list.friction.is_empty() {
        return Vec::new();
    }
    let size = |vector: Pair<N>| vector.dot(vector).sqrt();
    let rates = |id: JointId| {
        let at = posed.place(mechanism.joint_point(id));
        mechanism.rubbing_bodies(id).map(|body| posed.rates(body, at))
    };
    let all = || mechanism.joint_ids().filter(|&id| mechanism.joint(id).holds_places()).flat_map(rates);
    let least =
        |rates: &mut dyn Iterator<Item = N>| rates.fold(N::default(), N::larger) / N::from(AT_REST) / N::from(AT_REST);
    let least_speed = least(&mut all().map(|(velocity, _)| size(velocity)));
    let least_omega = least(&mut all().map(|(_, omega)| omega.larger(-omega)));
    let mut found = vec![None; mechanism.joints.len()];
    for &(joint, rub) in &list.friction {
        let [first, second] = rates(joint);
        found[joint.0] = Some(match rub {
            Rub::Pin { radius, grip } => {
                let [_, sine] = grip.tangent_and_sine(posed);
                Resisting::Couple(-(posed.given(radius) * sine * (second.1 - first.1).sense(least_omega)))
            }
            Rub::Guide(slider, grip) => {
                let guide = posed.guide(slider);
                let [tangent, _] = grip.tangent_and_sine(posed);
                let speed = (second.0 - first.0).dot(guide);
                Resisting::Along(guide * -(tangent * speed.sense(least_speed)))
            }
        });
    }
    found
}

/// The joints with friction that stand still, or of which it is not certain which way they move.
pub(super) fn at_rest(mechanism: &Mechanism, posed: &impl Posed<Ball>, list: &LoadList) -> Vec<JointId> {
    let is_open = |number: Ball| number.high == 0.0 && number.error() > 0.0;
    let resisting = resisting(mechanism, posed, list);
    let rests = |id: &JointId| match resisting.get(id.0).copied().flatten() {
        Some(Resisting::Couple(couple)) => is_open(couple),
        Some(Resisting::Along(force)) => is_open(force.x) || is_open(force.y),
        None => false,
    };
    mechanism.joint_ids().filter(rests).collect()
}

/// What friction does to the bodies of the joints, as loads: what both sides of a joint receive, but for the frame.
pub(super) fn as_loads<N: Solvable>(
    mechanism: &Mechanism,
    posed: &impl Posed<N>,
    friction: impl Iterator<Item = (JointId, Wrench<N>)>,
) -> Vec<Acting<N>> {
    let both = |(joint, Wrench { force, moment }): (JointId, Wrench<N>)| {
        let at = posed.place(mechanism.joint_point(joint));
        let [first, second] = mechanism.rubbing_bodies(joint);
        let source = Source::Friction(joint);
        [
            Acting { source, body: second, at, force, couple: moment },
            Acting { source, body: first, at, force: -force, couple: -moment },
        ]
    };
    friction.flat_map(both).filter(|load| load.body != GROUND).collect()
}
