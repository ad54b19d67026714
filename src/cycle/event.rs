//! Where a link or slider stops and turns back.

use super::drive::snapped;
use super::path::{Event, Happening, Path};
use super::segment::rates;
use super::walker::Walker;
use crate::geometry::{UNIT_ROUNDOFF, Vector, degrees_of};
use crate::kernel::Unknown;
use crate::mechanism::SliderId;
use std::cmp::Reverse;

/// Parts of a segment that are searched for a change of a rate's sign.
const PARTS: usize = 8;

/// Relative tolerance for rest: a link or slider whose rate stays below this part of the fastest rate does not move.
const AT_REST: f64 = 1e-9;

/// Roundings that enter a rate.
const ROUNDINGS: f64 = 64.0;

/// Most Newton or bisection steps to an extreme position.
const STEPS: usize = 60;

impl Path<'_> {
    /// All events between the path's ends and at them, in the order of the drive's value.
    #[must_use]
    pub fn events(&self) -> Vec<Event> {
        let mut events = extreme_positions(self);
        events.extend(self.changes.iter().chain(self.ends.iter().flatten()).cloned());
        events.sort_by(|a, b| a.at.total_cmp(&b.at));
        events
    }
}

/// Extreme positions on the path: where a link or slider stops and turns back.
fn extreme_positions(path: &Path) -> Vec<Event> {
    let (mechanism, kernel) = (&path.mechanism, &path.kernel);
    let mut events = Vec::new();
    let mut walker = path.walker();
    let fastest = |unknown: Unknown| path.nodes.iter().map(|n| rates(&n.block, unknown)[0].abs()).fold(0.0, f64::max);
    let turning = kernel.unknowns.iter().flatten().filter(|u| matches!(u, Unknown::Spin(_)));
    let fastest_turn = turning.map(|u| fastest(*u)).fold(0.0, f64::max);
    for unknown in kernel.unknowns.iter().flatten().copied() {
        let scale = match unknown {
            Unknown::Spin(_) => fastest_turn,
            Unknown::Slide(_) => fastest_turn * path.size,
        };
        if fastest(unknown) <= AT_REST * scale {
            continue;
        }
        for segment in &path.segments {
            let width = (segment.to - segment.from) / PARTS as f64;
            let place = |k: usize| segment.from + width * k as f64;
            for k in 0..PARTS {
                let (low, high) = (place(k), place(k + 1).min(segment.to));
                let (first, last) = (segment.rate(unknown, low), segment.rate(unknown, high));
                if (first < 0.0) == (last < 0.0)
                    || !turns_back(path, &mut walker, unknown, [low, high], fastest(unknown))
                {
                    continue;
                }
                let Some(at) = standstill(&mut walker, unknown, low, high, path.unit()) else {
                    continue;
                };
                let Some(block) = walker.positions(&[at]) else {
                    continue;
                };
                let what = match unknown {
                    Unknown::Slide(slider) => Happening::SlidesBack {
                        slider: mechanism.slider_name(SliderId(slider)),
                        position: snapped(block.slides[slider][0], path.size),
                    },
                    Unknown::Spin(class) => {
                        // Of links that turn together the one with most points is named: the lever, not the block on
                        // it.
                        let links = mechanism.links().filter(|(id, _)| kernel.seat(*id).class == class);
                        let largest = links.min_by_key(|(_, body)| Reverse(body.points.len()));
                        let Some((id, body)) = largest else { continue };
                        let axis = block.turn(class, 0) * kernel.seat(id).turn * Vector::x();
                        Happening::TurnsBack { link: body.name.clone(), angle: degrees_of(axis) }
                    }
                };
                events.push(Event { at, what });
            }
        }
    }
    events
}

/// Whether the rate of an unknown has different signs at these values of the drive, by more than its error: of the
/// `fastest` rate about u over the squared Hadamard ratio. `false` where one of them has no motion.
fn turns_back(path: &Path, walker: &mut Walker, unknown: Unknown, ends: [f64; 2], fastest: f64) -> bool {
    let mut sign = |value: f64| -> Option<f64> {
        let block = walker.unit_motion(value)?;
        let [rate, _] = rates(block, unknown);
        let ratios = path.kernel.determinants(block).into_iter().map(|[_, squared_ratio]| squared_ratio);
        let error = ROUNDINGS * UNIT_ROUNDOFF * fastest.max(rate.abs()) / ratios.fold(1.0, f64::min);
        (rate.abs() > error).then_some(rate.signum())
    };
    let [low, high] = ends.map(&mut sign);
    low.zip(high).is_some_and(|(low, high)| low != high)
}

/// The value of the drive between `low` and `high` where an unknown's rate is zero: Newton's method, kept in its
/// bracket by bisection. `None` where a position in between has no motion.
fn standstill(walker: &mut Walker, unknown: Unknown, low: f64, high: f64, unit: f64) -> Option<f64> {
    let mut bracket = [low, high];
    let rising = rates(walker.unit_motion(high)?, unknown)[0] > 0.0;
    let mut at = 0.5 * (low + high);
    for _ in 0..STEPS {
        let [first, second] = rates(walker.unit_motion(at)?, unknown);
        bracket[usize::from((first > 0.0) == rising)] = at;
        let newton = at - first / second;
        let next = if newton > bracket[0] && newton < bracket[1] { newton } else { 0.5 * (bracket[0] + bracket[1]) };
        if (next - at).abs() <= 1e-15 * unit {
            return Some(next);
        }
        at = next;
    }
    Some(at)
}
