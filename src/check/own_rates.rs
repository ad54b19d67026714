//! Values that follow from few numbers. Those that students compute from the rates of rotation of their own sheet, as |a_B| from α and ω, where a drawing gives them by
//! measuring: they follow from these rates, whatever was drawn. And those that the numbers of the scene are enough for.

use super::entry::Entry;
use super::model::Model;
use crate::construction::{Rate, Solution, image_name};
use crate::mechanism::{BodyId, GROUND, PointId, Role};
use crate::quantity::What;
use crate::sheet::Order;

/// Slack of a computed number beyond its roundings, in parts of it: people compute with three or four digits.
const SLACK: f64 = 3e-3;

/// By entry: how exactly it is the acceleration that the written rates of a link give one of its points relative to another, where
/// no later operation uses it. Segments from which rates are found, and all velocities, agree with them in any drawing.
pub(super) fn from_own_rates(model: &Model, entries: &[Entry], solution: &Solution) -> Vec<Option<f64>> {
    let rate = |order: Order, body: BodyId| {
        let is_it =
            |entry: &&Entry| matches!(entry.asked.what, What::Rate(Rate::Angular(o, b)) if (o, b) == (order, body));
        entries.iter().find(is_it).map(|entry| (entry.value.abs(), entry.rounding))
    };
    let is_own = |(index, entry): (usize, &Entry)| {
        let What::Segment(order @ Order::Acceleration, ends) = &entry.asked.what else { return None };
        let is_read = model.readings[index].is_ok_and(|reading| !model.used[reading.number.0]);
        let (body, length) = on_one_link(solution, *order, ends).filter(|_| is_read)?;
        let rates = rate(Order::Velocity, body).zip(rate(Order::Acceleration, body));
        let ((omega, omega_rounding), (alpha, alpha_rounding)) = rates?;
        let with = |omega: f64, alpha: f64| length * libm::hypot(alpha, omega * omega);
        let (own, most) = (with(omega, alpha), with(omega + omega_rounding, alpha + alpha_rounding));
        let within = (most - own) + entry.rounding + SLACK * own;
        ((entry.value.abs() - own).abs() <= within).then_some(within)
    };
    entries.iter().enumerate().map(is_own).collect()
}

/// By entry: whether the numbers that the scene gives are enough for it, as for a velocity of the driven link, so that a student with
/// the right sheet has it.
pub(super) fn from_given_numbers(entries: &[Entry], solution: &Solution) -> Vec<bool> {
    let is_driven = |body: BodyId| matches!(solution.mechanism.body(body).role, Role::Driver { .. });
    let is_given = |entry: &Entry| match &entry.asked.what {
        What::Segment(order, ends) => on_one_link(solution, *order, ends).is_some_and(|(body, _)| is_driven(body)),
        _ => false,
    };
    entries.iter().map(is_given).collect()
}

/// The link to which the two points belong whose images these are, and their distance; the pole is the image of what is fixed.
fn on_one_link(solution: &Solution, order: Order, ends: &[String; 2]) -> Option<(BodyId, f64)> {
    let Solution { mechanism, pose, .. } = solution;
    let ground = mechanism.body(GROUND);
    let of_end = |points: &[PointId], end: &String| {
        let is_pole = *end == order.pole();
        let is_it = |point: &&PointId| match is_pole {
            true => ground.has(**point),
            false => image_name(mechanism.point_name(**point)) == *end,
        };
        points.iter().find(is_it).copied()
    };
    mechanism.links().find_map(|(id, link)| {
        let [one, other] = ends.each_ref().map(|end| of_end(&link.points, end));
        let (one, other) = one.zip(other)?;
        (one != other).then(|| (id, (pose.point(one) - pose.point(other)).norm()))
    })
}
