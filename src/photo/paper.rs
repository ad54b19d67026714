//! The paper in a picture, straightened out: how dark it is at each place.

use super::picture::Picture;
use crate::geometry::Point;

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
    dark: Vec<f32>,
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
        let node = |i: usize, j: usize| pixel(Point::new(from[0] + GRID * i as f64, from[1] + GRID * j as f64));
        let grid: Vec<Point> =
            (0..nodes[1]).flat_map(|j| (0..nodes[0]).map(move |i| (i, j))).map(|(i, j)| node(i, j)).collect();
        let at = |x: f64, y: f64| {
            let (u, v) = ((x - from[0]) / GRID, (y - from[1]) / GRID);
            let (i, j) = ((u.max(0.0) as usize).min(nodes[0] - 2), (v.max(0.0) as usize).min(nodes[1] - 2));
            let (u, v) = (u - i as f64, v - j as f64);
            let mix = |row: usize| {
                let (a, b) = (grid[row * nodes[0] + i], grid[row * nodes[0] + i + 1]);
                a.coords * (1.0 - u) + b.coords * u
            };
            Point::from(mix(j) * (1.0 - v) + mix(j + 1) * v)
        };
        // As many samples of a place as the picture has pixels there.
        let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let density = (at(middle[0] + 1.0, middle[1]) - at(middle[0], middle[1])).norm() * step;
        let count = (density.round() as usize).clamp(1, 4);
        let offsets: Vec<f64> = (0..count).map(|i| ((i as f64 + 0.5) / count as f64 - 0.5) * step).collect();
        let mut light = Vec::with_capacity(size[0] * size[1]);
        for j in 0..size[1] {
            for i in 0..size[0] {
                let (x, y) = (from[0] + (i as f64 + 0.5) * step, from[1] + (j as f64 + 0.5) * step);
                let sum: f64 = offsets
                    .iter()
                    .flat_map(|dy| offsets.iter().map(move |dx| (dx, dy)))
                    .map(|(dx, dy)| picture.at(at(x + dx, y + dy)))
                    .sum();
                light.push((sum / (count * count) as f64) as f32);
            }
        }
        let dark = darkness(&light, size, (BLOCK / step).ceil() as usize);
        Paper { corner: from, step, size, dark }
    }

    /// How dark places are, row by row.
    #[must_use]
    pub fn dark(&self) -> &[f32] {
        &self.dark
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
