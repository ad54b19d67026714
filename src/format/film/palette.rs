//! The colours of a film in a file that has few of them.
//!
//! A quantizer for photographs makes a mean of what is alike, so that not even the paper keeps its white. Drawings have few
//! colours, and on the edges of lines their mixtures: here all colours of a palette are colours of the film, and there is
//! none of which much is far from them.

use super::Pixel;
use indexmap::IndexMap;

/// Most colours: another index says that a pixel stays as it is.
const MOST: usize = 255;

/// How many pixels of each colour there are.
pub(super) type Counts = IndexMap<Pixel, u64>;

/// Counts the colours of a picture.
pub(super) fn counts(pixels: &[Pixel]) -> Counts {
    let mut counts = Counts::new();
    // Most pixels are like the one before them.
    for run in pixels.chunk_by(|a, b| a == b) {
        *counts.entry(run[0]).or_default() += run.len() as u64;
    }
    counts
}

/// Colours, of which each pixel gets the nearest.
pub(super) struct Palette {
    pub colours: Vec<Pixel>,
    /// The index of the nearest of all colours from which they were chosen: of the first of equals.
    nearest: IndexMap<Pixel, u8>,
}

impl Palette {
    /// First the most frequent colour; then, one after another, that of which most is farthest from those that there are.
    pub(super) fn new(counts: &Counts) -> Palette {
        // A thin line has few pixels, and is seen as well as the paper.
        let weights: Vec<u64> = counts.values().map(|count| count.isqrt()).collect();
        let mut farness = vec![u64::MAX; weights.len()];
        let mut nearest: IndexMap<Pixel, u8> = counts.keys().map(|colour| (*colour, 0)).collect();
        let mut colours = Vec::new();
        while colours.len() < MOST {
            let cost = |index: &usize| match farness[*index] {
                u64::MAX => weights[*index],
                far => weights[*index] * far,
            };
            // Of equals the first.
            let next = (0..weights.len()).rev().max_by_key(cost).filter(|index| cost(index) > 0);
            let Some((next, _)) = next.and_then(|index| counts.get_index(index)) else { break };
            for (far, (colour, nearest)) in farness.iter_mut().zip(&mut nearest) {
                let distance = distance(colour, next);
                if distance < *far {
                    (*far, *nearest) = (distance, colours.len() as u8);
                }
            }
            colours.push(*next);
        }
        Palette { colours, nearest }
    }

    /// The indices of the nearest colours.
    pub(super) fn indices(&self, pixels: &[Pixel]) -> Vec<u8> {
        let mut known: IndexMap<Pixel, u8> = IndexMap::new();
        let mut indices = Vec::with_capacity(pixels.len());
        for run in pixels.chunk_by(|a, b| a == b) {
            let index = match self.nearest.get(&run[0]) {
                Some(index) => *index,
                None => *known.entry(run[0]).or_insert_with(|| self.nearest_to(&run[0])),
            };
            indices.resize(indices.len() + run.len(), index);
        }
        indices
    }

    fn nearest_to(&self, pixel: &Pixel) -> u8 {
        let nearest = (0_u8..).zip(&self.colours).min_by_key(|(_, colour)| distance(colour, pixel));
        nearest.map_or(0, |(index, _)| index)
    }
}

/// The square of the distance of two colours.
fn distance(a: &Pixel, b: &Pixel) -> u64 {
    a.iter().zip(b).map(|(a, b)| u64::from(a.abs_diff(*b)).pow(2)).sum()
}
