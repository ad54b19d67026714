use super::Block;
use super::action::{Chain, Closing, Reducible, Unknown};
use super::solve::largest_norm;
use crate::geometry::{Lanes, Number, Pair, Reduced, Row, portions};

/// What a vector of a loop is to the equations that [`Reduced`] solves: h belongs to the loop's own unknown, s and t to
/// the shared ones.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    H,
    S,
    T,
}

use Role::{H, S, T};

impl Role {
    /// Index of its unknown in the group, in a loop of this index.
    const fn unknown(self, index: usize) -> usize {
        match self {
            S => 0,
            T => 1,
            H => 2 + index,
        }
    }
}

/// A loop without known rotations: the roles of its members in their order, and of the slide along the guide of one of
/// them, if it has one.
#[derive(Clone, Copy, PartialEq, Eq)]
struct LoopShape {
    members: [Option<Role>; MEMBERS],
    guide: Option<(usize, Role)>,
}

/// Most members of a loop that has a shape.
const MEMBERS: usize = 3;

const NO_LOOP: LoopShape = LoopShape { members: [None; MEMBERS], guide: None };

/// Two links with pins, as in a four-bar.
pub(super) const TWO_TURNS: usize = 0;
/// A slide along a link that both loops share, as in the source's Figure 2.
pub(super) const SLIDE_AND_TURN: usize = 1;

/// Shapes of groups for which the compiler makes code of its own, in which all of a group's equations stay in
/// registers. Groups of all other shapes go through rows of memory, to the same bits.
const SHAPES: [[LoopShape; 2]; 2] = [
    [LoopShape { members: [Some(S), Some(T), None], guide: None }, NO_LOOP],
    [
        LoopShape { members: [Some(S), Some(T), None], guide: Some((0, H)) },
        LoopShape { members: [Some(S), Some(H), Some(T)], guide: None },
    ],
];

/// The index of a group's shape, if it has one of these; `columns` are those of [`Reducible`].
pub(super) fn shape_of(chains: &[Chain], columns: &[[usize; 3]]) -> Option<usize> {
    let mut shape = [NO_LOOP; 2];
    for ((chain, columns), shape) in chains.iter().zip(columns).zip(&mut shape) {
        // A single loop has no h.
        let first = if chains.len() == 1 { 1 } else { 0 };
        let role = |column| (first..3).find(|i| columns[*i] == column).map(|i| [H, S, T][i]);
        if chain.has_known || chain.members.len() > MEMBERS || chain.rails.len() > 1 {
            return None;
        }
        for (member, found) in chain.members.iter().zip(&mut shape.members) {
            *found = Some(role(member.column)?);
        }
        if let [rail] = chain.rails[..] {
            let arm = chain.members.iter().position(|m| m.column == rail.arm)?;
            shape.guide = Some((arm, role(rail.column)?));
        }
    }
    SHAPES.iter().position(|s| *s == shape)
}

/// What is computed in registers: a Newton step and the rates after it, or rates at closed positions.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Pass {
    StepAndRates,
    Rates,
}

/// A loop's vectors in one portion: of its members, turned by +90°, and of its guide.
#[derive(Clone, Copy)]
struct Vectors<T> {
    members: [Pair<T>; MEMBERS],
    guide: Pair<T>,
}

impl<N: Number> Vectors<N> {
    /// The columns h, s, t.
    #[inline(always)]
    fn columns(&self, shape: &LoopShape) -> [Pair<N>; 3] {
        let mut columns = [self.guide; 3];
        for j in 0..MEMBERS {
            if let Some(role) = shape.members[j] {
                columns[role as usize] = self.members[j];
            }
        }
        if let Some((_, role)) = shape.guide {
            columns[role as usize] = self.guide;
        }
        columns
    }

    /// Updates them for tiny corrections.
    #[inline(always)]
    fn correct(&mut self, shape: &LoopShape, index: usize, solved: &[N; 4]) {
        for j in 0..MEMBERS {
            let Some(role) = shape.members[j] else { continue };
            let spin = solved[role.unknown(index)];
            self.members[j] = self.members[j].plus_turned(self.members[j], spin);
            if let Some((arm, slide)) = shape.guide
                && arm == j
            {
                self.guide = self.guide.plus_turned(self.guide, spin);
                self.members[j] = self.members[j].plus_turned(self.guide, solved[slide.unknown(index)]);
            }
        }
    }

    /// The right side for accelerations, from the difference of the ends' accelerations and the rates of the unknowns.
    #[inline(always)]
    fn acceleration_side(&self, shape: &LoopShape, index: usize, difference: Pair<N>, rates: &[N; 4]) -> Pair<N> {
        let mut side = difference;
        for j in 0..MEMBERS {
            if let Some(role) = shape.members[j] {
                let omega = rates[role.unknown(index)];
                side = side.minus_turned(self.members[j], omega * omega);
            }
        }
        if let Some((arm, slide)) = shape.guide
            && let Some(role) = shape.members[arm]
        {
            let (omega, speed) = (rates[role.unknown(index)], rates[slide.unknown(index)]);
            side = side.minus_turned(self.guide, omega * (speed + speed));
        }
        side
    }
}

/// Carries out a pass for a group of this shape, each portion in registers. Returns the largest norm of a correction,
/// as [`solve`](super::solve::solve) does.
///
/// The columns and rates are those after tiny corrections; angles and slides themselves stay as they were, so that a
/// step that turns out not to be tiny can be made anew. Nothing here depends on the mechanism but which rows are read
/// and written: the same operations in the same order as through memory, and so the same bits.
#[inline(always)]
pub(super) fn in_registers<L: Lanes, R: Row, const LOOPS: usize, const SHAPE: usize>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
    equations: &Reducible<LOOPS>,
    pass: Pass,
) -> f64 {
    let shape = const { &SHAPES[SHAPE] };
    let chains: &[Chain; LOOPS] = closing.chains.first_chunk().expect("as many loops");
    let zero = lanes.splat(0.0);
    let nothing = Pair { x: zero, y: zero };
    let (mut sum, mut longest) = (zero, zero);
    for k in portions::<L, R>() {
        let mut vectors = [Vectors { members: [nothing; MEMBERS], guide: nothing }; LOOPS];
        let mut sides = [nothing; LOOPS];
        if pass == Pass::Rates {
            for i in 0..LOOPS {
                vectors[i] = closed_vectors(lanes, k, block, &chains[i], &shape[i]);
            }
        } else {
            for i in 0..LOOPS {
                (vectors[i], sides[i]) = turned_vectors(lanes, k, block, &chains[i], &shape[i]);
            }
            let (system, inverse) = system(lanes, k, block, closing, equations, shape, &vectors);
            let solved = system.solve(inverse, sides);
            let mut square = zero;
            for i in 0..2 * LOOPS {
                lanes.store(&mut block.solution[i], k, solved[i]);
                let step = solved[i] * lanes.splat(closing.scales[i]);
                square = square.plus_product(step, step);
            }
            sum = sum + square;
            longest = longest.larger(square);
            for i in 0..LOOPS {
                vectors[i].correct(&shape[i], i, &solved);
                store_vectors(lanes, k, block, &chains[i], &shape[i], &vectors[i]);
            }
        }
        let (system, inverse) = system(lanes, k, block, closing, equations, shape, &vectors);
        for i in 0..LOOPS {
            sides[i] = chains[i].difference(lanes, k, &block.point_velocities);
        }
        let rates = system.solve(inverse, sides);
        for i in 0..LOOPS {
            let difference = chains[i].difference(lanes, k, &block.point_accelerations);
            sides[i] = vectors[i].acceleration_side(&shape[i], i, difference, &rates);
        }
        let seconds = system.solve(inverse, sides);
        let Block { omegas, alphas, speeds, accelerations, .. } = block;
        for i in 0..2 * LOOPS {
            let (rows, second_rows) = match closing.unknowns[i] {
                Unknown::Spin(class) => (&mut omegas[class], &mut alphas[class]),
                Unknown::Slide(slider) => (&mut speeds[slider], &mut accelerations[slider]),
            };
            lanes.store(rows, k, rates[i]);
            lanes.store(second_rows, k, seconds[i]);
        }
    }
    largest_norm(lanes, sum, longest)
}

/// A loop's vectors at its angles and slides, and its gap.
#[inline(always)]
fn turned_vectors<L: Lanes, R: Row>(
    lanes: L,
    k: usize,
    block: &Block<R>,
    chain: &Chain,
    shape: &LoopShape,
) -> (Vectors<L::Number>, Pair<L::Number>) {
    let zero = lanes.splat(0.0);
    let nothing = Pair { x: zero, y: zero };
    let mut vectors = Vectors { members: [nothing; MEMBERS], guide: nothing };
    let mut gap = chain.difference(lanes, k, &block.points);
    for j in 0..MEMBERS {
        if shape.members[j].is_some() {
            let column = turned(lanes, k, block, chain.members[j].class, chain.members[j].column);
            vectors.members[j] = column;
            gap = Pair { x: gap.x - column.y, y: gap.y + column.x };
        }
    }
    if let Some((arm, _)) = shape.guide {
        let rail = &chain.rails[0];
        let slide = lanes.load(&block.slides[rail.slider], k);
        vectors.guide = turned(lanes, k, block, rail.class, rail.column);
        vectors.members[arm] = vectors.members[arm].plus_turned(vectors.guide, slide);
        gap = gap.minus_scaled(vectors.guide, slide);
    }
    (vectors, gap)
}

/// A column's vector turned with its class.
#[inline(always)]
fn turned<L: Lanes, R: Row>(lanes: L, k: usize, block: &Block<R>, class: usize, column: usize) -> Pair<L::Number> {
    lanes.pair(&block.turns[class], k).turn(lanes.pair(&block.lengths.columns[column], k))
}

/// A closed loop's vectors, from the block's columns.
#[inline(always)]
fn closed_vectors<L: Lanes, R: Row>(
    lanes: L,
    k: usize,
    block: &Block<R>,
    chain: &Chain,
    shape: &LoopShape,
) -> Vectors<L::Number> {
    let zero = lanes.splat(0.0);
    let nothing = Pair { x: zero, y: zero };
    let mut vectors = Vectors { members: [nothing; MEMBERS], guide: nothing };
    for j in 0..MEMBERS {
        if shape.members[j].is_some() {
            vectors.members[j] = lanes.pair(&block.columns[chain.members[j].column], k);
        }
    }
    if shape.guide.is_some() {
        vectors.guide = lanes.pair(&block.columns[chain.rails[0].column], k);
    }
    vectors
}

#[inline(always)]
fn store_vectors<L: Lanes, R: Row>(
    lanes: L,
    k: usize,
    block: &mut Block<R>,
    chain: &Chain,
    shape: &LoopShape,
    vectors: &Vectors<L::Number>,
) {
    for j in 0..MEMBERS {
        if shape.members[j].is_some() {
            lanes.store_pair(&mut block.columns[chain.members[j].column], k, vectors.members[j]);
        }
    }
    if shape.guide.is_some() {
        lanes.store_pair(&mut block.columns[chain.rails[0].column], k, vectors.guide);
    }
}

/// The reduced equations of a group's vectors, and the inverse of their determinant.
#[inline(always)]
fn system<L: Lanes, R: Row, const LOOPS: usize>(
    lanes: L,
    k: usize,
    block: &mut Block<R>,
    closing: &Closing,
    equations: &Reducible<LOOPS>,
    shape: &[LoopShape; 2],
    vectors: &[Vectors<L::Number>; LOOPS],
) -> (Reduced<LOOPS, L::Number>, L::Number) {
    let rows = &mut block.systems[closing.group];
    let one = lanes.splat(1.0);
    let mut columns = [[Pair { x: one, y: one }; 3]; LOOPS];
    let mut squares = [one; LOOPS];
    for i in 0..LOOPS {
        columns[i] = vectors[i].columns(&shape[i]);
        squares[i] = lanes.load(&rows.inverse_squares[i], k);
        if equations.varies[i] {
            squares[i] = one / columns[i][0].dot(columns[i][0]);
            lanes.store(&mut rows.inverse_squares[i], k, squares[i]);
        }
    }
    let system = Reduced::with_inverse_squares(columns, squares);
    let inverse = one / system.determinant();
    lanes.store(&mut rows.inverse_determinant, k, inverse);
    (system, inverse)
}
