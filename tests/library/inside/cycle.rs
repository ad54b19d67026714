//! The polynomial between two positions of a path.

use kinegon::cycle::segment::{quintic, slope};

#[test]
fn quintic_meets_both_ends() {
    // f(x) = x⁵ − 2 x³ + x has f = 0, f' = 1, f'' = 0 at 0 and f = 0, f' = 0, f'' = 8 at 1.
    let q = quintic([0.0, 1.0, 0.0], [0.0, 0.0, 8.0]);
    assert_eq!(q, [0.0, 1.0, 0.0, -2.0, 0.0, 1.0]);
    assert_eq!(slope(&q, 0.5), 1.0 - 6.0 * 0.25 + 5.0 * 0.0625);
}
