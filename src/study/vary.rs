//! The values that a number takes, in order or by chance.

use super::file::Range;
use super::number::Number;
use crate::geometry::Random;
use std::f64::consts::TAU;

/// A number of the scene with the values that it takes.
#[derive(Clone, Debug)]
pub(super) struct Varied {
    /// Its name as the study has it.
    pub name: String,
    pub number: Number,
    pub values: Values,
}

/// The values that a number takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Values {
    /// So many at equal distances, both ends among them.
    Grid { from: f64, to: f64, count: u64 },
    /// All between two equally likely.
    Uniform { from: f64, to: f64 },
    /// Normally distributed.
    Normal { mean: f64, sigma: f64 },
}

impl Values {
    /// The values of a range about the scene's number `own`; else what is wrong with it.
    pub fn of(range: &Range, own: f64) -> Result<Values, &'static str> {
        let middle = range.nominal.unwrap_or(own);
        let values = match *range {
            Range { from: Some(from), to: Some(to), count, nominal: None, plus_minus: None, sigma: None } => {
                match count {
                    Some(0 | 1) => return Err("a grid has at least 2 values"),
                    Some(count) => Values::Grid { from, to, count },
                    None => Values::Uniform { from, to },
                }
            }
            Range { from: None, to: None, count: None, plus_minus: Some(by), sigma: None, .. } if by > 0.0 => {
                Values::Uniform { from: middle - by, to: middle + by }
            }
            Range { from: None, to: None, count: None, plus_minus: None, sigma: Some(sigma), .. } if sigma > 0.0 => {
                Values::Normal { mean: middle, sigma }
            }
            Range { plus_minus: Some(by), .. } | Range { sigma: Some(by), .. } if by <= 0.0 => {
                return Err("a tolerance is a positive number");
            }
            _ => return Err("this is neither a grid nor a tolerance"),
        };
        match values {
            Values::Grid { from, to, .. } | Values::Uniform { from, to } if from == to => {
                Err("the range begins and ends at the same value")
            }
            _ => Ok(values),
        }
    }

    /// How many points of a grid it is; 1 for random values.
    pub fn points(self) -> u64 {
        if let Values::Grid { count, .. } = self { count } else { 1 }
    }

    /// The value at a point of the grid, or drawn for a row.
    pub fn value(self, point: u64, [seed, row, column]: [u64; 3]) -> f64 {
        match self {
            Values::Grid { from, to, count } => {
                let last = (count - 1) as f64;
                (from * (last - point as f64) + to * point as f64) / last
            }
            Values::Uniform { from, to } => from + (to - from) * dice(seed, row, column).unit(),
            Values::Normal { mean, sigma } => mean + sigma * normal(&mut dice(seed, row, column)),
        }
    }
}

/// Random numbers of one column of one row: they hang on the seed, the row and the column alone, so that any part of a study has the
/// same rows.
pub(super) fn dice(seed: u64, row: u64, column: u64) -> Random {
    let mix = |state: u64, number: u64| Random(state ^ number).next();
    Random(mix(mix(mix(0, seed), row), column))
}

/// Normally distributed, with mean 0 and standard deviation 1: G. E. P. Box, M. E. Muller, "A note on the generation of random normal
/// deviates", Ann. Math. Stat. 29 (1958).
pub(super) fn normal(dice: &mut Random) -> f64 {
    // Of (0, 1], so that its logarithm is finite.
    let size = 1.0 - dice.unit();
    libm::sqrt(-2.0 * libm::log(size)) * libm::cos(TAU * dice.unit())
}
