//! The shape of paper on a desk: bent about one direction, creased, with a corner up.

use std::f64::consts::FRAC_1_SQRT_2;

/// The radius of a crease and of a corner's bend, in mm.
const BEND: f64 = 6.0;

/// How the paper is bent. Lengths on the paper stay as they are, except where a corner is up on bent paper.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shape {
    /// How far the middle lies above or below the line between the ends, across the axis, in mm.
    pub sagitta: f64,
    /// The direction of the cylinder's axis on the page, in radians from x towards y.
    pub axis: f64,
    /// The ends are up, not the middle.
    pub is_hollow: bool,
    /// A fold parallel to the axis: its distance from the sheet's middle in mm, and its angle in radians, up or down.
    pub crease: Option<[f64; 2]>,
    /// A corner that is up: its number (clockwise from the upper left), its height along the diagonal in mm, its angle
    /// in radians.
    pub ear: Option<(usize, f64, f64)>,
}

/// A part of the profile across the axis: from a place of the paper on, with an even curvature.
#[derive(Clone, Copy, Debug)]
struct Arc {
    from: f64,
    start: [f64; 2],
    angle: f64,
    curvature: f64,
}

impl Arc {
    /// Place and height of a point of the paper, and the slope's angle there.
    fn at(&self, u: f64) -> ([f64; 2], f64) {
        let (s, [x, z]) = (u - self.from, self.start);
        let angle = self.angle + self.curvature * s;
        if self.curvature == 0.0 {
            let (sin, cos) = libm::sincos(self.angle);
            return ([x + s * cos, z + s * sin], angle);
        }
        let ((sin, cos), (sin_0, cos_0)) = (libm::sincos(angle), libm::sincos(self.angle));
        ([x + (sin - sin_0) / self.curvature, z - (cos - cos_0) / self.curvature], angle)
    }
}

/// A sheet's surface: where a point of the page lies above the desk.
#[derive(Clone, Debug)]
pub struct Surface {
    page: [f64; 2],
    across: [f64; 2],
    arcs: Vec<Arc>,
    ear: Option<(usize, f64, f64)>,
}

impl Surface {
    /// The surface of a page of this size in mm.
    pub fn new(page: [f64; 2], shape: &Shape) -> Surface {
        let (sin, cos) = libm::sincos(shape.axis);
        let across = [-sin, cos];
        let half = (page[0] * sin.abs() + page[1] * cos.abs()) / 2.0;
        let sign = if shape.is_hollow { 1.0 } else { -1.0 };
        let curvature = sign * curvature(half, shape.sagitta);
        let mut ends = vec![(-half - 15.0, curvature)];
        if let Some([at, angle]) = shape.crease {
            ends.push((at, curvature + angle.signum() / BEND));
            ends.push((at + BEND * angle.abs(), curvature));
        }
        ends.push((half + 15.0, 0.0));
        let mut arcs = vec![Arc { from: ends[0].0, start: [0.0; 2], angle: 0.0, curvature: 0.0 }];
        for &(from, curvature) in &ends {
            let last = arcs[arcs.len() - 1];
            let (start, angle) = last.at(from);
            arcs.push(Arc { from, start, angle, curvature });
        }
        let mut surface = Surface { page, across, arcs, ear: shape.ear };
        surface.lay_down(half);
        surface
    }

    /// Turns and moves the profile: both ends equally high, the lowest point on the desk, the middle in the middle.
    fn lay_down(&mut self, half: f64) {
        let ([x0, z0], [x1, z1]) = (self.profile(-half), self.profile(half));
        let turn = -libm::atan2(z1 - z0, x1 - x0);
        let (sin, cos) = libm::sincos(turn);
        for arc in &mut self.arcs {
            let [x, z] = arc.start;
            arc.start = [cos * x - sin * z, sin * x + cos * z];
            arc.angle += turn;
        }
        let heights = (0..=400).map(|k| self.profile(half * (f64::from(k) / 200.0 - 1.0))[1]);
        let (lowest, middle) = (heights.fold(f64::INFINITY, f64::min), self.profile(0.0)[0]);
        for arc in &mut self.arcs {
            arc.start = [arc.start[0] - middle, arc.start[1] - lowest];
        }
    }

    fn profile(&self, u: f64) -> [f64; 2] {
        let arc = self.arcs[1..].iter().rev().find(|arc| u >= arc.from).unwrap_or(&self.arcs[0]);
        arc.at(u).0
    }

    /// Where a point of the page lies: from the sheet's middle to the right and down in mm, and *below* the desk.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let (mut p, mut lift) = ([x - self.page[0] / 2.0, y - self.page[1] / 2.0], 0.0);
        if let Some((corner, size, angle)) = self.ear {
            let sign = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]][corner % 4];
            let out = sign.map(|s| s * FRAC_1_SQRT_2);
            let tip = (self.page[0] + self.page[1]) / 2.0 * FRAC_1_SQRT_2;
            let t = p[0] * out[0] + p[1] * out[1] - tip + size;
            if t > 0.0 {
                let arc = Arc { from: 0.0, start: [0.0; 2], angle: 0.0, curvature: 1.0 / BEND };
                let flat = BEND * angle;
                let ([along, height], _) = match t < flat {
                    true => arc.at(t),
                    false => {
                        let (start, angle) = arc.at(flat);
                        Arc { from: flat, start, angle, curvature: 0.0 }.at(t)
                    }
                };
                p = [p[0] + out[0] * (along - t), p[1] + out[1] * (along - t)];
                lift = height;
            }
        }
        let [a, b] = self.across;
        let (u, v) = (a * p[0] + b * p[1], b * p[0] - a * p[1]);
        let [x, height] = self.profile(u);
        [a * x + b * v, b * x - a * v, -height - lift]
    }
}

/// The curvature at which an arc of twice this half length has this sagitta.
fn curvature(half: f64, sagitta: f64) -> f64 {
    if sagitta == 0.0 {
        return 0.0;
    }
    let mut curvature = 2.0 * sagitta / (half * half);
    for _ in 0..40 {
        curvature *= sagitta * curvature / (1.0 - libm::cos(half * curvature));
    }
    curvature
}
