//! Maps from one plane to another that keep straight lines straight (homographies).

use crate::geometry::Point;
use nalgebra::{DMatrix, Matrix3, Vector3};

/// A homography: places of one plane to places of another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Homography(pub Matrix3<f64>);

impl Homography {
    /// The homography that takes the first of each pair nearest to the second, by the direct linear transformation with both sides scaled (Hartley 1997);
    /// `None` for fewer than four pairs or where they leave it open.
    pub(super) fn through(pairs: &[(Point, Point)]) -> Option<Homography> {
        if pairs.len() < 4 {
            return None;
        }
        let (from, to) = (scaling(pairs.iter().map(|pair| pair.0))?, scaling(pairs.iter().map(|pair| pair.1))?);
        let mut normal = DMatrix::<f64>::zeros(9, 9);
        for (a, b) in pairs {
            let (a, b) = (Homography(from).at(*a), Homography(to).at(*b));
            for row in [
                [a.x, a.y, 1.0, 0.0, 0.0, 0.0, -b.x * a.x, -b.x * a.y, -b.x],
                [0.0, 0.0, 0.0, a.x, a.y, 1.0, -b.y * a.x, -b.y * a.y, -b.y],
            ] {
                for i in 0..9 {
                    for j in 0..9 {
                        normal[(i, j)] += row[i] * row[j];
                    }
                }
            }
        }
        let eigen = normal.symmetric_eigen();
        let mut order: Vec<usize> = (0..9).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        // A second solution beside the first: the places are in line.
        if eigen.eigenvalues[order[1]] < 1e-9 * eigen.eigenvalues[order[8]] {
            return None;
        }
        let h = eigen.eigenvectors.column(order[0]);
        let scaled = Matrix3::from_fn(|i, j| h[3 * i + j]);
        Some(Homography(to.try_inverse()? * scaled * from)).filter(|h| h.0.iter().all(|x| x.is_finite()))
    }

    /// Where a place goes.
    pub(super) fn at(&self, point: Point) -> Point {
        let image = self.0 * Vector3::new(point.x, point.y, 1.0);
        Point::new(image.x / image.z, image.y / image.z)
    }
}

/// Brings places to a mean of zero and a mean distance of √2.
fn scaling(points: impl Iterator<Item = Point> + Clone) -> Option<Matrix3<f64>> {
    let count = points.clone().count() as f64;
    let mean = points.clone().map(|p| p.coords).sum::<nalgebra::Vector2<f64>>() / count;
    let spread = points.map(|p| (p.coords - mean).norm()).sum::<f64>() / count;
    let scale = std::f64::consts::SQRT_2 / spread;
    let matrix = Matrix3::new(scale, 0.0, -scale * mean.x, 0.0, scale, -scale * mean.y, 0.0, 0.0, 1.0);
    scale.is_finite().then_some(matrix)
}
