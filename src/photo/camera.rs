//! A camera over a sheet of paper that may be bent: places on paper to places in its picture, and back; and the camera that explains the markers in a
//! picture best, with how sure it is.

use super::edges::{self, Corner};
use super::markers::{self, Homography, LEAST, Seen};
use super::picture::Picture;
use crate::drawing::markers::SIDE;
use crate::geometry::{Point, Vector};
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector3};

/// How many numbers describe a camera and a sheet.
const UNKNOWNS: usize = 15;

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
    fn changed(&self, by: &[f64; UNKNOWNS]) -> Camera {
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
        let [a, b, c] = self.bend;
        let (x, y) = ((paper.x - self.middle.x) / self.half, (paper.y - self.middle.y) / self.half);
        let height = a * x * x + b * x * y + c * y * y;
        // Along each axis of the bend a slope s shortens the way by s²/2 per length: (2 λ u)² / 2, summed up.
        let tilt = 0.5 * libm::atan2(b, a - c);
        let (sine, cosine) = (libm::sin(tilt), libm::cos(tilt));
        let mean = 0.5 * (a + c);
        let half = 0.5 * libm::hypot(a - c, b);
        let (u, v) = (x * cosine + y * sine, y * cosine - x * sine);
        let shortened = |strength: f64, u: f64| u - 2.0 / 3.0 * (strength / self.half).powi(2) * u.powi(3);
        let (u, v) = (shortened(mean + half, u), shortened(mean - half, v));
        let (x, y) = ((u * cosine - v * sine) * self.half, (u * sine + v * cosine) * self.half);
        let Camera { turn, place, .. } = self;
        Vector3::new(
            turn.m11 * x + turn.m12 * y + turn.m13 * height + place.x,
            turn.m21 * x + turn.m22 * y + turn.m23 * height + place.y,
            turn.m31 * x + turn.m32 * y + turn.m33 * height + place.z,
        )
    }

    /// Where a place on the sheet, in mm, is in the picture.
    pub(super) fn pixel(&self, paper: Point) -> Point {
        let at = self.in_space(paper);
        let (x, y) = (at.x / at.z * self.focal, at.y / at.z * self.focal);
        let r = (x / self.reach).powi(2) + (y / self.reach).powi(2);
        let [k1, k2] = self.distortion;
        let farther = 1.0 + r * (k1 + r * k2);
        Point::new(self.axis.x + x * farther, self.axis.y + y * farther)
    }

    /// How places in the picture change with places on the sheet, in pixels per mm.
    fn slope(&self, paper: Point) -> Matrix2<f64> {
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

    /// How far the middle of the sheet is above or below its corners and the middles of its edges, at most, in mm.
    pub(super) fn bend_height(&self) -> f64 {
        let [a, b, c] = self.bend;
        let (x, y) = (self.middle.x / self.half, self.middle.y / self.half);
        let heights = [(x, 0.0), (0.0, y), (x, y), (x, -y)].map(|(x, y)| a * x * x + b * x * y + c * y * y);
        heights.iter().fold(0.0, |most, height| most.max(height.abs()))
    }

    /// For each of its numbers the cameras in which it alone is larger and smaller by `step`.
    fn beside(&self, step: f64) -> [[Camera; 2]; UNKNOWNS] {
        std::array::from_fn(|i| {
            [step, -step].map(|step| self.changed(&std::array::from_fn(|j| if i == j { step } else { 0.0 })))
        })
    }
}

type Square = SMatrix<f64, UNKNOWNS, UNKNOWNS>;
type Column = SVector<f64, UNKNOWNS>;
/// How a place changes with each of the numbers.
type Slopes = SMatrix<f64, 2, UNKNOWNS>;

/// A corner of a marker: its place on the sheet, the way from the marker's middle out to it, and where it is in the picture.
#[derive(Clone, Copy, Debug)]
struct Sight {
    /// The marker's number.
    marker: usize,
    paper: Point,
    outwards: Vector,
    corner: Corner,
}

/// What is supposed of a camera and a sheet before the picture is seen: standard deviations, in the order of [`Camera::changed`]; the turn is not known at all.
/// Wide-angle and tele lenses of telephones have focal lengths of 0.9 to 3 half diagonals, and put distortion right to a few per cent.
const BEFORE: [f64; UNKNOWNS] = [0.4, 0.06, 0.06, 0.04, 0.04, 1e3, 1e3, 1e3, 1e3, 1e3, 1e3, 4.0, 4.0, 4.0, 0.06];
/// Usual focal length, in half diagonals.
const FOCAL: f64 = 1.25;
/// What no camera of this kind explains, in pixels: added to every corner's deviation, in parts of a pixel for each thousand of the picture's half diagonal.
const UNEXPLAINED: f64 = 0.03;
/// Markers that are never left out.
const ENOUGH: usize = 5;
/// Off by so many standard deviations a corner counts less (Huber 1964).
const FAR: f64 = 2.5;

/// A camera with the covariance of its numbers.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub camera: Camera,
    covariance: Square,
    /// Root of the mean square of the corners' distances from where they should be, on the sheet in mm.
    pub residual: f64,
    /// Mean spread of the markers' edges by blur, as a standard deviation in mm.
    pub blur: f64,
}

/// The camera that explains the markers: from their rough corners first, then from the edges where that camera expects them.
pub(super) fn fitted(picture: &Picture, seen: &Seen) -> Option<Fitted> {
    let (sheet, size) = (seen.page.size_mm(), [picture.width() as f64, picture.height() as f64]);
    let rough = fit(&sights(picture, seen, None), &seen.plane, sheet, size)?;
    let mut sights = sights(picture, seen, Some(&rough.camera));
    let mut fitted = fit(&sights, &seen.plane, sheet, size)?;
    while let Some((marker, better)) = fitted.without_worst(&sights) {
        sights.retain(|sight| sight.marker != marker);
        fitted = better;
    }
    (sights.len() >= 3 * LEAST).then_some(fitted)
}

/// The corners of the markers, looked for where a camera or else their outlines let expect them.
fn sights(picture: &Picture, seen: &Seen, camera: Option<&Camera>) -> Vec<Sight> {
    let mut sights = Vec::new();
    for marker in &seen.markers {
        let own = markers::corners(seen.page, marker.number);
        let expected = camera.map_or(marker.corners, |camera| own.map(|paper| camera.pixel(paper)));
        let middle = nalgebra::center(&own[0], &own[2]);
        for (paper, corner) in own.into_iter().zip(edges::corners(picture, &expected, SIDE)) {
            let outwards = (paper - middle) / (0.5 * SIDE);
            sights.extend(corner.map(|corner| Sight { marker: marker.number, paper, outwards, corner }));
        }
    }
    sights
}

/// The camera for corners of a sheet of that size in mm, in a picture of that size in pixels; `plane` is where it is roughly.
fn fit(sights: &[Sight], plane: &Homography, sheet: [f64; 2], picture: [f64; 2]) -> Option<Fitted> {
    let starts = [1.0, 0.7, 1.8].map(|focal| start(plane, sheet, picture, FOCAL * focal));
    let fitted = starts.into_iter().flatten().filter_map(|camera| improve(camera, sights));
    let (_, camera) = fitted.min_by(|a, b| a.0.total_cmp(&b.0))?;
    finished(camera, sights)
}

/// A camera without distortion over a flat sheet.
fn start(plane: &Homography, [w, h]: [f64; 2], [width, height]: [f64; 2], focal: f64) -> Option<Camera> {
    let reach = 0.5 * libm::hypot(width, height);
    let (focal, axis, middle) = (focal * reach, Vector::new(0.5 * width, 0.5 * height), Vector::new(0.5 * w, 0.5 * h));
    let inside = Matrix3::new(focal, 0.0, axis.x, 0.0, focal, axis.y, 0.0, 0.0, 1.0);
    let centred = Matrix3::new(1.0, 0.0, middle.x, 0.0, 1.0, middle.y, 0.0, 0.0, 1.0);
    let columns = inside.try_inverse()? * plane.0 * centred;
    let [a, b, place]: [Vector3<f64>; 3] = std::array::from_fn(|i| columns.column(i).into_owned());
    let scale = 2.0 / (a.norm() + b.norm());
    let scale = if place.z < 0.0 { -scale } else { scale };
    let x = (a * scale).normalize();
    let normal = x.cross(&(b * scale)).normalize();
    let turn = Matrix3::from_columns(&[x, normal.cross(&x), normal]);
    let camera = Camera {
        middle,
        half: middle.norm(),
        reach,
        focal,
        usual: [axis.x, axis.y],
        axis,
        distortion: [0.0; 2],
        turn,
        place: place * scale,
        bend: [0.0; 3],
        spread: 0.0,
    };
    turn.iter().chain(camera.place.iter()).all(|x| x.is_finite()).then_some(camera)
}

/// How far a camera is from what is supposed, in standard deviations.
fn supposed(camera: &Camera) -> Column {
    let off_axis = [0, 1].map(|i| camera.axis[i] / camera.reach - camera.usual[i] / camera.reach);
    let focal = libm::log(camera.focal / (FOCAL * camera.reach));
    let (distortion, bend) = (camera.distortion, camera.bend);
    let mut off = Column::zeros();
    off.as_mut_slice()[..5].copy_from_slice(&[focal, off_axis[0], off_axis[1], distortion[0], distortion[1]]);
    off.as_mut_slice()[11..].copy_from_slice(&[bend[0], bend[1], bend[2], camera.spread]);
    off.component_div(&Column::from(BEFORE))
}

impl Sight {
    fn expected(&self, camera: &Camera) -> Point {
        let (paper, outwards) = (self.paper, self.outwards);
        camera.pixel(Point::new(paper.x + outwards.x * camera.spread, paper.y + outwards.y * camera.spread))
    }

    fn deviation(&self, camera: &Camera) -> f64 {
        libm::hypot(self.corner.deviation, UNEXPLAINED * camera.reach / 1000.0)
    }
}

/// Sum of the squares of all residuals in standard deviations, those far off less, and the equations for a step.
fn equations(camera: &Camera, sights: &[Sight]) -> (f64, Square, Column) {
    const STEP: f64 = 1e-6;
    let changed = camera.beside(STEP);
    let off = supposed(camera);
    let mut cost = off.norm_squared();
    // The lower triangle.
    let mut matrix: [[f64; UNKNOWNS]; UNKNOWNS] =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { BEFORE[i].powi(-2) } else { 0.0 }));
    let mut right: [f64; UNKNOWNS] = std::array::from_fn(|i| -off[i] / BEFORE[i]);
    for sight in sights {
        let deviation = sight.deviation(camera);
        let residual = (sight.corner.at - sight.expected(camera)) / deviation;
        let size = residual.norm();
        let weight = if size > FAR { FAR / size } else { 1.0 };
        cost += if size > FAR { FAR * (2.0 * size - FAR) } else { size * size };
        let slopes = changed.each_ref().map(|[up, down]| {
            let (up, down) = (sight.expected(up), sight.expected(down));
            let step = 2.0 * STEP * deviation;
            [(up.x - down.x) / step, (up.y - down.y) / step]
        });
        for (i, [x, y]) in slopes.iter().enumerate() {
            for (sum, [u, v]) in matrix[i].iter_mut().zip(&slopes[..=i]) {
                *sum += (x * u + y * v) * weight;
            }
            right[i] += (x * residual.x + y * residual.y) * weight;
        }
    }
    (cost, Square::from_fn(|i, j| matrix[i.max(j)][i.min(j)]), Column::from(right))
}

/// Steps of Levenberg (1944) and Marquardt (1963) until they no longer help: the sum of squares, and the camera.
fn improve(mut camera: Camera, sights: &[Sight]) -> Option<(f64, Camera)> {
    let (mut cost, mut matrix, mut right) = equations(&camera, sights);
    let mut damping = 1e-3;
    for _ in 0..60 {
        let mut damped = matrix;
        for i in 0..UNKNOWNS {
            damped[(i, i)] *= 1.0 + damping;
        }
        let step = damped.cholesky()?.solve(&right);
        let next = camera.changed(&std::array::from_fn(|i| step[i]));
        let (less, next_matrix, next_right) = equations(&next, sights);
        if less < cost {
            let is_done = cost - less < 1e-7 * cost;
            (cost, matrix, right, camera) = (less, next_matrix, next_right, next);
            damping = (damping * 0.1).max(1e-9);
            if is_done {
                break;
            }
        } else {
            damping *= 10.0;
            if damping > 1e6 {
                break;
            }
        }
    }
    cost.is_finite().then_some((cost, camera))
}

/// The covariance of a camera, larger where the corners scatter more than they should.
fn finished(camera: Camera, sights: &[Sight]) -> Option<Fitted> {
    let (_, matrix, _) = equations(&camera, sights);
    let inverse = matrix.cholesky()?.inverse();
    let (mut scatter, mut on_paper) = (0.0, 0.0);
    for sight in sights {
        let off = sight.corner.at - sight.expected(&camera);
        scatter += (off / sight.deviation(&camera)).norm_squared();
        let mm = (camera.slope(sight.paper).try_inverse()? * off).norm();
        on_paper += mm * mm;
    }
    // Of the unknowns some two thirds are found from the corners.
    let freedom = (2.0 * sights.len() as f64 - 10.0).max(6.0);
    let covariance = inverse * (scatter / freedom).max(1.0);
    let residual = (on_paper / sights.len() as f64).sqrt();
    let blur = sights.iter().map(|sight| sight.corner.blur).sum::<f64>() / sights.len() as f64;
    Some(Fitted { camera, covariance, residual, blur })
}

/// Without a marker that does not fit, less than this share of the squares of all residuals is left.
const LEFT: f64 = 0.5;
/// Residuals that no marker is left out for, in mm.
const GOOD: f64 = 0.04;

impl Fitted {
    /// The camera without the marker that does not fit, and that marker: on a corner of paper that stands up, or half under a finger. `None` where
    /// all fit, or are too few.
    fn without_worst(&self, sights: &[Sight]) -> Option<(usize, Fitted)> {
        let mut markers: Vec<usize> = sights.iter().map(|sight| sight.marker).collect();
        markers.dedup();
        if markers.len() <= ENOUGH || self.residual < GOOD {
            return None;
        }
        let without = |marker: &usize| {
            let others: Vec<Sight> = sights.iter().filter(|sight| sight.marker != *marker).copied().collect();
            let (_, camera) = improve(self.camera, &others)?;
            Some((*marker, finished(camera, &others)?))
        };
        let best = markers.iter().filter_map(without).min_by(|a, b| a.1.residual.total_cmp(&b.1.residual))?;
        let share =
            best.1.residual.powi(2) * (markers.len() - 1) as f64 / (self.residual.powi(2) * markers.len() as f64);
        (share < LEFT).then_some(best)
    }

    /// Covariance of the place on the sheet of something in the picture, in mm²: that of the camera alone.
    pub(super) fn covariance(&self, paper: Point) -> Option<Matrix2<f64>> {
        const STEP: f64 = 1e-6;
        let back = self.camera.slope(paper).try_inverse()?;
        let slope = |[up, down]: [Camera; 2]| back * (up.pixel(paper) - down.pixel(paper)) / (2.0 * STEP);
        let slopes = Slopes::from_columns(&self.camera.beside(STEP).map(slope));
        Some(slopes * self.covariance * slopes.transpose())
    }
}
