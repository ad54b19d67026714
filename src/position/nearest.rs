use super::closing::places;
use super::search::chord;
use super::tree::{Placed, Tree, WholeAssembly};
use crate::geometry::{BoundingBox, Point};
use crate::mechanism::{BodyId, PointId};

/// Most work, as [`Assembler::work`](super::modes::Assembler) counts it, before the nearest assembly found so far is taken without a proof: that of
/// trying all assemblies of a chain of 18 dyads.
const MOST_WORK: usize = 12_000_000;

/// The assembly nearest to the rough places.
pub(super) struct Nearest {
    pub whole: WholeAssembly,
    /// Whether it was shown that no other one is nearer.
    pub is_proven: bool,
}

/// The assembly nearest to the rough places, of several equally near ones the first; `None` if there is none, or none
/// was found.
///
/// Branch and bound. Groups are put down one after another, each in its nearest mode first; the squared distances of
/// what is down are a lower bound of those of the whole, so that a mode is left out, with all that could hang on it,
/// where this bound exceeds the nearest assembly found so far. Parts of the mechanism that share nothing but groups
/// that are down are solved one by one (R. Dechter, R. Mateescu, "AND/OR search spaces for graphical models",
/// Artificial Intelligence 171, 2007).
pub(super) fn nearest(tree: &mut Tree<'_>) -> Option<Nearest> {
    let wishes = Wishes::new(tree);
    let mut levels = vec![Level::whole(tree, wishes.laid)];
    // Where the work is too much, the first assembly is taken everywhere.
    let mut is_hasty;
    let found = loop {
        is_hasty = tree.assembler.work > MOST_WORK;
        if tree.assembler.work > 2 * MOST_WORK {
            return None;
        }
        let level = levels.last_mut()?;
        if let Some(trial) = &level.trial {
            match level.parts.get(trial.solved).copied() {
                Some(group) => match level.part(trial, tree, &wishes, group) {
                    Some(part) => levels.push(part),
                    None => level.trial = None,
                },
                None => level.keep_trial(),
            }
        } else if !level.try_next(tree, is_hasty) {
            let Level { group, best, .. } = levels.pop()?;
            match group {
                Some(group) => tree.take(group),
                None => break best,
            }
            levels.last_mut()?.add(best);
        }
    };
    found.map(|best| Nearest { whole: tree.whole(&best.placed), is_proven: !is_hasty })
}

/// A part of the mechanism: a group in one of its modes after another, with the nearest assembly of all that hangs on
/// it.
struct Level {
    /// The group; none for the whole mechanism.
    group: Option<usize>,
    /// The first groups of the parts that hang on it.
    parts: Vec<usize>,
    /// Squared distances of all that is down besides this part.
    base: f64,
    /// The sum above which an assembly of the whole is of no use.
    limit: f64,
    /// The group's modes that have not been tried, the nearest first.
    choices: std::vec::IntoIter<Choice>,
    trial: Option<Trial>,
    best: Option<Best>,
}

/// A mode of a group.
struct Choice {
    /// Its squared distances from the rough places.
    cost: f64,
    laid: Laid,
    placed: Placed,
}

/// A mode that is being tried.
struct Trial {
    /// Squared distances of the group, and of its parts that are solved.
    cost: f64,
    /// The mode's number.
    mode: usize,
    laid: Laid,
    own: Option<Placed>,
    /// Number of parts solved, and their groups.
    solved: usize,
    placed: Vec<Placed>,
}

/// The nearest assembly of a part so far.
struct Best {
    cost: f64,
    mode: usize,
    placed: Vec<Placed>,
}

/// What decides the weight of rough angles, which hang on the size of the whole.
#[derive(Clone, Copy, Default)]
pub(super) struct Laid {
    pub extent: BoundingBox,
    /// The sum of squared chords at radius 1.
    pub chords: f64,
}

impl Laid {
    fn cost(&self) -> f64 {
        let size = if self.chords > 0.0 { self.extent.size() } else { 0.0 };
        self.chords * size * size
    }
}

impl Level {
    /// The whole mechanism.
    fn whole(tree: &Tree<'_>, laid: Laid) -> Level {
        let trial = Trial { cost: 0.0, mode: 0, laid, own: None, solved: 0, placed: Vec::new() };
        Level {
            group: None,
            parts: tree.order.roots.clone(),
            base: 0.0,
            limit: f64::INFINITY,
            choices: Vec::new().into_iter(),
            trial: Some(trial),
            best: None,
        }
    }

    /// A part of what is being tried: a group with all that hangs on it; none if the group has no mode.
    fn part(&self, trial: &Trial, tree: &mut Tree<'_>, wishes: &Wishes, group: usize) -> Option<Level> {
        let modes = tree.modes(group).ok()?;
        let mut choices: Vec<Choice> = modes.into_iter().map(|p| wishes.choice(tree, trial.laid, p)).collect();
        choices.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        let best = self.best.as_ref().map_or(f64::INFINITY, |best| self.base + best.cost);
        Some(Level {
            group: Some(group),
            parts: tree.order.next[group].clone(),
            base: self.base + trial.cost,
            limit: self.limit.min(best),
            choices: choices.into_iter(),
            trial: None,
            best: None,
        })
    }

    /// Whether a mode with at least these squared distances cannot be the one: of equally near ones the first is taken.
    fn is_useless(&self, cost: f64, mode: usize) -> bool {
        let best = self.best.as_ref();
        let is_worse = best.is_some_and(|best| cost > best.cost || cost == best.cost && mode > best.mode);
        is_worse || self.base + cost > self.limit
    }

    /// Puts down the nearest mode that has not been tried; false if none is left that could be the one.
    fn try_next(&mut self, tree: &mut Tree<'_>, is_hasty: bool) -> bool {
        let Some(Choice { cost, laid, placed }) = self.choices.next() else {
            return false;
        };
        let mode = placed.assembly.map_or(usize::MAX, |assembly| assembly.mode);
        // The modes after it are no nearer.
        if is_hasty && self.best.is_some() || self.is_useless(cost, mode) {
            return false;
        }
        tree.down.put(&placed);
        self.trial = Some(Trial { cost, mode, laid, own: Some(placed), solved: 0, placed: Vec::new() });
        true
    }

    /// Adds the nearest assembly of a part to what is being tried; without one the trial is over.
    fn add(&mut self, best: Option<Best>) {
        let (Some(mut trial), Some(best)) = (self.trial.take(), best) else {
            return;
        };
        trial.cost += best.cost;
        trial.solved += 1;
        match trial.placed.is_empty() {
            true => trial.placed = best.placed,
            false => trial.placed.extend(best.placed),
        }
        if !self.is_useless(trial.cost, trial.mode) {
            self.trial = Some(trial);
        }
    }

    /// Keeps what is being tried, all parts of which are solved, if it is the nearest.
    fn keep_trial(&mut self) {
        let Some(Trial { cost, mode, own, mut placed, .. }) = self.trial.take() else {
            return;
        };
        if !self.is_useless(cost, mode) {
            placed.extend(own);
            self.best = Some(Best { cost, mode, placed });
        }
    }
}

/// What rough places and angles ask of the groups.
pub(super) struct Wishes {
    /// By group: points with rough places, each in the frame of a body, and the rough place.
    points: Vec<Vec<(BodyId, Point, Point)>>,
    /// By group: links with rough angles, in degrees.
    angles: Vec<Vec<(BodyId, f64)>>,
    /// What is down before the first group.
    laid: Laid,
}

impl Wishes {
    fn new(tree: &Tree<'_>) -> Wishes {
        let (mechanism, rough) = (tree.mechanism, &tree.assembler.rough);
        let mut group_of = vec![None; mechanism.bodies.len()];
        for (index, group) in mechanism.groups.iter().enumerate() {
            group.bodies.iter().for_each(|body| group_of[body.0] = Some(index));
        }
        let holders = mechanism.holders();
        let mut wishes = Wishes {
            points: vec![Vec::new(); mechanism.groups.len()],
            angles: vec![Vec::new(); mechanism.groups.len()],
            laid: Laid::default(),
        };
        for &(point, place) in &rough.points {
            // A point of a body of known position is where it is.
            if holders[point.0].iter().any(|body| tree.down.frames.of(*body).is_some()) {
                continue;
            }
            let first = holders[point.0].iter().filter_map(|body| group_of[body.0]).min();
            let bodies = first.iter().flat_map(|group| &mechanism.groups[*group].bodies);
            let held = { bodies }.find_map(|body| Some((*body, mechanism.body(*body).local_of(point)?)));
            if let (Some(group), Some((body, local))) = (first, held) {
                wishes.points[group].push((body, local, place));
            }
        }
        for &(link, angle) in &rough.angles {
            if let Some(group) = group_of[link.0] {
                wishes.angles[group].push((link, angle));
            }
        }
        let (places, _) = places(mechanism, &tree.down.frames);
        let is_sought = |point: PointId| holders[point.0].iter().any(|body| group_of[body.0].is_some());
        if !rough.angles.is_empty() {
            let known = mechanism.point_ids().filter(|point| !is_sought(*point));
            wishes.laid.extent = BoundingBox::of(known.map(|point| places[point.0]));
        }
        wishes
    }

    /// A group's mode with its squared distances; an angle counts as in [`Tree::distance`], with the size
    /// of what is down.
    fn choice(&self, tree: &Tree<'_>, before: Laid, placed: Placed) -> Choice {
        let frame = |body: BodyId| placed.frames.iter().find(|(other, _)| *other == body).map(|(_, frame)| frame);
        let distance =
            |&(body, local, place): &(BodyId, Point, Point)| Some((frame(body)? * local - place).norm_squared());
        let mut cost: f64 = self.points[placed.group].iter().filter_map(distance).sum();
        let mut laid = before;
        if !tree.assembler.rough.angles.is_empty() {
            for &(link, angle) in &self.angles[placed.group] {
                let chord = frame(link).map_or(0.0, |frame| chord(frame, angle));
                laid.chords += chord * chord;
            }
            let points = placed
                .frames
                .iter()
                .flat_map(|(body, frame)| tree.mechanism.body(*body).local.iter().map(move |local| frame * local));
            laid.extent = before.extent.with(points);
            cost += (laid.cost() - before.cost()).max(0.0);
        }
        Choice { cost, laid, placed }
    }
}
