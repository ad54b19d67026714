//! Lists of quantities that a solved scene has.

use super::name::is_acceleration;
use crate::construction::{Action, Construction, Solution, coincident_name};
use crate::mechanism::{Role, SliderId};
use crate::motion::Order;

/// Names of what results and steps give and a hand drawing may have read from it: measured lengths and segments, rates, vectors by size
/// and angle, angles of links, positions of sliders.
#[must_use]
pub fn readable_names(solution: &Solution) -> Vec<String> {
    let Solution { mechanism, motion, construction, .. } = solution;
    let mut names = measured_names(construction);
    for (_, body) in mechanism.links().filter(|(_, b)| b.role != Role::Stub) {
        // A link with one point has no line of its own.
        let heads = ["angle", "omega", "alpha"].into_iter();
        let heads = heads.skip(usize::from(body.points.len() < 2));
        names.extend(heads.map(|head| format!("{head}({})", body.name)));
    }
    for slider in (0..mechanism.sliders.len()).map(SliderId) {
        let slider = mechanism.slider_name(slider);
        names.extend(["position", "v_r", "a_r"].map(|head| format!("{head}({slider})")));
        names.push(format!("a_c({slider}).size"));
    }
    let sliders = mechanism.sliders.iter();
    let under = sliders.map(|s| coincident_name(mechanism.point_name(s.at), &mechanism.body(s.on).name));
    let special = construction.special.iter().flatten();
    let special = special.filter(|s| s.is_assur && s.place.finite().is_some());
    let points = mechanism.points.iter().cloned().chain(under);
    for point in points.chain(special.map(|s| s.name.clone())) {
        for head in ["v", "a"] {
            names.extend(["size", "angle"].map(|part| format!("{head}({point}).{part}")));
        }
    }
    if motion.order == Order::Velocity {
        names.retain(|name| !is_acceleration(name));
    }
    names
}

/// Names of everything that the construction measures, in its order.
#[must_use]
pub fn measured_names(construction: &Construction) -> Vec<String> {
    names(construction, |action| action.is_measured())
}

/// Names of everything that stands in the construction's steps with a value: what is measured, then the rest of the plans.
#[must_use]
pub fn step_names(construction: &Construction) -> Vec<String> {
    let mut all = measured_names(construction);
    all.extend(names(construction, |action| !action.is_measured()));
    all
}

/// Names that the steps of some kinds give, in their order.
fn names(construction: &Construction, is_wanted: impl Fn(&Action) -> bool) -> Vec<String> {
    let steps = construction.numbered_steps().filter(|s| is_wanted(&s.step.action));
    steps.flat_map(|s| s.names()).collect()
}
