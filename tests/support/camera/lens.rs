//! The camera: where points above the desk are seen in the upright picture.

use super::surface::{Shape, Surface};

/// How the camera is held, relative to the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// By how much the sheet is turned in the picture, clockwise, in radians.
    pub turn: f64,
    /// The angle between the line of sight and the sheet's normal, in radians.
    pub tilt: f64,
    /// The direction in the picture about which the camera is tilted, in radians.
    pub about: f64,
    /// The larger of the sheet's extents as part of the picture's width or height.
    pub fill: f64,
    /// Where the sheet lies in the room that is left: −1 to 1, right and down; more moves it out of the picture.
    pub shift: [f64; 2],
}

/// A lens, as it is after the telephone's own correction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Focal length as on film of 36 mm × 24 mm (by the diagonal).
    pub focal_mm: f64,
    /// How far the axis is off the picture's middle, as parts of its width and height.
    pub off_centre: [f64; 2],
    /// k₁ and k₂ over the distance from the axis in focal lengths.
    pub radial: [f64; 2],
    /// p₁ and p₂ (Brown).
    pub tangential: [f64; 2],
}

/// What is needed to say where a point of the page is seen.
#[derive(Clone, Debug)]
pub struct View {
    pub size: [usize; 2],
    pub surface: Surface,
    desk: Surface,
    rotation: [[f64; 3]; 3],
    offset: [f64; 3],
    focal: f64,
    axis: [f64; 2],
    lens: Lens,
    page: [f64; 2],
}

impl View {
    /// A sheet of this size in mm, seen in a picture of this size in pixels.
    pub fn new(page: [f64; 2], shape: &Shape, pose: &Pose, lens: &Lens, size: [usize; 2]) -> View {
        let [width, height] = size.map(|n| n as f64);
        let focal = lens.focal_mm / libm::hypot(36.0, 24.0) * libm::hypot(width, height);
        let axis = [width * (0.5 + lens.off_centre[0]), height * (0.5 + lens.off_centre[1])];
        let mut view = View {
            size,
            surface: Surface::new(page, shape),
            desk: Surface::new(page, &Shape::default()),
            rotation: rotation(pose),
            offset: [0.0, 0.0, 2.0 * focal * page[0].max(page[1]) / width],
            focal,
            axis,
            lens: *lens,
            page,
        };
        for _ in 0..30 {
            view.approach(pose);
        }
        view
    }

    /// Moves the camera so that the sheet fills what it is to fill.
    fn approach(&mut self, pose: &Pose) {
        let size = self.size.map(|n| n as f64);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for k in 0..64 {
            let (t, side) = (f64::from(k % 16) / 16.0, k / 16);
            let [x, y] = [[t, 0.0], [1.0, t], [1.0 - t, 1.0], [0.0, 1.0 - t]][side as usize];
            let pixel = self.pixel([x * self.page[0], y * self.page[1]]);
            low = [0, 1].map(|i| low[i].min(pixel[i]));
            high = [0, 1].map(|i| high[i].max(pixel[i]));
        }
        let extent = [0, 1].map(|i| (high[i] - low[i]) / size[i]);
        self.offset[2] *= extent[0].max(extent[1]) / pose.fill;
        let moved = [0, 1].map(|i| {
            let target = size[i] / 2.0 * (1.0 + pose.shift[i] * (1.0 - extent[i]).abs());
            (target - f64::midpoint(low[i], high[i])) * self.offset[2] / self.focal
        });
        self.offset = [self.offset[0] + moved[0], self.offset[1] + moved[1], self.offset[2]];
    }

    /// Where a point of the page (mm) is seen; the centre of the picture's first pixel is (0.5, 0.5).
    pub fn pixel(&self, mm: [f64; 2]) -> [f64; 2] {
        self.project(self.surface.place(mm))
    }

    /// Where a point of the desk is in the picture; in mm of the page as if that lay flat on the desk.
    pub fn desk_pixel(&self, mm: [f64; 2]) -> [f64; 2] {
        self.project(self.desk.place(mm))
    }

    fn project(&self, place: [f64; 3]) -> [f64; 2] {
        let [x, y, z] = [0, 1, 2].map(|i| {
            let row = self.rotation[i];
            row[0] * place[0] + row[1] * place[1] + row[2] * place[2] + self.offset[i]
        });
        let [x, y] = self.distorted([x / z, y / z]);
        [self.axis[0] + self.focal * x, self.axis[1] + self.focal * y]
    }

    fn distorted(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let ([k1, k2], [p1, p2]) = (self.lens.radial, self.lens.tangential);
        let r2 = x * x + y * y;
        let radial = 1.0 + r2 * (k1 + r2 * k2);
        [
            x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
            y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y,
        ]
    }

    /// Which point of the desk is seen at a pixel, in mm of the page as if that lay flat.
    pub fn desk(&self, pixel: [f64; 2]) -> [f64; 2] {
        let seen = [0, 1].map(|i| (pixel[i] - self.axis[i]) / self.focal);
        let mut ray = seen;
        for _ in 0..8 {
            let off = self.distorted(ray);
            ray = [0, 1].map(|i| ray[i] + seen[i] - off[i]);
        }
        // Into the sheet's frame; the desk is its plane z = 0.
        let turned = |v: [f64; 3]| [0, 1, 2].map(|j| (0..3).map(|i| self.rotation[i][j] * v[i]).sum::<f64>());
        let (eye, way) = (turned(self.offset), turned([ray[0], ray[1], 1.0]));
        let far = eye[2] / way[2].max(1e-2 * eye[2].signum());
        [0, 1].map(|i| way[i] * far - eye[i] + self.page[i] / 2.0)
    }

    /// How many pixels a mm takes near the sheet's middle.
    pub fn pixels_per_mm(&self) -> f64 {
        self.focal / self.offset[2]
    }
}

/// First the turn in the picture, then the tilt.
fn rotation(pose: &Pose) -> [[f64; 3]; 3] {
    let (sin, cos) = libm::sincos(pose.turn);
    let turn = [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]];
    let (sin, cos) = libm::sincos(pose.about);
    let [x, y] = [cos, sin];
    let (sin, cos) = libm::sincos(pose.tilt);
    let rest = 1.0 - cos;
    let tilt = [
        [cos + rest * x * x, rest * x * y, sin * y],
        [rest * x * y, cos + rest * y * y, -sin * x],
        [-sin * y, sin * x, cos],
    ];
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| tilt[i][k] * turn[k][j]).sum()))
}
