//! What stops and turns back where a scene stands.

use super::path::{Event, Happening};
use crate::accuracy::bounds;
use crate::construction::Solution;
use crate::geometry::{degrees_of, span};
use crate::mechanism::{AngularRate, BodyId, LoopEquations, SliderId};
use crate::motion::{drive_stands, motion};
use crate::sheet::Order;
use crate::words::Wording;
use std::cmp::Reverse;

/// What hardly moves.
#[derive(Clone, Copy)]
enum Slow {
    Link(BodyId),
    Slider(SliderId),
}

/// Rates below this part of the fastest may be zero: whether they are their bounds tell.
const SLOW: f64 = 1e-9;

/// What turns back at the scene's own position, as a [`Path`](super::Path) says it of the whole motion: dead centres, if the
/// link or slider were the driving one. Its velocity is zero within its bound, and its acceleration is not.
#[must_use]
pub fn turning_back(solution: &Solution) -> Vec<Happening> {
    let Solution { scene, mechanism, pose, motion: own, .. } = solution;
    let size = span(pose.points.iter().copied());
    let turning = own.bodies.iter().map(|body| body.omega.abs().max(body.velocity.norm() / size));
    let fastest = turning.fold(0.0, f64::max);
    let is_slow = |rate: f64, scale: f64| rate.abs() <= SLOW * scale && scale > 0.0;
    let mut slow: Vec<Slow> = Vec::new();
    for group in &mechanism.groups {
        let equations = LoopEquations::new(mechanism, group);
        for unknown in 0..equations.unknowns {
            let turns = |id: &&BodyId| equations.angular_rate_of(**id) == AngularRate::Unknown(unknown);
            let named = group.bodies.iter().filter(turns).filter(|&&id| !mechanism.body(id).is_nameless());
            // Of links that turn together the one with most points is named: the lever, not the block on it.
            let largest = named.min_by_key(|&&id| Reverse(mechanism.body(id).points.len()));
            slow.extend(largest.filter(|&&id| is_slow(own.body(id).omega, fastest)).map(|&id| Slow::Link(id)));
        }
        let slides = equations.slides.iter().map(|&(id, _)| id);
        slow.extend(slides.filter(|&id| is_slow(own.slide(id).velocity, fastest * size)).map(Slow::Slider));
    }
    if slow.is_empty() {
        return Vec::new();
    }
    let Ok(full) = motion(mechanism, pose, Order::Acceleration) else { return Vec::new() };
    let bounds = bounds(scene, mechanism, pose, &full);
    let turns =
        |[rate, second]: [f64; 2], [error, of_second]: [f64; 2]| rate.abs() <= error && second.abs() > of_second;
    let happening = |slow: Slow| match slow {
        Slow::Link(id) => {
            let (rates, axis) = (full.body(id), pose.axes[id.0]?);
            let is_turning = turns([rates.omega, rates.alpha], bounds.angular_rates(id));
            let link = mechanism.body(id).name.clone();
            is_turning.then(|| Happening::TurnsBack { link, angle: degrees_of(axis) })
        }
        Slow::Slider(id) => {
            let (rates, position) = (full.slide(id), pose.slides[id.0]?);
            let is_turning = turns([rates.velocity, rates.acceleration], bounds.slide(id));
            is_turning.then(|| Happening::SlidesBack { slider: mechanism.slider_name(id), position })
        }
    };
    slow.into_iter().filter_map(happening).collect()
}

/// The same in words.
#[must_use]
pub fn told_turning_back(solution: &Solution, words: &Wording) -> Vec<String> {
    let told = |what| {
        let [name, amount] = drive_stands(&solution.mechanism, &solution.pose);
        Event { at: 0.0, within: 0.0, what }.text(&format!("{name} = {}", words.number(amount)), words)
    };
    turning_back(solution).into_iter().map(told).collect()
}
