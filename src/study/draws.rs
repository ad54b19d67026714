use crate::geometry::Random;
use std::f64::consts::TAU;

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
