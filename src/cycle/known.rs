//! Limits that are known by lengths, before a path comes to them.

use super::path::Path;
use super::segment::Node;

/// A limit of a dyad that hangs on the moved crank, known by lengths.
#[derive(Clone, Copy)]
pub(super) struct Known {
    /// The drive's value there, and the bound of its error.
    pub at: f64,
    pub within: f64,
    pub group: usize,
}

impl Known {
    /// All of them, within half a turn of a node.
    fn all(path: &Path, node: &Node) -> Vec<Known> {
        let pose = path.position(&node.block, 0).pose();
        let reaches = (0..path.mechanism.groups.len()).filter_map(|group| Some((group, path.reach(group, &pose)?)));
        let limits = reaches.flat_map(|(group, reach)| {
            let limits = reach.limits(node.value).into_iter();
            limits.map(move |[at, within]| Known { at, within, group })
        });
        limits.collect()
    }

    /// Whether lengths tell all limits of a group.
    pub fn has(path: &Path, node: &Node, group: usize) -> bool {
        path.reach(group, &path.position(&node.block, 0).pose()).is_some()
    }

    /// The one nearest to a node.
    pub fn nearest(path: &Path, node: &Node) -> Option<Known> {
        let away = |known: &Known| (known.at - node.value).abs();
        Known::all(path, node).into_iter().min_by(|a, b| away(a).total_cmp(&away(b)))
    }

    /// The next one ahead of a node.
    pub fn ahead(path: &Path, node: &Node, forward: f64) -> Option<Known> {
        let beyond = Known::all(path, node).into_iter().map(|known| {
            let is_behind = (known.at - node.value) * forward < 0.0;
            Known { at: known.at + if is_behind { forward * path.unit() } else { 0.0 }, ..known }
        });
        beyond.min_by(|a, b| ((a.at - b.at) * forward).total_cmp(&0.0))
    }
}
