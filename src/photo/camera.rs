//! A camera over a sheet of paper that may be bent: places on paper to places in its picture, and back.

use crate::geometry::{Point, Vector};
use nalgebra::{Matrix2, Matrix3, Vector3};

/// How many numbers describe a camera and a sheet.
pub(super) const UNKNOWNS: usize = 15;

/// A pinhole camera with radial distortion over a sheet bent as a part of a cylinder.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    /// Middle of the sheet, in mm.
    pub middle: Vector,
    /// Half its diagonal, in mm.
    pub half: f64,
    /// Half the picture's diagonal, in pixels.
    pub reach: f64,
    /// Focal length, in pixels.
    pub focal: f64,
    /// The middle of the picture, and where the optical axis meets it, in pixels.
    pub usual: [f64; 2],
    pub axis: Vector,
    /// Radial distortion: at r half diagonals from the axis places are farther out by k₁ r² + k₂ r⁴ (Brown 1966).
    pub distortion: [f64; 2],
    /// From axes of the sheet to those of the camera, and the sheet's middle, in mm.
    pub turn: Matrix3<f64>,
    pub place: Vector3<f64>,
    /// Heights over the plane through its middle as a x² + b x y + c y² for x and y in half diagonals, in mm.
    pub bend: [f64; 3],
    /// How much farther out than drawn the edges of black are, in mm.
    pub spread: f64,
}

impl Camera {
    /// The camera after small changes of its numbers: of ln focal; axis in half diagonals; distortion; turn about the axes of the camera in radians; place in its
    /// distance; bend and spread in mm.
    pub(super) fn changed(&self, by: &[f64; UNKNOWNS]) -> Camera {
        let turn = nalgebra::Rotation3::new(Vector3::new(by[5], by[6], by[7]));
        let far = self.place.norm();
        Camera {
            focal: self.focal * libm::exp(by[0]),
            axis: self.axis + Vector::new(by[1], by[2]) * self.reach,
            distortion: [self.distortion[0] + by[3], self.distortion[1] + by[4]],
            turn: turn.matrix() * self.turn,
            place: self.place + Vector3::new(by[8], by[9], by[10]) * far,
            bend: [self.bend[0] + by[11], self.bend[1] + by[12], self.bend[2] + by[13]],
            spread: self.spread + by[14],
            ..*self
        }
    }

    /// Where a place on the sheet, in mm, is in space; a bent sheet keeps its lengths to third order.
    fn in_space(&self, paper: Point) -> Vector3<f64> {
        let at = paper.coords - self.middle;
        let [a, b, c] = self.bend;
        let (x, y) = (at.x / self.half, at.y / self.half);
        let height = a * x * x + b * x * y + c * y * y;
        // Along each axis of the bend a slope s shortens the way by s²/2 per length: (2 λ u)² / 2, summed up.
        let tilt = 0.5 * libm::atan2(b, a - c);
        let (sine, cosine) = (libm::sin(tilt), libm::cos(tilt));
        let mean = 0.5 * (a + c);
        let half = 0.5 * libm::hypot(a - c, b);
        let (u, v) = (x * cosine + y * sine, y * cosine - x * sine);
        let shortened = |strength: f64, u: f64| u - 2.0 / 3.0 * (strength / self.half).powi(2) * u.powi(3);
        let (u, v) = (shortened(mean + half, u), shortened(mean - half, v));
        let flat = Vector::new(u * cosine - v * sine, u * sine + v * cosine) * self.half;
        self.turn * Vector3::new(flat.x, flat.y, height) + self.place
    }

    /// Where a place on the sheet, in mm, is in the picture.
    pub(super) fn pixel(&self, paper: Point) -> Point {
        let at = self.in_space(paper);
        let plane = Vector::new(at.x / at.z, at.y / at.z) * self.focal;
        let r = (plane / self.reach).norm_squared();
        let [k1, k2] = self.distortion;
        Point::from(self.axis + plane * (1.0 + r * (k1 + r * k2)))
    }

    /// How places in the picture change with places on the sheet, in pixels per mm.
    pub(super) fn slope(&self, paper: Point) -> Matrix2<f64> {
        const STEP: f64 = 1e-3;
        let along = |d: Vector| (self.pixel(paper + d) - self.pixel(paper - d)) / (2.0 * STEP);
        Matrix2::from_columns(&[along(Vector::new(STEP, 0.0)), along(Vector::new(0.0, STEP))])
    }

    /// Where a place in the picture is on the sheet, in mm, by Newton steps from its middle; `None` where there is none.
    pub(super) fn paper(&self, pixel: Point) -> Option<Point> {
        let mut at = Point::from(self.middle);
        for _ in 0..30 {
            let off = pixel - self.pixel(at);
            let step = self.slope(at).try_inverse()? * off;
            let longest = 0.5 * self.half;
            at += step * (longest / step.norm().max(longest));
            if step.norm() < 1e-9 {
                return Some(at);
            }
        }
        None
    }
}

impl Camera {
    /// How far the middle of the sheet is above or below its corners and the middles of its edges, at most, in mm.
    pub(super) fn bend_height(&self) -> f64 {
        let [a, b, c] = self.bend;
        let (x, y) = (self.middle.x / self.half, self.middle.y / self.half);
        let heights = [(x, 0.0), (0.0, y), (x, y), (x, -y)].map(|(x, y)| a * x * x + b * x * y + c * y * y);
        heights.iter().fold(0.0, |most, height| most.max(height.abs()))
    }

    /// The middle of the picture, in half diagonals.
    pub(super) fn usual_axis(&self) -> [f64; 2] {
        self.usual.map(|x| x / self.reach)
    }
}
