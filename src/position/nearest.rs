use super::closing::{BoundingBox, places};
use super::rough::{Rough, chord};
use super::tree::{Placed, Tree, WholeAssembly};
use crate::geometry::Point;
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
pub(super) fn nearest(tree: &mut Tree<'_>, rough: &Rough) -> Option<Nearest> {
    let wishes = Wishes::new(tree, rough);
    let mut search = Search { levels: vec![Level::whole(tree, wishes.laid)], is_hasty: false };
    let found = loop {
        search.is_hasty = tree.assembler.work > MOST_WORK;
        if tree.assembler.work > 2 * MOST_WORK {
            return None;
        }
        let level = search.levels.last_mut()?;
        if let Some(trial) = &level.trial {
            match level.parts.get(trial.solved).copied() {
                Some(group) => search.enter(tree, &wishes, group),
                None => level.keep_trial(),
            }
        } else if !level.try_next(tree, search.is_hasty) {
            let level = search.levels.pop()?;
            match level.group {
                Some(group) => tree.take(group),
                None => break level.best,
            }
            search.add(level.best);
        }
    };
    found.map(|best| Nearest { whole: tree.whole(&best.placed), is_proven: !search.is_hasty })
}

/// The levels of the tree that are being tried, from the whole mechanism to a part of a part.
struct Search {
    levels: Vec<Level>,
    /// Whether the first assembly is taken everywhere, because the work is too much.
    is_hasty: bool,
}

impl Search {
    /// Starts on a part of what is being tried: a group with all that hangs on it.
    fn enter(&mut self, tree: &mut Tree<'_>, wishes: &Wishes, group: usize) {
        let Some((level, trial)) =
            self.levels.last_mut().and_then(|level| Some((level.bounds(), level.trial.as_ref()?)))
        else {
            return;
        };
        let (base, limit) = level;
        let laid = trial.laid;
        match tree.modes(group) {
            Ok(modes) => {
                let mut choices: Vec<Choice> = modes.into_iter().map(|p| wishes.choice(tree, laid, p)).collect();
                choices.sort_by(|a, b| a.cost.total_cmp(&b.cost));
                self.levels.push(Level {
                    group: Some(group),
                    parts: tree.order.next[group].clone(),
                    base,
                    limit,
                    choices: choices.into_iter(),
                    trial: None,
                    best: None,
                });
            }
            Err(_) => self.add(None),
        }
    }

    /// Adds the best assembly of a part to what is being tried; without one there is nothing to try.
    fn add(&mut self, best: Option<Best>) {
        if let Some(level) = self.levels.last_mut() {
            level.add(best);
        }
    }
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

    /// Squared distances of all that is down, and the sum above which an assembly of the whole is of no use.
    fn bounds(&self) -> (f64, f64) {
        let cost = self.trial.as_ref().map_or(0.0, |trial| trial.cost);
        let best = self.best.as_ref().map_or(f64::INFINITY, |best| self.base + best.cost);
        (self.base + cost, self.limit.min(best))
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
        let mode = placed.assembly.mode;
        // The modes after it are no nearer.
        if is_hasty && self.best.is_some() || self.is_useless(cost, mode) {
            return false;
        }
        tree.put(&placed);
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
    fn new(tree: &Tree<'_>, rough: &Rough) -> Wishes {
        let mechanism = tree.mechanism;
        let group_of = |body: &BodyId| mechanism.groups.iter().position(|group| group.bodies.contains(body));
        let mut wishes = Wishes {
            points: vec![Vec::new(); mechanism.groups.len()],
            angles: vec![Vec::new(); mechanism.groups.len()],
            laid: Laid::default(),
        };
        for &(point, place) in &rough.points {
            let holds = |body: &BodyId| mechanism.body(*body).local_of(point).map(|local| (*body, local));
            // A point of a body of known position is where it is.
            if mechanism.body_ids().filter_map(|body| holds(&body)).any(|(body, _)| tree.frames.of(body).is_some()) {
                continue;
            }
            let mut groups = mechanism.groups.iter().enumerate();
            let held = groups.find_map(|(index, group)| Some((index, group.bodies.iter().find_map(holds)?)));
            if let Some((group, (body, local))) = held {
                wishes.points[group].push((body, local, place));
            }
        }
        for &(link, angle) in &rough.angles {
            if let Some(group) = group_of(&link) {
                wishes.angles[group].push((link, angle));
            }
        }
        let (places, _) = places(mechanism, &tree.frames);
        let is_sought = |point: PointId| {
            mechanism.groups.iter().any(|g| g.bodies.iter().any(|b| mechanism.body(*b).points.contains(&point)))
        };
        if !rough.angles.is_empty() {
            let known = mechanism.point_ids().filter(|point| !is_sought(*point));
            wishes.laid.extent = BoundingBox::of(known.map(|point| places[point.0]));
        }
        wishes
    }

    /// A group's mode with its squared distances; an angle counts as in [`WholeAssembly::distance_from`], with the size
    /// of what is down.
    fn choice(&self, tree: &Tree<'_>, before: Laid, placed: Placed) -> Choice {
        let frame = |body: BodyId| placed.frames.iter().find(|(other, _)| *other == body).map(|(_, frame)| frame);
        let distance =
            |&(body, local, place): &(BodyId, Point, Point)| Some((frame(body)? * local - place).norm_squared());
        let mut cost: f64 = self.points[placed.group].iter().filter_map(distance).sum();
        let mut laid = before;
        if tree.has_angles {
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
