//! The Assur groups, and the order in which they can be solved, found from links and joints alone.
//!
//! A link has three degrees of freedom; a joint supplies constraints, most kinds two. Each constraint is assigned to
//! one of the two links it joins, three to a link at most; a link depends on the other links of the joints whose
//! constraints it is assigned. The strongly connected components of that dependence are the groups of L. V. Assur
//! (1914), and they are the same for every possible assignment (A. L. Dulmage, N. S. Mendelsohn, "Coverings of
//! bipartite graphs", Canadian Journal of Mathematics 10, 1958).
//!
//! Three constraints to a link are not enough: two links joined twice are rigid together with one constraint too many,
//! though an assignment of three to each may exist. Constraints between bodies in the plane are independent only if any
//! `n` bodies share at most `3 n - 3` of them (T.-S. Tay, "Rigidity of multi-graphs I", Journal of Combinatorial Theory
//! B 36, 1984). So a constraint is taken only if four more could be assigned to its two ends, one more than a rigid
//! body needs: the (3, 3) pebble game of A. Lee and I. Streinu, "Pebble game algorithms and sparse graphs", Discrete
//! Mathematics 308, 2008. All bodies of known motion count as one body.
//!
//! A pin through three or more links is a body of its own, a point with two degrees of freedom, which each of these links
//! joins by two constraints: `n` bodies and `p` such points share at most `3 n + 2 p - 3`. To replace it by joints of two
//! links each would say beforehand which link is solved first, and so join groups that do not belong together: a link
//! whose partner at the pin is found later seems to need that partner. With the pin as a point the groups are the finest
//! ones, and it is their order that says which links meet at the pin first.
//!
//! The count holds for general dimensions. Special ones (parallel slides, equal and parallel cranks) show only in the
//! solving, and mechanisms that move only because of them count as over-constrained: a wedge between three slides, a
//! double parallelogram.

use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};

/// Degrees of freedom of a link in the plane.
const MOTIONS: usize = 3;

/// Degrees of freedom of a point in the plane.
const MOTIONS_OF_PIN: usize = 2;

/// A joint between two bodies, by its number of constraints.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Edge {
    /// The number of constraints it supplies.
    pub constraints: usize,
    /// The two bodies joined: the index of a link of unknown motion or of a pin, or `None` for a body of known motion.
    pub ends: [Option<usize>; 2],
    /// Other links of unknown motion without which its constraints say nothing, as the carrier of two wheels that mesh.
    pub related: Vec<usize>,
}

impl Edge {
    /// A pin.
    #[must_use]
    pub fn pin(ends: [Option<usize>; 2]) -> Edge {
        Edge { constraints: 2, ends, related: Vec::new() }
    }
}

/// The groups that the links form, or why they form none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Structure {
    /// Assur groups, each after all groups on which it hangs; of groups that can be solved at the same time, the one
    /// with the smallest link index first. Every link and every pin is in exactly one of them; a pin that belongs to a link
    /// of a group before is alone.
    Groups(Vec<Component>),
    /// Some links have too few or too many constraints. Lists are in ascending order.
    Misfit {
        /// Links that can move though all drives are given.
        under: Vec<usize>,
        /// The number of degrees of freedom left, which is that of missing drives.
        missing: usize,
        /// Links of the over-constrained part: each belongs to a smallest set of links and joints with a constraint too
        /// many.
        over: Vec<usize>,
        /// The number of constraints too many.
        surplus: usize,
    },
}

/// An Assur group: links and pins that can be solved only together, given the groups before it. It has three constraints
/// for each link and two for each pin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Component {
    /// Indices of links, ascending.
    pub links: Vec<usize>,
    /// Indices of pins, ascending.
    pub pins: Vec<usize>,
    /// Indices of the joints among these, and between them and known bodies or earlier groups, ascending.
    pub joints: Vec<usize>,
}

/// The Assur groups of `links` links of unknown motion in an order in which they can be solved, or why they form none.
/// The bodies after the links are `pins` pins, each of three or more links, which join the pin by two constraints each.
///
/// The order of `edges` and of the ends of an edge does not change the groups. An edge between two known bodies or from
/// a link to itself belongs to no group. The time grows at most with links times joints.
///
/// # Panics
/// If an edge names a body that is not below `links + pins`.
pub fn structure(links: usize, pins: usize, edges: &[Edge]) -> Structure {
    let known = links + pins;
    let mut assignment = Assignment::new(links, pins);
    let mut over = BTreeSet::new();
    let mut surplus = 0;
    for (joint, edge) in edges.iter().enumerate() {
        assert!(
            edge.ends.iter().flatten().all(|&body| body < known),
            "joint {joint} names a body not below {known}: {edge:?}"
        );
        let ends = edge.ends.map(|end| end.unwrap_or(known));
        if ends[0] == ends[1] {
            continue;
        }
        for _ in 0..edge.constraints {
            if !assignment.take(joint, ends) {
                surplus += 1;
                over.extend(assignment.reach(&ends));
            }
        }
    }
    assignment.clear(known);

    let missing: usize = assignment.room[..known].iter().sum();
    if missing == 0 && surplus == 0 {
        return Structure::Groups(groups(links, pins, &assignment.taken, edges));
    }
    let of_links = |bodies: BTreeSet<usize>| bodies.into_iter().filter(|&body| body < links).collect();
    Structure::Misfit { under: of_links(assignment.movable()), missing, over: of_links(over), surplus }
}

/// A constraint of `joint`, assigned to the body `to`, which therefore depends on the body `from`.
struct Constraint {
    joint: usize,
    to: usize,
    from: usize,
}

/// Constraints assigned to bodies, three to each link and two to each pin at most. The last body stands for all known bodies.
struct Assignment {
    taken: Vec<Constraint>,
    /// For each body, the constraints assigned to it, as indices into `taken`.
    assigned: Vec<Vec<usize>>,
    /// For each body, the number of constraints that could still be assigned: the free pebbles of Lee & Streinu.
    room: Vec<usize>,
}

impl Assignment {
    fn new(links: usize, pins: usize) -> Self {
        let mut room = vec![MOTIONS; links];
        room.resize(links + pins, MOTIONS_OF_PIN);
        room.push(MOTIONS);
        Self { taken: Vec::new(), assigned: vec![Vec::new(); room.len()], room }
    }

    /// Takes a constraint between `ends` and returns true, if it is independent of those taken before. If it is not,
    /// all free pebbles that `ends` can reach have been moved to them, so that [`Self::reach`] from `ends` is the
    /// smallest rigid set with both (Lee & Streinu).
    fn take(&mut self, joint: usize, ends: [usize; 2]) -> bool {
        let [first, second] = ends;
        while self.room[first] + self.room[second] <= MOTIONS {
            if !self.make_room(first, second) && !self.make_room(second, first) {
                return false;
            }
        }
        // More than three are free at both ends, at most three at either, and two bodies with two do not meet: each end has one.
        self.room[first] -= 1;
        self.assigned[first].push(self.taken.len());
        self.taken.push(Constraint { joint, to: first, from: second });
        true
    }

    /// Passes every constraint of `body` on to others. This is possible for any one body, as the whole keeps three
    /// degrees of freedom.
    fn clear(&mut self, body: usize) {
        while self.make_room(body, body) {}
        debug_assert!(self.assigned[body].is_empty(), "the whole keeps three free motions");
    }

    /// Passes one constraint of `body` along an augmenting path to a body with room, but not to `keep`. False if there
    /// is no such path.
    fn make_room(&mut self, body: usize, keep: usize) -> bool {
        let mut arrived_by = vec![None; self.room.len()];
        let mut pending = vec![body];
        while let Some(here) = pending.pop() {
            for &constraint in &self.assigned[here] {
                let next = self.taken[constraint].from;
                if next == body || arrived_by[next].is_some() {
                    continue;
                }
                arrived_by[next] = Some(constraint);
                if next != keep && self.room[next] > 0 {
                    self.room[next] -= 1;
                    self.pass_back(next, &arrived_by);
                    self.room[body] += 1;
                    return true;
                }
                pending.push(next);
            }
        }
        false
    }

    /// Reverses every constraint on the path by which `end` was reached.
    fn pass_back(&mut self, end: usize, arrived_by: &[Option<usize>]) {
        let mut here = end;
        while let Some(index) = arrived_by[here] {
            let constraint = &mut self.taken[index];
            let before = constraint.to;
            (constraint.to, constraint.from) = (here, before);
            self.assigned[before].retain(|&other| other != index);
            self.assigned[here].push(index);
            here = before;
        }
    }

    /// The bodies `starts` and all bodies on which they depend.
    fn reach(&self, starts: &[usize]) -> BTreeSet<usize> {
        closure(starts, |here| self.assigned[here].iter().map(|&constraint| self.taken[constraint].from))
    }

    /// The bodies with room and all that depend on them: the alternating paths of Dulmage & Mendelsohn. Requires that no
    /// constraint is assigned to the known body.
    fn movable(&self) -> BTreeSet<usize> {
        let mut dependents = vec![Vec::new(); self.room.len()];
        for constraint in &self.taken {
            dependents[constraint.from].push(constraint.to);
        }
        let known = self.room.len() - 1;
        let free: Vec<usize> = (0..known).filter(|&body| self.room[body] > 0).collect();
        closure(&free, |here| dependents[here].iter().copied())
    }
}

/// These bodies, and all to which `next` leads from them, directly or over others.
fn closure<N: Iterator<Item = usize>>(starts: &[usize], next: impl Fn(usize) -> N) -> BTreeSet<usize> {
    let mut reached: BTreeSet<usize> = starts.iter().copied().collect();
    let mut pending = starts.to_vec();
    while let Some(here) = pending.pop() {
        pending.extend(next(here).filter(|&next| reached.insert(next)));
    }
    reached
}

/// The strongly connected components of the dependence between bodies, in solving order. Every link has three
/// constraints and every pin two.
fn groups(links: usize, pins: usize, taken: &[Constraint], edges: &[Edge]) -> Vec<Component> {
    let known = links + pins;
    let between_bodies = || {
        let needed = |constraint: &Constraint| {
            let (to, related) = (constraint.to, &edges[constraint.joint].related);
            related.iter().copied().chain([constraint.from]).map(move |from| (to, from)).collect::<Vec<_>>()
        };
        taken.iter().flat_map(needed).filter(|(to, from)| *from != known && to != from)
    };

    let mut dependence = DiGraph::<(), ()>::from_edges(between_bodies().map(|(to, from)| (to as u32, from as u32)));
    while dependence.node_count() < known {
        dependence.add_node(());
    }

    // Kosaraju, not Tarjan: petgraph's Tarjan is recursive, and a long chain of groups could exhaust the stack.
    let mut components: Vec<Component> = kosaraju_scc(&dependence)
        .into_iter()
        .map(|nodes| {
            let mut bodies: Vec<usize> = nodes.into_iter().map(NodeIndex::index).collect();
            bodies.sort_unstable();
            let pins = bodies.split_off(bodies.partition_point(|&body| body < links));
            let pins = pins.into_iter().map(|pin| pin - links).collect();
            Component { links: bodies, pins, joints: Vec::new() }
        })
        .collect();
    // By smallest link, so that a group's index is its rank among the groups that can be solved at the same time. Pins
    // that are alone come first: they are known as soon as their link is, and no group waits for them.
    components.sort_unstable_by_key(|component| (component.links.first().copied(), component.pins.first().copied()));

    let mut group_of = vec![0; known];
    for (group, component) in components.iter().enumerate() {
        let pins = component.pins.iter().map(|pin| links + pin);
        component.links.iter().copied().chain(pins).for_each(|body| group_of[body] = group);
    }
    for constraint in taken {
        components[group_of[constraint.to]].joints.push(constraint.joint);
    }
    for component in &mut components {
        // A joint with constraints assigned to both its bodies makes them depend on each other, so they are in one
        // group.
        component.joints.sort_unstable();
        component.joints.dedup();
        debug_assert_eq!(
            component.joints.iter().map(|&joint| edges[joint].constraints).sum::<usize>(),
            MOTIONS * component.links.len() + MOTIONS_OF_PIN * component.pins.len()
        );
    }

    let mut dependents = vec![Vec::new(); components.len()];
    let mut waits_for = vec![0_usize; components.len()];
    for (to, from) in between_bodies() {
        let (group, before) = (group_of[to], group_of[from]);
        if group != before {
            dependents[before].push(group);
            waits_for[group] += 1;
        }
    }
    let mut ready: BinaryHeap<Reverse<usize>> =
        (0..components.len()).filter(|&group| waits_for[group] == 0).map(Reverse).collect();
    let mut order = Vec::with_capacity(components.len());
    while let Some(Reverse(group)) = ready.pop() {
        order.push(std::mem::take(&mut components[group]));
        for &next in &dependents[group] {
            waits_for[next] -= 1;
            if waits_for[next] == 0 {
                ready.push(Reverse(next));
            }
        }
    }
    order
}
