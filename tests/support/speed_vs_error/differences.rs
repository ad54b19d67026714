//! The fair rival: the loop equations on differences, as anyone writes them who subtracts first: four unknowns, four equations,
//! nalgebra's LU.

use super::measure::{Pins, Rates};
use nalgebra::{Matrix4, Vector4};

type Vector = [f64; 2];

fn minus([a, b]: Vector, [c, d]: Vector) -> Vector {
    [a - c, b - d]
}

/// Velocities and accelerations; infinite where the matrix is singular.
///
/// With the arms r of links 2, 3, 4, 5: ω2 J BC + ω3 J CD − ω4 J ED = v_E − v_B, and the same by G and F; accelerations have the same
/// matrix.
pub fn rates(pins: &Pins) -> Rates<f64> {
    let [b, c, d, e, f, g] = pins.places;
    let loops = [[minus(c, b), minus(d, c), minus(d, e)], [minus(g, b), minus(f, g), minus(f, e)]];
    let mut matrix = Matrix4::zeros();
    // Columns: ω2, ω3, ω4, ω5.
    for (k, [second, own, fourth]) in loops.into_iter().enumerate() {
        for (column, [x, y], sign) in [(0, second, 1.0), (1 + 2 * k, own, 1.0), (2, fourth, -1.0)] {
            matrix[(2 * k, column)] = -sign * y;
            matrix[(2 * k + 1, column)] = sign * x;
        }
    }
    let factors = matrix.lu();
    let solve = |sides: [Vector; 2]| -> [f64; 4] {
        let [[p, q], [r, s]] = sides;
        factors.solve(&Vector4::new(p, q, r, s)).map_or([f64::INFINITY; 4], Into::into)
    };
    let between = minus(pins.velocity[1], pins.velocity[0]);
    let omega = solve([between; 2]);
    let between = minus(pins.acceleration[1], pins.acceleration[0]);
    let sides = [0, 1].map(|k| {
        let [second, own, fourth] = loops[k];
        let squares = [omega[0], omega[1 + 2 * k], omega[2]].map(|w| w * w);
        [0, 1]
            .map(|axis| between[axis] + squares[0] * second[axis] + squares[1] * own[axis] - squares[2] * fourth[axis])
    });
    let alpha = solve(sides);
    Rates::from_links(pins, pins.places, omega, alpha)
}
