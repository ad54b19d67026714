use super::action::{Action, Closing, Kernel, Order, Own, Pattern, PatternLoop};
use super::close::place;
use super::rates::point_rates;
use super::{Block, portions};
use crate::geometry::{Lanes, Number, Pair, Reduced, Row};

impl Kernel {
    /// Closes every group by a single Newton step from the angles and slides in `block`, places all points, and computes
    /// all rates if `RATES`: what [`Self::assemble`] and [`Self::rates`] do, to the last bit, but each group at a
    /// stroke, in registers.
    ///
    /// `false` if a correction is larger than `sure`, or if a group is not of the common kinds: angles and slides are
    /// then no longer those of before.
    #[inline(always)]
    pub fn close_at_once<L: Lanes, R: Row, const RATES: bool>(
        &self,
        lanes: L,
        block: &mut Block<R>,
        sure: f64,
    ) -> bool {
        for action in &self.actions {
            match action {
                Action::Place(placing) => {
                    place(lanes, block, placing);
                    if RATES {
                        point_rates(lanes, block, placing);
                    }
                }
                Action::Close(closing) => {
                    if compute::<L, R, true, RATES>(lanes, block, closing, sure) != Some(true) {
                        return false;
                    }
                }
            }
        }
        true
    }
}

/// Computes a group of one of the common kinds, each portion in registers: if `STEP` its position by one Newton step, if
/// `RATES` its rates. Whether no correction was larger than `sure`; `None` for other kinds.
#[inline(always)]
pub(super) fn compute<L: Lanes, R: Row, const STEP: bool, const RATES: bool>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
    sure: f64,
) -> Option<bool> {
    Some(match closing.pattern.as_ref()? {
        Pattern::One(chain) => match chain.own {
            Own::Slide { .. } => compute_one::<L, R, STEP, RATES, true>(lanes, block, closing, chain, sure),
            _ => compute_one::<L, R, STEP, RATES, false>(lanes, block, closing, chain, sure),
        },
        Pattern::Two([a, b]) => match [a.own, b.own] {
            [Own::Slide { .. }, Own::Spin(_)] => {
                compute_two::<L, R, STEP, RATES, true, false>(lanes, block, closing, [a, b], sure)
            }
            [Own::Spin(_), Own::Slide { .. }] => {
                compute_two::<L, R, STEP, RATES, false, true>(lanes, block, closing, [a, b], sure)
            }
            _ => compute_two::<L, R, STEP, RATES, false, false>(lanes, block, closing, [a, b], sure),
        },
    })
}

/// A loop's columns in the fixed frame, and which of them its slider lengthens.
#[derive(Clone, Copy)]
struct Columns<T, const SLIDES: bool> {
    arms: [Pair<T>; 2],
    own: Pair<T>,
    order: Order,
    on_second: bool,
}

impl<T: Number, const SLIDES: bool> Columns<T, SLIDES> {
    /// Columns, and the loop's gap, from the gap without members.
    #[inline(always)]
    fn new(chain: &PatternLoop, turns: [Pair<T>; 3], lengths: [Pair<T>; 3], slide: T, gap: Pair<T>) -> (Self, Pair<T>) {
        let on_second = matches!(chain.own, Own::Slide { on_second: true, .. });
        let [first, second, own] = turns;
        let own = if !SLIDES {
            own
        } else if on_second {
            second
        } else {
            first
        };
        let arms = [first.turn(lengths[0]), second.turn(lengths[1])];
        let mut columns = Columns { arms, own: own.turn(lengths[2]), order: chain.order, on_second };
        // A column is the member's vector turned by +90°.
        let mut gap = columns.subtract_turned(gap, [slide.same(-1.0); 3], None);
        if SLIDES {
            columns.lengthen(slide);
            gap = gap.minus_scaled(columns.own, slide);
        }
        (columns, gap)
    }

    /// Columns computed before.
    #[inline(always)]
    fn stored<L: Lanes<Number = T>, R: Row>(lanes: L, k: usize, chain: &PatternLoop, rows: [&[R; 2]; 3]) -> Self {
        let on_second = matches!(chain.own, Own::Slide { on_second: true, .. });
        let arms = [lanes.pair(rows[0], k), lanes.pair(rows[1], k)];
        Columns { arms, own: lanes.pair(rows[2], k), order: chain.order, on_second }
    }

    /// side − J c w of the members' columns c with the weights w, in the order of the loop; `alpha` is that of a second
    /// arm whose rotation is known.
    #[inline(always)]
    fn subtract_turned(&self, side: Pair<T>, [u, v, w]: [T; 3], alpha: Option<T>) -> Pair<T> {
        let Columns { arms: [a, b], own: c, .. } = *self;
        match self.order {
            Order::A => side.minus_turned(a, u),
            Order::Ab => known(side.minus_turned(a, u).minus_turned(b, v), b, alpha),
            Order::Ba => known(side.minus_turned(b, v), b, alpha).minus_turned(a, u),
            Order::Abc => side.minus_turned(a, u).minus_turned(b, v).minus_turned(c, w),
            Order::Acb => side.minus_turned(a, u).minus_turned(c, w).minus_turned(b, v),
            Order::Bac => side.minus_turned(b, v).minus_turned(a, u).minus_turned(c, w),
            Order::Bca => side.minus_turned(b, v).minus_turned(c, w).minus_turned(a, u),
            Order::Cab => side.minus_turned(c, w).minus_turned(a, u).minus_turned(b, v),
            Order::Cba => side.minus_turned(c, w).minus_turned(b, v).minus_turned(a, u),
        }
    }

    /// Adds a slide along the guide to the arm that it lengthens.
    #[inline(always)]
    fn lengthen(&mut self, slide: T) {
        if self.on_second {
            self.arms[1] = self.arms[1].plus_turned(self.own, slide);
        } else {
            self.arms[0] = self.arms[0].plus_turned(self.own, slide);
        }
    }

    /// Turns the columns by tiny corrections; none for a second arm whose rotation is known.
    #[inline(always)]
    fn correct(&mut self, first: T, second: Option<T>, own: T) {
        self.arms[0] = self.arms[0].plus_turned(self.arms[0], first);
        if let Some(second) = second {
            self.arms[1] = self.arms[1].plus_turned(self.arms[1], second);
        }
        if !SLIDES {
            self.own = self.own.plus_turned(self.own, own);
            return;
        }
        if !self.on_second {
            self.own = self.own.plus_turned(self.own, first);
        } else if let Some(second) = second {
            self.own = self.own.plus_turned(self.own, second);
        }
        self.lengthen(own);
    }

    /// a_end − a_start + Σ ω² r − 2 ω ṡ J u, from the first difference.
    #[inline(always)]
    fn acceleration_side(&self, side: Pair<T>, [first, second, own]: [T; 3], alpha: Option<T>) -> Pair<T> {
        let side = self.subtract_turned(side, [first * first, second * second, own * own], alpha);
        if !SLIDES {
            return side;
        }
        let omega = if self.on_second { second } else { first };
        side.minus_turned(self.own, omega * (own + own))
    }
}

/// − c α of an arm with a known rotation.
#[inline(always)]
fn known<T: Number>(side: Pair<T>, column: Pair<T>, alpha: Option<T>) -> Pair<T> {
    match alpha {
        Some(alpha) => side.minus_scaled(column, alpha),
        None => side,
    }
}

/// Where a loop is computed from: places, velocities and accelerations of its start and of its end, and its lengths.
struct Sources<'a, R> {
    ends: Option<[[&'a [R; 2]; 2]; 3]>,
    lengths: [&'a [R; 2]; 3],
}

impl<'a, R: Row> Sources<'a, R> {
    #[inline(always)]
    fn new(chain: &PatternLoop, values: [&'a [[R; 2]]; 3], lengths: &'a [[R; 2]]) -> Self {
        let ends = match chain.ends {
            Some([start, end]) => Some([
                [&values[0][start], &values[0][end]],
                [&values[1][start], &values[1][end]],
                [&values[2][start], &values[2][end]],
            ]),
            None => None,
        };
        let [first, second, own] = chain.columns();
        Sources { ends, lengths: [&lengths[first], &lengths[second], &lengths[own]] }
    }

    /// The `order`th derivative of the vector from the loop's start to its end.
    #[inline(always)]
    fn difference<L: Lanes>(&self, lanes: L, k: usize, order: usize) -> Pair<L::Number> {
        match &self.ends {
            Some(ends) => lanes.pair(ends[order][1], k) - lanes.pair(ends[order][0], k),
            None => Pair { x: lanes.splat(0.0), y: lanes.splat(0.0) },
        }
    }

    #[inline(always)]
    fn lengths<L: Lanes>(&self, lanes: L, k: usize) -> [Pair<L::Number>; 3] {
        [lanes.pair(self.lengths[0], k), lanes.pair(self.lengths[1], k), lanes.pair(self.lengths[2], k)]
    }
}

#[inline(always)]
fn compute_two<L: Lanes, R: Row, const STEP: bool, const RATES: bool, const A: bool, const B: bool>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
    [first, second]: [&PatternLoop; 2],
    sure: f64,
) -> bool {
    let system = &mut block.systems[closing.group];
    let inverse_squares = system.inverse_squares.each_ref();
    let inverses = &mut system.inverse_determinant;
    let one = lanes.splat(1.0);
    let (limit, per_size) = (lanes.splat(sure * sure), lanes.splat(1.0 / closing.size));
    let classes = [first.first.class, first.second.class, first.own_class(), second.own_class()];
    let slider = if A { first.slider() } else { second.slider() };
    let turns = block.turns.get_disjoint_mut(classes).expect("four classes");
    let omegas = block.omegas.get_disjoint_mut(classes).expect("four classes");
    let alphas = block.alphas.get_disjoint_mut(classes).expect("four classes");
    let points: [&[[R; 2]]; 3] = [&block.points, &block.point_velocities, &block.point_accelerations];
    let sources =
        [Sources::new(first, points, &block.lengths.columns), Sources::new(second, points, &block.lengths.columns)];
    let [[a, b, c], [d, e, f]] = [first.columns(), second.columns()];
    let stored = block.columns.get_disjoint_mut([a, b, c, d, e, f]).expect("six columns");
    let mut is_sure = true;
    for k in portions::<L, R>() {
        let squares = [lanes.load(inverse_squares[0], k), lanes.load(inverse_squares[1], k)];
        let mut a = Columns::<_, A>::stored(lanes, k, first, [&stored[0], &stored[1], &stored[2]]);
        let mut b = Columns::<_, B>::stored(lanes, k, second, [&stored[3], &stored[4], &stored[5]]);
        if STEP {
            let turn =
                [lanes.pair(turns[0], k), lanes.pair(turns[1], k), lanes.pair(turns[2], k), lanes.pair(turns[3], k)];
            let slide = if A || B { lanes.load(&block.slides[slider], k) } else { one };
            let gap;
            (a, gap) = Columns::<_, A>::new(
                first,
                [turn[0], turn[1], turn[2]],
                sources[0].lengths(lanes, k),
                slide,
                sources[0].difference(lanes, k, 0),
            );
            let other;
            (b, other) = Columns::<_, B>::new(
                second,
                [turn[0], turn[1], turn[3]],
                sources[1].lengths(lanes, k),
                slide,
                sources[1].difference(lanes, k, 0),
            );
            let system = system_of_two(&a, &b, squares);
            let steps = system.solve(one / system.determinant(), [gap, other]);
            let scaled =
                [if A { steps[2] * per_size } else { steps[2] }, if B { steps[3] * per_size } else { steps[3] }];
            let square = (steps[0] * steps[0]).plus_product(steps[1], steps[1]);
            let square = square.plus_product(scaled[0], scaled[0]).plus_product(scaled[1], scaled[1]);
            is_sure &= lanes.are_at_most(square, limit);
            a.correct(steps[0], Some(steps[1]), steps[2]);
            b.correct(steps[0], Some(steps[1]), steps[3]);
            lanes.store_pair(stored[0], k, a.arms[0]);
            lanes.store_pair(stored[1], k, a.arms[1]);
            lanes.store_pair(stored[2], k, a.own);
            lanes.store_pair(stored[3], k, b.arms[0]);
            lanes.store_pair(stored[4], k, b.arms[1]);
            lanes.store_pair(stored[5], k, b.own);
            lanes.store_pair(turns[0], k, turn[0].plus_turned(turn[0], steps[0]));
            lanes.store_pair(turns[1], k, turn[1].plus_turned(turn[1], steps[1]));
            if A {
                lanes.store(&mut block.slides[slider], k, slide + steps[2]);
            } else {
                lanes.store_pair(turns[2], k, turn[2].plus_turned(turn[2], steps[2]));
            }
            if B {
                lanes.store(&mut block.slides[slider], k, slide + steps[3]);
            } else {
                lanes.store_pair(turns[3], k, turn[3].plus_turned(turn[3], steps[3]));
            }
        }
        if RATES {
            let system = system_of_two(&a, &b, squares);
            let inverse = one / system.determinant();
            lanes.store(inverses, k, inverse);
            let sides = [sources[0].difference(lanes, k, 1), sources[1].difference(lanes, k, 1)];
            let rates = system.solve(inverse, sides);
            let side = sources[0].difference(lanes, k, 2);
            let side = a.acceleration_side(side, [rates[0], rates[1], rates[2]], None);
            let other = sources[1].difference(lanes, k, 2);
            let other = b.acceleration_side(other, [rates[0], rates[1], rates[3]], None);
            let seconds = system.solve(inverse, [side, other]);
            lanes.store(omegas[0], k, rates[0]);
            lanes.store(omegas[1], k, rates[1]);
            lanes.store(alphas[0], k, seconds[0]);
            lanes.store(alphas[1], k, seconds[1]);
            if A {
                lanes.store(&mut block.speeds[slider], k, rates[2]);
                lanes.store(&mut block.accelerations[slider], k, seconds[2]);
            } else {
                lanes.store(omegas[2], k, rates[2]);
                lanes.store(alphas[2], k, seconds[2]);
            }
            if B {
                lanes.store(&mut block.speeds[slider], k, rates[3]);
                lanes.store(&mut block.accelerations[slider], k, seconds[3]);
            } else {
                lanes.store(omegas[3], k, rates[3]);
                lanes.store(alphas[3], k, seconds[3]);
            }
        }
    }
    is_sure
}

#[inline(always)]
fn system_of_two<T: Number, const A: bool, const B: bool>(
    a: &Columns<T, A>,
    b: &Columns<T, B>,
    squares: [T; 2],
) -> Reduced<2, T> {
    Reduced::with_inverse_squares([[a.own, a.arms[0], a.arms[1]], [b.own, b.arms[0], b.arms[1]]], squares)
}

#[inline(always)]
fn compute_one<L: Lanes, R: Row, const STEP: bool, const RATES: bool, const SLIDES: bool>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
    chain: &PatternLoop,
    sure: f64,
) -> bool {
    let inverses = &mut block.systems[closing.group].inverse_determinant;
    let one = lanes.splat(1.0);
    let (limit, per_size) = (lanes.splat(sure * sure), lanes.splat(1.0 / closing.size));
    let classes = [chain.first.class, chain.second.class];
    let slider = chain.slider();
    let turns = block.turns.get_disjoint_mut(classes).expect("two classes");
    let omegas = block.omegas.get_disjoint_mut(classes).expect("two classes");
    let alphas = block.alphas.get_disjoint_mut(classes).expect("two classes");
    let points: [&[[R; 2]]; 3] = [&block.points, &block.point_velocities, &block.point_accelerations];
    let source = Sources::new(chain, points, &block.lengths.columns);
    let columns = chain.columns();
    let stored = block.columns.get_disjoint_mut(columns).expect("three columns");
    // Whether the second arm is there, with a known rotation.
    let has_known = SLIDES && chain.order != Order::A;
    let mut is_sure = true;
    for k in portions::<L, R>() {
        let mut columns = Columns::<_, SLIDES>::stored(lanes, k, chain, [&stored[0], &stored[1], &stored[2]]);
        if STEP {
            let turn = [lanes.pair(turns[0], k), lanes.pair(turns[1], k)];
            let slide = if SLIDES { lanes.load(&block.slides[slider], k) } else { one };
            let lengths = source.lengths(lanes, k);
            let gap;
            (columns, gap) = Columns::<_, SLIDES>::new(
                chain,
                [turn[0], turn[1], turn[1]],
                lengths,
                slide,
                source.difference(lanes, k, 0),
            );
            let system = system_of_one(&columns);
            let [x, y, ..] = system.solve(one / system.determinant(), [gap]);
            let scaled = if SLIDES { y * per_size } else { y };
            is_sure &= lanes.are_at_most((x * x).plus_product(scaled, scaled), limit);
            columns.correct(x, (!SLIDES).then_some(y), y);
            lanes.store_pair(stored[0], k, columns.arms[0]);
            lanes.store_pair(turns[0], k, turn[0].plus_turned(turn[0], x));
            if SLIDES {
                lanes.store(&mut block.slides[slider], k, slide + y);
                lanes.store_pair(stored[2], k, columns.own);
                if has_known {
                    lanes.store_pair(stored[1], k, columns.arms[1]);
                }
            } else {
                lanes.store_pair(stored[1], k, columns.arms[1]);
                lanes.store_pair(turns[1], k, turn[1].plus_turned(turn[1], y));
            }
        }
        if RATES {
            let system = system_of_one(&columns);
            let inverse = one / system.determinant();
            lanes.store(inverses, k, inverse);
            let mut side = source.difference(lanes, k, 1);
            let (mut known_omega, mut known_alpha) = (one, None);
            if has_known {
                known_omega = lanes.load(omegas[1], k);
                known_alpha = Some(lanes.load(alphas[1], k));
                side = side.minus_scaled(columns.arms[1], known_omega);
            }
            let [x, y, ..] = system.solve(inverse, [side]);
            let side = source.difference(lanes, k, 2);
            let second = if SLIDES { known_omega } else { y };
            let side = columns.acceleration_side(side, [x, second, y], known_alpha);
            let [z, w, ..] = system.solve(inverse, [side]);
            lanes.store(omegas[0], k, x);
            lanes.store(alphas[0], k, z);
            if SLIDES {
                lanes.store(&mut block.speeds[slider], k, y);
                lanes.store(&mut block.accelerations[slider], k, w);
            } else {
                lanes.store(omegas[1], k, y);
                lanes.store(alphas[1], k, w);
            }
        }
    }
    is_sure
}

#[inline(always)]
fn system_of_one<T: Number, const SLIDES: bool>(columns: &Columns<T, SLIDES>) -> Reduced<1, T> {
    let [s, second] = columns.arms;
    let t = if SLIDES { columns.own } else { second };
    Reduced::with_inverse_squares([[s, s, t]], [s.x.same(1.0)])
}
