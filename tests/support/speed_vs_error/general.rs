//! The joint equations of all links in f64: twelve unknowns, solved by nalgebra.

use super::joints::{Given, JointEquations};
use super::measure::{Pins, Rates};
use nalgebra::{SMatrix, SVector};

/// Unknowns of a fourth-class group.
const SIZE: usize = 12;

/// How the equations are solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// Triangular factors with partial pivoting.
    Lu,
    /// Orthogonal factors.
    Qr,
}

/// Velocities and accelerations; infinite where the solver finds the equations singular.
pub fn rates(equations: &JointEquations, given: &Given<f64>, pins: &Pins, solver: Solver) -> Rates<f64> {
    let mut matrix = SMatrix::<f64, SIZE, SIZE>::zeros();
    equations.matrix(given, |row, column, value| matrix[(row, column)] += value);
    type Side = SVector<f64, SIZE>;
    let [first, second] = match solver {
        Solver::Lu => {
            let factors = matrix.lu();
            both(equations, given, |side| factors.solve(&side))
        }
        Solver::Qr => {
            let factors = matrix.qr();
            both(equations, given, |side: Side| factors.solve(&side))
        }
    };
    let rate = |solution: &Side, link: usize| solution[3 * link + 2];
    let links = [0, 1, 2, 3];
    let states = equations.states(given, first.as_slice(), second.as_slice());
    let at = |link: usize, point: usize| {
        let body = &states[pins.bodies[link]];
        let place = pins.places[point];
        (body.velocity_at(place), body.acceleration_at(place))
    };
    let joints = [at(0, 1), at(2, 2), at(2, 4), at(0, 5)];
    Rates {
        omega: links.map(|link| rate(&first, link)),
        alpha: links.map(|link| rate(&second, link)),
        velocity: joints.map(|j| j.0),
        acceleration: joints.map(|j| j.1),
    }
}

/// The solutions for velocities and accelerations.
fn both(
    equations: &JointEquations,
    given: &Given<f64>,
    solve: impl Fn(SVector<f64, SIZE>) -> Option<SVector<f64, SIZE>>,
) -> [SVector<f64, SIZE>; 2] {
    let solved = |sides: Vec<f64>| {
        let solution = solve(SVector::from_vec(sides));
        solution.unwrap_or_else(|| SVector::repeat(f64::INFINITY))
    };
    let first = solved(equations.velocity_sides(given));
    let second = solved(equations.acceleration_sides(given, first.as_slice()));
    [first, second]
}
