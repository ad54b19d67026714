use super::modes::NoMode;
use super::tree::{Placed, Tree, WholeAssembly};
use std::fmt;

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
        match self.tree.modes(group) {
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

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let least = if self.is_exact { "" } else { "at least " };
        write!(f, "{least}{}", self.number)
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
                let modes = tree.modes(group).unwrap_or_default();
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
