use super::action::{Closing, Reducible, Reducing};
use super::block::System;
use super::{Block, vector};
use crate::geometry::{Lanes, LinearSystem, Number, Pair, Reduced, Row, portions};
use nalgebra::DMatrix;

/// Factors a group's equations and solves them for the block's right sides. Returns the largest norm of a position's
/// solution, as a vector of angles in radians and slides in parts of the group's size: an upper bound of its
/// components. NaN if one is NaN.
#[inline(always)]
pub(super) fn solve<L: Lanes, R: Row>(lanes: L, block: &mut Block<R>, closing: &Closing) -> f64 {
    match &closing.reduced {
        Some(Reducing::One(equations)) => solve_reduced(lanes, block, closing, equations),
        // The columns of two loops fill the registers once.
        Some(Reducing::Two(equations)) => solve_reduced(lanes.narrow(), block, closing, equations),
        None => {
            block.systems[closing.group].general = general_systems(&block.columns, closing);
            solve_general(block, closing);
            let (mut sum, mut longest) = (lanes.splat(0.0), lanes.splat(0.0));
            for k in portions::<L, R>() {
                let mut square = lanes.splat(0.0);
                for (scale, steps) in closing.scales.iter().zip(&block.solution) {
                    let step = lanes.load(steps, k) * lanes.splat(*scale);
                    square = square.plus_product(step, step);
                }
                sum = sum + square;
                longest = longest.larger(square);
            }
            largest_norm(lanes, sum, longest)
        }
    }
}

/// The largest norm, from the sum and the largest of the squares: a NaN may be lost in the largest number, but not in
/// the sum.
#[inline(always)]
pub(super) fn largest_norm<L: Lanes>(lanes: L, sum: L::Number, longest: L::Number) -> f64 {
    if lanes.sum(sum).is_nan() { f64::NAN } else { lanes.largest(longest).sqrt() }
}

/// As [`solve`], for equations that reduce.
#[inline(always)]
fn solve_reduced<L: Lanes, R: Row, const LOOPS: usize>(
    lanes: L,
    block: &mut Block<R>,
    closing: &Closing,
    equations: &Reducible<LOOPS>,
) -> f64 {
    let (mut sum, mut longest) = (lanes.splat(0.0), lanes.splat(0.0));
    for k in portions::<L, R>() {
        let square = solve_portion(lanes, k, block, closing, equations);
        sum = sum + square;
        longest = longest.larger(square);
    }
    largest_norm(lanes, sum, longest)
}

/// Solves reduced equations in one portion, in registers. Returns the squared norms.
#[inline(always)]
fn solve_portion<L: Lanes, R: Row, const LOOPS: usize>(
    lanes: L,
    k: usize,
    block: &mut Block<R>,
    closing: &Closing,
    equations: &Reducible<LOOPS>,
) -> L::Number {
    let Block { columns, systems, sides, solution, .. } = block;
    let (system, inverse) = factor(lanes, k, equations, columns, &mut systems[closing.group]);
    let mut right = [lanes.pair(&sides[0], k); LOOPS];
    for index in 1..LOOPS {
        right[index] = lanes.pair(&sides[index], k);
    }
    let solved = system.solve(inverse, right);
    let mut square = lanes.splat(0.0);
    for index in 0..2 * LOOPS {
        lanes.store(&mut solution[index], k, solved[index]);
        let step = solved[index] * lanes.splat(closing.scales[index]);
        square = square.plus_product(step, step);
    }
    square
}

/// The reduced equations in one portion, and the inverse of their determinant.
#[inline(always)]
pub(super) fn factor<L: Lanes, R: Row, const LOOPS: usize>(
    lanes: L,
    k: usize,
    equations: &Reducible<LOOPS>,
    columns: &[[R; 2]],
    system: &mut System<R>,
) -> (Reduced<LOOPS, L::Number>, L::Number) {
    let one = lanes.splat(1.0);
    let mut own = [[Pair { x: one, y: one }; 3]; LOOPS];
    let mut squares = [one; LOOPS];
    for index in 0..LOOPS {
        let [h, s, t] = equations.columns[index];
        own[index] = [lanes.pair(&columns[h], k), lanes.pair(&columns[s], k), lanes.pair(&columns[t], k)];
        let row = &mut system.inverse_squares[index];
        squares[index] = lanes.load(row, k);
        if equations.varies[index] {
            squares[index] = one / own[index][0].dot(own[index][0]);
            lanes.store(row, k, squares[index]);
        }
    }
    let reduced = Reduced::with_inverse_squares(own, squares);
    let inverse = one / reduced.determinant();
    lanes.store(&mut system.inverse_determinant, k, inverse);
    (reduced, inverse)
}

/// The factored systems of a group that does not reduce, by position.
#[inline(never)]
pub(super) fn general_systems<R: Row>(columns: &[[R; 2]], closing: &Closing) -> Vec<Option<LinearSystem>> {
    let (loops, unknowns) = (closing.chains.len(), closing.unknowns.len());
    let system = |position: usize| {
        let matrix = DMatrix::from_fn(2 * loops + closing.ties.len(), unknowns, |row, unknown| {
            match closing.chains.get(row / 2) {
                Some(chain) => columns[chain.columns[unknown]][row % 2][position],
                None => closing.ties[row - 2 * loops].weight(unknown),
            }
        });
        LinearSystem::of_vectors((matrix.nrows() == matrix.ncols()).then_some(matrix)?, loops)
    };
    (0..R::LEN).map(system).collect()
}

/// Solves the factored equations of a group that does not reduce for the block's right sides.
#[inline(never)]
pub(super) fn solve_general<R: Row>(block: &mut Block<R>, closing: &Closing) {
    let Block { systems, sides, tie_sides, solution, .. } = block;
    let (sides, tie_sides) = (&sides[..closing.chains.len()], &tie_sides[..closing.ties.len()]);
    for (position, system) in systems[closing.group].general.iter().enumerate() {
        let side: Vec<f64> = sides.iter().flatten().chain(tie_sides).map(|row| row[position]).collect();
        let solved = system.as_ref().map(|system| system.solve(&side));
        for (unknown, row) in solution[..side.len()].iter_mut().enumerate() {
            row[position] = solved.as_ref().map_or(f64::NAN, |s| s[unknown]);
        }
    }
}

/// The determinant of a group's equations at one position, and the square of Hadamard's ratio; zeros for a singular
/// system.
pub(super) fn determinant<R: Row>(block: &Block<R>, closing: &Closing, position: usize) -> [f64; 2] {
    let column = |index: usize| Pair::from(vector(&block.columns[index], position));
    match closing.reduced {
        Some(Reducing::One(equations)) => {
            let system = Reduced::new(equations.columns.map(|c| c.map(column)));
            [system.determinant(), system.squared_hadamard_ratio()]
        }
        Some(Reducing::Two(equations)) => {
            let system = Reduced::new(equations.columns.map(|c| c.map(column)));
            [system.determinant(), system.squared_hadamard_ratio()]
        }
        None => {
            let systems = &block.systems[closing.group].general;
            let system = systems.get(position).and_then(Option::as_ref);
            system.map_or([0.0; 2], |s| [s.determinant(), s.condition().powi(-2)])
        }
    }
}
