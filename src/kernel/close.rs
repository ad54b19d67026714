use super::block::turned;
use super::compile::{Action, Chain, Closing, InputKind, Placing, Source, Unknown};
use super::{Block, Kernel};
use crate::geometry::{
    LinearSystem, Pairs, Reduced, UNIT_ROUNDOFF, Vector, lane, quarter_turn, set_lane,
    turn_of_degrees,
};
use crate::mechanism::Reduction;
use nalgebra::DMatrix;
use smallvec::SmallVec;

/// Newton steps at most for one group, from a good start.
const STEPS: usize = 12;

/// The largest part of a group's size, or of a radian, by which a first step may correct a start that counts as good.
const GOOD: f64 = 0.5;

/// How a block's positions were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// The largest first correction, in radians or parts of the group's size: how far off the start was.
    pub first: f64,
    /// Whether every loop closed to what rounding allows.
    pub closed: bool,
    /// The part of the largest first correction that a second one would still have to remove, in units of rounding.
    pub doubt: f64,
}

/// The columns of a group's equations, factored.
pub(super) enum Factored<const N: usize> {
    One(Reduced<1, N>, [usize; 2]),
    Two(Reduced<2, N>, [usize; 4]),
    Any(Vec<Option<LinearSystem>>),
}

/// Right sides of a group's loops, or the solutions for them: numbers by unknown.
pub(super) type Sides<const N: usize> = SmallVec<[Pairs<N>; 2]>;

impl Kernel {
    /// Sets a drive: an angle in degrees, or a position along the guide.
    pub fn set_input<const N: usize>(&self, block: &mut Block<N>, input: usize, values: &[f64; N]) {
        match self.inputs[input].kind {
            InputKind::Turning { class } => {
                for (i, value) in values.iter().enumerate() {
                    let turn = turn_of_degrees(*value);
                    set_lane(&mut block.turns[class], i, Vector::new(turn.re, turn.im));
                }
            }
            InputKind::Sliding { slider } => block.slides[slider] = *values,
        }
    }

    /// Closes every group by Newton's method from the angles and slides in `block`, and places all points.
    ///
    /// The matrix is that of the velocities, so a position is as exact as the condition of its velocities allows. It must start near:
    /// where a first step is larger than half a radian, or steps do not get smaller, the loops count as not closed.
    pub fn assemble<const N: usize>(&self, block: &mut Block<N>) -> Correction {
        let mut worst = Correction {
            first: 0.0,
            closed: true,
            doubt: 0.0,
        };
        for action in &self.actions {
            match action {
                Action::Place(placing) => place(block, placing),
                Action::Close(closing) => {
                    let found = close(block, closing);
                    worst.first = worst.first.max(found.first);
                    worst.doubt = worst.doubt.max(found.doubt);
                    worst.closed &= found.closed;
                    if !worst.closed {
                        return worst;
                    }
                }
            }
        }
        worst
    }
}

fn place<const N: usize>(block: &mut Block<N>, placing: &Placing) {
    let turn = &block.turns[placing.class];
    let from = block.points[placing.from];
    let reach = &mut block.reaches[placing.reach];
    let to = &mut block.points[placing.to];
    match placing.slide {
        None => {
            for i in 0..N {
                set_lane(reach, i, turned(turn, placing.local, i));
            }
        }
        Some((slider, direction)) => {
            let slides = &block.slides[slider];
            for i in 0..N {
                let local = placing.local + direction * slides[i];
                set_lane(reach, i, turned(turn, local, i));
            }
        }
    }
    for axis in 0..2 {
        for i in 0..N {
            to[axis][i] = from[axis][i] + reach[axis][i];
        }
    }
}

/// Newton's method for one group.
fn close<const N: usize>(block: &mut Block<N>, closing: &Closing) -> Correction {
    let mut before = f64::INFINITY;
    let mut first = None;
    let mut first_doubt = 0.0;
    for _ in 0..STEPS {
        arms(block, closing);
        let factored = factor(block, closing);
        let gaps: Sides<N> = closing.chains.iter().map(|c| gap(block, c)).collect();
        let corrections = factored.solve(&gaps, closing.unknowns.len());
        let mut largest: f64 = 0.0;
        let size = closing.size(block);
        for (unknown, correction) in closing.unknowns.iter().zip(&corrections) {
            let size = match unknown {
                Unknown::Spin(_) => 1.0,
                Unknown::Slide(_) => size,
            };
            for i in 0..N {
                let step = correction[i].abs() / size;
                // A NaN must not be lost in a maximum.
                largest = if step <= largest { largest } else { step };
            }
        }
        // Newton's method squares an error and divides it by the sharpness; what that leaves must be rounding.
        let sharpness = &block.squared_sharpness[closing.group];
        let dullest = sharpness.iter().fold(1.0, |least: f64, &s| least.min(s));
        let doubt = largest * largest / (dullest.sqrt() * UNIT_ROUNDOFF);
        let found = |closed| Correction {
            first: first.unwrap_or(largest),
            closed,
            doubt: if first.is_none() { doubt } else { first_doubt },
        };
        let far = first.is_none() && largest > GOOD;
        if largest.is_nan() || far || (largest > 0.5 * before && doubt > 1e3) {
            return found(false);
        }
        correct(block, closing, &corrections);
        if doubt <= 0.25 || largest > 0.5 * before {
            arms(block, closing);
            return found(true);
        }
        if first.is_none() {
            (first, first_doubt) = (Some(largest), doubt);
        }
        before = largest;
    }
    Correction {
        first: first.unwrap_or(f64::INFINITY),
        closed: false,
        doubt: f64::INFINITY,
    }
}

impl Closing {
    /// The largest component of a member's vector: a length to compare slides with.
    fn size<const N: usize>(&self, block: &Block<N>) -> f64 {
        let members = self.chains.iter().flat_map(|c| &c.members);
        let components = members.flat_map(|m| &block.arms[m.arm]).flatten();
        components.fold(0.0, |size: f64, x| size.max(x.abs()))
    }
}

/// Turns the members of all loops, and the guides in them.
fn arms<const N: usize>(block: &mut Block<N>, closing: &Closing) {
    for member in closing.chains.iter().flat_map(|c| &c.members) {
        let turn = &block.turns[member.class];
        let arm = &mut block.arms[member.arm];
        for i in 0..N {
            set_lane(arm, i, turned(turn, member.local, i));
        }
        for rail in &member.rails {
            let (guide, slides) = (&mut block.rails[rail.rail], &block.slides[rail.slider]);
            for i in 0..N {
                let direction = turned(turn, rail.direction, i);
                set_lane(guide, i, direction);
                set_lane(arm, i, lane(arm, i) + direction * slides[i]);
            }
        }
    }
}

/// What is missing for a loop to close: from its start, along its members, to its end.
fn gap<const N: usize>(block: &Block<N>, chain: &Chain) -> Pairs<N> {
    let mut gap = [[0.0; N]; 2];
    if let Some([start, end]) = chain.ends {
        let (start, end) = (&block.points[start], &block.points[end]);
        for axis in 0..2 {
            for i in 0..N {
                gap[axis][i] = end[axis][i] - start[axis][i];
            }
        }
    }
    for member in &chain.members {
        let arm = &block.arms[member.arm];
        for axis in 0..2 {
            for i in 0..N {
                gap[axis][i] -= arm[axis][i];
            }
        }
    }
    gap
}

/// The column of an unknown in a loop.
fn column<const N: usize>(block: &Block<N>, chain: &Chain, unknown: usize) -> Pairs<N> {
    match chain.columns[unknown] {
        None => [[0.0; N]; 2],
        Some(Source::Rail(rail)) => block.rails[rail],
        Some(Source::Arm(arm)) => {
            let arm = &block.arms[arm];
            let mut column = [[0.0; N]; 2];
            for i in 0..N {
                set_lane(&mut column, i, quarter_turn(lane(arm, i)));
            }
            column
        }
    }
}

/// Factors the equations; notes determinant and sharpness.
pub(super) fn factor<const N: usize>(block: &mut Block<N>, closing: &Closing) -> Factored<N> {
    let group = closing.group;
    match (closing.reduction, closing.chains.as_slice()) {
        (Some(Reduction::OneLoop), [chain]) => {
            let [s, t] = [0, 1].map(|u| column(block, chain, u));
            let system = Reduced::new([[[[0.0; N]; 2], s, t]]);
            block.determinants[group] = system.determinant;
            block.squared_sharpness[group] = system.squared_sharpness;
            Factored::One(system, [0, 1])
        }
        (
            Some(Reduction::TwoLoops {
                shared: [x, y],
                own,
            }),
            [first, second],
        ) => {
            let columns = [(first, own[0]), (second, own[1])]
                .map(|(chain, own)| [own, x, y].map(|u| column(block, chain, u)));
            let system = Reduced::new(columns);
            block.determinants[group] = system.determinant;
            block.squared_sharpness[group] = system.squared_sharpness;
            Factored::Two(system, [x, y, own[0], own[1]])
        }
        (_, chains) => {
            let unknowns = closing.unknowns.len();
            let columns: Vec<Vec<Pairs<N>>> = chains
                .iter()
                .map(|chain| (0..unknowns).map(|u| column(block, chain, u)).collect())
                .collect();
            let systems = (0..N).map(|i| {
                let matrix = DMatrix::from_fn(2 * chains.len(), unknowns, |row, unknown| {
                    columns[row / 2][unknown][row % 2][i]
                });
                let system = (matrix.nrows() == matrix.ncols()).then(|| LinearSystem::new(matrix));
                let system = system.flatten();
                let condition = system
                    .as_ref()
                    .map_or(f64::INFINITY, LinearSystem::condition);
                block.determinants[group][i] =
                    system.as_ref().map_or(0.0, LinearSystem::determinant);
                block.squared_sharpness[group][i] = 1.0 / (condition * condition);
                system
            });
            Factored::Any(systems.collect())
        }
    }
}

impl<const N: usize> Factored<N> {
    /// The unknowns for these right sides.
    pub(super) fn solve(&self, sides: &[Pairs<N>], unknowns: usize) -> SmallVec<[[f64; N]; 4]> {
        let mut solution: SmallVec<[[f64; N]; 4]> = SmallVec::from_elem([0.0; N], unknowns);
        match self {
            Factored::One(system, order) => {
                let solved = system.solve(&[sides[0]]);
                for (unknown, value) in order.iter().zip(solved) {
                    solution[*unknown] = value;
                }
            }
            Factored::Two(system, order) => {
                let solved = system.solve(&[sides[0], sides[1]]);
                for (unknown, value) in order.iter().zip(solved) {
                    solution[*unknown] = value;
                }
            }
            Factored::Any(systems) => {
                for (i, system) in systems.iter().enumerate() {
                    let side: Vec<f64> = sides.iter().flat_map(|s| [s[0][i], s[1][i]]).collect();
                    let solved = system.as_ref().map(|s| s.solve(&side));
                    for (unknown, value) in solution.iter_mut().enumerate() {
                        value[i] = solved.as_ref().map_or(f64::NAN, |s| s[unknown]);
                    }
                }
            }
        }
        solution
    }
}

/// Adds the corrections of the unknowns.
fn correct<const N: usize>(block: &mut Block<N>, closing: &Closing, corrections: &[[f64; N]]) {
    for (unknown, correction) in closing.unknowns.iter().zip(corrections) {
        match *unknown {
            Unknown::Slide(slider) => {
                for i in 0..N {
                    block.slides[slider][i] += correction[i];
                }
            }
            Unknown::Spin(class) => {
                let turn = &mut block.turns[class];
                for i in 0..N {
                    let (c, s) = (turn[0][i], turn[1][i]);
                    // The rotation whose half angle has this tangent (Cayley, 1846): to third order the correction.
                    let half = 0.5 * correction[i];
                    let scale = 1.0 / (1.0 + half * half);
                    let (cosine, sine) = ((1.0 - half * half) * scale, 2.0 * half * scale);
                    let (c, s) = (c * cosine - s * sine, s * cosine + c * sine);
                    // Rounding must not change lengths in the long run: one Newton step towards length 1.
                    let unit = 1.5 - 0.5 * (c * c + s * s);
                    (turn[0][i], turn[1][i]) = (c * unit, s * unit);
                }
            }
        }
    }
}
