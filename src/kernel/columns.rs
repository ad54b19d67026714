use super::action::{Chain, Closing, Tied, TiedClass};
use super::{Block, vector};
use crate::geometry::{Lanes, MANY, Pair, Row, Vector, portions};
use std::f64::consts::TAU;

/// Rotates the vectors of all loops' members and guides into the fixed frame, and computes the gaps of loops and ties.
/// A loop's gap is the vector from its start to its end point less the sum of its members' vectors.
///
/// Vector by vector, each in all positions: these do not wait for one another.
#[inline(always)]
pub(super) fn turn_columns<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    let Block { turns, slides, points, columns, lengths, sides, .. } = block;
    let zero = lanes.splat(0.0);
    for (chain, side) in closing.chains.iter().zip(sides) {
        let mut gaps = [Pair { x: zero, y: zero }; MANY];
        for k in portions::<L, R>() {
            gaps[k] = chain.difference(lanes, k, points);
        }
        for member in &chain.members {
            let (turn, local) = (&turns[member.class], &lengths.columns[member.column]);
            let column = &mut columns[member.column];
            for k in portions::<L, R>() {
                let turned = lanes.pair(turn, k).turn(lanes.pair(local, k));
                lanes.store_pair(column, k, turned);
                // A column is the member's vector turned by +90°.
                gaps[k] = Pair { x: gaps[k].x - turned.y, y: gaps[k].y + turned.x };
            }
        }
        for rail in &chain.rails {
            let (turn, local) = (&turns[rail.class], &lengths.columns[rail.column]);
            let ends = columns.get_disjoint_mut([rail.column, rail.arm]);
            let [guide, arm] = ends.expect("a guide belongs to a member");
            for k in portions::<L, R>() {
                let turned = lanes.pair(turn, k).turn(lanes.pair(local, k));
                let slide = lanes.load(&slides[rail.slider], k);
                let longer = lanes.pair(arm, k).plus_turned(turned, slide);
                lanes.store_pair(guide, k, turned);
                lanes.store_pair(arm, k, longer);
                gaps[k] = gaps[k].minus_scaled(turned, slide);
            }
        }
        for k in portions::<L, R>() {
            lanes.store_pair(side, k, gaps[k]);
        }
    }
    for (tied, side) in closing.ties.iter().zip(&mut block.tie_sides) {
        for position in 0..R::LEN {
            side[position] =
                tied.gap(|class| vector(&block.turns[class], position), |slider| block.slides[slider][position]);
        }
    }
}

impl Tied {
    /// The constant angle less the weighted sum of the classes' angles and of the slides, in radians, in [−π, π].
    fn gap(&self, direction: impl Fn(usize) -> Vector, slide: impl Fn(usize) -> f64) -> f64 {
        let angle = |c: &TiedClass| {
            let turned = direction(c.class);
            c.weight * libm::atan2(turned.y, turned.x)
        };
        let gap = self.apart - self.classes.iter().map(angle).sum::<f64>();
        let gap = self.slides.iter().fold(gap, |gap, s| gap - s.weight * slide(s.slider));
        gap - TAU * (gap / TAU).round()
    }
}

impl Chain {
    /// The value at the loop's end less that at its start, in one portion; zero for a loop that closes on itself.
    #[inline(always)]
    pub(super) fn difference<L: Lanes, R: Row>(&self, lanes: L, k: usize, values: &[[R; 2]]) -> Pair<L::Number> {
        match self.ends {
            Some([start, end]) => lanes.pair(&values[end], k) - lanes.pair(&values[start], k),
            None => Pair { x: lanes.splat(0.0), y: lanes.splat(0.0) },
        }
    }
}

/// Updates the columns for tiny corrections of the unknowns.
#[inline(always)]
pub(super) fn correct_columns<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    let Block { columns, solution, .. } = block;
    for chain in &closing.chains {
        for member in &chain.members {
            if let Some(spin) = member.spin {
                rotate_slightly(lanes, &mut columns[member.column], &solution[spin]);
            }
        }
        for rail in &chain.rails {
            if let Some(spin) = rail.spin {
                rotate_slightly(lanes, &mut columns[rail.column], &solution[spin]);
            }
            let Some(slide) = rail.slide else { continue };
            let ends = columns.get_disjoint_mut([rail.column, rail.arm]);
            let [guide, arm] = ends.expect("a guide belongs to a member");
            for k in portions::<L, R>() {
                let step = lanes.load(&solution[slide], k);
                let longer = lanes.pair(arm, k).plus_turned(lanes.pair(guide, k), step);
                lanes.store_pair(arm, k, longer);
            }
        }
    }
}

/// Rotates vectors by tiny angles, to first order.
#[inline(always)]
fn rotate_slightly<L: Lanes, R: Row>(lanes: L, vectors: &mut [R; 2], angles: &R) {
    for k in portions::<L, R>() {
        let old = lanes.pair(vectors, k);
        let turned = old.plus_turned(old, lanes.load(angles, k));
        lanes.store_pair(vectors, k, turned);
    }
}
