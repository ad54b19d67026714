//! Names of the quantities that results, steps and hand drawings give.

use crate::construction::{Construction, NumberedStep, Solution, coincident_name};
use crate::mechanism::Role;
use crate::scene::{Component, Head, QuantityName};
use crate::sheet::Order;

/// Names of the quantities that results and steps give and that may be read from a hand drawing: measured lengths and
/// segments, rates, vectors by size and angle, angles of links, positions of sliders.
#[must_use]
pub fn readable_names(solution: &Solution) -> Vec<String> {
    let Solution { mechanism, motion, construction, .. } = solution;
    let mut names = measured_names(construction);
    for (_, body) in mechanism.links().filter(|(_, b)| b.role != Role::Unsolved) {
        // A link with one point has no line whose angle could be measured.
        let heads = [Head::Angle, Head::Omega, Head::Alpha].into_iter().skip(usize::from(body.points.len() < 2));
        names.extend(heads.map(|head| head.of(&body.name)));
    }
    for slider in mechanism.slider_ids() {
        let slider = mechanism.slider_name(slider);
        names.extend([Head::SlidePosition, Head::SlideVelocity, Head::SlideAcceleration].map(|head| head.of(&slider)));
        names.push(Head::Coriolis.number_of(&slider, Component::Size));
    }
    let sliders = mechanism.sliders.iter();
    let under = sliders.map(|s| coincident_name(mechanism.point_name(s.at), &mechanism.body(s.on).name));
    let special = construction.special.iter();
    let special = special.filter(|s| s.is_assur && s.place.finite().is_some());
    let points = mechanism.points.iter().cloned().chain(under);
    for point in points.chain(special.map(|s| s.name.clone())) {
        for head in [Head::Velocity, Head::Acceleration] {
            names.extend([Component::Size, Component::Angle].map(|part| head.number_of(&point, part)));
        }
    }
    if motion.order == Order::Velocity {
        names.retain(|name| !QuantityName::parse(name).is_some_and(|name| name.needs_accelerations()));
    }
    names
}

/// Names of the lengths and segments that the construction measures, in its order.
#[must_use]
pub fn measured_names(construction: &Construction) -> Vec<String> {
    let measured = construction.steps_by_hand().filter(|step| step.action.is_measured());
    measured.flat_map(|step| step.names()).collect()
}

/// Names of the quantities whose values the construction's steps give: first those measured, then those of each plan in
/// order.
#[must_use]
pub fn step_names(construction: &Construction) -> Vec<String> {
    let mut steps: Vec<NumberedStep<'_>> = construction.steps_by_hand().collect();
    steps.sort_by_key(|step| !step.action.is_measured());
    steps.iter().flat_map(NumberedStep::names).collect()
}
