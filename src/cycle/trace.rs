use super::segment::{Node, Segment};
use super::{Event, Happening, Path};
use crate::geometry::OneByOne;
use crate::kernel::{Correction, Unknown};

/// What is left of a middle position for Newton's method to find, in units of rounding after one step: far less than one.
const DOUBT: f64 = 0.02;

/// The same for the many short steps towards a limit, where Newton's method may take a second step.
const DOUBT_NEAR_END: f64 = 1e4;

/// Steps below this part of a turn are those near a limit.
const SHORT: f64 = 1e-4;

/// The largest turn of a link in one step, in radians.
const LARGEST_TURN: f64 = 0.6;

/// The largest first correction of a predicted position, in radians or parts of the group's size.
const OFF: f64 = 0.1;

/// The part that must be left of a group's determinant after a step: a limit is approached by ever smaller steps.
const DETERMINANT_LEFT: f64 = 0.2;

/// Steps below this part of a turn have met something, and are as near to it as is known in f64: much shorter ones could
/// hop to another branch.
const SMALLEST: f64 = 1e-11;

/// How near an end must have been approached, in parts of a turn, for its estimate to be exact. What that leaves out is of the
/// size of the distance's square, over the distance to the next end; a limit is approached much nearer, a place that runs off
/// to infinity not: there the distance's third power is left out.
const NEAR_END: f64 = 1e-6;

/// How far before a change point a leap may begin, in parts of a turn: shorter ones are for motions that are quick there.
const LEAPS: [f64; 4] = [4e-3, 4e-4, 4e-5, 4e-6];

/// How near a change point is approached before the leap, in parts of a turn: there rates are still known well.
const NEAR_CHANGE: f64 = 4e-7;

/// By how much rates may grow from the beginning of a leap to there. They grow more before two limits with nothing between
/// them, and where two branches only come near each other; but what is less than about 1e-6 of a turn wide counts as one change point.
const GROWTH: f64 = 1.3;

/// The largest first correction after a leap, in radians or parts of the group's size.
const LEAP_OFF: f64 = 1e-5;

/// The nodes of a path, in walking order, and what happened after those that were there.
pub(super) struct Traced {
    pub nodes: Vec<Node>,
    pub changes: Vec<Event>,
    pub end: Option<Event>,
}

/// Follows the branch from the last of some nodes to a value of the drive, or as far as it goes.
pub(super) fn trace(path: &Path, mut nodes: Vec<Node>, target: f64) -> Traced {
    let forward = (target - nodes[nodes.len() - 1].value).signum();
    let unit = path.unit();
    let mut step = unit / 36.0;
    let mut traced = Traced { nodes: Vec::new(), changes: Vec::new(), end: None };
    loop {
        let last = &nodes[nodes.len() - 1];
        let left = (target - last.value) * forward;
        if left <= 0.0 {
            break;
        }
        if let Some(leap) = leap(path, &nodes, forward, NEAR_CHANGE) {
            traced.changes.push(leap.land(&mut nodes));
            step = unit / 360.0;
            continue;
        }
        let tried = step.min(left);
        let to = if tried < left { last.value + forward * tried } else { target };
        match advance(path, last, to) {
            Some((node, correction)) => {
                // The error in the middle grows with the sixth power of the step, what it leaves with the twelfth.
                let growth = libm::pow(allowed(tried / unit) / correction.doubt.max(1e-30), 1.0 / 12.0);
                step = tried * (0.9 * growth).clamp(0.3, 2.0);
                nodes.push(node);
            }
            None => {
                step = 0.5 * tried;
                if step > SMALLEST * unit {
                    continue;
                }
                // Very unequal links leave rates too little known to come as near as that.
                if let Some(leap) = leap(path, &nodes, forward, LEAPS[0]) {
                    traced.changes.push(leap.land(&mut nodes));
                    step = unit / 360.0;
                    continue;
                }
                let links = dullest_links(path, last);
                let ahead = ahead(path, &nodes, forward);
                let ahead = ahead.filter(|a| a.away.abs() < NEAR_END * unit);
                traced.end = Some(match ahead {
                    Some(Ahead { at, runs_off: false, .. }) => Event { at, what: Happening::Limit { links } },
                    Some(Ahead { at, .. }) => Event { at, what: Happening::RunsOff { links } },
                    None => Event { at: last.value, what: Happening::Singular { links } },
                });
                break;
            }
        }
    }
    traced.nodes = nodes;
    traced
}

/// The node at a value of the drive, if the step to it is sure; and how well its middle was met.
fn advance(path: &Path, last: &Node, to: f64) -> Option<(Node, Correction)> {
    let step = to - last.value;
    let mut block = last.block.clone();
    path.set_inputs(OneByOne, &mut block, &[to]);
    for unknown in path.kernel.unknowns.iter().flatten() {
        match *unknown {
            Unknown::Spin(class) => {
                let (omega, alpha) = (block.omegas[class][0], block.alphas[class][0]);
                let angle = step * (omega + 0.5 * step * alpha);
                if angle.is_nan() || angle.abs() > LARGEST_TURN {
                    return None;
                }
                let (sine, cosine) = libm::sincos(angle);
                let [[x], [y]] = block.turns[class];
                block.turns[class] = [[x * cosine - y * sine], [x * sine + y * cosine]];
            }
            Unknown::Slide(slider) => {
                let (speed, second) = (block.speeds[slider][0], block.accelerations[slider][0]);
                block.slides[slider][0] += step * (speed + 0.5 * step * second);
            }
        }
    }
    let found = path.kernel.assemble(OneByOne, &mut block, 0.0);
    if !found.closed || found.first > OFF {
        return None;
    }
    path.unit_rates(&mut block);
    let node = Node::new(path, to, block);
    let mut pairs = last.determinants.iter().zip(&node.determinants);
    if !pairs.all(|([old, _], [new, _])| new / old >= DETERMINANT_LEFT) {
        return None;
    }
    let segment = Segment::new(&path.kernel, last, &node);
    let middle = last.value + 0.5 * step;
    let mut block = node.block.clone();
    path.set_inputs(OneByOne, &mut block, &[middle]);
    segment.predict(OneByOne, &[middle], &mut block);
    let met = path.kernel.assemble(OneByOne, &mut block, 0.0);
    let short = step.abs() / path.unit();
    (met.closed && met.doubt <= allowed(short)).then_some((node, met))
}

/// The doubt that a step of this part of a turn may leave.
fn allowed(step: f64) -> f64 {
    if step < SHORT { DOUBT_NEAR_END } else { DOUBT }
}

/// The group nearest to a singular position.
fn dullest(node: &Node) -> Option<usize> {
    let sharpness = node.determinants.iter().map(|[_, sharpness]| sharpness);
    let least = sharpness.enumerate().min_by(|a, b| a.1.total_cmp(b.1));
    least.map(|(group, _)| group)
}

/// Names of the links of the group nearest to a singular position.
fn dullest_links(path: &Path, node: &Node) -> String {
    let name = |group: usize| path.mechanism.groups[group].link_names(path.mechanism);
    dullest(node).map_or_else(String::new, name)
}

/// The fastest rate of a group's unknowns; slides count in parts of the mechanism's size.
fn fastest(path: &Path, node: &Node, group: usize) -> f64 {
    let size = path.size();
    let unknowns = path.kernel.unknowns[group].iter();
    let rates = unknowns.map(|unknown| match *unknown {
        Unknown::Spin(class) => node.block.omegas[class][0].abs(),
        Unknown::Slide(slider) => node.block.speeds[slider][0].abs() / size,
    });
    rates.fold(0.0, f64::max)
}

/// What shows ahead in rates that grow.
struct Ahead {
    at: f64,
    /// How far ahead.
    away: f64,
    /// Whether a place runs off to infinity there; else two branches meet.
    runs_off: bool,
}

/// What lies ahead of the last node; `None` if nothing shows in the rates.
///
/// Where rates grow like the power −p of the distance d, their ratio to the second derivatives is q = (dx/dv) / (d²x/dv²) = d / p,
/// so two nodes tell p. At a limit, where x = x* − c √d, it is 1/2; where x = c / d runs off to infinity it is 2.
/// The next term of d, which at a limit is of the power 3/2, is removed by the two nodes (Richardson, 1911).
fn ahead(path: &Path, nodes: &[Node], forward: f64) -> Option<Ahead> {
    let last = &nodes[nodes.len() - 1];
    let group = dullest(last)?;
    let determinant = |node: &Node| node.determinants[group][0];
    // A node that is some way back, seen by the determinant.
    let back = |n: &&Node| determinant(n) / determinant(last) >= 2.0;
    let before = nodes.iter().rev().find(back)?;
    let size = path.size();
    let rates = |node: &Node, unknown: Unknown| {
        let block = &node.block;
        match unknown {
            Unknown::Spin(class) => [block.omegas[class][0], block.alphas[class][0]],
            Unknown::Slide(slider) => [block.speeds[slider][0] / size, block.accelerations[slider][0] / size],
        }
    };
    let second = |unknown: &&Unknown| rates(last, **unknown)[1].abs();
    let unknowns = path.kernel.unknowns[group].iter();
    let quickest = *unknowns.max_by(|a, b| second(a).total_cmp(&second(b)))?;
    let [now, then] = [last, before].map(|node| rates(node, quickest));
    let [near, far] = [now, then].map(|[first, second]| first / second);
    // Rates grow as the determinant falls; at a change point they do not.
    let grown = now[0] / then[0] >= 0.5 * determinant(before) / determinant(last);
    if !(grown && near * forward > 0.0 && far * forward > 0.0) {
        return None;
    }
    let runs_off = (last.value - before.value) / (far - near) > 1.0;
    let (power, next) = if runs_off { (2.0, 3.0) } else { (0.5, 1.5) };
    let weight = libm::pow(near / far, next);
    let [near, far] = [near, far].map(|q| power * q);
    let (near_place, far_place) = (last.value + near, before.value + far);
    let at = near_place + (near_place - far_place) * weight / (1.0 - weight);
    Some(Ahead { at, away: near, runs_off })
}

/// A way over a change point.
struct Leap {
    /// How many nodes lie before it.
    kept: usize,
    /// The node on the other side.
    node: Node,
    /// The change point.
    event: Event,
}

impl Leap {
    /// Goes on from the other side.
    fn land(self, nodes: &mut Vec<Node>) -> Event {
        nodes.truncate(self.kept);
        nodes.push(self.node);
        self.event
    }
}

/// The leap over a change point less than this part of a turn ahead, where a determinant passes through zero while the
/// motion stays smooth.
///
/// A leap proves itself; going on by steps, rounding would take what rates are left for a limit, or for the branch that crosses this one.
fn leap(path: &Path, nodes: &[Node], forward: f64, within: f64) -> Option<Leap> {
    let [.., before, last] = nodes else {
        return None;
    };
    let group = dullest(last)?;
    let determinant = |node: &Node| node.determinants[group][0];
    // The determinant goes to zero in proportion to the distance.
    let fall = (determinant(before) - determinant(last)) / (before.value - last.value);
    let zero = last.value - determinant(last) / fall;
    let away = |node: &Node| (zero - node.value) * forward / path.unit();
    if away(last).is_nan() || away(last).abs() > within {
        return None;
    }
    let known = nodes.iter().rfind(|n| away(n) >= NEAR_CHANGE)?;
    LEAPS.into_iter().find_map(|length| {
        let far = nodes.iter().rposition(|n| away(n) >= length)?;
        let grown = fastest(path, known, group) > GROWTH * fastest(path, &nodes[far], group);
        let (node, at) = leap_from(path, &nodes[far..], group, zero).filter(|_| !grown)?;
        let links = path.mechanism.groups[group].link_names(path.mechanism);
        let what = Happening::Change { links };
        Some(Leap { kept: far + 1, node, event: Event { at, what } })
    })
}

/// Leaps from the first of these nodes to the other side of the `zero` of a group's determinant.
///
/// The polynomial from there to the next node is followed to the other side; the leap is sure where that meets the mechanism to
/// [`LEAP_OFF`] and the determinant has changed its sign: on the branch that crosses this one it has not.
fn leap_from(path: &Path, nodes: &[Node], group: usize, zero: f64) -> Option<(Node, f64)> {
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
        let found = path.kernel.assemble(OneByOne, &mut block, 0.0);
        (found.closed && found.first <= LEAP_OFF).then(|| Node::new(path, value, block))
    };
    let mut node = land(zero + width, &segment)?;
    path.unit_rates(&mut node.block);
    if !(-5.0..=-0.2).contains(&(determinant(&node) / determinant(far))) {
        return None;
    }
    // The determinant's zero by inverse interpolation through four positions around it.
    let whole = Segment::new(&path.kernel, far, &node);
    let around = [-0.25, -0.125, 0.125, 0.25].map(|part| land(zero + part * width, &whole));
    let samples: Vec<[f64; 2]> = around.iter().flatten().map(|n| [determinant(n), n.value - zero]).collect();
    if samples.len() < around.len() {
        return None;
    }
    let mut at = zero;
    for (i, [own, offset]) in samples.iter().enumerate() {
        let others = samples.iter().enumerate().filter(|(j, _)| *j != i);
        at += others.fold(*offset, |term, (_, [other, _])| term * other / (other - own));
    }
    Some((node, at))
}
