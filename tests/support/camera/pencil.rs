//! Pencil strokes on a page: graphite on the paper's grain.

use super::noise::Noise;
use crate::random::Random;
use std::f64::consts::TAU;

/// A stroke of a pencil.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Its corners, in mm of the page.
    pub points: Vec<[f64; 2]>,
    /// In mm.
    pub width: f64,
    /// The grey of its middle, 0 to 255, as a picture shows it.
    pub grey: f64,
    /// How far it leaves its way, in mm.
    pub wobble: f64,
}

/// How long a piece of a stroke is, in mm.
const STEP: f64 = 0.25;
/// How far the grain of paper goes on, in mm per cell of noise.
const GRAIN: f32 = 0.07;

/// How much light graphite keeps, in 255ths, for each pixel of a page of this size.
pub(super) fn graphite(strokes: &[Stroke], [width, height]: [usize; 2], per_mm: f32, random: &mut Random) -> Vec<u8> {
    let grain = Noise::new(random, 2);
    let mut sheet = Sheet { width, height, per_mm, dark: vec![0; width * height] };
    for stroke in strokes {
        sheet.stroke(stroke, random);
    }
    let step = 1.0 / (GRAIN * per_mm);
    for (k, dark) in sheet.dark.iter_mut().enumerate().filter(|(_, dark)| **dark > 0) {
        let (x, y) = (k % width, k / width);
        let part = f32::from(*dark) / 255.0;
        // Much pressure fills the valleys of the grain, too.
        let tooth = grain.at(x as f32 * step, y as f32 * step);
        let held = (1.6 - 1.3 * tooth * (1.3 - part)).clamp(0.15, 1.2);
        *dark = (255.0 * (part * held).min(0.93)) as u8;
    }
    sheet.dark
}

struct Sheet {
    width: usize,
    height: usize,
    per_mm: f32,
    dark: Vec<u8>,
}

impl Sheet {
    fn stroke(&mut self, stroke: &Stroke, random: &mut Random) {
        let grey = libm::pow(stroke.grey.clamp(0.0, 255.0) / 255.0, 2.2);
        let way = pieces(&stroke.points);
        let length = way.last().map_or(0.0, |piece| piece.2);
        let waves = [(); 3].map(|()| [random.between(8.0, 45.0), random.angle(), random.unit()]);
        let pressures = [(); 2].map(|()| [random.between(15.0, 80.0), random.angle()]);
        let sum: f64 = waves.iter().map(|wave| wave[2]).sum();
        let mut last: Option<([f32; 2], f32)> = None;
        for (place, normal, s) in way {
            let off: f64 = waves.iter().map(|[mm, at, part]| part * libm::sin(s / mm * TAU + at)).sum();
            let off = stroke.wobble * off / sum.max(0.3);
            let tremor = stroke.wobble * 0.12 * random.within(1.0);
            let pressure: f64 = pressures.iter().map(|[mm, at]| 0.1 * libm::sin(s / mm * TAU + at)).sum();
            // A stroke begins and ends with less pressure.
            let ends = (0.55 + s / 1.5).min(0.6 + (length - s) / 1.2).min(1.0);
            let dark = (1.0 - grey) * ((0.92 + pressure) * ends).clamp(0.1, 1.1);
            let place = [0, 1].map(|i| (place[i] + normal[i] * (off + tremor)) as f32 * self.per_mm);
            let (from, before) = last.unwrap_or((place, dark as f32));
            let radius = (stroke.width * (0.5 + 0.12 * pressure)) as f32 * self.per_mm;
            self.piece([from, place], radius, (before + dark as f32) / 2.0);
            last = Some((place, dark as f32));
        }
    }

    /// Darkens what lies round a short line, all in pixels.
    fn piece(&mut self, [a, b]: [[f32; 2]; 2], radius: f32, dark: f32) {
        let reach = radius + 1.0;
        let range = |i: usize, end: usize| {
            let low = (a[i].min(b[i]) - reach).max(0.0) as usize;
            let high = ((a[i].max(b[i]) + reach).max(0.0) as usize + 1).min(end);
            low..high.max(low)
        };
        let d = [b[0] - a[0], b[1] - a[1]];
        let square = (d[0] * d[0] + d[1] * d[1]).max(1e-6);
        for y in range(1, self.height) {
            for x in range(0, self.width) {
                let p = [x as f32 + 0.5 - a[0], y as f32 + 0.5 - a[1]];
                let t = ((p[0] * d[0] + p[1] * d[1]) / square).clamp(0.0, 1.0);
                let off = [p[0] - t * d[0], p[1] - t * d[1]];
                let distance = (off[0] * off[0] + off[1] * off[1]).sqrt();
                // A pencil's line is darkest in its middle and fades over its outer half.
                let edge = ((radius + 0.5 - distance) / (0.45 * radius + 1.0)).clamp(0.0, 1.0);
                let value = (255.0 * dark * edge).min(255.0) as u8;
                let old = &mut self.dark[y * self.width + x];
                *old = (*old).max(value);
            }
        }
    }
}

/// Places along a way with the way's normal and the length so far.
fn pieces(points: &[[f64; 2]]) -> Vec<([f64; 2], [f64; 2], f64)> {
    let mut all = Vec::new();
    let mut before = 0.0;
    for pair in points.windows(2) {
        let d = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let length = libm::hypot(d[0], d[1]);
        let count = (length / STEP).ceil().max(1.0);
        let normal = [-d[1] / length.max(1e-9), d[0] / length.max(1e-9)];
        for k in 0..=count as usize {
            let t = k as f64 / count;
            all.push(([0, 1].map(|i| pair[0][i] + t * d[i]), normal, before + t * length));
        }
        before += length;
    }
    if let ([point], true) = (points, all.is_empty()) {
        all.push((*point, [0.0, 0.0], 0.0));
    }
    all
}
