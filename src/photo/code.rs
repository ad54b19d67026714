//! The code on a sheet, read module by module where it must be.

use super::picture::Picture;
use crate::geometry::Point;
use rqrr::{BitGrid, Grid};

/// Versions of QR codes on sheets.
const VERSIONS: std::ops::RangeInclusive<usize> = 1..=8;
/// Least share of the modules of the three finder patterns that are as they must be.
const LIKE: f64 = 0.8;

/// The modules of a code.
struct Modules {
    size: usize,
    dark: Vec<bool>,
}

impl BitGrid for Modules {
    fn size(&self) -> usize {
        self.size
    }

    fn bit(&self, y: usize, x: usize) -> bool {
        self.dark[y * self.size + x]
    }
}

/// How much of its brightness a module may lend to each neighbour in a row, by blur.
const BLURS: [f64; 4] = [0.0, 0.1, 0.17, 0.23];
/// Rounds in which blur is taken back.
const ROUNDS: usize = 12;

/// The text of the code in a square: `pixel` says where its places are in the picture, for coordinates from 0 to 1.
pub(super) fn text(picture: &Picture, pixel: impl Fn(f64, f64) -> Point) -> Option<String> {
    let mut tries: Vec<(f64, Modules)> = Vec::new();
    for version in VERSIONS {
        let seen = Seen::new(picture, &pixel, 17 + 4 * version);
        for blur in BLURS {
            let modules = seen.modules(blur);
            let likeness = modules.likeness();
            if likeness >= LIKE {
                tries.push((likeness, modules));
            }
        }
    }
    tries.sort_by(|a, b| b.0.total_cmp(&a.0));
    tries.into_iter().find_map(|(_, modules)| Grid::new(modules).decode().ok()).map(|(_, text)| text)
}

/// Brightness of modules, with a row of white on all sides.
struct Seen {
    /// Modules along a side, with the white.
    wide: usize,
    light: Vec<f64>,
}

impl Seen {
    /// The modules of a code of that size.
    fn new(picture: &Picture, pixel: &impl Fn(f64, f64) -> Point, size: usize) -> Seen {
        let wide = size + 2;
        let share = |i: usize, part: f64| (i as f64 - 0.5 + part) / size as f64;
        let near = [-0.22, 0.0, 0.22];
        let module = |x: usize, y: usize| {
            let parts = near.iter().flat_map(|dy| near.map(|dx| (dx, *dy)));
            parts.map(|(dx, dy)| picture.at(pixel(share(x, dx), share(y, dy)))).sum::<f64>() / 9.0
        };
        let light = (0..wide * wide).map(|i| module(i % wide, i / wide)).collect();
        Seen { wide, light }
    }

    /// Which modules are dark, if each lends the share `blur` of its brightness to either neighbour, along rows and columns.
    fn modules(&self, blur: f64) -> Modules {
        let wide = self.wide as i64;
        let place = |x: i64, y: i64| (y.clamp(0, wide - 1) * wide + x.clamp(0, wide - 1)) as usize;
        let [own, beside, across] = [(1.0 - 2.0 * blur).powi(2), blur * (1.0 - 2.0 * blur), blur * blur];
        let mut sharp = self.light.clone();
        let (low, high) =
            self.light.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(*v), high.max(*v)));
        for _ in 0..if blur > 0.0 { ROUNDS } else { 0 } {
            for y in 0..wide {
                for x in 0..wide {
                    let at = |dx: i64, dy: i64| sharp[place(x + dx, y + dy)];
                    let sides = at(-1, 0) + at(1, 0) + at(0, -1) + at(0, 1);
                    let corners = at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1);
                    let value = (self.light[place(x, y)] - beside * sides - across * corners) / own;
                    sharp[place(x, y)] = value.clamp(low - 20.0, high + 20.0);
                }
            }
        }
        let size = self.wide - 2;
        let mut dark = Vec::with_capacity(size * size);
        for y in 1..wide - 1 {
            for x in 1..wide - 1 {
                let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
                for v in (-4..=4)
                    .flat_map(|dy| (-4..=4).map(move |dx| (dx, dy)))
                    .map(|(dx, dy)| sharp[place(x + dx, y + dy)])
                {
                    (low, high) = (low.min(v), high.max(v));
                }
                dark.push(sharp[place(x, y)] < 0.5 * (low + high));
            }
        }
        Modules { size, dark }
    }
}

impl Modules {
    /// Share of the modules of finder patterns, and of the white beside them, that are as they must be.
    fn likeness(&self) -> f64 {
        let last = self.size - 1;
        let (mut right, mut all) = (0, 0);
        for y in 0..8_usize {
            for x in 0..8_usize {
                let ring = x.abs_diff(3).max(y.abs_diff(3));
                let is_dark = !(ring == 2 || x == 7 || y == 7);
                for (x, y) in [(x, y), (last - x, y), (x, last - y)] {
                    all += 1;
                    right += usize::from(self.dark[y * self.size + x] == is_dark);
                }
            }
        }
        f64::from(right as u32) / f64::from(all)
    }
}
