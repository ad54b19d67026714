use super::segment::Node;
use super::{Path, Position};
use crate::kernel::Unknown;
use crate::mechanism::PointId;
use crate::quantity::State;

/// Most branches that are followed one after another.
const MOST_BRANCHES: usize = 8;
/// Distance from a limit at which the other branch is sought, in turns: unknowns differ there by the root of it.
const BACK: f64 = 1e-4;
/// Distance of points that counts as none, in sizes of the mechanism.
const CLOSED: f64 = 1e-7;

/// The other branches of the motion that hang together with this one: in a limit position the drive can go no further,
/// but the mechanism, moved by another link, goes over to the branch that ends there too, and the drive goes back.
/// Without the branch itself, in the order in which they follow from its upper end, and then from its lower one.
pub(super) fn other_branches<'a>(own: &Path<'a>) -> Vec<Path<'a>> {
    let mut all = Vec::new();
    for above in [true, false] {
        let (mut chain, closed) = chain(own, above);
        all.append(&mut chain);
        if closed {
            break;
        }
    }
    all
}

/// The branches one after another from one end of a branch, and whether they lead back to it.
fn chain<'a>(own: &Path<'a>, mut above: bool) -> (Vec<Path<'a>>, bool) {
    let mut chain: Vec<Path<'a>> = Vec::new();
    while chain.len() < MOST_BRANCHES {
        let Some((next, value)) = across(chain.last().unwrap_or(own), above) else {
            return (chain, false);
        };
        if is_same(own, &next, [value; 2]) {
            return (chain, true);
        }
        chain.push(next);
        above = !above;
    }
    (chain, false)
}

/// The branch that ends in the same limit position as `path` above or below, followed to its other end, and a value of
/// the drive near the limit.
///
/// At a distance d of the limit the unknowns are x* − c √d on one branch and x* + c √d on the other.
fn across<'a>(path: &Path<'a>, above: bool) -> Option<(Path<'a>, f64)> {
    path.limit(above)?;
    let edge = if above { path.high() } else { path.low() };
    let inwards = if above { -path.unit() } else { path.unit() };
    let value = edge + BACK * inwards;
    let mut walker = path.walker();
    let limit = walker.positions(&[edge])?.clone();
    let mut block = walker.positions(&[value])?.clone();
    for unknown in path.kernel.unknowns.iter().flatten() {
        match *unknown {
            Unknown::Spin(class) => {
                let turned = limit.turn(class, 0) * block.turn(class, 0).inverse() * limit.turn(class, 0);
                block.turns[class] = [[turned.re], [turned.im]];
            }
            Unknown::Slide(slider) => block.slides[slider][0] = 2.0 * limit.slides[slider][0] - block.slides[slider][0],
        }
    }
    if !path.kernel.assemble(&mut block, 0.0).closed {
        return None;
    }
    path.unit_rates(&mut block);
    let mut next = path.restarted(Node::new(&path.kernel, value, block));
    if is_same(path, &next, [value; 2]) {
        return None;
    }
    next.follow_to(edge - BACK * inwards);
    next.follow_to(edge + path.far().copysign(inwards));
    Some((next, value))
}

/// Whether all points are in the same places on two branches at values of the drive.
pub(super) fn is_same(a: &Path, b: &Path, values: [f64; 2]) -> bool {
    let places = |position: Position<'_>| -> Vec<_> {
        (0..a.mechanism.points.len()).map(|point| position.place(PointId(point))).collect()
    };
    let at = |path: &Path, value: f64| {
        // A branch of one position only has no segment to walk on.
        let alone = path.nodes.first().filter(|node| path.segments.is_empty() && node.value == value);
        match alone {
            Some(node) => Some(places(path.position(&node.block, 0))),
            None => path.walker().position(value).map(places),
        }
    };
    let pairs = at(a, values[0]).zip(at(b, values[1])).map(|(a, b)| a.into_iter().zip(b));
    pairs.is_some_and(|mut pairs| pairs.all(|(p, q)| (p - q).norm() <= CLOSED * a.size()))
}
