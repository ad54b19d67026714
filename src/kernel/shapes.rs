use super::Block;
use super::action::{Chain, Closing, Reducing, Shape, Unknown};
use super::solve::largest_norm;
use crate::geometry::{Lanes, Number, Pair, Reduced, Row, portions};

/// Columns h, s, t of each loop, as [`Reduced`] takes them.
type Columns<N, const LOOPS: usize> = [[Pair<N>; 3]; LOOPS];

/// The equations of a shape: the same operations in the same order as through rows, and so the same bits.
trait Equations<const LOOPS: usize> {
    /// The columns at the angles and slides, and the loops' gaps; as `turn_columns`.
    fn turned<L: Lanes, R: Row>(
        lanes: L,
        k: usize,
        block: &Block<R>,
        chains: &[Chain; LOOPS],
    ) -> (Columns<L::Number, LOOPS>, [Pair<L::Number>; LOOPS]);

    /// The columns after tiny corrections of s, t, and the loops' own unknowns; as `correct_columns`.
    fn corrected<N: Number>(columns: Columns<N, LOOPS>, steps: [N; 4]) -> Columns<N, LOOPS>;

    /// Keeps the columns for what is asked later.
    fn store<L: Lanes, R: Row>(
        lanes: L,
        k: usize,
        columns: Columns<L::Number, LOOPS>,
        chains: &[Chain; LOOPS],
        rows: &mut [[R; 2]],
    );

    /// The right sides for accelerations, from differences of the ends' accelerations and the rates of s, t, and the
    /// loops' own unknowns; as `acceleration_side`.
    fn sides<N: Number>(differences: [Pair<N>; LOOPS], columns: Columns<N, LOOPS>, rates: [N; 4]) -> [Pair<N>; LOOPS];
}

/// Two links with pins.
struct TwoTurns;

impl Equations<1> for TwoTurns {
    #[inline(always)]
    fn turned<L: Lanes, R: Row>(
        lanes: L,
        k: usize,
        block: &Block<R>,
        [chain]: &[Chain; 1],
    ) -> (Columns<L::Number, 1>, [Pair<L::Number>; 1]) {
        let (s, t) = (member(lanes, k, block, chain, 0), member(lanes, k, block, chain, 1));
        let gap = less(less(chain.difference(lanes, k, &block.points), s), t);
        ([[s, s, t]], [gap])
    }

    #[inline(always)]
    fn corrected<N: Number>([[_, s, t]]: Columns<N, 1>, [by_s, by_t, ..]: [N; 4]) -> Columns<N, 1> {
        let s = s.plus_turned(s, by_s);
        [[s, s, t.plus_turned(t, by_t)]]
    }

    #[inline(always)]
    fn store<L: Lanes, R: Row>(
        lanes: L,
        k: usize,
        [[_, s, t]]: Columns<L::Number, 1>,
        [chain]: &[Chain; 1],
        rows: &mut [[R; 2]],
    ) {
        lanes.store_pair(&mut rows[chain.members[0].column], k, s);
        lanes.store_pair(&mut rows[chain.members[1].column], k, t);
    }

    #[inline(always)]
    fn sides<N: Number>([side]: [Pair<N>; 1], [[_, s, t]]: Columns<N, 1>, [x, y, ..]: [N; 4]) -> [Pair<N>; 1] {
        [side.minus_turned(s, x * x).minus_turned(t, y * y)]
    }
}

/// In the first loop a slide h along a link s, whose length to the slide varies, and a link t; in the second the first
/// link again (u), a link g and the second link again (v).
struct SlideAndTurn;

impl Equations<2> for SlideAndTurn {
    #[inline(always)]
    fn turned<L: Lanes, R: Row>(
        lanes: L,
        k: usize,
        block: &Block<R>,
        [first, second]: &[Chain; 2],
    ) -> (Columns<L::Number, 2>, [Pair<L::Number>; 2]) {
        let (s, t) = (member(lanes, k, block, first, 0), member(lanes, k, block, first, 1));
        let gap = less(less(first.difference(lanes, k, &block.points), s), t);
        let rail = &first.rails[0];
        let h = turned(lanes, k, block, rail.class, rail.column);
        let slide = lanes.load(&block.slides[rail.slider], k);
        let (s, gap) = (s.plus_turned(h, slide), gap.minus_scaled(h, slide));
        let u = member(lanes, k, block, second, 0);
        let (g, v) = (member(lanes, k, block, second, 1), member(lanes, k, block, second, 2));
        let second_gap = less(less(less(second.difference(lanes, k, &block.points), u), g), v);
        ([[h, s, t], [g, u, v]], [gap, second_gap])
    }

    #[inline(always)]
    fn corrected<N: Number>([[h, s, t], [g, u, v]]: Columns<N, 2>, [by_s, by_t, by_h, by_g]: [N; 4]) -> Columns<N, 2> {
        let h = h.plus_turned(h, by_s);
        let s = s.plus_turned(s, by_s).plus_turned(h, by_h);
        let (t, u) = (t.plus_turned(t, by_t), u.plus_turned(u, by_s));
        [[h, s, t], [g.plus_turned(g, by_g), u, v.plus_turned(v, by_t)]]
    }

    #[inline(always)]
    fn store<L: Lanes, R: Row>(
        lanes: L,
        k: usize,
        [[h, s, t], [g, u, v]]: Columns<L::Number, 2>,
        [first, second]: &[Chain; 2],
        rows: &mut [[R; 2]],
    ) {
        lanes.store_pair(&mut rows[first.rails[0].column], k, h);
        lanes.store_pair(&mut rows[first.members[0].column], k, s);
        lanes.store_pair(&mut rows[first.members[1].column], k, t);
        lanes.store_pair(&mut rows[second.members[0].column], k, u);
        lanes.store_pair(&mut rows[second.members[1].column], k, g);
        lanes.store_pair(&mut rows[second.members[2].column], k, v);
    }

    #[inline(always)]
    fn sides<N: Number>(
        [first, second]: [Pair<N>; 2],
        [[h, s, t], [g, u, v]]: Columns<N, 2>,
        [x, y, speed, z]: [N; 4],
    ) -> [Pair<N>; 2] {
        let first = first.minus_turned(s, x * x).minus_turned(t, y * y).minus_turned(h, x * (speed + speed));
        [first, second.minus_turned(u, x * x).minus_turned(g, z * z).minus_turned(v, y * y)]
    }
}

/// The column of one of a loop's members.
#[inline(always)]
fn member<L: Lanes, R: Row>(lanes: L, k: usize, block: &Block<R>, chain: &Chain, index: usize) -> Pair<L::Number> {
    turned(lanes, k, block, chain.members[index].class, chain.members[index].column)
}

/// A column's vector turned with its class.
#[inline(always)]
fn turned<L: Lanes, R: Row>(lanes: L, k: usize, block: &Block<R>, class: usize, column: usize) -> Pair<L::Number> {
    lanes.pair(&block.turns[class], k).turn(lanes.pair(&block.lengths.columns[column], k))
}

/// A gap less a member's vector, of which the column is turned by +90°.
#[inline(always)]
fn less<N: Number>(gap: Pair<N>, column: Pair<N>) -> Pair<N> {
    Pair { x: gap.x - column.y, y: gap.y + column.x }
}

impl Shape {
    /// The shape of a group, if it has one of these: what `Equations` takes for granted about the order of members.
    pub fn of(closing: &Closing) -> Option<Shape> {
        if closing.chains.iter().any(|c| c.has_known) {
            return None;
        }
        let columns = |chain: &Chain| -> (Vec<usize>, Vec<[usize; 2]>) {
            let guides = chain.rails.iter().map(|r| [r.column, r.arm]);
            (chain.members.iter().map(|m| m.column).collect(), guides.collect())
        };
        let loops: Vec<_> = closing.chains.iter().map(columns).collect();
        match closing.reduced.as_ref()? {
            Reducing::One(equations) => {
                let [[_, s, t]] = equations.columns;
                (loops == [(vec![s, t], vec![])]).then_some(Shape::TwoTurns)
            }
            Reducing::Two(equations) => {
                let [[h, s, t], [g, u, v]] = equations.columns;
                let is_like = loops == [(vec![s, t], vec![[h, s]]), (vec![u, g, v], vec![])];
                is_like.then_some(Shape::SlideAndTurn)
            }
        }
    }
}

/// One Newton step of a group and the rates after it, if it has a shape. Returns the largest norm of a correction, as
/// [`solve`](super::solve::solve) does, and leaves the corrections in the block's solution: columns and rates are those
/// after them, but angles and slides are not, so that the step can be made anew if it turns out to be too large.
#[inline(always)]
pub(super) fn step_with_rates<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) -> Option<f64> {
    Some(match closing.shape? {
        Shape::TwoTurns => in_registers::<TwoTurns, _, _, 1>(lanes, block, closing),
        // The columns of two loops fill the registers once.
        Shape::SlideAndTurn => in_registers::<SlideAndTurn, _, _, 2>(lanes.narrow(), block, closing),
    })
}

/// That of a group with these equations.
#[inline(always)]
fn in_registers<E: Equations<LOOPS>, L: Lanes, R: Row, const LOOPS: usize>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
) -> f64 {
    let chains: &[Chain; LOOPS] = closing.chains.first_chunk().expect("as many loops");
    let (zero, one) = (lanes.splat(0.0), lanes.splat(1.0));
    let (mut sum, mut longest) = (zero, zero);
    for k in portions::<L, R>() {
        let mut squares = [one; LOOPS];
        for (square, row) in squares.iter_mut().zip(&block.systems[closing.group].inverse_squares) {
            *square = lanes.load(row, k);
        }
        let (columns, mut sides) = E::turned(lanes, k, block, chains);
        let equations = Reduced::with_inverse_squares(columns, squares);
        let steps = equations.solve(one / equations.determinant(), sides);
        let mut square = zero;
        for (i, step) in steps.into_iter().enumerate().take(2 * LOOPS) {
            lanes.store(&mut block.solution[i], k, step);
            let step = step * lanes.splat(closing.scales[i]);
            square = square.plus_product(step, step);
        }
        sum = sum + square;
        longest = longest.larger(square);
        let columns = E::corrected(columns, steps);
        E::store(lanes, k, columns, chains, &mut block.columns);
        let equations = Reduced::with_inverse_squares(columns, squares);
        let inverse = one / equations.determinant();
        lanes.store(&mut block.systems[closing.group].inverse_determinant, k, inverse);
        for i in 0..LOOPS {
            sides[i] = chains[i].difference(lanes, k, &block.point_velocities);
        }
        let rates = equations.solve(inverse, sides);
        for i in 0..LOOPS {
            sides[i] = chains[i].difference(lanes, k, &block.point_accelerations);
        }
        let seconds = equations.solve(inverse, E::sides(sides, columns, rates));
        for i in 0..2 * LOOPS {
            let (row, second_row) = match closing.unknowns[i] {
                Unknown::Spin(class) => (&mut block.omegas[class], &mut block.alphas[class]),
                Unknown::Slide(slider) => (&mut block.speeds[slider], &mut block.accelerations[slider]),
            };
            lanes.store(row, k, rates[i]);
            lanes.store(second_row, k, seconds[i]);
        }
    }
    largest_norm(lanes, sum, longest)
}
