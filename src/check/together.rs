//! Errors of joints that leave every link its shape, as a drawing program makes them.

use crate::construction::{Construction, Does, Part, Values};
use crate::geometry::{Vector, unit};
use crate::mechanism::{GROUND, Mechanism, PointId};
use nalgebra::DMatrix;

/// The ways in which joints may be off together: the null space of what keeps the links' shapes: distances between points of one link, places of the ground.
pub(super) fn ways_together(construction: &Construction, exact: &Values, mechanism: &Mechanism) -> Vec<Vec<f64>> {
    let operations = construction.operations.iter();
    let plots: Vec<(PointId, Vector)> = operations
        .filter_map(|operation| match (operation.part, &operation.does) {
            (Part::Joint(point), Does::Plot { place, .. }) => Some((point, exact.place(*place))),
            _ => None,
        })
        .collect();
    let count = 2 * plots.len();
    // The sum of squares of what changes shapes: its kernel is what does not.
    let mut squares = DMatrix::<f64>::zeros(count, count);
    let mut hold = |row: &[(usize, f64)]| {
        for &(i, a) in row {
            for &(j, b) in row {
                squares[(i, j)] += a * b;
            }
        }
    };
    for (i, (own, at)) in plots.iter().enumerate() {
        if mechanism.body(GROUND).points.contains(own) {
            hold(&[(2 * i, 1.0)]);
            hold(&[(2 * i + 1, 1.0)]);
        }
        for (j, (other, there)) in plots.iter().enumerate().take(i) {
            let mut bodies = mechanism.bodies.iter();
            let is_rigid = bodies.any(|b| b.points.contains(own) && b.points.contains(other));
            if let Some(u) = unit(at - there).filter(|_| is_rigid) {
                hold(&[(2 * i, u.x), (2 * i + 1, u.y), (2 * j, -u.x), (2 * j + 1, -u.y)]);
            }
        }
    }
    let eigen = squares.symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    let kernel = eigen.eigenvalues.iter().enumerate();
    let kernel = kernel.filter(|(_, value)| value.abs() <= 1e-10 * largest);
    kernel.map(|(k, _)| eigen.eigenvectors.column(k).iter().copied().collect()).collect()
}
