use super::model::GROUPS;

/// Symmetric matrices, one for each kind of errors, and that of roundings gone on with.
pub(super) struct Covariances {
    pub groups: [Vec<f64>; GROUPS],
    pub roundings: Vec<f64>,
}

impl Covariances {
    /// Their sum for a hand as good as that.
    pub fn sum(&self, hand: &[f64; GROUPS], into: &mut [f64]) {
        into.copy_from_slice(&self.roundings);
        for (group, s) in self.groups.iter().zip(hand) {
            for (sum, part) in into.iter_mut().zip(group) {
                *sum += s * s * part;
            }
        }
    }
}

/// Adds a column times itself.
pub(super) fn add_outer(matrix: &mut [f64], column: &[f64]) {
    let count = column.len();
    for (i, a) in column.iter().enumerate().filter(|(_, a)| **a != 0.0) {
        for (entry, b) in matrix[i * count..(i + 1) * count].iter_mut().zip(column) {
            *entry += a * b;
        }
    }
}
