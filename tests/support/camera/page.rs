//! A printed and drawn page: how much light each place of it sends back.

use super::noise::Noise;
use super::pencil::{self, Stroke};
use crate::random::Random;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// The width of tiles in which a page is drawn, in pixels; larger ones are drawn less exactly.
const TILE: usize = 2048;
/// How far ink runs, in mm (standard deviation).
const INK_BLUR: f64 = 0.05;
/// What printed black sends back, as part of white.
const INK: f32 = 0.045;

/// A picture of a page, with smaller ones of half its size each.
#[derive(Clone)]
pub struct Page {
    /// Width and height in mm.
    pub mm: [f64; 2],
    levels: Vec<Level>,
}

/// Light that is sent back, as 255ths of white; linear.
#[derive(Clone)]
struct Level {
    width: usize,
    height: usize,
    per_mm: f32,
    values: Vec<u8>,
}

impl Page {
    /// Draws an SVG whose view box is the page in any unit, at so many pixels per mm.
    ///
    /// With 24 pixels per mm all edges of markers on A4 and A3 fall between pixels.
    pub fn draw(svg: &str, mm: [f64; 2], per_mm: usize, options: &Options<'_>) -> Page {
        let tree = Tree::from_str(svg, options).expect("the test's sheet is a good SVG");
        let [width, height] = mm.map(|length| (length * per_mm as f64).ceil() as usize);
        let fine = 2.0 * per_mm as f32;
        let scale = fine * mm[0] as f32 / tree.size().width();
        let mut values = vec![255; width * height];
        let tiles = |length: usize| (0..length).step_by(TILE / 2);
        for (x0, y0) in tiles(height).flat_map(|y0| tiles(width).map(move |x0| (x0, y0))) {
            let mut tile = Pixmap::new(TILE as u32, TILE as u32).expect("it is not empty");
            tile.fill(resvg::tiny_skia::Color::WHITE);
            let moved = Transform::from_scale(scale, scale).post_translate(-2.0 * x0 as f32, -2.0 * y0 as f32);
            resvg::render(&tree, moved, &mut tile.as_mut());
            let data = tile.data();
            for y in y0..height.min(y0 + TILE / 2) {
                for x in x0..width.min(x0 + TILE / 2) {
                    let first = 4 * (2 * (y - y0) * TILE + 2 * (x - x0));
                    let grey = |k: usize| u32::from(data[k]) * 2 + u32::from(data[k + 1]) * 5 + u32::from(data[k + 2]);
                    let sum = [0, 4, 4 * TILE, 4 * TILE + 4].map(|k| grey(first + k)).iter().sum::<u32>();
                    values[y * width + x] = ((sum + 16) / 32) as u8;
                }
            }
        }
        Page { mm, levels: vec![Level { width, height, per_mm: per_mm as f32, values }] }
    }

    /// A page from values of its own: rows of pixels, as 255ths of white.
    pub fn raster(mm: [f64; 2], per_mm: usize, values: Vec<u8>) -> Page {
        let [width, height] = mm.map(|length| (length * per_mm as f64).ceil() as usize);
        assert_eq!(values.len(), width * height, "a page of {mm:?} mm has {width} × {height} pixels");
        Page { mm, levels: vec![Level { width, height, per_mm: per_mm as f32, values }] }.with_levels()
    }

    /// The page as a printer leaves it, with what a pencil has drawn on it.
    pub fn printed(mut self, strokes: &[Stroke], seed: u64) -> Page {
        let mut random = Random(seed);
        let fibres = Noise::new(&mut random, 2);
        let clouds = Noise::new(&mut random, 3);
        let level = &mut self.levels[0];
        level.blur(INK_BLUR);
        let graphite = pencil::graphite(strokes, [level.width, level.height], level.per_mm, &mut random);
        let cloud_step = 1.0 / (2.5 * level.per_mm);
        let (mut row, fibre_step) = (vec![0.0; level.width], 24.0 / level.per_mm);
        for y in 0..level.height {
            for (x, cloud) in row.iter_mut().enumerate().step_by(8) {
                *cloud = clouds.at(x as f32 * cloud_step, y as f32 * cloud_step);
            }
            let fibre_y = (y as f32 * fibre_step * 0.4) as usize;
            for x in 0..level.width {
                let k = y * level.width + x;
                let fibre = fibres.cell((x as f32 * fibre_step * 0.4) as usize, fibre_y);
                let paper = 0.955 + 0.025 * fibre + 0.02 * row[x & !7];
                let ink = INK + (1.0 - INK) * f32::from(level.values[k]);
                let ink = if level.values[k] == 0 { INK * 255.0 } else { ink };
                level.values[k] = (ink * paper * (1.0 - f32::from(graphite[k]) / 255.0) + 0.5) as u8;
            }
        }
        self.with_levels()
    }

    /// The page as it is drawn, sharp and without paper.
    pub fn finished(self) -> Page {
        self.with_levels()
    }

    fn with_levels(mut self) -> Page {
        self.levels.truncate(1);
        while self.levels[self.levels.len() - 1].width > 64 {
            let half = self.levels[self.levels.len() - 1].half();
            self.levels.push(half);
        }
        self
    }

    /// The picture to take values from where a pixel takes so many mm at most: so that samples lie nearer than its pixels.
    pub(super) fn sampler(&self, mm_per_pixel: f64) -> Sampler<'_> {
        let wanted = 3.0 / mm_per_pixel;
        let fits = |level: &&Level| f64::from(level.per_mm) <= wanted;
        Sampler { level: self.levels.iter().find(fits).unwrap_or(&self.levels[self.levels.len() - 1]) }
    }
}

/// Values between pixels of one of a page's pictures.
#[derive(Clone, Copy)]
pub(super) struct Sampler<'a> {
    level: &'a Level,
}

impl Sampler<'_> {
    /// The light that a place sends back, in mm; 255 is all.
    #[inline]
    pub fn at(&self, x: f32, y: f32) -> f32 {
        let level = self.level;
        let x = (x * level.per_mm - 0.5).clamp(0.0, (level.width - 2) as f32);
        let y = (y * level.per_mm - 0.5).clamp(0.0, (level.height - 2) as f32);
        let (i, j) = (x as usize, y as usize);
        let (s, t) = (x - i as f32, y - j as f32);
        let first = j * level.width + i;
        let row = |k: usize| {
            let (a, b) = (f32::from(level.values[k]), f32::from(level.values[k + 1]));
            a + (b - a) * s
        };
        let (a, b) = (row(first), row(first + level.width));
        a + (b - a) * t
    }
}

impl Level {
    fn half(&self) -> Level {
        let [width, height] = [self.width, self.height].map(|n| n.div_ceil(2).max(2));
        let at =
            |x: usize, y: usize| u32::from(self.values[y.min(self.height - 1) * self.width + x.min(self.width - 1)]);
        let mut values = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let (x, y) = (2 * x, 2 * y);
                let sum = at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1);
                values.push(((sum + 2) / 4) as u8);
            }
        }
        Level { width, height, per_mm: self.per_mm / 2.0, values }
    }

    /// Blurs by a Gaussian of this width in mm.
    fn blur(&mut self, mm: f64) {
        let sigma = mm as f32 * self.per_mm;
        let radius = (2.5 * sigma).ceil() as usize;
        let weights: Vec<f32> = (0..=radius).map(|k| (-0.5 * (k as f32 / sigma).powi(2)).exp()).collect();
        let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f32>();
        let (width, height) = (self.width, self.height);
        let source = self.values.clone();
        let mut row = vec![0.0_f32; width + 2 * radius];
        for y in 0..height {
            let part = weights[0] / sum;
            for (to, from) in row[radius..].iter_mut().zip(&source[y * width..(y + 1) * width]) {
                *to = f32::from(*from) * part;
            }
            for (k, weight) in weights.iter().enumerate().skip(1) {
                let part = weight / sum;
                let above = y.saturating_sub(k) * width;
                let below = (y + k).min(height - 1) * width;
                let pairs = source[above..above + width].iter().zip(&source[below..below + width]);
                for (to, (a, b)) in row[radius..].iter_mut().zip(pairs) {
                    *to += (f32::from(*a) + f32::from(*b)) * part;
                }
            }
            let (first, last) = (row[radius], row[radius + width - 1]);
            row[..radius].fill(first);
            row[radius + width..].fill(last);
            for (x, to) in self.values[y * width..(y + 1) * width].iter_mut().enumerate() {
                let middle = x + radius;
                let mut value = row[middle] * weights[0];
                for (k, weight) in weights.iter().enumerate().skip(1) {
                    value += (row[middle - k] + row[middle + k]) * weight;
                }
                *to = (value / sum + 0.5) as u8;
            }
        }
    }
}
