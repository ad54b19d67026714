//! Where mechanisms side by side were, with their rates: what these let expect of the next position, and whether it is that of the same branch.

use crate::geometry::{Lanes, MANY, Many, Number, Pair, Row, portions};
use crate::kernel::{Block, InputKind, Kernel, Unknown};

/// Angle, in radians, or part of a slide to which positions and rates must agree.
const AGREED: f64 = 1e-4;

/// Where mechanisms side by side were, with their rates.
#[derive(Clone, Debug)]
pub struct Kept(pub(super) Vec<Rates>);

/// All rows of a block in one piece of memory: many are kept.
#[derive(Clone, Debug)]
pub(super) struct Rates(Vec<Many>);

/// The rows of [`Rates`].
pub(super) struct Rows<'a> {
    pub turns: &'a [[Many; 2]],
    pub slides: &'a [Many],
    omegas: &'a [Many],
    alphas: &'a [Many],
    speeds: &'a [Many],
    accelerations: &'a [Many],
    /// By group.
    inverse_determinants: &'a [Many],
}

impl Rates {
    pub fn of(kernel: &Kernel, block: &Block<Many>) -> Rates {
        let groups = kernel.unknowns.len();
        let mut rows = Vec::with_capacity(4 * block.omegas.len() + 3 * block.slides.len() + groups);
        rows.extend_from_slice(block.turns.as_flattened());
        for part in [&block.slides, &block.omegas, &block.alphas, &block.speeds, &block.accelerations] {
            rows.extend_from_slice(part);
        }
        rows.extend((0..groups).map(|group| kernel.inverse_determinants(block, group)));
        Rates(rows)
    }

    /// The rows, of which a block has as many.
    pub fn rows(&self, block: &Block<Many>) -> Rows<'_> {
        let (classes, sliders) = (block.omegas.len(), block.slides.len());
        let (turns, rest) = self.0.split_at(2 * classes);
        let (slides, rest) = rest.split_at(sliders);
        let (omegas, rest) = rest.split_at(classes);
        let (alphas, rest) = rest.split_at(classes);
        let (speeds, rest) = rest.split_at(sliders);
        let (accelerations, inverse_determinants) = rest.split_at(sliders);
        Rows { turns: turns.as_chunks().0, slides, omegas, alphas, speeds, accelerations, inverse_determinants }
    }
}

/// A position, and the weights of its values, first and second derivatives in another one.
type Weighted<'a> = (Rows<'a>, [f64; 3]);

/// Moves the unknowns of a block to where they are expected `time` after `was`; those without a time stay. The rates there say it, and those at
/// `before`, if that is as long before.
#[inline(always)]
pub(super) fn run_on<L: Lanes>(
    lanes: L,
    kernel: &Kernel,
    before: Option<&Rates>,
    was: &Rates,
    block: &mut Block<Many>,
    time: &Many,
) {
    match before {
        // The value at 2 of the polynomial of degree 5 with these values, first and second derivatives at 0 and at 1.
        Some(before) => {
            let from = [(before.rows(block), [-31.0, -14.0, -2.0]), (was.rows(block), [32.0, -16.0, 4.0])];
            expect(lanes, kernel, &from, block, time);
        }
        None => expect(lanes, kernel, &[(was.rows(block), [1.0, 1.0, 0.5])], block, time),
    }
}

#[inline(always)]
fn expect<L: Lanes>(lanes: L, kernel: &Kernel, from: &[Weighted], block: &mut Block<Many>, time: &Many) {
    let zero = lanes.splat(0.0);
    for unknown in kernel.unknowns.iter().flatten() {
        match *unknown {
            Unknown::Spin(class) => {
                let turns = &mut block.turns[class];
                let old = *turns;
                for k in portions::<L, Many>() {
                    let time = lanes.load(time, k);
                    let mut sum = Pair { x: zero, y: zero };
                    for (rows, weights) in from {
                        let [own, first, second] =
                            [lanes.splat(weights[0]), lanes.splat(weights[1]), lanes.splat(weights[2])];
                        let omega = lanes.load(&rows.omegas[class], k) * time;
                        let alpha = lanes.load(&rows.alphas[class], k) * time * time;
                        // The derivatives of a direction d are ω J d and (α J − ω²) d.
                        let along = own.minus_product(second, omega * omega);
                        let across = (first * omega).plus_product(second, alpha);
                        let direction = lanes.pair(&rows.turns[class], k);
                        sum = sum.plus_scaled(direction, along).plus_turned(direction, across);
                    }
                    lanes.store_pair(turns, k, sum * (lanes.splat(1.0) / sum.dot(sum).sqrt()));
                }
                stay(&mut turns[0], &old[0], time);
                stay(&mut turns[1], &old[1], time);
            }
            Unknown::Slide(slider) => {
                let slides = &mut block.slides[slider];
                let old = *slides;
                for k in portions::<L, Many>() {
                    let time = lanes.load(time, k);
                    let mut sum = zero;
                    for (rows, weights) in from {
                        let speed = lanes.load(&rows.speeds[slider], k) * time;
                        let acceleration = lanes.load(&rows.accelerations[slider], k) * time * time;
                        sum = sum.plus_product(lanes.splat(weights[0]), lanes.load(&rows.slides[slider], k));
                        sum = sum.plus_product(lanes.splat(weights[1]), speed);
                        sum = sum.plus_product(lanes.splat(weights[2]), acceleration);
                    }
                    lanes.store(slides, k, sum);
                }
                stay(slides, &old, time);
            }
        }
    }
}

/// Puts back what has no time.
#[inline(always)]
fn stay(row: &mut Many, old: &Many, time: &Many) {
    for lane in 0..MANY {
        row[lane] = if time[lane] == 0.0 { old[lane] } else { row[lane] };
    }
}

/// As `Variants::kept_branch`, for the mechanisms of a block.
///
/// What is wrong is counted, in numbers, so that the compiler uses registers of many.
#[inline(always)]
pub(super) fn kept_branch(kernel: &Kernel, was: &Rates, block: &Block<Many>, time: &Many) -> [bool; MANY] {
    let was = was.rows(block);
    let mut wrong = Many::splat(0.0);
    let mut ask = |lane: usize, is_right: bool| wrong[lane] += if is_right { 0.0 } else { 1.0 };
    for (group, was) in was.inverse_determinants.iter().enumerate() {
        let is = kernel.inverse_determinants(block, group);
        for lane in 0..MANY {
            ask(
                lane,
                (is[lane].abs() < f64::INFINITY) & (was[lane].abs() < f64::INFINITY) & (is[lane] * was[lane] > 0.0),
            );
        }
    }
    let passed =
        |time: f64, was: [f64; 2], is: [f64; 2]| time * (0.5 * (was[0] + is[0]) + time / 12.0 * (was[1] - is[1]));
    for unknown in kernel.unknowns.iter().flatten() {
        let Unknown::Spin(class) = *unknown else { continue };
        let (from, to) = (&was.turns[class], &block.turns[class]);
        let (omegas, alphas) = ([&was.omegas[class], &block.omegas[class]], [&was.alphas[class], &block.alphas[class]]);
        for lane in 0..MANY {
            let rates = |end: usize| [omegas[end][lane], alphas[end][lane]];
            let by = passed(time[lane], rates(0), rates(1));
            let ([c0, s0], [c1, s1]) = ([from[0][lane], from[1][lane]], [to[0][lane], to[1][lane]]);
            let (sine, cosine) = (c0 * s1 - s0 * c1, c0 * c1 + s0 * s1);
            ask(lane, (by.abs() <= 1.0) & (cosine > 0.0) & ((sine - short_sine(by)).abs() <= AGREED));
        }
    }
    for input in &kernel.inputs {
        if let InputKind::Turning { class } = input.kind {
            let omega = &block.omegas[class];
            for lane in 0..MANY {
                ask(lane, (time[lane] * omega[lane]).abs() <= 1.0);
            }
        }
    }
    for (slider, (from, to)) in was.slides.iter().zip(&block.slides).enumerate() {
        let speeds = [&was.speeds[slider], &block.speeds[slider]];
        let seconds = [&was.accelerations[slider], &block.accelerations[slider]];
        for lane in 0..MANY {
            let rates = |end: usize| [speeds[end][lane], seconds[end][lane]];
            let by = passed(time[lane], rates(0), rates(1));
            let size = to[lane].abs().max(from[lane].abs());
            let moved = to[lane] - from[lane];
            ask(lane, (moved - by).abs() <= AGREED * size.max(moved.abs()));
        }
    }
    wrong.0.map(|count| count == 0.0)
}

/// The sine of up to a radian, to a millionth.
#[inline(always)]
fn short_sine(x: f64) -> f64 {
    let square = x * x;
    x * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))))
}
