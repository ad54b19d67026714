use super::tree::{Placed, Tree};
use std::fmt;

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
    let mut levels = vec![Level::whole(tree)];
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
                    tree.put(&placed);
                    level.trial = Some((1, 0));
                }
                None => {
                    let (number, group) = (level.total, level.group);
                    let Some(group) = group else {
                        break number;
                    };
                    tree.take(group);
                    levels.pop();
                    levels.iter_mut().last().into_iter().for_each(|before| before.multiply(number));
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

impl Level {
    /// The whole mechanism.
    fn whole(tree: &Tree<'_>) -> Level {
        let parts = tree.order.roots.clone();
        Level { group: None, parts, modes: Vec::new().into_iter(), total: 0, trial: Some((1, 0)) }
    }

    /// Takes a part as solved.
    fn multiply(&mut self, number: u64) {
        if let Some((product, solved)) = &mut self.trial {
            *product = product.saturating_mul(number);
            *solved += 1;
        }
    }
}
