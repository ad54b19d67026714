//! Differences from decimals of many digits, on which every other number of these tests rests.

use support::exact::{Exact, minus};

#[test]
fn differences_from_decimals_are_exact() {
    // 0.1 is 0.1000000000000000055511151231257827… in binary.
    let tenth = minus(0.1, "0.1");
    assert!((tenth / 5.551_115_123_125_783e-18 - 1.0).abs() < 1e-14);
    assert_eq!(libm::log10(minus(-2.5e-300, "-2.5E-300").abs()).floor(), -317.0);
    assert_eq!(minus(3.0, "0"), 3.0);
    assert_eq!(minus(0.0, "-3.0"), 3.0);
    assert_eq!(minus(0.0, "0"), 0.0);
    assert_eq!(minus(1e20, "100000000000000000001"), -1.0);
    assert_eq!(minus(1.0, "1e40"), -1e40);
    let third = Exact::read("0.33333333333333333333333333333333");
    let rest = third * Exact::from(3.0) - Exact::from(1.0);
    assert!((rest.rounded() / -1e-32 - 1.0).abs() < 0.5, "{rest:?}");
}
