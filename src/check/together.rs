//! Joint errors of a drawing program: displacements of all joints together that leave every link its shape.

use crate::construction::{Construction, OperationKind, OperationRole, Values};
use crate::geometry::{Vector, unit};
use crate::mechanism::{GROUND, Mechanism, PointId};
use nalgebra::DMatrix;

/// A basis of the joint displacements that keep the links' shapes: the null space of the constraints, which are the
/// distances between points of one link and the places of the ground's points.
pub fn ways_together(construction: &Construction, exact: &Values, mechanism: &Mechanism) -> Vec<Vec<f64>> {
    let operations = construction.operations.iter();
    let plots: Vec<(PointId, Vector)> = operations
        .filter_map(|operation| match (operation.role, &operation.kind) {
            (OperationRole::Joint(point), OperationKind::Plot { place, .. }) => Some((point, exact.place(*place))),
            _ => None,
        })
        .collect();
    if plots.is_empty() {
        return Vec::new();
    }
    let count = 2 * plots.len();
    // AᵀA of the constraint matrix A: both have the same null space.
    let mut squares = DMatrix::<f64>::zeros(count, count);
    let mut constrain = |row: &[(usize, f64)]| {
        for &(i, a) in row {
            for &(j, b) in row {
                squares[(i, j)] += a * b;
            }
        }
    };
    for (i, (point, at)) in plots.iter().enumerate() {
        if mechanism.body(GROUND).points.contains(point) {
            constrain(&[(2 * i, 1.0)]);
            constrain(&[(2 * i + 1, 1.0)]);
        }
        for (j, (other, there)) in plots.iter().enumerate().take(i) {
            let is_rigid = mechanism.bodies.iter().any(|b| b.points.contains(point) && b.points.contains(other));
            if is_rigid && let Some(u) = unit(at - there) {
                constrain(&[(2 * i, u.x), (2 * i + 1, u.y), (2 * j, -u.x), (2 * j + 1, -u.y)]);
            }
        }
    }
    let eigen = squares.symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    let null_space = eigen.eigenvalues.iter().enumerate().filter(|(_, value)| value.abs() <= 1e-10 * largest);
    null_space.map(|(k, _)| eigen.eigenvectors.column(k).iter().copied().collect()).collect()
}
