use super::known::Known;
use super::leap::{ALIKE, LEAPS, NEAR_CHANGE, ROOM, ROUNDED, fastest, leap, nearest_to_singularity, relative_rates};
use super::path::{Event, Happening, Path};
use super::segment::{Node, Segment, rates};
use crate::geometry::OneByOne;
use crate::kernel::{Correction, Unknown};
use std::f64::consts::TAU;

/// Distance that the branch is first followed the other way, in turns: enough for the longest leap.
const RUN_UP: f64 = 0.01;

/// Mean sine of a group's equations, times the rate of the fastest link where that is more than one, below which positions
/// are closed with twice the digits.
const DELICATE: f64 = 0.1;

/// Largest error of the interpolated middle of a step after one Newton step, in unit roundoffs: far less than one.
const DOUBT: f64 = 0.02;

/// Largest such error in the many short steps towards a limit, where Newton's method may take a second step.
const DOUBT_NEAR_END: f64 = 1e4;

/// Length of a step, in turns, below which it counts as near a limit.
const SHORT: f64 = 1e-4;

/// Largest turn of a link in one step, in radians.
const LARGEST_TURN: f64 = 0.6;

/// Largest first correction of a predicted position, in radians or parts of the group's size.
const OFF: f64 = 0.1;

/// Least ratio of a group's determinant after a step to that before: a limit is approached in ever smaller steps.
const DETERMINANT_LEFT: f64 = 0.2;

/// Smallest step, in turns; below it a singularity has been reached as nearly as f64 can tell. Much shorter steps could
/// hop to another branch.
const SMALLEST: f64 = 1e-11;

/// The same part of it where the path leads away from a limit: there is no other branch near it.
const SMALLEST_FROM_LIMIT: f64 = 1e-16;

/// Part of the way to a limit that is known by lengths which one step may go at most.
const TOWARDS_LIMIT: f64 = 0.9;

/// Distance of an end, in turns, from which its estimated place counts as exact. The estimate's error is of the order
/// of the distance's square over the distance to the next end. A limit is approached much nearer than this; a place
/// that runs off to infinity is not, but there the error is of the third power of the distance.
const NEAR_END: f64 = 1e-6;

impl Path<'_> {
    /// Follows the branch until the drive's value is reached or an event ends the path; [`Self::end`] then returns the
    /// event.
    pub fn follow_to(&mut self, value: f64) {
        if self.nodes.len() == 1 && value.is_finite() {
            // A leap over a change point close ahead needs nodes before it, so the branch is first followed a little
            // the other way. If there is a change point on that side too, those nodes are dropped: it is crossed later,
            // with nodes before it.
            let single = self.clone();
            self.extend(self.origin + RUN_UP.copysign(self.origin - value) * self.unit());
            let singular = |end: &Event| matches!(end.what, Happening::Singular(_));
            if !self.changes.is_empty() || self.ends.iter().flatten().any(singular) {
                *self = single;
            }
        }
        self.extend(value);
    }

    /// Follows the branch beyond the nodes found so far.
    fn extend(&mut self, value: f64) {
        let up = value > self.high();
        if !up && value >= self.low() || self.ends[usize::from(up)].is_some() {
            return;
        }
        let mut nodes = std::mem::take(&mut self.nodes);
        if !up {
            nodes.reverse();
        }
        let (changes, end) = trace(self, &mut nodes, value);
        if !up {
            nodes.reverse();
        }
        self.nodes = nodes;
        self.changes.extend(changes);
        self.ends[usize::from(up)] = end;
        let segment = |pair: &[Node]| {
            let mut segment = Segment::new(&self.kernel, &pair[0], &pair[1]);
            segment.delicate = pair.iter().any(|node| self.is_delicate(node));
            if self.changes.iter().any(|c| segment.holds(c.at)) {
                segment.sure = 0.0;
            }
            segment
        };
        self.segments = self.nodes.windows(2).map(segment).collect();
        self.draw_back(up);
    }

    /// Leaves out positions next to an event that ends the path where rounding keeps them from being found once more.
    fn draw_back(&mut self, up: bool) {
        let last = |path: &Path| if up { path.high() } else { path.low() };
        while self.ends[usize::from(up)].is_some()
            && self.nodes.len() > 2
            && self.walker().position(last(self)).is_none()
        {
            let [node, segment] =
                if up { [self.nodes.len(), self.segments.len()].map(|count| count - 1) } else { [0, 0] };
            self.nodes.remove(node);
            self.segments.remove(segment);
        }
    }

    /// Whether rounded gaps of the loops move a link much further than rounding of the drive does, as next to a change
    /// point: the one is u over the Hadamard ratio, the other u times the rate.
    fn is_delicate(&self, node: &Node) -> bool {
        let per_turn = self.unit() / if self.drive.is_angle { TAU } else { 1.0 };
        (0..node.determinants.len()).any(|group| {
            let rate = fastest(self, node, group) * per_turn;
            // The squared ratio is a product of a sine for each pair of unknowns, squared; this is their mean.
            let sine = libm::pow(node.determinants[group][1], 1.0 / self.kernel.unknowns[group].len() as f64);
            sine * rate.max(1.0) < DELICATE
        })
    }
}

/// Follows the branch from the last of `nodes` to the drive's value `target`, or as far as it goes, and appends the nodes
/// found. Returns the change points that were crossed, and the event that ends the path.
fn trace(path: &Path, nodes: &mut Vec<Node>, target: f64) -> (Vec<Event>, Option<Event>) {
    let forward = (target - nodes[nodes.len() - 1].value).signum();
    let unit = path.unit();
    let mut step = unit / 36.0;
    let mut changes = Vec::new();
    let mut limit: Option<Option<Known>> = None;
    loop {
        let left = (target - nodes[nodes.len() - 1].value) * forward;
        if left <= 0.0 {
            return (changes, None);
        }
        if let Some(known) = limit.iter().flatten().next() {
            step = step.min(TOWARDS_LIMIT * (known.at - nodes[nodes.len() - 1].value) * forward);
            if step <= 0.0 {
                return (changes, Some(end(path, nodes, forward)));
            }
        }
        if let Some(change) = leap(path, nodes, forward, NEAR_CHANGE) {
            changes.push(change);
            step = unit / 360.0;
            continue;
        }
        let last = &nodes[nodes.len() - 1];
        let tried = step.min(left);
        let to = if tried < left { last.value + forward * tried } else { target };
        match advance(path, last, to) {
            Some((node, correction)) => {
                // The interpolation error in the middle grows with the sixth power of the step, that after a Newton
                // step with the twelfth.
                let growth = libm::pow(allowed(tried / unit) / correction.doubt.max(1e-30), 1.0 / 12.0);
                step = tried * (0.9 * growth).clamp(0.3, 2.0);
                let further = |to: f64| Some(advance(path, last, to)?.0);
                if let Some(beyond) = path.beyond_guides(last, &node, further) {
                    let (node, event) = path.leaving(last, beyond, further);
                    nodes.extend(node);
                    return (changes, Some(event));
                }
                nodes.push(node);
            }
            None => {
                step = 0.5 * tried;
                limit.get_or_insert_with(|| Known::ahead(path, last, forward));
                let smallest = if leaves_limit(path, last, forward) { SMALLEST_FROM_LIMIT } else { SMALLEST };
                if step > smallest * unit {
                    continue;
                }
                // With links of very unequal lengths rates are too inexact to come as near as `NEAR_CHANGE`.
                if let Some(change) = leap(path, nodes, forward, LEAPS[0]) {
                    changes.push(change);
                    step = unit / 360.0;
                    continue;
                }
                return (changes, Some(end(path, nodes, forward)));
            }
        }
    }
}

/// The event that ends a path at the last of its nodes.
fn end(path: &Path, nodes: &[Node], forward: f64) -> Event {
    let unit = path.unit();
    let last = &nodes[nodes.len() - 1];
    let group = nearest_to_singularity(last);
    let name = |group: usize| path.mechanism.groups[group].link_names(&path.mechanism);
    let links = group.map_or_else(String::new, name);
    let estimate = |count: usize| ahead(path, &nodes[..count], forward).filter(|a| a.away.abs() < NEAR_END * unit);
    let found = estimate(nodes.len());
    let near = found.as_ref().map_or(last.value, |found| found.at);
    if let Some(Known { at, within, group: own }) = Known::nearest(path, last)
        && group == Some(own)
        && (at - near).abs() < ALIKE * unit
    {
        return Event { at, within, what: Happening::Limit(links) };
    }
    // Where lengths tell all limits of a group, what only looks like another one is branches that pass each other closely.
    let has_known = group.is_some_and(|group| Known::has(path, last, group));
    match found.filter(|_| !has_known) {
        Some(Ahead { at, runs_off, .. }) => {
            let others = (1..=2).filter_map(|fewer| estimate(nodes.len().saturating_sub(fewer).max(1)));
            let off = others.map(|other| (other.at - at).abs()).fold(0.0, f64::max);
            let what = if runs_off { Happening::RunsOff(links) } else { Happening::Limit(links) };
            Event { at, within: ROOM * off + ROUNDED * unit, what }
        }
        None => {
            // Where the determinant would be zero if it went on to fall as it did last.
            let zero = group.and_then(|group| match nodes {
                [.., before, last] => {
                    let [was, is] = [before, last].map(|node| node.determinants[group][0]);
                    Some((last.value - before.value) * is / (was - is))
                }
                _ => None,
            });
            let away = zero.filter(|away| away.is_finite()).unwrap_or(0.0).abs();
            Event { at: last.value, within: ROOM * (away + SMALLEST * unit), what: Happening::Singular(links) }
        }
    }
}

/// Whether the path leads away from a limit, or a place comes back from afar: rates fall.
fn leaves_limit(path: &Path, last: &Node, forward: f64) -> bool {
    let Some(group) = nearest_to_singularity(last) else { return false };
    let all = path.kernel.unknowns[group].iter().map(|unknown| relative_rates(path, last, *unknown));
    let quickest = all.max_by(|a, b| a[1].abs().total_cmp(&b[1].abs()));
    quickest.is_some_and(|[first, second]| first * second * forward < 0.0)
}

/// The node at a value of the drive, and how well the middle of the step to it was met; `None` if the step cannot be
/// trusted.
fn advance(path: &Path, last: &Node, to: f64) -> Option<(Node, Correction)> {
    let step = to - last.value;
    let mut block = last.block.clone();
    path.set_inputs(OneByOne, &mut block, &[to]);
    for unknown in path.kernel.unknowns.iter().flatten() {
        let [first, second] = rates(&block, *unknown);
        let by = step * (first + 0.5 * step * second);
        match *unknown {
            Unknown::Spin(class) => {
                if by.is_nan() || by.abs() > LARGEST_TURN {
                    return None;
                }
                let (sine, cosine) = libm::sincos(by);
                let [[x], [y]] = block.turns[class];
                block.turns[class] = [[x * cosine - y * sine], [x * sine + y * cosine]];
            }
            Unknown::Slide(slider) => block.slides[slider][0] += by,
        }
    }
    let found = path.kernel.assemble(&mut block, 0.0);
    if !found.closed || found.first > OFF {
        return None;
    }
    path.unit_rates(&mut block);
    let node = Node::new(&path.kernel, to, block);
    let mut pairs = last.determinants.iter().zip(&node.determinants);
    if !pairs.all(|([old, _], [new, _])| new / old >= DETERMINANT_LEFT) {
        return None;
    }
    let segment = Segment::new(&path.kernel, last, &node);
    let middle = last.value + 0.5 * step;
    let mut block = node.block.clone();
    path.set_inputs(OneByOne, &mut block, &[middle]);
    segment.predict(OneByOne, &[middle], &mut block);
    let met = path.kernel.assemble(&mut block, 0.0);
    let short = step.abs() / path.unit();
    (met.closed && met.doubt <= allowed(short)).then_some((node, met))
}

/// Largest doubt of a correction in the middle of a step of this length, in turns.
fn allowed(step: f64) -> f64 {
    if step < SHORT { DOUBT_NEAR_END } else { DOUBT }
}

/// A singularity ahead, estimated from the growth of rates.
struct Ahead {
    /// The drive's value there.
    at: f64,
    /// Its distance from the last node, in the drive's unit.
    away: f64,
    /// Whether a place runs off to infinity there; else two branches meet.
    runs_off: bool,
}

/// The singularity ahead of the last node; `None` if rates do not grow towards one.
///
/// Where rates grow like the power −p of the distance d, their ratio to the second derivatives is q = (dx/dv) /
/// (d²x/dv²) = d / p, so two nodes determine p. At a limit, where x = x* − c √d, p is 1/2; where x = c / d runs off to
/// infinity, p is 2. The next term in d, of the power 3/2 at a limit, is eliminated with the two nodes (Richardson,
/// 1911).
fn ahead(path: &Path, nodes: &[Node], forward: f64) -> Option<Ahead> {
    let last = &nodes[nodes.len() - 1];
    let group = nearest_to_singularity(last)?;
    let determinant = |node: &Node| node.determinants[group][0];
    // The last node whose determinant is at least twice as large.
    let back = |n: &&Node| determinant(n) / determinant(last) >= 2.0;
    let before = nodes.iter().rev().find(back)?;
    let second = |unknown: &&Unknown| relative_rates(path, last, **unknown)[1].abs();
    let unknowns = path.kernel.unknowns[group].iter();
    let quickest = *unknowns.max_by(|a, b| second(a).total_cmp(&second(b)))?;
    let [now, then] = [last, before].map(|node| relative_rates(path, node, quickest));
    let [near, far] = [now, then].map(|[first, second]| first / second);
    // Towards a limit rates grow as the determinant falls; towards a change point they do not.
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
