use super::closing::places;
use super::frames::{Frames, driven_position};
use super::modes::{Assembler, NoMode};
use super::search::{Rough, chord};
use super::{Assembly, Pose};
use crate::geometry::{Placement, Vector, span};
use crate::mechanism::{BodyId, Class, Joint, Mechanism, PointId, Role};
use crate::scene::Near;
use crate::words::{Language, Wording};

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
    pub assembly: Assembly,
    pub frames: Vec<(BodyId, Placement)>,
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

    /// The rough places by which an assembly is chosen.
    pub(super) fn rough(&self) -> &Rough {
        &self.assembler.rough
    }

    /// The modes of a group, in their order; all groups on which it hangs must be down, and it must not.
    pub(super) fn modes(&mut self, group: usize) -> Result<Vec<Placed>, NoMode> {
        let found = self.assembler.modes(group, &self.down.frames, &self.down.slides)?;
        let modes = found.len();
        let joints = self.mechanism.groups[group].joints.iter();
        let sliders: Vec<usize> = joints.filter_map(|&j| self.mechanism.joint(j).slider).map(|id| id.0).collect();
        let placed = found.into_iter().enumerate().map(|(index, assembled)| Placed {
            group,
            assembly: Assembly { mode: index + 1, modes },
            slides: sliders.iter().map(|&id| (id, assembled.slides[id])).collect(),
            frames: assembled.frames.set,
        });
        Ok(placed.collect())
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
        let (rough, frames) = (self.rough(), &whole.frames);
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
        placed.slides.iter().for_each(|&(id, position)| self.slides[id] = position);
        self.assemblies[placed.group] = Some(placed.assembly);
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
            assemblies: self.assemblies,
            warnings: search_warnings(mechanism.for_positions(), Wording::default().language).collect(),
        }
    }
}

/// Warnings for groups whose assembly modes come from a search, not from a polynomial. A group without a loop has one
/// mode.
pub(crate) fn search_warnings(mechanism: &Mechanism, language: &Language) -> impl Iterator<Item = String> {
    let groups = mechanism.groups.iter();
    let higher = groups.filter(|group| group.class == Class::Higher && !group.loops.is_empty());
    higher.map(|group| language.modes_searched(&group.link_names(mechanism)))
}
