use super::action::{Closing, ReducedColumns};
use super::block::System;
use super::{Block, vector};
use crate::geometry::{Lanes, LinearSystem, Pair, Reduced, Row, portions};
use nalgebra::DMatrix;

/// Solves a group's equations for the block's right sides; factors them first if `FACTOR`, else uses the factors from
/// before.
#[inline(always)]
pub(super) fn solve<L: Lanes, R: Row, const FACTOR: bool>(lanes: L, block: &mut Block<R>, closing: &Closing) {
    let Block { columns, systems, sides, tie_sides, solution, .. } = block;
    let system = &mut systems[closing.group];
    let Some(reduced) = closing.reduced else {
        if FACTOR {
            system.general = general_systems(columns, closing);
        }
        let (sides, tie_sides) = (&sides[..closing.chains.len()], &tie_sides[..closing.ties.len()]);
        return solve_general(system, sides, tie_sides, solution);
    };
    let System { inverse_determinant, inverse_squares, .. } = system;
    let one = lanes.splat(1.0);
    match reduced {
        ReducedColumns::One([s, t]) => {
            let (s, t) = (&columns[s], &columns[t]);
            let [x, y] = solution.first_chunk_mut().expect("room for two unknowns");
            for k in portions::<L, R>() {
                let (s, t) = (lanes.pair(s, k), lanes.pair(t, k));
                let system = Reduced::with_inverse_squares([[s, s, t]], [one]);
                let inverse = if FACTOR { one / system.determinant() } else { lanes.load(inverse_determinant, k) };
                if FACTOR {
                    lanes.store(inverse_determinant, k, inverse);
                }
                let solved = system.solve(inverse, [lanes.pair(&sides[0], k)]);
                lanes.store(x, k, solved[0]);
                lanes.store(y, k, solved[1]);
            }
        }
        ReducedColumns::Two { columns: [[h, s, t], [g, u, v]], varies } => {
            let (h, s, t) = (&columns[h], &columns[s], &columns[t]);
            let (g, u, v) = (&columns[g], &columns[u], &columns[v]);
            let sides: &[[R; 2]; 2] = sides.first_chunk().expect("room for two loops");
            let [x, y, first, second] = solution.first_chunk_mut().expect("room for four");
            for k in portions::<L, R>() {
                let (h, g) = (lanes.pair(h, k), lanes.pair(g, k));
                if FACTOR && varies[0] {
                    lanes.store(&mut inverse_squares[0], k, one / h.dot(h));
                }
                if FACTOR && varies[1] {
                    lanes.store(&mut inverse_squares[1], k, one / g.dot(g));
                }
                let columns = [[h, lanes.pair(s, k), lanes.pair(t, k)], [g, lanes.pair(u, k), lanes.pair(v, k)]];
                let squares = [lanes.load(&inverse_squares[0], k), lanes.load(&inverse_squares[1], k)];
                let system = Reduced::with_inverse_squares(columns, squares);
                let inverse = if FACTOR { one / system.determinant() } else { lanes.load(inverse_determinant, k) };
                if FACTOR {
                    lanes.store(inverse_determinant, k, inverse);
                }
                let sides = [lanes.pair(&sides[0], k), lanes.pair(&sides[1], k)];
                let solved = system.solve(inverse, sides);
                lanes.store(x, k, solved[0]);
                lanes.store(y, k, solved[1]);
                lanes.store(first, k, solved[2]);
                lanes.store(second, k, solved[3]);
            }
        }
    }
}

/// The factored systems of a group that does not reduce, by position.
#[inline(never)]
fn general_systems<R: Row>(columns: &[[R; 2]], closing: &Closing) -> Vec<Option<LinearSystem>> {
    let (loops, unknowns) = (closing.chains.len(), closing.unknowns.len());
    let system = |position: usize| {
        let matrix = DMatrix::from_fn(2 * loops + closing.ties.len(), unknowns, |row, unknown| {
            match closing.chains.get(row / 2) {
                Some(chain) => columns[chain.columns[unknown]][row % 2][position],
                None => closing.ties[row - 2 * loops].weight(unknown),
            }
        });
        LinearSystem::new((matrix.nrows() == matrix.ncols()).then_some(matrix)?)
    };
    (0..R::LEN).map(system).collect()
}

#[inline(never)]
fn solve_general<R: Row>(system: &System<R>, sides: &[[R; 2]], tie_sides: &[R], solution: &mut [R]) {
    for (position, system) in system.general.iter().enumerate() {
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
        Some(ReducedColumns::One([s, t])) => {
            let system = Reduced::new([[s, s, t].map(column)]);
            [system.determinant(), system.squared_sharpness()]
        }
        Some(ReducedColumns::Two { columns, .. }) => {
            let system = Reduced::new(columns.map(|c| c.map(column)));
            [system.determinant(), system.squared_sharpness()]
        }
        None => {
            let systems = &block.systems[closing.group].general;
            let system = systems.get(position).and_then(Option::as_ref);
            system.map_or([0.0; 2], |s| [s.determinant(), s.condition().powi(-2)])
        }
    }
}
