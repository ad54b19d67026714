use super::closing::{Assembled, places};
use super::frames::{Frames, driven_position};
use super::modes::{Assembler, NoMode};
use super::says;
use super::search::{Rough, chord};
use super::wheels;
use super::{Assembly, Pose};
use crate::geometry::{Placement, Vector, span};
use crate::mechanism::{BodyId, Class, Joint, Mechanism, PointId, Role};
use crate::message::Message;
use crate::scene::Near;

/// The assemblies of a mechanism as a tree: each mode of a group leaves the groups after it modes of their own.
///
/// Groups are put down and taken away one after another; [`Tree::modes`] gives what the next group has then.
pub(super) struct Tree<'a> {
    pub mechanism: &'a Mechanism,
    /// Finds modes, and counts the work.
    pub assembler: Assembler<'a>,
    /// The bodies of known position, and the groups that are down.
    pub down: WholeAssembly,
    /// The groups in the order of the tree.
    pub order: Order,
}

/// A group in one of its modes.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub group: usize,
    /// Its mode; none where the group may move at fixed drives.
    pub assembly: Option<Assembly>,
    pub frames: Vec<(BodyId, Placement)>,
    /// Angles of its wheels, with their whole turns.
    turned: Vec<(BodyId, f64)>,
    /// The positions of its sliders.
    slides: Vec<(usize, f64)>,
}

/// What can be solved by itself once the groups before it are down.
#[derive(Clone, Debug)]
pub(super) struct Order {
    /// Groups that share nothing, with all that hangs on them.
    pub roots: Vec<usize>,
    /// By group: the groups that share nothing once it is down, each with all that hangs on it.
    pub next: Vec<Vec<usize>>,
}

impl<'a> Tree<'a> {
    /// The tree of a mechanism given by lengths.
    pub(super) fn new(mechanism: &'a Mechanism, near: &Near) -> Tree<'a> {
        let frames = Frames::known(mechanism);
        let rough = Rough::new(mechanism, near);
        let order = Order::new(mechanism, !rough.angles.is_empty());
        let assembler = Assembler::new(mechanism, &frames, rough);
        let slides = mechanism.sliders.iter().map(driven_position).collect();
        let assemblies = vec![None; mechanism.groups.len()];
        Tree { mechanism, assembler, down: WholeAssembly { frames, slides, assemblies }, order }
    }

    /// The modes of a group, in their order, and at last one assembly in which it may move, if there is any; all groups on which it hangs must be
    /// down, and it must not.
    pub(super) fn modes(&mut self, group: usize) -> Result<Vec<Placed>, NoMode> {
        let found = self.assembler.modes(group, &self.down.frames, &self.down.slides)?;
        let (modes, may_move) = (found.modes.len(), found.moving.is_some());
        let number = |index| Assembly { mode: index + 1, modes, at_most: found.at_most, may_move };
        let joints = self.mechanism.groups[group].joints.iter();
        let sliders: Vec<usize> = joints.filter_map(|&j| self.mechanism.joint(j).slider).map(|id| id.0).collect();
        let placed = |assembly, assembled: Assembled| Placed {
            group,
            assembly,
            slides: sliders.iter().map(|&id| (id, assembled.slides[id])).collect(),
            turned: wheels::degrees(&assembled, &self.mechanism.groups[group].links),
            frames: assembled.frames.set,
        };
        let standing =
            found.modes.into_iter().enumerate().map(|(index, assembled)| placed(Some(number(index)), assembled));
        Ok(standing.chain(found.moving.into_iter().map(|assembled| placed(None, assembled))).collect())
    }

    /// The modes of a group that stand at fixed drives.
    fn standing(&mut self, group: usize) -> Result<Vec<Placed>, NoMode> {
        let mut modes = self.modes(group)?;
        modes.retain(|placed| placed.assembly.is_some());
        if modes.is_empty() { Err(NoMode::Moves) } else { Ok(modes) }
    }

    /// Takes a group away.
    pub(super) fn take(&mut self, group: usize) {
        self.down.frames.forget(&self.mechanism.groups[group].bodies);
    }

    /// Takes all groups away.
    pub(super) fn clear(&mut self) {
        self.mechanism.groups.iter().for_each(|group| self.down.frames.forget(&group.bodies));
    }

    /// The assembly of the whole mechanism with these groups.
    pub(super) fn whole<'p>(&self, placed: impl IntoIterator<Item = &'p Placed>) -> WholeAssembly {
        let mut whole = self.down.clone();
        placed.into_iter().for_each(|group| whole.put(group));
        whole
    }

    /// Root mean square of an assembly's distances from the rough places; an angle counts as its chord on a circle whose
    /// radius is the mechanism's size.
    pub(super) fn distance(&self, whole: &WholeAssembly) -> f64 {
        let (rough, frames) = (&self.assembler.rough, &whole.frames);
        let (points, _) = places(self.mechanism, frames);
        let size = span(points.iter().copied());
        let placed = |p: PointId| {
            let mut links = self.mechanism.links();
            links.any(|(id, body)| frames.of(id).is_some() && body.points.contains(&p))
        };
        let mut sum = 0.0;
        for (p, rough) in rough.points.iter().filter(|(p, _)| placed(*p)) {
            sum += (points[p.0] - rough).norm_squared();
        }
        for (link, angle) in &rough.angles {
            if let Some(frame) = frames.of(*link) {
                let chord = chord(frame, *angle) * size;
                sum += chord * chord;
            }
        }
        (sum / rough.count().max(1) as f64).sqrt()
    }
}

impl Order {
    /// The order by which groups hang on each other; each group comes after all on which it hangs.
    ///
    /// With rough angles each hangs on the one before it: an angle's weight depends on the size of the whole, so that no
    /// part stands by itself.
    fn new(mechanism: &Mechanism, has_angles: bool) -> Order {
        let count = mechanism.groups.len();
        let mut group_of = vec![None; mechanism.bodies.len()];
        for (index, group) in mechanism.groups.iter().enumerate() {
            group.bodies.iter().for_each(|body| group_of[body.0] = Some(index));
        }
        let mut hang_on = vec![Vec::new(); count];
        for (index, group) in mechanism.groups.iter().enumerate() {
            let joints = group.joints.iter().map(|&joint| mechanism.joint(joint));
            let related = joints.clone().flat_map(Joint::related_bodies);
            let bodies = joints.flat_map(|joint| joint.bodies).chain(related);
            let groups = bodies.filter_map(|body| group_of[body.0]);
            groups.filter(|&other| other < index).for_each(|other| hang_on[other].push(index));
            if has_angles && index > 0 {
                hang_on[index - 1].push(index);
            }
        }
        // From the last group on: a group joins the parts that hang on it, and becomes the first of the joined part.
        let mut part: Vec<usize> = (0..count).collect();
        let mut is_root = vec![true; count];
        let mut next = vec![Vec::new(); count];
        for group in (0..count).rev() {
            for &hanging in &hang_on[group] {
                let first = first_of(&mut part, hanging);
                if first != group {
                    part[first] = group;
                    is_root[first] = false;
                    next[group].push(first);
                }
            }
            next[group].sort_unstable();
        }
        Order { roots: (0..count).filter(|&group| is_root[group]).collect(), next }
    }
}

/// The first group of the part to which `group` belongs.
fn first_of(part: &mut [usize], mut group: usize) -> usize {
    while part[group] != group {
        part[group] = part[part[group]];
        group = part[group];
    }
    group
}

/// An assembly of the whole mechanism, or of the groups that are down.
#[derive(Clone, Debug)]
pub(super) struct WholeAssembly {
    pub frames: Frames,
    pub slides: Vec<f64>,
    /// By group: the number of its assembly mode.
    pub assemblies: Vec<Option<Assembly>>,
}

impl WholeAssembly {
    /// Puts a group down.
    pub(super) fn put(&mut self, placed: &Placed) {
        self.frames.settle(&placed.frames);
        placed.turned.iter().for_each(|&(body, degrees)| self.frames.set_degrees(body, degrees));
        placed.slides.iter().for_each(|&(id, position)| self.slides[id] = position);
        self.assemblies[placed.group] = placed.assembly;
    }

    /// The pose of `mechanism`. It may have fewer bodies and sliders than its [`Mechanism::for_positions`], to which
    /// this assembly belongs.
    pub(super) fn pose(self, mechanism: &Mechanism) -> Pose {
        let (points, guides) = places(mechanism, &self.frames);
        let named = |id: usize| !matches!(mechanism.bodies[id].role, Role::Ground | Role::Carrier { .. });
        let axes = (0..mechanism.bodies.len()).map(|id| {
            let frame = self.frames.of(BodyId(id)).filter(|_| named(id))?;
            Some(frame.rotation * Vector::x())
        });
        Pose {
            axes: axes.collect(),
            points,
            guides,
            slides: self.slides[..mechanism.sliders.len()].iter().copied().map(Some).collect(),
            warnings: search_warnings(mechanism.for_positions(), &self.assemblies).collect(),
            assemblies: self.assemblies,
        }
    }
}

/// Warnings for groups whose assembly modes come from a search, not from a polynomial, unless all that there can be have been found; and for groups that may
/// move at fixed drives. A group without a loop has one mode.
pub(crate) fn search_warnings(mechanism: &Mechanism, assemblies: &[Option<Assembly>]) -> impl Iterator<Item = Message> {
    let groups = mechanism.groups.iter().enumerate();
    let higher = groups.filter(|(_, group)| group.class == Class::Higher && !group.loops.is_empty());
    higher.flat_map(|(index, group)| {
        let links = group.link_names(mechanism);
        let (searched, may_move) = match assemblies.get(index).copied().flatten() {
            Some(Assembly { modes, at_most: Some(most), may_move, .. }) => {
                (((modes as u64) < most).then(|| says::searched_of(&links, modes, most)), may_move)
            }
            _ => (Some(says::searched(&links)), false),
        };
        searched.into_iter().chain(may_move.then(|| says::may_move(&links)))
    })
}

/// All assemblies of a mechanism, one after another in the order of their numbers: that of the first group's modes,
/// then of the second's, and so on.
pub(super) struct Listing<'t, 'a> {
    tree: &'t mut Tree<'a>,
    most_work: usize,
    /// By group that is down, or comes next: its modes, and the index of the one after that which is down.
    levels: Vec<(Vec<Placed>, usize)>,
    /// Of the groups that could not be put down, the one farthest from the first: its index, and the reason in the first
    /// assembly of those before it.
    pub failure: Option<(usize, NoMode)>,
    /// Whether the work became too much.
    pub is_stopped: bool,
}

impl<'t, 'a> Listing<'t, 'a> {
    /// It ends after so much further work as [`Assembler::work`](super::modes::Assembler) counts it, although there may be more assemblies.
    pub(super) fn new(tree: &'t mut Tree<'a>, most_work: usize) -> Listing<'t, 'a> {
        tree.clear();
        let most_work = tree.assembler.work + most_work;
        let mut listing = Listing { tree, most_work, levels: Vec::new(), failure: None, is_stopped: false };
        listing.enter(0);
        listing
    }

    /// Finds the modes of the next group.
    fn enter(&mut self, group: usize) {
        match self.tree.standing(group) {
            Ok(modes) => self.levels.push((modes, 0)),
            Err(no_mode) => {
                if self.failure.as_ref().is_none_or(|(deepest, _)| group > *deepest) {
                    self.failure = Some((group, no_mode));
                }
            }
        }
    }
}

impl Iterator for Listing<'_, '_> {
    type Item = WholeAssembly;

    fn next(&mut self) -> Option<WholeAssembly> {
        let groups = self.tree.mechanism.groups.len();
        loop {
            if self.tree.assembler.work > self.most_work {
                self.is_stopped = true;
                return None;
            }
            let depth = self.levels.len();
            let (modes, next) = self.levels.last_mut()?;
            let Some(placed) = modes.get(*next) else {
                self.tree.take(depth - 1);
                self.levels.pop();
                continue;
            };
            *next += 1;
            self.tree.down.put(placed);
            if depth == groups {
                let down = self.levels.iter().filter_map(|(modes, next)| modes.get(next.checked_sub(1)?));
                return Some(self.tree.whole(down));
            }
            self.enter(depth);
        }
    }
}

/// How many assemblies a mechanism has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// How many were counted.
    pub number: u64,
    /// Whether these are all; else there are at least so many. Of groups of higher class those count that a search
    /// finds.
    pub is_exact: bool,
}

impl Count {
    /// It in a message.
    pub(super) fn told(self) -> Message {
        if self.is_exact { self.number.into() } else { says::at_least(self.number) }
    }
}

/// Counts all assemblies without keeping any, with at most so much further work as [`Assembler::work`](super::modes::Assembler) counts it.
///
/// Parts of the mechanism that share nothing but groups that are down are counted one by one, and their numbers
/// multiplied.
pub(super) fn counted(tree: &mut Tree<'_>, most_work: usize) -> Count {
    tree.clear();
    let most_work = tree.assembler.work.saturating_add(most_work);
    let parts = tree.order.roots.clone();
    // The whole mechanism is a part in a mode of its own.
    let mut levels = vec![Level { group: None, parts, modes: Vec::new().into_iter(), total: 0, trial: Some((1, 0)) }];
    let mut is_exact = true;
    let number = loop {
        let Some(level) = levels.last_mut() else {
            break 0;
        };
        // Where the work is too much, what has been counted of each part still counts.
        is_exact = is_exact && tree.assembler.work <= most_work;
        match level.trial {
            Some((product, solved)) if product == 0 || solved == level.parts.len() => {
                level.total = level.total.saturating_add(product);
                level.trial = None;
            }
            Some((_, solved)) if is_exact => {
                let group = level.parts[solved];
                let modes = tree.standing(group).unwrap_or_default();
                let parts = tree.order.next[group].clone();
                levels.push(Level { group: Some(group), parts, modes: modes.into_iter(), total: 0, trial: None });
            }
            Some(_) => level.trial = None,
            None => match level.modes.next().filter(|_| is_exact) {
                Some(placed) => {
                    tree.down.put(&placed);
                    level.trial = Some((1, 0));
                }
                None => {
                    let (number, group) = (level.total, level.group);
                    let Some(group) = group else {
                        break number;
                    };
                    tree.take(group);
                    levels.pop();
                    if let Some((product, solved)) = levels.last_mut().and_then(|before| before.trial.as_mut()) {
                        *product = product.saturating_mul(number);
                        *solved += 1;
                    }
                }
            },
        }
    };
    Count { number, is_exact: is_exact && number < u64::MAX }
}

/// A part of the mechanism: a group with all that hangs on it.
struct Level {
    /// The group; none for the whole mechanism.
    group: Option<usize>,
    /// The first groups of the parts that hang on it.
    parts: Vec<usize>,
    /// The group's modes that have not been counted.
    modes: std::vec::IntoIter<Placed>,
    /// The number of assemblies with the modes that have been counted.
    total: u64,
    /// With the mode that is being counted: the product of the numbers of the parts that are solved, and how many are.
    trial: Option<(u64, usize)>,
}
