//! What a telephone makes of the light: blur, noise, its curve of tones, smoothing and sharpening.

use super::take::{CELL, Exposure};
use crate::random::Random;

/// Lens out of focus, shaking hands, sensor and its software; lengths in pixels of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor {
    /// Standard deviation of the blur.
    pub defocus: f64,
    /// Length and direction (radians) of the hand's movement.
    pub motion: [f64; 2],
    /// Noise of a dark pixel, as part of the largest value.
    pub read_noise: f64,
    /// Variance of a white pixel by the grains of light.
    pub shot_noise: f64,
    /// How much faint structure is smoothed away, 0 to 1.
    pub smear: f64,
    /// How much edges are made steeper.
    pub sharpening: f64,
    /// Steepness of the curve of tones beside that of sRGB, 0 to 1.
    pub contrast: f64,
}

/// Entries of the curve of tones.
const TONES: usize = 4096;

/// Red, green and blue of each pixel, row by row.
pub fn develop(mut exposure: Exposure, sensor: &Sensor, cast: [f32; 3], white: f32, seed: u64) -> Vec<u8> {
    let size = exposure.size;
    let mut light = std::mem::take(&mut exposure.light);
    light.iter_mut().for_each(|value| *value *= white);
    if sensor.defocus > 0.05 {
        gaussian(&mut light, size, sensor.defocus);
    }
    if sensor.motion[0] > 0.1 {
        light = moved(&light, size, sensor.motion);
    }
    let mut random = Random(seed);
    for value in &mut light {
        let bits = random.next();
        let sum: u64 = (0..4).map(|k| (bits >> (16 * k)) & 0xffff).sum();
        let normal = (sum as f32 / 65_536.0 - 2.0) * 1.732;
        let variance = sensor.read_noise * sensor.read_noise + sensor.shot_noise * f64::from(value.max(0.0));
        *value += normal * (variance as f32).sqrt();
    }
    let tones = tones(sensor.contrast as f32);
    let luma: Vec<f32> = light.iter().map(|value| tone(&tones, *value)).collect();
    let corrections = sharpened(&luma, size, sensor);
    coloured(&exposure, &light, &corrections, cast, &tones)
}

/// sRGB and a gentle S over it, for light from 0 to 1.
fn tones(contrast: f32) -> Vec<f32> {
    let curve = |k: usize| {
        let linear = k as f32 / (TONES - 1) as f32;
        let encoded = match linear <= 0.003_130_8 {
            true => 12.92 * linear,
            false => 1.055 * libm::powf(linear, 1.0 / 2.4) - 0.055,
        };
        let s = encoded * encoded * (3.0 - 2.0 * encoded);
        encoded + contrast * (s - encoded)
    };
    (0..TONES).map(curve).collect()
}

#[inline]
fn tone(tones: &[f32], light: f32) -> f32 {
    let at = (light.clamp(0.0, 1.0) * (TONES - 1) as f32).min((TONES - 2) as f32);
    let k = at as usize;
    tones[k] + (tones[k + 1] - tones[k]) * (at - k as f32)
}

/// What smoothing and sharpening add to each pixel.
fn sharpened(luma: &[f32], size: [usize; 2], sensor: &Sensor) -> Vec<f32> {
    let mut soft = luma.to_vec();
    gaussian(&mut soft, size, 1.1);
    let (smear, sharp) = (sensor.smear as f32, sensor.sharpening as f32);
    for (soft, luma) in soft.iter_mut().zip(luma) {
        let detail = luma - *soft;
        // Faint detail is taken for noise, strong detail for an edge.
        let strength = (detail.abs() / 0.05).min(1.0);
        let kept = (1.0 + sharp) * strength + (1.0 - smear) * (1.0 - strength);
        *soft = detail * (kept - 1.0);
    }
    soft
}

fn coloured(exposure: &Exposure, light: &[f32], corrections: &[f32], cast: [f32; 3], tones: &[f32]) -> Vec<u8> {
    let [width, height] = exposure.size;
    let rows = exposure.colours.len() / exposure.columns;
    let mut pixels = Vec::with_capacity(3 * width * height);
    let mut row_colours = vec![[0.0_f32; 3]; exposure.columns];
    let near = |x: usize, count: usize| {
        let at = ((x as f32 + 0.5) / CELL as f32 - 0.5).clamp(0.0, (count - 1) as f32);
        (at as usize, (at as usize + 1).min(count - 1), at.fract())
    };
    for y in 0..height {
        let (above, below, t) = near(y, rows);
        for (column, colour) in row_colours.iter_mut().enumerate() {
            let [a, b] = [above, below].map(|row| exposure.colours[row * exposure.columns + column]);
            *colour = [0, 1, 2].map(|i| (a[i] + (b[i] - a[i]) * t) * cast[i]);
        }
        for x in 0..width {
            let (left, right, s) = near(x, exposure.columns);
            let (a, b) = (row_colours[left], row_colours[right]);
            let (value, correction) = (light[y * width + x], corrections[y * width + x]);
            for (a, b) in a.iter().zip(b) {
                let part = a + (b - a) * s;
                let encoded = tone(tones, value * part) + correction;
                pixels.push((encoded * 255.0 + 0.5).clamp(0.0, 255.0) as u8);
            }
        }
    }
    pixels
}

/// Blurs by a Gaussian of this standard deviation.
fn gaussian(values: &mut [f32], [width, height]: [usize; 2], sigma: f64) {
    let radius = (3.0 * sigma).ceil().max(1.0) as usize;
    // Integrals over pixels, so that narrow ones are right, too.
    let upto = |x: f64| 0.5 * libm::erf(x / (sigma * std::f64::consts::SQRT_2));
    let weights: Vec<f32> = (0..=radius).map(|k| (upto(k as f64 + 0.5) - upto(k as f64 - 0.5)) as f32).collect();
    let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f32>();
    let weights: Vec<f32> = weights.iter().map(|weight| weight / sum).collect();
    let mut padded = vec![0.0_f32; width + 2 * radius];
    for row in values.chunks_exact_mut(width) {
        padded[radius..radius + width].copy_from_slice(row);
        padded[..radius].fill(row[0]);
        padded[radius + width..].fill(row[width - 1]);
        row.iter_mut().for_each(|value| *value *= weights[0]);
        for (k, weight) in weights.iter().enumerate().skip(1) {
            let pairs = padded[radius - k..].iter().zip(&padded[radius + k..]);
            row.iter_mut().zip(pairs).for_each(|(to, (a, b))| *to += (a + b) * weight);
        }
    }
    // Down the columns: a ring of rows that are still needed.
    let mut ring: Vec<Vec<f32>> = Vec::new();
    let row_at = |values: &[f32], y: usize| values[y * width..(y + 1) * width].to_vec();
    for y in 0..height {
        if y == 0 {
            ring = (0..=2 * radius).map(|k| row_at(values, k.saturating_sub(radius).min(height - 1))).collect();
        } else {
            ring.rotate_left(1);
            let next = (y + radius).min(height - 1);
            let last = ring.len() - 1;
            if next > y {
                ring[last].copy_from_slice(&values[next * width..(next + 1) * width]);
            } else {
                let kept = ring[last - 1].clone();
                ring[last].copy_from_slice(&kept);
            }
        }
        let to = &mut values[y * width..(y + 1) * width];
        to.iter_mut().zip(&ring[radius]).for_each(|(to, from)| *to = from * weights[0]);
        for (k, weight) in weights.iter().enumerate().skip(1) {
            let pairs = ring[radius - k].iter().zip(&ring[radius + k]);
            to.iter_mut().zip(pairs).for_each(|(to, (a, b))| *to += (a + b) * weight);
        }
    }
}

/// Smears along a straight line about each pixel.
fn moved(values: &[f32], [width, height]: [usize; 2], [length, direction]: [f64; 2]) -> Vec<f32> {
    let count = (2.0 * length).ceil().max(2.0) as usize;
    let (sin, cos) = libm::sincos(direction);
    let reach = (length / 2.0).ceil() as usize + 2;
    let mut taps: Vec<([usize; 2], f32)> = Vec::new();
    for k in 0..count {
        let t = length * ((k as f64 + 0.5) / count as f64 - 0.5);
        let [x, y] = [t * cos, t * sin].map(|off| off + reach as f64);
        let (i, j) = (x as usize, y as usize);
        let (s, t) = ((x - i as f64) as f32, (y - j as f64) as f32);
        let part = 1.0 / count as f32;
        let corners = [([i, j], (1.0 - s) * (1.0 - t)), ([i + 1, j], s * (1.0 - t))];
        for (at, weight) in corners.into_iter().chain([([i, j + 1], (1.0 - s) * t), ([i + 1, j + 1], s * t)]) {
            match taps.iter_mut().find(|(tap, _)| *tap == at) {
                Some((_, sum)) => *sum += weight * part,
                None => taps.push((at, weight * part)),
            }
        }
    }
    let mut result = vec![0.0_f32; width * height];
    let mut padded = vec![0.0_f32; width + 2 * reach];
    for y in 0..height {
        let to = &mut result[y * width..(y + 1) * width];
        for dy in 0..=2 * reach {
            if !taps.iter().any(|([_, j], _)| *j == dy) {
                continue;
            }
            let from = (y + dy).saturating_sub(reach).min(height - 1);
            let row = &values[from * width..(from + 1) * width];
            padded[reach..reach + width].copy_from_slice(row);
            padded[..reach].fill(row[0]);
            padded[reach + width..].fill(row[width - 1]);
            for ([i, _], weight) in taps.iter().filter(|([_, j], _)| *j == dy) {
                to.iter_mut().zip(&padded[*i..]).for_each(|(to, from)| *to += from * weight);
            }
        }
    }
    result
}
