use super::modes::NoMode;
use super::tree::{Placed, Tree, WholeAssembly};

/// All assemblies of a mechanism, one after another in the order of their numbers: that of the first group's modes,
/// then of the second's, and so on.
pub(super) struct Listing<'t, 'a> {
    tree: &'t mut Tree<'a>,
    most_work: usize,
    /// By group that is down, or comes next: its modes, and the index of the one after that which is down.
    levels: Vec<(Vec<Placed>, usize)>,
    /// Of the groups that could not be put down, the one farthest from the first: its index, and the reason.
    failure: Option<(usize, NoMode)>,
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

    /// Why there is no assembly: the group that could not be put down in any assembly of those before it, and the
    /// reason in the first of these.
    pub(super) fn failure(self) -> Option<(usize, NoMode)> {
        self.failure
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
            self.tree.put(placed);
            if depth == groups {
                let down = self.levels.iter().filter_map(|(modes, next)| modes.get(next.checked_sub(1)?));
                return Some(self.tree.whole(down));
            }
            self.enter(depth);
        }
    }
}
