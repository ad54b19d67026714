//! Grey pictures: brightness between pixels, and smaller copies; and the paper in a picture, straightened out: how dark it is
//! at each place.

use crate::geometry::{Point, Vector};

/// A grey picture, row by row from the upper left; 0 is black. Places are in pixels, x to the right, y down; the centre of the first pixel is at (0.5, 0.5).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: usize,
    height: usize,
    grey: Vec<u8>,
}

impl Picture {
    /// A picture of `width` × `height` pixels; `None` if there are not as many.
    #[must_use]
    pub fn new(width: usize, height: usize, grey: Vec<u8>) -> Option<Picture> {
        (width.checked_mul(height) == Some(grey.len())).then_some(Picture { width, height, grey })
    }

    /// Its width, in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Its height, in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Its pixels, row by row.
    #[must_use]
    pub fn grey(&self) -> &[u8] {
        &self.grey
    }

    pub(super) fn row(&self, y: usize) -> &[u8] {
        &self.grey[y * self.width..][..self.width]
    }

    /// Whether a place has pixels on all sides.
    pub(super) fn holds(&self, at: Point) -> bool {
        (1.0..self.width as f64 - 1.0).contains(&at.x) && (1.0..self.height as f64 - 1.0).contains(&at.y)
    }

    /// Brightness at a place, from the four pixels around it; outside that of the nearest ones.
    #[inline]
    pub(super) fn at(&self, at: Point) -> f64 {
        let within = |x: f64, size: usize| (x - 0.5).max(0.0).min(size as f64 - 1.0);
        let (x, y) = (within(at.x, self.width), within(at.y, self.height));
        let (i, j) = (x as u32 as usize, y as u32 as usize);
        let (u, v) = (x - i as f64, y - j as f64);
        // Beyond the last pixel of a row or column there is none, and its part is 0.
        let right = usize::from(i + 1 < self.width);
        let below = if j + 1 < self.height { self.width } else { 0 };
        let first = j * self.width + i;
        let grey = |further: usize| f64::from(self.grey[first + further]);
        let upper = grey(0) * (1.0 - u) + grey(right) * u;
        upper * (1.0 - v) + (grey(below) * (1.0 - u) + grey(below + right) * u) * v
    }

    /// The picture as a mirror shows it.
    pub(super) fn mirrored(&self) -> Picture {
        let grey = self.grey.chunks(self.width.max(1)).flat_map(|row| row.iter().rev().copied()).collect();
        Picture { grey, ..*self }
    }

    /// The picture with means of `factor` × `factor` pixels; what is left over at its right and lower edges is cut off.
    pub(super) fn smaller(&self, factor: usize) -> Picture {
        if factor <= 1 {
            return self.clone();
        }
        let (width, height) = (self.width / factor, self.height / factor);
        let mut grey = Vec::with_capacity(width * height);
        let mut sums = vec![0_u32; width];
        let area = (factor * factor) as u32;
        for y in 0..height {
            sums.fill(0);
            for row in 0..factor {
                let row = self.row(y * factor + row);
                for (sum, pixels) in sums.iter_mut().zip(row.chunks_exact(factor)) {
                    *sum += pixels.iter().map(|&pixel| u32::from(pixel)).sum::<u32>();
                }
            }
            grey.extend(sums.iter().map(|sum| (sum / area) as u8));
        }
        Picture { width, height, grey }
    }
}

/// Distance of places of the grid on which the picture's places are computed; between them they are interpolated, in mm.
const GRID: f64 = 4.0;
/// Side of the blocks in which the brightness of bare paper is looked for, in mm.
const BLOCK: f64 = 5.0;
/// Share of a block's places that are darker than bare paper.
const BARE: f64 = 0.8;

/// A part of a sheet of paper, by how dark it is: 0 is bare paper, 1 black.
#[derive(Clone, Debug)]
pub struct Paper {
    /// Its upper left corner on the sheet, in mm.
    pub corner: [f64; 2],
    /// Distance of neighbouring places, in mm.
    pub step: f64,
    /// Number of places in a row, and of rows.
    pub size: [usize; 2],
    /// How dark places are, row by row.
    pub dark: Vec<f32>,
}

impl Paper {
    /// The part of the sheet between two corners, in mm; `pixel` says where its places are in the picture.
    pub(super) fn new(
        picture: &Picture,
        pixel: impl Fn(Point) -> Point,
        [from, to]: [[f64; 2]; 2],
        step: f64,
    ) -> Paper {
        let size: [usize; 2] = std::array::from_fn(|i| ((to[i] - from[i]) / step).ceil().max(1.0) as usize);
        let nodes: [usize; 2] = std::array::from_fn(|i| (size[i] as f64 * step / GRID).ceil() as usize + 2);
        let middle = Point::new(0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]));
        // Pixels along the side of a place. All of them count: means of several first, then as many samples as there are of these.
        let density = (pixel(middle + Vector::new(1.0, 0.0)) - pixel(middle)).norm() * step;
        let factor = (density as usize).clamp(1, 4);
        let picture = picture.smaller(factor);
        let count = ((density / factor as f64).round() as usize).clamp(1, 2);
        let node = |i: usize, j: usize| {
            pixel(Point::new(from[0] + GRID * i as f64, from[1] + GRID * j as f64)) / factor as f64
        };
        let grid: Vec<Point> =
            (0..nodes[1]).flat_map(|j| (0..nodes[0]).map(move |i| (i, j))).map(|(i, j)| node(i, j)).collect();
        let apart = step / count as f64;
        // Where samples are, in nodes; those between two nodes follow one another by equal steps.
        let place = |sample: usize| (sample as f64 + 0.5) * apart / GRID;
        let columns = size[0] * count;
        let mut ends = vec![0; nodes[0]];
        (0..columns).for_each(|column| ends[place(column) as usize + 1] = column + 1);
        let mut samples = vec![0.0_f32; columns];
        let mut light = vec![0.0_f32; size[0] * size[1]];
        for row in 0..size[1] * count {
            let (j, v) = (place(row) as usize, place(row).fract());
            let node = |i: usize| grid[j * nodes[0] + i].coords * (1.0 - v) + grid[(j + 1) * nodes[0] + i].coords * v;
            for (i, own) in ends.windows(2).enumerate() {
                let Some(samples) = samples.get_mut(own[0]..own[1]) else { continue };
                let way = node(i + 1) - node(i);
                let mut at = node(i) + way * place(own[0]).fract();
                for sample in samples {
                    *sample = picture.at(Point::from(at)) as f32;
                    at += way * (apart / GRID);
                }
            }
            let light = &mut light[row / count * size[0]..][..size[0]];
            light
                .iter_mut()
                .zip(samples.chunks_exact(count))
                .for_each(|(light, own)| *light += own.iter().sum::<f32>());
        }
        light.iter_mut().for_each(|light| *light /= (count * count) as f32);
        let dark = darkness(&light, size, (BLOCK / step).ceil() as usize);
        Paper { corner: from, step, size, dark }
    }

    /// How dark a place on the sheet is, in mm, from the four places around it; outside 0.
    pub(super) fn at(&self, x: f64, y: f64) -> f64 {
        let (u, v) = ((x - self.corner[0]) / self.step - 0.5, (y - self.corner[1]) / self.step - 0.5);
        if u < 0.0 || v < 0.0 || u >= (self.size[0] - 1) as f64 || v >= (self.size[1] - 1) as f64 {
            return 0.0;
        }
        let (i, j) = (u as usize, v as usize);
        let (u, v) = (u - i as f64, v - j as f64);
        let mix = |j: usize| {
            let row = &self.dark[j * self.size[0] + i..];
            f64::from(row[0]) * (1.0 - u) + f64::from(row[1]) * u
        };
        mix(j) * (1.0 - v) + mix(j + 1) * v
    }
}

/// Darkness in relation to bare paper, whose brightness changes slowly.
fn darkness(light: &[f32], [width, height]: [usize; 2], block: usize) -> Vec<f32> {
    let blocks = [width.div_ceil(block), height.div_ceil(block)];
    let mut bare = Vec::with_capacity(blocks[0] * blocks[1]);
    let mut values = Vec::with_capacity(block * block);
    for j in 0..blocks[1] {
        for i in 0..blocks[0] {
            values.clear();
            for y in (j * block..((j + 1) * block).min(height)).step_by(2) {
                values.extend(light[y * width..][i * block..((i + 1) * block).min(width)].iter().step_by(2));
            }
            let place = ((values.len() - 1) as f64 * BARE) as usize;
            let (_, value, _) = values.select_nth_unstable_by(place, f32::total_cmp);
            bare.push(value.max(1.0));
        }
    }
    let part = |at: usize, count: usize| {
        let u = ((at as f32 + 0.5) / block as f32 - 0.5).clamp(0.0, (count - 1) as f32);
        let low = (u as usize).min(count.saturating_sub(2));
        (low, (low + 1).min(count - 1), u - low as f32)
    };
    let mut dark = Vec::with_capacity(light.len());
    for y in 0..height {
        let (j0, j1, v) = part(y, blocks[1]);
        for x in 0..width {
            let (i0, i1, u) = part(x, blocks[0]);
            let mix = |j: usize| bare[j * blocks[0] + i0] * (1.0 - u) + bare[j * blocks[0] + i1] * u;
            let white = mix(j0) * (1.0 - v) + mix(j1) * v;
            dark.push((1.0 - light[y * width + x] / white).clamp(-0.2, 1.0));
        }
    }
    dark
}
