use super::action::{Chain, Closing, Tied, TiedClass};
use super::close::portions;
use super::{Block, vector};
use crate::geometry::{Lanes, MANY, Pair, Row, Vector};
use std::f64::consts::TAU;

/// Turns the vectors of all loops' members, and the guides in them, and finds what is missing for the loops to close:
/// from their starts, along their members, to their ends; and for the ties to hold.
#[inline(always)]
pub(super) fn turn_columns<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    let Block { turns, slides, points, columns, lengths, sides, .. } = block;
    for (chain, side) in closing.chains.iter().zip(sides) {
        let mut gaps = chain.difference(lanes, points);
        for rail in &chain.rails {
            let (turn, local) = (&turns[rail.class], &lengths.columns[rail.column]);
            let guide = &mut columns[rail.column];
            for k in portions::<L, R>() {
                let turned = lanes.pair(turn, k).turn(lanes.pair(local, k));
                lanes.store_pair(guide, k, turned);
            }
        }
        for member in &chain.members {
            let (turn, local) = (&turns[member.class], &lengths.columns[member.column]);
            let column = &mut columns[member.column];
            for k in portions::<L, R>() {
                let turned = lanes.pair(turn, k).turn(lanes.pair(local, k));
                lanes.store_pair(column, k, turned);
                // A column is its member's vector a quarter turn on.
                gaps[k].x = gaps[k].x - turned.y;
                gaps[k].y = gaps[k].y + turned.x;
            }
        }
        for rail in &chain.rails {
            let ends = columns.get_disjoint_mut([rail.column, rail.arm]);
            let [guide, arm] = ends.expect("a guide belongs to a member");
            let slides = &slides[rail.slider];
            for k in portions::<L, R>() {
                let (guide, slide) = (lanes.pair(guide, k), lanes.load(slides, k));
                let longer = lanes.pair(arm, k).plus_turned(guide, slide);
                lanes.store_pair(arm, k, longer);
                gaps[k] = gaps[k].minus_scaled(guide, slide);
            }
        }
        for k in portions::<L, R>() {
            lanes.store_pair(side, k, gaps[k]);
        }
    }
    for (tied, side) in closing.ties.iter().zip(&mut block.tie_sides) {
        for position in 0..R::LEN {
            side[position] = tied.gap(|class| vector(&block.turns[class], position));
        }
    }
}

impl Tied {
    /// What is missing of its constant angle where classes are turned in these directions: at most half a turn.
    fn gap(&self, direction: impl Fn(usize) -> Vector) -> f64 {
        let angle = |c: &TiedClass| {
            let turned = direction(c.class);
            c.weight * libm::atan2(turned.y, turned.x)
        };
        let gap = self.apart - self.classes.iter().map(angle).sum::<f64>();
        gap - TAU * (gap / TAU).round()
    }
}

impl Chain {
    /// By portion, the value at its end less that at its start; zero for a loop that closes on itself.
    #[inline(always)]
    pub(super) fn difference<L: Lanes, R: Row>(&self, lanes: L, values: &[[R; 2]]) -> [Pair<L::Number>; MANY] {
        let zero = lanes.splat(0.0);
        let mut differences = [Pair { x: zero, y: zero }; MANY];
        if let Some([start, end]) = self.ends {
            let (start, end) = (&values[start], &values[end]);
            for k in portions::<L, R>() {
                differences[k] = lanes.pair(end, k) - lanes.pair(start, k);
            }
        }
        differences
    }
}

/// Corrects the columns for tiny corrections of the unknowns.
#[inline(always)]
pub(super) fn correct_columns<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    let Block { columns, solution, .. } = block;
    for chain in &closing.chains {
        for member in &chain.members {
            if let Some(spin) = member.spin {
                turn_little(lanes, &mut columns[member.column], &solution[spin]);
            }
        }
        for rail in &chain.rails {
            if let Some(spin) = rail.spin {
                turn_little(lanes, &mut columns[rail.column], &solution[spin]);
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

/// Turns vectors by tiny angles.
#[inline(always)]
fn turn_little<L: Lanes, R: Row>(lanes: L, vectors: &mut [R; 2], angles: &R) {
    for k in portions::<L, R>() {
        let old = lanes.pair(vectors, k);
        let turned = old.plus_turned(old, lanes.load(angles, k));
        lanes.store_pair(vectors, k, turned);
    }
}
