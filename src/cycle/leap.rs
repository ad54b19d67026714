//! Leaps over change points, where two branches of a motion cross.

use super::path::{Event, Happening, Path};
use super::segment::{Node, Segment, rates};
use crate::geometry::OneByOne;
use crate::kernel::Unknown;

/// Distance of an estimate from what lengths say, in turns, within which both mean the same.
pub(super) const ALIKE: f64 = 1e-5;

/// What estimates of a place may be off, in differences of two of them, …
pub(super) const ROOM: f64 = 4.0;

/// … and at least, in turns.
pub(super) const ROUNDED: f64 = 1e-14;

/// Distances before a change point from which a leap may start, in turns: the shorter ones are for motions that are
/// quick there.
pub(super) const LEAPS: [f64; 4] = [4e-3, 4e-4, 4e-5, 4e-6];

/// Distance from a change point at which it is leapt over, in turns: rates are still known well there.
pub(super) const NEAR_CHANGE: f64 = 4e-7;

/// Largest growth of rates from the start of a leap to [`NEAR_CHANGE`]. They grow more before two limits with no motion
/// between them, and where two branches only come near each other; of other groups than those of which
/// [`Reach`](crate::motion::Reach) knows it a gap of less than about 1e-6 of a turn counts as one change point.
const GROWTH: f64 = 1.3;

/// Largest first correction after a leap, in radians or parts of the group's size.
const LEAP_OFF: f64 = 1e-5;

/// Leaps over a change point at most `within` turns ahead, where a determinant passes through zero while the motion
/// stays smooth: drops the nodes next to it and appends the one on the other side. Returns the event; `None` if there is
/// no change point.
///
/// A leap is checked. Ordinary steps would come so near that rounding errors of the rates look like a limit, or lead to
/// the branch that crosses this one.
pub(super) fn leap(path: &Path, nodes: &mut Vec<Node>, forward: f64, within: f64) -> Option<Event> {
    let [.., before, last] = nodes.as_slice() else {
        return None;
    };
    let group = nearest_to_singularity(last)?;
    let determinant = |node: &Node| node.determinants[group][0];
    // The determinant is proportional to the distance from the change point.
    let fall = (determinant(before) - determinant(last)) / (before.value - last.value);
    let zero = last.value - determinant(last) / fall;
    let away = |node: &Node| (zero - node.value) * forward / path.unit();
    if away(last).is_nan() || away(last).abs() > within {
        return None;
    }
    let known = nodes.iter().rfind(|n| away(n) >= NEAR_CHANGE)?;
    let reach = path.reach(group, &path.position(&last.block, 0).pose());
    if reach.as_ref().is_some_and(|reach| !reach.branches_cross()) {
        return None;
    }
    let (far, node, [at, within]) = LEAPS.into_iter().find_map(|length| {
        let far = nodes.iter().rposition(|n| away(n) >= length)?;
        if fastest(path, known, group) > GROWTH * fastest(path, &nodes[far], group) {
            return None;
        }
        let (node, place) = leap_from(path, &nodes[far..], group, zero)?;
        Some((far, node, place))
    })?;
    nodes.truncate(far + 1);
    nodes.push(node);
    let links = path.mechanism.groups[group].link_names(&path.mechanism);
    let known = reach.map(|reach| reach.in_line(at)).filter(|[known, _]| (known - at).abs() < ALIKE * path.unit());
    let [at, within] = known.unwrap_or([at, within]);
    Some(Event { at, within, what: Happening::Change(links) })
}

/// The node on the other side of the `zero` of a group's determinant, as far from it as the first of these nodes, and
/// the drive's value at the change point with what it may be off.
///
/// The polynomial through the first two nodes is extrapolated to the other side. The leap is accepted if the mechanism
/// closes there within [`LEAP_OFF`] and the determinant has changed its sign; on the branch that crosses this one it
/// would not.
fn leap_from(path: &Path, nodes: &[Node], group: usize, zero: f64) -> Option<(Node, [f64; 2])> {
    let [far, near, ..] = nodes else {
        return None;
    };
    let determinant = |node: &Node| node.determinants[group][0];
    let width = zero - far.value;
    let segment = Segment::new(&path.kernel, far, near);
    let land = |value: f64, segment: &Segment| {
        let mut block = near.block.clone();
        path.set_inputs(OneByOne, &mut block, &[value]);
        segment.predict(OneByOne, &[value], &mut block);
        let found = path.kernel.assemble(&mut block, 0.0);
        (found.closed && found.first <= LEAP_OFF).then(|| Node::new(&path.kernel, value, block))
    };
    let mut node = land(zero + width, &segment)?;
    path.unit_rates(&mut node.block);
    if !(-5.0..=-0.2).contains(&(determinant(&node) / determinant(far))) {
        return None;
    }
    // The zero of the determinant, by inverse interpolation through four positions around it.
    let whole = Segment::new(&path.kernel, far, &node);
    let around = [-0.25, -0.125, 0.125, 0.25].map(|part| land(zero + part * width, &whole));
    let samples: Vec<[f64; 2]> = around.iter().flatten().map(|n| [determinant(n), n.value - zero]).collect();
    if samples.len() < around.len() {
        return None;
    }
    let interpolated = |samples: &[[f64; 2]]| {
        let terms = samples.iter().enumerate().map(|(i, [own, offset])| {
            let others = samples.iter().enumerate().filter(|(j, _)| *j != i);
            others.fold(*offset, |term, (_, [other, _])| term * other / (other - own))
        });
        terms.sum::<f64>()
    };
    let (by_four, by_three) = (interpolated(&samples), interpolated(&samples[1..]));
    Some((node, [zero + by_four, ROOM * (by_four - by_three).abs() + ROUNDED * path.unit()]))
}

/// The group nearest to a singular position: the one of the least Hadamard ratio.
pub(super) fn nearest_to_singularity(node: &Node) -> Option<usize> {
    let ratios = node.determinants.iter().map(|[_, ratio]| ratio);
    ratios.enumerate().min_by(|a, b| a.1.total_cmp(b.1)).map(|(group, _)| group)
}

/// Rate and second derivative of an unknown; of slides in parts of the mechanism's size.
pub(super) fn relative_rates(path: &Path, node: &Node, unknown: Unknown) -> [f64; 2] {
    let unit = match unknown {
        Unknown::Spin(_) => 1.0,
        Unknown::Slide(_) => path.size,
    };
    rates(&node.block, unknown).map(|rate| rate / unit)
}

/// The fastest rate of a group's unknowns; slides count in parts of the mechanism's size.
pub(super) fn fastest(path: &Path, node: &Node, group: usize) -> f64 {
    let rate = |unknown: &Unknown| relative_rates(path, node, *unknown)[0].abs();
    path.kernel.unknowns[group].iter().map(rate).fold(0.0, f64::max)
}
