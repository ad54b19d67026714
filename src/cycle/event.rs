//! Where a link or slider stops and turns back.

use super::drive::snapped;
use super::path::{Event, Happening, Path};
use super::segment::{Segment, rates};
use super::walker::Walker;
use crate::geometry::{UNIT_ROUNDOFF, Vector, degrees_of};
use crate::kernel::{Single, Unknown};
use crate::mechanism::SliderId;
use std::cmp::Reverse;

/// Parts of a segment that are searched for a change of a rate's sign.
const PARTS: usize = 8;

/// So many parts to either side of such a change a certain sign is looked for.
const WIDE: usize = 3;

/// Relative tolerance for rest: a link or slider whose rate stays below this part of the fastest rate does not move.
const AT_REST: f64 = 1e-9;

/// Roundings that enter a rate.
const ROUNDINGS: f64 = 64.0;

/// Most Newton or bisection steps to an extreme position.
const STEPS: usize = 60;

impl Path<'_> {
    /// The fastest rate of a position, for a unit rate of the drive; slides count in parts of the mechanism's size.
    fn fastest(&self, block: &Single) -> f64 {
        let unknowns = self.kernel.unknowns.iter().flatten();
        let of_unknown = |unknown: &Unknown| match unknown {
            Unknown::Spin(_) => rates(block, *unknown)[0].abs(),
            Unknown::Slide(_) => rates(block, *unknown)[0].abs() / self.size,
        };
        let own = if self.drive.is_angle { 1.0_f64.to_radians() } else { 1.0 / self.size };
        unknowns.map(of_unknown).fold(own, f64::max)
    }

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
    let kernel = &path.kernel;
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
        let fastest = fastest(unknown);
        if fastest <= AT_REST * scale {
            continue;
        }
        let samples = samples(path, unknown);
        let mut next = 1;
        while next < samples.len() {
            let at = next;
            next += 1;
            if (samples[at - 1][1] < 0.0) == (samples[at][1] < 0.0) {
                continue;
            }
            // A rate that is zero to its error, as at the scene's own position, has no sign: those on both sides count.
            let mut sign =
                |index: usize| Some((index, certain_sign(path, &mut walker, unknown, samples[index][0], fastest)?));
            let before = (at.saturating_sub(WIDE)..at).rev().find_map(&mut sign);
            let after = (at..samples.len().min(at + WIDE)).find_map(&mut sign);
            let Some(((low, first), (high, last))) = before.zip(after) else { continue };
            next = high + 1;
            if first == last {
                continue;
            }
            let [low, high] = [low, high].map(|index| samples[index][0]);
            let found = standstill(&mut walker, unknown, low, high, path.unit());
            events.extend(found.and_then(|at| extreme(path, &mut walker, unknown, at)));
        }
    }
    events
}

/// The places at which a rate's sign is read, in the order of the drive's value, and the rate there, from the polynomials.
fn samples(path: &Path, unknown: Unknown) -> Vec<[f64; 2]> {
    let of_segment = |segment: &Segment, k: usize| {
        let at =
            if k == PARTS { segment.to } else { segment.from + (segment.to - segment.from) / PARTS as f64 * k as f64 };
        [at, segment.rate(unknown, at)]
    };
    let segments = path.segments.iter();
    let inner = segments.flat_map(|segment| (0..PARTS).map(move |k| of_segment(segment, k)));
    inner.chain(path.segments.last().map(|last| of_segment(last, PARTS))).collect()
}

/// The event at a value of the drive where an unknown's rate is zero.
fn extreme(path: &Path, walker: &mut Walker, unknown: Unknown, at: f64) -> Option<Event> {
    let (mechanism, kernel) = (&path.mechanism, &path.kernel);
    let block = walker.unit_motion(at)?;
    let [rate, second] = rates(block, unknown);
    // What the rate may be off, by those that others have there, moves its zero; with a second time as much as room.
    let own = if matches!(unknown, Unknown::Spin(_)) { 1.0 } else { path.size };
    let fastest = own * path.fastest(block);
    let within = 2.0 * (rate.abs() + error(path, block, rate, fastest)) / second.abs() + UNIT_ROUNDOFF * path.unit();
    let block = walker.positions(&[at])?;
    let what = match unknown {
        Unknown::Slide(slider) => Happening::SlidesBack {
            slider: mechanism.slider_name(SliderId(slider)),
            position: snapped(block.slides[slider][0], path.size),
        },
        Unknown::Spin(class) => {
            // Of links that turn together the one with most points is named: the lever, not the block on it.
            let links = mechanism.links().filter(|(id, _)| kernel.seat(*id).class == class);
            let (id, body) = links.min_by_key(|(_, body)| Reverse(body.points.len()))?;
            let axis = block.turn(class, 0) * block.turn_in_class(id, 0) * Vector::x();
            Happening::TurnsBack { link: body.name.clone(), angle: degrees_of(axis) }
        }
    };
    Some(Event { at, within, what })
}

/// The sign of the rate of an unknown at a value of the drive; `None` where it may be zero by its error, of the
/// `fastest` rate about u over the squared Hadamard ratio, or where there is no motion.
fn certain_sign(path: &Path, walker: &mut Walker, unknown: Unknown, value: f64, fastest: f64) -> Option<f64> {
    let block = walker.unit_motion(value)?;
    let [rate, _] = rates(block, unknown);
    (rate.abs() > error(path, block, rate, fastest)).then_some(rate.signum())
}

/// What rounding may move a rate by.
fn error(path: &Path, block: &Single, rate: f64, fastest: f64) -> f64 {
    let ratios = path.kernel.determinants(block).into_iter().map(|[_, squared_ratio]| squared_ratio);
    ROUNDINGS * UNIT_ROUNDOFF * fastest.max(rate.abs()) / ratios.fold(1.0, f64::min)
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
