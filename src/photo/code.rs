//! The code on a sheet, read module by module where it must be.

use super::picture::Picture;
use crate::drawing::markers::SheetCode;
use crate::geometry::{Point, Vector};
use nalgebra::{SMatrix, SVector};
use rqrr::{BitGrid, Grid};

/// Versions of QR codes on sheets.
const VERSIONS: std::ops::RangeInclusive<usize> = 1..=8;
/// Least share of the modules of the three finder patterns that are as they must be.
const LIKE: f64 = 0.8;

/// Farthest that a corner of the code is looked for from where the markers let expect it, in parts of the code's side: a corner of paper
/// may stand up.
const ASIDE: f64 = 0.16;

/// What the code in a square says: `pixel` says where its places are in the picture, for coordinates from 0 to 1. Where it is too blurred to be read
/// by itself it is compared with those that are `expected`.
pub(super) fn code(
    picture: &Picture,
    pixel: impl Fn(f64, f64) -> Point,
    expected: impl FnOnce() -> Vec<SheetCode>,
) -> Option<SheetCode> {
    let sizes = || VERSIONS.map(|version| 17 + 4 * version);
    let read = |all: &[Modules]| SheetCode::read(&first_text(all)?);
    let plain = |seen: &[Seen]| -> Vec<Modules> { seen.iter().map(Seen::plain).collect() };
    let equalized = |seen: &[Seen]| -> Vec<Modules> {
        seen.iter().flat_map(|seen| SMALL.iter().filter_map(|small| seen.equalized(*small))).collect()
    };
    let seen: Vec<Seen> = sizes().map(|size| Seen::new(picture, &pixel, size)).collect();
    if let Some(code) = read(&plain(&seen)) {
        return Some(code);
    }
    let mut all = equalized(&seen);
    if let Some(code) = read(&all) {
        return Some(code);
    }
    let aligned: Vec<Seen> = sizes().map(|size| Seen::new(picture, &aligned(picture, &pixel, size), size)).collect();
    let further = equalized(&aligned);
    let moved: Vec<Modules> = further.iter().cloned().chain(plain(&aligned)).collect();
    all.extend(further);
    read(&moved).or_else(|| likest(&all, &expected()).cloned())
}

/// The text of the first code that can be read, the likeliest size first.
fn first_text(all: &[Modules]) -> Option<String> {
    let mut tries: Vec<(f64, &Modules)> = all.iter().map(|modules| (modules.likeness(), modules)).collect();
    tries.retain(|(likeness, _)| *likeness >= LIKE);
    tries.sort_by(|a, b| b.0.total_cmp(&a.0));
    tries.into_iter().find_map(|(_, modules)| Grid::new(modules).decode().ok()).map(|(_, text)| text)
}

/// Least correlation of a code with what is seen: of those of other sheets, with hundreds of modules, it is below 0.2.
const CORRELATED: f64 = 0.4;
/// Least difference to the correlation of any other.
const CLEARLY: f64 = 0.15;

/// The expected code that is clearly most like what is seen.
fn likest<'a>(all: &[Modules], expected: &'a [SheetCode]) -> Option<&'a SheetCode> {
    let rated = expected.iter().filter_map(|code| {
        let modules = code.modules()?;
        let of_size = all.iter().filter(|seen| seen.size == modules.len());
        Some((of_size.map(|seen| seen.correlation(&modules)).fold(0.0, f64::max), code))
    });
    let mut rated: Vec<(f64, &SheetCode)> = rated.collect();
    rated.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (most, code) = *rated.first()?;
    let second = rated.iter().find(|(_, other)| *other != code).map_or(0.0, |(value, _)| *value);
    (most > CORRELATED && most > second + CLEARLY).then_some(code)
}

/// Where the places of a code of that size are in the picture, moved so that its three finder patterns and its alignment
/// pattern are where they are seen.
fn aligned<'a>(
    picture: &'a Picture,
    pixel: &'a impl Fn(f64, f64) -> Point,
    size: usize,
) -> impl Fn(f64, f64) -> Point + 'a {
    let module = 1.0 / size as f64;
    // How much lighter the light modules of a pattern are than the dark ones, if its middle is there: by ring, the weight of all its modules.
    let contrast = |x: f64, y: f64, rings: &[f64]| -> f64 {
        let last = rings.len() as i32 - 1;
        let modules = (-last..=last).flat_map(|j| (-last..=last).map(move |i| (i, j)));
        modules
            .map(|(i, j)| {
                let ring = i.abs().max(j.abs());
                let weight = rings[ring as usize] / f64::from(8 * ring.max(1) - 7 * i32::from(ring == 0));
                weight * picture.at(pixel(x + f64::from(i) * module, y + f64::from(j) * module))
            })
            .sum()
    };
    // The place near (x, y) with the most contrast, from steps of half a module to finer ones.
    let found = |x: f64, y: f64, rings: &[f64], mut reach: f64| {
        let mut best = (contrast(x, y, rings), x, y);
        let mut step = 0.5 * module;
        while step > 0.05 * module {
            let count = (reach / step).ceil() as i32;
            let (_, u, v) = best;
            for (i, j) in (-count..=count).flat_map(|j| (-count..=count).map(move |i| (i, j))) {
                let (u, v) = (u + f64::from(i) * step, v + f64::from(j) * step);
                let value = contrast(u, v, rings);
                if value > best.0 {
                    best = (value, u, v);
                }
            }
            (reach, step) = (step, 0.4 * step);
        }
        Vector::new(best.1, best.2)
    };
    let (near, far) = (3.5 * module, 1.0 - 3.5 * module);
    let finder = [(near, near), (far, near), (near, far)].map(|(x, y)| found(x, y, &FINDER, ASIDE));
    let [corner, right, below] = finder;
    // As if the paper were even; what the alignment pattern is off grows towards it along both sides.
    let even = move |u: f64, v: f64| corner + (right - corner) * u + (below - corner) * v;
    let fourth = (1.0 - 6.5 * module - near) / (far - near);
    let expected = even(fourth, fourth);
    let has_fourth = (25..45).contains(&size);
    let seen = if has_fourth { found(expected.x, expected.y, &ALIGNMENT, 2.0 * module) } else { expected };
    let twist = (seen - expected) / (fourth * fourth);
    move |x: f64, y: f64| {
        let (u, v) = ((x - near) / (far - near), (y - near) / (far - near));
        let at = even(u, v) + twist * (u * v);
        pixel(at.x, at.y)
    }
}

/// Weights of the rings of a finder pattern, from its middle out: dark ones are negative.
const FINDER: [f64; 4] = [-0.2, -0.8, 2.0, -1.0];
/// Weights of the rings of an alignment pattern.
const ALIGNMENT: [f64; 3] = [-0.5, 1.0, -0.5];

/// Half modules in a row round the middle of a module from which it is told whether it is dark.
const ROW: usize = 6;
const INPUTS: usize = ROW * ROW;
/// Rounds in which the modules told apart teach.
const LEARNT: usize = 5;
/// How small weights are kept, in parts of the mean square of their inputs: for little and for much noise.
const SMALL: [f64; 3] = [0.02, 0.1, 0.5];
/// White round a code whose brightness is looked at, in half modules.
const BORDER: i64 = 5;
/// Modules to either side with which brightness is compared.
const LOCAL: i64 = 4;

/// Brightness of a code at every half module, in relation to that around.
struct Seen {
    size: usize,
    wide: usize,
    light: Vec<f64>,
}

impl Seen {
    /// A code of so many modules.
    fn new(picture: &Picture, pixel: &impl Fn(f64, f64) -> Point, size: usize) -> Seen {
        let wide = 2 * size + 2 * BORDER as usize;
        // Place i is the middle of module (i − border − ½) / 2.
        let share = |i: usize, part: f64| (0.5 * (i as f64 - BORDER as f64) + 0.25 + 0.5 * part) / size as f64;
        let place = |x: usize, y: usize| {
            let parts = [-0.25, 0.25].into_iter().flat_map(|dy| [-0.25, 0.25].map(|dx| (dx, dy)));
            parts.map(|(dx, dy)| picture.at(pixel(share(x, dx), share(y, dy)))).sum::<f64>() / 4.0
        };
        let raw: Vec<f64> = (0..wide * wide).map(|i| place(i % wide, i / wide)).collect();
        // Half way between the darkest and the lightest near a place, and their difference.
        let reach = 2 * LOCAL;
        let coarse = (0..wide * wide).map(|i| {
            let (x, y) = ((i % wide) as i64, (i / wide) as i64);
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for dy in (-reach..=reach).step_by(2) {
                for dx in (-reach..=reach).step_by(2) {
                    let (u, v) = ((x + dx).clamp(0, wide as i64 - 1), (y + dy).clamp(0, wide as i64 - 1));
                    let value = raw[v as usize * wide + u as usize];
                    (low, high) = (low.min(value), high.max(value));
                }
            }
            (raw[i] - 0.5 * (low + high)) / (high - low).max(8.0)
        });
        let light = coarse.collect();
        Seen { size, wide, light }
    }

    /// Brightness at half modules from the middle of a module.
    fn at(&self, x: i64, y: i64, dx: i64, dy: i64) -> f64 {
        // The middle of module 0 lies between the half modules `border` and `border` + 1.
        let last = self.wide as i64 - 1;
        let place = |i: i64, d: i64| (2 * i + BORDER + d).clamp(0, last) as usize;
        self.light[place(y, dy) * self.wide + place(x, dx)]
    }

    /// The modules that are darker than half way between the darkest and the lightest around.
    fn plain(&self) -> Modules {
        self.modules(|x, y| self.at(x, y, 0, 0) + self.at(x, y, 1, 0) + self.at(x, y, 0, 1) + self.at(x, y, 1, 1))
    }

    fn modules(&self, light: impl Fn(i64, i64) -> f64) -> Modules {
        let size = self.size as i64;
        Modules { size: self.size, light: (0..size * size).map(|i| light(i % size, i / size)).collect() }
    }

    /// The brightness round a module, from which it is told whether it is dark.
    fn round(&self, x: i64, y: i64) -> SVector<f64, INPUTS> {
        let place = |i: usize| i as i64 - (ROW as i64 / 2 - 1);
        SVector::from_fn(|i, _| self.at(x, y, place(i % ROW), place(i / ROW)))
    }

    /// The modules after blur is taken back: by the sum of weighted brightness round a module that is right, with least squares, for
    /// the modules that are the same in all codes, and then for all as they were told apart (a decision-directed equalizer: Lucky 1966).
    fn equalized(&self, small: f64) -> Option<Modules> {
        let size = self.size as i64;
        let same = known(self.size);
        let mut weights = self.weights(same.iter().copied(), small)?;
        for _ in 0..LEARNT {
            let told = (0..size * size).map(|i| (i % size, i / size));
            let told = told.map(|(x, y)| (x, y, self.round(x, y).dot(&weights) < 0.0));
            weights = self.weights(told.chain(same.iter().copied()), small)?;
        }
        Some(self.modules(|x, y| self.round(x, y).dot(&weights)))
    }

    /// The weights by which the brightness round modules tells best whether they are dark.
    fn weights(&self, modules: impl Iterator<Item = (i64, i64, bool)>, small: f64) -> Option<SVector<f64, INPUTS>> {
        // The lower triangle.
        let mut matrix = [[0.0; INPUTS]; INPUTS];
        let mut right = SVector::<f64, INPUTS>::zeros();
        for (x, y, is_dark) in modules {
            let round = self.round(x, y);
            for (i, at) in round.iter().enumerate() {
                for (sum, other) in matrix[i].iter_mut().zip(&round.as_slice()[..=i]) {
                    *sum += at * other;
                }
            }
            right += round * if is_dark { -1.0 } else { 1.0 };
        }
        let mut matrix = SMatrix::<f64, INPUTS, INPUTS>::from_fn(|i, j| matrix[i.max(j)][i.min(j)]);
        // Weights stay small where the modules leave them open.
        let usual = small * matrix.trace() / INPUTS as f64;
        matrix += SMatrix::identity() * usual;
        Some(matrix.cholesky()?.solve(&right))
    }
}

/// The modules of a code by how light they are: dark ones are negative.
#[derive(Clone)]
struct Modules {
    size: usize,
    light: Vec<f64>,
}

impl BitGrid for &Modules {
    fn size(&self) -> usize {
        self.size
    }

    fn bit(&self, y: usize, x: usize) -> bool {
        self.light[y * self.size + x] < 0.0
    }
}

impl Modules {
    /// Correlation with a code, over the modules that are not the same in all codes.
    fn correlation(&self, code: &[Vec<bool>]) -> f64 {
        let mut is_same = vec![false; self.light.len()];
        self.known().for_each(|(module, _)| is_same[module] = true);
        let own = self.light.iter().zip(code.iter().flatten()).zip(&is_same).filter(|(_, same)| !**same);
        let pairs: Vec<(f64, f64)> =
            own.map(|((light, dark), _)| (light.clamp(-2.0, 2.0), if *dark { -1.0 } else { 1.0 })).collect();
        let n = pairs.len().max(1) as f64;
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / n;
        let (a, b) = (mean(&|p| p.0), mean(&|p| p.1));
        let covariance = mean(&|p| (p.0 - a) * (p.1 - b));
        let spread = mean(&|p| (p.0 - a).powi(2)) * mean(&|p| (p.1 - b).powi(2));
        covariance / spread.sqrt().max(f64::MIN_POSITIVE)
    }

    /// Share of the modules that are the same in all codes which are as they must be.
    fn likeness(&self) -> f64 {
        let right = self.known().filter(|(module, is_dark)| (self.light[*module] < 0.0) == *is_dark).count();
        right as f64 / self.known().count().max(1) as f64
    }

    /// The modules that are the same in all codes of this size, and whether they are dark.
    fn known(&self) -> impl Iterator<Item = (usize, bool)> {
        let size = self.size as i64;
        let inside =
            known(self.size).into_iter().filter(move |(x, y, _)| (0..size).contains(x) && (0..size).contains(y));
        inside.map(move |(x, y, is_dark)| ((y * size + x) as usize, is_dark))
    }
}

/// Modules that are the same in all codes of a size (ISO/IEC 18004): finder patterns, timing patterns, the alignment pattern of versions 2 to 6, and the
/// white around.
fn known(size: usize) -> Vec<(i64, i64, bool)> {
    let last = size as i64 - 1;
    let mut all = Vec::new();
    for y in -1..8_i64 {
        for x in -1..8_i64 {
            let ring = (x - 3).abs().max((y - 3).abs());
            let is_dark = ring != 2 && ring < 4;
            all.extend([(x, y, is_dark), (last - x, y, is_dark), (x, last - y, is_dark)]);
        }
    }
    for i in 8..last - 7 {
        all.extend([
            (i, 6, i % 2 == 0),
            (6, i, i % 2 == 0),
            (i, -1, false),
            (-1, i, false),
            (i, last + 1, false),
            (last + 1, i, false),
        ]);
    }
    if (25..45).contains(&size) {
        for (dx, dy) in (-2..=2_i64).flat_map(|dy| (-2..=2_i64).map(move |dx| (dx, dy))) {
            all.push((last - 6 + dx, last - 6 + dy, dx.abs().max(dy.abs()) != 1));
        }
    }
    all
}
