//! Lists of the quantities of a solved scene.

use super::band::{Pencil, pencil};
use super::name::{QuantityError, QuantityRequest};
use crate::construction::{Action, Construction, Solution, Tolerance, coincident_name};
use crate::mechanism::Role;
use crate::scene::QuantityName;
use crate::sheet::Sheet;

/// Names of the quantities that results and steps give and that may be read from a hand drawing: measured lengths and
/// segments, rates, vectors by size and angle, angles of links, positions of sliders.
#[must_use]
pub fn readable_names(solution: &Solution) -> Vec<String> {
    let Solution { mechanism, motion, construction, .. } = solution;
    let mut names = measured_names(construction);
    for (_, body) in mechanism.links().filter(|(_, b)| b.role != Role::Unsolved) {
        // A link with one point has no line whose angle could be measured.
        let heads = ["angle", "omega", "alpha"].into_iter().skip(usize::from(body.points.len() < 2));
        names.extend(heads.map(|head| format!("{head}({})", body.name)));
    }
    for slider in mechanism.slider_ids() {
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
    if motion.order == Sheet::Velocity {
        names.retain(|name| !QuantityName::parse(name).is_some_and(|name| name.needs_accelerations()));
    }
    names
}

/// Names of the lengths and segments that the construction measures, in its order.
#[must_use]
pub fn measured_names(construction: &Construction) -> Vec<String> {
    names(construction, |action| action.is_measured())
}

/// Names of the quantities whose values the construction's steps give: first those measured, then those of each plan in
/// order.
#[must_use]
pub fn step_names(construction: &Construction) -> Vec<String> {
    let mut all = measured_names(construction);
    all.extend(names(construction, |action| !action.is_measured()));
    all
}

/// What honest hands find for the quantities of the steps when they draw at the figure's scales.
///
/// # Errors
/// A name that the construction gives is not understood.
pub fn step_pencil(solution: &Solution, tolerance: Tolerance) -> Result<Pencil, QuantityError> {
    let names = step_names(&solution.construction);
    let asked =
        names.iter().map(|name| QuantityRequest::new(name, &solution.mechanism)).collect::<Result<Vec<_>, _>>()?;
    Ok(pencil(solution, &solution.scales(), tolerance, asked))
}

/// Names that the steps of some kinds give, in their order.
fn names(construction: &Construction, is_wanted: impl Fn(&Action) -> bool) -> Vec<String> {
    let steps = construction.numbered_steps().filter(|s| is_wanted(&s.step.action));
    steps.flat_map(|s| s.names()).collect()
}
