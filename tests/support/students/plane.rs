//! Places of a plan as complex numbers, x to the right and y up.

pub type Place = nalgebra::Complex<f64>;

/// A quarter turn, counter-clockwise.
pub const QUARTER: f64 = std::f64::consts::FRAC_PI_2;
pub const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// The vector of length 1 in a direction.
pub fn unit(angle: f64) -> Place {
    let (sin, cos) = libm::sincos(angle);
    Place::new(cos, sin)
}

/// The length of a vector.
pub fn size(vector: Place) -> f64 {
    libm::hypot(vector.re, vector.im)
}

/// The direction of a vector.
pub fn direction(vector: Place) -> f64 {
    libm::atan2(vector.im, vector.re)
}

/// How far a vector goes along a direction.
pub fn along(vector: Place, direction: f64) -> f64 {
    (vector * unit(-direction)).re
}

/// Where two lines cross, each through a place in a direction.
pub fn crossing(first: (Place, f64), second: (Place, f64)) -> Place {
    let (u, w) = (unit(first.1), unit(second.1));
    first.0 + u * (((second.0 - first.0).conj() * w).im / (u.conj() * w).im)
}

/// Solves as many linear equations as there are unknowns, by elimination; the last column holds the right sides.
pub fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let count = rows.len();
    for column in 0..count {
        let largest = (column..count).max_by(|&i, &j| rows[i][column].abs().total_cmp(&rows[j][column].abs()));
        rows.swap(column, largest.unwrap_or(column));
        let pivot = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let part = row[column] / pivot[column];
            if i != column {
                row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= part * p);
            }
        }
    }
    (0..count).map(|i| rows[i][count] / rows[i][i]).collect()
}
