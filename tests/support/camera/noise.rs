//! Smooth noise that repeats, for fibres, wood and graphite.

use crate::random::Random;

/// A square of noise, from 0 to 1, that goes on at its edges.
pub struct Noise {
    values: Vec<f32>,
}

/// Values along an edge; a power of two.
const EDGE: usize = 256;

impl Noise {
    /// Noise whose smallest waves are about so many cells long.
    pub fn new(random: &mut Random, cells: usize) -> Noise {
        let raw: Vec<f32> = (0..EDGE * EDGE).map(|_| random.unit() as f32).collect();
        let mut values = raw;
        for is_across in [false, true] {
            let smooth = |k: usize| {
                let (i, j) = (k / EDGE, k % EDGE);
                let at = |d: usize| {
                    let [i, j] = if is_across { [(i + d) % EDGE, j] } else { [i, (j + d) % EDGE] };
                    values[i * EDGE + j]
                };
                (0..cells).map(at).sum::<f32>() / cells as f32
            };
            values = (0..EDGE * EDGE).map(smooth).collect();
        }
        // A sum of many is narrow: spread it to the same variance whatever the number.
        let spread = cells as f32;
        let values = values.iter().map(|v| ((v - 0.5) * spread * 0.8 + 0.5).clamp(0.0, 1.0)).collect();
        Noise { values }
    }

    /// The value of a cell.
    pub fn cell(&self, x: usize, y: usize) -> f32 {
        self.values[(y % EDGE) * EDGE + x % EDGE]
    }

    /// The value at a place, in cells, between cells by their mean.
    pub fn at(&self, x: f32, y: f32) -> f32 {
        let (i, j) = (x.floor(), y.floor());
        let (s, t) = (x - i, y - j);
        let (i, j) = (i as i64 as usize & (EDGE - 1), j as i64 as usize & (EDGE - 1));
        let row = |j: usize| {
            let (a, b) = (self.cell(i, j), self.cell(i + 1, j));
            a + (b - a) * s
        };
        let (a, b) = (row(j), row(j + 1));
        a + (b - a) * t
    }
}
